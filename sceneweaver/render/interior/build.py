"""The room around the furniture as it is seen at eye level: whole walls, ceiling, joinery, fittings, world outside."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Mesh
from sceneweaver.geometry.shell import outer_outline
from sceneweaver.scene import Scene

from ..blocks import Builder, Finishes
from ..camera import Camera
from ..openings import add_door, add_window, is_in_doorway
from ..shell import add_wall, add_wall_finish, floor_mesh
from ..words import is_one_of
from .fittings import add_fittings, plan_fittings
from .outside import outside_mesh
from .trim import add_ceiling, add_coving, add_skirting


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
    found: list[Element] = []

    def take(name: str, category: str, builder: Builder) -> None:
        mesh = builder.mesh()
        if mesh is not None:
            found.append(Element(name, category, mesh))

    outer = np.array(outer_outline(room.walls))
    found.append(Element("floor", "floor", floor_mesh(look.looks.floor, outer)))
    for wall in room.walls:
        builder = Builder()
        add_wall(builder, room, wall, room.height, look)
        add_wall_finish(builder, room, wall, look, room.height)
        take(f"wall:{wall.index}", "wall", builder)
    builder = Builder()
    add_ceiling(builder, room, look)
    take("ceiling", "ceiling", builder)
    builder = Builder()
    add_coving(builder, room, look, scene.objects)
    take("coving", "coving", builder)
    builder = Builder()
    add_skirting(builder, room, look)
    take("skirting", "skirting", builder)
    panelled = not is_one_of(room.type, "plain doors")
    for door in room.doors:
        wall, builder = room.walls[door.wall], Builder()
        is_open = any(is_in_doorway(wall, door, np.asarray(camera.eye)) for camera in cameras)
        add_door(builder, wall, door, look, panelled, None if is_open else 0.0)
        take(door.id, "door", builder)
    for window in room.windows:
        builder = Builder()
        add_window(builder, room.walls[window.wall], window, look)
        take(window.id, "window", builder)
    fittings, builder = plan_fittings(scene), Builder()
    add_fittings(builder, room.walls, fittings, look)
    take("fittings", "fittings", builder)
    world = outside_mesh(room)
    if world is not None:
        found.append(Element("outside", "outside", world))
    return found
