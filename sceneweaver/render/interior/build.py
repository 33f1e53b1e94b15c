"""The room around the furniture as it is seen at eye level: whole walls, ceiling, joinery, fittings, world outside."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.geometry.shell import WALL_THICKNESS, outer_outline
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room, Scene, SceneObject

from ..blocks import Builder, Finishes
from ..camera import Camera
from ..mouldings import Plane, disc, moulding, plate
from ..openings import add_door, add_window, is_in_doorway
from ..shell import add_wall, add_wall_finish, bare_stretches, floor_mesh
from ..words import is_one_of
from .fittings import add_fittings, plan_fittings
from .outside import outside_mesh

_SKIRTING = ((0.0, 0.0), (0.014, 0.0), (0.014, 0.058), (0.0115, 0.067), (0.006, 0.0735), (0.005, 0.078), (0.0, 0.078))
"""Profile of a skirting board (depth, height) [m], counter-clockwise."""

_COVE = 0.07
"""Height and depth [m] of coving."""


@dataclass(frozen=True)
class Element:
    """A part of the room: its name, unique in the room ("floor", "wall:0", the id of a door ...), what it is, and its
    mesh in the world's frame."""

    name: str
    category: str
    mesh: Mesh


def build_interior(scene: Scene, look: Finishes, cameras: Sequence[Camera] = ()) -> list[Element]:
    """All parts of a room that are no objects of the scene.

    Args:
        scene: The scene.
        look: What the room is made of.
        cameras: Who looks: a door in which one of them stands is open.
    """
    room = scene.room
    meshes: list[tuple[str, str, Mesh | None]] = []

    def part(name: str, category: str, build: Callable[..., None], *given: Any) -> None:
        builder = Builder()
        build(builder, *given)
        meshes.append((name, category, builder.mesh()))

    meshes.append(("floor", "floor", floor_mesh(look.looks.floor, np.array(outer_outline(room.walls)))))
    for wall in room.walls:
        part(f"wall:{wall.index}", "wall", _add_whole_wall, room, wall, look)
    part("ceiling", "ceiling", _add_ceiling, room, look)
    part("coving", "coving", _add_coving, room, look, scene.objects)
    part("skirting", "skirting", _add_skirting, room, look)
    panelled = not is_one_of(room.type, "plain doors")
    for door in room.doors:
        wall = room.walls[door.wall]
        is_open = any(is_in_doorway(wall, door, np.asarray(camera.eye)) for camera in cameras)
        part(door.id, "door", add_door, wall, door, look, panelled, None if is_open else 0.0)
    for window in room.windows:
        part(window.id, "window", add_window, room.walls[window.wall], window, look)
    part("fittings", "fittings", add_fittings, room.walls, plan_fittings(scene), look)
    meshes.append(("outside", "outside", outside_mesh(room)))
    return [Element(name, category, mesh) for name, category, mesh in meshes if mesh is not None]


def _add_whole_wall(builder: Builder, room: Room, wall: Wall, look: Finishes) -> None:
    add_wall(builder, room, wall, room.height, look)
    add_wall_finish(builder, room, wall, look, room.height)


def _add_skirting(builder: Builder, room: Room, look: Finishes) -> None:
    """Boards along all walls but tiled ones, from door frame to door frame."""
    for run in _runs(room, look):
        closed = len(run) > 2 and bool(np.allclose(run[0], run[-1]))
        moulding(builder, Plane.floor(), run[:-1] if closed else run, _SKIRTING, look.trim, closed)


def _runs(room: Room, look: Finishes) -> Iterator[np.ndarray]:
    """The paths [N, 2] of skirting boards around the room, counter-clockwise."""
    pieces: list[list[tuple[float, float]]] = []
    for wall in room.walls:
        for a, b in bare_stretches(room, wall, look, _SKIRTING[-1][1]):
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


def _add_ceiling(builder: Builder, room: Room, look: Finishes) -> None:
    """The ceiling over room and walls."""
    import manifold3d

    plan = np.array(outer_outline(room.walls))
    triangles = np.asarray(manifold3d.triangulate([plan]), dtype=np.int32)
    levels = (room.height, room.height + WALL_THICKNESS)
    for level, faces in zip(levels, (triangles[:, ::-1], triangles), strict=True):
        builder.add(np.column_stack([plan, np.full(len(plan), level)]), faces, look.ceiling)


def _add_coving(builder: Builder, room: Room, look: Finishes, things: Iterable[SceneObject]) -> None:
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
