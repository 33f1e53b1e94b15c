"""What the page says of relations, violations and objects, drawn from the scene and its metrics."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sceneweaver.geometry.rotations import is_upright
from sceneweaver.scene import Relation, Scene, SceneObject

KINDS = {
    "collision": "Collision",
    "out_of_bounds": "Out of the room",
    "unsupported": "Unsupported",
    "blocked_zone": "Blocked zone",
    "blocked_opening": "Blocked opening",
    "blocked_floor": "Floor not free",
    "narrow_path": "Narrow path",
    "relation": "Relation",
    "soft_relation": "Soft relation",
    "unstable": "Falls or slides",
    "yaw_domain": "Yaw off its domain",
    "dropped": "Dropped",
}


SOFT = ("soft_relation", "narrow_path")
"""Kinds of violations that leave a scene valid."""


@dataclass(frozen=True)
class RelationRow:
    """A relation in words; ``held`` is None when nobody checked, ``detail`` says what was measured when it fails."""

    relation: Relation
    text: str
    held: bool | None
    detail: str = ""


@dataclass(frozen=True)
class ViolationRow:
    """A violation of metrics.json; ``relation`` is the place of its relation in the scene, None when it names none."""

    kind: str
    objects: tuple[str, ...]
    detail: str
    relation: int | None = None

    @property
    def name(self) -> str:
        """Its kind in words."""
        return KINDS.get(self.kind, self.kind)


def faults_of(metrics: Mapping[str, Any]) -> list[ViolationRow]:
    """The violations of metrics.json, in their order."""
    return [
        ViolationRow(
            str(v["kind"]), tuple(map(str, v["objects"])), str(v["detail"]), v.get("relation", {}).get("index")
        )
        for v in metrics.get("violations") or ()
    ]


def relation_rows(scene: Scene, metrics: Mapping[str, Any]) -> list[RelationRow]:
    """All relations; one is broken when a violation names it. In files where violations name none, nothing is known."""
    faults = [fault for fault in faults_of(metrics) if fault.kind in ("relation", "soft_relation")]
    broken = {fault.relation: fault.detail for fault in faults}
    checked = "violations" in metrics and None not in broken
    return [
        RelationRow(r, _phrase(r), k not in broken if checked else None, broken.get(k, ""))
        for k, r in enumerate(scene.relations)
    ]


def object_facts(scene: Scene, rows: list[RelationRow], faults: list[ViolationRow]) -> dict[str, dict[str, Any]]:
    """By id, what the panel of the 3D view shows of an object."""
    carries: dict[str, list[str]] = defaultdict(list)
    for thing in scene.objects:
        if thing.support is not None:
            carries[thing.support.object].append(thing.id)
    told: dict[str, list[dict[str, Any]]] = defaultdict(list)
    for row in rows:
        for object_id in dict.fromkeys((row.relation.subject, *row.relation.targets)):
            told[object_id].append({"text": row.text, "held": row.held})
    wrong: dict[str, list[str]] = defaultdict(list)
    for fault in faults:
        for object_id in dict.fromkeys(fault.objects):
            if fault.kind not in SOFT:
                wrong[object_id].append(f"{fault.name}: {fault.detail}")
    return {o.id: _facts(o, carries[o.id], told[o.id], wrong[o.id]) for o in scene.objects}


def _facts(thing: SceneObject, carries: list[str], told: list[dict[str, Any]], wrong: list[str]) -> dict[str, Any]:
    d, w, h = thing.size
    x, y, z = thing.pose.position
    return {
        "category": thing.category.replace("_", " "),
        "description": thing.description,
        "size": [d, w, h],
        "position": [x, y, z],
        "yaw": _degrees(thing.pose.yaw),
        "tilted": not is_upright(thing.pose.quaternion, 1e-3),
        "mount": {"floor": "on the floor", "wall": "on the wall", "ceiling": "on the ceiling"}.get(
            thing.mount, thing.mount
        ),
        "support": None
        if thing.support is None
        else {"object": thing.support.object, "surface": thing.support.surface},
        "asset": thing.asset,
        "carries": carries,
        "relations": told,
        "faults": wrong,
        "box": {"low": [-d / 2, -w / 2, 0.0], "high": [d / 2, w / 2, h]},
        "top": [x, y, z + h + 0.03],
    }


def _degrees(angle: float) -> float:
    """An angle [rad] in degrees to one decimal, in (-180, 180]."""
    value = round(math.degrees(angle), 1) + 0.0  # no -0.0
    return 180.0 if value == -180.0 else value


def _phrase(relation: Relation) -> str:
    """A relation as words: "chair-0 front against desk-0 (gap -0.4 to -0.1), soft"."""
    params = []
    for name, value in relation.params.items():
        shown = " to ".join(f"{v:g}" for v in value) if isinstance(value, list | tuple) else f"{value}"
        params.append(f"{name} {shown}")
    text = " ".join((relation.subject, relation.type.replace("_", " "), " and ".join(relation.targets))).rstrip()
    return text + (f" ({', '.join(params)})" if params else "") + ("" if relation.hard else ", soft")
