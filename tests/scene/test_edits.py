"""Edits: each does what it says, refuses what it cannot do, and has an exact inverse."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, given
from hypothesis import strategies as st
from pydantic import TypeAdapter

from sceneweaver.scene import (
    EDITS,
    PRIORITIES,
    Add,
    Edit,
    Geometry,
    InputError,
    Intent,
    Pose,
    Relate,
    Relation,
    Remove,
    Rename,
    Replace,
    Scene,
    SceneObject,
    SetAttributes,
    SetIntent,
    SetPose,
    SetSize,
    SetSupport,
    Support,
    Unrelate,
    apply,
    apply_all,
    edit_from_json,
    edit_to_json,
    edits_from_json,
    invert,
)
from tests.sizes import examples

SQUARE = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
LAMP = SceneObject(id="lamp-0", category="lamp", size=(0.2, 0.2, 0.5))


@pytest.fixture
def scene(small) -> Scene:
    return Scene.from_json(small)


def there_and_back(scene: Scene, *edits: Any) -> Scene:
    """The scene after the edits, having seen that their inverses lead back, over JSON, too."""
    before = scene.dumps()
    after, back = apply_all(scene, edits)
    assert scene.dumps() == before
    home, _ = apply_all(after, back)
    assert home == scene and Scene.loads(home.dumps()) == scene
    again, _ = apply_all(after, edits_from_json(json.loads(json.dumps([edit_to_json(e) for e in back]))))
    assert again == scene
    assert Scene.loads(after.dumps()) == after  # what an edit gives is a scene that loads
    return after


def refused(scene: Scene, edit: Any, message: str) -> None:
    with pytest.raises(InputError) as caught:
        apply(scene, edit)
    assert message in str(caught.value) and str(caught.value).isprintable()


def test_add(scene):
    assert there_and_back(scene, Add(object=LAMP)).ids[-1] == "lamp-0"
    assert there_and_back(scene, Add(object=LAMP, index=1)).ids[:3] == ("cup-0", "lamp-0", "desk-0")
    refused(scene, Add(object=LAMP, index=9), "add 'lamp-0': index is 9, but there are 5; give 0 to 5, or null")
    twin = LAMP.model_copy(update={"id": "door-0"})
    refused(scene, Add(object=twin), "add 'door-0': objects[5] 'door-0': id is taken by room.doors[0]")
    lost = {"mount": "surface", "support": Support(object="dsk-0", surface="top")}
    refused(scene, Add(object=LAMP.model_copy(update=lost)), "which is no object; did you mean 'desk-0'?")


def test_remove_takes_relations_along(scene):
    after = there_and_back(scene, Remove(id="chair-1"))
    assert "chair-1" not in after.ids and len(after.relations) == 4
    assert not any("chair-1" in (r.subject, *r.targets) for r in after.relations)
    refused(scene, Remove(id="chair-9"), "remove 'chair-9': 'chair-9' is no object of scene 'small'; did you mean")


def test_remove_of_a_carrier_needs_cascade(scene):
    refused(
        scene, Remove(id="desk-0"), "remove 'desk-0': 'tray-0', 'cup-0' would stand on nothing; set cascade to true"
    )
    after = there_and_back(scene, Remove(id="desk-0", cascade=True))
    assert after.ids == ("chair-0", "chair-1") and [r.type for r in after.relations] == ["away_from_door", "in_corner"]
    back = invert(scene, Remove(id="desk-0", cascade=True))
    assert [e.object.id for e in back if isinstance(e, Add)] == ["desk-0", "tray-0", "cup-0"]


def test_replace(scene):
    chair = scene.object("chair-0").model_copy(update={"category": "stool", "asset": "stool-7"})
    assert there_and_back(scene, Replace(object=chair)).object("chair-0").asset == "stool-7"
    refused(scene, Replace(object=LAMP), "replace 'lamp-0': 'lamp-0' is no object")
    bare = scene.object("desk-0").model_copy(update={"surfaces": ()})
    refused(scene, Replace(object=bare), "which is no surface of 'desk-0'")


def test_relate_and_unrelate(scene):
    near = Relation(type="near", subject="chair-0", target="desk-0")
    assert there_and_back(scene, Relate(relation=near)).relations[-1] == near
    assert there_and_back(scene, Relate(relation=near, index=0)).relations[0] == near
    lost = Relation(type="near", subject="chair-0", target="dekc-0")
    refused(scene, Relate(relation=lost), "relate near 'chair-0': relations[9] near 'chair-0': target is 'dekc-0'")
    refused(scene, Relate(relation=near, index=10), "index is 10, but there are 9")

    twice = {"type": "near", "subject": "chair-1", "target": "desk-0"}
    assert there_and_back(scene, Unrelate(**twice)).relations[3].params == {}
    assert there_and_back(scene, Unrelate(**twice, index=4)).relations[2].params == {"max": 2.0}
    refused(
        scene,
        Unrelate(**twice, index=3),
        "unrelate near 'chair-1': there is no such relation with target \"desk-0\" at",
    )
    refused(
        scene,
        Unrelate(type="near", subject="chair-1"),
        "no such relation without target; relations of that subject: near",
    )
    pair = Unrelate(type="between", subject="desk-0", target=["chair-0", "chair-1"])
    assert len(there_and_back(scene, pair).relations) == 8


def test_pose(scene):
    pose = Pose.from_yaw(1, 1, 0, 1)
    assert there_and_back(scene, SetPose(id="desk-0", pose=pose)).object("desk-0").pose == pose
    refused(scene, SetPose(id="dsk-0", pose=pose), "pose 'dsk-0': 'dsk-0' is no object")


def test_size_scales_the_shape(scene):
    desk = there_and_back(scene, SetSize(id="desk-0", size=(2, 1, 1.5))).object("desk-0")
    assert desk.parts[0].polygon == ((-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)) and desk.parts[0].z == (1.4, 1.5)
    assert desk.zones[0].polygon[1] == (2, -0.5) and desk.zones[0].z == (0, 3.6)
    assert desk.surfaces[0].z == 1.5 and desk.surfaces[0].headroom == 3.0
    assert there_and_back(scene, SetSize(id="chair-0", size=(1, 1, 1))).object("chair-0").parts is None
    there_and_back(scene, SetSize(id="desk-0", size=(0.3, 0.7, 0.1)), SetSize(id="desk-0", size=(1 / 3, 2, 3)))


def test_size_with_a_shape_of_its_own(scene):
    surfaces = [{"name": "top", "polygon": SQUARE, "z": 0.9}]
    edit = SetSize(id="desk-0", size=(1, 1, 0.9), geometry=Geometry(surfaces=surfaces))
    desk = there_and_back(scene, edit).object("desk-0")
    assert desk.parts is None and desk.zones == () and desk.surfaces[0].z == 0.9
    refused(
        scene, SetSize(id="desk-0", size=(1, 1, 1), geometry=Geometry()), "no surface of 'desk-0'; its surfaces: none"
    )
    refused(scene, SetSize(id="desk-0", size=(1e-6, 1, 1)), "size 'desk-0': object 'desk-0': ")


def test_support(scene):
    on_desk = Support(object="desk-0", surface="top")
    after = there_and_back(scene, SetSupport(id="chair-0", support=on_desk), SetSupport(id="cup-0"))
    assert (after.object("chair-0").mount, after.object("cup-0").mount) == ("surface", "floor")
    assert there_and_back(scene, SetSupport(id="cup-0", mount="wall")).object("cup-0").support is None
    refused(scene, SetSupport(id="cup-0", mount="surface"), 'support is missing, but mount is "surface"')
    refused(scene, SetSupport(id="cup-0", support=on_desk, mount="wall"), 'support is given, but mount is "wall"')
    on_tray = Support(object="tray-0", surface="top")
    refused(scene, SetSupport(id="desk-0", support=on_tray), "goes round in a circle")
    refused(scene, SetSupport(id="cup-0", support=Support(object="desk-0", surface="tpo")), 'did you mean "top"?')


def test_rename(scene):
    after = there_and_back(scene, Rename(id="desk-0", new_id="table"))
    assert after.object("tray-0").support.object == "table" and after.relations[0].subject == "table"
    after = there_and_back(scene, Rename(id="chair-0", new_id="stool"))
    assert after.relations[3].target == ("stool", "chair-1")
    there_and_back(scene, Rename(id="chair-0", new_id="chair-0"))
    refused(scene, Rename(id="chair-0", new_id="window-0"), "rename 'chair-0': objects[3] 'window-0': id is taken")
    refused(scene, Rename(id="window-0", new_id="w"), "rename 'window-0': 'window-0' is no object")
    with pytest.raises(InputError, match='rename: new_id is "wall:0"'):
        Rename(id="chair-0", new_id="wall:0")


def test_intent(scene):
    hung = Intent(priority="needed", program_item="desk", mounting_height=(0.5, 0.5), keep_clear=True)
    assert there_and_back(scene, SetIntent(id="desk-0", intent=hung)).object("desk-0").intent == hung
    assert there_and_back(scene, SetIntent(id="chair-0", intent=hung)).object("chair-0").intent == hung
    assert there_and_back(scene, SetIntent(id="desk-0", intent=Intent())).object("desk-0").intent == Intent()
    refused(scene, SetIntent(id="dsk-0", intent=hung), "intent 'dsk-0': 'dsk-0' is no object of scene 'small'; did")
    with pytest.raises(
        InputError, match='intent: intent.priority is "high"; give one of: optional, usual, needed, asked'
    ):
        edit_from_json({"op": "intent", "id": "desk-0", "intent": {"priority": "high"}})


def test_attributes(scene):
    edit = SetAttributes(id="desk-0", set={"color": "red", "n": 1}, unset=("style", "nothing"))
    assert there_and_back(scene, edit).object("desk-0").attributes == {"color": "red", "n": 1}
    refused(scene, SetAttributes(id="desk-0", set={"a": 1}, unset=("a",)), '"a" is both set and unset')
    with pytest.raises(InputError, match="attributes: set.x is NaN"):
        SetAttributes(id="desk-0", set={"x": float("nan")})


def test_apply_all_says_which_edit_and_changes_nothing(scene):
    with pytest.raises(InputError, match=r"^edits\[1\] remove 'nothing': 'nothing' is no object"):
        apply_all(scene, [Remove(id="chair-0"), Remove(id="nothing")])
    assert "chair-0" in scene.ids


def test_invert_of_what_is_not_there(scene):
    for edit in (
        SetPose(id="x", pose=Pose()),
        Remove(id="x"),
        Rename(id="x", new_id="y"),
        SetSize(id="x", size=(1, 1, 1)),
    ):
        with pytest.raises(InputError, match="'x' is no object"):
            invert(scene, edit)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (5, r'edit is 5; give an object {"op": ...}'),
        ({}, 'edit: "op" is missing; give one of: add, remove'),
        ({"op": "ad"}, 'edit: op is "ad"; did you mean "add"?'),
        ({"op": ["add"]}, "edit: op is a list"),
        ({"op": "remove"}, 'remove: "id" is missing; add it'),
        ({"op": "remove", "id": "a", "cascde": True}, 'remove: unknown key "cascde"; did you mean "cascade"?'),
        ({"op": "remove", "id": "a", "cascade": 1}, "remove: cascade is 1; give true or false"),
        (
            {"op": "add", "object": {"id": "a", "category": "b", "size": [1, 0, 1]}},
            "add: object.size[1] is 0; sizes are",
        ),
        (
            {"op": "relate", "relation": {"type": "naer", "subject": "a"}},
            'relate: relation.type "naer" is unknown; did you',
        ),
        ({"op": "pose", "id": "a", "pose": {"position": [0, 0]}}, "pose: pose.position has 2 entries; give 3"),
    ],
)
def test_bad_edits_in_json(data, message):
    with pytest.raises(InputError) as caught:
        edit_from_json(data)
    assert message in str(caught.value)
    with pytest.raises(InputError, match=r"^edits\[1\] "):
        edits_from_json([{"op": "remove", "id": "a"}, data])
    with pytest.raises(InputError, match="give a list of edits"):
        edits_from_json({})


def test_the_union_is_discriminated_by_op():
    adapter = TypeAdapter(Edit)
    assert adapter.validate_python({"op": "remove", "id": "a"}) == Remove(id="a")
    assert {*adapter.json_schema()["discriminator"]["mapping"]} == {*EDITS}


# Random edits: ids and relations are drawn from those of the scene, so that most of them apply.

numbers = st.floats(-3, 3, allow_nan=False).map(lambda x: round(x, 3))
sizes = st.tuples(*[st.floats(0.01, 5)] * 3)
poses = st.builds(Pose.from_yaw, numbers, numbers, numbers, numbers)
intents = st.builds(
    Intent,
    priority=st.sampled_from([None, *PRIORITIES]),
    request=st.sampled_from([None, "x"]),
    mounting_height=st.none() | st.tuples(numbers, numbers).map(sorted),
    keep_clear=st.booleans(),
)
values = st.recursive(st.none() | st.integers() | st.text(max_size=3), lambda v: st.lists(v, max_size=2), max_leaves=4)
surfaces = st.sampled_from([(), ({"name": "top", "polygon": SQUARE, "z": 0.5},)])


@st.composite
def edits(draw, scene: Scene):
    object_id = draw(st.sampled_from(scene.ids))
    other = draw(st.sampled_from(scene.ids))
    fresh = draw(st.sampled_from(["new-0", "new-1", "new-2", "chair-0"]))
    index = draw(st.none() | st.integers(0, 5))
    supports = [Support(object=o.id, surface=s.name) for o in scene.objects for s in o.surfaces]
    support = draw(st.sampled_from([None, *supports]))
    op = draw(st.sampled_from(sorted(EDITS)))
    if op in ("add", "replace"):
        obj = SceneObject(
            id=fresh if op == "add" else object_id,
            category="thing",
            size=draw(sizes),
            pose=draw(poses),
            mount="surface" if support else "floor",
            support=support,
            surfaces=draw(surfaces),
        )
        return Add(object=obj, index=index) if op == "add" else Replace(object=obj)
    if op == "remove":
        return Remove(id=object_id, cascade=draw(st.booleans()))
    if op == "relate":
        target = draw(
            st.sampled_from([("near", other), ("in_corner", None), ("against_wall", "wall:2"), ("around", other)])
        )
        assume(target[1] != object_id)
        return Relate(relation=Relation(type=target[0], subject=object_id, target=target[1]), index=index)
    if op == "unrelate":
        assume(scene.relations)
        i = draw(st.integers(0, len(scene.relations) - 1))
        r = scene.relations[i]
        return Unrelate(type=r.type, subject=r.subject, target=r.target, index=draw(st.sampled_from([None, i])))
    if op == "pose":
        return SetPose(id=object_id, pose=draw(poses))
    if op == "size":
        geometry = draw(st.none() | st.builds(Geometry, surfaces=surfaces))
        return SetSize(id=object_id, size=draw(sizes), geometry=geometry)
    if op == "support":
        return SetSupport(id=object_id, support=support)
    if op == "rename":
        return Rename(id=object_id, new_id=fresh)
    if op == "intent":
        return SetIntent(id=object_id, intent=draw(intents))
    keys = st.sampled_from(["color", "style", "a", "b"])
    put = draw(st.dictionaries(keys, values, max_size=2))
    return SetAttributes(
        id=object_id, set=put, unset=tuple(k for k in draw(st.lists(keys, max_size=2)) if k not in put)
    )


@examples(40, 120, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(data=st.data())
def test_any_edits_have_an_exact_inverse(small, data):
    scene = start = Scene.from_json(small)
    done, back = [], []
    for _ in range(data.draw(st.integers(1, 6))):
        if not scene.ids:
            break
        edit = data.draw(edits(scene))
        try:
            after = apply(scene, edit)
        except InputError as error:
            assert str(error).isprintable()
            continue
        assert edit_from_json(json.loads(json.dumps(edit_to_json(edit)))) == edit
        home, _ = apply_all(after, invert(scene, edit))
        assert home == scene
        assert Scene.loads(after.dumps()) == after
        back[:0] = invert(scene, edit)
        done.append(edit)
        scene = after
    assert apply_all(start, done) == (scene, back)
    assert apply_all(scene, back)[0] == start
