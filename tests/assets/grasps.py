"""Whether a parallel gripper can take hold: of every door, drawer and lid, with room for fingers and palm.

``python -m tests.assets.grasps [CATEGORY ...] [--seeds N]`` prints each link without a grasp and each grasp that is of
no use.

The hand: two fingers with pads, ``FINGER`` thick, wide and deep, that open to ``OPENING``, on a palm. Its tips reach
``TIP`` past the position of a grasp. It comes with everything closed.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import manifold3d
import numpy as np

from sceneweaver.assets.asset import Asset
from sceneweaver.assets.body import Grasp
from sceneweaver.assets.parametric import make, makers
from sceneweaver.physics.hulls import merged_hulls

FINGER = (0.015, 0.02, 0.045)
"""Thickness with its pad, width and depth of a finger [m]."""

OPENING = 0.08
"""Between the fingers, at most [m]."""

TIP = 0.01
"""How far the tips of the fingers reach past the middle of what is held [m]."""

PALM = (0.04, 0.12, 0.04)
"""Extents of the palm across, along the closing of the fingers, and along the approach [m]."""

SLACK = 3e-3
"""By how much what is between the fingers may be thicker than a grasp says, and out of their middle [m]."""

HELD = {"door", "drawer", "lid"}
"""Roles of links that a hand must be able to move."""

Box = tuple[np.ndarray, np.ndarray]
"""Lower and upper corner, [3] each."""


def faults_of(asset: Asset) -> Iterator[str]:
    """What keeps a hand from moving what can be moved."""
    held = {grasp.link for grasp in asset.grasps}
    for number, link in enumerate(asset.links, start=1):
        if link.role in HELD and number not in held:
            yield f"{link.name}: a {link.role} without a grasp"
    for grasp in asset.grasps:
        for fault in grasp_faults(asset, grasp):
            of = asset.links[grasp.link - 1].name if grasp.link else "base"
            yield f"{of}: {grasp.name} {fault}"


def grasp_faults(asset: Asset, grasp: Grasp) -> Iterator[str]:
    """What is wrong with one grasp."""
    turn = frame_of(grasp)
    origin = np.array(grasp.position)
    if grasp.width + 2 * SLACK > OPENING:
        yield f"is {grasp.width * 1e3:.0f} mm wide"
        return
    solids = merged_hulls(asset)
    placed = [(solid.points - origin) @ turn for solid in solids]
    corners = (asset.mesh.vertices - origin) @ turn
    for name, (low, high) in hand(OPENING).items():
        near = [k for k, p in enumerate(placed) if (p.min(0) < high).all() and (p.max(0) > low).all()]
        deep = max((_shared(placed[k], low, high) for k in near), default=0.0)
        if deep > 1e-10:
            yield f"{name} is in a collision part by {deep * 1e9:.1f} mm3"
        elif crosses(corners[asset.mesh.faces], low + 5e-4, high - 5e-4):
            yield f"{name} is in the visual mesh"
        if asset.mount == "floor" and _lowest(low, high, turn, origin) < 0.0:
            yield f"{name} is in the floor"
    own = [p for solid, p in zip(solids, placed, strict=True) if solid.link == grasp.link]
    low, high = np.array([-FINGER[1] / 2, -OPENING / 2, TIP - FINGER[2]]), np.array([FINGER[1] / 2, OPENING / 2, TIP])
    between = [b for p in own if (b := _between(p, low, high)) is not None]
    if not between:
        yield "has nothing between the fingers"
        return
    right, left = min(a for a, _ in between), max(b for _, b in between)
    if not grasp.width - SLACK <= left - right <= grasp.width + SLACK:
        yield f"closes to {(left - right) * 1e3:.1f} mm, not to {grasp.width * 1e3:.1f}"
    if abs(left + right) / 2 > SLACK:
        yield f"is {abs(left + right) / 2 * 1e3:.1f} mm out of the middle"


def frame_of(grasp: Grasp) -> np.ndarray:
    """Its axes as columns [3, 3]: +z along the approach, +y along the closing."""
    z, y = np.array(grasp.approach), np.array(grasp.closing)
    assert abs(z @ y) < 1e-6
    return np.column_stack([np.cross(y, z), y, z])


def hand(opening: float) -> dict[str, Box]:
    """The boxes of a hand in the frame of a grasp."""
    thick, wide, deep = FINGER
    back = TIP - deep
    boxes = {
        "the palm": (np.array([-PALM[0], -PALM[1], 2 * (back - PALM[2])]) / 2, np.array([*PALM[:2], 2 * back]) / 2)
    }
    for name, side in (("the right finger", -1.0), ("the left finger", 1.0)):
        y = sorted((side * opening / 2, side * (opening / 2 + thick)))
        boxes[name] = (np.array([-wide / 2, y[0], back]), np.array([wide / 2, y[1], TIP]))
    return boxes


def crosses(triangles: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
    """Whether any of some triangles [F, 3, 3] reaches into a box (Akenine-Moeller: no axis parts the two)."""
    apart = (triangles.min(axis=1) > high).any(axis=1) | (triangles.max(axis=1) < low).any(axis=1)
    t = triangles[~apart] - (low + high) / 2
    half = (high - low) / 2
    edges = np.roll(t, -1, axis=1) - t
    normal = np.cross(edges[:, 0], edges[:, 1])
    axes = [normal, *(np.cross(edges[:, k], axis) for k in range(3) for axis in np.eye(3))]
    free = np.zeros(len(t), dtype=bool)
    for axis in axes:
        along = np.einsum("fvk,fk->fv", t, axis)
        reach = np.abs(axis) @ half
        free |= (along.min(axis=1) > reach) | (along.max(axis=1) < -reach)
    return bool((~free).any())


def _shared(points: np.ndarray, low: np.ndarray, high: np.ndarray) -> float:
    """Volume that the hull of points and a box share [m3]."""
    cube = manifold3d.Manifold.cube((high - low).tolist()).translate(low.tolist())
    return float((manifold3d.Manifold.hull_points(points) ^ cube).volume())


def _between(points: np.ndarray, low: np.ndarray, high: np.ndarray) -> tuple[float, float] | None:
    """From where to where along y the hull of points fills a box; None: it is not in it."""
    cube = manifold3d.Manifold.cube((high - low).tolist()).translate(low.tolist())
    shared = manifold3d.Manifold.hull_points(points) ^ cube
    if shared.volume() < 1e-10:
        return None
    bounds = shared.bounding_box()
    return bounds[1], bounds[4]


def _lowest(low: np.ndarray, high: np.ndarray, turn: np.ndarray, origin: np.ndarray) -> float:
    corners = np.array([(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    return float((corners @ turn.T + origin)[:, 2].min())


def main() -> int:
    """Examine categories and print the faults."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("categories", nargs="*")
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    bad = grasps = links = 0
    for name in options.categories or sorted(makers()):
        for seed in range(options.seeds):
            asset = make(name, seed)
            grasps += len(asset.grasps)
            links += sum(link.role in HELD for link in asset.links)
            for fault in faults_of(asset):
                print(f"{name} seed {seed}: {fault}")
                bad += 1
    print(f"{links} doors, drawers and lids, {grasps} grasps, {bad} faults")
    return 1 if bad else 0


if __name__ == "__main__":
    raise SystemExit(main())
