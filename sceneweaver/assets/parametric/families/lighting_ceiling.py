"""Lamps that hang from the ceiling or on the wall, and fans."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .lighting_parts import across, globe, shade

_CLOTH = ("lit shade", "white fabric", "beige fabric", "rust fabric", "green fabric", "charcoal fabric")


def _rose(b: Builder, h: float, radius: float, metal) -> None:
    """The cap at the ceiling."""
    b.lathe([(0.012, h - 0.045), (radius * 0.75, h - 0.035), (radius, h - 0.018), (radius, h)], metal, 24)


@draws("pendant")
def pendant(b: Builder) -> None:
    """A cord from a rose, and a bell, drum, globe, cone, woven basket or cage with a bulb."""
    r, h = across(b) / 2, b.size.height
    kind = b.pick("kind", ["dome", "drum", "globe", "cone", "basket", "slats"])
    metal = b.material(
        "metal",
        "black steel",
        "brass",
        "copper",
        "white steel",
        "brushed steel",
        "teal paint",
        "sage paint",
        "mustard fabric",
    )
    tall = min(h * 0.6, r * {"dome": 1.0, "drum": 0.9, "globe": 2.0, "cone": 1.25, "basket": 1.15, "slats": 1.2}[kind])
    rr = min(r, tall / 2) if kind == "globe" else r
    with b.solid("cord"):
        _rose(b, h, 0.05, metal if kind != "globe" else "black steel")
        b.bar((0, 0, tall - 0.01), (0, 0, h - 0.04), 0.0035, "black plastic", 8)
        b.lathe([(0.024, tall - 0.012), (0.024, tall + 0.02), (0.014, tall + 0.05), (0.007, tall + 0.056)], metal, 16)
    with b.solid("shade"):
        if kind == "dome":
            curve = [(r * math.cos(a), 0.012 + (tall - 0.012) * math.sin(a)) for a in np.linspace(0, 1.45, 8)]
            b.lathe([(r - 0.003, 0.003), (r, 0.006), *curve], metal, 32)
            b.frustum(r - 0.01, r - 0.01, (0.0, 0.006), "lamp glow", 32)
        elif kind == "drum":
            cloth = b.material("shade", *_CLOTH)
            shade(b, r, r * b.uniform("taper", 0.8, 1.0), (0.0, tall), cloth)
        elif kind == "globe":
            globe(b, rr, tall / 2, 24)
            b.lathe([(rr * 0.5, tall * 0.93), (rr * 0.3, tall * 0.985), (0.03, tall + 0.01)], metal, 20)
            if rr < r:
                b.frustum(r, r, (tall / 2 - 0.006, tall / 2 + 0.006), metal, 32)
        elif kind == "cone":
            b.lathe([(r - 0.003, 0.003), (r, 0.006), (r * 0.94, 0.03), (0.045, tall * 0.86), (0.035, tall)], metal, 32)
            b.frustum(r - 0.01, r - 0.01, (0.0, 0.005), "lamp glow", 32)
        elif kind == "basket":
            weave = b.material("weave", "rattan", "wicker", "black paint")
            _ribs(b, r, tall, weave)
        else:
            wood = b.material("slats", "light oak", "walnut", "white paint", "birch")
            count = 7
            for k in range(count):
                s = (k + 0.5) / count
                radius = r * math.sin(math.pi * (0.16 + 0.62 * s)) ** 0.8
                b.frustum(
                    radius if k != 3 else r,
                    (radius if k != 3 else r) * 0.9,
                    (s * tall - 0.008, s * tall + 0.008),
                    wood,
                    28,
                )
            b.frustum(r * 0.42, r * 0.36, (0.0, tall), "lamp glow", 24)


def _ribs(b: Builder, r: float, tall: float, weave) -> None:
    """A round basket of ribs and rings around a glowing ball."""
    angles = np.linspace(-0.35, 1.35, 8)
    low, high = math.sin(angles[0]), math.sin(angles[-1])
    curve = [(math.cos(a) * (r - 0.004), 0.004 + (tall - 0.008) * (math.sin(a) - low) / (high - low)) for a in angles]
    for k in range(12):
        a = k * math.pi / 6
        path = [(u * math.cos(a), u * math.sin(a), z) for u, z in curve]
        b.tube(path[::2] + [path[-1]], 0.004, weave, 6)
    for u, z in (curve[0], curve[2], curve[3], curve[5], curve[7]):
        ring = np.arange(24) * (math.pi / 12)
        path = np.c_[u * np.cos(ring), u * np.sin(ring), np.full(24, z)]
        hull = _disc(u + 0.004, z)
        b.add(shapes.sweep(path, 0.004, 6, True), weave, [hull])
    b.ball((r * 0.38, r * 0.38, r * 0.38), (0, 0, tall * 0.45), "lamp glow", 16)


def _disc(radius: float, z: float):
    return shapes.frustum(radius, radius, (z - 0.0045, z + 0.0045), 24)


@draws("chandelier")
def chandelier(b: Builder) -> None:
    """A turned stem with curved arms and candles of light; or a ring, or a cluster of globes."""
    r, h = across(b) / 2, b.size.height
    metal = b.material("metal", "brass", "black steel", "bronze", "chrome")
    kind = b.pick("kind", ["candles", "ring", "globes"])
    count = b.whole("arms", 5, 8)
    with b.solid("stem"):
        _rose(b, h, 0.06, metal)
        b.bar((0, 0, h * 0.5), (0, 0, h - 0.04), 0.006, metal, 8)
    if kind == "ring":
        with b.solid("ring"):
            ring = np.arange(32) * (math.pi / 16)
            section = np.array([[-0.012, -0.022], [0.012, -0.022], [0.012, 0.022], [-0.012, 0.022]])
            inner = r - 0.013
            z = 0.03
            b.tube(np.c_[inner * np.cos(ring), inner * np.sin(ring), np.full(32, z)], section, metal, closed=True)
            b.add(*_glow_ring(inner, z))
            for k in range(4):
                a = (k + 0.5) * math.pi / 2
                b.bar((inner * math.cos(a), inner * math.sin(a), z), (0, 0, h * 0.62), 0.002, metal, 6)
        with b.solid("stem"):
            b.frustum(0.016, 0.016, (h * 0.5, h * 0.66), metal, 16, bevel=0.004)
        return
    body = min(0.42, h * 0.5)
    with b.solid("body"):
        k = body / 0.42
        b.lathe(
            [
                (0.0, 0.0),
                (0.02, 0.012),
                (0.016, 0.03),
                (0.05 * k, 0.07),
                (0.062 * k, 0.11),
                (0.03, 0.16 * k + 0.02),
                (0.018, 0.2 * k + 0.02),
                (0.032, 0.27 * k + 0.02),
                (0.02, 0.34 * k + 0.02),
                (0.012, h * 0.5 + 0.02),
            ],
            metal,
            20,
        )
        bulb = 0.014 if kind == "candles" else min(0.07, r * 0.2)
        out = r - (0.034 if kind == "candles" else bulb)
        cup = body * 0.42
        for n in range(count):
            with b.frame(yaw=(n + 0.5) * 2 * math.pi / count):
                path = [
                    (0.03, 0, 0.12 * k),
                    (out * 0.3, 0, 0.035),
                    (out * 0.62, 0, 0.03),
                    (out * 0.9, 0, 0.09 * k),
                    (out, 0, cup),
                ]
                b.tube(path, 0.006, metal, 8)
            a = (n + 0.5) * 2 * math.pi / count
            with b.frame(out * math.cos(a), out * math.sin(a)):
                if kind == "candles":
                    b.lathe([(0.008, cup - 0.016), (0.034, cup), (0.034, cup + 0.006)], metal, 14)
                    b.frustum(0.013, 0.012, (cup, cup + 0.085), "candle wax", 10)
                    b.lathe(
                        [(0.008, cup + 0.085), (bulb, cup + 0.105), (0.006, cup + 0.14), (0.0, cup + 0.155)],
                        "lamp glow",
                        10,
                    )
                else:
                    b.lathe([(0.01, cup - 0.02), (bulb * 0.6, cup), (bulb * 0.6, cup + 0.012)], metal, 14)
                    b.ball((bulb, bulb, bulb), (0, 0, cup + bulb + 0.004), "lamp glow", 14)


def _glow_ring(radius: float, z: float):
    """The light under a ring: its shape, its finish and no parts, as it lies inside the ring to half a millimetre."""
    ring = np.arange(32) * (math.pi / 16)
    section = np.array([[-0.0124, -0.0224], [0.0124, -0.0224], [0.0124, 0.002], [-0.0124, 0.002]])
    path = np.c_[radius * np.cos(ring), radius * np.sin(ring), np.full(32, z)]
    return shapes.sweep(path, section, closed=True), "lamp glow", []


@draws("ceiling_light")
def ceiling_light(b: Builder) -> None:
    """A flush light: an opal bowl or a flat disc in a metal ring, or three spots on a plate."""
    r, h = across(b) / 2, b.size.height
    metal = b.material("rim", "brushed steel", "brass", "white steel", "black steel", "oak")
    kind = b.pick("kind", ["bowl", "disc", "drum", "square"])
    with b.solid("light"):
        if kind == "bowl":
            curve = [(r * 0.93 * math.sin(a), (h - 0.03) * (1 - math.cos(a))) for a in np.linspace(0, math.pi / 2, 8)]
            b.lathe(curve, "lamp glow", 32)
            b.frustum(r, r, (h - 0.032, h), metal, 32, bevel=0.005)
            b.lathe([(0.0, -0.012), (0.012, -0.004), (0.01, 0.006)], metal, 12)
        elif kind == "disc":
            b.frustum(r, r, (h * 0.62, h), metal, 36, bevel=0.004)
            b.frustum(r * 0.86, r * 0.96, (0.0, h * 0.7), "lamp glow", 36, bevel=0.006)
        elif kind == "drum":
            cloth = b.material("shade", *_CLOTH)
            shade(b, r, r, (0.0, h - 0.012), cloth)
            b.frustum(r * 0.5, r * 0.5, (h - 0.02, h), metal, 24)
        else:
            b.box((-r, r), (-r, r), (h * 0.7, h), metal, bevel=0.004)
            b.box((-r * 0.93, r * 0.93), (-r * 0.93, r * 0.93), (0.0, h * 0.72), "lamp glow", bevel=0.012)


@draws("track_light")
def track_light(b: Builder) -> None:
    """A rail with three to five spots turned each its own way."""
    d, w, h = b.size
    metal = b.material("rail", "black steel", "white steel", "brushed steel")
    count = max(3, min(5, round(w / 0.3)))
    rail = 0.025
    with b.solid("rail"):
        b.box((-0.018, 0.018), (-w / 2, w / 2), (h - rail, h), metal)
    # A spot is a can of length c and radius s, hung so that turned any way it stays in the box.
    s = min(0.04, d * 0.3)
    c = min(h - rail - 0.05, 2.4 * s)
    with b.solid("spots"):
        for k in range(count):
            y = (k + 0.5) * w / count - w / 2
            with b.frame(0, y, h - rail):
                b.frustum(0.014, 0.014, (-0.03, 0.0), metal, 12)
                b.bar((0, 0, -0.02), (0, 0, -0.05), 0.006, metal, 8)
                turn = 0.0 if k == 0 else b.uniform(f"turn {k}", -0.5, 0.5)
                tip = b.uniform(f"tip {k}", -0.4, 0.4) if k else 0.0
                with b.frame(0, 0, -0.04, pitch=tip, roll=turn):
                    b.frustum(s, s * 0.86, (-c, 0.0), metal, 18, bevel=0.004)
                    b.frustum(s * 0.8, s * 0.8, (-c - 0.002, -c + 0.01), "lamp glow", 18)
        half = d / 2
        b.box((-half, half), (-w / 2 + 0.01, -w / 2 + 0.09), (h - rail * 0.7, h - 0.002), metal)


@draws("ceiling_fan")
def ceiling_fan(b: Builder) -> None:
    """A rod, a motor, three to five pitched blades, and often a light below."""
    r, h = across(b) / 2, b.size.height
    metal = b.material("motor", "brushed steel", "white steel", "black steel", "bronze")
    blades = b.material("blades", "walnut", "oak", "white paint", "black paint", "wenge")
    count = b.pick("blades", [3, 4, 5])
    lit = b.chance("light", 0.7)
    low = 0.09 if lit else 0.0
    with b.solid("motor"):
        b.lathe(
            [
                (0.05, low),
                (0.1, low + 0.012),
                (0.115, low + 0.05),
                (0.11, low + 0.09),
                (0.06, low + 0.125),
                (0.02, low + 0.15),
            ],
            metal,
            28,
        )
        if lit:
            curve = [(0.1 * math.sin(a), 0.088 * (1 - math.cos(a))) for a in np.linspace(0, math.pi / 2, 6)]
            b.lathe([*curve, (0.1, low + 0.012)], "lamp glow", 28)
    with b.solid("rod"):
        b.bar((0, 0, low + 0.14), (0, 0, h - 0.03), 0.012, metal, 12)
        b.lathe([(0.02, h - 0.075), (0.055, h - 0.05), (0.065, h - 0.02), (0.065, h)], metal, 24)
    # The box of blades at equal angles from +x is two radii wide in one direction only.
    reach = r / max(abs(math.sin(k * 2 * math.pi / count)) for k in range(count)) if count != 4 else r
    wide = b.uniform("blade width", 0.055, 0.07)
    reach -= 0.012
    with b.solid("blades"):
        for k in range(count):
            with b.frame(0, 0, low + 0.055, yaw=k * 2 * math.pi / count, roll=0.2):
                b.box((0.09, 0.24), (-0.02, 0.02), (-0.004, 0.004), metal)
                plan = [
                    (0.19, -wide * 0.7),
                    (reach - 0.03, -wide),
                    (reach, -wide * 0.6),
                    (reach, wide * 0.6),
                    (reach - 0.03, wide),
                    (0.19, wide * 0.7),
                ]
                b.extrude(np.array(plan), (0.003, 0.011), blades, bevel=0.002)


@draws("wall_sconce")
def wall_sconce(b: Builder) -> None:
    """A plate on the wall with an arm and a shade or a globe; or a cylinder that lights up and down."""
    d, w, h = b.size
    metal = b.material("metal", "brass", "black steel", "brushed steel", "bronze", "white steel")
    kind = b.pick("kind", ["shade", "globe", "updown"])
    r = min(w / 2, d * 0.4)
    x = d / 2 - r
    with b.solid("sconce"):
        if kind == "updown":
            b.box((-d / 2, -d / 2 + 0.018), (-w * 0.3, w * 0.3), (h * 0.3, h * 0.7), metal)
            b.box((-d / 2 + 0.01, x), (-0.015, 0.015), (h * 0.47, h * 0.53), metal)
            with b.frame(x):
                b.frustum(r, r, (0.003, h - 0.003), metal, 28)
                b.frustum(r - 0.006, r - 0.006, (0.0, 0.01), "lamp glow", 24)
                b.frustum(r - 0.006, r - 0.006, (h - 0.01, h), "lamp glow", 24)
            return
        plate = min(0.05, h * 0.2)
        with b.frame(-d / 2, 0, plate, pitch=math.pi / 2):
            b.frustum(plate, plate * 0.94, (0.0, 0.016), metal, 24, bevel=0.003)
        path = [(-d / 2 + 0.01, 0, plate), (x - 0.04, 0, h * 0.2), (x - 0.01, 0, h * 0.22), (x, 0, h * 0.3)]
        b.tube(path, 0.007, metal, 10)
        with b.frame(x):
            b.lathe([(0.012, h * 0.26), (0.028, h * 0.32), (0.028, h * 0.34)], metal, 16)
            b.frustum(0.012, 0.012, (h * 0.32, h * 0.46), "white plastic", 12)
            if kind == "shade":
                cloth = b.material("shade", *_CLOTH)
                shade(b, r, r * 0.66, (h * 0.42, h), cloth)
            else:
                top = min(r, (h - h * 0.34) / 2)
                b.ball((r, r, top), (0, 0, h - top), "lamp glow", 20)
