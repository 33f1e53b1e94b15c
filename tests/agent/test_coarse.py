"""Plainer shapes for the search hold the true ones."""

from __future__ import annotations

import math

import sceneweaver as sw
from sceneweaver.agent.coarse import coarse
from sceneweaver.assets import make
from sceneweaver.scene import Pose, Relation, Room, Scene
from sceneweaver.verify import check


def _room(*objects):
    room = Room(type="office", outline=((0, 0), (5, 0), (5, 4), (0, 4)), height=2.7)
    return Scene(id="room", room=room, objects=objects)


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


def test_what_is_near_for_coarse_shapes_is_near_for_the_true_ones():
    # A picture has a thick box for the search, a sofa with rounded corners one box.
    sofa = make("sofa", 1).object("sofa-0", pose=Pose.from_yaw(0.6, 2.0, 0, 0))
    frame = make("picture", 0).object("picture-0", mount="wall")
    gap = 0.4
    behind = 0.6 + sofa.size[0] / 2 + gap + frame.size[0] / 2  # in front of the sofa, with its back to it turned away
    frame = frame.model_copy(update={"pose": Pose.from_yaw(behind, 2.0, 1.5, math.pi)})
    near = Relation(type="near", subject="picture-0", target="sofa-0", params={"max": gap - 0.02})
    scene = _room(sofa, frame).model_copy(update={"relations": (near,)})
    assert not check(scene).relations.hard.satisfied
    plain = coarse(scene)
    assert plain.relations[0].params["max"] < gap - 0.02 - 0.04
    assert not check(plain).relations.hard.satisfied
    far = Relation(type="distance", subject="picture-0", target="sofa-0", params={"min": 0.35, "max": 0.36})
    kept = coarse(scene.model_copy(update={"relations": (far,)})).relations[0]
    assert kept.params == {"min": 0.35, "max": 0.35}
