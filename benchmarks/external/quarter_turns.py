"""A layout problem as rectangles at quarter turns and linear conditions: what integer programs and grids see.

Made from the engine's compiled scene, so that rivals know what the engine knows, as far as it can be said this way:

- a body is the bounding rectangles of its collision parts (and of what it carries) at four yaws, square to the longest
  wall; an object whose yaw is not free has its own. Parts that share no height do not meet. Heights stay as they are;
- the hull of the room and the sides of zones count exactly, pockets of the outline and doors as rectangles;
- a relation is a choice of linear intervals, one for each of its options, pair of turns, and side of a distance.
  Distances beyond a corner are cut to 1/sqrt(2) along both axes; angles that are free within some degrees to their
  middle. Positions between or around others (`FEATURE_BETWEEN`, `FEATURE_ASIDE`, `FEATURE_SPREAD`) and relations that
  users define are left out.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.geometry.se2 import relative
from sceneweaver.kernels import tables as k
from sceneweaver.layout import Problem
from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.layout.rows import CompiledRelation, Row

FAR = 1e3  # [m] from where on an interval has no end
INSET = 0.001  # [m] kept from the ends of an interval that the verdict insists on


class Body(NamedTuple):
    """What may move: its index, the yaws [T] that it may take, and rectangles (x0, y0, x1, y1) from its pose at each.

    ``solids`` [P, T, 4] with heights ``solid_z`` [P, 2], ``zones`` [Z, T, 4] with ``zone_z``; ``corners`` [T, V, 2] are
    those of its parts, ``reach`` [T, 4] the rectangle around its own footprint.
    """

    index: int
    yaws: np.ndarray
    solids: np.ndarray
    solid_z: np.ndarray
    zones: np.ndarray
    zone_z: np.ndarray
    corners: np.ndarray
    reach: np.ndarray


class Apart(NamedTuple):
    """Rectangles that must not overlap: of body ``a`` by turn [T, 4], and of ``b`` or (-1) one that stands still."""

    a: int
    boxes_a: np.ndarray
    b: int
    boxes_b: np.ndarray


class Interval(NamedTuple):
    """``low <= normal . (p_a - p_b) <= high`` [m]; b = -1: the origin."""

    a: int
    b: int
    normal: tuple[float, float]
    low: float
    high: float


class Choice(NamedTuple):
    """One way in which a relation holds: turns of bodies, (body, those it may have), and intervals."""

    turns: tuple[tuple[int, frozenset[int]], ...]
    intervals: tuple[Interval, ...]


class Wanted(NamedTuple):
    """A relation: whether it is hard, its weight, and its choices; ``objects`` are bodies."""

    hard: bool
    weight: float
    bodies: tuple[int, ...]
    choices: tuple[Choice, ...]


@dataclass
class QuarterTurns:
    """A scene in the frame of its longest wall, turned by ``angle``. Bodies are numbered as in ``bodies``.

    Attributes:
        planes: [K, 3] as (n, c) with n . x >= c inside of the room's hull.
        box: of the room, x0, y0, x1, y1 [m].
        left_out: how many hard relations cannot be said.
    """

    angle: float
    bodies: list[Body]
    planes: np.ndarray
    box: tuple[float, float, float, float]
    apart: list[Apart]
    relations: list[Wanted]
    left_out: int
    names: dict[str, int] = field(default_factory=dict)  # of bodies, by id of the object
    points: dict[str, np.ndarray] = field(default_factory=dict)  # middles of what stands still, doors and windows

    def bounds(self, body: int, turn: int) -> np.ndarray:
        """Levels [K] with n . p >= level for the body's pose at a turn."""
        return self.planes[:, 2] - (self.bodies[body].corners[turn] @ self.planes[:, :2].T).min(axis=0)

    def spot(self, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Positions [B, n, 2] and nearest turns [B, n] of the bodies in poses [B, N, 4]."""
        index = [body.index for body in self.bodies]
        xy = poses[:, index, :2] @ _turn(-self.angle).T
        yaw = poses[:, index, 3] - self.angle
        turns = [np.abs(wrap_angle(yaw[:, i, None] - b.yaws)).argmin(axis=1) for i, b in enumerate(self.bodies)]
        return xy, np.array(turns, dtype=int).reshape(len(self.bodies), len(poses)).T

    def placed(self, poses: np.ndarray, xy: np.ndarray, turns: np.ndarray) -> np.ndarray:
        """Poses [B, N, 4] with the bodies at positions [B, n, 2] and turns [B, n]."""
        found = np.array(poses, dtype=np.float64)
        index = [body.index for body in self.bodies]
        found[:, index, :2] = xy @ _turn(self.angle).T
        yaws = [body.yaws[turns[:, i]] for i, body in enumerate(self.bodies)]
        found[:, index, 3] = wrap_angle(np.array(yaws).reshape(len(index), -1).T + self.angle)
        return found


def quarter_turns(problem: Problem, given: np.ndarray | None = None) -> QuarterTurns:
    """The view of a problem of one scene, with what is carried as it stands in a layout ``given`` [N, 4].

    Without one what is carried does not count. Where nothing is carried the view is made once.
    """
    if given is not None and (problem.roots[0] != np.arange(problem.objects)).any():
        return _view(problem, given)
    if problem not in _VIEWS:
        _VIEWS[problem] = _view(problem, None)
    return _VIEWS[problem]


_VIEWS: WeakKeyDictionary[Problem, QuarterTurns] = WeakKeyDictionary()


def _turn(angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]])


def _box(points: np.ndarray) -> np.ndarray:
    return np.concatenate([points.min(axis=-2), points.max(axis=-2)], axis=-1)


def _view(problem: Problem, given: np.ndarray | None) -> QuarterTurns:
    room, scene = compile_scene(problem.scenes[0]).room, problem.scenes[0]
    walls = room.region.walls
    along = max(walls, key=lambda wall: wall.length).along
    angle = math.atan2(along[1], along[0]) % (math.pi / 2)
    back = _turn(-angle)
    movable = [i for i in range(room.size) if problem.free[0, i, :2].all() and room.roots[i] == i]
    number = {index: i for i, index in enumerate(movable)}
    bodies = [_body(room, index, bool(problem.free[0, index, 3]), angle, given) for index in movable]
    planes = np.array([(*(back @ row[:2]), row[2]) for row in room.region.planes])
    box = _box(np.array([wall.start for wall in walls]) @ back.T)
    apart = [*_between(room, bodies), *_still(room, bodies, number, back)]
    said, left_out = [], 0
    for relation in room.relations:
        if relation.weight <= 0 and not relation.fault:
            continue
        wanted = _relation(room, relation, bodies, number, angle)
        left_out += wanted is None and relation.fault != 0
        said += [] if wanted is None or not wanted.choices else [wanted]
    view = QuarterTurns(
        angle, bodies, planes, (float(box[0]), float(box[1]), float(box[2]), float(box[3])), apart, said, left_out
    )
    view.names = {room.ids[index]: i for index, i in number.items()}
    for i, name in enumerate(room.ids):
        if i not in number:
            view.points[name] = back @ room.home[i, :2]
    for opening in scene.room.openings:
        wall = walls[opening.wall]
        view.points[opening.id] = back @ np.array(wall.point(opening.offset + opening.width / 2))
    return view


def _body(room: LayoutProblem, index: int, turns: bool, angle: float, given: np.ndarray | None) -> Body:
    base = 0.0 if turns else room.home[index, 3] - angle
    yaws = base + np.arange(4 if turns else 1) * math.pi / 2
    frames = np.stack([_turn(yaw) for yaw in yaws])
    parts: dict[str, list[tuple[np.ndarray, np.ndarray]]] = {"solids": [], "zones": []}
    for j in np.flatnonzero(room.roots == index):
        if j != index and given is None:
            continue
        away = relative(given[j], given[index]) if given is not None else np.zeros(4)
        height = room.home[index, 2] if given is None else given[j, 2]
        for kind, found in parts.items():
            for prism in getattr(room, kind)[j]:
                found.append((prism.polygon @ _turn(away[3]).T + away[:2], np.array(prism.z) + height))
    boxes, heights = {}, {}
    for kind, found in parts.items():
        turned = [[_box(polygon @ frame.T) for frame in frames] for polygon, _ in found]
        boxes[kind] = np.array(turned).reshape(-1, len(yaws), 4)
        heights[kind] = np.array([z for _, z in found]).reshape(-1, 2)
    corners = np.concatenate([polygon for polygon, _ in parts["solids"]])
    outline = np.concatenate(room.footprints[index])
    return Body(
        index,
        yaws,
        boxes["solids"],
        heights["solids"],
        boxes["zones"],
        heights["zones"],
        np.stack([corners @ frame.T for frame in frames]),
        np.stack([_box(outline @ frame.T) for frame in frames]),
    )


def _meet(z: np.ndarray, other: np.ndarray) -> bool:
    return min(z[1], other[1]) - max(z[0], other[0]) > 1e-3


def _between(room: LayoutProblem, bodies: list[Body]) -> Iterator[Apart]:
    """What two bodies have to keep free of each other."""
    for i, a in enumerate(bodies):
        for j in range(i + 1, len(bodies)):
            b, flags = bodies[j], int(room.flags[a.index, bodies[j].index])
            kinds = [
                (k.PAIR_COLLIDE, a.solids, a.solid_z, b.solids, b.solid_z),
                (k.PAIR_ZONE_OF_FIRST, a.zones, a.zone_z, b.solids, b.solid_z),
                (k.PAIR_ZONE_OF_SECOND, a.solids, a.solid_z, b.zones, b.zone_z),
            ]
            for bit, ours, our_z, theirs, their_z in kinds:
                if flags & bit:
                    pairs = [(p, q) for p in range(len(ours)) for q in range(len(theirs))]
                    yield from (Apart(i, ours[p], j, theirs[q]) for p, q in pairs if _meet(our_z[p], their_z[q]))


def _still(room: LayoutProblem, bodies: list[Body], number: dict[int, int], back: np.ndarray) -> Iterator[Apart]:
    """What bodies have to keep free of pockets, doors, and objects that do not move."""
    region = room.region
    walls = [(prism, "wall") for prism in region.solids] + [(prism, "opening") for prism in region.openings]
    for i, a in enumerate(bodies):
        for prism, kind in walls:
            if kind == "opening" and not room.clear[a.index]:
                continue
            box = _box(prism.polygon @ back.T)[None]
            for ours, z in zip(a.solids, a.solid_z, strict=True):
                if _meet(z, np.array(prism.z)):
                    yield Apart(i, ours, -1, box)
        for j in range(room.size):
            if int(room.roots[j]) in number:
                continue
            flags, frame = int(room.flags[a.index, j]), back @ _turn(room.home[j, 3])
            for bit, ours, our_z, theirs in (
                (k.PAIR_COLLIDE, a.solids, a.solid_z, room.solids[j]),
                (k.PAIR_ZONE_OF_FIRST, a.zones, a.zone_z, room.solids[j]),
                (k.PAIR_ZONE_OF_SECOND, a.solids, a.solid_z, room.zones[j]),
            ):
                for prism in theirs if flags & bit else ():
                    box = _box(prism.polygon @ frame.T + back @ room.home[j, :2])[None]
                    for mine, z in zip(ours, our_z, strict=True):
                        if _meet(z, np.array(prism.z) + room.home[j, 2]):
                            yield Apart(i, mine, -1, box)


class _Side(NamedTuple):
    """A relation's object: its body (-1: it stands still at ``at``), its turns, frames and outlines by turn."""

    body: int
    at: np.ndarray
    yaws: np.ndarray
    reach: np.ndarray


def _side(room: LayoutProblem, index: int, bodies: list[Body], number: dict[int, int], angle: float) -> _Side:
    if index < 0:
        return _Side(-1, np.zeros(2), np.array([-angle]), np.zeros((1, 4)))
    if index in number:
        body = bodies[number[index]]
        return _Side(number[index], np.zeros(2), body.yaws, body.reach)
    yaw = np.array([room.home[index, 3] - angle])
    outline = np.concatenate(room.footprints[index]) @ _turn(yaw[0]).T
    return _Side(-1, _turn(-angle) @ room.home[index, :2], yaw, _box(outline)[None])


def _relation(
    room: LayoutProblem, relation: CompiledRelation, bodies: list[Body], number: dict[int, int], angle: float
) -> Wanted | None:
    """None where it cannot be said, or where nothing in it moves."""
    a, b = (_side(room, index, bodies, number, angle) for index in relation.objects[:2])
    moving = tuple(side.body for side in (a, b) if side.body >= 0)
    # what is carried has no place of its own here
    if not moving or any(i >= 0 and room.roots[i] != i for i in relation.objects):
        return None
    sizes = room.sizes[relation.objects[0]]
    found: dict[tuple, dict[int, set[int]]] = defaultdict(lambda: defaultdict(set))
    known = False
    for option in relation.options:
        for tb in range(len(b.yaws)):
            for ta in range(len(a.yaws)):
                ways: list[tuple[Interval, ...]] | None = [()]
                for row in option:
                    more = _said(row, a, b, ta, tb, sizes, angle, room, relation)
                    if more is None:
                        ways = None
                        break
                    ways = [(*one, *extra) for one in ways for extra in more]
                if ways is None:
                    continue
                known = True
                for way in ways:
                    found[way][tb].add(ta)
    if not known:
        return None
    choices = []
    for way, by_turn in found.items():
        merged: dict[frozenset[int], set[int]] = defaultdict(set)
        for tb, own in by_turn.items():
            merged[frozenset(own)].add(tb)
        for own, others in merged.items():
            turns = [(a.body, own)] if a.body >= 0 and len(own) < len(a.yaws) else []
            turns += [(b.body, frozenset(others))] if b.body >= 0 and len(others) < len(b.yaws) else []
            choices.append(Choice(tuple(turns), way))
    return Wanted(relation.fault != 0, float(relation.weight), moving, tuple(choices))


def _inset(low: float, high: float) -> tuple[float, float]:
    by = min(INSET, 0.25 * (high - low))
    return low + by if low > -FAR else -math.inf, high - by if high < FAR else math.inf


def _said(
    row: Row,
    a: _Side,
    b: _Side,
    ta: int,
    tb: int,
    size: np.ndarray,
    angle: float,
    room: LayoutProblem,
    relation: CompiledRelation,
) -> list[tuple[Interval, ...]] | None:
    """A row at two turns as ways of intervals, any of which will do; [] if none holds; None if it cannot be said."""

    def interval(normal: np.ndarray, low: float, high: float, by: float = 0.0) -> Interval:
        level = by + float(normal @ (b.at if b.body >= 0 or a.body >= 0 else 0))
        if a.body < 0:  # the subject stands still: turn the difference round
            level = float(normal @ a.at) - by
            return Interval(b.body, -1, (round(normal[0], 9), round(normal[1], 9)), level - high, level - low)
        return Interval(a.body, b.body, (round(normal[0], 9), round(normal[1], 9)), low + level, high + level)

    low, high = _inset(*row.hold)
    frame = _turn(b.yaws[tb])
    if row.feature == k.FEATURE_LINE:
        normal = frame @ row.normal
        point = _turn(a.yaws[ta]) @ row.point
        return [(interval(normal, low, high, row.offset - float(normal @ point)),)]
    if row.feature == k.FEATURE_YAW:
        period = row.normal[0]
        off = (a.yaws[ta] - b.yaws[tb] - row.offset + period / 2) % period - period / 2
        return [()] if row.hold[0] <= off <= row.hold[1] else []
    if row.feature in (k.FEATURE_EXTENT, k.FEATURE_WINDOW):
        normal = _turn(-angle) @ row.normal
        turned = _turn(a.yaws[ta]).T @ normal
        half = 0.5 * float(np.abs(turned) @ size[:2])
        if row.feature == k.FEATURE_EXTENT:
            return [(interval(normal, low, high, row.offset + half),)]
        width, share = row.point
        most = half + width - 2 * share * min(half, width) + row.hold[1]
        return [(interval(normal, -most, most, row.offset),)]
    if row.feature == k.FEATURE_HEIGHT:
        over = room.home[relation.objects[1], 2] if relation.objects[1] >= 0 else 0.0
        return [()] if row.hold[0] <= room.home[relation.objects[0], 2] - over - row.offset <= row.hold[1] else []
    if row.feature == k.FEATURE_CONSTANT:
        return [()] if row.hold[0] <= row.offset <= row.hold[1] else []
    if row.feature == k.FEATURE_BEARING:
        ahead = _turn(a.yaws[ta]) @ (1.0, 0.0)
        slope = math.tan(min(row.hold[1], 1.5))
        left = np.array([-ahead[1], ahead[0]])
        # b seen from a: |left . d| <= slope ahead . d with d = p_b - p_a
        return [tuple(interval(side * left + slope * ahead, -math.inf, -0.01) for side in (1.0, -1.0))]
    if row.feature == k.FEATURE_DISTANCE:
        theirs = b.reach[tb] if row.polygon is None else _box(np.asarray(row.polygon) @ _turn(-angle).T)
        return list(_distances(interval, a.reach[ta], theirs, low, high))
    return None


def _distances(interval, ours: np.ndarray, theirs: np.ndarray, low: float, high: float) -> Iterator[tuple]:
    """A distance of two rectangles in an interval: sides on which it is kept, and reaches that it does not exceed."""
    x, y = np.array([1.0, 0.0]), np.array([0.0, 1.0])
    first, last = theirs[:2] - ours[2:], theirs[2:] - ours[:2]  # between them, along an axis, rectangles touch
    nears = [((high, high),)] if math.isinf(high) else [((high, 0.0),), ((0.0, high),), ((high / 2**0.5,) * 2,)]
    for ((by_x, by_y),) in nears:
        within = ()
        if not math.isinf(high):
            within = (
                interval(x, first[0] - by_x, last[0] + by_x),
                interval(y, first[1] - by_y, last[1] + by_y),
            )
        if low <= 0:
            yield within
            continue
        for axis, d in ((x, 0), (y, 1)):
            yield (*within, interval(axis, -math.inf, first[d] - low))
            yield (*within, interval(axis, last[d] + low, math.inf))


def holds(choice: Choice, xy: np.ndarray, turns: np.ndarray, slack: float = 1e-6) -> np.ndarray:
    """Whether a choice holds [B] at positions [B, n, 2] and turns [B, n]."""
    good = np.ones(len(xy), dtype=bool)
    for body, allowed in choice.turns:
        good &= np.isin(turns[:, body], list(allowed))
    for each in choice.intervals:
        d = xy[:, each.a] - (xy[:, each.b] if each.b >= 0 else 0.0)
        value = d @ np.array(each.normal)
        good &= (value >= each.low - slack) & (value <= each.high + slack)
    return good


def overlapping(pairs: Sequence[Apart], xy: np.ndarray, turns: np.ndarray, slack: float = 1e-6) -> np.ndarray:
    """Which of some pairs [B, P] overlap at positions [B, n, 2] and turns [B, n]."""
    found = np.zeros((len(xy), len(pairs)), dtype=bool)
    for p, pair in enumerate(pairs):
        a = pair.boxes_a[turns[:, pair.a]].reshape(-1, 2, 2) + xy[:, pair.a, None]
        b = pair.boxes_b if pair.b < 0 else pair.boxes_b[turns[:, pair.b]] + np.tile(xy[:, pair.b], 2)
        b = b.reshape(-1, 2, 2)
        found[:, p] = ((a[:, 1] - b[:, 0] > slack) & (b[:, 1] - a[:, 0] > slack)).all(axis=1)
    return found
