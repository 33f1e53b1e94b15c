"""Cases of boards: carcasses, shelves, tops, mouldings, slatted sides."""

from __future__ import annotations

from ..box import Axis, Box
from ..drawing import Drawing, Look
from .cavities import compartments


def carcass(
    d: Drawing, box: Box, material: Look, board: float = 0.018, back: float = 0.006, inside: Look | None = None
) -> Box:
    """Two sides, a bottom, a top and a back, open in front; returns the room inside."""
    for side in (box.left(board), box.right(board)):
        d.box(side, material, bevel=0.0015)
    inner = box.inset(y=board)
    for level in (inner.bottom(board), inner.top(board)):
        d.box(level, material, bevel=0.0015)
    d.box(inner.inset(z=board).back(back), inside or material, bevel=0.0)
    return inner.inset(z=board, back=back)


def walls(d: Drawing, box: Box, material: Look, thick: float = 0.02, bevel: float = 0.003) -> Box:
    """Four upright boards around a box, as rails under a table's top or the walls of a crate; returns the box."""
    for side in box.walls(thick):
        d.box(side, material, bevel)
    return box


def shelves(
    d: Drawing,
    room: Box,
    count: int,
    material: Look,
    board: float = 0.018,
    inset: float = 0.0,
    name: str | None = "shelf",
    floor: bool = True,
) -> list[Box]:
    """So many boards in a room, evenly, each a surface, and so is the room's floor; returns the rooms from below.

    Args:
        d: The drawing.
        room: What `carcass` returned.
        count: Boards between the floor and the top.
        material: What they are of.
        board: How thick they are [m].
        inset: How far they stay behind the front [m].
        name: Of the surfaces, with a number each; None: they are no surfaces but interiors, as behind doors.
        floor: Whether the room's floor is one as well.
    """
    rooms = room.inset(front=inset).rows(count + 1, gap=board)
    for k, own in enumerate(rooms):
        if k:
            d.box(own.bottom(-board), material, bevel=0.0015)
        if name and (k or floor):
            d.surface(f"{name}-{k}", own.bottom(-board), headroom=own.height, inset=0.005)
    if name is None:
        compartments(d, rooms)
    return rooms


def frame(d: Drawing, box: Box, material: Look, width: float = 0.03, bevel: float = 0.002) -> Box:
    """Four bars around what faces the front: a picture, a mirror, a pane; returns the room between them."""
    inner = box.inset(y=width)
    for bar in (box.left(width), box.right(width), inner.top(width), inner.bottom(width)):
        d.box(bar, material, bevel)
    return inner.inset(z=width)


def board_top(d: Drawing, box: Box, material: Look, over: float = 0.012, name: str | None = "top") -> Box:
    """A top that stands over its case in front and at the sides, and is a surface."""
    top = d.box(box.inset(front=-over, y=-over), material, bevel=0.004)
    if name:
        d.surface(name, top, inset=0.01)
    return top


def cornice(d: Drawing, box: Box, material: Look, over: float = 0.03) -> Box:
    """A stepped moulding on top of a case; it stands out of the box in front and at the sides."""
    for k, step in enumerate(box.rows(3), start=1):
        d.box(step.inset(front=-over * k / 3, y=-over * k / 3), material, bevel=0.002)
    return box


def slats(
    d: Drawing, box: Box, material: Look, pitch: float, size: float = 0.016, axis: Axis = "y", rounded: bool = False
) -> Box:
    """Upright bars side by side along an axis, about ``pitch`` apart, as high as the box, in its middle."""
    long = box.size["xyz".index(axis)]
    count = max(1, round(long / pitch) - 1)
    step = long / (count + 1)
    inner = box.inset(x=step) if axis == "x" else box.inset(y=step)
    first, last = ("back", "front") if axis == "x" else ("right", "left")
    with d.along(inner.anchor(f"bottom {first}"), inner.anchor(f"bottom {last}"), count):
        bar = Box.sized(size, size, box.height)
        if rounded:
            d.cylinder(bar, material, segments=8)
        else:
            d.box(bar, material, bevel=0.002)
    return box
