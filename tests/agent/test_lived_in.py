"""The last touch: bare furniture gets small things and a room traces of life, without breaking what was right."""

from __future__ import annotations

import pytest

from sceneweaver.agent.executor import Executor
from sceneweaver.agent.lived_in import DONE, lived_in
from sceneweaver.agent.settings import Settings
from sceneweaver.assets import Library, make
from sceneweaver.knowledge import room_types
from sceneweaver.language import read_request
from sceneweaver.rules.design import limit
from sceneweaver.scene import Door, InputError, Pose, Relation, Room, Scene
from sceneweaver.tools.add_clutter import AddClutter
from sceneweaver.tools.base import Context
from sceneweaver.verify import check

LIBRARY = Library()


def bedroom() -> Scene:
    """A bed, a wardrobe, and a desk with its chair, at the walls."""
    bed, desk, chair = make("single_bed", 1), make("desk", 2), make("chair", 2)
    wardrobe = make("wardrobe", 3)
    objects = [
        bed.object("single_bed-0", pose=Pose.from_yaw(bed.size[0] / 2 + 0.02, 2.0, 0.0, 0.0)),
        desk.object("desk-0", pose=Pose.from_yaw(3.0, 4.0 - desk.size[0] / 2 - 0.02, 0.0, -1.5707963)),
        chair.object("chair-0", pose=Pose.from_yaw(3.0, 4.0 - desk.size[0] + 0.1 - chair.size[0] / 2, 0.0, 1.5707963)),
        wardrobe.object("wardrobe-0", pose=Pose.from_yaw(5.0 - wardrobe.size[0] / 2 - 0.02, 1.2, 0.0, 3.1415926)),
    ]
    ties = [Relation(type="front_to_front", subject="chair-0", target="desk-0")]
    return Scene(
        id="bedroom",
        prompt="a bedroom",
        room=Room(type="bedroom", outline=((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), height=2.6),
        objects=tuple(objects),
        relations=tuple(ties),
    )


def touched(scene: Scene, clutter: float, prompt: str = "a bedroom"):
    brief, kind = read_request(prompt), room_types()["bedroom"]
    executor = Executor(kind, brief, Settings())
    outcome = executor.judged(scene)
    context = Context(brief, kind, scene, LIBRARY, seed=3, clutter=clutter)
    return outcome, lived_in(outcome, executor, context)


@pytest.mark.parametrize("clutter", [0.0, 0.4, 1.0])
def test_the_room_stays_valid_and_is_touched_once(clutter):
    before, after = touched(bedroom(), clutter)
    assert before.report.valid and after.report.valid and check(after.scene).valid
    assert len(after.scene.objects) > len(before.scene.objects) + 8
    assert after.scene.provenance[DONE] == clutter
    again = touched(after.scene, clutter)[1]
    assert again.scene == after.scene


def test_a_show_room_has_nothing_on_its_floor_and_chairs_pushed_in():
    tidy, messy = (touched(bedroom(), c)[1].scene for c in (0.0, 1.0))
    own = set(bedroom().ids)
    assert not [o for o in tidy.objects if o.mount == "floor" and o.id not in own]
    assert tidy.object("chair-0").pose == bedroom().object("chair-0").pose
    left = [o for o in messy.objects if o.mount == "floor" and o.id not in own]
    assert len(left) >= 2 and all(o.intent.priority == "optional" for o in left)


def test_shelves_that_are_hung_are_filled(monkeypatch):
    monkeypatch.setattr("sceneweaver.generate.wall_objects.wall_things", lambda room: {"wall_shelf": 1.0})
    after = touched(bedroom(), 0.0)[1].scene
    shelves = [o.id for o in after.objects if o.category == "wall_shelf"]
    carrying = {o.support.object for o in after.objects if o.support is not None}
    assert shelves and set(shelves) <= carrying


def test_what_lowers_the_grade_is_taken_back_alone(monkeypatch):
    """What is out of place in a bedroom goes; the other walls keep what was hung."""
    things = {"picture": 1.0, "range_hood": 1.0}
    monkeypatch.setattr("sceneweaver.generate.wall_objects.wall_things", lambda room: things)
    before, after = touched(bedroom(), 0.0)
    hung = {o.category for o in after.scene.objects if o.mount == "wall"}
    assert hung == {"picture"}
    assert after.review.total >= before.review.total


@pytest.mark.parametrize("prompt", ["a minimalist bedroom", "a bedroom with only a bed and a desk"])
def test_who_wants_little_gets_no_more(prompt):
    before, after = touched(bedroom(), 1.0, prompt)
    assert after.scene == before.scene


def test_what_is_named_is_not_strewn_about():
    brief, kind = read_request("a bedroom with one pair of slippers"), room_types()["bedroom"]
    for seed in range(6):
        edits = AddClutter().propose(Context(brief, kind, bedroom(), LIBRARY, seed, clutter=1.0)).edits
        assert not [e for e in edits if e.op == "add" and e.object.category == "slippers"]


def test_nothing_is_strewn_before_a_door_or_at_its_frame():
    """A door half a metre beside the desk, where bags are put down."""
    brief, kind, scene = read_request("a bedroom"), room_types()["bedroom"], bedroom()
    desk, gap, strewn = scene.object("desk-0"), limit("door_frame", "gap"), 0
    right = desk.pose.position[0] - desk.size[1] / 2 - 0.5  # of the frame, in the wall that runs from x = 5 to 0
    door = Door(id="door-0", wall=2, offset=5.0 - right, width=0.9, height=2.0)
    scene = scene.model_copy(update={"room": scene.room.model_copy(update={"doors": (door,)})})
    for seed in range(16):
        edits = AddClutter().propose(Context(brief, kind, scene, LIBRARY, seed, clutter=1.0)).edits
        for thing in [e.object for e in edits if e.op == "add"]:
            strewn += 1
            x, y, _ = thing.pose.position
            half = min(thing.size[:2]) / 2
            assert y < 4.0 - 0.9 or not right - 0.9 - gap - half < x < right + gap + half, thing.id
    assert strewn > 16


def test_clutter_out_of_range_is_refused():
    brief, kind = read_request("a bedroom"), room_types()["bedroom"]
    with pytest.raises(InputError, match="clutter"):
        AddClutter().propose(Context(brief, kind, bedroom(), LIBRARY, 1, inputs={"clutter": 2}))
    with pytest.raises(InputError, match="clutter"):
        Settings(clutter=1.5)
