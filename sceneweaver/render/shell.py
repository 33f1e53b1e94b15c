"""The room from above as meshes: floor, walls with openings and what is on them, doors, windows, skirting boards."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_vertices, ring_faces
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS, outer_outline, wall_pieces, wall_plan
from sceneweaver.geometry.walls import Wall, walls_of
from sceneweaver.scene import Door, Room

from .blocks import Builder, Finishes, Range, wall_block
from .mouldings import Plane, plate, rectangle
from .openings import REACH, add_door, add_window

STUB = 0.05
"""Height [m] at which a wall between camera and room is cut."""

_SKIRTING = (0.014, 0.075)  # depth and height [m]
_AJAR = 0.42  # how far doors stand open [rad]


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
    """What is in a wall and along its foot."""
    for opening in room.openings_of(wall.index):
        if isinstance(opening, Door):
            add_door(builder, wall, opening, look, panelled=False, ajar=_AJAR)
        else:
            add_window(builder, wall, opening, look, bright=True)
    depth, height = _SKIRTING
    for a, b in bare_stretches(room, wall, look, height):
        builder.prism(wall_block(wall, (a, b), (-depth, 0.0)), (0.0, height), look.trim)


def bare_stretches(room: Room, wall: Wall, look: Finishes, height: float) -> Iterator[Range]:
    """The stretches of a wall [m] that have a skirting board of a height [m]: neither tiles nor door frames."""
    tiled = look.tiled(wall.index)
    if tiled is not None and tiled[0] < height:
        return
    gaps = [(d.offset - REACH, d.offset + d.width + REACH) for d in room.doors if d.wall == wall.index]
    gaps += [(w.offset, w.offset + w.width) for w in room.windows if w.wall == wall.index and w.sill < height]
    at = 0.0
    for a, b in [*sorted(gaps), (wall.length, wall.length)]:
        if a - at > 0.02:
            yield at, a
        at = max(at, b)


PANELS = 1.15
"""Height [m] of panelling."""

_PAPER, _TILE = 0.001, 0.004  # thickness [m]
_BATTEN, _FIELD, _RAIL = 0.05, 0.42, 0.06  # widths [m] of battens and of the fields between them, height of the rail

Rectangle = tuple[Range, Range]


def add_wall_finish(builder: Builder, room: Room, wall: Wall, look: Finishes, height: float) -> None:
    """Paper, panels and tiles of a wall up to a height [m] at which it may be cut."""
    kind, band, accent = look.accented(wall.index), look.tiled(wall.index), look.looks.accent
    high = look.plan.accent.high if look.plan.accent is not None else None
    if kind == "paper" and accent is not None:
        add_facing(builder, room, wall, (0.0, min(high or height, height)), _PAPER, accent)
    elif kind == "panelling" and accent is not None:
        _panels(builder, room, wall, accent, height, high or PANELS)
    elif kind == "paint" and accent is not None and high is not None:
        add_facing(builder, room, wall, (0.0, min(high, height)), _PAPER, accent)
    elif kind == "paint" and accent is not None and (of := look.plan.accent and look.plan.accent.of) in _CLAD:
        _clad(builder, room, wall, accent, height, *_CLAD[of or ""])
    if look.plan.walls_of in _CLAD and kind is None:
        _clad(builder, room, wall, look.looks.wall, height, *_CLAD[look.plan.walls_of])
    if band is not None and look.looks.tiles is not None:
        add_facing(builder, room, wall, (band[0], min(band[1], height)), _TILE, look.looks.tiles)


_CLAD = {"logs": (0.24, 0.05, False), "boards": (0.16, 0.007, False), "metal": (1.2, 0.012, True)}
"""Walls of bodies: how high logs, boards or plates are, how far they stand out [m], whether they are square."""

_JOINT = 0.01  # between plates and boards [m]


def _clad(
    builder: Builder, room: Room, wall: Wall, material: Material, height: float, high: float, deep: float, plates: bool
) -> None:
    """Logs, boards or plates before a wall."""
    rows = max(1, round(room.height / high))
    step = room.height / rows
    for row in range(rows):
        low, top = row * step, min((row + 1) * step - _JOINT, height)
        for (a, b), z in _solid(room, wall, (low, top)):
            if not plates:
                _slab(builder, wall, (a, b), z, deep, material)
                if deep > 0.03:  # the round of a log, in two steps
                    mid = 0.5 * (low + top)
                    _slab(
                        builder,
                        wall,
                        (a, b),
                        (max(z[0], mid - 0.3 * step), min(z[1], mid + 0.3 * step)),
                        1.5 * deep,
                        material,
                    )
                continue
            count = max(1, round((b - a) / high))
            wide = (b - a) / count
            for k in range(count):
                _slab(builder, wall, (a + k * wide, a + (k + 1) * wide - _JOINT), z, deep, material)


def add_facing(builder: Builder, room: Room, wall: Wall, z: Range, thick: float, material: Material) -> None:
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


def _panels(builder: Builder, room: Room, wall: Wall, panel: Material, height: float, high: float) -> None:
    """Panelling up to a height [m], cut at another; high panels have a rail where low ones end."""
    top = min(high, height)
    for along, z in _solid(room, wall, (0.0, top)):
        _slab(builder, wall, along, z, 0.002, panel)
    count = max(1, round(wall.length / (_FIELD + _BATTEN)))
    step = (wall.length - _BATTEN) / count
    battens = [(k * step, k * step + _BATTEN) for k in range(count + 1)]
    for (a, b), z in _solid(room, wall, (0.0, top)):
        for low, high in battens:
            _slab(builder, wall, (max(a, low), min(b, high)), z, 0.009, panel)
    for rail in (PANELS, high) if high > 2.0 * _RAIL + PANELS else (high,):
        if height >= rail:
            for along, z in _solid(room, wall, (rail - _RAIL, rail)):
                _slab(builder, wall, along, z, 0.018, panel)


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
