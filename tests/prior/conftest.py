"""A small prior with random weights: what is tested of the network needs no training."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.prior import LayoutPrior
from sceneweaver.prior.network import Shape, first_weights
from sceneweaver.prior.vocabulary import Words
from sceneweaver.scene.catalogue import CATALOGUE

WORDS = Words.of(["bed", "chair", "desk", "nightstand", "wardrobe"], ["bedroom", "study"], CATALOGUE)


def small_weights(seed: int = 0, **sizes: int) -> tuple[dict[str, np.ndarray], Shape]:
    """Random weights, none of them 0, of a network with heads of 16 numbers."""
    usual = {"wide": 48, "deep": 2, "heads": 4, "slim": 64, "steps": 2, "eyes": 4}
    shape = Shape(len(WORDS.categories), len(WORDS.kinds), len(WORDS.relations), **(usual | sizes))
    rng = np.random.default_rng(seed)
    weights = first_weights(shape, seed)
    return {k: (v + 0.05 * rng.standard_normal(v.shape)).astype(np.float32) for k, v in weights.items()}, shape


@pytest.fixture(scope="session")
def small() -> LayoutPrior:
    weights, shape = small_weights()
    return LayoutPrior(weights, shape, WORDS, {"made": "for tests"})
