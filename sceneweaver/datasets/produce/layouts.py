"""Layouts of many rooms, searched for in shared launches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.agent.choice import choice_terms
from sceneweaver.agent.executor import Outcome, Variant, remaining, with_relations
from sceneweaver.agent.relaxation import relaxed
from sceneweaver.agent.riders import searched, with_riders
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.layout import QualityTerm, Solution, refine_many
from sceneweaver.scene import Room, Scene
from sceneweaver.verify import check

from .drafts import Draft

VARIANTS = 3
"""Ways to line up furniture that are tried in a room, the first that the tool proposes."""

LEAST = 4
"""Layouts of each case that are searched for at least."""

STEPS = 1
"""Times that a layout is begun: of a room that holds it, one of a few will do."""

ROUNDS = 4
"""Searches: in the room that was drawn, in other rooms, and then with less in it."""

ROOMS = 3
"""Other rooms that are tried."""

LESS = 3
"""Things that go at once where no room holds everything."""

COMPARED = 4
"""Layouts that the critic compares for each that is kept."""

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
        scene: what is left of it; its room may be another than was drawn.
        variants: relations that line things up, of which the layouts of one are enough.
        found: layouts with their quality.
    """

    draft: Draft
    scene: Scene
    variants: list[Variant]
    found: list[tuple[float, Scene]]
    cases: list[_Case]
    nearest: Scene | None = None
    done: bool = False

    @property
    def wanted(self) -> int:
        return self.draft.request.layouts

    def prepare(self, round_: int) -> None:
        """Decide what to search for in a round."""
        proposal, half = self.draft.proposal, -(-self.draft.executor.settings.layouts // 2)
        if round_ > 1:
            self.done = bool(self.found) or not self._lighter()
        rooms, variants = [self.scene.room], self.variants or [()]
        if round_ and not self.found:
            others = proposal.larger or proposal.rooms
            rooms, variants = [*rooms, *others][round_ == 1 :][:ROOMS], variants[:1]
        self.cases = [] if self.done else [*self._cases(rooms, variants, half, round_)]

    def _lighter(self) -> bool:
        """Leave out what is in the way of the nearest layout; whether there was anything that nobody asked for."""
        if self.nearest is None:
            return False
        faults = [v for v in check(self.nearest, walkable=False).violations if v.hard]
        lighter = relaxed(self.scene, faults, LESS)
        if lighter is None or lighter.unmet:
            return False
        self.scene, self.variants = lighter.scene, remaining(lighter.scene, self.variants)
        return True

    def _cases(self, rooms: Sequence[Room], variants: Sequence[Variant], count: int, round_: int) -> Iterator[_Case]:
        each = max(LEAST, count // (len(rooms) * len(variants)))
        for room in rooms:
            scene = self.scene.model_copy(update={"room": room})
            for variant in variants:
                plain = searched(with_relations(scene, variant))
                terms = choice_terms(plain, self.draft.context.room_type)
                yield _Case(scene, plain, terms, each, (self.draft.seed + round_) % 2**32)

    def take(self, solutions: Sequence[Solution]) -> None:
        """Keep the valid layouts of a round; where there are none, the nearest to one."""
        for case, solution in zip(self.cases, solutions, strict=True):
            for candidate in solution.best_candidates(COMPARED * self.wanted):
                quality = float(solution.quality[candidate]) if solution.quality is not None else 0.0
                self.found.append((-round(quality, 4), with_riders(case.scene, solution.scene(candidate))))
        self.done = len(self.found) >= (1 if self.wanted == 1 else COMPARED * self.wanted)
        if not self.found and self.cases:
            k = min(range(len(self.cases)), key=lambda k: float(solutions[k].energy.min()))
            self.nearest = with_riders(self.cases[k].scene, solutions[k].best)
            self.scene = self.scene.model_copy(update={"room": self.nearest.room})


def laid_out(drafts: Sequence[Draft], device: str) -> list[list[Scene]]:
    """Valid layouts of each of some rooms, by the engine's word, the best by the terms of choice first.

    What a room gets does not depend on the others. Where the room that was drawn does not hold everything, others are
    tried that are as good or larger, and then it holds less of what nobody asked for.
    """
    searches = [_Search(d, d.scene, list(d.proposal.variants[:VARIANTS]), [], []) for d in drafts]
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
            steps=STEPS,
            snap=True,
            quality=[case.terms for case in cases],
        )
        for search in busy:
            search.take(solutions[: len(search.cases)])
            solutions = solutions[len(search.cases) :]
    return [[scene for _, scene in sorted(search.found, key=lambda row: row[0])] for search in searches]


def chosen(draft: Draft, layouts: Sequence[Scene], count: int) -> list[Outcome]:
    """The best valid ones of some layouts by the critic's word, no two of them near-duplicates.

    Args:
        draft: what they are layouts of.
        layouts: the layouts, the most promising first.
        count: how many are wanted; fewer come where there are no more.
    """
    judged = [draft.executor.judged(layout) for layout in layouts[: COMPARED * count]]
    kept: list[Outcome] = []
    for outcome in sorted((o for o in judged if o.report.valid), key=lambda o: o.key):
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
