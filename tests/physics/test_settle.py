"""What stands stays, what floats falls, and what may move is not welded."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.assets import make
from sceneweaver.physics import build, settle, stability
from sceneweaver.physics.hulls import MOST, _reaches, solids_of
from sceneweaver.scene import Part, Pose, Room, Scene, SceneObject, Support

ROOM = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)))
ASSETS = {a.id: a for a in (make("desk", 3), make("mug", 2), make("toilet", 1), make("exercise_ball", 1))}
DESK, MUG, TOILET, BALL = ASSETS.values()


def _box(object_id: str, z: float, **more) -> SceneObject:
    return SceneObject(id=object_id, category="box", size=(0.3, 0.2, 0.4), pose=Pose.from_yaw(1, 1, z, 0.5), **more)


def _scene(*objects: SceneObject) -> Scene:
    return Scene(id="s", room=ROOM, objects=objects)


def test_what_stands_stays() -> None:
    top = DESK.surfaces[0]
    mug = MUG.object("mug", pose=Pose.from_yaw(2, 2, top.z, 0.4), support=Support(object="desk", surface=top.name))
    found = stability(
        _scene(DESK.object("desk", pose=Pose.from_yaw(2, 2, 0, 0.9)), mug, _box("b", 0)), ASSETS.__getitem__
    )
    assert found["free"] == 3 and found["moved_over_0_01m"] == 0 and found["mean_shift_m"] < 2e-3


def test_what_floats_falls_and_is_a_fault() -> None:
    scene = _scene(_box("up", 0.5))
    found = stability(scene, seconds=1.0)
    assert found["moved_over_0_1m"] == 1 and found["moved"]["up"] > 0.4
    result = settle(scene, seconds=1.0)
    assert result.faults == ("up",) and result.scene.object("up").pose == scene.object("up").pose


def test_a_little_is_taken_over() -> None:
    result = settle(_scene(_box("b", 0.004)), seconds=1.0)
    assert not result.faults and result.scene.object("b").pose.position[2] == pytest.approx(0, abs=1e-3)
    assert max(stability(result.scene, seconds=1.0)["moved"].values()) < 1e-3


def test_what_may_move() -> None:
    objects = (
        _box("free", 0),
        _box("told", 0, fixed=True),
        TOILET.object("toilet", pose=Pose.from_yaw(3, 3, 0, 0)),
        DESK.object("desk", pose=Pose.from_yaw(2, 2, 0, 0)),
        _box("hung", 1.0, mount="wall"),
    )
    model = build(_scene(*objects), ASSETS.__getitem__)
    assert model.free == ("free", "desk") and model.fixed == ("told", "toilet", "hung")


def test_what_is_heavy_is_not_welded() -> None:
    piano = make("grand_piano", 0)
    assert piano.mass > 200
    scene = _scene(piano.object("piano", pose=Pose.from_yaw(2, 2, 0, 0)))
    found = stability(scene, {piano.id: piano}.__getitem__, 1.0)
    assert found["free"] == 1 and found["mean_shift_m"] < 2e-3


def test_parts_are_worked_out_once() -> None:
    again = make("exercise_ball", 1)
    assert solids_of(again.object("a"), again, np.ones(3))[0] is solids_of(BALL.object("b"), BALL, np.ones(3))[0]
    once, twice = (sum(s.volume for s in solids_of(BALL.object("b"), BALL, np.full(3, k))) for k in (1.0, 2.0))
    assert twice == pytest.approx(8 * once)


def test_merged_parts_leave_what_moves_its_room() -> None:
    kitchen = make("kitchen_counter", 0)
    assert len(kitchen.hulls) > MOST
    solids = solids_of(kitchen.object("k"), kitchen, np.ones(3))
    assert len(solids) <= MOST and {s.link for s in solids} == set(range(len(kitchen.links) + 1))
    assert not [1 for a in solids for b in solids if a.link < b.link and _reaches(a, b)]


def test_parts_of_an_object_without_an_asset() -> None:
    parts = (Part(polygon=((-0.15, -0.1), (0.15, -0.1), (0, 0.1)), z=(0, 0.4)),)
    one, two = solids_of(_box("a", 0, parts=parts), None, np.ones(3)), solids_of(_box("b", 0), None, np.ones(3))
    assert one[0].box is None and one[0].volume == pytest.approx(0.012)
    assert two[0].box is not None and two[0].volume == pytest.approx(0.024)


def test_merged_parts_contain_the_hulls_and_stay_in_the_prisms() -> None:
    from scipy.spatial import ConvexHull

    assert len(BALL.hulls) > MOST
    solids = solids_of(BALL.object("ball"), BALL, np.ones(3))
    assert len(solids) <= MOST
    planes = [ConvexHull(s.points).equations for s in solids]
    for hull in BALL.hulls:
        assert min((hull.vertices @ p[:, :3].T + p[:, 3]).max() for p in planes) < 1e-6
    low, high = BALL.mesh.bounds
    assert all((s.points > low - 2e-3).all() and (s.points < high + 2e-3).all() for s in solids)
