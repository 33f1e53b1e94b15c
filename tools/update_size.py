"""Make objects anew in another size."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.assets import Library, categories
from sceneweaver.generate.exchange import Size, exchanged, resized_body
from sceneweaver.scene import InputError, Scene, SceneObject
from sceneweaver.scene.edits import AnyEdit, SetSize, apply_all

from .base import Context, Proposal
from .card import checked
from .update_rotation import known_ids

CLOSE = 0.06
"""Relative difference of a size that is taken for what was asked."""


class UpdateSize:
    """Gives objects another size: the same design drawn anew, or a body that fits better."""

    name = "update_size"

    def propose(self, context: Context) -> Proposal:
        """New bodies for ``sizes``, or for ``ids`` times ``scale``."""
        scene, notes, unmet = context.scene, list[str](), list[str]()
        wanted = _wanted(scene, checked(self.name, context.inputs))
        edits: list[AnyEdit] = []
        for id in sorted(wanted, key=lambda i: _depth(scene, i)):
            obj = scene.object(id)
            size = _clamped(obj, wanted[id], notes)
            if _close(obj.size, size):
                notes.append(f"{id} has that size already")
                continue
            if obj.fixed:
                unmet.append(f"{id} is fixed")
                continue
            steps = _resized(context.library, scene, obj, size, context.seed, notes, unmet)
            scene, _ = apply_all(scene, steps)  # so that what stands on it is resized where it stands now
            edits += steps
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def _wanted(scene: Scene, inputs: Mapping[str, Any]) -> dict[str, Size]:
    sizes, ids, scale = inputs.get("sizes"), inputs.get("ids"), inputs.get("scale")
    if bool(ids) != (scale is not None) or not (sizes or ids):
        raise InputError("tool update_size: inputs need sizes, or ids and scale; give id: [depth, width, height]")
    wanted: dict[str, Size] = {}
    for id in known_ids(scene, list(ids or ()), "tool update_size: inputs.ids"):
        d, w, h = (s * float(scale or 1.0) for s in scene.object(id).size)
        wanted[id] = (d, w, h)
    for id, given in (sizes or {}).items():
        known_ids(scene, [id], "tool update_size: inputs.sizes")
        own = scene.object(id).size
        d, w, h = (float(own[k] if extent is None else extent) for k, extent in enumerate(given))
        wanted[id] = (d, w, h)
    return wanted


def _clamped(obj: SceneObject, size: Size, notes: list[str]) -> Size:
    """The size [m] brought into what such a thing can measure."""
    category = categories().get(obj.category.replace(" ", "_"))
    if category is None or category.size is None:
        return size
    kept = tuple(min(max(s, low), high) for s, (low, high) in zip(size, category.size.ranges, strict=True))
    if not _close(kept, size, 0.005):
        said, now = (" x ".join(f"{v:.2f}" for v in s) for s in (size, kept))
        notes.append(f"{obj.id}: {said} m was brought to {now} m, as a {category.words} measures")
    return kept[0], kept[1], kept[2]


def _resized(
    library: Library, scene: Scene, obj: SceneObject, size: Size, seed: int, notes: list[str], unmet: list[str]
) -> list[AnyEdit]:
    asset = resized_body(library, obj, size, seed)
    if asset is None:
        return [SetSize(id=obj.id, size=size)]
    if not _close(asset.size, size):
        now = " x ".join(f"{v:.2f}" for v in asset.size)
        notes.append(f"{obj.id}: the nearest body measures {now} m")
    return exchanged(scene, obj, asset, seed, notes, unmet)


def _close(a: tuple[float, ...], b: tuple[float, ...], slack: float = CLOSE / 6) -> bool:
    return all(abs(x - y) <= slack * max(x, y) for x, y in zip(a, b, strict=True))


def _depth(scene: Scene, id: str) -> int:
    depth, at = 0, scene.object(id)
    while at.support is not None:
        depth, at = depth + 1, scene.object(at.support.object)
    return depth
