"""BEHAVIOR: objects of a home by rooms, poses of base links, walls and floors among the objects."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written


def spin(yaw, factor=1.0):
    """A quaternion x, y, z, w, of a length of its own."""
    return [0.0, 0.0, factor * math.sin(yaw / 2), factor * math.cos(yaw / 2)]


OBJECTS = {  # name: category, model, place, yaw, rooms, more arguments
    "floors_a_0": ("floors", "aaaaaa", (2.0, 1.5, -0.02), 0.0, ["kitchen_0"], {"bounding_box": [4.0, 3.0, 0.04]}),
    "floors_b_0": (
        "floors",
        "bbbbbb",
        (5.5, 1.5, -0.02),
        math.pi / 2,
        ["bedroom_1"],
        {"bounding_box": [3.4, 3.0, 0.04]},
    ),
    "walls_a_0": ("walls", "cccccc", (2.0, 0.0, 1.3), 0.0, ["kitchen_0"], {"bounding_box": [4.0, 0.1, 2.6]}),
    "door_x_0": (
        "door",
        "dddddd",
        (4.0, 2.1, 1.02),
        math.pi / 2,
        ["kitchen_0", "bedroom_1"],
        {"bounding_box": [0.92, 0.08, 2.04], "fixed_base": True},
    ),
    "window_y_0": ("window", "eeeeee", (1.4, 3.0, 1.6), 0.0, ["kitchen_0"], {"bounding_box": [1.2, 0.1, 0.9]}),
    "fridge_z_0": (
        "fridge",
        "ffffff",
        (0.9, 0.8, 0.9),
        0.3,
        ["kitchen_0"],
        {"bounding_box": [0.7, 0.75, 1.8], "fixed_base": True},
    ),
    "bed_q_0": ("bed", "gggggg", (5.2, 1.2, 0.3), -1.2, ["bedroom_1"], {"bounding_box": [2.0, 1.2, 0.6]}),
    "stool_w_0": ("stool", "hhhhhh", (2.6, 1.9, 0.25), 2.4, None, {"scale": [1.1, 0.9, 1.25]}),
}


def scene(old=False):
    infos, poses = {}, {}
    for i, (name, (category, model, place, yaw, rooms, more)) in enumerate(OBJECTS.items()):
        args = {"name": name, "category": category, "model": model, "fixed_base": False, **more}
        if rooms is not None:
            args["in_rooms"] = rooms
        infos[name] = {"class_module": "omnigibson.objects.dataset_object", "class_name": "DatasetObject", "args": args}
        poses[name] = {"root_link": {"pos": list(place), "ori": spin(yaw, 1.0 + 0.1 * i)}, "joints": {}}
    infos["robot0"] = {"class_module": "omnigibson.robots.fetch", "class_name": "Fetch", "args": {"name": "robot0"}}
    poses["robot0"] = {"root_link": {"pos": [1, 1, 0], "ori": [0, 0, 0, 1]}}
    registry = {"object_registry": poses, "system_registry": {}}
    return {
        "metadata": {},
        "state": registry if old else {"pos": [0, 0, 0], "ori": [0, 0, 0, 1], "registry": registry},
        "objects_info": {"init_info": infos},
    }


@pytest.mark.parametrize("old", [False, True])
def test_poses(tmp_path, old):
    rooms = rooms_of("behavior", written(tmp_path, "house_best.json", scene(old)))
    assert list(rooms) == ["kitchen_0", "bedroom_1"]
    kitchen, bedroom = rooms["kitchen_0"], rooms["bedroom_1"]
    assert (kitchen.type, bedroom.type, kitchen.height) == ("kitchen", "bedroom", 2.6)
    np.testing.assert_allclose(sorted(kitchen.outline), [(0, 0), (0, 3), (4, 0), (4, 3)], atol=1e-9)
    np.testing.assert_allclose(sorted(bedroom.outline), [(4, -0.2), (4, 3.2), (7, -0.2), (7, 3.2)], atol=1e-9)
    things = things_of(kitchen) | things_of(bedroom)
    require_pose(things["fridge_z_0"], (0.9, 0.8, 0.9), compass(0.3))
    require_pose(things["bed_q_0"], (5.2, 1.2, 0.3), compass(-1.2))
    require_pose(things["stool_w_0"], (2.6, 1.9, 0.25), compass(2.4))
    assert things["fridge_z_0"].size == (0.7, 0.75, 1.8)
    assert things["stool_w_0"].size is None  # a scale alone
    assert things["fridge_z_0"].fixed and not things["bed_q_0"].fixed
    assert set(things_of(kitchen)) == {"fridge_z_0", "stool_w_0"}  # where the stool stands
    assert any("robot0" in note for note in kitchen.notes)


def test_openings(tmp_path):
    rooms = rooms_of("behavior", written(tmp_path, "house_best.json", scene()))
    door, window = rooms["kitchen_0"].openings
    np.testing.assert_allclose((door.start, door.end), ((4.0, 1.64), (4.0, 2.56)), atol=1e-9)
    assert (door.kind, door.leads_to, door.height) == ("door", "bedroom_1", 2.04)
    np.testing.assert_allclose((window.start, window.end), ((0.8, 3.0), (2.0, 3.0)), atol=1e-9)
    assert window.bottom == pytest.approx(1.15)
    assert [(o.name, o.leads_to) for o in rooms["bedroom_1"].openings] == [("door_x_0", "kitchen_0")]


def test_boxes_from_the_metadata_of_assets(tmp_path):
    """Middle = base + R (scale * offset); sides = scale * box. A bounding box gives the scale by the native one."""
    for category, model, offset, box in (
        ("stool", "hhhhhh", (0.03, -0.05, 0.2), (0.4, 0.5, 0.6)),
        ("fridge", "ffffff", (0.1, 0.0, -0.3), (0.35, 1.5, 0.9)),
    ):
        meta = {"base_link_offset": list(offset), "bbox_size": list(box)}
        written(tmp_path, f"data/objects/{category}/{model}/misc/metadata.json", meta)
    path = written(tmp_path, "house_best.json", scene())
    things = things_of(rooms_of("behavior", path, tmp_path / "data")["kitchen_0"])
    assert things["stool_w_0"].size == pytest.approx((0.44, 0.45, 0.75))
    x, y, z = 0.03 * 1.1, -0.05 * 0.9, 0.2 * 1.25
    c, s = math.cos(2.4), math.sin(2.4)
    require_pose(things["stool_w_0"], (2.6 + c * x - s * y, 1.9 + s * x + c * y, 0.25 + z), compass(2.4))
    x, z = 0.1 * 0.7 / 0.35, -0.3 * 1.8 / 0.9
    require_pose(things["fridge_z_0"], (0.9 + math.cos(0.3) * x, 0.8 + math.sin(0.3) * x, 0.9 + z), compass(0.3))


def test_a_floor_above_the_ground(tmp_path):
    data = scene()
    for pose in data["state"]["registry"]["object_registry"].values():
        pose["root_link"]["pos"][2] += 2.9
    rooms = rooms_of("behavior", written(tmp_path, "house_best.json", data))
    require_pose(things_of(rooms["bedroom_1"])["bed_q_0"], (5.2, 1.2, 0.3), compass(-1.2))
    assert rooms["kitchen_0"].height == pytest.approx(2.6)
    assert rooms["kitchen_0"].openings[1].bottom == pytest.approx(1.15)


def test_from_file_to_judge(tmp_path):
    path = written(tmp_path, "house_best.json", scene())
    made = {m.room: m for m in sw.read_scenes(path, assets="boxes", sizes={"stool": (0.35, 0.35, 0.5)})}
    report = sw.check(made["kitchen_0"].scene)
    assert (report.collisions, report.out_of_bounds) == (0, 0), report
    assert [len(m.scene.room.doors) for m in made.values()] == [1, 1]
    assert made["kitchen_0"].sizes_from == {"fridge_z_0": "file", "stool_w_0": "table"}
    near = changed(scene(), [2.5, 1.8, 0.9], "state", "registry", "object_registry", "fridge_z_0", "root_link", "pos")
    worse = next(iter(sw.read_scenes(written(tmp_path, "worse.json", near), assets="boxes")))
    assert sw.check(worse.scene).collisions


def test_broken_files(tmp_path):
    whole = scene()
    text = written(tmp_path, "whole.json", whole).read_text()
    bed = "state", "registry", "object_registry", "bed_q_0", "root_link"
    args = "objects_info", "init_info", "bed_q_0", "args"
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(whole, "2 1 1", *args, "bounding_box"), ("bed_q_0.args.bounding_box", "list")),
        ("missing.json", without(whole, *bed, "pos"), ("bed_q_0.root_link", "'pos'")),
        ("nan.json", changed(whole, float("nan"), *bed, "ori", 2), ("ori[2]", "NaN")),
        ("empty.json", "", ("empty",)),
        ("zero.json", changed(whole, [0, 0, 0, 0], *bed, "ori"), ("root_link.ori", "x, y, z, w")),
        ("state.json", without(whole, "state", "registry"), ("state", "'object_registry'")),
    ):
        require_error(written(tmp_path, name, data), "behavior", *words)
