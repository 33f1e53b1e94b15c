"""The free floor of a room as a grid of cells."""

from __future__ import annotations

import math
from dataclasses import dataclass

import warp as wp

from sceneweaver.kernels.walk import Floor

CELL = 0.1
LOW, HIGH = 0.05, 1.8  # rugs are walked on, lamps are walked under
MOST_CELLS = 4_000  # of one room; larger rooms get larger cells


@dataclass(frozen=True)
class Grid:
    """Cells over the box (xmin, ymin, xmax, ymax) of a room [m]."""

    box: tuple[float, float, float, float]

    @property
    def cell(self) -> float:
        """Edge of a cell [m]."""
        x0, y0, x1, y1 = self.box
        return max(CELL, math.sqrt((x1 - x0) * (y1 - y0) / MOST_CELLS))

    @property
    def shape(self) -> tuple[int, int]:
        """Cells along x and along y."""
        x0, y0, x1, y1 = self.box
        return max(1, math.ceil((x1 - x0) / self.cell)), max(1, math.ceil((y1 - y0) / self.cell))

    @property
    def floor(self) -> Floor:
        """The grid as kernels take it."""
        floor = Floor()
        floor.cell, floor.origin = self.cell, wp.vec2(self.box[0], self.box[1])
        floor.nx, floor.ny = self.shape
        floor.radius, floor.low, floor.high = 0.0, LOW, HIGH
        return floor
