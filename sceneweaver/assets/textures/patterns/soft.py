"""Soft surfaces without threads that can be counted: velvet, boucle, knit, felt, fur, silk, leather."""

from __future__ import annotations

import numpy as np

from ..noise import blurred, cells, field, grid, spread, step
from ..registry import pattern
from ..relief import Relief


@pattern("velvet", (0.3, 0.3), kind="fabric")
def _velvet(n: int) -> Relief:
    """Short pile with patches that catch the light."""
    crush, nap = field(n, 151, 0.22, 1.8), field(n, 153, (0.012, 0.005), 1.2)
    return Relief(1.0 + 0.05 * crush + 0.045 * nap, 4e-5 * nap + 1.2e-4 * crush, 1.0 + 0.10 * crush)


@pattern("boucle", (0.15, 0.15), kind="fabric")
def _boucle(n: int) -> Relief:
    """Curled yarn: little loops of 4 mm in heaps of several sizes."""
    height = np.zeros((n, n))
    for seed, rows in ((161, 22), (163, 34), (165, 52)):
        near = cells(n, seed, rows)
        ring = np.exp(-(((near.first * rows - 0.36) / 0.20) ** 2))
        height = np.maximum(height, ring * (0.55 + 0.45 * spread(near.number, seed + 1)))
    fibre = field(n, 167, 0.008, 1.1)
    tint = (0.60 + 0.40 * height) * (1.0 + 0.04 * fibre + 0.015 * field(n, 169, 0.15))
    return Relief(tint, 1.1e-3 * blurred(height, 0.003) + 2e-5 * fibre, np.ones((n, n)))


@pattern("knit", (0.12, 0.12), kind="fabric")
def _knit(n: int) -> Relief:
    """Stocking stitch: columns of V of 6 mm."""
    u, v = grid(n)
    columns, rows = 20, 28
    x = np.mod(u * columns, 1.0) - 0.5
    y = np.mod(v * rows - 1.1 * np.abs(x), 1.0) - 0.5
    leg = np.clip(1.0 - ((np.abs(x) - 0.25) / 0.25) ** 2, 0.0, 1.0) * np.clip(1.0 - (y / 0.52) ** 2, 0.0, 1.0)
    strand = np.cos(2 * np.pi * (np.mod(v * rows - 1.1 * np.abs(x), 1.0) * 3 + np.sign(x) * x * 4))
    yarn = field(n, 173, 0.006, 1.0)
    tint = (0.42 + 0.58 * np.sqrt(leg)) * (1.0 + 0.04 * strand + 0.05 * yarn + 0.015 * field(n, 175, 0.2))
    return Relief(tint, 1.3e-3 * np.sqrt(leg) + 3e-5 * strand, np.ones((n, n)))


@pattern("felt", (0.15, 0.15), kind="fabric", pixels=256)
def _felt(n: int) -> Relief:
    """Felt and fleece: matted fibres, two tones."""
    fibre = field(n, 181, (0.06, 0.008), 1.2) + field(n, 183, (0.008, 0.06), 1.2) + field(n, 185, 0.02, 1.3)
    return Relief(np.clip(1.0 + 0.055 * fibre, 0.3, None), 2.5e-5 * fibre, np.ones((n, n)))


@pattern("wool", (0.2, 0.2), kind="fabric")
def _wool(n: int) -> Relief:
    """Soft wool: fuzz over a loose weave."""
    u, v = grid(n)
    wave = 0.5 * np.cos(2 * np.pi * 44 * u) * np.cos(2 * np.pi * 44 * v)
    fuzz = field(n, 191, 0.010, 1.2)
    return Relief(1.0 + 0.07 * wave + 0.07 * fuzz + 0.015 * field(n, 193, 0.2), 1.2e-4 * wave + 8e-5 * fuzz)


@pattern("silk", (0.3, 0.3), kind="fabric", pixels=256)
def _silk(n: int) -> Relief:
    """Silk and satin: fine slubs along u, sheen that comes and goes."""
    slub, sheen = field(n, 195, (0.25, 0.006), 1.3), field(n, 197, 0.3, 1.8)
    return Relief(1.0 + 0.03 * slub + 0.03 * sheen, 8e-6 * slub, 1.0 + 0.12 * sheen)


@pattern("leather", (0.2, 0.2), pixels=512)
def _leather(n: int) -> Relief:
    """Grain leather: pebbles between creases, pores, worn patches."""
    bend = field(n, 1101, 0.08)
    small, large = cells(n, 1103, 62), cells(n, 1105, 26)
    crease = 1.0 - step(0.0, 0.0042, small.border) * step(0.0, 0.005, large.border) * (0.96 + 0.01 * bend)
    pebble = np.clip(small.border / 0.008, 0.0, 1.0)
    wear, fine = field(n, 1107, 0.3, 1.7), field(n, 1109, 0.008, 1.0)
    tint = (1.0 + 0.03 * wear + 0.02 * fine) * (1.0 - 0.34 * crease)
    return Relief(
        tint, 2.2e-4 * pebble + 1.6e-4 * np.clip(large.border / 0.02, 0, 1), 1.0 + 0.22 * crease - 0.05 * wear
    )


@pattern("suede", (0.2, 0.2), kind="fabric", pixels=256)
def _suede(n: int) -> Relief:
    """Suede: a short nap stroked to and fro."""
    nap, stroke = field(n, 1111, 0.010, 1.2), field(n, 1113, (0.3, 0.12), 1.7)
    return Relief(1.0 + 0.05 * nap + 0.07 * stroke, 3e-5 * nap, np.ones((n, n)))
