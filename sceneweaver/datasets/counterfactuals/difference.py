"""What a change does, measured on both scenes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from sceneweaver.critic import review_scene
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge import room_types
from sceneweaver.language import read_request
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify import Report, check

from .changes import Change, changed_ids

COUNTS = ("collisions", "out_of_bounds", "unsupported", "blocked_zones", "blocked_openings")


@dataclass(frozen=True)
class Measured:
    """A scene with its judgement and its grade, None for a kind of room without one."""

    scene: Scene
    report: Report
    grade: float | None

    @classmethod
    def of(cls, scene: Scene) -> Measured:
        """Judge and grade a scene."""
        report = check(scene)
        kind = room_types().get(scene.room.type)
        if kind is None:
            return cls(scene, report, None)
        return cls(scene, report, round(review_scene(scene, report, kind, read_request(scene.prompt)).total, 3))

    @property
    def broken(self) -> list[Relation]:
        """The relations that do not hold."""
        found = (v.relation.index for v in self.report.violations if v.relation is not None)
        return [self.scene.relations[k] for k in found]


def difference(before: Measured, after: Measured, change: Change) -> dict[str, Any]:
    """All that differs between two scenes, as JSON data.

    ``before`` and ``after`` hold what the files differ in: poses, looks or whole objects, by id; ``measured`` holds
    pairs, before and after, of what `sceneweaver.check` and the critic say. Lengths are metres, angles degrees.
    """
    ids = changed_ids(change, before.scene)
    old, new = ({o.id: o for o in m.scene.objects} for m in (before, after))
    fields = {"moved": {"pose"}, "turned": {"pose"}, "recoloured": {"asset", "attributes", "description"}}
    shown = fields.get(change.kind)
    one, other = before.report, after.report
    left = list(after.scene.relations)
    measured: dict[str, Any] = {
        "valid": [one.valid, other.valid],
        **{name: [getattr(one, name), getattr(other, name)] for name in COUNTS},
        "violations": [v.to_dict() for v in other.violations if v.hard],
        "relations_lost": [_relation(before.scene, r) for r in after.broken if r not in before.broken],
        "relations_gained": [_relation(before.scene, r) for r in before.broken if r in left and r not in after.broken],
        "relations_removed": [_relation(before.scene, r) for r in before.scene.relations if r not in left],
        "walkable_share": [_rounded(one.walkable_share), _rounded(other.walkable_share)],
        "reachable_share": [_rounded(one.reachable_share), _rounded(other.reachable_share)],
        "grade": [before.grade, after.grade],
    }
    if change.kind in ("moved", "turned"):
        a, b = old[change.object].pose, new[change.object].pose
        measured["distance"] = round(math.dist(a.position, b.position), 4)
        measured["turn"] = round(math.degrees(wrap_angle(b.yaw - a.yaw)), 2)
    return {
        "schema": "sceneweaver.difference/1",
        "change": change.kind,
        "object": change.object,
        "carried": ids[1:],
        "valid": other.valid,
        "breaks": change.breaks,
        "with": _others(after.report, ids) if change.breaks is not None else [],
        "before": {i: old[i].model_dump(mode="json", include=shown) for i in ids},
        "after": {i: new[i].model_dump(mode="json", include=shown) for i in ids if i in new},
        "measured": measured,
    }


def _others(report: Report, ids: list[str]) -> list[str]:
    """What the violation names besides the changed objects."""
    return [name for v in report.violations if v.hard for name in v.objects if name not in ids]


def _relation(scene: Scene, relation: Relation) -> dict[str, Any]:
    return {
        "index": scene.relations.index(relation),
        **relation.model_dump(mode="json", include={"type", "subject", "target", "hard"}),
    }


def _rounded(share: float | None) -> float | None:
    return None if share is None else round(share, 6)
