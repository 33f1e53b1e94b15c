"""Layouts of many rooms, searched for in shared launches."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from sceneweaver.agent.choice import choice_terms
from sceneweaver.agent.executor import Outcome, Variant, remaining, with_relations
from sceneweaver.agent.relaxation import lightened
from sceneweaver.agent.riders import searched, with_riders
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.layout import QualityTerm, Solution, refine_many
from sceneweaver.layout.devices import pick_devices
from sceneweaver.scene import PRIORITIES, Room, Scene
from sceneweaver.verify import check

from .drafts import Draft

VARIANTS = 3
"""Ways to line up furniture that are tried in a room, the first that the tool proposes."""

SHARE, LEAST = 4, 2
"""Part of a room's candidates that one round begins, and the least of each case: many a room is soon done, and where
nothing fits, the next round with less in the room or more of it finds more than further tries in this one."""

LEAST_GPU = 16
"""The same on a GPU, which does as many side by side in the time of one: fewer rounds are left to wait for."""

STEPS, STEPS_GPU = 1, 20
"""Times that a layout is begun: of a room that holds it, one of a few will do. On a GPU they are shorter by far."""

GROWN = ((1.12, 1.25), (1.12, 1.25, 1.4), (1.25, 1.4, 1.6), (1.4, 1.6), (1.6, 1.8), (1.8, 2.0))
"""By round after the first, floors of other rooms, as multiples of the one that was drawn."""

ROUNDS = 4 + len(GROWN)
"""Searches: in the room that was drawn, in others and with less in them, and once more where too little was found."""

AGAIN = 0x68E31DA4
"""What lies between the seeds of two searches for the same."""

LESS = 3
"""Things that go at once where no room holds everything."""

COMPARED = 4
"""Layouts that the critic compares for each that is kept. Several of one room have to differ, which takes as many."""

ENOUGH = 2
"""Layouts of a room that is wanted once, with fewer of which there is one search more: the critic should choose."""

LARGE = 0.35
"""Area [m2] of plan from which on a piece makes a layout another one."""

APART, TURNED = 0.3, np.radians(30.0)
"""How far [m] or turned [rad] one large piece is in another layout at least: more than between near-duplicates."""


@dataclass(frozen=True)
class _Case:
    """A room with what is to stand in it, as it is given to the engine."""

    scene: Scene
    plain: Scene
    terms: list[QualityTerm]
    candidates: int
    seed: int


@dataclass
class _Search:
    """The search for layouts of one draft.

    Attributes:
        draft: what is laid out.
        scene: what is left of it.
        variants: relations that line things up, of which the layouts of one are enough.
        least: layouts of each case that a round begins at least.
        found: layouts with minus their quality.
        cases: what is searched for in this round.
        fruitful: the cases of the round in which something was found.
        nearest: where nothing is found, the layout that comes nearest to a valid one.
        done: whether it is over.
    """

    draft: Draft
    scene: Scene
    variants: list[Variant]
    least: int
    found: list[tuple[float, Scene]] = field(default_factory=list)
    cases: list[_Case] = field(default_factory=list)
    fruitful: list[_Case] = field(default_factory=list)
    nearest: Scene | None = None
    done: bool = False

    def prepare(self, round_: int) -> None:
        """Decide what to search for in a round."""
        if self.found:  # too few: once more where they were
            self.cases = [replace(case, seed=(case.seed + AGAIN) % 2**32) for case in self.fruitful]
            return
        scenes = [self.scene]
        if round_:
            scenes = [*self._elsewhere(round_)]
            if self._lighter():
                scenes = [self.scene, *scenes] if round_ == 1 else [*self._elsewhere(round_)]
            scenes = scenes or [self.scene]  # of some there is no other
        self.cases = [*self._cases(scenes, self.variants if len(scenes) == 1 else self.variants[:1], round_)]

    def _elsewhere(self, round_: int) -> Iterator[Scene]:
        """The scene in other rooms: somewhat larger ones, or of the same size where that was asked for."""
        proposal, room = self.draft.proposal, self.scene.room
        sizes = GROWN[min(round_, len(GROWN)) - 1]
        for other in [grown(room, size) for size in sizes] if proposal.larger else proposal.rooms[: len(sizes)]:
            yield self.scene.model_copy(update={"room": other})

    def _lighter(self) -> bool:
        """Leave out what is in the way of the nearest layout; whether there was anything that a room can do without."""
        if self.nearest is None:
            return False
        faults = [v for v in check(self.nearest, walkable=False).violations if v.hard]
        for priority in PRIORITIES[:2]:
            lighter = lightened(self.scene, faults, priority, LESS)
            if lighter is not None:
                self.scene, self.variants = lighter.scene, remaining(lighter.scene, self.variants)
                return True
        return False

    def _cases(self, scenes: Sequence[Scene], variants: Sequence[Variant], round_: int) -> Iterator[_Case]:
        share = -(-self.draft.executor.settings.layouts // SHARE)
        each = max(self.least, share // (len(scenes) * max(1, len(variants))))
        for scene in scenes:
            for variant in variants or ((),):
                plain = searched(with_relations(scene, variant))
                terms = choice_terms(plain, self.draft.context.room_type)
                yield _Case(scene, plain, terms, each, (self.draft.seed + round_) % 2**32)

    def take(self, solutions: Sequence[Solution]) -> None:
        """Keep the valid layouts of a round; where there are none, the nearest to one."""
        most, before = COMPARED * self.draft.request.layouts, len(self.found)
        for case, solution in zip(self.cases, solutions, strict=True):
            kept = solution.best_candidates(most)
            if kept and not before:
                self.fruitful.append(case)
            for candidate in kept:
                quality = float(solution.quality[candidate]) if solution.quality is not None else 0.0
                self.found.append((-round(quality, 4), with_riders(case.scene, solution.scene(candidate))))
        self.done = before > 0 or len(self.found) >= (ENOUGH if self.draft.request.layouts == 1 else most)
        if not self.found and self.cases:
            k = min(range(len(self.cases)), key=lambda k: float(solutions[k].energy.min()))
            self.nearest = with_riders(self.cases[k].scene, solutions[k].best)

    @property
    def layouts(self) -> list[Scene]:
        """What was found, the best first; several scenes of a request are of one room."""
        ranked = [scene for _, scene in sorted(self.found, key=lambda row: row[0])]
        if self.draft.request.layouts == 1 or not ranked:
            return ranked
        outlines = Counter(scene.room.outline for scene in ranked)
        return [scene for scene in ranked if scene.room.outline == outlines.most_common(1)[0][0]]


def grown(room: Room, size: float) -> Room:
    """A room with so many times the floor, of the same shape, doors and windows where they were in their walls."""
    scale = math.sqrt(size)
    outline = tuple((round(scale * x, 3), round(scale * y, 3)) for x, y in room.outline)

    def moved(openings: Sequence[Any]) -> tuple[Any, ...]:
        aside = (scale * (o.offset + o.width / 2) - o.width / 2 for o in openings)
        return tuple(
            o.model_copy(update={"offset": round(offset, 3)}) for o, offset in zip(openings, aside, strict=True)
        )

    update = {"outline": outline, "doors": moved(room.doors), "windows": moved(room.windows)}
    return Room.model_validate(room.model_copy(update=update).model_dump())


def laid_out(drafts: Sequence[Draft], device: str) -> list[list[Scene]]:
    """Valid layouts of each of some rooms, by the engine's word, the best by the terms of choice first.

    What a room gets does not depend on the others. Where the room that was drawn does not hold everything, others are
    tried that are as good or larger, and then it holds less of what was not asked for.
    """
    least, steps = (LEAST, STEPS) if pick_devices(device)[0] == "cpu" else (LEAST_GPU, STEPS_GPU)
    searches = [_Search(d, d.scene, [*d.proposal.variants[:VARIANTS]], least) for d in drafts]
    for round_ in range(ROUNDS):
        for search in searches:
            if not search.done:
                search.prepare(round_)
        busy = [search for search in searches if not search.done]
        cases = [case for search in busy for case in search.cases]
        solutions = refine_many(
            [case.plain for case in cases],
            candidates=[case.candidates for case in cases],
            seed=[case.seed for case in cases],
            device=device,
            steps=steps,
            snap=True,
            quality=[case.terms for case in cases],
        )
        for search in busy:
            search.take(solutions[: len(search.cases)])
            solutions = solutions[len(search.cases) :]
    return [search.layouts for search in searches]


def chosen(draft: Draft, layouts: Sequence[Scene], count: int) -> list[Outcome]:
    """The best valid ones of some layouts by the critic's word, no two of them near-duplicates.

    Args:
        draft: what they are layouts of.
        layouts: the layouts, the most promising first.
        count: how many are wanted; fewer come where there are no more.
    """
    judged = [
        draft.executor.judged(layout, report)
        for layout in layouts[: COMPARED * count]
        if (report := check(layout)).valid
    ]
    kept: list[Outcome] = []
    for outcome in sorted(judged, key=lambda o: o.key):
        if len(kept) < count and not any(alike(outcome.scene, other.scene) for other in kept):
            kept.append(outcome)
    return kept


def alike(first: Scene, second: Scene) -> bool:
    """Whether the large pieces of two layouts of a room stand in the same places, whichever of a kind is where."""
    from scipy.optimize import linear_sum_assignment

    kinds: dict[str, list[int]] = {}
    for k, obj in enumerate(first.objects):
        if obj.mount == "floor" and obj.size[0] * obj.size[1] >= LARGE and obj.size[2] > 0.05:
            kinds.setdefault(obj.category, []).append(k)
    for members in kinds.values():
        here, there = (
            np.array([(*scene.objects[k].pose.position[:2], scene.objects[k].pose.yaw) for k in members])
            for scene in (first, second)
        )
        step = here[:, None] - there[None]
        apart = (np.linalg.norm(step[..., :2], axis=-1) >= APART) | (np.abs(wrap_angle(step[..., 2])) >= TURNED)
        rows, columns = linear_sum_assignment(apart)
        if apart[rows, columns].any():
            return False
    return True
