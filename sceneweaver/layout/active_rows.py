"""The rows of a projection that are active at a layout, and how they change with poses and parameters.

They are the projection's own (`kernels.linearise`), taken down with their keys, so that a row is known again where
poses or parameters are a little different.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.kernels import load_for
from sceneweaver.kernels.inequality import ARM, ROWS, SLACK
from sceneweaver.kernels.linearise import linearise
from sceneweaver.kernels.projection import choose_options
from sceneweaver.optimizers import Batch, Monitor
from sceneweaver.optimizers.projection import new_system

Problem = Any  # its module imports this one, so it cannot be named here

REACH = 0.01
"""[m] clearance below which something gets a row."""

NEAR = 4.0e-4
"""[m] beyond where a projection leaves a row under force, up to which it counts as active."""


@dataclass
class Rows:
    """Rows of one layout: keys, clearances [R] beyond what a projection leaves [m], derivatives [R, N, 4] by roots."""

    keys: list[tuple[int, int]]
    clearance: np.ndarray
    slope: np.ndarray

    def matched(self, keys: list[tuple[int, int]]) -> tuple[np.ndarray, np.ndarray]:
        """Clearances and derivatives of the rows with some keys; NaN where there is none."""
        at = {key: i for i, key in enumerate(self.keys)}
        index = np.array([at.get(key, len(self.keys)) for key in keys], dtype=np.int64)
        clearance = np.append(self.clearance, np.nan)
        slope = np.concatenate([self.slope, np.full((1, *self.slope.shape[1:]), np.nan)])
        return clearance[index], slope[index]


def movement_weights(objects: int) -> np.ndarray:
    """The weights [N, 4] of a squared movement, as a projection has them."""
    return np.tile([1.0, 1.0, 1.0, float(ARM) ** 2], (objects, 1))


def batch_for(problem: Problem, poses: np.ndarray, which: np.ndarray) -> Batch:
    """Layouts [K, N, 4] with the option of every relation that is nearest to each."""
    batch = problem.batch(poses.astype(np.float32), which)
    if batch.size and batch.relations:
        everyone = wp.array(np.arange(batch.size, dtype=np.int32), dtype=wp.int32, device=batch.device)
        load_for(choose_options, batch.device)
        wp.launch(
            choose_options,
            (batch.size, batch.relations),
            [batch.problems, everyone],
            [batch.state],
            device=batch.device,
        )
    return batch


def rows_of(problem: Problem, poses: np.ndarray, which: np.ndarray, options: np.ndarray | None = None) -> list[Rows]:
    """The rows of layouts [K, N, 4], with the nearest options or with given ones [K, relations]."""
    batch = batch_for(problem, poses, which)
    if options is not None:
        batch.state.options.assign(options)
    system, _ = new_system(batch, Monitor(batch.size))
    system.reach, system.plain = REACH, 1
    system.live.fill_(1)
    everyone = wp.array(np.arange(batch.size, dtype=np.int32), dtype=wp.int32, device=batch.device)
    load_for(linearise, batch.device)
    wp.launch(
        linearise, (batch.size, batch.objects), [batch.problems, everyone, batch.state], [system], device=batch.device
    )
    count, keys, rows = system.count.numpy(), system.keys.numpy(), system.rows.numpy()
    return [_taken(count[k], keys[k], rows[k], problem.objects) for k in range(batch.size)]


def _taken(count: np.ndarray, keys: np.ndarray, rows: np.ndarray, objects: int) -> Rows:
    slots = np.concatenate([obj * int(ROWS) + np.arange(n) for obj, n in enumerate(count.tolist())]).astype(np.int64)
    body, jacobian = rows["body"][slots].reshape(-1, 3), rows["jacobian"][slots].reshape(-1, 3, 4)
    slope = np.zeros((slots.size, objects + 1, 4))
    for k in range(3):
        np.add.at(slope, (np.arange(slots.size), body[:, k]), np.where(body[:, k, None] >= 0, jacobian[:, k], 0.0))
    named = list(zip((slots // int(ROWS)).tolist(), keys[slots].tolist(), strict=True))
    return Rows(named, float(SLACK) - rows["goal"][slots].astype(np.float64) - float(SLACK), slope[:, :objects])
