"""RPLAN, House-GAN++: rings of edges in any order, pixels with y down, doors between rooms."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import refused, rooms, same_ring

PIXEL = 0.0703125  # 18 m of 256
LIVING = [(50, 40), (130, 40), (130, 90), (95, 90), (95, 140), (50, 140)]
BEDROOM = [(134, 40), (180, 40), (180, 90), (134, 90)]
INNER = [(131, 55), (131, 68), (133, 68), (133, 55)]  # between the two
FRONT = [(60, 141), (76, 141), (76, 144), (60, 144)]  # below the living room


def ring(corners: list[tuple[int, int]], kind: int) -> list[list[float]]:
    pairs = zip(corners, corners[1:] + corners[:1], strict=True)
    return [[float(x0), float(y0), float(x1), float(y1), kind, 0] for (x0, y0), (x1, y1) in pairs]


def plan() -> dict[str, Any]:
    shapes = [(LIVING, 1), (BEDROOM, 3), (INNER, 17), (FRONT, 15)]
    edges, owners = [], []
    for node, (corners, kind) in enumerate(shapes):
        for edge in ring(corners, kind):
            edges.append(edge)
            owners.append([node])
    owners[10 + 0].append(0)  # the door's side at x = 131 is the living room's, the one at 133 the bedroom's
    owners[10 + 2].append(1)
    owners[14 + 0].append(0)
    edges[1], edges[3], owners[1], owners[3] = edges[3], edges[1], owners[3], owners[1]
    edges[2] = [*edges[2][2:4], *edges[2][:2], *edges[2][4:]]  # the other way round
    boxes = [
        [min(x for x, _ in c), min(y for _, y in c), max(x for x, _ in c), max(y for _, y in c)] for c, _ in shapes
    ]
    return {"room_type": [kind for _, kind in shapes], "boxes": boxes, "edges": edges, "ed_rm": owners}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "7513.json"
    path.write_text(json.dumps(plan()))
    return path


def test_outlines_in_metres_with_y_up(file: Path) -> None:
    living, bedroom = rooms(file, "rplan")
    assert (living.name, living.type, bedroom.type) == ("living_room_0", "living_room", "bedroom")
    same_ring(living.outline, [(x * PIXEL, -y * PIXEL) for x, y in LIVING])
    same_ring(bedroom.outline, [(x * PIXEL, -y * PIXEL) for x, y in BEDROOM])
    assert not living.objects


def test_doors_and_where_they_lead(file: Path) -> None:
    living, bedroom = rooms(file, "rplan")
    inner, front = living.openings
    np.testing.assert_allclose(
        sorted([inner.start, inner.end]), [(132 * PIXEL, -68 * PIXEL), (132 * PIXEL, -55 * PIXEL)], atol=1e-5
    )
    np.testing.assert_allclose(
        sorted([front.start, front.end]), [(60 * PIXEL, -142.5 * PIXEL), (76 * PIXEL, -142.5 * PIXEL)], atol=1e-5
    )
    assert (inner.leads_to, front.leads_to) == ("bedroom_0", "outside")
    assert [o.leads_to for o in bedroom.openings] == ["living_room_0"]


def test_to_scenes(file: Path) -> None:
    living, bedroom = sw.read_scenes(file)
    assert len(living.scene.room.doors) == 2 and len(bedroom.scene.room.doors) == 1
    assert living.scene.room.type == "living_room"
    sw.check(living.scene)


def test_edges_that_do_not_close_give_the_box(file: Path) -> None:
    data = plan()
    data["edges"][6] = [0.0, 0.0, 1.0, 1.0, 3, 0]
    file.write_text(json.dumps(data))
    bedroom = rooms(file, "rplan", room="bedroom_0")[0]
    same_ring(bedroom.outline, [(x * PIXEL, -y * PIXEL) for x, y in BEDROOM])
    assert any("do not close" in note for note in bedroom.notes)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda d: d.pop("ed_rm"), "'ed_rm' is missing"),
        (lambda d: d["ed_rm"].pop(), "there are 18 edges"),
        (lambda d: d["ed_rm"].__setitem__(0, [9]), "one of the 4 rooms"),
        (lambda d: d["edges"].__setitem__(0, [1, 2]), "edges"),
        (lambda d: d["edges"].__setitem__(0, [float("nan"), 0, 0, 0, 1, 0]), "NaN"),
        (lambda d: d.update(room_type=[]), "no room"),
        (lambda d: d.update(room_type="kitchen"), "room_type"),
    ],
)
def test_broken_files_are_one_line(file: Path, change: Any, match: str) -> None:
    data = plan()
    change(data)
    file.write_text(json.dumps(data))
    refused("rplan", file, match=match)


def test_a_file_cut_off_and_an_empty_one(file: Path) -> None:
    for text in (json.dumps(plan())[:90], "", "[]"):
        file.write_text(text)
        refused("rplan", file)
