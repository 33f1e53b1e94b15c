"""The energy of the zoo's rooms against the reference, and its gradient against its own differences."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.compile import compile_scene
from tests.kernels import compare
from tests.kernels.harness import (
    LARGE,
    ROOMS,
    USUAL,
    any_options,
    batch_of,
    energies,
    noisy,
    run_energy,
    scattered,
    zoo,
)
from tests.kernels.made import gallery
from tests.sizes import often


@pytest.mark.parametrize("name", often(ROOMS, USUAL))
def test_room(device, name):
    rng = np.random.default_rng(11)
    problem = zoo(name).room
    scales = (0.1,) if name in LARGE else (0.3, 0.1, 0.02, 0.003)
    few = 1 if name == "hall-300" else 2 if name in LARGE else 6
    layouts = [scattered(problem, rng) for _ in range(few)] + [noisy(problem, rng, s) for s in scales]
    anchors = [noisy(problem, rng, 0.3) for _ in layouts]
    options = [any_options(problem, rng) for _ in layouts]
    tally = compare.check(
        [problem], [0] * len(layouts), layouts, options, device, weights=compare.UNEVEN, anchors=anchors, name=name
    )
    assert tally.active == tally.compared  # the pull, at least


@pytest.mark.parametrize("name", ["bedroom-small", "living-dining-L", "gallery"])
def test_gradient_against_the_kernel_s_own_differences(device, name):
    """Central differences in float32 of the total energy, every coordinate of every object a candidate of its own."""
    rng = np.random.default_rng(12)
    problem = compile_scene(gallery()).room if name == "gallery" else zoo(name).room
    layout, options = scattered(problem, rng), any_options(problem, rng)
    n = problem.size
    unit = np.eye(4 * n).reshape(4 * n, n, 4)
    slopes = []
    for step in (1e-3, 2.5e-4):
        layouts = np.float32(np.concatenate([layout + step * unit, layout - step * unit]))
        found = energies(problem, layouts, device, options=[options] * len(layouts))
        up, down = found.total.reshape(2, 4 * n)
        moved = np.einsum("knc,knc->k", layouts[: 4 * n].astype(float) - layouts[4 * n :].astype(float), unit)
        slopes.append((up - down) / moved)
    gradient = run_energy(batch_of([problem], [0], [layout], device, [options])).gradient[0].ravel()
    smooth = np.abs(slopes[0] - slopes[1]) < 0.02 * np.abs(slopes[1]) + 0.02
    assert smooth.mean() > 0.9 and np.sum(np.abs(gradient[smooth]) > 0.1) > n
    np.testing.assert_allclose(gradient[smooth], slopes[1][smooth], rtol=0.02, atol=0.03)
