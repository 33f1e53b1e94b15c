"""Musical instruments and what plays music."""

from __future__ import annotations

import math

import numpy as np

from ..builder import Builder, span
from .gym_kit import Look, disc, face, gear, inlay, side


def keyboard(b: Builder, x: tuple[float, float], y: tuple[float, float], z: float, whites: int = 36) -> None:
    """White keys with dark gaps and black keys upon them; the white ones end at x[1]."""
    b.box(x, y, (z - 0.02, z), "white plastic", 0.0)
    step = (y[1] - y[0]) / whites
    for k in range(1, whites):
        inlay(
            b,
            (x[0], x[1] + 0.0003),
            (y[0] + k * step - 0.0006, y[0] + k * step + 0.0006),
            (z - 0.01, z + 0.0003),
            "black plastic",
        )
    m = x[0] + 0.36 * (x[1] - x[0])
    for k in range(1, whites):
        if k % 7 in (0, 3):
            continue
        c = y[0] + k * step
        b.box((x[0], m + 0.02), (c - step * 0.27, c + step * 0.27), (z - 0.001, z + 0.01), "black plastic", 0.0)


def _pedals(b: Builder, x: float, z: float = 0.03) -> None:
    for k in (-1, 0, 1):
        b.box((x - 0.06, x + 0.06), (k * 0.07 - 0.012, k * 0.07 + 0.012), (z, z + 0.012), "brass", 0.005)


@gear("upright_piano")
def upright_piano(b: Builder) -> None:
    """A tall case with a key bed on consoles, fall, music desk, pedals."""
    d, w, h = b.size
    wood = b.material("case", "black paint", "mahogany", "walnut", "white paint", "wenge", "cherry")
    x0, x1 = -d / 2, d / 2
    body = x0 + d * 0.58
    key = 0.72 if h > 1.05 else h * 0.67
    with b.solid("body"):
        b.box((x0, body), (-w / 2 + 0.03, w / 2 - 0.03), (0.06, h - 0.025), wood, 0.004)
        for s in (-1, 1):
            ys = (w / 2 - 0.03, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.03)
            b.box((x0, body + 0.01), ys, (0, h - 0.025), wood, 0.004)
        b.box((x0, body + 0.03), (-w / 2, w / 2), (h - 0.028, h), wood, 0.008)
        b.box((body - 0.01, body + 0.006), (-w / 2 + 0.12, w / 2 - 0.12), (0.16, key - 0.16), wood, 0.006)
        b.box((body - 0.01, body + 0.006), (-w / 2 + 0.08, w / 2 - 0.08), (key + 0.14, h - 0.06), wood, 0.006)
        with b.frame(body + 0.005, 0, key + 0.1, pitch=-0.2):
            b.box((0, 0.014), (-w * 0.26, w * 0.26), (0.02, 0.24), wood, 0.004)
        b.surface("top", (x0 + 0.01, body + 0.02), (-w / 2 + 0.01, w / 2 - 0.01), h)
    with b.solid("keys"):
        b.box((body, x1), (-w / 2, w / 2), (key - 0.09, key - 0.02), wood, 0.006)
        for s in (-1, 1):
            ys = (w / 2 - 0.06, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.06)
            side(
                b,
                [(body, key - 0.03), (x1, key - 0.03), (x1, key + 0.01), (x1 - 0.05, key + 0.05), (body, key + 0.1)],
                ys,
                wood,
                0.004,
            )
        keyboard(b, (body + 0.05, x1 - 0.03), (-w / 2 + 0.065, w / 2 - 0.065), key + 0.012, 52)
        b.box((body - 0.005, body + 0.05), (-w / 2 + 0.055, w / 2 - 0.055), (key - 0.03, key + 0.1), wood, 0.006)
        inlay(b, (body + 0.04, body + 0.0503), (-0.09, 0.09), (key + 0.055, key + 0.068), "brass")
    for s in (-1, 1):
        y = s * (w / 2 - 0.035)
        with b.solid(f"leg {s}"):
            with b.frame(x1 - 0.07, y):
                b.lathe(
                    [(0.03, 0.06), (0.022, 0.1), (0.034, key * 0.5), (0.026, key - 0.12), (0.04, key - 0.09)], wood, 16
                )
            b.box((body - 0.05, x1 - 0.01), (y - 0.035, y + 0.035), (0, 0.07), wood, 0.006)
    with b.solid("body"):
        _pedals(b, body + 0.04, 0.05)
        b.box((body - 0.01, body + 0.002), (-0.14, 0.14), (0.04, 0.12), "brass", 0.004)
    b.clear((body + 0.12, x1), (-w / 2 + 0.1, w / 2 - 0.1), (0.0, key - 0.1))


@gear("digital_piano")
def digital_piano(b: Builder) -> None:
    """A flat keyboard case on two side panels with a back board, music rest, pedals."""
    d, w, h = b.size
    wood = b.material("case", "black paint", "white paint", "walnut", "light oak", "wenge")
    x0, x1 = -d / 2, d / 2
    rest = 0.16
    top = h - rest
    with b.solid("case"):
        b.box((x0, x1), (-w / 2, w / 2), (top - 0.13, top - 0.045), wood, 0.008)
        b.box((x0, x0 + d * 0.5), (-w / 2, w / 2), (top - 0.06, top), wood, 0.008)
        for s in (-1, 1):
            ys = (w / 2 - 0.045, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.045)
            side(b, [(x0 + d * 0.4, top - 0.08), (x1, top - 0.08), (x1, top - 0.04), (x0 + d * 0.5, top)], ys, wood)
        keyboard(b, (x0 + d * 0.5, x1 - 0.02), (-w / 2 + 0.05, w / 2 - 0.05), top - 0.028, 52)
        for k in range(9):
            y = -0.28 + k * 0.07
            inlay(
                b,
                (x0 + d * 0.3, x0 + d * 0.34),
                (y - 0.014, y + 0.014),
                (top - 0.01, top + 0.0003),
                "red plastic" if k == 0 else "grey plastic",
            )
        with b.frame(x0 + 0.09, 0, top - 0.005, pitch=-0.3):
            b.box((-0.006, 0.006), (-w * 0.26, w * 0.26), (0, rest / math.cos(0.3)), wood, 0.004)
    for s in (-1, 1):
        y = s * (w / 2 - 0.03)
        with b.solid(f"leg {s}"):
            b.box((x0 + 0.02, x0 + d * 0.55), (y - 0.018, y + 0.018), (0.04, top - 0.12), wood, 0.004)
            b.box((x0, x1 - 0.03), (y - 0.03, y + 0.03), (0, 0.05), wood, 0.006)
    with b.solid("back"):
        b.box((x0 + 0.03, x0 + 0.05), (-w / 2 + 0.03, w / 2 - 0.03), (0.2, top - 0.25), wood, 0.003)
        b.box((x0 + 0.06, x0 + 0.16), (-w / 2 + 0.03, w / 2 - 0.03), (0.06, 0.12), wood, 0.004)
        _pedals(b, x0 + 0.2, 0.075)
    b.clear((x0 + 0.26, x1), (-w / 2 + 0.08, w / 2 - 0.08), (0.0, top - 0.14))


@gear("grand_piano")
def grand_piano(b: Builder) -> None:
    """The curved case on three legs with its lid up, golden plate and strings inside; the player is in front."""
    d, w, h = b.size
    wood = b.material("case", "black paint", "black paint", "mahogany", "white paint", "walnut")
    x0, x1, y = -d / 2, d / 2, w / 2
    key = 0.7
    rim = 1.0
    # Seen from above: straight side at -y (bass is at the player's left, who looks toward -x: that is -y).
    t = np.linspace(0, 1, 10)
    sway = [
        (x1 - 0.42 - float(s) * (d - 0.62), y - 0.62 * w * float(0.5 - 0.5 * math.cos(math.pi * s)) * 0.85) for s in t
    ]
    tail = [(x0 + 0.06, -y * 0.28), (x0, -y * 0.42), (x0, -y * 0.72), (x0 + 0.05, -y * 0.93), (x0 + 0.16, -y)]
    outline = [(x1 - 0.42, -y), (x1 - 0.42, y), *sway[1:], *tail]
    with b.solid("case"):
        b.extrude(outline, (key - 0.06, rim - 0.1), wood)
        inner = [((px - x0 - d / 2) * 0.95 - 0.012, (py) * 0.94 - 0.004) for px, py in outline]
        b.extrude([(px + 0.0, py) for px, py in inner], (rim - 0.1, rim - 0.085), "brass")
        _rim(b, outline, (rim - 0.11, rim), wood)
        for k in range(24):
            yy = -y * 0.86 + k * w * 0.86 / 24
            ends = x1 - 0.5
            reach = float(np.interp(yy, [q for _, q in sway[::-1]], [p for p, _ in sway[::-1]])) + 0.14
            inlay(b, (reach, ends), (yy - 0.001, yy + 0.001), (rim - 0.09, rim - 0.0847), "steel")
    with b.solid("keys"):
        b.box((x1 - 0.43, x1), (-y, y), (key - 0.06, key - 0.005), wood, 0.006)
        for s in (-1, 1):
            ys = (y - 0.09, y) if s > 0 else (-y, -y + 0.09)
            b.box((x1 - 0.43, x1 - 0.02), ys, (key - 0.02, key + 0.09), wood, 0.015)
            b.box((x1 - 0.43, x1 - 0.3), ys, (key + 0.06, rim), wood, 0.015)
        b.box((x1 - 0.42, x1 - 0.19), (-y + 0.08, y - 0.08), (key - 0.01, key + 0.1), wood, 0.006)
        keyboard(b, (x1 - 0.2, x1 - 0.035), (-y + 0.095, y - 0.095), key + 0.03, 52)
        inlay(b, (x1 - 0.2, x1 - 0.1897), (-0.12, 0.12), (key + 0.06, key + 0.08), "brass")
        with b.frame(x1 - 0.42, 0, rim - 0.1, pitch=-0.35):
            b.box((0, 0.012), (-0.36, 0.36), (0.0, 0.28), wood, 0.006)
    with b.solid("lid"):
        # Hinged on the straight bass side, propped open at the treble side.
        angle = math.asin(min(0.62, (h - rim - 0.02) / (w * 0.98)))
        with b.frame(0, -y, rim, roll=angle):
            b.extrude([(px, (py + y)) for px, py in outline], (0.0, 0.018), wood)
        reach = y - w * 0.25
        b.bar(
            (x1 - 0.6, reach, rim - 0.08),
            (x1 - 0.6, -y + (reach + y) * 0.98, rim + math.tan(angle) * (reach + y) * 0.98),
            0.009,
            wood,
            8,
        )
    for k, (px, py) in enumerate([(x1 - 0.32, -y + 0.14), (x1 - 0.32, y - 0.14), (x0 + 0.34, -y * 0.5)]):
        with b.solid(f"leg {k}"), b.frame(px, py):
            b.lathe([(0.035, 0.05), (0.05, 0.12), (0.045, 0.3), (0.075, key - 0.12), (0.09, key - 0.06)], wood, 8)
            disc(b, (0, 0, 0.03), 0.03, 0.03, "brass", segments=16)
    with b.solid("lyre"):
        for s in (-1, 1):
            b.bar((x1 - 0.45, s * 0.09, key - 0.06), (x1 - 0.45, s * 0.06, 0.12), 0.014, wood, 8)
        b.box((x1 - 0.52, x1 - 0.38), (-0.13, 0.13), (0.07, 0.13), wood, 0.008)
        _pedals(b, x1 - 0.36, 0.085)


def _rim(b: Builder, outline, z: tuple[float, float], wood: Look) -> None:
    """A wall along the outline, inside it."""
    p = np.array(outline)
    n = len(p)
    for k in range(n):
        a, c = p[k], p[(k + 1) % n]
        u = (c - a) / max(1e-9, float(np.linalg.norm(c - a)))
        inward = np.array([-u[1], u[0]]) * 0.035
        corners = [a, c, c + inward, a + inward]
        b.hull([(q[0], q[1], zz) for q in corners for zz in z], wood)


@gear("guitar_on_stand")
def guitar_on_stand(b: Builder) -> None:
    """An acoustic or electric guitar leaning in a tripod stand."""
    d, w, h = b.size
    electric = b.chance("electric", 0.4)
    if electric:
        top = b.material("body", "red paint", "blue paint", "black paint", "cream paint", "yellow paint")
    else:
        top = b.material("body", "oak", "light oak", "cherry", "walnut", "black paint")
    sides_ = b.material("sides", "mahogany", "walnut") if not electric else top
    lean = 0.16
    with b.frame(d * 0.12, 0, 0.13, pitch=-lean):
        long = (h - 0.13) / math.cos(lean)
        bl = long * 0.48
        t = 0.05 if electric else 0.1
        half = w / 2
        prof = [
            (0.0, 0.45),
            (0.03, 0.75),
            (0.1, 0.95),
            (0.22, 1.0),
            (0.34, 0.95),
            (0.46, 0.76),
            (0.56, 0.62),
            (0.66, 0.62),
            (0.78, 0.72),
            (0.88, 0.74),
            (0.95, 0.66),
            (1.0, 0.35),
        ]
        right = [(half * r, bl * z) for z, r in prof]
        outline = right + [(-y, z) for y, z in reversed(right)]
        face(b, outline, (-t, 0), sides_)
        face(b, [(y * 0.985, z * 0.985 + bl * 0.007) for y, z in outline], (-0.004, 0.002), top)
        if electric:
            for z in (0.35, 0.5, 0.65):
                b.box((0, 0.009), (-0.04, 0.04), (bl * z - 0.01, bl * z + 0.01), "black plastic", 0.002)
            for z in (0.18, 0.26):
                disc(b, (0.006, half * 0.55, bl * z), 0.014, 0.014, "chrome", "x", 12)
        else:
            disc(b, (0.0018, 0, bl * 0.64), half * 0.29, 0.003, "walnut", "x", 24)
            disc(b, (0.002, 0, bl * 0.64), half * 0.25, 0.0032, "black plastic", "x", 24)
            b.box((0, 0.008), (-half * 0.4, half * 0.4), (bl * 0.24, bl * 0.275), "wenge", 0.002)
            face(
                b,
                [(half * 0.28, bl * 0.42), (half * 0.6, bl * 0.44), (half * 0.5, bl * 0.62), (half * 0.25, bl * 0.55)],
                (0.0005, 0.0023),
                "black plastic",
            )
        b.box((-0.02, 0.0), (-0.028, 0.028), (bl - 0.06, long * 0.86), "mahogany", 0.004)
        b.box((0.0, 0.008), (-0.026, 0.026), (bl * 0.74, long * 0.86), "wenge", 0.0)
        for k in range(1, 12):
            z = long * 0.86 - (long * 0.86 - bl * 0.78) * (1 - 0.9**k) / (1 - 0.9**12)
            inlay(b, (0.007, 0.0083), (-0.026, 0.026), (z - 0.001, z + 0.001), "brass")
        face(b, [(-0.028, long * 0.86), (0.028, long * 0.86), (0.038, long), (-0.038, long)], (-0.018, 0.0), sides_)
        for k in range(3):
            for s in (-1, 1):
                z = long * (0.89 + 0.036 * k)
                b.bar((-0.01, s * 0.03, z), (-0.01, s * 0.052, z), 0.006, "chrome", 8)
        for k in range(6):
            y = -0.018 + 0.0072 * k
            b.bar((0.01, y, bl * 0.26), (0.0095, y, long * 0.87), 0.0009, "brass", 4)
    x = -d * 0.28
    b.bar((x * 0.3, 0, 0.1), (x * 0.55, 0, h * 0.62), 0.011, "black steel")
    b.tube([(x * 0.55, 0, h * 0.61), (x * 0.2, -0.05, h * 0.62), (x * 0.2 + 0.07, -0.05, h * 0.62)], 0.009, "rubber", 8)
    b.tube([(x * 0.55, 0, h * 0.61), (x * 0.2, 0.05, h * 0.62), (x * 0.2 + 0.07, 0.05, h * 0.62)], 0.009, "rubber", 8)
    b.bar((x * 0.32, 0, 0.12), (-d / 2, 0, 0.01), 0.01, "black steel")
    for s in (-1, 1):
        b.bar((x * 0.32, 0, 0.12), (d * 0.42, s * w * 0.42, 0.01), 0.01, "black steel")
        b.tube(
            [
                (x * 0.32, 0, 0.13),
                (d * 0.12 - 0.06, s * 0.09, 0.12),
                (d * 0.12 + 0.03, s * 0.09, 0.115),
                (d * 0.12 + 0.04, s * 0.09, 0.15),
            ],
            0.009,
            "rubber",
            8,
        )


@gear("cello")
def cello(b: Builder) -> None:
    """A cello in its stand."""
    d, w, h = b.size
    wood = b.material("body", "cherry", "mahogany", "oak")
    with b.frame(0.05, 0, 0.14, pitch=-0.12):
        long = (h - 0.14) / math.cos(0.12)
        bl = long * 0.62
        half = w / 2
        prof = [
            (0, 0.4),
            (0.05, 0.8),
            (0.16, 1.0),
            (0.3, 0.94),
            (0.38, 0.82),
            (0.42, 0.62),
            (0.5, 0.52),
            (0.58, 0.55),
            (0.63, 0.7),
            (0.72, 0.78),
            (0.86, 0.74),
            (0.95, 0.5),
            (1, 0.2),
        ]
        right = [(half * r, bl * z) for z, r in prof]
        outline = right + [(-y, z) for y, z in reversed(right)]
        face(b, outline, (-0.13, 0), wood)
        face(b, [(y * 0.9, z * 0.96 + bl * 0.02) for y, z in outline], (-0.01, 0.012), wood)
        for s in (-1, 1):
            inlay(
                b,
                (0.005, 0.0123),
                (s * half * 0.42 - 0.004, s * half * 0.42 + 0.004),
                (bl * 0.38, bl * 0.54),
                "black plastic",
            )
        b.box((0.01, 0.06), (-0.045, 0.045), (bl * 0.45, bl * 0.46), "light oak", 0.002)
        b.hull(
            [
                (x, y, z)
                for x, y, z in (
                    (0.012, -0.025, bl * 0.12),
                    (0.012, 0.025, bl * 0.12),
                    (0.05, -0.035, bl * 0.36),
                    (0.05, 0.035, bl * 0.36),
                    (0.03, 0.0, bl * 0.1),
                    (0.03, 0.02, bl * 0.36),
                )
            ],
            "wenge",
        )
        b.hull(
            [
                (x, y * (0.02 if z > 1 else 0.03), zz)
                for x, z, zz in (
                    (0.055, 0, bl * 0.6),
                    (0.04, 0, bl * 0.6),
                    (0.02, 2, long * 0.9),
                    (0.005, 2, long * 0.9),
                )
                for y in (-1, 1)
            ],
            "wenge",
        )
        b.box((-0.02, 0.01), (-0.018, 0.018), (bl - 0.03, long * 0.93), wood, 0.004)
        disc(b, (-0.02, 0, long - 0.04), 0.04, 0.04, wood, "y", 16)
        b.box((-0.035, 0.0), (-0.016, 0.016), (long * 0.92, long - 0.03), wood, 0.004)
        for k in range(4):
            s = -1 if k % 2 else 1
            b.bar(
                (-0.01, s * 0.01, long * (0.91 + 0.015 * k)),
                (-0.01, s * 0.07, long * (0.91 + 0.015 * k)),
                0.006,
                "wenge",
                8,
            )
            y = -0.015 + 0.01 * k
            b.bar((0.05, y * 1.2, bl * 0.36), (0.061, y, bl * 0.455), 0.001, "steel", 4)
            b.bar((0.061, y, bl * 0.455), (0.02, y * 0.7, long * 0.91), 0.001, "steel", 4)
        b.bar((-0.06, 0, 0.01), (-0.06, 0, -0.1), 0.006, "steel", 8)
    b.bar((-d * 0.25, 0, 0.05), (-d * 0.32, 0, h * 0.4), 0.014, "black steel")
    for s in (-1, 1):
        b.bar((-d * 0.25, 0, 0.06), (d / 2, s * w * 0.45, 0.012), 0.012, "black steel")
        b.bar((-d * 0.3, 0, h * 0.38), (-0.02, s * w * 0.32, h * 0.38), 0.01, "rubber")
        b.bar((d * 0.05, s * 0.11, 0.05), (d * 0.05, s * 0.11, 0.18), 0.012, "rubber")
        b.bar((-d * 0.25, 0, 0.09), (d * 0.07, s * 0.12, 0.09), 0.012, "black steel")
    b.bar((-d * 0.25, 0, 0.06), (-d / 2, 0, 0.012), 0.012, "black steel")


def _drum(b: Builder, at, r: float, t: float, shell: Look, axis: str = "z") -> None:
    """A drum with white heads, chrome hoops and lugs."""
    turn = {"z": {}, "x": {"pitch": math.pi / 2}}[axis]
    with b.frame(at[0], at[1], at[2], **turn):
        b.frustum(r, r, (-t / 2, t / 2), shell, 28)
        for s in (-1, 1):
            b.frustum(r + 0.008, r + 0.008, span(s * t / 2, s * (t / 2 - 0.022)), "chrome", 28)
            b.frustum(r * 0.96, r * 0.96, span(s * (t / 2 - 0.004), s * (t / 2 + 0.0004)), "white plastic", 28)
        for k in range(8):
            a = (k + 0.5) * math.pi / 4
            c, s = math.cos(a), math.sin(a)
            with b.frame(c * (r + 0.002), s * (r + 0.002), 0, yaw=a):
                b.box((-0.006, 0.008), (-0.01, 0.01), (-t * 0.25, t * 0.25), "chrome", 0.0)


def _cymbal(b: Builder, x: float, y: float, z: float, r: float, tilt: float) -> None:
    with b.frame(x, y, z, pitch=tilt):
        b.lathe([(r, 0), (r * 0.25, 0.014), (r * 0.16, 0.028), (0.01, 0.034)], "brass", 28)


def _stand(b: Builder, x: float, y: float, top: float, spread: float = 0.22) -> None:
    b.bar((x, y, 0.2), (x, y, top), 0.012, "chrome", 8)
    for k in range(3):
        a = k * 2 * math.pi / 3 + 0.4
        b.bar((x, y, 0.3), (x + spread * math.cos(a), y + spread * math.sin(a), 0.012), 0.01, "chrome", 8)


@gear("drum_kit")
def drum_kit(b: Builder) -> None:
    """Bass drum in front, toms on it, snare, floor tom, hi-hat, two cymbals, the drummer's stool behind."""
    d, w, h = b.size
    shell = b.material("shells", "red plastic", "black plastic", "blue plastic", "mahogany", "oak", "white plastic")
    x1 = d / 2
    r = 0.28
    with b.solid("bass"):
        _drum(b, (x1 - 0.25, 0, r + 0.008), r, 0.44, shell, "x")
        for s in (-1, 1):
            b.bar((x1 - 0.12, s * 0.25, 0.25), (x1 - 0.03, s * 0.42, 0.012), 0.01, "chrome", 8)
        b.box((x1 - 0.78, x1 - 0.47), (-0.05, 0.05), (0.0, 0.025), "steel", 0.004)
        b.bar((x1 - 0.5, 0, 0.02), (x1 - 0.49, 0, 0.25), 0.01, "steel", 8)
    with b.solid("toms"):
        for s, rr in ((-1, 0.16), (1, 0.14)):
            with b.frame(x1 - 0.36, s * 0.2, 0.78, pitch=-0.25, roll=0):
                _drum(b, (0, 0, 0), rr, 0.22, shell)
            b.bar((x1 - 0.22, s * 0.05, 0.5), (x1 - 0.25, s * 0.12, 0.74), 0.013, "chrome", 8)
    with b.solid("snare"):
        _drum(b, (x1 - 0.85, 0.32, 0.6), 0.18, 0.15, "chrome")
        _stand(b, x1 - 0.85, 0.32, 0.53, 0.2)
    with b.solid("floor tom"):
        y = -w / 2 + 0.35
        _drum(b, (x1 - 0.75, y, 0.42), 0.2, 0.38, shell)
        for k in range(3):
            a = k * 2 * math.pi / 3
            px, py = x1 - 0.75 + 0.222 * math.cos(a), y + 0.222 * math.sin(a)
            b.bar((px, py, 0.0), (px, py, 0.5), 0.009, "chrome", 8)
    with b.solid("hi-hat"):
        y = w / 2 - 0.3
        _stand(b, x1 - 0.62, y, 0.95, 0.2)
        _cymbal(b, x1 - 0.62, y, 0.86, 0.18, 0)
        with b.frame(x1 - 0.62, y, 0.855, pitch=math.pi):
            b.lathe([(0.18, 0), (0.045, 0.012), (0.01, 0.03)], "brass", 28)
    for s in (-1, 1):
        with b.solid(f"cymbal {s}"):
            y = s * (w / 2 - 0.26)
            _stand(b, x1 - 0.28, y, h - 0.06, 0.24)
            _cymbal(b, x1 - 0.28, y, h - 0.1, 0.25 if s < 0 else 0.21, -0.2)
    with b.solid("stool"):
        x = -d / 2 + 0.17
        with b.frame(x, 0):
            b.lathe([(0.15, 0.44), (0.17, 0.47), (0.165, 0.52), (0.13, 0.54)], "black leather", 28)
        _stand(b, x, 0, 0.46, 0.2)


@gear("music_stand")
def music_stand(b: Builder) -> None:
    """A tilted desk with a sheet of music on a tripod."""
    d, w, h = b.size
    metal = b.material("stand", "black steel", "chrome", "white steel", "walnut")
    for k in range(3):
        a = k * 2 * math.pi / 3 + math.pi / 3
        b.bar((0, 0, 0.3), (0.26 * math.cos(a), 0.26 * math.sin(a), 0.01), 0.011, metal, 8)
    b.bar((0, 0, 0.12), (0, 0, h - 0.2), 0.012, metal, 10)
    b.frustum(0.02, 0.02, (h * 0.5, h * 0.5 + 0.05), "black plastic", 12)
    with b.frame(0.0, 0, h - 0.36, pitch=-0.4):
        b.box((-0.004, 0.004), (-w / 2, w / 2), (0, 0.36), metal, 0.002)
        b.box((0, 0.06), (-w / 2, w / 2), (-0.004, 0.006), metal, 0.002)
        for s in (-1, 1):
            y0 = s * 0.115
            b.box((0.004, 0.006), (y0 - 0.108, y0 + 0.108), (0.008, 0.31), "paper", 0)
            for k in range(7):
                inlay(b, (0.0055, 0.0062), (y0 - 0.09, y0 + 0.09), (0.04 + k * 0.036, 0.043 + k * 0.036), "ink pigment")


@gear("microphone_stand")
def microphone_stand(b: Builder) -> None:
    """A microphone on a stand with a round foot or a tripod and boom."""
    d, w, h = b.size
    metal = b.material("stand", "black steel", "chrome")
    if b.chance("round foot", 0.5):
        b.lathe([(w / 2, 0), (w / 2, 0.015), (0.04, 0.035), (0.02, 0.05)], metal, 28)
    else:
        for k in range(3):
            a = k * 2 * math.pi / 3
            b.bar((0, 0, 0.2), (w * 0.5 * math.cos(a), w * 0.5 * math.sin(a), 0.012), 0.01, metal, 8)
    b.bar((0, 0, 0.03), (0, 0, h - 0.12), 0.011, metal, 10)
    b.frustum(0.018, 0.018, (h * 0.55, h * 0.55 + 0.07), "black plastic", 12)
    with b.frame(-0.03, 0, h - 0.14, pitch=-0.45):
        b.lathe([(0.012, -0.06), (0.02, 0.06), (0.027, 0.08)], "black plastic", 16)
        b.ball((0.027, 0.027, 0.032), (0, 0, 0.1), "steel", 12)
    b.box((-0.04, 0.02), (-0.02, 0.02), (h - 0.16, h - 0.11), "black plastic", 0.006)


@gear("speaker_tower")
def speaker_tower(b: Builder) -> None:
    """A slim floor speaker: three cones and a dome on the front."""
    d, w, h = b.size
    wood = b.material("cabinet", "walnut", "black paint", "white paint", "oak", "cherry")
    x1 = d / 2 - 0.006
    b.box((-d / 2 - 0.01, x1 + 0.006), (-w / 2 - 0.015, w / 2 + 0.015), (0, 0.03), "black plastic", 0.006)
    b.box((-d / 2, x1), (-w / 2, w / 2), (0.03, h), wood, 0.008)
    b.box((x1 - 0.01, x1 + 0.006), (-w / 2 + 0.008, w / 2 - 0.008), (0.04, h - 0.008), "black plastic", 0.003)
    r = w * 0.38
    z = h - 0.02 - r * 0.9
    for k, (rr, gap) in enumerate([(r * 0.8, 0), (r * 0.35, 0.01), (r, 0.02), (r, 0.02)]):
        if k:
            z -= rr + gap
        for share, depth, look in (
            (1.0, 0.012, "brushed steel"),
            (0.88, 0.0126, "black plastic"),
            (0.35, 0.02, "grey plastic"),
        ):
            disc(b, (x1, 0, z), rr * share, depth * 1.6, look, "x", 24)
        z -= rr


@gear("amplifier")
def amplifier(b: Builder) -> None:
    """A guitar amplifier: grille cloth, control panel with knobs, corners, handle."""
    d, w, h = b.size
    skin = b.material("skin", "black leather", "tan leather", "red plastic", "white leather")
    cloth = b.material("grille", "black fabric", "grey fabric", "beige fabric")
    t = h - 0.03
    x1 = d / 2
    b.box((-d / 2, x1 - 0.02), (-w / 2, w / 2), (0.02, t), skin, 0.012)
    for ys, zs in (
        ((-w / 2, w / 2), (0.02, 0.05)),
        ((-w / 2, w / 2), (t - 0.03, t)),
        ((-w / 2, -w / 2 + 0.03), (0.02, t)),
        ((w / 2 - 0.03, w / 2), (0.02, t)),
    ):
        b.box((x1 - 0.04, x1), ys, zs, skin, 0.004)
    b.box((x1 - 0.03, x1 - 0.012), (-w / 2 + 0.03, w / 2 - 0.03), (0.05, t - 0.12), cloth, 0)
    b.box((x1 - 0.03, x1 - 0.005), (-w / 2 + 0.03, w / 2 - 0.03), (t - 0.115, t - 0.03), "brass", 0.003)
    for k in range(7):
        y = -w / 2 + 0.08 + k * (w - 0.16) / 6
        disc(b, (x1, y, t - 0.07), 0.014, 0.024, "black plastic", "x", 12)
    inlay(b, (x1 - 0.02, x1 - 0.0117), (w * 0.12, w * 0.4), (t - 0.16, t - 0.14), "white plastic")
    for s in (-1, 1):
        for x in (-d / 2 + 0.03, x1 - 0.05):
            b.frustum(0.015, 0.018, (0, 0.022), "rubber", 12) if False else disc(
                b, (x, s * (w / 2 - 0.04), 0.011), 0.017, 0.022, "rubber", "z", 12
            )
        for z in (0.02, t):
            c = s * w / 2
            b.box(
                (x1 - 0.045, x1 + 0.0003),
                (c - 0.03, c + 0.0003) if s > 0 else (c - 0.0003, c + 0.03),
                (z - 0.0003, z + 0.03) if z < 0.1 else (z - 0.03, z + 0.0003),
                "brass",
                0.01,
            )
    b.tube(
        [(-0.01, -0.11, t - 0.005), (-0.01, -0.08, h - 0.008), (-0.01, 0.08, h - 0.008), (-0.01, 0.11, t - 0.005)],
        0.008,
        "black leather",
        8,
    )


@gear("record_player")
def record_player(b: Builder) -> None:
    """A wooden plinth with a record, tone arm and buttons, its clear lid raised in some."""
    d, w, h = b.size
    wood = b.material("plinth", "walnut", "black paint", "oak", "white paint", "cherry")
    x1 = d / 2
    z = 0.085
    for x in (-d / 2 + 0.05, x1 - 0.05):
        for s in (-1, 1):
            disc(b, (x, s * (w / 2 - 0.05), 0.01), 0.02, 0.02, "rubber", "z", 16)
    b.box((-d / 2, x1), (-w / 2, w / 2), (0.018, z), wood, 0.005)
    cy = -w * 0.08
    r = min(d * 0.42, w * 0.36)
    disc(b, (0, cy, z + 0.008), r, 0.016, "steel", "z", 36)
    disc(b, (0, cy, z + 0.017), r * 0.98, 0.004, "black plastic", "z", 36)
    disc(
        b,
        (0, cy, z + 0.0193),
        r * 0.33,
        0.0012,
        b.material("label", "red plastic", "yellow plastic", "blue plastic"),
        "z",
        20,
    )
    disc(b, (0, cy, z + 0.022), 0.004, 0.014, "chrome", "z", 8)
    ay = w / 2 - 0.065
    disc(b, (-d * 0.28, ay, z + 0.015), 0.035, 0.03, "steel", "z", 20)
    b.tube(
        [
            (-d * 0.38, ay, z + 0.04),
            (-d * 0.28, ay, z + 0.04),
            (d * 0.14, ay - 0.03, z + 0.032),
            (d * 0.2, ay - 0.085, z + 0.026),
        ],
        0.005,
        "chrome",
        8,
    )
    disc(b, (-d * 0.38, ay, z + 0.04), 0.014, 0.03, "black plastic", "x", 12)
    b.box((d * 0.17, d * 0.25), (ay - 0.115, ay - 0.085), (z + 0.018, z + 0.03), "black plastic", 0.003)
    for k in range(2):
        disc(b, (d * 0.4, -w * 0.38 + 0.05 * k, z + 0.004), 0.014, 0.008, "chrome", "z", 12)
    if h > 0.25:
        with b.frame(-d / 2 + 0.006, 0, z + 0.004, pitch=-1.25):
            pass
        with b.frame(-d / 2 + 0.004, 0, z, pitch=0.12):
            b.box((0, 0.004), (-w / 2, w / 2), (0, h - z), "glass", 0)
            for s in (-1, 1):
                ys = (w / 2 - 0.004, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.004)
                b.box((0.004, 0.045), ys, (0.02, h - z), "glass", 0)
    else:
        for s in (-1, 1):
            ys = (w / 2 - 0.004, w / 2) if s > 0 else (-w / 2, -w / 2 + 0.004)
            b.box((-d / 2, x1), ys, (z, h - 0.004), "glass", 0)
        for xs in ((-d / 2, -d / 2 + 0.004), (x1 - 0.004, x1)):
            b.box(xs, (-w / 2, w / 2), (z, h - 0.004), "glass", 0)
        b.box((-d / 2, x1), (-w / 2, w / 2), (h - 0.004, h), "glass", 0)


@gear("jukebox")
def jukebox(b: Builder) -> None:
    """A rounded cabinet with glowing arched tubes, a record window and a speaker grille."""
    d, w, h = b.size
    wood = b.material("cabinet", "walnut", "mahogany", "cherry", "red paint")
    x1 = d / 2 - 0.06
    r = w / 2

    def arch(rr: float, foot: float, n: int = 12):
        t = np.linspace(0, math.pi, n + 1)
        return [(-rr, foot), (rr, foot)] + [(rr * math.cos(a), h - r + rr * math.sin(a)) for a in t]

    face(b, arch(r, 0.06), (-d / 2, x1), wood)
    b.box((-d / 2 + 0.02, x1 + 0.03), (-r + 0.02, r - 0.02), (0, 0.08), "black plastic", 0.004)
    face(b, arch(r * 0.97, 0.1), (x1 - 0.01, x1 + 0.02), "chrome")
    face(b, arch(r * 0.9, 0.12), (x1 - 0.01, x1 + 0.03), "orange plastic")
    face(b, arch(r * 0.76, 0.14), (x1 - 0.01, x1 + 0.038), wood)
    glow = b.pick("glow", ["red petal", "yellow petal", "purple petal"])
    for rr, look in ((0.93, "lamp glow"), (0.83, glow)):
        t = np.linspace(0, math.pi, 11)
        path = [(x1 + 0.03, r * rr, 0.16)] + [
            (x1 + 0.03, r * rr * math.cos(a), h - r + r * rr * math.sin(a)) for a in t
        ]
        b.tube([*path, (x1 + 0.03, -r * rr, 0.16)], 0.026, look, 8)
    t = np.linspace(0, math.pi, 9)
    q = r * 0.62
    face(
        b,
        [(-q, h * 0.62), (q, h * 0.62)] + [(q * math.cos(a), h - r + q * math.sin(a)) for a in t],
        (x1, x1 + 0.043),
        "screen",
    )
    disc(b, (x1 + 0.044, 0, h * 0.72), q * 0.5, 0.006, "black plastic", "x", 28)
    disc(b, (x1 + 0.045, 0, h * 0.72), q * 0.18, 0.006, "red plastic", "x", 20)
    b.box((x1, x1 + 0.06), (-q, q), (h * 0.53, h * 0.6), "chrome", 0.008)
    for k in range(8):
        y = -q * 0.85 + k * q * 1.7 / 7
        inlay(
            b,
            (x1, x1 + 0.0603),
            (y - 0.018, y + 0.018),
            (h * 0.55, h * 0.58),
            "red plastic" if k % 2 else "white plastic",
        )
    b.box((x1, x1 + 0.048), (-q, q), (0.17, h * 0.5), "brass", 0.01)
    for k in range(7):
        y = -q * 0.84 + k * q * 1.68 / 6
        b.box((x1 + 0.04, x1 + 0.056), (y - 0.012, y + 0.012), (0.19, h * 0.48), "chrome" if k % 2 else glow, 0.003)
