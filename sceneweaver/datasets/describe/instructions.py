"""Instructions for rearranging a scene: goals as words and relations, and poses that reach them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.scene import Pose, Relation, Scene, Support
from sceneweaver.scene.edits import carried
from sceneweaver.verify.solids import Body

from .asker import Asker
from .facts import Facts, group_of, has_front, is_seat, is_watcher, viewer_of
from .moves import Space, is_movable, judged_locally
from .naming import sentence

_NO_TABLES = frozenset(("seating", "chair_group", "bed_group", "sanitary", "sport", "electronics", "plant_group"))
"""Groups of the taxonomy that small things are not put on."""


@dataclass(frozen=True, eq=False)
class Goal:
    """What to do with a thing.

    Attributes:
        words: what is asked, after the name of the thing: "against the wall with the door".
        verb: "Move", "Turn", "Put" or "Push".
        relations: what has to hold afterwards; `sceneweaver.check` judges it.
        poses: candidates [n, 3] (x, y, yaw) of the bottom centre [m, rad].
        height: of the bottom [m].
        support: carrier and surface that it is put on; None: the floor.
        objects: ids that the words speak of.
    """

    verb: str
    words: str
    relations: tuple[Relation, ...]
    poses: np.ndarray
    height: float = 0.0
    support: tuple[str, str] | None = None
    objects: tuple[str, ...] = ()

    def words_of(self, thing: str) -> str:
        """The whole of it for a thing by name, without a full stop."""
        if self.verb == "Put":
            return (
                f"Take {thing} and put it {self.words}"
                if " on " in thing or " in " in thing
                else f"Put {thing} {self.words}"
            )
        return f"{self.verb} {thing} {self.words}"


def _relation(kind: str, body: Body, target: str | None, **params: object) -> Relation:
    return Relation(type=kind, subject=body.id, target=target, params=params)


def _move(asker: Asker, words: str, poses: np.ndarray, relation: Relation, facing: Body | None = None) -> Goal:
    """A move of a thing that a relation puts somewhere, perhaps facing another one."""
    relations = [relation]
    objects = asker.names[relation.target].ids if relation.target in asker.facts.by_id else ()
    if facing is not None:
        away = np.array(facing.centre) - poses[:, :2]
        poses[:, 2] = np.arctan2(away[:, 1], away[:, 0])
        relations.append(Relation(type="facing", subject=relation.subject, target=facing.id))
        objects = asker.names[facing.id].ids
    return Goal("Move", words, tuple(relations), poses, objects=objects)


def against_wall(asker: Asker, body: Body) -> Iterator[Goal]:
    """With its back to a wall."""
    facts = asker.facts
    for k, name in asker.shuffled(facts.wall_names.items()) if has_front(body) else ():
        wall = facts.placed.walls[k]
        free = wall.length - body.size[1]
        if free < 0.1 or facts.wall_at(body, 0.9) == k:
            continue
        offsets = body.size[1] / 2 + free * asker.rng.random(24)
        x, y = wall.point(offsets, body.size[0] / 2 + 0.01)
        yaw = np.full(24, math.atan2(wall.inward[1], wall.inward[0]))
        words = asker.say("goal_wall", wall=name)
        yield _move(asker, words, np.stack([x, y, yaw], axis=1), _relation("against_wall", body, f"wall:{k}"))


def turned_to(asker: Asker, body: Body) -> Iterator[Goal]:
    """Where it is, facing another thing."""
    if not is_watcher(body):
        return
    for other in _targets(asker, body):
        away = (other.centre[0] - body.centre[0], other.centre[1] - body.centre[1])
        yaw = math.atan2(away[1], away[0])
        if math.hypot(*away) < 0.5 or abs(wrap_angle(yaw - body.yaw)) < 0.6:
            continue
        words = asker.say("goal_facing", other=asker.name(other))
        pose = np.array([[*body.centre, yaw]])
        yield Goal("Turn", words, (_relation("facing", body, other.id),), pose, objects=asker.names[other.id].ids)


def next_to(asker: Asker, body: Body) -> Iterator[Goal]:
    """Beside another thing, looking the same way."""
    for other in _targets(asker, body):
        if asker.facts.distance(body, other) < 0.6:
            continue
        words = asker.say("goal_near", other=asker.name(other))
        poses = np.concatenate([_beyond(asker, body, other, side) for side in ("left", "right", "front")])
        yield _move(asker, words, poses, _relation("near", body, other.id, max=0.3))


def on_side(asker: Asker, body: Body) -> Iterator[Goal]:
    """To the left or right of a thing, for who sits on it or looks at it."""
    for other in _targets(asker, body):
        if not has_front(other):
            continue
        left = asker.coin()
        side, opposite = ("left", "right") if left else ("right", "left")
        seen = side if is_seat(other) else opposite
        words = asker.say(f"goal_side_{viewer_of(other)}", side=seen, other=asker.name(other))
        if asker.facts.holds(f"{side}_of", body, other.id):
            continue
        yield _move(asker, words, _beyond(asker, body, other, side), _relation(f"{side}_of", body, other.id))


def before(asker: Asker, body: Body) -> Iterator[Goal]:
    """In front of a thing, facing it where it can."""
    for other in _targets(asker, body):
        if not has_front(other) or asker.facts.holds("in_front_of", body, other.id):
            continue
        watches = is_watcher(body)
        words = f"just in front of {asker.name(other)}" + (", facing it" if watches else "")
        poses = _beyond(asker, body, other, "front", (0.3, 0.9))
        yield _move(asker, words, poses, _relation("in_front_of", body, other.id), other if watches else None)


def into_corner(asker: Asker, body: Body) -> Iterator[Goal]:
    """Into some corner of the room."""
    facts = asker.facts
    if facts.holds("in_corner", body, None) or max(body.size[:2]) > 1.2:
        return
    walls, poses = facts.placed.walls, []
    d, w, _ = body.size
    for wall in walls:
        previous = walls[wall.index - 1]
        if abs(np.dot(previous.along, wall.along)) > 0.05 or np.dot(previous.along, wall.inward) > 0:
            continue
        yaw = math.atan2(wall.inward[1], wall.inward[0])
        poses.append((*wall.point(w / 2 + 0.02, d / 2 + 0.02), yaw))
        poses.append((*wall.point(d / 2 + 0.02, w / 2 + 0.02), yaw - math.pi / 2))
    if poses:
        words = asker.say("goal_corner")
        yield _move(asker, words, np.array(asker.shuffled(poses)), _relation("in_corner", body, None))


def to_window(asker: Asker, body: Body) -> Iterator[Goal]:
    """Close to the only window, perhaps facing something."""
    facts = asker.facts
    if len(facts.placed.windows) != 1 or facts.holds("near_window", body, facts.placed.windows[0].item.id):
        return
    window = facts.placed.windows[0]
    u = window.item.offset + window.item.width * (asker.rng.random(24) * 1.4 - 0.2)
    x, y = window.wall.point(u, max(body.size[:2]) / 2 + 0.1 + 0.5 * asker.rng.random(24))
    yaw = math.atan2(window.wall.inward[1], window.wall.inward[0])
    poses = np.stack([x, y, np.full(24, yaw)], axis=1)
    other = _targets(asker, body)[:1] if is_watcher(body) else []
    words = "close to the window" + "".join(f" so that it faces {asker.name(o)}" for o in other)
    yield _move(asker, words, poses, _relation("near_window", body, window.item.id), other[0] if other else None)


def onto(asker: Asker, body: Body) -> Iterator[Goal]:
    """On top of another carrier."""
    for other in asker.shuffled(asker.standing):
        tops = [s for s in other.item.surfaces if s.headroom is None]
        support = body.item.support
        if not tops or other.tilted or (support is not None and support.object == other.id):
            continue
        top = max(tops, key=lambda s: s.z)
        if group_of(other.item.category) in _NO_TABLES or not 0.3 < other.position[2] + top.z < 1.5:
            continue
        corners = np.array(top.polygon)
        spread = corners.min(axis=0) + np.ptp(corners, axis=0) * asker.rng.random((24, 2))
        turns = np.array(asker.shuffled([0.0, math.pi / 2, math.pi, -math.pi / 2] * 6))
        poses = np.column_stack([other.frame.to_world(spread), other.yaw + turns])
        yield Goal(
            "Put",
            f"on {asker.name(other)}",
            (_relation("on_top", body, other.id),),
            poses,
            height=other.position[2] + top.z,
            support=(other.id, top.name),
            objects=asker.names[other.id].ids,
        )


def _targets(asker: Asker, body: Body) -> list[Body]:
    """Named furniture in a drawn order, the thing itself and what its name speaks of left out."""
    mine = asker.names[body.id].ids
    return [b for b in asker.shuffled(asker.standing) if b.id not in mine and body.id not in asker.names[b.id].ids][:4]


def _beyond(
    asker: Asker, body: Body, other: Body, side: str, gaps: tuple[float, float] = (0.03, 0.25), count: int = 10
) -> np.ndarray:
    """Poses [n, 3] beyond a side of another thing, turned as it is or a quarter further."""
    face, poses = other.face(side), []
    for _ in range(count):
        yaw = other.yaw + (0.0, math.pi / 2, -math.pi / 2, math.pi)[int(asker.rng.integers(4))]
        along_front = abs(math.cos(yaw) * face.normal[0] + math.sin(yaw) * face.normal[1]) > 0.7
        depth, width = body.size[:2] if along_front else body.size[1::-1]
        gap = gaps[0] + (gaps[1] - gaps[0]) * asker.rng.random()
        aside = (asker.rng.random() - 0.5) * max(0.0, 2 * face.half - 0.3 * width)
        x = face.centre[0] + face.normal[0] * (gap + depth / 2) - face.normal[1] * aside
        y = face.centre[1] + face.normal[1] * (gap + depth / 2) + face.normal[0] * aside
        poses.append((x, y, yaw))
    return np.array(poses)


FLOOR_GOALS: tuple[Callable[[Asker, Body], Iterator[Goal]], ...] = (
    against_wall,
    turned_to,
    next_to,
    on_side,
    before,
    into_corner,
    to_window,
)
"""What furniture can be asked to be."""


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
