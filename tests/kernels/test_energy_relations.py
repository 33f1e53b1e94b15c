"""Every relation type of the catalogue, in a scene made for it, at random poses under random options."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.scene.catalogue import BUILT_IN
from tests.kernels import compare
from tests.kernels.harness import any_options, noisy, scattered
from tests.kernels.made import gallery, related
from tests.sizes import sizes


def layouts_of(problem: LayoutProblem, rng: np.random.Generator, count: int) -> list[np.ndarray]:
    half = count // 2
    return [scattered(problem, rng) for _ in range(half)] + [noisy(problem, rng, 0.15) for _ in range(count - half)]


@sizes("count", 8, 24)
@pytest.mark.parametrize("kind", sorted(BUILT_IN))
def test_relation(device, kind, count):
    rng = np.random.default_rng(5)
    problem = compile_scene(related(kind)).room
    layouts = layouts_of(problem, rng, count)
    options = [any_options(problem, rng) for _ in layouts]
    alone = {"collision": 0.0, "bounds": 0.0, "zone": 0.0, "opening": 0.0, "relation": 1.2}
    tally = compare.check([problem], [0] * len(layouts), layouts, options, device, weights=alone, name=kind)
    # on_floor, on_top and inside hold by construction; what hangs has its mounting
    assert tally.active > 0.4 * count or kind in ("on_floor", "on_top", "inside")


@pytest.mark.parametrize("kind", ["front_against", "above", "around", "inside"])
def test_relation_among_the_other_terms(device, kind):
    rng = np.random.default_rng(6)
    problem = compile_scene(related(kind)).room
    layouts = layouts_of(problem, rng, 16)
    anchors = [noisy(problem, rng, 0.3) for _ in layouts]
    options = [any_options(problem, rng) for _ in layouts]
    weights = compare.UNEVEN
    tally = compare.check([problem], [0] * 16, layouts, options, device, weights=weights, anchors=anchors, name=kind)
    assert tally.active > 16


def test_everything_at_once(device):
    rng = np.random.default_rng(8)
    problem = compile_scene(gallery()).room
    layouts = layouts_of(problem, rng, 12)
    anchors = [noisy(problem, rng, 0.3) for _ in layouts]
    options = [any_options(problem, rng) for _ in layouts]
    weights = compare.UNEVEN
    compare.check([problem], [0] * 12, layouts, options, device, weights=weights, anchors=anchors, name="gallery")


def test_surfaces(device):
    """The problems of support surfaces: a polygon for a room, the carrier's parts as its walls."""
    rng = np.random.default_rng(9)
    for domain in compile_scene(gallery()).domains:
        layouts = [noisy(domain.problem, rng, 0.1) for _ in range(20)]
        options = [any_options(domain.problem, rng) for _ in layouts]
        compare.check([domain.problem], [0] * 20, layouts, options, device, weights=compare.UNEVEN)
