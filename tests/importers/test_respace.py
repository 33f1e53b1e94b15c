"""ReSpace: positions at the bottom, full sizes, quaternions about y, bounds of floor and ceiling."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import about_y, corners, only, refused, rooms, same_ring, y_up_corners

L_SHAPE = [(-2.2, -1.9), (2.4, -1.9), (2.4, 0.6), (0.5, 0.6), (0.5, 2.3), (-2.2, 2.3)]  # x, z
THINGS = [  # description, label, size x, y, z, pos of the bottom, angle
    ("Modern wooden king-size bed with a low frame, in oak.", "Modern wooden king-size bed", (1.9, 1.1, 2.2), 0.3),
    ("A tall white wardrobe featuring two doors.", "A tall white wardrobe", (1.4, 2.2, 0.6), -1.2),
    ("Round nightstand", "Round nightstand", (0.5, 0.55, 0.42), 2.4),
]
PLACES = [(-0.9, 0.0, -0.6), (1.9, 0.0, 0.1), (-0.4, 0.2, 1.6)]


def scene(floor: float = 0.0) -> dict[str, Any]:
    return {
        "room_type": "bedroom",
        "bounds_top": [[x, floor + 2.6, z] for x, z in L_SHAPE],
        "bounds_bottom": [[x, floor, z] for x, z in L_SHAPE],
        "objects": [
            {
                "desc": desc,
                "size": list(size),
                "pos": [x, floor + y, z],
                "rot": [0.0, float(np.sin(angle / 2)), 0.0, float(np.cos(angle / 2))],
                "jid": "asked",
                "sampled_asset_jid": "found-(1.0)-(1.0)-(1.0)",
            }
            for (desc, _, size, angle), (x, y, z) in zip(THINGS, PLACES, strict=True)
        ],
    }


def check(room: Any) -> None:
    same_ring(room.outline, [(x, -z) for x, z in L_SHAPE])
    assert room.height == pytest.approx(2.6) and room.type == "bedroom"
    for thing, (desc, label, size, angle), place in zip(room.objects, THINGS, PLACES, strict=True):
        expected = y_up_corners(np.array(place) + (0, size[1] / 2, 0), size, about_y(angle))
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)
        assert (thing.label, thing.description) == (label, desc)
        assert thing.asset == "found-(1.0)-(1.0)-(1.0)"


def test_poses_by_an_independent_route(tmp_path: Path) -> None:
    file = tmp_path / "room.json"
    file.write_text(json.dumps(scene()))
    check(only(rooms(file, "respace")))


def test_a_quarter_turn_by_hand(tmp_path: Path) -> None:
    """The back of a sofa turned by -90 degrees about y is at +x: its front, +z, has become -x."""
    data = scene()
    data["objects"] = [
        {"desc": "sofa", "size": [2.5, 0.9, 1.0], "pos": [1.5, 0, 0.4], "rot": [0, -0.70710678, 0, 0.70710678]}
    ]
    file = tmp_path / "room.json"
    file.write_text(json.dumps(data))
    sofa = only(rooms(file, "respace")).objects[0]
    np.testing.assert_allclose(sofa.rotation, [[-1, 0, 0], [0, -1, 0], [0, 0, 1]], atol=1e-7)
    assert sofa.position == (1.5, -0.4, 0.0) and sofa.size == (1.0, 2.5, 0.9) and sofa.anchor == "bottom"


def test_wrapped_in_a_list_and_raised(tmp_path: Path) -> None:
    file = tmp_path / "rooms.json"
    file.write_text(json.dumps([{"room_id": "a", "scene": scene()}, {"scene": json.dumps(scene(-1.25))}]))
    first, second = rooms(file, "respace")
    assert (first.name, second.name) == ("a", "0001")
    check(first)
    check(second)
    assert any("-1.25 m" in note for note in second.notes)


def test_to_a_scene_and_the_judge(tmp_path: Path) -> None:
    file = tmp_path / "room.json"
    file.write_text(json.dumps(scene()))
    (imported,) = sw.read_scenes(file)
    assert [o.category for o in imported.scene.objects] == ["king_bed", "wardrobe", "nightstand"]
    assert imported.scene.room.height == pytest.approx(2.6) and imported.boundary == "file"
    sw.check(imported.scene)


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda d: d["objects"][1].pop("pos"), r"objects\[1\]: 'pos' is missing"),
        (lambda d: d["objects"][1].update(size=[1, -1, 1]), "size: -1"),
        (lambda d: d["objects"][0].update(rot=[0, 0, 0, 0]), "length 0"),
        (lambda d: d["objects"][0].update(rot="none"), "rot: 4 numbers"),
        (lambda d: d["objects"][2].update(pos=[0, float("inf"), 0]), "pos: NaN or infinity"),
        (lambda d: d.update(objects={}), "list"),
        (lambda d: d.update(bounds_bottom=[[0, 0, 0], [1, 0, 0]]), "2 corners"),
        (lambda d: d.update(bounds_top=[[0, -3, 0]]), "below the floor"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, change: Any, match: str) -> None:
    data = scene()
    change(data)
    file = tmp_path / "room.json"
    file.write_text(json.dumps(data))
    refused("respace", file, match=match)


def test_a_file_cut_off_and_an_empty_one(tmp_path: Path) -> None:
    file = tmp_path / "room.json"
    for text in (json.dumps(scene())[:90], "", "3", '{"scene": "{"}'):
        file.write_text(text)
        refused("respace", file)
