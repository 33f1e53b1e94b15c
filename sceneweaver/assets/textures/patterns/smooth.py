"""What is nearly plain: paint, plastic, glaze, glass, paper, cardboard, rubber, wax, a screen."""

from __future__ import annotations

import numpy as np

from ..noise import cells, field, grid, step
from ..registry import pattern
from ..relief import Relief


@pattern("painted", (0.5, 0.5), pixels=256)
def _painted(n: int) -> Relief:
    """Lacquer on wood or board: faint orange peel."""
    peel = field(n, 701, 0.012, 2.2)
    return Relief(1.0 + 0.006 * field(n, 703, 0.3), 4e-6 * peel, 1.0 + 0.06 * field(n, 705, 0.15, 1.6))


@pattern("plastic", (0.1, 0.1), pixels=256)
def _plastic(n: int) -> Relief:
    """Moulded plastic: a fine even grain."""
    grain = field(n, 711, 0.012, 2.2)
    return Relief(1.0 + 0.008 * grain, 4e-6 * grain, 1.0 + 0.06 * grain)


@pattern("rubber", (0.1, 0.1), pixels=256)
def _rubber(n: int) -> Relief:
    """Matt rubber: small bumps."""
    grain = field(n, 721, 0.02, 2.2)
    return Relief(1.0 + 0.03 * grain, 1.5e-5 * grain, 1.0 + 0.03 * grain)


@pattern("glaze", (0.3, 0.3), pixels=256)
def _glaze(n: int) -> Relief:
    """Glazed ceramic: soft waves, a few pin holes."""
    wave = field(n, 731, 0.10, 3.0)
    pin = step(3.2, 3.6, field(n, 733, 0.012, 2.5))
    return Relief((1.0 + 0.010 * wave) * (1.0 - 0.2 * pin), 1.5e-5 * wave, 1.0 + 0.08 * wave + 0.8 * pin)


@pattern("earthenware", (0.2, 0.2), pixels=256)
def _earthenware(n: int) -> Relief:
    """Unglazed clay with the rings of the wheel (along u) and grit."""
    ring, grit = field(n, 741, (0.8, 0.03), 1.6), field(n, 743, 0.008, 1.0)
    speck = step(2.3, 2.8, field(n, 745, 0.012, 2.2))
    tint = (1.0 + 0.035 * ring + 0.035 * grit + 0.03 * field(n, 747, 0.3)) * (1.0 - 0.3 * speck)
    return Relief(tint, 4e-5 * ring + 1.5e-5 * grit, 1.0 + 0.05 * grit)


@pattern("stoneware", (0.25, 0.25), pixels=256)
def _stoneware(n: int) -> Relief:
    """Speckled glaze."""
    speck = step(1.9, 2.5, field(n, 751, 0.010, 2.2))
    cloud = field(n, 753, 0.2, 1.6)
    tint = (1.0 + 0.05 * cloud)[:, :, None] * (1.0 - 0.55 * speck[:, :, None] * np.array([0.75, 0.9, 1.0]))
    return Relief(tint, 2e-5 * cloud, 1.0 + 0.1 * cloud)


@pattern("paper", (0.2, 0.2), pixels=256)
def _paper(n: int) -> Relief:
    """Paper with faint fibres."""
    fibre = field(n, 761, (0.03, 0.008), 1.2) + field(n, 763, (0.008, 0.03), 1.2)
    return Relief(1.0 + 0.012 * fibre, 4e-6 * fibre, np.ones((n, n)))


@pattern("cardboard", (0.2, 0.2), grain=True, pixels=256)
def _cardboard(n: int) -> Relief:
    """Corrugated board: fibres, specks and the flutes that show through."""
    flute = np.cos(2 * np.pi * 28 * grid(n)[1])
    fibre = field(n, 771, (0.05, 0.01), 1.1)
    speck = step(2.2, 2.8, field(n, 773, (0.02, 0.008), 1.8))
    return Relief((1.0 + 0.018 * flute + 0.04 * fibre) * (1.0 - 0.22 * speck), 3e-5 * flute + 8e-6 * fibre)


@pattern("foam", (0.05, 0.05), pixels=256)
def _foam(n: int) -> Relief:
    """Open cells of a sponge."""
    near = cells(n, 781, 26)
    hole = 1.0 - step(0.004, 0.016, near.first)
    return Relief((1.0 - 0.4 * hole) * (1.0 + 0.03 * field(n, 783, 0.1)), -4e-4 * hole, np.ones((n, n)))


@pattern("wax", (0.1, 0.1), pixels=256)
def _wax(n: int) -> Relief:
    """Wax and soap: soft dents and clouds."""
    cloud = field(n, 791, 0.25, 2.0)
    return Relief(1.0 + 0.02 * cloud, 3e-5 * field(n, 793, 0.2, 2.6), 1.0 + 0.10 * cloud)


@pattern("screen", (0.5, 0.5), pixels=256)
def _screen(n: int) -> Relief:
    """A screen that is off: hardly more than glass, with traces of wiping."""
    wipe = field(n, 795, (0.3, 0.1), 1.6)
    return Relief(np.ones((n, n)), np.zeros((n, n)), 1.0 + 0.12 * wipe)


@pattern("frosted", (0.1, 0.1), pixels=256)
def _frosted(n: int) -> Relief:
    """Etched glass."""
    grain = field(n, 797, 0.010, 1.6)
    return Relief(1.0 + 0.01 * grain, 6e-6 * grain, 1.0 + 0.05 * grain)


@pattern("canvas print", (0.1, 0.1), pixels=256)
def _canvas_print(n: int) -> Relief:
    """Pigment on the weave of a painter's canvas, with strokes."""
    u, v = grid(n)
    weave = np.cos(2 * np.pi * 50 * u) * np.cos(2 * np.pi * 50 * v)
    stroke = field(n, 799, (0.30, 0.04), 1.4)
    return Relief(1.0 + 0.02 * weave + 0.05 * stroke, 1.2e-5 * weave + 3e-5 * stroke, 1.0 + 0.06 * stroke)
