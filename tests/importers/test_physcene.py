"""PhyScene: sampled rooms, a room with its models, and boxes with the floor's mesh and a door."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.boxes import about_y, corners, only, refused, rooms, same_ring, y_up_corners

THINGS = [  # label, centre, half extents, angle
    ("dressing_table", (1.2, 0.4, -0.7), (0.55, 0.4, 0.24), 0.3),
    ("wardrobe", (-1.6, 1.05, 1.1), (0.8, 1.05, 0.31), -1.2),
    ("single_bed", (-0.2, 0.42, -1.4), (0.5, 0.42, 1.02), 2.4),
]


def check(objects: Any) -> None:
    assert [o.label for o in objects] == [label for label, *_ in THINGS]
    for thing, (_, centre, half, angle) in zip(objects, THINGS, strict=True):
        expected = y_up_corners(centre, 2 * np.array(half), about_y(angle))
        np.testing.assert_allclose(corners(thing), expected, atol=1e-5)


def sampled() -> dict[str, Any]:
    names = [label for label, *_ in THINGS]
    one_hot = [[float(n == label) for n in [*names, "empty"]] for label in [*names, "empty"]]
    slots = [*THINGS, ("empty", (0, 0, 0), (0.1, 0.1, 0.1), 0.0)]
    return {
        "class_labels": [one_hot],
        "translations": [[list(t) for _, t, _, _ in slots]],
        "sizes": [[list(s) for _, _, s, _ in slots]],
        "angles": [[[a] for *_, a in slots]],
        "objfeats_32": [[[0.0] * 32] * 4],
        "objectness": [[[-0.98], [-0.7], [-0.99], [0.97]]],  # the score of being empty
        "scene_ids": ["house_Bedroom-9"],
        "object_types": names,
    }


def models() -> dict[str, Any]:
    """The wardrobe is GAPartNet's, stretched; the others 3D-FUTURE's. A position is the model's origin."""
    found: dict[str, Any] = {"ThreedFront": {}, "GPN": {}}
    for k, (label, centre, half, angle) in enumerate(THINGS):
        centroid = [0.01 * (k + 1), half[1] + 0.02, -0.03]
        row = {
            "label": label,
            "query_label": label,
            "theta": angle,
            "centroid": centroid,
            "position": (np.array(centre) - centroid).tolist(),
            "scale": [1.0, 1.0, 1.0],
            "path": "x/raw_model.obj",
            "size": list(half),
            "query_size": [s / 2 for s in half],
        }
        if label == "wardrobe":
            found["GPN"]["40147"] = [{**row, "size": [9.0, 9.0, 9.0], "query_size": list(half)}]
        else:
            found["ThreedFront"][f"jid-{k}"] = [row]
    return found


def boxes() -> dict[str, Any]:
    return {
        "objects": [
            {"label": label, "position": list(centre), "scale": list(half), "theta": angle, "rot_degree": 0.0}
            for label, centre, half, angle in THINGS
        ],
        "floor_center": [11.0, 0.0, 6.5],
        # A door of 0.9 m in the wall at z = 8.6: x, z, y and lengths along them; the leaf sweeps a square.
        "door_box": [[-1.3, 2.1, 1.0, 0.9, 0.9, 2.0, 0.0]],
    }


def test_sampled_rooms(tmp_path: Path) -> None:
    file = tmp_path / "sampled.json"
    file.write_text(json.dumps(sampled()))
    room = only(rooms(file, "physcene"))
    check(room.objects)
    assert (room.name, room.type) == ("house_Bedroom-9", "bedroom")


def test_objectness_is_the_score_of_being_empty(tmp_path: Path) -> None:
    """A slot whose best class is furniture, but whose objectness is not negative, is none to PhyScene."""
    data = sampled()
    data["objectness"][0][1] = [0.2]
    file = tmp_path / "sampled.json"
    file.write_text(json.dumps(data))
    room = only(rooms(file, "physcene"))
    assert [o.label for o in room.objects] == ["dressing_table", "single_bed"]
    assert any("1 boxes are left out" in note for note in room.notes)
    data["objectness"] = [[[1.0]] * 4]
    file.write_text(json.dumps(data))
    assert len(only(rooms(file, "physcene")).objects) == 3


def test_models_are_placed_by_origin_and_centroid(tmp_path: Path) -> None:
    file = tmp_path / "house_Bedroom-9.json"
    file.write_text(json.dumps(models()))
    room = only(rooms(file, "physcene"))
    by_label = {o.label: o for o in room.objects}
    check([by_label[label] for label, *_ in THINGS])
    assert by_label["wardrobe"].asset == "40147"


def test_a_model_without_centroid_stands_on_its_origin(tmp_path: Path) -> None:
    data = models()
    del data["ThreedFront"]["jid-0"][0]["centroid"]
    file = tmp_path / "room.json"
    file.write_text(json.dumps(data))
    room = only(rooms(file, "physcene"))
    x, y, z = data["ThreedFront"]["jid-0"][0]["position"]
    assert room.objects[0].anchor == "bottom" and room.objects[0].position == pytest.approx((x, -z, y))
    assert any("centroid" in note for note in room.notes)


def test_boxes_with_the_floor_and_its_door(tmp_path: Path) -> None:
    (tmp_path / "room_3.obj").write_text(
        "v 9 0 4.4\nv 13 0 4.4\nv 13 0 8.6\nv 9 0 8.6\nf 1 2 3\nf 1 3 4\n"  # 4.0 x 4.2 m about (11, 6.5)
    )
    file = tmp_path / "House_12_room_3_bedroom_bbox.json"
    file.write_text(json.dumps(boxes()))
    room = only(rooms(file, "physcene"))
    check(room.objects)
    assert room.type == "bedroom"
    same_ring(room.outline, [(-2, -2.1), (2, -2.1), (2, 2.1), (-2, 2.1)])
    (door,) = room.openings
    ends = sorted([door.start, door.end])
    np.testing.assert_allclose(ends, [(-1.75, -2.1), (-0.85, -2.1)], atol=1e-5)
    assert door.height == 2.0
    (imported,) = sw.read_scenes(file)
    assert len(imported.scene.room.doors) == 1 and imported.boundary == "file"
    sw.check(imported.scene)


def test_boxes_alone_say_what_is_missing(tmp_path: Path) -> None:
    file = tmp_path / "House_12_room_3_bedroom_bbox.json"
    file.write_text(json.dumps(boxes()))
    room = only(rooms(file, "physcene"))
    check(room.objects)
    assert room.outline is None and any("1 doors left out" in note for note in room.notes)


@pytest.mark.parametrize(
    ("data", "match"),
    [
        ({"ThreedFront": {"j": [{"label": "a", "theta": 0.0}]}}, "'position' is missing"),
        ({"ThreedFront": {"j": [{"label": "a", "theta": float("nan"), "position": [0, 0, 0]}]}}, "theta: NaN"),
        ({"GPN": {"j": 3}}, "list"),
        ({"objects": [{"label": "a", "position": [0, 0, 0], "scale": [1, 1], "theta": 0}]}, "scale: 3 numbers"),
        ({"objects": [{"label": "a", "position": [0, 0, 0], "scale": [1, 0, 1], "theta": 0}]}, "positive"),
        ({**sampled(), "angles": [[[0.1, 0.2, 0.3]] * 4]}, "angles"),
        ({"rooms": []}, "neither"),
        ([], "object"),
    ],
)
def test_broken_files_are_one_line(tmp_path: Path, data: Any, match: str) -> None:
    file = tmp_path / "room_bbox.json"
    file.write_text(json.dumps(data))
    refused("physcene", file, match=match)


def test_a_file_cut_off_and_an_empty_one(tmp_path: Path) -> None:
    file = tmp_path / "room_bbox.json"
    for text in (json.dumps(boxes())[:100], ""):
        file.write_text(text)
        refused("physcene", file)
