"""The room from above as meshes: floor, walls with openings and what is on them, doors, windows, skirting boards."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_vertices, ring_faces
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS, outer_outline, wall_pieces, wall_plan
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import Door, Room, Window

from .blocks import Builder, Finishes, Range, wall_block
from .mouldings import Plane, plate, rectangle

STUB = 0.05
"""Height [m] at which a wall between camera and room is cut."""

_SKIRTING = (0.014, 0.075)  # depth and height [m]


@dataclass(frozen=True)
class Shell:
    """Meshes in the world's frame: the floor, each wall with what is in it (None: nothing), and the outer outline."""

    floor: Mesh
    walls: tuple[Mesh | None, ...]
    outer: np.ndarray


def build_shell(room: Room, look: Finishes, cut: Collection[int] = (), top: float | None = None) -> Shell:
    """The shell of a room.

    Args:
        room: The room.
        look: What it is made of.
        cut: Walls that stand between camera and room: only a stub of them is left.
        top: Height [m] at which all walls are cut; None: the ceiling.
    """
    walls, high = room.walls, room.height if top is None else min(top, room.height)
    meshes = []
    for wall in walls:
        builder = Builder(high)
        if wall.index in cut:
            add_wall(builder, room, wall, STUB, look)
        else:
            add_wall(builder, room, wall, high, look)
            builder.top = high - 0.002  # where all is cut, frames do not end in the plane of the wall's cut
            add_wall_finish(builder, room, wall, look, high)
            _fittings(builder, room, wall, look)
        meshes.append(builder.mesh())
    outer = np.array(outer_outline(walls))
    return Shell(floor_mesh(look.looks.floor, outer), tuple(meshes), outer)


def add_wall(builder: Builder, room: Room, wall: Wall, height: float, look: Finishes) -> None:
    """A wall up to a height [m], with its openings."""
    ends = [wall.coordinates(corner)[0] for corner in wall_plan(room.walls, wall.index)[1:3]]
    for (a, b), z, opening in wall_pieces(wall.length, room.openings_of(wall.index), height):
        if opening is not None:
            continue
        # Where a piece ends at a corner its outer face runs on to the next wall's.
        outer_a = ends[0] if a <= 1e-6 else a
        outer_b = ends[1] if b >= wall.length - 1e-6 else b
        if outer_b - outer_a < 1e-3:
            outer_a, outer_b = a, b
        corners = ((outer_a, -WALL_THICKNESS), (outer_b, -WALL_THICKNESS), (b, 0.0), (a, 0.0))
        plan = np.array([wall.point(*corner) for corner in corners])
        # The outer face, which is the plan's first side, has a paint of its own.
        paint = look.wall(wall.index)
        builder.prism(plan, z, paint, look.cut if z[1] >= height - 1e-6 else paint, first=look.outside)


def _fittings(builder: Builder, room: Room, wall: Wall, look: Finishes) -> None:
    doors = [d for d in room.doors if d.wall == wall.index]
    windows = [w for w in room.windows if w.wall == wall.index]
    for door in doors:
        add_door(builder, wall, door, look)
    for window in windows:
        add_window(builder, wall, window, look)
    depth, height = _SKIRTING
    tiled = look.tiled(wall.index)
    if tiled is not None and tiled[0] < height:
        return
    at = 0.0
    gaps = [(d.offset - 0.03, d.offset + d.width + 0.03) for d in doors]
    gaps += [(w.offset, w.offset + w.width) for w in windows if w.sill < height]
    for a, b in [*sorted(gaps), (wall.length, wall.length)]:
        if a - at > 0.01:
            builder.prism(wall_block(wall, (at, a), (-depth, 0.0)), (0.0, height), look.trim)
        at = max(at, b)


PANELS = 1.15
"""Height [m] of panelling."""

_PAPER, _TILE = 0.001, 0.004  # thickness [m]
_BATTEN, _FIELD, _RAIL = 0.05, 0.42, 0.06  # widths [m] of battens and of the fields between them, height of the rail

Rectangle = tuple[Range, Range]


def add_wall_finish(builder: Builder, room: Room, wall: Wall, look: Finishes, height: float) -> None:
    """Paper, panels and tiles of a wall up to a height [m] at which it may be cut."""
    kind, band, accent = look.accented(wall.index), look.tiled(wall.index), look.looks.accent
    if kind == "paper" and accent is not None:
        _facing(builder, room, wall, (0.0, height), _PAPER, replace(accent, texture="stripes"))
    elif kind == "panelling" and accent is not None:
        _panels(builder, room, wall, accent, height)
    if band is not None and look.looks.tiles is not None:
        _facing(builder, room, wall, (band[0], min(band[1], height)), _TILE, look.looks.tiles)


def _facing(builder: Builder, room: Room, wall: Wall, z: Range, thick: float, material: Material) -> None:
    """A thin layer on the parts of a wall between two heights [m] that are no openings."""
    for along, (low, high) in _solid(room, wall, z):
        plate(builder, Plane.on_wall(wall), rectangle(along, (low, high)), (0.0, thick), material)


def _solid(room: Room, wall: Wall, z: Range) -> Iterator[Rectangle]:
    """The rectangles of a wall that are no openings, between two heights [m]."""
    for along, high, opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height):
        low, top = max(high[0], z[0]), min(high[1], z[1])
        if opening is None and top - low > 1e-3:
            yield along, (low, top)


def _slab(builder: Builder, wall: Wall, along: Range, z: Range, thick: float, material: Material) -> None:
    if along[1] - along[0] > 1e-3 and z[1] - z[0] > 1e-3:
        builder.prism(wall_block(wall, along, (-thick, 0.0)), z, material)


def _panels(builder: Builder, room: Room, wall: Wall, panel: Material, height: float) -> None:
    """Panelling up to `PANELS`, or a lower height [m]."""
    top = min(PANELS, height)
    for along, z in _solid(room, wall, (0.0, top)):
        _slab(builder, wall, along, z, 0.002, panel)
    count = max(1, round(wall.length / (_FIELD + _BATTEN)))
    step = (wall.length - _BATTEN) / count
    battens = [(k * step, k * step + _BATTEN) for k in range(count + 1)]
    for (a, b), z in _solid(room, wall, (0.0, top)):
        for low, high in battens:
            _slab(builder, wall, (max(a, low), min(b, high)), z, 0.009, panel)
    if height >= PANELS:
        for along, z in _solid(room, wall, (PANELS - _RAIL, PANELS)):
            _slab(builder, wall, along, z, 0.018, panel)


_AJAR = 0.42  # how far a leaf stands open [rad]
_BAR = 0.055


def add_door(builder: Builder, wall: Wall, door: Door, look: Finishes) -> None:
    """A door in its opening; leaves that swing in stand ajar."""
    start, end, top = door.offset, door.offset + door.width, door.height
    bar = min(_BAR, door.width / 5, top / 8)
    deep = (-0.015, WALL_THICKNESS + 0.012)
    for s in ((start - 0.03, start + bar), (end - bar, end + 0.03)):
        builder.prism(wall_block(wall, s, deep), (0.0, top + 0.03), look.trim)
    builder.prism(wall_block(wall, (start + bar, end - bar), deep), (top - bar, top + 0.03), look.trim)
    builder.prism(wall_block(wall, (start, end), (0.0, WALL_THICKNESS)), (-0.002, 0.006), look.leaf)
    inner, wide = start + bar, door.width - 2 * bar
    if door.swing == "slide":
        _leaf(builder, wall, (inner, -0.05), 0.0, wide, 0.0, top - bar, look, 1.0)
        return
    # Left and right are those of somebody who comes in: an in-left door hangs at its offset.
    at_end = door.swing == "in-right"
    angle = _AJAR if door.swing != "out" else 0.0
    hinge = (inner + wide if at_end else inner, 0.004)
    _leaf(builder, wall, hinge, angle, wide, 0.008, top - bar, look, -1.0 if at_end else 1.0)


def _leaf(
    builder: Builder,
    wall: Wall,
    hinge: tuple[float, float],
    angle: float,
    width: float,
    low: float,
    high: float,
    look: Finishes,
    way: float,
) -> None:
    """A leaf from its hinge (s, t) toward ``way`` along the wall, turned into the room by ``angle``."""
    along = np.array([way * np.cos(angle), -np.sin(angle)])
    across = np.array([way * np.sin(angle), np.cos(angle)])

    def block(a: Range, b: Range) -> np.ndarray:
        corners = [
            np.asarray(hinge) + along * u + across * v
            for u, v in ((a[0], b[1]), (a[1], b[1]), (a[1], b[0]), (a[0], b[0]))
        ]
        plan = np.array([wall.point(offset, -out) for offset, out in corners])
        return plan if way > 0 else plan[::-1]

    builder.prism(block((0.0, width), (0.0, 0.04)), (low, high), look.leaf)
    # Two sunk panels, as thin raised frames would be: a lighter field with a shadow line around it.
    if width > 0.5 and high > 1.4:
        for z in ((0.12, 0.45 * high), (0.52 * high, high - 0.14)):
            builder.prism(block((0.12, width - 0.12), (-0.006, 0.046)), z, look.leaf)
        for side in ((-0.055, -0.04), (0.08, 0.095)):
            builder.prism(block((width - 0.19, width - 0.05), side), (1.0, 1.022), look.metal)
        builder.prism(block((width - 0.07, width - 0.05), (-0.055, 0.095)), (1.0, 1.022), look.metal)


def add_window(builder: Builder, wall: Wall, window: Window, look: Finishes) -> None:
    """A window in its opening, with a board on its sill and daylight outside."""
    start, end = window.offset, window.offset + window.width
    low, high = window.sill, window.sill + window.height
    bar = min(_BAR, window.width / 6, window.height / 6)
    deep = (0.35 * WALL_THICKNESS, 0.35 * WALL_THICKNESS + 0.05)
    for s in ((start, start + bar), (end - bar, end)):
        builder.prism(wall_block(wall, s, deep), (low, high), look.trim)
    for z in ((low, low + bar), (high - bar, high)):
        builder.prism(wall_block(wall, (start + bar, end - bar), deep), z, look.trim)
    panes = max(1, round(window.width / 0.85))
    thin = (deep[0] + 0.008, deep[1] - 0.008)
    for k in range(1, panes):
        at = start + window.width * k / panes
        builder.prism(wall_block(wall, (at - 0.02, at + 0.02), thin), (low + bar, high - bar), look.trim)
    if window.height > 1.1:
        rail = high - 0.3 * window.height
        builder.prism(wall_block(wall, (start + bar, end - bar), thin), (rail - 0.016, rail + 0.016), look.trim)
    middle = (deep[0] + deep[1]) / 2
    builder.prism(
        wall_block(wall, (start + bar, end - bar), (middle, middle + 0.004)), (low + bar, high - bar), look.glass
    )
    if low > 0.1:  # one down to the floor has no board
        builder.prism(wall_block(wall, (start - 0.04, end + 0.04), (-0.07, deep[0])), (low - 0.028, low), look.trim)
    builder.prism(wall_block(wall, (start, end), (deep[1] + 0.01, deep[1] + 0.012)), (low, high), look.daylight)


def floor_mesh(look: Material, plan: np.ndarray) -> Mesh:
    """The floor slab with its top at z = 0, the pattern of its material along the longest edge of its plan [N, 2]."""
    import manifold3d

    triangles = np.asarray(manifold3d.triangulate([np.asarray(plan, dtype=float)]), dtype=np.int32)
    n = len(plan)
    faces = np.concatenate([triangles + n, triangles[:, ::-1], ring_faces(0, n, n)]).astype(np.int32)
    vertices = prism_vertices(plan, (-FLOOR_THICKNESS, 0.0))
    longest = max(walls_of(plan), key=lambda wall: round(wall.length, 6))
    uv = np.stack(longest.coordinates(vertices[:, :2].T), axis=1)[faces].astype(np.float32)
    zeros = np.zeros(len(faces), dtype=np.int32)
    return Mesh(vertices, faces, zeros, zeros, (look,), uv)
