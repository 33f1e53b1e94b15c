"""Cloth: threads that go over and under each other, pile, loops, leather and woven cane."""

from __future__ import annotations

import numpy as np

from ..noise import blurred, cells, field, grid, step
from ..registry import pattern
from ..relief import Relief


def woven(
    n: int, count: int, lift: np.ndarray, seed: int, uneven: float = 0.1, slub: float = 0.1, raised: float = 1.2e-4
) -> Relief:
    """Cloth of ``count`` warp and weft threads.

    Args:
        n: Side in pixels.
        count: Threads along u and along v; a multiple of the sides of ``lift``.
        lift: Whether the warp thread lies on top, bool [rows, columns], repeated over the cloth.
        seed: Of the random numbers.
        uneven: How much threads differ in tone.
        slub: How much a thread differs along itself.
        raised: Height of a thread above the gaps [m].
    """
    u, v = grid(n)
    wobble = 0.06 / count * field(n, seed, 0.08)
    x, y = (u + wobble) * count, (v + np.roll(wobble, n // 3, 0)) * count
    i, j = np.floor(x).astype(int) % count, np.floor(y).astype(int) % count
    fx, fy = x - np.floor(x) - 0.5, y - np.floor(y) - 0.5
    rows, columns = lift.shape
    up = lift[j % rows, i % columns].astype(float)
    # How high a thread is follows its neighbours: it rises from under the last and dives under the next.
    before = lift[(j - 1) % rows, i % columns], lift[(j + 1) % rows, i % columns]
    beside = lift[j % rows, (i - 1) % columns], lift[j % rows, (i + 1) % columns]
    bend_warp = np.where(fy < 0, before[0], before[1])
    bend_weft = np.where(fx < 0, ~beside[0], ~beside[1])
    crown = lambda across: np.sqrt(np.clip(1.0 - (across / 0.5) ** 2, 0.0, 1.0))  # noqa: E731
    dive = lambda along, stays: np.where(stays, 1.0, np.cos(np.clip(np.abs(along), 0, 0.5) * np.pi) ** 0.6)  # noqa: E731
    warp, weft = crown(fx) * dive(fy, bend_warp), crown(fy) * dive(fx, bend_weft)
    height = np.where(up > 0, warp, weft)
    rng = np.random.default_rng(seed)
    tones = rng.standard_normal((2, count))
    tone = np.where(up > 0, tones[0][i], tones[1][j])
    along = np.where(
        up > 0,
        field(n, seed + 1, (1 / count, 0.06), 1.5),
        field(n, seed + 2, (0.06, 1 / count), 1.5),
    )
    fibre = field(n, seed + 3, 0.004, 1.0)
    tint = (0.60 + 0.40 * height) * (1.0 + uneven * tone + slub * along + 0.05 * fibre)
    tint = tint / blurred(tint, 0.05)  # from afar cloth is even: what is left of single threads would repeat as a grid
    return Relief(tint, raised * height + 3e-6 * fibre, 1.0 - 0.05 * height)


_PLAIN = np.array([[1, 0], [0, 1]], dtype=bool)
_TWILL = np.array([[(i + j) % 4 < 2 for i in range(4)] for j in range(4)], dtype=bool)


@pattern("weave", (0.12, 0.12), kind="fabric")
def _weave(n: int) -> Relief:
    """A sturdy plain weave, as of sofas: threads of 1.9 mm."""
    return woven(n, 64, _PLAIN, 101, 0.06, 0.08, 2.2e-4)


@pattern("linen", (0.12, 0.12), kind="fabric")
def _linen(n: int) -> Relief:
    """Linen: uneven threads of 1.3 mm with slubs."""
    return woven(n, 92, _PLAIN, 111, 0.09, 0.13, 1.2e-4)


@pattern("cotton", (0.06, 0.06), kind="fabric", pixels=256)
def _cotton(n: int) -> Relief:
    """Fine cotton, as of sheets."""
    return woven(n, 64, _PLAIN, 121, 0.02, 0.03, 5e-5)


@pattern("twill", (0.10, 0.10), kind="fabric")
def _twill(n: int) -> Relief:
    """Twill with its diagonal."""
    return woven(n, 64, _TWILL, 131, 0.05, 0.05, 1.2e-4)


@pattern("canvas", (0.12, 0.12), kind="fabric")
def _canvas(n: int) -> Relief:
    """Coarse canvas of doubled threads."""
    basket = np.kron(_PLAIN, np.ones((2, 2), dtype=bool))
    return woven(n, 96, basket, 141, 0.06, 0.07, 1.6e-4)


@pattern("mesh", (0.06, 0.06), kind="fabric", pixels=256)
def _mesh(n: int) -> Relief:
    """The open net of office chairs: round holes that look dark."""
    near = cells(n, 151, 20, jitter=0.0)
    hole = 1.0 - step(0.013, 0.019, near.first)
    tint = 1.0 - 0.85 * hole
    return Relief(tint, -4e-4 * blurred(hole, 0.006), 1.0 + 0.1 * hole)
