"""Named frames of a scene: where a hand takes hold, what is inside, where things stand, where a robot comes in, and
from where to look. Writers of files mark them under the same names."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from sceneweaver.assets import Grasp
from sceneweaver.geometry.rotations import Quaternion, from_matrix, from_yaw, matrix
from sceneweaver.scene import Room, SceneObject

from .leaves import Leaf
from .things import RigidBody, Thing

Kind = Literal["grasp", "interior", "surface", "spawn"]
Vector = tuple[float, float, float]

_UNTURNED = (0.0, 0.0, 0.0, 1.0)
_FLAT = 0.001  # [m], half the thickness of what marks a surface
_INSIDE = 0.45  # [m] from a door's wall to where a robot comes in, or half the door's width
_EYE = 1.6  # [m] above the floor
_WIDE = math.radians(75.0)  # vertical field of view at eye level
_ABOVE = math.radians(45.0)  # of the camera over the room
_SHAPE = 4 / 3  # width to height of the picture that the camera over the room fills with it


@dataclass(frozen=True)
class Frame:
    """A frame in a body, or in the world; ``half`` are the half extents [3] of the box that it marks [m].

    A grasp's +z is the way of the hand, and its fingers close along y; a spawn frame's +x leads into the room. The
    quaternion is (x, y, z, w).
    """

    kind: Kind
    name: str
    position: Vector
    quaternion: Quaternion
    half: Vector


@dataclass(frozen=True)
class View:
    """A camera in the world that looks along its -z, +y up; ``angle`` [rad] is its vertical field of view."""

    name: str
    position: Vector
    quaternion: Quaternion
    angle: float


def frames_of(thing: Thing, body: RigidBody) -> list[Frame]:
    """The grasps, interiors and support surfaces of one body, in its frame: ``<body>:grasp:<name>`` and so on.

    A second one of a name ends in ``-1``, the next in ``-2``.
    """
    scale = np.asarray(thing.scale)
    found: list[Frame] = []
    for grasp in thing.asset.grasps if thing.asset is not None else ():
        if thing.body_of(grasp.link) == body.number:
            found.append(_held(grasp, scale))
    for inside in thing.asset.interiors if thing.asset is not None else ():
        if thing.body_of(inside.link) == body.number:
            low, high = np.asarray(inside.low) * scale, np.asarray(inside.high) * scale
            middle, half = _vector((low + high) / 2), _vector((high - low) / 2)
            found.append(Frame("interior", inside.name, middle, _UNTURNED, half))
    for surface in thing.object.surfaces if body.number == 0 else ():
        low, high = np.min(surface.polygon, axis=0), np.max(surface.polygon, axis=0)
        (x, y), (a, b) = ((low + high) / 2).tolist(), ((high - low) / 2).tolist()
        found.append(Frame("surface", surface.name, (x, y, surface.z), _UNTURNED, (a, b, _FLAT)))
    given = Counter[str]()
    named = []
    for frame in found:
        name = f"{body.name}:{frame.kind}:{frame.name}"
        named.append(replace(frame, name=f"{name}-{given[name]}" if given[name] else name))
        given[name] += 1
    return named


def leaf_frames(leaf: Leaf) -> list[Frame]:
    """The grasps of a door's leaf, in its frame: ``room:door:<door>:grasp:inside`` and ``outside``."""
    found = [_held(grasp, np.ones(3)) for grasp in leaf.grasps]
    return [replace(frame, name=f"{leaf.name}:grasp:{frame.name}") for frame in found]


def _held(grasp: Grasp, scale: np.ndarray) -> Frame:
    z, y = np.asarray(grasp.approach), np.asarray(grasp.closing)
    turn = from_matrix(np.column_stack([np.cross(y, z), y, z]))
    half = (grasp.length / 2, grasp.width / 2, _FLAT)
    return Frame("grasp", grasp.name, _vector(np.asarray(grasp.position) * scale), turn, half)


def spawns(room: Room) -> list[Frame]:
    """For each door a frame on the floor inside of it, its x axis into the room: ``room:spawn:<door>``."""
    found = []
    for door in room.doors:
        wall = room.walls[door.wall]
        x, y = wall.point(door.offset + door.width / 2, max(_INSIDE, door.width / 2))
        turn = from_yaw(wall.yaw + math.pi / 2)
        found.append(Frame("spawn", f"room:spawn:{door.id}", (x, y, 0.0), turn, (0.0, 0.0, 0.0)))
    return found


def views(room: Room, objects: Sequence[SceneObject]) -> list[View]:
    """Over the room, at the first door, and in the two free corners that are farthest from it, these at eye level."""
    low, high = np.min(room.outline, axis=0), np.max(room.outline, axis=0)
    middle, (wide, deep) = (low + high) / 2, high - low
    far = max(max(wide, deep) / _SHAPE, min(wide, deep)) / 2 / math.tan(_ABOVE / 2)
    above = (float(middle[0]), float(middle[1]), float(room.height + 1.05 * far))
    found = [View("room:top", above, from_yaw(0.0 if wide >= deep else math.pi / 2), _ABOVE)]
    wall = room.walls[room.doors[0].wall if room.doors else 0]
    at = room.doors[0].offset + room.doors[0].width / 2 if room.doors else wall.length / 2
    door = np.array(wall.point(at, 0.1))
    corners = []
    for corner in np.asarray(room.outline, dtype=float):
        toward = middle - corner
        corners.append(corner + toward * min(1.0, 0.35 / max(float(np.linalg.norm(toward)), 1e-9)))
    corners.sort(key=lambda corner: -float(np.linalg.norm(corner - door)))
    taken = _within(np.array([(*corner, _EYE) for corner in corners]), objects)
    free = [corner for corner, within in zip(corners, taken, strict=True) if not within]
    first, second = [*free, *corners][:2]
    places = {"door": door, "corner": first, "corner2": second}
    return [*found, *(_eye(f"room:eye-{name}", place, middle) for name, place in places.items())]


def _eye(name: str, place: np.ndarray, middle: np.ndarray) -> View:
    """A camera at eye level that looks down a little at the middle of the room."""
    ahead = np.array([*(middle - place), -0.6])
    ahead /= np.linalg.norm(ahead)
    right = np.array([ahead[1], -ahead[0], 0.0]) / max(float(np.hypot(ahead[0], ahead[1])), 1e-9)
    turn = from_matrix(np.column_stack([right, np.cross(right, ahead), -ahead]))
    return View(name, (float(place[0]), float(place[1]), _EYE), turn, _WIDE)


def _within(points: np.ndarray, objects: Sequence[SceneObject]) -> np.ndarray:
    """Whether points [N, 3] are in the box of some object, [N]."""
    if not objects:
        return np.zeros(len(points), dtype=bool)
    off = points[:, None] - np.array([o.pose.position for o in objects])
    own = np.einsum("nok,okj->noj", off, matrix([o.pose.quaternion for o in objects]))
    depth, width, height = np.array([o.size for o in objects]).T
    plan = (np.abs(own[..., 0]) <= depth / 2) & (np.abs(own[..., 1]) <= width / 2)
    return (plan & (own[..., 2] >= 0) & (own[..., 2] <= height)).any(axis=1)


def _vector(values: np.ndarray) -> Vector:
    x, y, z = (float(v) for v in values)
    return x, y, z
