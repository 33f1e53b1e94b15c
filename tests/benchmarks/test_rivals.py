"""The rivals: the registry, and the NumPy one's arithmetic."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
import pytest

from benchmarks.judging import Judge
from benchmarks.rivals import RIVALS, Rival, base, batch_size, present, solve
from benchmarks.rivals.boxes import Boxes, Pairs, overlap_loss
from benchmarks.rivals.numpy_descent import Model
from benchmarks.rooms import ROOMS, load, witness
from benchmarks.settings import Settings
from benchmarks.starts import movable, noisy_poses, random_poses

PLANE = (0, 1, 3)


def _two_boxes(pose) -> float:
    zeros = np.zeros((2, 2))
    boxes = Boxes(np.array([0, 1]), zeros, np.array([[0.5, 0.5], [0.5, 0.5]]), zeros + (0, 1), np.zeros(2))
    poses = np.array([[(0.0, 0.0, 0.0), pose]])
    return float(overlap_loss(boxes, Pairs(boxes, np.array([[0, 1]])), poses, 0.0, np.zeros_like(poses))[0])


@pytest.mark.parametrize(
    ("pose", "depth"),
    [
        ((1.1, 0.0, 0.0), 0.0),
        ((0.9, 0.0, 0.0), 0.1),
        ((0.9, 0.95, 0.0), 0.05),
        ((1.2, 0.0, np.pi / 4), 0.5 + np.sqrt(0.5) - 1.2),
    ],
)
def test_depth_of_overlap(pose, depth):
    assert _two_boxes(pose) == pytest.approx(max(depth, 0.0) ** 2)


@pytest.mark.parametrize("name", ["bedroom", "living-dining-L"])
def test_gradient_of_overlap_and_bounds(name):
    scene = load(name)
    model = Model(scene)
    model.pulls = []  # those hold their targets still
    x = random_poses(scene, 2, 0)[:, model.floor][:, :, PLANE]
    _, gradient = model.loss(x)
    h = 1e-6
    for body in range(0, len(model.floor), 3):
        for k in range(3):
            step = np.zeros_like(x)
            step[:, body, k] = h
            slope = (model.loss(x + step)[0] - model.loss(x - step)[0]) / (2 * h)
            assert gradient[:, body, k] == pytest.approx(slope, abs=1e-6)


def test_pairs_that_are_left_out_do_not_touch():
    model = Model(load("restaurant-60"))
    x = random_poses(load("restaurant-60"), 2, 0)[:, model.floor][:, :, PLANE]
    everything, gradient = model.loss(x)
    model.look(x)
    assert len(model.active.pairs) < len(model.pairs.pairs)
    near, the_same = model.loss(x)
    assert near == pytest.approx(everything)
    assert the_same == pytest.approx(gradient)


@pytest.mark.parametrize("name", ROOMS)
def test_pulls_are_nearly_at_rest_at_the_witness(name):
    """They aim at the middle of the intervals, so that they pull a little on what just holds."""
    model = Model(load(name))
    x = witness(load(name))[None][:, movable(load(name))][:, :, PLANE]
    furthest = max(float(np.abs(pull(x)).max()) for _, _, pull in model.pulls)
    assert furthest < 0.45  # chairs are tucked under tables in witnesses, which boxes cannot be


def test_some_noisy_starts_are_solved():
    scene = load("bedroom-small")
    poses, seconds = solve(RIVALS["numpy descent"], scene, noisy_poses(scene, 8, 0), 0, "cpu")
    assert seconds > 0
    assert any(o.valid for o in Judge(1)(scene, poses))


def _rival(name: str, missing: str | None = None, shape: tuple[int, ...] | None = None) -> Rival:
    def run(scene, starts, seed, device):
        return np.full(shape or starts.shape, np.nan)

    return Rival(name, "does nothing.", run, lambda device: missing, lambda objects, device: 3)


def test_registry(monkeypatch):
    monkeypatch.setattr(base, "RIVALS", {})
    base.register(_rival("there"))
    base.register(_rival("gone", missing="torch is not installed"))
    notes: list[str] = []
    assert [r.name for r in present(Settings(), notes)] == ["there"]
    assert notes == ["Rival there: does nothing.", "Rival gone left out: torch is not installed"]
    assert present(Settings(rivals=()), []) == []


def test_rivals_prepare_outside_of_the_time():
    scene, seen = load("bedroom-small"), []
    starts = random_poses(scene, 2, 0)

    def prepare(scene, starts, device):
        seen.append((starts.shape, device))
        time.sleep(0.2)

    began = time.perf_counter()
    _, seconds = solve(replace(_rival("slow"), prepare=prepare), scene, starts, 0, "cpu")
    assert seen == [(starts.shape, "cpu")]
    assert seconds <= time.perf_counter() - began - 0.2


def test_batches_suit_the_rival_and_the_settings():
    rival = replace(_rival("big"), most=lambda objects, device: 8192 if device == "cuda:0" else 128)
    assert batch_size(rival, Settings(device="cuda:0"), 10) == 8192
    assert batch_size(rival, Settings(device="cpu"), 10) == 128
    assert batch_size(rival, Settings(device="cpu", quick=True), 10) == 16
    assert batch_size(rival, Settings(device="cpu", most=5), 10) == 5


def test_what_a_rival_returns_is_checked():
    scene = load("bedroom-small")
    starts = random_poses(scene, 2, 0)
    poses, _ = solve(_rival("nan"), scene, starts, 0, "cpu")
    np.testing.assert_array_equal(poses, np.zeros_like(starts))
    assert not any(opinion.valid for opinion in Judge(1)(scene, poses))
    with pytest.raises(ValueError, match="rival short returned poses of shape"):
        solve(_rival("short", shape=(1, 2)), scene, starts, 0, "cpu")
