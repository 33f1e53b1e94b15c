"""LayoutVLM: poses alone, and an input beside them in which the sides of a box may be exchanged."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written

FLOOR = [[0, 0, 0], [4.4, 0, 0], [4.4, 2.1, 0], [2.5, 2.1, 0], [2.5, 5.2, 0], [0, 5.2, 0]]
LAYOUT = {
    "sofa-0": {"position": [1.1, 1.2, 0.42], "rotation": [0.0, 0.0, math.degrees(0.3)]},
    "plant_A-0": {"position": [3.8, 1.2, 0.55], "rotation": [0.0, 0.0, math.degrees(-1.2)]},
    "plant_B-0": {"position": [0.4, 4.6, 0.7], "rotation": [0.0, 0.0, math.degrees(2.4)]},
    "picture-0": {"position": [2.46, 3.6, 1.5], "rotation": [0.0, 0.0, 180.0]},
    "lamp-0": {"rotation": [0.0, 0.0, 0.0]},
}


def asset(category, box, on="onFloor", **more):
    flags = {flag: flag == on for flag in ("onFloor", "onWall", "onCeiling", "onObject")}
    size = {"boundingBox": dict(zip("xyz", box, strict=True))}
    return {"category": category, "description": f"a {category}", **flags, "assetMetadata": size, **more}


PREPARED = {  # x along the front
    "task_description": "a plain room",
    "boundary": {"floor_vertices": FLOOR, "wall_height": 2.6},
    "assets": {
        "sofa-0": asset("sofa", (0.85, 1.95, 0.84), uid="s1", asset_var_name="sofa"),
        "plant_A-0": asset("plant", (0.5, 0.55, 1.1), uid="p1", asset_var_name="plant_A"),
        "plant_B-0": asset("plant", (0.3, 0.35, 1.4), uid="p2", asset_var_name="plant_B"),
        "picture-0": asset("picture", (0.05, 0.9, 0.6), "onWall", uid="w1", asset_var_name="picture"),
    },
}


def raw_entry(prepared):
    """What the data.json of an asset holds: x and y the other way round."""
    box = prepared["assetMetadata"]["boundingBox"]
    flags = {k: v for k, v in prepared.items() if k.startswith("on")}
    return {
        "annotations": {"category": prepared["category"], "description": prepared["description"], **flags},
        "assetMetadata": {"boundingBox": {"x": box["y"], "y": box["x"], "z": box["z"]}},
    }


def require_room(room):
    assert room.outline == tuple((x, y) for x, y, _ in FLOOR)
    assert (room.height, room.text) == (2.6, "a plain room")
    things = things_of(room)
    assert set(things) == {"sofa-0", "plant_A-0", "plant_B-0", "picture-0"}
    require_pose(things["sofa-0"], (1.1, 1.2, 0.42), compass(0.3))
    require_pose(things["plant_A-0"], (3.8, 1.2, 0.55), compass(-1.2))
    require_pose(things["plant_B-0"], (0.4, 4.6, 0.7), compass(2.4))
    require_pose(things["picture-0"], (2.46, 3.6, 1.5), (-1, 0, 0))
    assert things["sofa-0"].size == (0.85, 1.95, 0.84)  # depth along the front first
    assert things["plant_A-0"].size == (0.5, 0.55, 1.1)
    assert things["plant_B-0"].size == (0.3, 0.35, 1.4)
    assert (things["picture-0"].mount, things["sofa-0"].mount) == ("wall", "floor")
    assert things["plant_B-0"].label == "plant"
    assert any("lamp-0" in note and "left out" in note for note in room.notes)


def test_beside_its_prepared_input(tmp_path):
    written(tmp_path, "task.json", PREPARED)
    written(tmp_path, "other.json", {"irrelevant": True})
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", LAYOUT)).values()
    require_room(room)
    assert room.name == tmp_path.name


def test_beside_a_raw_input_with_assets_in_a_folder(tmp_path):
    """A raw input has ids alone; their files, and the names that LayoutVLM makes of their categories, tell the rest."""
    ids = {f"{e['uid']}-0": {} for e in PREPARED["assets"].values()}
    written(tmp_path, "input.json", {**PREPARED, "assets": ids})
    for entry in PREPARED["assets"].values():
        written(tmp_path, f"assets/{entry['uid']}/data.json", raw_entry(entry))
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", LAYOUT), tmp_path / "assets").values()
    require_room(room)


def test_beside_a_raw_input_that_has_its_boxes(tmp_path):
    ids = {f"{e['uid']}-0": raw_entry(e) for e in PREPARED["assets"].values()}
    written(tmp_path, "input.json", {**PREPARED, "assets": ids})
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", LAYOUT)).values()
    require_room(room)


def test_an_input_under_the_names_of_the_layout(tmp_path):
    """Then it is a prepared one, whatever else it lacks: x is along the front."""
    plain = {name: {"assetMetadata": entry["assetMetadata"]} for name, entry in PREPARED["assets"].items()}
    written(tmp_path, "input.json", {**PREPARED, "assets": plain})
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", LAYOUT)).values()
    assert things_of(room)["sofa-0"].size == (0.85, 1.95, 0.84)
    assert things_of(room)["sofa-0"].label == "sofa"


def test_alone(tmp_path):
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", LAYOUT)).values()
    assert room.outline is None
    assert {t.size for t in room.objects} == {None}
    require_pose(things_of(room)["sofa-0"], (1.1, 1.2, 0.42), compass(0.3))


def test_names_lead_to_no_other_folder(tmp_path):
    written(tmp_path, "secret/data.json", raw_entry(PREPARED["assets"]["sofa-0"]))
    written(tmp_path, "in/input.json", {**PREPARED, "assets": {"../secret-0": {}}})
    path = written(tmp_path, "in/layout.json", LAYOUT)
    (room,) = rooms_of("layoutvlm", path, tmp_path / "in").values()
    assert {t.size for t in room.objects} == {None}


@pytest.mark.parametrize("angles", [(10.0, -25.0, 70.0), (0.0, 90.0, 12.0)])
def test_three_angles(tmp_path, angles):
    """About fixed x, y, z, one after the other."""

    def turn(i, j, degrees):
        m, a = np.eye(3), math.radians(degrees)
        m[i, i] = m[j, j] = math.cos(a)
        m[j, i], m[i, j] = math.sin(a), -math.sin(a)
        return m

    expected = turn(0, 1, angles[2]) @ turn(2, 0, angles[1]) @ turn(1, 2, angles[0])
    layout = changed(LAYOUT, list(angles), "sofa-0", "rotation")
    (room,) = rooms_of("layoutvlm", written(tmp_path, "layout.json", layout)).values()
    require_pose(room.objects[0], (1.1, 1.2, 0.42), expected[:, 0], expected[:, 2])


def test_from_file_to_judge(tmp_path):
    written(tmp_path, "task.json", PREPARED)
    (made,) = sw.read_scenes(written(tmp_path, "layout.json", LAYOUT), assets="boxes")
    report = sw.check(made.scene)
    assert (report.collisions, report.out_of_bounds) == (0, 0), report
    assert made.boundary == "file"
    moved = changed(LAYOUT, [3.4, 3.0, 0.42], "sofa-0", "position")  # in the notch of the L
    (worse,) = sw.read_scenes(written(tmp_path, "layout.json", moved), assets="boxes")
    assert sw.check(worse.scene).out_of_bounds


def test_broken_files(tmp_path):
    text = written(tmp_path, "whole.json", LAYOUT).read_text()
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(LAYOUT, ["1", 2, 3], "sofa-0", "position"), ("sofa-0.position[0]", "number")),
        ("missing.json", changed(LAYOUT, [1.0, 2.0], "sofa-0", "position"), ("sofa-0.position", "3 numbers")),
        ("nan.json", changed(LAYOUT, float("nan"), "plant_A-0", "rotation", 2), ("plant_A-0.rotation[2]", "NaN")),
        ("empty.json", "", ("empty",)),
        ("list.json", [1, 2], ("object",)),
    ):
        require_error(written(tmp_path, f"{name[:-5]}/{name}", data), "layoutvlm", *words)
    written(tmp_path, "b/task.json", without(PREPARED, "boundary", "floor_vertices"))
    with pytest.raises(sw.InputError, match=r"task.json: boundary: 'floor_vertices' is missing"):
        list(sw.read_scenes(written(tmp_path, "b/layout.json", LAYOUT), assets="boxes"))
