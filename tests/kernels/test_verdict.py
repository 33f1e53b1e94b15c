"""The verdict kernels against the reference's own predicates."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.compile import LayoutProblem, compile_scene
from sceneweaver.scene.catalogue import BUILT_IN
from tests.kernels.harness import LARGE, ROOMS, USUAL, noisy, scattered, verdict, zoo
from tests.kernels.made import gallery, related
from tests.kernels.predicates import BROKEN, VALID, object_margins, relation_margins, status
from tests.sizes import often, sizes

NEAR = 2e-5  # [m, rad] so near to a threshold, float32 may decide either way
LEFT_OUT = 0.03


def agree(problem: LayoutProblem, layouts: list[np.ndarray], device: str) -> np.ndarray:
    """Assert that kernels and predicates agree but near thresholds; gives [status, count] of the kernels."""
    found = verdict(problem, np.array(layouts), device)
    n, r = problem.size, len(problem.relations)
    unsure = 0
    for c, layout in enumerate(layouts):
        objects, relations = object_margins(problem, layout), relation_margins(problem, layout)
        sure_o, sure_r = np.abs(objects) > NEAR, np.abs(relations) > NEAR
        fault, holds = found.fault[c, :n], found.holds[c, :r]
        np.testing.assert_array_equal(fault[sure_o], np.where(objects < 0, BROKEN, VALID)[sure_o], f"candidate {c}")
        np.testing.assert_array_equal(holds[sure_r], (relations >= 0)[sure_r], f"candidate {c}")
        unsure += int(np.sum(~sure_o) + np.sum(~sure_r))
        if sure_o.all() and sure_r.all():
            assert found.status[c] == status(problem, objects, relations), f"candidate {c}"
    assert unsure <= LEFT_OUT * len(layouts) * (n + r)
    return np.bincount(found.status, minlength=4)


@pytest.mark.parametrize("name", often(ROOMS, USUAL))
def test_room(device, name):
    rng = np.random.default_rng(21)
    problem = zoo(name).room
    scales = (0.0,) if name == "hall-300" else (0.0, 0.001, 0.01) if name in LARGE else (0, 3e-4, 1e-3, 0.05)
    layouts = [noisy(problem, rng, s, rigid) for s in scales for rigid in ((True,) if s == 0 else (True, False))]
    if name not in LARGE:
        layouts += [scattered(problem, rng) for _ in range(4)]
    counts = agree(problem, layouts, device)
    assert counts[0] >= 1, "the zoo's own layouts are valid"
    assert counts[1] >= 1 or name == "hall-300"


@sizes("count", 3, 10)
@pytest.mark.parametrize("kind", sorted(BUILT_IN))
def test_relation(device, kind, count):
    rng = np.random.default_rng(22)
    problem = compile_scene(related(kind)).room
    layouts = [scattered(problem, rng) for _ in range(3 * count)]
    layouts += [noisy(problem, rng, 0.2) for _ in range(count)]
    agree(problem, layouts, device)


def test_gallery_and_its_surfaces(device):
    rng = np.random.default_rng(23)
    compiled = compile_scene(gallery())
    for problem in (compiled.room, *(d.problem for d in compiled.domains)):
        agree(problem, [noisy(problem, rng, s) for s in (0.0, 0.01, 0.1) for _ in range(8)], device)
