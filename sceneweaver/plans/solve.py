"""Thousands of floor plans at once for a programme in an envelope."""

from __future__ import annotations

import math
import time

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.messages import is_number, show
from sceneweaver.kernels.plan_tables import CUT_X

from .envelope import Envelope
from .profile import Profile
from .programme import Programme
from .solve_problem import compile_plan
from .solve_run import LEAST_MOVES, MOVES, pick_device, run_rounds
from .solve_solution import PlanSolution

MAX_CANDIDATES = 1 << 20


def solve_plans(
    programme: Programme,
    envelope: Envelope,
    *,
    candidates: int = 4096,
    seed: int = 0,
    profile: Profile | str = "base",
    device: str = "auto",
    time_limit: float | None = None,
    rounds: int = 16,
    moves: int | None = None,
) -> PlanSolution:
    """Plan a programme in an envelope, many times at once.

    Each candidate is a forest of slicing trees that is annealed until its plan keeps all hard rules of the profile and
    all hard adjacencies of the programme; candidates that fail begin anew, up to ``rounds`` times. What is called valid
    was verified in whole millimetres, and `check_plan` calls it valid as well. Equal seeds give equal plans on devices
    of one kind, unless time ran out.

    Args:
        programme: the rooms; those without a storey get one, and stairs are added (`Programme.with_storeys`).
        envelope: what they have to fit into.
        candidates: how many plans to search for.
        seed: of the random numbers.
        profile: rules, or the name of those that ship with the library.
        device: "auto", "cpu", "cuda", "cuda:1".
        time_limit: seconds after which no further round begins; None: no limit.
        rounds: attempts of a candidate at most.
        moves: of an attempt; None: `MOVES` times the sum of the squares of the storeys' numbers of rooms.

    Raises:
        InputError: an argument is wrong, the programme is too large, or stairs find no place.

    Examples:
        >>> from sceneweaver.plans import Envelope, Programme, solve_plans
        >>> programme = Programme.from_graph(
        ...     {"hall": "entrance_hall", "living": ("living_kitchen", 26), "bed": "bedroom", "bath": "bathroom"},
        ...     [("hall", "living"), ("hall", "bed"), ("hall", "bath")],
        ... )
        >>> solution = solve_plans(programme, Envelope.rectangle(9, 7), candidates=16, device="cpu")
        >>> len(solution.valid) > 0, [room.id for room in solution.best.rooms]
        (True, ['hall', 'living', 'bed', 'bath'])
    """
    began = time.monotonic()
    if not isinstance(programme, Programme):
        raise InputError(f"programme is of type {type(programme).__name__}; give a Programme")
    if not isinstance(envelope, Envelope):
        raise InputError(f"envelope is of type {type(envelope).__name__}; give an Envelope")
    _require_whole("candidates", candidates, 1, MAX_CANDIDATES)
    _require_whole("seed", seed, 0, 2**63)
    _require_whole("rounds", rounds, 1, 1000)
    if moves is not None:
        _require_whole("moves", moves, 1, 1_000_000)
    if time_limit is not None and (not is_number(time_limit) or not time_limit > 0):
        raise InputError(f"time_limit is {show(time_limit)}; give seconds above 0, or None")
    plan = compile_plan(programme, envelope, profile)
    counts = np.bincount([room.storey or 0 for room in plan.programme.rooms])
    moves = max(LEAST_MOVES, MOVES * int((counts**2).sum())) if moves is None else moves
    end = math.inf if time_limit is None else began + time_limit
    found, timed_out = run_rounds(plan, candidates, seed, rounds, moves, pick_device(device), end)
    cells = slice(0, plan.cells)
    behind = np.arange(found["code"].shape[1])[None] >= found["length"][:, None]
    is_cut = (found["code"] >= int(CUT_X)) & ~behind
    return PlanSolution(
        plan=plan,
        status=found["status"].astype(np.int8),
        energy=found["energy"],
        frames=found["frame"],
        codes=np.where(behind, -1, found["code"]),
        cuts=np.where(is_cut, found["cut"], 0),
        cells=found["cells"][:, cells],
        storeys=found["storey"][:, cells],
        owners=found["owner"][:, cells],
        doors=found["doors"],
        windows=found["windows"],
        counts=found["count"],
        violations=found["violation"],
        rounds=found["rounds"],
        elapsed=time.monotonic() - began,
        timed_out=timed_out,
    )


def _require_whole(name: str, value: object, least: int, most: int) -> None:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise InputError(f"{name} is {show(value)}; give a whole number from {least} to {most}")
