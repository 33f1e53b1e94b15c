"""ACDC: poses from a camera, of bases and not of middles; the graph beside the file."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from tests.importers.reading import changed, compass, require_error, require_pose, rooms_of, things_of, without, written

CAMERA = [0.4, -1.7, 1.6], [0.5417, -0.2243, -0.3105, 0.7482]  # x, y, z, w; not of length 1 to the last digit


def turn_about(axis, angle):
    """Rodrigues."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def camera():
    """The camera's pose in the world, by axis and angle of its quaternion."""
    (x, y, z, w) = np.array(CAMERA[1]) / np.linalg.norm(CAMERA[1])
    pose = np.eye(4)
    pose[:3, :3] = turn_about((x, y, z), 2 * math.atan2(np.linalg.norm((x, y, z)), w))
    pose[:3, 3] = CAMERA[0]
    return pose


def seen(place, yaw):
    """A pose of the world as the camera sees it."""
    world = np.eye(4)
    world[:3, :3] = turn_about((0, 0, 1), yaw)
    world[:3, 3] = place
    return (np.linalg.inv(camera()) @ world).tolist()


def thing(category, model, size, place, yaw, floor=True, wall=False, scale=(1.0, 1.0, 1.0)):
    return {
        "category": category,
        "model": model,
        "scale": list(scale),
        "bbox_extent": list(size),
        "tf_from_cam": seen(place, yaw),
        "mount": {"floor": floor, "wall": wall},
    }


INFO = {
    "resolution": [720, 1280],
    "scene_graph": "/data/acdc_output/step_3_output/scene_0/scene_0_graph.json",
    "cam_pose": list(CAMERA),
    "objects": {
        "cabinet_0": thing("bottom_cabinet", "jhymlr", (0.45, 0.9, 0.8), (2.1, 0.6, 0.4), 0.3, scale=(1.2, 0.9, 1.1)),
        "table_1": thing("breakfast_table", "bhszwe", (0.7, 1.3, 0.72), (1.2, 2.4, 0.36), -1.2),
        "bowl_2": thing("bowl", "aspeds", (0.2, 0.24, 0.09), (1.3, 2.3, 0.765), 2.4),
        "picture_3": thing("picture", "fhxlmk", (0.04, 0.8, 0.5), (2.9, 1.8, 1.5), math.pi, floor=False, wall=True),
    },
}
GRAPH = {
    "floor": {"objOnTop": ["cabinet_0", "table_1"], "objBeneath": None, "mount": {"floor": True, "wall": False}},
    "cabinet_0": {"objOnTop": [], "objBeneath": "floor", "mount": {"floor": True, "wall": False}},
    "table_1": {"objOnTop": ["bowl_2"], "objBeneath": "floor", "mount": {"floor": True, "wall": False}},
    "bowl_2": {"objOnTop": [], "objBeneath": "table_1", "mount": {"floor": True, "wall": False}},
}


def test_poses(tmp_path):
    written(tmp_path, "scene_0_graph.json", GRAPH)
    (room,) = rooms_of("acdc", written(tmp_path, "scene_0_info.json", INFO)).values()
    assert (room.name, room.outline) == ("scene_0", None)
    things = things_of(room)
    require_pose(things["cabinet_0"], (2.1, 0.6, 0.4), compass(0.3))
    require_pose(things["table_1"], (1.2, 2.4, 0.36), compass(-1.2))
    require_pose(things["bowl_2"], (1.3, 2.3, 0.765), compass(2.4))
    require_pose(things["picture_3"], (2.9, 1.8, 1.5), (-1, 0, 0))
    assert things["cabinet_0"].size == (0.45, 0.9, 0.8)
    assert (things["bowl_2"].support, things["bowl_2"].mount) == ("table_1", "surface")
    assert [things[n].mount for n in ("cabinet_0", "table_1", "picture_3")] == ["floor", "floor", "wall"]
    assert things["cabinet_0"].label == "bottom_cabinet"


def test_bases_that_are_not_the_middle_of_their_box(tmp_path):
    """With metadata of the assets the box lies where it is; without, what is on the floor is set down."""
    written(tmp_path, "scene_0_graph.json", GRAPH)
    path = written(tmp_path, "scene_0_info.json", INFO)
    offset = np.array((0.05, -0.1, 0.22))
    meta = {"base_link_offset": offset.tolist(), "bbox_size": [0.4, 1.0, 0.7]}
    written(tmp_path, "data/objects/bottom_cabinet/jhymlr/misc/metadata.json", meta)
    (room,) = rooms_of("acdc", path, tmp_path / "data").values()
    scaled = offset * (1.2, 0.9, 1.1)
    c, s = math.cos(0.3), math.sin(0.3)
    moved = (2.1 + c * scaled[0] - s * scaled[1], 0.6 + s * scaled[0] + c * scaled[1], 0.4 + scaled[2])
    require_pose(things_of(room)["cabinet_0"], moved, compass(0.3))
    low = changed(INFO, seen((2.1, 0.6, 0.0), 0.3), "objects", "cabinet_0", "tf_from_cam")  # a base at the bottom
    (room,) = rooms_of("acdc", written(tmp_path, "scene_0_info.json", low)).values()
    require_pose(things_of(room)["cabinet_0"], (2.1, 0.6, 0.4), compass(0.3))
    assert any("cabinet_0" in note and "set down" in note for note in room.notes)


def test_the_graph_is_read_beside_the_file_alone(tmp_path):
    written(tmp_path, "elsewhere/scene_0_graph.json", GRAPH)
    info = changed(INFO, str(tmp_path / "elsewhere" / "scene_0_graph.json"), "scene_graph")
    (room,) = rooms_of("acdc", written(tmp_path, "here/scene_0_info.json", info)).values()
    assert things_of(room)["bowl_2"].support is None
    assert any("not beside it" in note for note in room.notes)


def test_from_file_to_judge(tmp_path):
    written(tmp_path, "scene_0_graph.json", GRAPH)
    (made,) = sw.read_scenes(written(tmp_path, "scene_0_info.json", INFO), assets="boxes")
    report = sw.check(made.scene)
    assert (report.collisions, report.out_of_bounds) == (0, 0), report
    assert {o.id: o.support.object for o in made.scene.objects if o.support} == {"bowl_2": "table_1"}
    near = changed(INFO, seen((1.9, 0.9, 0.36), -1.2), "objects", "table_1", "tf_from_cam")
    (worse,) = sw.read_scenes(written(tmp_path, "scene_0_info.json", near), assets="boxes")
    assert sw.check(worse.scene).collisions


@pytest.mark.parametrize("rows", [0, 1])
def test_a_matrix_as_rows_or_in_one_list(tmp_path, rows):
    info = INFO if rows else changed(INFO, sum(seen((2.1, 0.6, 0.4), 0.3), []), "objects", "cabinet_0", "tf_from_cam")
    (room,) = rooms_of("acdc", written(tmp_path, "scene_0_info.json", info)).values()
    require_pose(things_of(room)["cabinet_0"], (2.1, 0.6, 0.4), compass(0.3))


def test_broken_files(tmp_path):
    text = written(tmp_path, "whole.json", INFO).read_text()
    cabinet = "objects", "cabinet_0"
    for name, data, words in (
        ("cut.json", text[:-30], ("cut off",)),
        ("type.json", changed(INFO, "1", *cabinet, "bbox_extent", 2), ("objects.cabinet_0.bbox_extent[2]", "number")),
        ("missing.json", without(INFO, *cabinet, "tf_from_cam"), ("cabinet_0", "'tf_from_cam'")),
        ("nan.json", changed(INFO, float("nan"), "cam_pose", 1, 3), ("cam_pose[1][3]", "NaN")),
        ("empty.json", "", ("empty",)),
        ("zero.json", changed(INFO, [0, 0, 0, 0], "cam_pose", 1), ("cam_pose[1]", "x, y, z, w")),
        ("flat.json", changed(INFO, np.zeros((4, 4)).tolist(), *cabinet, "tf_from_cam"), ("tf_from_cam", "flattens")),
        ("rows.json", changed(INFO, np.eye(4)[:3].tolist(), *cabinet, "tf_from_cam"), ("tf_from_cam", "4 rows")),
    ):
        require_error(written(tmp_path, name, data), "acdc", *words)
