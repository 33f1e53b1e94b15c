"""The room around the furniture as it is seen at eye level: whole walls, ceiling, joinery, fittings, world outside."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.assets.materials import shade
from sceneweaver.geometry.shell import WALL_THICKNESS, outer_outline
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room, Scene, SceneObject

from ..blocks import Builder, Finishes, wall_block
from ..camera import Camera
from ..mouldings import Plane, disc, moulding, plate
from ..openings import add_door, add_window, is_in_doorway
from ..shell import add_wall, add_wall_finish, bare_stretches, floor_mesh
from ..tracing.lights import GLOW
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
    meshes: list[Element | None] = [
        _element("floor", "floor", floor_mesh(look.looks.floor, np.array(outer_outline(room.walls))))
    ]
    for wall in room.walls:
        meshes.append(_part(f"wall:{wall.index}", "wall", _add_whole_wall, room, wall, look))
    meshes.append(_part("ceiling", "ceiling", _add_ceiling, np.array(outer_outline(room.walls)), room.height, look))
    meshes += trim_of(scene, look)
    panelled = has_panelled_doors(room)
    for door in room.doors:
        wall = room.walls[door.wall]
        is_open = any(is_in_doorway(wall, door, np.asarray(camera.eye)) for camera in cameras)
        meshes.append(_part(door.id, "door", add_door, wall, door, look, panelled, None if is_open else 0.0))
    for window in room.windows:
        meshes.append(_part(window.id, "window", add_window, room.walls[window.wall], window, look))
    meshes.append(fittings_of(scene, look))
    meshes.append(_element("outside", "outside", outside_mesh(room)))
    return [element for element in meshes if element is not None]


def trim_of(scene: Scene, look: Finishes) -> list[Element | None]:
    """Coving, beams, skirting boards and lines of light of a room."""
    room = scene.room
    return [
        _part("coving", "coving", _add_coving, room, look, scene.objects),
        _part("beams", "beams", _add_beams, room, look),
        _part("skirting", "skirting", _add_skirting, room, look),
        _part("glow", "glow", _add_glow, room),
    ]


def fittings_of(scene: Scene, look: Finishes) -> Element | None:
    """Switches, sockets and radiators of a room."""
    return _part("fittings", "fittings", add_fittings, scene.room.walls, plan_fittings(scene), look)


def has_panelled_doors(room: Room) -> bool:
    """Whether the doors of a kind of room have panels."""
    return not is_one_of(room.type, "plain doors")


def _part(name: str, category: str, build: Callable[..., None], *given: Any) -> Element | None:
    builder = Builder()
    build(builder, *given)
    return _element(name, category, builder.mesh())


def _element(name: str, category: str, mesh: Mesh | None) -> Element | None:
    return None if mesh is None else Element(name, category, mesh)


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


def _add_ceiling(builder: Builder, plan: np.ndarray, height: float, look: Finishes) -> None:
    """The ceiling over a plan [N, 2]: room and walls."""
    import manifold3d

    triangles = np.asarray(manifold3d.triangulate([plan]), dtype=np.int32)
    levels = (height, height + WALL_THICKNESS)
    for level, faces in zip(levels, (triangles[:, ::-1], triangles), strict=True):
        builder.add(np.column_stack([plan, np.full(len(plan), level)]), faces, look.ceiling)


def _add_coving(builder: Builder, room: Room, look: Finishes, things: Iterable[SceneObject]) -> None:
    """Coving along the ceiling where the kind of room has it, and roses over hanging lamps."""
    above = room.finish.ceiling if room.finish is not None else None
    if (
        is_one_of(room.type, "plain ceiling")
        or room.height < 2.2
        or (above and (above.beams or above.material != "plaster"))
    ):
        return
    moulding(builder, Plane.floor(), np.asarray(room.outline), _cove(room.height), look.ceiling, closed=True)
    under = Plane(np.array([0.0, 0.0, room.height]), *(np.eye(3) * (1, 1, -1)))
    for thing in things:
        if thing.mount == "ceiling" and is_one_of(thing.category, "hanging lamp"):
            x, y, _ = thing.pose.position
            for radius, thick in ((0.17, 0.008), (0.145, 0.016), (0.10, 0.024)):
                plate(builder, under, disc((x, y), radius, 40), (-0.001, thick), look.ceiling, bevel=0.006)


def _add_glow(builder: Builder, room: Room) -> None:
    """A line of coloured light under the ceiling, all around, where the room is lit so."""
    if room.light is None or room.light.glow is None:
        return
    tube = Material(f"{room.light.glow}{GLOW}", shade(room.light.glow), roughness=0.6, emission=0.9)
    for wall in room.walls:
        if wall.length > 0.3:
            builder.prism(
                wall_block(wall, (0.05, wall.length - 0.05), (-0.035, -0.005)),
                (room.height - 0.09, room.height - 0.06),
                tube,
            )


_BEAM = (0.16, 0.18, 1.0)
"""Width and height of a beam, and about how far beams are apart [m]."""


def _add_beams(builder: Builder, room: Room, look: Finishes) -> None:
    """Beams under the ceiling, across the longer way of the room."""
    import shapely

    if look.looks.beams is None:
        return
    plan = shapely.Polygon(room.outline)
    x0, y0, x1, y1 = plan.bounds
    along_x = x1 - x0 < y1 - y0
    low, high = (y0, y1) if along_x else (x0, x1)
    wide, deep, apart = _BEAM
    count = max(3, round((high - low) / apart))
    for k in range(count):
        at = low + (k + 0.5) * (high - low) / count
        a, b = at - wide / 2, at + wide / 2
        strip = shapely.box(x0, a, x1, b) if along_x else shapely.box(a, y0, b, y1)
        found = plan.intersection(strip)
        for part in getattr(found, "geoms", [found]):
            if not part.is_empty and part.area > 0.02:
                box = shapely.box(*part.bounds)
                corners = np.array(shapely.geometry.polygon.orient(box).exterior.coords)[:-1]
                builder.prism(corners, (room.height - deep, room.height), look.looks.beams)


def _cove(height: float) -> np.ndarray:
    """The profile of a hollow between wall and ceiling; finer mouldings would be thinner than a pixel."""
    angle = np.linspace(np.pi, np.pi / 2, 9)
    hollow = _COVE * np.stack([1 + np.cos(angle), np.sin(angle) - 1], axis=1)
    return np.concatenate([[(0.0, 0.0)], hollow]) + (0.0, height)
