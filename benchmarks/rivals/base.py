"""What a rival is, and the registry of those there are."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from benchmarks.settings import Settings
from sceneweaver.scene import Scene

Solve = Callable[[Scene, np.ndarray, int, str], np.ndarray]
"""``solve(scene, starts [B, N, 4], seed, device)`` gives poses [B, N, 4]: world x, y, z [m] and yaw [rad].

It may start again from anywhere. What stands on an object is to be carried along (``benchmarks.starts.carry``).
"""


@dataclass(frozen=True)
class Rival:
    """Another solver.

    Attributes:
        name: as tables show it.
        about: one sentence: what it does and what it is not asked to do.
        solve: see `Solve`; imports what it needs itself.
        missing: why it cannot run here, or None.
        most: how many candidates it is given for a scene of so many objects, so that a run ends.
    """

    name: str
    about: str
    solve: Solve
    missing: Callable[[], str | None]
    most: Callable[[int], int]


RIVALS: dict[str, Rival] = {}


def register(rival: Rival) -> Rival:
    """Enter a rival under its name."""
    RIVALS[rival.name] = rival
    return rival


def present(settings: Settings, notes: list[str]) -> list[Rival]:
    """The rivals asked for that can run; a note says which cannot and why, and what the others are."""
    found = []
    for rival in RIVALS.values():
        if settings.rivals is not None and rival.name not in settings.rivals:
            continue
        reason = rival.missing()
        notes.append(
            f"Rival {rival.name}: {rival.about}" if reason is None else f"Rival {rival.name} left out: {reason}"
        )
        if reason is None:
            found.append(rival)
    return found


def solve(rival: Rival, scene: Scene, starts: np.ndarray, seed: int, device: str) -> tuple[np.ndarray, float]:
    """Its layouts and how long it took [s]; poses that are not finite are put at the origin, for the judge to see."""
    began = time.perf_counter()
    poses = np.asarray(rival.solve(scene, starts, seed, device), dtype=np.float64)
    seconds = time.perf_counter() - began
    if poses.shape != starts.shape:
        raise ValueError(f"rival {rival.name} returned poses of shape {poses.shape}; expected {starts.shape}")
    return np.nan_to_num(poses, nan=0.0, posinf=0.0, neginf=0.0), seconds
