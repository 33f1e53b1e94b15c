"""What gives way, from what the judge says of one layout."""

from __future__ import annotations

from dataclasses import replace

from sceneweaver.agent.relaxation import REASON, cleared, eased, left_out, relaxed, still_true
from sceneweaver.scene import Intent, Pose, Priority, Relation, Room, Scene, SceneObject, Support, Surface
from sceneweaver.verify import Report, check

TOP = Surface(name="top", polygon=((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)), z=0.5)


def cube(name: str, priority: Priority | None = None, at: float = 2.0, **more) -> SceneObject:
    """A box of 1 x 1 x 0.5 m at (at, 2) m that things can stand on."""
    pose, intent = Pose.from_yaw(at, 2.0, 0.0, 0.0), Intent(priority=priority)
    more = {"category": "chest", "surfaces": (TOP,), **more}
    return SceneObject(id=name, size=(1.0, 1.0, 0.5), pose=pose, intent=intent, **more)


def room(*objects: SceneObject, relations: tuple[Relation, ...] = ()) -> Scene:
    return Scene(id="s", room=Room(outline=((0, 0), (9, 0), (9, 4), (0, 4))), objects=objects, relations=relations)


def relax(scene: Scene, at_once: int = 1):
    return relaxed(scene, [v for v in check(scene).violations if v.hard], at_once)


def test_a_valid_scene_has_nothing_to_give_up():
    assert relax(room(cube("a", "optional"))) is None


def test_only_what_is_in_trouble_gives_way_and_what_stands_on_it_goes_along():
    cup = SceneObject(
        id="cup",
        category="cup",
        size=(0.1, 0.1, 0.1),
        pose=Pose.from_yaw(2.4, 2.0, 0.5, 0.0),
        mount="surface",
        support=Support(object="b", surface="top"),
    )
    found = relax(room(cube("a", "needed", 2.1), cube("b", "usual", 2.9), cup, cube("c", "optional", 6.0)))
    assert found is not None and found.scene.ids == ("a", "c")
    assert found.notes == (f"b was left out: {REASON}",) and not found.unmet and not found.scene.dropped


def test_what_carries_something_asked_for_is_not_given_up_before_what_carries_nothing():
    tv = SceneObject(
        id="tv",
        category="tv",
        size=(0.1, 0.8, 0.5),
        pose=Pose.from_yaw(2.9, 2.0, 0.5, 0.0),
        mount="surface",
        support=Support(object="stand", surface="top"),
        intent=Intent(priority="asked"),
    )
    found = relax(room(cube("table", "usual", 2.1), cube("stand", "optional", 2.9), tv))
    assert found is not None and found.scene.ids == ("stand", "tv") and not found.unmet


def test_what_is_there_for_a_thing_goes_with_it_unless_it_was_asked_for():
    objects = (cube("a", "needed", 2.1), cube("desk", "optional", 2.9), cube("stool", "usual", 6.0))
    tied = Relation(type="front_to_front", subject="stool", target="desk")
    near = Relation(type="near", subject="stool", target="desk")
    kept = ("a", "stool")
    for relation, priority, left in ((tied, "usual", ("a",)), (tied, "asked", kept), (near, "usual", kept)):
        stool = objects[2].model_copy(update={"intent": Intent(priority=priority)})
        scene = room(*objects[:2], stool, relations=(relation,))
        found = relaxed(scene, [v for v in check(scene).violations if v.kind == "collision"])
        assert found is not None and found.scene.ids == left


def test_what_is_in_most_trouble_goes_first_and_several_go_when_it_takes_long():
    row = [cube(name, "usual", 2.0 + 0.6 * k) for k, name in enumerate("abcd")]
    for at_once, left in ((1, ("a", "c", "d")), (2, ("a", "d")), (9, ())):
        found = relax(room(*row), at_once)
        assert found is not None and found.scene.ids == left and len(found.notes) == 4 - len(left)


def test_a_relation_gives_way_before_what_is_needed_and_of_two_the_one_that_nobody_asked_for():
    pair = (cube("a", "needed"), cube("b", "needed", 7.0))
    asked, usual = (
        Relation(type=t, subject="a", target="b", params={"max": 0.5}, asked=t == "near")
        for t in ("near", "in_front_of")
    )
    first = relax(room(*pair, relations=(asked, usual)))
    assert first is not None and [r.hard for r in first.scene.relations] == [True, False] and not first.unmet
    second = relax(first.scene)
    assert second is not None and not any(r.hard for r in second.scene.relations)
    assert second.unmet == ("a near b cannot hold here",) and second.scene.ids == ("a", "b")
    assert relax(second.scene) is None


def test_relations_of_one_type_are_told_apart():
    near = tuple(Relation(type="near", subject="a", target=t, params={"max": 0.5}) for t in ("b", "c"))
    found = relax(room(cube("a", "needed"), cube("b", at=3.2), cube("c", at=7.0), relations=near))
    assert found is not None and [r.hard for r in found.scene.relations] == [True, False]


def test_at_last_what_was_asked_for_is_dropped_with_the_reason():
    found = relax(room(cube("a", "asked"), cube("b", "asked", 2.5, category="desk")))
    assert found is not None and found.scene.ids == ("b",)
    (dropped,) = found.scene.dropped
    assert (dropped.id, dropped.category, dropped.reason) == ("a", "chest", REASON)
    assert found.unmet == (f"a: {REASON}",) and not found.notes


def test_what_was_asked_for_leaves_its_usual_place_before_a_place_that_was_asked_for():
    usual = [Relation(type="near", subject=a, target=b, params={"max": 5.0}) for a, b in ("ab", "ba")]
    asked = Relation(type="near", subject="a", target="b", params={"max": 4.0}, asked=True)
    small = cube("a", "asked").model_copy(update={"size": (0.9, 0.9, 1.0)})
    before = room(small, cube("b", "asked", 2.5), relations=(*usual, asked))
    found, both = relax(before), relax(before, 2)
    assert found is not None and both is not None and found.late and both.late and not found.unmet
    assert [r.hard for r in found.scene.relations] == [False, True, True]
    assert [r.hard for r in both.scene.relations] == [False, False, True]
    then = relax(both.scene)
    assert then is not None and then.unmet and not then.late


def test_before_what_was_asked_for_goes_all_its_relations_become_soft():
    tie = Relation(type="near", subject="a", target="b", params={"max": 0.5}, asked=True)
    found = relax(room(cube("a", "asked"), cube("b", "asked", 2.5), relations=(tie,)))
    assert found is not None and found.scene.ids == ("a", "b") and not found.scene.relations[0].hard
    then = relax(found.scene)
    assert then is not None and len(then.scene.ids) == 1


def test_a_layout_of_a_scene_that_asked_for_more_is_one_of_what_is_left():
    ties = tuple(Relation(type="near", subject="a", target=t, params={"max": 0.5}) for t in ("b", "c"))
    before = room(cube("a", "needed"), cube("b", "usual", 2.5), cube("c", "usual", 7.0), relations=ties)
    after = relax(before)
    assert after is not None and after.scene.ids == ("a", "c")
    soft = after.scene.model_copy(update={"relations": (ties[1].model_copy(update={"hard": False}),)})
    left = eased(before.replace_poses({"c": Pose.from_yaw(8.0, 2.0, 0.0, 0.0)}), soft)
    assert left.ids == ("a", "c") and left.object("c").pose.position[0] == 8.0
    assert [r.hard for r in left.relations] == [False] and check(left).valid


def test_of_many_alike_several_go_at_once_but_none_that_is_wanted_more():
    many = [cube(f"n{k}", "needed", 2.0 + 0.01 * k) for k in range(11)]
    found = relax(room(cube("asked", "asked", 2.3), *many))
    assert found is not None and len(found.scene.ids) == 12 - 3 and "asked" in found.scene.ids


def test_what_is_wrong_is_taken_out_of_a_layout_as_it_stands():
    far = Relation(type="near", subject="a", target="d", params={"max": 0.5}, asked=True)
    chests = [cube("b", "optional", 2.6), cube("c", "asked", 3.2), cube("d", "needed", 7.0), cube("out", "asked", 9.0)]
    scene = room(cube("a", "needed"), *chests, relations=(far,))
    lighter, report = cleared(scene, check(scene))
    assert lighter.scene.ids == ("a", "c", "d")  # b was in the way of both, and c alone of nothing
    assert [v.kind for v in report.violations if v.hard] == ["dropped"] and report == check_again(lighter.scene, report)
    assert {o.id: o.pose for o in lighter.scene.objects} == {o.id: o.pose for o in scene.objects if o.id in "acd"}
    assert [d.id for d in lighter.scene.dropped] == ["out"] and not lighter.scene.relations[0].hard
    assert lighter.unmet == ("a near d cannot hold here", f"out: {REASON}")
    assert lighter.notes == (f"b was left out: {REASON}",)


def check_again(scene: Scene, report: Report) -> Report:
    return replace(check(scene), seconds=report.seconds)


def test_the_least_wanted_goes_even_where_several_of_it_go():
    scene = room(cube("bed", "asked"), *(cube(f"p{k}", "optional", 1.2 + 0.8 * k) for k in range(3)))
    lighter, _ = cleared(scene, check(scene))
    assert "bed" in lighter.scene.ids and not lighter.unmet


def test_a_valid_layout_is_left_as_it_is():
    scene = room(cube("a", "optional"))
    report = check(scene)
    lighter, after = cleared(scene, report)
    assert lighter.scene is scene and after is report and not lighter.notes


def test_a_heap_of_alike_things_keeps_one():
    scene = room(*(cube(f"n{k:02}", "asked", 2.0 + 0.01 * k) for k in range(40)))
    lighter, report = cleared(scene, check(scene))
    assert len(lighter.scene.ids) == 1 and len(lighter.scene.dropped) == 39 and not report.collisions


def test_what_was_asked_for_is_drawn_nowhere_by_its_relations_before_it_goes():
    """Its hard relations become soft and all of them light; only then it goes."""
    pair = (cube("a", "asked"), cube("b", "asked", 2.3))
    ties = tuple(Relation(type="near", subject="a", target="b", params={"max": m}, asked=True) for m in (0.1, 0.2))
    soft = Relation(type="facing", subject="a", target="b", hard=False)
    scene = room(*pair, relations=(*ties, soft))
    first = relax(scene)
    assert first is not None and first.scene.ids == scene.ids and not first.scene.dropped
    assert not any(r.hard for r in first.scene.relations)
    assert all(r.weight < 0.1 for r in first.scene.relations if "a" in (r.subject, *r.targets))
    assert len(first.unmet) == 2  # the soft one had been given up already
    second = relax(first.scene)
    assert second is not None and len(second.scene.dropped) == 1


def test_of_relations_about_different_objects_one_each_gives_way_at_once():
    cubes = [cube(name, "asked", at) for name, at in zip("abcd", (1.0, 3.0, 5.0, 8.0), strict=True)]
    far = {"max": 0.1}
    relations = (
        Relation(type="near", subject="a", target="b", params=far, asked=True),
        Relation(type="near", subject="b", target="a", params={"max": 0.2}, asked=True),
        Relation(type="near", subject="c", target="d", params=far, asked=True),
    )
    for at_once, left in ((1, 2), (2, 1), (9, 0)):
        found = relax(room(*cubes, relations=relations), at_once)
        assert found is not None and sum(r.hard for r in found.scene.relations) == left


def test_what_came_back_is_not_said_to_be_left_out():
    scene = room(cube("kitchenette-0", category="kitchen_counter"))
    gone = left_out("sofa-0"), "sofa was left out of the floor asked for: the floor or the walls are full"
    back = left_out("kitchenette-0"), "kitchen_counter was left out of the floor asked for: the floor is full"
    another = "another kitchen_counter was left out of the floor asked for: the floor is full"
    assert still_true((*gone, *back, another, "desk-0: 2 mugs"), scene) == (*gone, another, "desk-0: 2 mugs")


def test_all_that_nobody_asked_for_goes_at_once_where_it_is_in_the_way_of_what_was():
    found = relax(room(cube("a", "asked", 2.5), cube("b", "usual", 2.0), cube("c", "usual", 3.0)))
    assert found is not None and found.scene.ids == ("a",) and not found.unmet


def test_what_others_were_asked_to_be_at_goes_after_them():
    objects = (cube("bar", "asked", 2.0), cube("s", "asked", 2.5), cube("t", "asked", 1.5))
    told = tuple(Relation(type="near", subject=n, target="bar", asked=True, hard=False, weight=0.01) for n in "st")
    found = relax(room(*objects, relations=told))
    assert found is not None and "bar" in found.scene.ids and len(found.scene.dropped) == 1


def test_what_nobody_asked_for_goes_before_what_was_even_where_it_is_in_no_trouble():
    objects = (cube("a", "asked", 2.0), cube("b", "asked", 2.5), cube("c", "usual", 6.0))
    found = relax(room(*objects))
    assert found is not None and found.scene.ids == ("a", "b") and found.late and not found.unmet
    near = Relation(type="near", subject="a", target="c", asked=True)
    objects = (*objects[:2], cube("c", "usual", 3.7))
    held = relax(room(*objects, relations=(near,)))
    assert held is not None and "c" in held.scene.ids
