"""The room as USD prims: floor and walls with static colliders, window panes, and doors that open."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sceneweaver.assets import Mesh
from sceneweaver.geometry.rotations import Quaternion, from_yaw
from sceneweaver.geometry.shell import PANE_THICKNESS, WALL_THICKNESS, heights, wall_pieces
from sceneweaver.geometry.walls import Wall
from sceneweaver.physics.frames import leaf_frames, spawns
from sceneweaver.physics.hulls import Solid
from sceneweaver.physics.inertia import Inertia, inertia_of
from sceneweaver.physics.leaves import Leaf, leaves, wall_ends
from sceneweaver.scene import Room

from .openings import window_mesh
from .room import floor_mesh, leaf_mesh, wall_mesh
from .usd_bodies import Hinge, Solids, filter_pair, join, rigid, weld
from .usd_layer import Names, Prim, apply, label, place, prim
from .usd_looks import Looks
from .usd_mesh import box_collider, render_mesh
from .usd_views import add_frames

_DEEP = 0.5  # [m] of the floor's collider: nothing falls through it in one step
_FRICTION, _LEAF_FRICTION = 0.8, 0.5

Range = tuple[float, float, float, float]


def add_room(parent: Prim, room: Room, looks: Looks) -> list[Solids]:
    """Floor, walls, windows and doors below a prim; returns the leaves of the doors."""
    _floor(parent, room, looks)
    walls = prim(parent, "Walls", kind="group")
    stays = [_wall(walls, room, k, looks) for k in range(len(room.outline))]
    if room.windows:
        windows, names = prim(parent, "Windows", kind="group"), Names()
        for window in room.windows:
            made = prim(windows, names(window.id), kind="component", displayName=window.id)
            label(made, "window")
            place(made, *wall_pose(room.walls[window.wall]))
            render_mesh(made, "Mesh", _in_wall(window_mesh(room, window), room, window.wall), looks)
            span = (window.offset, window.offset + window.width, *heights(window))
            pane = prim(made, "Collision", "Scope")
            box_collider(pane, "part_0", *_middle(*span, PANE_THICKNESS), looks, _FRICTION)
    found = leaves(room)
    if not found:
        return []
    add_frames(prim(parent, "Spawns", kind="group"), spawns(room))
    doors, names = prim(parent, "Doors", kind="group"), Names()
    moving = []
    for leaf, door in zip(found, room.doors, strict=True):
        moving.append(_door(doors, names(leaf.door), leaf, looks))
        # Its hinge is in the opening: it may touch the wall that carries it, and no more than touch.
        filter_pair(moving[-1], stays[door.wall], parent.layer)
    return moving


def wall_pose(wall: Wall) -> tuple[tuple[float, float, float], Quaternion]:
    """Frame of a wall: at its first corner, +x along it, +y into the room; the quaternion is (x, y, z, w)."""
    return (*wall.start, 0.0), from_yaw(wall.yaw)


def wall_boxes(room: Room, wall: int) -> Iterator[Range]:
    """The solid of a wall around its openings as boxes: from and to along it, from and to in height [m]."""
    pieces = wall_pieces(room.walls[wall].length, room.openings_of(wall), room.height, wall_ends(room, wall))
    return ((*span, *z) for span, z, opening in pieces if opening is None)


def _floor(parent: Prim, room: Room, looks: Looks) -> None:
    made = prim(parent, "Floor", kind="component")
    label(made, "floor")
    render_mesh(made, "Mesh", floor_mesh(room), looks)
    low, high = np.min(room.outline, axis=0) - WALL_THICKNESS, np.max(room.outline, axis=0) + WALL_THICKNESS
    center, half = (low + high) / 2, (high - low) / 2
    scope = prim(made, "Collision", "Scope")
    box_collider(scope, "part_0", np.array([*center, -_DEEP / 2]), np.array([*half, _DEEP / 2]), looks, _FRICTION)


def _wall(parent: Prim, room: Room, wall: int, looks: Looks) -> Solids:
    made = prim(parent, f"Wall_{wall}", kind="component", displayName=f"wall:{wall}")
    label(made, "wall")
    place(made, *wall_pose(room.walls[wall]))
    render_mesh(made, "Mesh", _in_wall(wall_mesh(room, wall), room, wall), looks)
    scope, paths = prim(made, "Collision", "Scope"), []
    for number, (low, high, bottom, top) in enumerate(wall_boxes(room, wall)):
        center, half = _middle(low, high, bottom, top, WALL_THICKNESS)
        box_collider(scope, f"part_{number}", center, half, looks, _FRICTION)
        paths.append(scope.path.AppendChild(f"part_{number}"))
    return Solids((), tuple(paths))


def _in_wall(mesh: Mesh, room: Room, wall: int) -> Mesh:
    """A mesh of the world in a wall's frame."""
    points = np.column_stack([room.walls[wall].frame.to_local(mesh.vertices[:, :2]), mesh.vertices[:, 2]])
    return replace(mesh, vertices=points)


def _middle(low: float, high: float, bottom: float, top: float, thick: float) -> tuple[np.ndarray, np.ndarray]:
    """Centre and half extents of a box in a wall's frame, its inner face flush with the room."""
    center = np.array([(low + high) / 2, -thick / 2, (bottom + top) / 2])
    return center, np.array([(high - low) / 2, thick / 2, (top - bottom) / 2])


def _door(parent: Prim, name: str, leaf: Leaf, looks: Looks) -> Solids:
    """A leaf on a frame that is fixed to the world: an articulation like that of any piece with doors."""
    made = prim(parent, name, kind="component", displayName=leaf.door)
    made.SetInfo("customData", {"sceneweaver": {"id": leaf.door, "name": leaf.name}})
    label(made, "door")
    apply(made, "PhysicsArticulationRootAPI")
    place(made, leaf.position, from_yaw(leaf.yaw))
    frame, panel = prim(made, "frame"), prim(made, "leaf")
    place(frame)
    rigid(frame, Inertia(1.0, np.zeros(3), 0.1 * np.eye(3)))  # it never moves
    place(panel)
    rigid(panel, _leaf_inertia(leaf))
    render_mesh(panel, "Mesh", leaf_mesh(leaf), looks)
    add_frames(panel, leaf_frames(leaf))
    scope = prim(panel, "Collision", "Scope")
    for number, (center, half) in enumerate(leaf.boxes):
        box_collider(scope, f"part_{number}", np.asarray(center), np.asarray(half), looks, _LEAF_FRICTION)
    joints = prim(made, "joints", "Scope")
    weld(joints, "world", made, frame)
    join(joints, "leaf", frame, panel, Hinge(leaf.joint, leaf.axis, (0.0, 0.0, 0.0), leaf.limits, leaf.hold, leaf.hold))
    return Solids((panel.path,))


def _leaf_inertia(leaf: Leaf) -> Inertia:
    solids = [
        Solid(np.zeros((0, 3)), float(8 * np.prod(half)), box=(np.asarray(center), np.asarray(half)))
        for center, half in leaf.boxes
    ]
    total = sum(solid.volume for solid in solids)
    return inertia_of(solids, [leaf.mass * solid.volume / total for solid in solids])
