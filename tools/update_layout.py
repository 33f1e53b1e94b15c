"""Let some objects, or all, be laid out anew."""

from __future__ import annotations

from typing import Any

from sceneweaver.generate.carry import move
from sceneweaver.generate.draft import Draft
from sceneweaver.scene import CATALOGUE, InputError, Pose, Scene, SceneObject
from sceneweaver.scene.edits import AnyEdit

from .add_relation import related
from .base import Context, Proposal
from .card import checked
from .update_rotation import known_ids

TIED = CATALOGUE.with_role("tying")
"""Types by which an object belongs to its target and goes where that goes."""


TOGETHER = 1.2
"""Distance [m] within which the objects of a group are wanted."""


class UpdateLayout:
    """Sets objects back, so that the engine finds a place for them anew."""

    name = "update_layout"

    def propose(self, context: Context) -> Proposal:
        """The objects of ``ids`` without a place, or with no ids a fresh layout of the room."""
        scene, inputs = context.scene, checked(self.name, context.inputs)
        where = f"tool {self.name}: inputs"
        if not scene.objects:
            raise InputError(f"tool {self.name}: the scene has no objects; begin with an initialiser")
        ids = known_ids(scene, list(inputs.get("ids", ())), f"{where}.ids")
        rows: list[dict[str, Any]] = [dict(row) for row in inputs.get("relations", ())]
        edits, notes, unmet = related(scene, rows, f"{where}.relations")
        if "near" in inputs:
            more, said, against = _near(scene, ids, inputs["near"])
            edits, notes, unmet = [*edits, *more], [*notes, *said], [*unmet, *against]
        for k, group in enumerate(inputs.get("groups", ())):
            members = known_ids(scene, list(group), f"{where}.groups[{k}]")
            more, said, against = _together(scene, members)
            edits, notes, unmet = [*edits, *more], [*notes, *said], [*unmet, *against]
            ids = list(dict.fromkeys([*ids, *members]))
        if (
            ids and not rows and "near" not in inputs and not inputs.get("groups")
        ):  # what is laid out by itself would leave its row
            notes += [f"{id} stands in a row and stays there" for id in ids if id in _in_rows(scene)]
            ids = [id for id in ids if id not in _in_rows(scene)]
            if not ids:
                return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))
        if not ids:
            return Proposal(edits=tuple(edits), fresh=True, notes=tuple(notes), unmet=tuple(unmet))
        free: dict[str, Pose] = {}
        for id in _with_kin(scene, ids):
            obj = scene.object(id)
            if obj.fixed:
                unmet.append(f"{id} is fixed")
            elif obj.support is not None:
                base = _base(scene, obj)
                notes.append(f"{id} stands on {obj.support.object}, so {base.id} is laid out anew")
                if not base.fixed:
                    free[base.id] = _unplaced(base)
            else:
                free[id] = _unplaced(obj)
        moves: list[AnyEdit] = list(move(scene, free))
        return Proposal(edits=(*edits, *moves), notes=tuple(notes), unmet=tuple(unmet))


def _unplaced(obj: SceneObject) -> Pose:
    """The pose of what is new: at the origin, at its own height."""
    return Pose(position=(0.0, 0.0, obj.pose.position[2]))


def _in_rows(scene: Scene) -> set[str]:
    """What a row, a run or a grid hangs together by."""
    formation = CATALOGUE.with_role("formation")
    return {id for r in scene.relations if r.hard and r.type in formation for id in (r.subject, *r.targets)}


def _with_kin(scene: Scene, ids: list[str]) -> list[str]:
    """The objects with those that belong to them: a desk moves with its chair."""
    found = list(ids)
    for id in found:
        found += [
            r.subject
            for r in scene.relations
            if r.hard and r.type in TIED and r.target == id and r.subject not in found
        ]
    return list(dict.fromkeys(found))


def _base(scene: Scene, obj: SceneObject) -> SceneObject:
    while obj.support is not None:
        obj = scene.object(obj.support.object)
    return obj


def _together(scene: Scene, ids: list[str]):
    """Wishes by which objects stand together: each near the first."""
    rows = [
        {"type": "near", "subject": id, "target": ids[0], "params": {"max": TOGETHER}, "hard": False}
        for id in ids[1:]
        if scene.object(id).support is None
    ]
    return related(scene, rows, "tool update_layout: inputs.groups")


def _near(scene: Scene, ids: list[str], word: str):
    named = Draft.of(scene).named(word)
    if not named:
        raise InputError(f"tool update_layout: inputs.near is '{word}', which is no object; name one of the scene")
    if not ids:
        raise InputError("tool update_layout: inputs.near needs ids; name the objects that should stand near")
    rows = [{"type": "near", "subject": id, "target": named[0]} for id in ids if id != named[0]]
    return related(scene, rows, "tool update_layout: inputs.near")
