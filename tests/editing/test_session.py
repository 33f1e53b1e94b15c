"""Live editing: valid after every edit, nothing moves that need not, and every edit can be taken back."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from benchmarks import rooms
from benchmarks.changes import CHANGES, involved
from sceneweaver.editing.session import LEAST
from sceneweaver.scene import Pose, Relate, Relation, Rename, SetSize
from tests.layout.made import scene, thing
from tests.verify.agreement import oracle


@pytest.fixture
def session() -> sw.EditSession:
    return sw.EditSession(sw.Scene.example("bedroom"), device="cpu")


def poses(scene: sw.Scene) -> dict[str, sw.Pose]:
    return {o.id: o.pose for o in scene.objects}


@pytest.mark.parametrize("name", ["bedroom-tight", "studio-U", "office-dense", "gym-30"])
def test_edits_of_a_room(name):
    witness = rooms.load(name)
    session = sw.EditSession(witness, device="cpu")
    for k, (edit, change) in enumerate(CHANGES.items()):
        changed = change(session.scene, np.random.default_rng([7, k]))
        if changed is None:
            continue
        scene, edited = changed
        result = session.update(scene, [edited])
        assert result.valid and sw.check(result.scene).valid, edit
        assert oracle.check(result.scene.to_json())["valid"], edit
        before, after = poses(scene), poses(result.scene)
        still = set(scene.ids) - involved(scene, edited)
        assert all(after[i] is before[i] for i in still) or result.freed == "all", edit
        assert {m.id for m in result.moves} == {i for i in after if after[i] != before[i]}
        assert session.undo().scene is witness


def test_what_is_in_order_stays_where_it_was_put(session):
    chair = session.scene.object("chair").pose.position
    result = session.move("chair", by=(0.0, 0.05))
    assert (result.valid, result.freed, result.moves) == (True, "nothing", ())
    assert repr(result).startswith("EditResult(valid, 0 moved, ")
    assert result.scene.object("chair").pose.position == pytest.approx((chair[0], chair[1] + 0.05, chair[2]))


def two_boxes() -> sw.EditSession:
    """A large box in the middle of a room, and a small one just before it."""
    large = sw.SceneObject(id="large", category="box", size=(1.0, 2.0, 0.7), pose=sw.Pose.from_yaw(2.5, 2.0, 0.0, 0.0))
    small = sw.SceneObject(id="small", category="box", size=(0.4, 0.4, 0.4), pose=sw.Pose.from_yaw(1.75, 2.0, 0.0, 0.0))
    return sw.EditSession(sw.build(sw.Room.rectangle(4, 4)).scene().add(large).add(small), device="cpu")


def test_a_little_push_moves_what_was_edited_alone():
    result = two_boxes().move("small", by=(0.1, 0.0))
    assert result.valid and result.freed == "edited" and [m.id for m in result.moves] == ["small"]
    assert result.moves[0].distance == pytest.approx(0.05, abs=5e-3)


def test_what_is_in_the_way_makes_way_for_what_was_dragged():
    """A push back by more than half of the way would undo the edit."""
    session = two_boxes()
    session.move("small", by=(LEAST / 4, 0.0))
    result = session.move("small", by=(0.25, 0.0))
    assert result.valid and result.freed == "named" and [m.id for m in result.moves] == ["large"]


def test_what_stands_on_it_goes_along(session):
    lamp = next(o for o in session.scene.objects if o.support)
    carrier = lamp.support.object
    result = session.resize(carrier, height=session.scene.object(carrier).size[2] + 0.05)
    step = result.scene.object(lamp.id).pose.position[2] - lamp.pose.position[2]
    assert result.valid and step == pytest.approx(0.05, abs=0.02)


def test_add_by_words_remove_and_undo(session):
    given = session.scene
    added = session.add("armchair", at=(2.2, 1.9), name="reading chair")
    assert added.valid and added.scene.ids[-1] == "reading chair"
    assert all(added.scene.object(o.id) is o for o in given.objects)
    lamp = session.add("lamp", on="dresser")
    assert lamp.valid and lamp.scene.objects[-1].support.object == "dresser"
    assert session.remove("reading chair").valid and "reading chair" not in session.scene.ids
    for _ in range(3):
        session.undo()
    assert session.scene is given
    with pytest.raises(sw.InputError, match="there is no edit to take back"):
        session.undo()


def test_a_new_thing_finds_its_place_anywhere(session):
    """There is no room for it where it begins, nor near."""
    given = session.scene
    result = session.add("wardrobe", against="wall", width=0.8)
    assert result.valid and all(result.scene.object(o.id).pose == o.pose for o in given.objects)


def test_relate_moves_the_subject(session):
    given = session.scene
    result = session.relate("plant", "near", "armchair", max=0.3)
    assert result.valid and {m.id for m in result.moves} <= {"plant"}
    assert session.unrelate("plant", "near", "armchair").scene.relations == given.relations


def test_typed_edits_are_one_step(session):
    given = session.scene
    size = given.object("armchair").size
    near = Relation(type="near", subject="plant", target="armchair", params={"max": 1.5})
    result = session.edit(SetSize(id="armchair", size=(size[0], size[1], 0.9)), Relate(relation=near))
    assert result.valid and result.scene.relations[-1] == near
    assert session.undo().scene is given


def test_what_cannot_be_made_valid_is_told():
    session = sw.EditSession(scene([thing("bed", pose=Pose.from_yaw(2.5, 2.0, 0.0, 0.0))], []), device="cpu")
    result = session.resize("bed", width=12.0)
    assert not result.valid and result.report.violations and result.scene.object("bed").size[1] == 12.0
    assert session.undo().valid


def test_fixed_things_stay(session):
    held = {"bed", "wardrobe"}
    objects = tuple(o.model_copy(update={"fixed": o.id in held}) for o in session.scene.objects)
    session.update(session.scene.model_copy(update={"objects": objects}))
    for _ in range(2):
        result = session.move("nightstand-left", by=(0.2, 0.2), turn=20)
        assert not held & {m.id for m in result.moves}


def test_a_failing_edit_changes_nothing(session):
    given = session.scene
    for call in (
        lambda: session.move("chiar", by=(1, 0)),
        lambda: session.add("desk", facing="nobody"),
        lambda: session.relate("chair", "nera", "bed"),
        lambda: session.update(given, ["nobody"]),
        lambda: session.update("bedroom"),
        lambda: session.resize("chair", width=-1.0),
        lambda: session.move(3, by=(1, 0)),
    ):
        with pytest.raises(sw.InputError) as error:
            call()
        assert "\n" not in str(error.value) and session.scene is given
    with pytest.raises(sw.InputError):
        session.undo()


def test_the_same_edits_give_the_same_scene():
    found = []
    for _ in range(2):
        session = sw.EditSession(rooms.load("bedroom-tight"), device="cpu", seed=3)
        rng = np.random.default_rng(0)
        for change in CHANGES.values():
            scene, edited = change(session.scene, rng)
            session.update(scene, [edited])
            if "new-object" in scene.ids:
                session.edit(Rename(id="new-object", new_id=f"plant-{len(scene.ids)}"))
        found.append(session.scene)
    assert found[0] == found[1]


def test_no_scene():
    with pytest.raises(sw.InputError, match="scene: str is not a Scene"):
        sw.EditSession("bedroom")
