"""Floor, walls and ceiling at eye level, with skirting boards, coving and the roses of lamps."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from sceneweaver.assets.body import Material
from sceneweaver.geometry.shell import WALL_THICKNESS, outer_outline
from sceneweaver.scene import Room, SceneObject

from ..blocks import Builder, Finishes
from ..mouldings import Plane, disc, moulding, plate
from ..shell import bare_stretches
from ..words import is_one_of

SKIRTING = ((0.0, 0.0), (0.014, 0.0), (0.014, 0.058), (0.0115, 0.067), (0.006, 0.0735), (0.005, 0.078), (0.0, 0.078))
"""Profile of a skirting board (depth, height) [m], counter-clockwise."""

_COVE = 0.07
"""Height and depth [m] of coving."""


def add_skirting(builder: Builder, room: Room, look: Finishes) -> None:
    """Boards along all walls but tiled ones, from door frame to door frame."""
    for run in _runs(room, look):
        closed = len(run) > 2 and bool(np.allclose(run[0], run[-1]))
        moulding(builder, Plane.floor(), run[:-1] if closed else run, SKIRTING, look.trim, closed)


def _runs(room: Room, look: Finishes) -> Iterator[np.ndarray]:
    """The paths [N, 2] of skirting boards around the room, counter-clockwise."""
    pieces: list[list[tuple[float, float]]] = []
    for wall in room.walls:
        for a, b in bare_stretches(room, wall, look, SKIRTING[-1][1]):
            ends = [wall.point(a), wall.point(b)]
            joins = a == 0.0 and pieces and np.allclose(pieces[-1][-1], ends[0])
            if joins:
                pieces[-1].append(ends[1])
            else:
                pieces.append(ends)
    if len(pieces) > 1 and np.allclose(pieces[-1][-1], pieces[0][0]):
        pieces[0] = pieces.pop()[:-1] + pieces[0]
    for piece in pieces:
        yield np.array(piece)


def add_ceiling(builder: Builder, room: Room, look: Finishes) -> None:
    """The ceiling over room and walls."""
    outer = np.array(outer_outline(room.walls))
    _slab(builder, outer, (room.height, room.height + WALL_THICKNESS), look.ceiling)


def add_coving(builder: Builder, room: Room, look: Finishes, things: Iterable[SceneObject]) -> None:
    """Coving along the ceiling where the kind of room has it, and roses over hanging lamps."""
    if is_one_of(room.type, "plain ceiling") or room.height < 2.2:
        return
    moulding(builder, Plane.floor(), np.asarray(room.outline), _cove(room.height), look.ceiling, closed=True)
    under = Plane(np.array([0.0, 0.0, room.height]), *(np.eye(3) * (1, 1, -1)))
    for thing in things:
        if thing.mount == "ceiling" and is_one_of(thing.category, "hanging lamp"):
            x, y, _ = thing.pose.position
            for radius, thick in ((0.17, 0.008), (0.145, 0.016), (0.10, 0.024)):
                plate(builder, under, disc((x, y), radius, 40), (-0.001, thick), look.ceiling, bevel=0.006)


def _cove(height: float) -> np.ndarray:
    """The profile of a hollow between wall and ceiling; finer mouldings would be thinner than a pixel."""
    angle = np.linspace(np.pi, np.pi / 2, 9)
    hollow = _COVE * np.stack([1 + np.cos(angle), np.sin(angle) - 1], axis=1)
    return np.concatenate([[(0.0, 0.0)], hollow]) + (0.0, height)


def _slab(builder: Builder, plan: np.ndarray, z: tuple[float, float], material: Material) -> None:
    import manifold3d

    triangles = np.asarray(manifold3d.triangulate([plan]), dtype=np.int32)
    for level, faces in zip(z, (triangles[:, ::-1], triangles), strict=True):
        builder.add(np.column_stack([plan, np.full(len(plan), level)]), faces, material)
