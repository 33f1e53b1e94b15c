"""Plainer shapes for the search hold the true ones."""

from __future__ import annotations

import sceneweaver as sw
from sceneweaver.agent.coarse import coarse
from sceneweaver.assets import make
from sceneweaver.scene import Pose, Room, Scene
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
