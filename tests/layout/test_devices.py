"""Candidates split over devices: the result of one."""

import time

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.layout.compile import compile_scene
from sceneweaver.layout.devices import pick_devices, solve_on
from sceneweaver.layout.engine import solve
from sceneweaver.layout.job import Job
from sceneweaver.optimizers import Monitor
from tests.layout.made import zoo


def solved(devices, candidates, start, keep=False):
    jobs = []
    for k, name in enumerate(("bedroom-small", "dining-round")):
        compiled = compile_scene(zoo(name))
        world = np.repeat(compiled.room.home[None], candidates, axis=0)
        if start == "given":
            world[..., :2] += np.random.default_rng(k).normal(scale=0.1, size=world[..., :2].shape)
        jobs.append(Job(compiled, world, start, 5, keep))
    began = time.monotonic()
    monitor = Monitor(2 * candidates)
    return solve_on(devices, jobs, lambda share, device: solve(share, "search", 2, device, monitor, began))


@pytest.mark.parametrize("candidates", [1, 7, 32])
@pytest.mark.parametrize("start", ["random", "given"])
def test_shares_add_up_to_the_whole(candidates, start):
    whole = solved(["cpu"], candidates, start)
    for parts in (["cpu", "cpu"], ["cpu", "cpu", "cpu"]):
        for one, many in zip(whole, solved(parts, candidates, start), strict=True):
            for name in ("poses", "status", "relations", "energy", "walkable"):
                assert np.array_equal(getattr(one, name), getattr(many, name), equal_nan=name == "walkable"), name
            assert one.best == many.best


def test_names_of_devices():
    assert pick_devices("cpu") == ["cpu"]
    for name in ("gpu", "cuda:x", "cuda:all:1", "", "cpu:0"):
        with pytest.raises(sw.InputError, match="device"):
            pick_devices(name)
