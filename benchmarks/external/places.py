"""Places of one rectangle among others that stand: what placers on grids and samplers that reject have in common."""

from __future__ import annotations

from collections import defaultdict

import numpy as np

from .quarter_turns import QuarterTurns
from .rectangles import Apart, Wanted, holds

FLUSH = 0.004  # [m] from a wall that a thing stands at
SLACK = 5e-4  # [m] by which rectangles may overlap


class Places:
    """Tests of places in a view."""

    def __init__(self, view: QuarterTurns) -> None:
        self.view = view
        self.pairs: dict[int, list[Apart]] = defaultdict(list)
        for pair in view.apart:
            self.pairs[pair.a].append(pair)
            if pair.b >= 0:
                self.pairs[pair.b].append(Apart(pair.b, pair.boxes_b, pair.a, pair.boxes_a))
        self.relations: dict[int, list[Wanted]] = defaultdict(list)
        for wanted in view.relations:
            for body in wanted.bodies:
                self.relations[body].append(wanted)

    def order(self) -> list[int]:
        """Large ones first, but what others refer to before those."""
        area = [float(np.prod(body.reach[0, 2:] - body.reach[0, :2])) for body in self.view.bodies]
        needs: dict[int, set[int]] = defaultdict(set)
        for wanted in self.view.relations:
            if len(wanted.bodies) == 2:
                needs[wanted.bodies[0]].add(wanted.bodies[1])
        left, order = set(range(len(area))), []
        while left:
            ready = [i for i in left if not needs[i] & left] or list(left)
            order.append(max(ready, key=lambda i: area[i]))
            left.remove(order[-1])
        return order

    def free(
        self, body: int, spots: np.ndarray, turns: np.ndarray, xy: np.ndarray, others: np.ndarray, here: list[int]
    ) -> np.ndarray:
        """Whether a body at spots [P, 2] and turns [P] is in the room and clear of bodies ``here`` (at xy, turns)."""
        view, good = self.view, np.zeros(len(spots), dtype=bool)
        for t in np.unique(turns):
            rows = turns == t
            level = spots[rows] @ view.planes[:, :2].T - view.bounds(body, int(t))
            good[rows] = (level >= -SLACK).all(axis=1)
        standing = set(here)
        for pair in self.pairs[body]:
            if pair.b >= 0 and pair.b not in standing:
                continue
            a = pair.boxes_a[turns]
            b = pair.boxes_b[0] if pair.b < 0 else pair.boxes_b[others[pair.b]] + np.tile(xy[pair.b], 2)
            hit = (a[:, 2] + spots[:, 0] - b[0] > SLACK) & (b[2] - a[:, 0] - spots[:, 0] > SLACK)
            hit &= (a[:, 3] + spots[:, 1] - b[1] > SLACK) & (b[3] - a[:, 1] - spots[:, 1] > SLACK)
            good &= ~hit
        return good

    def satisfied(
        self,
        body: int,
        spots: np.ndarray,
        turns: np.ndarray,
        xy: np.ndarray,
        others: np.ndarray,
        here: list[int],
        hard: bool = False,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Which relations a body's spots satisfy: those to the room [P, R] and those to bodies here [P, Q].

        ``hard``: only those that are.
        """
        room, between = [], []
        standing = {*here, body}
        many_xy = np.repeat(xy[None], len(spots), axis=0)
        many_turns = np.repeat(others[None], len(spots), axis=0)
        many_xy[:, body], many_turns[:, body] = spots, turns
        for wanted in self.relations[body]:
            if set(wanted.bodies) <= standing and (wanted.hard or not hard):
                good = np.zeros(len(spots), dtype=bool)
                for choice in wanted.choices:
                    good |= holds(choice, many_xy, many_turns)
                (room if len(wanted.bodies) == 1 else between).append(good)
        empty = np.zeros((len(spots), 0), dtype=bool)
        return (np.stack(room, axis=1) if room else empty), (np.stack(between, axis=1) if between else empty)

    def grid(
        self, body: int, cell: float, shift: np.ndarray, xy: np.ndarray, others: np.ndarray, here: list[int]
    ) -> tuple[np.ndarray, np.ndarray]:
        """Free spots [P, 2] and turns [P] of a body on a grid of the room, and flush with its walls."""
        x0, y0, x1, y1 = self.view.box
        points = np.stack(np.meshgrid(np.arange(x0 + shift[0], x1, cell), np.arange(y0 + shift[1], y1, cell)), -1)
        points = points.reshape(-1, 2)
        spots, turns = [], []
        for t in range(len(self.view.bodies[body].yaws)):
            mine = [points]
            for normal, level in zip(self.view.planes[:, :2], self.view.bounds(body, t), strict=True):
                off = points @ normal - level
                near = np.abs(off) < cell
                mine.append(points[near] + (FLUSH - off[near])[:, None] * normal)
            spots.append(np.concatenate(mine))
            turns.append(np.full(len(spots[-1]), t))
        at, how = np.concatenate(spots), np.concatenate(turns)
        good = self.free(body, at, how, xy, others, here)
        return at[good], how[good]
