"""Add relations between what is there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.scene import CATALOGUE, InputError, Relation, Scene, SceneObject
from sceneweaver.scene.edits import Relate, Unrelate
from sceneweaver.scene.references import check_references

from .base import Context, Proposal
from .card import checked

SYMMETRIC = CATALOGUE.with_role("symmetric")
"""Types that say the same with subject and target exchanged."""

OPPOSITE = {
    "left_of": ("right_of",),
    "right_of": ("left_of",),
    "in_front_of": ("behind", "back_to_back"),
    "behind": ("in_front_of", "front_against", "front_to_front"),
    "above": ("below",),
    "below": ("above",),
    "back_to_back": ("facing", "front_against", "front_to_front", "in_front_of", "around"),
    "front_to_front": ("back_to_back", "behind"),
    "front_against": ("back_to_back",),
    "around": ("back_to_back",),
    "facing": ("back_to_back",),
}
"""Types that cannot hold together for the same two objects."""

PLACES = CATALOGUE.with_role("seat")
"""Types of which an object can have one only: it cannot be pulled up to two things."""


class AddRelation:
    """Adds relations; says which are there already and which contradict."""

    name = "add_relation"

    def propose(self, context: Context) -> Proposal:
        """The relations of ``inputs["relations"]`` that are new and possible."""
        rows = checked(self.name, context.inputs)["relations"]
        edits, notes, unmet = related(context.scene, rows, f"tool {self.name}: inputs.relations")
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def related(
    scene: Scene, rows: Iterable[Mapping[str, Any]], where: str
) -> tuple[list[Relate | Unrelate], list[str], list[str]]:
    """Edits that add relations to a scene, notes, and what was not added as it contradicts a hard one.

    Raises:
        InputError: for a relation that no scene could have: an unknown type, object or param.
    """
    edits: list[Relate | Unrelate] = []
    notes: list[str] = []
    unmet: list[str] = []
    there = list(scene.relations)
    for k, row in enumerate(rows):
        relation = _read(scene, row, f"{where}[{k}]")
        words = f"{relation.type} of {relation.subject}" + (f" to {_target(relation)}" if relation.target else "")
        same = next((r for r in there if _same(r, relation)), None)
        if same is not None and (same.hard or not relation.hard) and dict(same.params) == dict(relation.params):
            notes.append(f"{words} is there already")
            continue
        against = next((r for r in there if r is not same and r.hard and relation.hard and clash(r, relation)), None)
        if against is not None:
            unmet.append(f"{words} contradicts {against.type}" + (f" {_target(against)}" if against.target else ""))
            continue
        reason = _impossible(scene.object(relation.subject), relation)
        if reason:
            unmet.append(f"{words}: {reason}")
            continue
        if same is not None:  # it becomes hard, or gets other numbers
            edits.append(Unrelate(type=same.type, subject=same.subject, target=same.target))
            there.remove(same)
        edits.append(Relate(relation=relation))
        there.append(relation)
    return edits, notes, unmet


def clash(a: Relation, b: Relation) -> bool:
    """Whether two relations can never hold together."""
    if a.subject == b.subject:
        if a.type in PLACES and b.type in PLACES and a.target != b.target:
            return True
        if a.type == b.type and a.type in CATALOGUE.with_role("wall") and None not in (a.target, b.target):
            return a.target != b.target and a.type == "against_wall"
        if a.target == b.target and a.target is not None:
            return b.type in OPPOSITE.get(a.type, ()) or a.type in OPPOSITE.get(b.type, ()) or _apart(a, b)
        return False
    crossed = a.target == b.subject and b.target == a.subject
    if crossed and a.type == b.type and a.type in ("above", "below", "on_top", "inside"):
        return True
    return crossed and _apart(a, b)


def _apart(a: Relation, b: Relation) -> bool:
    """Whether one wants two objects nearer than the other allows."""
    for near, far in ((a, b), (b, a)):
        if near.type == "near" and far.type == "distance":
            return float(CATALOGUE["near"].value(near, "max")) < float(far.params.get("min") or 0.0)
    return False


def _read(scene: Scene, row: Mapping[str, Any], where: str) -> Relation:
    data = {k: v for k, v in row.items() if v is not None}
    if isinstance(data.get("target"), list):
        pair = data["target"]
        data["target"] = tuple(pair) if len(pair) == 2 else pair[0] if len(pair) == 1 else None
    try:
        relation = Relation.model_validate(data)
        check_references(scene.room, scene.objects, (relation,))
    except InputError as error:
        raise InputError(f"{where}: {str(error).removeprefix('relation: ')}") from None
    except ValueError as error:  # the scene's own checks, whose path is that of the scene
        loc = getattr(error, "loc", ())
        field = next((str(part) for part in reversed(loc) if isinstance(part, str)), "")
        raise InputError(f"{where}.{field} {getattr(error, 'text', error)}") from None
    return relation


def _same(a: Relation, b: Relation) -> bool:
    if a.type != b.type:
        return False
    if (a.subject, a.target) == (b.subject, b.target):
        return True
    return a.type in SYMMETRIC and a.subject == b.target and a.target == b.subject


def _impossible(subject: SceneObject, relation: Relation) -> str:
    """Why a relation can never hold; empty when it can."""
    if relation.type in ("on_top", "inside") and (subject.support is None or subject.support.object != relation.target):
        return f"{subject.id} does not stand on it; add it there anew with add_objects"
    floor = CATALOGUE.with_role("edge") - {"at_window"}
    if subject.support is not None and relation.type in floor and relation.hard:
        return f"{subject.id} stands on {subject.support.object}, which decides where it is"
    return ""


def _target(relation: Relation) -> str:
    return " and ".join(relation.targets)
