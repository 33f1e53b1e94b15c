"""From an edited scene to a valid one: objects are freed step by step until a valid layout is found."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Literal

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.layout.engine import refine
from sceneweaver.layout.live import LiveLayout
from sceneweaver.scene import Pose, Scene
from sceneweaver.scene.edits import carried
from sceneweaver.verify import Report, check

Freed = Literal["nothing", "edited", "named", "both", "anywhere", "all"]
"""What was free to move in the end: nothing at all, what was edited, what violations named, both, what was added
anywhere in the room, or everything."""

TRIES = 3  # of a projection with some objects free
ALL = (16, 64)  # candidates with everything free, the second number where the first found nothing
TURNED = math.radians(30.0)  # by which what was edited may be turned so that it fits where it was put
SAME = 1.0e-5  # [m] and [rad] by which a pose may differ and still count as unmoved; float32 loses about 1e-6


@dataclass(frozen=True)
class Settled:
    """A scene with the judge's report, and what was free to move."""

    scene: Scene
    report: Report
    freed: Freed

    @property
    def in_order(self) -> bool:
        """Whether nothing is wrong that moving things could mend: valid, but for what was dropped before."""
        return not any(v.hard and v.kind != "dropped" for v in self.report.violations)


def settle(live: LiveLayout, scene: Scene, edited: Mapping[str, float], new: Collection[str], seed: int) -> Settled:
    """The edited scene made valid with little movement; where nothing valid is found, what has the fewest violations.

    Args:
        live: keeps the compiled scene.
        scene: after the edit.
        edited: ids of what was edited, with how far [m] each may be pushed before others make way for it.
        new: ids of what was not there before.
        seed: of tries and searches.
    """
    given = Settled(scene, check(scene, walkable=False), "nothing")
    if given.in_order:
        return given
    best, far = given, None  # far: valid, but what was edited went further than its leeway
    for freed, attempt in _attempts(live, given, edited, new, seed):
        if far is not None and freed != "named":
            break
        found = attempt()
        if found is None:
            continue
        if found.in_order:
            if freed != "edited" or _within(scene, found.scene, edited):
                return found
            far = found
        best = min(best, found, key=lambda a: sum(v.hard for v in a.report.violations))
    return far or best


Attempt = tuple[Freed, Callable[[], Settled | None]]
"""What is free, and what looks for a layout then: a scene that is not always valid, or None."""


def _attempts(
    live: LiveLayout, given: Settled, edited: Mapping[str, float], new: Collection[str], seed: int
) -> Iterator[Attempt]:
    """Attempts with more and more free: what was edited, what is in trouble but for that, both, everything.

    What is new is searched for a place in the whole room before anything makes way for it. Some things are freed only
    where each violation names one of them.
    """
    scene = given.scene
    wrong = [set(scene.ids).intersection(v.objects) for v in given.report.violations if v.hard]
    surfaces = any(_in_one_stack(scene, each) for each in wrong)
    own = _stacks(scene, edited)
    named = _stacks(scene, set().union(*wrong)) - own
    steps: list[tuple[Freed, set[str]]] = [("edited", own), ("named", named)]
    if own and named:
        steps.append(("both", own | named))
    for freed, free in steps:
        if all(free & each for each in wrong if each):
            yield freed, partial(_projected, live, scene, freed, free, surfaces, seed)
        if freed == "edited" and new:
            yield "anywhere", partial(_placed, live, scene, new, seed)
    for candidates in ALL:
        yield "all", partial(_refined, live, scene, candidates, seed)


def _projected(
    live: LiveLayout, scene: Scene, freed: Freed, free: Collection[str], surfaces: bool, seed: int
) -> Settled | None:
    """The nearest layout with some things free."""
    poses = live.settle(scene, free, surfaces=surfaces, tries=TRIES, seed=seed)
    return None if poses is None else _judged(live, scene, poses, freed)


def _placed(live: LiveLayout, scene: Scene, new: Collection[str], seed: int) -> Settled | None:
    """The nearest layout with what is new anywhere in the room."""
    poses = live.place(scene, new, seed=seed)
    return None if poses is None else _judged(live, scene, poses, "anywhere")


def _refined(live: LiveLayout, scene: Scene, candidates: int, seed: int) -> Settled:
    """A layout near the present one, with everything free and a price on all that was in order."""
    kept = live.compiled(scene)
    solution = refine(
        scene, candidates=candidates, seed=seed, init="current", device=live.device, compiled=kept, walk=False
    )
    return _judged(live, scene, solution.bodies[solution.order[0]].astype(np.float64), "all")


def _judged(live: LiveLayout, scene: Scene, poses: np.ndarray, freed: Freed) -> Settled:
    """The scene at poses [N, 4] and those of its free areas, judged; what has not moved keeps its pose to the bit."""
    moved = {}
    for obj, pose in zip(scene.objects, poses[: len(scene.objects)], strict=True):
        d = pose - (*obj.pose.position, obj.pose.yaw)
        d[3] = wrap_angle(d[3])
        if not obj.fixed and np.abs(d).max() > SAME:
            x, y, z, yaw = pose.tolist()
            moved[obj.id] = Pose.from_yaw(x, y, z, yaw)
    placed = scene.replace_poses(moved)
    if scene.free_areas:
        placed = placed.replace_area_poses(live.area_poses(scene, poses))
    return Settled(placed, check(placed, walkable=False), freed)


def _stacks(scene: Scene, names: Collection[str]) -> set[str]:
    """Some objects with all that stands on them."""
    return {each for name in names for each in carried(scene, name)}


def _in_one_stack(scene: Scene, names: Collection[str]) -> bool:
    """Whether things are all carried by the same one, or are that, and some are carried."""
    roots = set()
    for name in names:
        obj = scene.object(name)
        while obj.support is not None:
            obj = scene.object(obj.support.object)
        roots.add(obj.id)
    return len(roots) == 1 and any(scene.object(name).support for name in names)


def _within(before: Scene, after: Scene, leeways: Mapping[str, float]) -> bool:
    """Whether some objects stayed within their leeway [m], and turned little."""
    for name, leeway in leeways.items():
        a, b = before.object(name).pose, after.object(name).pose
        turned = abs(wrap_angle(a.yaw - b.yaw))
        if math.dist(a.position[:2], b.position[:2]) > leeway or (turned > TURNED and leeway < math.inf):
            return False
    return True
