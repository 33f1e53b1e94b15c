"""What `quarter_turns` is made of: bodies as rectangles, what keeps apart, choices of intervals, and their tests."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np


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


def turn_by(angle: float) -> np.ndarray:
    """The matrix [2, 2] of a turn [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]])


def box_of(points: np.ndarray) -> np.ndarray:
    """The rectangle x0, y0, x1, y1 [..., 4] around points [..., V, 2]."""
    return np.concatenate([points.min(axis=-2), points.max(axis=-2)], axis=-1)


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
