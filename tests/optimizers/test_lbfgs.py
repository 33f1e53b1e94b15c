"""L-BFGS: the direction against a reference, the line search, what is remembered, and pushes."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

from sceneweaver.kernels.lbfgs import ACCEPTED, MEMORY, REFUSED, SLOTS, STUCK_BEST, TRIES, search_line
from sceneweaver.optimizers import Monitor
from sceneweaver.optimizers.launches import Launches
from sceneweaver.optimizers.lbfgs import one_step, workspace
from tests.kernels.harness import zoo
from tests.optimizers.batches import batch

ROOM, COUNT = "bedroom-small", 6
OBJECTS = zoo(ROOM).room.size


def two_loop(gradient: np.ndarray, steps: list[np.ndarray], gradient_changes: list[np.ndarray]) -> np.ndarray:
    """Minus the inverse Hessian times the gradient (Nocedal & Wright 2006, algorithm 7.4); oldest pairs first."""
    q, alphas = gradient.copy(), []
    for s, y in zip(steps[::-1], gradient_changes[::-1], strict=True):
        alphas.append(s @ q / (s @ y))
        q -= alphas[-1] * y
    if steps:
        q *= steps[-1] @ gradient_changes[-1] / (gradient_changes[-1] @ gradient_changes[-1])
    for s, y, alpha in zip(steps, gradient_changes, alphas[::-1], strict=True):
        q += (alpha - y @ q / (s @ y)) * s
    return -q


def remembered(work, candidate: int) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """The pairs of one candidate, oldest first, as float64 vectors."""
    count, head = (int(a.numpy()[candidate]) for a in (work.history.count, work.history.head))
    slots = [(head - count + k) % int(SLOTS) for k in range(count)]
    return tuple(
        [a.numpy()[slot, :, candidate].astype(np.float64).ravel() for slot in slots]
        for a in (work.history.steps, work.history.gradient_changes)
    )


def test_direction_is_that_of_the_reference(device):
    what = batch([ROOM], COUNT, device, 0.3)
    work, step = workspace(what), Launches(device)
    one_step(step, what, work, 0.1, 100)
    compared, longest = 0, 0
    for _ in range(30):
        step.play(Monitor(1))
        for c in np.flatnonzero(work.line.state.numpy() == ACCEPTED):
            steps, gradient_changes = remembered(work, c)
            gradient = work.line.gradient.numpy()[:, c].astype(np.float64).ravel()
            found = work.line.direction.numpy()[:, c].astype(np.float64).ravel()
            wanted = two_loop(gradient, steps, gradient_changes)
            assert np.linalg.norm(found - wanted) < 2e-3 * np.linalg.norm(wanted)
            assert all(s @ y > 0 for s, y in zip(steps, gradient_changes, strict=True))
            assert gradient @ found < 0
            compared, longest = compared + 1, max(longest, len(steps))
    assert compared > 40 and longest == MEMORY


@pytest.fixture
def searching(device):
    """One candidate of energy 1 half way along the direction (-1, 0, 0, 0) of its first object, slope 1."""
    what = batch([ROOM], 1, device, 0.1)
    work = workspace(what)
    vector = np.zeros((OBJECTS, 1, 4), dtype=np.float32)
    vector[0, 0, 0] = 1.0
    work.line.gradient.assign(vector)
    work.line.direction.assign(-vector)
    work.line.energy.assign([1.0])
    work.line.slope.assign([-1.0])
    work.line.step_length.assign([0.5])

    def after(energy: float, slope: float) -> SimpleNamespace:
        """What is decided when the trial has this energy and this slope along x."""
        share = np.zeros((OBJECTS, 1), dtype=np.float32)
        share[0] = energy
        work.measured.share.assign(share)
        work.measured.gradient.assign(vector * slope)
        wp.launch(search_line, 1, [what.problems, work.measured], [work.history, work.line], device=device)
        found = {
            name: getattr(work.line, name).numpy()[0] for name in ("energy", "step_length", "state", "tries", "slope")
        }
        return SimpleNamespace(**found, count=work.history.count.numpy()[0])

    return after


def test_a_lower_energy_is_accepted_and_remembered(searching):
    found = searching(0.6, 0.5)
    assert found.state == ACCEPTED and found.energy == pytest.approx(0.6)
    assert found.count == 1 and found.slope < 0


@pytest.mark.parametrize("slope", [1.0, 1.5])
def test_pairs_without_positive_curvature_are_left_out(searching, slope):
    found = searching(0.4, slope)
    assert found.state == ACCEPTED and found.count == 0


@pytest.mark.parametrize("energy", [1.0, 1.2, 5.0, 1e6, float("nan")])
def test_what_does_not_help_cuts_the_step(searching, energy):
    found = searching(energy, 0.5)
    assert found.state == REFUSED and found.energy == 1.0 and found.tries == 1
    assert 0.05 * 0.99 <= found.step_length <= 0.25 * 1.01


def test_the_parabola_says_by_how_much(searching):
    assert searching(1.25, 0.5).step_length == pytest.approx(0.5 * 0.5 / (2 * 0.75), rel=1e-5)


def test_when_nothing_helps_the_candidate_is_pushed_on(searching):
    for k in range(int(TRIES)):
        assert searching(2.0, 0.5).tries == k + 1
    found = searching(2.0, 0.5)
    assert found.state == STUCK_BEST and found.energy == np.inf
    assert searching(3.0, 0.5).state == ACCEPTED, "where the push led is taken as it is"


def test_a_solved_candidate_rests(searching):
    assert searching(0.0, 0.0).state == ACCEPTED
    found = searching(0.0, 0.0)
    assert found.state == REFUSED and found.step_length == 0.0
