"""The room as USD prims: floor and walls with static colliders, window panes, and doors that open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.geometry.rotations import Quaternion, from_yaw
from sceneweaver.geometry.shell import heights
from sceneweaver.geometry.walls import Wall
from sceneweaver.physics.frames import leaf_frames, spawns
from sceneweaver.physics.inertia import Inertia
from sceneweaver.physics.leaves import Leaf, leaves
from sceneweaver.physics.shell import FLOOR_FRICTION, LEAF_FRICTION, floor_slab, wall_slab, wall_slabs
from sceneweaver.scene import Room

from .names import Names
from .openings import window_mesh
from .room import floor_mesh, leaf_mesh, wall_mesh
from .usd_bodies import Solids, filter_pair, join, rigid, weld
from .usd_layer import Prim, apply, label, place, prim, prim_names
from .usd_looks import Looks
from .usd_mesh import box_collider, render_mesh
from .usd_views import add_frames


def add_room(parent: Prim, room: Room, looks: Looks, names: Names) -> list[Solids]:
    """Floor, walls, windows and doors below a prim; returns the leaves of the doors.

    ``names`` gives those of the doors: `room_door_<id>`, and with `_frame`, `_leaf` and `_joint` of what is below.
    """
    _floor(parent, room, looks)
    walls = prim(parent, "Walls", kind="group")
    stays = [_wall(walls, room, k, looks) for k in range(len(room.outline))]
    if room.windows:
        windows, titles = prim(parent, "Windows", kind="group"), prim_names()
        for window in room.windows:
            made = prim(windows, titles(window.id), kind="component", displayName=window.id)
            label(made, "window")
            place(made, *wall_pose(room.walls[window.wall]))
            render_mesh(made, "Mesh", _in_wall(window_mesh(room, window), room, window.wall), looks)
            pane = wall_slab((window.offset, window.offset + window.width), heights(window), pane=True)
            add_boxes(made, [(pane.centre, pane.half)], looks, FLOOR_FRICTION)
    found = leaves(room)
    if not found:
        return []
    add_frames(prim(parent, "Spawns", kind="group"), spawns(room))
    doors = prim(parent, "Doors", kind="group")
    moving = []
    for leaf, door in zip(found, room.doors, strict=True):
        moving.append(add_door(doors, names, leaf, looks))
        # Its hinge is in the opening: it may touch the wall that carries it, and no more than touch.
        filter_pair(moving[-1], stays[door.wall], parent.layer)
    return moving


def wall_pose(wall: Wall) -> tuple[tuple[float, float, float], Quaternion]:
    """Frame of a wall: at its first corner, +x along it, +y into the room; the quaternion is (x, y, z, w)."""
    return (*wall.start, 0.0), from_yaw(wall.yaw)


def _floor(parent: Prim, room: Room, looks: Looks) -> None:
    made = prim(parent, "Floor", kind="component")
    label(made, "floor")
    render_mesh(made, "Mesh", floor_mesh(room), looks)
    slab = floor_slab(room)
    add_boxes(made, [(slab.centre, slab.half)], looks, FLOOR_FRICTION)


def _wall(parent: Prim, room: Room, wall: int, looks: Looks) -> Solids:
    made = prim(parent, f"Wall_{wall}", kind="component", displayName=f"wall:{wall}")
    label(made, "wall")
    place(made, *wall_pose(room.walls[wall]))
    render_mesh(made, "Mesh", _in_wall(wall_mesh(room, wall), room, wall), looks)
    slabs = [(slab.centre, slab.half) for slab in wall_slabs(room, wall) if not slab.pane]
    return Solids((), add_boxes(made, slabs, looks, FLOOR_FRICTION))


def add_boxes(made: Prim, boxes: Sequence[Any], looks: Looks, friction: float) -> tuple[Any, ...]:
    """Colliders below a prim, by centres [3] and half extents [3]; returns their paths."""
    scope = prim(made, "Collision", "Scope")
    for number, (centre, half) in enumerate(boxes):
        box_collider(scope, f"part_{number}", np.asarray(centre), np.asarray(half), looks, friction)
    return tuple(scope.path.AppendChild(f"part_{number}") for number in range(len(boxes)))


def _in_wall(mesh: Mesh, room: Room, wall: int) -> Mesh:
    """A mesh of the world in a wall's frame."""
    points = np.column_stack([room.walls[wall].frame.to_local(mesh.vertices[:, :2]), mesh.vertices[:, 2]])
    return replace(mesh, vertices=points)


def add_door(parent: Prim, names: Names, leaf: Leaf, looks: Looks) -> Solids:
    """A leaf on a frame that is fixed to the world: an articulation like that of any piece with doors."""
    name = names(leaf.name)
    made = prim(parent, name, kind="component", displayName=leaf.door)
    made.SetInfo("customData", {"sceneweaver": {"id": leaf.door, "name": leaf.name}})
    label(made, "door")
    apply(made, "PhysicsArticulationRootAPI")
    place(made, leaf.position, from_yaw(leaf.yaw))
    frame, panel = prim(made, names(f"{name}_frame")), prim(made, names(f"{name}_leaf"))
    place(frame)
    rigid(frame, Inertia(1.0, np.zeros(3), 0.1 * np.eye(3)))  # it never moves
    place(panel)
    rigid(panel, leaf.inertia)
    render_mesh(panel, "Mesh", leaf_mesh(leaf), looks)
    add_frames(panel, leaf_frames(leaf))
    add_boxes(panel, leaf.boxes, looks, LEAF_FRICTION)
    joints = prim(made, "joints", "Scope")
    weld(joints, names(f"{name}_frame_joint"), made, frame)
    join(joints, names(f"{name}_joint"), frame, panel, leaf.moves)
    return Solids((panel.path,))
