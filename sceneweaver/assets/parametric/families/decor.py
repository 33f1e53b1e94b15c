"""Vases, candles, bowls and trays, frames and bookends."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import art, frame
from .plants_parts import leaves

GLAZES = (
    "white ceramic, blue ceramic, terracotta, grey ceramic, cream ceramic, glass, sage paint, dark marble, black paint"
)
PROFILES = (
    [(0.5, 0.0), (0.56, 0.02), (0.9, 0.3), (1.0, 0.5), (0.86, 0.72), (0.42, 0.88), (0.4, 0.92), (0.52, 1.0)],
    [(0.7, 0.0), (0.74, 0.02), (1.0, 0.18), (0.98, 0.34), (0.55, 0.58), (0.3, 0.72), (0.28, 0.92), (0.4, 1.0)],
    [(0.66, 0.0), (0.7, 0.02), (0.72, 0.5), (0.8, 0.75), (1.0, 1.0)],
    [(0.6, 0.0), (0.64, 0.02), (0.84, 0.22), (1.0, 0.5), (0.96, 0.68), (0.66, 0.86), (0.5, 0.94), (0.58, 1.0)],
    [(0.86, 0.0), (0.92, 0.02), (1.0, 0.1), (1.0, 0.86), (0.9, 0.93), (0.6, 0.96), (0.6, 1.0)],
)


def _vessel(d: Drawing, box: Box, floor: float = 0.06) -> None:
    """A vase of glaze or glass that fills a box, some with a band of another finish; hollow down to a share of it."""
    look, profile = d.material("glaze", GLAZES), d.pick("profile", PROFILES)
    radii, heights = np.array(profile).T
    bore = float(np.interp(np.linspace(floor, 1.0, 15), heights, radii).min())
    bore -= 0.01 / box.width
    lip = profile[-1][0] - max(0.008 / box.width, 0.04)
    with d.part("vase"):
        d.turned(box, [*profile, (lip, 1.0), (bore, 0.97), (bore, floor)], look, 32, hollow=True, holds=floor < 0.5)
        if d.chance("band", 0.35) and not look.called("glass"):
            ring = [(r + 0.0008 / box.width, z) for r, z in profile[1:3]]
            d.turned(box, ring, d.material("band", "brass, white ceramic, ink pigment"), 32)


@draws("vase")
def vase(d: Drawing) -> None:
    """A vase turned in one of five profiles."""
    _vessel(d, d.even("round"))


@draws("floor_vase")
def floor_vase(d: Drawing) -> None:
    """A tall vase for the floor with dry pampas stalks."""
    box = d.even("round")
    r, high = box.width / 2, box.height
    _vessel(d, box.share(z=(0.0, 0.56)), 0.86)
    turn = np.arange(30)
    with d.part("stalks"):
        for n in range(7):
            a, out = 2.399 * n, (0.3 + 0.1 * (n % 3)) * r
            top = (0.97 - 0.03 * n) * high
            tip = np.array([out * math.cos(a), out * math.sin(a), top])
            foot = np.array([0.0, 0.0, 0.48 * high])
            d.sweep([foot, 0.5 * (foot + tip) + (0, 0, 0.02), tip], 0.003, "wicker", 5)
            t = np.linspace(0.0, 1.0, len(turn))[:, None]
            base = tip * (0.86 + 0.1 * t)
            long = 0.3 * r + 0.06 * high * np.sin(math.pi * (0.25 + 0.7 * t[:, 0]))
            points, faces = leaves(base, 2.4 * turn, 1.2, 0.9, 0.75 * long, 0.018, (0.4, 1, 0.2), 0.0, 0.003, rib=False)
            every = (faces[None] + points.shape[1] * turn[:, None, None]).reshape(-1, 3).astype(np.int32)
            plume = points.reshape(-1, 3)
            d.add((plume, every), "sand pigment", [shapes.hull(plume)])
    d.fit(box.size)


def _flame(d: Drawing, at: Box, size: float = 0.03) -> None:
    """A wick and its flame on top of a candle; the wick alone where it is out, drips where it is burnt down."""
    x, y, z = at.anchor("top")
    d.bar((x, y, z - 0.002), (x, y, z + 0.006), 0.0012, "black plastic", 6)
    if d.takes("burnt_down"):
        wax = d.material("wax", "candle wax, white paint")
        for k in range(5):
            a, long = 2.4 * k, (0.5 + 0.1 * (k % 3)) * at.height
            side = (x + 0.5 * at.depth * math.cos(a), y + 0.5 * at.width * math.sin(a), z - long / 2)
            d.ball(Box.around(side, 0.008, 0.008, long), wax, 8)
    if d.takes("unlit"):
        return
    flame = Box.sized(0.48 * size, 0.48 * size, size - 0.003, (x, y, z + 0.003))
    d.turned(flame, [(0.1, 0), (1, 0.36), (0.66, 0.66), (0, 1)], "flame", 10)


@draws("candle")
def candle(d: Drawing) -> None:
    """A pillar candle, one in a glass or a tin, or three on a plate, that burn."""
    box = d.even("round")
    kind = d.pick("kind", ["pillar", "jar", "group"])
    wax = d.material("wax", "candle wax, white paint, rose fabric, sage paint")
    with d.part("candle"):
        if kind == "jar":
            jar = box.share(z=(0.0, 0.8))
            wall = 1 - 0.006 / box.width
            look = d.material("jar", "glass, grey ceramic, brass, white ceramic")
            d.turned(jar, [(0.94, 0), (1, 0.05), (1, 1), (wall, 1), (wall, 0.75)], look, 28, hollow=True, holds=False)
            fill = d.cylinder(jar.inset(x=0.004, y=0.004, bottom=0.006).share(z=(0.0, 0.76)), wax)
            _flame(d, fill, box.z[1] - fill.z[1])
            return
        metal = "brass, black steel, oak" if kind == "pillar" else "oak, marble, black steel"
        plate = d.cylinder(box.bottom(0.009), d.material("plate", metal), bevel=0.003, segments=28)
        room = box.inset(bottom=plate.z[1] - 0.001, top=0.035)
        group = ((0.4, 1.0, 0.4), (2.5, 0.72, 0.36), (4.6, 0.5, 0.38)) if kind == "group" else ((0.0, 1.0, 0.8),)
        out = 0.52 * box.width / 2 if kind == "group" else 0.0
        for a, tall, size in group:
            own = room.share(z=(0.0, tall)).place(size * box.depth, size * box.width)
            stick = d.cylinder(own.move(out * math.cos(a), out * math.sin(a)), wax, bevel=0.004)
            _flame(d, stick, 0.035)


@draws("candlestick")
def candlestick(d: Drawing) -> None:
    """A turned stick with a slim candle."""
    box = d.even("round")
    metal = d.material("metal", "brass, black steel, chrome, oak, copper")
    stick = box.share(z=(0.0, d.uniform("stick", 0.45, 0.58)))
    shape = [(1, 0), (1, 0.05), (0.82, 0.1), (0.3, 0.2), (0.18, 0.35), (0.34, 0.45), (0.2, 0.55), (0.16, 0.85)]
    with d.part("candlestick"):
        d.turned(stick, [*shape, (0.44, 0.94), (0.44, 1.0)], metal, 28)
        slim = box.place(0.022, 0.022).inset(bottom=stick.z[1] - 0.005, top=0.03)
        d.cylinder(slim, d.material("candle", "candle wax, white paint, red paint"), ends=(1.0, 0.82), segments=14)
        _flame(d, slim)


@draws("decorative_bowl")
def decorative_bowl(d: Drawing) -> None:
    """A wide bowl on a foot ring, with balls in it."""
    box = d.even("round")
    look = d.material(
        "bowl", "white ceramic, blue ceramic, terracotta, grey ceramic, cream ceramic, oak, walnut, brass"
    )
    balls = d.material("balls", "moss pigment, brass, bark, walnut")  # pale ones look like eggs
    outer = [(0.36, 0), (0.38, 0.08), (0.72, 0.34), (0.93, 0.67), (1, 0.86)]
    inner = [(1 - 0.01 / box.width, 0.86), (0.9, 0.67), (0.68, 0.38), (0.3, 0.16)]
    with d.part("bowl"):
        d.turned(box, [*outer, *inner], look, 36, hollow=True, holds=False)
        size = min(0.3 * box.width, 0.8 * box.height)
        for k, a in enumerate((0.3, 2.4, 4.5)):
            out = 0.6 * size
            at = box.place(size, size, size, at="top").move(out * math.cos(a), out * math.sin(a), -0.006 * (k + 1))
            d.ball(at, balls, segments=14)
        d.ball(box.place(0.7 * size, 0.7 * size, 0.7 * size, at="top"), balls, segments=14)


@draws("decorative_tray")
def decorative_tray(d: Drawing) -> None:
    """A tray with a rim and two handles."""
    look = d.material("tray", "walnut, oak, white paint, black paint, rattan, marble")
    metal = d.material("handles", "brass, black steel, copper")
    box = d.bounds
    rim = box.share(z=(0.0, 0.62)).inset(bottom=0.006)
    with d.part("tray"):
        floor = d.box(box.bottom(0.008), look, 0.002)
    for k, side in enumerate((rim.front(0.008), rim.back(0.008))):
        with d.part(f"long rim {k}"):
            d.box(side, look, 0.002)
    for k, side in enumerate((rim.left(0.008), rim.right(0.008))):
        with d.part(f"rim {k}"):
            d.box(side.inset(x=0.008), look, 0.002)
            y, low, top = side.center[1], rim.z[1] - 0.004, box.z[1] - 0.0045
            grip = [(-0.2, low), (-0.18, top), (0.18, top), (0.2, low)]
            d.sweep([(x * box.depth, y, z) for x, z in grip], 0.0038, metal, 8)
    d.interior("inside", floor.inset(x=0.009, y=0.009).to(z=(floor.z[1], rim.z[1])))
    d.surface("top", floor, inset=0.012)


@draws("picture_frame")
def picture_frame(d: Drawing) -> None:
    """A small framed photograph that leans on its own foot."""
    deep, wide, high = d.size
    wood = d.material("frame", "brass, oak, black paint, white paint, walnut, chrome")
    rng = np.random.default_rng(d.integer("art", 0, 2**31 - 1))
    lean, thick, bar = math.atan2(0.42 * deep, high), 0.014, d.uniform("bar", 0.012, 0.02)
    with d.part("frame"):
        with d.at(deep / 2 - thick, pitch=-lean):
            body = Box((0.0, thick), (-wide / 2, wide / 2), (0.0, (high - thick * math.sin(lean)) / math.cos(lean)))
            inside = frame(d, body, wood, bar, 0.003)
            sheet = d.box(inside.back(thick / 2), "paper", 0.0)
            art(d, sheet.front(-0.003).inset(y=0.014, z=0.014), rng, d.pick("photo", ["hills", "sea", "leaves"]))
        top = 0.6 * high
        ends = ((0.004 - deep / 2, 0.0), (deep / 2 - thick - math.tan(lean) * top, top))
        d.hull([(x + e, y, z) for x, z in ends for e in (-0.003, 0.003) for y in (-0.02, 0.02)], "black paint")


@draws("bookend")
def bookend(d: Drawing) -> None:
    """An angle with a weight on it: an arch, a ball on steps, or a block cut aslant."""
    look = d.material("body", "marble, brass, black steel, walnut, concrete, dark marble")
    kind = d.pick("kind", ["arch", "ball", "wedge"])
    box = d.bounds
    with d.part("bookend"):
        if kind == "wedge":
            d.silhouette(box, [(0, 0), (1, 0), (1, 0.3), (0.03 / box.width, 1), (0, 1)], look, "x", bevel=0.002)
        elif kind == "ball":
            d.box(box.bottom(0.016), look)
            d.box(box.right(0.014).inset(bottom=0.016), look)
            room = box.inset(right=0.014, bottom=0.015)
            size = 0.94 * min(room.depth, room.width)
            d.ball(room.place(size, size, size, at="right bottom"), d.material("ball", "brass, marble, oak"))
        else:
            d.box(box.right(0.02), look)
            t = np.linspace(0, np.pi / 2, 9)
            arc = np.c_[np.cos(t), 0.92 * np.sin(t)]
            d.silhouette(box.inset(right=0.02, x=0.01), [*arc, *(0.5 * arc)[::-1]], look, "x")
