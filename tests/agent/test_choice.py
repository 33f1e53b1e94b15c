"""Terms of design quality made of a scene and the design rules: they agree with what the critic says."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from sceneweaver.agent import executor
from sceneweaver.agent.choice import choice_terms
from sceneweaver.agent.executor import Executor
from sceneweaver.agent.settings import Settings
from sceneweaver.critic import review_scene
from sceneweaver.knowledge import room_type
from sceneweaver.knowledge.library import library_scenes, load_scene
from sceneweaver.language import SceneGraph
from sceneweaver.layout import rate
from sceneweaver.layout.rate import measures
from sceneweaver.rules.design import design_rules
from sceneweaver.scene import Door, Pose, Relation, Room, Scene, SceneObject, Window
from sceneweaver.tools.base import Proposal
from sceneweaver.verify import check

ROOM = Room(
    type="bedroom",
    outline=((0, 0), (5, 0), (5, 4), (0, 4)),
    doors=(Door(id="door", wall=0, offset=0.3, width=0.9, height=2.1),),
    windows=(Window(id="window", wall=2, offset=1.5, width=1.4, sill=0.9, height=1.2),),
)


def thing(
    name: str, size: tuple[float, float, float], x: float, y: float, yaw: float = 0.0, **more: Any
) -> SceneObject:
    return SceneObject(
        id=name, category=more.pop("category", name.split("-")[0]), size=size, pose=Pose.from_yaw(x, y, 0, yaw), **more
    )


BED = thing("bed-0", (2.0, 1.6, 0.5), 3.0, 2.99, -np.pi / 2)
WARDROBE = thing("wardrobe-0", (0.6, 1.2, 2.0), 4.69, 1.2, np.pi)
AT_DOOR = thing("bed-0", (2.0, 1.6, 0.5), 3.0, 1.01, np.pi / 2)
"""With its head at the wall of the door."""

BLOCKS = (thing("dresser-0", (2.0, 1.7, 0.9), 1.05, 2.2), thing("dresser-1", (1.0, 1.0, 0.9), 3.3, 1.2))
"""They fill the floor."""

CASES = {
    "bed_off_door_wall": ((AT_DOOR, WARDROBE), (BED, WARDROBE)),
    "door_frame": (
        (BED, thing("dresser-0", (0.4, 1.0, 0.8), 1.8, 0.21, np.pi / 2)),
        (BED, thing("dresser-0", (0.4, 1.0, 0.8), 4.0, 0.21, np.pi / 2)),
    ),
    "low_below_windows": (
        (AT_DOOR, thing("dresser-0", (0.6, 1.2, 1.1), 2.8, 3.69, -np.pi / 2)),
        (AT_DOOR, thing("dresser-0", (0.6, 1.2, 1.1), 4.3, 3.69, -np.pi / 2)),
    ),
    "before_use": (
        (BED, WARDROBE, thing("dresser-0", (0.5, 1.2, 0.9), 3.9, 1.2, np.pi)),
        (BED, WARDROBE, thing("dresser-0", (0.5, 1.2, 0.9), 0.26, 2.6, 0.0)),
    ),
    "no_empty_floor": ((WARDROBE,), (BED, WARDROBE, *BLOCKS)),
}
"""Objects that break a rule, and some that keep it."""


def points(scene: Scene, rule: str) -> float:
    """What the terms of a rule take off a scene as it is."""
    terms = [t for t in choice_terms(scene, room_type(scene.room.type)) if t.rule == rule]
    poses = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]])
    return -float(rate(scene, poses, terms)[0]) if terms else 0.0


@pytest.mark.parametrize("rule", CASES)
def test_terms_take_points_off_where_the_critic_does(rule):
    for objects, kept in zip(CASES[rule], (False, True), strict=True):
        scene = Scene(id="s", room=ROOM, objects=objects)
        review = review_scene(scene, check(scene), room_type("bedroom"), SceneGraph(text="a bedroom"))
        assert (rule in {f.rule for f in review.faults}) is not kept
        if kept:
            assert points(scene, rule) <= 0.2 * design_rules()[rule].points
        else:
            assert points(scene, rule) >= 0.4 * design_rules()[rule].points


def test_points_are_those_of_the_rules():
    scene = Scene(id="s", room=ROOM, objects=(BED, WARDROBE))
    for term in choice_terms(scene, room_type("bedroom")):
        if term.rule not in design_rules():  # an older check
            assert term.rule in ("unreachable", "crooked", "askew") and 0 < term.weight < term.most
            continue
        rule = design_rules()[term.rule]
        assert 0 < term.weight <= rule.points and term.most == rule.most and rule.applies("bedroom")


def test_what_belongs_to_a_sofa_is_read_from_relations():
    """Of two coffee tables each is wanted on the axis of its own sofa."""
    objects = [thing(f"{kind}-{k}", size, 1.0 + k, 2.0) for k in (0, 1) for kind, size in SET.items()]
    ties = [Relation(type="front_to_front", subject=f"coffee_table-{k}", target=f"sofa-{k}") for k in (0, 1)]
    room = ROOM.model_copy(update={"type": "living_room"})
    scene = Scene(id="s", room=room, objects=objects, relations=ties)
    terms = [t for t in choice_terms(scene, room_type("living_room")) if t.rule == "table_on_sofa_axis"]
    assert {t.objects for t in terms} == {("sofa-0", "coffee_table-0"), ("sofa-1", "coffee_table-1")}


TABLE = thing("dining_table-0", (0.9, 2.4, 0.75), 2.5, 2.0)
SEATS = [(1.9, 1.4, 0.0), (1.9, 2.6, 0.0), (3.1, 1.4, np.pi), (3.1, 2.6, np.pi)]
DESK = thing("reception_desk-0", (0.7, 1.8, 1.1), 1.6, 2.0)

OLDER = {
    "crooked": ("bedroom", (WARDROBE,), (thing("wardrobe-0", (0.6, 1.2, 2.0), 4.6, 1.2, np.pi + 0.07),)),
    "askew": ("bedroom", (WARDROBE,), (thing("wardrobe-0", (0.6, 1.2, 2.0), 4.4, 1.2, np.pi + 0.4),)),
    "uneven_row": (
        "restaurant",
        tuple(thing(f"cafe_table-{k}", (0.7, 0.7, 0.75), 1.0 + 1.3 * k, 2.5) for k in range(3)),
        tuple(thing(f"cafe_table-{k}", (0.7, 0.7, 0.75), 1.0 + 1.3 * k, 2.5 + 0.06 * (k == 1)) for k in range(3)),
    ),
    "staff_and_visitors_apart": (
        "waiting_room",
        (DESK, thing("armchair-0", (0.8, 0.8, 0.9), 3.5, 2.0, np.pi)),
        (DESK, thing("armchair-0", (0.8, 0.8, 0.9), 0.5, 2.0)),
    ),
    "cramped_seat": (
        "dining_room",
        (TABLE, *(thing(f"dining_chair-{k}", (0.45, 0.45, 0.9), *SEATS[k]) for k in range(4))),
        (TABLE, thing("dining_chair-0", (0.45, 0.45, 0.9), 1.9, 1.4), thing("dresser-0", (0.5, 1.0, 0.9), 1.4, 1.4)),
    ),
}
"""Kinds of rooms, objects that keep an older check or a rule of staff, and some that break it."""


@pytest.mark.parametrize("check_", OLDER)
def test_terms_follow_the_older_checks(check_):
    kind, kept, broken = OLDER[check_]
    for objects, wrong in ((kept, False), (broken, True)):
        seats = [o.id for o in objects if "chair-" in o.id] if TABLE in objects else []
        ties = tuple(Relation(type="front_against", subject=name, target=TABLE.id) for name in seats)
        scene = Scene(id="s", room=ROOM.model_copy(update={"type": kind}), objects=objects, relations=ties)
        review = review_scene(scene, check(scene), room_type(kind), SceneGraph(text="a room"))
        taken = sum(f.points for f in review.faults if f.kind == check_)
        assert (taken > 0.0) is wrong
        assert (points(scene, check_) > 0.05) is wrong


SET = {"sofa": (0.9, 2.0, 0.8), "coffee_table": (0.6, 1.1, 0.4)}


def test_every_room_of_the_library_has_terms_that_can_be_measured():
    for name in [card.name for card in library_scenes()][::4]:
        scene = load_scene(name)
        terms = choice_terms(scene, room_type(scene.room.type))
        poses = np.array([[(*o.pose.position, o.pose.yaw) for o in scene.objects]])
        values, rows = measures(scene, poses, terms)
        assert len(rows) == len(terms) > 3, name
        assert np.isfinite(values).all(), name


def test_the_executor_prefers_good_layouts():
    """With choice no bed has its head at the door's wall, though relations allow it."""
    relations = [Relation(type="against_wall", subject=o.id) for o in (BED, WARDROBE)]
    draft = Scene(id="s", room=ROOM, objects=(BED, WARDROBE), relations=relations)
    lost = {}
    for choice in (True, False):
        settings = Settings(device="cpu", candidates=24, finalists=1, choice=choice, generations=2)
        runner = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), settings)
        found = [runner.run(draft, Proposal(scene=draft, fresh=True), seed).scene for seed in range(3)]
        lost[choice] = sum(points(scene, rule) for scene in found for rule in ("bed_off_door_wall", "door_frame"))
    assert lost[True] == 0.0 < lost[False]


def test_with_many_layouts_all_rooms_are_compared(monkeypatch):
    """A small room suits a bed and a wardrobe better than a hall; with few layouts the first valid room stays."""
    hall = ROOM.model_copy(update={"outline": ((0, 0), (7, 0), (7, 6), (0, 6))})
    small = Room(type="bedroom", outline=((0, 0), (3.4, 0), (3.4, 3.2), (0, 3.2)), doors=ROOM.doors)
    relations = [Relation(type="against_wall", subject=o.id) for o in (BED, WARDROBE)]
    draft = Scene(id="s", room=hall, objects=(BED, WARDROBE), relations=relations)
    settings = Settings(device="cpu", candidates=16, generations=1)
    runner = Executor(room_type("bedroom"), SceneGraph(text="a bedroom"), settings)
    proposal = Proposal(scene=draft, fresh=True, rooms=(small,))
    assert runner.run(draft, proposal, 1).scene.room == hall
    monkeypatch.setattr(executor, "MANY", 16)
    assert runner.run(draft, proposal, 1).scene.room == small
