"""Walkable share of the best candidates: what decides between layouts that are all valid."""

from __future__ import annotations

import math

import numpy as np
import warp as wp

from sceneweaver.kernels.walk import Floor, mark_floor, walk
from sceneweaver.optimizers import Batch, Monitor
from sceneweaver.optimizers.run import on_threads

from .compile import LayoutProblem

CELL = 0.1
RADIUS = 0.2  # of the robot, as the judge has it
LOW, HIGH = 0.02, 1.8
MOST_CELLS = 20_000  # of one room; larger rooms get larger cells


def walkable_shares(
    batch: Batch, room: LayoutProblem, candidates: np.ndarray, monitor: Monitor | None = None
) -> np.ndarray:
    """Share of the free floor that can be reached from the doors, for some candidates of a batch.

    Args:
        batch: holds the poses.
        room: the candidates' problem.
        candidates: indices [K] into the batch.
        monitor: of a run that time may end; None: all are measured, in one piece.

    Returns:
        Shares [K] float32, 0 to 1; nan where time was up.
    """
    if monitor is not None and batch.device == "cpu":
        found = np.full(len(candidates), np.nan, dtype=np.float32)

        def one(rows: tuple[int, int]) -> None:
            if not monitor.broken_off:
                found[slice(*rows)] = walkable_shares(batch, room, candidates[slice(*rows)])

        on_threads(one, [(k, k + 1) for k in range(len(candidates))], monitor)
        return found
    x0, y0, x1, y1 = room.region.box
    cell = max(CELL, math.sqrt((x1 - x0) * (y1 - y0) / MOST_CELLS))
    floor = Floor()
    floor.origin = wp.vec2(x0, y0)
    floor.cell = cell
    floor.nx, floor.ny = max(1, math.ceil((x1 - x0) / cell)), max(1, math.ceil((y1 - y0) / cell))
    floor.radius, floor.low, floor.high = room.walker or RADIUS, LOW, HIGH
    device, count = batch.device, len(candidates)
    grid = wp.zeros((count, floor.nx * floor.ny), dtype=wp.int32, device=device)
    queue = wp.zeros_like(grid)
    share = wp.zeros(count, dtype=wp.float32, device=device)
    selected = wp.array(candidates.astype(np.int32), dtype=wp.int32, device=device)
    centres = np.array([d.polygon.mean(axis=0) for d in room.region.doors.values()], dtype=np.float32).reshape(-1, 2)
    doors = wp.array(centres, dtype=wp.vec2, device=device)
    wp.launch(
        mark_floor,
        grid.shape,
        [batch.problems, floor, selected, batch.state],
        [grid],
        device=device,
    )
    wp.launch(walk, count, [floor, doors, grid, queue], [share], device=device)
    return share.numpy()
