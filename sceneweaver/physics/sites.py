"""Frames of a scene as sites and cameras of a MuJoCo model.

Sites carry no weight and touch nothing. Those that are boxes have the size of what they mark.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any
from xml.etree import ElementTree as Xml

from sceneweaver.geometry.rotations import wxyz
from sceneweaver.scene import Room, SceneObject

from .frames import Frame, frames_of, leaf_frames, spawns, views
from .leaves import Leaf
from .things import RigidBody, Thing
from .xml import child


def add_sites(element: Xml.Element, thing: Thing, body: RigidBody) -> None:
    """The grasps, interiors and support surfaces of one body of a thing, in the body's frame."""
    _add(element, frames_of(thing, body))


def add_leaf_sites(element: Xml.Element, leaf: Leaf) -> None:
    """The grasps of the leaf of a door, in its frame."""
    _add(element, leaf_frames(leaf))


def _add(element: Xml.Element, frames: Sequence[Frame]) -> None:
    for frame in frames:
        turn: dict[str, Any] = {"quat": wxyz(frame.quaternion)} if frame.kind == "grasp" else {}
        place = {"name": frame.name, "type": "box", "pos": frame.position, "size": frame.half}
        child(element, "site", {**place, **turn})


def add_spawns(world: Xml.Element, room: Room, more: Mapping[str, str]) -> None:
    """For each door a frame on the floor inside of it, its x axis into the room, with ``more`` attributes."""
    for frame in spawns(room):
        child(world, "site", {"name": frame.name, "pos": frame.position, "quat": wxyz(frame.quaternion), **more})


def add_cameras(world: Xml.Element, room: Room, objects: Sequence[SceneObject]) -> None:
    """The views of a room."""
    for view in views(room, objects):
        turn, angle = wxyz(view.quaternion), round(math.degrees(view.angle), 6)
        child(world, "camera", name=view.name, pos=view.position, quat=turn, fovy=angle)
