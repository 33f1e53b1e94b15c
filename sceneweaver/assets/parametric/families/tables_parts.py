"""What tables share: plans, tops, legs, aprons, pedestals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from ...body import Material
from ..builder import Builder, Interval

Finish = Material | str
Edge = Literal["soft", "square", "knife"]


def rounded(x: Interval, y: Interval, radius: float, steps: int = 4) -> np.ndarray:
    """A rectangle with round corners, counter-clockwise."""
    radius = min(radius, 0.499 * (x[1] - x[0]), 0.499 * (y[1] - y[0]))
    turn = np.linspace(0, math.pi / 2, steps + 1)
    corners = ((x[1], y[1], 1, 1, 0), (x[0], y[1], -1, 1, 1), (x[0], y[0], -1, -1, 2), (x[1], y[0], 1, -1, 3))
    points = []
    for cx, cy, sx, sy, k in corners:
        a = turn + k * math.pi / 2
        points.append(np.c_[cx - sx * radius + radius * np.cos(a), cy - sy * radius + radius * np.sin(a)])
    return np.concatenate(points)


def ellipse(a: float, b: float, count: int = 40, power: float = 2.0) -> np.ndarray:
    """An ellipse with these half axes; a power above 2 makes it squarer (a superellipse). It touches all four ends."""
    t = np.arange(count) * (2 * math.pi / count)
    c, s = np.cos(t), np.sin(t)
    return np.c_[a * np.sign(c) * np.abs(c) ** (2 / power), b * np.sign(s) * np.abs(s) ** (2 / power)]


def drawn_in(plan: np.ndarray, by: float) -> np.ndarray:
    """A plan made smaller about its middle by this much at its ends."""
    low, high = plan.min(axis=0), plan.max(axis=0)
    middle, half = (low + high) / 2, (high - low) / 2
    return middle + (plan - middle) * (1 - np.minimum(0.9, by / half))


def tabletop(
    b: Builder,
    plan: np.ndarray,
    z: Interval,
    material: Finish,
    edge: Edge = "soft",
    name: str | None = "top",
    headroom: float | None = None,
    inset: float = 0.01,
) -> None:
    """A convex slab with a support surface; a "knife" edge is cut away underneath."""
    if edge == "knife":
        low = drawn_in(plan, min(0.05, 1.6 * (z[1] - z[0])))
        thin = z[1] - 0.35 * (z[1] - z[0])
        b.hull(
            np.concatenate(
                [
                    np.c_[low, np.full(len(low), z[0])],
                    np.c_[plan, np.full(len(plan), thin)],
                    np.c_[plan, np.full(len(plan), z[1])],
                ]
            ),
            material,
        )
    else:
        b.extrude(plan, z, material, bevel=0.004 if edge == "soft" else 0.0015)
    if name:
        b.surface(name, (0, 0), (0, 0), z[1], headroom, polygon=drawn_in(plan, inset)[:: max(1, len(plan) // 24)])


def proud(style: str) -> float:
    """How far a handle of joinery stands out of its front [m]."""
    return {"none": 0.0, "cup": 0.022}.get(style, 0.025)


def planks(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Finish,
    ends: float = 0.0,
    name: str | None = "top",
    wide: float = 0.14,
) -> None:
    """A top of boards along y with cut edges; ``ends`` is the width of the boards across its two ends."""
    count = max(3, round((x[1] - x[0]) / wide))
    edges = np.linspace(x[0], x[1], count + 1)
    if ends:
        b.box(x, (y[0], y[0] + ends), z, material, bevel=0.0014)
        b.box(x, (y[1] - ends, y[1]), z, material, bevel=0.0014)
    for low, high in zip(edges[:-1], edges[1:], strict=True):
        b.box((float(low), float(high)), (y[0] + ends, y[1] - ends), z, material, bevel=0.0014)
    if name:
        b.surface(name, (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), z[1])


def prism_leg(b: Builder, foot: Sequence[float], head: Sequence[float], low, high, material: Finish) -> None:
    """A straight or leaning leg of rectangular section; ``low`` and ``high`` are its (x, y) sizes at both ends."""
    square = np.array([(-0.5, -0.5, 0), (0.5, -0.5, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0)])
    low = np.array([*np.broadcast_to(low, 2), 0.0])
    high = np.array([*np.broadcast_to(high, 2), 0.0])
    b.hull(np.concatenate([np.asarray(foot) + square * low, np.asarray(head) + square * high]), material)


def cone_leg(
    b: Builder,
    foot: Sequence[float] | np.ndarray,
    head: Sequence[float] | np.ndarray,
    low: float,
    high: float,
    material: Finish,
    segments: int = 14,
) -> None:
    """A round leg between two points with these radii, its ends level."""
    angle = (np.arange(segments) + 0.5) * (2 * math.pi / segments)
    circle = np.c_[np.cos(angle), np.sin(angle), np.zeros(segments)]
    b.hull(np.concatenate([np.asarray(foot) + low * circle, np.asarray(head) + high * circle]), material)


def turned_leg(b: Builder, x: float, y: float, h: float, width: float, material: Finish, block: float = 0.13) -> None:
    """A leg turned on a lathe with rings and a bulge under a square block."""
    r, t = width / 2, h - block
    with b.frame(x, y):
        b.box((-r, r), (-r, r), (t, h), material)
        profile = [
            (0.5, 0.0),
            (0.62, 0.03),
            (0.5, 0.075),
            (0.42, 0.10),
            (0.72, 0.115),
            (0.72, 0.135),
            (0.5, 0.15),
            (0.92, 0.68),
            (0.98, 0.80),
            (0.7, 0.90),
            (0.55, 0.925),
            (0.95, 0.94),
            (0.95, 0.97),
            (0.75, 1.0),
        ]
        b.lathe([(r * a, t * k) for a, k in profile], material, segments=14)


def corner_legs(
    b: Builder,
    x: Interval,
    y: Interval,
    h: float,
    material: Finish,
    style: str,
    width: float = 0.05,
    group: str | None = None,
    cap: Finish | None = None,
) -> None:
    """Four separate legs with their outsides in the rectangle x, y, each its own prism (or all one ``group``).

    Styles: square, tapered (square, drawn in on its inner faces), round, splayed, turned, hairpin. ``cap`` dips the
    feet of round and splayed ones in another finish.
    """
    for k, (sx, sy) in enumerate(((-1, -1), (-1, 1), (1, -1), (1, 1))):
        px, py = x[0] if sx < 0 else x[1], y[0] if sy < 0 else y[1]
        cx, cy = px - sx * width / 2, py - sy * width / 2
        with b.solid(group or f"leg {k}"):
            if style == "square":
                b.box((cx - width / 2, cx + width / 2), (cy - width / 2, cy + width / 2), (0.0, h), material)
            elif style == "tapered":
                foot = 0.55 * width
                prism_leg(b, (px - sx * foot / 2, py - sy * foot / 2, 0), (cx, cy, 0.8 * h), foot, width, material)
                b.box((cx - width / 2, cx + width / 2), (cy - width / 2, cy + width / 2), (0.8 * h, h), material, 0.001)
            elif style in ("round", "splayed"):
                lean = 0.0 if style == "round" else 0.14 * h
                foot = np.array([px - sx * width * 0.28, py - sy * width * 0.28, 0.0])
                head = np.array([px - sx * (width / 2 + lean), py - sy * (width / 2 + lean), h])
                if style == "round":
                    head[:2] = cx, cy
                if cap is not None:
                    share = min(0.3, 0.09 / h)
                    cut, r = foot + share * (head - foot), width * (0.28 + share * 0.22)
                    cone_leg(b, foot, cut, width * 0.28, r, cap)
                    cone_leg(b, cut, head, r, width / 2, material)
                else:
                    cone_leg(b, foot, head, width * 0.28, width / 2, material)
            elif style == "turned":
                turned_leg(b, cx, cy, h, width, material)
            elif style == "hairpin":
                r = 0.006
                fx, fy = px - sx * 0.012, py - sy * 0.012
                for dx, dy in ((0.11, 0.02), (0.02, 0.11)):
                    b.bar((fx, fy, 0), (fx - sx * dx, fy - sy * dy, h - 0.004), r, material, segments=8)
                b.box(
                    (min(px, px - sx * 0.14), max(px, px - sx * 0.14)),
                    (min(py, py - sy * 0.14), max(py, py - sy * 0.14)),
                    (h - 0.005, h),
                    material,
                    bevel=0.0,
                )
            else:
                raise ValueError(f"no legs of style {style}")


def apron(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    material: Finish,
    thick: float = 0.02,
    sides: Sequence[str] = ("front", "back", "left", "right"),
) -> None:
    """Rails under a top, along the rectangle x, y."""
    if "front" in sides:
        b.box((x[1] - thick, x[1]), y, z, material)
    if "back" in sides:
        b.box((x[0], x[0] + thick), y, z, material)
    if "left" in sides:
        b.box((x[0] + thick, x[1] - thick), (y[1] - thick, y[1]), z, material)
    if "right" in sides:
        b.box((x[0] + thick, x[1] - thick), (y[0], y[0] + thick), z, material)


def end_frame(b: Builder, y: float, x: Interval, h: float, material: Finish, style: str, bar: float = 0.05) -> None:
    """The legs of one end of a table at y, in one prism: "loop", "vee", "cross", "a", "trestle" or "slab"."""
    x0, x1 = x
    r = bar / 2
    ys = (y - r, y + r)
    mid = (x0 + x1) / 2
    with b.solid(f"end {y:.3f}"):
        if style == "loop":
            b.box((x0, x0 + bar), ys, (0, h), material)
            b.box((x1 - bar, x1), ys, (0, h), material)
            b.box((x0 + bar, x1 - bar), ys, (0, bar), material)
            b.box((x0 + bar, x1 - bar), ys, (h - bar, h), material)
        elif style == "vee":
            for s in (-1, 1):
                wide = 0.5 * (x1 - x0)
                prism_leg(
                    b, (mid + s * 0.45 * wide, y, 0), (mid + s * (wide - r), y, h), (bar, bar), (bar, bar), material
                )
            b.box((x0, x1), ys, (h - 0.02, h), material)
            b.box((mid - 0.3 * (x1 - x0), mid + 0.3 * (x1 - x0)), ys, (0, 0.02), material)
        elif style == "cross":
            for s in (-1, 1):
                prism_leg(
                    b,
                    (mid - s * (mid - x0 - bar * 0.7), y, 0),
                    (mid + s * (mid - x0 - bar * 0.7), y, h - 0.03),
                    (bar * 1.4, bar),
                    (bar * 1.4, bar),
                    material,
                )
            b.box((x0, x1), ys, (h - 0.05, h), material)
        elif style == "a":
            for s in (-1, 1):
                prism_leg(
                    b,
                    (mid + s * (mid - x0 - r), y, 0),
                    (mid + s * 0.2 * (x1 - x0), y, h - 0.03),
                    (bar, bar),
                    (bar, bar),
                    material,
                )
            b.box((x0 + 0.06, x1 - 0.06), ys, (h - 0.05, h), material)
            b.box((x0 + 0.14, x1 - 0.14), (y - r * 0.7, y + r * 0.7), (0.22, 0.22 + bar), material)
        elif style == "trestle":
            prism_leg(b, (mid, y, 0.04), (mid, y, 0.08), (x1 - x0, bar * 1.3), (0.6 * (x1 - x0), bar * 1.3), material)
            b.box((x0, x0 + 0.09), (y - r * 1.3, y + r * 1.3), (0, 0.04), material)
            b.box((x1 - 0.09, x1), (y - r * 1.3, y + r * 1.3), (0, 0.04), material)
            b.box((mid - 0.07, mid + 0.07), ys, (0.08, h - 0.07), material, bevel=0.008)
            prism_leg(
                b, (mid, y, h - 0.07), (mid, y, h), (0.5 * (x1 - x0), bar * 1.3), (x1 - x0 - 0.06, bar * 1.3), material
            )
        elif style == "slab":
            b.box(x, ys, (0, h), material, bevel=0.004)
        else:
            raise ValueError(f"no end frame of style {style}")


def pedestal(b: Builder, h: float, radius: float, material: Finish, style: str, slim: float = 1.0) -> None:
    """A central foot under a round top, up to height h: "tulip", "disc", "claw", "drum" or "cross"."""
    half = radius * 0.55
    with b.solid("foot"):
        if style == "tulip":
            b.lathe(
                [(radius, 0.0), (radius, 0.008), (radius * 0.72, 0.02), (radius * 0.42, 0.05)], material, segments=28
            )
        elif style == "disc":
            b.lathe([(radius, 0.0), (radius, 0.012), (radius * 0.96, 0.018), (0.06, 0.028)], material, segments=28)
        elif style == "claw":
            for k in range(4):
                with b.frame(yaw=math.pi / 4 + k * math.pi / 2):
                    knee = [(half, y, z) for y in (-0.022, 0.022) for z in (0.075, 0.13)]
                    b.hull([(0.03, y, z) for y in (-0.025, 0.025) for z in (0.12, 0.2)] + knee, material)
                    b.hull(
                        knee
                        + [(radius - 0.03, y, 0.0) for y in (-0.022, 0.022)]
                        + [(radius, y, z) for y in (-0.018, 0.018) for z in (0.0, 0.04)],
                        material,
                    )
        elif style == "drum":
            b.frustum(radius * 0.62, radius * 0.5, (0.0, h - 0.03), material, segments=28, bevel=0.006)
        elif style == "cross":
            for yaw in (math.pi / 4, -math.pi / 4):
                with b.frame(yaw=yaw):
                    b.hull(
                        [(x, y, z) for x in (-radius, radius) for y in (-0.028, 0.028) for z in (0.0, 0.022)]
                        + [(x, y, 0.05) for x in (-0.05, 0.05) for y in (-0.028, 0.028)],
                        material,
                    )
        else:
            raise ValueError(f"no pedestal of style {style}")
    with b.solid("column"):
        if style == "tulip":
            b.lathe(
                [
                    (radius * 0.42, 0.05),
                    (0.07 * slim, 0.13),
                    (0.048 * slim, 0.24),
                    (0.045 * slim, 0.4 * h + 0.1),
                    (0.05 * slim, 0.75 * h),
                    (0.075 * slim, 0.9 * h),
                    (half, h),
                ],
                material,
                segments=24,
            )
        elif style == "claw":
            b.lathe(
                [
                    (0.04, 0.07),
                    (0.06, 0.1),
                    (0.06, 0.2),
                    (0.04, 0.23),
                    (0.075, 0.3),
                    (0.085, 0.38),
                    (0.055, 0.5),
                    (0.04, 0.56),
                    (0.06, 0.58),
                    (0.06, h - 0.06),
                    (radius * 0.5, h - 0.03),
                    (radius * 0.5, h),
                ],
                material,
                segments=20,
            )
        elif style == "drum":
            b.frustum(radius * 0.7, radius * 0.7, (h - 0.03, h), material, segments=28)
        else:
            b.frustum(0.038 * slim, 0.038 * slim, (0.02, h - 0.008), material, segments=20)
            b.frustum(radius * 0.5, radius * 0.5, (h - 0.008, h), material, segments=20)
