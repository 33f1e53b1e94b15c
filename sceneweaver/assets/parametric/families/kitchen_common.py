"""What a kitchen shares: finishes that match, worktops, plinths, burners, oven doors."""

from __future__ import annotations

from typing import NamedTuple

from ...body import Material
from ...drawing import Box, Drawing
from ...drawing.components import handle, knob
from ...drawing.drawing import Look

WORKTOPS = ("oak", "walnut", "marble", "dark marble", "granite", "concrete", "beech")
COATS = ("brushed steel", "white paint", "black paint", "steel")
"""Finishes of the appliances of a kitchen, which match in a suite."""

LEAVES = ("white paint", "oak", "sage paint", "navy paint", "light grey paint", "walnut", "cream paint")
MORE_LEAVES = ("black paint", "teal paint", "light oak", "pine", "grey paint")

SETBACK = 0.027
"""How far the fronts of units lie behind the front of their worktop [m], which covers their handles."""

PLINTH = 0.1
"""Height of the plinth under base units [m]."""


class Fittings(NamedTuple):
    """What `unit` and `fronts` take at their end: finishes, the style of handles, and the panel of framed doors."""

    leaf: Material
    pull: Material
    style: str
    panel: Look | None


def finishes_of(d: Drawing) -> tuple[Material, Fittings]:
    """Finish of the carcasses of a kitchen, and its fronts, the same for all pieces of a suite."""
    leaf = d.material("fronts", *LEAVES, *MORE_LEAVES)
    # The sides that are seen at the end of a run are faced like its fronts.
    body = leaf if d.in_suite else d.material("body", "white paint", "light grey paint")
    pull = d.material("pulls", "black steel", "brass", "steel", "bronze")
    shaker = d.style in ("classic", "rustic", "scandinavian") and d.chance("shaker", 0.75, matched=True)
    style = d.pick("pull style", ["bar", "bar", "knob", "cup"], matched=True)
    return body, Fittings(leaf, pull, style, leaf if shaker else None)


def worktop_of(d: Drawing) -> tuple[Material, float]:
    """Finish and thickness [m] of a worktop, the same for all pieces of a suite."""
    return d.material("top", *WORKTOPS), d.pick("top thickness", [0.02, 0.03, 0.04], matched=True)


def coat_of(d: Drawing, *more: str) -> Material:
    """Finish of an appliance, the same for all of a suite; one that stands alone in no room may have one of ``more``.

    It is a choice of its own, so that a room's paint or copper does not become that of its hood.
    """
    alone = not d.in_suite and not d.in_room
    return d.material("body", d.pick("coat", (*COATS, *more) if alone else COATS, matched=True))


def plinth(d: Drawing, box: Box) -> None:
    """Boards across the front and the sides of a box, set back from its front, on which base units stand."""
    own = box.inset(back=0.02, front=0.05, y=0.002)
    for board in (own.front(0.016), own.inset(front=0.016).left(0.016), own.inset(front=0.016).right(0.016)):
        d.box(board, "black plastic", bevel=0.0)


def worktop(d: Drawing, box: Box, material: Look, hole: Box) -> Box:
    """A worktop with a rectangular hole."""
    across = box.to(x=hole.x)
    parts = (box.to(x=(box.x[0], hole.x[0])), box.to(x=(hole.x[1], box.x[1])))
    for part in (*parts, across.to(y=(box.y[0], hole.y[0])), across.to(y=(hole.y[1], box.y[1]))):
        d.box(part, material, bevel=0.0)
    return box


def feet(d: Drawing, box: Box, radius: float = 0.018) -> None:
    """Four low round feet under the corners of a box, as high as it is."""
    with d.corners(box, inset=0.05):
        d.cylinder(Box.sized(2 * radius, 2 * radius, box.height), "black plastic", segments=12)


def burners(d: Drawing, top: Box, gas: bool, count: int = 4) -> None:
    """Places to cook on the top of a box: rings printed on glass, or gas burners under iron grates of 35 mm."""
    columns = top.top(0.0).columns(2 if count <= 4 else 3)
    for j, column in enumerate(columns):
        for i, cell in enumerate(column.split("x", 2)):
            radius = min(cell.depth, cell.width) * (0.40 if (i + j) % 2 else 0.31)
            with d.at(*cell.center):
                if gas:
                    d.cylinder(Box.sized(1.24 * radius, 1.24 * radius, 0.012), "iron", ends=(1.0, 0.8), segments=16)
                    cap = Box.sized(0.72 * radius, 0.72 * radius, 0.011, (0.0, 0.0, 0.011))
                    d.cylinder(cap, "black steel", ends=(1.0, 0.9), segments=16)
                    continue
                with d.no_colliders():
                    for k, size in enumerate((radius, radius - 0.003, 0.5 * radius, 0.5 * radius - 0.003)):
                        ring = Box.sized(2 * size, 2 * size, 0.0011 + 0.0001 * k, (0.0, 0.0, -0.001))
                        d.cylinder(ring, "black glass" if k % 2 else "grey plastic", segments=28)
        if gas:
            grate = column.inset(x=0.01, y=0.007).to(z=(top.z[1], top.z[1] + 0.035))
            for bar in (grate.left(0.01), grate.right(0.01)):
                d.box(bar, "iron", bevel=0.0)
            upper = grate.top(0.011)
            ends = (upper.anchor("back bottom"), upper.anchor("front bottom"))
            with d.at(x=0.005), d.along(ends[0], (ends[1][0] - 0.01, *ends[1][1:]), 5):
                d.box(Box.sized(0.01, upper.width, 0.011), "iron", bevel=0.0)


def oven_door(d: Drawing, name: str, leaf: Box, material: Look, pull: Look, handled: bool = True) -> None:
    """A door with a window and a bar across its top; it falls open about its lower edge."""
    with d.hinge(name, leaf.anchor("front bottom"), axis=(0.0, 1.0, 0.0), limits=(0.0, 1.5)):
        side, low, high = 0.12 * leaf.width, 0.15 * leaf.height, 0.26 * leaf.height
        for part in (leaf.left(side), leaf.right(side)):
            d.box(part, material)
        between = leaf.inset(y=side)
        for part in (between.bottom(low), between.top(high)):
            d.box(part, material)
        d.box(between.inset(bottom=low, top=high).place(depth=0.006), "smoked glass", bevel=0.0)
        if handled:
            # Low enough for fingers below the knobs over it.
            handle(d, leaf.top(max(0.5 * high, 0.066)), pull, "bar", 0.78 * leaf.width)


def knobs(d: Drawing, row: Box, count: int, material: Look, radius: float = 0.019, first: int = 0) -> None:
    """Turning knobs side by side on a box's front, each with a white mark; they are numbered from ``first``."""
    for k, place in enumerate(row.columns(count), start=first):
        knob(d, place, material, radius, 0.022, "white plastic", f"knob-{k}")
