"""Markov chains over valid layouts: from one that is valid to others, for far less than a search from the start.

A step moves objects picked at random, mends what that broke, and keeps the outcome if it is valid; else the chain
stays where it was. Chains do not know of each other: neither their number nor the threads change what one does.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import advance_clock, retire, set_turns
from sceneweaver.kernels.chains import ChainState, begin_step, end_step
from sceneweaver.kernels.plan import Plan

from .batch import Batch
from .launches import Launches, repeatable
from .run import cpu_threads, pieces
from .search import CPU, GPU, Effort, Rounds, extend_state, plan_for
from .starts import new_run
from .verdict import add_verdict, new_device_verdict

MODULES = ("chains", "bookkeeping", "verdict")
MIXING = 1.0  # moves of each movable object in a step; half of it costs less, and leaves steps more alike
ROUNDS = 2  # in which what a step broke is mended
TEMPERATURE = 0.002  # [m]


def mixing_plan(effort: Effort) -> Plan:
    """The plan of a step."""
    plan = plan_for(effort, "given", 1)
    plan.mixing, plan.anchored_attempts, plan.temperature = MIXING, 0, TEMPERATURE
    plan.first_steps = plan.steps = plan.rounds = ROUNDS
    plan.moves = 1
    return plan


class _Part:
    """Chains that one thread, or one GPU, takes through a step."""

    def __init__(self, batch: Batch, plan: Plan, seeds: np.ndarray) -> None:
        self.batch, device = batch, batch.device
        self.state, self.run, self.verdict = extend_state(batch), new_run(batch), new_device_verdict(batch)
        chains = self.chains = ChainState()
        chains.seed = wp.array(seeds, dtype=wp.uint32, device=device)
        chains.open = wp.full(batch.size, 1, dtype=wp.int32, device=device)
        chains.fresh = wp.zeros(batch.size, dtype=wp.int32, device=device)
        chains.step = wp.zeros(1, dtype=wp.int32, device=device)
        chains.last = wp.clone(batch.state.poses)
        self.block = block = Launches(device)
        block.add(begin_step, batch.size, [chains], [self.state, self.run])
        for _ in range(plan.rounds):
            Rounds(batch, self.state, plan, self.run, block)
            block.add(set_turns, self.state.poses.shape, [self.state.poses], [self.state.turns])
            add_verdict(block, batch, self.verdict, self.run.active)
            block.add(advance_clock, 1, [], [self.run])
            block.add(retire, batch.size, [plan, 0.0, self.verdict], [self.run])
        block.add(end_step, batch.size, [batch.problems, self.verdict], [self.state, chains])
        self.step = repeatable(device, block)


class Step(NamedTuple):
    """What a step has led to.

    ``fresh`` [B] says where there is another valid layout, ``poses`` [B, N, 4] are all layouts, ``energy`` [B] is
    theirs, and ``holds`` [B, R] says which relations hold.
    """

    fresh: np.ndarray
    poses: np.ndarray
    energy: np.ndarray
    holds: np.ndarray


def _results(part: _Part) -> tuple[wp.array, ...]:
    return part.chains.fresh, part.batch.state.poses, part.run.total, part.verdict.holds


class Chains:
    """Chains that begin at the poses of a batch, which are valid layouts."""

    def __init__(self, batch: Batch, seeds: np.ndarray) -> None:
        """``seeds`` [B] uint32 are what all draws of each chain follow from."""
        self.batch = batch
        plan = mixing_plan(CPU if batch.device == "cpu" else GPU)
        parts, first = [], 0
        with wp.ScopedDevice(batch.device):
            for part in pieces(batch):
                parts.append(_Part(part, plan, seeds[first : first + part.size]))
                first += part.size
        self._parts, self._host = parts, []
        if batch.device != "cpu":
            found = _results(parts[0])
            self._host = [wp.empty(a.shape, dtype=a.dtype, device="cpu", pinned=True) for a in found]

    def step(self) -> None:
        """Take all open chains one step on; on a GPU it goes on after the return."""
        with wp.ScopedDevice(self.batch.device):
            if len(self._parts) == 1:
                self._parts[0].step()
                return
            with ThreadPoolExecutor(cpu_threads()) as pool:
                list(pool.map(lambda part: part.step(), self._parts))

    def read(self) -> Step:
        """What the last step has led to; arrays that no later step writes to, but the next call of `read` may."""
        if self.batch.device == "cpu":
            parts = self._parts
            return Step(
                np.concatenate([part.chains.fresh.numpy() for part in parts]) != 0,
                self.batch.state.poses.numpy().copy(),
                np.concatenate([part.run.total.numpy() for part in parts]),
                np.concatenate([part.verdict.holds.numpy() for part in parts]),
            )
        (part,) = self._parts
        for host, found in zip(self._host, _results(part), strict=True):
            wp.copy(host, found)
        wp.synchronize_device(self.batch.device)
        fresh, poses, energy, holds = (host.numpy() for host in self._host)
        return Step(fresh != 0, poses, energy, holds)

    def close(self, done: np.ndarray) -> None:
        """Leave the chains [B] where they are from now on."""
        first = 0
        for part in self._parts:
            part.chains.open.assign((~done[first : first + part.batch.size]).astype(np.int32))
            first += part.batch.size
