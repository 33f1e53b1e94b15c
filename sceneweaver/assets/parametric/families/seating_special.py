"""Seats of waiting rooms, cinemas, terraces and hospitals."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .seating_parts import bent, pillow, shell


@draws("waiting_bench")
def waiting_bench(b: Builder) -> None:
    """Three to five shells on a steel beam with two feet, a small table in place of one in some."""
    d, w, h = b.size
    body = b.material(
        "seats", "black leather", "grey plastic", "blue plastic", "brushed steel", "beech", "green plastic"
    )
    metal = b.material("frame", "brushed steel", "chrome", "black steel")
    count = 3 if w < 2.05 else 4 if w < 2.5 else 5
    step = w / count
    table = b.whole("table", 0, count - 1) if count > 3 and b.chance("with table", 0.4) else None
    seat, beam = 0.43, 0.33
    x0, x1 = -d / 2, d / 2
    with b.solid("beam"):
        b.box((-0.06, 0.0), (-w / 2 + 0.06, w / 2 - 0.06), (beam - 0.04, beam + 0.02), metal, bevel=0.006)
        for s in (-1, 1):
            y = s * (w / 2 - 0.5 * step)
            b.box((-0.055, -0.005), (y - 0.025, y + 0.025), (0.04, beam - 0.03), metal, bevel=0.004)
            b.hull(
                [
                    (px, y + t, z)
                    for t in (-0.025, 0.025)
                    for px, z in (
                        (x0 + 0.04, 0.0),
                        (x0 + 0.04, 0.02),
                        (-0.03, 0.06),
                        (x1 - 0.06, 0.02),
                        (x1 - 0.06, 0.0),
                    )
                ],
                metal,
            )
    padded = body.name == "black leather"
    for k in range(count):
        y = -w / 2 + (k + 0.5) * step
        half = step / 2 - 0.03
        if k == table:
            with b.solid("seats"):
                b.box(
                    (-0.2, x1 - 0.06),
                    (y - half, y + half),
                    (seat - 0.02, seat),
                    b.material("top", "beech", "white paint"),
                )
                b.box((-0.1, 0.1), (y - 0.05, y + 0.05), (beam, seat - 0.019), metal)
            continue
        with b.solid("seats"):
            b.box((-0.09, 0.06), (y - 0.1, y + 0.1), (beam + 0.01, seat - 0.055), metal, bevel=0.004)
            if padded:
                with b.frame(0.0, y, seat, pitch=-0.06):
                    b.cushion((x0 + 0.14, x1), (-half, half), (-0.075, 0.0), body, radius=0.03)
            else:
                profile = [
                    (x1, seat - 0.04),
                    (x1 - 0.05, seat),
                    (x1 - 0.2, seat - 0.012),
                    (x0 + 0.24, seat - 0.03),
                    (x0 + 0.16, seat - 0.01),
                ]
                grid = bent(profile, [half] * 5, lambda _, s: (0.0, 0.006 * s * s), 5) + (0, y, 0)
                shell(b, grid, 0.016, body, 4, 1)
                b.box((-0.1, 0.1), (y - 0.12, y + 0.12), (seat - 0.075, seat - 0.03), metal, bevel=0.004)
        with b.solid("backs"), b.frame(x0 + 0.19, y, seat - 0.02, pitch=-0.3):
            high = (h - seat + 0.02) / math.cos(0.3) - 0.01
            if padded:
                b.cushion((-0.03, 0.025), (-half, half), (0.03, high), body, radius=0.025)
            else:
                grid = bent(
                    [(0.0, 0.0), (0.02, 0.14), (0.0, 0.3), (-0.02, high)],
                    [half] * 4,
                    lambda _, s: (0.008 * s * s, 0.0),
                    5,
                )
                shell(b, grid, 0.016, body, 3, 1)
            b.box((-0.045, -0.002), (-0.03, 0.03), (-0.02, 0.2), metal, bevel=0.004)
    for k in range(count + 1):
        if b.style == "scandinavian" and 0 < k < count:
            continue
        y = -w / 2 + k * step
        y = min(max(y, -w / 2 + 0.022), w / 2 - 0.022)
        with b.solid(f"arm {k}"):
            b.tube([(-0.1, y, seat - 0.06), (-0.12, y, 0.6), (0.12, y, 0.61), (0.1, y, seat - 0.06)], 0.012, metal, 8)
            b.cushion((-0.14, 0.14), (y - 0.022, y + 0.022), (0.605, 0.63), "black plastic", radius=0.01)
            b.bar((-0.1, y, seat - 0.06), (0.1, y, seat - 0.06), 0.012, metal, 8)
            inner = min(max(y, -w / 2 + 0.08), w / 2 - 0.08)
            b.bar((-0.03, y, seat - 0.06), (-0.03, inner, beam), 0.012, metal, 8)
    b.fit()


@draws("egg_chair")
def egg_chair(b: Builder) -> None:
    """A woven egg that hangs from a bent post on a round foot, with cushions inside."""
    d, w, h = b.size
    weave = b.material("basket", "rattan", "wicker", "black steel", "white plastic")
    metal = b.material("stand", "black steel", "white steel", "brushed steel")
    cover = b.material("cushion", "beige fabric", "grey fabric", "@fabric")
    r = w / 2
    with b.solid("foot"):
        angle = np.arange(24) * 2 * np.pi / 24
        rim = np.c_[(d / 2 - 0.022) * np.cos(angle), (r - 0.022) * np.sin(angle), np.full(24, 0.022)]
        b.tube(rim, 0.022, metal, 8, closed=True)
        b.bar((-d / 2 + 0.03, 0, 0.022), (d / 2 - 0.03, 0, 0.022), 0.02, metal, 8)
        b.bar((0, -r + 0.03, 0.022), (0, r - 0.03, 0.022), 0.02, metal, 8)
    t = np.linspace(0, 1, 9)
    back = -d / 2 + 0.025
    with b.solid("post"):
        arc = [
            (back, 0, 0.03),
            (back, 0, 0.9),
            *[
                (
                    back + (0.5 * d - 0.03) * (1 - math.cos(s * math.pi / 2)) * 1.0,
                    0,
                    1.25 + (h - 1.272) * math.sin(s * math.pi / 2),
                )
                for s in t
            ],
        ]
        b.tube(arc, 0.022, metal, 10)
    with b.solid("chain"):
        b.bar((-0.005, 0, h - 0.03), (-0.005, 0, h - 0.16), 0.007, metal, 6)
    low, top = 0.24, h - 0.15
    middle, half = (low + top) / 2, (top - low) / 2

    # The egg: a wall about z, open to the front; thick enough to be seen as wicker.
    ex, ey = d / 2 - 0.075, r - 0.06
    rows = np.linspace(-0.97, 1.0, 12)
    turn = np.linspace(1.0, 2 * math.pi - 1.0, 19)
    opening = np.clip(1.0 - 0.85 * np.abs(rows) ** 2.5, 0.1, 1)
    grid = []
    for s, o in zip(rows, opening, strict=True):
        ring = max(0.06, math.sqrt(max(0.0, 1 - abs(s) ** 2.3)))
        a = math.pi + (turn - math.pi) * (math.pi - 1.0 * o) / (math.pi - 1.0)
        grid.append(
            np.c_[0.0 + ex * ring * np.cos(a) + 0.01, ey * ring * np.sin(a), np.full(len(a), middle + s * half)]
        )
    grid = np.array(grid)
    with b.solid("basket"):
        shell(b, grid[:, ::-1], 0.022, weave, 5, 6)
        # Ribs make the weave readable.
        for k in range(1, 18, 2):
            path = grid[:, k]
            centre = np.array([0.01, 0, middle])
            outward = path - centre
            outward[:, 2] = 0
            outward /= np.linalg.norm(outward, axis=1, keepdims=True) + 1e-9
            b.add(shapes.sweep(path + 0.004 * outward, 0.013, 5), weave, [])
        b.tube(grid[:, 0], 0.018, weave, 6)
        b.tube(grid[:, -1], 0.018, weave, 6)
        b.frustum(0.06, 0.06, (low - 0.005, low + 0.02), weave, segments=14)
        b.lathe([(0.3, low + 0.14), (0.37, low + 0.19), (0.37, low + 0.25), (0.33, low + 0.29)], cover, segments=24)
        with b.frame(-0.2, 0, low + 0.52, pitch=1.2):
            pillow(b, 0.5, 0.6, 0.2, cover, lift=-0.1)
        accent = b.material("pillow", "white fabric", "mustard fabric", "rust fabric", "green fabric")
        with b.frame(-0.02, 0.1, low + 0.45, pitch=1.05, yaw=0.2):
            pillow(b, 0.34, 0.4, 0.13, accent, lift=-0.06)
    b.fit()


@draws("theater_seat")
def theater_seat(b: Builder) -> None:
    """One to three padded recliners side by side with shared broad arms, cup holders and a raised back."""
    d, w, h = b.size
    cover = b.material("cover", "black leather", "brown leather", "red fabric", "charcoal fabric", "navy fabric")
    count = max(1, min(3, round((w - 0.2) / 0.7)))
    arm = 0.2
    step = (w - arm) / count
    x0, x1 = -d / 2, d / 2
    half = (step - arm) / 2
    for k in range(count):
        y = -w / 2 + arm + half + k * step
        with b.solid("seat"):
            b.box((x0 + 0.25, x1 - 0.1), (y - half - 0.03, y + half + 0.03), (0.0, 0.07), "black plastic")
            b.cushion((x0 + 0.2, x1 - 0.04), (y - half, y + half), (0.06, 0.33), cover, radius=0.03)
            with b.frame(0, y, 0.44, pitch=-0.07):
                b.cushion((x0 + 0.26, x1 - 0.01), (-half, half), (-0.13, 0.02), cover, radius=0.06)
            b.cushion((x1 - 0.09, x1), (y - half + 0.01, y + half - 0.01), (0.12, 0.4), cover, radius=0.04)
        with b.solid("back"), b.frame(x0 + 0.3, y, 0.36, pitch=-0.26):
            long = (h - 0.36) / math.cos(0.26) - 0.03
            wide = half + 0.04
            b.cushion((-0.15, -0.02), (-wide, wide), (-0.1, long - 0.03), cover, radius=0.04)
            b.cushion((-0.06, 0.09), (-half, half), (0.04, 0.36 * long), cover, radius=0.06)
            b.cushion((-0.06, 0.075), (-half - 0.01, half + 0.01), (0.35 * long, 0.7 * long), cover, radius=0.055)
            b.cushion((-0.06, 0.09), (-wide, wide), (0.69 * long, long), cover, radius=0.06)
    for k in range(count + 1):
        y = -w / 2 + arm / 2 + k * step
        with b.solid(f"arm {k}"):
            b.cushion(
                (x0 + 0.16, x1 - 0.06), (y - arm / 2 + 0.012, y + arm / 2 - 0.012), (0.02, 0.53), cover, radius=0.03
            )
            b.cushion((x0 + 0.16, x1 - 0.03), (y - arm / 2, y + arm / 2), (0.5, 0.6), cover, radius=0.045)
            with b.frame(x1 - 0.2, y):
                b.lathe([(0.05, 0.58), (0.05, 0.604), (0.046, 0.608)], "brushed steel", segments=20)
                b.frustum(0.04, 0.04, (0.6, 0.6085), "black plastic", segments=18)
            if b.chance("glow", 0.6):
                b.box(
                    (x0 + 0.3, x1 - 0.2),
                    (y - arm / 2 + 0.004, y + arm / 2 - 0.004),
                    (0.045, 0.055),
                    "lamp glow",
                    bevel=0,
                )
    b.fit()


def _hoop(b: Builder, rings: list[tuple[np.ndarray, float, str]], step: int = 2) -> None:
    """Closed rings that lie side by side, with one collision part for every ``step`` of their stretches."""
    points, drawn = [], []
    for path, radius, material in rings:
        shape = shapes.sweep(path, radius, 6, closed=True)
        points.append(shape[0].reshape(len(path), -1, 3))
        drawn.append((shape, material))
    both = np.concatenate(points, axis=1)
    count = len(both)
    hulls = [
        shapes.hull(both[[(k + i) % count for i in range(step + 1)]].reshape(-1, 3)) for k in range(0, count, step)
    ]
    for k, (shape, material) in enumerate(drawn):
        b.add(shape, material, hulls if k == 0 else [])


@draws("wheelchair")
def wheelchair(b: Builder) -> None:
    """Two large spoked wheels with push rims, castors, a cloth seat and back, arms, handles, foot plates."""
    d, w, h = b.size
    frame = b.material("frame", "black steel", "chrome", "blue paint", "red paint", "brushed steel")
    cloth = b.material("seat", "black fabric", "navy fabric", "charcoal fabric")
    x0, x1 = -d / 2, d / 2
    big, seat = 0.3, 0.5
    hub = x0 + 0.34
    track = w / 2 - 0.06
    inner = track - 0.045
    n = 24
    angle = np.arange(n) * 2 * np.pi / n
    for s in (-1, 1):
        with b.solid(f"wheel {s}"):
            y = s * track

            def ring(r: float, yy: float) -> np.ndarray:
                return np.c_[hub + r * np.cos(angle), np.full(n, yy), big + r * np.sin(angle)]

            _hoop(b, [(ring(big - 0.014, y), 0.014, "rubber"), (ring(big - 0.034, y), 0.009, "aluminium")])
            _hoop(b, [(ring(big - 0.05, s * (w / 2 - 0.008)), 0.008, "chrome")])
            with b.frame(hub, y, big, roll=math.pi / 2):
                b.frustum(0.025, 0.025, (-0.035, 0.035), "aluminium", segments=12)
            for k in range(5):
                a = k * math.pi / 5
                reach = np.array([(big - 0.034) * math.cos(a), 0.0, (big - 0.034) * math.sin(a)])
                middle = np.array([hub, y, big])
                b.bar(middle - reach, middle + reach, 0.003, "aluminium", 4)
            for a in (0.6, 2.2, 3.8, 5.4):
                at = (hub + (big - 0.045) * math.cos(a), big + (big - 0.045) * math.sin(a))
                b.bar((at[0], y, at[1]), (at[0], s * (w / 2 - 0.008), at[1]), 0.005, "aluminium", 5)
        y = s * inner
        r = 0.0115
        back = x0 + 0.17
        front = x0 + 0.6
        with b.solid(f"side {s}"):
            b.bar((back + 0.02, y, 0.2), (back, y, h - 0.015), r, frame, 8)
            b.tube([(back, y, h - 0.06), (back - 0.02, y, h - 0.015), (x0 + 0.1, y, h - 0.0125)], r, frame, 8)
            b.bar((x0 + 0.1, y, h - 0.0145), (x0, y, h - 0.0145), 0.0145, "rubber", 8)
            b.bar((back, y, seat - 0.03), (front, y, seat - 0.03), r, frame, 8)
            b.bar((back + 0.02, y, 0.21), (front, y, 0.21), r, frame, 8)
            b.tube(
                [(front, y, 0.17), (front, y, seat + 0.17), (front - 0.05, y, seat + 0.21), (back, y, seat + 0.21)],
                r,
                frame,
                8,
            )
            b.cushion(
                (back + 0.08, front - 0.05),
                (y - 0.025, y + 0.025),
                (seat + 0.215, seat + 0.245),
                "black plastic",
                radius=0.012,
            )
            b.box((back + 0.03, front - 0.02), (y - 0.002, y + 0.002), (seat - 0.02, seat + 0.17), cloth, bevel=0)
            b.bar((hub, y, big), (hub, s * track, big), 0.012, frame, 8)
            b.bar((hub, y, 0.21), (hub, y, seat - 0.03), r, frame, 8)
            # The castor in front, and the foot plate on its hanger.
            with b.frame(front + 0.0, y, 0.075, roll=math.pi / 2):
                b.frustum(0.075, 0.075, (-0.014, 0.014), "rubber", segments=18, bevel=0.006)
                b.frustum(0.045, 0.045, (-0.016, 0.016), "grey plastic", segments=14)
            for t in (-0.022, 0.022):
                b.bar((front, y + t, 0.07), (front, y + t, 0.175), 0.006, frame, 6)
            b.bar((front, y - 0.025, 0.172), (front, y + 0.025, 0.172), 0.009, frame, 6)
            foot = y - s * 0.035
            b.tube([(front, y, seat - 0.03), (front + 0.06, foot, seat - 0.05), (x1 - 0.12, foot, 0.12)], r, frame, 8)
        with b.solid("foot plates"), b.frame(x1 - 0.1, s * (inner - 0.1), 0.115, pitch=-0.12):
            b.box((-0.08, 0.095), (-0.075, 0.09 if s > 0 else 0.075), (-0.008, 0.008), "black plastic", bevel=0.004)
    with b.solid("seat"):
        b.cushion(
            (back, front + 0.01), (-inner - 0.002, inner + 0.002), (seat - 0.035, seat + 0.02), cloth, radius=0.02
        )
        for s in (-1, 1):
            b.bar((hub + 0.1, -s * inner, 0.21), (hub + 0.1, s * inner, seat - 0.035), 0.01, frame, 8)
    with b.solid("back"):
        rows = []
        for t in np.linspace(-1, 1, 7):
            rows.append([(back - 0.03 * (1 - t * t), t * inner, z) for z in (seat, seat + 0.2, h - 0.07)])
        b.sheet(np.array(rows), 0.014, cloth, cells=3)
    b.fit()
