"""Low tables of living rooms and bedrooms, and what stands along their walls."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import REACH, carcass, door, drawers, feet, leg, legs, walls
from .tables_parts import drawer_case, end_frame, pedestal, planks, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "cherry", "ash grey wood", "wenge", "pine")
PAINTS = ("white paint", "cream paint", "sage paint", "navy paint", "light grey paint", "black paint")
METALS = ("black steel", "brass", "brushed steel", "white steel")
PULLS = ("brass", "black steel", "brushed steel")


def _shelf(d: Drawing, box: Box, look, z: float, inset: float, ceiling: float, thick: float = 0.02) -> None:
    """A board between legs with its top at a height, on which things may stand ``inset`` from its edges."""
    with d.part("shelf"):
        board = d.box(box.to(z=(z - thick, z)), look)
    d.surface("shelf", board, round(ceiling - z - 0.005, 4), inset)


@draws("coffee_table")
def coffee_table(d: Drawing) -> None:
    """A low top on legs with a shelf, a glass top on metal, a waterfall of boards, or a chest with drawers."""
    kind = d.pick("kind", ["shelf", "glass", "waterfall", "splayed", "drawers", "rustic", "hairpin"])
    bounds = d.bounds
    tops = {
        "glass": ("glass", "marble", "dark marble"),
        "waterfall": (*WOODS, "white paint", "black paint"),
        "drawers": (*WOODS, *PAINTS),
    }
    top = d.material("top", *tops.get(kind, WOODS))
    thick = 0.012 if top.name == "glass" else 0.036 if kind == "rustic" else d.uniform("thickness", 0.022, 0.03)
    plate, under = bounds.top(thick), bounds.inset(top=thick)
    low = under.z[1]
    if kind == "waterfall":
        with d.part("top"):
            d.box(plate, top, bevel=0.004)
        d.surface("top", plate, inset=0.01)
        for k, side in enumerate((under.right(thick), under.left(thick))):
            with d.part(f"side {k}"):
                d.box(side, top, bevel=0.004)
        _shelf(d, under.inset(x=0.03, y=thick), top, d.uniform("shelf", 0.1, 0.16), 0.01, low)
    elif kind == "glass":
        metal = d.material("frame", "black steel", "brass", "chrome")
        rail = under.inset(x=0.01, y=0.01)
        with d.part("top"):
            tabletop(d, plate, top, 0.012)
            walls(d, rail.top(0.02), metal)
        legs(d, rail.inset(top=0.02), metal, "square", 0.02)
        lower = d.material("lower", "glass", "oak", "walnut") if top.name == "glass" else top
        with d.part("shelf"):
            walls(d, rail.to(z=(0.07, 0.088)), metal)
        _shelf(d, under.inset(x=0.012, y=0.012), lower, 0.1, 0.03, low - 0.02, 0.012)
    elif kind == "drawers":
        fronts = d.material("fronts", *WOODS) if top.name.endswith("paint") else top
        pull, style = d.material("pulls", *PULLS), d.pick("pull style", ["knob", "cup"])
        look = d.material("legs", "black steel", "brass") if d.chance("metal legs", 0.3) else top
        case = under.inset(back=0.03, front=REACH[style], y=0.02)
        with d.part("top"):
            tabletop(d, plate, top, 0.02)
            drawer_case(d, case.top(0.12), top, fronts, pull, style, columns=2)
        legs(d, case.inset(x=0.01, y=0.01, top=0.12), look, "tapered", 0.04)
        if low - 0.12 > 0.2:
            _shelf(d, case.inset(x=0.02, y=0.02), top, 0.093, 0.04, low - 0.12)
    else:
        look = top
        if kind == "hairpin" or d.chance("painted", 0.35):
            steel = ("black steel", "brass", "copper")
            look = d.material("legs", *(steel if kind == "hairpin" else ("white paint", "black paint", "cream paint")))
        with d.part("top"):
            if kind == "rustic":
                planks(d, plate, top, ends=0.09)
            elif kind == "splayed":
                tabletop(d, plate, top, power=d.pick("power", [2.0, 2.6, 3.4]), edge="knife")
                walls(d, under.place(0.62 * bounds.depth, 0.62 * bounds.width).top(0.035), look)
            else:
                tabletop(d, plate, top, d.pick("corner", [0.01, 0.04, 0.1]))
            if kind in ("shelf", "rustic"):
                walls(d, under.inset(x=0.03, y=0.03).top(0.055), look)
        if kind == "splayed":
            legs(d, under.place(0.8 * bounds.depth, 0.8 * bounds.width), look, "splayed", 0.04, 0.14 * low)
        elif kind == "hairpin":
            legs(d, under.inset(x=0.03, y=0.03), look, "hairpin")
        else:
            width = 0.05 if kind == "shelf" else 0.07
            style = d.pick("legs", ["square", "tapered"] if kind == "shelf" else ["turned", "square"])
            legs(d, under.inset(x=0.025, y=0.025), look, style, width)
            _shelf(d, under.inset(x=0.045, y=0.045), top, 0.1 if style == "turned" else 0.13, width - 0.01, low - 0.055)


@draws("nightstand")
def nightstand(d: Drawing) -> None:
    """Two or three drawers, a drawer over an open niche, or a drawer over a shelf between four legs."""
    kind = d.pick("kind", ["two drawers", "niche", "table", "three drawers"])
    style = d.pick("pull style", ["knob", "bar", "cup"])
    wood = d.material("body", *WOODS, *PAINTS)
    fronts = d.material("fronts", *WOODS, "white paint") if d.chance("two tone", 0.3) else wood
    pull = d.material("pulls", *PULLS)
    look = d.material("legs", "brass", "black steel", "oak", "walnut") if d.chance("other legs", 0.4) else wood
    kinds = ["square", "tapered"] if kind == "table" else ["tapered", "splayed", "round"]
    base = d.pick("leg style", kinds)
    plate = d.bounds.inset(front=max(0.0, REACH[style] - 0.008)).top(0.02)
    case = plate.inset(x=0.008, y=0.01).to(z=(0.0, plate.z[0]))
    with d.part("top"):
        tabletop(d, plate, wood, d.pick("corner", [0.006, 0.02]))
    if kind.endswith("drawers"):
        low = 0.15 if kind == "two drawers" else 0.06
        with d.part("body"):
            if low > 0.1:
                legs(d, case.bottom(low).inset(back=0.02, y=0.01), look, base, 0.04)
            else:
                feet(d, case.bottom(low), look)
            drawer_case(d, case.inset(bottom=low), wood, fronts, pull, style, 2 if low > 0.1 else 3)
    elif kind == "niche":
        low, deep, board = 0.12, 0.15, 0.018
        with d.part("drawer"):
            drawer_case(d, case.top(deep), wood, fronts, pull, style)
        room = case.inset(bottom=low, top=deep)
        with d.part("floor"):
            legs(d, case.bottom(low).inset(back=0.02, y=0.01), look, base, 0.04)
            d.box(room.bottom(board), wood)
        room = room.inset(bottom=board)
        for k, side in enumerate((room.right(board), room.left(board))):
            with d.part(f"side {k}"):
                d.box(side, wood)
        with d.part("back"):
            d.box(room.inset(y=board).back(0.008), wood, bevel=0.0)
        inner = room.inset(back=0.015, front=0.01, y=board + 0.006)
        d.surface("shelf", inner.bottom(0.0), round(room.height - 0.005, 4))
    else:
        with d.part("top"):
            drawer_case(d, case.top(0.13), wood, fronts, pull, style)
        legs(d, case.inset(top=0.13), look, base, 0.038)
        _shelf(d, case.inset(x=0.012, y=0.012), wood, 0.14, 0.033, case.z[1] - 0.13, 0.018)
    d.fit()


@draws("side_table")
def side_table(d: Drawing) -> None:
    """A small table: round on three legs or a disc, a drum of slats, or square with a shelf."""
    kind = d.pick("kind", ["three legs", "disc", "square", "frame", "drum", "tulip"])
    bounds = d.bounds
    if kind in ("square", "frame"):
        slim = kind == "frame"
        top = d.material("top", *WOODS, *(("marble", "glass") if slim else PAINTS))
        look = d.material("legs", *METALS) if slim else top
        plate = bounds.top(0.012 if top.name == "glass" else 0.02)
        under = bounds.inset(x=0.012, y=0.012).to(z=(0.0, plate.z[0]))
        deep = 0.018 if slim else 0.06
        with d.part("top"):
            tabletop(d, plate, top)
            walls(d, under.top(deep), look, 0.018)
        style = "square" if slim else d.pick("legs", ["tapered", "square", "turned"])
        legs(d, under, look, style, 0.018 if slim else 0.036)
        _shelf(d, under.inset(x=0.008, y=0.008), top, 0.15, 0.035, plate.z[0] - deep, 0.016)
        return
    radius = min(bounds.size[:2]) / 2
    top = d.material("top", *WOODS, "white paint", "marble", "dark marble", "teal paint", "black paint")
    plate = Box.sized(2 * radius, 2 * radius, bounds.height).top(0.02)
    low = plate.z[0]
    if kind == "drum":
        metal = d.material("frame", "brass", "black steel", "copper")
        with d.part("body"):
            tabletop(d, plate, top, power=2.0)
            d.cylinder(Box.sized(1.94 * radius, 1.94 * radius, 0.03), metal, segments=36)
            d.cylinder(Box.sized(1.68 * radius, 1.68 * radius, low - 0.03, (0, 0, 0.03)), top, segments=28)
            with d.ring(28, 0.9 * radius):
                d.box(Box.sized(0.08 * radius, 0.024, low - 0.03, (0, 0, 0.03)), top)
        return
    with d.part("top"):
        tabletop(d, plate, top, power=2.0, edge=d.pick("edge", ["soft", "knife"]))
    if kind == "three legs":
        look = d.material("legs", "brass", "black steel", "oak", "walnut", "white paint")
        thin = look.name in ("brass", "black steel")
        with d.part("top"):
            d.cylinder(plate.place(1.2 * radius, 1.2 * radius).bottom(-0.012), look, segments=28)
        with d.ring(3, 0.0, math.pi / 3), d.part("leg"):
            low_width, high_width = (0.016, 0.018) if thin else (0.02, 0.036)
            leg(d, (0.86 * radius, 0, 0), (0.5 * radius, 0, low), low_width, high_width, look)
    else:
        finishes = METALS if kind == "disc" else ("white paint", "black paint")
        pedestal(d, low, 0.7 * radius, d.material("foot", *finishes), kind, slim=0.55)


@draws("tv_stand")
def tv_stand(d: Drawing) -> None:
    """A long low cabinet: doors or drawers at both ends, open shelves for players in the middle."""
    wood = d.material("body", *WOODS, "white paint", "black paint", "light grey paint")
    looks = ("white paint", "light grey paint", "oak", "walnut", "rattan")
    fronts = d.material("fronts", *looks) if d.chance("two tone", 0.5) else wood
    pull, drawn = d.material("pulls", *PULLS), d.chance("drawers", 0.4)
    style = d.pick("pull style", ["bar", "knob", "cup"] if drawn else ["knob", "none"])
    base = d.pick("feet", ["tapered", "splayed", "plinth", "sled"])
    low = {"plinth": 0.05, "sled": 0.12}.get(base, d.uniform("rise", 0.11, 0.16))
    board, case = 0.022, d.bounds.inset(front=REACH[style])
    with d.part("base"):
        d.box(case.inset(bottom=low).bottom(board), wood)
        if base == "sled":
            metal, at = d.material("legs", "black steel", "brass", "white steel"), case.y[1] - 0.14
            with d.mirror("y"):
                end_frame(d, case.bottom(low).inset(x=0.03).to(y=(at - 0.011, at + 0.011)), metal, "loop")
        else:
            other = base != "plinth" and d.chance("other legs", 0.5)
            look = d.material("legs", "oak", "walnut", "black steel", "brass") if other else wood
            feet(d, case.bottom(low).inset(y=0.03), look, base)
    with d.part("top"):
        d.box(case.top(board), wood)
    d.surface("top", case, inset=0.01)
    room = case.inset(bottom=low + board, top=board)
    share = d.uniform("side share", 0.27, 0.36)
    right, middle, left = room.columns([share, 1 - 2 * share, share])
    sides: tuple[tuple[Literal["left", "right"], Box], ...] = (("right", right), ("left", left))
    for name, cell in sides:
        with d.part(name):
            inner = carcass(d, cell.inset(front=0.019), wood, 0.012)
            if drawn:
                drawers(d, cell.inset(back=0.006), 2, fronts, pull, style, 1, f"{name}-drawer", overlay=0.012)
            else:
                d.box(inner.inset(front=0.03).place(height=0.012), wood, bevel=0.0)
                door(d, f"{name}-door", cell.front(0.018), fronts, pull, name, style)
    with d.part("back"):
        d.box(middle.back(0.01), wood, bevel=0.0)
    open_room = middle.inset(back=0.01, front=0.02)
    levels = open_room.rows([1.0, d.uniform("shelf", 0.8, 1.2)], gap=0.016) if room.height > 0.24 else [open_room]
    for k, level in enumerate(levels):
        if k:
            with d.part("shelf"):
                d.box(level.bottom(-0.016), wood)
        d.surface(f"shelf-{k}", level.bottom(0.0), round(level.height - 0.005, 4), inset=0.01)


@draws("console_table")
def console_table(d: Drawing) -> None:
    """A narrow table along a wall: slim frame, drawers, a shelf below, or a half moon."""
    kind = d.pick("kind", ["frame", "drawers", "half moon", "cross", "waterfall"])
    bounds, slim = d.bounds, kind == "frame"
    top = d.material("top", *WOODS, *(("marble", "glass") if slim else ("white paint", "cream paint")))
    plate = bounds.top(0.012 if top.name == "glass" else 0.024)
    under = bounds.to(z=(0.0, plate.z[0]))
    low = under.height
    if kind == "half moon":
        _half_moon(d, bounds, low, top)
        return
    painted = not slim and d.chance("painted", 0.3)
    paints = ("white paint", "black paint", "sage paint", "navy paint")
    look = d.material("legs", *METALS) if slim else d.material("legs", *paints) if painted else top
    with d.part("top"):
        tabletop(d, plate, top, 0.01)
    if kind == "waterfall":
        for k, side in enumerate((under.right(0.03), under.left(0.03))):
            with d.part(f"side {k}"):
                d.box(side, look)
        _shelf(d, under.inset(x=0.02, y=0.03), top, 0.16, 0.012, low)
    elif kind == "cross":
        at = under.y[1] - 0.07
        with d.mirror("y"), d.part("end"):
            end_frame(d, under.inset(x=0.01).to(y=(at - 0.022, at + 0.022)), look, "cross")
        with d.part("rail"):
            d.box(under.place(0.04, 2 * at - 0.04, 0.06), look)
    else:
        case = under.inset(back=0.01, front=0.01 if slim else 0.026, y=0.01 if slim else 0.015)
        deep = 0.02 if slim else 0.13
        with d.part("top"):
            if slim:
                walls(d, case.top(deep), look)
            else:
                pull, style = d.material("pulls", "brass", "black steel"), d.pick("pull style", ["knob", "cup"])
                drawer_case(d, case.top(deep), look, look, pull, style, columns=2 if bounds.width < 1.15 else 3)
        style = "square" if slim else d.pick("legs", ["tapered", "turned", "square"])
        legs(d, case.inset(top=deep), look, style, 0.022 if slim else 0.045)
        if slim or d.chance("shelf", 0.6):
            _shelf(d, case.inset(x=0.01, y=0.015), top, 0.16, 0.04, low - deep, 0.018)


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
