"""Fronts: handles, drawers with boxes, doors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from ...body import Material
from ..box import Box, Vec3
from ..drawing import Drawing, Look
from ..tree import vec3

REACH = {"bar": 0.025, "knob": 0.025, "cup": 0.022, "lip": 0.022, "none": 0.0}
"""How far a handle stands out of its front [m]."""

FRONT = 0.018
"""Thickness of a drawer's front [m]."""

SWING = math.radians(95.0)
"""Angle [rad] to which a door opens, as on common hinges: its handle stays clear of what stands beside it."""


def pulls(d: Drawing, body: Material, *styles: str) -> tuple[str, Material, float]:
    """A style of handle, a metal that shows on the body, and how far it stands out [m]."""
    style = d.pick("pull style", styles or ("bar", "knob", "cup"))
    dark = body.darker(0.25)
    metals = ("brass", "brushed steel", "steel") if dark else ("black steel", "brass", "brushed steel")
    return style, d.material("pulls", *metals), REACH[style]


def handle(
    d: Drawing, face: Box, material: Look, style: str = "bar", length: float = 0.12, upright: bool = False
) -> None:
    """A handle in the middle of a box's front: "bar", "knob", "cup", "none" or a "lip" along its top; see `REACH`."""
    x, y, z = face.anchor("front")
    into, up, across = (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0)
    if style == "none":
        return
    if style == "knob":
        with d.handle("knob", (x + 0.019, y, z), into, across, 0.028, 0.028), d.at(x, y, z, pitch=math.pi / 2):
            d.revolve([(0.006, 0.0), (0.006, 0.012), (0.014, 0.018), (0.012, 0.025)], material, segments=12)
    elif style == "cup":
        cup = Box.around((x + 0.011, y, z - 0.002), 0.022, 0.7 * length, 0.026)
        with d.handle("cup", cup.center, into, up, cup.height, cup.width):
            d.box(cup, material, bevel=0.008)
    elif style == "lip":
        lip(d, face.front(-REACH[style]).top(0.028).inset(y=0.03, top=0.012), material)
    else:
        with d.at(x, y, z, roll=math.pi / 2 if upright else 0.0):
            half = length / 2
            with d.handle("bar", (0.02, 0.0, 0.0), into, up, 0.01, length):
                d.bar((0.02, -half, 0.0), (0.02, half, 0.0), 0.005, material, segments=8)
                with d.mirror("y"):
                    d.box(Box.around((0.009, 0.76 * half, 0.0), 0.018, 0.008, 0.008), material, bevel=0.0)


def bar_pull(
    d: Drawing, start: Vec3, end: Vec3, metal: Look, radius: float = 0.011, out: float = 0.032, inset: float = 0.06
) -> None:
    """A bar before a front on two posts, that a hand comes to along -x.

    ``start`` and ``end`` lie on the front; the bar's middle line stands ``out`` metres before it, and the posts come in
    by a share ``inset`` of its length.
    """
    a, b = np.array(start), np.array(end)
    along, reach = b - a, np.array([out, 0.0, 0.0])
    closing = (0.0, 1.0, 0.0) if abs(along[2]) > abs(along[1]) else (0.0, 0.0, 1.0)
    grip, length = vec3((a + b) / 2 + reach), float(np.linalg.norm(along))
    with d.handle("bar", grip, (-1.0, 0.0, 0.0), closing, 2 * radius, length):
        d.bar(vec3(a + reach), vec3(b + reach), radius, metal, 10)
        for share in (inset, 1 - inset):
            x, y, z = vec3(a + share * along)
            d.bar((x - 0.001, y, z), (x + out, y, z), 0.75 * radius, metal, 8)


def lip(d: Drawing, box: Box, material: Look, closing: Vec3 = (0.0, 0.0, 1.0), bevel: float = 0.003) -> None:
    """A lip or tab on a front that fills a box, for fingers that come along -x and close along y or z."""
    upright = closing[2] > closing[1]
    width, length = (box.height, box.width) if upright else (box.width, box.height)
    with d.handle("lip", box.center, (-1.0, 0.0, 0.0), closing, width, length):
        d.box(box, material, bevel)


def drawer(
    d: Drawing,
    name: str,
    box: Box,
    front: Look,
    pull: Look,
    style: str = "bar",
    travel: float | None = None,
    inside: Look = "birch",
    overlay: float = 0.0,
    label: bool = False,
) -> Box:
    """A drawer that slides: a front that ends at the box's front with a gap of 2 mm around it, and a box behind it.

    The box behind has a bottom, two sides and a back, and stays 12 mm off the case at the sides, of which the front
    covers ``overlay`` [m]. It comes out by ``travel`` [m], unless told by three quarters of its depth. A card in
    a metal holder over its handle is its ``label``. Returns the room inside.
    """
    own = box.inset(y=0.002, z=0.002)
    with d.slide(name, limits=(0.0, round(0.75 * box.depth if travel is None else travel, 3))):
        face = d.box(own.front(FRONT), front)
        tray = own.inset(
            front=FRONT, back=0.01, y=0.012 + overlay, bottom=0.012 + overlay, top=min(0.03, 0.25 * box.height)
        )
        if min(tray.size) > 0.03:
            d.box(tray.bottom(0.004), inside, bevel=0.0)
            walls = tray.inset(bottom=0.004)
            for side in (walls.left(0.009), walls.right(0.009), walls.inset(y=0.009).back(0.009)):
                d.box(side, inside, bevel=0.0)
        handle(d, face, pull, style, min(0.16, 0.4 * box.width))
        if label:
            holder = d.box(face.front(-0.003).place(width=0.09, height=0.036).move(z=0.05), pull, bevel=0.001)
            d.print(holder.front(0.0).inset(y=0.007, z=0.006), "paper")
        room = tray.inset(bottom=0.004, y=0.009, back=0.009)
        if min(tray.size) > 0.03:
            d.interior("inside", room)
    return room


def drawers(
    d: Drawing,
    box: Box,
    rows: int | Sequence[float],
    front: Look,
    pull: Look,
    style: str = "bar",
    columns: int | Sequence[int] = 1,
    name: str = "drawer",
    overlay: float = 0.0,
) -> None:
    """Rows of drawers from the bottom up with these weights, each row in so many columns; ``overlay`` as for one."""
    number = 0
    levels = box.rows(rows)
    counts = [columns] * len(levels) if isinstance(columns, int) else columns
    for level, count in zip(levels, counts, strict=True):
        for cell in level.columns(count):
            drawer(d, f"{name}-{number}", cell, front, pull, style, overlay=overlay)
            number += 1


def door(
    d: Drawing,
    name: str,
    box: Box,
    leaf: Look,
    pull: Look,
    hung: Literal["left", "right"] = "left",
    style: str = "bar",
    panel: Look | None = None,
    grip: float = 0.5,
) -> Box:
    """A door leaf that fills a box, as thick as it is deep, hinged at its left (+y) or right; it opens outward.

    With ``panel`` it is a frame of the leaf's finish around a thinner panel (glass, say). ``grip`` is the share of its
    height at which its handle is, unless it is as high as a man's chest.
    """
    own = box.inset(y=0.0015, z=0.0015)
    limits = (0.0, SWING) if hung == "left" else (-SWING, 0.0)
    with d.hinge(name, own.anchor(f"front {hung} bottom"), limits=limits):
        if panel is None:
            d.box(own, leaf)
        else:
            rim = min(0.06, 0.2 * own.width)
            for stile in (own.left(rim), own.right(rim)):
                d.box(stile, leaf)
            for rail in (own.bottom(rim), own.top(rim)):
                d.box(rail.inset(y=rim), leaf)
            d.box(own.inset(y=rim, z=rim).place(depth=0.006), panel, bevel=0.0)
        reach = min(0.05, 0.15 * own.width)
        long = min(0.2, 0.5 * own.height)
        if style == "cup":  # it lies along the leaf's width, and stays on the leaf
            long = min(long, 2 * (reach - 0.003) / 0.7)
        y = own.y[0] + reach if hung == "left" else own.y[1] - reach
        z = own.z[0] + max(0.6 * long, min(grip * own.height, own.height - 0.6 * long))
        if own.height > 1.2:
            z = min(max(1.05, own.z[0] + 0.1), own.z[1] - long)
        handle(d, Box(own.x, (y, y), (z, z)), pull, style, long, upright=True)
    return own


def doors(
    d: Drawing,
    box: Box,
    count: int,
    leaf: Look,
    pull: Look,
    style: str = "bar",
    panel: Look | None = None,
    name: str = "door",
    grip: float = 0.5,
) -> None:
    """Doors side by side over a box, hung in pairs that meet in their middle; a single one is hung left."""
    for k, cell in enumerate(box.columns(count)):
        hung = "right" if count > 1 and k % 2 == 0 else "left"
        door(d, f"{name}-{k}", cell, leaf, pull, hung, style, panel, grip)
