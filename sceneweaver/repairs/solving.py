"""Passes of projections over many scenes at once: with what is hard, with what is wished for as well, with neither."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from sceneweaver.layout import Solution, engine
from sceneweaver.runtime.deadline import Deadline, TimeUp
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify import Report, check

from .report import Move, moves_between
from .upright import engine_scene, put_back
from .wishes import NEARLY, holding, squared

MOST, LEAST, WORK = 64, 4, 1280  # candidates: as many as WORK objects, within these bounds
TRIES = 4  # of a candidate from the first feasible one on
TRIED = 4  # layouts that are judged when none is valid, and of each pass where wishes count
VARIANTS = 6  # of a scene that loses wishes
JUDGED = 0.5  # [s] beyond a time limit in which what was found is judged
MOVED = 1e-3  # [m] from which an object counts as moved
LOST = 1.0  # [m] of movement that a relation is worth that held before
UNMET = 0.1  # [m] the same of one that nearly did
SKEWED = 0.3  # [m] the same of an object that was square to the room
STIRRED = 0.01  # [m] the same of an object that need not move at all, where wishes count


@dataclass(frozen=True)
class Option:
    """A layout to choose from: the scene in it, the judge on it, who moved, the wishes that it loses (those that held
    before) and leaves unmet (those that nearly did), how many objects are square to the room no more, how many moved
    where that counts by itself, who is gone."""

    scene: Scene
    report: Report
    moves: tuple[Move, ...]
    lost: frozenset[int] = frozenset()
    unmet: frozenset[int] = frozenset()
    skewed: int = 0
    stirred: int = 0
    taken_out: tuple[str, ...] = ()

    @property
    def badness(self) -> tuple[int, float]:
        """Order of options: by how many things are wrong, then by how far objects went and what got lost."""
        wrong = sum(v.hard for v in self.report.violations)
        price = LOST * len(self.lost) + UNMET * len(self.unmet) + SKEWED * self.skewed + STIRRED * self.stirred
        return wrong, sum(m.distance + abs(m.rise) for m in self.moves) + price


@dataclass
class Work:
    """A scene under repair.

    Attributes:
        scene: as it was.
        before: the judge on it.
        relations: whether its hard relations are to hold.
        held: soft relations that hold and should go on holding.
        wishes: these, and those that nearly hold.
        square: objects that should stay square to the room.
        options: what was found so far.
        solution: of the pass with all that is hard and nothing else; None before.
    """

    scene: Scene
    before: Report
    relations: bool
    held: frozenset[int] = frozenset()
    wishes: frozenset[int] = frozenset()
    square: frozenset[int] = frozenset()
    options: list[Option] = field(default_factory=list)
    solution: Solution | None = None
    unjudged: bool = False

    @property
    def best(self) -> Option:
        """The best of the options and the scene as it was."""
        as_it_was = Option(self.scene, self.before, (), unmet=self.wishes - self.held)
        return min([*self.options, as_it_was], key=lambda option: option.badness)

    @classmethod
    def on(cls, scene: Scene, relations: bool, soft: bool) -> Work:
        """Work on a scene, with its soft relations for wishes where they count and something is to be mended."""
        before = judged(scene, relations)
        if not soft or before.valid:
            return cls(scene, before, relations)
        return cls(scene, before, relations, holding(scene), holding(scene, slack=NEARLY), squared(scene))


@dataclass(frozen=True)
class Budget:
    """How much a pass may do."""

    candidates: int | None
    seed: int
    device: str
    times: int = 1

    def count(self, scene: Scene) -> int:
        """Candidates of a scene: as asked for or by its size, or so many times as many, up to `MOST`."""
        base = self.candidates or max(LEAST, min(MOST, WORK // max(1, len(scene.objects))))
        return max(base, min(MOST, self.times * base))


def judged(scene: Scene, relations: bool, *, walkable: bool = True) -> Report:
    """The judge on a scene, with all relations taken for soft when they were not asked for."""
    if not relations:
        soft = tuple(r.model_copy(update={"hard": False}) for r in scene.relations)
        scene = scene.model_copy(update={"relations": soft})
    return check(scene, walkable=walkable)


Hard = Sequence[frozenset[int]]
"""The numbers of the relations that are to hold, of each scene."""

Found = list[tuple[Solution, np.ndarray]]
"""Of each scene its solution, and how far its objects were lifted for the engine [m]."""


def project(
    work: Sequence[Work],
    hard: Hard,
    budget: Budget,
    clock: Deadline,
    *,
    square: bool = False,
    anew: bool = False,
    bound: Sequence[frozenset[int]] = (),
) -> Found:
    """Solve scenes in shared launches with the relations of these numbers to hold.

    Args:
        work: the scenes.
        hard: of each the numbers of the relations.
        budget: candidates, seed, device.
        clock: when to be back.
        square: whether what is square to the room keeps its yaw.
        anew: not from where they are but from layouts that are searched for.
        bound: of each the numbers of the objects that stay where they are.
    """
    models = []
    for each, numbers, still in zip(work, hard, bound or [frozenset[int]()] * len(work), strict=True):
        kept = _still(_squared(each.scene, each.square) if square else each.scene, still)
        models.append(engine_scene(_with_hard(kept, numbers), True))
    solutions = engine.refine_many(
        [model for model, _ in models],
        candidates=[budget.count(each.scene) for each in work],
        init="sample" if anew else "current",
        optimizer="search" if anew else "projection",
        steps=None if anew else TRIES,
        seed=budget.seed,
        device=budget.device,
        time_limit=clock.time_limit,
    )
    return [(solution, lift) for solution, (_, lift) in zip(solutions, models, strict=True)]


def judge(work: Sequence[Work], found: Found, nearest: bool = False) -> list[Solution]:
    """Make the best layout of each scene an option, or where none is valid or wishes count a few; the solutions.

    ``nearest``: a few of those that moved least anyway.
    """
    for each in work:
        each.unjudged = True
    for each, (solution, lift) in zip(work, found, strict=True):
        for k in _chosen(solution, nearest or bool(each.wishes or each.square)):
            add_option(each, put_back(each.scene, lift, solution.poses[k]))
        each.unjudged = False
    return [solution for solution, _ in found]


def _still(scene: Scene, bound: frozenset[int]) -> Scene:
    """The scene with these objects fixed."""
    if not bound:
        return scene
    objects = (o.model_copy(update={"fixed": True}) if i in bound else o for i, o in enumerate(scene.objects))
    return scene.model_copy(update={"objects": tuple(objects)})


def _squared(scene: Scene, square: frozenset[int]) -> Scene:
    """The scene with these objects bound to their yaw."""
    objects = tuple(
        o.model_copy(update={"yaw_domain": (math.degrees(o.pose.yaw),)}) if i in square else o
        for i, o in enumerate(scene.objects)
    )
    return scene.model_copy(update={"objects": objects})


def _with_hard(scene: Scene, numbers: frozenset[int]) -> Scene:
    """The scene with the relations of these numbers hard and all others soft."""

    def with_hardness(k: int, relation: Relation) -> Relation:
        return relation if relation.hard == (k in numbers) else relation.model_copy(update={"hard": k in numbers})

    relations = tuple(with_hardness(k, r) for k, r in enumerate(scene.relations))
    return scene.model_copy(update={"relations": relations})


def _chosen(solution: Solution, nearest: bool) -> np.ndarray:
    """The layouts of a solution that are worth a look by the judge: the best, and with ``nearest`` those that moved
    least; where none is valid those with the least left to mend."""
    chosen = solution.order[:1]
    if solution.status[chosen[0]] != 0:
        return np.unique(np.concatenate([chosen, np.argsort(solution.energy, kind="stable")[:TRIED]]))
    if not nearest:
        return chosen
    before = np.array([o.pose.position for o in solution.source.objects])
    shift = np.linalg.norm(solution.poses[..., :3] - before, axis=-1).sum(axis=-1)
    near = solution.ranked[np.argsort(shift[solution.ranked], kind="stable")[:TRIED]]
    return np.unique(np.concatenate([chosen, near]))


def add_option(work: Work, scene: Scene) -> None:
    """Make a layout of the scene an option, with what the judge says of it."""
    report = judged(scene, work.relations, walkable=False)  # floor is measured of what is chosen
    missed = work.wishes - holding(scene, work.wishes)
    moves = moves_between(work.scene, scene)
    skewed = len(work.square - squared(scene)) if work.square else 0
    stirred = sum(m.distance + abs(m.rise) > MOVED for m in moves) if work.wishes or work.square else 0
    work.options.append(Option(scene, report, moves, missed & work.held, missed - work.held, skewed, stirred))


def hard_relations(scene: Scene) -> frozenset[int]:
    """The numbers of the hard relations of a scene."""
    return frozenset(k for k, r in enumerate(scene.relations) if r.hard)


def mend(work: Sequence[Work], budget: Budget, clock: Deadline) -> None:
    """Project scenes: with all that is hard, with their wishes too, and where that cannot be with those that can.

    Where hard relations cannot hold everything else still can. Scenes that stay invalid, and of which nothing proves
    that they are so, are projected once more with more candidates.
    """
    if not work:
        return
    asked = [hard_relations(each.scene) if each.relations else frozenset() for each in work]
    found = project(work, asked, budget, clock)
    for each, (solution, _) in zip(work, found, strict=True):
        each.solution = solution
    with suppress(TimeUp), clock.enforced(lambda: JUDGED):
        judge(work, found)
        bare = [each for each, numbers in zip(work, asked, strict=True) if numbers and _failed(each.solution)]
        if bare:
            judge(bare, project(bare, [frozenset()] * len(bare), budget, clock))
        wishing = [(each, n) for each, n in zip(work, asked, strict=True) if each.wishes or each.square]
        _mend_wishing([trial for trial in wishing if not _failed(trial[0].solution)], budget, clock)


def lay_out_anew(work: Sequence[Work], budget: Budget, clock: Deadline) -> None:
    """Search layouts of scenes that no projection made valid; those with the least movement become options."""
    if not work:
        return
    asked = [hard_relations(each.scene) if each.relations else frozenset() for each in work]
    found = project(work, asked, budget, clock, anew=True)
    with suppress(TimeUp), clock.enforced(lambda: JUDGED):
        judge(work, found, nearest=True)


Trial = tuple[Work, frozenset[int]]
"""A scene with the relations that are to hold in a pass."""


def _mend_wishing(scenes: Sequence[Trial], budget: Budget, clock: Deadline) -> None:
    """Passes in which wishes have to hold as if they were hard, and what is square keeps its yaw.

    First all wishes; where that fails those that held before; where that fails those that hold in the layout nearest to
    valid. Where nothing that stays square is valid the same again with any yaw. Then, of scenes that lose some that
    held, each of these again beside all others that need not be lost.

    Args:
        scenes: with the relations that have to hold anyway.
    """

    def run(trials: Sequence[Trial], square: bool) -> list[tuple[Trial, Solution]]:
        if not trials or clock.passed:
            return []
        some = [each for each, _ in trials]
        found = project(some, [numbers for _, numbers in trials], budget, clock, square=square)
        return list(zip(trials, judge(some, found), strict=True))

    def chain(trials: Sequence[Trial], square: bool) -> None:
        tried = run([(each, numbers | each.wishes) for each, numbers in trials], square)
        failed = {id(each) for (each, _), solution in tried if _failed(solution)}
        less = [(each, n | each.held) for each, n in trials if id(each) in failed and each.held != each.wishes]
        tried = [trial for trial in run(less, square) or tried if _failed(trial[1])]
        run([(each, numbers - (each.wishes & _unmet(solution))) for (each, numbers), solution in tried], square)

    chain(scenes, True)
    chain([trial for trial in scenes if trial[0].best.skewed], False)
    for square in (True, False):
        trials = []
        for each, numbers in scenes:
            lost = each.best.lost
            if lost and (each.best.skewed == 0) == square:
                trials += [(each, numbers | (each.held - {k})) for k in sorted(each.held)[:VARIANTS] if len(lost) > 1]
                trials += [(each, numbers | (each.held - lost) | {k}) for k in sorted(lost)[:VARIANTS]]
        run(trials, square)


def _failed(solution: Solution | None) -> bool:
    return solution is not None and bool(solution.status.min() != 0)


def _unmet(solution: Solution) -> frozenset[int]:
    """Relations that do not hold in the layout that is nearest to valid."""
    nearest = int(np.argmin(solution.energy))
    return frozenset(np.flatnonzero(~solution.relations[nearest]).tolist())
