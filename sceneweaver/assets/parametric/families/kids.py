"""Toys, and furniture for small children."""

from __future__ import annotations

import math

from ...drawing.components import open_box
from ..builder import Builder, span
from .gym_kit import disc, face, gear, inlay, post, ring, side
from .small_parts import OPEN

_GAY = (
    "red plastic",
    "blue plastic",
    "yellow plastic",
    "green plastic",
    "orange plastic",
    "mint plastic",
    "pink plastic",
)
_WOOD = ("birch", "white paint", "light oak", "pine", "sage paint")


@gear("toy_chest")
def toy_chest(b: Builder) -> None:
    """A wooden box with a lid, low feet, coloured stars and handles, or an open one."""
    d, w, h = b.size
    wood = b.material("wood", *_WOOD)
    if b.request.shape == OPEN:
        open_box(b, b.bounds, wood, 0.018, floor=0.02)
        return
    x, y = d / 2 - 0.012, w / 2 - 0.01
    for sx in (-1, 1):
        for s in (-1, 1):
            b.box(
                (sx * (x - 0.03) - 0.025, sx * (x - 0.03) + 0.025),
                (s * (y - 0.03) - 0.025, s * (y - 0.03) + 0.025),
                (0, 0.05),
                wood,
            )
    b.box((-x, x), (-y, y), (0.04, h - 0.045), wood, 0.004)
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (h - 0.04, h), b.material("lid", *_GAY, *_WOOD), 0.012)
    n = 4
    for k in range(n):
        c, z, r = -y + (k + 0.5) * 2 * y / n, h * 0.45, min(0.06, h * 0.13)
        if k % 2:
            disc(b, (x, c, z), r, 0.016, _GAY[k % 7], "x", 20)
        else:
            p = [
                (
                    c + r * (1.15 if j % 2 == 0 else 0.5) * math.sin(j * math.pi / 5),
                    z + r * (1.15 if j % 2 == 0 else 0.5) * math.cos(j * math.pi / 5),
                )
                for j in range(10)
            ]
            face(b, p[::-1], (x - 0.002, x + 0.008), _GAY[(k + 2) % 7])
    b.surface("top", (-d / 2 + 0.02, d / 2 - 0.02), (-w / 2 + 0.02, w / 2 - 0.02), h)


@gear("play_kitchen")
def play_kitchen(b: Builder) -> None:
    """A small kitchen: hob, sink with tap, oven with window, cupboard, back with shelf and hooks."""
    d, w, h = b.size
    wood = b.material("body", *_WOOD)
    front = b.material("fronts", "pink plastic", "mint plastic", "white paint", "sage paint", "sky pigment")
    x0, x1, y = -d / 2, d / 2 - 0.02, w / 2
    z = h * 0.52
    with b.solid("body"):
        b.box((x0, x1), (-y, y), (0, z - 0.02), wood, 0.004)
        b.box((x0, x1 + 0.01), (-y, y), (z - 0.025, z), "birch", 0.004)
        for s in (-1, 1):
            b.box((x1 - 0.005, x1 + 0.008), span(s * 0.01, s * (y - 0.01)), (0.04, z - 0.09), front, 0.004)
        b.box((x1, x1 + 0.012), (0.06, y - 0.06), (0.12, z - 0.19), "black glass", 0.003)
        b.bar((x1 + 0.015, 0.06, z - 0.13), (x1 + 0.015, y - 0.06, z - 0.13), 0.007, "steel", 8)
        disc(b, (x1 + 0.01, -0.04, z * 0.5), 0.015, 0.02, "steel", "x", 12)
        for k in range(4):
            disc(b, (x1 + 0.002, y * 0.25 + k * y * 0.17, z - 0.058), 0.017, 0.02, _GAY[k], "x", 12)
    with b.solid("back"):
        for px in (-0.06, 0.07):
            disc(b, (px, y * 0.5, z + 0.002), 0.055, 0.006, "black glass", "z", 20)
            ring(b, (px, y * 0.5, z + 0.004), 0.04, 0.003, "red plastic", "z", 14, 5)
        disc(b, (0.02, -y * 0.5, z + 0.002), 0.1, 0.006, "steel", "z", 24)
        disc(b, (0.02, -y * 0.5, z + 0.0025), 0.085, 0.0062, "grey plastic", "z", 24)
        b.tube(
            [(-0.1, -y * 0.5, z), (-0.1, -y * 0.5, z + 0.13), (-0.05, -y * 0.5, z + 0.16), (0.0, -y * 0.5, z + 0.12)],
            0.011,
            "chrome",
            8,
        )
        with b.frame(-0.06, y * 0.5, z + 0.004):
            b.lathe([(0.04, 0), (0.045, 0.05)], "red plastic", 16)
        b.box((x0, x0 + 0.018), (-y, y), (z - 0.01, h), wood, 0.003)
        for s in (-1, 1):
            b.box((x0, x0 + 0.14), span(s * y, s * (y - 0.018)), (z - 0.01, h), wood, 0.003)
        b.box((x0, x0 + 0.14), (-y, y), (h - 0.02, h), wood, 0.003)
        b.box((x0, x0 + 0.13), (-y, y), (h - 0.2, h - 0.185), wood, 0.002)
        for k in range(4):
            c = -y * 0.7 + k * y * 0.4
            b.bar((x0 + 0.03, c, h - 0.3), (x0 + 0.03, c, h - 0.2), 0.008, _GAY[k], 6)
            disc(b, (x0 + 0.03, c, h - 0.32), 0.028, 0.01, _GAY[k], "x", 12)


@gear("doll_house")
def doll_house(b: Builder) -> None:
    """A house with an open front: rooms, roof, windows, tiny furniture."""
    d, w, h = b.size
    wall = b.material("walls", "pink plastic", "white paint", "mint plastic", "cream paint", "sky pigment")
    roof = b.material("roof", "red paint", "teal paint", "lilac plastic", "navy paint")
    e = h * 0.66
    x, y = d / 2, w / 2 - 0.03
    b.box((-x, x), (-w / 2, w / 2), (0, 0.02), "birch", 0.003)
    b.box((-x, -x + 0.01), (-y, y), (0.02, e), wall, 0)
    for c in (-y, -0.005 + w * 0.05, y - 0.012):
        b.box((-x, x - 0.01), (c, c + 0.012), (0.02, e), wall, 0.001)
    for z in (e * 0.5, e):
        b.box((-x, x - 0.01), (-y, y), (z - 0.012, z), "birch", 0.001)
    face(b, [(-y, e), (y, e), (0, h - 0.02)], (-x, -x + 0.01), wall)
    for s in (-1, 1):
        p = (s * w / 2, e - 0.03)
        r = [p, (p[0], p[1] + 0.024), (0, h), (0, h - 0.024)]
        face(b, r if s > 0 else r[::-1], (-x, x), roof)
    b.box((-0.06, 0.0), (y * 0.45, y * 0.6), (e + 0.05, h * 0.97), "terracotta", 0.003)
    for c, z in ((-y * 0.5, e * 0.26), (y * 0.55, e * 0.26), (-y * 0.5, e * 0.76), (y * 0.55, e * 0.76)):
        inlay(b, (-x, -x + 0.0103), (c - 0.07, c + 0.07), (z - 0.05, z + 0.07), "white paint")
        inlay(b, (-x, -x + 0.01035), (c - 0.06, c + 0.06), (z - 0.04, z + 0.06), "sky pigment")
    g = e * 0.5
    b.box((-x + 0.03, -x + 0.13), (-y * 0.8, -y * 0.25), (g, g + 0.05), "blue fabric", 0.008)
    b.box((-x + 0.03, -x + 0.13), (-y * 0.8, -y * 0.7), (g, g + 0.1), "birch", 0.003)
    b.box((-x + 0.02, -x + 0.08), (y * 0.3, y * 0.7), (g, g + 0.13), "pine", 0.003)
    disc(b, (0.0, -y * 0.45, 0.075), 0.06, 0.01, "red plastic", "z", 16)
    disc(b, (0.0, -y * 0.45, 0.045), 0.01, 0.06, "birch", "z", 8)
    b.box((-x + 0.02, -x + 0.1), (y * 0.25, y * 0.85), (0.02, 0.06), "yellow plastic", 0.008)
    b.box((-x + 0.02, -x + 0.045), (y * 0.25, y * 0.85), (0.02, 0.11), "yellow plastic", 0.008)


@gear("rocking_horse")
def rocking_horse(b: Builder) -> None:
    """A wooden horse with mane, saddle and handle bar on two curved runners."""
    d, w, h = b.size
    wood = b.material("wood", "light oak", "birch", "pine", "white paint")
    hair = b.material("hair", "mahogany", "black fabric", "cream paint", "brown leather")
    n = 8
    for s in (-1, 1):
        path = [(-d / 2 + d * k / n, s * w * 0.4, 0.02 + 0.1 * (2 * k / n - 1) ** 4) for k in range(n + 1)]
        b.tube(path, 0.02, wood, 8)
        for x, e in ((d * 0.18, d * 0.3), (-d * 0.2, -d * 0.3)):
            post(b, (x, s * w * 0.2, h * 0.48), (e, s * w * 0.4, 0.05), wood, 0.045)
    for x in (-d * 0.3, d * 0.3):
        b.bar((x, -w * 0.4, 0.07), (x, w * 0.4, 0.07), 0.014, wood, 8)
    z = h * 0.52
    b.cushion((-d * 0.28, d * 0.26), (-w * 0.27, w * 0.27), (z - 0.1, z + 0.08), wood, 0.07)
    side(
        b,
        [(d * 0.1, z), (d * 0.26, z), (d * 0.33, h * 0.82), (d * 0.26, h * 0.92), (d * 0.17, h * 0.9)],
        (-0.05, 0.05),
        wood,
        0.015,
    )
    side(
        b,
        [(d * 0.22, h * 0.78), (d * 0.44, h * 0.7), (d * 0.47, h * 0.78), (d * 0.3, h * 0.95), (d * 0.2, h * 0.95)],
        (-0.055, 0.055),
        wood,
        0.015,
    )
    for s in (-1, 1):
        b.hull(
            [
                (d * 0.22 + px, s * 0.035 + py, zz)
                for px, py, zz in (
                    (-0.02, -0.012, h * 0.93),
                    (0.02, 0.012, h * 0.93),
                    (0.02, -0.012, h * 0.93),
                    (0, 0, h),
                )
            ],
            wood,
        )
        disc(b, (d * 0.32, s * 0.055, h * 0.85), 0.012, 0.004, "black plastic", "y", 12)
        b.bar((d * 0.22, 0, h * 0.76), (d * 0.22, s * w * 0.38, h * 0.76), 0.014, "red plastic", 8)
    side(
        b, [(d * 0.06, z + 0.08), (d * 0.13, z + 0.08), (d * 0.21, h * 0.97), (d * 0.15, h * 0.95)], (-0.02, 0.02), hair
    )
    b.tube([(-d * 0.26, 0, z + 0.03), (-d * 0.38, 0, z + 0.02), (-d * 0.42, 0, z - 0.16)], 0.03, hair, 8)
    b.cushion((-d * 0.16, d * 0.06), (-w * 0.29, w * 0.29), (z, z + 0.1), "red plastic", 0.04)
    b.box((-d * 0.19, -d * 0.15), (-w * 0.2, w * 0.2), (z + 0.05, z + 0.2), wood, 0.015)


@gear("play_tent", square=True)
def play_tent(b: Builder) -> None:
    """A tipi of cloth on crossed poles, open in front, with flags."""
    d, w, h = b.size
    cloth = b.material("cloth", "white fabric", "beige fabric", "grey fabric", "rose fabric", "sky pigment")
    m = h * 0.82
    c = d / 2 - 0.02
    for sx in (-1, 1):
        for s in (-1, 1):
            t = 1 - (h / m)
            b.bar((sx * c, s * c, 0.0), (sx * c * t, s * c * t, h), 0.012, "pine", 6)
    top = 0.08
    z1 = m * (1 - top)

    def wall(corners) -> None:
        b.hull([p for p in corners], cloth)

    k, q = c, c * top
    wall(
        [(-k, s * k, 0.01) for s in (-1, 1)]
        + [(-k + 0.012, s * k, 0.01) for s in (-1, 1)]
        + [(-q, s * q, z1) for s in (-1, 1)]
        + [(-q + 0.012, s * q, z1) for s in (-1, 1)]
    )
    for s in (-1, 1):
        wall(
            [(x, s * k, 0.01) for x in (-k, k)]
            + [(x, s * (k - 0.012), 0.01) for x in (-k, k)]
            + [(x, s * q, z1) for x in (-q, q)]
            + [(x, s * (q - 0.012), z1) for x in (-q, q)]
        )
        wall(
            [
                (k, s * k, 0.01),
                (k, s * k * 0.5, 0.01),
                (k - 0.012, s * k, 0.01),
                (k - 0.012, s * k * 0.5, 0.01),
                (q, s * q, z1),
                (q - 0.012, s * q, z1),
                (q, 0, z1),
                (q - 0.012, 0, z1),
            ]
        )
    b.cushion((-k * 0.85, k * 0.85), (-k * 0.85, k * 0.85), (0.0, 0.05), "grey fabric", 0.02)
    for j in range(5):
        z, y = m * 0.42, (-0.4 + 0.2 * j) * k
        x = k * (1 - z / m) + 0.004
        b.hull([(x + e, y + yy, z + zz) for e in (0, 0.003) for yy, zz in ((-0.04, 0), (0.04, 0), (0, -0.08))], _GAY[j])


@gear("slide")
def slide(b: Builder) -> None:
    """A ladder, a platform and a curved chute with raised edges; children come down to the front."""
    d, w, h = b.size
    chute = b.material("chute", *_GAY)
    frame = b.material("frame", *_GAY, "pine")
    z = h * 0.72
    px = -d / 2 + d * 0.24
    path = [(px, z), (px + d * 0.14, z * 0.93), (px + d * 0.5, z * 0.32), (d / 2 - 0.14, 0.09), (d / 2, 0.07)]
    for (xa, za), (xc, zc) in zip(path[:-1], path[1:], strict=True):
        b.hull(
            [(x, y, zz + e) for x, zz in ((xa, za), (xc, zc)) for y in (-w * 0.38, w * 0.38) for e in (-0.03, 0)], chute
        )
        for s in (-1, 1):
            b.hull(
                [
                    (x, y, zz + e)
                    for x, zz in ((xa, za), (xc, zc))
                    for y in (s * w * 0.36, s * w * 0.44)
                    for e in (-0.035, 0.09)
                ],
                chute,
            )
    for s in (-1, 1):
        y = s * w * 0.42
        post(b, (-d / 2 + 0.03, s * (w / 2 - 0.03), 0.01), (px - 0.04, y, z), frame, 0.05)
        post(b, (px + d * 0.12, s * (w / 2 - 0.03), 0.01), (px, y, z - 0.03), frame, 0.05)
        b.tube(
            [
                (px - 0.05, y, z - 0.02),
                (px - 0.06, y, h - 0.03),
                (px + 0.03, y, h - 0.018),
                (px + d * 0.12, y, z + 0.04),
            ],
            0.018,
            frame,
            8,
        )
    n = 3
    for k in range(1, n + 1):
        u = k / (n + 0.3)
        x = -d / 2 + 0.03 + u * (px - 0.04 + d / 2 - 0.03)
        b.box((x - 0.05, x + 0.05), (-w * 0.42, w * 0.42), (u * z - 0.015, u * z + 0.015), frame, 0.006)
    b.box((d / 2 - 0.3, d / 2 - 0.2), (-w * 0.42, w * 0.42), (0, 0.08), chute, 0.01)


@gear("toy_shelf")
def toy_shelf(b: Builder) -> None:
    """A low frame with three rows of tilted coloured bins."""
    d, w, h = b.size
    wood = b.material("frame", *_WOOD)
    for s in (-1, 1):
        y = s * (w / 2 - 0.01)
        side(
            b, [(-d / 2, 0), (d / 2, 0), (d / 2, h * 0.25), (-d / 2 + 0.1, h), (-d / 2, h)], (y - 0.01, y + 0.01), wood
        )
    n = 3 if w < 0.8 else 4
    cw = (w - 0.06) / n
    for k in range(3):
        z = 0.08 + k * (h - 0.16) / 3
        x1 = d / 2 - 0.03 - k * (d - 0.32) / 2.2 * 0.8
        for e in (0.06, 0.24):
            b.bar(
                (x1 - e, -w / 2 + 0.01, z + 0.02 + e * 0.25),
                (x1 - e, w / 2 - 0.01, z + 0.02 + e * 0.25),
                0.012,
                wood,
                8,
            )
        for i in range(n):
            c = -w / 2 + 0.03 + (i + 0.5) * cw
            with b.frame(x1 - 0.28, c, z + 0.095, pitch=0.24):
                t = min(0.14, (h - 0.2) / 3 - 0.06)
                look = _GAY[(i + 2 * k) % 7]
                b.hull(
                    [
                        (x, yy * cw * 0.46 * q, zz)
                        for yy in (-1, 1)
                        for x, q, zz in ((0.02, 0.85, 0), (0.26, 0.85, 0), (0, 1, t), (0.28, 1, t * 0.75))
                    ],
                    look,
                )
                for j in range(3):
                    b.ball(
                        (0.035, 0.035, 0.035),
                        (0.07 + 0.06 * j, cw * 0.2 * (j - 1), t * 0.85),
                        _GAY[(i + k + j + 3) % 7],
                        8,
                    )


@gear("easel")
def easel(b: Builder) -> None:
    """A child's A-frame easel with a drawing on it and a tray of paints."""
    d, w, h = b.size
    wood = b.material("wood", "pine", "birch", "light oak", "white paint")
    a = math.atan2(d / 2 - 0.03, h)
    for s in (-1, 1):
        for e in (-1, 1):
            post(
                b, (e * (d / 2 - 0.02), s * (w / 2 - 0.02), 0.01), (e * 0.015, s * (w / 2 - 0.02), h - 0.01), wood, 0.03
            )
    z = h * 0.42
    for e, look in ((1, "white plastic"), (-1, "forest pigment")):
        x = e * (d / 2 - 0.02) * (1 - z / h) + e * 0.01
        with b.frame(x, 0, z, pitch=-a * e):
            t = (h - z) * 0.95
            b.box((-0.006, 0.006), (-w / 2 + 0.035, w / 2 - 0.035), (0, t), look, 0.002)
            if e > 0:
                b.box((0.005, 0.008), (-w * 0.36, w * 0.36), (0.04, t - 0.04), "paper", 0)
                disc(b, (0.008, w * 0.2, t * 0.72), 0.05, 0.002, "yellow petal", "x", 16)
                inlay(b, (0.006, 0.0083), (-w * 0.34, w * 0.34), (0.05, t * 0.25), "green plastic")
                b.box((0.006, 0.009), (-w * 0.2, w * 0.02), (t * 0.25, t * 0.5), "red plastic", 0)
                b.hull(
                    [
                        (0.0075 + q, yy, zz)
                        for q in (0, 0.0015)
                        for yy, zz in ((-w * 0.25, t * 0.5), (w * 0.07, t * 0.5), (-w * 0.09, t * 0.68))
                    ],
                    "blue plastic",
                )
    b.box((-d * 0.25, d * 0.42), (-w / 2 + 0.03, w / 2 - 0.03), (z - 0.05, z - 0.03), wood, 0.003)
    for k in range(5):
        disc(b, (d * 0.33, -w * 0.3 + k * w * 0.15, z), 0.027, 0.06, _GAY[k], "z", 12)


@gear("activity_table")
def activity_table(b: Builder) -> None:
    """A small round-legged table with blocks, an arch of wire with beads and gears."""
    d, w, h = b.size
    wood = b.material("wood", *_WOOD)
    z = h - 0.2
    with b.solid("table"):
        b.box((-d / 2, d / 2), (-w / 2, w / 2), (z - 0.03, z), wood, 0.008)
        for sx in (-1, 1):
            for s in (-1, 1):
                with b.frame(sx * (d / 2 - 0.05), s * (w / 2 - 0.05)):
                    b.frustum(0.02, 0.03, (0, z - 0.03), _GAY[(sx + s) % 7], 14)
    with b.solid("toys"):
        for k, y in enumerate((-0.06, 0.06)):
            path = [
                (
                    -d * 0.3 + d * 0.6 * j / 8,
                    y,
                    z + 0.16 * math.sin(math.pi * j / 8) + 0.02 * math.sin(j * 2.2 + k) * (0 < j < 8) + 0.005,
                )
                for j in range(9)
            ]
            b.tube(path, 0.004, _GAY[k + 3], 6)
            for j in (2, 3, 5, 6):
                b.ball((0.02, 0.02, 0.02), path[j], _GAY[(j + k) % 7], 8)
        disc(b, (0, w * 0.3, z + 0.01), 0.07, 0.02, "red plastic", "z", 12)
        disc(b, (0.1, w * 0.36, z + 0.01), 0.045, 0.02, "blue plastic", "z", 10)
        for k in range(4):
            c = -w * 0.34 + 0.055 * (k % 2)
            b.box((-0.08 + 0.06 * (k // 2), -0.03 + 0.06 * (k // 2)), (c, c + 0.05), (z, z + 0.05), _GAY[k], 0.004)
        b.box((-0.05, 0.0), (-w * 0.32, -w * 0.32 + 0.05), (z + 0.05, h), "green plastic", 0.004)


@gear("play_mat")
def play_mat(b: Builder) -> None:
    """Puzzle tiles of foam in bright colours."""
    d, w, h = b.size
    n, m = max(2, round(d / 0.33)), max(2, round(w / 0.33))
    looks = b.pick(
        "set",
        [
            ("red plastic", "yellow plastic", "blue plastic", "green plastic"),
            ("mint plastic", "white plastic", "grey plastic", "pink plastic"),
        ],
    )
    b.material("tiles", looks[0])
    for i in range(n):
        for j in range(m):
            x, y = -d / 2 + i * d / n, -w / 2 + j * w / m
            b.box((x, x + d / n - 0.001), (y, y + w / m - 0.001), (0, h), looks[(i + 2 * j) % 4], 0.002)


@gear("ball_pit", square=True)
def ball_pit(b: Builder) -> None:
    """A padded round pool full of bright balls."""
    d, w, h = b.size
    cloth = b.material("rim", "grey fabric", "beige fabric", "rose fabric", "blue fabric")
    r = d / 2
    ring(b, (0, 0, h / 2), r - 0.045, 0.04, cloth, "z", 20, 6)
    b.frustum(r, r, (0, h * 0.97), cloth, 28, 0.02)
    z = h * 0.97
    q = 0.038
    k = 0
    for ringn, count in ((0.12, 4), (0.3, 10), (0.5, 15), (0.7, 20), (0.87, 24)):
        for j in range(count):
            a = j * 2 * math.pi / count + ringn * 7
            b.ball(
                (q, q, q),
                (r * ringn * 0.97 * math.cos(a), r * ringn * 0.97 * math.sin(a), z),
                _GAY[(k * 5 + j * 3) % 7],
                6,
            )
            k += 1


@gear("teddy_bear")
def teddy_bear(b: Builder) -> None:
    """A big plush bear that sits, with a bow."""
    d, w, h = b.size
    fur = b.material("fur", "brown leather", "tan leather", "beige fabric", "white fabric", "grey fabric")
    pale = "white fabric" if fur.name != "white fabric" else "beige fabric"
    b.ball((w * 0.3, w * 0.32, h * 0.3), (-d * 0.1, 0, h * 0.3), fur, 14)
    b.ball((w * 0.25, w * 0.27, h * 0.21), (-d * 0.06, 0, h * 0.74), fur, 14)
    b.ball((w * 0.1, w * 0.2, h * 0.2), (-d * 0.1 + w * 0.22, 0, h * 0.3), pale, 12)
    b.ball((w * 0.12, w * 0.12, h * 0.075), (w * 0.2 - d * 0.06, 0, h * 0.69), pale, 12)
    b.ball((0.025, 0.035, 0.02), (w * 0.31 - d * 0.06, 0, h * 0.72), "black plastic", 8)
    for s in (-1, 1):
        b.ball((0.018, 0.02, 0.02), (w * 0.21 - d * 0.06, s * w * 0.1, h * 0.79), "black plastic", 8)
        b.ball((w * 0.05, w * 0.1, h * 0.075), (-d * 0.06, s * w * 0.21, h * 0.92), fur, 12)
        b.ball((w * 0.26, w * 0.11, h * 0.1), (d * 0.18, s * w * 0.27, h * 0.1), fur, 12)
        b.ball((w * 0.06, w * 0.1, h * 0.1), (d * 0.18 + w * 0.23, s * w * 0.27, h * 0.11), pale, 12)
        with b.frame(0.0, s * w * 0.34, h * 0.42, pitch=0.7):
            b.ball((w * 0.22, w * 0.09, h * 0.085), (w * 0.1, 0, 0), fur, 12)
        b.hull(
            [
                (w * 0.22 - d * 0.1 + e, s * q, h * 0.53 + zz)
                for e in (0, 0.03)
                for q, zz in ((0, 0), (0.09, 0.04), (0.09, -0.04))
            ],
            b.material("bow", "red plastic", "blue plastic"),
        )


@gear("kids_car")
def kids_car(b: Builder) -> None:
    """A ride-on car: body, bonnet, wheels, steering wheel, seat, headlights."""
    d, w, h = b.size
    paint = b.material("body", *_GAY)
    z = h * 0.55
    b.box((-d / 2, d / 2), (-w * 0.42, w * 0.42), (0.09, z * 0.8), paint, 0.04)
    b.box((d * 0.12, d * 0.46), (-w * 0.38, w * 0.38), (z * 0.6, z), paint, 0.04)
    b.box((-d * 0.46, -d * 0.2), (-w * 0.38, w * 0.38), (z * 0.6, h * 0.72), paint, 0.04)
    b.box((-d * 0.22, d * 0.06), (-w * 0.26, w * 0.26), (z * 0.7, z * 0.84), "black plastic", 0.02)
    for x in (-d * 0.3, d * 0.3):
        for s in (-1, 1):
            disc(b, (x, s * (w / 2 - 0.04), 0.105), 0.105, 0.08, "rubber", "y", 20, 0.012)
            disc(b, (x, s * (w / 2 - 0.04), 0.105), 0.055, 0.082, "white plastic", "y", 16)
    b.bar((d * 0.14, 0, z * 0.9), (d * 0.06, 0, h - 0.07), 0.014, "black plastic", 8)
    with b.frame(d * 0.05, 0, h - 0.075, pitch=-0.6):
        ring(b, (0, 0, 0), 0.1, 0.014, "black plastic", "z", 16, 6)
        b.box((-0.1, 0.1), (-0.014, 0.014), (-0.008, 0.008), "black plastic", 0.003)
    for s in (-1, 1):
        disc(b, (d * 0.46, s * w * 0.25, z * 0.78), 0.04, 0.03, "lamp glow", "x", 16)
        inlay(
            b,
            (-d / 2 - 0.0003, -d * 0.4),
            (s * w * 0.25 - 0.03, s * w * 0.25 + 0.03),
            (z * 0.55, z * 0.61),
            "red petal",
        )
    b.box((d * 0.45, d / 2 + 0.004), (-w * 0.2, w * 0.2), (0.16, 0.24), "black plastic", 0.006)
