"""Tables that are a top on a base: to eat, sit and put things at. What there is stands in a table of kinds."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import leg, legs, pulls, walls
from ...drawing.drawing import Look
from .tables_parts import board_between, drawer_case, ends, pedestal, pedestal_of_drawers, planks, tabletop

WOODS = "oak, light oak, walnut, beech, pine, cherry, ash grey wood, mahogany, wenge"
PAINTS = "white paint, cream paint, sage paint, navy paint, light grey paint, black paint"
METALS = "black steel, brass, brushed steel, white steel"
STEELS = "black steel, white steel, brushed steel"
STONES = "marble, dark marble"
KNEES = 0.62
"""Height [m] that stays free for knees."""


class Kind(NamedTuple):
    """One form of a table: what carries its top, finishes, and measures [m]."""

    base: str
    top: str = WOODS
    look: str = ""
    """Of the base; without, it is as the top, or now and then painted."""
    edge: str = "soft"
    """"soft", "knife", "either", "boards" (a top of planks) or "slats"."""
    width: float = 0.05
    """Of legs and bars."""
    inset: float = 0.03
    """Of legs from the edge; of a central foot, its radius as a share of the table's width."""
    apron: float = 0.0
    """Height of the rails, or of the drawers, under the top."""
    shelf: float = 0.0
    """Height of a board between the legs."""
    plan: str = "rectangle"
    """"rectangle", "round" or "oval"."""


def _round(*kinds: Kind) -> list[Kind]:
    return [kind._replace(plan="round") for kind in kinds]


_DINING = [
    Kind("tapered", f"{WOODS}, white paint", edge="either", width=0.065, apron=0.085),
    Kind("square", f"{WOODS}, white paint", edge="boards", width=0.075, apron=0.085),
    Kind("turned", f"{WOODS}, white paint", edge="boards", width=0.085, apron=0.085),
    Kind("splayed", edge="either", width=0.055, apron=0.05),
    Kind("loop", f"{WOODS}, glass, marble", STEELS, inset=0.07),
    Kind("vee", f"{WOODS}, glass, marble", STEELS, "either", inset=0.07),
    Kind("cross", edge="boards", width=0.07, inset=0.07),
    Kind("a", edge="boards", width=0.065, inset=0.07),
    Kind("trestle", edge="boards", width=0.08, inset=0.07),
]
_BISTRO = "oak, walnut, marble, white paint, black paint, dark marble, light oak"
_IRON = "black steel, brushed steel, chrome, iron"
_CENTRAL = [Kind(base, _BISTRO, _IRON, inset=0.38) for base in ("disc", "cross", "tulip", "iron")]
_LONG_BAR = [Kind("square", _BISTRO, _IRON, width=0.04, inset=0.03, apron=0.06)]
_BOARDS = "oak, light oak, walnut, white paint, birch, ash grey wood, wenge"
_SLATTED = "oak, cherry, ash grey wood, mahogany"

LONG = 1.4
"""How many times longer than deep a high table is from which it stands on legs at its corners."""

TABLES = {
    "dining_table": _DINING,
    "round_dining_table": _round(
        Kind(
            "tulip",
            f"{STONES}, white paint, oak, walnut",
            "white paint, black paint, white steel",
            "either",
            inset=0.27,
        ),
        Kind("claw", inset=0.36),
        Kind("drum", "oak, walnut, marble", edge="either", inset=0.36),
        Kind("cross", "glass, black paint, oak, white paint", "black steel, brushed steel, chrome", inset=0.34),
        Kind("splayed", edge="either", width=0.055, inset=0.16, apron=0.05),
        Kind("tapered", edge="either", width=0.055, inset=0.2, apron=0.05),
    ),
    "oval_table": [
        Kind("tulip", "marble, white paint, walnut, oak", "white paint, black paint", "either", plan="oval"),
        Kind("splayed", edge="either", width=0.058, inset=0.14, apron=0.055, plan="oval"),
        Kind("vee", look="black steel, brass", edge="either", width=0.055, inset=0.14, plan="oval"),
        Kind("drum", edge="either", plan="oval"),
    ],
    "bar_table": [*_CENTRAL, *_round(*_CENTRAL, *_CENTRAL)],
    "cafe_table": [*_CENTRAL, *_round(*_CENTRAL, *_CENTRAL)],
    "patio_table": [
        Kind("tapered", _SLATTED, edge="slats", width=0.06, inset=0.02, apron=0.06),
        Kind("tapered", _SLATTED, "black steel, aluminium, white steel", "slats", 0.06, 0.02, 0.06),
        Kind(
            "square", f"{STEELS}, sage paint, teal paint, grey paint", edge="slats", width=0.06, inset=0.02, apron=0.06
        ),
        Kind("round", "frosted glass, glass", "black steel, aluminium, wicker", width=0.06, inset=0.02, apron=0.054),
    ],
    "coffee_table": [
        Kind("square", inset=0.025, apron=0.055, shelf=0.13),
        Kind("tapered", inset=0.025, apron=0.055, shelf=0.13),
        Kind("square", f"glass, {STONES}", "black steel, brass, chrome", width=0.02, inset=0.01, apron=0.02, shelf=0.1),
        Kind("turned", edge="boards", width=0.07, inset=0.025, apron=0.055, shelf=0.1),
        Kind("waterfall", f"{WOODS}, white paint, black paint", width=0.03, shelf=0.13),
        Kind("splayed", edge="knife", width=0.04, inset=0.08, apron=0.035, plan="oval"),
        Kind("hairpin", look="black steel, brass, copper", edge="either"),
        Kind("drawers", f"{WOODS}, {PAINTS}", width=0.04, apron=0.12, shelf=0.093),
    ],
    "round_coffee_table": _round(
        Kind("splayed", f"{WOODS}, white paint, black paint", edge="either", width=0.044, inset=0.14, apron=0.035),
        Kind("slats", f"{WOODS}, white paint, black paint"),
        Kind("wire", "marble, oak, glass, walnut", "black steel, brass, copper, white steel"),
        Kind("round", f"{WOODS}, white paint, black paint", width=0.036, inset=0.15, shelf=0.12),
        Kind("drum", f"{STONES}, oak", "black steel, brass, oak", inset=0.35),
    ),
    "side_table": [
        *_round(
            Kind("three legs", f"{WOODS}, {STONES}, white paint", f"{METALS}, oak, walnut", "either"),
            Kind("disc", f"{WOODS}, {STONES}, white paint, teal paint", METALS, "either", inset=0.35),
            Kind("tulip", f"{WOODS}, {STONES}, black paint", "white paint, black paint", "either", inset=0.35),
            Kind("slats", f"{WOODS}, white paint, teal paint", "brass, black steel, copper"),
        ),
        *(Kind(base, f"{WOODS}, {PAINTS}", "", "soft", 0.036, 0.012, 0.06, 0.15) for base in ("tapered", "turned")),
        Kind("square", f"{WOODS}, marble, glass", METALS, width=0.018, inset=0.012, apron=0.018, shelf=0.15),
    ],
    "desk": [
        *(Kind(base, _BOARDS, "oak, beech, walnut, birch", apron=0.05) for base in ("tapered", "splayed")),
        Kind("square", _BOARDS, f"{STEELS}, iron", apron=0.05),
        Kind("hairpin", _BOARDS, f"{STEELS}, iron"),
        Kind("loop", _BOARDS, f"{STEELS}, iron", width=0.045),
        Kind("panel", _BOARDS),
        *[Kind("stacks", _BOARDS)] * 3,
        Kind("drawers", _BOARDS, width=0.045, apron=0.085),
    ],
    "console_table": [
        Kind("square", f"{WOODS}, marble, glass", METALS, width=0.022, inset=0.01, apron=0.02, shelf=0.16),
        Kind("drawers", f"{WOODS}, white paint, cream paint", width=0.045, apron=0.13, shelf=0.16),
        Kind("half moon"),
        Kind("cross", f"{WOODS}, white paint", width=0.045, inset=0.01),
        Kind("waterfall", f"{WOODS}, white paint", width=0.03, shelf=0.16),
    ],
}


@draws(*TABLES)
def table(d: Drawing) -> None:
    """A top on legs with an apron, on end frames, on a central foot or two, on drawers; often with a shelf."""
    bounds = d.bounds
    long_bar = d.category.name == "bar_table" and max(bounds.size[:2]) > LONG * min(bounds.size[:2])
    kind = d.pick("kind", _LONG_BAR if long_bar else TABLES[d.category.name])
    round_plan = kind.plan == "round"
    if round_plan or kind in _CENTRAL:
        side = min(bounds.size[:2])
        bounds = bounds.place(side, side)
    top = look = d.material("top", *kind.top.split(", "))
    if kind.look:
        look = d.material("legs", *kind.look.split(", "))
    elif top.called("marble", "dark marble", "glass"):
        look = d.material("legs", "oak", "walnut", "black paint")
    elif kind.base not in ("waterfall", "slats", "half moon") and d.chance("painted", 0.3):
        look = d.material("legs", "white paint", "cream paint", "black paint")
    thick = 0.012 if top.called("glass") else 0.036 if kind.edge == "slats" else d.uniform("thickness", 0.022, 0.034)
    plate, under = bounds.top(thick), bounds.inset(top=thick)
    if kind.base == "half moon":
        _half_moon(d, bounds, under.height, top)
        return
    with d.part("body" if kind.base in ("slats", "wire") else "top"):
        _top(d, plate, kind, top)
        if kind.apron and kind.base != "drawers":
            lean = 0.1 * under.height if kind.base == "splayed" else 0.1 * kind.width
            rails = under.inset(x=kind.inset + lean, y=kind.inset + lean).top(
                min(kind.apron, max(0.02, under.height - 0.3))
            )
            if round_plan:
                d.cylinder(rails, look, segments=32)
            else:
                walls(d, rails, look, min(0.02, kind.width))
    _base(d, under, kind, top, look)
    if kind.shelf:
        inset = kind.inset + 0.2 * kind.width if kind.base != "waterfall" else kind.width
        if round_plan:
            disc = under.inset(x=0.07 * bounds.depth, y=0.07 * bounds.depth).to(z=(kind.shelf - 0.02, kind.shelf))
            with d.part("shelf"):
                d.cylinder(disc, top, bevel=0.004, segments=40)
            free = disc.place(0.5 * bounds.depth, 0.5 * bounds.depth)
            d.surface("shelf", free, round(under.height - kind.shelf - 0.005, 4))
        else:
            lower = under.inset(x=inset, y=inset, front=0.026 if kind.base == "drawers" else 0.0)
            board = 0.012 if kind.width < 0.03 else 0.02
            free = 0.01 if kind.base == "waterfall" else kind.width
            board_between(d, lower, top, kind.shelf, free, under.height - kind.apron, board)
    if bounds.height > 0.9 and not long_bar:
        with d.part("ring"):
            d.hoop(Box.around((0.0, 0.0, 0.3), 0.4, 0.4, 0.0), 0.009, look, steps=16)
            with d.ring(4):
                d.bar((0.0, 0, 0.3), (0.2, 0, 0.3), 0.006, look, 6)


def _top(d: Drawing, plate: Box, kind: Kind, look: Look) -> None:
    """The top of a table by its kind."""
    if kind.edge == "boards":
        planks(d, plate, look, d.pick("ends", [0.0, 0.1]))
    elif kind.edge == "slats":
        rim, pitch, gap = (0.06, 0.085, 0.007) if kind.base == "tapered" else (0.035, 0.05, 0.005)
        inner = walls(d, plate, look, rim).inset(x=rim, y=rim)
        # What shows between the slats; the whole field is one flat part.
        d.box(inner.top(0.024), "grey plastic" if d.named(look).called("black steel") else "black plastic", bevel=0.0)
        for slat in inner.inset(y=gap / 2).columns(round(inner.width / pitch) | 1, gap=gap):
            d.box(slat.top(0.018).inset(bottom=0.0047, top=-0.0013), look, bevel=0.0013)
        d.surface("top", plate.inset(top=-0.0013), inset=0.01)
    else:
        edge = d.pick("edge", ["soft", "knife"]) if kind.edge == "either" and plate.height > 0.015 else kind.edge
        power = {"rectangle": None, "round": 2.0, "oval": d.pick("power", [2.0, 2.5])}[kind.plan]
        wide = min(plate.size[:2]) > 0.6 and kind.edge == "either"
        tabletop(
            d,
            plate,
            look,
            d.pick("corner", [0.03, 0.08, 0.2] if wide else [0.01, 0.03]),
            power,
            edge.replace("either", "soft"),
        )


def _base(d: Drawing, under: Box, kind: Kind, top: Look, look: Look) -> None:
    """What carries a table, by its kind."""
    base, width, inset, height = kind.base, kind.width, kind.inset, under.height
    depth, wide, _ = under.size
    radius, knees = min(depth, wide) / 2, under.to(z=(0.0, KNEES))
    if base in ("loop", "vee", "cross", "a", "trestle") and inset < 0.2:
        over = 0.21 * wide if kind.plan == "oval" else d.uniform("overhang", 0.05, min(0.3, 0.14 * wide))
        room = ends(d, under, look, base, width, inset, over)
        if base in ("cross", "a", "trestle"):
            z = {"trestle": 0.14, "a": 0.29, "cross": 0.5 * height}[base]
            with d.part("rail"):
                d.box(room.place(depth=0.06 if depth > 0.5 else 0.04).to(z=(z - 0.035, z + 0.035)), look)
            for side in (knees.front(depth / 2 - 0.06), knees.back(depth / 2 - 0.06)):
                d.clear(side.inset(y=0.16 * wide))
        else:
            with d.part("top"):
                d.box(room.top(0.03).place(depth=0.06), look)
            d.clear(knees.inset(y=0.16 * wide))
    elif base in ("tulip", "disc", "claw", "drum", "iron", "cross"):
        if kind.plan == "oval":
            with d.mirror("y"), d.at(y=0.26 * wide):
                pedestal(d, height, 0.3, look, base)
            for side in (knees.front(depth / 2 - 0.31), knees.back(depth / 2 - 0.31)):
                d.clear(side.place(width=0.4 * wide))
            return
        pedestal(d, height, max(inset * wide, 0.23 * height), look, base, min(1.0, max(0.5, 1.05 * wide)))
    elif base == "three legs":
        thin = d.named(look).metallic > 0
        with d.ring(3, 0.0, math.pi / 3), d.part("leg"):
            leg(
                d,
                (0.86 * radius, 0, 0),
                (0.5 * radius, 0, height),
                0.016 if thin else 0.02,
                0.018 if thin else 0.036,
                look,
            )
        with d.part("top"):
            d.cylinder(under.place(1.2 * radius, 1.2 * radius).top(0.012), look, segments=28)
    elif base == "slats":
        with d.part("body"):
            d.cylinder(under.place(1.94 * radius, 1.94 * radius).bottom(0.025), look, segments=36)
            d.cylinder(under.inset(bottom=0.025).place(1.68 * radius, 1.68 * radius), top, segments=28)
            with d.ring(32, 0.9 * radius):
                d.box(Box.sized(0.08 * radius, 0.12 * radius, height - 0.025, (0, 0, 0.025)), top, bevel=0.002)
    elif base == "wire":
        with d.part("body"):
            for size, z in ((1.24 * radius, 0.006), (1.8 * radius, height - 0.006)):
                d.hoop(Box.around((0.0, 0.0, z), size, size, 0.0), 0.006, look, steps=18)
            head = (0.9 * radius * math.cos(0.35), 0.9 * radius * math.sin(0.35), height - 0.003)
            with d.ring(12), d.mirror("y"):
                d.bar((0.62 * radius, 0, 0.006), head, 0.004, look, 5)
    elif base == "panel":
        with d.mirror("y"), d.part("side"):
            d.box(under.inset(back=0.015, front=0.03, left=0.015).left(0.025), look)
        with d.part("modesty"):
            d.box(under.inset(back=0.06, y=0.04, bottom=0.3).back(0.018), look)
        d.clear(knees.inset(back=0.1, y=0.1))
    elif base == "stacks":
        style, pull, reach = pulls(d, d.named(look))
        own, stack = under.inset(back=0.02, front=reach + 0.005, y=0.02), d.uniform("stack", 0.36, 0.42)
        first = d.pick("side", ["right", "left"])
        widths = {side: stack if side == first or wide > 1.5 else 0.025 for side in ("right", "left")}
        for side, across in widths.items():
            place = own.right(across) if side == "right" else own.left(across)
            if across == stack:
                pedestal_of_drawers(d, place, top, look, pull, style, d.integer("count", 3, 4), side)
            else:
                with d.part("side"):
                    d.box(place, top)
        free = own.inset(**widths)
        with d.part("modesty"):
            d.box(free.inset(back=0.02, bottom=0.25).back(0.016), top, bevel=0.0)
        d.clear(free.inset(back=0.1, y=0.05).to(z=knees.z))
    elif base == "waterfall":
        with d.mirror("y"), d.part("side"):
            d.box(under.left(width), top, bevel=0.004)
    else:
        box = under.inset(x=inset, y=inset)
        if base == "drawers":
            # A hand has no room over a wider pull under a top that stands over it.
            style, pull, reach = pulls(d, d.named(look), *(("knob", "cup") if kind.apron > 0.115 else ("knob",)))
            box = box.inset(front=reach)
            with d.part("top"):
                drawer_case(d, box.top(kind.apron), look, look, pull, style, columns=2 if wide < 1.15 else 3)
            box, base = box.inset(x=0.01, y=0.01, top=kind.apron), d.pick("legs", ["tapered", "turned", "square"])
        legs(d, box, look, base, width)
        if under.height > 0.6 and depth > 0.5:
            d.clear(knees.inset(x=0.0 if kind.plan != "round" else 0.15 * depth, y=0.16 * wide))


def _half_moon(d: Drawing, bounds: Box, low: float, look) -> None:
    """A console whose front is a half of an ellipse, on four legs."""
    turn, x = np.linspace(-math.pi / 2, math.pi / 2, 21), bounds.x[0]

    def outline(inset: float) -> np.ndarray:
        """The plan, drawn in along its curve."""
        return np.c_[x + (bounds.depth - inset) * np.cos(turn), (bounds.width / 2 - inset) * np.sin(turn)]

    with d.part("top"):
        d.extrude(outline(0.0), (low, bounds.z[1]), look, bevel=0.004)
        d.extrude(outline(0.035), (low - 0.1, low), look)
        d.extrude(outline(0.028), (low - 0.1, low - 0.088), look)
    d.surface("top", bounds, polygon=outline(0.015)[1:-1] + (0.005, 0.0))
    for angle in (-1.36, -0.55, 0.55, 1.36):
        at = max(x + (bounds.depth - 0.06) * math.cos(angle), x + 0.03), (bounds.width / 2 - 0.075) * math.sin(angle)
        d.cylinder(Box.sized(0.042, 0.042, low - 0.1, (*at, 0.0)), look, ends=(0.52, 1.0), segments=14)
