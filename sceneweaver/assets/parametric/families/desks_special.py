"""Desks with something above the top, counters, and benches to work at."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..joinery import door, drawer
from ..registry import draws
from .desks import drawer_stack
from .tables_parts import corner_legs, ellipse, end_frame, planks, prism_leg, proud, rounded, tabletop

WOODS = ("oak", "walnut", "cherry", "mahogany", "light oak", "beech")


@draws("secretary_desk")
def secretary_desk(b: Builder) -> None:
    """A writing top on slim legs with drawers in its apron and a hutch of pigeonholes above its back."""
    d, w, h = b.size
    style = b.pick("pull style", ["knob", "cup"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wood = b.material("body", *WOODS, "white paint", "sage paint")
    pull = b.material("pulls", "brass", "bronze", "black steel")
    table, deep = 0.75, 0.11
    low = table - 0.022
    hutch = x[0] + b.uniform("hutch", 0.2, 0.24)
    face = x[1] - proud(style) - 0.005
    with b.solid("top"):
        b.box(x, y, (low, table), wood, bevel=0.004)
        b.box((x[0] + 0.012, face - 0.019), (y[0] + 0.015, y[1] - 0.015), (low - deep, low), wood)
        step = (w - 0.03) / 2
        for k in range(2):
            at = y[0] + 0.015 + k * step
            drawer(b, f"drawer-{k}", (x[0] + 0.04, face), (at, at + step), (low - deep, low - 0.002), wood, pull, style)
    corner_legs(
        b,
        (x[0] + 0.012, face - 0.004),
        (y[0] + 0.015, y[1] - 0.015),
        low - deep,
        wood,
        b.pick("legs", ["tapered", "turned"]),
        0.048,
    )
    b.surface("top", (hutch + 0.03, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), table)
    t, back = 0.016, 0.006
    mid = table + 0.55 * (h - table)
    with b.solid("hutch top"):
        b.box((x[0], hutch + 0.01), y, (h - 0.02, h), wood, bevel=0.006)
    b.surface("hutch", (x[0] + 0.01, hutch), (y[0] + 0.01, y[1] - 0.01), h)
    shell = (y[0] + 0.01, y[1] - 0.01)
    third = w / 6
    with b.solid("back"):
        b.box((x[0], x[0] + back), shell, (table, h - 0.02), wood, bevel=0.0)
    for s in (-1, 1):
        outer = (shell[1] - t, shell[1]) if s > 0 else (shell[0], shell[0] + t)
        inner = (third, third + t) if s > 0 else (-third - t, -third)
        block = (inner[1], outer[0]) if s > 0 else (outer[1], inner[0])
        low_drawer = table + 0.5 * (mid - table)
        with b.solid(f"wing {s}"):
            b.box((x[0] + back, hutch), outer, (table, h - 0.02), wood, bevel=0.001)
            b.box((x[0] + back, hutch), inner, (table, h - 0.02), wood, bevel=0.001)
            b.box((x[0] + back, hutch - 0.02), block, (table, mid), wood, bevel=0.0)
            for k, zs in enumerate(((table, low_drawer), (low_drawer, mid))):
                drawer(b, f"small-{s + 1}{k}", (x[0] + 0.03, hutch - 0.001), block, zs, wood, pull, "knob")
            b.box((x[0] + back, hutch), block, (mid, mid + 0.012), wood, bevel=0.001)
            if b.chance("letters", 0.6):
                for k in range(1, 4):
                    at = block[0] + (block[1] - block[0]) * k / 4
                    b.box(
                        (x[0] + back, hutch - 0.01), (at - 0.003, at + 0.003), (mid + 0.012, h - 0.02), wood, bevel=0.0
                    )
    with b.solid("shelf"):
        b.box((x[0] + back, hutch - 0.005), (-third, third), (mid, mid + 0.012), wood, bevel=0.001)
    b.surface(
        "shelf",
        (x[0] + 0.02, hutch - 0.02),
        (-third + 0.01, third - 0.01),
        mid + 0.012,
        round(h - 0.02 - mid - 0.017, 4),
    )
    b.clear((x[0] + 0.1, x[1]), (y[0] + 0.1, y[1] - 0.1), (0.0, low - deep - 0.01))


@draws("computer_desk")
def computer_desk(b: Builder) -> None:
    """A desk with a raised shelf for screens, a tray for the keyboard, a rack for the machine, steel or panel ends."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", "black paint", "oak", "white paint", "walnut", "wenge")
    metal = b.material("frame", "black steel", "white steel", "red paint", "grey paint")
    glow = b.chance("lights", 0.35)
    table = 0.75
    low = table - 0.022
    rack = 0.24
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.02, 3), (low, table), top, name=None)
        if glow:
            b.box(
                (x[1] - 0.004, x[1] + 0.001), (y[0] + 0.05, y[1] - 0.05), (low + 0.008, low + 0.014), "lamp glow", 0.0
            )
    for s in (-1, 1):
        end_frame(b, s * (w / 2 - 0.03), (x[0] + 0.03, x[1] - 0.04), low, metal, "loop", 0.04)
    shelf = x[0] + 0.26
    with b.solid("screen shelf"):
        b.box((x[0], shelf), (y[0] + 0.02, y[1] - 0.02), (h - 0.02, h), top)
    b.surface("shelf", (x[0] + 0.01, shelf - 0.01), (y[0] + 0.03, y[1] - 0.03), h)
    for s in (-1, 1):
        at = s * (w / 2 - 0.035)
        with b.solid(f"post {s}"):
            b.box((x[0] + 0.02, shelf - 0.03), (at - 0.01, at + 0.01), (table, h - 0.02), metal)
    b.surface("top", (shelf + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), table)
    b.surface("under", (x[0] + 0.02, shelf), (y[0] + 0.06, y[1] - 0.06), table, round(h - table - 0.025, 4))
    side = b.pick("rack side", [-1, 1])
    far = side * (w / 2 - 0.05)
    ys = (far - rack, far) if side > 0 else (far, far + rack)
    with b.solid("rack"):
        b.box((x[0] + 0.08, x[1] - 0.08), ys, (0.1, 0.118), top)
        inner = ys[0] if side > 0 else ys[1] - 0.016
        b.box((x[0] + 0.08, x[1] - 0.08), (inner, inner + 0.016), (0.118, low), top)
        b.box(
            (x[0] + 0.08, x[1] - 0.08),
            (ys[0] + 0.016, ys[1]) if side > 0 else (ys[0], ys[1] - 0.016),
            (0.5, 0.516),
            top,
        )
        lo, hi = (ys[0] + 0.03, ys[1] - 0.02) if side > 0 else (ys[0] + 0.02, ys[1] - 0.03)
        b.box((x[0] + 0.1, x[1] - 0.13), (lo, hi), (0.118, 0.48), "black plastic", bevel=0.008)
        b.box((x[1] - 0.131, x[1] - 0.128), (lo + 0.02, hi - 0.02), (0.15, 0.45), "black glass", bevel=0.0)
        b.box((x[1] - 0.13, x[1] - 0.1265), (lo + 0.03, hi - 0.03), (0.44, 0.444), "lamp glow", bevel=0.0)
    middle = (ys[1] + w / 2) / 2 if side < 0 else (ys[0] - w / 2) / 2
    reach = min(0.3, 0.5 * (w - rack) - 0.12)
    with b.solid("tray"), b.slide("tray", limits=(0.0, 0.28)):
        b.box((x[1] - 0.36, x[1] - 0.03), (middle - reach, middle + reach), (low - 0.065, low - 0.05), top)
        b.box(
            (x[1] - 0.2, x[1] - 0.07),
            (middle - 0.21, middle + 0.21),
            (low - 0.05, low - 0.032),
            "black plastic",
            bevel=0.004,
        )
        for k in (-1, 1):
            at = middle + k * (reach - 0.01)
            b.box((x[1] - 0.36, x[1] - 0.06), (at - 0.008, at + 0.008), (low - 0.05, low - 0.002), metal)
    b.clear((x[0] + 0.1, x[1]), (middle - reach, middle + reach), (0.0, 0.62))
    b.fit()


@draws("dressing_table")
def dressing_table(b: Builder) -> None:
    """A small table with drawers on slim legs and a mirror: round, arched, oval or a tripartite one."""
    d, w, h = b.size
    style = b.pick("pull style", ["knob", "cup"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wood = b.material("body", "white paint", "oak", "walnut", "cream paint", "light oak", "light grey paint")
    metal = b.material("pulls", "brass", "copper", "chrome", "black steel")
    table = 0.76
    low, deep = table - 0.022, 0.12
    face = x[1] - proud(style)
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.02, 3), (low, table), wood, name=None)
        b.box((x[0] + 0.01, face - 0.019), (y[0] + 0.015, y[1] - 0.015), (low - deep, low), wood)
        count = 2 if w < 0.95 else 3
        step = (w - 0.03) / count
        for k in range(count):
            at = y[0] + 0.015 + k * step
            drawer(
                b, f"drawer-{k}", (x[0] + 0.03, face), (at, at + step), (low - deep, low - 0.002), wood, metal, style
            )
    legs = metal if metal.name != "chrome" and b.chance("metal legs", 0.35) else wood
    corner_legs(
        b,
        (x[0] + 0.02, face - 0.01),
        (y[0] + 0.025, y[1] - 0.025),
        low - deep,
        legs,
        b.pick("legs", ["tapered", "splayed", "turned"] if legs is wood else ["round"]),
        0.042,
    )
    b.surface("top", (x[0] + 0.09, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), table)
    kind = b.pick("mirror", ["round", "arch", "oval", "three"])
    frame = metal if b.chance("metal frame", 0.6) else wood
    rise = table + (0.04 if kind in ("round", "oval") else 0.0)
    half = (h - rise) / 2
    reach = {"round": half, "oval": min(0.3 * w, 0.72 * half), "arch": 0.3 * w, "three": 0.2 * w}[kind]
    with b.solid("mirror"):
        if kind in ("round", "oval"):
            ring = ellipse(reach, half, 40)
            _plate(b, ring + (0, rise + half), x[0] + 0.03, 0.02, frame)
            _plate(b, ellipse(reach - 0.018, half - 0.018, 40) + (0, rise + half), x[0] + 0.049, 0.003, "mirror")
            b.box((x[0] + 0.034, x[0] + 0.046), (-0.02, 0.02), (table, rise + 0.03), frame)
            b.box((x[0] + 0.01, x[0] + 0.085), (-0.11, 0.11), (table, table + 0.014), frame)
        else:
            _plate(b, _arch(reach, rise, h), x[0] + 0.03, 0.02, frame)
            _plate(b, _arch(reach - 0.02, rise + 0.02, h - 0.02), x[0] + 0.049, 0.003, "mirror")
    if kind == "three":
        for s in (-1, 1):
            with b.solid(f"wing {s}"), b.frame(x[0] + 0.045, s * (reach + 0.003), 0, yaw=-s * 0.4):
                wide = 0.15 * w
                ring = _arch(wide / 2, rise, h - 0.06) + (s * wide / 2, 0)
                _plate(b, ring, -0.012, 0.02, frame)
                inner = _arch(wide / 2 - 0.018, rise + 0.02, h - 0.08) + (s * wide / 2, 0)
                _plate(b, inner, 0.007, 0.003, "mirror")
    b.clear((x[0] + 0.1, x[1]), (y[0] + 0.1, y[1] - 0.1), (0.0, low - deep - 0.01))


def _plate(b: Builder, ring: np.ndarray, x: float, thick: float, material) -> None:
    """An upright convex plate: corners (y, z), from depth x forward."""
    n = len(ring)
    b.hull(np.concatenate([np.c_[np.full(n, x), ring], np.c_[np.full(n, x + thick), ring]]), material)


def _arch(half: float, low: float, high: float, count: int = 16) -> np.ndarray:
    """A round-headed opening as corners (y, z)."""
    half_high = min(half, 0.5 * (high - low))
    turn = np.linspace(0, math.pi, count + 1)
    return np.concatenate(
        [np.c_[half * np.cos(turn), high - half_high + half_high * np.sin(turn)], [(-half, low), (half, low)]]
    )


@draws("reception_desk")
def reception_desk(b: Builder) -> None:
    """A high counter toward the visitors (+x) and a lower desk behind it, with a panelled or slatted front."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    kind = b.pick("front", ["slats", "panels", "stone", "glow"])
    body = b.material("body", "white paint", "oak", "walnut", "light grey paint", "navy paint", "sage paint")
    counter = b.material("counter", "walnut", "oak", "marble", "white paint", "dark marble", "granite")
    wall = (x[1] - 0.17, x[1] - 0.07)
    table = 0.74
    with b.solid("front"):
        b.box(wall, y, (0.08, h - 0.035), body)
        b.box((wall[0] + 0.02, wall[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0, 0.08), "black steel")
        if kind == "slats":
            slat = b.material("slats", "oak", "walnut", "light oak", "black paint")
            count = round(w / 0.07)
            for k in range(count):
                at = y[0] + (k + 0.5) * w / count
                b.box((wall[1], wall[1] + 0.022), (at - 0.02, at + 0.02), (0.09, h - 0.04), slat)
        elif kind == "panels":
            count = round(w / 0.6)
            for k in range(count):
                lo, hi = y[0] + k * w / count, y[0] + (k + 1) * w / count
                b.box((wall[1], wall[1] + 0.018), (lo + 0.006, hi - 0.006), (0.1, h - 0.06), body, bevel=0.004)
        else:
            face = b.material("face", "marble", "dark marble", "concrete", "walnut")
            b.box((wall[1], wall[1] + 0.02), (y[0] + 0.02, y[1] - 0.02), (0.12, h - 0.09), face)
            if kind == "glow":
                b.box((wall[1], wall[1] + 0.008), (y[0] + 0.02, y[1] - 0.02), (h - 0.085, h - 0.05), "lamp glow", 0.0)
                b.box((wall[1], wall[1] + 0.008), (y[0] + 0.02, y[1] - 0.02), (0.085, 0.115), "lamp glow", bevel=0.0)
    with b.solid("counter"):
        b.box((x[1] - 0.32, x[1]), y, (h - 0.035, h), counter, bevel=0.004)
    b.surface("counter", (x[1] - 0.31, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
    with b.solid("top"):
        b.box((x[0], wall[0]), (y[0] + 0.03, y[1] - 0.03), (table - 0.028, table), counter if kind != "stone" else body)
    b.surface("top", (x[0] + 0.01, wall[0] - 0.01), (y[0] + 0.06, y[1] - 0.06), table, round(h - 0.04 - table, 4))
    profile = [
        (x[0] + 0.02, 0),
        (x[0] + 0.02, table + 0.03),
        (wall[0], 0),
        (wall[0], h - 0.035),
        (wall[0] - 0.1, h - 0.035),
    ]
    for s in (-1, 1):
        ys = (y[1] - 0.03, y[1]) if s > 0 else (y[0], y[0] + 0.03)
        with b.solid(f"side {s}"):
            b.hull([(px, py, pz) for py in ys for px, pz in profile], body)
    pull = b.material("pulls", "black steel", "brushed steel")
    at = -w / 2 + 0.06
    with b.frame((x[0] + wall[0]) / 2, at + 0.21, 0, yaw=math.pi):
        deep = (wall[0] - x[0]) / 2
        drawer_stack(
            b,
            (-deep + 0.01, deep - 0.03),
            (-0.2, 0.2),
            (0.04, table - 0.03),
            body,
            body,
            pull,
            3,
            "cup",
            tall_last=True,
        )
    with b.solid("drawer stack"):
        b.box((x[0] + 0.08, wall[0] - 0.02), (at + 0.03, at + 0.38), (0, 0.04), "black plastic", bevel=0.0)
    b.clear((x[0], wall[0] - 0.02), (at + 0.45, w / 2 - 0.05), (0.0, 0.62))


@draws("workbench")
def workbench(b: Builder) -> None:
    """A thick top on heavy legs with a shelf and a front vice, dog holes, or steel legs with drawers."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2 - 0.07), (-w / 2, w / 2)
    top = b.material("top", "beech", "pine", "plywood", "oak")
    kind = b.pick("kind", ["joiner", "garage", "joiner"])
    low = h - 0.055
    with b.solid("top"):
        planks(b, x, y, (low, h), top, ends=0.0, wide=0.11)
        if kind == "joiner":
            b.box((x[1] - 0.045, x[1] - 0.001), (y[0] + 0.01, y[1] - 0.01), (low - 0.05, low), top)
    metal = b.material("vice", "iron", "black steel", "steel")
    if kind == "joiner":
        at = y[1] - 0.32
        with b.solid("vice"):
            b.box((x[1] + 0.012, x[1] + 0.062), (at - 0.22, at + 0.22), (low - 0.11, h - 0.001), top, bevel=0.006)
            b.bar((x[1] - 0.1, at, low - 0.06), (x[1] + 0.066, at, low - 0.06), 0.014, metal, segments=12)
            b.bar((x[1] - 0.1, at - 0.14, low - 0.06), (x[1] + 0.05, at - 0.14, low - 0.06), 0.009, metal, segments=8)
            b.bar((x[1] - 0.1, at + 0.14, low - 0.06), (x[1] + 0.05, at + 0.14, low - 0.06), 0.009, metal, segments=8)
            b.bar(
                (x[1] + 0.066, at - 0.11, low - 0.09), (x[1] + 0.066, at + 0.08, low - 0.03), 0.004, "steel", segments=8
            )
            b.bar((x[1] + 0.058, at, low - 0.06), (x[1] + 0.07, at, low - 0.06), 0.017, metal, segments=12)
        for k in range(6):
            py = y[0] + 0.15 + k * (w - 0.8) / 6
            with b.frame(x[1] - 0.09, py):
                b.frustum(0.011, 0.011, (h - 0.002, h + 0.0008), "black plastic", segments=10)
    legs = top if kind == "joiner" else b.material("legs", "grey paint", "blue paint", "red paint", "black steel")
    width = 0.09 if kind == "joiner" else 0.05
    corner_legs(b, (x[0] + 0.03, x[1] - 0.045), (y[0] + 0.12, y[1] - 0.12), low, legs, "square", width)
    shelf = 0.2
    with b.solid("shelf"):
        for px in (x[0] + 0.03 + width / 2, x[1] - 0.045 - width / 2):
            b.box(
                (px - 0.02, px + 0.02), (y[0] + 0.12 + width, y[1] - 0.12 - width), (shelf - 0.09, shelf - 0.02), legs
            )
        b.box((x[0] + 0.06, x[1] - 0.075), (y[0] + 0.12 + width, y[1] - 0.12 - width), (shelf - 0.02, shelf), top)
    wide = 0.42
    if kind == "garage":
        pull = b.material("pulls", "black plastic", "steel")
        ys = (y[0] + 0.12 + width, y[0] + 0.12 + width + wide)
        drawer_stack(b, (x[0] + 0.06, x[1] - 0.025), ys, (low - 0.36, low), legs, legs, pull, 3, "cup")
        with b.solid("drawer stack"):
            b.box((x[0] + 0.05, x[1] - 0.05), (ys[1], ys[1] + 0.018), (shelf, low), legs, bevel=0.0)
        b.surface(
            "shelf",
            (x[0] + 0.08, x[1] - 0.1),
            (ys[1] + 0.03, y[1] - 0.14 - width),
            shelf,
            round(low - shelf - 0.005, 4),
        )
    else:
        b.surface(
            "shelf",
            (x[0] + 0.08, x[1] - 0.1),
            (y[0] + 0.15 + width, y[1] - 0.15 - width),
            shelf,
            round(low - 0.11 - shelf - 0.005, 4),
        )
    b.fit()


@draws("drafting_table")
def drafting_table(b: Builder) -> None:
    """A tilted drawing board with a ledge, a parallel rule and a sheet of paper, on a steel or wooden trestle."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    board = b.material("board", "birch", "beech", "white paint", "light oak", "plywood")
    legs = b.material("legs", "black steel", "oak", "white steel", "walnut", "grey paint")
    wooden = legs.name in ("oak", "walnut")
    tilt = b.uniform("tilt", 0.26, 0.42)
    long = (d - 0.06) / math.cos(tilt)
    rise = long * math.sin(tilt)
    middle = h - rise / 2 - 0.03
    with b.solid("board"), b.frame(0, 0, middle, pitch=tilt):
        b.box((-long / 2, long / 2), y, (-0.02, 0.0), board)
        b.box((long / 2 - 0.03, long / 2 + 0.012), (y[0] + 0.05, y[1] - 0.05), (0.0, 0.014), legs)
        b.box((-0.3 * long, 0.36 * long), (-0.3 * w, 0.3 * w), (0.0, 0.0012), "paper", bevel=0.0)
        for k in range(3):
            at = -0.2 * long + 0.09 * k
            b.box((at, at + 0.002), (-0.2 * w, (0.05 + 0.06 * k) * w), (0.0012, 0.0017), "navy paint", bevel=0.0)
        for k in range(2):
            at = -0.2 * w + k * 0.25 * w
            b.box((-0.2 * long, 0.02 * long), (at, at + 0.002), (0.0012, 0.0017), "navy paint", bevel=0.0)
        b.box((0.14 * long, 0.14 * long + 0.045), (y[0] + 0.02, y[1] - 0.02), (0.002, 0.008), "clear plastic", 0.0)
        for s in (-1, 1):
            at = s * (w / 2 - 0.02)
            b.box((0.14 * long - 0.01, 0.14 * long + 0.055), (at - 0.016, at + 0.016), (0.0, 0.013), "black plastic")
        b.hull(
            [
                (0.05, 0.33 * w, 0.0),
                (0.05, 0.33 * w, 0.003),
                (0.05, 0.45 * w, 0.0),
                (0.05, 0.45 * w, 0.003),
                (-0.12, 0.45 * w, 0.0),
                (-0.12, 0.45 * w, 0.003),
            ],
            "clear plastic",
        )
    bar = 0.05 if wooden else 0.035
    reach = min(0.36 * w, w / 2 - 0.1)
    hold = middle - 0.05
    for s in (-1, 1):
        at = s * reach
        with b.solid(f"end {s}"):
            b.box((x[0] + 0.04, x[1] - 0.04), (at - bar / 2, at + bar / 2), (0.0, bar), legs)
            b.box((-0.04, 0.04), (at - bar / 2, at + bar / 2), (bar, hold), legs)
            prism_leg(b, (x[0] + 0.14, at, bar * 0.5), (-0.02, at, 0.45), (0.03, bar * 0.7), (0.03, bar * 0.7), legs)
            with b.frame(0, 0, middle, pitch=tilt):
                b.box((-0.3 * long, 0.3 * long), (at - bar / 2, at + bar / 2), (-0.06, -0.02), legs)
            b.bar(
                (0.0, at + s * bar / 2, hold - 0.02),
                (0.0, at + s * (bar / 2 + 0.03), hold - 0.02),
                0.025,
                "black plastic",
                segments=12,
            )
    for name, z in (("low rail", 0.3), ("rail", hold - 0.14)):
        with b.solid(name):
            b.box((-0.02, 0.02), (-reach + bar / 2, reach - bar / 2), (z - 0.025, z + 0.025), legs)
    b.fit()


@draws("lab_bench")
def lab_bench(b: Builder) -> None:
    """A dark resistant top over cupboards and drawers with a gap for knees, a basin with a tap, a shelf above."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    body = b.material("body", "white paint", "light grey paint", "blue paint", "sage paint")
    top = b.material("top", "black paint", "granite", "grey ceramic", "white ceramic")
    pull = b.material("pulls", "brushed steel", "black steel")
    table = 0.9
    low = table - 0.03
    with b.solid("top"):
        b.box(x, y, (low, table), top, bevel=0.004)
    rack = x[0] + 0.24
    s = b.pick("sink side", [-1, 1])
    sink = s * (w / 2 - 0.28)
    with b.solid("sink"):
        b.box((0.0, 0.3), (sink - 0.2, sink + 0.2), (table, table + 0.008), "brushed steel", bevel=0.003)
        b.box((0.02, 0.28), (sink - 0.18, sink + 0.18), (table + 0.008, table + 0.009), "black steel", bevel=0.0)
        neck = [(-0.03, 0.0), (-0.03, 0.26), (0.0, 0.32), (0.07, 0.34), (0.13, 0.3), (0.14, 0.24)]
        b.tube([(px, sink, table + pz) for px, pz in neck], 0.011, "chrome", segments=10)
        b.bar((-0.03, sink - 0.05, table + 0.06), (-0.03, sink + 0.05, table + 0.06), 0.009, "chrome", segments=8)
        for k, look in ((-1, "blue plastic"), (1, "red plastic")):
            b.bar((-0.03, sink + k * 0.05, table + 0.06), (-0.03, sink + k * 0.075, table + 0.06), 0.014, look, 10)
    clear = (-w / 2 + 0.01, sink - 0.22) if s > 0 else (sink + 0.22, w / 2 - 0.01)
    b.surface("top", (rack + 0.02, x[1] - 0.01), clear, table)
    face = x[1] - 0.045
    wide = min(0.5, 0.3 * w)
    for k in (-1, 1):
        ys = (y[1] - 0.01 - wide, y[1] - 0.01) if k > 0 else (y[0] + 0.01, y[0] + 0.01 + wide)
        if k == s:
            with b.solid(f"cupboard {k}"):
                b.box((x[0] + 0.02, face - 0.019), ys, (0.09, low), body, bevel=0.001)
                b.box((x[0] + 0.04, face - 0.06), ys, (0.0, 0.09), "black plastic", bevel=0.0)
                door(
                    b,
                    "door",
                    (face - 0.018, face),
                    ys,
                    (0.09, low - 0.002),
                    body,
                    pull,
                    hung="left" if s > 0 else "right",
                )
        else:
            drawer_stack(b, (x[0] + 0.02, face), ys, (0.09, low), body, body, pull, 4, "bar")
            with b.solid("drawer stack"):
                b.box((x[0] + 0.04, face - 0.06), ys, (0.0, 0.09), "black plastic", bevel=0.0)
    inner = (y[0] + 0.01 + wide, y[1] - 0.01 - wide)
    with b.solid("back"):
        b.box((x[0] + 0.02, x[0] + 0.04), inner, (0.0, low), body, bevel=0.0)
    for k in (-1, 1):
        at = k * (w / 2 - 0.03)
        with b.solid("posts"):
            b.box((x[0] + 0.08, x[0] + 0.12), (at - 0.02, at + 0.02), (table, h - 0.2), "brushed steel")
    shelf = h - 0.2
    with b.solid("shelf"):
        b.box((x[0], rack), y, (shelf - 0.02, shelf), body)
        b.box((x[0] + 0.04, x[0] + 0.16), (y[0] + 0.1, y[1] - 0.1), (shelf - 0.045, shelf - 0.02), "lamp glow")
    for k in range(5):
        look = ("amber glass", "green glass", "glass", "amber glass", "white plastic")[k]
        at = s * (w / 2 - 0.1 - 0.11 * k)
        tall = b.uniform(f"bottle {k}", 0.12, 0.17) if k else 0.2
        with b.solid("bottles"), b.frame(x[0] + 0.09, at, shelf):
            b.lathe(
                [(0.036, 0.0), (0.038, 0.01), (0.038, 0.6 * tall), (0.014, 0.78 * tall), (0.014, 0.88 * tall)],
                look,
                segments=14,
            )
            b.frustum(0.017, 0.017, (0.88 * tall, tall), "blue plastic" if k % 2 else "black plastic", segments=12)
    far = (-w / 2 + 0.02, s * w / 2 - 0.68) if s > 0 else (-w / 2 + 0.68, w / 2 - 0.02)
    b.surface("shelf", (x[0] + 0.02, rack - 0.02), far, shelf)
    b.clear((x[0] + 0.1, x[1]), (inner[0] + 0.01, inner[1] - 0.01), (0.0, 0.8))
