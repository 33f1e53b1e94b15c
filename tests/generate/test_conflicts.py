"""What a request states that excludes each other to the letter is taken as people mean it."""

from __future__ import annotations

import pytest

from sceneweaver.agent.design import chosen_room
from sceneweaver.agent.loop import empty_scene
from sceneweaver.assets import Library
from sceneweaver.language import read_request
from sceneweaver.scene import Relation, Scene
from sceneweaver.tools.base import Context
from sceneweaver.tools.init_prior import InitPrior


@pytest.fixture(scope="module")
def drawn(library: Library):
    """The first scene of a request."""

    def run(text: str) -> Scene:
        brief = read_request(text)
        room = chosen_room(brief)[0]
        scene = InitPrior().propose(Context(brief, room, empty_scene(brief, room), library, 0)).scene
        assert scene is not None
        return scene

    return run


def asked(scene: Scene, subject: str) -> list[Relation]:
    return [r for r in scene.relations if r.asked and r.subject.startswith(subject)]


def test_seats_with_their_sides_told_are_not_spread_around_as_well(drawn):
    scene = drawn("a dining room with a long table surrounded by six chairs along its long sides, three per side")
    chairs = asked(scene, "dining_chair") or asked(scene, "chair")
    seated = [r for r in chairs if r.type == "seated_at"]
    assert len(seated) == 6 and not any(r.type == "around" for r in chairs)
    assert {(r.params["side"], r.params["n"]) for r in seated} == {("front", 3), ("back", 3)}


def test_what_is_around_a_thing_in_a_corner_is_near_it(drawn):
    scene = drawn("a living room with a cat tree in the corner and three stools around it")
    stools = asked(scene, "stool")
    assert len(stools) == 3 and {r.type for r in stools} == {"near"}


def test_what_is_next_to_a_thing_is_not_kept_across_the_room_from_it(drawn):
    scene = drawn("a living room with a sofa and an armchair next to the sofa and opposite the sofa")
    rows = {r.type: r.hard for r in asked(scene, "armchair")}
    assert rows["near"] and not rows["distance"]


def test_a_sofa_at_a_wall_leaves_room_for_the_screen_behind_it(drawn):
    scene = drawn("a living room with a sofa against the left wall and a room divider behind the sofa")
    wall = next(r for r in asked(scene, "sofa") if r.type == "against_wall")
    depth = scene.object("room_divider-0").size[0]
    assert wall.hard and wall.params["gap"][1] >= depth


def test_nothing_usual_hangs_where_something_else_was_asked_for(drawn):
    scene = drawn("a bathroom with a pedestal sink below a medicine cabinet and a round mirror on the wall")
    above = {r.subject for r in scene.relations if r.type == "above" and r.target == "pedestal_sink-0"}
    assert above == {"medicine_cabinet-0"}


def test_no_bathtub_means_none_of_any_kind(drawn):
    for seed_word in ("modern", "classic", "rustic"):
        scene = drawn(f"a large {seed_word} bathroom without a bathtub")
        assert not any("bathtub" in o.category for o in scene.objects)
