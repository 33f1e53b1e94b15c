"""The engine's compiled relations as choices of linear intervals, for each pair of turns; see `quarter_turns`."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from sceneweaver.kernels import tables as k
from sceneweaver.layout.compile import LayoutProblem
from sceneweaver.layout.rows import CompiledRelation, Row

from .rectangles import Body, Choice, Interval, Wanted, box_of, turn_by

FAR = 1e3  # [m] from where on an interval has no end
INSET = 0.001  # [m] kept from the ends of an interval that the verdict insists on


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
    outline = np.concatenate(room.footprints[index]) @ turn_by(yaw[0]).T
    return _Side(-1, turn_by(-angle) @ room.home[index, :2], yaw, box_of(outline)[None])


def relation_of(
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
    frame = turn_by(b.yaws[tb])
    if row.feature == k.FEATURE_LINE:
        normal = frame @ row.normal
        point = turn_by(a.yaws[ta]) @ row.point
        return [(interval(normal, low, high, row.offset - float(normal @ point)),)]
    if row.feature == k.FEATURE_YAW:
        period = row.normal[0]
        off = (a.yaws[ta] - b.yaws[tb] - row.offset + period / 2) % period - period / 2
        return [()] if row.hold[0] <= off <= row.hold[1] else []
    if row.feature in (k.FEATURE_EXTENT, k.FEATURE_WINDOW):
        normal = turn_by(-angle) @ row.normal
        turned = turn_by(a.yaws[ta]).T @ normal
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
        ahead = turn_by(a.yaws[ta]) @ (1.0, 0.0)
        slope = math.tan(min(row.hold[1], 1.5))
        left = np.array([-ahead[1], ahead[0]])
        # b seen from a: |left . d| <= slope ahead . d with d = p_b - p_a
        return [tuple(interval(side * left + slope * ahead, -math.inf, -0.01) for side in (1.0, -1.0))]
    if row.feature == k.FEATURE_DISTANCE:
        theirs = b.reach[tb] if row.polygon is None else box_of(np.asarray(row.polygon) @ turn_by(-angle).T)
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
