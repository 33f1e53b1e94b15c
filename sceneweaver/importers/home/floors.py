"""Clear floors of a storey's rooms from outlines as files have them: turned to the axes, cleaned, inset, on the grid.

Files draw rooms between the faces of walls or on the middle lines of walls, with the noise of pixels or of a survey.
What comes out is what a home has: the floor between wall faces in whole millimetres.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import shapely

from sceneweaver.geometry.polygons import signed_area, tidy

Drawn = Literal["auto", "faces", "middles"]
"""What the outlines of a file are: the faces of walls, their middle lines, or whatever the gaps between rooms say."""

TOUCH = 0.02
"""Rooms nearer than this [m] share a line: there is no wall between them."""

THICK = 0.6
"""Widest gap [m] between two rooms that is one wall."""

THIN = 0.01
"""Thinnest wall [m] that a home gets."""

SLIVER = 0.2
"""Parts of a room narrower than this [m] are no floor: tails that drawings have along walls."""

NOTCH = 0.03
"""Steps of an outline shorter than this [m] are noise."""

SHARED = 1e-4
"""Floor [m2] that two rooms may have in common before one loses it: less is rounding."""

STUB = 0.1
"""Thickness [m] of the wall from a room that stands free within another one to the wall next to it."""

SLANT = 0.06
"""Tangent below which a wall is meant to lie along an axis."""

STEP = 0.045
"""Steps of a wall shorter than this [m] are noise: no wall is so thin."""

LEVEL = 0.01
"""Walls along an axis whose places differ by less than this [m] lie on one line."""


@dataclass(frozen=True, eq=False)
class Floor:
    """The clear floor of a room: corners [k, 2] counter-clockwise [m], and what was done to it."""

    ring: np.ndarray
    notes: tuple[str, ...] = ()


def turn_of(rings: Sequence[np.ndarray]) -> float:
    """Angle [rad] by which rooms are turned from the axes, in (-45, 45] degrees; 0 where most walls lie along them."""
    edges = np.concatenate([np.roll(ring, -1, axis=0) - ring for ring in rings])
    length, angle = np.hypot(edges[:, 0], edges[:, 1]), np.arctan2(edges[:, 1], edges[:, 0])
    off = (angle + np.pi / 4) % (np.pi / 2) - np.pi / 4
    if length[np.abs(off) < SLANT].sum() >= 0.7 * length.sum():
        return 0.0
    mean = (length * np.exp(4j * angle)).sum() / length.sum()
    if abs(mean) < 0.4:
        return 0.0
    first = float(np.angle(mean)) / 4
    near = np.abs((angle - first + np.pi / 4) % (np.pi / 2) - np.pi / 4) < 0.1
    return first + float(np.angle((length * np.exp(4j * (angle - first)))[near].sum())) / 4


def turned(points: Any, angle: float) -> np.ndarray:
    """Points [n, 2] turned by ``-angle`` about the origin."""
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(points, dtype=float) @ np.array([[c, -s], [s, c]])


def clean(rings: Sequence[np.ndarray]) -> list[Floor | None]:
    """Rooms without tails, steps and overlaps, walls along the axes straightened; None: nothing is left of one.

    Args:
        rings: outlines [k, 2] in either order, along the axes but for what is meant to be slanted.
    """
    notes: list[list[str]] = [[] for _ in rings]
    shapes = [_open(shapely.Polygon(ring), said) for ring, said in zip(rings, notes, strict=True)]
    _part(shapes, notes)
    outlines = [None if s is None else np.asarray(tidy(shapely.get_coordinates(s.exterior)[:-1], 1e-4)) for s in shapes]
    for axis in (0, 1):
        _level(outlines, axis)
    shapes = [None if ring is None else _largest(shapely.Polygon(ring)) for ring in outlines]
    _part(shapes, notes)
    found: list[Floor | None] = []
    for shape, said in zip(shapes, notes, strict=True):
        found.append(
            None
            if shape is None
            else Floor(np.asarray(tidy(shapely.get_coordinates(shape.exterior)[:-1], 1e-4)), tuple(said))
        )
    return found


def _largest(shape: Any) -> Any:
    """The largest polygon of a shape, its holes filled; None where there is none."""
    shape = shape if shape.is_valid else shapely.make_valid(shape)
    parts = [p for p in shapely.get_parts(shape) if p.geom_type == "Polygon" and p.area > 0.01]
    return shapely.Polygon(max(parts, key=lambda p: p.area).exterior) if parts else None


def _open(shape: Any, notes: list[str]) -> Any:
    """The polygon without what is narrower than `SLIVER` and without steps of less than `NOTCH`."""
    whole = _largest(shape)
    if whole is None:
        notes.append("it encloses no floor")
        return None
    core = whole.buffer(-SLIVER / 2, join_style="mitre")
    wide = _largest(core.buffer(SLIVER / 2, join_style="mitre", mitre_limit=10).intersection(whole))
    if wide is None:
        notes.append(f"it is nowhere {SLIVER:g} m wide")
        return None
    if whole.area - wide.area > 1e-3:
        notes.append(f"{whole.area - wide.area:.2f} m2 narrower than {SLIVER:g} m left out")
    else:
        wide = whole
    filled = _largest(wide.buffer(NOTCH / 2, join_style="mitre").buffer(-NOTCH / 2, join_style="mitre"))
    return wide if filled is None or abs(filled.area - wide.area) < 1e-4 else filled


def _part(shapes: list[Any], notes: list[list[str]]) -> None:
    """Takes from each larger room what a smaller one has of it, in place."""
    order = sorted((k for k, s in enumerate(shapes) if s is not None), key=lambda k: shapes[k].area)
    for i, small in enumerate(order):
        for large in order[i + 1 :]:
            if shapes[small] is None or shapes[large] is None or not shapes[small].intersects(shapes[large]):
                continue
            shared = shapes[small].intersection(shapes[large]).area
            if shared > SHARED:
                shapes[large] = _largest(_cut(shapes[large], shapes[small]))
                notes[large].append(f"{shared:.2f} m2 that another room has as well left out")


def _cut(large: Any, small: Any) -> Any:
    """A room without another, and where that one stands free in it without a wall from there to the nearest wall."""
    left = large.difference(small)
    parts = [p for p in shapely.get_parts(left) if p.geom_type == "Polygon"]
    if len(parts) != 1 or not parts[0].interiors:
        return left
    link = shapely.shortest_line(shapely.Polygon(parts[0].interiors[0]), large.exterior)
    (x0, y0), (x1, y1) = link.coords[0], link.coords[-1]
    x, y = sorted((x0, x1)), sorted((y0, y1))
    dx, dy = (NOTCH, STUB / 2) if abs(x1 - x0) >= abs(y1 - y0) else (STUB / 2, NOTCH)
    return left.difference(shapely.box(x[0] - dx, y[0] - dy, x[1] + dx, y[1] + dy))


def _level(outlines: list[Any], axis: int) -> None:
    """Gives walls that are nearly along an axis one coordinate each, and those of nearly equal places one place."""
    counts = [0 if ring is None else len(ring) for ring in outlines]
    starts = np.concatenate(([0], np.cumsum(counts)))
    values = np.concatenate([ring[:, axis] for ring in outlines if ring is not None] or [np.zeros(0)])
    group = np.arange(len(values))
    weight = np.full(len(values), 1e-9)
    for ring, start in zip(outlines, starts[:-1], strict=True):
        if ring is None:
            continue
        step = np.roll(ring, -1, axis=0) - ring
        for k in range(len(ring)):
            along, across = abs(step[k, 1 - axis]), abs(step[k, axis])
            if along > 1e-9 and across <= SLANT * along:
                a, b = start + k, start + (k + 1) % len(ring)
                group[group == group[b]] = group[a]
                weight[[a, b]] += along
    walls = np.unique(group[weight > 1e-6])
    if not len(walls):
        return
    members = [np.flatnonzero(group == g) for g in walls]
    places = np.array([np.average(values[m], weights=weight[m]) for m in members])
    heavy = np.array([weight[m].sum() for m in members])
    number = {int(n): k for k, m in enumerate(members) for n in m}
    for bundle in _bundles(places, _steps(outlines, starts, axis, number, places)):
        spread = np.ptp(places[bundle])
        place = places[bundle[0]] if spread < 1e-9 else np.average(places[bundle], weights=heavy[bundle])
        for k in bundle:
            values[members[k]] = place
    for ring, start, count in zip(outlines, starts[:-1], counts, strict=True):
        if ring is not None:
            ring[:, axis] = values[start : start + count]


def _bundles(places: np.ndarray, pairs: Sequence[tuple[int, int]]) -> list[list[int]]:
    """Numbers of walls that are to lie on one line: those of nearly equal places, and the pairs."""
    label = np.arange(len(places))
    order = np.argsort(places, kind="stable").tolist()
    first = order[0]
    for k in order[1:]:
        if places[k] - places[first] <= LEVEL:
            label[label == label[k]] = label[first]
        else:
            first = k
    for a, b in pairs:
        label[label == label[b]] = label[a]
    return [np.flatnonzero(label == g).tolist() for g in np.unique(label)]


def _steps(
    outlines: Sequence[Any], starts: np.ndarray, axis: int, number: dict[int, int], places: np.ndarray
) -> list[tuple[int, int]]:
    """Pairs of walls of a step in an outline, at most `STEP` apart, or of two rooms that all but touch."""
    walls: list[tuple[int, float, float, int]] = []
    found: list[tuple[int, int]] = []
    for room, (ring, start) in enumerate(zip(outlines, starts[:-1], strict=True)):
        if ring is None:
            continue
        for k in range(len(ring)):
            a, b = start + k, start + (k + 1) % len(ring)
            low, high = sorted((float(ring[k, 1 - axis]), float(ring[(k + 1) % len(ring), 1 - axis])))
            if number.get(a) is not None and number.get(a) == number.get(b):
                walls.append((number[a], low, high, room))
            elif abs(ring[k, axis] - ring[(k + 1) % len(ring), axis]) <= STEP and high - low <= LEVEL:
                found += [(number[a], number[b])] if a in number and b in number else []
    for k, (one, low, high, room) in enumerate(walls):
        for other, low_, high_, room_ in walls[k + 1 :]:
            if room != room_ and abs(places[one] - places[other]) <= TOUCH and min(high, high_) - max(low, low_) > 0.1:
                found.append((one, other))
    return found


def gaps(rings: Sequence[np.ndarray]) -> list[tuple[float, float]]:
    """How far apart rooms are that face each other, as (length, gap) [m] of each two facing walls."""
    edges = [
        (k, a, (b - a) / np.hypot(*(b - a)), float(np.hypot(*(b - a))))
        for k, ring in enumerate(rings)
        for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True)
        if np.hypot(*(b - a)) > 0.3
    ]
    found = []
    for i, (room, a, way, long) in enumerate(edges):
        for other, c, back, far in edges[i + 1 :]:
            if room == other or way @ back > -0.999:
                continue
            gap = float(way[1] * (c - a)[0] - way[0] * (c - a)[1])  # outwards of a counter-clockwise room
            low, high = sorted((float((c - a) @ way), float((c + far * back - a) @ way)))
            shared = min(high, long) - max(low, 0.0)
            if shared >= 0.3 and -TOUCH <= gap <= THICK:
                found.append((shared, max(0.0, gap)))
    return found


def on_middles(found: Sequence[tuple[float, float]]) -> bool:
    """Whether rooms are drawn on the middle lines of walls: most of what faces another room touches it."""
    total = sum(length for length, _ in found)
    return total > 0 and sum(length for length, gap in found if gap < TOUCH) > 0.6 * total


def thickness(outlines: Sequence[Sequence[Sequence[float]]], usual: float) -> float:
    """The thinnest wall [m] between rooms that do not touch, at most ``usual``, in whole millimetres.

    Args:
        outlines: clear floors.
        usual: what walls are without two rooms.
    """
    boxes = []
    for outline in outlines:
        a = np.asarray(outline, dtype=float)
        b = np.roll(a, -1, axis=0)
        straight = bool((np.abs(a - b).min(axis=1) < 1e-9).all())
        boxes.append((np.minimum(a, b), np.maximum(a, b), straight, shapely.Polygon(a)))
    least = usual
    for k, (low, high, along, shape) in enumerate(boxes):
        for low_, high_, along_, shape_ in boxes[k + 1 :]:
            if along and along_:
                apart = float(np.maximum(low[:, None] - high_[None], low_[None] - high[:, None]).max(axis=2).min())
            else:
                apart = shape.distance(shape_)
            if apart >= THIN:
                least = min(least, apart)
    return max(THIN, round(np.floor(least * 1000 + 1e-4) / 1000, 3))


def inset(ring: np.ndarray, by: float) -> np.ndarray | None:
    """The outline with every wall moved inwards by ``by`` [m]; None where nothing is left."""
    shape = _largest(shapely.Polygon(ring).buffer(-by, join_style="mitre", mitre_limit=10))
    return None if shape is None else np.asarray(tidy(shapely.get_coordinates(shape.exterior)[:-1], 1e-6))


def apart(outlines: dict[str, tuple[tuple[float, float], ...]]) -> dict[str, tuple[tuple[float, float], ...]]:
    """Outlines on the grid of which none has a millimetre of another: the larger room loses what rounding gave it."""
    shapes = {key: shapely.Polygon(outline) for key, outline in outlines.items()}
    order = sorted(shapes, key=lambda key: shapes[key].area)
    for k, small in enumerate(order):
        for large in order[k + 1 :]:
            if shapes[small].intersects(shapes[large]) and shapes[small].intersection(shapes[large]).area > 1e-7:
                left = _largest(shapes[large].difference(shapes[small]))
                ring = None if left is None else on_grid(shapely.get_coordinates(left.exterior)[:-1])
                if ring is not None:
                    shapes[large], outlines = shapely.Polygon(ring), {**outlines, large: ring}
    return outlines


def on_grid(ring: np.ndarray) -> tuple[tuple[float, float], ...] | None:
    """The corners in whole millimetres, counter-clockwise from the least; None where they are no simple polygon."""
    whole = np.round(ring, 3) + 0.0
    whole = whole[(np.abs(whole - np.roll(whole, 1, axis=0)) > 1e-9).any(axis=1)]
    if len(whole) < 3:
        return None
    corners = np.asarray(tidy(whole))
    if len(corners) < 3 or signed_area(corners) < 0.01 or not shapely.Polygon(corners).is_valid:
        return None
    first = min(range(len(corners)), key=lambda k: (corners[k, 1] + corners[k, 0], corners[k, 0]))
    return tuple((round(float(x), 3), round(float(y), 3)) for x, y in np.roll(corners, -first, axis=0))
