"""Rejection sampling, object by object: what batched samplers of scenes do, with checks of collision on many at once.

As in Sceniris and in samplers built on cuRobo's collision checks: every object in turn is drawn many times from the
region that one of its relations leaves it (else from the room), in four directions or any; draws that leave the room,
collide with what stands, or miss a relation are rejected, and one of the others is taken. An object for which all draws
are rejected ``tries`` times ends the attempt, and the layout is begun anew. Written from what such samplers have in
common.

Fairness: it sees what `quarter_turns` says: rectangles, zones, doors, walls, relations; not yaws between quarter turns,
positions between and around others, objectives. Rejection is by the same tests that the grid search uses, not by the
engine. The best attempt (most objects placed) is kept.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from sceneweaver.layout import Problem

from .one_by_one import OneByOne
from .places import Places
from .quarter_turns import QuarterTurns, quarter_turns
from .rectangles import Choice

CHUNK = 16  # draws that go for the same choices


@dataclass(frozen=True)
class Rejection(OneByOne):
    draws: int = 256  # of an object at once
    tries: int = 4
    from_relations: float = 0.8  # share of the draws that are taken from a relation's region
    limit: float = 0.5

    SETTINGS: ClassVar[dict[str, list[Any]]] = {
        "draws": [64, 256, 1024],
        "tries": [1, 4, 16],
        "from_relations": [0.0, 0.5, 0.8, 1.0],
    }

    def solve(self, problem: Problem, given: np.ndarray, seed: int, until: Callable[[], bool]) -> np.ndarray:
        view, rng = quarter_turns(problem, given), np.random.default_rng(seed)
        places = Places(view)
        order, (xy, turns) = places.order(), view.spot(given[None])
        best, most = (xy[0], turns[0]), -1
        while not until() and most < len(order):
            attempt, own_turns, here = xy[0].copy(), turns[0].copy(), []
            for body in order:
                if not self._place(view, places, body, attempt, own_turns, here, rng, until):
                    break
                here.append(body)
            if len(here) > most:
                best, most = (attempt, own_turns), len(here)
        return view.placed(given[None], best[0][None], best[1][None])

    def _place(
        self,
        view: QuarterTurns,
        places: Places,
        body: int,
        xy: np.ndarray,
        turns: np.ndarray,
        here: list[int],
        rng: np.random.Generator,
        until: Callable[[], bool],
    ) -> bool:
        """Put a body somewhere, in place; False if all draws are rejected."""
        for _ in range(self.tries):
            if until():
                return False
            spots, how = _draw(view, places, body, xy, turns, here, rng, self.draws, self.from_relations)
            good = places.free(body, spots, how, xy, turns, here)
            spots, how = spots[good], how[good]
            if len(spots):
                room, between = places.satisfied(body, spots, how, xy, turns, here, hard=True)
                rows = np.flatnonzero(room.all(axis=1) & between.all(axis=1))
                if len(rows):
                    taken = rng.choice(rows)
                    xy[body], turns[body] = spots[taken], how[taken]
                    return True
        return False


def _draw(
    view: QuarterTurns,
    places: Places,
    body: int,
    xy: np.ndarray,
    turns: np.ndarray,
    here: list[int],
    rng: np.random.Generator,
    count: int,
    share: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Spots [P, 2] and turns [P]: uniform in the room, and for a share of them within a choice of a relation."""
    x0, y0, x1, y1 = view.box
    spots = rng.uniform((x0, y0), (x1, y1), (count, 2))
    how = rng.integers(0, len(view.bodies[body].yaws), count)
    standing = {*here, body}
    known = [w for w in places.relations[body] if w.hard and set(w.bodies) <= standing]
    for first in range(0, int(share * count) if known else 0, CHUNK):
        rows = slice(first, first + CHUNK)
        for w in rng.permutation(len(known)):  # one relation after another narrows what is left
            choices = [c for c in known[w].choices if all(i == body or turns[i] in some for i, some in c.turns)]
            if choices:
                spots[rows], how[rows] = _into(
                    choices[rng.integers(len(choices))], body, spots[rows], how[rows], xy, rng
                )
    return spots, how


def _into(
    choice: Choice, body: int, spots: np.ndarray, how: np.ndarray, xy: np.ndarray, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Spots [P, 2] moved into the intervals of a choice, at random where they were outside, and turns it allows."""
    for i, allowed in choice.turns:
        if i == body:
            how = np.where(np.isin(how, list(allowed)), how, rng.choice(sorted(allowed), len(how)))
    for each in choice.intervals:
        normal, low, high = np.array(each.normal), each.low, each.high
        other = each.b if each.a == body else each.a
        at = float(normal @ xy[other]) if other >= 0 else 0.0
        if each.a == body:
            low, high = low + at, high + at
        else:
            normal, low, high = -normal, low - at, high - at
        value, least, most = spots @ normal, low, high
        if math.isinf(least) or math.isinf(most):  # where an end is open, two metres beyond the other
            least, most = (most - 2.0, most) if math.isinf(least) else (least, least + 2.0)
        if least < most < math.inf:
            moved = (rng.uniform(least, most, len(spots)) - value)[:, None] / float(normal @ normal) * normal
            spots = np.where(((value < low) | (value > high))[:, None], spots + moved, spots)
    return spots, how
