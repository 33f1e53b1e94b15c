"""Parallel tempering: replicas of each candidate at several temperatures, between two descents.

The first descent brings the replicas near minima, where small steps are accepted; the second polishes the best.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace

import numpy as np
import warp as wp

from sceneweaver.kernels.descent import ADAM
from sceneweaver.kernels.tempering import FIRST, Ladder, accept, copy_replicas, exchange, make_moves

from .base import Blocks, Checkpoint, Monitor, Start, register_blocks, to_the_end
from .batch import Batch, new_state
from .descent import (
    MEASURED,
    MEASURED_ON_GPU,
    Settings,
    add_choice,
    add_measure,
    descend,
    finish,
    new_gradients,
    outcome,
    threads,
)
from .launches import Launches, blocks_of
from .starts import draw_starts

STEPS = 1200
REPLICAS = 3
COLDEST = 0.005  # [m], in units of the energy
HOTTEST_GIVEN, HOTTEST = 0.03, 0.2  # the same, from given poses and from drawn ones
JUMPS_GIVEN, JUMPS = 0.2, 0.7  # share of moves that are jumps
STEP_SIZE = 0.015  # [m] a Langevin step takes for a gradient of one, to begin with
LEAD = 40  # steps of the descent at the beginning, at most a quarter of all
POLISH = 0.25  # share of the steps for the descent at the end
FIRST_DESCENT = Settings(rate=0.1, rate_end=0.005, noise=0.03, quiet=0.6)
LAST_DESCENT = Settings(rate=0.01, rate_end=0.0005, noise=0.0, quiet=1.0)
UNROLL = 10  # steps in one graph


def parts(steps: int) -> tuple[int, int, int]:
    """How many of the steps are first descent, tempering and last descent; replicas take the first two."""
    lead, polish = min(LEAD, steps // 4), int(POLISH * steps)
    return lead, steps - lead - polish, polish


def ladder_of(batch: Batch, hottest: float) -> Ladder:
    """A ladder for a batch, temperatures in equal ratios, before anything was tried."""
    ladder, rows, objects, device = Ladder(), batch.size * REPLICAS, max(batch.objects, 1), batch.device
    ladder.temperature = wp.array(np.geomspace(COLDEST, hottest, REPLICAS), dtype=wp.float32, device=device)
    ladder.step_size = wp.full(rows, STEP_SIZE, dtype=wp.float32, device=device)
    ladder.energy, ladder.total = (wp.full(rows, np.inf, dtype=wp.float32, device=device) for _ in range(2))
    ladder.move = wp.full(rows, int(FIRST), dtype=wp.int32, device=device)
    for name in ("rung", "accepted", "better"):
        setattr(ladder, name, wp.zeros(rows, dtype=wp.int32, device=device))
    for name in ("gradient", "step"):
        setattr(ladder, name, wp.zeros((objects, rows), dtype=wp.vec4, device=device))
    ladder.lowest = wp.full(batch.size, np.inf, dtype=wp.float32, device=device)
    ladder.best = wp.zeros_like(batch.state.poses)
    ladder.clock = wp.zeros(batch.size, dtype=wp.int32, device=device)
    return ladder


def replicate(batch: Batch, rung: wp.array) -> Batch:
    """A batch in which every candidate has REPLICAS neighbouring rows."""
    rows = batch.size * REPLICAS
    many = replace(
        batch,
        problem=wp.zeros(rows, dtype=wp.int32, device=batch.device),
        state=new_state(rows, batch.objects, batch.relations, batch.device),
    )
    wp.launch(
        copy_replicas,
        (rows, batch.objects),
        [REPLICAS, batch.problem, batch.state],
        [many.problem, many.state, rung],
        device=batch.device,
    )
    return many


def temper(
    batch: Batch, start: Start, lead: int, steps: int, monitor: Monitor, whole: bool
) -> Generator[Checkpoint, None, int]:
    """Run the replicas: every candidate ends at the best layout that one of them passed; energies measured of each.

    ``lead`` steps of descent come before the ``steps`` of tempering.
    """
    given = start == "given"
    ladder = ladder_of(batch, HOTTEST_GIVEN if given else HOTTEST)
    rows = replicate(batch, ladder.rung)
    draw_starts(rows, start)
    if lead:
        to_the_end(descend(rows, ADAM, FIRST_DESCENT.schedule(lead), monitor))
    state, proposal = rows.state, rows.scratch()
    proposal.anchors = state.anchors
    wp.copy(proposal.poses, state.poses)
    wp.copy(proposal.turns, state.turns)
    measured, problems, block = new_gradients(rows), rows.problems, Launches(batch.device, UNROLL)
    add_choice(block, rows, proposal, [proposal.options, proposal.options])
    add_measure(block, rows, proposal, measured)
    jumps = JUMPS_GIVEN if given else JUMPS
    block.add(accept, rows.size, [problems, REPLICAS, jumps, state, measured], [ladder])
    block.add(exchange, batch.size, [REPLICAS, state], [ladder])
    inputs = [problems, REPLICAS, measured]
    block.add(make_moves, threads(rows, rows.objects), inputs, [ladder, state, proposal])
    nothing = wp.full(batch.size, np.inf, dtype=wp.float32, device=batch.device)

    def best() -> wp.array:
        finish(batch, batch.state.poses, nothing, ladder.best, ladder.lowest)
        return batch.state.poses

    energies = REPLICAS * (lead + 2 if lead else 0)
    for done in blocks_of(steps + 1, UNROLL, whole, block, monitor):  # the first step only measures the start
        yield Checkpoint(best, energies + REPLICAS * done)
    best()
    return energies + REPLICAS * (steps + 1)


@register_blocks("tempering", (*MEASURED, "tempering", "descent"), (*MEASURED_ON_GPU, "tempering", "descent"))
def tempering_blocks(batch: Batch, start: Start, budget: int | None, monitor: Monitor, whole: bool) -> Blocks:
    """Refine every candidate by ``budget`` steps (default 1200); it ends at the lowest energy of any replica.

    A step measures REPLICAS energies of a candidate, one of the last descent a single one.
    """
    lead, steps, polish = parts(budget or STEPS)
    energies = yield from temper(batch, start, lead, steps, monitor, whole)
    total = yield from descend(batch, ADAM, LAST_DESCENT.schedule(polish), monitor, whole, energies)
    return outcome(batch, total, monitor)
