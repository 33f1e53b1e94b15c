"""Carrying out proposals in small rooms: what moves, what gives way first, and what is said of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from sceneweaver.agent.executor import Executor, Outcome
from sceneweaver.agent.riders import at_rest
from sceneweaver.agent.settings import Settings
from sceneweaver.critic import CRITERIA, Fault, Review
from sceneweaver.generate.carry import local
from sceneweaver.knowledge import room_type
from sceneweaver.language import Entity, SceneGraph
from sceneweaver.layout import Solution, refine
from sceneweaver.runtime.deadline import Deadline
from sceneweaver.scene import (
    Add,
    Dropped,
    InputError,
    Intent,
    Pose,
    Priority,
    Relation,
    Remove,
    Room,
    Scene,
    SceneObject,
    SetPose,
    SetSize,
    Support,
    Surface,
)
from sceneweaver.tools.base import Proposal
from sceneweaver.verify import Violation, check

QUICK = Settings(device="cpu", candidates=16)
LARGE = (1.7, 1.7, 0.8)
"""Of this size one fits beside the bed in the room below, not two."""


def box(
    object_id: str, size: tuple[float, float, float], x: float = 0.0, y: float = 0.0, z: float = 0.0, **more: Any
) -> SceneObject:
    """A box at x, y, z [m]."""
    return SceneObject(
        id=object_id, category=more.pop("category", "cabinet"), size=size, pose=Pose.from_yaw(x, y, z, 0), **more
    )


def wanted(object_id: str, priority: Priority | None, size: tuple[float, float, float] = LARGE) -> SceneObject:
    return box(object_id, size, intent=Intent(priority=priority, request=object_id if priority == "asked" else None))


def room_with(*objects: SceneObject, relations: tuple[Relation, ...] = (), **more: Any) -> Scene:
    """Objects in a room of 3 by 3 m."""
    room = Room(type="bedroom", outline=((0, 0), (3, 0), (3, 3), (0, 3)))
    return Scene(id="s", room=room, objects=objects, relations=relations, **more)


BED = box("bed-0", (2.0, 1.6, 0.5), 1.1, 2.1)


def run(
    before: Scene,
    /,
    *edits: Any,
    settings: Settings = QUICK,
    seed: int = 0,
    rival: Outcome | None = None,
    **more: Any,
) -> Outcome:
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), settings)
    return executor.run(before, Proposal(edits=edits, **more), seed, rival)


def fresh(scene: Scene, **more: Any) -> Outcome:
    """A layout from scratch."""
    return run(scene, scene=scene, fresh=True, **more)


# ---- edits ----------------------------------------------------------------------------------------------------------


def test_what_is_valid_as_it_was_proposed_is_left_alone():
    stool = box("stool-0", (0.4, 0.4, 0.5), 2.6, 0.4)
    outcome = run(room_with(BED), Add(object=stool), notes=("a note",), unmet=("a wish",))
    assert outcome.scene == room_with(BED, stool) and outcome.report.valid
    assert outcome.notes == ("a note",) and outcome.unmet == ("a wish",)


def test_what_is_new_finds_a_place_and_nothing_else_moves():
    scene = room_with(BED, box("desk-0", (0.6, 1.0, 0.75), 2.6, 0.6))
    outcome = run(scene, Add(object=wanted("chest-0", "usual", (0.4, 0.9, 0.8))))
    assert outcome.report.valid and not outcome.notes
    assert outcome.scene.objects[:2] == scene.objects
    assert run(scene, Add(object=wanted("chest-0", "usual", (0.4, 0.9, 0.8)))).scene == outcome.scene


def test_what_was_moved_into_another_thing_is_moved_out_again_and_the_other_stays():
    scene = room_with(BED, box("chest-0", (0.4, 0.9, 0.8), 2.7, 0.6))
    outcome = run(scene, SetPose(id="chest-0", pose=Pose.from_yaw(1.9, 1.5, 0, 0)))
    assert outcome.report.valid and outcome.scene.object("bed-0") == scene.object("bed-0")
    assert outcome.scene.object("chest-0").pose != scene.object("chest-0").pose


def test_what_nobody_asked_for_is_left_out_where_it_has_no_place():
    for priority in (None, "optional", "usual", "needed"):
        outcome = run(room_with(BED), Add(object=wanted("chest-0", priority)))
        assert outcome.scene == room_with(BED) and outcome.report.valid
        assert outcome.notes == ("chest-0 was left out: the room has no place for it",) and not outcome.unmet


def test_what_was_asked_for_is_dropped_at_last_and_reported():
    bed = BED.model_copy(update={"intent": Intent(priority="asked", request="bed-0")})
    outcome = run(room_with(bed), Add(object=wanted("chest-0", "asked")))
    (gone,) = {"bed-0", "chest-0"} - set(outcome.scene.ids)
    assert [d.id for d in outcome.scene.dropped] == [gone] and not outcome.report.valid
    assert outcome.unmet == (f"{gone}: the room has no place for it",)
    assert outcome.key[:2] == (0, 1)


def test_small_things_that_are_in_the_way_are_left_out_unless_they_were_asked_for():
    top = Surface(name="top", polygon=((-0.3, -0.5), (0.3, -0.5), (0.3, 0.5), (-0.3, 0.5)), z=0.75)
    on = Support(object="desk-0", surface="top")
    desk = box("desk-0", (0.6, 1.0, 0.75), 2.6, 0.6, surfaces=(top,))
    cups = [
        box(f"cup-{k}", (0.1, 0.1, 0.1), 2.6, y, 0.75, support=on, mount="surface") for k, y in enumerate((0.6, 0.63))
    ]
    scene = room_with(BED, desk, cups[0])
    outcome = run(scene, Add(object=cups[1]))
    assert outcome.scene == scene and outcome.report.valid
    assert outcome.notes == ("1 small things did not fit and were left out",)
    asked = cups[1].model_copy(update={"intent": Intent(priority="asked", request="cup")})
    outcome = run(scene, Add(object=asked))
    assert outcome.scene.ids == (*scene.ids, "cup-1") and outcome.report.valid and not outcome.notes


def test_nothing_gives_way_for_an_edit_of_a_scene_that_lacks_nothing():
    scene = room_with(BED, box("chest-0", (0.4, 0.9, 0.8), 2.7, 0.6, intent=Intent(priority="optional")))
    larger = SetSize(id="bed-0", size=(2.8, 2.8, 0.5))
    assert run(scene, larger).scene.ids == ("bed-0",)
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), QUICK)
    outcome = run(scene, larger, rival=executor.judged(scene))
    assert outcome.scene.ids == scene.ids and outcome.faults and not outcome.notes


def test_an_edit_ends_where_more_that_was_asked_for_would_go_than_without_it():
    asked = Intent(priority="asked")
    bed = BED.model_copy(update={"intent": asked})
    scene = room_with(bed, box("chest-0", (0.4, 0.9, 0.8), 2.7, 0.6, intent=asked))
    larger = SetSize(id="bed-0", size=(2.8, 2.8, 0.5))
    assert run(scene, larger).scene.dropped
    piano = Entity(id="piano", noun="piano", category="upright_piano", count=(1, 1))
    rival = Executor(room_type("bedroom"), SceneGraph(text="a piano", entities=(piano,)), QUICK).judged(scene)
    outcome = run(scene, larger, rival=rival)
    assert not rival.lacks_nothing
    assert not outcome.scene.dropped and outcome.faults


def test_what_is_carried_goes_along_in_a_search_after_an_edit():
    top = Surface(name="top", polygon=((-0.2, -0.4), (0.2, -0.4), (0.2, 0.4), (-0.2, 0.4)), z=0.8)
    chest = box("chest-0", (0.4, 0.9, 0.8), 2.7, 0.6, surfaces=(top,))
    on = Support(object="chest-0", surface="top")
    vase = box("vase-0", (0.1, 0.1, 0.3), 2.8, 0.9, 0.8, support=on, mount="surface")
    scene = room_with(BED, chest, vase)
    new = Pose.from_yaw(1.9, 1.5, 0, 0)
    edits = (SetPose(id="chest-0", pose=new), SetPose(id="vase-0", pose=Pose.from_yaw(2.0, 1.8, 0.8, 0)))
    outcome = run(scene, *edits)
    assert outcome.report.valid and outcome.scene.object("bed-0") == BED
    moved, carried = outcome.scene.object("chest-0").pose, outcome.scene.object("vase-0").pose
    assert moved != new and local(moved, carried) == pytest.approx((0.1, 0.3, 0.8, 0.0), abs=1e-6)


@pytest.mark.parametrize("hard", (True, False))
def test_what_is_carried_is_at_rest_unless_something_is_wrong_with_it(hard):
    top = Surface(name="top", polygon=((-0.3, -0.5), (0.3, -0.5), (0.3, 0.5), (-0.3, 0.5)), z=0.75)
    desk = box("desk-0", (0.6, 1.0, 0.75), 2.6, 0.6, surfaces=(top,))
    on = Support(object="desk-0", surface="top")

    def carrying(*ys: float) -> Scene:
        cups = [box(f"cup-{k}", (0.1, 0.1, 0.1), 2.6, y, 0.75, support=on, mount="surface") for k, y in enumerate(ys)]
        relation = Relation(type="next_to", subject="cup-0", target="desk-0", hard=hard)
        return room_with(BED, desk, *cups, relations=(relation,))

    apart, touching = carrying(0.3, 0.9), carrying(0.6, 0.63)
    assert at_rest(apart, check(apart)) is not hard
    assert not at_rest(touching, check(touching))


@pytest.mark.parametrize(("x", "y"), ((0.0, 0.0), (1.0, 1.1)), ids=("half outside", "in the bed"))
def test_a_carrier_without_a_place_says_nothing_of_what_it_carries(x, y):
    top = Surface(name="top", polygon=((-0.3, -0.5), (0.3, -0.5), (0.3, 0.5), (-0.3, 0.5)), z=0.3)
    desk = box("desk-0", (0.6, 1.0, 0.3), x, y, surfaces=(top,))
    on = Support(object="desk-0", surface="top")
    scene = room_with(BED, desk, box("cup-0", (0.1, 0.1, 0.1), x - 0.2, y + 0.3, 0.3, support=on, mount="surface"))
    report = check(scene)
    assert any("cup-0" in v.objects for v in report.violations)
    assert at_rest(scene, report)


def test_edits_that_cannot_be_applied_are_refused():
    with pytest.raises(InputError, match="remove 'sofa-0'"):
        run(room_with(BED), Remove(id="sofa-0"))


# ---- whole rooms ----------------------------------------------------------------------------------------------------


def test_a_room_from_scratch_is_valid_and_depends_on_the_seed_alone():
    parts = [wanted(f"chest-{k}", "usual", (0.5, 0.8 + 0.1 * k, 1.0)) for k in range(3)]
    against = tuple(Relation(type="against_wall", subject=o.id) for o in parts)
    scene = room_with(BED, *parts, relations=against)
    first, again, other = fresh(scene), fresh(scene), fresh(scene, seed=1)
    assert first.report.valid and other.report.valid and check(first.scene).valid
    assert first.scene == again.scene and first.scene != other.scene
    assert first.scene.relations == against and first.scene.ids == scene.ids


def test_the_least_wanted_gives_way_first():
    crowd = [wanted("a", "asked"), wanted("b", "optional"), wanted("c", "usual"), wanted("d", "needed")]
    outcome = fresh(room_with(*crowd))
    assert not outcome.faults
    assert outcome.scene.ids == ("a",) and not outcome.unmet and not outcome.scene.dropped
    gone = [note.split()[0] for note in outcome.notes]
    assert gone == ["b", "c", "d"]


def test_of_many_alike_some_are_kept_and_each_that_was_asked_for_is_accounted_for():
    crowd = [wanted(f"chest-{k}", "asked", (1.2, 1.2, 0.8)) for k in range(7)]
    outcome = fresh(room_with(*crowd))
    kept, dropped = outcome.scene.ids, tuple(d.id for d in outcome.scene.dropped)
    assert kept and dropped and sorted(kept + dropped) == sorted(o.id for o in crowd)
    assert len(outcome.unmet) == len(dropped) and not outcome.faults


LEFT, RIGHT = (Relation(type=t, subject="a", target="b") for t in ("left_of", "right_of"))


@pytest.mark.parametrize(
    ("asked", "soft", "unmet"),
    [
        (["left_of"], "right_of", []),
        (["right_of"], "left_of", []),
        (["left_of", "right_of"], "left_of", ["a left_of b cannot hold here"]),
    ],
)
def test_of_contradicting_relations_the_one_that_was_not_asked_for_becomes_soft(asked, soft, unmet):
    pair = [box(object_id, (0.4, 0.4, 0.5), category="stool", intent=Intent(priority="needed")) for object_id in "ab"]
    relations = tuple(r.model_copy(update={"asked": r.type in asked}) for r in (LEFT, RIGHT))
    outcome = fresh(room_with(*pair, relations=relations))
    assert outcome.report.valid and outcome.scene.ids == ("a", "b")
    assert [r.type for r in outcome.scene.relations if not r.hard] == [soft]
    assert list(outcome.unmet) == unmet


def test_of_relations_of_one_type_the_one_that_fails_becomes_soft():
    posts = [box(f"post-{k}", (0.1, 0.1, 1.0), x, 0.2, fixed=True) for k, x in enumerate((0.2, 2.8))]
    stool = box("stool-0", (0.3, 0.3, 0.4), intent=Intent(priority="needed"))
    near = tuple(Relation(type="near", subject="stool-0", target=p.id, params={"max": 0.3}) for p in posts)
    outcome = fresh(room_with(*posts, stool, relations=near))
    assert outcome.report.valid
    kept = [r.target for r in outcome.scene.relations if r.hard]
    failing = [v.relation.target for v in outcome.report.violations if v.relation is not None]
    assert len(kept) == 1 and {*kept, *failing} == {"post-0", "post-1"}


def test_without_physics_nothing_is_searched():
    blind = QUICK.model_copy(update={"physics": False})
    outcome = run(room_with(BED), Add(object=wanted("chest-0", "usual")), settings=blind)
    assert outcome.scene.object("chest-0").pose == Pose() and outcome.report.collisions + outcome.report.out_of_bounds
    drawn = fresh(room_with(*(wanted(object_id, "usual") for object_id in "abc")), settings=blind)
    assert drawn.scene.ids == ("a", "b", "c") and not drawn.notes and drawn.faults


# ---- what is better --------------------------------------------------------------------------------------------------


def judged(scene: Scene, grade: float) -> Outcome:
    return Outcome(scene, check(scene), Review(grades=dict.fromkeys(CRITERIA, grade)))


def test_what_is_not_as_asked_weighs_more_than_the_grades():
    asked = Fault(criterion="alignment", kind="asked_relation", reason="not so", points=2.0)
    fine, poor = judged(room_with(BED), 8.5), judged(room_with(BED), 9)
    poor = replace(poor, review=poor.review.model_copy(update={"faults": (asked,)}))
    assert fine.key < poor.key


def test_faults_weigh_more_than_what_was_dropped_and_that_more_than_grades():
    good, poor = judged(room_with(BED), 9), judged(room_with(BED), 3)
    gone = Dropped(id="sofa-0", category="sofa", reason="no place")
    without = judged(room_with(BED, dropped=(gone,)), 9)
    broken = judged(room_with(BED, box("chest-0", LARGE, 1.1, 2.1)), 9.5)
    assert sorted([broken, without, poor, good], key=lambda o: o.key) == [good, poor, without, broken]
    assert not without.faults and not without.report.valid
    assert [v.kind for v in broken.faults] == ["collision"]


def test_soft_relations_that_fail_cost_and_are_no_faults():
    facing = Relation(type="near", subject="stool-0", target="bed-0", params={"max": 0.1}, hard=False)
    near, far = (
        judged(room_with(BED, box("stool-0", (0.3, 0.3, 0.4), 2.0, y), relations=(facing,)), 8) for y in (1.1, 0.3)
    )
    assert near.key < far.key and near.key[:2] == far.key[:2] == (0, 0) and not far.faults
    assert [v.kind for v in far.report.violations] == ["soft_relation"]
    unstable = Violation("unstable", ("bed-0",), "bed-0 moves 20 cm in 3 s of physics", 0.2)
    fallen = replace(near, report=replace(near.report, violations=(unstable,)))
    assert fallen.faults == (unstable,) and fallen.key[0] == 1


@pytest.mark.parametrize(
    ("few", "size", "drawn"),
    [
        (8, (0.5, 0.5, 0.5), [32]),  # nearly all are valid
        (33, (0.5, 0.5, 0.5), [32, 32]),  # never enough of them
        (33, (4.0, 0.5, 0.5), [32]),  # too long for the room: none is, and none will be
    ],
)
def test_the_second_half_of_the_layouts_is_drawn_where_few_of_the_first_are_valid(monkeypatch, few, size, drawn):
    counts = []

    def counted(scene: Scene, **given: Any) -> Solution:
        counts.append(given["candidates"])
        return refine(scene, **given)

    monkeypatch.setattr("sceneweaver.agent.executor.refine", counted)
    monkeypatch.setattr("sceneweaver.agent.executor.FEW", few)
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), Settings(device="cpu", generations=0))
    before = room_with(BED, wanted("chest-0", "asked", size))
    executor._free(before, True, 0, 1, lambda scene: scene)
    assert counts == drawn


def test_what_is_wrong_is_mended_before_anything_gives_way():
    chest, shelf = box("chest-0", (0.5, 0.5, 0.5), 1.5, 2.0), box("shelf-0", (0.4, 0.4, 0.5), 0.3, 0.3)
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), QUICK)
    wrong = executor.judged(room_with(BED, chest, shelf))
    mended = executor._mended(wrong, 0, lambda scene: scene)
    assert wrong.faults and mended.report.valid
    assert mended.scene.object("shelf-0").pose.position == pytest.approx(shelf.pose.position, abs=1e-3)
    hopeless = executor.judged(room_with(BED, box("chest-0", (4.0, 4.0, 0.5), 1.5, 2.0)))
    assert executor._mended(hopeless, 0, lambda scene: scene) is hopeless


def test_rows_go_along_into_other_rooms():
    """In a larger room both variants are tried; the draft that goes on has neither, as a search adds them itself."""
    before = room_with(BED, box("desk-0", (0.6, 3.5, 0.7), 1.0, 1.0))
    variants = [(Relation(type="against_wall", subject="desk-0", target=f"wall:{k}"),) for k in (0, 1)]
    larger = Room(type="bedroom", outline=((0, 0), (5, 0), (5, 5), (0, 5)))
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), QUICK)
    draft, best = executor._roomed(before, [larger], executor.judged(before), 0, variants)
    assert best.report.valid and draft.room == best.scene.room == larger
    assert not draft.relations and len(best.scene.relations) == 1


def test_a_deadline_that_has_passed_ends_the_search_with_what_there_is():
    chests = [wanted(f"chest-{k}", "asked") for k in range(30)]
    settings = QUICK.model_copy(update={"attempts": (20, 60)})
    executor = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), settings, deadline=Deadline(0.0))
    before = room_with(BED, *chests)
    outcome = executor.run(before, Proposal(scene=before, fresh=True), 0)
    assert outcome.scene.ids == before.ids and not outcome.report.valid and not outcome.unmet
    assert executor.attempts == 20  # one search, which its time limit cut off; nothing gave way
