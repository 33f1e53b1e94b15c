"""Lamps that stand on the floor or on furniture."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .lighting_parts import across, foot, globe, shade, shell

_CLOTH = ("lit shade", "white fabric", "beige fabric", "rust fabric", "green fabric", "charcoal fabric")


@draws("floor_lamp")
def floor_lamp(b: Builder) -> None:
    """A pole on a round foot with a cloth shade, a globe, a bowl that lights the ceiling, or a paper column."""
    r, h = across(b) / 2, b.size.height
    kind = b.pick("kind", ["drum", "cone", "globe", "bowl", "column"])
    metal = b.material("pole", "black steel", "brass", "chrome", "white steel", "bronze")
    if kind == "column":
        wood = b.material("frame", "walnut", "oak", "black steel")
        half = r - 0.012
        with b.solid("column"):
            b.box((-r, r), (-r, r), (0.0, 0.03), wood)
            b.box((-r, r), (-r, r), (h - 0.025, h), wood)
            b.box((-half, half), (-half, half), (0.03, h - 0.025), "lit shade", bevel=0.0)
            for sx in (-1, 1):
                for sy in (-1, 1):
                    x, y = sx * (r - 0.009), sy * (r - 0.009)
                    b.box((x - 0.009, x + 0.009), (y - 0.009, y + 0.009), (0.03, h - 0.025), wood, bevel=0.001)
            bars = b.whole("bars", 3, 6)
            for k in range(1, bars):
                z = 0.03 + k * (h - 0.055) / bars
                b.box((-r + 0.004, r - 0.004), (-r + 0.004, r - 0.004), (z - 0.006, z + 0.006), wood, bevel=0.001)
        return
    with b.solid("foot"):
        foot(b, min(r, 0.155) if kind != "bowl" else min(r, 0.14), 0.025, metal)
    tall = min(0.3, h * b.uniform("shade height", 0.15, 0.19))
    top = h - tall - 0.02 if kind in ("drum", "cone") else h - 0.1
    with b.solid("pole"):
        b.frustum(0.011, 0.009, (0.02, top + 0.03), metal, segments=16)
        b.frustum(0.016, 0.016, (top * 0.5, top * 0.5 + 0.03), metal, segments=16, bevel=0.003)
    with b.solid("shade"):
        if kind in ("drum", "cone"):
            cloth = b.material("shade", *_CLOTH)
            upper = r if kind == "drum" else r * b.uniform("taper", 0.5, 0.72)
            shade(b, r, upper, (h - tall - 0.012, h - 0.012), cloth)
            b.frustum(0.02, 0.02, (top - 0.03, h - tall), metal, segments=16)
            b.lathe([(0.008, h - 0.02), (0.012, h - 0.006), (0.0, h)], metal, 12)
        elif kind == "globe":
            globe(b, r, h - r)
            b.lathe([(0.012, h - 2 * r - 0.03), (r * 0.42, h - 2 * r + 0.005), (r * 0.55, h - 1.85 * r)], metal, 20)
            b.frustum(0.011, 0.011, (h - 2 * r - 0.3, h - 2 * r), metal, segments=16)
        else:
            b.lathe(
                [(0.014, h - 0.16), (0.05, h - 0.13), (r * 0.75, h - 0.05), (r, h - 0.004), (r, h - 0.002)],
                b.material("bowl", "frosted glass", "white steel", "brass", "black steel"),
                32,
            )
            b.frustum(r - 0.006, r - 0.006, (h - 0.01, h), "lamp glow", 32)


@draws("arc_lamp")
def arc_lamp(b: Builder) -> None:
    """A heavy foot at the back, an upright, a wide arc, and a bell that hangs far in front."""
    d, w, h = b.size
    metal = b.material("arc", "chrome", "brass", "black steel", "brushed steel")
    stone = b.material("foot", "marble", "dark marble", "concrete")
    bell = w / 2 * b.uniform("bell", 0.7, 0.84)
    base = w / 2
    # The arc is a quarter and more of an ellipse from the upright to the bell.
    x0, x1 = base, d - bell
    rise = h * b.uniform("upright", 0.42, 0.55)
    with b.solid("foot"):
        if b.chance("round foot", 0.5):
            with b.frame(base):
                b.frustum(base, base, (0.0, 0.12), stone, 32, bevel=0.006)
        else:
            b.box((0.0, 2 * base), (-base, base), (0.0, 0.11), stone, bevel=0.005)
    with b.solid("upright"):
        b.bar((x0, 0, 0.1), (x0, 0, rise), 0.013, metal, 14)
        with b.frame(x0):
            b.frustum(0.022, 0.018, (0.1, 0.16), metal, 16, bevel=0.003)
            b.frustum(0.019, 0.019, (rise - 0.04, rise + 0.02), metal, 16, bevel=0.003)
    end = math.radians(18)
    ax = (x1 - x0) / (1 + math.sin(math.pi / 2 - end))
    az = h - 0.009 - rise
    path = [(x0 + ax - ax * math.cos(a), 0.0, rise + az * math.sin(a)) for a in np.linspace(0, math.pi - end, 15)]
    half = 8
    with b.solid("rise"):
        b.tube(path[:half], 0.009, metal, 10)
    with b.solid("reach"):
        b.tube(path[half - 1 :], 0.009, metal, 10)
    tip = path[-1][2]
    high = bell * b.uniform("depth", 0.75, 0.95)
    with b.solid("bell"), b.frame(path[-1][0], 0.0, tip - high - 0.06):
        b.frustum(0.006, 0.006, (high, high + 0.068), metal, 10)
        b.lathe([(bell * 0.3, high - 0.012), (0.03, high + 0.012), (0.016, high + 0.035)], metal, 20)
        curve = [(bell * math.cos(a), high * math.sin(a)) for a in np.linspace(0, math.radians(75), 4)]
        shell(b, curve, 0.002, metal, 24, 12)
        b.ball((0.035, 0.035, 0.04), (0, 0, high * 0.45), "lamp glow", 12)
        b.frustum(0.02, 0.02, (high * 0.6, high), "black plastic", 12)


@draws("tripod_lamp")
def tripod_lamp(b: Builder) -> None:
    """Three leaning wooden legs that meet in a hub, with a drum of cloth on it."""
    w, h = across(b), b.size.height
    wood = b.material("legs", "oak", "walnut", "beech", "black steel", "light oak")
    metal = b.material("hub", "brass", "black steel", "brushed steel")
    cloth = b.material("shade", *_CLOTH)
    spread = (w - 0.02) / 1.7321
    tall = b.uniform("shade height", 0.24, 0.30)
    hub = h - tall - b.uniform("neck", 0.04, 0.1)
    with b.solid("legs"):
        for k in range(3):
            a = k * 2 * math.pi / 3
            c, s = math.cos(a), math.sin(a)
            b.hull(
                [(spread * c + 0.010 * u, spread * s + 0.010 * v, 0.0) for u, v in _OCTAGON]
                + [(0.032 * c + 0.014 * u, 0.032 * s + 0.014 * v, hub) for u, v in _OCTAGON],
                wood,
            )
        if b.chance("brace", 0.6):
            share = 0.38
            r = spread * (1 - share) + 0.032 * share
            ring = [(r * math.cos(a), r * math.sin(a), hub * share) for a in (0, 2 * math.pi / 3, 4 * math.pi / 3)]
            for p in ring:
                b.bar((0, 0, hub * share), p, 0.005, metal, 8)
            with b.frame(0, 0, hub * share):
                b.frustum(0.014, 0.014, (-0.012, 0.012), metal, 12)
        b.frustum(0.055, 0.055, (hub - 0.02, hub + 0.012), metal, 20, bevel=0.003)
        b.frustum(0.012, 0.012, (hub, h - tall * 0.5), metal, 12)
    radius = w * b.uniform("shade", 0.36, 0.43)
    with b.solid("shade"):
        shade(b, radius, radius * b.uniform("taper", 0.82, 1.0), (h - tall, h), cloth)


_OCTAGON = [(math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)) for k in range(8)]


@draws("table_lamp")
def table_lamp(b: Builder) -> None:
    """A turned, ceramic or metal body under a cloth shade; or a mushroom of glass."""
    r, h = across(b) / 2, b.size.height
    kind = b.pick("kind", ["gourd", "bottle", "sphere", "stick", "mushroom", "stack"])
    if kind == "mushroom":
        body = b.material("body", "brass", "white steel", "black steel", "orange plastic", "teal paint")
        cap = h * 0.42
        with b.solid("lamp"):
            b.lathe(
                [(r * 0.62, 0), (r * 0.66, 0.012), (r * 0.3, 0.05), (r * 0.2, h * 0.3), (r * 0.24, h - cap + 0.01)],
                body,
                28,
            )
            b.lathe([(r * 0.86, h - cap - 0.012), (r * 0.9, h - cap + 0.004)], "lamp glow", 32)
            b.lathe(
                [(r * 0.97, h - cap), (r, h - cap + 0.008)]
                + [
                    (r * math.cos(a), h - cap + 0.008 + (cap - 0.008) * math.sin(a))
                    for a in np.linspace(0.2, math.pi / 2 - 0.1, 6)
                ]
                + [(0.0, h)],
                "lit shade" if b.chance("lit", 0.5) else body,
                32,
            )
        return
    body = b.material("body", "@ceramic", "oak", "walnut", "brass", "glass", "concrete", "bronze")
    metal = b.material("fittings", "brass", "black steel", "brushed steel")
    tall = h * b.uniform("shade height", 0.38, 0.46)
    neck = h - tall - 0.02
    top = neck - 0.03
    k = r * b.uniform("girth", 0.5, 0.66)
    with b.solid("lamp"):
        if kind == "stack":
            b.box((-k, k), (-k, k), (0.0, 0.022), metal)
            for low, high, share in ((0.022, 0.36, 0.62), (0.36, 0.7, 0.85), (0.7, 1.0, 0.55)):
                z0, z1 = max(0.022, low * top), high * top
                b.ball((k * share, k * share, (z1 - z0) / 2), (0, 0, (z0 + z1) / 2), body, 20)
        else:
            profile = {
                "gourd": [
                    (0.62, 0.0),
                    (0.66, 0.03),
                    (0.95, 0.2),
                    (1.0, 0.34),
                    (0.86, 0.5),
                    (0.52, 0.62),
                    (0.42, 0.68),
                    (0.5, 0.78),
                    (0.48, 0.88),
                    (0.22, 1.0),
                ],
                "bottle": [(0.8, 0.0), (0.86, 0.03), (0.9, 0.4), (0.86, 0.55), (0.6, 0.7), (0.32, 0.8), (0.24, 1.0)],
                "sphere": [
                    (0.7, 0.0),
                    (0.7, 0.05),
                    (0.4, 0.09),
                    (0.34, 0.13),
                    (0.75, 0.24),
                    (1.0, 0.45),
                    (1.0, 0.58),
                    (0.78, 0.8),
                    (0.4, 0.93),
                    (0.2, 1.0),
                ],
                "stick": [
                    (1.0, 0.0),
                    (1.0, 0.06),
                    (0.9, 0.085),
                    (0.3, 0.12),
                    (0.2, 0.16),
                    (0.22, 0.5),
                    (0.32, 0.54),
                    (0.22, 0.6),
                    (0.2, 0.92),
                    (0.26, 1.0),
                ],
            }[kind]
            b.lathe([(k * u, top * v) for u, v in profile], body, 28)
        b.frustum(0.012, 0.012, (top - 0.01, neck + tall * 0.3), metal, 12)
        b.frustum(0.02, 0.018, (top - 0.004, top + 0.018), metal, 16)
        cloth = b.material("shade", *_CLOTH)
        shade(b, r, r * b.uniform("taper", 0.55, 1.0), (h - tall - 0.012, h - 0.012), cloth)
        b.lathe([(0.005, h - 0.02), (0.008, h - 0.005), (0.0, h)], metal, 12)


@draws("desk_lamp")
def desk_lamp(b: Builder) -> None:
    """A weighted foot, two arms with springs and joints, and a bell that looks down in front."""
    d, w, h = b.size
    metal = b.material(
        "lamp", "black steel", "white steel", "red paint", "teal paint", "aluminium", "yellow paint", "sage paint"
    )
    joint = b.material("joints", "chrome", "black plastic", "brass")
    base = w / 2
    bell = base * b.uniform("bell", 0.62, 0.8)
    x0, z0 = -base * 0.2, 0.055
    tilt = 0.45
    tip = (d - base - 1.54 * bell, 0.0, h * b.uniform("head", 0.74, 0.84))
    elbow = (-base * 0.6, 0.0, h - 0.0115)
    with b.solid("foot"):
        b.lathe(
            [(base - 0.003, 0), (base, 0.004), (base, 0.026), (base - 0.006, 0.033), (0.03, 0.036), (0.018, 0.05)],
            metal,
            32,
        )
    with b.solid("arms"):
        for y in (-0.011, 0.011):
            b.bar((x0, y, z0), (elbow[0], y, elbow[2]), 0.0042, metal, 8)
            b.bar((elbow[0], y, elbow[2]), (tip[0], y, tip[2]), 0.0042, metal, 8)
        b.bar((-base * 0.1, 0, 0.03), (x0, 0, z0), 0.009, metal, 10)
        low = np.array((x0, 0.0, z0))
        span = np.array(elbow) - low
        b.bar(low + 0.05 * span, low + 0.4 * span, 0.006, joint, 8)
        for at in ((x0, z0), (elbow[0], elbow[2]), (tip[0], tip[2])):
            with b.frame(at[0], 0.0, at[1], roll=math.pi / 2):
                b.frustum(0.0115, 0.0115, (-0.017, 0.017), joint, 14, bevel=0.002)
    with b.solid("head"), b.frame(tip[0], 0.0, tip[2], pitch=-tilt):
        long = bell * 1.45
        outer = [(bell, -long), (bell * 0.88, -long * 0.62), (bell * 0.5, -long * 0.28), (0.02, -long * 0.2)]
        shell(b, outer, 0.002, metal, 24, 12)
        b.lathe([(0.024, -long * 0.24), (0.022, 0.018), (0.014, 0.024)], metal, 20)
        b.ball((bell * 0.42, bell * 0.42, bell * 0.42), (0, 0, -long * 0.5), "lamp glow", 12)


@draws("lantern")
def lantern(b: Builder) -> None:
    """A square or six-sided lantern of glass between posts, with a roof, a ring, and a candle that burns."""
    r, h = across(b) / 2, b.size.height
    metal = b.material("frame", "black steel", "white paint", "copper", "iron", "oak")
    body = h * b.uniform("body", 0.6, 0.66)
    sides = b.pick("sides", [4, 4, 6])
    r = r if sides == 4 else r * 0.866
    inner = r * 0.86

    def ring(radius: float) -> np.ndarray:
        # Flats stand across x and y, so that the lantern is two radii deep.
        a = (np.arange(sides) + 0.5) * (2 * np.pi / sides)
        return np.c_[np.cos(a), np.sin(a)] * radius / math.cos(math.pi / sides)

    with b.solid("lantern"):
        b.extrude(ring(r), (0.0, 0.016), metal, bevel=0.003)
        b.extrude(ring(r * 0.97), (body, body + 0.014), metal, bevel=0.003)
        corners = ring(inner)
        for x, y in corners:
            b.box((x - 0.006, x + 0.006), (y - 0.006, y + 0.006), (0.016, body), metal, bevel=0.001)
        b.extrude(ring(inner), (0.016, body), "glass")
        for k in range(sides):
            p, q = corners[k], corners[(k + 1) % sides]
            z = 0.016 + 0.72 * (body - 0.016)
            b.bar((*p, z), (*q, z), 0.003, metal, 6)
        b.frustum(inner * 0.42, inner * 0.42, (0.017, body * 0.45), "candle wax", 20, bevel=0.003)
        b.lathe([(0.001, body * 0.45), (0.008, body * 0.5), (0.005, body * 0.55), (0.0, body * 0.62)], "flame", 10)
        roof = body + (h - body) * 0.52
        b.add(_roof(ring(r * 0.92), body + 0.014, ring(0.02), roof), metal)
        b.frustum(0.016, 0.02, (roof, roof + 0.016), metal, 12)
        loop = (h - roof - 0.012) / 2
        turn = [
            (0.0, loop * math.cos(a), roof + 0.012 + loop + loop * math.sin(a)) for a in np.arange(12) * (math.pi / 6)
        ]
        b.tube(
            [
                (x, y * (1 - 0.003 / loop), roof + 0.012 + loop + (z - roof - 0.012 - loop) * (1 - 0.003 / loop))
                for x, y, z in turn
            ],
            0.003,
            metal,
            6,
            closed=True,
        )


def _roof(low: np.ndarray, z0: float, high: np.ndarray, z1: float):
    points = [(x, y, z0) for x, y in low] + [(x, y, z1) for x, y in high]
    return shapes.hull(np.array(points))


@draws("night_light")
def night_light(b: Builder) -> None:
    """A small glowing ball or moon on a wooden stand."""
    r, h = across(b) / 2, b.size.height
    wood = b.material("stand", "light oak", "white plastic", "walnut", "pine")
    k = min(r, (h - 0.02) / 2)
    with b.solid("light"):
        b.lathe([(k * 0.6, 0), (k * 0.62, 0.006), (k * 0.5, 0.02), (k * 0.55, h - 2 * k + 0.18 * k)], wood, 24)
        b.ball((r, r, k), (0, 0, h - k), "lamp glow", 20)


@draws("string_lights")
def string_lights(b: Builder) -> None:
    """A hanging cord with many small bulbs, in bows along the wall."""
    d, w, h = b.size
    cord = b.material("cord", "black plastic", "white plastic", "green plastic")
    bulb = d / 2
    bows = max(2, round(w))
    span = (w - 2 * bulb) / bows
    sag = h - 3.1 * bulb - 0.008
    with b.solid("string"):
        for k in range(bows):
            y0 = -w / 2 + bulb + k * span
            t = np.linspace(0, 1, 9)
            path = np.c_[np.zeros(9), y0 + t * span, h - 0.006 - sag * 4 * t * (1 - t)]
            b.tube(path, 0.003, cord, 6)
            for i in range(1, 9, 2) if k else range(0, 9, 2):
                _, y, z = path[i]
                with b.frame(0, y, z):
                    cap = shapes.frustum(bulb * 0.5, bulb * 0.5, (-bulb * 1.2, 0.004), 8)
                    light = shapes.ball((bulb, bulb, bulb * 1.25), (0, 0, -bulb * 1.75), 10)
                    b.add(cap, cord, hulls=[])
                    b.add(light, "lamp glow", [shapes.hull_of([cap, light])])
        for k in range(bows + 1):
            y = -w / 2 + bulb + k * span
            b.bar((-d / 2, y, h - 0.006), (0.003, y, h - 0.006), 0.006, "white plastic", 8)
