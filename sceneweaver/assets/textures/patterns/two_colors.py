"""Checks and stripes of two colours, which the name of the texture says: "checkered #222222 #f2f0ec"."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

import numpy as np

from ..noise import field, grid
from ..registry import Pattern
from ..relief import Relief, to_linear

_NAME = re.compile(r"(checkered|stripes) #([0-9a-f]{6}) #([0-9a-f]{6})")

Color = tuple[float, float, float]


def name_of(kind: str, first: Color, second: Color) -> str:
    """The name of a texture of two sRGB colours in 0..1."""
    return f"{kind} {_hex(first)} {_hex(second)}"


def mean_of(first: Color, second: Color) -> Color:
    """The sRGB colour of a material on which such a texture shows its colours as they are."""
    both = 0.5 * (to_linear(np.array(first)) + to_linear(np.array(second)))
    shown = np.where(both <= 0.0031308, 12.92 * both, 1.055 * both ** (1 / 2.4) - 0.055)
    return round(float(shown[0]), 4), round(float(shown[1]), 4), round(float(shown[2]), 4)


@cache
def two_colored(name: str) -> Pattern | None:
    """The pattern of such a name; None where it is none."""
    said = _NAME.fullmatch(name)
    if said is None:
        return None
    first, second = (to_linear(np.array(_rgb(said[k]))) for k in (2, 3))
    if said[1] == "checkered":
        return Pattern(name, (1.2, 1.2), _checks(first, second), "stone")
    return Pattern(name, (0.6, 0.6), _stripes(first, second))


def _checks(first: np.ndarray, second: np.ndarray) -> Callable[[int], Relief]:
    """Tiles of 0.3 m in turn, with joints of 3 mm."""

    def draw(n: int) -> Relief:
        u, v = grid(n)
        i, j = np.floor(u * 4), np.floor(v * 4)
        x, y = (u * 4 - i) * 0.3, (v * 4 - j) * 0.3
        edge = np.minimum(np.minimum(x, 0.3 - x), np.minimum(y, 0.3 - y))
        joint = edge < 0.0018
        even = ((i + j) % 2 == 0)[:, :, None]
        tint = np.where(even, first, second) * (1.0 + 0.015 * field(n, 951, 0.1))[:, :, None]
        tint = np.where(joint[:, :, None], 0.6 * (first + second) / 2 + 0.05, tint)
        return Relief(tint, np.where(joint, 0.0, 6e-4), np.where(joint, 2.2, 1.0))

    return draw


def _stripes(first: np.ndarray, second: np.ndarray) -> Callable[[int], Relief]:
    """Stripes of 0.1 m in turn."""

    def draw(n: int) -> Relief:
        band = (np.floor(grid(n)[0] * 6) % 2 == 0)[:, :, None]
        fibre = field(n, 955, 0.004, 1.0)
        return Relief(np.where(band, first, second) * (1.0 + 0.01 * fibre)[:, :, None], 8e-6 * fibre, np.ones((n, n)))

    return draw


def _hex(color: Color) -> str:
    return "#" + "".join(f"{round(255 * min(1.0, max(0.0, c))):02x}" for c in color)


def _rgb(text: str) -> Color:
    r, g, b = (int(text[k : k + 2], 16) / 255 for k in (0, 2, 4))
    return r, g, b
