"""Desks with something above the top."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, draws
from ...drawing.components import REACH, drawer, legs
from .tables import KNEES
from .tables_parts import drawer_case, ends, tabletop

WOODS = ("oak", "walnut", "cherry", "mahogany", "light oak", "beech")


@draws("secretary_desk")
def secretary_desk(d: Drawing) -> None:
    """A writing top on slim legs with drawers in its apron and a hutch of pigeonholes above its back."""
    style = d.pick("pull style", ["knob", "cup"])
    wood = d.material("body", *WOODS, "white paint", "sage paint")
    pull = d.material("pulls", "brass", "bronze", "black steel")
    bounds, height, thin = d.bounds, 0.75, 0.006
    plate = bounds.to(z=(height - 0.022, height))
    case = plate.bottom(-0.116).inset(back=0.012, front=REACH[style] + 0.005, y=0.015)
    with d.part("top"):
        d.box(plate, wood, bevel=0.004)
        drawer_case(d, case, wood, wood, pull, style, columns=2)
    legs(d, case.to(z=(0.0, case.z[0])), wood, d.pick("legs", ["tapered", "turned"]), 0.048)
    deep = d.uniform("hutch", 0.2, 0.24)
    d.surface("top", plate.inset(back=deep + 0.02), inset=0.01)
    hutch = bounds.inset(y=0.01, bottom=height).back(deep)
    room = hutch.inset(top=0.02, back=thin)
    with d.part("hutch top"):
        d.box(hutch.inset(front=-0.01, y=-0.01).top(0.02), wood, bevel=0.006)
    d.surface("hutch", hutch, inset=0.005)
    with d.part("back"):
        d.box(hutch.inset(top=0.02).back(thin), wood, bevel=0.0)
    middle = height + 0.55 * room.height
    board = room.to(z=(middle, middle + 0.012))
    right, center, left = room.columns(3)
    for name, wing in (("right", right), ("left", left)):
        with d.part(f"wing {name}"):
            for side in (wing.right(0.016), wing.left(0.016)):
                d.box(side, wood, bevel=0.001)
            inner = wing.inset(y=0.016)
            d.box(board.to(y=inner.y), wood, bevel=0.001)
            for k, cell in enumerate(inner.to(z=(height, middle)).rows(2)):
                drawer(d, f"small-{name}-{k}", cell.inset(front=0.001), wood, pull, "knob")
            if d.chance("letters", 0.6):
                for cell in inner.inset(front=0.01).to(z=(board.z[1], room.z[1])).columns(4)[1:]:
                    d.box(cell.right(0.006), wood, bevel=0.0)
    with d.part("shelf"):
        shelf = d.box(board.to(y=center.y).inset(front=0.005), wood, bevel=0.001)
    d.surface("shelf", shelf.inset(x=0.012, y=0.01), round(room.z[1] - shelf.z[1] - 0.005, 4))
    d.clear(bounds.inset(back=0.1, y=0.1).to(z=(0.0, case.z[0] - 0.01)))


@draws("computer_desk")
def computer_desk(d: Drawing) -> None:
    """A desk with a raised shelf for screens, a tray for the keyboard, a rack for the machine, steel ends."""
    top = d.material("top", "black paint", "oak", "white paint", "walnut", "wenge")
    metal = d.material("frame", "black steel", "white steel", "red paint", "grey paint")
    bounds, height = d.bounds, 0.75
    plate = bounds.to(z=(height - 0.022, height))
    under = bounds.to(z=(0.0, plate.z[0]))
    with d.part("top"):
        tabletop(d, plate, top, 0.02, name=None)
        if d.chance("lights", 0.35):
            d.print(plate.inset(y=0.05).front(0.0).place(height=0.006), "lamp glow")
    ends(d, under, metal, "loop", 0.04, 0.03, 0.01)
    shelf = bounds.inset(y=0.02).back(0.26).top(0.02)
    with d.part("screen shelf"):
        d.box(shelf, top)
    with d.mirror("y"), d.part("post"):
        d.box(shelf.inset(back=0.02, front=0.03, left=0.005).left(0.02).to(z=(height, shelf.z[0])), metal)
    d.surface("shelf", shelf, inset=0.01)
    d.surface("top", plate.inset(back=0.26), inset=0.01)
    d.surface("under", plate.back(0.26).inset(back=0.02, y=0.06), round(shelf.z[0] - height - 0.005, 4))
    right = d.pick("rack side", [True, False])
    space = under.inset(x=0.08, y=0.05)
    rack = space.right(0.24) if right else space.left(0.24)
    with d.part("rack"):
        room = rack.inset(bottom=0.118)
        d.box(room.bottom(-0.018), top)
        d.box(room.left(0.016) if right else room.right(0.016), top)
        machine = room.inset(back=0.02, front=0.05, y=0.03).bottom(0.36)
        d.box(machine, "black plastic", bevel=0.008)
        face = machine.inset(y=0.02, z=0.03).front(0.0)
        d.print(face, "black glass")
        d.print(face.top(0.004).inset(y=0.01), "lamp glow", 0.0004)
    free = under.to(y=(rack.y[1], under.y[1]) if right else (under.y[0], rack.y[0]))
    tray = free.place(width=min(0.6, free.width - 0.1)).inset(front=0.02).front(0.33).top(0.065)
    with d.part("tray"), d.slide("tray", limits=(0.0, 0.28)):
        board = d.box(tray.bottom(0.015), top)
        x, y, z = board.anchor("front")
        d.grasp("edge", (x - 0.009, y, z), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), board.height, board.width)
        d.box(board.top(-0.018).inset(front=0.04).front(0.13).place(width=0.42), "black plastic", bevel=0.004)
        for rail in (tray.right(0.016), tray.left(0.016)):
            d.box(rail.inset(bottom=0.015, front=0.03, top=0.002), metal)
    d.clear(bounds.inset(back=0.1).to(y=tray.y, z=(0.0, KNEES)))
    d.fit()


@draws("dressing_table")
def dressing_table(d: Drawing) -> None:
    """A small table with drawers on slim legs and a mirror: round, arched, oval or a tripartite one."""
    style = d.pick("pull style", ["knob", "cup"])
    wood = d.material("body", "white paint", "oak", "walnut", "cream paint", "light oak", "light grey paint")
    metal = d.material("pulls", "brass", "copper", "chrome", "black steel")
    bounds, height = d.bounds, 0.76
    plate = bounds.to(z=(height - 0.022, height))
    case = plate.bottom(-0.12).inset(back=0.01, front=REACH[style], y=0.015)
    with d.part("top"):
        tabletop(d, plate, wood, 0.02, name=None)
        drawer_case(d, case, wood, wood, metal, style, columns=2 if bounds.width < 0.95 else 3)
    look = metal if not metal.called("chrome") and d.chance("metal legs", 0.35) else wood
    styles = ["tapered", "splayed", "turned"] if look == wood else ["round"]
    legs(d, case.inset(x=0.01, y=0.01).to(z=(0.0, case.z[0])), look, d.pick("legs", styles), 0.042)
    d.surface("top", plate.inset(back=0.08), inset=0.01)
    kind = d.pick("mirror", ["round", "arch", "oval", "three"])
    frame = metal if d.chance("metal frame", 0.6) else wood
    stands = kind in ("round", "oval")
    glass = bounds.inset(bottom=height + (0.04 if stands else 0.0))
    half = glass.height / 2
    wide = bounds.width
    width = {"round": 2 * half, "oval": min(0.6 * wide, 1.44 * half), "arch": 0.6 * wide, "three": 0.4 * wide}[kind]
    glass = glass.inset(back=0.03).back(0.02).place(width=width)
    with d.part("mirror"):
        _mirror(d, glass, frame, stands)
        if stands:
            d.box(glass.place(0.012, 0.04).to(z=(height, glass.z[0] + 0.03)), frame)
            d.box(glass.place(width=0.22).inset(x=-0.025).to(z=(height, height + 0.014)), frame)
    if kind == "three":
        wing = Box((-0.012, 0.008), (0.0, 0.15 * bounds.width), glass.inset(top=0.06).z)
        with d.mirror("y"), d.at(bounds.x[0] + 0.045, glass.y[1] + 0.003, 0.0, yaw=-0.4), d.part("wing"):
            _mirror(d, wing, frame, False)
    d.clear(bounds.inset(back=0.1, y=0.1).to(z=(0.0, case.z[0] - 0.01)))


def _mirror(d: Drawing, box: Box, frame, ellipse: bool) -> None:
    """A framed mirror that fills the width and height of a box: an ellipse, or with a round head."""
    turn = np.linspace(0.0, math.pi, 17)
    for inset, x, look in ((0.0, box.x, frame), (0.018, (box.x[1] - 0.001, box.x[1] + 0.002), "mirror")):
        own = box.inset(y=inset, z=inset)
        _, y, z = own.center
        half = min(own.width / 2, 0.5 * own.height)
        if ellipse:
            around = np.linspace(0.0, 2 * math.pi, 41)[:-1]
            outline = np.c_[y + own.width / 2 * np.cos(around), z + own.height / 2 * np.sin(around)]
        else:
            head = np.c_[y + own.width / 2 * np.cos(turn), own.z[1] - half + half * np.sin(turn)]
            outline = np.concatenate([head, [(own.y[0], own.z[0]), (own.y[1], own.z[0])]])
        d.extrude(outline, x, look, axis="x")
