"""``report.html``: what a data set is made of, in one file that loads nothing from elsewhere."""

from __future__ import annotations

import base64
import hashlib
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from sceneweaver.io import load_json, packaged, write_atomic
from sceneweaver.knowledge.palettes import palettes
from sceneweaver.scene import InputError

from ..engines import open_dataset, read_records
from ..templates import html
from . import charts
from .charts import box_of, extent_of, image_url, path_of
from .collect import PICTURES, Gathered, gather

NAME, WEB = "report.html", Path(__file__).parent / "web"

_MAPS, _NAMES, _OUTLINES, _SCALE = 18, 26, 60, 9.0  # heat maps, names of the matrix, shells; widest shell drawn [m]


def write_report(
    path: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    pictures: int = PICTURES,
    workers: int = 1,
) -> Path:
    """Write the report of a data set, packed or still being made.

    Args:
        path: the data set.
        out: the file; None: ``report.html`` in the data set.
        pictures: scenes that are drawn, at most; each takes about 12 kB.
        workers: processes that read scenes, where there are many.

    Returns:
        Where it was written.

    Raises:
        InputError: no data set, or nothing is made yet.
        MissingDependencyError: when pyarrow is not installed.
    """
    dataset = open_dataset(Path(path))
    folder = dataset.folder
    found = gather(folder, dataset.spec.product, pictures=pictures, workers=workers)
    if not found.numbers["requests"]:
        raise InputError(f"{folder.path}: nothing is made yet; try again when the first block is there")
    verification = folder.path / "verification.json"
    whole = folder.table(dataset.spec.product).is_file()
    verified = load_json(verification) if verification.is_file() and whole else None
    target = folder.path / NAME if out is None else Path(out)
    write_atomic(target, page(dataset.spec.name, found, read_records(folder), verified, whole))
    return target


def page(
    name: str,
    found: Gathered,
    records: Sequence[Mapping[str, Any]] = (),
    verification: Mapping[str, Any] | None = None,
    whole: bool = True,
) -> str:
    """The text of the page."""
    script = packaged.text(__package__ or "", "web", "report.js")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    environment = html()
    environment.filters |= {
        "histogram": charts.histogram,
        "percent": _percent,
        "size": _size,
        "image": image_url,
        "shares": _shares,
        "spread_words": _spread_words,
    }
    text = environment.get_template("report/web/page.html").render(
        name=name,
        found=found,
        numbers=found.numbers,
        records=records,
        verification=verification,
        whole=whole,
        policy=f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data:",
        style=packaged.text(__package__ or "", "web", "report.css"),
        script=script,
        noun="layouts" if found.numbers.get("layouts") else "scenes",
        places=_places(found),
        together=_together(found),
        relations=_relations(found),
        shells=_shells(found),
        coverage=_coverage(found),
        pairs=[pair for pair in found.pairs if all(key in found.plans for key in pair)],
        run=_run(records),
    )
    return text + "\n"


def _places(found: Gathered) -> list[tuple[str, int, str]]:
    """The categories with most objects, how many these are, and a map of where they stand."""
    often = sorted(found.heat, key=lambda name: (-float(found.heat[name].sum()), name))[:_MAPS]
    return [(name, int(found.heat[name].sum()), charts.heat_map(found.heat[name])) for name in often]


def _together(found: Gathered) -> dict[str, Any]:
    """What stands in the same rooms, like beside like, and shares of scenes [N, N] below the diagonal."""
    from scipy.cluster.hierarchy import leaves_list, linkage
    from scipy.spatial.distance import squareform

    names = [name for name, _ in sorted(found.present.items(), key=lambda pair: (-pair[1], pair[0]))[:_NAMES]]
    if len(names) < 3:
        return {"names": []}
    share = np.eye(len(names))
    for a, first in enumerate(names):
        for b, second in enumerate(names[:a]):
            both = found.together[min(first, second), max(first, second)]
            either = found.present[first] + found.present[second] - both
            share[a, b] = share[b, a] = both / either if either else 0.0
    order = leaves_list(linkage(squareform(1.0 - share, checks=False), "average", optimal_ordering=True))
    below = np.tril(share[np.ix_(order, order)], -1)
    return {"names": [names[k] for k in order], "shares": below.tolist()}


def _relations(found: Gathered) -> list[tuple[str, int, str]]:
    """How often each relation is asked for, as rows of bars."""
    total: Counter[str] = Counter()
    for (name, _), count in found.relations.items():
        total[name] += count
    often = sorted(total.items(), key=lambda pair: (-pair[1], pair[0]))
    return [(_words(name), n, f"{n:,} ({found.relations[name, True]:,} hard)") for name, n in often]


def _shells(found: Gathered) -> dict[str, Any]:
    """Outlines of rooms, all to one scale, and how many corners they have."""
    if not found.shells:
        return {}
    ranked = sorted(found.shells.items(), key=lambda pair: (len(pair[1][0]), _area(pair[1][0]), pair[0]))
    shown = [ranked[k][1] for k in np.linspace(0, len(ranked) - 1, min(_OUTLINES, len(ranked))).round().astype(int)]
    scale = min(1.0, _SCALE / max(extent_of(outline) for outline, _ in shown))
    corners: Counter[int] = Counter()
    for outline, count in found.shells.values():
        corners[len(outline)] += count
    total = corners.total()
    return {
        "outlines": [_shell(outline, count, scale) for outline, count in shown],
        "corners": [(f"{n} walls", count, _percent(count / total)) for n, count in sorted(corners.items())],
    }


def _shell(outline: Sequence[Sequence[float]], count: int, scale: float) -> tuple[Any, ...]:
    """View box, width and height [rem], area [m2], count and path of an outline."""
    left, low, right, high = box_of(outline)
    width, height = right - left, high - low
    box = f"{100 * left - 6:.0f} {-100 * high - 6:.0f} {100 * width + 12:.0f} {100 * height + 12:.0f}"
    return box, 0.75 * width * scale, 0.75 * height * scale, _area(outline), count, path_of(outline)


def _area(outline: Sequence[Sequence[float]]) -> float:
    return float(shapely.Polygon(outline).area)


def _coverage(found: Gathered) -> dict[str, Any]:
    """How much of the knowledge base is used, as rows of bars, and what is not."""
    known, covered = palettes(), found.numbers["coverage"]
    unseen = {name: covered[name]["unseen"] for name in ("room_types", "categories")}
    rows = [
        ("kinds of rooms", covered["room_types"]["seen"], covered["room_types"]["known"]),
        ("categories", covered["categories"]["seen"], covered["categories"]["known"]),
        ("palettes", len(found.palettes.keys() & known.keys()), len(known)),
    ]
    return {
        "rows": [(name, seen / of, f"{seen} of {of}") for name, seen, of in rows],
        "unseen": unseen | {"palettes": sorted(set(known) - found.palettes.keys())},
    }


def _run(records: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """How the run went."""
    return {
        "throughput": charts.throughput_svg(records),
        "memory": charts.memory_svg(records),
        "hosts": len({record.get("host") for record in records}),
        "workers": len({(record.get("host"), record.get("worker")) for record in records}),
    }


def _shares(tally: Mapping[str, int], total: int) -> list[tuple[str, float, str]]:
    """A tally as rows of bars."""
    return [(_words(name), count, f"{count:,} ({_percent(count / total)})") for name, count in tally.items()]


def _spread_words(spread: Mapping[str, Any]) -> str:
    scale, unit = (100, " %") if spread["high"] == 1.0 else (1, "")
    mean, least, most = (scale * spread[key] for key in ("mean", "least", "most"))
    return f"mean {mean:.3g}{unit}, from {least:.3g} to {most:.3g}{unit}"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %" if share < 0.9995 or share == 1.0 else f"{100 * share:.2f} %"


def _size(count: float) -> str:
    units = ["bytes", "kB", "MB", "GB"]
    while count >= 999.5 and len(units) > 1:
        count /= 1000
        units.pop(0)
    return f"{count:.3g} {units[0]}"
