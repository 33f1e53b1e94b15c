"""Where the steps of a stair lie in its footprint: what plans and pictures draw."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.home import Stair


@dataclass(frozen=True, eq=False)
class Step:
    """A tread or landing: its plan [4, 2] in metres, counter-clockwise, and how many risers it lies over the floor."""

    plan: np.ndarray
    level: int


@dataclass(frozen=True, eq=False)
class StairSteps:
    """The steps of a stair from the lowest, and the line [N, 2] along which it is walked up [m]."""

    steps: tuple[Step, ...]
    line: np.ndarray


def stair_steps(stair: Stair) -> StairSteps:
    """The steps of a stair: ``risers - 1`` treads, as the upper floor is the last step.

    The first flight runs along ``up`` at the right edge of the footprint. Of an L the second one goes on to the left
    behind a quarter landing, of a U it comes back beside the first one behind a half landing.
    """
    up = np.asarray(stair.up)
    left = np.array([-up[1], up[0]])
    corners = np.asarray(stair.outline, dtype=float)
    u, v = corners @ up, corners @ left
    origin = up * u.min() + left * v.min()
    deep, wide = float(np.ptp(u)), float(np.ptp(v))
    frame = np.stack([up, left])
    flight = min(stair.width, wide)
    treads, going = stair.risers - 1, stair.going
    boxes: list[tuple[float, float, float, float]] = []  # from and to along up, from and to leftward
    if stair.shape == "straight":
        boxes = [(k * going, (k + 1) * going, 0.0, wide) for k in range(treads)]
        line = [(0.0, wide / 2), (treads * going, wide / 2)]
    elif stair.shape == "l":
        first = int(max(1, min(treads - 2, round((deep - flight) / going))))
        turn = first * going
        rest = treads - first - 1
        boxes = [(k * going, (k + 1) * going, 0.0, flight) for k in range(first)]
        boxes.append((turn, turn + flight, 0.0, flight))
        boxes += [(turn, turn + flight, flight + k * going, flight + (k + 1) * going) for k in range(rest)]
        middle = turn + flight / 2
        line = [(0.0, flight / 2), (middle, flight / 2), (middle, flight + rest * going)]
    else:
        flight = min(flight, wide / 2)
        first = (treads - 1 + 1) // 2
        rest = treads - 1 - first
        turn = first * going
        boxes = [(k * going, (k + 1) * going, 0.0, flight) for k in range(first)]
        boxes.append((turn, max(deep, turn + flight), 0.0, wide))
        boxes += [(turn - (k + 1) * going, turn - k * going, wide - flight, wide) for k in range(rest)]
        middle = turn + (max(deep, turn + flight) - turn) / 2
        line = [(0.0, flight / 2), (middle, flight / 2), (middle, wide - flight / 2)]
        line.append((turn - rest * going, wide - flight / 2))
    steps = []
    for level, (a, b, c, d) in enumerate(boxes, 1):
        quad = np.array([(a, c), (b, c), (b, d), (a, d)])
        steps.append(Step(origin + quad @ frame, level))
    return StairSteps(tuple(steps), origin + np.asarray(line) @ frame)
