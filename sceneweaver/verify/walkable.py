"""Can a robot get about? Flood fill of the floor from the doors.

The robot is a disc, of radius 0.2 m unless another is given. A cell of the 5 cm grid is *free* when its centre lies in
the room and is at least the radius from every wall and from every obstacle. Obstacles are the solid parts of all
objects, whatever holds them, that begin below 1.8 m and end more than 2 cm above the floor: rugs are walked on, high
shelves passed under. Each door is entered at the free cell nearest to the centre of its zone; a door without one within
half the diagonal of its zone is blocked. Steps go to the four neighbouring cells. A room without doors is entered in
its largest free region.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sceneweaver.geometry.hulls import convex_hull
from sceneweaver.scene import CATALOGUE, Relation
from sceneweaver.verify.grid import Grid, padded
from sceneweaver.verify.solids import Array, Body, Placed

RADIUS = 0.2
"""Radius of the robot in metres, unless another is given."""

RADII = (0.01, 5.0)
"""Least and largest radius of a robot in metres."""

ARM = 0.35
"""How far the robot reaches beyond its radius, in metres."""

CLEARANCE = 1.8
"""Height in metres from which solids do not hinder."""

STEP = 0.02
"""Height in metres up to which solids are walked on."""

MOST_CELLS = 10_000_000
"""Cells up to which a floor is measured: a square of 158 m."""

TUCKED = CATALOGUE.with_role("seat")
"""Relations, hard or soft, by which one object stands in front of another."""


class Access(NamedTuple):
    """Shares from 0 to 1.

    ``walkable``: of the free cells, the largest share that can be reached from one door; 0 when no cell is free.
    ``reachable``: of the objects that stand on the floor, the share with a functional side within radius + 0.35 m of a
    cell that can be reached from some door; 1 when there are none; ``unreached`` has the ids of the others. The
    functional sides of an object are its front face and its hard zones (their convex hulls); for the two objects of a
    `TUCKED` relation and for what is walked on, its whole footprint. The distance is that in the plane, whatever stands
    in between.
    """

    walkable: float
    reachable: float
    unreached: tuple[str, ...] = ()


def measure(placed: Placed, radius: float = RADIUS) -> Access | None:
    """Return how much of the floor and which objects a robot of some radius [m] can reach; each is measured once.

    None for a room of more than `MOST_CELLS`.
    """
    kept: dict[float, Access | None] = placed.__dict__.setdefault("_access", {})
    if radius not in kept:
        kept[radius] = _measure(placed, radius)
    return kept[radius]


def _measure(placed: Placed, radius: float) -> Access | None:
    from scipy.ndimage import label

    grid = Grid(placed)
    if grid.cells > MOST_CELLS:
        return None
    free = free_for(placed, grid, radius)
    regions, count = label(free)
    sizes = np.bincount(regions.ravel(), minlength=count + 1)
    sizes[0] = 0
    entered = _entered(placed, grid, free, regions) if placed.doors else {int(sizes.argmax())} - {0}
    walkable = max((int(sizes[k]) for k in entered), default=0) / max(1, int(sizes.sum()))
    reached = np.isin(regions, list(entered))
    standing, missed = _unreached(placed, grid, reached, radius)
    return Access(walkable, 1.0 - len(missed) / standing if standing else 1.0, missed)


def free_for(placed: Placed, grid: Grid, radius: float) -> np.ndarray:
    """Which cells of a grid a robot of some radius [m] may stand on."""
    parts = placed.parts
    solid = (parts.z[:, 0] < CLEARANCE) & (parts.z[:, 1] > STEP)
    walls = np.stack([grid.outline, np.roll(grid.outline, -1, axis=0)], axis=1)
    obstacles = grid.to_grid(parts.xy[solid])
    hindered = grid.covered(grid.spans(walls, radius)) | grid.covered(grid.spans(obstacles, radius))
    return grid.inside() & ~hindered


def _entered(placed: Placed, grid: Grid, free: np.ndarray, regions: np.ndarray) -> set[int]:
    """Labels of the regions that the doors open into."""
    entered = set()
    for door in placed.doors:
        corners = grid.to_grid(np.array(door.polygon))
        cell = grid.nearest(free, corners.mean(axis=0), float(np.hypot(*(corners[2] - corners[0]))) / 2)
        if cell is not None:
            entered.add(int(regions[cell]))
    return entered


def _unreached(placed: Placed, grid: Grid, reached: np.ndarray, radius: float) -> tuple[int, tuple[str, ...]]:
    """How many objects stand on the floor, and the ids of those that cannot be reached."""
    standing = [body for body in placed.bodies if body.item.mount == "floor"]
    if not standing:
        return 0, ()
    fronts = grid.to_grid(np.array([front_of(body) for body in standing]))
    near = grid.touches(reached, grid.spans(fronts, radius + ARM), len(standing))
    left = [body for body, touched in zip(standing, near.tolist(), strict=True) if not touched]
    shapes: list[Array] = []  # the others of what has not been reached by its front
    owner: list[str] = []
    for body in left:
        found = other_sides(placed, body)
        shapes += found
        owner += [body.id] * len(found)
    held: set[str] = set()
    if shapes:
        spans = grid.spans(grid.to_grid(padded(shapes)), radius + ARM)
        held = {owner[k] for k in np.flatnonzero(grid.touches(reached, spans, len(shapes)))}
    return len(standing), tuple(body.id for body in left if body.id not in held)


def _ends(relation: Relation) -> tuple[str, ...]:
    return (relation.subject, relation.target) if isinstance(relation.target, str) else (relation.subject,)


def other_sides(placed: Placed, body: Body) -> list[Array]:
    """Convex polygons [v, 2] that a body is reached by beside its front: see `Access`."""
    found = [convex_hull(placed.zones.xy[row]) for row in np.flatnonzero(placed.zones.owner == body.index)]
    if body.z[1] <= STEP or any(r.type in TUCKED and body.id in _ends(r) for r in placed.scene.relations):
        found += list(placed.parts.xy[placed.part_rows(body)])
    return found


def front_of(body: Body) -> Array:
    """The front face of a body in plan: its two ends [2, 2]."""
    (x, y), (nx, ny), half = body.face("front")
    return np.array([(x + ny * half, y - nx * half), (x - ny * half, y + nx * half)])
