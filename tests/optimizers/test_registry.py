"""The registry: what it names exists, and every way in knows the same optimisers."""

from __future__ import annotations

import importlib

import numpy as np
import pytest
import warp as wp
from typer.testing import CliRunner

import sceneweaver as sw
from sceneweaver.cli.app import app
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.engine import _modules
from sceneweaver.layout.job import Job
from sceneweaver.optimizers import OPTIMIZERS, Batch, Monitor, Optimizer, OptimizerResult, register
from sceneweaver.optimizers.batch import load_poses
from tests.layout.made import BOX, CUP, scene, table
from tests.optimizers.batches import STEPWISE


def test_all_are_entered():
    assert set(OPTIMIZERS) == {"search", "projection", *STEPWISE}


@pytest.mark.parametrize("name", OPTIMIZERS)
def test_modules_hold_kernels(name):
    assert OPTIMIZERS[name].modules_on("cpu") and isinstance(OPTIMIZERS[name], Optimizer)
    for module in {*OPTIMIZERS[name].modules_on("cpu"), *OPTIMIZERS[name].modules_on("cuda:0")}:
        found = importlib.import_module(f"sceneweaver.kernels.{module}")
        assert wp.get_module(found.__name__).kernels


def test_the_command_line_names_them():
    said = " ".join(CliRunner().invoke(app, ["refine", "--help"], env={"COLUMNS": "200"}).output.split())
    assert ", ".join(OPTIMIZERS) in said


def test_only_what_is_needed_is_compiled():
    plain, laden = compile_scene(scene([BOX], [])), compile_scene(scene([table(), CUP], []))
    here = [Job(plain, plain.room.home[None], "given", 0)]
    assert "search" not in _modules(here, "langevin", "cpu") and "descent" in _modules(here, "langevin", "cpu")
    assert "search" in _modules([Job(plain, plain.room.home[None], "random", 0)], "langevin", "cpu"), (
        "it draws the starts"
    )
    assert "search" in _modules([Job(laden, laden.room.home[None], "given", 0)], "adam", "cpu"), "it fills the surfaces"
    assert "search" not in _modules([Job(plain, plain.room.home[None], "random", 0)], "search", "cuda:0")


@pytest.mark.parametrize("optimizer", STEPWISE)
def test_through_the_front_door(optimizer):
    what = scene([table(), CUP, BOX], [])
    solution = sw.refine(what, candidates=8, init="random", optimizer=optimizer, steps=150, device="cpu")
    assert (solution.status == 0).any()
    assert sw.check(solution.best, walkable=False).valid


@pytest.mark.parametrize("optimizer", STEPWISE)
@pytest.mark.parametrize("steps", [0, -3, 2.5, True])
def test_budgets_that_are_none(optimizer, steps):
    with pytest.raises(sw.InputError, match="steps"):
        sw.refine(scene([BOX], []), optimizer=optimizer, steps=steps, device="cpu")


@pytest.mark.parametrize("optimizer", STEPWISE)
def test_rooms_without_anything_to_do(optimizer):
    assert sw.refine(scene([], []), candidates=2, optimizer=optimizer, device="cpu").best.objects == ()


class ShiftEast:
    """A toy: moves the free object of every candidate east, a centimetre a step, and has no kernels of its own."""

    def __init__(self) -> None:
        self.calls: list[tuple[int, str, int | None]] = []

    def modules_on(self, device: str) -> tuple[str, ...]:
        return ()

    def __call__(self, batch: Batch, start: str, budget: int | None, monitor: Monitor) -> OptimizerResult:
        self.calls.append((batch.size, start, budget))
        poses = batch.state.poses.numpy().copy()
        poses[:, 0, 0] += 0.01 * (budget or 1)
        load_poses(batch, poses)
        monitor.add(batch.size, batch.size, 0.0)
        return OptimizerResult(np.full(batch.size, 0.25, dtype=np.float32))


def test_an_optimiser_of_your_own():
    """One that keeps to the protocol, and a function; both through the front door."""
    toy = ShiftEast()
    assert isinstance(toy, Optimizer) and not isinstance(ShiftEast.__call__, Optimizer)
    what = scene([BOX], [])
    before = what.objects[0].pose.position
    try:
        assert register("east")(toy) is toy
        register("east-function", modules=())(lambda batch, start, budget, monitor: toy(batch, start, 2, monitor))
        for name, steps in (("east", 30), ("east-function", 2)):
            solution = sw.refine(what, candidates=3, init="current", optimizer=name, steps=30, device="cpu")
            assert solution.poses[:, 0, 0] == pytest.approx(before[0] + 0.01 * steps, abs=1e-5)
            assert solution.poses[:, 0, 1] == pytest.approx(before[1], abs=1e-5)
            assert solution.energy == pytest.approx(0.25)
        assert toy.calls[0][1:] == ("given", 30) and sum(size for size, _, _ in toy.calls) == 6
    finally:
        for name in ("east", "east-function"):
            OPTIMIZERS.pop(name, None)
