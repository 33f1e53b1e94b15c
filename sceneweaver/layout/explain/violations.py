"""What is wrong with single layouts, and most often in many."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

import numpy as np
import shapely

from sceneweaver.kernels import tables as k
from sceneweaver.scene import Scene

from ..compile import Problem
from ..shapes import Prism, reach_of
from ..solution import Solution
from .sections import extent, moved
from .study import BEST, Study
from .walls import wall_claims
from .words import LINES, plural, relation_words

SUNK = 2.5e-4  # [m] half of what the engine lets two bodies sink in; INTRUDED: the same for zones and clearances
INTRUDED = 4.25e-3
Shapes = list[tuple[shapely.Polygon, tuple[float, float]]]


def violations(problem: Problem, scene: Scene, poses: np.ndarray | None) -> dict[str, tuple[str, ...]]:
    """What is wrong with one layout, in words, with the ids of the objects; relations are left out.

    ``poses`` are the world's [object, 4]; None: those of the scene.
    """
    poses = problem.home if poses is None else poses.astype(np.float64)
    ids, objects = problem.ids, scene.objects
    solids = [_shapes(moved(s, p)) for s, p in zip(problem.solids, poses, strict=True)]
    zones = [_shapes(moved(z, p), INTRUDED) for z, p in zip(problem.zones, poses, strict=True)]
    prisms = [(*s, *z) for s, z in zip(problem.solids, problem.zones, strict=True)]
    reach = np.array([reach_of([p.polygon for p in own]) for own in prisms])
    floor = shapely.Polygon(scene.room.outline).buffer(SUNK, join_style="mitre")
    shapes = [_shapes([p], INTRUDED) for p in problem.region.openings]
    openings = list(zip((*scene.room.doors, *scene.room.windows), shapes, strict=True))
    found: dict[str, tuple[str, ...]] = {}
    for i, obj in enumerate(objects):
        outside = any(not floor.covers(s) for s, _ in solids[i])
        low, top = extent(problem.solids[i]) + poses[i, 2]
        if outside or top > scene.room.height + 2 * SUNK or low < -2 * SUNK:
            found[f"{obj.id} is partly outside of the room"] = (obj.id,)
        if obj.mount != "wall":
            for opening, shape in openings:
                if _meet(solids[i], shape):
                    found[f"{obj.id} is in the clearance of {opening.id}"] = (obj.id,)
        gaps = np.hypot(*(poses[:, :2] - poses[i, :2]).T)
        for j in np.flatnonzero(gaps < reach + reach[i]):
            flags = int(problem.flags[i, j])
            if j > i and flags & k.PAIR_COLLIDE and _meet(solids[i], solids[j]):
                found[f"{obj.id} and {ids[j]} collide"] = (obj.id, ids[j])
            elif flags & k.PAIR_ZONE_OF_FIRST and _meet(zones[i], solids[j]) and not _meet(solids[i], solids[j]):
                found[f"{ids[j]} is in the access zone of {obj.id}"] = (obj.id, ids[j])
    return found


def _shapes(prisms: Iterable[Prism], give: float = SUNK) -> Shapes:
    return [(shapely.Polygon(p.polygon).buffer(-give, join_style="mitre"), p.z) for p in prisms]


def _meet(a: Shapes, b: Shapes) -> bool:
    for s, z in a:
        for t, w in b:
            if min(z[1], w[1]) - max(z[0], w[0]) > 2 * SUNK and s.intersects(t):
                return True
    return False


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
    scene, top = study.scene, study.top[: max(4, min(BEST, 800 // max(1, len(study.scene.objects))))]
    counts: Counter[str] = Counter()
    for c in top[np.isfinite(study.solution.poses[top]).all(axis=(1, 2))]:
        counts.update(violations(study.problem, scene, study.solution.poses[c]).keys())
        for j, rel in enumerate(scene.relations):
            if rel.hard and not study.solution.relations[c, j]:
                counts[f"{relation_words(rel)} is unmet"] += 1
    if not counts:
        return most_unmet(scene, study.solution)
    worst = sorted(counts.items(), key=lambda item: (-item[1], item[0]))[: LINES + 1]
    which = f"In the best {len(top)} layouts" if len(top) > 1 else "In the only layout"
    return f"{which}: {'; '.join(f'{text} ({n})' for text, n in worst)}."


def hints(study: Study) -> list[str]:
    """Where it is tight, and what is wrong most often."""
    tight = study.walls.tightest(wall_claims(study.scene))
    return [f"It is tight: {tight}."] * bool(tight) + [most_frequent(study)]
