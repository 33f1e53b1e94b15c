"""Setting a layout straight makes nothing worse, and what was nearly so exactly so."""

from __future__ import annotations

import math

import pytest

import sceneweaver as sw
from sceneweaver.agent.coarse import coarse
from sceneweaver.agent.frames import local
from sceneweaver.agent.tidy import tidy
from sceneweaver.assets import make
from sceneweaver.scene import Pose, Relation, Room, Scene
from sceneweaver.verify import check


def _room(*objects, relations=()):
    room = Room(type="office", outline=((0, 0), (5, 0), (5, 4), (0, 4)), height=2.7)
    return Scene(id="room", room=room, objects=objects, relations=relations)


@pytest.mark.parametrize("name", ["bedroom", "study", "living-room"])
def test_nothing_becomes_worse(name):
    scene = Scene.example(name)
    before, after = check(scene), check(tidy(scene))
    assert after.valid >= before.valid
    assert len(after.violations) <= len(before.violations)


def test_coarse_shapes_contain_the_true_parts():
    import shapely

    objects = [
        make(category, seed).object(f"{category}-{seed}", pose=Pose.from_yaw(2, 2, 0, 0))
        for category in ("sofa", "sectional_sofa", "arc_lamp", "desk", "dining_chair", "wardrobe", "potted_plant")
        for seed in (0, 1)
    ]
    plain = coarse(_room(*objects))
    for true, rough in zip(objects, plain.objects, strict=True):
        for part in true.solids:
            room = shapely.union_all(
                [
                    shapely.Polygon(p.polygon).buffer(1e-6)
                    for p in rough.solids
                    if p.z[0] <= part.z[0] + 1e-5 and p.z[1] >= part.z[1] - 1e-5
                ]
            )
            assert room.contains(shapely.Polygon(part.polygon)), true.id
        assert len(rough.solids) <= len(true.solids)


def test_a_layout_of_coarse_shapes_is_valid_for_the_true_ones():
    scene = Scene.example("living-room")
    solution = sw.refine(coarse(scene), candidates=16, seed=3)
    layout = scene.replace_poses({o.id: o.pose for o in solution.best.objects})
    assert (solution.status == 0).any() and check(layout).valid


@pytest.mark.parametrize("yaw", [0.0, 0.7, math.pi / 2])
def test_seats_are_shared_out_between_the_sides_of_a_table(yaw):
    table = make("conference_table", 3).object("table-0", pose=Pose.from_yaw(4.0, 3.0, 0.0, yaw))
    chair = make("conference_chair", 1)
    long, deep = table.size[1], table.size[0] / 2 + chair.size[0] / 2 + 0.03
    spots = [(-deep, -0.45 * long), (-deep, -0.1 * long), (-deep, 0.15 * long), (-deep, 0.4 * long), (deep, 0.2 * long)]
    chairs = []
    for k, (u, v) in enumerate(spots):
        x, y = 4.0 + math.cos(yaw) * u - math.sin(yaw) * v, 3.0 + math.sin(yaw) * u + math.cos(yaw) * v
        pose = Pose.from_yaw(x, y, 0.0, yaw + (0.0 if u < 0 else math.pi))
        chairs.append(chair.object(f"chair-{k}", pose=pose))
    relations = tuple(Relation(type="front_against", subject=c.id, target="table-0") for c in chairs)
    room = Room(type="office", outline=((0, 0), (8, 0), (8, 6), (0, 6)), height=2.7)
    after = tidy(Scene(id="room", room=room, objects=(table, *chairs), relations=relations))
    places = [local(after.object(c.id), after.object("table-0")) for c in chairs]
    near, far = sorted(v for u, v in places if u < 0), sorted(v for u, v in places if u > 0)
    assert sorted((len(near), len(far))) == [2, 3]
    for row in (near, far):
        assert sum(row) == pytest.approx(0.0, abs=0.01)  # the row is in the middle of its side
        steps = [b - a for a, b in zip(row, row[1:], strict=False)]
        assert max(steps) - min(steps) < 0.01
    assert check(after).relations.hard.satisfied == 5
