"""Questions of what can be got at from the door: by a robot, by a hand, by an eye."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.verify.grid import CELL, Grid
from sceneweaver.verify.solids import Body
from sceneweaver.verify.walkable import CLEARANCE, MOST_CELLS, STEP

from .asker import Asker, Question, rounded

ERROR = 0.08
"""Length [m] by which distances on the grid of the floor may be off, on the safe side."""

STOP = 0.3
"""How near [m] a robot has to come to a thing."""

RADII = (0.2, 0.25, 0.3, 0.35, 0.4)
"""Radii of robots [m]."""

PERSON, SHOULDER, ARM, HAND_MARGIN = 0.2, 1.4, 0.7, 0.1
"""Radius of who walks, height of the shoulder, length of the arm [m], and how far from that an answer must be."""

EYE = 1.6
"""Height of the eye [m]."""


COARSE, FINE = np.linspace(-0.49, 0.49, 4), np.linspace(-0.5, 0.5, 11)
"""Where in a box points are looked at: for most answers, and before something counts as hidden."""


class Floor:
    """The floor from the only door: how wide each cell's free surroundings are, and what can be got to."""

    def __init__(self, asker: Asker):
        self.facts = asker.facts
        self.grid = Grid(self.facts.placed)

    @cached_property
    def clearance(self) -> np.ndarray:
        """Distance [m] of every cell from what hinders, within about half of `ERROR`."""
        from scipy.ndimage import distance_transform_edt

        grid, parts = self.grid, self.facts.placed.parts
        solid = (parts.z[:, 0] < CLEARANCE) & (parts.z[:, 1] > STEP)
        blocked = grid.covered(grid.spans(grid.to_grid(parts.xy[solid]), CELL / 2)) | ~grid.inside()
        return CELL * np.asarray(distance_transform_edt(~np.pad(blocked, 1, constant_values=True)))[1:-1, 1:-1]

    @cached_property
    def door_cells(self) -> np.ndarray:
        """Which cells lie in the zone of the door."""
        door = self.facts.placed.doors[0]
        return self.grid.covered(self.grid.spans([self.grid.to_grid(np.array(door.polygon))], 1e-6))

    def entered(self, radius: float) -> np.ndarray:
        """Which cells a disc can get to from the zone of the door."""
        from scipy.ndimage import label

        regions, _ = label(self.clearance >= radius)
        inside = set(np.unique(regions[self.door_cells]).tolist()) - {0}
        return np.isin(regions, list(inside)) if inside else np.zeros(regions.shape, dtype=bool)

    def near(self, bodies: list[Body], cells: np.ndarray, reach: float) -> set[str]:
        """Ids of the bodies whose footprint is at most ``reach`` metres from some of the cells."""
        placed = self.facts.placed
        rows = np.concatenate([np.arange(*placed.part_rows(b).indices(len(placed.parts))) for b in bodies])
        spans = self.grid.spans(self.grid.to_grid(placed.parts.xy[rows]), reach)
        touched = self.grid.touches(cells, spans, len(rows))
        return {placed.bodies[int(k)].id for k in placed.parts.owner[rows[touched]]}

    def positions(self, cells: np.ndarray) -> np.ndarray:
        """World positions [n, 2] of the centres of cells."""
        return self.grid.to_world(cells)


def _floor(asker: Asker) -> Floor | None:
    """The floor where there is one door and the grid is not too large; kept with the asker."""
    if asker.floor is None and asker.facts.door is not None:
        floor = Floor(asker)
        asker.floor = floor if floor.grid.cells <= MOST_CELLS // 50 else None
    return asker.floor


def robot_reaches(asker: Asker) -> Question | None:
    """Whether a round robot gets from the door to a thing."""
    floor = _floor(asker)
    if floor is None:
        return None
    radius = asker.one(RADII)
    surely, perhaps = floor.entered(radius + ERROR), floor.entered(radius - ERROR)
    if not surely.any() or not asker.standing:
        return None
    reached = floor.near(asker.standing, surely, radius + STOP - ERROR)
    reachable = floor.near(asker.standing, perhaps, radius + STOP + ERROR)

    def answer(body: Body) -> tuple[bool | None, None]:
        return (True if body.id in reached else None if body.id in reachable else False), None

    return asker.ask_balanced(
        "robot_reaches",
        asker.shuffled(asker.standing),
        answer,
        lambda said, read: {"operands": {"radius": radius, "stop": STOP}, "margin": ERROR},
        across=200 * radius,
        stop=100 * STOP,
        low=STEP,
        high=CLEARANCE,
        error=ERROR,
    )


def in_reach(asker: Asker) -> Question | None:
    """Whether someone who walks in can lay a hand on a thing."""
    floor = _floor(asker)
    if floor is None:
        return None
    surely, perhaps = (floor.positions(floor.entered(PERSON + k * ERROR)) for k in (1, -1))
    if not len(surely):
        return None
    shoulder = np.array([0.0, 0.0, SHOULDER])

    def closest(body: Body, cells: np.ndarray) -> float:
        near = np.abs(cells - body.centre).max(axis=1) <= math.hypot(*body.size[:2]) / 2 + ARM + HAND_MARGIN
        cells = cells[near]
        if not len(cells):
            return math.inf
        local = (np.hstack([cells, np.zeros((len(cells), 1))]) + shoulder - np.array(body.position)) @ body.rotation
        d, w, h = body.size
        beyond = np.maximum(np.abs(local - (0, 0, h / 2)) - (d / 2, w / 2, h / 2), 0.0)
        return float(np.sqrt((beyond**2).sum(axis=1).min()))

    def answer(body: Body) -> tuple[bool | None, float]:
        near, far = closest(body, surely), closest(body, perhaps)
        return (True if near <= ARM - HAND_MARGIN else False if far >= ARM + HAND_MARGIN else None), near

    def details(said: bool, near: float) -> dict[str, Any]:
        operands = {"distance": rounded(min(near, 9.999)), "radius": PERSON, "shoulder": SHOULDER, "arm": ARM}
        return {"operands": operands, "margin": HAND_MARGIN}

    some = asker.shuffled(asker.named)[:10]
    return asker.ask_balanced("in_reach", some, answer, details, shoulder=SHOULDER, arm=100 * ARM)


def seen_from_door(asker: Asker) -> Question | None:
    """Whether a thing is in sight from the doorway."""
    facts = asker.facts
    if facts.doorway is None:
        return None
    start, inward, _ = facts.doorway
    eye = np.append(start + 0.05 * inward, EYE)

    def answer(body: Body) -> tuple[bool | None, float]:
        seen = visible_share(asker, body, eye, COARSE)
        hidden = seen == 0.0 and visible_share(asker, body, eye, FINE) == 0.0
        return (True if seen >= 0.5 else False if hidden else None), seen

    small = [b for b in asker.named if b not in asker.standing]
    return asker.ask_balanced(
        "seen_from_door",
        [*asker.shuffled(small)[:4], *asker.shuffled(asker.standing)[:4]],
        answer,
        lambda said, seen: {"operands": {"eye": [rounded(v) for v in eye], "share": rounded(seen)}},
        eye=EYE,
    )


def visible_share(asker: Asker, body: Body, eye: np.ndarray, steps: np.ndarray) -> float:
    """The share of points of a body's box that the eye sees past the parts of all others and the walls.

    The points form a grid at ``steps``, shares of depth, width and height from the middle of the box.
    """
    grid = np.stack(np.meshgrid(steps, steps, steps + 0.5, indexing="ij"), axis=-1).reshape(-1, 3)
    points = body.to_world(grid * np.array(body.size))
    placed = asker.facts.placed
    others = placed.parts.owner != body.index
    xy, z = placed.parts.xy[others], placed.parts.z[others]
    low, high = np.minimum(points.min(axis=0), eye), np.maximum(points.max(axis=0), eye)
    near = (xy.max(axis=1) >= low[:2]).all(axis=1) & (xy.min(axis=1) <= high[:2]).all(axis=1)
    near &= (z[:, 1] >= low[2]) & (z[:, 0] <= high[2])
    hidden = _past_walls(asker, points, eye) | crosses(xy[near], z[near], eye, points).any(axis=0)
    return 1.0 - float(hidden.mean())


def crosses(xy: np.ndarray, z: np.ndarray, eye: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Which prisms are met by which of the segments from an eye [3] to points [n, 3].

    Args:
        xy: corners [k, v, 2] of convex counter-clockwise polygons; corners may repeat.
        z: lower and upper ends [k, 2].
        eye: where all segments start.
        points: where they end.

    Returns:
        Flags [k, n]; Cyrus-Beck clipping against the planes of each prism.
    """
    edges = np.roll(xy, -1, axis=1) - xy
    normals = np.stack([edges[..., 1], -edges[..., 0]], axis=-1)
    toward = normals @ (points - eye)[:, :2].T
    at_eye = ((xy - eye[:2]) * normals).sum(axis=-1)[..., None]
    rise = np.broadcast_to((points - eye)[:, 2], (len(xy), 1, len(points)))
    toward = np.concatenate([toward, rise, -rise], axis=1)
    ends = np.stack([z[:, 1] - eye[2], eye[2] - z[:, 0]], axis=1)[..., None]
    at_eye = np.concatenate([at_eye, ends], axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = at_eye / toward
    enter = np.where(toward < 0, t, 0.0).max(axis=1, initial=0.0)
    leave = np.where(toward > 0, t, 1.0).min(axis=1, initial=1.0)
    outside = ((toward == 0) & (at_eye < 0)).any(axis=1)
    return (enter < leave) & ~outside


def _past_walls(asker: Asker, points: np.ndarray, eye: np.ndarray) -> np.ndarray:
    """Which segments leave the room on their way, in rooms that are not convex."""
    import shapely

    outline = asker.facts.placed.floor
    if float(shapely.area(shapely.convex_hull(outline))) - asker.facts.area < 1e-6:
        return np.zeros(len(points), dtype=bool)
    lines = shapely.linestrings(np.stack([np.broadcast_to(eye[:2], (len(points), 2)), points[:, :2]], axis=1))
    inner = shapely.buffer(outline, 0.01)
    shapely.prepare(inner)
    return ~shapely.contains_properly(inner, lines)


TEMPLATES = (robot_reaches, in_reach, seen_from_door)
