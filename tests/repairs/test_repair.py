"""Repair of broken scenes: least movement, nothing silent."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.geometry.rotations import tilt_of
from sceneweaver.repairs.upright import engine_scene, put_back
from sceneweaver.scene import Pose
from tests.layout.made import BED, CUP, PICTURE, relation, room, scene, table, thing, zoo


def repair(what, **options):
    return sw.repair_report(what, **({"device": "cpu", "candidates": 8} | options))


def at(obj, x, y, z=0.0, yaw=0.0):
    return obj.model_copy(update={"pose": Pose.from_yaw(x, y, z, yaw)})


def leaning(x: float, y: float, z: float, degrees: float, yaw: float = 0.0) -> Pose:
    """Tilted about the object's own front, then turned."""
    a, b = math.radians(degrees) / 2, yaw / 2
    return Pose(
        position=(x, y, z),
        quaternion=(
            math.cos(b) * math.sin(a),
            math.sin(b) * math.sin(a),
            math.sin(b) * math.cos(a),
            math.cos(b) * math.cos(a),
        ),
    )


A, B = at(thing("a"), 2.0, 2.0), at(thing("b"), 3.5, 2.5, yaw=0.3)


@pytest.mark.parametrize("name", ["bedroom", "living-dining-L", "office-20", "restaurant-dense"])
def test_a_valid_scene_is_returned_as_it_is(name):
    done = repair(zoo(name))
    assert sw.repair(zoo(name), device="cpu") is zoo(name) and done.scene is zoo(name)
    assert done.valid and done.moves == () and done.device is None


def test_disturbed_rooms_are_valid_again_with_all_that_was_in_them():
    rng = np.random.default_rng(2)
    for name in ("bedroom", "studio-U", "office-20"):
        what = zoo(name)
        poses = {}
        for obj in what.objects:
            if obj.mount == "floor":
                (x, y, z), (dx, dy, turn) = obj.pose.position, rng.normal(size=3) * (0.15, 0.15, 0.2)
                poses[obj.id] = Pose.from_yaw(x + dx, y + dy, z, obj.pose.yaw + turn)
        broken = what.replace_poses(poses)
        done = repair(broken)
        assert not done.before.valid and done.valid and done.unmet == ()
        assert sw.check(done.scene).valid
        strip = {"objects": (), "relations": ()}
        assert done.scene.model_copy(update=strip) == broken.model_copy(update=strip)
        assert done.scene.relations == broken.relations
        for before, after in zip(broken.objects, done.scene.objects, strict=True):
            assert after.model_copy(update={"pose": before.pose}) == before


def test_what_is_in_order_keeps_its_pose_exactly():
    inside = at(thing("c"), 1.23456789012345, 3.3000000001, 0.0012, 0.123456789)
    done = repair(scene([A, at(thing("b"), 2.4, 2.0), inside], []))
    assert done.valid and [m.id for m in done.moves] == ["a", "b"]
    assert done.scene.object("c").pose == inside.pose


def test_without_relations_only_bodies_count():
    what = scene([at(BED, 2.5, 2.2), at(thing("b"), 2.5, 2.2)], [relation("against_wall", "bed")])
    with_them, without = repair(what), repair(what, relations=False)
    assert with_them.valid and sw.check(with_them.scene).valid
    assert without.valid and not sw.check(without.scene).valid
    assert without.scene.relations == what.relations
    assert sum(m.distance for m in without.moves) < sum(m.distance for m in with_them.moves)


@pytest.mark.parametrize("x", [5.3, 7.0, 60.0, -4000.0])
def test_what_is_outside_comes_in(x):
    done = repair(scene([A, at(thing("b"), x, 2.0)], []))
    assert done.valid and [m.id for m in done.moves] == ["b"]
    assert done.scene.object("b").pose.position[0] == pytest.approx(4.75 if x > 0 else 0.25, abs=0.06)


@pytest.mark.parametrize("z", [0.4, -0.2])
def test_what_floats_or_sinks_is_set_down(z):
    lamp = at(thing("lamp", (0.4, 0.4, 0.3), mount="ceiling"), 3.5, 1.0, 2.0)
    done = repair(scene([at(A, 2.0, 2.0, z), B, lamp], []))
    assert done.valid and {m.id for m in done.moves} == {"a", "lamp"}
    assert all(m.distance == 0.0 and m.turn == 0.0 for m in done.moves)
    assert done.moves[0].rise == pytest.approx(-z)
    assert done.scene.object("lamp").pose.position[2] == pytest.approx(2.4, abs=1e-6)


def test_small_things_go_back_onto_their_surface_and_along_with_it():
    base = at(table(), 2.5, 2.0)
    over = repair(scene([base, at(CUP, 2.5, 2.58, 0.75)], []))
    assert over.valid and [m.id for m in over.moves] == ["cup"]
    lost = repair(scene([base, at(CUP, 4.5, 3.5, 0.0)], []))
    assert lost.valid and lost.scene.object("cup").pose.position[2] == pytest.approx(0.75, abs=1e-6)
    along = repair(scene([at(table(), 0.3, 2.0), at(CUP, 0.4, 2.1, 0.75)], []))
    assert along.valid and {m.id for m in along.moves} == {"table", "cup"}
    a, b = (along.scene.object(k).pose.position for k in ("table", "cup"))
    assert np.subtract(b, a) == pytest.approx((0.1, 0.1, 0.75), abs=1e-3)


def test_wall_objects_are_hung_again():
    done = repair(scene([A, at(PICTURE, 2.0, 3.7, 1.4, -math.pi / 2)], []))
    assert done.valid and [m.id for m in done.moves] == ["picture"]


def test_fixed_objects_never_move():
    pose = Pose.from_yaw(2.0000000001, 2.0, 0.0, 0.2)
    pillar = thing("pillar", (0.4, 0.4, 2.5), fixed=True, pose=pose)
    done = repair(scene([pillar, at(thing("b"), 2.2, 2.0)], []))
    assert done.valid and done.scene.object("pillar").pose == pose


def test_a_tilt_is_kept_and_reported():
    lying = thing("lamp", (0.3, 0.3, 1.5), pose=leaning(2.0, 2.0, 0.0, 90.0, 0.4))
    done = repair(scene([lying, at(thing("b"), 2.1, 2.2)], []))
    assert done.valid and len(done.notes) == 1 and "lamp leans by 90.0 degrees" in done.notes[0]
    after = done.scene.object("lamp").pose
    assert tilt_of(after.quaternion) == pytest.approx(math.pi / 2)
    assert after.position[2] == pytest.approx(0.15, abs=1e-6), "its lowest edge on the floor"


def test_what_leans_less_than_the_judge_minds_is_no_reason_to_move():
    a = thing("a", pose=leaning(2.0, 2.0, 0.0, 0.4))
    done = repair(scene([a, at(thing("b"), 3.5, 2.0, 0.3)], []))
    assert done.valid and done.notes == () and [m.id for m in done.moves] == ["b"]
    assert done.scene.object("a").pose == a.pose


def test_turns_go_on_top_of_a_tilt():
    what = scene([thing("a", pose=leaning(2.0, 2.0, 0.0, 20.0, 0.4))], [])
    model, lift = engine_scene(what, relations=True)
    poses = np.array([[*model.objects[0].pose.position, 0.4 + 0.5]])
    pose = put_back(what, lift, poses).objects[0].pose
    assert pose.yaw == pytest.approx(0.9) and tilt_of(pose.quaternion) == pytest.approx(math.radians(20.0))
    assert pose.position == pytest.approx((2.0, 2.0, 0.0))


def test_everything_in_one_place():
    what = zoo("bedroom-small")
    done = repair(what.replace_poses({o.id: Pose.from_yaw(2.0, 1.5, 0.0, 0.0) for o in what.objects}), candidates=16)
    assert done.valid and len(done.scene.objects) == len(what.objects)


def test_an_impossible_scene_is_as_good_as_it_gets_and_says_why():
    what = scene(
        [at(thing("whale", (9, 2, 1)), 2, 2), at(thing("b"), 0.1, 1.0), at(thing("c"), 3.9, 2.8)], [], room=room(4, 3)
    )
    done = repair(what)
    assert not done.valid and done.explanation and "whale" in done.explanation
    assert len(done.unmet) < sum(v.kind != "soft_relation" for v in done.before.violations)
    assert len(done.scene.objects) == 3


def test_relations_that_cannot_hold_do_not_keep_the_rest_from_being_mended():
    pillar = thing("pillar", (0.4, 0.4, 2.5), fixed=True, pose=Pose.from_yaw(2.5, 2.0, 0.0, 0.0))
    what = scene(
        [pillar, at(thing("b"), 2.6, 2.0), at(thing("c"), 3.9, 2.8, 0.2)], [relation("against_wall", "pillar")]
    )
    done = repair(what)
    assert not done.valid and [v.kind for v in done.unmet] == ["relation"]
    assert {m.id for m in done.moves} == {"b", "c"} and max(m.distance for m in done.moves) < 0.5


def test_dropped_objects_are_not_brought_back_and_that_is_said():
    what = scene([at(A, 0.1, 2.0)], []).model_copy(
        update={"dropped": (sw.Dropped(id="sofa", category="sofa", reason="no room"),)}
    )
    done = repair(what)
    assert not done.valid and [v.kind for v in done.unmet] == ["dropped"]
    assert "sofa" in done.notes[0] and done.scene.dropped == what.dropped


def test_same_seed_same_scene():
    what = zoo("bedroom")
    broken = what.replace_poses({o.id: Pose.from_yaw(2.0, 1.5, 0.0, 0.0) for o in what.objects if o.mount == "floor"})
    assert repair(broken, seed=3).scene == repair(broken, seed=3).scene


def test_the_report_is_plain_data():
    import json

    data = repair(scene([A, at(thing("b"), 2.4, 2.0)], [])).to_dict()
    assert json.loads(json.dumps(data)) == data
    assert data["valid"] and [m["id"] for m in data["moved"]] == ["a", "b"]
    assert not data["before"]["valid"] and data["metrics"]["valid"]


@pytest.mark.parametrize(
    ("options", "says"),
    [({"candidates": 0}, "candidates"), ({"seed": -1}, "seed"), ({"time_limit": 0}, "time_limit")],
)
@pytest.mark.parametrize("broken", [False, True])
def test_bad_arguments_are_named(options, says, broken):
    what = scene([A, at(thing("b"), 2.4 if broken else 3.5, 2.0)], [])
    with pytest.raises(sw.InputError, match=says):
        sw.repair(what, **({"device": "cpu"} | options))
