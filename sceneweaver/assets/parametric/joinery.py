"""What many pieces share: legs, handles, drawers, doors, carcasses."""

from __future__ import annotations

from typing import Literal

import numpy as np

from ..body import Material
from .builder import Builder, Interval

LegStyle = Literal["square", "tapered", "round", "splayed", "hairpin", "sled", "panel", "trestle"]


def legs(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Material | str,
    style: LegStyle = "square",
    width: float = 0.045,
) -> None:
    """Four legs, or what stands for them, inside the rectangle x, y between two heights.

    "sled" and "trestle" join front and back legs, "panel" makes each side one board.
    """
    low, high = z
    corners = [(sx, sy) for sx in (0, 1) for sy in (0, 1)]
    if style in ("square", "tapered", "round", "splayed"):
        for sx, sy in corners:
            cx = x[sx] + (width / 2 if sx == 0 else -width / 2)
            cy = y[sy] + (width / 2 if sy == 0 else -width / 2)
            if style == "square":
                b.box((cx - width / 2, cx + width / 2), (cy - width / 2, cy + width / 2), z, material)
            elif style == "round":
                with b.frame(cx, cy):
                    b.frustum(width / 2, width / 2, z, material, segments=16)
            elif style == "tapered":
                foot = width * 0.3
                with b.frame(cx, cy):
                    b.frustum(foot, width / 2, z, material, segments=16)
            else:
                # The foot stays inside the rectangle; the head is drawn in by a tenth of the height.
                inward = 0.1 * (high - low)
                hx, hy = cx + (inward if sx == 0 else -inward), cy + (inward if sy == 0 else -inward)
                _leaning(b, (cx, cy, low), (hx, hy, high), width * 0.3, width / 2, material)
    elif style == "hairpin":
        r = 0.006
        spread = min(0.09, 0.3 * (y[1] - y[0]))
        for sx, sy in corners:
            px = x[sx] + (r + 0.005 if sx == 0 else -r - 0.005)
            py = y[sy] + (r + 0.005 if sy == 0 else -r - 0.005)
            inward = spread if sy == 0 else -spread
            b.bar((px, py, low), (px, py + inward * 0.3, high), r, material, segments=8)
            b.bar((px, py, low), (px, py + inward, high), r, material, segments=8)
    elif style == "sled":
        t = width * 0.6
        for k in (0, 1):
            ys = (y[0], y[0] + t) if k == 0 else (y[1] - t, y[1])
            b.box((x[0], x[0] + t), ys, z, material)
            b.box((x[1] - t, x[1]), ys, z, material)
            b.box((x[0] + t, x[1] - t), ys, (low, low + t), material)
    elif style == "panel":
        t = max(0.018, width * 0.6)
        for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
            b.box(x, ys, z, material)
    elif style == "trestle":
        t = width
        for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
            middle = (x[0] + x[1]) / 2
            b.box(x, ys, (low, low + 0.05), material)
            b.box((middle - t / 2, middle + t / 2), ys, (low + 0.05, high - 0.04), material)
            b.box((x[0] + 0.05, x[1] - 0.05), ys, (high - 0.04, high), material)
    else:
        raise ValueError(f"no legs of style {style}")


def _leaning(b: Builder, foot, head, low: float, high: float, material: Material | str, segments: int = 12) -> None:
    """A round leg between two points, its ends cut level."""
    angle = (np.arange(segments) + 0.5) * (2 * np.pi / segments)
    circle = np.c_[np.cos(angle), np.sin(angle), np.zeros(segments)]
    b.hull(np.concatenate([np.asarray(foot) + low * circle, np.asarray(head) + high * circle]), material)


def handle(
    b: Builder,
    x: float,
    y: float,
    z: float,
    material: Material | str,
    style: str = "bar",
    length: float = 0.12,
    upright: bool = False,
) -> None:
    """A handle on a front face at depth x, centred at (y, z): "bar", "knob", "cup" or "none". It stands out 25 mm."""
    if style == "none":
        return
    if style == "knob":
        with b.frame(x, y, z, pitch=np.pi / 2):
            b.lathe([(0.006, 0.0), (0.006, 0.012), (0.014, 0.018), (0.012, 0.025)], material, segments=12)
        return
    half = length / 2
    if style == "cup":
        b.box((x, x + 0.022), (y - half * 0.7, y + half * 0.7), (z - 0.012, z + 0.014), material, bevel=0.008)
        return
    span = (y, y, z - half, z + half) if upright else (y - half, y + half, z, z)
    b.bar((x + 0.02, span[0], span[2]), (x + 0.02, span[1], span[3]), 0.005, material, segments=8)
    for share in (0.12, 0.88):
        py, pz = span[0] + share * (span[1] - span[0]), span[2] + share * (span[3] - span[2])
        b.box((x, x + 0.018), (py - 0.004, py + 0.004), (pz - 0.004, pz + 0.004), material, bevel=0.0)


def drawer(
    b: Builder,
    name: str,
    x: Interval,
    y: Interval,
    z: Interval,
    front: Material | str,
    pull: Material | str,
    style: str = "bar",
    travel: float | None = None,
) -> None:
    """A drawer with a front of 18 mm that ends at x[1], filling the rectangle y, z with a gap of 2 mm; it slides.

    It comes out by ``travel``, unless told by three quarters of its depth x[1] - x[0].
    """
    gap = 0.002
    with b.slide(name, limits=(0.0, round(0.75 * (x[1] - x[0]) if travel is None else travel, 3))):
        b.box((x[1] - 0.018, x[1]), (y[0] + gap, y[1] - gap), (z[0] + gap, z[1] - gap), front)
        wide = min(0.16, 0.4 * (y[1] - y[0]))
        handle(b, x[1], (y[0] + y[1]) / 2, (z[0] + z[1]) / 2, pull, style, wide)


def door(
    b: Builder,
    name: str,
    x: Interval,
    y: Interval,
    z: Interval,
    leaf: Material | str,
    pull: Material | str,
    hung: Literal["left", "right"] = "left",
    style: str = "bar",
    panel: Material | str | None = None,
) -> None:
    """A door leaf over the rectangle y, z between two depths, hinged at its left or right (seen from behind: +y, -y).

    With ``panel``, a framed door: the frame in ``leaf`` and a thinner panel (glass, say) in it.
    """
    gap = 0.0015
    y, z = (y[0] + gap, y[1] - gap), (z[0] + gap, z[1] - gap)
    # A leaf opens outward: hung at +y it turns counter-clockwise seen from above, at -y clockwise.
    at, limits = ((x[1], y[1], z[0]), (0.0, 1.92)) if hung == "left" else ((x[1], y[0], z[0]), (-1.92, 0.0))
    with b.hinge(name, at, limits=limits):
        if panel is None:
            b.box(x, y, z, leaf)
        else:
            f = min(0.06, 0.2 * (y[1] - y[0]))
            b.box(x, y, (z[0], z[0] + f), leaf)
            b.box(x, y, (z[1] - f, z[1]), leaf)
            b.box(x, (y[0], y[0] + f), (z[0] + f, z[1] - f), leaf)
            b.box(x, (y[1] - f, y[1]), (z[0] + f, z[1] - f), leaf)
            middle = (x[0] + x[1]) / 2
            b.box((middle - 0.003, middle + 0.003), (y[0] + f, y[1] - f), (z[0] + f, z[1] - f), panel, bevel=0)
        reach = min(0.05, 0.15 * (y[1] - y[0]))
        py = y[0] + reach if hung == "left" else y[1] - reach
        long = min(0.2, 0.5 * (z[1] - z[0]))
        if style == "cup":  # it lies along the leaf's width, and stays on the leaf
            long = min(long, 2 * (reach - 0.003) / 0.7)
        high = min(max(1.05, z[0] + 0.1), z[1] - long) if z[1] - z[0] > 1.2 else (z[0] + z[1]) / 2
        handle(b, x[1], py, high, pull, style, long, upright=True)


def carcass(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Material | str,
    board: float = 0.018,
    back: float = 0.006,
) -> tuple[Interval, Interval, Interval]:
    """Two sides, a bottom, a top and a back; returns the interior (x, y, z)."""
    b.box(x, (y[0], y[0] + board), z, material, bevel=0.0015)
    b.box(x, (y[1] - board, y[1]), z, material, bevel=0.0015)
    inner = (y[0] + board, y[1] - board)
    b.box(x, inner, (z[0], z[0] + board), material, bevel=0.0015)
    b.box(x, inner, (z[1] - board, z[1]), material, bevel=0.0015)
    b.box((x[0], x[0] + back), inner, (z[0] + board, z[1] - board), material, bevel=0.0)
    return (x[0] + back, x[1]), inner, (z[0] + board, z[1] - board)
