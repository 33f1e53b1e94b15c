"""Tables and machines to play at."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_kit import disc, gear, inlay, post, ring, side

_BALLS = (
    "yellow plastic",
    "blue plastic",
    "red plastic",
    "lilac plastic",
    "orange plastic",
    "green plastic",
    "mahogany",
    "black plastic",
)


@gear("pool_table")
def pool_table(b: Builder) -> None:
    """Cloth between cushions and wooden rails, six pockets, balls, cue, heavy legs."""
    d, w, h = b.size
    wood = b.material("rails", "mahogany", "walnut", "black paint", "oak", "cherry")
    cloth = b.material("cloth", "green paint", "green fabric", "blue fabric", "red fabric", "green fabric")
    x, y = d / 2, w / 2
    rail = 0.13
    bed = h - 0.045
    with b.solid("bed"):
        b.box((-x + 0.04, x - 0.04), (-y + 0.04, y - 0.04), (h - 0.24, bed - 0.03), wood, 0.01)
        b.box((-x + rail, x - rail), (-y + rail, y - rail), (bed - 0.03, bed), cloth, 0)
        for s in (-1, 1):
            xs = (x - rail, x) if s > 0 else (-x, -x + rail)
            b.box(xs, (-y, y), (h - 0.12, h), wood, 0.015)
            ys = (y - rail, y) if s > 0 else (-y, -y + rail)
            b.box((-x + rail, x - rail), ys, (h - 0.12, h), wood, 0.015)
            e = s * (x - rail)
            for k in (-1, 1):
                lo, hi = sorted((k * 0.07, k * (y - rail - 0.06)))
                b.box((min(e, e - s * 0.045), max(e, e - s * 0.045)), (lo, hi), (bed - 0.001, h - 0.004), cloth, 0.01)
            f = s * (y - rail)
            b.box(
                (-x + rail + 0.06, x - rail - 0.06),
                (min(f, f - s * 0.045), max(f, f - s * 0.045)),
                (bed - 0.001, h - 0.004),
                cloth,
                0.01,
            )
        for sx in (-1, 1):
            for share in (-1, 0, 1):
                px, py = sx * (x - rail - 0.015 + 0.05 * (share == 0)), share * (y - rail - 0.015)
                disc(b, (px, py, h - 0.01), 0.062, 0.024, "black leather", "z", 20)
                disc(b, (px, py, h - 0.0095), 0.045, 0.0254, "black plastic", "z", 20)
            for k in range(-3, 4):
                if k:
                    disc(b, (sx * (x - 0.06), k * y / 4, h), 0.009, 0.0016, "chalk pigment", "z", 8)
        r = 0.028
        n = 0
        for row in range(5):
            for k in range(row + 1):
                b.ball((r, r, r), ((k - row / 2) * 2 * r, y * 0.36 + row * 1.75 * r, bed + r), _BALLS[n % 8], 10)
                n += 1
        b.ball((r, r, r), (0.05, -y * 0.5, bed + r), "white plastic", 10)
        b.bar((0.16, -y * 0.85, h + 0.012), (0.09, -y * 0.02, bed + 0.03), 0.01, "light oak", 8)
    style = b.pick("legs", ["block", "turned"])
    for sx in (-1, 1):
        for sy in (-1, 1):
            with b.solid(f"leg {sx} {sy}"), b.frame(sx * (x - 0.16), sy * (y - 0.2)):
                if style == "block":
                    b.hull(
                        [(a * q, c * q, z) for a in (-1, 1) for c in (-1, 1) for q, z in ((0.06, 0), (0.1, h - 0.22))],
                        wood,
                    )
                else:
                    b.lathe(
                        [
                            (0.06, 0),
                            (0.07, 0.05),
                            (0.045, 0.1),
                            (0.09, 0.3),
                            (0.075, 0.42),
                            (0.05, 0.46),
                            (0.1, h - 0.22),
                        ],
                        wood,
                        16,
                    )


@gear("table_football")
def table_football(b: Builder) -> None:
    """A box with a green field, eight rods with men in two colours, goals and handles."""
    d, w, h = b.size
    wood = b.material("case", "walnut", "black paint", "light oak", "grey paint", "mahogany")
    one, two = b.pick(
        "teams",
        [("red plastic", "blue plastic"), ("yellow plastic", "black plastic"), ("white plastic", "red plastic")],
    )
    x, y = 0.37, w / 2
    z = h - 0.22
    with b.solid("case"):
        b.box((-x, x), (-y, y), (z - 0.03, z), wood, 0.004)
        inlay(b, (-x + 0.02, x - 0.02), (-y + 0.02, y - 0.02), (z - 0.01, z + 0.0003), "green fabric")
        inlay(b, (-x + 0.02, x - 0.02), (-0.005, 0.005), (z - 0.01, z + 0.00035), "white plastic")
        for s in (-1, 1):
            b.box((x - 0.025, x) if s > 0 else (-x, -x + 0.025), (-y, y), (z - 0.05, h - 0.01), wood, 0.004)
            ys = (y - 0.03, y) if s > 0 else (-y, -y + 0.03)
            b.box((-x, x), ys, (z - 0.05, h - 0.01), wood, 0.004)
            inlay(b, (-0.1, 0.1), (s * (y - 0.03) - 0.0003, s * (y - 0.03) + 0.0003), (z, z + 0.09), "black plastic")
            for k in range(6):
                b.box(
                    (-0.16 + 0.05 * k, -0.125 + 0.05 * k),
                    (s * (y - 0.07) - 0.004, s * (y - 0.07) + 0.004),
                    (h - 0.012, h),
                    two if s > 0 else one,
                    0.002,
                )
            b.box(
                (-0.18, 0.18), (s * (y - 0.07) - 0.006, s * (y - 0.07) + 0.006), (h - 0.02, h - 0.01), "black steel", 0
            )
        men = (1, 2, 3, 5, 5, 3, 2, 1)
        team = (0, 0, 1, 0, 1, 0, 1, 1)
        for k, count in enumerate(men):
            py = (k - 3.5) * (w - 0.16) / 8
            push = b.uniform(f"rod {k}", -0.08, 0.08)
            zz = z + 0.115
            mine = team[k]
            reach = d / 2
            a, c = (-x - 0.14 + push, reach) if mine == 0 else (-reach, x + 0.14 + push)
            b.bar((a, py, zz), (c, py, zz), 0.008, "chrome", 6)
            end = c if mine == 0 else a
            sign = 1 if mine == 0 else -1
            b.bar((end, py, zz), (end - sign * 0.12, py, zz), 0.017, "black plastic", 8)
            for m in range(count):
                px = (m - (count - 1) / 2) * (0.6 / max(2, count)) + push * 0.5
                b.hull(
                    [
                        (px + e * q, py + f * t, zz + g)
                        for e in (-1, 1)
                        for f in (-1, 1)
                        for q, t, g in ((0.012, 0.014, -0.09), (0.02, 0.012, 0.0), (0.02, 0.012, 0.03))
                    ],
                    one if mine == 0 else two,
                )
                b.ball((0.014, 0.014, 0.017), (px, py, zz + 0.044), "skin tone", 8)
        b.ball((0.017, 0.017, 0.017), (0.05, 0.02, z + 0.017), "white plastic", 10)
    for s in (-1, 1):
        with b.solid(f"legs {s}"):
            for sx in (-1, 1):
                px, py = sx * (x - 0.06), s * (y - 0.1)
                b.box((px - 0.05, px + 0.05), (py - 0.05, py + 0.05), (0.03, z), wood, 0.006)
                disc(b, (px, py, 0.015), 0.03, 0.03, "rubber", "z", 12)
            b.box((-x + 0.1, x - 0.1), (s * (y - 0.1) - 0.02, s * (y - 0.1) + 0.02), (0.2, 0.3), wood, 0.004)


@gear("table_tennis")
def table_tennis(b: Builder) -> None:
    """Two blue or green halves with white lines, a net, bats and a ball; the players stand left and right."""
    d, w, h = b.size
    top = b.material("top", "blue paint", "green paint", "navy paint")
    metal = b.material("legs", "black steel", "white steel", "steel")
    z = h - 0.1525
    x = 0.7625
    with b.solid("top"):
        for s in (-1, 1):
            ys = (0.002, w / 2) if s > 0 else (-w / 2, -0.002)
            b.box((-x, x), ys, (z - 0.022, z), top, 0)
            b.box(
                (-x + 0.03, x - 0.03),
                (s * 0.03, s * (w / 2 - 0.03)) if s > 0 else (-w / 2 + 0.03, -0.03),
                (z - 0.065, z - 0.02),
                metal,
                0.004,
            )
            for xs in ((-x, -x + 0.02), (x - 0.02, x), (-0.003, 0.003)):
                inlay(b, xs, ys, (z - 0.01, z + 0.0003), "white plastic")
            inlay(
                b,
                (-x, x),
                (w / 2 - 0.02, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.02),
                (z - 0.01, z + 0.0003),
                "white plastic",
            )
    with b.solid("net"):
        b.box((-d / 2 + 0.01, d / 2 - 0.01), (-0.002, 0.002), (z + 0.01, h - 0.015), "sheer fabric", 0)
        b.box((-d / 2 + 0.01, d / 2 - 0.01), (-0.004, 0.004), (h - 0.015, h), "white fabric", 0)
        for s in (-1, 1):
            b.box((s * (d / 2 - 0.01) - 0.01, s * (d / 2 - 0.01) + 0.01), (-0.01, 0.01), (z - 0.05, h), metal, 0.003)
            b.box(span(s * (x - 0.05), s * d / 2), (-0.03, 0.03), (z - 0.05, z - 0.022), metal, 0.003)
    with b.solid("top"):
        for s, look in ((-1, "red plastic"), (1, "black plastic")):
            with b.frame(s * 0.3, s * w * 0.32, z, yaw=s * 0.6):
                disc(b, (0, 0, 0.008), 0.078, 0.014, look, "z", 20)
                b.box((-0.17, -0.06), (-0.013, 0.013), (0.001, 0.02), "light oak", 0.005)
        b.ball((0.02, 0.02, 0.02), (0.1, -w * 0.2, z + 0.02), "orange plastic", 10)
    for s in (-1, 1):
        with b.solid(f"legs {s}"):
            for sx in (-1, 1):
                post(b, (sx * (x - 0.14), s * 0.42, z - 0.05), (sx * (x - 0.14), s * 0.3, 0.06), metal, 0.04)
                post(
                    b,
                    (sx * (x - 0.14), s * (w / 2 - 0.25), z - 0.05),
                    (sx * (x - 0.14), s * (w / 2 - 0.3), 0.0),
                    metal,
                    0.04,
                )
                disc(b, (sx * (x - 0.14), s * 0.3, 0.05), 0.05, 0.03, "black plastic", segments=16)
            b.box((-x + 0.14, x - 0.14), (s * 0.3 - 0.02, s * 0.3 + 0.02), (0.12, 0.16), metal, 0.003)


@gear("air_hockey")
def air_hockey(b: Builder) -> None:
    """A white rink with rounded rails, red and blue lines, goals, strikers and a puck."""
    d, w, h = b.size
    case = b.material("case", "black paint", "blue paint", "red paint", "navy paint")
    x, y = d / 2, w / 2
    z = h - 0.05
    with b.solid("top"):
        b.box((-x + 0.05, x - 0.05), (-y + 0.05, y - 0.05), (z - 0.16, z), "white plastic", 0)
        b.box((-x + 0.03, x - 0.03), (-y + 0.03, y - 0.03), (z - 0.2, z - 0.02), case, 0.01)
        for s in (-1, 1):
            b.box((x - 0.09, x) if s > 0 else (-x, -x + 0.09), (-y, y), (z - 0.08, h), case, 0.02)
            b.box((-x + 0.08, x - 0.08), (y - 0.09, y) if s > 0 else (-y, -y + 0.09), (z - 0.08, h), case, 0.02)
            inlay(b, (-0.17, 0.17), (s * (y - 0.09) - 0.0003, s * (y - 0.09) + 0.0003), (z, z + 0.028), "black plastic")
            inlay(
                b,
                (-x + 0.09, x - 0.09),
                (s * y * 0.35 - 0.006, s * y * 0.35 + 0.006),
                (z - 0.01, z + 0.0003),
                "blue plastic",
            )
            disc(b, (0.12 * s, s * y * 0.6, z + 0.01), 0.048, 0.02, "red plastic", "z", 24, 0.004)
            disc(b, (0.12 * s, s * y * 0.6, z + 0.03), 0.02, 0.04, "red plastic", "z", 16, 0.006)
        inlay(b, (-x + 0.09, x - 0.09), (-0.006, 0.006), (z - 0.01, z + 0.0003), "red plastic")
        disc(b, (0, 0, z), 0.16, 0.0006, "red plastic", "z", 28)
        disc(b, (0, 0, z), 0.15, 0.0008, "white plastic", "z", 28)
        disc(b, (-0.1, y * 0.12, z + 0.004), 0.032, 0.008, "green plastic", "z", 20)
    for s in (-1, 1):
        with b.solid(f"leg {s}"):
            b.box((-x + 0.14, x - 0.14), (s * (y - 0.3) - 0.08, s * (y - 0.3) + 0.08), (0.05, z - 0.18), case, 0.015)
            b.box((-x + 0.06, x - 0.06), (s * (y - 0.3) - 0.12, s * (y - 0.3) + 0.12), (0, 0.06), "black plastic", 0.01)


@gear("arcade_machine")
def arcade_machine(b: Builder) -> None:
    """Shaped side panels, lit marquee, slanted screen, control panel with sticks and buttons, coin door."""
    d, w, h = b.size
    case = b.material("sides", "black paint", "red paint", "blue paint", "yellow paint", "teal paint")
    trim = b.material("trim", "yellow plastic", "red plastic", "blue plastic", "orange plastic")
    x0, x1, y = -d / 2, d / 2, w / 2
    k = h / 1.75
    shape = [
        (x0, 0),
        (x1 - 0.1, 0),
        (x1 - 0.1, 0.75 * k),
        (x1, 0.88 * k),
        (x1, 0.98 * k),
        (x1 - 0.26, 1.05 * k),
        (x1 - 0.36, 1.45 * k),
        (x1 - 0.1, 1.52 * k),
        (x1 - 0.1, h),
        (x0 + 0.12, h),
        (x0, h - 0.25),
    ]
    for s in (-1, 1):
        ys = (y - 0.025, y) if s > 0 else (-y, -y + 0.025)
        side(b, shape, ys, case)
        for i in range(3):
            zz = (0.25 + 0.07 * i) * k
            inlay(b, (x0 + 0.05, x1 - 0.15), (s * y - 0.0003, s * y + 0.0003), (zz, zz + 0.035), trim)
    i = y - 0.02
    b.box((x0 + 0.02, x1 - 0.13), (-i, i), (0.02, 0.8 * k), "black plastic", 0.004)
    b.box((x0 + 0.02, x1 - 0.42), (-i, i), (0.7 * k, h - 0.26), "black plastic", 0.004)
    side(
        b,
        [
            (x1 - 0.42, 0.8 * k),
            (x1 - 0.14, 0.8 * k),
            (x1 - 0.03, 0.9 * k),
            (x1 - 0.03, 0.945 * k),
            (x1 - 0.29, 1.02 * k),
            (x1 - 0.42, 1.02 * k),
        ],
        (-i, i),
        trim,
    )
    side(
        b,
        [(x1 - 0.44, 1.0 * k), (x1 - 0.3, 1.03 * k), (x1 - 0.4, 1.43 * k), (x1 - 0.44, 1.43 * k)],
        (-i, i),
        "black glass",
    )
    with b.frame(x1 - 0.3, 0, 1.035 * k, pitch=-0.245):
        b.box((-0.03, 0.004), (-i + 0.05, i - 0.05), (0.05, 0.36 * k), "screen", 0.004)
        for a in range(4):
            for c in range(6):
                inlay(
                    b,
                    (0.0, 0.0043),
                    (-0.16 + 0.06 * c, -0.13 + 0.06 * c),
                    (0.2 + 0.03 * a, 0.215 + 0.03 * a),
                    ("red plastic", "yellow plastic", "green plastic", "blue plastic")[a],
                )
        inlay(b, (0.0, 0.0043), (-0.03, 0.03), (0.08, 0.09), "white plastic")
    b.box((x0 + 0.12, x1 - 0.12), (-i, i), (1.5 * k, h - 0.01), "black plastic", 0.004)
    b.box((x1 - 0.14, x1 - 0.11), (-i + 0.02, i - 0.02), (1.54 * k, h - 0.02), "lit shade", 0.004)
    inlay(b, (x1 - 0.13, x1 - 0.1097), (-i * 0.7, i * 0.7), (1.59 * k, 1.66 * k), trim)
    slope = math.atan2(0.075 * k, 0.26)
    for s, look in ((-1, "red plastic"), (1, "blue plastic")):
        with b.frame(x1 - 0.16, s * w * 0.22, 0.9825 * k, pitch=slope):
            b.bar((0, -0.08, -0.003), (0, -0.08, 0.055), 0.007, "steel", 8)
            b.ball((0.02, 0.02, 0.02), (0, -0.08, 0.065), look, 10)
            for q in range(6):
                disc(b, (-0.02 + 0.04 * (q // 3), -0.01 + 0.035 * (q % 3), 0.003), 0.013, 0.016, look, "z", 10)
    b.box((x1 - 0.14, x1 - 0.115), (-0.13, 0.13), (0.25 * k, 0.62 * k), "black steel", 0.004)
    for s in (-1, 1):
        inlay(b, (x1 - 0.13, x1 - 0.1147), (s * 0.06 - 0.015, s * 0.06 + 0.015), (0.45 * k, 0.52 * k), "orange plastic")


@gear("pinball_machine")
def pinball_machine(b: Builder) -> None:
    """A sloping glazed playfield on steel legs with a lit back box."""
    d, w, h = b.size
    case = b.material("case", "black paint", "red paint", "blue paint", "navy paint")
    x0, x1, y = -d / 2, d / 2, w * 0.4
    with b.solid("table"):
        for s in (-1, 1):
            ys = (y - 0.03, y) if s > 0 else (-y, -y + 0.03)
            side(b, [(x0 + 0.05, 0.68), (x1, 0.6), (x1, 0.87), (x0 + 0.05, 1.05)], ys, case)
            inlay(b, (x0 + 0.2, x1 - 0.2), (s * y - 0.0003, s * y + 0.0003), (0.72, 0.78), "yellow plastic")
            inlay(b, (x0 + 0.3, x1 - 0.4), (s * y - 0.0003, s * y + 0.0003), (0.8, 0.84), "orange plastic")
        i = y - 0.03
        slope = math.atan2(0.18, d - 0.05)
        with b.frame(x1, 0, 0.87, pitch=slope):
            long = (d - 0.05) / math.cos(slope)
            b.box((-long, 0), (-i, i), (-0.2, -0.05), "navy paint", 0)
            top = -0.05
            disc(b, (-long * 0.2, 0, top + 0.001), 0.1, 0.003, "yellow plastic", "z", 20)
            for a, c, look in ((0.6, -0.1, "red plastic"), (0.62, 0.1, "green plastic"), (0.72, 0.0, "orange plastic")):
                disc(b, (-long * a, c, top + 0.02), 0.045, 0.04, "white plastic", "z", 20)
                disc(b, (-long * a, c, top + 0.036), 0.05, 0.012, look, "z", 20)
            for a, c, look in (
                (0.4, -0.14, "red plastic"),
                (0.42, 0.15, "blue plastic"),
                (0.5, 0.0, "lamp glow"),
                (0.85, -0.12, "blue plastic"),
                (0.84, 0.13, "yellow plastic"),
                (0.33, 0.0, "red plastic"),
            ):
                disc(b, (-long * a, c, top + 0.001), 0.022, 0.006, look, "z", 12)
            for s in (-1, 1):
                with b.frame(-long * 0.14, s * 0.1, top, yaw=s * 1.0):
                    b.box((-0.01, 0.01), span(0, -s * 0.08), (0, 0.02), "white plastic", 0.004)
                b.bar(
                    (-long * 0.25, s * 0.2, top + 0.01), (-long * 0.17, s * 0.11, top + 0.01), 0.008, "red plastic", 6
                )
            b.box((-long, 0), (-i, i), (-0.004, 0.0), "glass", 0)
        b.box((x1 - 0.02, x1 + 0.008), (-y - 0.004, y + 0.004), (0.82, 0.885), "chrome", 0.006)
        b.box((x1 - 0.03, x1 - 0.0), (-y, y), (0.6, 0.86), case, 0.003)
        b.box((x1 - 0.01, x1 + 0.006), (-0.12, 0.12), (0.64, 0.8), "black steel", 0.003)
        b.bar((x1, y - 0.1, 0.75), (x1 + 0.03, y - 0.1, 0.75), 0.012, "chrome", 10)
        b.box((x0 + 0.05, x1 - 0.03), (-y, y), (0.66, 0.68), case, 0)
    with b.solid("back box"):
        b.box((x0, x0 + 0.26), (-w / 2, w / 2), (1.08, h), case, 0.008)
        b.box((x0 + 0.03, x0 + 0.2), (-y + 0.05, y - 0.05), (0.9, 1.1), case, 0)
        b.box((x0 + 0.255, x0 + 0.264), (-w / 2 + 0.03, w / 2 - 0.03), (1.3, h - 0.04), "lit shade", 0.002)
        disc(b, (x0 + 0.264, 0, (1.3 + h) / 2), 0.19, 0.004, "red plastic", "x", 28)
        disc(b, (x0 + 0.2645, 0, (1.3 + h) / 2), 0.14, 0.005, "yellow plastic", "x", 28)
        b.hull(
            [
                (x0 + 0.25 + 0.018 * e, yy, (1.3 + h) / 2 + zz)
                for e in (0, 1)
                for yy, zz in ((0, 0.13), (0.11, -0.08), (-0.11, -0.08))
            ],
            "blue plastic",
        )
        b.box((x0 + 0.255, x0 + 0.262), (-w / 2 + 0.06, w / 2 - 0.06), (1.13, 1.25), "black glass", 0.002)
        for k in range(4):
            inlay(b, (x0 + 0.26, x0 + 0.2623), (-0.18 + 0.1 * k, -0.12 + 0.1 * k), (1.17, 1.21), "orange plastic")
    for sx, z in ((x0 + 0.08, 0.72), (x1 - 0.02, 0.68)):
        with b.solid(f"legs {sx > 0}"):
            for s in (-1, 1):
                c = s * (y + 0.01)
                b.hull(
                    [
                        (sx + e * q + (0.03 if z > 0.7 else -0.03) * (zz > 0.1) * 0, c + f * q, zz)
                        for e in (-1, 1)
                        for f in (-1, 1)
                        for q, zz in ((0.018, 0.02), (0.028, z))
                    ],
                    "chrome",
                )
                disc(b, (sx, c, 0.012), 0.025, 0.024, "black plastic", "z", 12)


@gear("dartboard", square=True)
def dartboard(b: Builder) -> None:
    """Twenty black and cream sectors with red and green rings and a bull."""
    d, w, h = b.size
    r = h / 2
    face_x = d - 0.012
    w2 = r
    with b.frame(0, 0, r):
        disc(b, (face_x / 2, 0, 0), w2, face_x, "black plastic", "x", 40)
        for k in range(20):
            a0 = (k - 0.5) * math.pi / 10
            odd = k % 2
            for lo, hi, look in (
                (0.07, 0.42, "black plastic" if odd else "beige fabric"),
                (0.42, 0.47, "red plastic" if odd else "green plastic"),
                (0.47, 0.7, "black plastic" if odd else "beige fabric"),
                (0.7, 0.755, "red plastic" if odd else "green plastic"),
            ):
                if look == "black plastic":
                    continue
                p = [
                    (q * w2 * math.sin(a), q * w2 * math.cos(a))
                    for q, a in ((lo, a0), (lo, a0 + math.pi / 10), (hi, a0 + math.pi / 10), (hi, a0))
                ]
                b.hull([(x, py, pz) for py, pz in p for x in (face_x - 0.002, face_x + 0.0005)], look)
            a = k * math.pi / 10
            py, pz = 0.87 * w2 * math.sin(a), 0.87 * w2 * math.cos(a)
            inlay(
                b, (face_x - 0.001, face_x + 0.0003), (py - 0.006, py + 0.006), (pz - 0.01, pz + 0.01), "white plastic"
            )
        disc(b, (face_x, 0, 0), w2 * 0.07, 0.0012, "green plastic", "x", 16)
        disc(b, (face_x, 0, 0), w2 * 0.032, 0.002, "red plastic", "x", 12)
        ring(b, (face_x - 0.002, 0, 0), w2 * 0.985, w2 * 0.015, "black steel", "x", 32, 6)
        for k, (py, pz) in enumerate(((0.2, 0.3), (-0.1, 0.52), (0.02, -0.1))):
            if k < b.whole("darts", 0, 3):
                q = (py * w2, pz * w2)
                b.bar((face_x, *q), (d - 0.001, *q), 0.003, "brass", 6)
    b.size = b.size._replace(width=h)


@gear("chess_table")
def chess_table(b: Builder) -> None:
    """A pedestal table whose top is a chessboard, with the pieces set up."""
    d, w, h = b.size
    wood = b.material("wood", "walnut", "mahogany", "oak", "wenge")
    z = h - 0.085
    s = min(d, w)
    with b.solid("top"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (z - 0.04, z), wood, 0.008)
        q = s * 0.8 / 8
        for i in range(8):
            for j in range(8):
                inlay(
                    b,
                    ((i - 4) * q, (i - 3) * q),
                    ((j - 4) * q, (j - 3) * q),
                    (z - 0.002, z + 0.0003),
                    "birch" if (i + j) % 2 else "wenge",
                )
        for team, sign in (("cream paint", -1), ("black paint", 1)):
            for k in range(8):
                x = (k - 3.5) * q
                tall = (0.05, 0.055, 0.065, 0.085, 0.078, 0.065, 0.055, 0.05)[k]
                r = q * 0.3
                with b.frame(x, sign * 3.5 * q, z):
                    b.lathe(
                        [
                            (r, 0),
                            (r * 0.9, 0.008),
                            (r * 0.45, 0.02),
                            (r * 0.4, tall * 0.6),
                            (r * 0.75, tall * 0.75),
                            (r * 0.5, tall),
                        ],
                        team,
                        8,
                    )
                with b.frame(x, sign * 2.5 * q, z):
                    b.lathe([(r * 0.8, 0), (r * 0.35, 0.016), (r * 0.5, 0.034), (r * 0.3, 0.04)], team, 8)
    with b.solid("foot"):
        b.lathe(
            [
                (0.05, 0.08),
                (0.045, 0.14),
                (0.075, 0.25),
                (0.04, 0.34),
                (0.04, z - 0.16),
                (0.07, z - 0.12),
                (0.08, z - 0.04),
            ],
            wood,
            20,
        )
        for k in range(4):
            with b.frame(yaw=k * math.pi / 2 + math.pi / 4):
                side(
                    b,
                    [(0.03, 0.1), (s * 0.25, 0.03), (s * 0.42, 0.0), (s * 0.44, 0.03), (s * 0.26, 0.09), (0.03, 0.2)],
                    (-0.02, 0.02),
                    wood,
                )
    b.clear((-d / 2, d / 2), (-w / 2, -0.2), (0.1, z - 0.05))
    b.clear((-d / 2, d / 2), (0.2, w / 2), (0.1, z - 0.05))


def _oval(x: float, y: float, n: int = 28) -> list[tuple[float, float]]:
    """A stadium: straight sides along y with round ends."""
    t = np.linspace(-math.pi / 2, math.pi / 2, n // 2)
    top = [(x * math.sin(-a), (y - x) + x * math.cos(a)) for a in t]
    return top + [(-px, -py) for px, py in top]


@gear("poker_table")
def poker_table(b: Builder) -> None:
    """An oval of green felt with a padded rim, chips and cards, on two pedestals."""
    d, w, h = b.size
    wood = b.material("wood", "mahogany", "walnut", "black paint")
    felt = b.material("felt", "green fabric", "red fabric", "navy fabric")
    z = h - 0.025
    x, y = d / 2, w / 2
    with b.solid("top"):
        b.extrude(_oval(x - 0.05, y - 0.05), (z - 0.06, z - 0.02), wood)
        b.extrude(_oval(x - 0.1, y - 0.1), (z - 0.025, z), felt)
        p = np.array(_oval(x - 0.06, y - 0.06))
        a = (np.arange(8) + 0.5) * math.pi / 4
        b.tube(
            np.c_[p, np.full(len(p), z - 0.004)],
            np.c_[0.06 * np.cos(a), 0.03 * np.sin(a)],
            "black leather",
            closed=True,
        )
        for k, look in enumerate(("red plastic", "blue plastic", "white plastic", "green plastic", "black plastic")):
            for j in range(4):
                px, py = (x - 0.32) * math.cos(1.57 * j + 0.5), (y - 0.35) * math.sin(1.57 * j + 0.5)
                disc(
                    b,
                    (px + 0.045 * (k % 3), py + 0.045 * (k // 3), z + 0.012 + 0.004 * k),
                    0.02,
                    0.024 + 0.008 * k,
                    look,
                    "z",
                    12,
                )
        for k in range(5):
            b.box((-0.03, 0.06), (-0.2 + 0.08 * k, -0.137 + 0.08 * k), (z, z + 0.001), "paper", 0)
            inlay(
                b,
                (0.005, 0.025),
                (-0.18 + 0.08 * k, -0.157 + 0.08 * k),
                (z, z + 0.0013),
                "red plastic" if k % 2 else "black plastic",
            )
    for s in (-1, 1):
        with b.solid(f"foot {s}"):
            c = s * (y - x * 0.75)
            b.box((-x + 0.2, x - 0.2), (c - 0.06, c + 0.06), (0, 0.08), wood, 0.012)
            with b.frame(0, c):
                b.lathe([(0.09, 0.08), (0.06, 0.16), (0.085, 0.4), (0.07, z - 0.14), (0.11, z - 0.06)], wood, 20)
