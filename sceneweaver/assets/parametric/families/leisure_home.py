"""Warmth, air, hobbies and pets."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_kit import disc, gear, inlay, ring


@gear("aquarium")
def aquarium(b: Builder) -> None:
    """A tank of water with plants, stones and fish on a cabinet."""
    d, w, h = b.size
    wood = b.material("cabinet", "black paint", "walnut", "white paint", "light oak")
    x, y = d / 2, w / 2
    z = h * 0.55
    b.box((-x, x - 0.016), (-y, y), (0, z), wood, 0.004)
    for s in (-1, 1):
        b.box((x - 0.018, x), span(s * 0.002, s * (y - 0.003)), (0.05, z - 0.03), wood, 0.003)
        inlay(b, (x - 0.01, x + 0.0003), span(s * 0.03, s * 0.045), (z * 0.5, z * 0.7), "steel")
    b.box((-x, x), (-y, y), (z - 0.005, z + 0.02), "black plastic", 0.003)
    b.box((-x + 0.004, x - 0.004), (-y + 0.004, y - 0.004), (z + 0.02, h - 0.05), "glass", 0)
    b.box((-x, x), (-y, y), (h - 0.055, h), "black plastic", 0.006)
    i, j = x - 0.015, y - 0.015
    inlay(b, (-i, i), (-j, j), (z + 0.021, z + 0.06), "sand pigment")
    inlay(b, (-i, -i + 0.004), (-j, j), (z + 0.06, h - 0.07), "sea pigment")
    from ... import shapes

    looks = ("leaf", "pale leaf", "dark leaf")
    for k in range(10):
        py = -j * 0.9 + k * j * 1.8 / 9
        px = b.uniform(f"x {k}", -i * 0.7, i * 0.3)
        tall = (h - z) * b.uniform(f"tall {k}", 0.25, 0.75)
        for m in range(3):
            a = k + 2.1 * m
            p, q = px + 0.05 * math.cos(a), py + 0.05 * math.sin(a)
            pts = [
                (px - 0.008, py, z + 0.05),
                (px + 0.008, py, z + 0.05),
                (px, py + 0.008, z + 0.05),
                ((px + p) / 2 + 0.014, (py + q) / 2, z + 0.05 + tall * 0.55),
                ((px + p) / 2 - 0.014, (py + q) / 2, z + 0.05 + tall * 0.55),
                ((px + p) / 2, (py + q) / 2 + 0.012, z + 0.05 + tall * 0.5),
                (p, q, z + 0.05 + tall * (0.8 + 0.1 * m)),
            ]
            b.add(shapes.hull(np.array(pts)), looks[k % 3], [])
    for k in range(4):
        r = 0.03 + 0.012 * k
        b.add(shapes.ball((r, r * 1.3, r * 0.8), (i * 0.3, -j * 0.6 + k * j * 0.4, z + 0.06), 8), "granite", [])
    for k in range(7):
        c = (
            b.uniform(f"fx {k}", 0, i * 0.6),
            b.uniform(f"fy {k}", -j * 0.8, j * 0.8),
            z + (h - z) * b.uniform(f"fz {k}", 0.3, 0.75),
        )
        look = ("orange plastic", "yellow plastic", "blue plastic", "red plastic")[k % 4]
        s = 1 if k % 2 else -1
        b.add(shapes.ball((0.012, 0.035, 0.02), c, 10), look, [])
        b.add(
            shapes.hull(
                np.array(
                    [(c[0] + e * 0.003, c[1] - s * 0.028 * 1, c[2]) for e in (-1, 1)]
                    + [(c[0], c[1] - s * 0.06, c[2] + q) for q in (-0.022, 0.022)]
                )
            ),
            look,
            [],
        )


@gear("fireplace")
def fireplace(b: Builder) -> None:
    """A mantelpiece on pilasters around an opening with logs and flames."""
    d, w, h = b.size
    stone = b.material("stone", "marble", "dark marble", "white paint", "granite", "concrete", "oak")
    inner = b.material("lining", "terracotta", "iron", "granite")
    x0, y = -d / 2, w / 2
    x1 = d / 2 - 0.12
    lim = w * 0.3
    with b.solid("hearth"):
        b.box((x0, d / 2), (-y, y), (0, 0.05), stone, 0.006)
    with b.solid("body"):
        z = h * 0.66
        b.box((x0, x0 + 0.05), (-lim, lim), (0.05, z), inner, 0)
        for s in (-1, 1):
            b.box((x0, x1 - 0.03), span(s * lim, s * (y - 0.05)), (0.05, h - 0.1), stone, 0.004)
            b.box((x0 + 0.05, x1 - 0.04), span(s * (lim - 0.012), s * lim), (0.05, z), inner, 0)
            ys = span(s * (y - 0.06), s * (y - 0.22))
            b.box((x0, x1), ys, (0.05, h - 0.12), stone, 0.008)
            b.box((x0, x1 + 0.02), span(s * (y - 0.045), s * (y - 0.235)), (0.05, 0.17), stone, 0.01)
            b.box((x0, x1 + 0.02), span(s * (y - 0.045), s * (y - 0.235)), (h - 0.2, h - 0.12), stone, 0.01)
            for k in (0.1, 0.14, 0.18):
                b.box((x1 - 0.01, x1 + 0.008), (s * (y - k) - 0.01, s * (y - k) + 0.01), (0.22, h - 0.25), stone, 0.004)
        b.box((x0, x1 - 0.03), (-lim, lim), (z, h - 0.1), stone, 0.004)
        b.box((x1 - 0.04, x1 - 0.015), (-lim * 0.5, lim * 0.5), (z + 0.06, h - 0.14), stone, 0.008)
        b.box((x0, x1 + 0.03), (-y + 0.03, y - 0.03), (h - 0.12, h - 0.06), stone, 0.012)
        b.box((x0, x1 + 0.07), (-y, y), (h - 0.06, h), stone, 0.008)
        m = (x0 + x1) / 2 + 0.03
        for s in (-1, 1):
            b.bar((m - 0.1, s * lim * 0.5, 0.09), (m + 0.12, s * lim * 0.5, 0.09), 0.012, "iron", 8)
            b.box((m + 0.1, m + 0.13), (s * lim * 0.5 - 0.012, s * lim * 0.5 + 0.012), (0.05, 0.22), "iron", 0.004)
        for k, (px, pz, t) in enumerate([(-0.05, 0.15, 0.05), (0.06, 0.15, 0.045), (0.0, 0.23, 0.045)]):
            b.bar((m + px, -lim * 0.62, pz + 0.02 * (k == 2)), (m + px, lim * 0.62, pz), t, "bark", 10)
            for s in (-1, 1):
                disc(
                    b,
                    (m + px, s * lim * 0.62, pz + (0.02 if s < 0 and k == 2 else 0)),
                    t * 0.85,
                    0.002,
                    "pine",
                    "y",
                    10,
                )
        for k in range(5):
            c = -lim * 0.4 + k * lim * 0.2
            tall = b.uniform(f"flame {k}", 0.12, 0.28)
            for look, q in (("flame", 1.0), ("yellow petal", 0.6)):
                with b.frame(m + 0.05 * (1 - q), c, 0.2):
                    b.lathe(
                        [(0.01, 0), (0.045 * q, tall * 0.25 * q), (0.022 * q, tall * 0.65 * q), (0.0, tall * q)],
                        look,
                        8,
                    )
    b.surface("mantel", (x0 + 0.01, x1 + 0.05), (-y + 0.02, y - 0.02), h)


@gear("wood_stove")
def wood_stove(b: Builder) -> None:
    """An iron stove with a glazed door, fire within, legs and a flue pipe."""
    d, w, h = b.size
    iron = b.material("body", "iron", "black steel", "forest pigment", "grey paint")
    top = min(0.95, h * 0.46) if b.chance("tall", 0.6) else 0.72
    x1 = d / 2 - 0.03
    with b.solid("stove"):
        for sx in (-d / 2 + 0.06, x1 - 0.06):
            for s in (-1, 1):
                with b.frame(sx, s * (w / 2 - 0.08)):
                    b.frustum(0.018, 0.032, (0, 0.15), iron, 10)
        b.box((-d / 2 + 0.01, x1), (-w / 2 + 0.02, w / 2 - 0.02), (0.14, top - 0.02), iron, 0.012)
        b.box((-d / 2, x1 + 0.02), (-w / 2, w / 2), (top - 0.035, top), iron, 0.01)
        b.box((-d / 2 + 0.01, x1 + 0.015), (-w / 2 + 0.01, w / 2 - 0.01), (0.14, 0.17), iron, 0.006)
        z0, z1 = top - 0.5 if top > 0.8 else 0.24, top - 0.08
        b.box((x1 - 0.01, x1 + 0.016), (-w * 0.38, w * 0.38), (z0, z1), iron, 0.006)
        b.box((x1, x1 + 0.019), (-w * 0.29, w * 0.29), (z0 + 0.06, z1 - 0.05), "black glass", 0.001)
        for k in range(5):
            c = -w * 0.18 + k * w * 0.09
            t = (z1 - z0) * b.uniform(f"flame {k}", 0.3, 0.6)
            b.hull(
                [
                    (x1 + 0.018 + e, c + yy, z0 + 0.075 + zz)
                    for e in (0, 0.0018)
                    for yy, zz in ((-0.02, 0), (0.02, 0), (0.025, t * 0.3), (-0.025, t * 0.3), (0.0, t))
                ],
                "flame",
            )
        b.bar((x1 + 0.018, -w * 0.14, z0 + 0.075), (x1 + 0.018, w * 0.14, z0 + 0.075), 0.004, "bark", 8)
        b.bar(
            (x1 + 0.03, -w * 0.34, (z0 + z1) / 2 - 0.06), (x1 + 0.03, -w * 0.34, (z0 + z1) / 2 + 0.06), 0.01, "brass", 8
        )
        b.box((x1, x1 + 0.025), (-w * 0.35, -w * 0.33), ((z0 + z1) / 2 - 0.01, (z0 + z1) / 2 + 0.01), "brass", 0)
        if z0 > 0.35:
            inlay(b, (x1 - 0.01, x1 + 0.0003), (-w * 0.36, w * 0.36), (0.2, z0 - 0.05), "black glass")
            for k in range(5):
                disc(b, (x1, -w * 0.26 + k * w * 0.13, 0.25), w * 0.058, 0.0006, "pine", "x", 12)
    with b.solid("flue"), b.frame(-d * 0.12):
        b.frustum(0.066, 0.066, (top, h), iron, 20)
        b.frustum(0.08, 0.07, (top, top + 0.05), iron, 20)
        b.frustum(0.07, 0.07, (h * 0.75, h * 0.75 + 0.04), iron, 20)


@gear("radiator")
def radiator(b: Builder) -> None:
    """A ribbed panel with a grille and valve, or a row of columns."""
    d, w, h = b.size
    paint = b.material("paint", "white steel", "white paint", "black paint", "grey paint")
    if b.chance("columns", 0.4):
        n = max(6, round(w / 0.055))
        step = w / n
        for k in range(n):
            y = -w / 2 + (k + 0.5) * step
            b.box((-d / 2 + 0.02, d / 2), (y - step * 0.4, y + step * 0.4), (0, 0.05), paint, 0.014)
            b.box((-d / 2 + 0.02, d / 2), (y - step * 0.4, y + step * 0.4), (h - 0.05, h), paint, 0.014)
            for x in (-d / 2 + 0.035, d / 2 - 0.016):
                b.box((x - 0.013, x + 0.013), (y - step * 0.28, y + step * 0.28), (0.03, h - 0.03), paint, 0.006)
        for z in (0.03, h - 0.03):
            b.bar((0.01, -w / 2 + 0.01, z), (0.01, w / 2 - 0.01, z), 0.014, paint, 8)
    else:
        b.box((-d / 2 + 0.02, d / 2 - 0.008), (-w / 2 + 0.02, w / 2), (0, h), paint, 0.012)
        n = max(8, int(w / 0.035))
        step = (w - 0.06) / n
        for k in range(n):
            y = -w / 2 + 0.05 + k * step
            b.box((d / 2 - 0.01, d / 2), (y, y + step * 0.6), (0.03, h - 0.03), paint, 0.005)
        for k in range(n):
            y = -w / 2 + 0.05 + k * step
            inlay(b, (-d / 2 + 0.035, d / 2 - 0.03), (y, y + step * 0.5), (h - 0.01, h + 0.0003), "grey plastic")
    for s in (-1, 1):
        b.box((-d / 2, -d / 2 + 0.04), (s * w * 0.35 - 0.02, s * w * 0.35 + 0.02), (0.06, h - 0.06), paint, 0.002)
    disc(b, (0.0, -w / 2 + 0.015, h * 0.85), 0.018, 0.03, "white plastic", "y", 16, 0.003)


@gear("heater")
def heater(b: Builder) -> None:
    """An oil filled radiator: fins in a row, a control box in front, on castors."""
    d, w, h = b.size
    paint = b.material("paint", "white steel", "black steel", "grey plastic")
    n = max(6, round((d - 0.16) / 0.05))
    x0, x1 = -d / 2, d / 2 - 0.12
    step = (x1 - x0) / n
    for k in range(n):
        x = x0 + (k + 0.5) * step
        b.box((x - step * 0.36, x + step * 0.36), (-w * 0.3, w * 0.3), (0.09, h), paint, step * 0.34)
    for z in (0.14, h - 0.05):
        b.bar((x0 + 0.01, 0, z), (x1, 0, z), 0.02, paint, 8)
    b.box((x1 - 0.005, d / 2), (-w * 0.3, w * 0.3), (0.09, h - 0.005), "grey plastic", 0.015)
    disc(b, (d / 2 - 0.004, 0, h - 0.2), 0.03, 0.006, "black plastic", "x", 20)
    for k, look in enumerate(("red plastic", "black plastic")):
        inlay(b, (d / 2 - 0.01, d / 2 + 0.0003), (-0.02, 0.02), (h - 0.12 + 0.035 * k, h - 0.1 + 0.035 * k), look)
    for x in (x0 + 0.06, d / 2 - 0.07):
        b.box((x - 0.012, x + 0.012), (-w / 2 + 0.02, w / 2 - 0.02), (0.055, 0.1), "black plastic", 0.003)
        for s in (-1, 1):
            disc(b, (x, s * (w / 2 - 0.015), 0.03), 0.03, 0.03, "rubber", "y", 16, 0.004)
            b.box(
                (x - 0.01, x + 0.01),
                (s * (w / 2 - 0.035) - 0.008, s * (w / 2 - 0.035) + 0.008),
                (0.03, 0.07),
                "black plastic",
                0,
            )


@gear("air_purifier")
def air_purifier(b: Builder) -> None:
    """A rounded tower with slits below, an outlet grille above and a small display."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "black plastic", "grey plastic")
    if abs(d - w) < 0.05:
        r = d / 2
        b.lathe([(r * 0.92, 0), (r, 0.015), (r, h - 0.04), (r * 0.9, h)], body, 32)
        for k in range(10):
            z = h * (0.08 + 0.05 * k)
            b.frustum(r + 0.0003, r + 0.0003, (z, z + h * 0.02), "grey plastic", 32)
        b.frustum(r * 0.75, r * 0.75, (h - 0.01, h + 0.0003), "black plastic", 28)
        for k in range(3):
            ring(b, (0, 0, h), r * (0.3 + 0.18 * k), 0.004, body, "z", 20, 6)
        return
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0, h), body, 0.03)
    for k in range(12):
        z = h * (0.12 + 0.045 * k)
        inlay(b, (d / 2 - 0.02, d / 2 + 0.0003), (-w * 0.36, w * 0.36), (z, z + h * 0.022), "grey plastic")
    disc(b, (d / 2, 0, h * 0.8), 0.035, 0.0007, "screen", "x", 24)
    disc(b, (d / 2, 0, h * 0.8), 0.012, 0.0008, "green plastic", "x", 16)
    for k in range(7):
        x = -d * 0.32 + k * d * 0.09
        inlay(b, (x, x + d * 0.045), (-w * 0.36, w * 0.36), (h - 0.02, h + 0.0003), "black plastic")


@gear("fan")
def fan(b: Builder) -> None:
    """A standing fan: round foot, pole, wire cage with blades."""
    d, w, h = b.size
    metal = b.material("stand", "white plastic", "black plastic", "chrome", "grey plastic")
    r = w / 2
    z = h - r
    with b.frame(-0.02):
        b.lathe([(d * 0.45, 0), (d * 0.45, 0.015), (0.06, 0.035), (0.025, 0.07)], metal, 28)
        b.frustum(0.017, 0.014, (0.03, z), metal, 12)
    b.box((-0.04, 0.0), (-0.03, 0.03), (z * 0.55, z * 0.55 + 0.06), metal, 0.01)
    disc(b, (-0.06, 0, z), 0.055, 0.16, metal, "x", 20, 0.02)
    for x, q in ((0.03, 0.8), (0.07, 1.0), (0.11, 0.8)):
        ring(b, (x, 0, z), (r - 0.007) * q, 0.006, metal, "x", 24, 6)
    disc(b, (0.12, 0, z), 0.05, 0.014, metal, "x", 20, 0.004)
    for k in range(12):
        a = k * math.pi / 6
        c, s = math.cos(a), math.sin(a)
        e = r - 0.007
        b.tube(
            [
                (0.02, 0.05 * c, z + 0.05 * s),
                (0.03, e * 0.8 * c, z + e * 0.8 * s),
                (0.07, e * c, z + e * s),
                (0.11, e * 0.8 * c, z + e * 0.8 * s),
                (0.12, 0.05 * c, z + 0.05 * s),
            ],
            0.0025,
            metal,
            4,
        )
    for k in range(4):
        with b.frame(0.07, 0, z, roll=k * math.pi / 2 + 0.3):
            b.hull(
                [
                    (e + q, yy, zz)
                    for e in (-0.003, 0.003)
                    for q, yy, zz in (
                        (-0.01, -0.02, 0.03),
                        (0.01, 0.02, 0.03),
                        (-0.025, -0.07, r * 0.6),
                        (0.025, 0.08, r * 0.6),
                        (0.0, 0.05, r * 0.82),
                    )
                ],
                "blue plastic" if metal.name == "white plastic" else "grey plastic",
            )


@gear("sewing_machine_table")
def sewing_machine_table(b: Builder) -> None:
    """A table on an iron frame with a treadle, and a sewing machine on it."""
    d, w, h = b.size
    wood = b.material("top", "oak", "walnut", "light oak", "cherry")
    paint = b.material("machine", "black paint", "white plastic", "sage paint", "red paint")
    z = h - 0.3
    with b.solid("top"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (z - 0.03, z), wood, 0.006)
        b.box((-d / 2 + 0.03, d / 2 - 0.06), (w / 2 - 0.25, w / 2 - 0.05), (z - 0.13, z - 0.03), wood, 0.004)
    for s in (-1, 1):
        with b.solid(f"leg {s}"):
            y = s * (w / 2 - 0.12)
            b.box((-d / 2 + 0.02, d / 2 - 0.03), (y - 0.015, y + 0.015), (0, 0.035), "iron", 0.004)
            for k in (-1, 1):
                b.bar((k * d * 0.4, y, 0.02), (-k * d * 0.32, y, z - 0.03), 0.013, "iron", 8)
            ring(b, (0, y, z * 0.5), 0.09, 0.009, "iron", "y", 14, 6)
    with b.solid("treadle"):
        b.bar((-0.05, -w / 2 + 0.12, 0.1), (-0.05, w / 2 - 0.12, 0.1), 0.01, "iron", 8)
        b.box((-0.14, 0.1), (-0.17, 0.17), (0.09, 0.11), "iron", 0.004)
    with b.solid("machine"):
        y0 = -0.12
        b.box((-0.09, 0.09), (y0 - 0.2, y0 + 0.2), (z, z + 0.045), paint, 0.01)
        b.box((-0.05, 0.05), (y0 + 0.1, y0 + 0.2), (z + 0.04, h - 0.02), paint, 0.02)
        b.box((-0.045, 0.045), (y0 - 0.2, y0 + 0.2), (h - 0.12, h - 0.03), paint, 0.025)
        b.box((-0.04, 0.04), (y0 - 0.2, y0 - 0.12), (z + 0.13, h - 0.04), paint, 0.015)
        b.bar((0, y0 - 0.16, z + 0.05), (0, y0 - 0.16, z + 0.14), 0.006, "steel", 8)
        disc(b, (0, y0 + 0.21, h - 0.08), 0.065, 0.025, "steel", "y", 20, 0.004)
        inlay(b, (0, 0.0453), (y0 - 0.05, y0 + 0.08), (h - 0.09, h - 0.06), "brass")
        b.frustum(0.004, 0.004, (h - 0.04, h), "steel", 8) if False else disc(
            b, (0, y0 + 0.05, h - 0.022), 0.015, 0.044, "red fabric", "z", 12
        )
    b.clear((-0.05, d / 2), (-w / 2 + 0.2, w / 2 - 0.28), (0.13, z - 0.05))


@gear("pet_bed")
def pet_bed(b: Builder) -> None:
    """A low oval rim of cloth around a cushion, lower in front, with a bone upon it."""
    d, w, h = b.size
    cloth = b.material("rim", "grey fabric", "charcoal fabric", "rust fabric", "blue fabric", "beige fabric", "wicker")
    t = np.linspace(0, 2 * math.pi, 20, endpoint=False)
    r = h * 0.36
    a, c = d / 2 - r, w / 2 - r
    z = h - r - np.clip(np.cos(t) - 0.5, 0, 1) * h * 0.5
    b.tube(np.c_[a * np.cos(t), c * np.sin(t), np.maximum(z, r)], r, cloth, 10, closed=True)
    b.frustum(1.0, 1.0, (0, 0.001), cloth, 8) if False else b.extrude(
        np.c_[(a + r * 0.5) * np.cos(t), (c + r * 0.5) * np.sin(t)], (0, h * 0.35), cloth
    )
    b.extrude(
        np.c_[a * 0.95 * np.cos(t), c * 0.95 * np.sin(t)],
        (h * 0.3, h * 0.5),
        b.material("cushion", "white fabric", "beige fabric"),
    )
    zz = h * 0.5
    b.bar((0, -0.06, zz + 0.02), (0.03, 0.06, zz + 0.02), 0.014, "paper", 8)
    for py in (-0.065, 0.065):
        for e in (-0.016, 0.016):
            b.ball((0.02, 0.02, 0.018), (0.015 + py * 0.23 + e, py, zz + 0.02), "paper", 8)


@gear("cat_tree")
def cat_tree(b: Builder) -> None:
    """Posts wound with rope, carpeted boards, a house with a round door, a hanging ball."""
    d, w, h = b.size
    felt = b.material("felt", "beige fabric", "grey fabric", "charcoal fabric", "rust fabric")
    x, y = d / 2, w / 2

    def rope(px: float, py: float, z0: float, z1: float) -> None:
        with b.frame(px, py):
            b.frustum(0.045, 0.045, (z0, z1), "rattan", 14)
            n = int((z1 - z0) / 0.06)
            for k in range(n):
                z = z0 + (k + 0.5) * (z1 - z0) / n
                b.frustum(0.0453, 0.0453, (z - 0.005, z + 0.005), "wicker", 14)

    b.box((-x, x), (-y, y), (0, 0.04), felt, 0.01)
    hz = 0.36
    b.box((-x + 0.02, x - 0.06), (-y + 0.02, 0.02), (0.04, 0.04 + hz), felt, 0.015)
    disc(b, (x - 0.06, -y / 2 + 0.02, 0.04 + hz * 0.48), 0.105, 0.0006, "black fabric", "x", 24)
    m = h * 0.55
    rope(-x + 0.1, -y + 0.12, 0.4, m)
    rope(x - 0.14, y - 0.12, 0.04, m)
    rope(-x + 0.12, y - 0.12, 0.04, h - 0.1)
    b.box((-x + 0.02, x - 0.02), (-y + 0.04, y - 0.02), (m, m + 0.035), felt, 0.01)
    q = min(x, y) * 0.62
    with b.frame(-x + q + 0.02, y - q - 0.02):
        b.frustum(q * 0.85, q, (h - 0.11, h), felt, 24, 0.01)
        b.frustum(q * 0.8, q * 0.8, (h - 0.02, h + 0.0003), "white fabric", 24)
    b.bar((x - 0.06, -y + 0.12, m), (x - 0.06, -y + 0.12, m - 0.14), 0.004, "wicker", 6)
    b.ball(
        (0.03, 0.03, 0.03),
        (x - 0.06, -y + 0.12, m - 0.16),
        b.material("ball", "red fabric", "blue fabric", "mustard fabric"),
        10,
    )


@gear("litter_box")
def litter_box(b: Builder) -> None:
    """A tray under a rounded hood with an entrance and a handle."""
    d, w, h = b.size
    tray = b.material("tray", "grey plastic", "blue plastic", "mint plastic", "pink plastic")
    hood = b.material("hood", "white plastic", "grey plastic", "lilac plastic")
    x, y = d / 2, w / 2
    z = h * 0.35
    b.hull([(sx * x * q, sy * y * q, zz) for sx in (-1, 1) for sy in (-1, 1) for q, zz in ((0.88, 0), (1, z))], tray)
    t = h - 0.03
    b.hull(
        [
            (px, sy * y * q, zz)
            for sy in (-1, 1)
            for px, q, zz in (
                (-x * 0.97, 0.97, z),
                (x * 0.97, 0.97, z),
                (-x * 0.9, 0.85, t - 0.05),
                (x * 0.8, 0.85, t - 0.05),
                (-x * 0.75, 0.6, t),
                (x * 0.6, 0.6, t),
            )
        ],
        hood,
    )
    s = math.atan2(x * 0.17, t - 0.05 - z)
    with b.frame(x * 0.97, 0, z, pitch=-s):
        b.box((-0.01, 0.002), (-w * 0.26, w * 0.26), (0.01, (t - z) * 0.72), "black plastic", 0.001)
        b.box((-0.01, 0.006), (-w * 0.3, w * 0.3), (-0.015, 0.012), tray, 0.003)
    b.tube([(0, -0.07, t - 0.005), (0, -0.05, h - 0.007), (0, 0.05, h - 0.007), (0, 0.07, t - 0.005)], 0.007, tray, 8)
