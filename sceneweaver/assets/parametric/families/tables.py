"""Tables to eat and meet at."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, draws
from ...drawing.components import beam, legs, walls
from .tables_parts import LEGS, end_frame, pedestal, planks, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "pine", "cherry", "ash grey wood", "mahogany", "wenge")
METALS = ("black steel", "white steel", "brushed steel", "black paint")
KNEES = 0.62
"""Height [m] that stays free for knees."""


@draws("dining_table")
def dining_table(d: Drawing) -> None:
    """A rectangular top of wood, boards, glass or marble on legs with an apron, end frames or trestles."""
    base = d.pick("base", [*LEGS, "loop", "vee", "cross", "a", "trestle"])
    steel, railed = base in ("vee", "loop"), base in ("cross", "a", "trestle")
    top = d.material("top", *WOODS, *(("glass", "marble") if steel else ("white paint",)))
    look = top
    if steel or d.chance("painted", 0.3):
        look = d.material("legs", *(METALS if steel else ("white paint", "cream paint", "black paint")))
    glass, bounds = top.name == "glass", d.bounds
    plate = bounds.top(0.012 if glass else d.uniform("thickness", 0.024, 0.038))
    under = bounds.to(z=(0.0, plate.z[0]))
    low = under.height
    with d.part("top"):
        if base in ("turned", "square") or railed and d.chance("boards", 0.75):
            planks(d, plate, top, d.pick("ends", [0.0, 0.1]))
        elif base in ("splayed", "vee", "tapered"):
            edge = "soft" if glass else d.pick("edge", ["soft", "knife"])
            tabletop(d, plate, top, d.pick("corner", [0.03, 0.08, 0.2]), edge=edge)
        else:
            tabletop(d, plate, top)
        if base in LEGS:
            inset = 0.16 if base == "splayed" else 0.035
            walls(d, under.inset(x=inset, y=inset).top(min(0.085, low - 0.625)), look)
    if base in LEGS:
        legs(d, under.inset(x=0.03, y=0.03), look, base, LEGS[base])
    else:
        bar = {"loop": 0.05, "vee": 0.05, "cross": 0.07, "a": 0.065, "trestle": 0.08}[base]
        at = bounds.y[1] - d.uniform("overhang", 0.12, 0.3)
        with d.mirror("y"), d.part("end"):
            end_frame(d, under.inset(x=0.07).to(y=(at - bar / 2, at + bar / 2)), look, base)
        if railed or glass:
            height = {"trestle": 0.14, "a": 0.29, "cross": 0.5 * low}.get(base, low - 0.02)
            with d.part("rail" if railed else "top"):
                reach, thick = at - bar / 2, 0.08 if railed else 0.03
                beam(d, (0.0, -reach, height), (0.0, reach, height), look, 0.06, thick)
    if not railed:
        d.clear(bounds.inset(y=0.32).to(z=(0.0, KNEES)))
    for side in (bounds.front(bounds.depth / 2 - 0.06), bounds.back(bounds.depth / 2 - 0.06)) if railed else ():
        d.clear(side.inset(y=0.36).to(z=(0.0, KNEES)))


@draws("round_dining_table")
def round_dining_table(d: Drawing) -> None:
    """A round top on a tulip foot, a turned column with claws, a drum, a cross, or four legs."""
    base = d.pick("base", ["tulip", "claw", "drum", "cross", "splayed", "tapered"])
    tops = {
        "tulip": ("marble", "white paint", "dark marble", "oak", "walnut"),
        "drum": ("oak", "walnut", "marble"),
        "cross": ("glass", "black paint", "oak", "white paint"),
    }
    feet = {"tulip": ("white paint", "black paint", "white steel"), "cross": ("black steel", "brushed steel", "chrome")}
    top = d.material("top", *tops.get(base, WOODS))
    glass, wide = top.name == "glass", min(d.size[:2])
    if base in feet:
        look = d.material("foot", *feet[base])
    else:
        look = d.material("foot", "white paint", "cream paint", "black paint") if d.chance("painted", 0.3) else top
        if look.name in ("marble", "dark marble", "glass"):
            look = d.material("column", "oak", "walnut", "black paint")
    plate = Box.sized(wide, wide, d.size.height).top(0.012 if glass else d.uniform("thickness", 0.022, 0.034))
    low = plate.z[0]
    with d.part("top"):
        edge = "soft" if glass or base == "claw" else d.pick("edge", ["soft", "knife"])
        tabletop(d, plate, top, power=2.0, edge=edge)
        if base in ("splayed", "tapered", "claw"):
            frame = plate.place(0.84 * wide, 0.84 * wide) if base == "claw" else plate.place(0.5 * wide, 0.5 * wide)
            d.cylinder(frame.bottom(-0.018 if base == "claw" else -0.05), look, segments=32)
    if base in ("splayed", "tapered"):
        reach = (0.72 if base == "splayed" else 0.6) * wide
        legs(d, Box.sized(reach, reach, low), look, base, 0.055, 0.14 * low)
    else:
        pedestal(d, low, wide * {"tulip": 0.27, "claw": 0.36, "drum": 0.36, "cross": 0.34}[base], look, base)
    for side in ("front", "back", "left", "right"):
        knees = getattr(plate, side)(0.2 * wide).to(z=(0.07, KNEES))
        d.clear(knees.place(width=0.4) if side in ("front", "back") else knees.place(depth=0.4))


@draws("oval_table")
def oval_table(d: Drawing) -> None:
    """An oval top on two pedestals, on frames of steel, on splayed legs or on two round drums."""
    base = d.pick("base", ["tulip", "splayed", "vee", "drum"])
    top = d.material("top", *(("marble", "white paint", "walnut", "oak") if base == "tulip" else WOODS))
    feet = {"tulip": ("white paint", "black paint"), "vee": ("black steel", "brass")}
    look = d.material("foot", *feet[base]) if base in feet else top
    bounds = d.bounds
    plate = bounds.top(d.uniform("thickness", 0.024, 0.034))
    under = bounds.to(z=(0.0, plate.z[0]))
    (depth, width, low), at = under.size, 0.26 * bounds.width
    with d.part("top"):
        tabletop(d, plate, top, power=d.pick("power", [2.0, 2.5]), edge=d.pick("edge", ["soft", "knife"]))
        if base == "splayed":
            walls(d, under.place(0.54 * depth, 0.6 * width).top(0.055), look)
    if base == "splayed":
        legs(d, under.place(0.74 * depth, 0.76 * width), look, base, 0.058, 0.14 * low)
    else:
        with d.mirror("y"):
            if base == "vee":
                with d.part("end"):
                    end_frame(d, under.place(depth=0.72 * depth).to(y=(at - 0.027, at + 0.027)), look, base)
            else:
                with d.at(y=at):
                    pedestal(d, low, 0.3, look, base)
    for side in (bounds.front(bounds.depth / 2 - 0.31), bounds.back(bounds.depth / 2 - 0.31)):
        d.clear(side.place(width=0.4 * width).to(z=(0.0, KNEES)))


@draws("conference_table")
def conference_table(d: Drawing) -> None:
    """A long top in the form of a boat or a racetrack on panel feet or steel frames, with sockets in its middle."""
    form, base = d.pick("form", ["boat", "racetrack", "rectangle"]), d.pick("base", ["panel", "loop", "drum"])
    top = look = d.material("top", "walnut", "oak", "light oak", "wenge", "white paint", "cherry")
    if base == "loop" or d.chance("dark", 0.5):
        finishes = ("black steel", "brushed steel", "white steel") if base == "loop" else ("black paint", "grey paint")
        look = d.material("foot", *finishes)
    bounds = d.bounds
    depth, width, _ = bounds.size
    plate = bounds.top(0.032)
    under = bounds.to(z=(0.0, plate.z[0]))
    with d.part("top"):
        corner = 0.48 * depth if form == "racetrack" else 0.05
        tabletop(d, plate, top, corner, 4.5 if form == "boat" else None, "soft" if base == "loop" else "knife")
        for cell in plate.place(0.12, 0.64 * width).columns(2):
            d.box(cell.place(width=0.32).top(-0.001), "black plastic", bevel=0.0)
    count, reach = 2 if width < 3.0 else 3, 0.34 * width
    for k in range(count):
        foot = under.move(y=2 * reach * k / (count - 1) - reach)
        with d.part(f"foot {k}"):
            if base == "loop":
                end_frame(d, foot.place(0.64 * depth, 0.06), look, "loop")
            elif base == "panel":
                d.box(foot.inset(bottom=0.02).place(0.52 * depth, 0.08), look, bevel=0.006)
                d.box(foot.bottom(0.02).place(0.58 * depth, 0.12), "black steel")
            else:
                d.cylinder(foot.bottom(0.02).place(0.5, 0.5), "black steel", segments=28)
                d.cylinder(foot.inset(bottom=0.02).place(0.44, 0.44), look, segments=28)
    if base != "drum":
        with d.part("rail"):
            d.box(under.top(0.1).place(0.04, 2 * reach - 0.06), look)
    for side in (bounds.front(0.17 * depth), bounds.back(0.17 * depth)):
        d.clear(side.place(width=0.8 * width).to(z=(0.0, KNEES)))
    d.fit()


@draws("bar_table", "cafe_table")
def bistro_table(d: Drawing) -> None:
    """A small top, round or square, on a column of steel with a disc or a cross; a high one has a ring for the feet."""
    base, form = d.pick("base", ["disc", "cross", "tulip", "iron"]), d.pick("form", ["round", "square", "round"])
    top = d.material("top", "oak", "walnut", "marble", "white paint", "black paint", "dark marble", "light oak")
    metal = d.material("foot", "black steel", "brushed steel", "chrome", "iron")
    wide, height = min(d.size[:2]), d.size.height
    high, radius = height > 0.9, wide / 2
    plate = Box.sized(wide, wide, height).top(d.uniform("thickness", 0.02, 0.03))
    low = plate.z[0]
    with d.part("top"):
        tabletop(d, plate, top, 0.04, 2.0 if form == "round" else None)
        if top.name in ("marble", "white paint") and form == "round" and base == "iron":
            d.cylinder(plate.inset(x=0.03 * radius, y=0.03 * radius).bottom(-0.012), "brass", segments=36)
        d.cylinder(plate.place(0.24, 0.24).bottom(-0.02), metal, segments=20)
    reach = max(0.23, 0.8 * radius) if high else max(0.24, 0.72 * radius)
    if base != "iron":
        pedestal(d, low, reach, metal, base, slim=0.75)
    else:
        curve = ((0.03, 0.26), (0.05, 0.14), (0.12, 0.06), (reach - 0.03, 0.03), (reach - 0.012, 0.012))
        with d.part("foot"):
            with d.ring(4, 0.0, math.pi / 4):
                d.sweep([(x, 0, z) for x, z in curve], 0.012, metal, 8)
                d.cylinder(Box.sized(0.04, 0.04, 0.02, (reach - 0.02, 0, 0)), metal, ends=(1.0, 0.8), segments=12)
            d.cylinder(Box.sized(0.09, 0.09, 0.2, (0, 0, 0.08)), metal, ends=(1.0, 0.67), segments=16)
        with d.part("column"):
            d.cylinder(Box.sized(0.052, 0.052, low - 0.3, (0, 0, 0.28)), metal, segments=16)
            d.cylinder(Box.sized(0.09, 0.09, 0.02, (0, 0, 0.5 * low)), metal, segments=16)
    if high:
        with d.part("ring"):
            d.hoop(Box.around((0.0, 0.0, 0.3), 0.4, 0.4, 0.0), 0.009, metal, steps=16)
            with d.ring(4):
                d.bar((0.0, 0, 0.3), (0.2, 0, 0.3), 0.006, metal, 6)


@draws("folding_table")
def folding_table(d: Drawing) -> None:
    """A light top of plastic or wood on two pairs of folding steel legs with braces."""
    top = d.material("top", "white plastic", "grey plastic", "light oak", "white paint", "plywood")
    metal = d.material("legs", "grey paint", "black steel", "steel")
    plate, bounds, radius = d.bounds.top(0.04), d.bounds, 0.0125
    low, x = plate.z[0], bounds.x[1] - 0.07
    with d.part("top"):
        tabletop(d, plate, top, 0.05)
        with d.mirror("x"):
            d.box(plate.bottom(-0.02).inset(y=0.08).place(depth=0.024).move(x=0.3 * bounds.depth), metal)
        d.box(plate.bottom(-0.004).inset(x=0.03).place(width=0.008), "black plastic", bevel=0.0)
    at = bounds.y[1] - 0.16
    with d.mirror("y"):
        with d.part("end"):
            with d.mirror("x"):
                d.bar((x, at, 0.012), (x, at, low - 0.004), radius, metal)
                d.cylinder(Box.sized(0.034, 0.034, 0.03, (x, at, 0.0)), "rubber", segments=12)
            for z in (0.12, low - 0.03):
                d.bar((-x, at, z), (x, at, z), 0.8 * radius, metal, 8)
        with d.part("brace"):
            d.bar((0, at, 0.42), (0, at - min(0.3, at - 0.26), low - 0.008), 0.008, metal, 8)
            d.bar((-x, at, 0.42), (x, at, 0.42), 0.008, metal, 8)
    d.clear(bounds.inset(y=0.5).to(z=(0.0, KNEES)))


@draws("patio_table")
def patio_table(d: Drawing) -> None:
    """Slats of hardwood or metal with gaps, or glass, on weatherproof legs."""
    kind = d.pick("kind", ["slats", "metal", "glass"])
    tops = {
        "slats": ("oak", "cherry", "ash grey wood", "mahogany"),
        "metal": ("white steel", "black steel", "sage paint", "teal paint", "grey paint"),
        "glass": ("frosted glass", "glass"),
    }
    top = look = d.material("top", *tops[kind])
    if kind == "glass" or kind == "slats" and d.chance("metal legs", 0.4):
        look = d.material("legs", "black steel", "aluminium", "wicker" if kind == "glass" else "white steel")
    bounds = d.bounds
    low = bounds.z[1] - 0.036
    with d.part("top"):
        if kind == "glass":
            tabletop(d, bounds.top(0.012), top, 0.06)
            walls(d, bounds.inset(x=0.015, y=0.015, top=0.012).top(0.054), look)
        else:
            rim, pitch, gap = (0.06, 0.085, 0.007) if kind == "slats" else (0.035, 0.05, 0.005)
            plate = walls(d, bounds.top(0.036), top, rim).inset(x=rim, y=rim)
            # What shows between the slats; the whole field is one flat part.
            d.box(plate.top(0.024), "grey plastic" if top.name == "black steel" else "black plastic", bevel=0.0)
            for slat in plate.inset(y=gap / 2).columns(round(plate.width / pitch) | 1, gap=gap):
                d.box(slat.top(0.018).inset(bottom=0.0047, top=-0.0013), top, bevel=0.0013)
            walls(d, bounds.inset(x=0.03, y=0.03).to(z=(low - 0.05, low)), look)
            d.surface("top", bounds, inset=0.01)
    style = "tapered" if kind == "slats" else d.pick("leg style", ["square", "round"])
    legs(d, bounds.inset(x=0.02, y=0.02).to(z=(0.0, low)), look, style, 0.06)
    d.clear(bounds.inset(y=0.3).to(z=(0.0, KNEES)))
    d.fit()


@draws("picnic_table")
def picnic_table(d: Drawing) -> None:
    """A table and two benches of thick boards on A-frames, all in one."""
    wood = d.material("wood", "pine", "oak", "ash grey wood", "cherry", "green paint")
    bounds, thick, seat, half = d.bounds, 0.038, 0.44, 0.36
    low = bounds.z[1] - thick
    with d.part("top"):
        planks(d, bounds.top(thick).place(depth=2 * half), wood, wide=0.145)
    benches = bounds.to(z=(seat - thick, seat))
    for name, place in (("front-seat", benches.front(0.27)), ("back-seat", benches.back(0.27))):
        with d.part(name):
            planks(d, place, wood, name=None)
        d.surface(name, place, inset=0.01)
    at, feet, heads = bounds.y[1] - 0.32, bounds.x[1] - 0.12, 0.2
    knee = feet + (heads - feet) * (seat - thick) / low
    side = bounds.to(y=(at + 0.0225, at + 0.0625))

    def legs_between(x0: float, z0: float, x1: float, z1: float) -> None:
        """A leaning leg of rectangular section at the front, and at the back."""
        with d.mirror("x"):
            ends = ((x0, z0), (x1, z1))
            d.hull([(x + dx, at + dy, z) for x, z in ends for dx in (-0.05, 0.05) for dy in (-0.0225, 0.0225)], wood)

    with d.mirror("y"):
        with d.part("frame"):
            legs_between(feet, 0.0, knee, seat - thick)
            d.box(side.inset(x=0.03).to(z=(seat - 0.138, seat - thick)), wood)
        with d.part("upper frame"):
            legs_between(knee, seat - thick, heads, low)
        with d.part("top"):
            d.box(side.place(depth=2 * half - 0.06).to(z=(low - 0.092, low)), wood)
    for free in (bounds.front(bounds.depth / 2 - half - 0.02), bounds.back(bounds.depth / 2 - half - 0.02)):
        d.clear(free.inset(y=0.5).to(z=(0.0, 0.6)))
