"""Real furniture in a room: a chair tucked under a desk, cups between shelf boards, books in a bookcase."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

import sceneweaver as sw
from sceneweaver.assets.asset import Asset
from sceneweaver.assets.parametric import Request, make
from sceneweaver.scene import Door, Relation, Room, Scene, Support


def _study(seed: int) -> tuple[Scene, dict[str, Asset]]:
    assets: dict[str, Asset] = {}
    objects, relations = [], []

    def add(
        category: str, number: int, draw: int, support: Support | None = None, request: Request | None = None
    ) -> str:
        asset = make(category, draw, request)
        assets[asset.id] = asset
        objects.append(asset.object(f"{category}-{number}", support=support))
        return objects[-1].id

    desk = add("desk", 0, seed)
    chair = add("dining_chair", 0, seed)
    case = add("bookcase", 0, seed, request=Request(size=(0.32, 1.0, 1.8)))
    relations += [
        Relation(type="against_wall", subject=desk),
        Relation(type="against_wall", subject=case),
        # Tucked: the front of the seat at least 15 cm under the desk.
        Relation(type="front_against", subject=chair, target=desk, params={"gap": [-0.5, -0.15]}),
        Relation(type="in_front_of", subject=chair, target=desk),
    ]
    for k in range(4):
        add("mug", k, seed + k, Support(object=case, surface="shelf-1"))
    for k in range(2):
        add("standing_books", k, seed + k, Support(object=case, surface="shelf-2"))
    for k in range(3):
        add("book", k, seed + k, Support(object=case, surface="shelf-0"))
    add("monitor", 0, seed, Support(object=desk, surface="top"))
    room = Room(
        outline=((0, 0), (3.2, 0), (3.2, 3.4), (0, 3.4)),
        height=2.7,
        doors=(Door(id="door-0", wall=0, offset=0.3, width=0.9, height=2.0),),
    )
    return Scene(id=f"study-{seed}", room=room, objects=tuple(objects), relations=tuple(relations)), assets


@pytest.mark.parametrize("seed", range(3))
def test_real_furniture_is_placed_without_collisions(seed: int) -> None:
    scene, assets = _study(seed)
    solution = sw.refine(scene, candidates=64, seed=seed, init="random", device="cpu")
    best = solution.best
    report = sw.check(best)
    assert report.valid, report.violations[:3]
    bodies = {asset_id: trimesh.Trimesh(a.mesh.vertices, a.mesh.faces, process=False) for asset_id, a in assets.items()}
    true = sw.check(best, meshes=bodies)
    assert true.valid and true.collisions == 0, true.violations[:3]

    where = {o.id: o for o in best.objects}
    desk, chair, case = where["desk-0"], where["dining_chair-0"], where["bookcase-0"]
    # In the desk's frame the chair's front lies behind the desk's front: it is tucked.
    turn = -desk.pose.yaw
    dx, dy = (c - d for c, d in zip(chair.pose.position[:2], desk.pose.position[:2], strict=True))
    across = dx * np.cos(turn) - dy * np.sin(turn)
    assert across - chair.size[0] / 2 < desk.size[0] / 2 - 0.14
    shelves = {s.name: s for s in case.surfaces}
    for mug in (o for o in best.objects if o.category == "mug"):
        shelf = shelves["shelf-1"]
        assert mug.pose.position[2] == pytest.approx(case.pose.position[2] + shelf.z, abs=2e-3)
        assert shelf.headroom is not None and mug.size[2] < shelf.headroom
    assert np.mean(solution.status == 0) > 0.9
