"""Soft relations of a scene as wishes: which of them hold, nearly hold, and which a repair loses."""

from __future__ import annotations

from collections.abc import Iterable

from sceneweaver.scene import Scene
from sceneweaver.verify.relations import nearly_holds
from sceneweaver.verify.solids import Placed

NEARLY = 0.3  # [m] by which a soft relation may be missed that a repair is to mend, too


def holding(scene: Scene, numbers: Iterable[int] | None = None, slack: float = 0.0) -> frozenset[int]:
    """The numbers of the soft relations, or of those of ``numbers``, that hold in a scene by the judge.

    With ``slack`` [m] also those that are missed by so much at most.
    """
    chosen = [k for k, r in enumerate(scene.relations) if not r.hard] if numbers is None else list(numbers)
    if not chosen:
        return frozenset()
    placed = Placed.of(scene)
    return frozenset(k for k in chosen if nearly_holds(placed, scene.relations[k], slack))
