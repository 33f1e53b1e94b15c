"""The room itself as meshes: the floor as it is laid, walls with openings, doors, windows and skirting boards."""

from __future__ import annotations

import zlib
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.geometry.polygons import union
from sceneweaver.geometry.shell import WALL_THICKNESS, outer_outline, wall_pieces, wall_plan
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room

from .room_blocks import Builder, wall_block
from .room_finish import Finishes
from .room_floor import floor_mesh
from .room_openings import add_door, add_window
from .room_walls import add_wall_finish

STUB = 0.05
"""Height [m] at which a wall between camera and room is cut."""

_SKIRTING = (0.014, 0.075)  # depth and height [m]


@dataclass(frozen=True)
class Shell:
    """Meshes in the world's frame: the floor, each wall with what is in it (None: nothing), and the outer outline."""

    floor: Mesh
    walls: tuple[Mesh | None, ...]
    outer: np.ndarray


def build_shell(
    room: Room, look: Finishes, cut: Collection[int] = (), top: float | None = None, pixel: float = 0.0
) -> Shell:
    """The shell of a room.

    Args:
        room: The room.
        look: What it is made of.
        cut: Walls that stand between camera and room: only a stub of them is left.
        top: Height [m] at which all walls are cut; None: the ceiling.
        pixel: Size of a pixel on the floor [m], see ``floor_mesh``.
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
            add_wall_finish(builder, room, wall, look, high, pixel)
            _fittings(builder, room, wall, look)
        meshes.append(builder.mesh())
    outer = np.array(outer_outline(walls))
    seed = zlib.crc32(repr(room.outline).encode())
    floor = floor_mesh(look.looks.floor_kind, look.looks.floor, _covered(room), outer, seed, pixel)
    return Shell(floor, tuple(meshes), outer)


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


def _covered(room: Room) -> np.ndarray:
    """The floor's plan: the outline, and the thresholds of doors."""
    import shapely

    outline = np.asarray(room.outline, dtype=float)
    if not room.doors:
        return outline
    parts = [shapely.Polygon(outline)]
    for door in room.doors:
        parts.append(shapely.Polygon(room.walls[door.wall].strip(door.offset, door.width, -WALL_THICKNESS, 0.01)))
    whole = union(parts)
    if not isinstance(whole, shapely.Polygon):
        return outline
    return np.asarray(shapely.orient_polygons(whole).exterior.coords)[:-1]
