"""One floor plan at a time by the CP-SAT solver of OR-Tools (Perron and Furnon, Apache 2.0): rooms as rectangles.

Sides and places are whole numbers of a grid. Rooms, each with its walls, tile the envelope without overlaps; floor,
sides and shape are bounded, walls that doors, windows and the entrance need are choices of four sides, and every room
that the programme joins to none touches a room that leads on. The model is our own, after OR-Tools' documentation.

Fairness: it sees one storey in a rectangular envelope and one rectangle a room; halls do not bend. It does not see
leaves of doors or groups of wet rooms: the first plan that it finds is judged with all rules afterwards, and where that
fails the next is asked for, with another seed.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from sceneweaver.kernels import plan_tables as tables
from sceneweaver.plans.solve_problem import CompiledPlan
from sceneweaver.plans.solve_run import judge_rectangles

GRID = 50
"""Steps [mm]."""
WORKERS = 2
"""Threads: all cores of the machine that the figures are of."""


def suits(plan: CompiledPlan) -> bool:
    """Whether the rival sees all of a problem's shape: one storey, a rectangle."""
    return plan.programme.storeys == 1 and len(plan.envelope.outline) == 4


def first_valid(plan: CompiledPlan, limit: float, seed: int = 0) -> tuple[float, str]:
    """Seconds until the first plan that breaks no rule, or until it gave up, and how it ended.

    Args:
        plan: the problem, one that `suits`.
        limit: seconds at most.
        seed: of the solver.
    """
    began = time.perf_counter()
    tries = 0
    while (left := limit - (time.perf_counter() - began)) > 0.5:
        cells, status = _solved(plan, left, seed + tries)
        tries += 1
        if cells is None:
            return time.perf_counter() - began, status
        judged = judge_rectangles(plan, cells[None])
        if judged["status"][0] == 1:
            return time.perf_counter() - began, f"valid (try {tries})"
    return time.perf_counter() - began, f"none valid in {tries} plans" if tries else "time was up"


def _solved(plan: CompiledPlan, limit: float, seed: int) -> tuple[np.ndarray | None, str]:
    from ortools.sat.python import cp_model

    model = cp_model.CpModel()
    view = _Model(plan, model)
    view.add_rooms()
    view.add_ways()
    view.add_facades()
    solver = cp_model.CpSolver()
    solver.parameters.max_time_in_seconds = limit
    solver.parameters.num_workers = WORKERS
    solver.parameters.random_seed = seed
    status = solver.solve(model)
    if status not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
        return None, "proved that there is none" if status == cp_model.INFEASIBLE else "time was up"
    boxes = [[solver.value(v) for v in (r["x"], r["y"], r["x1"], r["y1"])] for r in view.rooms]
    # sides of the grid are those of rooms with half a wall around them
    inner = plan.numbers["inner"]
    cells = np.array(boxes) * GRID
    cells[:, :2] += view.low
    cells[:, 2:] += view.low - inner
    high = np.array(plan.arrays["bay"][0][2:])
    cells[:, 2:] = np.where(cells[:, 2:] >= high - view.rest, high, cells[:, 2:])
    return cells, "found"


class _Model:
    """Variables of the rooms, in grid steps: x, y from the lowest corner of the floor, sides with one wall each."""

    def __init__(self, plan: CompiledPlan, model: Any) -> None:
        self.plan, self.model = plan, model
        self.low = np.array(plan.arrays["bay"][0][:2])
        size = np.array(plan.arrays["bay"][0][2:]) - self.low + plan.numbers["inner"]
        self.size = [int(v) // GRID for v in size]
        self.rest = GRID
        self.wall = plan.numbers["inner"] // GRID
        self.rooms: list[dict[str, Any]] = []

    def add_rooms(self) -> None:
        """Rectangles that tile the floor, with their bounds."""
        model, (width, depth) = self.model, self.size
        areas, across, along = [], [], []
        for k in range(self.plan.numbers["rooms"]):
            least = -(-int(self.plan.arrays["room_side"][k]) // GRID) + self.wall
            x, y = model.new_int_var(0, width, f"x{k}"), model.new_int_var(0, depth, f"y{k}")
            x1, y1 = model.new_int_var(0, width, f"X{k}"), model.new_int_var(0, depth, f"Y{k}")
            w, h = model.new_int_var(least, width, f"w{k}"), model.new_int_var(least, depth, f"h{k}")
            across.append(model.new_interval_var(x, w, x1, f"ix{k}"))
            along.append(model.new_interval_var(y, h, y1, f"iy{k}"))
            clear = model.new_int_var(0, width * depth, f"a{k}")
            model.add_multiplication_equality(clear, [w - self.wall, h - self.wall])
            low, _, high = (int(v) for v in self.plan.arrays["room_area"][k])
            model.add(clear * GRID * GRID >= low)
            model.add(clear * GRID * GRID <= high)
            ratio = int(self.plan.arrays["room_aspect"][k])
            if ratio < 10**5:
                model.add(1000 * (w - self.wall) <= ratio * (h - self.wall))
                model.add(1000 * (h - self.wall) <= ratio * (w - self.wall))
            full = model.new_int_var(0, width * depth, f"f{k}")
            model.add_multiplication_equality(full, [w, h])
            areas.append(full)
            self.rooms.append({"x": x, "y": y, "x1": x1, "y1": y1, "w": w, "h": h, "clear": clear})
        model.add_no_overlap_2d(across, along)
        model.add(sum(areas) == width * depth)
        large = self.plan.numbers["large_room"]
        if large:
            flags = self.plan.arrays["room_flags"]
            ones = [k for k in range(len(self.rooms)) if flags[k] & int(tables.LARGE)]
            chosen = [model.new_bool_var(f"large{k}") for k in ones]
            model.add_bool_or(chosen)
            for k, literal in zip(ones, chosen, strict=True):
                model.add(self.rooms[k]["clear"] * GRID * GRID >= large).only_enforce_if(literal)

    def touching(self, a: int, b: int, need: int) -> list[Any]:
        """Choices of the side on which two rooms share a wall of so many mm; each enforces it."""
        model, found = self.model, []
        steps = -(-need // GRID) + self.wall
        for first, second in ((a, b), (b, a)):
            for axis, other in (("x", "y"), ("y", "x")):
                literal = model.new_bool_var("")
                p, q = self.rooms[first], self.rooms[second]
                model.add(p[axis + "1"] == q[axis]).only_enforce_if(literal)
                model.add(p[other + "1"] - q[other] >= steps).only_enforce_if(literal)
                model.add(q[other + "1"] - p[other] >= steps).only_enforce_if(literal)
                for r in (p, q):
                    model.add(r[other + "1"] - r[other] >= steps).only_enforce_if(literal)
                found.append(literal)
        return found

    def add_ways(self) -> None:
        """Doors that the programme asks for; rooms that it joins to none touch one that leads on and is joined."""
        plan, joined = self.plan, {self.plan.numbers["entrance"]}
        jambs = 2 * plan.numbers["jamb"]
        hard = [
            row
            for row, weight in zip(plan.arrays["adjacency"], plan.arrays["adjacency_weight"], strict=True)
            if weight < 0
        ]
        for a, b, kind, width in hard:
            if kind == int(tables.NEAR):
                self.model.add_bool_or(self.touching(int(a), int(b), plan.numbers["wet_wall"]))
            elif kind != int(tables.APART):
                self.model.add_bool_or(self.touching(int(a), int(b), int(width) + jambs))
                joined |= {int(a), int(b)}
        flags, doors = plan.arrays["room_flags"], plan.arrays["room_door"]
        leads = [k for k in joined if flags[k] & int(tables.THROUGH)]
        for k in range(len(self.rooms)):
            if k not in joined:
                sides = [s for o in leads for s in self.touching(k, o, int(min(doors[k], doors[o])) + jambs)]
                self.model.add_bool_or(sides)

    def add_facades(self) -> None:
        """Outer walls for the entrance and for windows, whose width grows with the floor."""
        plan, flags = self.plan, self.plan.arrays["room_flags"]
        entrance = plan.numbers["entrance_door"] + 2 * plan.numbers["jamb"]
        self._at_walls(plan.numbers["entrance"], int(tables.ENTRANCE), -(-entrance // GRID), 0)
        for k in range(len(self.rooms)):
            if flags[k] & (int(tables.GLAZED) | int(tables.LIT)):
                piers = 2 * plan.numbers["pier"]
                least = -(-(plan.numbers["least_window"] + piers) // GRID)
                glass = plan.numbers["glazing"] if flags[k] & int(tables.GLAZED) else 0
                self._at_walls(k, int(tables.WINDOWS), least, glass)

    def _at_walls(self, k: int, flag: int, least: int, glazing: int) -> None:
        plan, room, choices = self.plan, self.rooms[k], []
        for (side, *_), bits in zip(plan.arrays["facade"], plan.arrays["facade_flags"], strict=True):
            if not bits & flag:
                continue
            literal = self.model.new_bool_var("")
            axis, other = ("x", "h") if side % 2 == 0 else ("y", "w")
            end = 0 if side < 2 else self.size[side % 2]
            self.model.add(room[axis if side < 2 else axis + "1"] == end).only_enforce_if(literal)
            self.model.add(room[other] - self.wall >= least).only_enforce_if(literal)
            if glazing:
                # [steps] of wall * pane [mm] * 1000 * GRID >= glazing * clear * GRID^2, beside the piers
                clear = (room[other] - self.wall) * GRID - 2 * plan.numbers["pier"]
                self.model.add(
                    clear * 1000 * plan.numbers["pane"] >= glazing * GRID * GRID * room["clear"]
                ).only_enforce_if(literal)
            choices.append(literal)
        self.model.add_bool_or(choices)
