"""A mixed-integer program by HiGHS (Huangfu and Hall 2018) through `scipy.optimize.milp` (BSD-3), for small problems.

The model of two-dimensional floor planning by Sutanthavibul, Shragowitz and Rosen (1991): a binary variable for each
side on which two rectangles may be apart, one for each turn of a body and each choice of a relation, all with a large
constant. Soft relations and wire length are minimised. The model is our own; it is that of `cp_sat` with real lengths.

Fairness: it sees what `cp_sat` sees. HiGHS has no seed here; candidates differ by a small random pull towards where
they start. Above ``largest`` conditions it does not try, as the relaxation of large constants says next to nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .objectives import Net, nets_of
from .one_by_one import OneByOne
from .quarter_turns import QuarterTurns, quarter_turns


@dataclass(frozen=True)
class Milp(OneByOne):
    limit: float = 2.0  # [s] of a candidate
    pull: float = 1e-3  # what a metre from where a body starts costs
    gap: float = 0.05  # relative, at which it ends
    largest: int = 4000  # pairs of rectangles and choices

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "limit": [1.0, 2.0, 5.0],
        "pull": [0.0, 1e-3, 0.1],
        "gap": [0.01, 0.05, 0.5],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray | None:
        view = quarter_turns(problem, given)
        if len(view.apart) + sum(len(w.choices) for w in view.relations) > self.largest:
            return None
        xy, _ = view.spot(given[None])
        program = Program(view)
        program.minimise(nets_of(problem, self.objective))
        program.pull(xy[0], self.pull * np.random.default_rng(seed).uniform(0.5, 1.5, xy[0].shape))
        found = program.solve(self.limit, self.gap)
        return None if found is None else view.placed(given[None], found[0][None], found[1][None])


class Program:
    """Rows ``low <= A x <= high``, bounds and costs, gathered piece by piece."""

    def __init__(self, view: QuarterTurns) -> None:
        self.view = view
        self.low, self.high, self.cost, self.whole = [], [], [], []
        self.entries: list[tuple[int, int, float]] = []
        self.rows: list[tuple[float, float]] = []
        x0, y0, x1, y1 = view.box
        self.big = 2.0 * math.hypot(x1 - x0, y1 - y0) + 2.0
        self.x = [(self.variable(x0, x1), self.variable(y0, y1)) for _ in view.bodies]
        self.turn = [[self.binary() for _ in body.yaws] for body in view.bodies]
        for own in self.turn:
            self.row({v: 1.0 for v in own}, 1.0, 1.0)
        for i in range(len(view.bodies)):
            for p, (nx, ny, _) in enumerate(view.planes):
                levels = [view.bounds(i, t)[p] for t in range(len(self.turn[i]))]
                terms = {self.x[i][0]: nx, self.x[i][1]: ny}
                self.row(terms | {v: -level for v, level in zip(self.turn[i], levels, strict=True)}, -1e-5, math.inf)
        for pair in view.apart:
            self._apart(pair)
        self._relations()

    def variable(self, low: float, high: float, cost: float = 0.0, whole: bool = False) -> int:
        self.low.append(low)
        self.high.append(high)
        self.cost.append(cost)
        self.whole.append(whole)
        return len(self.low) - 1

    def binary(self, cost: float = 0.0) -> int:
        return self.variable(0.0, 1.0, cost, True)

    def row(self, terms: dict[int, float], low: float, high: float) -> None:
        self.entries += [(len(self.rows), v, float(factor)) for v, factor in terms.items()]
        self.rows.append((low, high))

    def _side(self, body: int, boxes: np.ndarray, i: int) -> tuple[dict[int, float], float]:
        """A side of a rectangle as terms and a constant."""
        if body < 0:
            return {}, float(boxes[0, i])
        return {self.x[body][i % 2]: 1.0} | dict(zip(self.turn[body], boxes[:, i], strict=True)), 0.0

    def _apart(self, pair: Any) -> None:
        sides = [self.binary() for _ in range(4)]
        self.row({v: 1.0 for v in sides}, 1.0, math.inf)
        for d in (0, 1):
            orders = ((pair.a, pair.boxes_a, pair.b, pair.boxes_b), (pair.b, pair.boxes_b, pair.a, pair.boxes_a))
            for side, (first, boxes, second, others) in zip((sides[d], sides[2 + d]), orders, strict=True):
                (up, most), (down, least) = self._side(first, boxes, 2 + d), self._side(second, others, d)
                terms = up | {v: -factor for v, factor in down.items()} | {side: self.big}
                self.row(terms, -math.inf, self.big + least - most)

    def _relations(self) -> None:
        for wanted in self.view.relations:
            chosen = []
            for choice in wanted.choices:
                lit = self.binary()
                chosen.append(lit)
                for body, allowed in choice.turns:
                    self.row({self.turn[body][t]: 1.0 for t in allowed} | {lit: -1.0}, 0.0, math.inf)
                for each in choice.intervals:
                    terms = {self.x[each.a][d]: each.normal[d] for d in (0, 1)}
                    if each.b >= 0:
                        terms |= {self.x[each.b][d]: -each.normal[d] for d in (0, 1)}
                    big = 2 * self.big + max((abs(v) for v in (each.low, each.high) if math.isfinite(v)), default=0.0)
                    if math.isfinite(each.low):
                        self.row(terms | {lit: -big}, each.low - big, math.inf)
                    if math.isfinite(each.high):
                        self.row(terms | {lit: big}, -math.inf, each.high + big)
            if not wanted.hard:
                chosen.append(self.variable(0.0, 1.0, 0.1 * wanted.weight))
            self.row({v: 1.0 for v in chosen}, 1.0, math.inf)

    def minimise(self, nets: list[Net]) -> None:
        """What nets take."""
        for net in nets:
            for d in (0, 1):
                least, most = self.variable(-1e3, 1e3, -net.weight), self.variable(-1e3, 1e3, net.weight)
                for body, offset in net.pins:
                    terms, constant = self._pin(body, offset, d)
                    self.row({least: 1.0} | {v: -factor for v, factor in terms.items()}, -math.inf, constant)
                    self.row({most: 1.0} | {v: -factor for v, factor in terms.items()}, constant, math.inf)

    def _pin(self, body: int, offset: tuple[float, float], d: int) -> tuple[dict[int, float], float]:
        if body < 0:
            return {}, offset[d]
        yaw = self.view.bodies[body].yaws
        along = (np.cos(yaw) * offset[0] - np.sin(yaw) * offset[1], np.sin(yaw) * offset[0] + np.cos(yaw) * offset[1])
        return {self.x[body][d]: 1.0} | dict(zip(self.turn[body], along[d], strict=True)), 0.0

    def pull(self, xy: np.ndarray, cost: np.ndarray) -> None:
        """What it costs [n, 2] to be a metre away from positions [n, 2]."""
        for i, own in enumerate(self.x):
            for d in (0, 1):
                away = self.variable(0.0, math.inf, float(cost[i, d]))
                self.row({away: 1.0, own[d]: -1.0}, -float(xy[i, d]), math.inf)
                self.row({away: 1.0, own[d]: 1.0}, float(xy[i, d]), math.inf)

    def solve(self, seconds: float, gap: float) -> tuple[np.ndarray, np.ndarray] | None:
        """Positions [n, 2] and turns [n], or None."""
        from scipy.optimize import Bounds, LinearConstraint, milp
        from scipy.sparse import csr_array

        r, c, v = zip(*self.entries, strict=True)
        matrix = csr_array((v, (r, c)), shape=(len(self.rows), len(self.low)))
        low, high = np.array(self.rows).T
        found = milp(
            np.array(self.cost),
            integrality=np.array(self.whole, dtype=int),
            bounds=Bounds(np.array(self.low), np.array(self.high)),  # pyright: ignore[reportArgumentType]
            constraints=LinearConstraint(matrix, low, high),
            options={"time_limit": seconds, "mip_rel_gap": gap},
        )
        if found.x is None:
            return None
        xy = np.array([[found.x[v] for v in own] for own in self.x]).reshape(-1, 2)
        return xy, np.array([int(np.argmax([found.x[v] for v in own])) for own in self.turn], dtype=int)
