"""What tables share: tops, aprons, ends, pedestals, cases of drawers under a top."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from ... import shapes
from ...drawing import Box, Drawing
from ...drawing.components import beam, carcass, drawers, oval
from ...drawing.drawing import Look


def tabletop(
    d: Drawing,
    box: Box,
    material: Look,
    corner: float = 0.015,
    power: float | None = None,
    edge: str = "soft",
    name: str | None = "top",
) -> Box:
    """A top that fills a box and is a surface: with round corners, or with a power an ellipse (2) or a squarer oval.

    A "knife" edge is cut away underneath.
    """

    def ring(inset: float, z: float) -> np.ndarray:
        own = box.inset(x=inset, y=inset)
        return oval(own, z, power, count=48) if power else shapes.rectangle(own.x, own.y, z, corner, 4)

    (low, high), cut = box.z, min(0.004, 0.3 * box.height)
    sides = ((cut, low), (0.0, low + cut), (0.0, high - cut), (cut, high))
    if edge == "knife":
        sides = ((min(0.05, 1.6 * box.height), low), (0.0, high - 0.35 * box.height), (0.0, high))
    d.loft([ring(*side) for side in sides], material, convex=True)
    if name:
        d.surface(name, box, polygon=ring(0.01, high)[:, :2][:: 2 if power else 1])
    return box


def planks(
    d: Drawing, box: Box, material: Look, ends: float = 0.0, name: str | None = "top", wide: float = 0.14
) -> Box:
    """A top of boards along y with cut edges; ``ends`` is the width of the boards across its two ends."""
    for end in (box.left(ends), box.right(ends)) if ends else ():
        d.box(end, material, bevel=0.0014)
    for board in box.inset(y=ends).split("x", max(3, round(box.depth / wide))):
        d.box(board, material, bevel=0.0014)
    if name:
        d.surface(name, box, inset=0.01)
    return box


def drawer_case(
    d: Drawing,
    box: Box,
    body: Look,
    front: Look,
    pull: Look,
    style: str,
    rows: int | Sequence[float] = 1,
    columns: int = 1,
    name: str = "drawer",
) -> None:
    """A case whose whole front is drawers, which end at the front of the box."""
    carcass(d, box.inset(front=0.019), body, board=0.012)
    drawers(d, box.inset(back=0.006), rows, front, pull, style, columns, name, overlay=0.012)


def pedestal_of_drawers(
    d: Drawing,
    box: Box,
    body: Look,
    front: Look,
    pull: Look,
    style: str,
    count: int = 3,
    name: str = "drawer",
    foot: float = 0.05,
) -> None:
    """A case of drawers on a dark base, the lowest drawer high enough for files; one part."""
    with d.part(f"{name} stack"):
        d.box(box.bottom(foot).inset(back=0.03, front=0.05, y=0.02), "black plastic", bevel=0.0)
        weights = [1.8, *[1.0] * (count - 1)]
        drawer_case(d, box.inset(bottom=foot), body, front, pull, style, weights, name=name)


def board_between(
    d: Drawing, box: Box, look: Look, z: float, inset: float, ceiling: float, thick: float = 0.02
) -> None:
    """A board between legs with its top at a height, on which things may stand ``inset`` from its edges."""
    with d.part("shelf"):
        board = d.box(box.to(z=(z - thick, z)), look)
    d.surface("shelf", board, round(ceiling - z - 0.005, 4), inset)


def ends(d: Drawing, under: Box, look: Look, style: str, bar: float, inset: float, over: float) -> Box:
    """Two frames that carry a table, ``inset`` from its long sides and ``over`` from its ends; the room between."""
    with d.mirror("y"), d.part("end"):
        end_frame(d, under.inset(x=inset, left=over).left(bar), look, style)
    return under.inset(y=over + bar)


def end_frame(d: Drawing, box: Box, material: Look, style: str) -> None:
    """What carries one end of a table: as thick as the box is wide; "loop", "vee", "cross", "a" or "trestle"."""
    bar, (x0, x1), (low, high) = box.width, box.x, box.z
    x, y, _ = box.center
    half, r = box.depth / 2, box.width / 2
    if style == "loop":
        for post in (box.back(bar), box.front(bar)):
            d.box(post, material)
        for rail in (box.bottom(bar), box.top(bar)):
            d.box(rail.inset(x=bar), material)
        return
    if style == "trestle":
        for rail, shares in ((box.top(0.07), (0.5, 0.96)), (box.inset(bottom=0.04).bottom(0.04), (1.0, 0.6))):
            ends = [(half * share, z) for share, z in zip(shares, rail.z, strict=True)]
            d.hull([(x + s * dx, w, z) for dx, z in ends for s in (-1, 1) for w in rail.inset(y=-0.3 * r).y], material)
        for foot in (box.back(0.09), box.front(0.09)):
            d.box(foot.bottom(0.04).inset(y=-0.3 * r), material)
        d.box(box.inset(bottom=0.08, top=0.07).place(depth=0.14), material, bevel=0.008)
        return
    feet, heads = {"vee": (0.45 * half, half - r), "cross": (half - r, r - half), "a": (half - r, 0.4 * half)}[style]
    thick = 1.4 * bar if style == "cross" else bar
    for side in (-1, 1):
        section = [(dx, dy) for dx in (-thick / 2, thick / 2) for dy in (-r, r)]
        ends = ((feet, low), (heads, high - 0.02))
        d.hull([(x + side * at + dx, y + dy, z) for at, z in ends for dx, dy in section], material)
    d.box(box.top(0.04 if style != "vee" else 0.02).inset(x=0.0 if style == "vee" else 0.06), material)
    if style == "a":
        beam(d, (x0 + 0.12, y, 0.25), (x1 - 0.12, y, 0.25), material, 0.7 * bar, bar)
    elif style == "vee":
        d.box(box.bottom(0.02).place(depth=0.6 * box.depth), material)


PEDESTALS = {
    "tulip": ((1.0, 0.0), (1.0, 0.008), (0.72, 0.02), (0.42, 0.05)),
    "disc": ((1.0, 0.0), (1.0, 0.012), (0.96, 0.018), (0.2, 0.028)),
}
"""Profiles of round feet: radius as a share of the foot's, and height [m]."""


def pedestal(d: Drawing, high: float, radius: float, material: Look, style: str, slim: float = 1.0) -> None:
    """A central foot under a round top, up to a height: "tulip", "disc", "claw", "drum", "iron" or "cross"."""
    plate = 0.5 * radius
    with d.part("foot"):
        if style in PEDESTALS:
            d.revolve([(radius * r, z) for r, z in PEDESTALS[style]], material, 28)
        elif style == "claw":
            knee = [(plate, y, z) for y in (-0.022, 0.022) for z in (0.075, 0.13)]
            claw = [(radius - 0.03, y, 0.0) for y in (-0.022, 0.022)]
            claw += [(radius, y, z) for y in (-0.018, 0.018) for z in (0.0, 0.04)]
            with d.ring(4, 0.0, math.pi / 4):
                d.hull([(0.03, y, z) for y in (-0.025, 0.025) for z in (0.12, 0.2)] + knee, material)
                d.hull(knee + claw, material)
        elif style == "iron":
            curve = ((0.03, 0.26), (0.05, 0.14), (0.12, 0.06), (radius - 0.03, 0.03), (radius - 0.012, 0.012))
            with d.ring(4, 0.0, math.pi / 4):
                d.sweep([(x, 0, z) for x, z in curve], 0.012, material, 8)
                d.cylinder(Box.sized(0.04, 0.04, 0.02, (radius - 0.02, 0, 0)), material, ends=(1.0, 0.8), segments=12)
            d.cylinder(Box.sized(0.09, 0.09, 0.2, (0, 0, 0.08)), material, ends=(1.0, 0.67), segments=16)
        elif style == "drum":
            wide = 1.24 * radius
            d.cylinder(Box.sized(wide, wide, high - 0.03), material, ends=(1.0, 0.8), bevel=0.006, segments=28)
        else:
            foot = [(x, y, z) for x in (-0.028, radius) for y in (-0.028, 0.028) for z in (0.0, 0.022)]
            with d.ring(4, 0.0, math.pi / 4):
                d.hull(foot + [(x, y, 0.05) for x in (-0.028, 0.05) for y in (-0.028, 0.028)], material)
    with d.part("column"):
        if style == "tulip":
            waist = [(0.07, 0.13), (0.048, 0.24), (0.045, 0.4 * high + 0.1), (0.05, 0.75 * high), (0.075, 0.9 * high)]
            d.revolve([(0.42 * radius, 0.05), *((r * slim, z) for r, z in waist), (1.1 * plate, high)], material)
        elif style == "claw":
            rings = ((0.04, 0.07), (0.06, 0.1), (0.06, 0.2), (0.04, 0.23), (0.075, 0.3), (0.085, 0.38), (0.055, 0.5))
            head = ((0.04, 0.56), (0.06, 0.58), (0.06, high - 0.06), (plate, high - 0.03), (plate, high))
            d.revolve([*rings, *head], material, 20)
        elif style == "drum":
            d.cylinder(Box.sized(1.4 * radius, 1.4 * radius, 0.03, (0, 0, high - 0.03)), material, segments=28)
        else:
            d.cylinder(Box.sized(0.076 * slim, 0.076 * slim, high - 0.028, (0, 0, 0.02)), material, segments=20)
            d.cylinder(Box.sized(radius, radius, 0.008, (0, 0, high - 0.008)), material, segments=20)
