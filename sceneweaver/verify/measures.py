"""The judge's measures, in float64: one function for each, and the sites at which relations may hold.

What a relation type asks for are the rows of `sceneweaver.rules`; the arithmetic here is the judge's own and shares
nothing with the engine's. Lengths have a slack of 1 mm unless a row is strict, overlaps and angles have none. Faces are
those of the object's box.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.spread import even_places
from sceneweaver.geometry.walls import Wall
from sceneweaver.rules import MEASURES
from sceneweaver.rules.relation import OPPOSITE, Row, Way, opposed, own_side
from sceneweaver.scene.catalogue import sides_named
from sceneweaver.verify.case import Case
from sceneweaver.verify.measure import ROUNDING, TOLERANCE, Judgement, Measurement, Measurements, judge
from sceneweaver.verify.solids import Body, Face, Opening, Point

SAME = 1e-9
"""Distance [m] up to which two points are one."""


class Reading(NamedTuple):
    """What a measure is at a site.

    Attributes:
        value: in m or deg.
        unit: ``m`` or ``deg``.
        scale, base: what the ends of the row's interval are multiplied with, and what is added to them.
        name: another name than the row's for what is measured.
    """

    value: float
    unit: str = "m"
    scale: float = 1.0
    base: float = 0.0
    name: str = ""


class Site(NamedTuple):
    """Where a relation may hold, in world coordinates.

    Attributes:
        name: of a wall, door or window, for sentences.
        side: the side of the target that it is.
        face: the face, wall or opening itself, its normal away from it into the room.
        subject_face: the face of the subject that is meant here.
        shape: what distances are taken from, as shapely geometries; None: the target.
        wall, before: the wall of it, and the one before a corner.
        local: from a point to its coordinates ahead and to the left.
        names: what expressions call the site's numbers.
    """

    local: Callable[[Point], Point]
    name: str = ""
    side: str = "front"
    face: Face = Face((0.0, 0.0), (1.0, 0.0), 0.0)
    subject_face: str = "front"
    shape: Any = None
    wall: Wall | None = None
    before: Wall | None = None
    names: Mapping[str, Any] = {}


def turn(a: Point, b: Point) -> float:
    """Angle between two directions [deg], 0 to 180."""
    return math.degrees(abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))


def along(start: Point, end: Point, direction: Point) -> float:
    """How far one point lies beyond another along a unit vector [m]."""
    return (end[0] - start[0]) * direction[0] + (end[1] - start[1]) * direction[1]


# ---- sites -----------------------------------------------------------------------------------------------------------


def _own(case: Case) -> Callable[[Point], Point]:
    return case.other.local if case.target is not None else lambda point: point


def _nowhere(case: Case) -> Iterator[Site]:
    yield Site(_own(case))


def _faces(case: Case) -> Iterator[Site]:
    for mine in case.spec.subject_sides:
        for side in case.spec.target_sides:
            face = case.other.face(side)
            yield Site(_own(case), "", side, face, mine, names={"opposed": opposed(mine, side)})


def _sides(case: Case) -> Iterator[Site]:
    scope, other = case.scope, case.other
    sides = [own_side(side, scope["frame"]) for side in case.spec.target_sides]
    if "side" in case.spec.params:
        sides = sides_named(str(scope["side"]), other.size, scope["frame"])
    for side in sides:
        face = other.face(side)
        part = -face.half + (scope.get("k", 0) + 0.5) * 2 * face.half / scope.get("n", 1)
        names = {"half": face.half, "part": part, "sideways": side in ("left", "right")}
        yield Site(_own(case), "", side, face, names=names)


def _of_wall(case: Case, wall: Wall, start: float = 0.0, width: float | None = None) -> Site:
    half = (wall.length if width is None else width) / 2
    u = start + half
    middle = (wall.start[0] + u * wall.along[0], wall.start[1] + u * wall.along[1])
    return Site(_own(case), f"wall {wall.index}", face=Face(middle, wall.inward, half), wall=wall)


def _walls(case: Case) -> Iterator[Site]:
    target, scope = case.relation.target, case.scope
    wanted = int(target[5:]) if isinstance(target, str) else None
    avoided = {door.wall.index for door in case.placed.doors} if scope.get("door_walls") == "avoided" else set()
    word = scope.get("side", "any")
    for wall in case.placed.walls:
        if wanted in (None, wall.index) and wall.index not in avoided:
            for side in case.spec.subject_sides:
                if word in ("any", side):
                    yield _of_wall(case, wall)._replace(subject_face=side)


def _corners(case: Case) -> Iterator[Site]:
    import shapely

    for wall in case.placed.walls:
        before = case.placed.walls[wall.index - 1]
        if before.along[0] * wall.inward[0] + before.along[1] * wall.inward[1] <= -case.number("corner"):
            yield _of_wall(case, wall)._replace(before=before, shape=shapely.points(wall.start))


def _openings(case: Case, openings: Iterable[Opening]) -> Iterator[Site]:
    import shapely

    for opening in openings:
        item, wall = opening.item, opening.wall
        if case.relation.target in (None, item.id):
            ends = [
                (wall.start[0] + u * wall.along[0], wall.start[1] + u * wall.along[1])
                for u in (item.offset, item.offset + item.width)
            ]
            site = _of_wall(case, wall, item.offset, item.width)
            yield site._replace(name=item.id, shape=shapely.linestrings(ends), subject_face="front")


def _either(case: Case) -> Iterator[Site]:
    return _openings(case, case.placed.windows if case.spec.target_kind == "window" else case.placed.doors)


def _door_zones(case: Case) -> Iterator[Site]:
    for door, zone in zip(case.placed.doors, case.placed.opening_zones.polygons, strict=False):
        if case.relation.target in (None, door.item.id):
            yield Site(_own(case), door.item.id, shape=zone)


def _wall_lines(case: Case) -> Iterator[Site]:
    import shapely

    for wall in case.placed.walls:
        yield _of_wall(case, wall)._replace(shape=shapely.linestrings([wall.start, wall.end]))


def _edges(case: Case) -> Iterator[Site]:
    """Edges of the convex hull of the target's footprint, as faces."""
    import shapely

    hull = shapely.convex_hull(shapely.multipolygons(case.placed.footprint(case.other)))
    ring = shapely.get_coordinates(shapely.normalize(hull))[:-1]
    x, y = ring[:, 0], ring[:, 1]
    if np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) < 0:
        ring = ring[::-1]
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        size = math.hypot(b[0] - a[0], b[1] - a[1])
        if size >= SAME:
            normal = (float(b[1] - a[1]) / size, float(a[0] - b[0]) / size)
            middle = (float(a[0] + b[0]) / 2, float(a[1] + b[1]) / 2)
            yield Site(_own(case), face=Face(middle, normal, size / 2))


def _middle(case: Case) -> Iterator[Site]:
    """The centre of the floor, or a point of it where that is outside."""
    import shapely

    floor = shapely.Polygon(case.placed.scene.room.outline)
    middle = shapely.centroid(floor)
    if not shapely.contains(floor, middle):
        middle = shapely.point_on_surface(floor)
    yield Site(lambda point: (point[0] - middle.x, point[1] - middle.y))


def _places(case: Case) -> Iterator[Site]:
    places, wall = even_places(case.placed.scene.room.outline, int(case.number("n"))), case.placed.walls[0]
    if case.number("k") < len(places):
        place = places[int(case.number("k"))]
        yield Site(lambda point: (along(place, point, wall.along), along(place, point, wall.inward)))


SITES: dict[str, tuple[Callable[[Case], Iterator[Site]], str]] = {
    "none": (_nowhere, "the two targets stand in one place"),
    "faces": (_faces, "it has no such face"),
    "sides": (_sides, "it has no such side"),
    "walls": (_walls, "the room has no {target}"),
    "corners": (_corners, "the room has no convex corner"),
    "windows": (lambda case: _openings(case, case.placed.windows), "the room has no {target}"),
    "doors": (lambda case: _openings(case, case.placed.doors), "the room has no {target}"),
    "openings": (_either, "the room has no {target}"),
    "door_zones": (_door_zones, "the room has no {target}"),
    "wall_bodies": (_wall_lines, "the room has no wall"),
    "edges": (_edges, "the target has no edge"),
    "middle": (_middle, "the room has no middle"),
    "places": (_places, "there is no such place"),
}
"""How the judge finds the sites of a way, and what it says where there is none."""


# ---- measures --------------------------------------------------------------------------------------------------------


def _face(case: Case, site: Site, row: Row) -> Face:
    """The face of the subject that a row is about; for "centre" a face without width at its origin."""
    if row.face == "centre":
        return Face(case.subject.centre, case.subject.front, 0.0)
    side = site.subject_face if row.face is None else OPPOSITE[site.side] if row.face == "opposite" else row.face
    return case.subject.face(side)


def _tangent(site: Site) -> Point:
    """The direction along a site: counter-clockwise about a thing, and with the wall."""
    nx, ny = site.face.normal
    return site.wall.along if site.wall is not None else (-ny, nx)


def _turned(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    nx, ny = site.face.normal
    yield Reading(turn(_face(case, site, row).normal, (-nx, -ny)), "deg")


def _overlap(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    face = _face(case, site, row)
    off = along(site.face.centre, face.centre, _tangent(site))
    shared = min(off + face.half, site.face.half) - max(off - face.half, -site.face.half)
    counted = face.half if row.of == "face" else min(face.half, site.face.half)
    yield Reading(shared, scale=2 * counted)


def _turn(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    modulo = float(row.options.get("modulo", 360.0))
    off = math.degrees(case.subject.yaw - case.other.yaw) - float(row.options.get("by", 0.0))
    yield Reading((off + modulo / 2) % modulo - modulo / 2, "deg")


def _bearing(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    """Coinciding centres face nothing: 90 degrees."""
    (ax, ay), (bx, by) = case.subject.centre, case.other.centre
    yield Reading(turn(case.subject.front, (bx - ax, by - ay)) if (ax, ay) != (bx, by) else 90.0, "deg")


def _distance(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    import shapely

    if site.shape is None:
        yield Reading(case.placed.distance(case.subject, case.other))
    else:
        yield Reading(float(shapely.distance(case.placed.footprint(case.subject), site.shape).min()))


def _box_gap(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    wall = site.before if row.of == "before" else site.wall
    if wall is not None:
        start, normal = wall.start, wall.inward
        name = "" if row.text != row.measure else f"distance to wall {wall.index}"
        yield Reading(min(along(start, corner, normal) for corner in case.subject.corners), name=name)


def _before(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    spots = [along(site.face.centre, corner, _tangent(site)) for corner in case.subject.corners]
    low, high, half = min(spots), max(spots), site.face.half
    yield Reading(min(high, half) - max(low, -half), scale=min(high - low, 2 * half))


def _line(case: Case) -> tuple[Point, Point, float]:
    """Start, direction and length of the way from the first target to the second."""
    a, b = (case.placed.by_id[name].centre for name in case.relation.target or ())
    size = math.hypot(b[0] - a[0], b[1] - a[1])
    return a, ((b[0] - a[0]) / max(size, SAME), (b[1] - a[1]) / max(size, SAME)), size


def _part_between(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    start, way, size = _line(case)
    if size >= SAME:
        yield Reading(along(start, case.subject.centre, way), scale=size)


def _off_line(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    start, (wx, wy), size = _line(case)
    if size >= SAME:
        yield Reading(along(start, case.subject.centre, (-wy, wx)))


def _spread(case: Case, site: Site, row: Row) -> Iterator[Reading]:
    """The angles to the neighbours on both sides, less the even one.

    The group are the subjects of all relations of the type with this target; ``n`` is its size when it is not given. A
    group of one has no neighbours.
    """
    target, by_id = case.relation.target, case.placed.by_id
    relations = case.placed.scene.relations
    names = {r.subject for r in relations if r.type == case.relation.type and r.target == target}
    group = [by_id[name] for name in names if name in by_id]
    n = case.spec.value(case.relation, "n") or len(group)
    if len(group) < 2 or n < 2:
        return
    here = _direction(case.other, case.subject)
    turns = sorted((_direction(case.other, b) - here) % 360.0 for b in group if b is not case.subject)
    for name, angle in (("angle to the next", turns[0]), ("angle to the one before", 360.0 - turns[-1])):
        yield Reading(angle, "deg", base=360.0 / n, name=name)


def _direction(centre: Body, body: Body) -> float:
    return math.degrees(math.atan2(body.position[1] - centre.position[1], body.position[0] - centre.position[0]))


def _lengths(value: Callable[[Case, Site, Point], float]) -> Callable[[Case, Site, Row], Iterator[Reading]]:
    """A measure that is one length: of a relation, a site, and the middle of the subject's face."""
    return lambda case, site, row: iter((Reading(value(case, site, _face(case, site, row).centre)),))


MEASURED: dict[str, Callable[[Case, Site, Row], Iterator[Reading]]] = {
    "turned": _turned,
    "gap": _lengths(lambda _, site, spot: along(site.face.centre, spot, site.face.normal)),
    "aside": _lengths(lambda _, site, spot: along(site.face.centre, spot, _tangent(site))),
    "overlap": _overlap,
    "ahead": _lengths(lambda _, site, spot: site.local(spot)[0]),
    "left": _lengths(lambda _, site, spot: site.local(spot)[1]),
    "turn": _turn,
    "bearing": _bearing,
    "distance": _distance,
    "box_gap": _box_gap,
    "before": _before,
    "part_between": _part_between,
    "off_line": _off_line,
    "spread": _spread,
    "height": _lengths(lambda case, *_: case.subject.bottom - (case.target.bottom if case.target is not None else 0.0)),
    "above": _lengths(lambda case, *_: case.subject.bottom - case.other.z[1]),
    "below": _lengths(lambda case, *_: case.other.bottom - case.subject.z[1]),
}
"""The readings of each measure; none where there is nothing to measure."""


# ---- rows ------------------------------------------------------------------------------------------------------------


def measurement(row: Row, reading: Reading, scope: Mapping[str, Any], site: str = "") -> Measurement | None:
    """A reading beside the interval of its row; None where the row asks for nothing."""
    interval = row.interval(scope)
    if interval is None:
        return None
    start = float(row.start.value(scope))
    value = reading.value - start
    if row.measure == "turn":  # beyond half a turn from where it is measured it is nearer the other way
        period = float(row.options.get("modulo", 360.0))
        value = (value + period / 2) % period - period / 2
    low, high = interval[0] * reading.scale + reading.base, interval[1] * reading.scale + reading.base
    if row.about and not reading.base:
        value, low = abs(value), -math.inf
    slack = TOLERANCE if MEASURES[row.measure].unit == "m" and not row.strict else 0.0
    name = reading.name or row.text
    name = name.format(site=site) if "{" in name else name
    return Measurement(name, value, low, high, reading.unit, slack)


def measured(case: Case, way: Way) -> Iterator[Measurements]:
    """The measurements of a way at each of its sites."""
    scope = case.scope
    if way.when is not None and not way.when.value(scope):
        return
    for site in SITES[way.sites][0](case):
        here = {**scope, **site.names}
        if way.where is not None and not way.where.value(here):
            continue
        found: list[Measurement] = []
        for row in way.rows:
            if row.kind is not None and row.counts(here):
                for reading in MEASURED[row.measure](case, site, row):
                    m = measurement(row, reading, here, site.name)
                    found += [] if m is None else [m]
        if found or way.sites != "none":
            yield found


def judge_ways(case: Case) -> Judgement:
    """Whether some way of a relation's type holds, at one of its sites or at every one."""
    target = case.relation.target
    missing = SITES[case.spec.ways[0].sites][1].format(target=target or case.spec.target_kind)
    whole = case.spec.overlap is not None and case.number("overlap") >= 1.0  # else rounding alone would decide
    return judge(_alternatives(case), missing, ROUNDING if case.spec.rounded or whole else 0.0)


def _alternatives(case: Case) -> Iterator[Measurements]:
    """What is measured of each way at each site, one after the other: the first that holds is enough."""
    for way in case.spec.ways:
        if not way.every:
            yield from measured(case, way)
            continue
        sites = list(measured(case, way))
        if sites or case.relation.target is None:
            yield [m for site in sites for m in site]
