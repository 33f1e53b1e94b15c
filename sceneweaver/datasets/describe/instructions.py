"""Instructions for rearranging a scene, each with its goal as relations and poses that reach it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from sceneweaver.scene import Pose, Relation, Scene, Support
from sceneweaver.scene.edits import carried
from sceneweaver.verify.solids import Body

from .facts import Facts
from .goals import FLOOR_GOALS, Goal, onto
from .moves import Space, is_movable, judged_locally
from .nouns import sentence
from .questions.question import Asker

SINGLE, MOST_MOVES = 2, 3
"""Instructions of one move in a scene, and the most moves of the one after them, which has at least two."""

TRIED_GOALS, TRIED_POSES = 12, 1
"""Goals of a step and poses of a goal that are looked at closely."""


@dataclass(frozen=True)
class Step:
    """One move: its words, its goal, the scene after it, and the relations that it gives up, by place in the scene."""

    words: str
    goal: Goal
    body: Body
    after: Scene
    given_up: tuple[int, ...]


class Instructor:
    """The instructions of one scene."""

    def __init__(self, facts: Facts, rng: np.random.Generator):
        self.facts = facts
        self.asker = Asker(facts, rng)
        self.space = Space(facts.scene, facts.placed)
        scene = facts.scene
        self.large = [b for b in self.asker.standing if is_movable(scene, b)]
        holders = {c for c, _ in facts.carried}
        self.small = [
            b
            for b in self.asker.named
            if b.item.support is not None and b.id not in holders and max(b.size[:2]) < 0.5 and not b.item.fixed
        ]

    def instruction(self, moves: int) -> list[Step] | None:
        """Some moves of different things, one after the other; None where none was found."""
        steps: list[Step] = []
        space, used, promised = self.space, set(), []
        for _ in range(moves):
            step = self._step(space, used, promised)
            if step is None:
                return None
            steps.append(step)
            used |= {step.body.id, *carried(step.after, step.body.id), *step.goal.objects}
            promised += step.goal.relations
            if len(steps) < moves:
                space = space.after(step.after, step.body.id)
        return steps

    def _step(self, space: Space, used: set[str], promised: list[Relation]) -> Step | None:
        """One move of a thing that no earlier step spoke of, which keeps what those promised."""
        bodies = [*self.asker.shuffled(self.large)[:4], *self.asker.shuffled(self.small)[:4]]
        goals = (
            (body, goal)
            for body in self.asker.shuffled(bodies)
            if body.id not in used and not used & set(carried(space.scene, body.id))
            for make in ((onto,) if body.item.support else self.asker.shuffled(FLOOR_GOALS)[:3])
            for goal in islice(make(self.asker, body), 1)
            if not used & set(goal.objects)
        )
        for body, goal in islice(goals, TRIED_GOALS):
            step = self._reached(space, body, goal, promised)
            if step is not None:
                return step
        return None

    def _reached(self, space: Space, body: Body, goal: Goal, promised: list[Relation]) -> Step | None:
        """The step, at the first pose that is valid."""
        scene = space.scene
        poses = goal.poses[space.free(body.id, goal.poses, goal.height, goal.support)]
        mine = [k for k, r in enumerate(scene.relations) if r.subject == body.id]
        others = [r for r in scene.relations if r.subject != body.id]
        for x, y, yaw in poses[:TRIED_POSES].tolist():
            after = scene.move(body.id, to=Pose.from_yaw(x, y, goal.height, yaw))
            if goal.support is not None:
                after = _resting(after, body.id, *goal.support)
            wanted = [*goal.relations, *others, *promised]
            judged = judged_locally(after, body.id, wanted, [scene.relations[k] for k in mine], space.reaches)
            if judged.hard:
                continue
            given_up = [mine[k] for k in judged.lost]
            kept = tuple(r for k, r in enumerate(after.relations) if k not in given_up)
            after = after.model_copy(update={"relations": kept})
            first = {id(r): k for k, r in enumerate(self.facts.scene.relations)}
            words = goal.words_of(self.asker.name(body))
            return Step(words, goal, body, after, tuple(first[id(scene.relations[k])] for k in given_up))
        return None

    def written(self, number: int, steps: list[Step]) -> dict[str, Any]:
        """An instruction as JSON data."""
        first = steps[0].words
        links = ("Then", "After that,", "Finally,")
        texts = [sentence(first)]
        for k, step in enumerate(steps[1:]):
            link = links[2] if k == len(steps) - 2 and len(steps) > 2 else links[k]
            texts.append(sentence(f"{link} {step.words[0].lower()}{step.words[1:]}"))
        return {
            "id": f"i{number}",
            "instruction": " ".join(texts),
            "steps": [_step_data(self.facts.scene, step) for step in steps],
        }


def _step_data(scene: Scene, step: Step) -> dict[str, Any]:
    group = carried(step.after, step.body.id)
    relations = [
        r.model_dump(mode="json", include={"type", "subject", "target", "params"}) for r in step.goal.relations
    ]
    after = step.after.object(step.body.id)
    return {
        "text": sentence(step.words),
        "object": step.body.id,
        "mentions": list(step.goal.objects),
        "goal": relations,
        "witness": {
            "poses": {i: step.after.object(i).pose.model_dump(mode="json") for i in group},
            "support": after.support.model_dump(mode="json") if after.support is not None else None,
        },
        "given_up": [scene.relations[k].model_dump(mode="json") | {"index": k} for k in step.given_up],
    }


def _resting(scene: Scene, object_id: str, carrier: str, surface: str) -> Scene:
    """The scene with an object on another surface."""
    support = Support(object=carrier, surface=surface)
    objects = (o.model_copy(update={"support": support}) if o.id == object_id else o for o in scene.objects)
    return scene.model_copy(update={"objects": tuple(objects)})


def instructions(facts: Facts, seed: int) -> list[dict[str, Any]]:
    """Instructions for rearranging a scene, of one to three moves, as JSON data.

    Each step names its object, its goal (relations that hold afterwards and do not before), a witness: poses at which
    the scene is valid, and the relations of the moved object that no longer hold there and are given up.

    Args:
        facts: a valid scene.
        seed: what is drawn: things, goals, wording.
    """
    instructor = Instructor(facts, np.random.default_rng(seed))
    found: dict[str, dict[str, Any]] = {}
    for moves in (*(1,) * SINGLE, 2 + int(instructor.asker.rng.integers(MOST_MOVES - 1))):
        steps = instructor.instruction(moves)
        if steps is not None:
            row = instructor.written(len(found), steps)
            found.setdefault(row["instruction"], row)
    return list(found.values())
