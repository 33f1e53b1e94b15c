"""Constraint programming by the CP-SAT solver of OR-Tools (Perron and Furnon, Apache 2.0; `pip install ortools`).

Positions are whole numbers of ``grid``, turns are quarters. Parts that stand on the floor share one NoOverlap2D (Sidi
and Perron's ``no_overlap_2d`` over intervals), all else that has to keep apart is a choice of four sides. Relations are
choices of linear intervals; soft ones and the wire length are minimised. After OR-Tools' documentation; the model is
our own.

Fairness: it sees bodies as rectangles, hard zones, doors, walls, hard and soft relations, nets and flows (by Manhattan
distance), by `quarter_turns`; not yaws between quarter turns, shapes other than rectangles, positions between and
around others, carried things' relations. One worker thread, so that processor time is time. It may prove that nothing
is possible in its grid, and says so by leaving the start as it is.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .objectives import Net, nets_of
from .one_by_one import OneByOne
from .quarter_turns import QuarterTurns, quarter_turns
from .rectangles import Interval

FAR = 10**7  # grid steps from where on an interval has no end
PATIENCE = 4.0  # of wall to processor time at most
MICRO = 1000  # of weights and directions that are whole numbers


@dataclass(frozen=True)
class CpSat(OneByOne):
    grid: float = 0.01  # [m]
    limit: float = 1.0  # [s] of a candidate
    hint: bool = True  # begin where the candidate starts
    linearization: int = 0  # level of the linear relaxation; 0 was best on blocks with nets

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "grid": [0.001, 0.01, 0.03],
        "limit": [0.5, 1.0, 2.0],
        "hint": [True, False],
        "linearization": [0, 1, 2],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray | None:
        from ortools.sat.python import cp_model

        view = quarter_turns(problem, given)
        xy, turns = view.spot(given[None])
        model = Model(view, self.grid)
        model.minimise(nets_of(problem, self.objective))
        if self.hint:
            model.hint(xy[0], turns[0])
        solver = cp_model.CpSolver()
        solver.parameters.num_workers = 1
        solver.parameters.random_seed = seed
        solver.parameters.max_time_in_seconds = PATIENCE * self.limit  # of the wall clock, which is not what counts
        solver.parameters.linearization_level = self.linearization
        solver.parameters.randomize_search = seed % 2 == 1
        over = threading.Event()

        def watch() -> None:
            while not over.wait(0.01):
                if until():
                    solver.stop_search()

        watcher = threading.Thread(target=watch)
        watcher.start()
        try:
            status = solver.solve(model.model)
        finally:
            over.set()
            watcher.join()
        if status not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
            return None
        found_xy, found_turns = model.read(solver)
        return view.placed(given[None], found_xy[None], found_turns[None])


class Model:
    """The program: variables of bodies, what keeps apart, relations. Lengths are in steps of the grid."""

    def __init__(self, view: QuarterTurns, grid: float) -> None:
        from ortools.sat.python import cp_model

        self.view, self.grid, self.model = view, grid, cp_model.CpModel()
        x0, y0, x1, y1 = (round(v / grid) for v in view.box)
        self.box, self.unmet = (x0, y0, x1, y1), []
        model = self.model
        self.x = [(model.new_int_var(x0, x1, ""), model.new_int_var(y0, y1, "")) for _ in view.bodies]
        self.turn = [[model.new_bool_var("") for _ in body.yaws] for body in view.bodies]
        told = {body for wanted in view.relations for choice in wanted.choices for body, _ in choice.turns}
        for i, own in enumerate(self.turn):
            model.add_exactly_one(own)
            if i not in told and len(own) == 4:  # half a turn of a symmetric body changes nothing
                for t in (2, 3):
                    if all(np.allclose(b[:, t], b[:, t - 2]) for b in (view.bodies[i].solids, view.bodies[i].zones)):
                        model.add(own[t] == 0)
        self._walls()
        self._keep_apart()
        self._relations()

    def _steps(self, value: float, up: bool) -> int:
        return (math.ceil if up else math.floor)(round(value / self.grid, 6))

    def _by_turn(self, body: int, values: list[int]) -> Any:
        """What depends on a body's turn."""
        if len(set(values)) == 1:
            return values[0]
        return sum(int(v) * lit for v, lit in zip(values, self.turn[body], strict=True))

    def _sides(self, body: int, boxes: np.ndarray) -> list[Any]:
        """Low x, low y, high x, high y of a rectangle given by turn [T, 4], rounded outwards."""
        if body < 0:
            return [self._steps(v, i >= 2) for i, v in enumerate(boxes[0])]
        offsets = [[self._steps(v, i >= 2) for v in boxes[:, i]] for i in range(4)]
        return [self.x[body][i % 2] + self._by_turn(body, offsets[i]) for i in range(4)]

    def _walls(self) -> None:
        for i, own in enumerate(self.turn):
            for t, lit in enumerate(own):
                for (nx, ny, _), level in zip(self.view.planes, self.view.bounds(i, t), strict=True):
                    cx, cy = round(MICRO * nx), round(MICRO * ny)
                    self.model.add(
                        cx * self.x[i][0] + cy * self.x[i][1] >= self._steps(MICRO * (level - 5e-5), True)
                    ).only_enforce_if(lit)

    def _keep_apart(self) -> None:
        """One NoOverlap2D of the largest part of each body that reaches the floor, four sides for all other pairs."""
        model, clique = self.model, {}
        for i, body in enumerate(self.view.bodies):
            low = [p for p in range(len(body.solids)) if body.solid_z[p, 0] < 0.02 < body.solid_z[p, 1]]
            if low:
                area = [np.prod(body.solids[p, 0, 2:] - body.solids[p, 0, :2]) for p in low]
                clique[i] = body.solids[low[int(np.argmax(area))]]
        together = {(p.a, p.b) for p in self.view.apart if self._in(clique, p)}
        everyone = all((i, j) in together for i in clique for j in clique if i < j)
        if len(clique) > 1 and everyone:
            both: list[list[Any]] = [[], []]
            for i, boxes in clique.items():
                sides = self._sides(i, boxes)
                for d in (0, 1):
                    width = [self._steps(b[2 + d], True) - self._steps(b[d], False) for b in boxes]
                    low, high = self.box[d] - max(width), self.box[2 + d] + max(width)
                    start, size, end = (
                        model.new_int_var(low, high, ""),
                        model.new_int_var(min(width), max(width), ""),
                        model.new_int_var(low, high, ""),
                    )
                    model.add(start == sides[d])
                    model.add(size == self._by_turn(i, width))
                    both[d].append(model.new_interval_var(start, size, end, ""))
            model.add_no_overlap_2d(*both)
            for d in (0, 1):  # what stands above each other takes its share of the room's other side
                sizes = [interval.size_expr() for interval in both[1 - d]]
                model.add_cumulative(both[d], sizes, self.box[3 - d] - self.box[1 - d])
        for pair in self.view.apart:
            if everyone and self._in(clique, pair):
                continue
            a, b = self._sides(pair.a, pair.boxes_a), self._sides(pair.b, pair.boxes_b)
            side = [model.new_bool_var("") for _ in range(4)]
            for d in (0, 1):
                model.add(a[2 + d] <= b[d]).only_enforce_if(side[d])
                model.add(b[2 + d] <= a[d]).only_enforce_if(side[2 + d])
            model.add_bool_or(side)

    @staticmethod
    def _in(clique: dict[int, np.ndarray], pair: Any) -> bool:
        return clique.get(pair.a) is pair.boxes_a or (
            pair.b in clique
            and pair.a in clique
            and np.array_equal(clique[pair.a], pair.boxes_a)
            and np.array_equal(clique[pair.b], pair.boxes_b)
        )

    def _relations(self) -> None:
        for wanted in self.view.relations:
            chosen = []
            for choice in wanted.choices:
                lit = self.model.new_bool_var("")
                for body, allowed in choice.turns:
                    self.model.add_bool_or([self.turn[body][t] for t in allowed]).only_enforce_if(lit)
                for each in choice.intervals:
                    self._interval(each, lit)
                chosen.append(lit)
            if not wanted.hard:
                missed = self.model.new_bool_var("")
                self.unmet.append((missed, wanted.weight))
                chosen.append(missed)
            self.model.add_bool_or(chosen)

    def _interval(self, each: Interval, lit: Any) -> None:
        cx, cy = round(MICRO * each.normal[0]), round(MICRO * each.normal[1])
        value = cx * self.x[each.a][0] + cy * self.x[each.a][1]
        if each.b >= 0:
            value -= cx * self.x[each.b][0] + cy * self.x[each.b][1]
        if math.isfinite(each.low):
            self.model.add(value >= self._steps(MICRO * each.low, True)).only_enforce_if(lit)
        if math.isfinite(each.high):
            self.model.add(value <= self._steps(MICRO * each.high, False)).only_enforce_if(lit)

    def minimise(self, nets: list[Net]) -> None:
        """Soft relations that do not hold, as a tenth of a metre each times its weight, and what nets take."""
        model, cost = self.model, []
        for missed, weight in self.unmet:
            cost.append(round(100 * weight * 0.1 / self.grid) * missed)
        for net in nets:
            for d in (0, 1):
                least, most = (model.new_int_var(-FAR, FAR, "") for _ in range(2))
                for body, offset in net.pins:
                    pin = self._pin(body, offset, d)
                    model.add(least <= pin)
                    model.add(most >= pin)
                cost.append(round(100 * net.weight) * (most - least))
        if cost:
            model.minimize(sum(cost))

    def _pin(self, body: int, offset: tuple[float, float], d: int) -> Any:
        if body < 0:
            return round(offset[d] / self.grid)
        along = [
            (
                math.cos(yaw) * offset[0] - math.sin(yaw) * offset[1],
                math.sin(yaw) * offset[0] + math.cos(yaw) * offset[1],
            )
            for yaw in self.view.bodies[body].yaws
        ]
        return self.x[body][d] + self._by_turn(body, [round(v[d] / self.grid) for v in along])

    def hint(self, xy: np.ndarray, turns: np.ndarray) -> None:
        for i, own in enumerate(self.x):
            for d in (0, 1):
                self.model.add_hint(own[d], int(np.clip(round(xy[i, d] / self.grid), self.box[d], self.box[2 + d])))
            for t, lit in enumerate(self.turn[i]):
                self.model.add_hint(lit, int(turns[i] == t))

    def read(self, solver: Any) -> tuple[np.ndarray, np.ndarray]:
        """Positions [n, 2] and turns [n] of a solution."""
        xy = np.array([[solver.value(v) * self.grid for v in own] for own in self.x]).reshape(-1, 2)
        turns = np.array([int(np.argmax([solver.value(lit) for lit in own])) for own in self.turn], dtype=int)
        return xy, turns
