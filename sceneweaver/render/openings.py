"""Doors and windows: lining, leaf with panels and lever; frame, sashes, board and ledge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sceneweaver.assets.body import Material
from sceneweaver.geometry.angles import heading
from sceneweaver.geometry.shell import WALL_THICKNESS
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Door, Window

from .blocks import Builder, Finishes, wall_block
from .mouldings import Plane, disc, moulding, plate, rectangle, rod

REACH = 0.058
"""How far the architrave reaches beside the opening [m]."""

HANDLE = 1.03
"""Height of the lever [m]."""

_LINING = 0.03
_ARCHITRAVE = ((-0.01, 0.0), (REACH, 0.0), (REACH, 0.017), (0.05, 0.019), (0.012, 0.012), (0.0, 0.011), (-0.01, 0.006))
_PANEL = ((0.0, 0.0), (0.03, 0.0), (0.024, 0.005), (0.013, 0.0095), (0.004, 0.008), (0.0, 0.004))
_LEAF = 0.04  # thickness [m]
_STILE = 0.11  # width [m] of what is around the panels of a leaf


def add_door(builder: Builder, wall: Wall, door: Door, look: Finishes, panelled: bool, ajar: float | None) -> None:
    """A door in its opening.

    Args:
        builder: Takes the triangles.
        wall: The wall that it is in.
        door: The door.
        look: What the shell is made of.
        panelled: Whether the leaf has panels and is painted; else it is plain and of wood.
        ajar: How far a leaf that swings in stands open [rad]. None: somebody stands in the door, it has no leaf, and a
            bit of a corridor is behind it.
    """
    add_frame(builder, wall, door, look)
    if ajar is None:
        _corridor(builder, wall, door, look)
    else:
        add_leaf(builder, wall, leaf_span(door), door, look, panelled, ajar)


def add_frame(builder: Builder, wall: Wall, door: Door, look: Finishes, thick: float = WALL_THICKNESS) -> None:
    """Lining, architraves and threshold of a door in a wall that is ``thick`` [m]."""
    start, end, top = door.offset, door.offset + door.width, door.height
    for s in ((start, start + _LINING), (end - _LINING, end)):
        builder.prism(wall_block(wall, s, (0.0, thick)), (0.0, top), look.trim)
    builder.prism(wall_block(wall, (start, end), (0.0, thick)), (top - _LINING, top), look.trim)
    path = [(start, 0.0), (start, top), (end, top), (end, 0.0)]
    for plane in (Plane.on_wall(wall), Plane.on_wall(wall, thick)):
        for run in (path,) if builder.top > top else (path[:2], path[2:]):  # cut, it has no upper part
            moulding(builder, plane, run, _ARCHITRAVE, look.trim)
    builder.prism(wall_block(wall, (start, end), (0.0, thick)), (-0.002, 0.005), look.leaf)


def leaf_span(door: Door) -> tuple[float, float]:
    """Where along its wall the leaf of a door is [m]."""
    return door.offset + _LINING + 0.003, door.offset + door.width - _LINING - 0.003


def add_leaf(
    builder: Builder,
    wall: Wall,
    span: tuple[float, float],
    door: Door,
    look: Finishes,
    panelled: bool,
    ajar: float,
    thick: float = WALL_THICKNESS,
) -> None:
    """A leaf with panels, lever and hinges.

    Args:
        builder: Takes the triangles.
        wall: The wall that it is in.
        span: Where along it the leaf is [m].
        door: How it swings, and how high it is.
        look: What the shell is made of.
        panelled: Whether it has panels and is painted; else it is plain and of wood.
        ajar: How far one that swings in stands open [rad].
        thick: Thickness of the wall [m].
    """
    top = door.height
    far = {"out": thick - 0.006, "slide": 0.5 * (thick + _LEAF)}.get(door.swing, _LEAF + 0.006)
    at_end = door.swing == "in-right"  # left and right are those of somebody who comes in
    edge, way = (span[0], 1.0) if at_end else (span[1], -1.0)
    if ajar and door.swing.startswith("in"):
        wall = _turned(wall, span[1] if at_end else span[0], -ajar if at_end else ajar)
    faces = (Plane.on_wall(wall, far - _LEAF), Plane.on_wall(wall, far))
    front = Plane(faces[0].origin, faces[0].u, faces[0].v, -faces[0].w)
    leaf = look.trim if panelled and look.plan.doors is None else look.leaf
    builder.prism(wall_block(wall, span, (far - _LEAF, far)), (0.008, top - _LINING - 0.003), leaf)
    for plane in (front, faces[1]):
        if panelled:
            _panels(builder, plane, span, top - _LINING, leaf)
        if door.swing == "slide":
            plate(builder, plane, disc((edge + way * 0.07, HANDLE), 0.028), (0.0, 0.003), look.metal, bevel=0.001)
        else:
            _lever(builder, plane, edge + way * 0.062, way, look.metal)
    if door.swing.startswith("in"):
        hung = span[1] if at_end else span[0]
        for z in (0.22, 0.5 * top, top - 0.25):
            rod(builder, front, ((hung, z - 0.045, 0.006), (hung, z + 0.045, 0.006)), 0.007, look.metal)


def _turned(wall: Wall, hinge: float, angle: float) -> Wall:
    """The wall turned counter-clockwise about a point of it, as a leaf that hangs there is."""
    along = heading(wall.yaw + angle)
    x, y = wall.point(hinge)
    start = (x - along[0] * hinge, y - along[1] * hinge)
    end = (start[0] + along[0] * wall.length, start[1] + along[1] * wall.length)
    return replace(wall, start=start, end=end, along=along, inward=(-along[1], along[0]))


def _panels(builder: Builder, plane: Plane, span: tuple[float, float], top: float, material: Material) -> None:
    """Raised panels: two tall ones over two low ones, one over one in a narrow leaf."""
    wide = span[1] - span[0]
    if wide < 0.45 or top < 1.5:
        return
    columns = 2 if wide > 0.68 else 1
    field = (wide - (columns + 1) * _STILE) / columns
    for k in range(columns):
        a = span[0] + _STILE + k * (field + _STILE)
        for low, high in ((0.22, 0.42 * top), (0.42 * top + 0.14, top - 0.13)):
            path = rectangle((a, a + field), (low, high))
            moulding(builder, plane, path, _PANEL, material, closed=True)
            inner = rectangle((a + 0.05, a + field - 0.05), (low + 0.05, high - 0.05))
            plate(builder, plane, inner, (-0.001, 0.006), material, bevel=0.005)


def _lever(builder: Builder, plane: Plane, at: float, way: float, metal: Material) -> None:
    """A lever on a round rose, toward ``way`` along the wall, with a keyhole below."""
    plate(builder, plane, disc((at, HANDLE), 0.026, 24), (0.0, 0.009), metal, bevel=0.002)
    plate(builder, plane, disc((at, HANDLE - 0.075), 0.022, 24), (0.0, 0.006), metal, bevel=0.002)
    slot = rectangle((at - 0.003, at + 0.003), (HANDLE - 0.088, HANDLE - 0.066))
    plate(builder, plane, slot, (0.0, 0.0065), Material("keyhole", (0.05, 0.05, 0.05)))
    out = 0.048
    rod(builder, plane, ((at, HANDLE, 0.0), (at, HANDLE, out + 0.008)), 0.009, metal)
    rod(builder, plane, ((at - way * 0.008, HANDLE, out), (at + way * 0.115, HANDLE, out)), 0.0085, metal)
    rod(builder, plane, ((at + way * 0.113, HANDLE, out + 0.008), (at + way * 0.113, HANDLE, 0.02)), 0.0085, metal)


def _corridor(builder: Builder, wall: Wall, door: Door, look: Finishes) -> None:
    """Walls, floor and ceiling behind an open doorway, so that it is no hole into the sky."""
    a, b, top, deep = door.offset - 0.3, door.offset + door.width + 0.3, door.height + 0.3, 1.4
    near, far = WALL_THICKNESS, WALL_THICKNESS + deep
    paint, thin = look.wall(wall.index), 0.02
    for s, t in (((a - thin, a), (near, far)), ((b, b + thin), (near, far)), ((a, b), (far, far + thin))):
        builder.prism(wall_block(wall, s, t), (0.0, top), paint)
    lid = wall_block(wall, (a, b), (near, far))
    builder.prism(lid, (top, top + thin), paint)
    builder.prism(lid, (-thin, -0.001), look.looks.floor)


def is_in_doorway(wall: Wall, door: Door, eye: np.ndarray) -> bool:
    """Whether a point (x, y, ...) is in an opening or closely behind it."""
    at, depth = wall.coordinates(eye[:2])
    return door.offset < at < door.offset + door.width and -0.6 < depth < 0.03


_FRAME, _SASH = 0.045, 0.05  # widths [m] of frame and sash
_PANE = 0.004
_SASH_WIDTH = 0.85  # about how wide a sash is [m]
_BOARD = (
    (-0.026, -0.03),
    (0.0, -0.03),
    (0.0, 0.044),
    (-0.005, 0.051),
    (-0.013, 0.054),
    (-0.021, 0.051),
    (-0.026, 0.044),
)
"""Profile of a window board (above the sill, into the room) [m]."""


def add_window(
    builder: Builder,
    wall: Wall,
    window: Window,
    look: Finishes,
    bright: bool = False,
    thick: float = WALL_THICKNESS,
) -> None:
    """A window in its opening in a wall that is ``thick`` [m], with clear panes: what is outside is seen, or ``bright``
    daylight."""
    start, end = window.offset, window.offset + window.width
    low, high = window.sill, window.sill + window.height
    plane = Plane.on_wall(wall)
    share = min(1.0, min(window.width, window.height) / 0.5)
    frame, sash = _FRAME * share, _SASH * share
    path = rectangle((start, end), (low, high))
    moulding(
        builder, plane, path, [(0.0, -0.09), (frame, -0.09), (frame, -0.036), (0.0, -0.03)], look.trim, closed=True
    )
    inner = (start + 0.7 * frame, end - 0.7 * frame)
    count = max(1, round((inner[1] - inner[0]) / _SASH_WIDTH))
    wide = (inner[1] - inner[0]) / count
    profile = [(0.0, -0.08), (sash, -0.08), (sash, -0.036), (0.8 * sash, -0.026), (0.0, -0.022)]
    for k in range(count):
        a, b = inner[0] + k * wide + 0.001, inner[0] + (k + 1) * wide - 0.001
        z = (low + 0.7 * frame, high - 0.7 * frame)
        moulding(builder, plane, rectangle((a, b), z), profile, look.trim, closed=True)
        glass = rectangle((a + sash - 0.004, b - sash + 0.004), (z[0] + sash - 0.004, z[1] - sash + 0.004))
        plate(builder, plane, glass, (-0.044 - _PANE, -0.044), look.glass)
        if window.height > 0.5 and (k % 2 == 1 or count == 1 or k == count - 1):
            _handle(builder, plane, a + 0.5 * sash, _handle_height(low, high), look)
    if low > 0.1:  # one down to the floor has no board
        ends = [(start - 0.045, low), (end + 0.045, low)]
        moulding(builder, plane, ends, _BOARD, look.trim)
    ledge = wall_block(wall, (start, end), (0.085, thick + 0.04))
    builder.prism(ledge, (low - 0.012, low + 0.002), look.metal)
    if bright:
        builder.prism(wall_block(wall, (start, end), (0.095, 0.097)), (low, high), look.daylight)


def _handle_height(low: float, high: float) -> float:
    """Where the handle is [m]: in the middle of a low window, in reach at a tall one."""
    return min((low + high) / 2, max(1.1, low + 0.3 * (high - low)))


def _handle(builder: Builder, plane: Plane, at: float, z: float, look: Finishes) -> None:
    base = rectangle((at - 0.013, at + 0.013), (z - 0.032, z + 0.032))
    plate(builder, plane, base, (-0.026, -0.014), look.metal, bevel=0.003)
    rod(builder, plane, ((at, z, -0.02), (at, z, 0.018)), 0.007, look.metal)
    rod(builder, plane, ((at, z + 0.01, 0.016), (at, z - 0.105, 0.016)), 0.008, look.metal)
