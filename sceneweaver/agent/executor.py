"""Carry out a proposal: apply its edits, refine thousands of layouts, judge them, let the critic choose."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from sceneweaver.assets import Library
from sceneweaver.critic import Review, review_scene
from sceneweaver.generate.carry import carried, has_place
from sceneweaver.generate.ways import WAYS
from sceneweaver.knowledge import RoomType
from sceneweaver.language import SceneGraph
from sceneweaver.layout import QualityTerm, Solution, improve, joined, refine, refine_many
from sceneweaver.runtime.deadline import NEVER, Deadline
from sceneweaver.scene import Pose, Relation, Room, Scene
from sceneweaver.scene.edits import Remove, apply, apply_all
from sceneweaver.tools.base import Proposal
from sceneweaver.verify import Report, Violation, check

from .choice import choice_terms
from .coarse import coarse
from .learned_starts import Starts
from .relaxation import eased, left_out, lightened, pruned, relaxed
from .riders import at_rest, searched, with_riders
from .settings import ASKED, Settings

ENOUGH = 4
"""Valid layouts that are compared when a few things are added to a scene."""

ROUNDS = 8
"""Times that something gives way before a layout that cannot be valid is taken as it is."""

WRONG = 2
"""Parts of the key of an outcome that count what is wrong and what was given up."""

CLOSE = 4
"""Faults up to which a layout is so near to a valid one that it pays to begin more often anew."""

AGAIN = 0.5
"""Share of the time of the last search without which no other begins before the deadline."""

AT_FIRST, FEW = 32, 8
"""Layouts of a new room that are drawn at first; valid ones among them below which the others are drawn as well, if
there are any: where none is valid, as many again seldom bring one."""

MANY = 1024
"""Layouts from which on all rooms that a tool proposes are compared, even where the first has a valid layout."""

VARIED = 2
"""Variants that are tried in each larger room."""

IMPROVED = 2
"""Of several rooms or variants, how many are taken further: those with the best layouts."""

OPENED = 4
"""Layouts of a new room in which doors and drawers are opened, of those that the critic likes best."""

NARROW = 2.0
"""What a way that is too narrow weighs, in points of the mean of all grades."""

STEADY = 3
"""Layouts that are tried in physics, of those that the critic likes best."""


Variant = tuple[Relation, ...]
"""Relations that are added to those of a scene."""

Plain = Callable[[Scene], Scene]
"""What makes a scene plainer for a search: with what is carried as objects of its own, or as parts of its carrier."""


@dataclass(frozen=True)
class Outcome:
    """A scene with its judgement. ``unmet`` says what was asked for and given up, and why."""

    scene: Scene
    report: Report
    review: Review
    notes: tuple[str, ...] = ()
    unmet: tuple[str, ...] = ()

    @property
    def faults(self) -> tuple[Violation, ...]:
        """What is wrong with the layout; what could not be placed at all is not in it."""
        return tuple(v for v in self.report.violations if v.hard and v.kind != "dropped")

    @property
    def lacks_nothing(self) -> bool:
        """Whether it is valid and has all that was asked for."""
        return self.report.valid and not self.review.unmet

    @property
    def narrow(self) -> int:
        """How many of the ways are too narrow that a shell which is given keeps; a room that is drawn keeps none."""
        ways = (v for v in self.report.violations if v.kind == "narrow_path" and v.objects[0].startswith(WAYS))
        return sum(1 for _ in ways)

    @property
    def key(self) -> tuple[float, ...]:
        """Smaller is better: what is wrong, what was given up; then soft relations that fail, what is not as asked, and
        the critic's grades."""
        soft = self.report.relations.soft
        missing = (soft.total - soft.satisfied) / max(1, soft.total)
        worth = self.review.total - ASKED * self.review.unmet - NARROW * self.narrow
        return len(self.faults), len(self.scene.dropped), round(4.0 * missing - worth, 6)


@dataclass
class Executor:
    """Refines and judges proposals for one request.

    ``library`` is where the assets of the scenes come from. ``attempts`` counts the layouts begun anew, for all
    candidates. ``found`` is told of every layout of a new room that is better than those before it: it is what there is
    when time is up before `run` ends. ``starts`` draws the poses that the search of a new room begins with; None: the
    engine draws them by the relations.
    """

    room_type: RoomType
    brief: SceneGraph
    settings: Settings
    library: Library = field(default_factory=Library)
    deadline: Deadline = NEVER
    attempts: int = 0
    found: Callable[[Outcome], None] | None = None
    starts: Starts | None = None

    def run(self, scene: Scene, proposal: Proposal, seed: int, rival: Outcome | None = None) -> Outcome:
        """The best scene that follows from a proposal.

        ``rival`` is the best that there is without it. Where that lacks nothing, an edit that finds no valid layout is
        left at that, and for another draw of the room things give way once, in no other rooms: what more searches lead
        to is seldom better.

        Raises:
            InputError: when an edit cannot be applied.
        """
        draft, _ = apply_all(proposal.scene or scene, proposal.edits)
        notes, unmet, plain = list(proposal.notes), list(proposal.unmet), searched
        if not proposal.fresh:
            draft, report, said = pruned(scene, draft)
            notes += said
            if report.valid:
                return self._outcome(draft, notes, unmet, report)
            plain = searched if at_rest(draft, report) else coarse
        if not self.settings.physics:
            return self._outcome(self._unrefined(draft, proposal, seed), notes, unmet)
        fresh, variants, took = proposal.fresh, list(proposal.variants), 0.0
        if not fresh and (placed := self._in_place(scene, draft, seed, notes, plain)) is not None:
            return replace(placed, notes=tuple(notes), unmet=tuple(unmet))

        def refined(patience: int, best: Outcome | None = None) -> Outcome:
            """The best layout of the draft, or the one that there is where that is better."""
            nonlocal took
            began = time.monotonic()
            new = self._refined(draft, variants, fresh, seed, patience, plain)
            took = time.monotonic() - began
            if best is not None and best.key <= new.key:
                return best
            if fresh and self.found is not None:
                self.found(replace(new, notes=tuple(notes), unmet=tuple(unmet)))
            return new

        best, patient, larger, before = refined(0), False, False, draft
        another = proposal.scene is not None  # draw of the room
        spare = bool(best.faults) and rival is not None and rival.lacks_nothing
        rounds, rooms = (int(another), ()) if spare else (ROUNDS, proposal.rooms)
        many = self.settings.choice and self.settings.layouts >= MANY
        if rooms and best.faults and (lighter := lightened(draft, best.faults)) is not None:
            # What is optional goes before the room is changed: a larger one would stay half empty without it.
            notes += lighter.notes
            draft, variants = lighter.scene, remaining(lighter.scene, variants)
            best = self.judged(eased(best.scene, draft))
            if best.faults:
                best = refined(0, best)
        if rooms and (best.faults or many):
            draft, best = self._roomed(draft, rooms, best, seed)
        for round_ in range(rounds):
            if 0 < len(best.faults) <= CLOSE and not self.deadline.passed:
                best = self._mended(best, seed, plain)
            if not best.faults or self.deadline.left < AGAIN * took:
                break
            at_once = 1 + max(len(notes) // 2, round_ // 2)  # the longer it takes, the more
            lighter = relaxed(draft, best.faults, at_once, fixed=self.settings.begin.room is not None)
            if lighter is None:
                break
            if (lighter.unmet or lighter.late) and not patient:  # before anything that was asked for goes
                patient = True
                if proposal.larger:
                    draft, best = self._roomed(draft, proposal.larger, best, seed, variants[:VARIED], larger=True)
                if 0 < len(best.faults) <= CLOSE:
                    best = refined(1, best)
                if best.faults and variants:
                    rows, variants = variants, []  # they may be what stands in the way
                    best = refined(0, best)
                    variants = rows if best.faults else []
                continue
            if len(lighter.scene.dropped) > len(draft.dropped) and proposal.larger and not larger:
                larger = True
                draft, best = self._roomed(draft, proposal.larger, best, seed, variants[:VARIED], larger=True)
                continue
            if _worse(lighter.scene, rival):
                spare = True
                break
            notes, unmet = [*notes, *lighter.notes], [*unmet, *lighter.unmet]
            draft, variants = lighter.scene, remaining(lighter.scene, variants)
            best = refined(0, self.judged(eased(best.scene, draft)))
        if best.faults and not spare and self.deadline.left > AGAIN * took:
            variants = []  # without the rows: they may be what stands in the way
            best = refined(1, best)
        if draft.ids != before.ids and best.report.valid and not self.deadline.passed:
            # The layout may be one that was valid when something had gone: those were not made exact.
            best = self._mended(best, seed, plain)
        return replace(best, notes=tuple(notes), unmet=tuple(unmet))

    def _mended(self, best: Outcome, seed: int, plain: Plain) -> Outcome:
        """A valid layout where what is wrong has moved, and the rest as little as may be; the same where none is."""
        found = [o for o in self._ranked(self._free(best.scene, False, seed, 1, plain)) if not o.faults]
        return min([best, *found], key=lambda o: o.key)

    def _roomed(
        self,
        draft: Scene,
        rooms: Sequence[Room],
        best: Outcome,
        seed: int,
        variants: Sequence[Variant] = (),
        *,
        larger: bool = False,
    ) -> tuple[Scene, Outcome]:
        """A draft in that of some rooms where its layout is best, with that layout; unchanged where none is better.

        Of ``larger`` rooms, which are given from the smallest on, only one where less is wrong: better grades alone are
        no reason for floor that nobody asked for.
        """
        s, attempts = self.settings, self.settings.attempts[0]
        self.attempts += attempts
        cases = [(draft.model_copy(update={"room": room}), variant) for room in rooms for variant in variants or ((),)]
        drafts = [with_relations(moved, variant) for moved, variant in cases]
        solutions = self._solved(drafts, max(8, s.layouts // len(drafts)), seed, attempts)
        for (moved, _), varied, solution in zip(cases, drafts, solutions, strict=True):
            layouts = solution.distinct(2) or [solution.best]
            found = self._steadiest(self._ranked([_posed(varied, layout) for layout in layouts]))
            if found.key[:WRONG] < best.key[:WRONG] if larger else found.key < best.key:
                draft, best = moved, found
            if self.deadline.passed:
                break
        return draft, best

    def _solved(self, drafts: Sequence[Scene], candidates: int, seed: int, attempts: int) -> list[Solution]:
        """So many layouts of each of some drafts, in one launch, and the best of all taken further."""
        plain = [searched(d) for d in drafts]
        terms = [self._terms(d) for d in plain]
        solutions = refine_many(
            plain,
            candidates=candidates,
            seed=seed,
            device=self.settings.device,
            steps=attempts,
            time_limit=self.deadline.time_limit,
            snap=True,
            quality=terms,
        )
        return self._improved(solutions, terms)

    def _terms(self, scene: Scene) -> list[QualityTerm]:
        """What the layouts of a scene are chosen by before the critic sees any."""
        s = self.settings
        return choice_terms(scene, self.room_type) if s.choice and s.rules else []

    def _improved(self, solutions: Sequence[Solution], terms: Sequence[Sequence[QualityTerm]]) -> list[Solution]:
        """The solutions; those with the best layouts of all are taken further."""
        s, found = self.settings, list(solutions)
        worth = {
            k: float(solution.quality[solution.ranked[0]])
            for k, solution in enumerate(found)
            if solution.quality is not None and len(solution.ranked)
        }
        best = sorted(worth, key=lambda k: -round(worth[k], 4))[:IMPROVED]
        for k in best if s.generations else ():
            if self.deadline.passed:
                break
            found[k] = improve(
                found[k],
                terms[k],
                candidates=max(1, s.children // len(best)),
                generations=s.generations,
                steps=s.attempts[0],
                time_limit=self.deadline.time_limit,
                snap=True,
            )
        return found

    def judged(self, scene: Scene, report: Report | None = None) -> Outcome:
        """A scene as it is."""
        return self._outcome(scene, (), (), report)

    def _outcome(
        self, scene: Scene, notes: Sequence[str], unmet: Sequence[str], report: Report | None = None
    ) -> Outcome:
        report = report or check(scene)
        review = review_scene(scene, report, self.room_type, self.brief, rules=self.settings.rules)
        return Outcome(scene, report, review, tuple(notes), tuple(unmet))

    def _refined(
        self, draft: Scene, variants: Sequence[Variant], fresh: bool, seed: int, patience: int, plain: Plain
    ) -> Outcome:
        """The best of the layouts of a scene, or of those of its variants."""
        attempts = self.settings.attempts[patience]
        self.attempts += attempts
        layouts = (
            self._of_variants(draft, variants, seed, attempts)
            if variants
            else self._free(draft, fresh, seed, attempts, plain)
        )
        ranked = self._ranked(layouts)
        return self._steadiest(self._opening(ranked) if fresh else ranked)

    def _opening(self, ranked: list[Outcome]) -> list[Outcome]:
        """Some outcomes, best first; of the leading valid ones the first in which all opens that has to is in front."""
        from sceneweaver.verify import openable

        for k, one in enumerate(ranked[:OPENED]):
            if one.faults or self.deadline.passed:
                break
            if not openable.violations(one.scene, openable.measure(one.scene, self.library.load)):
                return [one, *ranked[:k], *ranked[k + 1 :]]
        return ranked

    def _ranked(self, layouts: Sequence[Scene]) -> list[Outcome]:
        """Some layouts with their judgement, best first; past the deadline the first of them alone."""
        judged: list[Outcome] = []
        for layout in layouts:
            if judged and self.deadline.passed:
                break
            judged.append(self._outcome(layout, (), ()))
        return sorted(judged, key=lambda o: o.key)

    def _steadiest(self, ranked: list[Outcome]) -> Outcome:
        """The first of some outcomes, best first; to settle, the steadiest of the leading valid ones."""
        leading = [o for o in ranked[:STEADY] if o.report.valid] if self.settings.settle else []
        if len(leading) < 2 or self.deadline.passed:
            return ranked[0]
        from sceneweaver.physics import stability

        moved = [sum(far > 0.01 for far in stability(o.scene, self.library.load)["moved"].values()) for o in leading]
        return leading[moved.index(min(moved))]

    def _in_place(self, scene: Scene, draft: Scene, seed: int, notes: list[str], plain: Plain) -> Outcome | None:
        """The best valid layout in which only what an edit added or changed moves.

        New things that nobody asked for and that find no place are given up, one after the other. None when what was
        changed or asked for finds none.
        """
        s, old = self.settings, set(scene.ids)
        while True:
            loose = _changed(scene, draft)
            if len(loose) == len(draft.objects):
                return None
            if not loose:
                draft, report, said = pruned(scene, draft)
                notes += said
                return self._outcome(draft, (), (), report) if report.valid else None
            known = {o.id: o for o in draft.objects}
            moving = loose | {rider for id in loose for rider in carried(known, id)}
            pinned = _pinned(plain(draft), {o.id: o.pose for o in draft.objects if o.id not in moving})
            self.attempts += s.attempts[0]
            drawn = any(not has_place(draft.object(id)) for id in loose)
            terms = self._terms(pinned) if drawn else ()
            how = "sample" if drawn else "current"
            solution = self._searched(pinned, terms, max(16, s.layouts // 2), seed, s.attempts[0], how)
            layouts = [_posed(draft, layout) for layout in solution.distinct(ENOUGH)]
            valid = [o for o in self._ranked(layouts) if o.report.valid]
            if valid:
                return self._steadiest(valid)
            report = check(_posed(draft, solution.best), walkable=False)
            trouble = Counter(name for v in report.violations if v.hard for name in v.objects)
            extra = [o.id for o in draft.objects if o.id in loose - old and o.intent.priority != "asked"]
            if not extra or self.deadline.passed:
                return None
            gone = max(extra, key=lambda name: (trouble[name], draft.index(name)))
            notes.append(left_out(gone))
            draft = apply(draft, Remove(id=gone, cascade=True))

    def _free(self, draft: Scene, fresh: bool, seed: int, attempts: int, plain: Plain) -> list[Scene]:
        """Layouts of a whole scene, valid ones if there are any."""
        s, simple = self.settings, plain(draft)
        if fresh:
            terms = self._terms(simple)
            solution = self._improved([self._drawn(simple, terms, seed, attempts)], [terms])[0]
        else:
            solution = self._searched(simple, (), max(16, s.layouts // 4), seed, attempts, "current")
        layouts = solution.distinct(s.finalists if fresh else 2) or [solution.best]
        return [_posed(draft, layout) for layout in layouts]

    def _drawn(self, scene: Scene, terms: Sequence[QualityTerm], seed: int, attempts: int) -> Solution:
        """Layouts of a whole scene drawn anew."""
        count = self.settings.layouts
        first = count if count >= MANY else min(count, AT_FIRST)
        drawn = self.starts(scene, first, seed) if self.starts is not None else None
        solution = self._searched(scene, terms, first, seed, attempts, "sample" if drawn is None else drawn)
        if first < count and 0 < len(solution.ranked) < FEW and not self.deadline.passed:
            solution = joined(solution, self._searched(scene, terms, count - first, (seed + 1) % 2**32, attempts))
        return solution

    def _searched(
        self,
        scene: Scene,
        terms: Sequence[QualityTerm],
        candidates: int,
        seed: int,
        attempts: int,
        init: Literal["sample", "current"] | np.ndarray = "sample",
    ) -> Solution:
        """So many layouts of a scene."""
        return refine(
            scene,
            candidates=candidates,
            seed=seed,
            init=init,
            device=self.settings.device,
            steps=attempts,
            time_limit=self.deadline.time_limit,
            snap=True,
            quality=terms,
        )

    def _of_variants(self, draft: Scene, variants: Sequence[Variant], seed: int, attempts: int) -> list[Scene]:
        """Layouts of a scene with the relations of each variant; if none is valid, the one that comes nearest."""
        s = self.settings
        drafts = [with_relations(draft, variant) for variant in variants]
        solutions = self._solved(drafts, max(6, s.layouts // (2 * len(drafts))), seed, attempts)
        found = [
            _posed(draft, layout)
            for draft, solution in zip(drafts, solutions, strict=True)
            for layout in solution.distinct(max(2, s.finalists // len(drafts)))
        ]
        nearest = min(range(len(drafts)), key=lambda k: float(solutions[k].energy.min()))
        return found or [_posed(drafts[nearest], solutions[nearest].best)]

    def _unrefined(self, draft: Scene, proposal: Proposal, seed: int) -> Scene:
        """A layout as the relations draw it, without search: what a tool alone would give."""
        if not proposal.fresh:
            return draft
        scene = with_relations(draft, proposal.variants[0]) if proposal.variants else draft
        solution = refine(scene, candidates=1, seed=seed, optimizer="adam", steps=1, device=self.settings.device)
        return _posed(scene, solution.best)


def _worse(scene: Scene, rival: Outcome | None) -> bool:
    """Whether no layout of a scene can beat what there is without it, as more that was asked for has gone from it."""
    return rival is not None and not rival.faults and len(scene.dropped) > len(rival.scene.dropped)


def _changed(scene: Scene, draft: Scene) -> set[str]:
    """Ids of what stands on floor, walls or ceiling and is new, or is not as it was."""
    before = {o.id: o for o in scene.objects}
    return {
        o.id
        for o in draft.objects
        if o.mount != "surface"
        and (
            o.id not in before
            or o.pose != before[o.id].pose
            or o.size != before[o.id].size
            or o.asset != before[o.id].asset
        )
    }


def with_relations(scene: Scene, variant: Variant) -> Scene:
    """The scene with the relations of a variant."""
    return scene.model_copy(update={"relations": (*scene.relations, *variant)})


def remaining(scene: Scene, variants: Sequence[Variant]) -> list[Variant]:
    """The variants without the relations of what is not in a scene any more."""
    known = {*scene.ids, *(f"wall:{wall.index}" for wall in scene.room.walls)}
    return [tuple(r for r in variant if {r.subject, *r.targets} <= known) for variant in variants]


def _pinned(scene: Scene, poses: Mapping[str, Pose]) -> Scene:
    objects = [o.model_copy(update={"pose": poses[o.id], "fixed": True}) if o.id in poses else o for o in scene.objects]
    return scene.model_copy(update={"objects": tuple(objects)})


def _posed(draft: Scene, layout: Scene) -> Scene:
    """The draft with the poses of a layout of it."""
    return with_riders(draft, layout)
