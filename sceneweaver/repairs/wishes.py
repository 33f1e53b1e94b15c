"""Soft relations of a scene as wishes: which of them hold, and which a repair loses."""

from __future__ import annotations

from collections.abc import Iterable

from sceneweaver.scene import Scene
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed


def holding(scene: Scene, numbers: Iterable[int] | None = None) -> frozenset[int]:
    """The numbers of the soft relations, or of those of ``numbers``, that hold in a scene by the judge."""
    chosen = [k for k, r in enumerate(scene.relations) if not r.hard] if numbers is None else list(numbers)
    if not chosen:
        return frozenset()
    placed = Placed.of(scene)
    return frozenset(k for k in chosen if judge_relation(placed, scene.relations[k]).holds)
