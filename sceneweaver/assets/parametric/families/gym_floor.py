"""Mats, balls, bags and other small gear of a gym."""

from __future__ import annotations

import math

import numpy as np

from ...drawing import Box, Drawing, Look, draws
from ...drawing.box import Axis
from ...drawing.components import band

_BRIGHT = "blue plastic, mint plastic, lilac plastic, pink plastic, green plastic, black plastic, grey plastic"


@draws("yoga_mat", whole=True)
def yoga_mat(d: Drawing) -> None:
    """A flat mat with a printed centre line and marks for hands and feet."""
    mat = d.box(d.bounds, d.material("mat", _BRIGHT), 0.001)
    d.print(mat.top(0.0).inset(x=0.1).place(width=0.008), "white plastic")
    for mark in mat.top(0.0).share(x=(0.1, 0.9), y=(0.3, 0.7)).split("x", 5):
        d.print(mark.place(depth=0.008), "white plastic")


@draws("exercise_mat", whole=True)
def exercise_mat(d: Drawing) -> None:
    """A thick folding gymnastics mat of three or four panels, with handles."""
    look = d.material("mat", "blue plastic, red plastic, grey plastic, green plastic, black leather")
    for panel in d.bounds.inset(y=0.005).split("x", d.integer("panels", 3, 4), gap=0.002):
        d.box(panel, look, 0.008)
    with d.mirror("y"):
        d.box(d.bounds.left(0.012).share(z=(0.4, 0.6)).place(depth=0.16), "black leather", 0.002)


@draws("exercise_ball", "medicine_ball", whole=True, even="cube")
def exercise_ball(d: Drawing) -> None:
    """A big ball with grooves, or a heavy one of panels with seams."""
    r = d.size.depth / 2
    box = Box.sized(2 * r, 2 * r, 2 * r)
    seams: list[tuple[float, Axis, float, Look]]
    if d.category.name == "medicine_ball":
        look = d.material("ball", "brown leather, tan leather, black leather, red plastic, blue plastic")
        seams = [(0.0, axis, 0.003, "black leather") for axis in ("x", "y", "z")]
    else:
        look = d.material("ball", _BRIGHT, "red plastic")
        seams = [(k, "z", 0.006, look) for k in (-0.45, -0.3, 0.3, 0.45)]
    d.ball(box, look, 28)
    d.cylinder(box.bottom(0.02).place(0.46 * r, 0.46 * r), look, segments=16)  # it rests on a small flat
    for share, axis, wire, color in seams:
        side = 2 * (math.sqrt(1 - share**2) * r - 0.001)
        d.hoop(Box.around((0.0, 0.0, r + share * r), side, side, side), wire, color, axis, 20)


@draws("foam_roller", whole=True)
def foam_roller(d: Drawing) -> None:
    """A ribbed roll of foam with a hollow core."""
    look, box = d.material("roll", _BRIGHT, "orange plastic"), d.bounds
    core = box.inset(x=0.003, z=0.003)
    d.cylinder(core, look, "y", bevel=0.006)
    d.cylinder(core.share(x=(0.22, 0.78), z=(0.22, 0.78)).inset(y=-0.0003), "black plastic", "y", segments=20)
    for rib in box.share(y=(0.04, 0.96)).columns(5, gap=0.06 * box.width):
        d.cylinder(rib, look, "y", bevel=0.003)


@draws("aerobic_step", whole=True)
def aerobic_step(d: Drawing) -> None:
    """A stepping board with a rubber top on stacked blocks."""
    look = d.material("body", "black plastic, grey plastic, blue plastic")
    block = d.material("blocks", "blue plastic, green plastic, red plastic, grey plastic, lilac plastic")
    board = d.box(d.bounds.top(0.07).inset(top=0.008), look, 0.015)
    d.box(board.top(-0.008).inset(x=0.03, y=0.03, bottom=-0.002), "rubber", 0.003)
    with d.mirror("y"):
        legs = d.bounds.inset(top=0.07, x=0.01).left(0.3).inset(left=0.02)
        for stacked in legs.rows(max(1, round(legs.height / 0.05))):
            d.box(stacked, block, 0.01)


@draws("trampoline", whole=True, even="round")
def trampoline(d: Drawing) -> None:
    """A small indoor trampoline: mat, padded rim, legs, with a handle in some."""
    pad = d.material("pad", "blue plastic, green plastic, pink plastic, red plastic, black plastic")
    r, h = d.size.depth / 2, d.size.height
    z = 0.24 if h > 0.5 else h - 0.02
    d.cylinder(Box.sized(1.68 * r, 1.68 * r, 0.015, (0.0, 0.0, z - 0.03)), "black fabric", segments=32)
    turn = (np.arange(16) + 0.5) * (np.pi / 8)
    section = np.array([(0.09, -0.02), (0.09, 0.012), (0.0, 0.02), (-0.09, 0.012), (-0.09, -0.02)]) * (r, 1.0)
    d.sweep(np.c_[0.9 * r * np.cos(turn), 0.9 * r * np.sin(turn), 0 * turn + z - 0.005], section, pad, closed=True)
    with d.ring(6, 0.88 * r, math.pi / 6):
        d.bar((0.0, 0.0, 0.0), (0.0, 0.0, z - 0.02), 0.016, "steel")
        d.cylinder(Box.sized(0.048, 0.048, 0.03), "rubber", segments=12)
    if h > 0.5:
        half = [(0.0, 0.25, 0.03), (0.03, 0.25, 0.6 * h), (-0.08, 0.25, h - 0.02)]
        with d.at(0.86 * r):
            d.sweep([*half, *((x, -y, t) for x, y, t in reversed(half))], 0.016, "steel")
            d.bar((-0.08, -0.23, h - 0.02), (-0.08, 0.23, h - 0.02), 0.022, "rubber")


@draws("punching_bag", "heavy_bag", whole=True, even="round")
def punching_bag(d: Drawing) -> None:
    """A bag on a weighted foot, or a long one on four chains under the ceiling."""
    box, hangs = d.bounds, d.category.name == "heavy_bag"
    skin = d.material("skin", "black leather, brown leather, red plastic", *(() if hangs else ("blue plastic",)))
    if hangs:
        bag = box.inset(top=0.4)
        d.revolve([(0.06, box.height - 0.02), (0.06, box.height)], "black steel", 20)
        with d.part("chains"):
            with d.ring(4, start=math.pi / 4):
                d.bar((0.42 * bag.depth, 0.0, bag.height - 0.01), (0.0, 0.0, box.height - 0.15), 0.006, "steel", 6)
            d.bar((0.0, 0.0, box.height - 0.16), (0.0, 0.0, box.height - 0.02), 0.01, "steel", segments=8)
    else:
        d.turned(box.bottom(0.34), [(1, 0), (1, 0.06), (0.93, 0.6), (0.6, 0.9), (0.3, 1)], "black plastic", 28)
        d.cylinder(Box.sized(0.1, 0.1, 0.19, (0.0, 0.0, 0.33)), "steel", segments=16)
        wide = 2 * min(0.19, 0.34 * box.depth)
        bag = box.inset(bottom=0.5).place(wide, wide)
    with d.part("bag"):
        d.turned(bag, [(0.87, 0), (1, 0.025), (1, 0.97), (0.85, 1)], skin)
        for share in (0.14, 0.82):
            band(d, bag.share(z=(share, share + 0.045)), "white leather")
