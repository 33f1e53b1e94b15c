"""Many scenes at once, soft relations that are to be kept, and objects taken out."""

from __future__ import annotations

import math

import pytest

import sceneweaver as sw
from sceneweaver.repairs.solving import Budget, Work, add_option
from sceneweaver.repairs.staying import let_stay
from sceneweaver.repairs.wishes import holding
from sceneweaver.runtime.deadline import Deadline
from sceneweaver.scene import Pose, Relation, Room
from sceneweaver.scene.objects import Support
from tests.layout.made import CUP, scene, table, thing, zoo


def at(obj, x, y, z=0.0, yaw=0.0):
    return obj.model_copy(update={"pose": Pose.from_yaw(x, y, z, yaw)})


def relation(kind, subject, target=None, hard=True, **params):
    return Relation(type=kind, subject=subject, target=target, hard=hard, params=params)


def disturbed(name, shift):
    what = zoo(name)
    floor = [o for o in what.objects if o.mount == "floor"]
    poses = {}
    for k, obj in enumerate(floor):
        x, y, z = obj.pose.position
        poses[obj.id] = Pose.from_yaw(x + shift * math.cos(k), y + shift * math.sin(k), z, obj.pose.yaw)
    return what.replace_poses(poses)


def test_many_are_as_one_by_one():
    scenes = [disturbed("bedroom", 0.2), zoo("bedroom"), disturbed("bedroom-small", 0.1)]
    many = sw.repair_many(scenes, candidates=4, device="cpu")
    for what, done in zip(scenes, many, strict=True):
        alone = sw.repair_report(what, candidates=4, device="cpu")
        assert done.valid and alone.valid and done.source is what
        assert done.scene == alone.scene, "what stands beside a scene in the batch does not matter"
    assert many[1].scene is scenes[1] and many[1].device is None
    assert sw.repair_many([], device="cpu") == []


def in_a_row():
    """A cupboard in the wall, and a box beside it that holds on to it."""
    relations = [relation("leftright_to_leftright", "b", "a", hard=False), relation("against_wall", "a", hard=False)]
    big, small = thing("a", (0.6, 1.6, 2.0)), thing("b", (0.4, 0.5, 0.5))
    return scene([at(big, 0.25, 2.0), at(small, 0.25, 3.07), at(thing("c", (1, 1, 1)), 1.0, 2.9)], relations)


def test_soft_relations_that_hold_go_on_holding():
    what = in_a_row()
    assert holding(what) == {0} and holding(what, slack=0.1) == {0, 1}
    kept = sw.repair_report(what, soft=True, candidates=8, device="cpu")
    assert kept.valid and kept.held == (what.relations[0],) and kept.lost == ()
    assert kept.nearly == (what.relations[1],) and kept.unmended == ()
    assert holding(kept.scene) == {0, 1}
    assert kept.to_dict()["soft_relations"] == {"held": 1, "lost": [], "nearly": 1, "unmended": []}


def test_wishes_that_cannot_hold_are_named_and_cost_no_validity():
    pillar = thing("p", (0.3, 0.3, 2.0), fixed=True, pose=Pose.from_yaw(2.5, 2.0, 0.0, 0.0))
    inside = relation("centered_on", "b", "p", hard=False, axis="both", offset=0.1)
    beside = relation("near", "b", "c", hard=False, max=0.3)
    what = scene([pillar, at(thing("b"), 2.55, 2.0), at(thing("c"), 2.6, 2.7)], [inside, beside])
    done = sw.repair_report(what, soft=True, candidates=8, device="cpu")
    assert done.valid and done.held == (inside, beside) and done.lost == (inside,)


def test_relations_of_a_scene_are_what_they_were():
    what = in_a_row()
    done = sw.repair_report(what, soft=True, candidates=4, device="cpu")
    assert done.scene.relations == what.relations


def test_what_stands_on_a_carrier_goes_with_it_also_with_wishes():
    base, cup = at(table(), 0.3, 2.0), at(CUP, 0.4, 2.1, 0.75)
    done = sw.repair_report(scene([base, cup], []), soft=True, candidates=4, device="cpu")
    a, b = (done.scene.object(k).pose.position for k in ("table", "cup"))
    assert done.valid and (b[0] - a[0], b[1] - a[1]) == pytest.approx((0.1, 0.1), abs=1e-3)


def overfull():
    """Two rafts that do not fit side by side, a box on one of them, and a stool."""
    a, b = thing("a", (2.4, 1.4, 0.5)), thing("b", (2.4, 1.2, 0.5))
    objects = [at(a, 1.3, 0.8), at(b, 1.4, 1.3), at(thing("stool", (0.3, 0.3, 0.4)), 0.2, 2.0)]
    return scene(objects, [], room=Room(outline=((0, 0), (2.6, 0), (2.6, 2.3), (0, 2.3))))


def test_an_overfull_room_is_proved_to_be_so_and_nothing_is_lost_silently():
    done = sw.repair_report(overfull(), candidates=4, device="cpu")
    assert not done.valid and done.proof and done.taken_out == () and len(done.scene.objects) == 3
    assert "\n" not in done.proof and "a" in done.proof and done.explanation == done.proof


def test_drop_takes_out_the_least_and_says_so():
    done = sw.repair_report(overfull(), drop=True, candidates=4, device="cpu")
    assert done.valid and sw.check(done.scene).valid
    assert done.taken_out == ("b",), "one is enough, and it is the smaller of the two that do not fit together"
    assert {o.id for o in done.scene.objects} == {"a", "stool"} and done.proof
    assert done.to_dict()["taken_out"] == ["b"] and done.scene.dropped == ()


def test_drop_leaves_alone_what_can_be_mended():
    what = scene([at(thing("a"), 0.1, 1.0), at(thing("b"), 2.5, 2.0)], [])
    done = sw.repair_report(what, drop=True, candidates=4, device="cpu")
    assert done.valid and done.taken_out == () and done.explanation is None


def test_drop_takes_what_stands_on_a_thing_and_relations_with_it():
    whale = at(table("whale", (6.0, 3.0, 0.75)), 2.0, 1.5)
    cup = CUP.model_copy(update={"support": Support(object="whale", surface="top")})
    what = scene(
        [whale, at(cup, 2.0, 1.5, 0.75), at(thing("b"), 0.2, 0.6)], [relation("near", "b", "whale", hard=False)]
    )
    done = sw.repair_report(what, drop=True, soft=True, candidates=4, device="cpu")
    assert done.valid and done.taken_out == ("whale", "cup") and done.scene.relations == ()


def moved(done):
    return {m.id for m in done.moves if m.distance > 1e-3}


def test_with_wishes_one_object_makes_way_instead_of_both():
    a, b = thing("a", (1.0, 1.0, 1.0)), thing("b", (1.0, 1.0, 1.0))
    what = scene([at(a, 1.2, 1.5), at(b, 2.1, 1.5)], [])
    spread = sw.repair_report(what, candidates=4, device="cpu")
    one = sw.repair_report(what, soft=True, candidates=4, device="cpu")
    assert spread.valid and moved(spread) == {"a", "b"}, "squares spread the movement"
    assert one.valid and len(moved(one)) == 1
    assert sum(m.distance for m in one.moves) == pytest.approx(0.1, abs=2e-3)


def test_in_a_room_that_stays_invalid_nothing_moves_for_nothing():
    small = [at(thing(name, (0.3, 0.3, 0.4)), x, y) for name, x, y in (("c", 1.3, 2.25), ("d", 0.2, 2.12))]
    what = scene([*overfull().objects[:2], *small], [], room=overfull().room)
    work = Work.on(what, True, True)
    add_option(
        work, what.replace_poses({o.id: Pose.from_yaw(x, 2.1, 0, 0) for o, x in zip(small, (1.3, 0.7), strict=True)})
    )
    assert [v.kind for v in work.best.report.violations if v.hard] == ["collision"] and len(work.best.moves) == 2
    let_stay([work], Budget(4, 0, "cpu"), Deadline(math.inf))
    assert [m.id for m in work.best.moves] == ["c"], "c stood in the wall, d was right where it was"
    assert [v.kind for v in work.best.report.violations if v.hard] == ["collision"]
