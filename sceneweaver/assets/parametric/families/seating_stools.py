"""Stools, benches, ottomans, poufs, bean bags."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from ... import shapes
from ..builder import Builder
from ..joinery import legs
from ..registry import draws
from .seating_parts import arc_panel, leg, splayed, square_leg

_COVERS = ("@fabric", "brown leather", "tan leather", "black leather")


def _ring(b: Builder, r: float, z: float, radius: float, material, count: int = 12) -> None:
    angle = np.arange(count) * 2 * np.pi / count
    b.tube(np.c_[r * np.cos(angle), r * np.sin(angle), np.full(count, z)], radius, material, segments=6, closed=True)


@draws("stool")
def stool(b: Builder) -> None:
    """A round or square seat on three or four legs with stretchers."""
    d, w, h = b.size
    wood = b.material("seat", "oak", "walnut", "beech", "birch", "white paint", "black paint", "teal paint")
    under = b.material("legs", "black steel", "brass") if b.chance("metal legs", 0.25) else wood
    r = 0.5
    round_seat, count = b.chance("round", 0.7), b.pick("legs", [3, 4, 4])
    thick = 0.035
    padded = b.chance("padded", 0.3)
    with b.solid("stool"):
        top = h - thick
        if round_seat:
            if padded:
                cover = b.material("cover", *_COVERS)
                b.frustum(r * 0.36, r * 0.36, (top - 0.01, top + 0.012), wood, segments=28, bevel=0.004)
                b.lathe([(0.165, top + 0.01), (0.178, top + 0.022), (0.178, h - 0.012), (0.168, h)], cover, segments=28)
            else:
                b.lathe([(0.15, top), (0.178, top + 0.012), (0.18, h - 0.008), (0.174, h)], wood, segments=28)
            b.surface(
                "top",
                (0, 0),
                (0, 0),
                h,
                polygon=[(0.15 * math.cos(k * math.pi / 4), 0.15 * math.sin(k * math.pi / 4)) for k in range(8)],
            )
        else:
            b.box((-0.18, 0.18), (-0.18, 0.18), (top, h), wood, bevel=0.008)
            b.surface("top", (-0.165, 0.165), (-0.165, 0.165), h)
        foot, head = 0.175, 0.115
        low, high = (0.009, 0.009) if under is not wood else (0.011, 0.018)
        spots = [
            (math.cos(a), math.sin(a))
            for a in (2 * math.pi * (k + 0.5) / count + (math.pi if count == 3 else 0) for k in range(count))
        ]
        if not round_seat:
            spots, foot, head = [(1, 1), (-1, 1), (-1, -1), (1, -1)], 0.16, 0.14
        for c, s in spots:
            leg(b, (foot * c, foot * s, 0), (head * c, head * s, top + 0.004), low, high, under)
        share = 0.38
        at = foot + (head - foot) * share
        if under is not wood and round_seat:
            _ring(b, at, share * top, 0.007, under)
        else:
            for (c, s), (e, f) in zip(spots, spots[1:] + spots[:1], strict=True):
                b.bar((at * c, at * s, share * top), (at * e, at * f, share * top), 0.009, under, segments=8)
    b.fit()


@draws("bar_stool")
def bar_stool(b: Builder) -> None:
    """A high seat with a foot rest: four legs or a pedestal, with or without a low back."""
    d, w, h = b.size
    metal = b.material("frame", "black steel", "chrome", "brass", "oak", "walnut")
    backed = h > 0.82
    seat = min(h - 0.2, 0.76) if backed else h
    cover = b.material("cover", "@fabric", "black leather", "tan leather", "oak", "walnut")
    kind = b.pick("kind", ["pedestal", "four legs", "four legs"])
    with b.solid("seat"):
        if kind == "pedestal":
            b.lathe([(0.2, 0), (0.205, 0.008), (0.1, 0.022), (0.035, 0.035), (0.03, 0.05)], metal, segments=28)
            b.frustum(0.028, 0.028, (0.03, 0.36), metal, segments=14)
            b.frustum(0.019, 0.019, (0.36, seat - 0.07), metal, segments=14)
            _ring(b, 0.15, 0.27, 0.009, metal, 14)
            b.bar((-0.15, 0, 0.27), (0.15, 0, 0.27), 0.009, metal, segments=6)
            b.frustum(0.07, 0.1, (seat - 0.085, seat - 0.065), metal, segments=16)
        else:
            foot, head = 0.18, 0.14
            for sx in (-1, 1):
                for sy in (-1, 1):
                    square_leg(b, (sx * foot, sy * foot, 0), (sx * head, sy * head, seat - 0.06), 0.022, 0.03, metal)
            for z, pairs in ((0.24, (0, 2)), (0.3, (1, 3))):
                at = foot + (head - foot) * z / (seat - 0.06)
                ring = [(at, -at), (at, at), (-at, at), (-at, -at)]
                for k in pairs:
                    (ax, ay), (cx, cy) = ring[k], ring[(k + 1) % 4]
                    b.bar((ax, ay, z), (cx, cy, z), 0.01, metal, segments=8)
            b.box((-0.15, 0.15), (-0.15, 0.15), (seat - 0.075, seat - 0.05), metal, bevel=0.005)
        if b.chance("square seat", 0.5):
            b.cushion((-0.19, 0.2), (-0.2, 0.2), (seat - 0.07, seat), cover, radius=0.03)
        else:
            b.lathe(
                [(0.16, seat - 0.065), (0.195, seat - 0.05), (0.2, seat - 0.025), (0.185, seat - 0.006), (0.17, seat)],
                cover,
                segments=28,
            )
    if backed:
        with b.solid("back"):
            with b.frame(-0.17, 0, 0):
                arc_panel(b, 0.36, (seat + 0.1, h), 0.035, 0.09, cover, lean=0.03)
            for side in (-1, 1):
                b.bar((-0.15, side * 0.12, seat - 0.06), (-0.17, side * 0.12, seat + 0.14), 0.011, metal, segments=8)
    b.fit()


@draws("bench")
def bench(b: Builder) -> None:
    """A plank or padded seat on legs of several styles, some with a shelf for shoes below."""
    d, w, h = b.size
    wood = b.material("seat", "oak", "walnut", "pine", "light oak", "ash grey wood", "white paint")
    style = b.pick("legs", ["panel", "tapered", "trestle", "metal", "slatted"])
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    padded = b.chance("padded", 0.45)
    thick = 0.035
    top = h - (0.06 if padded else 0.0)
    under = b.material("legs", "black steel", "brass", "white steel") if style == "metal" else wood
    inset = (y[0] + 0.06, y[1] - 0.06)
    with b.solid("top"):
        if style == "slatted":
            for k in range(4):
                step = (d + 0.012) / 4
                b.box((x[0] + k * step, x[0] + (k + 1) * step - 0.012), y, (top - thick, top), wood)
        else:
            b.box(x, y, (top - thick, top), wood, bevel=0.006)
        if padded:
            cover = b.material("cover", *_COVERS)
            count = 3 if w > 1.35 else 2
            step = (w - 0.02) / count
            for k in range(count):
                b.cushion(
                    (x[0] + 0.005, x[1] - 0.005),
                    (y[0] + 0.01 + k * step, y[0] + 0.009 + (k + 1) * step),
                    (top - 0.004, h),
                    cover,
                    radius=0.022,
                )
                b.surface(
                    f"top-{k}", (x[0] + 0.035, x[1] - 0.035), (y[0] + 0.04 + k * step, y[0] - 0.02 + (k + 1) * step), h
                )
        elif style != "slatted":
            b.surface("top", (x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), h)
        floor = top - thick
        if style == "panel":
            legs(b, (x[0] + 0.02, x[1] - 0.02), inset, (0, floor), wood, "panel", 0.06)
            b.box((-0.015, 0.015), (y[0] + 0.09, y[1] - 0.09), (floor - 0.1, floor - 0.02), wood)
        elif style == "trestle":
            for cy in (y[0] + 0.2, y[1] - 0.2):
                for s in (-1, 1):
                    square_leg(b, (s * (d / 2 - 0.03), cy, 0), (s * 0.05, cy, floor), 0.045, 0.045, wood)
                b.box((-0.1, 0.1), (cy - 0.022, cy + 0.022), (floor - 0.035, floor), wood)
            b.box((-0.015, 0.015), (y[0] + 0.2, y[1] - 0.2), (0.55 * floor, 0.55 * floor + 0.06), wood)
        elif style == "metal":
            for cy in (inset[0], inset[1]):
                ring = np.array(
                    [
                        (x[0] + 0.03, cy, 0.0125),
                        (x[1] - 0.03, cy, 0.0125),
                        (x[1] - 0.03, cy, floor - 0.0125),
                        (x[0] + 0.03, cy, floor - 0.0125),
                    ]
                )
                square = 0.0125 * np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
                b.tube(ring, square, under, closed=True)
        else:
            splayed(
                b, (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.03, y[1] - 0.03), (0, floor + 0.002), wood, 0.04, 0.012, 0.022
            )
            b.box((x[0] + 0.06, x[1] - 0.06), (y[0] + 0.09, y[1] - 0.09), (floor - 0.05, floor), wood)
    b.fit()


@draws("storage_bench")
def storage_bench(b: Builder) -> None:
    """A bench over open compartments with baskets, or a chest with a padded lid."""
    d, w, h = b.size
    wood = b.material("body", "white paint", "oak", "pine", "sage paint", "walnut", "light grey paint")
    cover = b.material("cover", *_COVERS)
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    t, seat = 0.02, h - 0.06
    kind = b.pick("kind", ["open", "chest", "open"])
    if kind == "chest":
        with b.solid("chest"):
            b.box((x[0], x[1] - 0.006), y, (0.05, seat - 0.024), wood)
            b.box((x[0] + 0.03, x[1] - 0.05), (y[0] + 0.03, y[1] - 0.03), (0, 0.05), wood)
            for k in range(2 if w < 1.1 else 3):
                n = 2 if w < 1.1 else 3
                step = w / n
                ya, yb = y[0] + k * step + 0.05, y[0] + (k + 1) * step - 0.05
                for ys, zs in (
                    ((ya, yb), (0.09, 0.13)),
                    ((ya, yb), (seat - 0.11, seat - 0.07)),
                    ((ya, ya + 0.04), (0.13, seat - 0.11)),
                    ((yb - 0.04, yb), (0.13, seat - 0.11)),
                ):
                    b.box((x[1] - 0.007, x[1]), ys, zs, wood, bevel=0.002)
        with b.hinge("lid", (x[0], 0.0, seat - 0.02), axis=(0.0, -1.0, 0.0), limits=(0.0, 1.4)), b.solid("chest"):
            b.box((x[0], x[1]), y, (seat - 0.02, seat + 0.004), wood)
            b.cushion((x[0] + 0.01, x[1] - 0.008), (y[0] + 0.01, y[1] - 0.01), (seat, h), cover, radius=0.025)
    else:
        count = 2 if w < 1.05 else 3
        b.box(x, (y[0], y[0] + t), (0, seat), wood, bevel=0.002)
        b.box(x, (y[1] - t, y[1]), (0, seat), wood, bevel=0.002)
        inner = (y[0] + t, y[1] - t)
        with b.solid("floor"):
            b.box((x[0], x[1] - 0.01), inner, (0.03, 0.05), wood, bevel=0.0)
            b.box((x[0] + 0.02, x[1] - 0.05), inner, (0.0, 0.03), wood, bevel=0.0)
        with b.solid("seat"):
            b.box(x, inner, (seat - t, seat), wood, bevel=0.002)
            b.cushion(
                (x[0] + 0.004, x[1] - 0.004), (y[0] + 0.004, y[1] - 0.004), (seat - 0.003, h), cover, radius=0.025
            )
        b.box((x[0], x[0] + 0.006), inner, (0.05, seat - t), wood, bevel=0.0)
        step = (inner[1] - inner[0] + t) / count
        weave = b.material("baskets", "wicker", "rattan", "grey fabric", "beige fabric")
        full = b.whole("baskets", 0, count - 1)
        for k in range(count):
            ya, yb = inner[0] + k * step, inner[0] + (k + 1) * step - t
            if k:
                b.box((x[0] + 0.006, x[1] - 0.005), (ya - t, ya), (0.05, seat - t), wood, bevel=0.0)
            if k < full:
                b.cushion(
                    (x[0] + 0.02, x[1] - 0.02),
                    (ya + 0.015, yb - 0.015),
                    (0.05, 0.05 + 0.72 * (seat - t - 0.05)),
                    weave,
                    radius=0.02,
                )
                middle = (ya + yb) / 2
                b.box(
                    (x[1] - 0.022, x[1] - 0.012),
                    (middle - 0.04, middle + 0.04),
                    (0.22, 0.24),
                    "brown leather",
                    bevel=0.003,
                )
            else:
                b.surface(
                    f"shelf-{k}",
                    (x[0] + 0.012, x[1] - 0.015),
                    (ya + 0.005, yb - 0.005),
                    0.05,
                    headroom=round(seat - t - 0.05 - 0.004, 4),
                )
    if kind != "chest":
        b.surface("top", (x[0] + 0.035, x[1] - 0.035), (y[0] + 0.035, y[1] - 0.035), h)
    b.fit()


@draws("piano_bench")
def piano_bench(b: Builder) -> None:
    """A tufted leather seat on a wooden apron and four legs, with knobs to set its height."""
    d, w, h = b.size
    wood = b.material("legs", "black paint", "mahogany", "walnut", "cherry")
    cover = b.material("cover", "black leather", "brown leather", "black fabric")
    x, y = (-d / 2, d / 2), (-w / 2 + 0.02, w / 2 - 0.02)
    turned = b.chance("turned", 0.5)
    with b.solid("bench"):
        low = h - 0.16
        for cx in (x[0] + 0.03, x[1] - 0.03):
            for cy in (y[0] + 0.03, y[1] - 0.03):
                if turned:
                    with b.frame(cx, cy):
                        b.lathe(
                            [
                                (0.014, 0),
                                (0.02, 0.02),
                                (0.013, 0.05),
                                (0.022, low * 0.55),
                                (0.025, low * 0.8),
                                (0.016, low * 0.86),
                                (0.028, low * 0.92),
                                (0.028, low + 0.06),
                            ],
                            wood,
                            segments=14,
                        )
                else:
                    square_leg(b, (cx, cy, 0), (cx, cy, low + 0.06), 0.032, 0.05, wood)
        b.box((x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), (low + 0.02, h - 0.075), wood)
        b.box(x, y, (h - 0.085, h - 0.07), wood, bevel=0.006)
        for side in (-1, 1):
            with b.frame(0, side * (y[1] - 0.012), low + 0.05, roll=-side * math.pi / 2):
                b.lathe([(0.012, 0), (0.012, 0.012), (0.022, 0.016), (0.022, 0.03), (0.016, 0.034)], wood, segments=14)
        nx, ny = 2, 4 if w > 0.64 else 3
        sx, sy = (d - 0.01) / nx, (y[1] - y[0] - 0.01) / ny
        for i in range(nx):
            for j in range(ny):
                b.cushion(
                    (x[0] + 0.005 + i * sx, x[0] + 0.005 + (i + 1) * sx),
                    (y[0] + 0.005 + j * sy, y[0] + 0.005 + (j + 1) * sy),
                    (h - 0.075, h),
                    cover,
                    radius=0.03,
                )
    b.fit()


@draws("ottoman")
def ottoman(b: Builder) -> None:
    """A padded block on short legs, tufted in some."""
    d, w, h = b.size
    cover = b.material("cover", *_COVERS)
    wood = b.material("legs", "oak", "walnut", "black paint", "brass")
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    foot = b.uniform("foot", 0.06, 0.14)
    with b.solid("ottoman"):
        splayed(b, (x[0] + 0.03, x[1] - 0.03), (y[0] + 0.03, y[1] - 0.03), (0, foot + 0.005), wood, 0.02, 0.011, 0.02)
        b.cushion((x[0] + 0.008, x[1] - 0.008), (y[0] + 0.008, y[1] - 0.008), (foot, h - 0.11), cover, radius=0.02)
        b.cushion(x, y, (h - 0.13, h), cover, radius=0.045)
        seam = h - 0.118
        b.box(
            (x[0] + 0.006, x[1] - 0.006), (y[0] + 0.006, y[1] - 0.006), (seam - 0.005, seam + 0.005), cover, bevel=0.003
        )
        if b.chance("tufts", 0.5):
            for i in range(2):
                for j in range(3):
                    at = (x[0] + d * (i + 0.75) / 2.5, y[0] + w * (j + 0.5) / 3)
                    b.ball((0.014, 0.014, 0.004), (*at, h - 0.0029), cover, segments=10)
    b.surface("top", (x[0] + 0.055, x[1] - 0.055), (y[0] + 0.055, y[1] - 0.055), h)
    b.fit((d, w, h))


@draws("pouf")
def pouf(b: Builder) -> None:
    """A round, stuffed seat in gores that meet at a button; low and soft."""
    d, w, h = b.size
    cover = b.material("cover", "@fabric", "tan leather", "brown leather", "wicker")
    gores = b.pick("gores", [12, 16, 20])
    per = 4
    count = gores * per
    angle = np.arange(count) * 2 * np.pi / count
    bulge = 1 - 0.035 * np.abs(np.cos(angle * gores / 2)) ** 4
    rings = []
    profile = [
        (0.82, 0.0),
        (0.94, 0.05),
        (1.0, 0.18),
        (1.0, 0.5),
        (0.995, 0.78),
        (0.95, 0.92),
        (0.84, 0.985),
        (0.45, 1.0),
        (0.06, 0.985),
    ]
    for r, z in profile:
        share = bulge if 0.05 < z < 0.99 else bulge * 0 + 1
        rings.append(np.c_[r * share * np.cos(angle), r * share * np.sin(angle), np.full(count, z)])
    points = np.concatenate(rings) * np.array([d / 2, w / 2, h])
    faces = [ring_faces(k * count, (k + 1) * count, count) for k in range(len(rings) - 1)]
    fan = np.arange(1, count - 1)
    faces += [np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + (len(rings) - 1) * count]
    with b.solid("pouf"):
        hull = shapes.lathe([(r, z) for r, z in [*profile[:-1], (0.06, 1.0)]], 24)[0] * np.array([d / 2, w / 2, h])
        b.add((points, np.concatenate(faces).astype(np.int32)), cover, [shapes.hull(hull)])
        b.ball((0.025, 0.025, 0.012), (0, 0, h * 0.985), cover, segments=12)
    b.fit()


@draws("bean_bag")
def bean_bag(b: Builder) -> None:
    """A slumped sack with a dented seat and a high back, in gores with a seam."""
    d, w, h = b.size
    cover = b.material("cover", "@fabric", "brown leather", "black leather")
    n, m = 13, 36
    t = np.linspace(0, 1, n)[:, None]
    a = (np.arange(m) * 2 * np.pi / m)[None]
    radius = np.interp(t, [0, 0.06, 0.25, 0.45, 0.65, 0.82, 0.94, 1], [0.8, 0.95, 1, 0.93, 0.72, 0.48, 0.24, 0.05])
    radius = radius * (1 - 0.025 * np.abs(np.cos(3 * a)) ** 6)
    # The crown lies toward the back; the front half sags, so that a seat remains.
    height = t - 0.5 * t**1.5 * np.clip(np.cos(a), 0, 1) * np.sin(np.clip(t, 0, 1) * np.pi)
    x = radius * np.cos(a) - 0.55 * t**1.6
    grid = np.stack([x * d / 2, radius * np.sin(a) * w / 2, height * h], axis=-1)
    faces = [ring_faces(k * m, (k + 1) * m, m) for k in range(n - 1)]
    fan = np.arange(1, m - 1)
    faces += [np.c_[0 * fan, fan + 1, fan], np.c_[0 * fan, fan, fan + 1] + (n - 1) * m]
    hulls = [shapes.hull(grid[k : k + 4].reshape(-1, 3)) for k in (0, 3, 6, 9)]
    b.add((grid.reshape(-1, 3), np.concatenate(faces).astype(np.int32)), cover, hulls)
    tip = grid[-1].mean(axis=0)
    with b.frame(*tip):
        b.box((-0.02, 0.02), (-0.006, 0.006), (-0.02, 0.05), cover, bevel=0.004)
    b.fit()
