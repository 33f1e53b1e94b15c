"""What the judge finds wrong with layouts, and what is wrong most often in many."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

import numpy as np

from sceneweaver.layout import Solution
from sceneweaver.scene import Scene
from sceneweaver.verify import Violation

from .study import BEST, Study
from .walls import wall_claims
from .words import LINES, plural, relation_words

WORDS = {
    "collision": "{0} and {1} collide",
    "out_of_bounds": "{0} is partly outside of the room",
    "unsupported": "{0} is not held as its mount says",
    "blocked_zone": "{1} is in the access zone of {0}",
    "blocked_opening": "{0} is in the clearance of {1}",
}


def violation_words(violation: Violation) -> str:
    """What is wrong with the objects of a violation, without amounts, so that it can be counted over layouts."""
    return WORDS[violation.kind].format(*violation.objects)


def out_of_place(violations: Iterable[Violation]) -> list[Violation]:
    """Those that are about objects and the room alone, without relations."""
    return [v for v in violations if v.kind in WORDS]


def most_unmet(scene: Scene, solution: Solution) -> str:
    """The hard relations that are unmet most often; costs nothing."""
    hard = [j for j, r in enumerate(scene.relations) if r.hard]
    share = (~solution.relations).sum(axis=0)
    worst = [j for j in sorted(hard, key=lambda j: (-share[j], j)) if share[j]][:LINES]
    unmet = [f"{relation_words(scene.relations[j])} unmet in {share[j]}" for j in worst]
    broken = int(np.sum(solution.status == 1))
    diverged = int(np.sum(solution.status == 3))
    words = [f"{broken} with a collision or something out of place"] * bool(broken) + unmet
    words += [f"{diverged} diverged"] * bool(diverged)
    return f"Of {plural(solution.candidates, 'candidate')}: {'; '.join(words)}."


def most_frequent(study: Study) -> str:
    """What is wrong most often in the best candidates."""
    counts: Counter[str] = Counter()
    few = study.top[: max(4, min(BEST, 800 // max(1, len(study.scene.objects))))]
    judged = {int(c): found for c in few if (found := study.findings(int(c))) is not None}
    for c, found in judged.items():
        counts.update({violation_words(v) for v in out_of_place(found)})
        for j, rel in enumerate(study.scene.relations):
            if rel.hard and not study.solution.relations[c, j]:
                counts[f"{relation_words(rel)} is unmet"] += 1
    if not counts:
        return most_unmet(study.scene, study.solution)
    worst = sorted(counts.items(), key=lambda item: (-item[1], item[0]))[: LINES + 1]
    which = f"In the best {len(judged)} layouts" if len(judged) > 1 else "In the only layout"
    return f"{which}: {'; '.join(f'{text} ({n})' for text, n in worst)}."


def hints(study: Study) -> list[str]:
    """Where it is tight, and what is wrong most often."""
    tight = study.walls.tightest(wall_claims(study.scene))
    return [f"It is tight: {tight}."] * bool(tight) + [most_frequent(study)]
