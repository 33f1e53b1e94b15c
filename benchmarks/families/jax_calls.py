"""What a call through JAX costs beside the direct call of the same kernels."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks import rooms
from benchmarks.judging import Judge
from benchmarks.machine import resolve
from benchmarks.results import Column, Result
from benchmarks.settings import Settings

USUAL = ("bedroom-small", "living", "office-20")
ROUNDS, QUICK_ROUNDS = 40, 3
CHAIN = 10  # calls of a round in a row
CLOSE = 1e-5

COLUMNS = (
    Column("room", "room"),
    Column("objects", "objects", "count"),
    Column("candidates", "candidates", "count"),
    Column("direct", "direct [ms]", "number"),
    Column("jax", "JAX [ms]", "number"),
    Column("ratio", "JAX / direct", "number"),
    Column("chain_direct", "direct, in a row [ms]", "number"),
    Column("chain_jax", "JAX, in a row [ms]", "number"),
    Column("chain_ratio", "in a row, JAX / direct", "number"),
    Column("energy_direct", "mean energy, direct [m]", "number"),
    Column("energy_jax", "mean energy, JAX [m]", "number"),
    Column("apart", "gradients apart", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Both in turn, round by round; medians."""
    about = (
        "One energy with its gradient of all candidates, by `problem.energy_and_grad` of a Warp array and by the "
        f"jitted function of `sceneweaver.jax`, in turn, {ROUNDS} rounds each, medians. Each call is waited for; or "
        f"{CHAIN} calls go in a row and the last is waited for. JAX / direct: the median over rounds of the ratio of "
        "times; below 1 the call through JAX is the quicker one. Gradients apart: the largest difference, by "
        "components larger than 1 in their share."
    )
    result = Result("jax", "JAX", about)
    table = result.add("calls", "Calls through JAX beside direct calls", COLUMNS)
    full = 256 if resolve(settings.device) == "cpu" else 4096
    for name in rooms.chosen(settings, USUAL):
        table.rows.append(_row(result, settings, name, settings.size(full, 8)))
    return result


def _row(result: Result, settings: Settings, name: str, count: int) -> dict[str, Any]:
    import jax
    import warp as wp

    import sceneweaver.jax as swj
    from sceneweaver.layout import compile

    problem = compile(rooms.load(name), device=resolve(settings.device))
    poses = swj.sample(problem, jax.random.key(settings.seed), count)
    given = wp.array(np.asarray(poses), dtype=wp.vec4, device=problem.device)
    measured = jax.jit(lambda x: swj.energy_and_grad(problem, x))

    def direct(calls: int) -> Any:
        found = [problem.energy_and_grad(given) for _ in range(calls)]
        wp.synchronize_device(problem.device)
        return found[-1]

    def through_jax(calls: int) -> Any:
        return jax.block_until_ready([measured(poses) for _ in range(calls)])[-1]

    (energy, slope), (energy_jax, slope_jax) = direct(1), through_jax(1)
    pairs = [(energy.numpy(), np.asarray(energy_jax)), (slope.numpy(), np.asarray(slope_jax))]
    apart = [float((np.abs(b - a) / np.maximum(np.abs(a), 1.0)).max()) for a, b in pairs]
    if max(apart) > CLOSE:
        result.failures.append(f"{name}: energies and gradients through JAX are {apart} away from the direct ones")
    rounds = QUICK_ROUNDS if settings.quick else ROUNDS
    one, other = _in_turn(direct, through_jax, 1, rounds)
    chain, other_chain = _in_turn(direct, through_jax, CHAIN, rounds)
    return {
        "room": name,
        "objects": problem.objects,
        "candidates": count,
        "direct": 1e3 * float(np.median(one)),
        "jax": 1e3 * float(np.median(other)),
        "ratio": float(np.median(other / one)),
        "chain_direct": 1e3 * float(np.median(chain)),
        "chain_jax": 1e3 * float(np.median(other_chain)),
        "chain_ratio": float(np.median(other_chain / chain)),
        "energy_direct": float(pairs[0][0].mean()),
        "energy_jax": float(pairs[0][1].mean()),
        "apart": apart[1],
    }


def _in_turn(first: Callable, second: Callable, calls: int, rounds: int) -> tuple[np.ndarray, np.ndarray]:
    """Seconds a call [rounds] of two functions of a number of calls, which take turns."""
    seconds = np.zeros((2, rounds + 2))
    for k in range(rounds + 2):
        for row, function in zip(seconds, (first, second), strict=True):
            began = time.perf_counter()
            function(calls)
            row[k] = (time.perf_counter() - began) / calls
    return seconds[0, 2:], seconds[1, 2:]
