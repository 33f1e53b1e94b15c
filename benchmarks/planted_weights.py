"""Rooms that are arranged for planted weights: soft relations that contradict each other, brought to rest."""

from __future__ import annotations

import numpy as np

import sceneweaver as sw

KINDS = {
    "near": {"max": 0.1},
    "distance": {"min": 4.0, "max": 9.0},
    "in_middle": {"offset": 0.05},
    "off_walls": {"min": 1.6},
    "aligned": {},
    "facing": {"degrees": 2.0},
}
"""The kinds that are planted, with what they ask for."""


def planted(seed: int) -> dict[str, float]:
    """Weights by kind, drawn over a factor of six."""
    rng = np.random.default_rng([seed, 1])
    return {kind: float(w) for kind, w in zip(KINDS, np.exp(rng.uniform(-0.9, 0.9, len(KINDS))), strict=True)}


def wished(seed: int, weights: dict[str, float], objects: int = 5, each: int = 3) -> sw.Scene:
    """A room in which each kind is asked for a few times, of objects at random: not all of it can be had."""
    rng = np.random.default_rng([seed, 2])
    things = [
        sw.SceneObject(id=f"box-{k}", category="cabinet", size=(*map(float, rng.uniform(0.4, 0.9, 2)), 0.6))
        for k in range(objects)
    ]
    relations = []
    for kind, params in KINDS.items():
        alone = kind in ("in_middle", "off_walls")
        for _ in range(each):
            a, b = (f"box-{k}" for k in rng.permutation(objects)[:2])
            target = None if alone else b
            relations.append(
                sw.Relation(type=kind, subject=a, target=target, params=params, hard=False, weight=weights[kind])
            )
    width, depth = map(float, rng.uniform(4.0, 6.0, 2))
    room = sw.Room(outline=((0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)), height=2.7)
    return sw.Scene(id=f"planted-{seed}", room=room, objects=things, relations=relations)


def arranged(given: sw.Scene, seed: int = 0, device: str = "cpu") -> sw.Scene:
    """The room at rest: a valid layout led downhill until it stays where it is."""
    solution = sw.refine(given, candidates=16, seed=seed, device=device, explain=False)
    for _ in range(4):
        solution = sw.refine(
            given, init=solution.poses, optimizer="lbfgs", steps=400, seed=seed, device=device, explain=False
        )
    best = int(np.lexsort([solution.energy, solution.status != 0])[0])
    return solution.scene(best)


def forgotten(given: sw.Scene) -> sw.Scene:
    """The room without the weights that it was arranged for."""
    plain = tuple(r.model_copy(update={"weight": 1.0}) for r in given.relations)
    return given.model_copy(update={"relations": plain})


def cosine(learned: dict[str, float], true: dict[str, float]) -> float:
    """Of two sets of weights."""
    a, b = (np.array([w.get(kind, 0.0) for kind in true]) for w in (learned, true))
    return float(a @ b / np.linalg.norm(a) / np.linalg.norm(b))
