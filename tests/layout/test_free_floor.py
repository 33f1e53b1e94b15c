"""Free floor in the engine: whatever it calls valid keeps the floor free, by the judge's own arithmetic."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import engine
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.free_floor import stand_ins
from sceneweaver.scene import FreeArea, Pose, Scene
from sceneweaver.verify.free_floor import measure
from sceneweaver.verify.solids import Placed

from .made import BED, relation, room, scene, table, thing

CASES = {
    "circle": ("bedroom", FreeArea(id="a", kind="circle", size=(1.5, 1.5))),
    "rectangle": ("study", FreeArea(id="a", kind="rectangle", size=(1.4, 0.9))),
    "inside the door": ("living-room", FreeArea(id="a", kind="rectangle", size=(1.0, 1.2), targets=("door",))),
    "in front": ("study", FreeArea(id="a", kind="circle", size=(1.0, 1.0), targets=("desk",), side="front")),
    "sides": ("bedroom", FreeArea(id="a", kind="clearance", size=(0.7, 0.7), targets=("bed",), side="sides")),
    "front": ("study", FreeArea(id="a", kind="clearance", size=(0.9, 0.9), targets=("cabinet",), side="front")),
    "off the walls": ("study", FreeArea(id="a", kind="gap", size=(0.4, 0.4), targets=("bin",), others=("wall",))),
}


def keeping(name: str, area: FreeArea) -> Scene:
    made = Scene.example(name)
    return made.model_copy(update={"free_areas": (area,)})


@pytest.mark.parametrize("case", CASES)
def test_valid_layouts_keep_the_floor_free(case):
    name, area = CASES[case]
    made = keeping(name, area)
    assert not {*area.targets} - {*made.ids, *(d.id for d in made.room.doors)}
    solution = engine.refine(made, candidates=24, seed=5, device="cpu", walk=False)
    assert solution.poses.shape == (24, len(made.objects), 4)
    valid = np.flatnonzero(solution.status == 0)
    assert len(valid) >= 8
    for candidate in valid[:8]:
        layout = solution.scene(candidate)
        assert measure(Placed.of(layout), layout.free_areas[0]).holds
        assert sw.check(layout, walkable=False).valid


def test_without_free_floor_nothing_is_added():
    made = Scene.example("bedroom")
    compiled = compile_scene(made)
    assert compiled.room.size == len(made.objects)
    assert compiled.bodies(compiled.room.home[None]).shape[1] == len(made.objects)


def test_stand_ins_meet_nothing_and_follow_what_carries_them():
    around = FreeArea(id="a", kind="clearance", size=(0.5, 0.5), targets=("bed",), side="around")
    made = scene([BED, thing("rug", (2.0, 2.0, 0.02))], [], free_areas=(around,), room=room(6.0, 6.0))
    compiled = compile_scene(made)
    assert not (compiled.room.flags & 1)[-1].any()
    world = np.array([[[3.0, 2.0, 0.0, 1.0], [1.0, 1.0, 0.0, 0.0]]])
    assert compiled.bodies(world)[0, 2] == pytest.approx([3.0, 2.0, 0.0, 1.0])
    solution = engine.refine(made, candidates=8, seed=1, device="cpu", walk=False)
    assert solution.free_floor is not None
    apart = np.linalg.norm(solution.free_floor[:, 0, :2] - solution.poses[:, 0, :2], axis=-1)
    assert apart.max() < 1e-4
    assert (solution.status == 0).any()  # what is flat may lie in it


def test_a_chair_may_stand_in_the_clearance_of_its_table():
    around = FreeArea(id="a", kind="clearance", size=(0.8, 0.8), targets=("table",), side="around")
    chair = thing("chair", (0.5, 0.5, 0.9))
    made = scene([table(), chair, thing("bin", (0.3, 0.3, 0.4))], [relation("front_against", "chair", "table")])
    made = made.model_copy(update={"free_areas": (around,)})
    solution = engine.refine(made, candidates=16, seed=2, device="cpu", walk=False)
    valid = np.flatnonzero(solution.status == 0)
    assert len(valid)
    for candidate in valid[:6]:
        poses = {o.id: o.pose.position for o in solution.scene(candidate).objects}
        assert np.hypot(poses["bin"][0] - poses["table"][0], poses["bin"][1] - poses["table"][1]) > 0.8 + 0.4
        assert sw.check(solution.scene(candidate), walkable=False).valid


def test_the_two_sides_of_a_gap_are_kept_apart():
    gap = FreeArea(id="a", kind="gap", size=(1.2, 1.2), targets=("counter",), others=("shelf",))
    things = [thing("counter", (0.6, 1.8, 0.9)), thing("shelf", (0.3, 1.2, 1.8))]
    made = scene(things, [relation("against_wall", "shelf")], free_areas=(gap,))
    solution = engine.refine(made, candidates=16, seed=3, device="cpu", walk=False)
    valid = np.flatnonzero(solution.status == 0)
    assert len(valid) >= 8
    assert all(sw.check(solution.scene(k), walkable=False).valid for k in valid[:6])


def test_a_way_between_doors_is_kept_free():
    given = room(3.2, 1.8)
    far = given.doors[0].model_copy(update={"id": "far", "wall": 2, "offset": 2.0})
    hall = given.model_copy(update={"doors": (given.doors[0], far), "windows": ()})
    way = FreeArea(id="a", kind="path", size=(0.9, 0.9), targets=("door",), others=("far",))
    made = scene([thing("bench", (0.4, 1.0, 0.5))], [], free_areas=(way,), room=hall)
    assert len(stand_ins(made, np.zeros((1, 4))).objects) == 1
    solution = engine.refine(made, candidates=16, seed=4, device="cpu", walk=False)
    for candidate in np.flatnonzero(solution.status == 0)[:6]:
        layout = solution.scene(candidate)
        assert measure(Placed.of(layout), way).holds


def test_floor_that_is_free_stays_where_it_is():
    circle = FreeArea(id="a", kind="circle", size=(1.2, 1.2), pose=Pose.from_yaw(3.5, 2.5, 0.0, 0.0))
    bed = BED.model_copy(update={"pose": Pose.from_yaw(1.2, 2.8, 0.0, 0.0)})
    made = scene([bed], [], free_areas=(circle,))
    kept = engine.refine(made, candidates=4, init="current", device="cpu", walk=False).best
    assert kept.free_areas[0].pose.position == pytest.approx((3.5, 2.5, 0.0), abs=1e-3)
    given = np.tile([[[1.2, 2.8, 0.0, 0.0]]], (3, 1, 1))
    assert engine.refine(made, candidates=3, init=given, device="cpu", walk=False).best.free_areas[0].pose is not None


def test_an_edit_session_moves_things_off_free_floor():
    circle = FreeArea(id="a", kind="circle", size=(1.4, 1.4), pose=Pose.from_yaw(3.6, 2.6, 0.0, 0.0))
    bed = BED.model_copy(update={"pose": Pose.from_yaw(1.2, 2.8, 0.0, 0.0)})
    chair = thing("chair", (0.5, 0.5, 0.9), pose=Pose.from_yaw(4.7, 3.7, 0.0, 0.0))
    session = sw.EditSession(scene([bed, chair], [], free_areas=(circle,)), device="cpu")
    moved = session.move("chair", to=(3.6, 2.6))
    assert moved.valid
    assert measure(Placed.of(moved.scene), moved.scene.free_areas[0]).holds


def test_floor_that_cannot_be_free_is_the_reason():
    circle = FreeArea(id="dance", kind="circle", size=(2.6, 2.6))
    made = scene([BED, thing("wardrobe", (0.6, 2.0, 2.0))], [], free_areas=(circle,), room=room(3.0, 3.0))
    solution = sw.refine(made, candidates=16, seed=1, device="cpu")
    assert not (solution.status == 0).any()
    assert solution.explanation is not None and "dance (circle of 2.60 m)" in solution.explanation
