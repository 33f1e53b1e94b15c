"""What `solve_plans` returns."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sceneweaver.home import Home
from sceneweaver.io import InputError
from sceneweaver.kernels.plan_tables import RULES

from .check import check_plan
from .report import PlanReport
from .solve_home import home_of, outlines_of
from .solve_problem import CompiledPlan
from .solve_topology import neighbour_matrices, room_classes, topology_codes

COMPARED = 200
"""Topologies that the exact checker compares to choose a plan."""

UNITS = {
    "area": "m2 of floor", "side": "m of width", "aspect": "m of length", "glazing": "m of outer wall",
    "adjacency": "m between rooms that should meet", "reached": "rooms and m to reach them",
    "entrance": "m to the entrance's wall", "wet-groups": "groups of rooms with water",
    "corridors": "twentieths of the floor",
    "large-room": "m2 of floor", "shape": "m between parts of a room", "doors": "doors without a place",
    "windows": "m of window", "turning": "rooms to turn in",
}  # fmt: skip
"""What the violations of rules are measured in."""


@dataclass(frozen=True)
class PlanSolution:
    """Plans of all candidates; B candidates, C cells, D doors, W windows.

    Attributes:
        plan: the problem that was solved; ``plan.programme`` has the rooms in the order of the arrays.
        status: [B] int8, 1: valid.
        energy: [B] float32: hard violations and soft rows, lower is better.
        frames: [B] int32, number of each candidate's frame in ``plan.frames``.
        codes: [B, 64] int32, slicing trees in prefix order, see `kernels.plan_tables`; -1 behind the end.
        cuts: [B, 64] int32, where the wall of each cut of the code begins [mm].
        cells: [B, C, 4] int32, clear floor of each cell x0, y0, x1, y1 [mm].
        storeys: [B, C] int32, storey of each cell; -1: it is not there.
        owners: [B, C] int32, room of each cell; -1: none.
        doors: [B, D, 9] int32, `kernels.plan_tables.DOOR_RECORD`.
        windows: [B, W, 5] int32, `kernels.plan_tables.WINDOW_RECORD`.
        counts: [B, 2] int32, doors and windows of each.
        violations: [B, rules] float32, by how much each of `kernels.plan_tables.RULES` is broken.
        rounds: [B] int32, attempts of each.
        elapsed: seconds.
        timed_out: whether the time limit cut the search off.
    """

    plan: CompiledPlan
    status: np.ndarray
    energy: np.ndarray
    frames: np.ndarray
    codes: np.ndarray
    cuts: np.ndarray
    cells: np.ndarray
    storeys: np.ndarray
    owners: np.ndarray
    doors: np.ndarray
    windows: np.ndarray
    counts: np.ndarray
    violations: np.ndarray
    rounds: np.ndarray
    elapsed: float
    timed_out: bool

    def __repr__(self) -> str:
        late = ", time was up" if self.timed_out else ""
        return f"PlanSolution({len(self.valid)} of {len(self.status)} plans valid, {self.elapsed:.2f} s{late})"

    @cached_property
    def valid(self) -> np.ndarray:
        """Numbers of the valid candidates, best first."""
        found = np.flatnonzero(self.status == 1)
        return found[np.argsort(self.energy[found], kind="stable")]

    def topologies(self) -> np.ndarray:
        """[B] uint64: a code of access and neighbourhood of each candidate; 0 for those that are not valid.

        Two plans have the same code where the same rooms share walls and doors, whichever of rooms that differ by name
        alone is which.
        """
        codes = np.zeros(len(self.status), dtype=np.uint64)
        which = np.flatnonzero(self.status == 1)
        classes = room_classes(self.plan.programme)
        for first in range(0, len(which), 4096):
            k = which[first : first + 4096]
            matrices = neighbour_matrices(
                self.cells[k],
                self.storeys[k],
                self.owners[k],
                self.doors[k],
                self.counts[k, 0],
                len(classes),
                self.plan.numbers["inner"],
            )
            codes[k] = topology_codes(matrices, classes)
        return codes

    def outlines(self, k: int) -> list[list[tuple[float, float]]]:
        """The clear floor of each room of candidate k [m], counter-clockwise."""
        return outlines_of(self.plan, self.cells[k], self.storeys[k], self.owners[k])

    def home(self, k: int) -> Home:
        """Candidate k as a home.

        Raises:
            InputError: there is no such candidate, or it has no complete plan.
        """
        if not 0 <= k < len(self.status):
            raise InputError(f"k is {k}; candidates are 0 to {len(self.status) - 1}")
        if not self.rounds[k] or self.violations[k, RULES.index("doors")] > 0:
            raise InputError(f"candidate {k} has no complete plan; take one of valid")
        doors, windows = self.counts[k]
        return home_of(
            self.plan,
            int(self.frames[k]),
            self.cells[k],
            self.storeys[k],
            self.owners[k],
            self.doors[k, :doors],
            self.windows[k, :windows],
        )

    @property
    def best(self) -> Home:
        """The valid plan with the lowest energy.

        Raises:
            InputError: none is valid; `explanation` says why.
        """
        if not len(self.valid):
            raise InputError(self.explanation)
        return self.home(int(self.valid[0]))

    def distinct(self, n: int) -> list[Home]:
        """The best plan of each of the ``n`` best topologies, best first; fewer where there are fewer."""
        codes = self.topologies()
        seen: dict[int, int] = {}
        for k in self.valid:
            if len(seen) == n:
                break
            seen.setdefault(int(codes[k]), int(k))
        return [self.home(k) for k in seen.values()]

    def ranked(self, n: int = COMPARED) -> list[tuple[Home, PlanReport]]:
        """Plans with the verdict of `check_plan` on each, the one that soft rows cost least first.

        The ``n`` best topologies by energy are compared, for energies are no costs: they have a slope where a cost has
        come to its end, and know nothing of some rows. Invalid ones, if there are any, come last.
        """
        plan = self.plan
        homes = self.distinct(n)
        found = [(home, check_plan(home, plan.programme, plan.profile, envelope=plan.envelope)) for home in homes]
        return sorted(found, key=lambda pair: (not pair[1].valid, round(pair[1].cost, 6)))

    @property
    def explanation(self) -> str:
        """Which rule fails most often where nothing is valid, and by how much; empty where something is."""
        if len(self.valid):
            return ""
        late = " before time was up" if self.timed_out else ""
        tried = self.rounds > 0
        if not tried.any():
            return f"no plan was found{late}: the first round did not come to an end"
        broken = self.violations[tried] > 0
        worst = int(np.argmax(broken.sum(axis=0)))
        amounts = self.violations[tried][:, worst]
        least = float(np.min(amounts[amounts > 0])) if (amounts > 0).any() else 0.0
        often = int(broken[:, worst].sum())
        return (
            f"no valid plan was found{late}: {RULES[worst]} fails most often, in {often} of {len(broken)} candidates, "
            f"by {least:.2g} {UNITS[RULES[worst]]} at least"
        )
