"""Tasks: an instruction in words, when it is done, and how far it has come. All by geometry of poses, no contacts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .geometry import Articulation, SceneGeometry
from .predicates import distance_to_box, faces, is_inside, is_near, is_on, open_share, to_world
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
class Open(Task):
    """Open a door, lid or drawer, by the name of its body, to ``share`` of its range.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Open("fridge-0.door-0", share=0.5).subject
        'fridge-0.door-0'
    """

    joint: str
    share: float = 0.9

    @property
    def subject(self) -> str:
        """The door's body."""
        return self.joint

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "open the fridge"."""
        return f"open {_words_of_joint(geometry, self.joint)}"

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is open that far."""
        return bool(_opened(geometry, state, self.joint) >= self.share)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """Share that is missing, and the way of the hand to the grip."""
        missing = max(self.share - float(_opened(geometry, state, self.joint)), 0.0)
        return -missing - 0.5 * _to_grip(geometry, state, self.joint)


@dataclass(frozen=True)
class Close(Task):
    """Close a door, lid or drawer that begins open by ``begin`` of its range, to ``share`` of it.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Close("fridge-0.door-0").begin
        0.7
    """

    joint: str
    share: float = 0.05
    begin: float = 0.7

    @property
    def subject(self) -> str:
        """The door's body."""
        return self.joint

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "close the fridge"."""
        return f"close {_words_of_joint(geometry, self.joint)}"

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it is closed."""
        return bool(_opened(geometry, state, self.joint) <= self.share)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """Share that is open, and the way of the hand to the grip."""
        return -float(_opened(geometry, state, self.joint)) - 0.5 * _to_grip(geometry, state, self.joint)

    def start_joints(self, geometry: SceneGeometry) -> Mapping[str, float]:
        """It begins open by ``begin`` of its range."""
        return {self.joint: self.begin * geometry.articulations[self.joint].open_end}


@dataclass(frozen=True)
class PutIn(Task):
    """Put a thing into an interior, given by the body that carries it and its name, and let go.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.PutIn("mug-0", "sink_cabinet-0", "basin").subject
        'mug-0'
    """

    item: str
    container: str
    interior: str

    @property
    def subject(self) -> str:
        """The thing."""
        return self.item

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "put the mug in the sink"."""
        return f"put {_words(geometry, self.item)} in {_words(geometry, self.container)}"

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether the middle of its box is inside and the hand is away."""
        room = geometry.interior(self.container, self.interior)
        pose = state.bodies[self.container]
        inside = is_inside(_centre(geometry, state, self.item), pose, room.low, room.high, room.oval)
        return bool(inside) and _released(geometry, state, self.item)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The way of the thing to the middle of the interior, and of the hand to the thing."""
        return _carried(geometry, state, self.item, self.goal(geometry, state))

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """Where it stands on the bottom, in the middle."""
        room = geometry.interior(self.container, self.interior)
        low = np.append((room.low[:2] + room.high[:2]) / 2, room.low[2] + geometry.items[self.item].size[2] / 2)
        return to_world(state.bodies[self.container], low)


@dataclass(frozen=True)
class PutOn(Task):
    """Put a thing onto a support surface, given by its object and its name, and let go.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.PutOn("mug-0", "dining_table-0", "top").surface
        'top'
    """

    item: str
    support: str
    surface: str

    @property
    def subject(self) -> str:
        """The thing."""
        return self.item

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "put the mug on the dining table"."""
        return f"put {_words(geometry, self.item)} on {_words(geometry, self.support)}"

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether it rests on the surface and the hand is away."""
        top = geometry.surface(self.support, self.surface)
        bottom = _lowest(geometry, state, self.item)
        on = is_on(bottom, state.bodies[self.support], top.low, top.high, top.z)
        return bool(on) and _released(geometry, state, self.item)

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The way of the thing to the middle of the surface, and of the hand to the thing."""
        return _carried(geometry, state, self.item, self.goal(geometry, state))

    def goal(self, geometry: SceneGeometry, state: RoomState) -> Array:
        """Where it stands in the middle of the surface."""
        top = geometry.surface(self.support, self.surface)
        point = np.append((top.low + top.high) / 2, top.z + geometry.items[self.item].size[2] / 2)
        return to_world(state.bodies[self.support], point)


@dataclass(frozen=True)
class Take(Task):
    """Hold a thing at least ``height`` [m] above where it began.

    Examples:
        >>> from sceneweaver import envs
        >>> envs.Take("mug-0").height
        0.1
    """

    item: str
    height: float = 0.1

    @property
    def subject(self) -> str:
        """The thing."""
        return self.item

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "pick up the mug"."""
        return f"pick up {_words(geometry, self.item)}"

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
class NavigateTo(Task):
    """Drive to within ``reach`` [m] of an object's box and look at its middle.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver import envs
        >>> envs.NavigateTo("bed").instruction(envs.SceneGeometry(sw.Scene.example("bedroom")))
        'go to the bed'
    """

    item: str
    reach: float = 0.7

    @property
    def subject(self) -> str:
        """The object."""
        return self.item

    def instruction(self, geometry: SceneGeometry) -> str:
        """ "go to the fridge"."""
        return f"go to {_words(geometry, self.item)}"

    def success(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> bool:
        """Whether the base is near and looks there."""
        near = self._distance(geometry, state) <= self.reach
        return near and bool(faces(state.base, _centre(geometry, state, self.item)[:2]))

    def potential(self, geometry: SceneGeometry, state: RoomState, start: RoomState) -> float:
        """The way that is left, and by how much the base looks aside, half a metre for a full turn."""
        way = max(self._distance(geometry, state) - self.reach, 0.0)
        point = _centre(geometry, state, self.item)
        bearing = np.arctan2(point[1] - state.base[1], point[0] - state.base[0]) - state.base[2]
        return -way - 0.5 * abs((bearing + np.pi) % (2 * np.pi) - np.pi) / np.pi

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


def grasp_point(geometry: SceneGeometry, state: RoomState, joint: str) -> Array:
    """Where to take hold of a door or drawer [3]: its first grasp, else the middle of its edge that moves most."""
    found = geometry.grasps.get(joint)
    local = found[0].position if found else geometry.items[geometry.articulations[joint].object].centre
    return to_world(state.bodies[joint], local)


def _opened(geometry: SceneGeometry, state: RoomState, joint: str) -> Array:
    return open_share(state.joints[joint], geometry.articulations[joint].open_end)


def _to_grip(geometry: SceneGeometry, state: RoomState, joint: str) -> float:
    return float(np.linalg.norm(grasp_point(geometry, state, joint) - state.tool[:3]))


def _centre(geometry: SceneGeometry, state: RoomState, name: str) -> Array:
    if name not in geometry.items:
        return grasp_point(geometry, state, name)
    return to_world(state.bodies[name], geometry.items[name].centre)


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
    """ "the mug"; with its number where the room has several."""
    if name in geometry.articulations:
        return _words_of_joint(geometry, name)
    category = geometry.items[name].category
    several = sum(item.category == category for item in geometry.items.values()) > 1
    return f"the {category.replace('_', ' ')}" + (f" {name}" if several else "")


def _words_of_joint(geometry: SceneGeometry, name: str) -> str:
    """ "the fridge", or "the upper door of the fridge" where it has several."""
    door: Articulation = geometry.articulations[name]
    owner = _words(geometry, door.object)
    several = sum(other.object == door.object for other in geometry.articulations.values()) > 1
    part = name.removeprefix(f"{door.object}.").replace("_", " ").replace("-", " ")
    return f"the {part} of {owner}" if several else owner
