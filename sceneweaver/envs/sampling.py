"""Which tasks a room offers to a robot, and tasks by words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice

import numpy as np

from sceneweaver.physics.things import Thing
from sceneweaver.scene import InputError

from .geometry import Interior, Item, SceneGeometry, SupportSurface, grasps_of
from .naming import fit, plain
from .predicates import is_inside, to_local, to_world
from .reach import Reach, stands
from .robots import Robot
from .tasks import Close, JointTask, NavigateTo, Open, PutIn, PutOn, PutTask, Take, Task, Tidy

Array = np.ndarray
Poses = Mapping[str, Array]

_MARGIN = 0.01  # [m] between a thing and the edge of what it goes into
_EACH = 8  # places of each kind for a thing
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
    reach = Reach(geometry, robot, poses)
    found: list[Task] = []
    for joint in geometry.articulations:
        if _operable(geometry, reach, poses, joint):
            found += [Open(joint), Close(joint)]
    taken = [item for item in geometry.items.values() if _takeable(geometry, robot, reach, poses, item)]
    found += [Take(item.name) for item in taken]
    surfaces = [top for top in geometry.surfaces if _workable(robot, poses, top)]
    for item in taken:
        puts = _put_in(geometry, robot, reach, poses, item), _put_on(geometry, reach, surfaces, item)
        found += [goal for goals in puts for goal in islice(goals, _EACH)]
    if robot.base:
        standing = [t.object for t in geometry.things if stands(t.object.mount, t.object.size[2])]
        found += [NavigateTo(thing.id) for thing in standing if reach.beside(thing.id)]
    home = _homes(geometry, robot, poses, taken)
    if home and robot.base:
        found.append(Tidy(tuple(home[:_TIDY_MOST])))
    return found


def task_named(text: str, tasks: Iterable[Task], geometry: SceneGeometry) -> Task:
    """The task that a text asks for: "open the fridge", "close fridge-0.upper door", "put the mug in the sink",
    "put plate-1 on the dining table", "take the mug", "go to the bed", "tidy".

    Args:
        text: Verb and things; a thing is the name of a body, or words of its category, with words about its look
            before them where these are wanted, as in "go to the oak desk".
        tasks: Those to choose from, as by `tasks_of`; the first that fits is taken.
        geometry: Of the scene.

    Raises:
        InputError: nothing here is called so, or no such task is feasible here.
    """
    words = " ".join(text.lower().split())
    for verb, kinds in _VERBS.items():
        if words == verb or words.startswith(f"{verb} "):
            rest = words.removeprefix(verb).strip()
            fits = [(_fit_task(task, rest, geometry), task) for task in tasks if isinstance(task, kinds)]
            score, best = max(fits, key=lambda pair: pair[0], default=(0.0, None))
            if best is not None and score > 0:
                return best
            raise InputError(_refusal(text, rest, kinds, geometry))
    raise InputError(f"task: '{text}' has no known verb; begin with {', '.join(_VERBS)}")


def _operable(geometry: SceneGeometry, reach: Reach, poses: Poses, joint: str) -> bool:
    """Whether it opens far enough to matter and has a grip within reach."""
    door = geometry.articulations[joint]
    span = abs(door.open_end)
    if door.role == "control" or span < (0.1 if door.slides else 0.5):
        return False
    grasps = [to_world(poses[joint], g.position) for g in grasps_of(geometry, joint)]
    return bool(grasps) and bool(reach.points(np.array(grasps)).any())


def _takeable(geometry: SceneGeometry, robot: Robot, reach: Reach, poses: Poses, item: Item) -> bool:
    if not item.free or item.mass > robot.payload or not grasps_of(geometry, item.name):
        return False
    centre = to_world(poses[item.name], item.centre)
    return bool(reach.points(centre)) and bool(centre[2] <= robot.heights[1] - item.size[2])


def _put_in(geometry: SceneGeometry, robot: Robot, reach: Reach, poses: Poses, item: Item) -> Iterator[PutIn]:
    """Interiors that are open from above: sinks, bowls, bins; what has a door needs it opened first."""
    for room in geometry.interiors:
        owner = geometry.owner[room.body]
        if owner == geometry.owner[item.name] or room.body in geometry.articulations or room.entry[2] < 0.9:
            continue
        centre = to_world(poses[item.name], item.centre)
        middle = to_world(poses[room.body], (room.low + room.high) / 2)
        inside = bool(is_inside(centre, poses[room.body], room.low, room.high, room.oval))
        if not inside and _goes_through(item, room) and middle[2] <= robot.heights[1] - 0.3 and reach.points(middle):
            yield PutIn(item.name, room.body, room.name)


def _put_on(geometry: SceneGeometry, reach: Reach, surfaces: list[SupportSurface], item: Item) -> Iterator[PutOn]:
    """Surfaces that have a free spot for it."""
    support = {t.object.id: t.object.support for t in geometry.things}.get(item.name)
    for top in surfaces:
        here = support is not None and (support.object, support.surface) == (top.body, top.name)
        if not here and top.body != geometry.owner[item.name]:
            spot = reach.spot(top, item)
            if spot is not None:
                yield PutOn(item.name, top.body, top.name, spot)


def _workable(robot: Robot, poses: Poses, top: SupportSurface) -> bool:
    """Whether a surface is at a height to work at."""
    return 0.3 <= float(poses[top.body][2]) + top.z <= robot.heights[1] - 0.4


def _goes_through(item: Item, room: Interior) -> bool:
    """Whether its plan goes through the opening and most of it is inside then."""
    opening = sorted((room.high - room.low)[:2])
    plan = sorted(item.size[:2])
    spare = 2 * _MARGIN
    if room.oval:
        return bool(np.hypot(*plan) + spare < opening[0])
    return bool(plan[0] + spare < opening[0] and plan[1] + spare < opening[1])


def _homes(geometry: SceneGeometry, robot: Robot, poses: Poses, taken: list[Item]) -> list[PutOn]:
    """Where things stand now, as goals."""
    found = []
    names = {item.name for item in taken}
    for thing in geometry.things:
        support = thing.object.support
        if support is not None and thing.object.id in names:
            top = geometry.surface(support.object, support.surface)
            if _workable(robot, poses, top):
                found.append(PutOn(thing.object.id, support.object, support.surface, _spot_of(geometry, thing, poses)))
    return found


def _spot_of(geometry: SceneGeometry, thing: Thing, poses: Poses) -> tuple[float, float]:
    """Where a thing stands on its support, in the plan of the support's body."""
    item, support = geometry.items[thing.object.id], thing.object.support
    assert support is not None
    x, y, _ = to_local(poses[support.object], to_world(poses[item.name], item.centre)).tolist()
    return x, y


def _parted(rest: str, kind: type[Task]) -> tuple[str, str]:
    """The thing and the place of words such as "the mug onto the table"; no place: ""."""
    words, preposition = (" into ", " in ") if kind is PutIn else (" onto ", " on ")
    thing, _, place = rest.replace(words, preposition).partition(preposition)
    return thing, place


def _refusal(text: str, rest: str, kinds: tuple[type[Task], ...], geometry: SceneGeometry) -> str:
    """Why no task is what a text asks for: something is not there, or it cannot be done."""
    scene = geometry.scene.id
    bodies = [*geometry.items, *geometry.articulations]
    said = [rest]
    if PutTask in (base for kind in kinds for base in kind.__mro__):
        said = next((parts for kind in kinds if all(parts := _parted(rest, kind))), ())
        if not said:
            return f"task: '{text}' does not say where to; say put ... in ... or put ... on ..."
    for words in said:
        if not any(fit(words, name, geometry) for name in bodies):
            last = plain(words).rpartition(" ")[2]
            owners = {geometry.owner[name] for name in bodies if last and fit(last, name, geometry)}
            named = {thing.object.id: thing.object.description for thing in geometry.things}
            near = sorted(f"{name} ({named[name]})" if named[name] else name for name in owners)
            hint = f"there is {', '.join(near[:4])}" if near else "see RoomEnv.world.geometry.items for what is there"
            return f"task: nothing in scene '{scene}' is '{plain(words)}'; {hint}"
    return (
        f"task: '{text}' is not feasible in scene '{scene}': out of the robot's reach, too heavy or too wide for it, "
        "or there is no free place; RoomEnv.tasks has what is"
    )


def _fit_task(task: Task, rest: str, geometry: SceneGeometry) -> float:
    """How well the words after the verb mean a task; 0: not at all."""
    if isinstance(task, Tidy):
        return 1.0
    if isinstance(task, PutTask):
        thing, place = _parted(rest, type(task))
        one, other = fit(thing, task.item, geometry), fit(place, task.place(geometry).body, geometry)
        return one + other if one and other else 0.0
    found = fit(rest, task.subject, geometry)
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
