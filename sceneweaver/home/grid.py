"""The grid of 1 mm that homes lie on."""

from __future__ import annotations

GRID = 1e-3
"""Step of the grid [m]."""

ROUNDING = 1e-7
"""How far [m] a double may be from the grid: its own rounding."""


def on_grid(value: float) -> bool:
    """Whether a length [m] is whole millimetres."""
    return abs(value - round(value, 3)) <= ROUNDING


def millimetres(value: float) -> int:
    """A length [m] as the nearest whole millimetres."""
    return round(value * 1000)
