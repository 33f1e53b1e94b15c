"""Tools, machines and vehicles of a garage or workshop."""

from __future__ import annotations

import math

from ..builder import Builder, span
from .gym_kit import castors, disc, face, gear, inlay, post, ring, side

_LOUD = ("red paint", "blue paint", "yellow paint", "green paint", "black steel", "grey paint")


@gear("tool_chest")
def tool_chest(b: Builder) -> None:
    """A rolling chest of drawers in loud paint, with a handle at its side."""
    d, w, h = b.size
    paint = b.material("paint", *_LOUD)
    x0, x1, y = -d / 2, d / 2 - 0.03, w / 2 - 0.03
    castors(b, (x0 + 0.07, x1 - 0.07), (-y + 0.06, y - 0.06), r=0.05)
    b.box((x0, x1 - 0.02), (-y, y), (0.11, h - 0.01), paint, 0.006)
    b.box((x0, x1), (-y, y), (h - 0.03, h), "black plastic", 0.005)
    n = b.whole("drawers", 5, 7)
    z, share = 0.13, [1.0 + 0.9 * (k < 2) for k in range(n)]
    unit = (h - 0.05 - z) / sum(share)
    for k in range(n):
        t = unit * share[k]
        with b.slide(f"drawer-{k}", limits=(0.0, round(0.7 * d, 3))):
            b.box((x1 - 0.02, x1), (-y + 0.02, y - 0.02), (z + 0.004, z + t - 0.004), paint, 0.003)
            b.box((x1 - 0.002, x1 + 0.014), (-y + 0.05, y - 0.05), (z + t - 0.026, z + t - 0.01), "aluminium", 0.003)
        z += t
    b.tube(
        [
            (x0 + 0.08, y, h - 0.1),
            (x0 + 0.08, w / 2 - 0.012, h - 0.1),
            (x1 - 0.1, w / 2 - 0.012, h - 0.1),
            (x1 - 0.1, y, h - 0.1),
        ],
        0.012,
        "chrome",
        8,
    )
    b.surface("top", (x0 + 0.01, x1 - 0.01), (-y + 0.01, y - 0.01), h)


@gear("tool_cabinet")
def tool_cabinet(b: Builder) -> None:
    """A tall steel cupboard with two doors, louvres and a lock."""
    d, w, h = b.size
    paint = b.material("paint", *_LOUD)
    x0, x1, y = -d / 2, d / 2 - 0.05, w / 2
    b.box((x0, x1), (-y, y), (0, h), paint, 0.005)
    for s in (-1, 1):
        at = (x1 + 0.02, s * y, 0.06)
        with b.hinge(f"door-{s}", at, limits=(0.0, 1.9) if s > 0 else (-1.9, 0.0)):
            b.box((x1, x1 + 0.02), span(s * 0.002, s * (y - 0.004)), (0.06, h - 0.01), paint, 0.004)
            for k in range(5):
                for z in (0.2, h - 0.3):
                    inlay(
                        b,
                        (x1 + 0.01, x1 + 0.0203),
                        span(s * y * 0.3, s * y * 0.7),
                        (z + 0.022 * k, z + 0.022 * k + 0.008),
                        "black plastic",
                    )
            b.box(
                (x1 + 0.019, x1 + 0.05),
                (s * 0.04 - 0.012, s * 0.04 + 0.012),
                (h * 0.5, h * 0.5 + 0.14),
                "black plastic",
                0.006,
            )


@gear("pegboard")
def pegboard(b: Builder) -> None:
    """A perforated board with hammer, saw, wrenches, screwdrivers, pliers and a roll of tape."""
    d, w, h = b.size
    board = b.material("board", "plywood", "white steel", "grey paint", "blue paint", "black steel")
    x = -d / 2 + 0.015
    b.box((-d / 2, x), (-w / 2, w / 2), (0, h), board, 0.003)
    n, m = int(w / 0.06), int(h / 0.06)
    for i in range(n):
        for j in range(m):
            if (i + j) % 2 == 0:
                y, z = -w / 2 + (i + 0.5) * w / n, (j + 0.5) * h / m
                inlay(b, (x - 0.003, x + 0.0003), (y - 0.004, y + 0.004), (z - 0.004, z + 0.004), "black plastic")
    y = -w / 2 + 0.1
    z = h * 0.55
    b.bar((x + 0.02, y, z), (x + 0.02, y, z + 0.26), 0.014, "beech", 8)
    b.box((x + 0.004, x + 0.036), (y - 0.06, y + 0.05), (z + 0.24, z + 0.28), "iron", 0.006)
    y = 0.02
    face(
        b,
        [(y - 0.2, z + 0.1), (y + 0.12, z + 0.02), (y + 0.12, z + 0.14), (y - 0.2, z + 0.14)],
        (x + 0.006, x + 0.009),
        "steel",
    )
    b.box((x, x + 0.025), (y + 0.1, y + 0.2), (z + 0.01, z + 0.16), "beech", 0.01)
    for k in range(5):
        c = w / 2 - 0.08 - 0.05 * k
        t = 0.22 - 0.025 * k
        zz = h * 0.12
        b.box((x, x + 0.01), (c - 0.009, c + 0.009), (zz, zz + t), "chrome", 0.003)
        for e in (zz, zz + t):
            disc(b, (x + 0.006, c, e), 0.017, 0.012, "chrome", "x", 12)
    for k in range(5):
        c = -w / 2 + 0.07 + 0.055 * k
        b.bar((x + 0.014, c, 0.06), (x + 0.014, c, 0.2), 0.004, "steel", 6)
        b.bar(
            (x + 0.018, c, 0.19),
            (x + 0.018, c, 0.29),
            0.014,
            ("red plastic", "yellow plastic", "blue plastic")[k % 3],
            8,
        )
    disc(b, (x + d * 0.2, w / 2 - 0.1, h * 0.78), 0.05, d * 0.4, "yellow plastic", "x", 20)
    b.box((x, d / 2), (-0.06, 0.08), (0.1, 0.18), "blue plastic", 0.006)


@gear("bicycle")
def bicycle(b: Builder) -> None:
    """Two spoked wheels, a diamond frame, saddle, handlebar, cranks and chain, on its stand."""
    d, w, h = b.size
    paint = b.material(
        "frame", "red paint", "blue paint", "black paint", "teal paint", "yellow paint", "white paint", "green paint"
    )
    R = 0.34
    xr, xf = -d / 2 + R, d / 2 - R
    for x in (xr, xf):
        ring(b, (x, 0, R), R - 0.019, 0.019, "rubber", "y", 16, 6)
        disc(b, (x, 0, R), 0.025, 0.1, "aluminium", "y", 12)
        for k in range(6):
            a = k * math.pi / 6
            c, s = (R - 0.036) * math.cos(a), (R - 0.036) * math.sin(a)
            b.bar((x - c, 0, R - s), (x + c, 0, R + s), 0.0015, "steel", 4)
    bb, seat, head = (xr + 0.43, 0, 0.28), (xr + 0.27, 0, h * 0.76), (xf - 0.17, 0, h * 0.8)
    low = (xf - 0.12, 0, h * 0.66)
    for p, q, r in ((bb, seat, 0.016), (seat, head, 0.015), (bb, low, 0.019), (low, (xf - 0.19, 0, h * 0.86), 0.019)):
        b.bar(p, q, r, paint, 8)
    for s in (-1, 1):
        b.bar((bb[0], s * 0.02, bb[2]), (xr, s * 0.055, R), 0.009, paint, 6)
        b.bar((seat[0], s * 0.02, seat[2] - 0.03), (xr, s * 0.055, R), 0.008, paint, 6)
        b.tube([low, (low[0], s * 0.055, low[2] - 0.03), (xf, s * 0.055, R)], 0.011, paint, 6)
        b.bar((bb[0], s * 0.06, bb[2]), (bb[0] + s * 0.12, s * 0.075, bb[2] - s * 0.11), 0.01, "aluminium", 6)
        b.box(
            (bb[0] + s * 0.12 - 0.045, bb[0] + s * 0.12 + 0.045),
            span(s * 0.08, s * 0.16),
            (bb[2] - s * 0.11 - 0.012, bb[2] - s * 0.11 + 0.012),
            "black plastic",
            0.004,
        )
    b.bar((bb[0], -0.065, bb[2]), (bb[0], 0.065, bb[2]), 0.018, "aluminium", 8)
    disc(b, (bb[0], -0.05, bb[2]), 0.09, 0.004, "black steel", "y", 20)
    disc(b, (xr, -0.05, R), 0.04, 0.012, "black steel", "y", 14)
    for e in (-1, 1):
        b.bar((xr, -0.05, R + e * 0.038), (bb[0], -0.05, bb[2] + e * 0.088), 0.004, "black steel", 4)
    b.bar(seat, (seat[0] - 0.04, 0, h - 0.07), 0.013, "aluminium", 8)
    x, z = seat[0] - 0.04, h - 0.08
    p = [(-0.13, 0.08), (-0.03, 0.07), (0.14, 0.02)]
    b.hull(
        [
            (x + px * q, s * py * q, z + zz)
            for px, py in p
            for s in (-1, 1)
            for q, zz in ((0.8, 0), (1, 0.03), (0.85, 0.06))
        ],
        "black leather",
    )
    b.tube([(xf - 0.19, 0, h * 0.85), (xf - 0.2, 0, h - 0.03), (xf - 0.12, 0, h - 0.03)], 0.014, "aluminium", 8)
    for s in (-1, 1):
        b.tube(
            [
                (xf - 0.12, 0, h - 0.03),
                (xf - 0.14, s * (w / 2 - 0.12), h - 0.015),
                (xf - 0.22, s * (w / 2 - 0.008), h - 0.015),
            ],
            0.012,
            "aluminium",
            8,
        )
        b.bar((xf - 0.16, s * (w / 2 - 0.1), h - 0.016), (xf - 0.225, s * w / 2, h - 0.016), 0.016, "rubber", 8)
    for s in (-1, 1):
        b.bar((bb[0] - 0.06, s * 0.03, 0.27), (bb[0] - 0.08, s * w * 0.3, 0.013), 0.008, "black steel", 6)


@gear("ladder")
def ladder(b: Builder) -> None:
    """A step ladder with flat treads, a platform and red feet."""
    d, w, h = b.size
    rail = b.material("rails", "aluminium", "pine", "yellow paint", "red paint")
    top = h - 0.02
    tip = d * 0.05
    for s in (-1, 1):
        post(b, (d / 2 - 0.04, s * (w / 2 - 0.025), 0.02), (tip, s * w * 0.34, top), rail, 0.03, 0.06)
        post(b, (-d / 2 + 0.03, s * (w / 2 - 0.025), 0.02), (-tip, s * w * 0.34, top - 0.05), rail, 0.025, 0.035)
        for x in (d / 2 - 0.04, -d / 2 + 0.03):
            b.box(
                (x - 0.03, x + 0.03),
                (s * (w / 2 - 0.025) - 0.025, s * (w / 2 - 0.025) + 0.025),
                (0, 0.05),
                "rubber",
                0.005,
            )
    n = max(3, round(h / 0.27))
    for k in range(1, n):
        u = k / n
        x, y = d / 2 - 0.04 + u * (tip - d / 2 + 0.04), (w / 2 - 0.025) + u * (w * 0.34 - w / 2 + 0.025)
        b.box((x - 0.05, x + 0.045), (-y, y), (u * top - 0.012, u * top + 0.012), rail, 0.004)
    b.box((-0.13, 0.13), (-w * 0.38, w * 0.38), (h - 0.035, h), "black plastic" if rail.name != "pine" else rail, 0.008)
    for z in (0.25, 0.6):
        x, y = -d / 2 + 0.03 + z * (d / 2 - 0.03 - tip), (w / 2 - 0.025) + z * (w * 0.34 - w / 2 + 0.025)
        b.bar((x, -y, z * top), (x, y, z * top), 0.01, rail, 8)


@gear("tire_stack", square=True)
def tire_stack(b: Builder) -> None:
    """Three or four tyres one upon another, with tread blocks and rims in some."""
    d, w, h = b.size
    r = d / 2
    n = max(2, round(h / 0.21))
    t = h / n
    for k in range(n):
        z = k * t
        b.add(*_tyre(r, z, t), hulls=_wall(r, z, t))
        if k == n - 1 and b.chance("rim", 0.5):
            disc(b, (0, 0, z + t * 0.6), r * 0.56, t * 0.3, b.material("rim", "aluminium", "black steel"), "z", 24)
            for j in range(5):
                with b.frame(0, 0, z + t * 0.75, yaw=j * 2 * math.pi / 5):
                    b.box((0.03, r * 0.54), (-0.02, 0.02), (-0.01, t * 0.1), "steel", 0.003)


def _profile(r: float, z: float, t: float) -> list[tuple[float, float]]:
    return [
        (r * 0.62, z),
        (r * 0.93, z + 0.004),
        (r, z + t * 0.18),
        (r, z + t * 0.82),
        (r * 0.93, z + t - 0.004),
        (r * 0.62, z + t),
    ]


def _tyre(r: float, z: float, t: float):
    import numpy as np

    a = np.arange(24) * 2 * np.pi / 24
    p = np.array([(q, zz) for q, zz in _profile(r, z, t)])
    n = len(p)
    v = np.concatenate([np.c_[q * np.cos(a), q * np.sin(a), np.full(24, zz)] for q, zz in p])
    f = []
    for i in range(n):
        j = (i + 1) % n
        for k in range(24):
            m = (k + 1) % 24
            f += [(i * 24 + k, i * 24 + m, j * 24 + m), (i * 24 + k, j * 24 + m, j * 24 + k)]
    return (v, np.array(f, dtype=np.int32)), "rubber"


def _wall(r: float, z: float, t: float):
    import numpy as np

    from ... import shapes

    out = []
    for k in range(24):
        a = np.array([k, k + 1]) * 2 * np.pi / 24
        out.append(
            shapes.hull(np.array([(q * math.cos(x), q * math.sin(x), zz) for x in a for q, zz in _profile(r, z, t)]))
        )
    return out


@gear("sawhorse")
def sawhorse(b: Builder) -> None:
    """A beam on four splayed legs."""
    d, w, h = b.size
    wood = b.material("wood", "pine", "yellow paint", "plywood", "red paint")
    b.box((-0.045, 0.045), (-w / 2, w / 2), (h - 0.09, h), wood, 0.004)
    for sx in (-1, 1):
        for s in (-1, 1):
            post(
                b,
                (sx * (d / 2 - 0.03), s * (w / 2 - 0.03), 0.01),
                (sx * 0.05, s * (w / 2 - 0.14), h - 0.03),
                wood,
                0.035,
                0.07,
            )
    for s in (-1, 1):
        b.box(
            (-d * 0.32, d * 0.32),
            (s * (w / 2 - 0.08) - 0.012, s * (w / 2 - 0.08) + 0.012),
            (h * 0.42, h * 0.42 + 0.07),
            wood,
            0.003,
        )


@gear("drill_press")
def drill_press(b: Builder) -> None:
    """A cast foot, column, table, head with belt cover, chuck and three-arm lever."""
    d, w, h = b.size
    paint = b.material("paint", *_LOUD)
    x = -d * 0.22
    b.box((-d / 2, d / 2), (-w * 0.45, w * 0.45), (0, 0.05), "iron", 0.01)
    b.bar((x, 0, 0.04), (x, 0, h - 0.2), 0.035, "steel", 16)
    z = h * 0.55
    b.box((x, x + 0.15), (-0.06, 0.06), (z - 0.09, z - 0.02), "iron", 0.01)
    disc(b, (d * 0.18, 0, z), min(0.14, w * 0.45), 0.03, "iron", "z", 24)
    b.box((x - 0.1, d * 0.3), (-0.1, 0.1), (h - 0.3, h - 0.1), paint, 0.02)
    b.box((x - 0.12, d * 0.34), (-0.11, 0.11), (h - 0.11, h), paint, 0.03)
    disc(b, (x - 0.1, 0, h - 0.2), 0.08, 0.16, "grey plastic", "x", 20, 0.01)
    with b.frame(d * 0.18):
        b.lathe(
            [(0.004, h - 0.52), (0.006, h - 0.44), (0.022, h - 0.43), (0.03, h - 0.36), (0.03, h - 0.29)], "steel", 14
        )
    c = (d * 0.1, -0.12, h - 0.22)
    disc(b, c, 0.03, 0.06, "black plastic", "y", 14)
    for k in range(3):
        a = k * 2 * math.pi / 3 + 0.5
        e = (c[0] + 0.15 * math.cos(a), -w / 2 + 0.025, c[2] + 0.15 * math.sin(a))
        b.bar(c, e, 0.007, "steel", 6)
        b.ball((0.02, 0.02, 0.02), e, "black plastic", 8)
    inlay(b, (d * 0.2, d * 0.3 + 0.0003), (-0.04, 0.04), (h - 0.22, h - 0.17), "yellow plastic")


@gear("table_saw")
def table_saw(b: Builder) -> None:
    """A steel top with a blade, guard, fence and mitre slots, on a cabinet stand."""
    d, w, h = b.size
    paint = b.material("paint", *_LOUD)
    z = h - 0.12
    b.hull(
        [
            (x * q, y * q, zz)
            for x in (-d * 0.36, d * 0.36)
            for y in (-w * 0.3, w * 0.3)
            for q, zz in ((1.05, 0), (0.9, z - 0.05))
        ],
        paint,
    )
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (z - 0.05, z), "steel", 0.005)
    for s in (-1, 1):
        inlay(
            b,
            (-d / 2 + 0.01, d / 2 - 0.01),
            (s * 0.13 - 0.01, s * 0.13 + 0.01),
            (z - 0.02, z + 0.0003),
            "black plastic",
        )
    inlay(b, (-0.2, 0.2), (-0.04, 0.04), (z - 0.02, z + 0.0003), "red paint")
    disc(b, (0, 0, z - 0.02), 0.12, 0.004, "chrome", "y", 28)
    b.box((-0.16, 0.12), (-0.025, -0.01), (z + 0.07, h), "yellow plastic", 0.005)
    b.box((-0.16, 0.12), (0.01, 0.025), (z + 0.07, h), "yellow plastic", 0.005)
    b.box((-0.16, 0.12), (-0.012, 0.012), (h - 0.015, h), "yellow plastic", 0.003)
    b.box((-0.2, -0.16), (-0.012, 0.012), (z - 0.01, h), "steel", 0.003)
    b.box((-d / 2, d / 2), (w * 0.28 - 0.025, w * 0.28 + 0.025), (z, z + 0.06), "aluminium", 0.004)
    disc(b, (d * 0.36, -w * 0.1, z * 0.6), 0.08, 0.03, "black plastic", "x", 20)
    b.box((d * 0.32, d * 0.38), (w * 0.12, w * 0.2), (z * 0.7, z * 0.85), "red plastic", 0.006)


@gear("air_compressor")
def air_compressor(b: Builder) -> None:
    """A lying tank with domed ends, motor and pump on top, wheels, handle, gauges."""
    d, w, h = b.size
    paint = b.material("tank", *_LOUD)
    r = min(h * 0.27, w * 0.42)
    z = r + 0.09
    long = d - 0.12
    with b.frame(-d / 2 + 0.02, 0, z, pitch=math.pi / 2):
        b.lathe(
            [(r * 0.4, 0), (r * 0.8, 0.03), (r, 0.09), (r, long - 0.09), (r * 0.8, long - 0.03), (r * 0.4, long)],
            paint,
            24,
        )
    for s in (-1, 1):
        disc(b, (-d * 0.32, s * (w / 2 - 0.03), 0.1), 0.1, 0.05, "rubber", "y", 20, 0.008)
        disc(b, (-d * 0.32, s * (w / 2 - 0.03), 0.1), 0.05, 0.056, "grey plastic", "y", 16)
    b.bar((-d * 0.32, -w / 2 + 0.03, 0.1), (-d * 0.32, w / 2 - 0.03, 0.1), 0.012, "steel", 8)
    b.box((d * 0.24, d * 0.3), (-0.08, 0.08), (0, 0.2), "black steel", 0.004)
    t = z + r
    b.box((-d * 0.3, d * 0.25), (-w * 0.3, w * 0.3), (t - 0.06, t + 0.01), "black steel", 0.004)
    disc(b, (-d * 0.14, 0, t + 0.1), 0.095, d * 0.3, "black plastic", "x", 20, 0.015)
    b.box((d * 0.08, d * 0.2), (-0.07, 0.07), (t, h), "aluminium", 0.012)
    for k in range(5):
        zz = t + 0.05 + k * (h - t - 0.09) / 5
        b.box((d * 0.07, d * 0.21), (-0.08, 0.08), (zz, zz + 0.008), "aluminium", 0)
    for k in (-1, 1):
        disc(b, (d * 0.3, k * 0.06, t - 0.01), 0.03, 0.03, "white plastic", "x", 16)
    b.tube(
        [
            (d * 0.3, -0.12, t - 0.08),
            (d / 2 - 0.016, -0.12, t + 0.06),
            (d / 2 - 0.016, 0.12, t + 0.06),
            (d * 0.3, 0.12, t - 0.08),
        ],
        0.016,
        "rubber",
        8,
    )


@gear("fire_extinguisher")
def fire_extinguisher(b: Builder) -> None:
    """A red cylinder with label, valve, lever, hose and a wall bracket."""
    d, w, h = b.size
    r = min(d, w) / 2 - 0.015
    t = h - 0.11
    red = b.material("tank", "red plastic", "red paint")
    b.lathe([(r * 0.95, 0), (r, 0.02), (r, t - 0.06), (r * 0.7, t - 0.015), (r * 0.3, t)], red, 24)
    b.frustum(0.02, 0.02, (t - 0.01, h - 0.06), "brass", 12)
    b.box((-0.02, 0.09), (-0.012, 0.012), (h - 0.05, h - 0.035), "black plastic", 0.003)
    b.hull(
        [
            (x, y, z)
            for y in (-0.012, 0.012)
            for x, z in ((-0.02, h - 0.03), (0.09, h - 0.012), (0.09, h), (-0.02, h - 0.018))
        ],
        "black plastic",
    )
    b.box((-0.025, 0.01), (-0.014, 0.014), (h - 0.07, h - 0.015), "steel", 0.003)
    disc(b, (0.02, 0, h - 0.075), 0.018, 0.02, "white plastic", "x", 14)
    b.tube(
        [(0, 0.015, h - 0.065), (0, r * 0.8, h - 0.08), (0, r + 0.008, t * 0.8), (0, r + 0.008, t * 0.45)],
        0.009,
        "rubber",
        8,
    )
    b.frustum(r + 0.0003, r + 0.0003, (t * 0.4, t * 0.68), "white plastic", 24)
    b.frustum(r + 0.0004, r + 0.0004, (t * 0.55, t * 0.6), red, 24)
    b.box((-r - 0.015, -r + 0.01), (-0.03, 0.03), (t * 0.2, t * 0.9), "black steel", 0.002)


@gear("electrical_panel")
def electrical_panel(b: Builder) -> None:
    """A wall box with a door, a lock, a warning sign and conduits above."""
    d, w, h = b.size
    paint = b.material("case", "grey paint", "white steel", "light grey paint")
    t = h - 0.1
    b.box((-d / 2, d / 2 - 0.02), (-w / 2, w / 2), (0, t), paint, 0.006)
    x = d / 2 - 0.005
    b.box((d / 2 - 0.021, x), (-w / 2 + 0.015, w / 2 - 0.015), (0.015, t - 0.015), paint, 0.004)
    b.hull(
        [(x + e, yy, t * 0.68 + zz) for e in (-0.002, 0.0004) for yy, zz in ((-0.06, 0), (0.06, 0), (0, 0.1))],
        "yellow plastic",
    )
    b.hull(
        [
            (x + e, yy, t * 0.68 + zz)
            for e in (-0.001, 0.0007)
            for yy, zz in ((0.004, 0.07), (-0.014, 0.035), (0.012, 0.04), (-0.004, 0.01))
        ],
        "black plastic",
    )
    b.box((x - 0.002, d / 2), (w * 0.36 - 0.012, w * 0.36 + 0.012), (t * 0.4, t * 0.52), "black plastic", 0.002)
    for s in (-0.25, 0.0, 0.25):
        with b.frame(0, s * w):
            b.frustum(0.018, 0.018, (t - 0.01, h), "grey plastic", 12)


@gear("jerry_can")
def jerry_can(b: Builder) -> None:
    """A fuel can with pressed sides, three handles and a cap."""
    d, w, h = b.size
    paint = b.material("can", "red plastic", "green paint", "blue plastic", "yellow plastic")
    t = h - 0.05
    side(
        b,
        [
            (-d / 2, 0.02),
            (-d / 2 + 0.02, 0),
            (d / 2 - 0.02, 0),
            (d / 2, 0.02),
            (d / 2, t - 0.06),
            (d / 2 - 0.07, t),
            (-d / 2 + 0.02, t),
            (-d / 2, t - 0.02),
        ],
        (-w / 2, w / 2),
        paint,
        0.008,
    )
    for s in (-1, 1):
        for k in (-1, 1):
            b.bar(
                (-d * 0.34, s * (w / 2 - 0.004), t / 2 + k * t * 0.3),
                (d * 0.34, s * (w / 2 - 0.004), t / 2 - k * t * 0.3),
                0.008,
                paint,
                6,
            )
    for y in (-w * 0.3, 0, w * 0.3):
        b.tube(
            [(-d * 0.36, y, t - 0.01), (-d * 0.3, y, h - 0.01), (d * 0.08, y, h - 0.01), (d * 0.14, y, t - 0.01)],
            0.009,
            paint,
            6,
        )
    b.bar((d / 2 - 0.04, 0, t - 0.05), (d / 2 - 0.012, 0, t - 0.012), 0.026, "black plastic", 12)
