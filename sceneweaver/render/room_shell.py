"""The room itself as meshes: the floor as it is laid, walls with openings, doors, windows and skirting boards."""

from __future__ import annotations

import zlib
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.scene import Room
from sceneweaver.scene.polygons import union

from .room_blocks import Builder, Range, WallFrame
from .room_finish import Finishes
from .room_floor import SLAB, floor_mesh
from .room_openings import add_door, add_window
from .shapes import WALL_THICKNESS

STUB = 0.05
"""Height [m] at which a wall between camera and room is cut."""

_SKIRTING = (0.014, 0.075)  # depth and height [m]
_LONGEST_MITRE = 3.0  # in wall thicknesses


@dataclass(frozen=True)
class Shell:
    """Meshes in the world's frame: the floor, each wall with what is in it (None: nothing), and the outer outline."""

    floor: Mesh
    walls: tuple[Mesh | None, ...]
    outer: np.ndarray


def frames_of(room: Room) -> list[WallFrame]:
    """The frames of all walls; wall i runs from corner i to corner i + 1."""
    outline = room.outline
    return [WallFrame(outline[k], outline[(k + 1) % len(outline)]) for k in range(len(outline))]


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
    frames = frames_of(room)
    shifts = [_mitre(frames[k - 1], frames[k]) for k in range(len(frames))]
    high = room.height if top is None else min(top, room.height)
    walls = []
    for k, frame in enumerate(frames):
        builder = Builder(high)
        ends = (-shifts[k], frame.length + shifts[(k + 1) % len(frames)])
        if k in cut:
            _wall(builder, room, k, frame, ends, STUB, look)
        else:
            _wall(builder, room, k, frame, ends, high, look)
            builder.top = high - 0.002  # where all is cut, frames do not end in the plane of the wall's cut
            _fittings(builder, room, k, frame, look)
        walls.append(builder.mesh())
    outline = np.asarray(room.outline, dtype=float)
    outer = _outer(outline)
    seed = zlib.crc32(repr(room.outline).encode())
    floor = floor_mesh(look.floor, _covered(room, frames, outline), outer, seed, pixel)
    return Shell(floor, tuple(walls), outer)


def wall_pieces(room: Room, wall: int, length: float, height: float) -> list[tuple[Range, Range]]:
    """The solid parts of a wall, each an interval along it and one of height [m]."""
    holes = [(d.offset, d.offset + d.width, 0.0, d.height) for d in room.doors if d.wall == wall]
    holes += [(w.offset, w.offset + w.width, w.sill, w.sill + w.height) for w in room.windows if w.wall == wall]
    cuts = sorted({0.0, length, *(min(max(v, 0.0), length) for hole in holes for v in hole[:2])})
    pieces: list[tuple[Range, Range]] = []
    for a, b in zip(cuts, cuts[1:], strict=False):
        if b - a < 1e-6:
            continue
        middle, low = (a + b) / 2, 0.0
        for _, _, z0, z1 in sorted((h for h in holes if h[0] < middle < h[1]), key=lambda h: h[2]):
            if min(z0, height) - low > 1e-6:
                pieces.append(((a, b), (low, min(z0, height))))
            low = max(low, z1)
        if height - low > 1e-6:
            pieces.append(((a, b), (low, height)))
    return pieces


def _wall(
    builder: Builder, room: Room, wall: int, frame: WallFrame, ends: Range, height: float, look: Finishes
) -> None:
    for (a, b), z in wall_pieces(room, wall, frame.length, height):
        # Where a piece ends at a corner its outer face runs on to the next wall's.
        outer_a = ends[0] if a <= 1e-6 else a
        outer_b = ends[1] if b >= frame.length - 1e-6 else b
        if outer_b - outer_a < 1e-3:
            outer_a, outer_b = a, b
        plan = frame.points([(outer_a, WALL_THICKNESS), (outer_b, WALL_THICKNESS), (b, 0.0), (a, 0.0)])
        # The outer face, which is the plan's first side, has a paint of its own.
        builder.prism(plan, z, look.wall, look.cut if z[1] >= height - 1e-6 else look.wall, first=look.outside)


def _fittings(builder: Builder, room: Room, wall: int, frame: WallFrame, look: Finishes) -> None:
    for door in room.doors:
        if door.wall == wall:
            add_door(builder, frame, door, WALL_THICKNESS, look)
    for window in room.windows:
        if window.wall == wall:
            add_window(builder, frame, window, WALL_THICKNESS, look)
    depth, height = _SKIRTING
    at = 0.0
    gaps = sorted((d.offset - 0.03, d.offset + d.width + 0.03) for d in room.doors if d.wall == wall)
    gaps += sorted((w.offset, w.offset + w.width) for w in room.windows if w.wall == wall and w.sill < height)
    for a, b in [*sorted(gaps), (frame.length, frame.length)]:
        if a - at > 0.01:
            builder.prism(frame.block((at, a), (-depth, 0.0)), (0.0, height), look.trim)
        at = max(at, b)


def _covered(room: Room, frames: list[WallFrame], outline: np.ndarray) -> np.ndarray:
    """The floor's plan: the outline, and the thresholds of doors."""
    import shapely

    if not room.doors:
        return outline
    parts = [shapely.Polygon(outline)]
    for door in room.doors:
        block = frames[door.wall].block((door.offset, door.offset + door.width), (-0.01, WALL_THICKNESS))
        parts.append(shapely.Polygon(block))
    whole = union(parts)
    if not isinstance(whole, shapely.Polygon):
        return outline
    return np.asarray(shapely.orient_polygons(whole).exterior.coords)[:-1]


def _mitre(before: WallFrame, after: WallFrame) -> float:
    """How far the outer faces of two walls run beyond their common corner [m]; below 0 at reflex corners."""
    cross = float(before.along[0] * after.along[1] - before.along[1] * after.along[0])
    dot = float(before.along @ after.along)
    reach = WALL_THICKNESS * cross / max(1.0 + dot, 1e-6)
    return float(np.clip(reach, -_LONGEST_MITRE * WALL_THICKNESS, _LONGEST_MITRE * WALL_THICKNESS))


def _outer(outline: np.ndarray) -> np.ndarray:
    """The outer outline of slab and walls, counter-clockwise [N, 2]."""
    import shapely

    grown = shapely.buffer(shapely.Polygon(outline), WALL_THICKNESS, join_style="mitre", mitre_limit=_LONGEST_MITRE)
    return np.asarray(shapely.orient_polygons(grown).exterior.coords)[:-1]


__all__ = ["SLAB", "STUB", "Shell", "build_shell", "frames_of", "wall_pieces"]
