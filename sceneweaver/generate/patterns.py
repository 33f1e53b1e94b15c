"""Where the things of an arrangement stand to its first one: rows, grids, circles, backs together.

Each place is (ahead, left, turn) in the frame of the leader, [m, m, deg]; the leader is at (0, 0, 0).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple

ARC = math.radians(150)
"""Angle that a semicircle of seats goes over, seen from its middle."""

LEAST_RADIUS = 0.9
"""Least radius [m] of a circle of things."""


class Spot(NamedTuple):
    """A place in the leader's frame."""

    ahead: float
    left: float
    turn: float = 0.0


class Pitch(NamedTuple):
    """Extents [m] of one thing with what belongs to it, and the gaps between neighbours in a row and between rows."""

    depth: float
    width: float
    beside: float
    between: float


def block(
    rows: int, columns: int, count: int, pitch: Pitch, *, opposed: bool = False, aisle: float = 0.0
) -> list[Spot]:
    """Rows one behind the other, all looking ahead, the middle one of the front row first.

    Args:
        rows, columns: of the block.
        count: things; the last row may have fewer.
        pitch: of one thing.
        opposed: whether rows look at each other by pairs across the gap between them.
        aisle: width [m] of a way through the middle, from front to back; 0: none.
    """
    across, back = pitch.width + pitch.beside, pitch.depth + pitch.between
    found: list[Spot] = []
    for row in range(rows):
        for column in range(columns):
            if len(found) == count:
                break
            left = across * column + (aisle - pitch.beside if aisle and column >= columns / 2 else 0.0)
            if opposed:
                found.append(Spot(back * row, left, 180.0 * (row % 2)))
            else:
                found.append(Spot(-back * row, left, 0.0))
    first = min(columns // 2, len(found) - 1)
    return _about(found, first)


def upright(rows: int, columns: int, width: float, gap: float) -> list[Spot]:
    """Columns beside each other at a wall, row upon row from below."""
    return [Spot(0.0, (width + gap) * column) for _ in range(rows) for column in range(columns)]


def circle(count: int, pitch: Pitch, *, arc: float = 2 * math.pi, radius: float = 0.0) -> list[Spot]:
    """Things around a middle that they look at; over an arc the leader is in its middle.

    ``radius`` [m] is the least distance of their fronts from that middle.
    """
    closed = arc >= 2 * math.pi - 1e-9
    parts = count if closed else max(1, count - 1)
    step = arc / parts
    front = max(radius, LEAST_RADIUS, (pitch.width + pitch.beside) / (2 * math.tan(min(step, math.pi / 2) / 2)))
    around = front + pitch.depth / 2
    found: list[Spot] = []
    for k in range(count):
        angle = step * k if closed else step * k - arc / 2
        found.append(
            Spot(-around * math.cos(angle), -around * math.sin(angle), math.degrees(math.remainder(angle, 2 * math.pi)))
        )
    return _turned_about(found, 0 if closed else count // 2)


def ring(count: int, table: tuple[float, float], depth: float, gap: float) -> list[Spot]:
    """Seats about a table of two sides [m], in its frame, that look at it: opposite each other first, then the ends.

    ``gap`` [m] is between their fronts and the table; below 0 they are pulled up under it.
    """
    ahead, aside = table[0] / 2 + gap + depth / 2, table[1] / 2 + gap + depth / 2
    sides = [Spot(ahead, 0.0, 180.0), Spot(-ahead, 0.0, 0.0), Spot(0.0, aside, -90.0), Spot(0.0, -aside, 90.0)]
    if count <= len(sides):
        return sides[:count]
    around = max(math.hypot(*table) / 2 + gap + depth / 2, count * 0.7 / (2 * math.pi))
    found = []
    for k in range(count):
        angle = 2 * math.pi * k / count
        turn = math.degrees(math.remainder(angle + math.pi, 2 * math.pi))
        found.append(Spot(around * math.cos(angle), around * math.sin(angle), turn))
    return found


def u_shape(count: int, pitch: Pitch) -> list[Spot]:
    """Three sides about a floor open ahead, all looking inward."""
    side = count // 3
    base = count - 2 * side
    across = pitch.width + pitch.beside
    found = [Spot(0.0, across * (k - (base - 1) / 2)) for k in range(base)]
    out = (base - 1) / 2 * across + pitch.width / 2 + pitch.depth / 2
    start = pitch.depth / 2 + pitch.width / 2 + pitch.beside
    for k in range(side):
        found.append(Spot(start + across * k, out, -90.0))
        found.append(Spot(start + across * k, -out, 90.0))
    return _about(found, base // 2)


def back_to_back(count: int, pitch: Pitch) -> list[Spot]:
    """Pairs with their backs together, pair beside pair."""
    found: list[Spot] = []
    for k in range(count):
        left = (pitch.width + pitch.beside) * (k // 2)
        found.append(Spot(-pitch.depth - 0.01, left, 180.0) if k % 2 else Spot(0.0, left))
    return found


def double_rows(rows: int, columns: int, count: int, pitch: Pitch) -> list[Spot]:
    """Rows with their backs together by twos, with a way between the double rows."""
    across, found = pitch.width + pitch.beside, list[Spot]()
    for row in range(rows):
        ahead = -(row // 2) * (2 * pitch.depth + pitch.between) - (row % 2) * (pitch.depth + 0.01)
        found += [Spot(ahead, across * k, 180.0 * (row % 2)) for k in range(columns) if row * columns + k < count]
    return found


def end_to_end(sizes: Sequence[tuple[float, float]], gap: float) -> list[Spot]:
    """Things of some depths and widths [m] in a line along their longer sides, all looking the same way."""
    found, at = [Spot(0.0, 0.0)], 0.0
    for (d, w), (e, v) in itertools.pairwise(sizes):
        if sizes[0][0] >= sizes[0][1]:
            at -= (d + e) / 2 + gap
            found.append(Spot(at, 0.0))
        else:
            at += (w + v) / 2 + gap
            found.append(Spot((e - sizes[0][0]) / 2, at))
    return found


def side_by_side(sizes: Sequence[tuple[float, float]], gap: float) -> list[Spot]:
    """Things of some depths and widths [m] in a row with their backs in line."""
    found, at = [Spot(0.0, 0.0)], 0.0
    for (_, w), (e, v) in itertools.pairwise(sizes):
        at += (w + v) / 2 + gap
        found.append(Spot((e - sizes[0][0]) / 2, at))
    return found


def right_angle(
    one: Sequence[tuple[float, float]],
    other: Sequence[tuple[float, float]],
    beside: float,
    corner: float,
    *,
    open_: bool,
) -> list[Spot]:
    """Two rows of things of some depths and widths [m] at right angles, as along the two walls of a corner.

    The second is at the left end of the first and looks to the right. Open corners leave ``corner`` [m] between the end
    of the first row and the fronts of the second, which begins level with the backs of the first; else the second
    begins so far before the fronts of the first.
    """
    first = side_by_side(one, beside)
    end = max(spot.left + width / 2 for spot, (_, width) in zip(first, one, strict=True))
    if open_:
        end += corner + max(depth for depth, _ in other)
        ahead = -one[0][0] / 2
    else:
        ahead = max(spot.ahead + depth / 2 for spot, (depth, _) in zip(first, one, strict=True)) + corner
    found = list(first)
    for depth, width in other:
        found.append(Spot(ahead + width / 2, end - depth / 2, -90.0))
        ahead += width + beside
    return found


def _about(spots: Sequence[Spot], first: int) -> list[Spot]:
    """Spots of which all look ahead or by quarters, about one of them, which comes first."""
    base = spots[first]
    moved = [Spot(s.ahead - base.ahead, s.left - base.left, s.turn) for s in spots]
    return [moved[first], *moved[:first], *moved[first + 1 :]]


def within(frame: Spot, spot: Spot) -> Spot:
    """A spot that is given in the frame of another, in the frame of that one."""
    c, s = math.cos(math.radians(frame.turn)), math.sin(math.radians(frame.turn))
    ahead, left = frame.ahead + c * spot.ahead - s * spot.left, frame.left + s * spot.ahead + c * spot.left
    return Spot(ahead, left, _half_turn(frame.turn + spot.turn))


def seen_from(base: Spot, spot: Spot) -> Spot:
    """A spot in the frame of another of the same frame."""
    c, s = math.cos(math.radians(base.turn)), math.sin(math.radians(base.turn))
    dx, dy = spot.ahead - base.ahead, spot.left - base.left
    return Spot(c * dx + s * dy, c * dy - s * dx, _half_turn(spot.turn - base.turn))


def _half_turn(turn: float) -> float:
    """An angle [deg] within half a turn."""
    return math.degrees(math.remainder(math.radians(turn), 2 * math.pi))


def _turned_about(spots: Sequence[Spot], first: int) -> list[Spot]:
    """Spots in the frame of one of them, which comes first."""
    found = [seen_from(spots[first], spot) for spot in spots]
    return [found[first], *found[:first], *found[first + 1 :]]


def extent(spots: Sequence[Spot], depth: float, width: float) -> tuple[float, float]:
    """Sides [m] of the box about things at some spots, along the leader's front and across."""
    return extent_of([(spot, depth, width) for spot in spots])


def extent_of(things: Sequence[tuple[Spot, float, float]]) -> tuple[float, float]:
    """The same of things of several depths and widths [m]."""
    xs, ys = list[tuple[float, float]](), list[tuple[float, float]]()
    for spot, depth, width in things:
        c, t = abs(math.cos(math.radians(spot.turn))), abs(math.sin(math.radians(spot.turn)))
        xs.append((spot.ahead, (c * depth + t * width) / 2))
        ys.append((spot.left, (c * width + t * depth) / 2))
    sides = [max(at + half for at, half in values) - min(at - half for at, half in values) for values in (xs, ys)]
    return sides[0], sides[1]
