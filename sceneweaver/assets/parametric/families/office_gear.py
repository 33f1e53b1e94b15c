"""Machines, carts and cabinets of offices, schools and libraries."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_kit import castors, disc, gear, inlay, ring, side

_CASES = ("white plastic", "grey plastic", "black plastic")


@gear("desk_printer")
def desk_printer(b: Builder) -> None:
    """A low printer: scanner lid, slot with a sheet on its tray, small panel."""
    d, w, h = b.size
    body = b.material("body", *_CASES)
    x0, x1 = -d / 2, d / 2 - 0.08
    b.box((x0, x1), (-w / 2, w / 2), (0, h * 0.78), body, 0.012)
    b.box((x0 + 0.01, x1 - 0.005), (-w / 2 + 0.005, w / 2 - 0.005), (h * 0.77, h), body, 0.015)
    b.box((x0 + 0.015, x1 - 0.012), (-w / 2 + 0.008, w / 2 - 0.008), (h * 0.72, h * 0.84), "black plastic")
    inlay(b, (x1 - 0.01, x1 + 0.0003), (-w * 0.33, w * 0.33), (h * 0.16, h * 0.44), "black plastic")
    b.box((x1 - 0.03, d / 2), (-w * 0.28, w * 0.28), (h * 0.16, h * 0.19), "grey plastic", 0.003)
    b.box((x1 - 0.02, d / 2 - 0.02), (-0.105, 0.105), (h * 0.19, h * 0.2), "paper", 0)
    b.box((x1 - 0.02, x1 + 0.012), (-w * 0.4, w * 0.15), (h * 0.52, h * 0.74), "black plastic", 0.005)
    inlay(b, (x1, x1 + 0.0123), (-w * 0.3, -w * 0.1), (h * 0.56, h * 0.7), "screen")
    for k in range(3):
        disc(
            b,
            (x1 + 0.012, w * (0.02 * k * 2 - 0.02), h * 0.63),
            0.008,
            0.003,
            ("green plastic", "white plastic", "red plastic")[k],
            "x",
            10,
        )


@gear("photocopier")
def photocopier(b: Builder) -> None:
    """A floor copier: paper drawers, output slot, scanner, feeder, tilted panel."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "light grey paint", "grey plastic")
    x0, x1 = -d / 2, d / 2 - 0.03
    z1 = h - 0.12
    castors(b, (x0 + 0.08, x1 - 0.08), (-w / 2 + 0.08, w / 2 - 0.08), r=0.02)
    b.box((x0, x1), (-w / 2, w / 2), (0.045, z1 * 0.7), body, 0.01)
    n = 3
    for k in range(n):
        z = 0.07 + k * z1 * 0.17
        b.box((x1 - 0.01, x1 + 0.012), (-w / 2 + 0.03, w / 2 - 0.03), (z, z + z1 * 0.15), body, 0.004)
        inlay(b, (x1, x1 + 0.0123), (-0.09, 0.09), (z + z1 * 0.1, z + z1 * 0.125), "black plastic")
    b.box((x0, x0 + d * 0.45), (-w / 2, w / 2), (z1 * 0.69, z1 * 0.86), body, 0.006)
    b.box((x0, x1), (-w / 2, -w / 2 + 0.14), (z1 * 0.69, z1 * 0.86), body, 0.006)
    b.box((x0 + 0.1, x1 - 0.05), (-w * 0.2, w / 2 - 0.04), (z1 * 0.7, z1 * 0.72), "grey plastic", 0.003)
    b.box((x0 + 0.2, x1 - 0.08), (0.0, 0.25), (z1 * 0.72, z1 * 0.73), "paper", 0)
    b.box((x0, x1), (-w / 2, w / 2), (z1 * 0.85, z1), body, 0.01)
    inlay(b, (x0, x1 + 0.0003), (-w / 2 + 0.02, w / 2 - 0.02), (z1 * 0.9, z1 * 0.91), "black plastic")
    b.box((x0 + 0.02, x1 - 0.06), (-w / 2 + 0.02, w / 2 - 0.02), (z1, z1 + 0.06), "grey plastic", 0.012)
    b.box((x0 + 0.08, x1 - 0.12), (w * 0.1, w / 2 - 0.03), (z1 + 0.055, h), body, 0.015)
    b.box((x0 + 0.1, x1 - 0.14), (-w * 0.3, w * 0.1), (z1 + 0.058, z1 + 0.075), body, 0.004)
    b.box((x0 + 0.14, x1 - 0.18), (-w * 0.25, w * 0.1), (z1 + 0.074, z1 + 0.085), "paper", 0)
    with b.frame(x1 - 0.005, -w * 0.12, z1 - 0.1, pitch=-0.6):
        b.box((-0.02, 0.03), (-0.22, 0.22), (0, 0.16), "black plastic", 0.008)
        inlay(b, (0.0, 0.0303), (-0.12, 0.16), (0.03, 0.13), "screen")
        inlay(b, (0.0, 0.0303), (-0.19, -0.15), (0.05, 0.09), "green plastic")


@gear("phone_booth")
def phone_booth(b: Builder) -> None:
    """A soundproof office booth: glass door and back, felt inside, a shelf desk and a seat."""
    d, w, h = b.size
    shell = b.material("shell", "white paint", "black paint", "grey paint", "sage paint", "light oak", "navy paint")
    felt = b.material("felt", "grey fabric", "charcoal fabric", "blue fabric", "mustard fabric")
    t = 0.07
    x0, x1, y = -d / 2, d / 2 - 0.03, w / 2
    b.box((x0, x1), (-y, y), (0, 0.1), shell, 0.012)
    b.box((x0, x1), (-y, y), (h - 0.12, h), shell, 0.02)
    for s in (-1, 1):
        ys = (y - t, y) if s > 0 else (-y, -y + t)
        b.box((x0, x1), ys, (0.09, h - 0.1), shell, 0.02)
        b.box(
            (x0 + 0.05, x1 - 0.06),
            (y - t - 0.012, y - t + 0.001) if s > 0 else (-y + t - 0.001, -y + t + 0.012),
            (0.1, h - 0.12),
            felt,
            0,
        )
    b.box((x0, x0 + 0.05), (-y + t, y - t), (0.1, h - 0.12), felt, 0)
    b.box((x0 + 0.05, x0 + 0.32), (-y + t + 0.02, y - t - 0.02), (0.4, 0.46), felt, 0.02)
    b.box((x0 + 0.06, x0 + 0.28), (-0.15, 0.15), (0.1, 0.41), shell, 0.01)
    ys = (y - t - 0.3, y - t)
    b.box((x0 + 0.4, x1 - 0.1), ys, (0.72, 0.745), "light oak", 0.004)
    b.frustum(0.07, 0.07, (h - 0.135, h - 0.115), "lamp glow", 20)
    i = y - t - 0.003
    with b.hinge("door", (x1 - 0.005, -i, 0.1), limits=(-1.7, 0.0)):
        for yy in ((-i, -i + 0.05), (i - 0.05, i)):
            b.box((x1 - 0.045, x1 - 0.005), yy, (0.104, h - 0.124), "black steel", 0.003)
        for zz in ((0.104, 0.16), (h - 0.18, h - 0.124)):
            b.box((x1 - 0.045, x1 - 0.005), (-i + 0.05, i - 0.05), zz, "black steel", 0.003)
        b.box((x1 - 0.03, x1 - 0.02), (-i + 0.05, i - 0.05), (0.16, h - 0.18), "glass", 0)
        b.bar((d / 2 - 0.008, i - 0.025, 0.95), (d / 2 - 0.008, i - 0.025, 1.25), 0.008, "steel", 8)
        for z in (0.97, 1.23):
            b.box((x1 - 0.006, d / 2 - 0.006), (i - 0.031, i - 0.019), (z - 0.006, z + 0.006), "steel", 0)


@gear("server_rack")
def server_rack(b: Builder) -> None:
    """A tall black rack full of servers with lights, patch panels and cables, its front open."""
    d, w, h = b.size
    case = b.material("case", "black steel", "black steel", "grey paint")
    x0, x1, y = -d / 2, d / 2, w / 2
    b.box((x0, x1 - 0.03), (-y, y), (0.03, h), case, 0.006)
    castors(b, (x0 + 0.08, x1 - 0.1), (-y + 0.08, y - 0.08), r=0.014)
    for s in (-1, 1):
        b.box((x1 - 0.04, x1), span(s * y, s * (y - 0.05)), (0.03, h), case, 0.003)
    b.box((x1 - 0.04, x1), (-y + 0.05, y - 0.05), (h - 0.06, h), case, 0.003)
    b.box((x1 - 0.04, x1), (-y + 0.05, y - 0.05), (0.03, 0.09), case, 0.003)
    z, k = 0.1, 0
    i = y - 0.055
    f = x1 - 0.012
    while z < h - 0.15:
        units = b.pick(f"units {k}", (1, 1, 2, 2, 3))
        t = min(0.0445 * units, h - 0.07 - z)
        kind = b.pick(f"unit {k}", ("server", "disks", "patch", "blank"))
        look = "grey plastic" if kind in ("disks", "server") else "black plastic"
        b.box((x1 - 0.05, f), (-i, i), (z, z + t - 0.004), look, 0.002)
        m = z + t / 2
        if kind == "disks":
            for j in range(8):
                c = -i * 0.84 + j * i * 1.68 / 7
                inlay(b, (x1 - 0.04, f + 0.0003), (c - 0.018, c + 0.018), (z + 0.008, z + t - 0.012), "black plastic")
                inlay(b, (x1 - 0.04, f + 0.00035), (c - 0.004, c + 0.004), (m - 0.003, m + 0.003), "green plastic")
        elif kind == "patch":
            for j in range(12):
                c = -i * 0.86 + j * i * 1.72 / 11
                inlay(
                    b,
                    (x1 - 0.04, f + 0.0003),
                    (c - 0.008, c + 0.008),
                    (m - 0.007, m + 0.007),
                    "blue plastic" if j % 3 else "yellow plastic",
                )
        elif kind == "server":
            inlay(b, (x1 - 0.04, f + 0.0003), (-i * 0.6, i * 0.9), (m - 0.008, m + 0.008), "black plastic")
            for j, lamp in enumerate(("green plastic", "blue plastic", "orange plastic")):
                inlay(
                    b,
                    (x1 - 0.04, f + 0.0003),
                    (-i * 0.9 + 0.02 * j, -i * 0.9 + 0.02 * j + 0.008),
                    (m - 0.004, m + 0.004),
                    lamp,
                )
        z += t
        k += 1


@gear("water_cooler")
def water_cooler(b: Builder) -> None:
    """A slim body with two taps and a big blue bottle on top."""
    d, w, h = b.size
    body = b.material("body", "white plastic", "grey plastic", "black plastic")
    z = h * 0.7
    r = min(d, w) * 0.42
    x1 = d / 2 - 0.02
    b.box((-d / 2, x1), (-w / 2, w / 2), (0, z * 0.76), body, 0.015)
    b.box((-d / 2, x1 - 0.1), (-w / 2, w / 2), (z * 0.75, z * 0.93), body, 0.01)
    b.box((-d / 2, x1), (-w / 2, w / 2), (z * 0.92, z), body, 0.015)
    b.box((x1 - 0.1, d / 2), (-w * 0.35, w * 0.35), (z * 0.74, z * 0.775), "grey plastic", 0.004)
    for s, look in ((-1, "red plastic"), (1, "blue plastic")):
        b.box((x1 - 0.11, x1 - 0.03), (s * 0.06 - 0.014, s * 0.06 + 0.014), (z * 0.87, z * 0.9), "white plastic", 0.004)
        b.box((x1 - 0.06, x1 - 0.03), (s * 0.06 - 0.012, s * 0.06 + 0.012), (z * 0.89, z * 0.915), look, 0.004)
    inlay(b, (x1 - 0.05, x1 + 0.0003), (-w * 0.36, w * 0.36), (z * 0.08, z * 0.7), "grey plastic")
    inlay(b, (x1 - 0.05, x1 + 0.00035), (-w * 0.355, w * 0.355), (z * 0.084, z * 0.696), body)
    with b.frame(-0.01):
        t = h - z
        b.lathe(
            [(r * 0.4, z - 0.002), (r * 0.45, z + t * 0.1), (r, z + t * 0.25), (r, z + t * 0.95), (r * 0.85, h)],
            b.material("bottle", "sky pigment", "clear plastic"),
            24,
        )
        for k in (0.4, 0.6, 0.8):
            ring(b, (0, 0, z + t * k), r, 0.008, "sky pigment", "z", 20, 6)


@gear("shredder")
def shredder(b: Builder) -> None:
    """A bin with a window and a cutting head, a sheet half way in."""
    d, w, h = b.size
    body = b.material("body", "black plastic", "grey plastic", "white plastic")
    z = h * 0.72
    t = h - 0.06
    b.hull(
        [(x * d / 2 * q, y * w / 2 * q, zz) for x in (-1, 1) for y in (-1, 1) for q, zz in ((0.86, 0), (0.95, z))], body
    )
    b.box(
        (-d / 2, d / 2),
        (-w / 2, w / 2),
        (z, t),
        "black plastic" if body.name != "black plastic" else "grey plastic",
        0.015,
    )
    b.box((-0.008, 0.008), (-w * 0.34, w * 0.34), (t - 0.001, t + 0.002), "black glass", 0)
    b.box((-0.0015, 0.0015), (-0.105, 0.105), (t - 0.02, h), "paper", 0)
    inlay(b, (d / 2 - 0.01, d / 2 + 0.0003), (-0.02, 0.02), (z + 0.04, z + 0.055), "green plastic")
    with b.frame(d / 2 * 0.905, 0, z * 0.5, pitch=-math.atan2(d * 0.045, z) * -1 * -1 + 2 * math.atan2(d * 0.045, z)):
        b.box((-0.01, 0.003), (-w * 0.2, w * 0.2), (-z * 0.3, z * 0.3), "black glass", 0.002)


@gear("wastebasket", square=True)
def wastebasket(b: Builder) -> None:
    """A small round paper bin with crumpled paper in it."""
    d, w, h = b.size
    look = b.material("bin", "black steel", "white steel", "grey plastic", "blue plastic", "wicker", "green plastic")
    r = d / 2
    low = r * b.uniform("foot", 0.7, 0.9)
    t = h - 0.025
    b.frustum(low, r * 0.985, (0, t), look, 28)
    ring(b, (0, 0, t), r * 0.97, r * 0.03, look, "z", 24, 6)
    b.frustum(r * 0.9, r * 0.9, (t - 0.005, t + 0.001), "black plastic", 24)
    for k in range(4):
        a = k * 1.7 + 0.4
        q = r * 0.27
        b.ball(
            (q, q * 0.9, q * 0.8), (r * 0.42 * math.cos(a), r * 0.42 * math.sin(a), h - q * 0.8 - 0.004 * k), "paper", 8
        )


@gear("book_return_cart")
def book_return_cart(b: Builder) -> None:
    """A library trolley: two sloping shelves of books between end panels, on castors."""
    d, w, h = b.size
    frame = b.material("ends", "grey paint", "oak", "beech", "teal paint", "red paint", "black steel")
    x, y = d / 2, w / 2
    castors(b, (-x + 0.06, x - 0.06), (-y + 0.06, y - 0.06), r=0.045)
    for s in (-1, 1):
        ys = (y - 0.022, y) if s > 0 else (-y, -y + 0.022)
        side(b, [(-x, 0.1), (x, 0.1), (x, h - 0.12), (x - 0.08, h), (-x + 0.08, h), (-x, h - 0.12)], ys, frame)
    i = y - 0.02
    looks = (
        "red fabric",
        "navy fabric",
        "green fabric",
        "mustard fabric",
        "brown leather",
        "teal paint",
        "beige fabric",
    )
    for k in range(2):
        z = 0.16 + k * (h - 0.3) * 0.55
        b.box((-x + 0.02, x - 0.02), (-i, i), (z - 0.02, z), frame, 0.002)
        b.box((-0.01, 0.01), (-i, i), (z, z + 0.2), frame, 0.002)
        for e in (-1, 1):
            c, j = -i + 0.01, 0
            end = i * b.uniform(f"full {k} {e}", 0.3, 0.95)
            while c < end:
                t = b.uniform(f"t {k} {e} {j}", 0.025, 0.055)
                tall = b.uniform(f"h {k} {e} {j}", 0.19, 0.27)
                deep = min(x - 0.04, b.uniform(f"d {k} {e} {j}", 0.13, 0.17))
                b.box(
                    span(e * 0.01, e * (0.01 + deep)),
                    (c, c + t - 0.001),
                    (z, z + tall),
                    b.pick(f"l {k} {e} {j}", looks),
                    0.003,
                )
                c += t
                j += 1


@gear("card_catalog")
def card_catalog(b: Builder) -> None:
    """A library cabinet of many small drawers with brass label holders and pulls, on legs."""
    d, w, h = b.size
    wood = b.material("wood", "oak", "walnut", "mahogany", "cherry", "light oak")
    x0, x1, y = -d / 2, d / 2 - 0.026, w / 2
    foot = h * 0.3
    for sx in (x0 + 0.03, x1 - 0.03):
        for s in (-1, 1):
            b.hull(
                [
                    (sx + e * q, s * (y - 0.03) + f * q, z)
                    for e in (-1, 1)
                    for f in (-1, 1)
                    for q, z in ((0.015, 0), (0.026, foot))
                ],
                wood,
            )
    b.box((x0, x1 - 0.002), (-y, y), (foot, h - 0.025), wood, 0.004)
    b.box((x0, x1 + 0.016), (-y - 0.01, y + 0.01), (h - 0.028, h), wood, 0.006)
    cols, rows = max(4, round(w / 0.17)), max(4, round((h - foot) / 0.13))
    cw, ch = (w - 0.05) / cols, (h - foot - 0.06) / rows
    for i in range(cols):
        for j in range(rows):
            c, z = -y + 0.025 + (i + 0.5) * cw, foot + 0.015 + (j + 0.5) * ch
            b.add(
                _plain((x1 - 0.004, x1 + 0.0), (c - cw * 0.47, c + cw * 0.47), (z - ch * 0.46, z + ch * 0.46)),
                wood,
                None if (i, j) == (0, 0) else [],
            )
            inlay(b, (x1 - 0.003, x1 + 0.0002), (c - cw * 0.3, c + cw * 0.3), (z, z + ch * 0.3), "brass")
            inlay(
                b, (x1 - 0.003, x1 + 0.0003), (c - cw * 0.25, c + cw * 0.25), (z + 0.006, z + ch * 0.3 - 0.006), "paper"
            )
            inlay(b, (x1 - 0.003, x1 + 0.0003), (c - 0.012, c + 0.012), (z - ch * 0.3, z - ch * 0.1), "brass")
    b.box((x1 - 0.004, x1), (-y + 0.02, y - 0.02), (foot + 0.01, h - 0.03), "wenge", 0)
    b.surface("top", (x0 + 0.01, x1), (-y + 0.01, y - 0.01), h)


def _plain(x, y, z):
    from ... import shapes

    return shapes.box(x, y, z)


@gear("globe", square=True)
def globe(b: Builder) -> None:
    """A floor globe in a wooden ring on turned legs."""
    d, w, h = b.size
    wood = b.material("stand", "mahogany", "walnut", "oak", "cherry")
    sea = b.material("sea", "sea pigment", "sky pigment", "sand pigment")
    land = "sand pigment" if "sand" not in sea.name else "terracotta pigment"
    r = d / 2 * 0.8
    zc = h - r - 0.02
    b.ball((r, r, r), (0, 0, zc), sea, 28)
    lands = [
        (0.3, 0.4, 0.4),
        (0.8, -0.3, 0.3),
        (2.2, 0.5, 0.45),
        (2.5, -0.1, 0.3),
        (3.6, 0.5, 0.4),
        (4.2, -0.35, 0.35),
        (5.2, 0.3, 0.35),
        (5.6, -0.5, 0.25),
    ]
    for lon, lat, s in lands:
        n = 9
        t = np.arange(n) * 2 * math.pi / n
        wob = 1 + 0.25 * np.sin(3 * t + lon) + 0.15 * np.cos(5 * t)
        lo, la = lon + s * 0.9 * wob * np.cos(t), lat + s * wob * np.sin(t) * 0.8
        p = np.c_[np.cos(la) * np.cos(lo), np.cos(la) * np.sin(lo), np.sin(la)]
        m = np.array([math.cos(lat) * math.cos(lon), math.cos(lat) * math.sin(lon), math.sin(lat)])
        q = np.concatenate([p, p * 0.5 + m * 0.5])
        q = q / np.linalg.norm(q, axis=1, keepdims=True) * (r * 1.006) + (0, 0, zc)
        b.hull(
            np.concatenate([q, [m * r * 0.8 + (0, 0, zc)], [m * r * 1.006 + (0, 0, zc)]]),
            land if s < 0.42 else "moss pigment",
        )
    n = 24
    t = np.arange(n) * 2 * math.pi / n
    sec = np.array([(d * 0.05, -0.012), (d * 0.05, 0.012), (-d * 0.05, 0.012), (-d * 0.05, -0.012)])
    b.tube(np.c_[d * 0.45 * np.cos(t), d * 0.45 * np.sin(t), 0 * t + zc], sec, wood, closed=True)
    ring(b, (0, 0, zc), r * 1.045, 0.008, "brass", "y", 24, 6)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        with b.frame(d * 0.44 * math.cos(a), d * 0.44 * math.sin(a)):
            b.lathe(
                [(0.014, 0), (0.022, 0.06), (0.015, 0.12), (0.026, zc * 0.5), (0.016, zc * 0.75), (0.022, zc - 0.01)],
                wood,
                10,
            )
        b.bar((d * 0.44 * math.cos(a), d * 0.44 * math.sin(a), 0.16), (0, 0, 0.13), 0.012, wood, 8)
    b.frustum(0.03, 0.04, (0.1, 0.17), wood, 12)


@gear("mailboxes")
def mailboxes(b: Builder) -> None:
    """A wall of small numbered post boxes with slots and locks."""
    d, w, h = b.size
    case = b.material("case", "aluminium", "grey paint", "white steel", "black steel", "brass")
    x1 = d / 2
    b.box((-d / 2, x1 - 0.004), (-w / 2, w / 2), (0, h), case, 0.004)
    cols, rows = max(2, round(w / 0.3)), max(2, round(h / 0.17))
    cw, ch = (w - 0.04) / cols, (h - 0.04) / rows
    for i in range(cols):
        for j in range(rows):
            y, z = -w / 2 + 0.02 + i * cw, 0.02 + j * ch
            b.box((x1 - 0.006, x1), (y + 0.004, y + cw - 0.004), (z + 0.004, z + ch - 0.004), case, 0)
            inlay(
                b,
                (x1 - 0.003, x1 + 0.0003),
                (y + cw * 0.2, y + cw * 0.8),
                (z + ch * 0.72, z + ch * 0.82),
                "black plastic",
            )
            inlay(b, (x1 - 0.003, x1 + 0.0003), (y + cw * 0.3, y + cw * 0.62), (z + ch * 0.4, z + ch * 0.55), "paper")
            inlay(
                b,
                (x1 - 0.003, x1 + 0.0003),
                (y + cw * 0.78, y + cw * 0.84),
                (z + ch * 0.42, z + ch * 0.52),
                "black steel",
            )


@gear("turnstile")
def turnstile(b: Builder) -> None:
    """A gate of three turning arms on a steel body, with a card reader."""
    d, w, h = b.size
    steel = b.material("body", "brushed steel", "steel", "black steel")
    y = -w / 2
    b.box((-d / 2, d / 2), (y, y + 0.26), (0, h), steel, 0.02)
    b.box((-d / 2 + 0.03, d / 2 - 0.03), (y + 0.02, y + 0.24), (h - 0.005, h + 0.004), "black glass", 0)
    inlay(b, (d / 2 - 0.02, d / 2 + 0.0003), (y + 0.08, y + 0.18), (h - 0.2, h - 0.1), "black glass")
    inlay(b, (d / 2 - 0.02, d / 2 + 0.00035), (y + 0.11, y + 0.15), (h - 0.17, h - 0.13), "green plastic")
    c = (0, y + 0.27, h - 0.16)
    disc(b, c, 0.07, 0.06, "chrome", "y", 20, 0.01)
    b.bar(c, (0, w / 2 - 0.02, h - 0.16), 0.019, "chrome", 10)
    for s in (-1, 1):
        b.bar(c, (s * 0.3, y + 0.42, h - 0.42), 0.019, "chrome", 10)
