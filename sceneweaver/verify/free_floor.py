"""Floor that stays free, measured from where things stand.

In the way of free floor is every solid part that reaches into the heights from 3 cm to 1.9 m (rugs and what hangs
higher are not), and what is outside of the room. Measured is how wide the free floor is: of a rectangle or circle at
its place, or the largest anywhere; of a clearance how deep a strip before each side is; of a gap the least distance
between its two sides; of a path the widest disc that gets along it (`verify.ways`). As with zones, 5 mm do not count,
and what a relation ties to a thing (a chair to its table) may stand in its clearance.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.scene import CATALOGUE, FreeArea
from sceneweaver.verify.grid import CELL, Grid
from sceneweaver.verify.measure import Measurement, at_least, length
from sceneweaver.verify.report import Violation
from sceneweaver.verify.solids import Array, Body, Placed
from sceneweaver.verify.ways import forget_ground, widest_way

LOW, HIGH = 0.03, 1.9
"""Heights between which a solid part is in the way [m]."""

SLACK = 5e-3
"""Length by which things may reach into free floor [m]."""

PATH_SLACK = CELL
"""The same of a path, which is measured on the cells of a grid [m]."""

FAR = 5.0
"""Largest width that is looked for [m]."""

_STEPS = 24


class FreeFloor(NamedTuple):
    """What was measured of a free area, and the ids of what bounds it; None where it names nothing that is there."""

    area: FreeArea
    measurement: Measurement | None
    objects: tuple[str, ...] = ()

    @property
    def holds(self) -> bool:
        """Whether the floor is free, as far as there is something to measure."""
        return self.measurement is None or self.measurement.ok()


def measure(placed: Placed, area: FreeArea, anywhere: bool = False) -> FreeFloor:
    """How free a free area is; with ``anywhere`` a rectangle or circle may lie where it is largest.

    What was measured is kept, as judge and critic ask for the same.
    """
    kept = placed.__dict__.setdefault("_free_floor", {})
    if (area, anywhere) not in kept:
        kept[area, anywhere] = _measure(placed, area, anywhere)
    return kept[area, anywhere]


def _measure(placed: Placed, area: FreeArea, anywhere: bool) -> FreeFloor:
    if area.kind in ("rectangle", "circle"):
        return _somewhere(placed, area) if anywhere else _at_pose(placed, area)
    if area.kind == "clearance":
        return _clearance(placed, area)
    if area.kind == "gap":
        return _gap(placed, area)
    width, missed = widest_way(placed, area)
    if width is None:
        return FreeFloor(area, None)
    return FreeFloor(area, at_least("width of the way", width, area.size[0], slack=PATH_SLACK), missed)


def find(placed: Placed) -> Iterator[Violation]:
    """The free areas of a scene that are not free."""
    for area in placed.scene.free_areas:
        found = measure(placed, area)
        if found.holds or found.measurement is None:
            continue
        kind = "narrow_path" if area.kind == "path" else "blocked_floor"
        by = f" ({', '.join(found.objects[:4])})" if found.objects else ""
        text = f"{area.kind} {area.id} is {length(found.measurement.value)} wide, not {length(area.size[0])}{by}"
        yield Violation.of(kind, (area.id, *found.objects), text, found.measurement)
    forget_ground(placed)


def _in_the_way(placed: Placed, without: frozenset[str] = frozenset()) -> tuple[list[Any], list[str]]:
    """The parts that are in the way as polygons, and whose each is."""
    parts = placed.parts
    rows = np.flatnonzero((parts.z[:, 0] < HIGH) & (parts.z[:, 1] > LOW))
    found = [(parts.polygons[row], placed.bodies[int(parts.owner[row])].id) for row in rows]
    kept = [(polygon, name) for polygon, name in found if name not in without]
    return [polygon for polygon, _ in kept], [name for _, name in kept]


def _outside(placed: Placed) -> Any:
    """All that is not in the room, as far as it matters."""
    return placed.floor.buffer(2 * FAR).difference(placed.floor)


def _at_pose(placed: Placed, area: FreeArea) -> FreeFloor:
    """The largest rectangle or circle of its form about its middle."""
    import shapely
    from shapely import affinity

    x, y, _ = area.pose.position
    polygons, names = _in_the_way(placed)
    solids = [*polygons, _outside(placed)]
    if area.kind == "circle":
        away = [float(shapely.distance(shapely.Point(x, y), solid)) for solid in solids]
        factors = [2 * d / area.size[0] for d in away]
    else:
        turned = [affinity.rotate(s, -area.pose.yaw, origin=(x, y), use_radians=True) for s in solids]
        factors = [_square_about(affinity.translate(s, -x, -y), area.size) for s in turned]
    least = min(factors)
    near = {name for name, factor in zip(names, factors, strict=False) if factor < min(1.0, least + 0.05)}
    what = "diameter of the free circle" if area.kind == "circle" else "length of the free rectangle"
    measured = at_least(what, min(least * area.size[0], FAR), area.size[0], slack=2 * SLACK)
    return FreeFloor(area, measured, tuple(sorted(near)))


def _square_about(solid: Any, size: tuple[float, float]) -> float:
    """By how much a rectangle about the origin can be scaled until it meets a solid."""
    import shapely
    from shapely import affinity

    scaled = affinity.scale(solid, 2 / size[0], 2 / size[1], origin=(0, 0))
    low, high = 0.0, 2 * FAR / min(size)
    if shapely.distance(scaled, shapely.Point(0, 0)) > high * 1.5:
        return high
    for _ in range(_STEPS):
        middle = (low + high) / 2
        free = not shapely.intersects(scaled, shapely.box(-middle, -middle, middle, middle))
        low, high = (middle, high) if free else (low, middle)
    return low


def _somewhere(placed: Placed, area: FreeArea) -> FreeFloor:
    """The largest rectangle or circle of its form anywhere on the floor, on the cells of a grid."""
    from scipy.ndimage import distance_transform_edt

    grid = Grid(placed)
    free = free_cells(placed, grid)
    if area.kind == "circle":
        widest = 2 * CELL * float(np.max(np.asarray(distance_transform_edt(np.pad(free, 1))))) - CELL
        return FreeFloor(area, at_least("diameter of the free circle", max(widest, 0.0), area.size[0], slack=CELL))
    best = max(_largest(free, area.size), _largest(free.T, area.size))
    measured = at_least("length of the free rectangle", best * area.size[0], area.size[0], slack=CELL)
    return FreeFloor(area, measured)


def free_cells(placed: Placed, grid: Grid) -> np.ndarray:
    """Which cells of a grid nothing is on."""
    parts = placed.parts
    rows = (parts.z[:, 0] < HIGH) & (parts.z[:, 1] > LOW)
    return grid.inside() & ~grid.covered(grid.spans(grid.to_grid(parts.xy[rows]), SLACK))


def _largest(free: np.ndarray, size: tuple[float, float]) -> float:
    """The largest scale at which a rectangle of cells is free somewhere, its first side along the columns."""
    sums = np.pad(np.cumsum(np.cumsum(free, axis=0), axis=1), ((1, 0), (1, 0)))
    low, high = 0.0, FAR / min(size)
    for _ in range(12):
        scale = (low + high) / 2
        rows, columns = (max(1, round(scale * side / CELL)) for side in size)
        fits = False
        if rows <= free.shape[0] and columns <= free.shape[1]:
            inside = sums[rows:, columns:] - sums[:-rows, columns:] - sums[rows:, :-columns] + sums[:-rows, :-columns]
            fits = bool((inside == rows * columns).any())
        low, high = (scale, high) if fits else (low, scale)
    return low


def _clearance(placed: Placed, area: FreeArea) -> FreeFloor:
    """The least depth of a strip before a side of a target, over the whole of that side."""
    least, by = FAR, ""
    bodies = [placed.by_id[name] for name in area.targets if name in placed.by_id]
    for body in bodies:
        own = _belonging(placed, body)
        polygons, names = _in_the_way(placed, own)
        solids = [*polygons, _outside(placed)]
        for side in area.sides_of(*body.size[:2]):
            for solid, name in zip(solids, [*names, "wall"], strict=True):
                depth = _before(body, side, solid)
                if depth < least:
                    least, by = depth, name
    if not bodies:
        return FreeFloor(area, None)
    measured = at_least(f"clear beside {', '.join(area.targets[:3])}", least, area.size[0], slack=SLACK)
    return FreeFloor(area, measured, () if measured.ok() or not by else (by,))


def _before(body: Body, side: str, solid: Any) -> float:
    """How far a solid is before a side of a body, where it is before it at all [m]; `FAR` where not."""
    import shapely

    (x, y), (nx, ny), half = body.face(side)
    wide = max(half - SLACK, 1e-3)
    strip = shapely.Polygon(
        [
            (x - ny * wide, y + nx * wide),
            (x + ny * wide, y - nx * wide),
            (x + ny * wide + nx * FAR, y - nx * wide + ny * FAR),
            (x - ny * wide + nx * FAR, y + nx * wide + ny * FAR),
        ]
    )
    part = shapely.intersection(strip, solid)
    if part.is_empty or part.area < 1e-6:
        return FAR
    corners: Array = shapely.get_coordinates(part)
    return float(max(((corners - (x, y)) @ (nx, ny)).min(), 0.0))


def _belonging(placed: Placed, body: Body) -> frozenset[str]:
    """What does not count beside a thing: itself, what it carries, and what a relation ties to it, with its load."""
    names = {body.id}
    for relation in placed.scene.relations:
        if isinstance(relation.target, str) and CATALOGUE[relation.type].ties_zones:
            pair = {relation.subject, relation.target}
            names |= pair if body.id in pair else set()
    for _ in range(3):  # a cup on a tray on a table
        names |= {o.id for o in placed.scene.objects if o.support is not None and o.support.object in names}
    return frozenset(names)


def _gap(placed: Placed, area: FreeArea) -> FreeFloor:
    """The least distance between the two sides of a gap, as seen from above."""
    import shapely

    found: list[tuple[float, tuple[str, ...]]] = []
    if "wall" in area.others:
        border = placed.floor.exterior
        for name in area.targets:
            if name in placed.by_id:
                footprint = placed.footprint(placed.by_id[name])
                found.append((float(shapely.distance(footprint, border).min()), (name,)))
    for a, b in area.pairs(placed.by_id, placed.scene.relations):
        found.append((placed.distance(placed.by_id[a], placed.by_id[b]), (a, b)))
    if not found:
        return FreeFloor(area, None)
    least, names = min(found)
    measured = at_least("gap", least, area.size[0], slack=SLACK)
    if area.most is not None and least > area.size[0]:
        measured = Measurement("gap", least, area.size[0], area.most, slack=2 * CELL)
    return FreeFloor(area, measured, () if measured.ok() else names)
