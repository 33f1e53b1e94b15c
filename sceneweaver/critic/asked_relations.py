"""Whether the relations that a request names hold."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

from sceneweaver.brief import Meaning, StatedRelation, meanings
from sceneweaver.brief.wall_names import direction_of
from sceneweaver.geometry.angles import dot
from sceneweaver.scene import CATALOGUE, InputError, Relation, Room
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Body

from .grade import Finding, finding
from .survey import Survey

MIDDLE = 0.2
"""How far from the middle of the room, as a share of the side of a square of its floor, "in the middle" reaches."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Asked relations that do not hold; what is missing is said elsewhere."""
    for said, meant in meanings(survey.brief):
        subjects = _named(survey, said.subject)
        if not subjects:
            continue
        wrong, why = _wrong(survey, said, meant, subjects)
        if len(subjects) - len(wrong) >= _least(survey, said.subject):  # what came along may stand elsewhere
            wrong = [b for b in wrong if b.item.intent.request == said.subject]
        if wrong:
            words = said.words or f"{said.subject} {said.type} {' and '.join(said.targets)}".strip()
            ids = [b.id for b in wrong]
            rows = _rows(survey, said, meant, wrong)
            yield finding(
                "alignment",
                "asked_relation",
                ids,
                f"'{words}' does not hold for {', '.join(ids[:4])}: {why}",
                f"put {', '.join(ids[:4])} as asked",
                points=0.6 + 1.4 * len(wrong) / len(subjects),
                tool="add_relation" if rows else "update_layout",
                inputs={"relations": rows} if rows else {"ids": ids},
            )


def _least(survey: Survey, asked: str) -> int:
    """How many of something were asked for."""
    return next((a.count[0] if a.count else 1 for a in survey.brief.entities if a.id == asked), 1)


def _named(survey: Survey, asked: str) -> list[Body]:
    return [b for b in survey.bodies if survey.program.asked_of.get(b.id) == asked]


def _wrong(survey: Survey, said: StatedRelation, meant: Meaning, subjects: Sequence[Body]) -> tuple[list[Body], str]:
    """The subjects for which it does not hold, and why for the first."""
    if meant.target == "middle":
        return _middle(survey, subjects)
    wrong, why = [], ""
    for body in subjects:
        options = list(_options(survey, said, meant, body, len(subjects)))
        judgements = []
        for relation in options:
            try:
                judgements.append(judge_relation(_around(survey, said, meant, relation), relation))
            except InputError as error:
                why = why or str(error)
        if any(j.holds for j in judgements):
            continue
        if not judgements and not options and meant.target is not None and not _there(survey, said):
            continue  # the target is missing, which is a fault of its own
        wrong.append(body)
        why = why or next((j.text for j in judgements), "there is nothing to relate it to")
    return wrong, why


def _around(survey: Survey, said: StatedRelation, meant: Meaning, relation: Relation):
    """The placed scene, in which the members of an asked group know of each other."""
    if meant.type != "around":
        return survey.placed
    kept = survey.__dict__.setdefault("_around", {})
    key = (said.subject, relation.target)
    if key not in kept:
        from sceneweaver.verify.solids import Placed

        group = [
            Relation(type="around", subject=b.id, target=relation.target, params=relation.params)
            for b in _named(survey, said.subject)
        ]
        others = tuple(r for r in survey.scene.relations if r.type != "around")
        kept[key] = Placed.of(survey.scene.model_copy(update={"relations": (*others, *group)}))
    return kept[key]


def _there(survey: Survey, said: StatedRelation) -> bool:
    asked = {a.id for a in survey.brief.entities}
    return all(n not in asked or _named(survey, n) for n in said.targets)


def _options(survey: Survey, said: StatedRelation, meant: Meaning, body: Body, count: int) -> Iterator[Relation]:
    """The relations of which one should hold for a subject."""
    spec = CATALOGUE.get(meant.type)
    if spec is None:
        return
    params = dict(meant.params)
    kind = spec.target_kind
    if meant.type == "around" and "n" not in params:
        params["n"] = count
    targets: list[str | tuple[str, str] | None] = []
    if kind == "none":
        targets = [None]
    elif kind == "wall":
        name = meant.target.split(":", 1)[1] if isinstance(meant.target, str) and ":" in meant.target else None
        targets = [None] if name is None else [f"wall:{k}" for k in walls_named(name, survey.scene.room)]
    elif kind == "window":
        targets = [w.id for w in survey.scene.room.windows]
    elif kind == "door":
        targets = [None]
    elif kind == "objects":
        pair = meant.target if isinstance(meant.target, tuple) else (str(meant.target), str(meant.target))
        first, second = (_named(survey, name) for name in pair)
        pairs = ((a.id, b.id) for a in first for b in second if len({a.id, b.id, body.id}) == 3)
        targets = [*itertools.islice(pairs, 64)]
    else:
        targets = [*(b.id for b in _named(survey, str(meant.target)) if b is not body)]
    for target in targets:
        try:
            if meant.type == "around" and count < 2:
                yield Relation(type="front_against", subject=body.id, target=target)
            else:
                yield Relation(type=meant.type, subject=body.id, target=target, params=params)
        except InputError:
            continue


def _rows(survey: Survey, said: StatedRelation, meant: Meaning, wrong: Sequence[Body]) -> list[dict]:
    rows = []
    for body in wrong:
        first = (
            next(_options(survey, said, meant, body, len(_named(survey, said.subject))), None)
            if (meant.target != "middle")
            else None
        )
        if first is not None:
            target = list(first.target) if isinstance(first.target, tuple) else first.target
            row = {"type": first.type, "subject": body.id, "target": target, "hard": True}
            rows.append({**row, "params": dict(first.params)} if first.params else row)
    return rows


def _middle(survey: Survey, subjects: Sequence[Body]) -> tuple[list[Body], str]:
    """Whether a group as a whole is in the middle of the floor."""
    centroid = survey.placed.floor.centroid
    x = sum(b.position[0] for b in subjects) / len(subjects)
    y = sum(b.position[1] for b in subjects) / len(subjects)
    away = math.hypot(x - float(centroid.x), y - float(centroid.y))
    if away <= max(0.3, MIDDLE * math.sqrt(survey.area)):
        return [], ""
    return list(subjects), f"{away:.2f} m from the middle of the room"


def walls_named(name: str, room: Room) -> list[int]:
    """The walls that "left", "right", "far", "near" (seen from the door), a compass point or a number name."""
    if name.isdigit():
        return [int(name)] if int(name) < len(room.walls) else []
    way = direction_of(name, room)
    return [wall.index for wall in room.walls if way is None or dot(wall.outward, way) > 0.7]
