"""Statistics of a data set: against numbers worked out by hand and by numpy."""

import json
import math

import numpy as np
import pytest

from sceneweaver.datasets.statistics import Spread, entropy, statistics


def _row(index, **more):
    row = {"index": index, "key": f"{index:08d}", "status": "ok", "room": index // 2, "kind": "bedroom"}
    row |= {"room_type": "bedroom", "split": "train", "categories": ["bed", "chair", "chair"], "area": 12.0}
    row |= {"wall_count": 4, "object_count": 3, "grade": 7.0, "licences": ["MIT"], "bytes": 100, "valid": True}
    return row | {"layout_signature": f"s{index}", "near_duplicate_group": index} | more


def test_counts_shares_and_reasons():
    rows = [_row(0), _row(1, area=12.001), _row(2, area=20.0, near_duplicate_group=0, layout_signature="s0")]
    rows.append({"index": 3, "key": "00000003", "status": "rejected", "reason": "grade: 4.1 of 5"})
    rows[-1]["gates"] = {"grade": False, "valid": True, "still": None}
    found = statistics(iter(rows))
    assert (found["requests"], found["scenes"], found["served"], found["rooms"]) == (4, 3, 0.75, 2)
    assert found["reasons"] == {"grade": 1} and found["gates_failed"] == {"grade": 1}
    assert found["categories"] == {"bed": 3, "chair": 3}
    variety = found["diversity"]
    assert (variety["shells"], variety["layout_signatures"], variety["near_duplicates"]) == (2, 2, 2)
    assert variety["category_entropy"] == pytest.approx(entropy({"a": 1, "b": 1}), abs=1e-4)
    covered = found["coverage"]["categories"]
    assert covered["seen"] == 2 and covered["known"] > 100 and "wardrobe" in covered["unseen"]
    assert found["bytes"] == 300 and found["objects"] == 9 and found["invalid"] == 0
    json.dumps(found, allow_nan=False)


def test_a_spread_is_that_of_numpy_and_keeps_what_lies_outside():
    values = np.random.default_rng(3).normal(5.0, 4.0, 400)
    spread = Spread(0.0, 10.0, 20)
    for value in values:
        spread.add(float(value))
    found = spread.result()
    assert found["mean"] == pytest.approx(values.mean(), abs=1e-6)
    assert found["deviation"] == pytest.approx(values.std(), abs=1e-6)
    assert found["histogram"] == np.histogram(np.clip(values, 0.0, 9.999), 20, (0.0, 10.0))[0].tolist()
    assert (found["least"], found["most"]) == pytest.approx((values.min(), values.max()), abs=1e-6)


def test_nothing_delivered_is_no_error():
    found = statistics([{"index": 0, "key": "0", "status": "failed", "reason": "time limit"}])
    assert found["scenes"] == 0 and found["spreads"]["area"] == {"count": 0}
    assert found["diversity"]["category_entropy"] == 0.0 and not math.copysign(1, found["served"]) < 0
