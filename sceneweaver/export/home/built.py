"""A home ready to be written: its plans, what stands still, its doors, and the things of its rooms by their names."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sceneweaver.assets.placed import Load, loader
from sceneweaver.geometry.rotations import from_yaw
from sceneweaver.home import Home, HomeRoom
from sceneweaver.physics.enclosure import Enclosure, Standing
from sceneweaver.physics.frames import Frame, View, spawns, views
from sceneweaver.physics.leaves import Leaf
from sceneweaver.physics.things import Thing
from sceneweaver.runtime.deadline import checkpoint

from .meshes import Part, structure_parts
from .names import HomeNames, things_of_rooms
from .structure import StoreyPlan, fixed_bodies, home_leaves, storey_plans, wall_bodies

_ABOVE = 1.2  # of the home's diagonal, by which the camera is over it
_FIELD = np.deg2rad(45.0)


@dataclass(frozen=True, eq=False)
class BuiltHome:
    """A home and what all of its files are made of; each part is made when it is first needed.

    Attributes:
        home: The home.
        load: From asset id to asset; each is loaded once.
    """

    home: Home
    load: Load

    @classmethod
    def of(cls, home: Home, load: Load | None = None) -> BuiltHome:
        """A home with assets of a loader; None: the library of this user."""
        return cls(home, loader(load))

    @cached_property
    def names(self) -> HomeNames:
        """Of its things."""
        return HomeNames.of(self.home)

    @cached_property
    def plans(self) -> list[StoreyPlan]:
        """Of its storeys, from below."""
        checkpoint()
        return storey_plans(self.home)

    @cached_property
    def walls(self) -> list[list[Standing]]:
        """Of each storey its walls, and what is over and under openings."""
        return [wall_bodies(plan, self.names) for plan in self.plans]

    @cached_property
    def fixed(self) -> list[Standing]:
        """Decks, ceilings, railings, stairs."""
        return fixed_bodies(self.home, self.plans, self.names)

    @property
    def standing(self) -> list[Standing]:
        """All that stands still."""
        return [*(body for walls in self.walls for body in walls), *self.fixed]

    @cached_property
    def leaves(self) -> list[list[Leaf]]:
        """Of each storey the leaves of its doors."""
        checkpoint()
        return [home_leaves(self.home, plan, self.names) for plan in self.plans]

    @cached_property
    def parts(self) -> list[Part]:
        """What is seen beside things and leaves."""
        checkpoint()
        return structure_parts(self.home, self.plans, self.names)

    @cached_property
    def rooms(self) -> list[tuple[HomeRoom, list[Thing]]]:
        """The things of each furnished room."""
        return list(things_of_rooms(self.home, self.names, self.load))

    @property
    def things(self) -> list[Thing]:
        """Of all rooms."""
        return [thing for _, things in self.rooms for thing in things]

    @cached_property
    def corners(self) -> tuple[np.ndarray, np.ndarray]:
        """The corners of the box around the rooms [3] [m]; the lower one is on the lowest floor."""
        points = np.concatenate([np.asarray(room.outline) for room in self.home.rooms])
        low, high = points.min(axis=0), points.max(axis=0)
        return np.array([*low, self.plans[0].low]), np.array([*high, self.plans[-1].high])

    def enclosure(self) -> Enclosure:
        """What is around the things."""
        low, high = self.corners
        return Enclosure(
            self.home.id,
            self.names.home,
            low,
            high,
            tuple(self.standing),
            tuple(leaf for leaves in self.leaves for leaf in leaves),
            tuple(frame for room in self.home.rooms for frame in self.spawns(room.id)),
            tuple(self.views()),
        )

    def spawns(self, room: str) -> list[Frame]:
        """For each door of a room a frame on the floor inside of it: ``<room>:spawn:<door>``."""
        up = self.home.storey_of(room).elevation
        found = spawns(self.home.shell(room))
        return [replace(f, name=_renamed(f.name, room), position=_raised(f.position, up)) for f in found]

    def views(self) -> Iterator[View]:
        """Over the home, and those of each room: ``home:top``, ``<room>:top``, ``<room>:eye-door`` ..."""
        low, high = self.corners
        x, y = ((low + high) / 2)[:2].tolist()
        reach = float(np.linalg.norm((high - low)[:2]))
        turn = from_yaw(0.0 if high[0] - low[0] >= high[1] - low[1] else np.pi / 2)
        yield View(f"{self.names.home}:top", (x, y, float(high[2]) + _ABOVE * reach), turn, float(_FIELD))
        for room in self.home.rooms:
            up = self.home.storey_of(room.id).elevation
            for view in views(self.home.shell(room.id), room.scene.objects if room.scene is not None else ()):
                yield replace(view, name=_renamed(view.name, room.id), position=_raised(view.position, up))


def _renamed(name: str, room: str) -> str:
    return f"{room}:{name.removeprefix('room:')}"


def _raised(position: tuple[float, float, float], up: float) -> tuple[float, float, float]:
    x, y, z = position
    return x, y, z + up
