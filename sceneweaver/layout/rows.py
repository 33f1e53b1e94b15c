"""Relations as interval rows of the kernels: a relation has options (this wall, that side), an option is a set of rows,
and a row asks one feature of the poses to lie in an interval.

What a type means stands in `sceneweaver.rules`; here is how the engine finds its sites and computes its measures, one
function for each. Each row has two intervals: ``hold`` is the judge's, narrowed by more than float32 loses, and
decides; ``aim`` is narrower still and is what the energy pulls into, so that the optimum lies strictly inside. A row
may also have the value that it takes when the relation is exact; a row without intervals is there for that alone.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from sceneweaver.geometry.angles import dot
from sceneweaver.geometry.polygons import tidy
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.spread import even_places
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.kernels import tables as k
from sceneweaver.rules import MEASURES
from sceneweaver.rules.relation import OPPOSITE, Interval, Way, opposed, own_side
from sceneweaver.rules.relation import Row as Rule
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

HUNG = 1.0  # [m] beyond the heights where a thing should hang, from where it is brought to their middle

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
    """A relation between objects (local indices; -1 none) with its options; ``term`` names a term of the user's own."""

    objects: tuple[int, int, int]
    options: list[list[Row]]
    weight: float
    fault: int  # status when it does not hold: 0 soft, 1 mounting, 2 hard
    hard: bool
    term: str | None = None


@dataclass
class Frame:
    """What compiling needs to know: the objects of one problem, where they stand, their footprints."""

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


def line(point: Vector, normal, offset: float, lo: float = -INF, hi: float = INF, slack: float = SLACK) -> Row:
    """A point of the subject lies between lo and hi along a direction of the target."""
    if slack < 0 and hi - lo < 4 * TIGHT:
        return NEVER  # no room for rounding: nothing that is computed would be sure to hold
    aim, hold = _span(lo, hi, slack)
    return Row(k.FEATURE_LINE, aim, hold, point=point, normal=(float(normal[0]), float(normal[1])), offset=offset)


def yaw(offset: float, degrees: float | None, period: float = 2 * math.pi) -> Row:
    """The subject's yaw is within some degrees of the target's plus an offset, modulo the period; None: any will do."""
    aim, hold = (OPEN, OPEN) if degrees is None else _angle(degrees)
    return Row(k.FEATURE_YAW, aim, hold, normal=(period, 0.0), offset=offset, scale=LEVER)


def height(offset: float, lo: float, hi: float, slack: float = SLACK) -> Row:
    """The subject's bottom lies between lo and hi above the target's plus an offset."""
    aim, hold = _span(lo, hi, slack)
    return Row(k.FEATURE_HEIGHT, aim, hold, offset=offset)


NEVER = Row(k.FEATURE_CONSTANT, (0.0, 0.0), (0.0, 0.0), offset=1.0)


def _face(obj: SceneObject, side: str) -> tuple[Vector, float, float]:
    """Centre of a side face, its distance from the origin and its half length."""
    d, w = obj.size[0] / 2, obj.size[1] / 2
    n = SIDES[side]
    reach, half = (d, w) if side in ("front", "back") else (w, d)
    return (n[0] * reach, n[1] * reach), reach, half


def _bearing(v) -> float:
    return math.atan2(v[1], v[0])


# ---- sites -----------------------------------------------------------------------------------------------------------


class Site(NamedTuple):
    """Where a relation may hold, in the frame of the target, or of the room where there is none.

    Attributes:
        normal, level: direction of a face, wall or opening, and its offset along that.
        along, middle, half: direction along it, its middle there and half its width [m].
        face, side: the face of the subject that is meant here; the side of the target.
        axes, origin: of the frame in which "ahead" and "left" are measured.
        polygon: the footprint from which distances are taken; None: the target's.
        before: normal and offset of the wall before a corner.
        names: what expressions call the site's numbers.
    """

    normal: Vector = (1.0, 0.0)
    level: float = 0.0
    along: Vector = (0.0, 1.0)
    middle: float = 0.0
    half: float = 0.0
    face: str = "front"
    side: str = "front"
    axes: tuple[Vector, Vector] = ((1.0, 0.0), (0.0, 1.0))
    origin: Vector = (0.0, 0.0)
    polygon: Points | None = None
    before: tuple[Vector, float] = ((1.0, 0.0), 0.0)
    names: Mapping[str, Any] = {}


class Case(NamedTuple):
    """A relation to compile, with the names that the expressions of its rules know."""

    frame: Frame
    rel: Relation
    spec: RelationSpec
    scope: dict[str, Any]

    @property
    def a(self) -> SceneObject:
        """The subject."""
        return self.scope["a"]

    @property
    def b(self) -> SceneObject:
        """The target object."""
        return self.scope["b"]


def _nowhere(case: Case) -> Iterator[Site]:
    """The target itself, or the room."""
    yield Site()


def _target_side(b: SceneObject, side: str) -> Site:
    _, reach, half = _face(b, side)
    normal = SIDES[side]
    return Site(normal, reach, (-normal[1], normal[0]), 0.0, half, side=side)


def _faces(case: Case) -> Iterator[Site]:
    """Each face of the subject that may take part at each of the target's."""
    for face in case.spec.subject_sides:
        for side in case.spec.target_sides:
            yield _target_side(case.b, side)._replace(face=face, names={"opposed": opposed(face, side)})


def _sides(case: Case) -> Iterator[Site]:
    """The sides of the target that the relation names or its type has, with the middle of the part that is meant."""
    scope, b = case.scope, case.b
    if "side" in case.spec.params:
        sides = sides_named(scope["side"], b.size, scope["frame"])
    else:
        sides = tuple(own_side(side, scope["frame"]) for side in case.spec.target_sides)
    for side in sides:
        site = _target_side(b, side)
        part = ((scope.get("k", 0) + 0.5) / scope.get("n", 1) - 0.5) * 2 * site.half
        yield site._replace(names={"half": site.half, "part": part, "sideways": side in ("left", "right")})


def _at_wall(wall: Wall, face: str = "back") -> Site:
    level, start = dot(wall.inward, wall.start), dot(wall.along, wall.start)
    return Site(wall.inward, level, wall.along, start + wall.length / 2, wall.length / 2, face)


def _walls(case: Case) -> Iterator[Site]:
    """Each wall that is meant, for each face of the subject that may be there."""
    target, scope = case.rel.target, case.scope
    wanted = int(target.split(":")[1]) if isinstance(target, str) else None
    avoided = {door.wall for door in case.frame.doors} if scope.get("door_walls") == "avoided" else ()
    word = scope.get("side", "any")
    faces = [face for face in case.spec.subject_sides if word in ("any", face)]
    for i, wall in enumerate(case.frame.region.walls):
        if wanted in (None, i) and i not in avoided:
            yield from (_at_wall(wall, face) for face in faces)


def _corners(case: Case) -> Iterator[Site]:
    """The convex corners of the room."""
    walls = case.frame.region.walls
    for i, wall in enumerate(walls):
        last = walls[i - 1]
        if dot(last.along, wall.inward) <= -case.scope["corner"]:
            before = (last.inward, dot(last.inward, wall.start))
            yield _at_wall(wall)._replace(polygon=np.array([wall.start]), before=before)


def _openings(case: Case, openings: Sequence[Door | Window]) -> Iterator[Site]:
    for opening in openings:
        if case.rel.target in (None, opening.id):
            wall = case.frame.region.walls[opening.wall]
            ends = np.array([wall.point(opening.offset), wall.point(opening.offset + opening.width)])
            middle = dot(wall.along, wall.start) + opening.offset + opening.width / 2
            yield _at_wall(wall)._replace(middle=middle, half=opening.width / 2, polygon=ends)


def _windows(case: Case) -> Iterator[Site]:
    return _openings(case, case.frame.windows)


def _doors(case: Case) -> Iterator[Site]:
    return _openings(case, case.frame.doors)


def _either(case: Case) -> Iterator[Site]:
    return _windows(case) if case.spec.target_kind == "window" else _doors(case)


def _door_zones(case: Case) -> Iterator[Site]:
    """What doors need free."""
    doors = case.frame.region.doors
    wanted = [case.rel.target] if isinstance(case.rel.target, str) else doors
    return (Site(polygon=doors[name].polygon) for name in wanted)


def _wall_bodies(case: Case) -> Iterator[Site]:
    """The bodies of the walls, which lie outside of the room."""
    walls = case.frame.region.walls
    return (Site(polygon=np.array(wall.strip(0.0, wall.length, -WALL_THICKNESS, 0.0))) for wall in walls)


def _edges(case: Case) -> Iterator[Site]:
    """The edges of the hull of the target's footprint."""
    import shapely

    footprint = case.frame.footprints[case.frame.index[case.b.id]]
    hull = shapely.MultiPolygon([shapely.Polygon(p) for p in footprint]).convex_hull
    for edge in walls_of(tidy(shapely.get_coordinates(hull)[:-1])):
        normal, half = edge.outward, edge.length / 2
        along = (-normal[1], normal[0])
        yield Site(normal, dot(normal, edge.start), along, dot(along, edge.point(half)), half)


def _middle(case: Case) -> Iterator[Site]:
    """The middle of the room, along x and y."""
    yield Site(origin=case.frame.region.middle)


def _places(case: Case) -> Iterator[Site]:
    """The k-th of the even places, along the first wall and across."""
    walls = case.frame.region.walls
    places = even_places([w.start for w in walls], case.scope["n"])
    if case.scope["k"] < len(places):
        axes = (walls[0].along, walls[0].inward)
        place = places[case.scope["k"]]
        yield Site(axes=axes, origin=(dot(axes[0], place), dot(axes[1], place)))


SITES: dict[str, Callable[[Case], Iterator[Site]]] = {
    "none": _nowhere,
    "faces": _faces,
    "sides": _sides,
    "walls": _walls,
    "corners": _corners,
    "windows": _windows,
    "doors": _doors,
    "openings": _either,
    "door_zones": _door_zones,
    "wall_bodies": _wall_bodies,
    "edges": _edges,
    "middle": _middle,
    "places": _places,
}
"""How the engine finds the sites of a way."""


# ---- measures --------------------------------------------------------------------------------------------------------


class Asked(NamedTuple):
    """A row of a rule at a site: the interval in m or deg, None where any value will do, and where it starts."""

    rule: Rule
    site: Site
    interval: Interval | None
    start: float

    @property
    def ends(self) -> Interval:
        """The interval with finite ends, for the kernels."""
        low, high = self.interval or OPEN
        return max(low, -INF), min(high, INF)

    @property
    def slack(self) -> float:
        """What is allowed beyond the interval of lengths [m]."""
        return -TIGHT if self.rule.strict else SLACK

    @property
    def degrees(self) -> float | None:
        """The most of a symmetric interval of angles."""
        return None if self.interval is None else self.interval[1]

    def face(self) -> str:
        """The face of the subject that is measured."""
        named = self.rule.face
        return self.site.face if named is None else OPPOSITE[self.site.side] if named == "opposite" else named

    def point(self, a: SceneObject) -> Vector:
        """The point of the subject that is measured, in its frame."""
        return (0.0, 0.0) if self.rule.face == "centre" else _face(a, self.face())[0]

    def line(self, point: Vector, normal: Vector, offset: float) -> list[Row]:
        """The row of a coordinate of that point."""
        if self.interval is None:
            return [Row(k.FEATURE_LINE, OPEN, OPEN, point=point, normal=normal, offset=offset)]
        return [line(point, normal, offset, *self.ends, self.slack)]


def _turned(case: Case, asked: Asked) -> list[Row]:
    return [yaw(_bearing(asked.site.normal) + math.pi - _bearing(SIDES[asked.face()]), asked.degrees)]


def _gap(case: Case, asked: Asked) -> list[Row]:
    return asked.line(asked.point(case.a), asked.site.normal, asked.site.level + asked.start)


def _aside(case: Case, asked: Asked) -> list[Row]:
    return asked.line(asked.point(case.a), asked.site.along, asked.site.middle + asked.start)


def _overlap(case: Case, asked: Asked) -> list[Row] | None:
    site, share = asked.site, asked.ends[0]
    point, _, half = _face(case.a, asked.face())
    counted = half if asked.rule.of == "face" else min(half, site.half)
    if 2 * site.half < 2 * counted * share + 4 * TIGHT and asked.rule.of == "face":
        return None  # the wall is too short for it
    across = site.half + half - 2 * share * counted
    return [line(point, site.along, site.middle, -across, across, -TIGHT)]


def _ahead(case: Case, asked: Asked) -> list[Row]:
    return asked.line(asked.point(case.a), asked.site.axes[0], asked.site.origin[0] + asked.start)


def _left(case: Case, asked: Asked) -> list[Row]:
    return asked.line(asked.point(case.a), asked.site.axes[1], asked.site.origin[1] + asked.start)


def _turn(case: Case, asked: Asked) -> list[Row]:
    options = asked.rule.options
    by = math.radians(options.get("by", 0.0) + asked.start)
    return [yaw(by, asked.degrees, math.radians(options.get("modulo", 360.0)))]


def _bearing_of(case: Case, asked: Asked) -> list[Row]:
    aim, hold = _angle(asked.ends[1])
    return [Row(k.FEATURE_BEARING, aim, hold, scale=LEVER)]


def _distance(case: Case, asked: Asked) -> list[Row]:
    low, high = asked.ends
    aim, hold = _span(low, high, asked.slack, inset=0.005)
    if low <= 0:  # overlapping footprints are at distance 0
        aim, hold = (-INF, aim[1]), (-INF, hold[1])
    return [Row(k.FEATURE_DISTANCE, aim, hold, polygon=asked.site.polygon)]


def _box_gap(case: Case, asked: Asked) -> list[Row]:
    normal, level = asked.site.before if asked.rule.of == "before" else (asked.site.normal, asked.site.level)
    aim, hold = _span(*asked.ends, asked.slack)
    return [Row(k.FEATURE_EXTENT, aim, hold, normal=normal, offset=level)]


def _before(case: Case, asked: Asked) -> list[Row]:
    site, share = asked.site, asked.ends[0]
    aim, hold = (-INF, -0.003), (-INF, -TIGHT)
    return [Row(k.FEATURE_WINDOW, aim, hold, (site.half, share), site.along, site.middle)]


def _part_between(case: Case, asked: Asked) -> list[Row]:
    low, high = asked.ends
    return [Row(k.FEATURE_BETWEEN, (low + 0.01, high - 0.01), (low + 1e-4, high - 1e-4))]


def _off_line(case: Case, asked: Asked) -> list[Row]:
    aim, hold = _span(*asked.ends, asked.slack)
    return [Row(k.FEATURE_ASIDE, aim, hold)]


def _spread(case: Case, asked: Asked) -> list[Row]:
    """The angle from the next child around the same target back to this one: children keep the order of their
    relations, so that each has one neighbour to either side."""
    group = case.frame.around[_one(case.rel)]
    if len(group) < 2:
        return []
    aim, hold = _angle(asked.ends[1])
    return [Row(k.FEATURE_SPREAD, aim, hold, offset=-2 * math.pi / (case.scope["n"] or len(group)), scale=LEVER)]


def _height(case: Case, asked: Asked) -> list[Row]:
    if case.spec.target == "none" and case.a.mount == "floor":
        return []  # what stands on the floor does so by construction
    return [height(0.0, *asked.ends, asked.slack)]


def _above(case: Case, asked: Asked) -> list[Row]:
    return [height(case.b.size[2], *asked.ends, asked.slack)]


def _below(case: Case, asked: Asked) -> list[Row]:
    low, high = asked.ends
    return [height(-case.a.size[2], -high, -low, asked.slack)]


def _carried(case: Case, asked: Asked) -> list[Row] | None:
    """A choice of a surface, true by construction or not at all."""
    support = case.a.support
    if support is None or support.object != case.rel.target:
        return None
    surface = next(s for s in case.frame.object(support.object).surfaces if s.name == support.surface)
    return [] if asked.rule.of != "inner" or surface.headroom is not None else None


MEASURED: dict[str, Callable[[Case, Asked], list[Row] | None]] = {
    "turned": _turned,
    "gap": _gap,
    "aside": _aside,
    "overlap": _overlap,
    "ahead": _ahead,
    "left": _left,
    "turn": _turn,
    "bearing": _bearing_of,
    "distance": _distance,
    "box_gap": _box_gap,
    "before": _before,
    "part_between": _part_between,
    "off_line": _off_line,
    "spread": _spread,
    "height": _height,
    "above": _above,
    "below": _below,
    "carried": _carried,
}
"""The rows of each measure; None where it cannot hold at a site."""


# ---- relations -------------------------------------------------------------------------------------------------------


def _one(rel: Relation) -> str:
    assert isinstance(rel.target, str)  # the catalogue's target kind, checked when the scene was built
    return rel.target


def _case(frame: Frame, rel: Relation) -> Case:
    spec, a = CATALOGUE[rel.type], frame.object(rel.subject)
    b = frame.object(_one(rel)) if spec.target_kind == "object" else None
    alone = frame.tied.get((rel.type, b.id), 1) == 1 if b is not None else True
    scope = spec.scope(rel, a.size[0])
    return Case(frame, rel, spec, {**scope, "a": a, "b": b, "alone": alone, "default_gap": "gap" not in rel.params})


def _options(case: Case) -> list[list[Row]]:
    """The options of a relation: each site of each of its ways, or all sites of a way at once."""
    options: list[list[Row]] = []
    for way in case.spec.ways:
        if way.when is not None and not way.when.value(case.scope):
            continue
        found = []
        for site in SITES[way.sites](case):
            scope = {**case.scope, **site.names}
            if way.where is None or way.where.value(scope):
                rows = _rows(case._replace(scope=scope), way, site)
                found += [] if rows is None else [rows]
        options += [[row for rows in found for row in rows]] if way.every else found
    return options


def _rows(case: Case, way: Way, site: Site) -> list[Row] | None:
    """The kernels' rows of a way at a site; None where it cannot hold there."""
    found: list[Row] = []
    for rule in way.rows:
        if not rule.counts(case.scope):
            continue
        made = MEASURED[rule.measure](
            case, Asked(rule, site, rule.interval(case.scope), float(rule.start.value(case.scope)))
        )
        if made is None:
            return None
        if rule.snap is not None and (rule.snap_if is None or rule.snap_if.value(case.scope)):
            unit = DEGREE if MEASURES[rule.measure].unit == "deg" else 1.0
            made = [row.snapped(case.spec, rule.snap, unit) for row in made]
        for row in made:
            _add(found, row)
    return found


def _add(rows: list[Row], row: Row) -> None:
    """Add a row to those of an option: two intervals of one coordinate become one, what asks for nothing goes."""
    if row.is_open and row.exact is None:
        return
    if not row.is_open and row.feature == k.FEATURE_LINE and row.exact is None:
        for i, other in enumerate(rows):
            if (other.feature, other.point, other.normal) == (row.feature, row.point, row.normal) and not other.is_open:
                rows[i] = _both(other, row, row.offset - other.offset)
                return
    rows.append(row)


def _both(row: Row, other: Row, shift: float) -> Row:
    """A row whose intervals are what two rows have in common, the other's being shifted."""
    aim = (max(row.aim[0], other.aim[0] + shift), min(row.aim[1], other.aim[1] + shift))
    hold = (max(row.hold[0], other.hold[0] + shift), min(row.hold[1], other.hold[1] + shift))
    if hold[0] > hold[1]:
        return NEVER
    if aim[0] > aim[1]:
        aim = (0.5 * (hold[0] + hold[1]),) * 2
    return row._replace(aim=aim, hold=hold)


Builder = Callable[[Frame, Relation, Callable], list[list[Row]]]

BUILDERS: dict[str, Builder] = {}
"""The options of relation types that users have defined."""


def _neighbours(frame: Frame, rel: Relation) -> tuple[Relation, Relation]:
    """The around relations before and after one in the circle of its group."""
    group = frame.around[_one(rel)]
    i = next(j for j, other in enumerate(group) if other is rel)
    return group[i - 1], group[(i + 1) % len(group)]


def _spread_rows(frame: Frame, rel: Relation) -> list[Row]:
    """The rows of an around relation that are about its neighbours."""
    case = _case(frame, rel)
    rules = (rule for way in case.spec.ways for rule in way.rows if rule.measure == "spread")
    return [row for r in rules for row in _spread(case, Asked(r, Site(), r.interval(case.scope), 0.0))]


def spread_before(frame: Frame, rel: Relation) -> CompiledRelation | None:
    """The angle to the child before, for an around relation whose neighbour does not vouch for it: because that one is
    soft, or has another count or spread. None where nothing is missing."""
    before, _ = _neighbours(frame, rel)
    rows = _spread_rows(frame, rel)
    same = _spread_rows(frame, before) == rows and (before.hard or not rel.hard)
    if not rows or same:
        return None
    index = frame.index
    weight = rel.weight if rel.hard else SOFT_WEIGHT * rel.weight
    objects = (index[before.subject], index[_one(rel)], index[rel.subject])
    return CompiledRelation(objects, [rows], weight, 2 if rel.hard else 0, rel.hard)


SOFT_WEIGHT = 0.2  # of a hard relation's, times the relation's own weight


def compile_relation(frame: Frame, rel: Relation) -> CompiledRelation:
    """Rows of one relation of the scene."""
    build = BUILDERS.get(rel.type)
    options = _options(_case(frame, rel)) if build is None else build(frame, rel, _values(rel))
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


def _values(rel: Relation) -> Callable[[str], Any]:
    """Reads a relation's numbers: its params, else the catalogue's defaults."""
    return lambda name: CATALOGUE[rel.type].value(rel, name)


def mounting(frame: Frame, obj: int) -> CompiledRelation:
    """What holds a wall-mounted object: its back at some wall, as against_wall has it."""
    a = frame.objects[obj]
    options = _options(_case(frame, Relation(type="against_wall", subject=a.id)))
    hung = a.intent.mounting_height
    if hung is not None:
        # The judge knows no such limit. What hangs too high or too low is no less valid, only ugly.
        middle = 0.5 * (hung[0] + hung[1])
        level = height(0.0, *hung)._replace(exact=Snap(middle, middle, (hung[0] - HUNG, hung[1] + HUNG)))
        options = [[*rows, level] for rows in options]
    return CompiledRelation((obj, -1, -1), options or [[NEVER]], 1.0, 1, True)
