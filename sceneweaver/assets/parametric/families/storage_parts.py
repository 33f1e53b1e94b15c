"""What storage furniture shares: closed cases with a top, open cases of boards that carry things, rear panels."""

from __future__ import annotations

from collections.abc import Sequence

from ...drawing import Box, Drawing
from ...drawing.components import board_top, carcass, compartments, feet
from ...drawing.drawing import Look

BOARD = 0.018
"""Thickness of a case's boards [m]."""


def closed_case(d: Drawing, case: Box, wood: Look, base: str, foot: float, over: float, thick: float = 0.022) -> Box:
    """A carcass on feet of a style, under a top that stands over it; returns the room for flush fronts."""
    feet(d, case.bottom(foot), wood, base)
    room = carcass(d, case.inset(bottom=foot, top=thick), wood)
    board_top(d, case.top(thick), wood, over)
    return room


def inner_boards(d: Drawing, room: Box, count: int, wood: Look, name: str = "inside") -> None:
    """Boards behind doors, which are no surfaces; what is between them are interiors."""
    rooms = room.inset(front=0.03).rows(count + 1, gap=BOARD)
    for level in rooms[1:]:
        d.box(level.bottom(-BOARD), wood, bevel=0.0)
    compartments(d, rooms, name)


def rear_panels(d: Drawing, box: Box, sheet: Look, strip: Look, count: int) -> None:
    """Thin sheets side by side that close the back of a case, with strips over their joints, as seen from behind."""
    cells = box.columns(count, gap=0.004)
    for k, cell in enumerate(cells):
        d.box(cell, sheet, bevel=0.0)
        if k:
            d.box(Box(box.x, (cell.y[0] - 0.012, cell.y[0] + 0.008), box.z).inset(back=-0.003), strip, bevel=0.0)


def open_case(d: Drawing, case: Box, wood: Look, board: float, rear: Look | None = None) -> Box:
    """The sides and the back of a case of shelves, each a part; returns the room between them, as high as the case."""
    for name, side in (("side-0", case.right(board)), ("side-1", case.left(board))):
        with d.part(name):
            d.box(side, wood, bevel=0.0015)
    room = case.inset(y=board)
    with d.part("back"):
        d.box(room.back(0.006), rear or wood, bevel=0.0)
    return room.inset(back=0.006)


def boards(d: Drawing, rooms: Sequence[Box], look: Look, board: float, first: int = 1, ends: bool = True) -> None:
    """A board under each of some rooms, as a part and a surface; the rooms before ``first`` stand on what is there.

    Without ``ends`` the highest room has no ceiling, and its surface is called "top".
    """
    for k, room in enumerate(rooms):
        last = not ends and k + 1 == len(rooms)
        plate = room.bottom(-board)
        if k >= first:
            with d.part(f"shelf-{k}"):
                d.box(plate, look, bevel=0.0015)
        name, headroom = ("top", None) if last else (f"shelf-{k}", round(room.height - 0.003, 4))
        d.surface(name, plate, headroom, inset=0.005)
