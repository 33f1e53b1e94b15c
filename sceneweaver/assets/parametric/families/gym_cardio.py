"""Machines to run, ride, row and climb on; the user looks toward +x."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_kit import Look, disc, gear, inlay, post, ring, side


def _console(b: Builder, x: float, y: float, z: float, wide: float = 0.4, tall: float = 0.24) -> None:
    """A console that leans toward the user, with a dark screen."""
    with b.frame(x, y, z, pitch=0.45):
        b.box((-0.02, 0.045), (-wide / 2, wide / 2), (0, tall), "black plastic", 0.012)
        inlay(b, (-0.0203, 0), (-wide * 0.32, wide * 0.32), (tall * 0.3, tall * 0.9), "screen")
        for k in range(5):
            y0 = -wide * 0.3 + k * wide * 0.15 - 0.012
            inlay(b, (-0.0203, 0), (y0, y0 + 0.024), (tall * 0.1, tall * 0.2), "grey plastic")


@gear("treadmill")
def treadmill(b: Builder) -> None:
    """A belt between side rails, a motor hood, two uprights with handrails and a console."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "grey plastic", "white plastic")
    metal = b.material("frame", "black steel", "steel", "white steel", "grey paint")
    accent = b.material("accent", "red plastic", "blue plastic", "orange plastic", "yellow plastic")
    x0, x1, y = -d / 2, d / 2, w / 2
    with b.solid("deck"):
        b.box((x0 + 0.03, x1 - 0.1), (-y + 0.03, y - 0.03), (0.03, 0.15), metal, 0.01)
        b.box((x0 + 0.08, x1 - 0.35), (-y * 0.62, y * 0.62), (0.14, 0.165), "rubber", 0.004)
        for s in (-1, 1):
            ys = sorted((s * y * 0.64, s * y))
            b.box((x0, x1 - 0.3), (ys[0], ys[1]), (0.1, 0.185), body, 0.012)
            inlay(b, (x0 + 0.1, x1 - 0.5), (s * y * 0.8 - 0.02, s * y * 0.8 + 0.02), (0.17, 0.1853), accent)
            for x in (x0 + 0.12, x1 - 0.15):
                disc(b, (x, s * (y - 0.08), 0.035), 0.035, 0.05, "rubber", segments=12)
        disc(b, (x0 + 0.06, 0, 0.12), 0.045, w * 0.7, "rubber", segments=16)
        side(
            b,
            [(x1 - 0.36, 0.04), (x1, 0.04), (x1, 0.2), (x1 - 0.06, 0.27), (x1 - 0.24, 0.27), (x1 - 0.36, 0.17)],
            (-y + 0.02, y - 0.02),
            body,
            0.012,
        )
        inlay(b, (x1 - 0.2, x1 - 0.1), (-y * 0.6, y * 0.6), (0.2, 0.2703), accent)
    top = h - 0.25
    with b.solid("console"):
        for s in (-1, 1):
            yy = s * (y - 0.045)
            post(b, (x1 - 0.12, yy, 0.1), (x1 - 0.36, yy, top), metal, 0.06, 0.09)
            b.tube(
                [(x1 - 0.3, yy, top - 0.04), (x1 - 0.5, yy, top - 0.06), (x1 - 0.75, yy, top - 0.12)],
                0.021,
                "rubber",
                10,
            )
        b.box((x1 - 0.48, x1 - 0.32), (-y + 0.03, y - 0.03), (top - 0.06, top + 0.03), body, 0.015)
        for s in (-1, 1):
            disc(b, (x1 - 0.4, s * y * 0.6, top + 0.031), 0.045, 0.012, "black plastic", "z", 16)
        _console(b, x1 - 0.37, 0, top, w * 0.62, 0.24)
        b.box((x1 - 0.5, x1 - 0.47), (-0.03, 0.03), (top - 0.05, top - 0.01), "red plastic", 0.006)


@gear("exercise_bike")
def exercise_bike(b: Builder) -> None:
    """An upright bike: round drive housing, saddle on a post, handlebar, console."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "white plastic", "grey plastic")
    accent = b.material("accent", "red plastic", "blue plastic", "orange plastic", "green plastic")
    metal = b.material("frame", "black steel", "steel", "white steel")
    _feet(b, d, w, metal)
    post(b, (-d * 0.42, 0, 0.07), (d * 0.42, 0, 0.07), metal, 0.07)
    with b.frame(0.12, 0, 0.36):
        for t, r, look in ((0.13, 0.27, body), (0.142, 0.2, accent), (0.15, 0.16, body)):
            disc(b, (0, 0, 0), r, t, look, segments=28, bevel=0.012)
    side(
        b, [(-0.2, 0.08), (0.3, 0.08), (0.3, 0.36), (0.1, 0.6), (-0.1, 0.56), (-0.2, 0.35)], (-0.06, 0.06), body, 0.015
    )
    _cranks(b, 0.02, 0.3, 0.11, 0.16)
    sx, sz = -d * 0.25, h * 0.66
    post(b, (-0.13, 0, 0.25), (sx, 0, sz), metal, 0.05)
    _saddle(b, sx, sz, 0.26, 0.24)
    post(b, (0.2, 0, 0.45), (0.27, 0, h - 0.2), metal, 0.06)
    _bars(b, 0.27, h - 0.24, w * 0.92, -0.28)
    _console(b, 0.24, 0, h - 0.22, 0.26, 0.2)


def _feet(b: Builder, d: float, w: float, metal: Look) -> None:
    for x in (-d / 2 + 0.05, d / 2 - 0.05):
        b.bar((x, -w * 0.46, 0.04), (x, w * 0.46, 0.04), 0.03, metal, 12)
        for s in (-1, 1):
            disc(b, (x, s * w * 0.46, 0.04), 0.04, w * 0.08, "rubber", segments=16, bevel=0.005)


def _cranks(b: Builder, x: float, z: float, y: float, r: float) -> None:
    b.bar((x, -y, z), (x, y, z), 0.02, "steel", 10)
    for s in (-1, 1):
        a = (x + s * r * 0.75, s * y, z - s * r * 0.65)
        post(b, (x, s * y, z), a, "steel", 0.014, 0.03)
        b.box(
            (a[0] - 0.05, a[0] + 0.05), span(s * y, s * (y + 0.1)), (a[2] - 0.012, a[2] + 0.012), "black plastic", 0.005
        )


def _saddle(b: Builder, x: float, z: float, long: float, wide: float) -> None:
    p = [(-long / 2, -wide * 0.42), (-long * 0.1, -wide / 2), (long * 0.2, -wide * 0.2), (long / 2, -wide * 0.11)]
    outline = p + [(px, -py) for px, py in reversed(p)]
    low = [(x + px * 0.85, py * 0.75, z) for px, py in outline]
    mid = [(x + px, py, z + 0.035) for px, py in outline]
    top = [(x + px * 0.9, py * 0.8, z + 0.06 + (0.015 if px < 0 else 0)) for px, py in outline]
    b.hull(low + mid + top, "black leather")


def _bars(b: Builder, x: float, z: float, w: float, reach: float) -> None:
    """Handlebars that come back toward the user."""
    y = w / 2
    b.tube(
        [
            (x + reach, -y + 0.03, z + 0.05),
            (x + reach * 0.3, -y, z + 0.02),
            (x, -y * 0.4, z),
            (x, y * 0.4, z),
            (x + reach * 0.3, y, z + 0.02),
            (x + reach, y - 0.03, z + 0.05),
        ],
        0.016,
        "rubber",
        10,
    )


@gear("spin_bike")
def spin_bike(b: Builder) -> None:
    """A racing frame with a heavy bare flywheel in front."""
    d, w, h = b.size
    metal = b.material("frame", "black steel", "red paint", "white steel", "yellow paint", "grey paint")
    _feet(b, d, w, metal)
    post(b, (-d * 0.45, 0, 0.07), (d * 0.45, 0, 0.07), metal, 0.06)
    fx, fz = d * 0.24, 0.34
    disc(b, (fx, 0, fz), 0.235, 0.03, "steel", segments=32, bevel=0.006)
    disc(b, (fx, 0, fz), 0.13, 0.05, "black plastic", segments=24, bevel=0.006)
    for s in (-1, 1):
        post(b, (fx, s * 0.045, fz), (fx - 0.06, s * 0.045, 0.74), metal, 0.018, 0.05)
        post(b, (fx, s * 0.045, fz), (fx + 0.08, s * 0.045, 0.07), metal, 0.018, 0.05)
    disc(b, (-0.04, 0.05, 0.33), 0.1, 0.03, "black plastic", segments=24, bevel=0.005)
    b.hull(
        [(x, y, z + s) for x, z in ((-0.04, 0.33), (fx, fz)) for y in (0.04, 0.065) for s in (-0.045, 0.045)],
        "black plastic",
    )
    _cranks(b, -0.04, 0.33, 0.09, 0.17)
    post(b, (fx - 0.06, 0, 0.74), (-0.04, 0, 0.33), metal, 0.06)
    post(b, (-0.04, 0, 0.07), (-d * 0.22, 0, 0.62), metal, 0.06)
    post(b, (-d * 0.22, 0, 0.6), (-d * 0.27, 0, h * 0.78), "steel", 0.035)
    post(b, (-d * 0.34, 0, h * 0.78), (-d * 0.18, 0, h * 0.78), "steel", 0.035)
    _saddle(b, -d * 0.26, h * 0.79, 0.27, 0.18)
    post(b, (fx - 0.06, 0, 0.72), (fx - 0.09, 0, h * 0.9), "steel", 0.04)
    post(b, (fx - 0.2, 0, h * 0.9), (fx + 0.02, 0, h * 0.9), "steel", 0.035)
    y, z = min(w / 2, 0.24), h - 0.05
    for s in (-1, 1):
        b.tube(
            [(fx, 0, h * 0.91), (fx, s * y, h * 0.92), (fx + 0.14, s * y, z), (fx + 0.22, s * y * 0.7, z + 0.03)],
            0.015,
            "rubber",
            10,
        )


@gear("elliptical")
def elliptical(b: Builder) -> None:
    """Housing at the back, two long foot bars with treads, swinging handles, console."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "grey plastic", "white plastic")
    metal = b.material("frame", "black steel", "steel", "grey paint")
    accent = b.material("accent", "red plastic", "blue plastic", "orange plastic")
    _feet(b, d, w, metal)
    post(b, (-d * 0.45, 0, 0.07), (d * 0.45, 0, 0.07), metal, 0.08)
    x = -d / 2 + 0.38
    disc(b, (x, 0, 0.39), 0.33, 0.17, body, segments=28, bevel=0.02)
    disc(b, (x, 0, 0.39), 0.22, 0.182, accent, segments=28, bevel=0.008)
    disc(b, (x, 0, 0.39), 0.19, 0.186, body, segments=28, bevel=0.008)
    px = d * 0.28
    post(b, (px + 0.1, 0, 0.07), (px - 0.02, 0, h - 0.25), metal, 0.09)
    b.bar((px, -w * 0.4, h * 0.55), (px, w * 0.4, h * 0.55), 0.025, metal)
    for s in (-1, 1):
        y = s * (w / 2 - 0.15)
        a = (x + s * 0.13, y, 0.39 + s * 0.09)
        post(b, (x, 0, 0.39), (x, y, 0.39), "steel", 0.04)
        post(b, (x, y, 0.39), a, "steel", 0.03, 0.05)
        foot = (px - 0.02 + s * 0.1, y, 0.3)
        post(b, a, foot, metal, 0.05)
        m = (a[0] * 0.55 + foot[0] * 0.45, a[2] * 0.55 + foot[2] * 0.45)
        with b.frame(m[0], y, m[1] + 0.035, pitch=math.atan2(a[2] - 0.3, foot[0] - a[0])):
            b.box((-0.2, 0.2), (-0.085, 0.085), (-0.02, 0.02), "rubber", 0.01)
            b.box((0.17, 0.2), (-0.085, 0.085), (0.0, 0.06), "rubber", 0.01)
        yy = s * w * 0.4
        b.tube(
            [
                (foot[0], y, foot[2] - 0.01),
                (px, yy, h * 0.55),
                (px - s * 0.1 - 0.02, yy, h * 0.82),
                (px - 0.22 - s * 0.12, s * (w / 2 - 0.03), h - 0.03),
            ],
            0.02,
            metal,
            10,
        )
        b.bar(
            (px - s * 0.1 - 0.03, yy, h * 0.83),
            (px - 0.215 - s * 0.12, s * (w / 2 - 0.03), h - 0.035),
            0.026,
            "rubber",
            10,
        )
    _console(b, px - 0.08, 0, h - 0.3, 0.32, 0.24)


@gear("rowing_machine")
def rowing_machine(b: Builder) -> None:
    """A fan housing in front, a long rail, sliding seat, foot plates, handle."""
    d, w, h = b.size
    metal = b.material("rail", "aluminium", "black steel", "oak", "walnut")
    body = b.material("body", "black plastic", "grey plastic", "black steel")
    x0, x1 = -d / 2, d / 2
    r = min(0.27, h * 0.28)
    fx, fz = x1 - r - 0.04, r + 0.1
    with b.solid("fan"):
        disc(b, (fx, 0, fz), r, 0.19, body, segments=28, bevel=0.03)
        for k in range(3):
            ring(b, (fx, 0.094, fz), r * (0.35 + 0.2 * k), 0.006, "steel", n=16, segments=6)
            ring(b, (fx, -0.094, fz), r * (0.35 + 0.2 * k), 0.006, "steel", n=16, segments=6)
        b.bar((fx + 0.05, -w / 2 + 0.02, 0.03), (fx + 0.05, w / 2 - 0.02, 0.03), 0.03, "black steel", 12)
        post(b, (fx + 0.05, 0, 0.03), (fx, 0, fz), "black steel", 0.06)
        post(b, (fx - 0.1, 0, fz), (fx - 0.3, 0, h - 0.06), "black steel", 0.04)
        with b.frame(fx - 0.32, 0, h - 0.2, pitch=0.35):
            b.box((-0.02, 0.02), (-0.11, 0.11), (0, 0.2), "black plastic", 0.01)
            inlay(b, (-0.0203, 0), (-0.08, 0.08), (0.06, 0.18), "screen")
    with b.solid("rail"):
        post(b, (x0 + 0.03, 0, 0.34), (fx, 0, 0.3), metal, 0.07, 0.09)
        post(b, (x0 + 0.06, 0, 0.33), (x0 + 0.06, 0, 0.03), "black steel", 0.05)
        b.bar((x0 + 0.06, -w / 2 + 0.05, 0.025), (x0 + 0.06, w / 2 - 0.05, 0.025), 0.025, "rubber", 12)
        sx = x0 + d * b.uniform("seat", 0.25, 0.42)
        b.box((sx - 0.1, sx + 0.1), (-0.08, 0.08), (0.37, 0.41), "black plastic", 0.008)
        b.cushion((sx - 0.13, sx + 0.13), (-0.17, 0.17), (0.405, 0.46), "black leather", 0.025)
        for s in (-1, 1):
            with b.frame(fx - r - 0.12, s * 0.13, 0.33, pitch=-0.8):
                b.box((-0.15, 0.15), (-0.055, 0.055), (-0.012, 0.012), "grey plastic", 0.006)
                b.box((-0.02, 0.03), (-0.06, 0.06), (-0.016, 0.03), "rubber", 0.006)
        b.bar((fx - r - 0.12, -0.16, 0.31), (fx - r - 0.12, 0.16, 0.31), 0.015, "black steel")
        b.bar((fx - r + 0.02, -0.25, 0.5), (fx - r + 0.02, 0.25, 0.5), 0.017, "rubber", 10)
        b.bar((fx - r + 0.02, 0, 0.5), (fx, 0, fz + 0.06), 0.008, "steel", 6)


@gear("stair_climber")
def stair_climber(b: Builder) -> None:
    """Three turning steps between side panels, handrails and a console above."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "grey plastic", "white plastic", "grey paint")
    x0, x1, y = -d / 2, d / 2, w / 2
    for s in (-1, 1):
        ys = (y - 0.09, y) if s > 0 else (-y, -y + 0.09)
        side(b, [(x0 + 0.1, 0), (x1, 0), (x1, h * 0.58), (x1 - 0.3, h * 0.58), (x0 + 0.1, h * 0.2)], ys, body, 0.02)
        post(b, (x1 - 0.15, s * (y - 0.045), h * 0.5), (x1 - 0.25, s * (y - 0.045), h - 0.26), "black steel", 0.06)
        b.tube(
            [
                (x0 + 0.2, s * (y - 0.045), h * 0.24),
                (x0 + 0.28, s * (y - 0.045), h * 0.48),
                (x1 - 0.25, s * (y - 0.045), h * 0.72),
                (x1 - 0.2, s * (y - 0.045), h * 0.8),
            ],
            0.022,
            "steel",
            10,
        )
    step = 0.21
    for k in range(4):
        x, z = x0 + 0.02 + k * 0.24, 0.08 + k * step
        b.box((x, x + 0.27), (-y + 0.08, y - 0.08), (z - 0.06, z), "rubber", 0.008)
        inlay(b, (x - 0.0003, x + 0.02), (-y + 0.1, y - 0.1), (z - 0.03, z - 0.01), "yellow plastic")
        b.box((x + 0.2, x + 0.26), (-y + 0.09, y - 0.09), (max(0.0, z - 0.1), z + step - 0.05), "black plastic", 0.004)
    b.box((x1 - 0.4, x1 - 0.02), (-y + 0.08, y - 0.08), (0, h * 0.5), "black plastic", 0.01)
    b.box((x1 - 0.32, x1 - 0.16), (-y + 0.02, y - 0.02), (h - 0.33, h - 0.25), body, 0.02)
    _console(b, x1 - 0.24, 0, h - 0.27, w * 0.6, 0.28)


def plate(b: Builder, at: tuple[float, float, float], r: float, t: float, look: Look, axis: str = "y") -> None:
    """A weight plate with a raised hub."""
    disc(b, at, r, t, look, axis, 28, min(0.006, t * 0.3))
    disc(b, at, r * 0.3, t + 0.008, "steel", axis, 16, 0.002)


def dumbbell_at(b: Builder, at: np.ndarray, size: float, look: Look) -> None:
    """A dumbbell along y (so that it lies head to the front on a rack when turned), hexagonal heads."""
    half = size / 2
    grip = half * 0.42
    b.bar((at[0], at[1] - grip, at[2]), (at[0], at[1] + grip, at[2]), size * 0.05, "steel", 10)
    for s in (-1, 1):
        mid = at[1] + s * (grip + half) / 2
        disc(b, (at[0], mid, at[2]), size * 0.23, half - grip, look, segments=6, bevel=size * 0.03)
