"""The order of candidates, and its beginning without the rest."""

from __future__ import annotations

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout import QualityTerm, joined
from sceneweaver.layout.solution import best_of, rank
from tests.layout.made import relation, scene, thing

A, B = thing("a"), thing("b")
SOFT = [relation("near", "a", "b"), relation("against_wall", "b")]
ROOM = scene([A, B], [r.model_copy(update={"hard": False}) for r in SOFT])


def outcomes(count: int, seed: int, values: int) -> dict[str, np.ndarray]:
    """Statuses, relations and energies of so many candidates; few values make many ties."""
    rng = np.random.default_rng(seed)
    energy = rng.integers(0, values, count).astype(np.float32)
    energy[rng.random(count) < 0.05] = np.nan
    return {
        "status": rng.integers(0, 3, count).astype(np.int8),
        "relations": rng.random((count, 2)) < 0.5,
        "energy": energy,
    }


@pytest.mark.parametrize("moving", [False, True])
@pytest.mark.parametrize("values", [1, 3, 1000])
@pytest.mark.parametrize("count", [1, 5, 8, 9, 400])
def test_the_best_few_are_those_that_rank_first(count, values, moving):
    for seed in range(5):
        found = outcomes(count, seed, values)
        moved = np.random.default_rng(seed).integers(0, values, count).astype(float) if moving else None
        expected = rank(ROOM, **found, moved=moved)[:8]
        np.testing.assert_array_equal(best_of(8, ROOM, **found, moved=moved), expected)


def test_what_ranks_first():
    """Status, then movement, blocked floor, soft relations and energy, in this order; no number comes last."""
    found = {
        "status": np.array([1, 0, 0, 0, 0, 0], dtype=np.int8),
        "relations": np.array([[1, 1], [0, 1], [1, 1], [1, 1], [1, 1], [1, 1]], dtype=bool),
        "energy": np.array([0.0, 0.0, np.nan, 2.0, 1.0, 0.0], dtype=np.float32),
    }
    walkable = np.array([1.0, 1.0, 1.0, 1.0, 1.0, np.nan])
    assert rank(ROOM, **found).tolist() == [5, 4, 3, 2, 1, 0]
    assert rank(ROOM, **found, walkable=walkable).tolist() == [4, 3, 2, 1, 5, 0]
    assert rank(ROOM, **found, moved=np.array([0.0, 0.0, 1.0, 1.0, 1.0, 1.0]))[0] == 1


@pytest.mark.parametrize("terms", [(), (QualityTerm("gap", ("a", "door"), low=4.5, span=4.0, weight=2.0),)])
def test_two_solutions_as_one(terms):
    first, second = (sw.refine(ROOM, candidates=4, seed=seed, quality=terms) for seed in (0, 1))
    both = joined(first, second)
    assert both.candidates == 8 and both.elapsed == pytest.approx(first.elapsed + second.elapsed)
    np.testing.assert_array_equal(both.poses, np.concatenate([first.poses, second.poses]))
    assert both.best in (first.best, second.best)
    assert (both.quality is None) == (not terms)
