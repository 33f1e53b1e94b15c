"""Gradients by groups of terms, as on a GPU, against all terms in one kernel; and which groups a batch needs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels import tables as k
from sceneweaver.kernels.evaluator import EVERY_KIND, TERMS
from sceneweaver.kernels.gradients import WHOLE
from sceneweaver.kernels.gradients_gpu import GROUPS
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.pack import weights
from sceneweaver.optimizers import load_poses
from sceneweaver.optimizers.batch import Batch
from sceneweaver.optimizers.descent import by_object, new_gradients, threads
from tests.kernels.harness import ROOMS, batch_of, best_options
from tests.layout.made import relation, scene, thing
from tests.optimizers.batches import batch

ROUND, HALL = "dining-round", "living-dining-L"  # round tables; a room whose outside is no box


def gradients(what: Batch, kernels: list, lowest: float = np.inf) -> tuple[np.ndarray, np.ndarray]:
    """Shares and gradients, [object, candidate], that some kernels add up to, from -1 where none writes."""
    each = new_gradients(what, -1.0)
    rest = wp.full(what.size, lowest, dtype=wp.float32, device=what.device)
    inputs = [what.problems, by_object(what.state), rest]
    for kernel in kernels:
        wp.launch(kernel, threads(what, what.objects), inputs, [each], device=what.device)
    return each.share.numpy(), each.gradient.numpy()


def needed(what: Batch) -> list:
    """The kernels of the groups that a batch needs."""
    return [kernel for kinds, kernel in GROUPS if kinds & what.terms]


@pytest.mark.parametrize("name", ROOMS)
def test_groups_add_up(device, name):
    what = replace(batch([name], 6, device), weights=weights(pull=0.5))
    share, slope = gradients(what, needed(what))
    whole, gradient = gradients(what, [WHOLE.kernel])
    np.testing.assert_allclose(share, whole, atol=1e-5, rtol=1e-5)
    np.testing.assert_allclose(slope, gradient, atol=2e-5, rtol=1e-4)
    assert whole.max() > 0.1 and (whole >= 0).all()


def test_every_kind_of_terms_is_in_one_group():
    kinds = [kinds for kinds, _ in GROUPS]
    assert sum(kinds) == EVERY_KIND and np.bitwise_or.reduce(kinds) == EVERY_KIND
    assert sum(term.kind for term in TERMS) == EVERY_KIND == WHOLE.kinds
    assert kinds[0] & k.BOUNDS  # the one that sets what the others add to
    assert np.bitwise_or.reduce([batch([name], 1, "cpu").terms for name in ROOMS]) == EVERY_KIND


@pytest.mark.parametrize(("name", "kind"), [(ROUND, k.POLYGONS), (ROUND, k.RELATIONS), (HALL, k.POLYGONS)])
def test_a_group_that_is_needed_changes_something(device, name, kind):
    what = batch([name], 20, device)
    assert what.terms & kind
    share, _ = gradients(what, needed(what))
    without, _ = gradients(what, [kernel for kinds, kernel in GROUPS if not kinds & kind])
    assert np.abs(share - without).max() > 0.01


def test_a_room_of_boxes_needs_little(device):
    two = scene([thing("a"), thing("b")], [relation("near", "a", "b")])
    problem = compile_scene(two).room
    what = batch_of([problem], np.zeros(1, dtype=int), [problem.home], device)
    assert what.terms == k.BOUNDS | k.PULL | k.BOXES | k.DISTANCES


def test_batches_of_several_rooms(device):
    """Kinds of terms that only one of the rooms has leave the others as they are, to the bit."""
    few = batch(["bedroom-tight"], 5, device)
    mixed = batch([ROUND, "bedroom-tight"], 5, device)
    assert mixed.terms != few.terms
    poses = mixed.state.poses.numpy()
    poses[5:, : few.objects] = few.state.poses.numpy()
    load_poses(mixed, poses)
    best_options(mixed)
    best_options(few)
    for one, other in zip(gradients(mixed, needed(mixed)), gradients(few, needed(few)), strict=True):
        np.testing.assert_array_equal(one[: few.objects, 5:], other)


def test_no_number_is_far_and_flat(device):
    what = batch(["bedroom-small"], 2, device)
    poses = what.state.poses.numpy()
    poses[0, 3, 1] = np.nan
    what.state.poses.assign(poses)
    share, slope = gradients(what, needed(what))
    whole, gradient = gradients(what, [WHOLE.kernel])
    assert share[3, 0] == whole[3, 0] >= 1e6 and not slope[3, 0].any() and not gradient[3, 0].any()
    assert np.isfinite(share).all() and np.isfinite(slope[:, 1]).all()


def test_at_rest_nothing_is_measured(device):
    what = batch(["bedroom-small"], 3, device)
    for kernels in (needed(what), [WHOLE.kernel]):
        share, slope = gradients(what, kernels, lowest=0.0)
        assert (share == -1).all() and (slope == -1).all()
