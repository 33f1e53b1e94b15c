"""Relations of imported scenes: what categories suggest counts where it is nearly so, all else where it holds."""

from __future__ import annotations

import math

import pytest

from sceneweaver.importers.relations import relations_of
from sceneweaver.scene import Pose, Room, Scene, SceneObject

ROOM = Room(outline=((0, 0), (4, 0), (4, 3), (0, 3)))


def thing(name, category, size, x, y, yaw=0.0, **more):
    return SceneObject(id=name, category=category, size=size, pose=Pose.from_yaw(x, y, 0.0, yaw), **more)


def found(*objects):
    scene = Scene(id="s", room=ROOM, objects=objects)
    relations = relations_of(scene)
    assert all(not r.hard for r in relations)
    return {(r.type, r.subject, r.target) for r in relations}


BED = thing("bed", "bed", (2.0, 1.6, 0.5), 1.0, 1.5)


@pytest.mark.parametrize(("gap", "there"), [(0.02, True), (-0.12, True), (0.2, True), (0.7, False)])
def test_a_nightstand_that_reaches_into_its_bed_is_beside_it(gap, there):
    stand = thing("stand", "nightstand", (0.4, 0.5, 0.5), 0.2, 1.5 + 0.8 + 0.25 + gap)
    assert (("leftright_to_leftright", "stand", "bed") in found(BED, stand)) is there


@pytest.mark.parametrize(("x", "there"), [(0.28, True), (0.2, True), (0.45, True), (1.2, False)])
def test_a_wardrobe_in_its_wall_is_against_it(x, there):
    assert (("against_wall", "w", None) in found(thing("w", "wardrobe", (0.6, 1.2, 2.0), x, 1.5))) is there


def test_a_box_has_to_hold_exactly():
    assert ("against_wall", "b", None) in found(thing("b", "object", (0.6, 1.2, 1.0), 0.32, 1.5))
    assert ("against_wall", "b", None) not in found(thing("b", "object", (0.6, 1.2, 1.0), 0.28, 1.5))


def test_a_chair_at_the_nearest_table():
    table = thing("t", "dining_table", (1.0, 1.6, 0.75), 2.0, 1.5)
    other = thing("u", "dining_table", (0.8, 0.8, 0.75), 3.6, 2.6)
    chair = thing("c", "dining_chair", (0.5, 0.5, 0.9), 1.35, 1.4, 0.1)
    away = thing("d", "dining_chair", (0.5, 0.5, 0.9), 2.0, 0.5, math.pi)
    relations = found(table, other, chair, away)
    assert ("front_against", "c", "t") in relations and ("front_against", "c", "u") not in relations
    assert not any(r[1] == "d" and r[0] == "front_against" for r in relations), "it looks away"


def test_a_lamp_over_a_table_and_a_sofa_before_a_screen():
    table = thing("t", "dining_table", (1.0, 1.6, 0.75), 2.0, 1.5)
    lamp = SceneObject(
        id="l", category="pendant", size=(0.3, 0.3, 0.6), pose=Pose.from_yaw(2.2, 1.5, 2.1, 0.0), mount="ceiling"
    )
    assert ("above", "l", "t") in found(table, lamp)
    sofa = thing("s", "sofa", (0.9, 2.0, 0.8), 0.5, 1.5)
    screen = thing("v", "tv_stand", (0.4, 1.6, 0.5), 3.7, 1.4, math.pi)
    assert ("facing", "s", "v") in found(sofa, screen)
