"""Relations as interval rows: a relation has options (this wall, that side), an option is a set of rows, and a row
asks one feature of the poses to lie in an interval.

Each row has two intervals: ``hold`` is the judge's, narrowed by more than float32 loses, and decides; ``aim`` is
narrower still and is what the energy pulls into, so that the optimum lies strictly inside. A row may also have the
value that it takes when the relation is exact; a row without intervals is there for that alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.polygons import tidy
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.spread import even_places
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.kernels import tables as k
from sceneweaver.scene import CATALOGUE, Door, Relation, RelationSpec, SceneObject, Window
from sceneweaver.scene.catalogue import sides_named

from .region import Region
from .shapes import Points

INF = 1.0e9
DEGREE = math.radians(1.0)
LEVER = 0.5  # metres that a radian counts as
SLACK = 5.0e-4  # of the judge's 1 mm tolerance on lengths, what the engine allows itself
TIGHT = 2.0e-4  # where the judge has no tolerance
TIGHT_ANGLE = math.radians(0.02)

LOW = 0.2  # [m] what is lower than its target by more is not pushed under it as a seat is
LOOSE = 0.5  # [m] a relation that leaves more aside means no one place
HUNG = 1.0  # [m] beyond the heights where a thing should hang, from where it is brought to their middle
FLAT = 0.02  # [m] height of what lies on the floor like a rug

Vector = tuple[float, float]
OPEN: Vector = (-INF, INF)
SIDES: dict[str, Vector] = {"front": (1.0, 0.0), "back": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}


class Row(NamedTuple):
    """One feature and its intervals; see ``kernels.features`` for what point, normal and offset mean to each."""

    feature: int
    aim: Vector
    hold: Vector
    point: Vector = (0.0, 0.0)
    normal: Vector = (0.0, 0.0)
    offset: float = 0.0
    polygon: Points | None = None
    scale: float = 1.0
    exact: Snap | None = None

    @property
    def is_open(self) -> bool:
        """True when any value will do."""
        return self.aim == self.hold == OPEN

    def snapped(self, spec: RelationSpec, name: str, unit: float = 1.0) -> Row:
        """The row with what the catalogue says of a quantity's exact value, if it does; ``unit`` is that of the row."""
        exact = spec.snap.get(name)
        if exact is None:
            return self
        low, high = exact.within
        if isinstance(exact.value, str):
            value = 0.5 * (max(self.aim[0], -INF) + min(self.aim[1], INF))
        else:
            value = exact.value * unit
        alike = value if exact.alike is None else exact.alike * unit
        return self._replace(exact=Snap(value, alike, (low * unit, high * unit)))


class Snap(NamedTuple):
    """The exact value of a row, brought about from within an interval only.

    Where ``alike`` is another value, the subjects of a group take the same value, as near to the exact one as all can.
    """

    value: float
    alike: float
    within: Vector


@dataclass(frozen=True)
class CompiledRelation:
    """A relation between objects (local indices; -1 none) with its options."""

    objects: tuple[int, int, int]
    options: list[list[Row]]
    weight: float
    fault: int  # status when it does not hold: 0 soft, 1 mounting, 2 hard
    hard: bool


@dataclass
class Frame:
    """What the builders need to know: the objects of one problem, where they stand, their footprints."""

    objects: Sequence[SceneObject]
    index: dict[str, int]
    region: Region
    footprints: list[list[Points]]
    windows: Sequence[Window] = ()
    doors: Sequence[Door] = ()
    around: dict[str, list[Relation]] = field(default_factory=dict)  # target id -> the relations of its children
    tied: dict[tuple[str, str], int] = field(default_factory=dict)  # how many relations of a type have a target

    def object(self, key: str) -> SceneObject:
        """The object with an id."""
        return self.objects[self.index[key]]


def _span(lo: float, hi: float, slack: float = SLACK, inset: float = 0.003) -> tuple[Vector, Vector]:
    """(aim, hold) of an interval of lengths."""
    m = min(inset, 0.2 * (hi - lo))
    aim = (lo + m if lo > -INF else lo, hi - m if hi < INF else hi)
    s = max(slack, -0.25 * (hi - lo))
    return aim, (lo - s if lo > -INF else lo, hi + s if hi < INF else hi)


def _angle(degrees: float) -> tuple[Vector, Vector]:
    """(aim, hold) of a symmetric interval of angles."""
    limit = math.radians(degrees)
    aim = 0.85 * limit
    hold = limit - min(TIGHT_ANGLE, 0.01 * limit)
    return (-aim, aim), (-hold, hold)


def line(point: Vector, normal, offset: float, lo: float, hi: float, slack: float = SLACK) -> Row:
    """A point of the subject lies between lo and hi along a direction of the target."""
    if slack < 0 and hi - lo < 4 * TIGHT:
        return NEVER  # no room for rounding: nothing that is computed would be sure to hold
    aim, hold = _span(lo, hi, slack)
    return Row(k.FEATURE_LINE, aim, hold, point=point, normal=(float(normal[0]), float(normal[1])), offset=offset)


def yaw(offset: float, degrees: float, period: float = 2 * math.pi) -> Row:
    """The subject's yaw is within some degrees of the target's plus an offset, modulo the period."""
    aim, hold = _angle(degrees)
    return Row(k.FEATURE_YAW, aim, hold, normal=(period, 0.0), offset=offset, scale=LEVER)


def height(offset: float, lo: float, hi: float, slack: float = SLACK) -> Row:
    """The subject's bottom lies between lo and hi above the target's plus an offset."""
    aim, hold = _span(lo, hi, slack)
    return Row(k.FEATURE_HEIGHT, aim, hold, offset=offset)


def _open_line(point: Vector, normal, offset: float) -> Row:
    """A coordinate along a direction of the target on which the relation itself does not insist."""
    return Row(k.FEATURE_LINE, OPEN, OPEN, point=point, normal=(float(normal[0]), float(normal[1])), offset=offset)


def _open_yaw(offset: float, period: float = 2 * math.pi) -> Row:
    return Row(k.FEATURE_YAW, OPEN, OPEN, normal=(period, 0.0), offset=offset, scale=LEVER)


NEVER = Row(k.FEATURE_CONSTANT, (0.0, 0.0), (0.0, 0.0), offset=1.0)


def _face(obj: SceneObject, side: str) -> tuple[Vector, float, float]:
    """Centre of a side face, its distance from the origin and its half length."""
    d, w = obj.size[0] / 2, obj.size[1] / 2
    n = SIDES[side]
    reach, half = (d, w) if side in ("front", "back") else (w, d)
    return (n[0] * reach, n[1] * reach), reach, half


def _bearing(v) -> float:
    return math.atan2(v[1], v[0])


def _facing_rows(
    a: SceneObject,
    side: str,
    normal,
    reach: float,
    middle: float,
    half: float,
    gap: Vector,
    degrees: float,
    overlap: float,
) -> list[Row]:
    """a's side face opposite a face of b (normal, distance and lateral middle in b's frame)."""
    point, _, half_a = _face(a, side)
    across = half_a + half - 2 * overlap * min(half_a, half)
    tangent = (-normal[1], normal[0])
    return [
        yaw(_bearing(normal) + math.pi - _bearing(SIDES[side]), degrees),
        line(point, normal, reach, *gap),
        line(point, tangent, middle, -across, across, -TIGHT),
    ]


def _wall_rows(
    a: SceneObject, side: str, wall: Wall, gap: Vector, degrees: float, overlap: float, spec: RelationSpec
) -> list[Row] | None:
    """a's side face at a wall; None when the wall is too short for it."""
    point, _, half = _face(a, side)
    across = wall.length / 2 + half - 2 * half * overlap
    if wall.length < 2 * half * overlap + 4 * TIGHT:
        return None
    return [
        yaw(_bearing(wall.inward) + math.pi - _bearing(SIDES[side]), degrees).snapped(spec, "degrees", DEGREE),
        line(point, wall.inward, dot(wall.inward, wall.start), *gap).snapped(spec, "gap"),
        line(point, wall.along, dot(wall.along, wall.start) + wall.length / 2, -across, across, -TIGHT),
    ]


def _at_walls(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    a = frame.object(rel.subject)
    wanted = int(rel.target.split(":")[1]) if isinstance(rel.target, str) else None
    gap, spec = value("gap"), CATALOGUE[rel.type]
    avoided = set()
    if "door_walls" in spec.params and value("door_walls") == "avoided":
        avoided = {door.wall for door in frame.doors}
    options = []
    sides = [side for side in spec.subject_sides if "side" not in spec.params or value("side") in ("any", side)]
    for i, wall in enumerate(frame.region.walls):
        if (wanted is not None and i != wanted) or i in avoided:
            continue
        for side in sides:
            # the judge knows no lower limit but its 1 mm; objects stay inside the room anyway
            rows = _wall_rows(a, side, wall, (0.0, gap[1]), value("degrees"), value("overlap"), spec)
            if rows:
                options.append(rows)
    return options


def _at_sides(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    a, b = frame.object(rel.subject), frame.object(_one(rel))
    gap, spec = value("gap"), CATALOGUE[rel.type]
    offset = value("offset") if "offset" in spec.params else None
    options = []
    backs = value("backs") if "backs" in spec.params else None
    for side_a in spec.subject_sides:
        for side_b in spec.target_sides:
            if backs is not None and {side_a, side_b} != {"left", "right"}:
                continue
            _, reach, half = _face(b, side_b)
            rows = _facing_rows(a, side_a, SIDES[side_b], reach, 0.0, half, gap, value("degrees"), value("overlap"))
            if offset is not None:
                rows[2] = line(rows[2].point, rows[2].normal, 0.0, -offset, offset)
            options.append(_exact_faces(frame, rel, rows) + _backs(a, side_a, b, side_b, spec, backs))
    return options


def _exact_faces(frame: Frame, rel: Relation, rows: list[Row]) -> list[Row]:
    """Rows of two faces with their exact values: a gap only where the relation does not say one itself, the middles
    only for what is alone there."""
    a, b, spec = frame.object(rel.subject), frame.object(_one(rel)), CATALOGUE[rel.type]
    angle, gap, lateral = rows
    angle = angle.snapped(spec, "degrees", DEGREE)
    exact = spec.snap.get("gap")
    low = exact is not None and exact.alike is not None and (a.mount != "floor" or a.size[2] < b.size[2] - LOW)
    if "gap" not in rel.params and not low:
        gap = gap.snapped(spec, "gap")
    if frame.tied.get((rel.type, b.id), 1) == 1:
        lateral = lateral.snapped(spec, "lateral")
    return [angle, gap, lateral]


def _backs(
    a: SceneObject, side_a: str, b: SceneObject, side_b: str, spec: RelationSpec, most: float | None
) -> list[Row]:
    """The back of a in line with that of b, where both look the same way; at most so far off, where that is said."""
    if {side_a, side_b} != {"left", "right"}:
        return []
    back, ahead, level = (-a.size[0] / 2, 0.0), (1.0, 0.0), -b.size[0] / 2
    row = _open_line(back, ahead, level) if most is None else line(back, ahead, level, -most, most)
    return [row.snapped(spec, "backs")]


def _one(rel: Relation) -> str:
    assert isinstance(rel.target, str)  # the catalogue's target kind, checked when the scene was built
    return rel.target


def _distance(lo: float, hi: float, polygon: Points | None = None, slack: float = SLACK) -> Row:
    aim, hold = _span(lo, hi, slack, inset=0.005)
    if lo <= 0:  # overlapping footprints are at distance 0
        aim, hold = (-INF, aim[1]), (-INF, hold[1])
    return Row(k.FEATURE_DISTANCE, aim, hold, polygon=polygon)


def _near(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    middle = _middle(rel) if frame.object(rel.subject).mount == "ceiling" else []
    return [[_distance(0.0, value("max")), *middle]]


def _middle(rel: Relation, at: Vector = (0.0, 0.0)) -> list[Row]:
    """Exact rows of what belongs right over or under a place of its target, turned as it is or by quarters."""
    spec = CATALOGUE[rel.type]
    axes = ((1.0, 0.0), (0.0, 1.0))
    lines = [_open_line((0.0, 0.0), n, off).snapped(spec, "lateral") for n, off in zip(axes, at, strict=True)]
    return [*lines, _open_yaw(0.0, math.pi / 2).snapped(spec, "degrees", DEGREE)]


def _apart(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    lo, hi = value("min"), value("max")
    return [[_distance(0.0 if lo is None else lo, INF if hi is None else hi)]]


def _bearing_row(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    aim, hold = _angle(value("degrees"))
    turned, aside = _opposite(rel, math.pi)
    if (offset := value("offset")) is not None:
        aside = line((0.0, 0.0), (0.0, 1.0), 0.0, -offset, offset).snapped(CATALOGUE[rel.type], "lateral")
    return [[Row(k.FEATURE_BEARING, aim, hold, scale=LEVER), turned, aside]]


def _opposite(rel: Relation, turned: float) -> list[Row]:
    """Exact rows of the two middles in line along b's front, for what is turned so against b."""
    spec = CATALOGUE[rel.type]
    return [
        _open_yaw(turned).snapped(spec, "degrees", DEGREE),
        _open_line((0.0, 0.0), (0.0, 1.0), 0.0).snapped(spec, "lateral"),
    ]


def _aligned(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    return [[yaw(0.0, value("degrees"), math.pi / 2).snapped(CATALOGUE[rel.type], "degrees", DEGREE)]]


def _parallel(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    return [[yaw(0.0, value("degrees"), math.pi).snapped(CATALOGUE[rel.type], "degrees", DEGREE)]]


def _beyond(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The centre of a beyond a side of b that the catalogue names, in a band about the middle of it."""
    options = []
    for side in CATALOGUE[rel.type].target_sides:
        _, reach, half = _face(frame.object(_one(rel)), side)
        n, across = SIDES[side], half * value("band")
        options.append(
            [
                line((0.0, 0.0), n, reach, value("min"), value("max")),
                line((0.0, 0.0), (-n[1], n[0]), 0.0, -across, across, -TIGHT),
            ]
        )
    return options


def _centered(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    limit, spec, a, ahead = value("offset"), CATALOGUE[rel.type], frame.object(rel.subject), value("ahead")
    flat = a.mount == "ceiling" or a.size[2] < FLAT
    across, along = (line((0.0, 0.0), n, 0.0, -limit, limit).snapped(spec, "lateral") for n in ((0.0, 1.0), (1.0, 0.0)))
    if value("axis") == "either" and ahead is None:
        return [[row, *(_middle(rel) if flat else ())] for row in (across, along)]
    turned = [_open_yaw(0.0, math.pi / 2).snapped(spec, "degrees", DEGREE)] if flat else []
    if ahead is not None:
        return [[across, line((0.0, 0.0), (1.0, 0.0), 0.0, *ahead), *turned]]
    return [[across, *([along] if value("axis") == "both" else ()), *turned]]


def _over(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The centre of a over the box of b, or near its place there; a ceiling lamp, a rug and what is alone on it right
    over that place, the middle."""
    a, b, inset, offset = frame.object(rel.subject), frame.object(_one(rel)), value("inset"), value("offset")
    alone = a.mount == "ceiling" or a.size[2] < FLAT or (b.size[2] < FLAT and frame.tied.get((rel.type, b.id), 1) == 1)
    at = (value("forward") * b.size[0], value("left") * b.size[1])
    rows = []
    for middle, size, n in zip(at, b.size, ((1.0, 0.0), (0.0, 1.0)), strict=False):
        reach = max(size / 2 - inset, 0.0)
        low, high = -reach, reach
        if offset is not None:
            low, high = max(low, middle - offset), min(high, middle + offset)
        rows.append(line((0.0, 0.0), n, 0.0, low, high) if low <= high else NEVER)
    return [[*rows, *(_middle(rel, at) if alone else ())]]


def _corner(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    walls = frame.region.walls
    aim, hold = _span(-INF, value("to_wall"), -TIGHT)
    options = []
    for i, wall in enumerate(walls):
        before = walls[i - 1]
        if dot(before.along, wall.inward) > -0.17:  # not a convex corner of at least 10 degrees
            continue
        rows = [_distance(0.0, value("to_corner"), np.array([wall.start]), -TIGHT)]
        for w in (before, wall):
            row = Row(k.FEATURE_EXTENT, aim, hold, normal=w.inward, offset=dot(w.inward, wall.start))
            rows.append(row.snapped(CATALOGUE[rel.type], "gap"))
        options.append(rows)
    return options


def _at_window(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    options = []
    for window in frame.windows:
        if rel.target not in (None, window.id):
            continue
        wall = frame.region.walls[window.wall]
        middle = dot(wall.along, wall.start) + window.offset + window.width / 2
        aim, hold = _span(-INF, value("max"), -TIGHT)
        hung, offset = frame.object(rel.subject).mount == "wall", value("offset")
        centre = []
        if hung:
            centre = [_open_yaw(_bearing(wall.inward)).snapped(CATALOGUE[rel.type], "degrees", DEGREE)]
        aside = line((0.0, 0.0), wall.along, middle, -offset, offset)
        centre.append(aside.snapped(CATALOGUE[rel.type], "lateral") if hung or offset <= LOOSE else aside)
        options.append(
            [
                Row(
                    k.FEATURE_WINDOW,
                    (-INF, -0.003),
                    (-INF, -TIGHT),
                    point=(window.width / 2, value("overlap")),
                    normal=wall.along,
                    offset=middle,
                ),
                Row(k.FEATURE_EXTENT, aim, hold, normal=wall.inward, offset=dot(wall.inward, wall.start)),
                *centre,
            ]
        )
    return options


def _between(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    lo, hi = value("along")
    side = value("aside")
    aim, hold = _span(-side, side, -TIGHT)
    return [
        [
            Row(k.FEATURE_BETWEEN, (lo + 0.01, hi - 0.01), (lo + 1e-4, hi - 1e-4)),
            Row(k.FEATURE_ASIDE, aim, hold),
        ]
    ]


def _seated(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    a, b, spec = frame.object(rel.subject), frame.object(_one(rel)), CATALOGUE[rel.type]
    normal = SIDES[value("side")]
    point, _, _ = _face(a, "front")
    _, reach, half = _face(b, value("side"))
    place = ((value("k") + 0.5) / value("n") - 0.5) * 2 * half
    offset = value("offset")
    angle, gap, lateral = _exact_faces(
        frame,
        rel,
        [
            yaw(_bearing(normal) + math.pi, value("degrees")),
            line(point, normal, reach, *value("gap")),
            line(point, (-normal[1], normal[0]), place, -offset, offset),
        ],
    )
    return [[angle, lateral.snapped(spec, "lateral"), gap]]


def _next(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    return [_straight(frame, rel, value)]


def _straight(frame: Frame, rel: Relation, value) -> list[Row]:
    """Rows of the next in a row beyond a side of b: the boxes apart, the backs or else the middles in line."""
    a, b, spec = frame.object(rel.subject), frame.object(_one(rel)), CATALOGUE[rel.type]
    normal, offset = SIDES[value("side")], value("offset")
    _, reach_a, _ = _face(a, value("side"))
    _, reach_b, _ = _face(b, value("side"))
    near = (-normal[0] * reach_a, -normal[1] * reach_a)
    if normal[0] == 0.0:
        level = line((-a.size[0] / 2, 0.0), (1.0, 0.0), -b.size[0] / 2, -offset, offset)
    else:
        level = line((0.0, 0.0), (0.0, 1.0), 0.0, -offset, offset)
    return [
        yaw(0.0, value("degrees")).snapped(spec, "degrees", DEGREE),
        line(near, normal, reach_b, *value("gap")).snapped(spec, "gap"),
        level.snapped(spec, "lateral"),
    ]


def _run(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """Straight on, or around the corner: before b, the back in line with the side of b that is in the corner."""
    a, b, spec = frame.object(rel.subject), frame.object(_one(rel)), CATALOGUE[rel.type]
    side = SIDES[value("side")]
    turned = -side[1]  # to the right the run goes on facing b's left
    offset = value("offset")
    corner = [
        yaw(turned * math.pi / 2, value("degrees")).snapped(spec, "degrees", DEGREE),
        line((0.0, turned * a.size[1] / 2), (1.0, 0.0), b.size[0] / 2, *value("gap")).snapped(spec, "gap"),
        line((-a.size[0] / 2, 0.0), side, b.size[1] / 2, -offset, offset).snapped(spec, "lateral"),
    ]
    return [_straight(frame, rel, value), corner]


def _in_middle(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    (x, y), offset = frame.region.middle, value("offset")
    return [
        [line((0.0, 0.0), (1.0, 0.0), x, -offset, offset), line((0.0, 0.0), (0.0, 1.0), y, -offset, offset)],
    ]


def _on_grid(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The k-th of the even places, along the first wall and across."""
    places, spec, offset = (
        even_places([w.start for w in frame.region.walls], value("n")),
        CATALOGUE[rel.type],
        value("offset"),
    )
    if value("k") >= len(places):
        return []
    wall = frame.region.walls[0]
    return [
        [
            line((0.0, 0.0), n, dot(n, places[value("k")]), -offset, offset).snapped(spec, "lateral")
            for n in (wall.along, wall.inward)
        ]
    ]


def _across(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The front before one side of b, in the middle of a part of it; the gap anywhere in its interval."""
    a, b, spec, offset = frame.object(rel.subject), frame.object(_one(rel)), CATALOGUE[rel.type], value("offset")
    point, _, _ = _face(a, "front")
    options = []
    for side in sides_named(value("side"), b.size):
        normal = SIDES[side]
        _, reach, half = _face(b, side)
        place = ((value("k") + 0.5) / value("n") - 0.5) * 2 * half
        lateral = line(point, (-normal[1], normal[0]), place, -offset, offset)
        options.append(
            [
                yaw(_bearing(normal) + math.pi, value("degrees")).snapped(spec, "degrees", DEGREE),
                lateral.snapped(spec, "lateral") if offset <= LOOSE else lateral,
                line(point, normal, reach, *value("gap")),
            ]
        )
    return options


def _facing_door(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    options, most = [], value("aside")
    for door in frame.doors:
        if rel.target not in (None, door.id):
            continue
        wall = frame.region.walls[door.wall]
        rows = [yaw(_bearing(wall.outward), value("degrees"))]
        if most is not None:
            middle = wall.point(door.offset + door.width / 2)
            rows.append(line((0.0, 0.0), wall.along, dot(wall.along, middle), -most, most))
        options.append(rows)
    return options


def _off_walls(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The distance from the body of every wall, which lies outside of the room."""
    bodies = [np.array(wall.strip(0.0, wall.length, -WALL_THICKNESS, 0.0)) for wall in frame.region.walls]
    return [[_distance(value("min"), INF, body) for body in bodies]]


def _around(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    import shapely

    a = frame.object(rel.subject)
    target = frame.index[_one(rel)]
    hull = shapely.MultiPolygon([shapely.Polygon(p) for p in frame.footprints[target]]).convex_hull
    spread = _spread(frame, rel)
    options = []
    for edge in walls_of(tidy(shapely.get_coordinates(hull)[:-1])):
        (nx, ny), half = edge.outward, edge.length / 2
        rows = _facing_rows(
            a,
            "front",
            edge.outward,
            dot(edge.outward, edge.start),
            dot((-ny, nx), edge.point(half)),
            half,
            value("gap"),
            value("degrees"),
            value("overlap"),
        )
        options.append(_exact_faces(frame, rel, rows) + spread)
    return options


def _spread(frame: Frame, rel: Relation) -> list[Row]:
    """The angle from the next child around the same target back to this one: children keep the order of their
    relations, so that each has one neighbour to either side."""
    group = frame.around[_one(rel)]
    if len(group) < 2:
        return []
    value = _values(rel, frame.object(rel.subject))
    aim, hold = _angle(value("spread"))
    return [Row(k.FEATURE_SPREAD, aim, hold, offset=-2 * math.pi / (value("n") or len(group)), scale=LEVER)]


def _neighbours(frame: Frame, rel: Relation) -> tuple[Relation, Relation]:
    """The around relations before and after one in the circle of its group."""
    group = frame.around[_one(rel)]
    i = next(j for j, other in enumerate(group) if other is rel)
    return group[i - 1], group[(i + 1) % len(group)]


def spread_before(frame: Frame, rel: Relation) -> CompiledRelation | None:
    """The angle to the child before, for an around relation whose neighbour does not vouch for it: because that one is
    soft, or has another count or spread. None where nothing is missing."""
    before, _ = _neighbours(frame, rel)
    rows = _spread(frame, rel)
    same = _spread(frame, before) == rows and (before.hard or not rel.hard)
    if not rows or same:
        return None
    index = frame.index
    weight = rel.weight if rel.hard else SOFT_WEIGHT * rel.weight
    objects = (index[before.subject], index[_one(rel)], index[rel.subject])
    return CompiledRelation(objects, [rows], weight, 2 if rel.hard else 0, rel.hard)


def _away_from_door(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    doors = frame.region.doors
    wanted = [rel.target] if isinstance(rel.target, str) else list(doors)
    return [[_distance(value("min"), INF, doors[d].polygon) for d in wanted]]


def _near_opening(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """The distance from the line that a door or window takes in its wall."""
    openings = frame.windows if rel.type == "near_window" else frame.doors
    options = []
    for opening in openings:
        if rel.target in (None, opening.id):
            wall = frame.region.walls[opening.wall]
            ends = np.array([wall.point(opening.offset), wall.point(opening.offset + opening.width)])
            options.append([_distance(value("min"), value("max"), ends)])
    return options


def _stacked(above: bool) -> Callable[[Frame, Relation, Callable], list[list[Row]]]:
    def build(frame: Frame, rel: Relation, value) -> list[list[Row]]:
        a, b = frame.object(rel.subject), frame.object(_one(rel))
        half = b.size[1] * value("lateral")
        lateral = line((0.0, 0.0), (0.0, 1.0), 0.0, -half, half)
        vertical = height(b.size[2], 0.0, INF) if above else height(-a.size[2], -INF, 0.0)
        return [[lateral, vertical, *(_opposite(rel, 0.0) if a.mount == "wall" else ())]]

    return build


def _same_height(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    limit = value("tolerance")
    return [[height(0.0, -limit, limit)]]


def _on_floor(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    return [[]] if frame.object(rel.subject).mount == "floor" else [[height(0.0, -0.002, 0.002, -TIGHT)]]


def _supported(frame: Frame, rel: Relation, value) -> list[list[Row]]:
    """on_top and inside are choices of a surface, true by construction or not at all."""
    support = frame.object(rel.subject).support
    if support is None or support.object != rel.target:
        return []
    surface = next(s for s in frame.object(support.object).surfaces if s.name == support.surface)
    return [[]] if rel.type == "on_top" or surface.headroom is not None else []


Builder = Callable[[Frame, Relation, Callable], list[list[Row]]]

BUILDERS: dict[str, Builder] = {
    "against_wall": _at_walls,
    "side_against_wall": _at_walls,
    "front_against": _at_sides,
    "front_to_front": _at_sides,
    "leftright_to_leftright": _at_sides,
    "side_by_side": _at_sides,
    "back_to_back": _at_sides,
    "on_floor": _on_floor,
    "on_top": _supported,
    "inside": _supported,
    "near": _near,
    "distance": _apart,
    "facing": _bearing_row,
    "aligned": _aligned,
    "parallel": _parallel,
    "left_of": _beyond,
    "right_of": _beyond,
    "in_front_of": _beyond,
    "behind": _beyond,
    "beside": _beyond,
    "centered_on": _centered,
    "in_corner": _corner,
    "at_window": _at_window,
    "between": _between,
    "around": _around,
    "away_from_door": _away_from_door,
    "above": _stacked(True),
    "below": _stacked(False),
    "same_height": _same_height,
    "seated_at": _seated,
    "next_to": _next,
    "run_on": _run,
    "in_middle": _in_middle,
    "over": _over,
    "near_window": _near_opening,
    "near_door": _near_opening,
    "across_from": _across,
    "facing_door": _facing_door,
    "off_walls": _off_walls,
    "on_grid": _on_grid,
}


def _values(rel: Relation, subject: SceneObject) -> Callable[[str], Any]:
    """Reads a relation's numbers: its params, else the catalogue's defaults."""
    spec = CATALOGUE[rel.type]
    return lambda name: spec.gap_range(rel, subject.size[0]) if name == "gap" else spec.value(rel, name)


SOFT_WEIGHT = 0.2  # of a hard relation's, times the relation's own weight


def compile_relation(frame: Frame, rel: Relation) -> CompiledRelation:
    """Rows of one relation of the scene."""
    a = frame.object(rel.subject)
    options = BUILDERS[rel.type](frame, rel, _values(rel, a))
    b = c = -1
    if isinstance(rel.target, tuple):
        b, c = frame.index[rel.target[0]], frame.index[rel.target[1]]
    elif rel.target in frame.index:
        b = frame.index[rel.target]
    if rel.type == "around":
        c = frame.index[_neighbours(frame, rel)[1].subject]
    weight = rel.weight if rel.hard else SOFT_WEIGHT * rel.weight
    return CompiledRelation(
        (frame.index[rel.subject], b, c), options or [[NEVER]], weight, 2 if rel.hard else 0, rel.hard
    )


def mounting(frame: Frame, obj: int) -> CompiledRelation:
    """What holds a wall-mounted object: its back at some wall, as against_wall has it."""
    a = frame.objects[obj]
    rel = Relation(type="against_wall", subject=a.id)
    options = _at_walls(frame, rel, _values(rel, a))
    hung = a.intent.mounting_height
    if hung is not None:
        # The judge knows no such limit. What hangs where nobody looks for it is no less valid, only ugly.
        middle = 0.5 * (hung[0] + hung[1])
        level = height(0.0, *hung)._replace(exact=Snap(middle, middle, (hung[0] - HUNG, hung[1] + HUNG)))
        options = [[*rows, level] for rows in options]
    return CompiledRelation((obj, -1, -1), options or [[NEVER]], 1.0, 1, True)
