"""Which tasks a room offers to a robot, and tasks by words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice

import numpy as np

from sceneweaver.scene import InputError

from .geometry import Interior, Item, SceneGeometry, SupportSurface, grasps_of
from .predicates import is_inside, to_world
from .robots import Robot
from .tasks import Close, JointTask, NavigateTo, Open, PutIn, PutOn, PutTask, Take, Task, Tidy

Array = np.ndarray
Poses = Mapping[str, Array]

_MARGIN = 0.01  # [m] between a thing and the edge of what it goes into
_FLAT = 0.1  # [m]; lower things, as rugs, are driven over
_ARTICLES = ("the ", "a ", "an ")
_ELBOW_ROOM = 0.08  # [m] around where a thing is put
_TIDY_MOST = 3  # things of one tidy-up


def tasks_of(geometry: SceneGeometry, robot: Robot, poses: Poses) -> list[Task]:
    """All tasks that are feasible by geometry: within reach, light enough, and going through the opening.

    Args:
        geometry: Of the scene.
        robot: Who does them.
        poses: Poses [7] of all bodies, closed.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.envs import NavigateTo, World, mobile_manipulator, tasks_of
        >>> world = World(sw.Scene.example("bedroom"), mobile_manipulator())
        >>> state = world.state(world.new_data())
        >>> any(isinstance(t, NavigateTo) for t in tasks_of(world.geometry, world.robot, state.bodies))
        True
    """
    found: list[Task] = []
    for joint in geometry.articulations:
        if _operable(geometry, robot, poses, joint):
            found += [Open(joint), Close(joint)]
    taken = [item for item in geometry.items.values() if _takeable(geometry, robot, poses, item)]
    found += [Take(item.name) for item in taken]
    surfaces = _free_surfaces(geometry, robot, poses)
    for item in taken:
        puts = _put_in(geometry, robot, poses, item), _put_on(geometry, surfaces, item)
        found += [goal for goals in puts for goal in islice(goals, 8)]
    if robot.base:
        standing = [t.object for t in geometry.things if t.object.mount == "floor"]
        found += [NavigateTo(thing.id) for thing in standing if thing.size[2] > _FLAT]
    home = _homes(geometry, robot, poses, taken)
    if home and robot.base:
        found.append(Tidy(tuple(home[:_TIDY_MOST])))
    return found


def task_named(text: str, tasks: Iterable[Task], geometry: SceneGeometry) -> Task:
    """The task that a text asks for: "open the fridge", "close fridge-0.upper door", "put the mug in the sink",
    "put plate-1 on the dining table", "take the mug", "go to the bed", "tidy".

    Args:
        text: Verb and things; a thing is the name of a body, or words of its category.
        tasks: Those to choose from, as by `tasks_of`; the first that fits is taken.
        geometry: Of the scene.

    Raises:
        InputError: no such task is feasible here.
    """
    words = " ".join(text.lower().split())
    for verb, kinds in _VERBS.items():
        if words == verb or words.startswith(f"{verb} "):
            rest = words.removeprefix(verb).strip()
            fits = [(_fit_task(task, rest, geometry), task) for task in tasks if isinstance(task, kinds)]
            score, best = max(fits, key=lambda fit: fit[0], default=(0.0, None))
            if best is not None and score > 0:
                return best
            raise InputError(f"task: '{text}' is not feasible in scene '{geometry.scene.id}'; see RoomEnv.tasks")
    raise InputError(f"task: '{text}' has no known verb; begin with {', '.join(_VERBS)}")


def _operable(geometry: SceneGeometry, robot: Robot, poses: Poses, joint: str) -> bool:
    """Whether it opens far enough to matter and has a grip within reach."""
    door = geometry.articulations[joint]
    span = abs(door.open_end)
    if door.role == "control" or span < (0.1 if door.slides else 0.5):
        return False
    grasps = [to_world(poses[joint], g.position) for g in grasps_of(geometry, joint)]
    low, high = robot.heights
    return any(low <= point[2] <= high for point in grasps)


def _takeable(geometry: SceneGeometry, robot: Robot, poses: Poses, item: Item) -> bool:
    if not item.free or item.mass > robot.payload or not grasps_of(geometry, item.name):
        return False
    low, high = robot.heights
    centre = to_world(poses[item.name], item.centre)
    return bool(low <= centre[2] <= high - item.size[2])


def _put_in(geometry: SceneGeometry, robot: Robot, poses: Poses, item: Item) -> Iterator[PutIn]:
    """Interiors that are open from above: sinks, bowls, bins; what has a door needs it opened first."""
    for room in geometry.interiors:
        owner = geometry.owner[room.body]
        if owner == geometry.owner[item.name] or room.body in geometry.articulations or room.entry[2] < 0.9:
            continue
        centre = to_world(poses[item.name], item.centre)
        rim = to_world(poses[room.body], (room.low + room.high) / 2)[2]
        inside = bool(is_inside(centre, poses[room.body], room.low, room.high, room.oval))
        if not inside and _goes_through(item, room) and robot.heights[0] <= rim <= robot.heights[1] - 0.3:
            yield PutIn(item.name, room.body, room.name)


def _put_on(geometry: SceneGeometry, free: list[SupportSurface], item: Item) -> Iterator[PutOn]:
    support = {t.object.id: t.object.support for t in geometry.things}.get(item.name)
    for top in free:
        here = support is not None and (support.object, support.surface) == (top.body, top.name)
        if not here and top.body != geometry.owner[item.name] and _fits(item, top):
            yield PutOn(item.name, top.body, top.name)


def _crowds(geometry: SceneGeometry, poses: Poses) -> tuple[list[str], Array, Array, Array]:
    """Names, middles [N, 3], lowest heights [N] and radii in plan [N] of all things."""
    items = list(geometry.items.values())
    middles = to_world(np.stack([poses[item.name] for item in items]), np.stack([item.centre for item in items]))
    lowest = np.array([poses[item.name][2] + item.low[2] for item in items])
    return [item.name for item in items], middles, lowest, np.array([max(item.size[:2]) / 2 for item in items])


def _free_surfaces(geometry: SceneGeometry, robot: Robot, poses: Poses) -> list[SupportSurface]:
    """Surfaces at a height to work at with nothing in their middle."""
    if not geometry.items:
        return []
    names, middles, lowest, radii = _crowds(geometry, poses)
    found = []
    for top in geometry.surfaces:
        height = float(poses[top.body][2]) + top.z
        if not 0.3 <= height <= robot.heights[1] - 0.4:
            continue
        middle = to_world(poses[top.body], np.append((top.low + top.high) / 2, top.z))
        near = np.linalg.norm(middles[:, :2] - middle[:2], axis=1) < radii + _ELBOW_ROOM
        near &= (lowest > height - 0.03) & (np.array(names) != top.body)
        if not near.any():
            found.append(top)
    return found


def _goes_through(item: Item, room: Interior) -> bool:
    """Whether its plan goes through the opening and most of it is inside then."""
    opening = sorted((room.high - room.low)[:2])
    plan = sorted(item.size[:2])
    spare = 2 * _MARGIN
    if room.oval:
        return bool(np.hypot(*plan) + spare < opening[0])
    return bool(plan[0] + spare < opening[0] and plan[1] + spare < opening[1])


def _fits(item: Item, top: SupportSurface) -> bool:
    return bool((top.high - top.low > max(item.size[:2]) + 2 * _MARGIN).all())


def _homes(geometry: SceneGeometry, robot: Robot, poses: Poses, taken: list[Item]) -> list[PutOn]:
    """Where things stand now, as goals."""
    found = []
    names = {item.name for item in taken}
    for thing in geometry.things:
        support = thing.object.support
        if support is not None and thing.object.id in names:
            top = geometry.surface(support.object, support.surface)
            if 0.3 <= poses[top.body][2] + top.z <= robot.heights[1] - 0.4:
                found.append(PutOn(thing.object.id, support.object, support.surface))
    return found


def _fit(words: str, name: str, geometry: SceneGeometry) -> float:
    """How well words mean a body: its name 4, its object 3, its category 2, a part of its category 1, else 0."""
    for article in _ARTICLES:
        words = words.removeprefix(article)
    owner = geometry.owner[name]
    category = geometry.items[owner].category if name in geometry.articulations else geometry.items[name].category
    category = category.replace("_", " ").lower()
    if words == name.lower():
        return 4.0
    if words == owner.lower():
        return 3.0
    if words == category:
        return 2.0
    return 1.0 if words and set(words.split()) <= set(category.split()) else 0.0


def _fit_task(task: Task, rest: str, geometry: SceneGeometry) -> float:
    """How well the words after the verb mean a task; 0: not at all."""
    if isinstance(task, Tidy):
        return 1.0
    if isinstance(task, PutTask):
        words, preposition = (" into ", " in ") if isinstance(task, PutIn) else (" onto ", " on ")
        thing, found, place = rest.replace(words, preposition).partition(preposition)
        one, other = _fit(thing, task.item, geometry), _fit(place, task.place(geometry).body, geometry)
        return one + other if found and one and other else 0.0
    found = _fit(rest, task.subject, geometry)
    if found and isinstance(task, JointTask):
        # Of several doors the one with the highest grip is the main one.
        grip = max((g.position[2] for g in geometry.grasps.get(task.joint, ())), default=0.0)
        found += 0.01 * grip + (0.1 if geometry.articulations[task.joint].role == "door" else 0.0)
    return found


_VERBS: dict[str, tuple[type[Task], ...]] = {
    "open": (Open,),
    "close": (Close,),
    "put": (PutIn, PutOn),
    "take": (Take,),
    "pick up": (Take,),
    "go to": (NavigateTo,),
    "navigate to": (NavigateTo,),
    "tidy": (Tidy,),
}
