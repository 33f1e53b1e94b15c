"""Where the treads of a stair lie: flights and landings from its few numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import quote

from .parts import Stair

_SLACK = 2e-3
"""How far [m] a flight may reach over the footprint: rounding of a going."""


@dataclass(frozen=True, eq=False)
class Tread:
    """A tread or landing: its plan [4, 2], counter-clockwise, and its top as a number of risers above the floor."""

    plan: np.ndarray
    number: int


def treads(stair: Stair) -> list[Tread]:
    """The treads of a stair from below; the last riser leads to the upper floor, which is no tread.

    Flights lie at the edges of the footprint. An ``l`` turns at a square landing to the side on which the footprint
    goes on; the second flight of a ``u`` comes back on the left of the first, from a landing over the whole width.

    Raises:
        InputError: when the flights are longer than the footprint.
    """
    up = np.asarray(stair.up, dtype=float)
    turn = np.array([up, (-up[1], up[0])])  # rows: along the first flight, and to its left
    local = np.asarray(stair.outline) @ turn.T
    (low, right), (high, left) = local.min(axis=0), local.max(axis=0)
    w, g, count = stair.width, stair.going, stair.risers - 1
    boxes: list[tuple[float, float, float, float]] = []  # from and to along the flight, from and to leftwards
    if stair.shape == "straight":
        middle = (right + left - w) / 2
        boxes = [(low + k * g, low + (k + 1) * g, middle, middle + w) for k in range(count)]
    elif stair.shape == "u":
        first = min(int((high - low - w + _SLACK) / g), count // 2)
        boxes = [(low + k * g, low + (k + 1) * g, right, right + w) for k in range(first)]
        end = low + first * g
        boxes.append((end, end + w, right, left))
        boxes += [(end - (k + 1) * g, end - k * g, left - w, left) for k in range(count - first - 1)]
    else:
        # The first flight lies where the footprint reaches farthest back; the second leaves it to the other side.
        back = local[local[:, 0] < low + _SLACK, 1]
        leftwards = abs(back.min() - right) <= abs(left - back.max())
        near = right if leftwards else left - w
        first = min(int((high - low - w + _SLACK) / g), count - 1)
        boxes = [(low + k * g, low + (k + 1) * g, near, near + w) for k in range(first)]
        end = low + first * g
        boxes.append((end, end + w, near, near + w))
        for k in range(count - first - 1):
            a, b = (near + w + k * g, near + w + (k + 1) * g) if leftwards else (near - (k + 1) * g, near - k * g)
            boxes.append((end, end + w, a, b))
    found = []
    for number, (u0, u1, v0, v1) in enumerate(boxes, 1):
        if u0 < low - _SLACK or u1 > high + _SLACK or v0 < right - _SLACK or v1 > left + _SLACK:
            raise InputError(
                f"stair {quote(stair.id)}: {stair.risers} risers with a going of {g:g} m do not fit its outline; give "
                "it a larger outline, a smaller going, or fewer risers"
            )
        found.append(Tread(np.array([(u0, v0), (u1, v0), (u1, v1), (u0, v1)]) @ turn, number))
    return found
