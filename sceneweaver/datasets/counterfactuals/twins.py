"""Twins of a scene: each differs from it in one stated thing."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from sceneweaver.scene import Scene
from sceneweaver.verify import check

from ..describe.facts import Facts
from ..describe.moves import judged_locally
from .changes import Change, Changer, changed_ids
from .difference import Measured, difference

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
