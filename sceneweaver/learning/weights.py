"""Weights from arranged rooms: least squares of what is left of all forces, the hard rows free to push."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import nnls

from sceneweaver.layout import compile
from sceneweaver.scene import InputError, Relation, Scene

from .forces import Forces, forces_of, kinds_of

ROUNDS = 40  # in which hard rows and weights take turns
SETTLED = 1.0e-7  # change of the weights at which that ends
FIRM = 1.0e3  # of the condition that the weights add up to one
KINK = 0.05  # share of an object's forces: what is less at odds counts as squares, what is more by its length
DRAWS = 40  # of rooms, for the spread of the weights


@dataclass(frozen=True)
class LearnedWeights:
    """Weights for which rooms are at rest.

    Attributes:
        weights: by kind, with a mean of 1 over those that act: nothing tells how large all are together.
        spread: by kind, the standard deviation of its weight over draws of the rooms with replacement. A kind that is
            never at odds with another has a wide one: the rooms do not tell its weight.
        silent: kinds that pull at nothing in any room, so that nothing is learned of them.
        left: share of the forces that do not cancel out: 0 where the rooms minimise what was learned, 1 at most.
        rooms: how many rooms were looked at.

    Examples:
        >>> import sceneweaver as sw
        >>> learned = sw.LearnedWeights({"near": 1.5, "facing": 0.5}, {"near": 0.1, "facing": 0.2}, (), 0.1, 12)
        >>> scene = learned.applied(sw.Scene.example("bedroom"))
        >>> {r.weight for r in scene.relations if r.type == "near" and not r.hard} <= {1.5}
        True
    """

    weights: dict[str, float]
    spread: dict[str, float]
    silent: tuple[str, ...]
    left: float
    rooms: int

    def applied(self, scene: Scene, kind: Callable[[Relation], str | None] | None = None) -> Scene:
        """A scene whose soft relations have the learned weights; those of other kinds stay as they are."""
        named = kind or _by_type

        def weighed(relation: Relation) -> Relation:
            weight = None if relation.hard else self.weights.get(named(relation) or "")
            return relation if not weight else relation.model_copy(update={"weight": weight})

        return scene.model_copy(update={"relations": tuple(map(weighed, scene.relations))})


def learn_weights(
    scenes: Sequence[Scene],
    *,
    kind: Callable[[Relation], str | None] | None = None,
    reach: float = 0.01,
    seed: int = 0,
    device: str = "cpu",
) -> LearnedWeights:
    """Learn the weights of kinds of soft relations, and of terms, from rooms as someone arranged them.

    A room that is arranged well for some weights is at rest for them: no small move that the hard rows leave open makes
    it better. The weights are those, at least 0, for which the forces that are left in all rooms are least, with the
    hard rows that touch free to push; nothing is optimised and no room is laid out (inverse optimisation by the
    conditions of Karush, Kuhn and Tucker: Keshavarz, Wang and Boyd, "Imputing a convex objective function", 2011).
    Each object counts alike, and what is far off by its length, not its square: rooms of people are not optima.

    Args:
        scenes: arranged rooms, with the relations that speak of the arrangement; weights in them do not matter.
        kind: the kind of a soft relation, None where it does not count (default: its type). Kinds share a weight.
        reach: a hard row touches if a move of so many metres violates it.
        seed: of the draws for ``spread``.
        device: as for `refine`.

    Returns:
        The weights by kind, their spread, and what they leave over.

    Raises:
        InputError: no scene, no soft relation that counts, or a number out of range.

    Examples:
        >>> import sceneweaver as sw
        >>> room = sw.Scene.example("bedroom")
        >>> pull = {"type": "near", "subject": "armchair", "params": {"max": 0.0}, "hard": False}
        >>> pulls = [sw.Relation(target=target, **pull) for target in ("bed", "wardrobe")]
        >>> room = room.model_copy(update={"relations": (*room.relations, *pulls)})
        >>> rooms = [sw.refine(room, candidates=4, seed=seed, device="cpu").best for seed in range(3)]
        >>> learned = sw.learn_weights(rooms)
        >>> min(learned.weights.values()) >= 0
        True
    """
    if not scenes:
        raise InputError("scenes: there is none; give rooms as someone arranged them")
    if not 0 < reach <= 1:
        raise InputError(f"reach: {reach!r} is not a length above 0 and up to 1 m")
    named = kind or _by_type
    problems = [(scene, compile(scene, device=device)) for scene in scenes]
    kinds = sorted({name for scene, problem in problems for name in kinds_of(scene, problem, named) if name})
    if not kinds:
        raise InputError("scenes: no soft relation or term in them counts, so there is no weight to learn")
    rooms = [forces_of(scene, kinds, named, reach=reach, device=device) for scene in scenes]
    sizes = np.sqrt(sum((room.soft**2).sum(axis=0) for room in rooms))
    acting = sizes > 1.0e-6
    silent = tuple(name for name, acts in zip(kinds, acting, strict=True) if not acts)
    names = [name for name, acts in zip(kinds, acting, strict=True) if acts]
    if not names:
        raise InputError("scenes: all soft relations hold in them, so nothing tells how much each counts")
    scaled = [Forces(room.soft[:, acting] / sizes[acting], room.hard, room.objects) for room in rooms]
    shares, left = _at_rest(scaled)
    rng = np.random.default_rng(seed)
    draws = [_at_rest([scaled[i] for i in rng.integers(len(rooms), size=len(rooms))])[0] for _ in range(DRAWS)]
    weights = _mean_of_one(shares / sizes[acting])
    spread = np.std([_mean_of_one(draw / sizes[acting]) for draw in draws], axis=0)
    return LearnedWeights(
        dict(zip(names, map(float, weights), strict=True)),
        dict(zip(names, map(float, spread), strict=True)),
        silent,
        left,
        len(rooms),
    )


def _by_type(relation: Relation) -> str | None:
    return relation.type


def _mean_of_one(weights: np.ndarray) -> np.ndarray:
    return weights / max(float(weights.mean()), 1.0e-12)


def _at_rest(rooms: Sequence[Forces]) -> tuple[np.ndarray, float]:
    """The shares [K], at least 0 and one in all, for which least is left of the forces, and how much of them that is.

    Hard rows and shares take turns: each room's hard rows push as much as they can against the present shares, then the
    shares are those that are best with the rows free that push.
    """
    count = rooms[0].soft.shape[1]
    shares, before = np.full(count, 1.0 / count), np.zeros(count)
    counts = [_even(room, shares) for room in rooms]
    for _ in range(ROUNDS):
        square = np.zeros((count, count))
        for i, room in enumerate(rooms):
            scale = counts[i][:, None]
            pushes = _pushes(room.hard * scale, -(room.soft * scale) @ shares)
            counts[i] = _even(room, shares, room.soft @ shares + room.hard @ pushes)
            soft, rows = room.soft * counts[i][:, None], room.hard[:, pushes > 0] * counts[i][:, None]
            odd = soft - _projected(soft, rows)
            square += odd.T @ odd
        shares = _simplex(square)
        if np.abs(shares - before).max() < SETTLED:
            break
        before = shares
    return shares, _left_of(rooms, shares)


def _even(room: Forces, shares: np.ndarray, left: np.ndarray | None = None) -> np.ndarray:
    """How much each coordinate [D] counts: objects alike, and less those that are far from rest."""
    size = np.linalg.norm(room.soft, axis=1)
    counts = np.zeros(len(size))
    for obj in np.unique(room.objects):
        own = room.objects == obj
        acting = float(np.linalg.norm(size[own]))
        if acting > 1.0e-9:
            pulled = max(float(np.linalg.norm(np.abs(room.soft[own]) @ shares)), 1.0e-12)
            far = 0.0 if left is None else float(np.linalg.norm(left[own])) / pulled
            counts[own] = 1.0 / acting / np.sqrt(max(far, KINK))
    return counts + 1.0e-9


def _pushes(hard: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """How much each hard row [H] pushes, at least 0, to come nearest to a force [D]."""
    return nnls(hard, wanted)[0] if hard.shape[1] else np.zeros(0)


def _projected(soft: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """What of some forces [D, K] lies in the span of hard rows [D, A]."""
    return rows @ np.linalg.lstsq(rows, soft, rcond=None)[0] if rows.shape[1] else np.zeros_like(soft)


def _simplex(square: np.ndarray) -> np.ndarray:
    """The u >= 0 that add up to 1 with the least u' S u."""
    values, vectors = np.linalg.eigh(square / max(float(np.trace(square)), 1.0e-30))
    root = np.sqrt(np.maximum(values, 0.0))[:, None] * vectors.T
    table = np.vstack([root, np.full(len(square), FIRM)])
    shares = nnls(table, np.append(np.zeros(len(root)), FIRM))[0]
    return shares / shares.sum()


def _left_of(rooms: Sequence[Forces], shares: np.ndarray) -> float:
    """What is left of the forces, by length, over what there is of them."""
    left = total = 0.0
    for room in rooms:
        pulls = room.soft @ shares
        left += float(np.linalg.norm(pulls + room.hard @ _pushes(room.hard, -pulls)))
        total += float(np.linalg.norm(np.abs(room.soft) @ shares))
    return left / max(total, 1.0e-12)
