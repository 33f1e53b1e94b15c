"""Named frames of a MuJoCo model: where a hand takes hold, what is inside, where things stand and a robot comes in.

Sites carry no weight and touch nothing. Those that are boxes have the size of what they mark.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np

from sceneweaver.geometry.rotations import from_matrix, from_yaw, inverse, rotate, wxyz
from sceneweaver.scene import Room, SceneObject

from .things import RigidBody, Thing
from .xml import child

_FLAT = 0.001  # [m], half the thickness of a site that marks a surface
_INSIDE = 0.45  # [m] from a door's wall to where a robot comes in, or half the door's width
_EYE = 1.6  # [m] above the floor
_WIDE = 75.0  # [degree], vertical field of view at eye level
_ABOVE = 45.0  # [degree], of the camera over the room
_SHAPE = 4 / 3  # width to height of the picture that the camera over the room fills with it


class Sites:
    """Adds sites to bodies, each name given once."""

    def __init__(self) -> None:
        self._given: Counter[str] = Counter()

    def mark(self, frame: Xml.Element, thing: Thing, body: RigidBody) -> None:
        """The grasps, interiors and support surfaces of one body of a thing, in the body's frame."""
        scale = np.asarray(thing.scale)
        for grasp in thing.asset.grasps if thing.asset is not None else ():
            if thing.body_of(grasp.link) != body.number:
                continue
            z, y = np.asarray(grasp.approach), np.asarray(grasp.closing)
            turn = wxyz(from_matrix(np.column_stack([np.cross(y, z), y, z])))
            half = (grasp.length / 2, grasp.width / 2, _FLAT)
            self._box(frame, f"{body.name}:grasp:{grasp.name}", np.asarray(grasp.position) * scale, half, quat=turn)
        for inside in thing.asset.interiors if thing.asset is not None else ():
            if thing.body_of(inside.link) == body.number:
                low, high = np.asarray(inside.low) * scale, np.asarray(inside.high) * scale
                self._box(frame, f"{body.name}:interior:{inside.name}", (low + high) / 2, (high - low) / 2)
        for surface in thing.object.surfaces if body.number == 0 else ():
            low, high = np.min(surface.polygon, axis=0), np.max(surface.polygon, axis=0)
            middle, half = (low + high) / 2, (high - low) / 2
            self._box(frame, f"{body.name}:surface:{surface.name}", (*middle, surface.z), (*half, _FLAT))

    def _box(self, frame: Xml.Element, name: str, pos: Any, size: Any, **more: Any) -> None:
        self._given[name] += 1
        again = f"-{self._given[name] - 1}" if self._given[name] > 1 else ""
        child(frame, "site", name=name + again, type="box", pos=pos, size=size, **more)


def add_spawns(world: Xml.Element, room: Room, more: Mapping[str, str]) -> None:
    """For each door a frame on the floor inside of it, its x axis into the room, with ``more`` attributes."""
    for door in room.doors:
        wall = room.walls[door.wall]
        x, y = wall.point(door.offset + door.width / 2, max(_INSIDE, door.width / 2))
        turn = wxyz(from_yaw(wall.yaw + math.pi / 2))
        child(world, "site", {"name": f"room:spawn:{door.id}", "pos": (x, y, 0), "quat": turn, **more})


def add_cameras(world: Xml.Element, room: Room, objects: Sequence[SceneObject]) -> None:
    """One over the room, one at the first door and one in the corner that is farthest from it, both at eye level."""
    low, high = np.min(room.outline, axis=0), np.max(room.outline, axis=0)
    middle, (wide, deep) = (low + high) / 2, high - low
    across = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0) if wide >= deep else (0.0, 1.0, 0.0, -1.0, 0.0, 0.0)
    far = max(max(wide, deep) / _SHAPE, min(wide, deep)) / 2 / math.tan(math.radians(_ABOVE / 2))
    above = (*middle, room.height + 1.05 * far)
    child(world, "camera", name="room:top", pos=above, xyaxes=across, fovy=_ABOVE)
    wall = room.walls[room.doors[0].wall if room.doors else 0]
    at = room.doors[0].offset + room.doors[0].width / 2 if room.doors else wall.length / 2
    door = np.array(wall.point(at, 0.1))
    _eye(world, "room:eye-door", door, middle)
    corners = []
    for corner in np.asarray(room.outline, dtype=float):
        toward = middle - corner
        corners.append(corner + toward * min(1.0, 0.35 / max(float(np.linalg.norm(toward)), 1e-9)))
    corners.sort(key=lambda corner: -float(np.linalg.norm(corner - door)))
    free = [corner for corner in corners if not any(_within(o, (*corner, _EYE)) for o in objects)]
    _eye(world, "room:eye-corner", (free or corners)[0], middle)


def _eye(world: Xml.Element, name: str, place: np.ndarray, middle: np.ndarray) -> None:
    """A camera at eye level that looks down a little at the middle of the room."""
    ahead = np.array([*(middle - place), -0.6])
    ahead /= np.linalg.norm(ahead)
    right = np.array([ahead[1], -ahead[0], 0.0]) / max(float(np.hypot(ahead[0], ahead[1])), 1e-9)
    axes = (*right, *np.cross(right, ahead))
    child(world, "camera", name=name, pos=(*place, _EYE), xyaxes=axes, fovy=_WIDE)


def _within(thing: SceneObject, point: tuple[float, float, float]) -> bool:
    """Whether a point is in the box of an object."""
    off = np.asarray(point) - np.asarray(thing.pose.position)
    own = rotate(inverse(thing.pose.quaternion), off.tolist())
    depth, width, height = thing.size
    return abs(own[0]) <= depth / 2 and abs(own[1]) <= width / 2 and 0 <= own[2] <= height
