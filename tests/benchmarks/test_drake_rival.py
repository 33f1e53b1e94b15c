"""Drake's projection, where it is installed."""

from __future__ import annotations

import time

import numpy as np
import pytest

from benchmarks.judging import opinion, place
from benchmarks.rivals.drake_projection import project
from benchmarks.rooms import load, witness
from benchmarks.starts import movable, noisy_poses
from benchmarks.tenbox import ten_boxes
from sceneweaver.scene import Pose, Room, Scene, SceneObject

pytest.importorskip("pydrake", reason="drake is not installed")


def _scene(
    *objects: tuple[float, float, tuple[float, float, float]], outline=((0, 0), (5, 0), (5, 4), (0, 4))
) -> Scene:
    made = [
        SceneObject(id=f"box-{k}", category="box", size=size, pose=Pose.from_yaw(x, y, 0.0, 0.0))
        for k, (x, y, size) in enumerate(objects)
    ]
    return Scene(id="made", room=Room(outline=outline), objects=tuple(made))


def test_two_boxes_part_by_the_least_movement():
    scene = _scene((2.0, 2.0, (1.0, 1.0, 0.5)), (2.8, 2.1, (1.0, 1.0, 0.5)))
    start = witness(scene)
    poses, ok = project(scene, start)
    assert ok and opinion(place(scene, poses)).solid
    moved = poses - start
    assert moved[:, 0] == pytest.approx([-0.1, 0.1], abs=0.005)  # they share the 20 cm that they sink in
    assert np.abs(moved[:, (1, 3)]).max() < 0.02


def test_what_is_in_order_stays():
    scene = ten_boxes()
    poses, ok = project(scene, witness(scene))
    assert ok
    assert poses == pytest.approx(witness(scene), abs=1e-3)


def test_walls_push_back_and_heights_decide_who_meets():
    flat = SceneObject(id="flat", category="rug", size=(1.0, 1.0, 0.3), pose=Pose.from_yaw(2.0, 2.0, 0.0, 0.0))
    lamp = SceneObject(
        id="lamp", category="lamp", size=(1.0, 1.0, 0.3), mount="ceiling", pose=Pose.from_yaw(2.0, 2.0, 2.0, 0.0)
    )
    out = SceneObject(id="out", category="box", size=(1.0, 1.0, 0.5), pose=Pose.from_yaw(0.3, 3.0, 0.0, 0.0))
    scene = Scene(id="made", room=Room(outline=((0, 0), (5, 0), (5, 4), (0, 4))), objects=(flat, lamp, out))
    poses, ok = project(scene, witness(scene))
    assert ok
    assert poses[:2] == pytest.approx(witness(scene)[:2], abs=1e-6)
    assert poses[2, :2] == pytest.approx((0.5, 3.0), abs=0.005)


def test_reflex_corners_are_left_free():
    scene = _scene(
        (1.0, 1.0, (1.0, 1.0, 0.5)),
        (2.0, 2.0, (0.6, 0.6, 0.5)),
        outline=((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)),
    )
    poses, ok = project(scene, witness(scene))
    assert ok and opinion(place(scene, poses)).solid
    assert poses[0] == pytest.approx(witness(scene)[0], abs=1e-3)


def test_parts_and_what_is_carried():
    scene = load("dining-round")
    start = noisy_poses(scene, 1, 3)[0]
    poses, ok = project(scene, start)
    assert opinion(place(scene, poses)).solid or not ok
    assert poses.shape == start.shape and np.isfinite(poses).all()
    carried = [i for i, o in enumerate(scene.objects) if o.support is not None]
    for i in carried:
        below = scene.index(scene.objects[i].support.object)
        assert poses[i, 2] == start[i, 2]
        before, after = (np.linalg.norm(p[i, :2] - p[below, :2]) for p in (start, poses))
        assert after == pytest.approx(before, abs=1e-6)


def test_a_time_limit_is_kept():
    scene = load("library-100")
    start = noisy_poses(scene, 1, 0)[0]
    project(load("library-100"), start, 0.0)  # builds the plant
    began = time.perf_counter()
    poses, ok = project(scene, start, 0.2)
    assert time.perf_counter() - began < 5
    assert poses.shape == start.shape
    assert not ok or opinion(place(scene, poses)).solid


def test_a_process_that_ends_is_replaced():
    from benchmarks.rivals import drake_projection

    scene = _scene((2.0, 2.0, (1.0, 1.0, 0.5)), (2.8, 2.1, (1.0, 1.0, 0.5)))
    project(scene, witness(scene))
    process = drake_projection._worker._process
    assert process is not None
    process.kill()
    process.join()
    poses, ok = project(scene, witness(scene))
    assert not ok and np.array_equal(poses, witness(scene))
    assert project(scene, witness(scene))[1]
    assert len(movable(scene)) == 2
