"""Tables for many: conference, folding and picnic tables."""

from __future__ import annotations

from ...drawing import Box, Drawing, draws
from .tables import KNEES
from .tables_parts import end_frame, planks, tabletop


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
