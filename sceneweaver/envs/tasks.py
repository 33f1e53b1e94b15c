"""Tasks: an instruction in words, when it is done, and how far it has come. All by geometry of poses, no contacts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import ClassVar

import numpy as np

from .geometry import SceneGeometry
from .predicates import bearing_off, distance_to_box, faces, is_inside, is_near, is_on, open_share, to_world
from .world import RoomState

Array = np.ndarray

RELEASED = 0.12
"""A hand whose tool is farther than this [m] from the box of a thing has let go of it."""


class Task(ABC):
    """What a robot is to do in a room.

    A task of your own gives `subject`, `instruction`, `success` and `potential`; `start_joints` where doors do not
    begin closed. The reward of a step is the growth of the potential, so that what is best does not change by it (Ng,
    Harada and Russell 1999), and 1 more when the task is done.

    Examples:
        >>> from sceneweaver import envs
        >>> issubclass(envs.Open, envs.Task)
        True
    """

    @property
    @abstractmethod
    def subject(self) -> str:
        """The body that it is about."""

    @abstractmethod
    def instruction(self, geometry: SceneGeometry) -> str:
        """What to do, in words."""

    @abstractmethod
    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is done; ``start`` is how the episode began."""

    @abstractmethod
    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """How far it has come, higher is better: what is still to go [m] or as a share, negative."""

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """The point [3] of the world that the subject, or the base, is to come to."""
        return _centre(geometry, state, self.subject)

    def start_joints(self, geometry: SceneGeometry) -> Mapping[str, float]:
        """Positions of doors and drawers that do not begin closed."""
        return {}


@dataclass(frozen=True)
class _Worded(Task):
    """A task whose instruction names the bodies that its fields name."""

    words: ClassVar[str]

    def instruction(self, geometry: SceneGeometry) -> str:
        """The words of such a task, as "open the fridge"."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return self.words.format_map({k: _words(geometry, v) for k, v in values.items() if v in geometry.owner})


@dataclass(frozen=True)
class JointTask(_Worded):
    """A task about a door, lid or drawer, by the name of its body."""

    joint: str

    @property
    def subject(self) -> str:
        """The door's body."""
        return self.joint

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The share of the range that is missing, and the way of the hand to the grip."""
        grip = _centre(geometry, state, self.joint)
        return -self._missing(geometry, state) - 0.5 * float(np.linalg.norm(grip - state.tool[:3]))

    @abstractmethod
    def _missing(self, geometry: SceneGeometry, state: RoomState) -> float:
        """Share of the range that the door has still to go."""

    def _opened(self, geometry: SceneGeometry, state: RoomState) -> float:
        return float(open_share(state.joints[self.joint], geometry.articulations[self.joint].open_end))


@dataclass(frozen=True)
class Open(JointTask):
    """Open a door, lid or drawer, by the name of its body, to ``share`` of its range.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Open("fridge-0.door-0", share=0.5).subject
        'fridge-0.door-0'
    """

    words: ClassVar[str] = "open {joint}"
    share: float = 0.9

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is open that far."""
        return self._opened(geometry, state) >= self.share

    def _missing(self, geometry: SceneGeometry, state: RoomState) -> float:
        return max(self.share - self._opened(geometry, state), 0.0)


@dataclass(frozen=True)
class Close(JointTask):
    """Close a door, lid or drawer that begins open by ``begin`` of its range, to ``share`` of it.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Close("fridge-0.door-0").begin
        0.7
    """

    words: ClassVar[str] = "close {joint}"
    share: float = 0.05
    begin: float = 0.7

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is closed."""
        return self._opened(geometry, state) <= self.share

    def start_joints(self, geometry: SceneGeometry) -> Mapping[str, float]:
        """It begins open by ``begin`` of its range."""
        return {self.joint: self.begin * geometry.articulations[self.joint].open_end}

    def _missing(self, geometry: SceneGeometry, state: RoomState) -> float:
        return self._opened(geometry, state)


@dataclass(frozen=True)
class ItemTask(_Worded):
    """A task about an object or what can be taken out of one, by the name of its body."""

    item: str

    @property
    def subject(self) -> str:
        """The thing."""
        return self.item


@dataclass(frozen=True)
class Place:
    """Where things are put, in the frame of ``body``: a box from ``low`` to ``high`` [3] (of a surface both have its
    height), or the ellipse in its plan where it is ``oval``; at ``spot`` [2] of its plan, None: in its middle."""

    body: str
    low: Array
    high: Array
    oval: bool = False
    spot: tuple[float, float] | None = None

    @property
    def target(self) -> Array:
        """Where a thing is to stand [3], at the bottom."""
        return np.array([*((self.low[:2] + self.high[:2]) / 2 if self.spot is None else self.spot), self.low[2]])


class PutTask(ItemTask):
    """A task to bring a thing to a `Place` and let go."""

    @abstractmethod
    def place(self, geometry: SceneGeometry) -> Place:
        """Where it goes."""

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The way of the thing to the middle of its place, and of the hand to the thing."""
        return _carried(geometry, state, self.item, self.goal(geometry, state))

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """Where its middle is when it stands in its place, at the spot or in the middle."""
        place = self.place(geometry)
        point = place.target + [0.0, 0.0, geometry.items[self.item].size[2] / 2]
        return to_world(state.bodies[place.body], point)


@dataclass(frozen=True)
class PutIn(PutTask):
    """Put a thing into an interior, given by the body that carries it and its name, and let go.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.PutIn("mug-0", "sink_cabinet-0", "basin").subject
        'mug-0'
    """

    words: ClassVar[str] = "put {item} in {container}"
    container: str
    interior: str

    def place(self, geometry: SceneGeometry) -> Place:
        """The interior."""
        room = geometry.interior(self.container, self.interior)
        return Place(self.container, room.low, room.high, room.oval)

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether the middle of its box is inside and the hand is away."""
        room = self.place(geometry)
        inside = is_inside(_centre(geometry, state, self.item), state.bodies[room.body], room.low, room.high, room.oval)
        return bool(inside) and _released(geometry, state, self.item)


@dataclass(frozen=True)
class PutOn(PutTask):
    """Put a thing onto a support surface, given by its object and its name, and let go.

    It may stand anywhere on the surface; ``spot`` [2], in the plan of the surface's body [m], is where there is room
    for it, and so the goal. None: its middle.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.PutOn("mug-0", "dining_table-0", "top").surface
        'top'
    """

    words: ClassVar[str] = "put {item} on {support}"
    support: str
    surface: str
    spot: tuple[float, float] | None = None

    def place(self, geometry: SceneGeometry) -> Place:
        """The surface."""
        top = geometry.surface(self.support, self.surface)
        return Place(self.support, np.append(top.low, top.z), np.append(top.high, top.z), spot=self.spot)

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it rests on the surface and the hand is away."""
        top = self.place(geometry)
        bottom = _lowest(geometry, state, self.item)
        on = is_on(bottom, state.bodies[top.body], top.low[:2], top.high[:2], top.low[2])
        return bool(on) and _released(geometry, state, self.item)


@dataclass(frozen=True)
class Take(ItemTask):
    """Hold a thing at least ``height`` [m] above where it began.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Take("mug-0").height
        0.1
    """

    words: ClassVar[str] = "pick up {item}"
    height: float = 0.1

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is up and in the hand."""
        risen = state.bodies[self.item][2] - start.bodies[self.item][2]
        return bool(risen >= self.height) and not _released(geometry, state, self.item)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The height that is missing and the way of the hand to the thing."""
        return _carried(geometry, state, self.item, self.goal(geometry, start))

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """Above where it stands."""
        return _centre(geometry, state, self.item) + [0.0, 0.0, self.height]


@dataclass(frozen=True)
class NavigateTo(ItemTask):
    """Drive to within ``reach`` [m] of an object's box and look at its middle.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> envs.NavigateTo("bed").instruction(envs.SceneGeometry(sw.Scene.example("bedroom")))
        'go to the bed'
    """

    words: ClassVar[str] = "go to {item}"
    reach: float = 0.7

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether the base is near and looks there."""
        near = self._distance(geometry, state) <= self.reach
        return near and bool(faces(state.base, _centre(geometry, state, self.item)[:2]))

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The way that is left, and by how much the base looks aside, half a metre for a full turn."""
        way = max(self._distance(geometry, state) - self.reach, 0.0)
        aside = bearing_off(state.base, _centre(geometry, state, self.item)[:2])
        return -way - 0.5 * float(aside) / np.pi

    def _distance(self, geometry: SceneGeometry, state: RoomState) -> float:
        item = geometry.items[self.item]
        return float(distance_to_box(state.base[:2], state.bodies[self.item], item.low, item.high))


@dataclass(frozen=True)
class Tidy(Task):
    """Several tasks at once: all things at home. Things begin on the floor.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Tidy((envs.PutOn("mug-0", "dining_table-0", "top"),)).scattered
        ('mug-0',)
    """

    goals: tuple[PutIn | PutOn, ...]

    @property
    def subject(self) -> str:
        """The first of the things."""
        return self.goals[0].subject

    @property
    def scattered(self) -> tuple[str, ...]:
        """The things that begin somewhere on the floor."""
        return tuple(goal.item for goal in self.goals)

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "tidy up: put the mug in the sink, put ..."."""
        return "tidy up: " + ", ".join(goal.instruction(geometry) for goal in self.goals)

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether every goal is reached."""
        return all(goal.success(geometry, state, start) for goal in self.goals)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The sum of what is left; the hand counts for the nearest thing that is not at home."""
        left = [g for g in self.goals if not g.success(geometry, state, start)]
        ways = [np.linalg.norm(_centre(geometry, state, g.item) - g.goal(geometry, state)) for g in left]
        hand = [np.linalg.norm(_centre(geometry, state, g.item) - state.tool[:3]) for g in left]
        return -float(sum(ways)) - 0.5 * float(min(hand, default=0.0))

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """The goal of the first thing."""
        return self.goals[0].goal(geometry, state)


KINDS: tuple[type[Task], ...] = (Open, Close, NavigateTo, PutIn, PutOn, Take)
"""Kinds of tasks about one thing, by number; batches know these."""


def point_of(geometry: SceneGeometry, name: str) -> Array:
    """The point of a body that counts [3] in its frame: the middle of the box of a thing, the first grasp of a door or
    drawer, without one the middle of its piece."""
    if name in geometry.items:
        return geometry.items[name].centre
    grasps = geometry.grasps.get(name)
    return grasps[0].position if grasps else geometry.items[geometry.articulations[name].object].centre


def _centre(geometry: SceneGeometry, state: RoomState, name: str) -> Array:
    return to_world(state.bodies[name], point_of(geometry, name))


def _lowest(geometry: SceneGeometry, state: RoomState, name: str) -> Array:
    """The point [3] under the middle of a thing's box, at the height of the lowest of its corners."""
    item, pose = geometry.items[name], state.bodies[name]
    ends = np.stack([item.low, item.high])
    corners = np.array([(ends[i, 0], ends[j, 1], ends[k, 2]) for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    return np.append(to_world(pose, item.centre)[:2], to_world(pose, corners)[:, 2].min())


def _released(geometry: SceneGeometry, state: RoomState, name: str) -> bool:
    item = geometry.items[name]
    radius = float(np.linalg.norm(item.size) / 2)
    return not bool(is_near(state.tool[:3], _centre(geometry, state, name), radius + RELEASED))


def _carried(geometry: SceneGeometry, state: RoomState, name: str, goal: Array) -> float:
    centre = _centre(geometry, state, name)
    hand = float(np.linalg.norm(centre - state.tool[:3]))
    return -float(np.linalg.norm(centre - goal)) - 0.5 * hand


def _words(geometry: SceneGeometry, name: str) -> str:
    """ "the mug", or "the upper door of the fridge"; with names where the room has several such things."""
    if name in geometry.articulations:
        piece = geometry.articulations[name].object
        several = sum(other.object == piece for other in geometry.articulations.values()) > 1
        part = name.removeprefix(f"{piece}.").replace("_", " ").replace("-", " ")
        return f"the {part} of {_words(geometry, piece)}" if several else _words(geometry, piece)
    category = geometry.items[name].category
    several = sum(item.category == category for item in geometry.items.values()) > 1
    return f"the {category.replace('_', ' ')}" + (f" {name}" if several else "")
