"""Patterns of two colours, which the name of the texture says: "checkered #222222 #f2f0ec"; of prints these are the
ground and what is on it."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache

import numpy as np

from ..noise import cells, field, grid, spread, step
from ..registry import Pattern
from ..relief import Relief, to_linear

Color = tuple[float, float, float]


def name_of(kind: str, first: Color, second: Color) -> str:
    """The name of a texture of two sRGB colours in 0..1."""
    return f"{kind} {_hex(first)} {_hex(second)}"


def mean_of(kind: str, first: Color, second: Color) -> Color:
    """The sRGB colour of a material on which such a texture shows its colours as they are."""
    share = SHARES.get(kind, 0.5)
    both = (1.0 - share) * to_linear(np.array(first)) + share * to_linear(np.array(second))
    shown = np.where(both <= 0.0031308, 12.92 * both, 1.055 * both ** (1 / 2.4) - 0.055)
    return round(float(shown[0]), 4), round(float(shown[1]), 4), round(float(shown[2]), 4)


def colors_of(texture: str) -> tuple[str, Color, Color] | None:
    """Kind and sRGB colours of a texture of this module by its name; None for another."""
    said = _name().fullmatch(texture)
    return None if said is None else (said[1], _rgb(said[2]), _rgb(said[3]))


@cache
def two_colored(name: str) -> Pattern | None:
    """The pattern of such a name; None where it is none."""
    said = colors_of(name)
    if said is None:
        return None
    kind, *colors = said
    first, second = (to_linear(np.array(color)) for color in colors)
    if kind == "checkered":
        return Pattern(name, (1.2, 1.2), _checks(first, second), "stone")
    if kind == "stripes":
        return Pattern(name, (0.6, 0.6), _stripes(first, second))
    side, print_ = PRINTS[kind]
    return Pattern(name, (side, side), _printed(print_, first, second), "fabric")


@cache
def _name() -> re.Pattern[str]:
    kinds = "|".join(re.escape(kind) for kind in ("checkered", "stripes", *PRINTS))
    return re.compile(rf"({kinds}) #([0-9a-f]{{6}}) #([0-9a-f]{{6}})")


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


# ---- prints on cloth: how much of the second colour there is, [n, n] in 0..1 -----------------------------------------


def _printed(print_: Callable[[int], np.ndarray], first: np.ndarray, second: np.ndarray) -> Callable[[int], Relief]:
    """Cloth with a print."""

    def draw(n: int) -> Relief:
        share, fibre = print_(n)[:, :, None], field(n, 957, 0.006, 1.0)
        tint = (1.0 - share) * first + share * second
        return Relief(tint * (1.0 + 0.05 * fibre)[:, :, None], 6e-5 * fibre, np.ones((n, n)))

    return draw


def _gingham(n: int) -> np.ndarray:
    """Bands of 25 mm across each other: white, half and full."""
    u, v = grid(n)
    return 0.5 * ((np.floor(u * 4) % 2) + (np.floor(v * 4) % 2))


def _tartan(n: int) -> np.ndarray:
    """A sett of broad bands and narrow lines, the same along and across."""
    u, v = grid(n)
    edges = np.array([0.0, 0.26, 0.31, 0.36, 0.41, 0.67, 0.72, 0.74, 0.79, 0.82, 0.87, 0.89, 0.94])
    dark = np.array([0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.1, 1.0, 0.0, 0.6, 0.0, 1.0, 1.0])
    band = [dark[np.searchsorted(edges, along, side="right") - 1] for along in (u, v)]
    over = (np.floor(u * n / 3) + np.floor(v * n / 3)) % 2 == 0  # twill: one way is on top, then the other
    return 0.35 * np.where(over, band[0], band[1]) + 0.325 * (band[0] + band[1])


def _leopard(n: int) -> np.ndarray:
    """Broken rings around darker middles."""
    near = cells(n, 961, 9, jitter=0.75)
    at = near.first * 9 + 0.09 * field(n, 962, 0.05)
    broken = field(n, 963, 0.05) > -0.75
    ring = step(0.17, 0.22, at) * (1.0 - step(0.33, 0.38, at)) * broken
    return np.maximum(ring, 0.38 * (1.0 - step(0.17, 0.22, at)))


def _zebra(n: int) -> np.ndarray:
    """Stripes that bend and fork."""
    u, _ = grid(n)
    wave = np.sin(2 * np.pi * 6 * u + 1.9 * field(n, 965, (0.22, 0.45), 2.5))
    return step(-0.18, 0.18, wave)


def _dotted(n: int) -> np.ndarray:
    """Dots in a staggered grid."""
    u, v = grid(n)
    x, y = np.mod(u * 3, 1.0) - 0.5, np.mod(v * 3, 1.0) - 0.5
    return 1.0 - step(0.17, 0.19, np.minimum(np.hypot(x, y), np.hypot(np.abs(x) - 0.5, np.abs(y) - 0.5)))


def _floral(n: int) -> np.ndarray:
    """Blossoms of five petals, and small ones between them."""
    u, v = grid(n)
    found = np.zeros((n, n))
    rng = np.random.default_rng(967)
    for k in range(26):
        x, y = np.mod(np.stack([u, v]) - rng.random(2)[:, None, None] + 0.5, 1.0) - 0.5
        big, turn = (0.085 if k < 9 else 0.03) * rng.uniform(0.8, 1.2), rng.uniform(0.0, 6.28)
        far, angle = np.hypot(x, y) / big, np.arctan2(y, x)
        petals = 0.62 + 0.38 * np.abs(np.cos(2.5 * angle + turn))
        eye = step(0.20, 0.26, far)
        found = np.maximum(found, (1.0 - step(0.92, 1.0, far / petals)) * (0.35 + 0.65 * eye))
    return found


def _camouflage(n: int) -> np.ndarray:
    """Patches in three tones."""
    a, b = field(n, 971, 0.16, 2.5), field(n, 973, 0.16, 2.5)
    return np.where(a > 0.55, 1.0, np.where(b > 0.35, 0.5, 0.0))


def _patchwork(n: int) -> np.ndarray:
    """Patches of 0.1 m, each in a tone of its own, with seams."""
    u, v = grid(n)
    number = np.floor(u * 6) + 6 * np.floor(v * 6)
    x, y = (np.abs(np.mod(along * 6, 1.0) - 0.5) for along in (u, v))
    return np.where(np.maximum(x, y) > 0.475, 0.5, spread(number, 975))


PRINTS: dict[str, tuple[float, Callable[[int], np.ndarray]]] = {
    "gingham": (0.1, _gingham),
    "tartan": (0.3, _tartan),
    "leopard": (0.5, _leopard),
    "zebra": (0.8, _zebra),
    "dotted": (0.3, _dotted),
    "floral": (0.5, _floral),
    "camouflage": (0.8, _camouflage),
    "patchwork": (0.6, _patchwork),
}
"""Side of the pattern [m], and what draws it."""

SHARES = {
    "gingham": 0.5,
    "tartan": 0.33710937500000004,
    "leopard": 0.24671666515452068,
    "zebra": 0.49546265844872994,
    "dotted": 0.20370180580723568,
    "floral": 0.14511717499574928,
    "camouflage": 0.4340667724609375,
    "patchwork": 0.42662129616515004,
}
"""The share of the second colour in each print: what 256 pixels square show on average. Said here, as every start needs
them for the colours of finishes, and drawing all prints for that takes long."""


def _hex(color: Color) -> str:
    return "#" + "".join(f"{round(255 * min(1.0, max(0.0, c))):02x}" for c in color)


def _rgb(text: str) -> Color:
    r, g, b = (int(text[k : k + 2], 16) / 255 for k in (0, 2, 4))
    return r, g, b
