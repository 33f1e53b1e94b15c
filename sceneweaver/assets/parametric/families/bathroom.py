"""Toilets, bidets, urinals, basins and vanities."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import basin, bowl, drain, feet, legs, oval, tap, unit, vessel

_METALS = "chrome, black steel, brass, brushed steel"


def _egg(box: Box, middle: float, shares: tuple[float, ...], power: float = 2.2, back: float = 5.0) -> np.ndarray:
    """A ring by shares of what a box has before, behind and beside the depth ``middle``, and its height [m]."""
    before, behind, beside, z = shares
    x = (middle - behind * (middle - box.x[0]), middle + before * (box.x[1] - middle))
    return oval(Box(x, (beside * box.y[0], beside * box.y[1]), box.z), z, power, back, middle)


def _plate(d: Drawing, box: Box, middle: float, look: Look) -> None:
    """A seat or a lid: a flat egg with round edges that fills a box."""
    e, (low, high) = 0.006, box.z
    rings = ((e, low), (0.0, low + e), (0.0, high - e), (e, high))
    d.loft([_egg(box.inset(x=k, y=k), middle, (1.0, 1.0, 1.0, z), back=4.0) for k, z in rings], look, convex=True)


def _bowl(d: Drawing, box: Box, china: Look, seat: Look, hung: bool) -> None:
    """A toilet's bowl with seat and closed lid, square at its back; the lid's top is the box's."""
    lid, box = box, box.inset(front=0.014)  # the lid stands over, so that fingers find its edge
    middle, rim = box.x[0] + 0.52 * box.depth, box.z[1] - 0.042
    foot = [(0.45, 0.75, 0.42, 0.0), (0.62, 0.95, 0.62, 0.05), (0.85, 1.0, 0.85, 0.16), (0.96, 1.0, 0.97, rim - 0.05)]
    if not hung:
        foot = [(0.5, 1.0, 0.62, 0.0), (0.48, 1.0, 0.58, 0.03), (0.46, 0.98, 0.54, 0.14), (0.68, 0.98, 0.74, 0.25)]
        foot.append((0.92, 1.0, 0.95, rim - 0.055))
    d.loft([_egg(box, middle, row) for row in [*foot, (0.97, 1.0, 0.98, rim)]], china)
    plate = box.inset(back=0.055 if hung else 0.115)  # before a cistern, so that the lid can stand up
    _plate(d, plate.to(z=(rim + 0.0005, rim + 0.019)), middle, seat)
    with d.hinge("lid", (plate.x[0], 0.0, rim + 0.02), axis=(0.0, 1.0, 0.0), limits=(-1.5, 0.0), role="lid"):
        cover = plate.to(x=(plate.x[0], lid.x[1]), z=(rim + 0.021, box.z[1])).inset(y=0.002)
        _plate(d, cover, middle, seat)
        x, _, z = cover.anchor("front")
        d.grasp("edge", (x - 0.003, 0.0, z), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), cover.height, 0.1)
    with d.mirror("y"):
        x, z = plate.x[0] - 0.004, rim + 0.009
        d.bar((x, 0.057, z), (x, 0.093, z), 0.008, "chrome", 12)


@draws("toilet")
def toilet(d: Drawing) -> None:
    """A bowl on its foot, seat and lid, and behind them a cistern with its own lid and a push button."""
    box, china = d.bounds, d.material("bowl", "white ceramic")
    wooden = d.style in ("classic", "rustic") and d.chance("wood", 0.6)
    seat = d.pick("seat", ["oak", "walnut"]) if wooden else "white plastic"
    high, tank = d.uniform("seat height", 0.42, 0.45), box.back(0.175)
    with d.part("bowl"):
        _bowl(d, box.inset(back=0.1, y=0.03 * box.width).to(z=(0.0, high)), china, seat, False)
        d.box(tank.share(y=(0.2, 0.8)).to(z=(high - 0.16, high - 0.04)).inset(back=0.012), china, 0.02)
    with d.part("cistern"):
        case = tank.to(z=(high - 0.04, box.z[1] - 0.052))
        d.sections(case, [(0.81, 0.84, 0.0), (0.9, 0.94, 1.0)], china, 0.2, convex=True)
        lid = d.slab(tank.to(z=(case.z[1], box.z[1] - 0.012)), china, 0.035, 0.01)
    with d.part("button"), d.slide("button", (0.0, 0.0, -1.0), (0.0, 0.003), "control"):
        button = lid.top(-0.012).inset(bottom=0.002).place(0.052, 0.052)
        d.cylinder(button, "chrome", ends=(1.0, 0.92), bevel=0.002, segments=20)
        d.print(button.top(0.0).place(0.04, 0.0016), "black steel")
    for name, side in (("top-right", (lid.y[0] + 0.03, -0.03)), ("top-left", (0.03, lid.y[1] - 0.03))):
        d.surface(name, lid.inset(x=0.02).to(y=side))
    d.fit()


@draws("wall_toilet", whole=True)
def wall_toilet(d: Drawing) -> None:
    """A hung bowl with seat and lid; the cistern is in the wall."""
    _bowl(d, d.bounds, d.material("bowl", "white ceramic"), "white plastic", True)


@draws("bidet")
def bidet(d: Drawing) -> None:
    """A low open bowl on a foot, with a mixer at its back."""
    box, h, middle = d.bounds, 0.4, 0.02
    china = d.material("bowl", "white ceramic")
    with d.part("bowl"):
        foot = ((0.5, 1.0, 0.62, 0.0), (0.46, 0.98, 0.54, 0.05), (0.46, 0.98, 0.54, 0.13), (0.74, 0.98, 0.78, 0.25))
        d.loft([_egg(box, middle, row) for row in foot], china)
        outer = ((0.74, 0.98, 0.78, 0.25), (0.95, 1.0, 0.96, 0.33), (1.0, 1.0, 1.0, h - 0.02), (0.985, 0.99, 0.98, h))
        inner = ((0.84, 0.52, 0.8, h - 0.002), (0.79, 0.47, 0.74, 0.34), (0.42, 0.2, 0.36, 0.28))
        vessel(d, [_egg(box, middle, row) for row in outer], [_egg(box, middle, row, back=2.4) for row in inner], china)
        drain(d, (middle + 0.02, 0.0, 0.28), 0.022)
    with d.part("tap"), d.at(box.x[0] + 0.075, 0.0, h - 0.002):
        tap(d, d.material("tap", "chrome, brushed steel, brass"), 0.11, box.height - h)
    d.fit()


@draws("urinal", whole=True)
def urinal(d: Drawing) -> None:
    """A shell that is open in its upper front, with a low lip, a drain and a flush pipe."""
    china, box = d.material("bowl", "white ceramic"), d.bounds
    x, high, (deep, w, h) = box.x[0], box.z[1] - 0.06, box.size

    def ring(reach: float, half: float, z: float, power: float = 2.4) -> np.ndarray:
        return oval(Box((x, x + reach), (-half * w / 2, half * w / 2), box.z), z, power, 8.0, x + 1e-4, 24)

    d.loft([ring(0.45 * deep, 0.4, 0.0), ring(0.75 * deep, 0.72, 0.06), ring(deep, 0.96, 0.17)], china)
    # The lip in front and the side walls that rise to the wall.
    c, s = np.cos(np.linspace(-math.pi / 2, math.pi / 2, 13)).clip(0), np.linspace(-1, 1, 13)
    s = np.sin(s * math.pi / 2)
    rise, rims = 0.86 * high - (0.86 * high - 0.235) * c**0.8, []
    for reach, half, z in ((1.0, 0.96, 0.17), (1.0, 0.98, rise), (0.86, 0.82, 0.165), (0.88, 0.84, rise)):
        px = x + 0.03 + (deep - 0.03) * reach * c ** (2 / 2.4)
        rims.append(np.c_[px, np.sign(s) * half * w / 2 * np.abs(s) ** (2 / 2.4), z + 0 * s])
    for k in range(12):
        d.hull(np.concatenate([rim[k : k + 2] for rim in rims]), china)
    d.silhouette(box.back(0.05).to(z=(0.17, high)), [(0, 0), (1, 0.06), (1, 0.94), (0, 1)], china)
    d.loft([ring(0.05, 1.0, 0.78 * high, 3.0), ring(0.15, 1.0, 0.92 * high, 3.0), ring(0.14, 0.97, high, 3.0)], china)
    drain(d, (x + 0.52 * deep, 0.0, 0.172), 0.03)
    d.bar((x + 0.05, 0.0, high - 0.01), (x + 0.05, 0.0, h), 0.012, "chrome")
    d.bar((x, 0.0, h - 0.025), (x + 0.075, 0.0, h - 0.025), 0.018, "chrome", 12)


def _washbasin(d: Drawing, box: Box, china: Look, square: bool, ledge: float) -> None:
    """A washbasin that fills a box, with a ledge for the tap at its back, open above."""
    power, (low, h), x = 6.0 if square else 2.6, box.z, box.center[0]
    room, outer = box.inset(back=ledge + 0.02, front=0.02, y=0.028), []
    for share, z in ((0.8 if square else 0.45, low), (0.93 if square else 0.82, low + 0.05), (1.0, h - 0.05), (1.0, h)):
        plan = Box((box.x[0], x + share * box.depth / 2), (share * box.y[0], share * box.y[1]), box.z)
        outer.append(oval(plan, z, power, 8.0, x))
    inner = ((1.0, h, power), (0.9, h - 0.05, power), (0.4, h - 0.115, 2.4))
    vessel(d, outer, [oval(room.place(s * room.depth, s * room.width), z, p) for s, z, p in inner], china)
    drain(d, (room.center[0], 0.0, h - 0.115), 0.024)


@draws("pedestal_sink", "wall_basin")
def pedestal_sink(d: Drawing) -> None:
    """A basin with a tap on its ledge, on a waisted column or hung on the wall with its trap below."""
    hung, box, square = d.category.name == "wall_basin", d.bounds, d.chance("square", 0.5)
    china, metal = d.material("bowl", "white ceramic"), d.material("tap", _METALS)
    h = box.z[1] - 0.12 if hung else 0.84
    low = h - (0.165 if hung else 0.18)
    with d.part("basin"):
        _washbasin(d, box.to(z=(low, h)), china, square, 0.09 if hung else 0.1)
    with d.part("trap" if hung else "column"):
        if hung:
            d.cylinder(Box.sized(0.036, 0.036, low - 0.04, (0.0, 0.0, 0.05)), metal, segments=14)
            d.cylinder(Box.sized(0.072, 0.072, 0.075), metal, bevel=0.006, segments=18)
            d.bar((0.0, 0.0, 0.06), (box.x[0], 0.0, 0.06), 0.015, metal, 12)
            d.cylinder(Box.around((box.x[0] + 0.004, 0.0, 0.06), 0.008, 0.06, 0.06), metal, "x", segments=16)
        else:
            rows = ((0.24, 0.0), (0.23, 0.03), (0.17, 0.12), (0.16, 0.45), (0.22, low + 0.02))
            plans = [(Box.sized(size, size, 0.0, (-0.04, 0.0, 0.0)), z) for size, z in rows]
            d.loft([oval(plan, z, 4.0 if square else 2.2, count=24) for plan, z in plans], china)
    with d.part("tap"), d.at(box.x[0] + 0.053, 0.0, h):
        tap(d, metal, 0.115, box.z[1] - h, square=square)
    d.fit()


@draws("vanity", "double_vanity")
def vanity(d: Drawing) -> None:
    """A cabinet with one or two basins set on or into its top, and a tap for each."""
    tones = "white paint, oak, walnut, sage paint, navy paint, light grey paint, light oak, grey paint"
    leaf = d.material("fronts", tones)
    look = d.material("top", "marble, white ceramic, dark marble, oak, granite")
    pull, metal = d.material("pulls", "chrome, black steel, brass"), d.material("tap", _METALS)
    style, panel = d.pick("pull style", ["bar", "knob", "cup"]), leaf if d.style in ("classic", "rustic") else None
    box, count = d.bounds, 2 if d.category.name == "double_vanity" else 1
    on, square, legged = d.chance("vessel", 0.4), d.chance("square", 0.5), d.chance("legs", 0.35)
    bowl, low = 0.13 if on else 0.0, 0.2 if legged else 0.09
    h = min(0.86, box.height - 0.13) - bowl
    slab = box.to(z=(h - 0.03, h)).inset(front=0.004)
    apron = 0.0 if on else 0.13  # a fixed board before basins that are let in
    case = box.to(z=(low, h - 0.03 - apron)).inset(front=0.027)
    half = min(0.25, box.width / count / 2 - 0.07)
    holes = [cell.inset(back=0.12, front=0.07).place(width=2 * half) for cell in slab.columns(count)]
    with d.part("body"):
        if legged:
            legs(d, case.to(z=(0.0, low)).inset(x=0.02, y=0.03), leaf, "square", 0.035)
        else:
            feet(d, case.to(z=(0.0, low)), leaf)
        number = 1 if box.width < 0.95 else 2 if box.width < 1.5 else 3
        for k, cell in enumerate(case.columns(number)):
            layout = "drawers" if number == 3 and k == 1 else d.pick("layout", ["doors", "drawers", "mixed"])
            unit(d, f"unit-{k}", cell, layout, leaf, leaf, pull, style, panel)  # type: ignore[arg-type]
        if on:
            d.box(slab, look)
        else:
            above = case.top(-apron)
            for board in (above.front(0.018), *(b.inset(front=0.018) for b in (above.left(0.018), above.right(0.018)))):
                d.box(board.inset(z=0.001), leaf)
            xs = holes[0].x
            edges = [slab.y[0], *(y for hole in holes for y in hole.y), slab.y[1]]
            strips = [slab.to(x=(slab.x[0], xs[0])), slab.to(x=(xs[1], slab.x[1]))]
            strips += [slab.to(x=xs, y=(edges[k], edges[k + 1])) for k in range(0, len(edges), 2)]
            for strip in strips:
                d.box(strip, look, 0.0)
            for hole in holes:
                basin(d, hole.inset(x=0.002, y=0.002, bottom=-0.1), "white ceramic", 0.03 if square else 0.09)
    if not on:
        with d.part("splash"):
            d.box(slab.back(0.014).top(-0.06), look, 0.002)
    reach = half + 0.02
    for k, hole in enumerate(holes):
        y = hole.center[1]
        if on:
            wide = min(half - 0.03, 0.24 if square else 0.2)
            reach = wide + 0.01
            with d.part(f"bowl {k}"):
                china = d.material("bowl", "white ceramic, white ceramic, dark marble, concrete")
                size = 2 * min(wide, (box.depth - 0.184) / 2)
                dish = Box.sized(size, 2 * wide, bowl, (0.04, y, h))
                _washbowl(d, dish, china, 5.0 if square else 2.0)
        with d.part(f"tap {k}"), d.at(box.x[0] + 0.05, y, h):
            tap(d, metal, 0.15, box.z[1] - h, square=square, name=f"tap-{k}")
    middles = [hole.center[1] for hole in holes]
    edges = [box.y[0] + 0.01, *(m + s * reach for m in middles for s in (-1, 1)), box.y[1] - 0.01]
    names = ("top-right", "top-left") if count == 1 else ("top-right", "top-middle", "top-left")
    spans = [(edges[2 * k], edges[2 * k + 1]) for k in range(len(names))]
    free = slab.inset(back=0.02, front=0.01)
    rooms = [(name, free.to(y=y)) for name, y in zip(names, spans, strict=True) if y[1] - y[0] > 0.08]
    if not rooms and not on:  # a narrow one has its soap beside the tap
        shelf = slab.to(x=(slab.x[0] + 0.016, holes[0].x[0] - 0.02)).inset(y=0.01)
        rooms = [("top-right", shelf.to(y=(shelf.y[0], -0.05))), ("top-left", shelf.to(y=(0.05, shelf.y[1])))]
    for name, room in rooms:
        d.surface(name, room)
    d.fit()


def _washbowl(d: Drawing, box: Box, china: Look, power: float) -> None:
    """A bowl that stands on a top and fills a box."""
    low, high = box.z
    outer = ((0.6, 0.6, low), (0.9, 0.9, low + 0.05), (1.0, 1.0, high))
    inner = ((0.94, 0.94, high), (0.84, 0.84, low + 0.05), (0.3, 0.3, low + 0.014, 2.4))
    bowl(d, box, outer, inner, china, power)
    drain(d, (box.center[0], box.center[1], low + 0.014), 0.022)
