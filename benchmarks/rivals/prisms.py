"""What fills a scene, as upright convex prisms that floor objects carry along or that belong to the room."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from benchmarks.rivals.pulls import Room
from benchmarks.rooms import witness
from benchmarks.starts import movable
from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.geometry.se2 import SE2
from sceneweaver.geometry.shell import clearance, heights
from sceneweaver.scene import CATALOGUE, Scene

BEHIND = 2.0  # [m] that obstacles at the hull of the room reach out of it, so that no way out leads there


@dataclass(frozen=True)
class Prism:
    """A convex polygon between two heights.

    Attributes:
        owner: which of ``starts.movable(scene)`` carries it along; -1: it stands still.
        item: index of the object it belongs to; -1: the room's.
        corners: counter-clockwise [V, 2], in the owner's frame, or in the world's where there is none [m].
        z: lower and upper end in the world [m]; no rival lifts what stands on the floor.
    """

    owner: int
    item: int
    corners: np.ndarray
    z: tuple[float, float]

    def overlaps_height(self, other: Prism) -> bool:
        """Whether the two have heights in common, without which they never meet."""
        return min(self.z[1], other.z[1]) > max(self.z[0], other.z[0])


def owners(scene: Scene) -> np.ndarray:
    """Which of the movable floor objects every object moves with; -1: it stays where it is. Shape [N]."""
    slot = {int(i): k for k, i in enumerate(movable(scene))}
    index = {o.id: i for i, o in enumerate(scene.objects)}

    def owner(i: int) -> int:
        support = scene.objects[i].support
        if i in slot:
            return slot[i]
        return -1 if support is None or scene.objects[i].fixed else owner(index[support.object])

    return np.array([owner(i) for i in range(len(scene.objects))], dtype=int)


def solids(scene: Scene) -> list[Prism]:
    """The parts of all objects; what stands on an object is carried as the scene has it there."""
    return [
        Prism(owner, i, place(part.polygon), _lifted(part.z, z))
        for i, (owner, place, z) in enumerate(_frames(scene))
        for part in scene.objects[i].solids
    ]


def zones(scene: Scene) -> list[Prism]:
    """The hard zones of all objects."""
    return [
        Prism(owner, i, place(convex_hull(zone.polygon)), _lifted(zone.z, z))
        for i, (owner, place, z) in enumerate(_frames(scene))
        for zone in scene.objects[i].zones
        if zone.hard
    ]


def openings(scene: Scene) -> list[Prism]:
    """The clear space of doors and windows; in a wall of the hull it goes on behind the wall."""
    room = Room(scene)
    found = []
    for opening in scene.room.openings:
        wall = scene.room.walls[opening.wall]
        behind = BEHIND if np.all((room.p - wall.start) @ wall.inward > -1e-9) else 0.0
        zone = wall.strip(opening.offset, opening.width, -behind, clearance(opening))
        found.append(Prism(-1, -1, np.array(zone), heights(opening)))
    return found


def pockets(scene: Scene) -> list[Prism]:
    """What the convex hull of the outline has more than the room; at the hull's edge it goes on outwards."""
    import shapely

    room = shapely.Polygon(scene.room.outline)
    edge = room.convex_hull.exterior
    outside = room.convex_hull.difference(room)
    pieces = [p for p in getattr(outside, "geoms", [outside]) if p.area > 1e-9]
    found = []
    for piece in pieces:
        convex = piece.convex_hull.area - piece.area < 1e-9
        for part in [piece] if convex else shapely.constrained_delaunay_triangles(piece).geoms:
            found.append(Prism(-1, -1, _thick(convex_hull(part.exterior.coords[:-1]), edge), (0.0, scene.room.height)))
    return found


def tied(scene: Scene) -> set[tuple[int, int]]:
    """Pairs of objects, by index, that may stand in each other's zones."""
    index = {o.id: i for i, o in enumerate(scene.objects)}
    pairs = {
        (index[r.subject], index[r.target])
        for r in scene.relations
        if CATALOGUE[r.type].ties_zones and isinstance(r.target, str) and r.target in index
    }
    return pairs | {(b, a) for a, b in pairs}


def rectangle(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray, float] | None:
    """Middle [2], half size [2] and turn [rad] of a polygon that is a rectangle; None of any other."""
    if len(corners) != 4:
        return None
    along, aside = corners[1] - corners[0], corners[2] - corners[1]
    lengths = np.array([np.linalg.norm(along), np.linalg.norm(aside)])
    skew = abs(along @ aside) + np.abs(corners[0] + corners[2] - corners[1] - corners[3]).max()
    return None if skew > 1e-6 else (corners.mean(axis=0), lengths / 2, math.atan2(along[1], along[0]))


def _frames(scene: Scene) -> Iterator[tuple[int, Callable[[ArrayLike], np.ndarray], float]]:
    """Of every object its owner, what puts its points into the owner's frame, and its height."""
    own, floor = witness(scene), movable(scene)
    for i, owner in enumerate(owners(scene)):
        base = own[floor[owner]] if owner >= 0 else np.zeros(4)
        frame = SE2(base[0], base[1], base[3]).inverse() @ SE2(own[i, 0], own[i, 1], own[i, 3])
        yield int(owner), frame.to_world, float(own[i, 2])


def _lifted(z: tuple[float, float], by: float) -> tuple[float, float]:
    return z[0] + by, z[1] + by


def _thick(corners: np.ndarray, edge) -> np.ndarray:
    """A pocket with its side on the hull's edge moved outwards, so that it is left towards the room only."""
    import shapely

    after = np.roll(corners, -1, axis=0)
    for p, q in zip(corners, after, strict=True):
        if shapely.distance(edge, shapely.Point((p + q) / 2)) < 1e-6:
            out = np.array([q[1] - p[1], p[0] - q[0]]) / np.linalg.norm(q - p)
            return convex_hull([*corners, p + BEHIND * out, q + BEHIND * out])
    return corners
