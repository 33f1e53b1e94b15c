"""Examination rooms, dentists, hospitals."""

from __future__ import annotations

import math

from ..builder import Builder, span
from ..joinery import door
from .gym_kit import castors, disc, gear, inlay, post

_STEELS = ("white steel", "steel", "brushed steel", "light grey paint")


@gear("examination_table")
def examination_table(b: Builder) -> None:
    """A padded couch with a raised head end, a roll of paper, on a cabinet or a frame."""
    d, w, h = b.size
    pad = b.material("pad", "black leather", "white leather", "teal paint", "blue plastic", "mint plastic")
    metal = b.material("frame", *_STEELS)
    x0, x1 = -d / 2, d / 2
    z = h - 0.28
    if b.chance("cabinet", 0.5):
        b.box((x0 + 0.08, x1 - 0.08), (-w / 2 + 0.04, w / 2 - 0.04), (0.06, z - 0.08), metal, 0.006)
        b.box((x0 + 0.12, x1 - 0.12), (-w / 2 + 0.08, w / 2 - 0.08), (0, 0.07), "black plastic", 0)
        for k in range(3):
            a = x0 + 0.12 + k * (d - 0.24) / 3
            for s in (-1, 1):
                c = s * (w / 2 - 0.04)
                b.box(
                    (a + 0.01, a + (d - 0.24) / 3 - 0.01),
                    span(c - s * 0.002, c + s * 0.012),
                    (0.12, z - 0.14),
                    metal,
                    0.003,
                )
    else:
        for x in (x0 + 0.12, x1 - 0.12):
            for s in (-1, 1):
                b.bar((x, s * (w / 2 - 0.06), 0), (x, s * (w / 2 - 0.06), z - 0.05), 0.02, metal, 10)
            b.bar((x, -w / 2 + 0.06, 0.2), (x, w / 2 - 0.06, 0.2), 0.014, metal, 8)
        for s in (-1, 1):
            b.bar((x0 + 0.12, s * (w / 2 - 0.06), 0.2), (x1 - 0.12, s * (w / 2 - 0.06), 0.2), 0.014, metal, 8)
    b.box((x0 + 0.05, x1 - 0.05), (-w / 2 + 0.03, w / 2 - 0.03), (z - 0.09, z - 0.05), metal, 0.004)
    head = x0 + d * 0.32
    b.cushion((head + 0.01, x1), (-w / 2, w / 2), (z - 0.055, z + 0.04), pad, 0.025)
    long = math.hypot(head - x0, h - z - 0.05)
    a = math.asin(min(0.9, (h - z - 0.04) / long))
    with b.frame(head, 0, z - 0.05, pitch=a):
        b.cushion((-long, 0), (-w / 2, w / 2), (0, 0.09), pad, 0.025)
    post(
        b,
        (head - 0.25, 0, z - 0.07),
        (head - long * 0.6 * math.cos(a), 0, z - 0.05 + long * 0.6 * math.sin(a)),
        metal,
        0.04,
    )
    b.box((head + 0.02, x1 - 0.002), (-w * 0.4, w * 0.4), (z + 0.038, z + 0.042), "paper", 0.001)
    b.bar((x1 - 0.03, -w * 0.4, z - 0.1), (x1 - 0.03, w * 0.4, z - 0.1), 0.04, "paper", 14)


@gear("medical_cabinet")
def medical_cabinet(b: Builder) -> None:
    """A white cabinet with glazed doors above, solid ones below, a red cross, bottles inside."""
    d, w, h = b.size
    steel = b.material("case", "white steel", "light grey paint", "sage paint")
    x0, x1, y = -d / 2, d / 2 - 0.045, w / 2
    m = h * 0.42
    b.box((x0, x1), (-y, y), (0, m), steel, 0.004)
    for s in (-1, 1):
        b.box((x0, x1), span(s * y, s * (y - 0.02)), (m, h), steel, 0.002)
    b.box((x0, x0 + 0.015), (-y, y), (m, h), steel, 0)
    b.box((x0, x1), (-y, y), (h - 0.03, h), steel, 0.002)
    i = y - 0.02
    looks = ("amber glass", "white plastic", "blue plastic", "green glass", "clear plastic", "paper")
    for k in range(3):
        z = m + k * (h - m - 0.03) / 3
        if k:
            b.box((x0 + 0.015, x1 - 0.01), (-i, i), (z - 0.008, z), "glass", 0)
        n = int(w / 0.11)
        for j in range(n):
            c = -i + 0.06 + j * (2 * i - 0.12) / max(1, n - 1)
            t = (h - m) / 3 * b.uniform(f"t {k} {j}", 0.35, 0.7)
            with b.frame(x0 + (x1 - x0) * 0.55, c):
                look = b.pick(f"look {k} {j}", looks)
                if look == "paper":
                    b.box((-0.05, 0.05), (-0.035, 0.035), (z, z + t), look, 0.002)
                else:
                    b.lathe([(0.03, z), (0.03, z + t * 0.7), (0.014, z + t * 0.85), (0.014, z + t)], look, 12)
    for s, hung in ((-1, "right"), (1, "left")):
        ys = span(0.0, s * y)
        door(b, f"glass-{s}", (x1, x1 + 0.018), ys, (m, h), steel, "steel", hung=hung, panel="glass")  # type: ignore[arg-type]
        door(b, f"door-{s}", (x1, x1 + 0.018), ys, (0.04, m), steel, "steel", hung=hung)  # type: ignore[arg-type]
    x = x1 + 0.018
    for p, q in ((0.05, 0.016), (0.016, 0.05)):
        inlay(b, (x1 + 0.002, x + 0.0003), (y * 0.5 - p, y * 0.5 + p), (m * 0.5 - q, m * 0.5 + q), "red plastic")


@gear("iv_stand")
def iv_stand(b: Builder) -> None:
    """A pole on five castors with hooks, a bag of fluid and its line."""
    d, w, h = b.size
    r = d / 2 - 0.03
    for k in range(5):
        a = k * 2 * math.pi / 5
        x, y = r * math.cos(a), r * math.sin(a)
        b.bar((0, 0, 0.1), (x, y, 0.08), 0.014, "steel", 8)
        disc(b, (x, y, 0.03), 0.03, 0.02, "black plastic", "y", 14)
        b.bar((x, y, 0.05), (x, y, 0.085), 0.01, "black plastic", 8)
    b.frustum(0.014, 0.014, (0.08, h * 0.6), "steel", 12)
    b.frustum(0.009, 0.009, (h * 0.55, h - 0.03), "chrome", 12)
    b.frustum(0.022, 0.022, (h * 0.58, h * 0.62), "black plastic", 12)
    for k in range(4):
        a = k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        b.tube([(0, 0, h - 0.04), (0.09 * c, 0.09 * s, h - 0.06), (0.1 * c, 0.1 * s, h - 0.005)], 0.005, "chrome", 6)
    bag = b.material("bag", "clear plastic", "yellow plastic", "red plastic")
    b.cushion((-0.02, 0.02), (0.03, 0.15), (h - 0.36, h - 0.1), bag, 0.015)
    b.bar((0, 0.09, h - 0.11), (0, 0.09, h - 0.055), 0.004, "white plastic", 6)
    b.tube(
        [(0, 0.09, h - 0.36), (0.02, 0.09, h - 0.5), (0.05, 0.08, h * 0.5), (0.04, 0.04, h * 0.6)],
        0.003,
        "clear plastic",
        5,
    )
    if b.chance("pump", 0.5):
        b.box((0.012, 0.09), (-0.06, 0.06), (h * 0.45, h * 0.45 + 0.18), "white plastic", 0.012)
        inlay(b, (0.05, 0.0903), (-0.04, 0.04), (h * 0.45 + 0.08, h * 0.45 + 0.15), "screen")


@gear("medical_scale")
def medical_scale(b: Builder) -> None:
    """A platform scale with a column, sliding weights and a height rod."""
    d, w, h = b.size
    body = b.material("body", "white steel", "grey paint", "light grey paint")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0, 0.06), body, 0.01)
    b.box((-d / 2 + 0.14, d / 2 - 0.02), (-w / 2 + 0.02, w / 2 - 0.02), (0.055, 0.08), "rubber", 0.004)
    x = -d / 2 + 0.06
    z = min(1.35, h - 0.3)
    b.box((x - 0.035, x + 0.035), (-0.04, 0.04), (0.05, z), body, 0.008)
    b.box((x - 0.03, x + 0.04), (-w * 0.46, w * 0.46), (z, z + 0.05), body, 0.008)
    for dz in (0.065, 0.1):
        b.box((x - 0.01, x + 0.01), (-w * 0.46, w * 0.46), (z + dz, z + dz + 0.015), "brushed steel", 0.002)
    for s in (-1, 1):
        b.box((x - 0.015, x + 0.015), (s * w * 0.44 - 0.012, s * w * 0.44 + 0.012), (z + 0.04, z + 0.12), body, 0.003)
    for y, dz in ((w * 0.15, 0.055), (-w * 0.22, 0.09)):
        b.box((x - 0.018, x + 0.022), (y - 0.025, y + 0.025), (z + dz, z + dz + 0.035), "black plastic", 0.004)
    b.box((x - 0.012, x + 0.0), (-0.02, 0.02), (z, h), "aluminium", 0.002)
    b.box((x - 0.014, x + 0.22), (-0.03, 0.03), (h - 0.05, h - 0.04), "aluminium", 0.002)


@gear("privacy_screen")
def privacy_screen(b: Builder) -> None:
    """A folding ward screen: three framed cloth panels on castors, the outer ones turned forward."""
    d, w, h = b.size
    cloth = b.material("cloth", "blue fabric", "mint plastic", "white fabric", "green fabric", "sheer fabric")
    metal = b.material("frame", "steel", "white steel", "chrome")
    long = w * 0.4
    a = math.asin(min(0.9, (d - 0.06) / long))
    mid = w - 2 * long * math.cos(a)

    def panel(length: float) -> None:
        for y in (0.0, length):
            b.bar((0, y, 0.07), (0, y, h), 0.013, metal, 8)
            disc(b, (0, y, 0.03), 0.03, 0.022, "black plastic", "x", 14)
            b.bar((0, y, 0.045), (0, y, 0.08), 0.01, "black plastic", 8)
        for z in (0.2, h - 0.02):
            b.bar((0, 0, z), (0, length, z), 0.012, metal, 8)
        b.box((-0.003, 0.003), (0.015, length - 0.015), (0.22, h - 0.04), cloth, 0)
        for k in range(1, 7):
            y = k * length / 7
            b.box((-0.008, 0.008), (y - 0.008, y + 0.008), (0.22, h - 0.04), cloth, 0.003)

    with b.solid("middle"), b.frame(0, -mid / 2):
        panel(mid)
    with b.solid("left"), b.frame(0, mid / 2, yaw=-a):
        panel(long)
    with b.solid("right"), b.frame(0, -mid / 2, yaw=math.pi + a):
        panel(long)


@gear("dental_chair")
def dental_chair(b: Builder) -> None:
    """A reclined chair on a foot, with a lamp on an arm, an instrument tray and a spittoon."""
    d, w, h = b.size
    pad = b.material("pad", "blue plastic", "mint plastic", "black leather", "teal paint", "white leather")
    shell = "white plastic"
    with b.solid("chair"):
        b.box((-0.35, 0.35), (-0.25, 0.25), (0, 0.06), shell, 0.02)
        b.hull([(x, y, z) for z, q in ((0.05, 0.2), (0.42, 0.13)) for x in (-q * 1.3, q * 1.3) for y in (-q, q)], shell)
        b.cushion((-0.2, 0.3), (-0.27, 0.27), (0.42, 0.54), pad, 0.05)
        with b.frame(0.28, 0, 0.48, pitch=0.25):
            b.cushion((0, d / 2 - 0.25), (-0.23, 0.23), (-0.05, 0.06), pad, 0.045)
        with b.frame(-0.17, 0, 0.48, pitch=0.55):
            long = (d / 2 - 0.3) / math.cos(0.55)
            b.cushion((-long, 0.02), (-0.26, 0.26), (-0.04, 0.08), pad, 0.045)
            b.cushion((-long - 0.17, -long + 0.02), (-0.13, 0.13), (-0.01, 0.1), pad, 0.04)
        for s in (-1, 1):
            b.box((-0.2, 0.15), (s * 0.3 - 0.035, s * 0.3 + 0.035), (0.66, 0.7), shell, 0.012)
            b.box((-0.16, -0.1), (s * 0.3 - 0.02, s * 0.3 + 0.02), (0.46, 0.67), shell, 0.008)
    y = w / 2 - 0.16
    with b.solid("unit"):
        b.box((0.0, 0.3), (y - 0.1, y + 0.14), (0, 0.75), shell, 0.03)
        b.frustum(0.05, 0.05, (0.74, 0.78), "grey plastic", 12) if False else disc(
            b, (0.2, y, 0.77), 0.09, 0.06, "white ceramic", "z", 24, 0.01, head=0.11
        )
        b.box((0.0, 0.3), (0.2, y), (0.1, 0.2), shell, 0.02)
    with b.solid("lamp"):
        b.tube(
            [(0.05, y, 0.7), (0.05, y, h - 0.02), (-0.05, y - 0.02, h - 0.02), (-0.2, 0.05, h - 0.12)], 0.02, shell, 10
        )
        b.box((-0.28, -0.14), (-0.12, 0.16), (h - 0.24, h - 0.14), shell, 0.02)
        inlay(b, (-0.26, -0.16), (-0.08, 0.12), (h - 0.2403, h - 0.2), "lamp glow")
    with b.solid("tray"):
        b.tube([(0.1, y, 0.72), (0.25, y * 0.5, 0.84), (0.3, -w * 0.2, 0.86)], 0.018, shell, 8)
        b.box((0.16, 0.46), (-w / 2, -w / 2 + 0.45), (0.86, 0.9), shell, 0.012)
        b.box((0.18, 0.44), (-w / 2 + 0.02, -w / 2 + 0.43), (0.895, 0.905), "steel", 0.002)
        for k in range(5):
            c = -w / 2 + 0.07 + 0.07 * k
            b.bar((0.22, c, 0.91), (0.4, c, 0.91), 0.006, ("blue plastic", "steel")[k % 2], 6)


@gear("stretcher")
def stretcher(b: Builder) -> None:
    """A mattress on a wheeled frame with fold-down rails and a raised back."""
    d, w, h = b.size
    pad = b.material("pad", "blue plastic", "black leather", "green plastic", "grey plastic")
    metal = b.material("frame", "white steel", "steel", "grey paint")
    x0, x1 = -d / 2, d / 2
    z = h - 0.3
    castors(b, (x0 + 0.25, x1 - 0.25), (-w / 2 + 0.1, w / 2 - 0.1), r=0.075)
    b.box((x0 + 0.2, x1 - 0.2), (-w / 2 + 0.12, w / 2 - 0.12), (0.16, 0.26), metal, 0.02)
    for x in (-d * 0.18, d * 0.18):
        b.frustum(0.06, 0.06, (0, 0.01), metal, 8) if False else disc(
            b, (x, 0, (0.25 + z) / 2), 0.07, z - 0.25, metal, "z", 20
        )
    b.box((x0 + 0.03, x1 - 0.03), (-w / 2 + 0.05, w / 2 - 0.05), (z - 0.09, z - 0.04), metal, 0.01)
    head = x0 + d * 0.36
    b.cushion((head, x1 - 0.05), (-w / 2 + 0.07, w / 2 - 0.07), (z - 0.04, z + 0.06), pad, 0.03)
    long = (head - x0 - 0.05) / math.cos(0.35)
    with b.frame(head, 0, z - 0.04, pitch=0.35):
        b.cushion((-long, 0.02), (-w / 2 + 0.07, w / 2 - 0.07), (0, 0.1), pad, 0.03)
        b.cushion((-long + 0.02, -long + 0.3), (-w * 0.28, w * 0.28), (0.09, 0.17), "white fabric", 0.03, puff=0.6)
    for s in (-1, 1):
        y = s * (w / 2 - 0.02)
        b.tube(
            [(-d * 0.2, y, z - 0.08), (-d * 0.17, y, h - 0.02), (d * 0.2, y, h - 0.02), (d * 0.23, y, z - 0.08)],
            0.014,
            "chrome",
            8,
        )
        for k in range(1, 5):
            x = -d * 0.17 + k * d * 0.074
            b.bar((x, y, z - 0.07), (x, y, h - 0.02), 0.008, "chrome", 6)
        b.box((-d * 0.22, d * 0.25), (y - 0.012, y + 0.012), (z - 0.1, z - 0.06), metal, 0.003)
        b.box((-d * 0.1, d * 0.1), span(y, y - s * 0.08), (z - 0.09, z - 0.05), metal, 0.003)
    for x in (x0, x1):
        e = 1 if x > 0 else -1
        b.tube(
            [
                (x - e * 0.06, -w * 0.3, z - 0.06),
                (x - e * 0.014, -w * 0.3, z + 0.1),
                (x - e * 0.014, w * 0.3, z + 0.1),
                (x - e * 0.06, w * 0.3, z - 0.06),
            ],
            0.013,
            "black plastic",
            8,
        )


@gear("instrument_trolley")
def instrument_trolley(b: Builder) -> None:
    """A steel trolley: shelves with rims, a drawer, castors, bowls on top."""
    d, w, h = b.size
    metal = b.material("frame", "steel", "brushed steel", "white steel")
    x, y = d / 2, w / 2
    with b.solid("low"):
        castors(b, (-x + 0.03, x - 0.03), (-y + 0.03, y - 0.03), r=0.035)
        b.box((-x + 0.01, x - 0.01), (-y + 0.01, y - 0.01), (0.2, 0.22), metal, 0.002)
    for k, s in enumerate((-1, 1)):
        with b.solid(f"side {k}"):
            for e in (-1, 1):
                b.bar((e * (x - 0.02), s * (y - 0.02), 0.07), (e * (x - 0.02), s * (y - 0.02), h), 0.012, metal, 8)
    t = h - 0.06
    with b.solid("top"):
        b.box((-x + 0.01, x - 0.01), (-y + 0.01, y - 0.01), (t - 0.012, t), metal, 0.002)
        if b.chance("drawer", 0.6):
            b.box((-x + 0.03, x - 0.02), (-y + 0.06, y - 0.06), (t - 0.13, t - 0.012), metal, 0.003)
            b.box((x - 0.022, x - 0.006), (-0.06, 0.06), (t - 0.08, t - 0.06), "black plastic", 0.004)
        b.bar((-x + 0.01, -y + 0.02, h - 0.012), (-x + 0.01, y - 0.02, h - 0.012), 0.008, metal, 6)
        for s in (-1, 1):
            b.bar((-x + 0.01, s * (y - 0.01), h - 0.012), (x - 0.02, s * (y - 0.01), h - 0.012), 0.008, metal, 6)
        with b.frame(0, y * 0.5, t):
            b.lathe([(0.05, 0), (0.08, 0.03), (0.09, 0.05)], "chrome", 20)
        for k in range(5):
            c = -y * 0.7 + k * 0.05
            b.bar((-0.08, c, t + 0.006), (0.08, c + 0.01, t + 0.006), 0.006, "chrome", 6)
        b.box((-x * 0.5, x * 0.3), (0.02, 0.1), (t, t + 0.05), "blue plastic", 0.004)
    b.surface("shelf-0", (-x + 0.05, x - 0.05), (-y + 0.05, y - 0.05), 0.22, headroom=0.4)


@gear("hand_sanitizer_stand")
def hand_sanitizer_stand(b: Builder) -> None:
    """A slim post with a dispenser, a drip tray and a sign."""
    d, w, h = b.size
    metal = b.material("post", "white steel", "aluminium", "black steel")
    b.box((-d / 2, d / 2), (-w / 2, w / 2), (0, 0.015), metal, 0.004)
    b.box((-0.03, 0.0), (-0.05, 0.05), (0.01, h - 0.3), metal, 0.006)
    b.box((-0.02, -0.008), (-w * 0.36, w * 0.36), (h - 0.32, h), metal, 0.002)
    inlay(b, (-0.015, -0.0077), (-w * 0.32, w * 0.32), (h - 0.3, h - 0.02), "blue plastic")
    for p, q in ((0.06, 0.02), (0.02, 0.06)):
        inlay(b, (-0.015, -0.0076), (-p, p), (h - 0.16 - q, h - 0.16 + q), "white plastic")
    z = h - 0.6
    b.box((-0.002, 0.1), (-0.06, 0.06), (z, z + 0.25), "white plastic", 0.015)
    inlay(b, (0.05, 0.1003), (-0.03, 0.03), (z + 0.07, z + 0.2), "sky pigment")
    b.box((0.04, 0.08), (-0.015, 0.015), (z - 0.02, z + 0.01), "grey plastic", 0.004)
    b.box((-0.002, d / 2 - 0.01), (-0.07, 0.07), (z - 0.2, z - 0.185), "grey plastic", 0.004)
