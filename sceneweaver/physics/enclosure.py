"""What is around the things of a model: the floor, what stands still, the leaves of doors, and where one comes in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.scene import Scene

from .frames import Frame, Vector, View, spawns, views
from .leaves import Leaf, leaves
from .shell import Slab, wall_slabs


@dataclass(frozen=True, eq=False)
class Standing:
    """A body that stands still, such as a wall: ``slabs`` in a frame at ``position`` [m], turned by ``yaw`` [rad]."""

    name: str
    slabs: tuple[Slab, ...]
    position: Vector = (0.0, 0.0, 0.0)
    yaw: float = 0.0


@dataclass(frozen=True, eq=False)
class Enclosure:
    """A room, or a home, without its things; all in the world.

    Attributes:
        id: Of the scene.
        name: What the names of its parts begin with: ``<name>:floor`` and so on.
        low, high: Corners of the box of the clear space [3] [m]; ``low`` is on the floor, which goes on all around.
        standing: Walls and whatever else stands still.
        leaves: Of doors.
        spawns: Where a robot comes in.
        views: Cameras.
    """

    id: str
    name: str
    low: np.ndarray
    high: np.ndarray
    standing: tuple[Standing, ...]
    leaves: tuple[Leaf, ...]
    spawns: tuple[Frame, ...]
    views: tuple[View, ...]

    @property
    def middle(self) -> Vector:
        """Of the box [3]."""
        x, y, z = ((self.low + self.high) / 2).tolist()
        return x, y, z

    @property
    def reach(self) -> float:
        """The diagonal of the box in plan [m]."""
        return float(np.linalg.norm((self.high - self.low)[:2]))


def room_enclosure(scene: Scene) -> Enclosure:
    """The room of a scene: windows have a pane, doorways are open."""
    room = scene.room
    walls = [
        Standing(f"room:wall:{wall.index}", tuple(wall_slabs(room, wall.index)), (*wall.start, 0.0), wall.yaw)
        for wall in room.walls
    ]
    low, high = np.min(room.outline, axis=0), np.max(room.outline, axis=0)
    return Enclosure(
        scene.id,
        "room",
        np.array([*low, 0.0]),
        np.array([*high, room.height]),
        tuple(walls),
        tuple(leaves(room)),
        tuple(spawns(room)),
        tuple(views(room, scene.objects)),
    )
