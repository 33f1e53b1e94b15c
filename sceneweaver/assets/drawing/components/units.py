"""Units of fitted furniture: carcasses behind doors and drawers that cover them."""

from __future__ import annotations

from typing import Literal

from ..box import Box
from ..drawing import Drawing, Look
from .cases import carcass
from .cavities import compartments
from .fronts import FRONT, doors, drawer, drawers

Layout = Literal["door", "doors", "drawer", "drawers", "mixed"]

BOARD = 0.018
"""Thickness of the boards of a unit, whose edges its fronts cover [m]."""


def fronts(
    d: Drawing,
    name: str,
    box: Box,
    layout: Layout,
    leaf: Look,
    pull: Look,
    style: str = "bar",
    panel: Look | None = None,
    grip: float = 0.8,
) -> None:
    """Doors and drawers over the whole front of a box, whose depth their drawers have.

    Args:
        d: The drawing.
        name: What the names of doors and drawers begin with.
        box: The unit; the fronts end at its front.
        layout: "door" (two if it is wide), "doors", "drawer", "drawers", or "mixed" (a drawer over doors).
        leaf: Of doors and of drawers' fronts.
        pull: Of the handles.
        style: Of the handles.
        panel: What framed doors have in their frames; None: plain ones.
        grip: At which share of their height doors have their handles.
    """
    low = box
    if layout in ("drawer", "drawers"):
        weights = [1.0] if layout == "drawer" else [0.38, 0.38, 0.24] if box.height > 0.5 else [1.0, 1.0]
        drawers(d, box, weights, leaf, pull, style, name=f"{name}-drawer", overlay=BOARD)
        return
    if layout == "mixed":
        drawer(d, f"{name}-drawer", box.top(0.16), leaf, pull, style, overlay=BOARD)
        low = box.inset(top=0.16)
    count = 2 if layout == "doors" or box.width > 0.62 else 1
    doors(d, low.front(FRONT), count, leaf, pull, style, panel, f"{name}-door", grip)


def unit(
    d: Drawing,
    name: str,
    box: Box,
    layout: Layout,
    body: Look,
    leaf: Look,
    pull: Look,
    style: str = "bar",
    panel: Look | None = None,
    boards: int = 1,
    grip: float = 0.8,
) -> Box:
    """A carcass with `fronts`, and so many boards behind its doors; returns the room inside."""
    case = box.inset(front=FRONT + 0.001)
    room = carcass(d, case, body, BOARD)
    if layout in ("door", "doors"):
        rooms = room.inset(front=0.03).rows(boards + 1, gap=BOARD)
        for level in rooms[1:]:
            d.box(level.bottom(-BOARD), body, bevel=0.0)
        if boards:  # without any, somebody else draws them
            compartments(d, rooms, name)
    elif layout == "mixed":
        compartments(d, [room.to(z=(room.z[0], box.z[1] - 0.16 - BOARD))], name)
    fronts(d, name, box.inset(back=room.x[0] - box.x[0]), layout, leaf, pull, style, panel, grip)
    return room
