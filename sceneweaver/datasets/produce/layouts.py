"""Layouts of many rooms, searched for in shared launches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sceneweaver.agent.choice import choice_terms
from sceneweaver.agent.executor import Outcome, with_relations
from sceneweaver.agent.riders import searched, with_riders
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.layout import refine_many
from sceneweaver.scene import Scene

from .drafts import Draft

VARIANTS = 3
"""Ways to line up furniture that are tried in a room, the first that the tool proposes."""

LEAST = 6
"""Layouts of each of them that are searched for at least."""

STEPS = 2
"""Times that a layout which fails is begun anew."""

COMPARED = 4
"""Layouts that the critic compares for each that is kept."""

LARGE = 0.35
"""Area [m2] of plan from which on a piece makes a layout another one."""

APART, TURNED = 0.3, np.radians(30.0)
"""How far [m] or turned [rad] one large piece is in another layout at least: more than between near-duplicates."""


def laid_out(drafts: Sequence[Draft], device: str) -> list[list[Scene]]:
    """Valid layouts of each of some rooms, by the engine's word, the best by the terms of choice first.

    What a room gets does not depend on the others.
    """
    scenes, terms, counts, seeds, owners = [], [], [], [], []
    for number, draft in enumerate(drafts):
        variants = draft.proposal.variants[:VARIANTS] or ((),)
        for variant in variants:
            plain = searched(with_relations(draft.scene, variant))
            scenes.append(plain)
            terms.append(choice_terms(plain, draft.context.room_type))
            counts.append(max(LEAST, draft.executor.settings.layouts // len(variants)))
            seeds.append(draft.seed)
            owners.append(number)
    solutions = refine_many(scenes, candidates=counts, seed=seeds, device=device, steps=STEPS, snap=True, quality=terms)
    found: list[list[tuple[float, Scene]]] = [[] for _ in drafts]
    for number, solution in zip(owners, solutions, strict=True):
        draft = drafts[number]
        for candidate in solution.best_candidates(COMPARED * draft.request.layouts):
            quality = float(solution.quality[candidate]) if solution.quality is not None else 0.0
            found[number].append((-round(quality, 4), with_riders(draft.scene, solution.scene(candidate))))
    return [[scene for _, scene in sorted(rows, key=lambda row: row[0])] for rows in found]


def chosen(draft: Draft, layouts: Sequence[Scene], count: int) -> list[Outcome]:
    """The best valid ones of some layouts by the critic's word, no two of them near-duplicates.

    Args:
        draft: what they are layouts of.
        layouts: the layouts, the most promising first.
        count: how many are wanted; fewer come where there are no more.
    """
    judged = [draft.executor.judged(layout) for layout in layouts[: COMPARED * count]]
    kept: list[Outcome] = []
    for outcome in sorted((o for o in judged if o.report.valid), key=lambda o: o.key):
        if len(kept) < count and not any(alike(outcome.scene, other.scene) for other in kept):
            kept.append(outcome)
    return kept


def alike(first: Scene, second: Scene) -> bool:
    """Whether the large pieces of two layouts of a room stand in the same places, whichever of a kind is where."""
    from scipy.optimize import linear_sum_assignment

    kinds: dict[str, list[int]] = {}
    for k, obj in enumerate(first.objects):
        if obj.mount == "floor" and obj.size[0] * obj.size[1] >= LARGE and obj.size[2] > 0.05:
            kinds.setdefault(obj.category, []).append(k)
    for members in kinds.values():
        here, there = (
            np.array([(*scene.objects[k].pose.position[:2], scene.objects[k].pose.yaw) for k in members])
            for scene in (first, second)
        )
        step = here[:, None] - there[None]
        apart = (np.linalg.norm(step[..., :2], axis=-1) >= APART) | (np.abs(wrap_angle(step[..., 2])) >= TURNED)
        rows, columns = linear_sum_assignment(apart)
        if apart[rows, columns].any():
            return False
    return True
