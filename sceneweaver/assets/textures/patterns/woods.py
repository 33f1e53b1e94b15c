"""Woods: growth rings as level lines of a field that is long along the grain, with pores, fibres and rays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..noise import blurred, field, grid, spread, step
from ..registry import Pattern, add, pattern
from ..relief import Relief


@dataclass(frozen=True)
class Wood:
    """How a wood looks: ``rings`` over the height of the maps, ``figure`` how far they swing (arches), ``wiggle`` how
    much they tremble, ``late`` how dark late wood is and ``sharp`` how thin, ``pore`` how dark pores are and ``porous``
    the share of them that keeps to early wood, ``ray`` how bright rays are, ``tone`` how much broad bands differ.
    ``dark`` is the linear colour of late wood and pores as a share of that of early wood."""

    seed: int
    rings: int
    figure: float = 1.0
    wiggle: float = 0.25
    late: float = 0.5
    sharp: float = 3.0
    pore: float = 0.3
    porous: float = 0.5
    ray: float = 0.0
    tone: float = 0.06
    dark: tuple[float, float, float] = (0.62, 0.52, 0.42)


_WOODS = {
    "oak": Wood(11, 22, 1.5, 0.22, 0.72, 2.6, 0.80, 0.9, 0.14),
    "walnut": Wood(23, 18, 1.5, 0.3, 0.75, 2.2, 0.5, 0.25, 0.0, 0.12, (0.50, 0.44, 0.40)),
    "pine": Wood(31, 18, 1.3, 0.14, 0.75, 3.4, 0.0, 0.0, 0.0, 0.05, (0.70, 0.48, 0.28)),
    "beech": Wood(43, 34, 0.7, 0.2, 0.13, 2.0, 0.10, 0.0, -0.20, 0.04, (0.66, 0.50, 0.40)),
    "birch": Wood(47, 16, 1.6, 0.3, 0.22, 1.6, 0.06, 0.0, 0.05, 0.05, (0.74, 0.60, 0.46)),
    "cherry": Wood(59, 20, 1.4, 0.25, 0.36, 1.8, 0.16, 0.1, 0.06, 0.07, (0.56, 0.44, 0.38)),
    "mahogany": Wood(53, 26, 0.8, 0.3, 0.30, 1.6, 0.55, 0.1, 0.10, 0.13, (0.52, 0.40, 0.36)),
    "teak": Wood(61, 20, 1.2, 0.3, 0.6, 2.4, 0.5, 0.7, 0.0, 0.10, (0.50, 0.42, 0.34)),
    "ash": Wood(67, 18, 1.6, 0.2, 0.85, 2.6, 0.5, 0.95, 0.0, 0.04, (0.66, 0.54, 0.42)),
    "wenge": Wood(71, 60, 0.4, 0.3, 0.75, 1.2, 0.35, 0.3, 0.0, 0.06, (0.38, 0.34, 0.32)),
}
_SIZE = (1.6, 0.4)


def _drawn(n: int, wood: Wood) -> Relief:
    seed, (_, v) = wood.seed * 100, grid(n)
    swing = 0.11 * wood.figure * field(n, seed, (0.75, 0.30), 3.0)
    radius = wood.rings * (v + swing) + wood.wiggle * field(n, seed + 1, (0.16, 0.02), 1.5)
    ring = np.floor(radius)
    phase = radius - ring
    strength = 0.35 + 0.65 * np.random.default_rng(seed).random(wood.rings)
    late = phase**wood.sharp * (1.0 - step(0.90, 1.0, phase)) * strength[np.mod(ring, wood.rings).astype(int)]
    late = 1.6 * late
    fibre = field(n, seed + 2, (0.10, 0.004), 1.0)
    grain = field(n, seed + 3, (0.016, 0.0028), 1.6)
    early = 1.0 - wood.porous + wood.porous * (1.0 - step(0.10, 0.42, phase))
    pore = step(0.75, 1.9, grain) * early
    ray = step(1.3, 2.2, field(n, seed + 4, (0.006, 0.016), 2.2))
    dark = np.clip(wood.late * late + wood.pore * pore + 0.035 * fibre + 0.02, 0.0, 1.0)
    tone = 1.0 + wood.tone * field(n, seed + 5, (0.6, 0.16), 2.5) + wood.ray * ray * 0.5
    tint = (1.0 - dark[:, :, None] * (1.0 - np.asarray(wood.dark))) * tone[:, :, None]
    height = -1.1e-4 * pore * (wood.pore > 0.2) - 4e-5 * late - 1.2e-5 * fibre
    rough = 1.0 + 0.10 * pore + 0.10 * late + 0.03 * fibre
    return Relief(tint, height, rough)


for _name, _wood in _WOODS.items():
    add(Pattern(_name, _SIZE, lambda n, wood=_wood: _drawn(n, wood), "wood", grain=True))


@pattern("bamboo", (0.8, 0.2), kind="wood", grain=True)
def _bamboo(n: int) -> Relief:
    """Glued strips of 20 mm with a darker knot every 0.2 to 0.4 m."""
    u, v = grid(n)
    strip = np.floor(v * 10)
    tone, start = spread(strip, 8101) - 0.5, spread(strip, 8102)
    place = np.mod(u + start, 1.0)
    knots = np.exp(-(((place - 0.21) / 0.008) ** 2)) + np.exp(-(((place - 0.72) / 0.008) ** 2))
    fibre = field(n, 8103, (0.3, 0.006), 1.1)
    across = np.abs(np.mod(v * 10, 1.0) - 0.5)
    joint = step(0.46, 0.5, across)
    tint = (1.0 + 0.20 * tone + 0.045 * fibre)[:, :, None] * (
        1.0 - (0.30 * knots + 0.22 * joint)[:, :, None] * np.array([0.8, 1.0, 1.1])
    )
    return Relief(tint, -3e-5 * joint + 1e-5 * fibre, 1.0 + 0.1 * knots)


@pattern("plywood edge", (0.4, 0.036), kind="wood", grain=True, pixels=256)
def _plywood_edge(n: int) -> Relief:
    """Layers of 1.5 mm, every other one cut across its fibres."""
    u, v = grid(n)
    layer = np.floor(v * 24 + 0.15 * field(n, 8201, (0.2, 0.3), 2.0))
    across = np.mod(layer, 2)
    tone = spread(np.mod(layer, 24), 8203) - 0.5
    along, ends = field(n, 8205, (0.15, 0.01), 1.2), field(n, 8207, (0.006, 0.03), 1.2)
    dark = 0.30 * across * (1.0 + 0.3 * ends) + 0.05 * (1 - across) * along + 0.10 * tone
    tint = 1.0 - np.clip(dark + 0.06, 0.0, 0.8)[:, :, None] * np.array([0.75, 1.0, 1.2])
    return Relief(tint, -6e-5 * across + 1e-5 * ends, 1.0 + 0.1 * across)


def plank(n: int, x: np.ndarray, y: np.ndarray, number: np.ndarray, seed: int, wood: str = "oak") -> Relief:
    """Wood on boards: each shows another part of one trunk, in a tone of its own.

    Args:
        n: Side in pixels.
        x: Place along the board [m], [n, n].
        y: Place across it [m], [n, n].
        number: Which board, [n, n].
        seed: Of the random numbers.
        wood: Name of the wood.
    """
    from scipy.ndimage import map_coordinates

    trunk = _drawn(512, _WOODS[wood])
    du, dv, tone, warm = (spread(number, seed + k) for k in range(4))
    rows = (1.0 - (y / _SIZE[1] + dv)) * 512
    columns = (x / _SIZE[0] + du) * 512

    def read(image: np.ndarray, width: float) -> np.ndarray:
        smooth = blurred(image, (0.0, width))
        return map_coordinates(smooth, [rows, columns], order=1, mode="grid-wrap")

    width = 0.4 * 1.4 / n / _SIZE[1]
    tint = np.stack([read(trunk.tint[:, :, k], width) for k in range(3)], 2)
    shift = 1.0 + 0.26 * (tone - 0.5)[:, :, None] + (warm - 0.5)[:, :, None] * np.array([0.02, -0.03, -0.11])
    rough = np.ones((n, n)) if trunk.roughness is None else read(trunk.roughness, width)
    return Relief(tint * shift, read(trunk.height, width), rough * (1.0 + 0.10 * (warm - 0.5)))
