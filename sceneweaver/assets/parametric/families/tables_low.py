"""Nightstands and stands for televisions."""

from __future__ import annotations

from typing import Literal

from ...drawing import Box, Drawing, draws
from ...drawing.components import REACH, carcass, compartments, door, drawers, feet, legs
from .tables_parts import board_between, drawer_case, end_frame, tabletop

WOODS = ("oak", "light oak", "walnut", "beech", "cherry", "ash grey wood", "wenge", "pine")
PAINTS = ("white paint", "cream paint", "sage paint", "navy paint", "light grey paint", "black paint")
PULLS = ("brass", "black steel", "brushed steel")


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
        board_between(d, case.inset(x=0.012, y=0.012), wood, 0.14, 0.033, case.z[1] - 0.13, 0.018)
    d.fit()


@draws("tv_stand")
def tv_stand(d: Drawing) -> None:
    """A long low cabinet: doors or drawers at both ends, open shelves for players in the middle."""
    wood = d.material("body", *WOODS, "white paint", "black paint", "light grey paint")
    looks = ("white paint", "light grey paint", "oak", "walnut", "rattan")
    fronts = d.material("fronts", *looks) if d.chance("two tone", 0.5) else wood
    pull, drawn = d.material("pulls", *PULLS), d.chance("drawers", 0.4)
    style = d.pick("pull style", ["bar", "knob", "cup"] if drawn else ["knob", "bar"])
    base = d.pick("feet", ["tapered", "splayed", "plinth", "sled"])
    low = {"plinth": 0.05, "sled": 0.12}.get(base, d.uniform("rise", 0.11, 0.16))
    board, case = 0.022, d.bounds.inset(front=REACH[style])
    with d.part("base"):
        d.box(case.inset(bottom=low).bottom(board), wood)
        if base == "sled":
            metal = d.material("legs", "black steel", "brass", "white steel")
            with d.mirror("y"):
                end_frame(d, case.bottom(low).inset(x=0.03, left=0.13).left(0.022), metal, "loop")
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
                rooms = inner.inset(front=0.03).rows(2, gap=0.012)
                d.box(rooms[1].bottom(-0.012), wood, bevel=0.0)
                compartments(d, rooms, name)
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
