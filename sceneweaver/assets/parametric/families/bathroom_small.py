"""Bathroom accessories: towels, mirrors, paper, mats, hampers, bars, dispensers."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder
from ..joinery import carcass
from ..registry import draws
from .kitchen_parts import Finish, egg, loft, oval, rounded
from .small_containers import open_box
from .small_kit import OPEN

_METALS = ("chrome", "black steel", "brass", "brushed steel")
_TERRY = (
    "white fabric",
    "blue fabric",
    "green fabric",
    "rose fabric",
    "grey fabric",
    "mustard fabric",
    "beige fabric",
    "navy fabric",
)


def _towel(b: Builder, x: float, y: tuple, top: float, front: float, back: float, r: float, cloth: Finish) -> None:
    """A towel over a bar at (x, top - r) with a woven band, its ends at two heights."""
    b.box((x + r, x + r + 0.012), y, (front, top - r), cloth, bevel=0.004)
    b.box((x - r - 0.012, x - r), y, (back, top - r), cloth, bevel=0.004)
    ring = [
        (x + (r + 0.012) * math.cos(t), top - r - 0.012 + (r + 0.012) * math.sin(t)) for t in np.linspace(0, math.pi, 9)
    ]
    b.hull([(px, py, pz) for px, pz in ring for py in y], cloth)
    b.box(
        (x + r + 0.0118, x + r + 0.0135),
        y,
        (front + 0.05, front + 0.075),
        "white fabric" if "white" not in str(cloth) else "grey fabric",
        bevel=0,
    )


@draws("towel_rail")
def towel_rail(b: Builder) -> None:
    """One or two bars on two brackets with a hung towel."""
    d, w, h = b.size
    metal = b.material("bar", *_METALS)
    cloth = b.material("towel", *_TERRY)
    z = h - 0.025
    x = d / 2 - 0.025
    with b.solid("rail"):
        b.bar((x, -w / 2, z), (x, w / 2, z), 0.009, metal)
        for s in (-1, 1):
            py = s * (w / 2 - 0.03)
            b.bar((-d / 2, py, z), (x, py, z), 0.009, metal)
            with b.frame(-d / 2, py, z, pitch=math.pi / 2):
                b.frustum(0.025, 0.023, (0.0, 0.008), metal, segments=18)
        at = b.uniform("at", -0.12, 0.12) * w
        half = min(0.2, 0.3 * w)
        _towel(b, x, (at - half, at + half), h, 0.0, 0.06, 0.012, cloth)
    b.fit()


@draws("towel_radiator")
def towel_radiator(b: Builder) -> None:
    """Two uprights and many tubes in groups, on four brackets, with a valve; a towel on some."""
    d, w, h = b.size
    metal = b.material("body", "white steel", "white steel", "chrome", "black steel")
    x = d / 2 - 0.035
    r = 0.011
    with b.solid("radiator"):
        for s in (-1, 1):
            b.box(
                (x - 0.017, x + 0.013),
                (s * (w / 2 - 0.015) - 0.015, s * (w / 2 - 0.015) + 0.015),
                (0.06, h),
                metal,
                bevel=0.005,
            )
            for z in (0.2, h - 0.15):
                b.bar((-d / 2, s * (w / 2 - 0.05), z), (x, s * (w / 2 - 0.05), z), 0.01, metal, 8)
            with b.frame(x, s * (w / 2 - 0.015), 0.0):
                b.frustum(0.012, 0.012, (0.0, 0.065), "chrome", segments=12)
        with b.frame(x, w / 2 - 0.015, 0.03, roll=math.pi / 2):
            b.frustum(0.022, 0.02, (-0.004, 0.055), "white plastic", segments=14)
        n = int((h - 0.14) / 0.042)
        gaps = {int(n * f) for f in ((0.33, 0.66) if h < 1.2 else (0.25, 0.5, 0.78))}
        step = (h - 0.12) / n
        for k in range(n):
            if k in gaps or k - 1 in gaps:
                continue
            z = 0.1 + k * step
            b.bar((x, -w / 2 + 0.02, z), (x, w / 2 - 0.02, z), r, metal, 8)
        if b.chance("towel", 0.5):
            g = sorted(gaps)[-1]
            z = 0.1 + (g - 1) * step + r
            _towel(b, x, (-w * 0.28, w * 0.3), z + 0.012, z - 0.42, z - 0.3, r, b.material("towel", *_TERRY))
    b.fit()


@draws("medicine_cabinet")
def medicine_cabinet(b: Builder) -> None:
    """A shallow cupboard whose one, two or three doors are mirrors; boards inside, a lamp above some."""
    d, w, h = b.size
    shell = b.material("body", "white paint", "aluminium", "oak", "walnut", "light grey paint")
    lamp = b.chance("lamp", 0.5)
    top = h - 0.03 if lamp else h
    x, y = (-d / 2, d / 2 - 0.03), (-w / 2, w / 2)
    count = 1 if w < 0.55 else 2 if w < 0.78 else 3
    step = w / count
    with b.solid("cabinet"):
        inside = carcass(b, x, y, (0.0, top), shell, board=0.014)
        for k in (1, 2):
            z = k * top / 3
            b.box((x[0] + 0.006, x[1] - 0.01), inside[1], (z - 0.003, z + 0.003), "glass", bevel=0)
        for k in range(count):
            ys = (y[0] + k * step + 0.0015, y[0] + (k + 1) * step - 0.0015)
            left = k == count - 1
            at = ys[1] if left else ys[0]
            with b.hinge(f"door-{k}", (x[1] + 0.018, at, 0.0), limits=(0.0, 1.7) if left else (-1.7, 0.0)):
                b.box((x[1] + 0.0005, x[1] + 0.014), ys, (0.0015, top - 0.0015), shell, bevel=0.001)
                f = 0.016 if shell.name in ("oak", "walnut") else 0.003
                b.box((x[1] + 0.012, x[1] + 0.018), (ys[0] + f, ys[1] - f), (f, top - f), "mirror", bevel=0.0025)
                side = ys[0] + 0.02 if left else ys[1] - 0.02
                if f > 0.01:
                    side = ys[0] + 0.008 if left else ys[1] - 0.008
                b.box(
                    (x[1] + 0.013, x[1] + 0.028),
                    (side - 0.005, side + 0.005),
                    (0.3 * top, 0.3 * top + 0.05),
                    "chrome",
                    bevel=0.002,
                )
        if lamp:
            b.box((x[0], x[1] + 0.03), (y[0] + 0.03, y[1] - 0.03), (top, h), "chrome", bevel=0.004)
            b.box(
                (x[1] + 0.0, x[1] + 0.0305),
                (y[0] + 0.05, y[1] - 0.05),
                (top - 0.0005, top + 0.022),
                "lamp glow",
                bevel=0.002,
            )
    b.fit()


@draws("toilet_paper_stand")
def toilet_paper_stand(b: Builder) -> None:
    """A rod on a round foot with an arm that holds a roll, and a spare one on the foot."""
    d, w, h = b.size
    metal = b.material("rod", *_METALS)
    r = min(d, w) / 2
    with b.solid("stand"):
        b.frustum(r, r - 0.004, (0.0, 0.014), metal, segments=28, bevel=0.002)
        b.bar((0.0, -r + 0.03, 0.01), (0.0, -r + 0.03, h), 0.008, metal, 12)
        b.bar((0.0, -r + 0.03, h - 0.008), (0.0, r - 0.012, h - 0.008), 0.007, metal, 10)
        with b.frame(0.0, 0.012, h - 0.028, roll=math.pi / 2):
            b.frustum(0.05, 0.05, (-0.045, 0.045), "paper", segments=24)
            b.frustum(0.02, 0.02, (-0.0455, 0.0455), "cardboard", segments=16)
        b.box((0.0455, 0.047), (-0.03, 0.055), (h - 0.16, h - 0.03), "paper", bevel=0)
    with b.solid("spare"):
        for k in range(2):
            with b.frame(0.0, 0.025, 0.0145 + 0.092 * k):
                b.frustum(0.048, 0.048, (0.0, 0.09), "paper", segments=24)
    b.fit()


@draws("toilet_paper_holder")
def toilet_paper_holder(b: Builder) -> None:
    """A bent bar, or one with a flap, and a roll with a hanging leaf."""
    d, w, h = b.size
    metal = b.material("bar", *_METALS)
    r = d / 2 - 0.008
    z = h - 0.022 - 0.02
    cx = d / 2 - r
    with b.solid("holder"):
        with b.frame(cx, 0.0, z - 0.012, roll=math.pi / 2):
            b.frustum(r, r, (-0.05, 0.05), "paper", segments=28)
            b.frustum(0.02, 0.02, (-0.0505, 0.0505), "cardboard", segments=16)
        b.box((d / 2 - 0.0035, d / 2 - 0.002), (-0.05, 0.05), (0.0, z - 0.012), "paper", bevel=0)
        with b.frame(-d / 2, -w / 2 + 0.02, h - 0.025, pitch=math.pi / 2):
            b.frustum(0.02, 0.02, (0.0, 0.012), metal, segments=18, bevel=0.002)
        b.tube(
            [
                (-d / 2 + 0.01, -w / 2 + 0.02, h - 0.025),
                (cx, -w / 2 + 0.02, h - 0.025),
                (cx, -w / 2 + 0.011, z - 0.012),
                (cx, w / 2 - 0.006, z - 0.012),
            ],
            0.006,
            metal,
            8,
        )
        b.bar((cx, w / 2 - 0.006, z - 0.013), (cx, w / 2 - 0.006, z + 0.01), 0.006, metal, 8)
        if b.chance("flap", 0.6):
            b.hull(
                [
                    (px, py, pz)
                    for px, pz in (
                        (-d / 2, h - 0.012),
                        (-d / 2, h),
                        (cx, h),
                        (d / 2 - 0.01, h - 0.02),
                        (d / 2 - 0.01, h - 0.023),
                        (cx, h - 0.004),
                    )
                    for py in (-0.052, 0.058)
                ],
                metal,
            )
    b.fit()


@draws("bathroom_shelf")
def bathroom_shelf(b: Builder) -> None:
    """Two or three glass or wooden boards with rails, between wall strips."""
    d, w, h = b.size
    metal = b.material("metal", *_METALS)
    board = b.material("board", "glass", "oak", "bamboo", "white paint", "frosted glass")
    count = 2 if h < 0.42 else 3
    t = 0.008 if "glass" in board.name else 0.015
    rail = 0.045
    zs = [0.02 + k * (h - 0.02 - t - rail) / (count - 1) for k in range(count)]
    with b.solid("wall"):
        for s in (-1, 1):
            b.box(
                (-d / 2, -d / 2 + 0.01),
                (s * (w / 2 - 0.04) - 0.01, s * (w / 2 - 0.04) + 0.01),
                (0.0, h),
                metal,
                bevel=0.002,
            )
    for k, z in enumerate(zs):
        with b.solid(f"board {k}"):
            b.box((-d / 2 + 0.0105, d / 2 - 0.012), (-w / 2, w / 2), (z, z + t), board, bevel=0.002)
            for s in (-1, 1):
                py = s * (w / 2 - 0.04)
                b.box((-d / 2 + 0.01, d / 2 - 0.02), (py - 0.007, py + 0.007), (z - 0.012, z), metal, bevel=0)
        with b.solid(f"rail {k}"):
            zr = z + t + 0.03
            b.bar((d / 2 - 0.006, -w / 2 + 0.004, zr), (d / 2 - 0.006, w / 2 - 0.004, zr), 0.004, metal, 8)
            for s in (-1, 1):
                b.bar(
                    (d / 2 - 0.006, s * (w / 2 - 0.012), z), (d / 2 - 0.006, s * (w / 2 - 0.012), zr), 0.004, metal, 8
                )
        up = None if k == count - 1 else round(zs[k + 1] - 0.014 - z - t, 4)
        b.surface(f"shelf-{k}", (-d / 2 + 0.014, d / 2 - 0.018), (-w / 2 + 0.01, w / 2 - 0.01), z + t, headroom=up)
    b.fit()


@draws("bath_mat")
def bath_mat(b: Builder) -> None:
    """A tufted mat with a hem and rows of pile, or a slatted wooden one."""
    d, w, h = b.size
    if b.chance("slats", 0.25, matched=True):
        wood = b.material("mat", "bamboo", "oak", "walnut")
        with b.solid("mat"):
            n = int(w / 0.055)
            step = w / n
            for s in (-0.32, 0.32):
                b.box((s * d - 0.02, s * d + 0.02), (-w / 2 + 0.01, w / 2 - 0.01), (0.0, h * 0.5), wood, bevel=0.001)
            for k in range(n):
                y = -w / 2 + k * step
                b.box((-d / 2, d / 2), (y, y + step - 0.008), (h * 0.45, h), wood, bevel=0.002)
    else:
        cloth = b.material("mat", *_TERRY)
        round_ends = b.chance("oval", 0.3, matched=True)
        with b.solid("mat"):
            if round_ends:
                loft(
                    b,
                    [
                        oval(d / 2 - 0.004, w / 2 - 0.004, 0.0),
                        oval(d / 2, w / 2, h * 0.4),
                        oval(d / 2 - 0.006, w / 2 - 0.006, h * 0.75),
                    ],
                    cloth,
                    whole=True,
                )
                loft(
                    b,
                    [oval(d / 2 - 0.05, w / 2 - 0.05, h * 0.7), oval(d / 2 - 0.055, w / 2 - 0.055, h)],
                    cloth,
                    whole=True,
                )
            else:
                x, y = (-d / 2, d / 2), (-w / 2, w / 2)
                loft(b, [rounded(x, y, 0.03, 0.0), rounded(x, y, 0.03, h * 0.5)], cloth, whole=True)
                n = int((w - 0.06) / 0.03)
                step = (w - 0.06) / n
                for k in range(n):
                    a = y[0] + 0.03 + k * step
                    b.box((x[0] + 0.03, x[1] - 0.03), (a + 0.002, a + step - 0.002), (h * 0.45, h), cloth, bevel=0.005)
    b.fit()


@draws("laundry_hamper")
def laundry_hamper(b: Builder) -> None:
    """A woven box with a lid, bands of weave and grips, on four feet, or an open one."""
    d, w, h = b.size
    weave = b.material("body", "wicker", "rattan")
    if b.request.shape == OPEN:
        open_box(b, d, w, h, weave, 0.012, 0.03)
        b.fit()
        return
    band: Finish = {"wicker": "rattan", "rattan": "wicker"}.get(weave.name, "wicker")
    n = 22
    top = h - 0.035
    with b.solid("hamper"):
        x, y = d / 2, w / 2
        for k in range(n):
            z0, z1 = 0.02 + k * (top - 0.02) / n, 0.02 + (k + 1) * (top - 0.02) / n
            f = 0.86 + 0.12 * (k + 0.5) / n
            o = 0.0 if k % 2 else 0.006
            xs, ys = x * f - o, y * f - o
            loft(
                b,
                [rounded((-xs, xs), (-ys, ys), 0.03, z0), rounded((-xs, xs), (-ys, ys), 0.03, z1)],
                band if k % 2 or k == n - 3 else weave,
            )
        for sx in (-1, 1):
            for sy in (-1, 1):
                with b.frame(sx * (x * 0.86 - 0.04), sy * (y * 0.86 - 0.04)):
                    b.frustum(0.014, 0.016, (0.0, 0.021), "oak", segments=10)
        with b.hinge("lid", (-x, 0.0, h - 0.01), axis=(0.0, 1.0, 0.0), limits=(-1.4, 0.0)):  # clear of a wall
            ins = 0.015
            loft(
                b,
                [
                    rounded((-x, x), (-y, y), 0.035, top + 0.001),
                    rounded((-x, x), (-y, y), 0.035, h - 0.01),
                    rounded((-x + ins, x - ins), (-y + ins, y - ins), 0.03, h),
                ],
                weave,
                whole=True,
            )
            b.box((x - 0.03, x), (-0.035, 0.035), (top + 0.0005, h - 0.012), "brown leather", bevel=0)
        for s in (-1, 1):
            yy = y * 0.955
            b.tube(
                [
                    (-0.07, s * yy, top - 0.14),
                    (-0.05, s * (yy + 0.012), top - 0.1),
                    (0.05, s * (yy + 0.012), top - 0.1),
                    (0.07, s * yy, top - 0.14),
                ],
                0.008,
                band,
                8,
            )
    b.fit()


@draws("scale")
def scale(b: Builder) -> None:
    """A glass plate on feet with a display and steel contacts, or a padded one with a dial."""
    d, w, h = b.size
    look = b.material(
        "plate", "black glass", "white plastic", "frosted glass", "grey plastic", "white plastic", "bamboo"
    )
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    # Its user stands with the toes toward the display, at -x, and reads it from +x.
    with b.solid("scale"):
        for px in (x[0] + 0.04, x[1] - 0.04):
            for py in (y[0] + 0.04, y[1] - 0.04):
                with b.frame(px, py):
                    b.frustum(0.02, 0.022, (0.0, 0.0085), "black plastic", segments=14)
        b.box((x[0] + 0.02, x[1] - 0.02), (y[0] + 0.02, y[1] - 0.02), (0.008, h - 0.009), "grey plastic", bevel=0.002)
        loft(
            b,
            [
                rounded(x, y, 0.03, h - 0.009),
                rounded(x, y, 0.03, h - 0.001),
                rounded((x[0] + 0.002, x[1] - 0.002), (y[0] + 0.002, y[1] - 0.002), 0.03, h),
            ],
            look,
            whole=True,
        )
        b.box((x[0] + 0.025, x[0] + 0.075), (-0.05, 0.05), (h - 0.002, h + 0.0008), "black glass", bevel=0)
        for k in range(3):
            a = -0.027 + k * 0.02
            b.box((x[0] + 0.038, x[0] + 0.062), (a, a + 0.013), (h, h + 0.0012), "lamp glow", bevel=0)
        for s in (-1, 1):
            for px in (-0.02, 0.07):
                b.box(
                    (px - 0.025, px + 0.025),
                    (s * w * 0.26 - 0.035, s * w * 0.26 + 0.035),
                    (h - 0.002, h + 0.0008),
                    "brushed steel",
                    bevel=0,
                )
    b.fit()


@draws("shower_stool")
def shower_stool(b: Builder) -> None:
    """A slatted or holed seat on four splayed legs with rubber feet."""
    d, w, h = b.size
    wood = b.chance("wood", 0.5)
    seat = (
        b.material("seat", "bamboo", "oak", "walnut") if wood else b.material("seat", "white plastic", "grey plastic")
    )
    leg: Finish = seat if wood else b.material("legs", "aluminium", "chrome", "white steel")
    top = h - 0.028
    with b.solid("legs"):
        for sx in (-1, 1):
            for sy in (-1, 1):
                foot, head = (sx * (d / 2 - 0.018), sy * (w / 2 - 0.018)), (sx * (d / 2 - 0.05), sy * (w / 2 - 0.06))
                b.bar((*foot, 0.02), (*head, top), 0.013, leg, 12)
                with b.frame(*foot):
                    b.frustum(0.018, 0.015, (0.0, 0.03), "rubber", segments=12)
        z = top - 0.11
        for s in (-1, 1):
            b.bar((s * (d / 2 - 0.042), -w / 2 + 0.055, z), (s * (d / 2 - 0.042), w / 2 - 0.055, z), 0.008, leg, 8)
        b.bar((-d / 2 + 0.042, 0.0, z), (d / 2 - 0.042, 0.0, z), 0.008, leg, 8)
        if wood:
            n = 6
            step = (d - 0.03) / n
            for s in (-1, 1):
                b.box(
                    (-d / 2 + 0.02, d / 2 - 0.02),
                    (s * (w / 2 - 0.06) - 0.015, s * (w / 2 - 0.06) + 0.015),
                    (top - 0.02, top),
                    seat,
                )
            for k in range(n):
                a = -d / 2 + 0.015 + k * step
                b.box((a + 0.003, a + step - 0.003), (-w / 2, w / 2), (top, h), seat, bevel=0.004)
        else:
            x, y = (-d / 2 + 0.015, d / 2 - 0.015), (-w / 2, w / 2)
            loft(
                b,
                [
                    rounded(x, y, 0.06, top - 0.005),
                    rounded(x, y, 0.06, h - 0.006),
                    rounded((x[0] + 0.008, x[1] - 0.008), (y[0] + 0.008, y[1] - 0.008), 0.055, h),
                ],
                seat,
                whole=True,
            )
            for i in range(3):
                for j in range(5):
                    with b.frame((i - 1) * 0.06, (j - 2) * 0.06, h):
                        b.frustum(0.008, 0.008, (-0.004, 0.0003), "black plastic", segments=10)
    if not wood:
        b.surface("top", (-d / 2 + 0.05, d / 2 - 0.05), (-w / 2 + 0.05, w / 2 - 0.05), h)
    b.fit()


@draws("grab_bar")
def grab_bar(b: Builder) -> None:
    """A thick bar bent to the wall at both ends, with round plates."""
    d, w, h = b.size
    metal = b.material("bar", "brushed steel", "chrome", "white steel", "black steel")
    z, x = h / 2, d / 2 - 0.016
    e = w / 2 - h / 2
    with b.solid("bar"):
        b.tube(
            [
                (-d / 2 + 0.004, -e, z),
                (x - 0.025, -e, z),
                (x - 0.007, -e + 0.008, z),
                (x, -e + 0.03, z),
                (x, e - 0.03, z),
                (x - 0.007, e - 0.008, z),
                (x - 0.025, e, z),
                (-d / 2 + 0.004, e, z),
            ],
            0.016,
            metal,
            12,
        )
        for s in (-1, 1):
            with b.frame(-d / 2, s * e, z, pitch=math.pi / 2):
                b.frustum(h / 2, h / 2 - 0.006, (0.0, 0.009), metal, segments=24)
    b.fit()


@draws("hand_dryer")
def hand_dryer(b: Builder) -> None:
    """A rounded case with a nozzle below, a sensor, a grille and a sign."""
    d, w, h = b.size
    coat = b.material("body", "white plastic", "brushed steel", "chrome", "black plastic", "white steel")
    with b.solid("dryer"):
        b.cushion((-d / 2, d / 2), (-w / 2, w / 2), (0.04, h), coat, radius=min(0.06, d * 0.4))
        b.hull(
            [
                (px, py, z)
                for px, py, z in [(x, s * 0.075, 0.06) for x in (-0.03, d / 2 - 0.02) for s in (-1, 1)]
                + [(x, s * 0.055, 0.0) for x in (-0.005, d / 2 - 0.02) for s in (-1, 1)]
            ],
            "chrome",
        )
        b.hull(
            [(px, s * 0.045, z) for px in (0.005, d / 2 - 0.03) for s in (-1, 1) for z in (-0.0015, 0.004)],
            "black plastic",
        )
        f = d / 2
        b.box((f - 0.02, f + 0.0008), (-0.045, 0.045), (0.55 * h, 0.55 * h + 0.05), "black glass", bevel=0)
        b.box((f - 0.02, f + 0.0012), (-0.006, 0.006), (0.55 * h + 0.019, 0.55 * h + 0.031), "lamp glow", bevel=0)
        for k in range(4):
            z = 0.1 + k * 0.014
            b.box((f - 0.02, f + 0.001), (-0.05, 0.05), (z + 0.03, z + 0.036), "grey plastic", bevel=0)
    b.fit()


@draws("paper_towel_dispenser")
def paper_towel_dispenser(b: Builder) -> None:
    """A case with a bowed front, a window, a lock, a slot below and a towel that hangs out."""
    d, w, h = b.size
    coat = b.material("body", "white plastic", "brushed steel", "black plastic", "grey plastic")
    z0 = 0.06
    with b.solid("dispenser"):
        x = -d / 2

        def ring(k: float, z: float):

            return egg(d * k, 0.0001, w / 2, z, x, 0.0, 3.2, 8.0, 24)

        loft(b, [ring(0.86, z0), ring(1.0, z0 + 0.06), ring(1.0, h - 0.03), ring(0.9, h)], coat, whole=True)
        b.box((0.0, d / 2 - 0.022), (-0.085, 0.085), (z0 - 0.003, z0 + 0.01), "black plastic", bevel=0)
        b.hull(
            [(px + o, s * 0.075, z) for px, z in ((0.012, z0), (0.02, 0.0)) for o in (0.0, 0.002) for s in (-1, 1)],
            "paper",
        )
        b.hull(
            [(px + o, s * 0.075, z) for px, z in ((0.026, z0), (0.036, 0.015)) for o in (0.0, 0.002) for s in (-1, 1)],
            "paper",
        )
        f = d / 2
        b.box((f - 0.02, f + 0.0006), (-0.02, 0.02), (z0 + 0.08, h - 0.12), "black glass", bevel=0)
        b.box(
            (f - 0.02, f + 0.001), (-0.0185, 0.0185), (z0 + 0.0815, z0 + 0.08 + 0.6 * (h - 0.2 - z0)), "paper", bevel=0
        )
        with b.frame(f - 0.004, 0.0, h - 0.07, pitch=math.pi / 2):
            b.frustum(0.012, 0.011, (0.0, 0.005), "chrome", segments=14)
    b.fit()
