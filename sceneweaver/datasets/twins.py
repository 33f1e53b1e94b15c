"""Twins of a scene: each differs from it in one stated thing, and by how much."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from sceneweaver.critic import review_scene
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge import room_types
from sceneweaver.language import read_request
from sceneweaver.scene import Relation, Scene
from sceneweaver.verify import Report, check

from .changes import Change, Changer, changed_ids
from .describe.facts import Facts
from .describe.moves import judged_locally

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
    left, hard = list(after.scene.relations), [v for v in other.violations if v.hard]
    measured: dict[str, Any] = {
        "valid": [one.valid, other.valid],
        **{name: [getattr(one, name), getattr(other, name)] for name in COUNTS},
        "violations": [v.to_dict() for v in hard],
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
        "with": [name for v in hard for name in v.objects if name not in ids] if change.breaks is not None else [],
        "before": {i: old[i].model_dump(mode="json", include=shown) for i in ids},
        "after": {i: new[i].model_dump(mode="json", include=shown) for i in ids if i in new},
        "measured": measured,
    }


def _relation(scene: Scene, relation: Relation) -> dict[str, Any]:
    return {
        "index": scene.relations.index(relation),
        **relation.model_dump(mode="json", include={"type", "subject", "target", "hard"}),
    }


def _rounded(share: float | None) -> float | None:
    return None if share is None else round(share, 6)


TRIED = 12
"""Changes of one sort that are looked at."""


@dataclass(frozen=True)
class Twin:
    """A scene that differs from another in one thing, and the measured difference as JSON data."""

    scene: Scene
    difference: dict[str, Any]


def twins(scene: Scene, count: int, seed: int) -> list[Twin]:
    """Twins of a valid scene, in turn still valid and broken in exactly one thing.

    All that a difference does not name is equal to the last bit. A function of its arguments alone.

    Args:
        scene: the scene; of one that is not valid there are no twins.
        count: how many.
        seed: what is drawn: which things, and what becomes of them.

    Returns:
        ``count`` twins, unless a scene has too few things to change.
    """
    before = Measured.of(scene) if count else None
    if before is None or not before.report.valid:
        return []
    rng = np.random.default_rng(seed)
    changer = Changer(Facts(scene), rng)
    first = bool(rng.integers(2))
    found: list[Twin] = []
    used: set[tuple[str, str | None, str]] = set()
    for k in range(count):
        breaking = first == bool(k % 2)
        twin = _twin(changer, before, breaking, used) or _twin(changer, before, not breaking, used)
        if twin is not None:
            found.append(twin)
    return found


def twin_files(found: Sequence[Twin]) -> dict[str, bytes]:
    """The files of twins by suffix: ``twin-0.scene.json``, ``twin-0.difference.json`` ..."""
    files = {}
    for k, twin in enumerate(found):
        files[f"twin-{k}.scene.json"] = (twin.scene.dumps() + "\n").encode()
        files[f"twin-{k}.difference.json"] = (json.dumps(twin.difference, ensure_ascii=False) + "\n").encode()
    return files


def _twin(changer: Changer, before: Measured, breaking: bool, used: set[tuple[str, str | None, str]]) -> Twin | None:
    """The first change of a sort that does what it is to do and nothing else."""
    for source in changer.sources(breaking):
        for change in islice(_fresh(source(), used), TRIED):
            if not _near_as_stated(before.scene, change):
                continue
            after = Measured.of(change.after)
            if _as_stated(change, changed_ids(change, before.scene), after):
                used.add((change.kind, change.breaks, change.object))
                return Twin(change.after, difference(before, after, change))
    return None


def _fresh(changes: Iterable[Change], used: set[tuple[str, str | None, str]]) -> Iterable[Change]:
    return (c for c in changes if (c.kind, c.breaks, c.object) not in used)


def _near_as_stated(scene: Scene, change: Change) -> bool:
    """What neighbours alone can tell of it, which is much cheaper."""
    if change.kind == "recoloured":
        return True
    if change.kind == "removed":
        return check(change.after, walkable=False).valid
    hard = judged_locally(change.after, change.object, [r for r in scene.relations if r.hard]).hard
    return [v.kind for v in hard] == ([change.breaks] if change.breaks else [])


def _as_stated(change: Change, ids: Sequence[str], after: Measured) -> bool:
    """Whether the whole scene is valid, or wrong in the one stated thing."""
    hard = [v for v in after.report.violations if v.hard]
    if change.breaks is None:
        return not hard
    return [v.kind for v in hard] == [change.breaks] and bool(set(ids) & set(hard[0].objects))
