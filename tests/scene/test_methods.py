"""Edits as methods of a scene: what goes along, and that the scene they are called on stays as it is."""

from __future__ import annotations

import math

import pytest

from sceneweaver.scene import InputError, Pose, Relate, Relation, Scene, SceneObject


@pytest.fixture
def scene() -> Scene:
    return Scene.example("study")


def carried(scene: Scene, object_id: str) -> list[SceneObject]:
    return [o for o in scene.objects if o.support and o.support.object == object_id]


def test_what_stands_on_it_moves_along(scene):
    before, after = scene, scene.move("desk", by=(0.2, -0.1))
    for old in [before.object("desk"), *carried(before, "desk")]:
        new = after.object(old.id).pose
        step = [b - a for a, b in zip(old.pose.position, new.position, strict=True)]
        assert step == pytest.approx([0.2, -0.1, 0.0]) and new.yaw == pytest.approx(old.pose.yaw)
    still = {o.id for o in before.objects} - {"desk", *(o.id for o in carried(before, "desk"))}
    assert all(after.object(name) is before.object(name) for name in still)
    assert carried(before, "desk"), "something stands on it"


def test_it_turns_about_its_own_middle(scene):
    after = scene.move("desk", turn=90)
    desk, lamp = scene.object("desk").pose, carried(scene, "desk")[0]
    assert after.object("desk").pose.position == desk.position
    assert after.object("desk").pose.yaw == pytest.approx(math.remainder(desk.yaw + math.pi / 2, 2 * math.pi))
    u, v = lamp.pose.position[0] - desk.position[0], lamp.pose.position[1] - desk.position[1]
    x, y, _ = after.object(lamp.id).pose.position
    assert (x - desk.position[0], y - desk.position[1]) == pytest.approx((-v, u))


def test_to_a_point_or_a_pose(scene):
    assert scene.move("desk", to=(1, 1)).object("desk").pose.position[:2] == (1, 1)
    pose = Pose.from_yaw(1.0, 2.0, 0.0, 0.5)
    assert scene.move("desk", to=pose).object("desk").pose == pose


def test_a_higher_desk_lifts_what_is_on_it(scene):
    desk = scene.object("desk")
    after = scene.resize("desk", height=1.1 * desk.size[2], width=1.5)
    assert after.object("desk").size == pytest.approx((desk.size[0], 1.5, 1.1 * desk.size[2]))
    top = {s.name: s.z for s in after.object("desk").surfaces}
    for thing in carried(after, "desk"):
        assert thing.pose.position[2] == pytest.approx(top[thing.support.surface], abs=1e-6)


def test_add_remove_rename_relate(scene):
    box = SceneObject(id="box", category="box", size=(0.3, 0.3, 0.3))
    after = scene.add(box).relate("box", "near", "desk", hard=False, max=0.5).rename("box", "crate")
    relation = after.relations[-1]
    assert (relation.subject, relation.target, relation.hard, relation.params) == ("crate", "desk", False, {"max": 0.5})
    assert after.unrelate("crate", "near", "desk").remove("crate") == scene
    assert after.remove("desk", cascade=True).index("crate") < len(scene.objects)
    with pytest.raises(InputError, match="set cascade to true"):
        scene.remove("desk")


def test_typed_edits(scene):
    relation = Relation(type="near", subject="desk", target="armchair")
    assert scene.edit(Relate(relation=relation)).relations[-1] == relation
    assert scene.edit() is scene


WRONG = [
    (lambda s: s.move("dsk", by=(1, 0)), "did you mean 'desk'?"),
    (lambda s: s.move("desk", by=(1, 0), to=(1, 0)), "both to and by are given"),
    (lambda s: s.move("desk", by=(1,)), "by is"),
    (lambda s: s.move("desk", to="here"), "to is"),
    (lambda s: s.move("desk", to=(1, math.nan)), "to is"),
    (lambda s: s.move("desk", by=(1e300, 0)), "by is a list; give two or three numbers from -1e+06 to 1e+06"),
    (lambda s: s.move("desk", turn=1e300), "turn is 1e+300; give degrees from -3600 to 3600"),
    (lambda s: s.move("desk", turn=math.nan), "turn is NaN; give degrees"),
    (lambda s: s.move("desk", turn=-3601), "turn is -3601; give degrees"),
    (lambda s: s.relate("chair", "near", "desk", max=1e300), "max is 1e+300; numbers are at most"),
    (lambda s: s.move("desk", turn="left"), "turn is"),
    (lambda s: s.move(None, by=(1, 0)), "null is no object; give its id"),
    (lambda s: s.resize("desk", width=0), "size[1]"),
    (lambda s: s.relate("desk", "nere", "armchair"), 'did you mean "near"?'),
    (lambda s: s.unrelate("desk", "near", "armchair"), "there is no such relation"),
]


@pytest.mark.parametrize("call, text", WRONG, ids=[text for _, text in WRONG])
def test_errors_are_one_line(scene, call, text):
    with pytest.raises(InputError) as error:
        call(scene)
    assert text in str(error.value) and "\n" not in str(error.value)
