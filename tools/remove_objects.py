"""Take objects out, with what stands on them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.generate.carry import carried
from sceneweaver.generate.draft import Draft
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError, Scene, SceneObject
from sceneweaver.scene.edits import Remove

from .base import Context, Proposal
from .card import checked


class RemoveObjects:
    """Removes objects by id, or all but some of a category."""

    name = "remove_objects"

    def propose(self, context: Context) -> Proposal:
        """Removal of ``ids``, or of what ``category`` names beyond ``keep``."""
        scene = context.scene
        ids = _meant(scene, checked(self.name, context.inputs))
        if not ids:
            return Proposal(notes=("nothing is left to remove",))
        objects = {o.id: o for o in scene.objects}
        gone: set[str] = set()
        edits, notes = [], []
        for id in ids:
            if id in gone:
                continue  # it went with what it stood on
            riders = [r for r in carried(objects, id) if r not in gone]
            edits.append(Remove(id=id, cascade=True))
            gone |= {id, *riders}
            named = [r for r in riders if r not in ids]
            if named:
                more = f" and {len(named) - 4} more" if len(named) > 4 else ""
                notes.append(f"{', '.join(named[:4])}{more} went with {id}")
        return Proposal(edits=tuple(edits), notes=tuple(notes))


def _meant(scene: Scene, inputs: Mapping[str, Any]) -> list[str]:
    ids, category = inputs.get("ids"), inputs.get("category")
    if not ids and category is None:
        raise InputError("tool remove_objects: inputs.ids is missing; name ids or a category")
    known = set(scene.ids)
    for k, id in enumerate(ids or ()):
        if id not in known:
            fix = suggest(id, known, what="objects", mark="'")
            raise InputError(f"tool remove_objects: inputs.ids[{k}] is '{id}', which is no object{fix}")
    found: list[str] = list(dict.fromkeys(ids or []))
    if category is not None:
        pool = [id for id in Draft.of(scene).named(category) if id not in found]
        if not pool and not found:
            raise InputError(f"tool remove_objects: inputs.category is '{category}'; there is none in the scene")
        pool.sort(key=lambda id: _worth(scene, scene.object(id)))
        found += pool[: max(0, len(pool) - int(inputs.get("keep", 0)))]
    return found


def _worth(scene: Scene, obj: SceneObject) -> tuple[int, int, int, int]:
    """What is taken first: what nobody asked for, carries nothing and has few ties; of equals the last one."""
    asked = int(obj.intent.request is not None)
    load = sum(o.support is not None and o.support.object == obj.id for o in scene.objects)
    ties = sum(obj.id in (r.subject, *r.targets) for r in scene.relations)
    return asked, load, ties, -scene.index(obj.id)
