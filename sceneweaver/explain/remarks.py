"""What there is to say of a solution beside why nothing is valid: wishes that hold nowhere, engine against judge."""

from __future__ import annotations

import numpy as np

from sceneweaver.layout import Solution
from sceneweaver.scene import Relation
from sceneweaver.scene.catalogue import BUILT_IN
from sceneweaver.verify import check

from .softness import lost_wishes
from .words import relation_words


def remarks(solution: Solution) -> list[str]:
    """One line each."""
    return [*disagreements(solution), *lost_wishes(solution)]


def disagreements(solution: Solution) -> list[str]:
    """Relations of the user's own that the engine and the judge see otherwise in the best layout."""
    own = [j for j, rel in enumerate(solution.source.relations) if rel.type not in BUILT_IN]
    best = int(solution.order[0])
    if not own or not np.isfinite(solution.poses[best]).all():
        return []
    missed = {v.relation.index for v in check(solution.best, walkable=False).violations if v.relation is not None}
    held = solution.relations[best]
    return [_against(solution.source.relations[j], bool(held[j])) for j in own if held[j] == (j in missed)]


def _against(relation: Relation, held: bool) -> str:
    yes, no = ("its residual", "its `holds`") if held else ("its `holds`", "its residual")
    return (
        f"Engine and judge disagree about {relation_words(relation)} in the best layout: {yes} says that it holds, "
        f"{no} that it does not; mend one of them (define_relation)."
    )
