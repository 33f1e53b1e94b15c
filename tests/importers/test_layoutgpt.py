"""LayoutGPT's answers: frame, unit, room, and what is broken in them."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from sceneweaver.importers import read_scenes
from sceneweaver.importers.formats.layoutgpt import FORMAT
from sceneweaver.importers.model import ReadOptions
from sceneweaver.scene import InputError

BOXES = (  # category, length, width, height, left, top, depth, orientation: no two alike
    ("double_bed", 1.53, 2.04, 0.93, 1.9, 1.3, 0.465, 90 - math.degrees(0.3)),
    ("wardrobe", 1.2, 0.58, 2.11, 3.6, 2.2, 1.055, math.degrees(-1.2)),
    ("nightstand", 0.47, 0.39, 0.52, 0.6, 3.1, 0.26, math.degrees(2.4)),
    ("pendant_lamp", 0.4, 0.36, 0.7, 2.1, 2.9, 2.3, 0.0),
)
KEYS = ("length", "width", "height", "left", "top", "depth", "orientation")


def entry(scale=1.0, prompt="Room Size: max length 4.75m, max width 3.55m", name="a_Bedroom-1", boxes=BOXES):
    objects = []
    for label, *numbers in boxes:
        box = dict(zip(KEYS, (*(v * scale for v in numbers[:-1]), numbers[-1]), strict=True))
        objects.append([label, box])
    text = f"Condition:\nRoom Type: bedroom\n{prompt}\n"
    return {"query_id": name, "iter": 0, "prompt": text, "object_list": objects}


def saved(tmp_path, data, name="bedroom.json"):
    path = tmp_path / name
    path.write_text(data if isinstance(data, str) else json.dumps(data))
    return path


def rooms(tmp_path, data, **options):
    return list(FORMAT.read(saved(tmp_path, data), ReadOptions(**options)))


def by_matrices(numbers):
    """Corners [8, 3] of a box in our frame, by 4 x 4 matrices: its own, about y, then from y up to z up."""
    length, width, height, left, top, depth, orientation = numbers
    c, s = math.cos(math.radians(orientation)), math.sin(math.radians(orientation))
    turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    signs = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)])
    theirs = signs * (length / 2, height / 2, width / 2) @ turn.T + (left, depth, top)
    return theirs @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]).T


def corners(thing):
    d, w, h = thing.size
    signs = np.array([(i, j, k) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)])
    return signs * (d / 2, w / 2, h / 2) @ thing.rotation.T + thing.position


def test_boxes_are_where_the_matrices_say(tmp_path):
    (room,) = rooms(tmp_path, [entry()])
    for thing, (label, *numbers) in zip(room.objects, BOXES, strict=True):
        assert thing.label == label.replace("_", " ") and thing.anchor == "centre"
        ours, theirs = corners(thing), by_matrices(numbers)
        order = [np.lexsort(np.round(points, 6).T) for points in (ours, theirs)]
        assert ours[order[0]] == pytest.approx(theirs[order[1]], abs=1e-5)
        c, s = math.cos(math.radians(numbers[-1])), math.sin(math.radians(numbers[-1]))
        assert thing.rotation[:, 0] == pytest.approx((s, -c, 0.0), abs=1e-9), "the front looks along their +z at 0"
    assert np.array(room.outline) == pytest.approx(np.array([(0, -3.55), (4.75, -3.55), (4.75, 0), (0, 0)]))
    assert room.height == pytest.approx(2.65) and room.type == "bedroom" and room.objects[-1].mount == "ceiling"


def test_poses_of_the_scene(tmp_path):
    (imported,) = read_scenes(saved(tmp_path, [entry()]), assets="boxes")
    poses = {o.category: o.pose for o in imported.scene.objects}
    assert poses["bed"].position == pytest.approx((1.9, -1.3, 0.0), abs=1e-5)
    assert poses["bed"].yaw == pytest.approx(-0.3, abs=1e-5)
    assert poses["wardrobe"].yaw == pytest.approx(-1.2 - math.pi / 2, abs=1e-5)
    assert poses["nightstand"].yaw == pytest.approx(2.4 - math.pi / 2, abs=1e-5)
    assert imported.scene.object(imported.scene.objects[0].id).size == pytest.approx((2.04, 1.53, 0.93))


def test_a_pixel_by_the_data_set(tmp_path):
    folder = tmp_path / "atiss" / "a_Bedroom-1"
    folder.mkdir(parents=True)
    floor = np.array([(1.0, 0, 2.0), (5.75, 0, 2.0), (5.75, 0, 5.55), (1.0, 0, 5.55)])
    np.savez(folder / "boxes.npz", floor_plan_vertices=floor, uids=np.array(["x"]))
    scale = 256 / 3.55
    data = [entry(scale, f"Room Size: max length {4.75 * scale}px, max width 256px")]
    (room,) = rooms(tmp_path, data, folder=tmp_path / "atiss")
    assert room.objects[0].position == pytest.approx((1.9, -1.3, 0.465), abs=1e-5)
    assert np.array(room.outline)[2] == pytest.approx((4.75, 0.0), abs=1e-5)


def test_a_pixel_by_the_furniture(tmp_path):
    (room,) = rooms(tmp_path, [entry(80.0, "Room Size: max length 380px, max width 284px")])
    pixel = room.objects[0].size[1] / (1.53 * 80)
    assert pixel == pytest.approx(1 / 80, rel=0.35) and any(f"{pixel:.5f} m" in note for note in room.notes)
    ours = np.array([o.position for o in room.objects]) / pixel / 80
    theirs = np.array([(left, -top, depth) for _, _, _, _, left, top, depth, _ in BOXES])
    assert ours == pytest.approx(theirs, abs=1e-5)


def test_without_a_room_size_and_with_flat_boxes(tmp_path):
    flat = ("chair", 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    (room,) = rooms(tmp_path, [entry(prompt="", boxes=(*BOXES, flat))])
    assert room.outline is None and len(room.objects) == 4
    assert any("room size" in note for note in room.notes) and any("chair" in note for note in room.notes)


def test_equal_names_and_one_room(tmp_path):
    assert [r.name for r in rooms(tmp_path, [entry(), entry(), entry(name="b")])] == [
        "a_Bedroom-1",
        "a_Bedroom-1-2",
        "b",
    ]
    assert [r.name for r in rooms(tmp_path, [entry(), entry(name="b")], room="b")] == ["b"]


def changed(**numbers):
    data = entry()
    data["object_list"][1][1].update(numbers)
    return [data]


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (json.dumps([entry()])[:-200], "bedroom.json"),
        ([{**entry(), "object_list": {"bed": 1}}], "object_list"),
        ([{k: v for k, v in entry().items() if k != "prompt"}], "prompt"),
        (changed(left=None), "left"),
        (json.dumps(changed(top=1.5)).replace("1.5", "NaN", 1), "bedroom.json"),
        (changed(depth="high"), "depth"),
        ([], "bedroom.json"),
        ([3], "bedroom.json"),
        ([entry(prompt="Room Size: max length 0m, max width 3m")], "prompt"),
    ],
)
def test_broken_files_are_one_line(tmp_path, data, says):
    path = saved(tmp_path, data)
    with pytest.raises(InputError, match=says) as error:
        list(read_scenes(path, "layoutgpt", assets="boxes"))
    assert "\n" not in str(error.value) and "bedroom.json" in str(error.value)


@pytest.mark.parametrize("content", [b"", b"not a zip", "wrong"])
def test_a_broken_floor_plan_is_one_line(tmp_path, content):
    folder = tmp_path / "atiss" / "a_Bedroom-1"
    folder.mkdir(parents=True)
    if content == "wrong":
        np.savez(folder / "boxes.npz", floor_plan_vertices=np.zeros((4, 3)))
    else:
        (folder / "boxes.npz").write_bytes(content)
    with pytest.raises(InputError, match=r"boxes\.npz"):
        rooms(tmp_path, [entry(80.0, "Room Size: max length 380px, max width 284px")], folder=tmp_path / "atiss")


def test_names_do_not_lead_out_of_the_folder(tmp_path):
    (tmp_path / "boxes.npz").write_bytes(b"secret")
    (tmp_path / "atiss").mkdir()
    data = [entry(80.0, "Room Size: max length 380px, max width 284px", name="..")]
    assert len(rooms(tmp_path, data, folder=tmp_path / "atiss")) == 1
