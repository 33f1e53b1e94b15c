"""Rounds of the search for plans on one device: kernels, pieces of the batch in threads, time limits."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.io import InputError
from sceneweaver.kernels import load, plan_tables, variants_of
from sceneweaver.kernels.plan_cuts import solve_cuts
from sceneweaver.kernels.plan_search import search_plans
from sceneweaver.kernels.plan_tables import STATE, PlanState
from sceneweaver.kernels.plan_verdict import judge_cells, place_cells
from sceneweaver.kernels.streams import streams
from sceneweaver.runtime.compiling import Variant, start_warp
from sceneweaver.runtime.threads import cores, map_threads

from .solve_problem import CompiledPlan

MODULES = ("plan_search", "plan_cuts", "plan_verdict")
MOVES, LEAST_MOVES, MORE = 25, 800, 900
"""Moves of a round for the square of a storey's number of rooms, at least in all, and after a plan is valid."""
HOT, COLD = 4.0, 0.25
"""Temperatures at the ends of a round; a hard violation of 1 m is 10."""
STEPS = 12
"""Of the cuts' least squares."""
PIECE = 64
"""Candidates that a thread on a CPU takes at a time."""
BLOCK = 64
"""Threads of a block on a GPU."""


def kernel_modules() -> list[Variant]:
    """The modules of floor plans, to be compiled ahead."""
    return [variant for name in MODULES for variant in variants_of(name)]


def pick_device(device: str) -> str:
    """The Warp device of a name: "auto" is the first GPU, else the CPU.

    Raises:
        InputError: no such device.
    """
    start_warp()
    if device == "auto":
        return "cuda:0" if wp.is_cuda_available() else "cpu"
    known = ["cpu", *(f"cuda:{k}" for k in range(wp.get_cuda_device_count()))]
    name = "cuda:0" if device == "cuda" else device
    if name not in known:
        raise InputError(f'device: "{device}" is not there; give auto or one of {", ".join(known)}')
    return name


def new_state(candidates: int, device: str) -> Any:
    """A state of zeros, without any cell."""
    counts = {
        "candidate": candidates,
        "code": plan_tables.MAX_CODE,
        "cell": plan_tables.MAX_CELLS,
        "door": plan_tables.MAX_DOORS,
        "window": plan_tables.MAX_WINDOWS,
        "rule": plan_tables.RULE_COUNT,
    }
    state = PlanState()
    for table in STATE:
        shape = tuple(counts.get(name) or int(name) for name in table.shape)
        setattr(state, table.name, wp.zeros(shape, dtype=table.dtype, device=device))
    state.storey.fill_(-1)
    state.owner.fill_(-1)
    return state


def part_of(state: Any, first: int, last: int) -> Any:
    """Some candidates of a state, in the same memory."""
    part = PlanState()
    for table in STATE:
        setattr(part, table.name, getattr(state, table.name)[first:last])
    return part


def run_rounds(
    plan: CompiledPlan, candidates: int, seed: int, rounds: int, moves: int, device: str, end: float
) -> tuple[dict[str, np.ndarray], bool]:
    """Search all candidates for so many rounds at most, or until ``time.monotonic()`` passes ``end``.

    Returns:
        Arrays by name of `kernels.plan_tables.STATE`, and whether time was up before the last round's end.
    """
    load(device, *MODULES)
    problem = plan.on_device(device)
    state = new_state(candidates, device)
    state.rng.assign(streams(seed, np.arange(candidates)))

    def one_round(part: Any, active: np.ndarray) -> None:
        which = wp.array(active, dtype=wp.int32, device=device)
        options = {"dim": len(active), "device": device, "block_dim": BLOCK}
        wp.launch(search_plans, inputs=[problem.ref, moves, MORE, HOT, COLD, which], outputs=[part], **options)
        wp.launch(solve_cuts, inputs=[problem.ref, STEPS, which], outputs=[part], **options)
        wp.launch(place_cells, inputs=[problem.ref, which], outputs=[part], **options)
        wp.launch(judge_cells, inputs=[problem.ref, which], outputs=[part], **options)

    def work(first: int) -> bool:
        """All rounds of a piece, whether time was up."""
        part = part_of(state, first, min(first + piece, candidates))
        active = np.arange(len(part.status))
        for _ in range(rounds):
            if time.monotonic() > end:
                return True
            one_round(part, active)
            active = np.flatnonzero(part.status.numpy() == 0)  # those that are done take no threads
            if not len(active):
                break
        return False

    piece = PIECE if device == "cpu" else candidates
    timed_out = any(map_threads(work, range(0, candidates, piece), cores() if device == "cpu" else 1))
    return {table.name: getattr(state, table.name).numpy() for table in STATE}, timed_out


def judge_rectangles(plan: CompiledPlan, cells: np.ndarray, device: str = "cpu") -> dict[str, np.ndarray]:
    """Doors, windows, violations and status of plans given by one rectangle a room, in the frame with number 0.

    Args:
        plan: the problem.
        cells: [B, rooms, 4] int, clear floor of each room x0, y0, x1, y1 [mm]; stairwells are those of the frame.
        device: a Warp device.

    Returns:
        Arrays by name of `kernels.plan_tables.STATE`.
    """
    load(device, "plan_verdict")
    state = new_state(len(cells), device)
    given = {name: getattr(state, name).numpy() for name in ("cells", "storey", "owner")}
    for room, spec in enumerate(plan.programme.rooms):
        if plan.arrays["room_storeys"][room]:
            given["cells"][:, room] = cells[:, room]
            given["storey"][:, room] = spec.storey or 0
            given["owner"][:, room] = room
    for k, (rect, (room, storey, _doors)) in enumerate(
        zip(plan.arrays["fixed"], plan.arrays["fixed_room"], strict=True)
    ):
        if k < plan.arrays["fixed_start"][1]:
            at = plan.numbers["cells"] + k
            given["cells"][:, at], given["storey"][:, at], given["owner"][:, at] = rect, storey, room
    for name, values in given.items():
        getattr(state, name).assign(values)
    active = wp.array(np.arange(len(cells)), dtype=wp.int32, device=device)
    problem = plan.on_device(device)
    inputs = [problem.ref, active]
    wp.launch(judge_cells, len(cells), inputs, [state], device=device, block_dim=BLOCK)
    return {table.name: getattr(state, table.name).numpy() for table in STATE}
