"""Mats, balls and other small gear of a gym."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from .gym_kit import gear, inlay, ring

_BRIGHT = (
    "blue plastic",
    "mint plastic",
    "lilac plastic",
    "pink plastic",
    "green plastic",
    "black plastic",
    "grey plastic",
)


@gear("yoga_mat")
def yoga_mat(b: Builder) -> None:
    """A flat mat, sometimes with one end still rolled."""
    d, w, _ = b.size
    look = b.material("mat", *_BRIGHT)
    t = 0.006
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0, t), look, 0.001)
    inlay(b, (-d / 2 + 0.1, d / 2 - 0.1), (-0.004, 0.004), (t - 0.002, t + 0.0003), "white plastic")
    for k in range(5):
        x = (k - 2) * d / 6
        inlay(b, (x - 0.004, x + 0.004), (-w * 0.2, w * 0.2), (t - 0.002, t + 0.0003), "white plastic")


@gear("exercise_mat")
def exercise_mat(b: Builder) -> None:
    """A thick folding gymnastics mat of three or four panels."""
    d, w, h = b.size
    look = b.material("mat", "blue plastic", "red plastic", "grey plastic", "green plastic", "black leather")
    n = b.whole("panels", 3, 4)
    for k in range(n):
        x = -d / 2 + k * d / n
        b.box((x + 0.001, x + d / n - 0.001), (-w / 2, w / 2), (0, h), look, 0.008)
    for s in (-1, 1):
        b.box((-0.08, 0.08), (s * w / 2 - 0.006, s * w / 2 + 0.006), (h * 0.4, h * 0.6), "black leather", 0.002)


@gear("exercise_ball")
def exercise_ball(b: Builder) -> None:
    """A big ball with grooves, the valve at its side."""
    r = b.size.depth / 2
    look = b.material("ball", *_BRIGHT, "red plastic")
    b.ball((r, r, r), (0, 0, r), look, 28)
    b.frustum(r * 0.2, r * 0.24, (0, 0.02), look, 16)
    for k in (-0.45, -0.3, 0.3, 0.45):
        ring(b, (0, 0, r + k * r), math.sqrt(1 - k * k) * r - 0.001, 0.006, look, "z", 24, 6)
    b.size = b.size._replace(width=b.size.depth, height=b.size.depth)


@gear("medicine_ball")
def medicine_ball(b: Builder) -> None:
    """A leather ball of panels with seams."""
    r = b.size.depth / 2
    look = b.material("ball", "brown leather", "tan leather", "black leather", "red plastic", "blue plastic")
    b.ball((r, r, r), (0, 0, r), look, 24)
    b.frustum(r * 0.25, r * 0.3, (0, 0.01), look, 16)
    for axis in "xyz":
        ring(b, (0, 0, r), r - 0.001, 0.003, "black leather", axis, 28, 5)
    b.size = b.size._replace(width=b.size.depth, height=b.size.depth)


@gear("foam_roller")
def foam_roller(b: Builder) -> None:
    """A ribbed roll of foam with a hollow core."""
    d, w, h = b.size
    look = b.material("roll", *_BRIGHT, "orange plastic")
    r = h / 2
    with b.frame(0, 0, r, roll=-math.pi / 2):
        b.frustum(r, r, (-w / 2, w / 2), look, 24, 0.006)
        b.frustum(r * 0.55, r * 0.55, (-w / 2 - 0.0003, w / 2 + 0.0003), "black plastic", 20)
        n = 5
        for k in range(n):
            z = (k - (n - 1) / 2) * w / (n + 0.3)
            b.frustum(r + 0.003, r + 0.003, (z - w / 14, z + w / 14), look, 24, 0.003)


@gear("aerobic_step")
def aerobic_step(b: Builder) -> None:
    """A stepping board with a rubber top on stacked blocks."""
    d, w, h = b.size
    look = b.material("body", "black plastic", "grey plastic", "blue plastic")
    block = b.material("blocks", "blue plastic", "green plastic", "red plastic", "grey plastic", "lilac plastic")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.07, h - 0.008), look, 0.015)
    b.box((-d / 2 + 0.03, d / 2 - 0.03), (-w / 2 + 0.03, w / 2 - 0.03), (h - 0.01, h), "rubber", 0.003)
    n = max(1, round((h - 0.07) / 0.05))
    step = (h - 0.07) / n
    for k in range(n):
        for s in (-1, 1):
            y = s * (w / 2 - 0.16)
            b.box((-d / 2 + 0.01, d / 2 - 0.01), (y - 0.14, y + 0.14), (k * step, (k + 1) * step), block, 0.01)


@gear("trampoline", square=True)
def trampoline(b: Builder) -> None:
    """A small indoor trampoline: mat, padded rim, legs, with a handle in some."""
    d, w, h = b.size
    pad = b.material("pad", "blue plastic", "green plastic", "pink plastic", "red plastic", "black plastic")
    r = d / 2
    z = 0.24 if h > 0.5 else h - 0.02
    b.frustum(r * 0.84, r * 0.84, (z - 0.03, z - 0.015), "black fabric", 32)
    n = 16
    t = (np.arange(n) + 0.5) * (2 * np.pi / n)
    s = np.array([(0.09 * r, -0.02), (0.09 * r, 0.012), (0, 0.02), (-0.09 * r, 0.012), (-0.09 * r, -0.02)])
    b.tube(np.c_[0.9 * r * np.cos(t), 0.9 * r * np.sin(t), 0 * t + z - 0.005], s, pad, closed=True)
    for k in range(6):
        a = (k + 0.5) * math.pi / 3
        x, y = 0.88 * r * math.cos(a), 0.88 * r * math.sin(a)
        b.bar((x, y, 0.0), (x, y, z - 0.02), 0.016, "steel", 10)
        with b.frame(x, y):
            b.frustum(0.024, 0.024, (0, 0.03), "rubber", 12)
    if h > 0.5:
        y = 0.25
        x = 0.86 * r
        b.tube(
            [
                (x, -y, 0.03),
                (x + 0.03, -y, h * 0.6),
                (x - 0.08, -y, h - 0.02),
                (x - 0.08, y, h - 0.02),
                (x + 0.03, y, h * 0.6),
                (x, y, 0.03),
            ],
            0.016,
            "steel",
            10,
        )
        b.bar((x - 0.08, -y + 0.02, h - 0.02), (x - 0.08, y - 0.02, h - 0.02), 0.022, "rubber", 10)
