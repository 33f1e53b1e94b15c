"""What a rival is, and the registry of those there are."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from benchmarks.settings import Settings
from sceneweaver.scene import Scene

QUICK = 16  # candidates at quick sizes

Solve = Callable[[Scene, np.ndarray, int, str], np.ndarray]
"""``solve(scene, starts [B, N, 4], seed, device)`` gives poses [B, N, 4]: world x, y, z [m] and yaw [rad].

It may start again from anywhere. What stands on an object is to be carried along (``benchmarks.starts.carry``).
"""

Prepare = Callable[[Scene, np.ndarray, str], None]
"""``prepare(scene, starts [B, N, 4], device)``: what is done once for such a call, such as compiling; never timed."""


@dataclass(frozen=True)
class Rival:
    """Another solver.

    Attributes:
        name: as tables show it.
        about: one sentence: what it does and what it is not asked to do.
        solve: see `Solve`; imports what it needs itself.
        missing: why it cannot run on a device, or None.
        most: how many candidates it is given for a scene of so many objects on a device: enough to keep the device
            busy, and so few that a run ends.
        prepare: see `Prepare`; None when there is nothing to do.
    """

    name: str
    about: str
    solve: Solve
    missing: Callable[[str], str | None]
    most: Callable[[int, str], int]
    prepare: Prepare | None = None


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
        reason = rival.missing(settings.device)
        notes.append(
            f"Rival {rival.name}: {rival.about}" if reason is None else f"Rival {rival.name} left out: {reason}"
        )
        if reason is None:
            found.append(rival)
    return found


def batch_size(rival: Rival, settings: Settings, objects: int) -> int:
    """How many candidates it is given where it may have as many as suit it."""
    most = rival.most(objects, settings.device)
    return settings.size(most, min(most, QUICK))


def solve(rival: Rival, scene: Scene, starts: np.ndarray, seed: int, device: str) -> tuple[np.ndarray, float]:
    """Its layouts and how long it took without its preparation [s].

    Poses that are not finite are put at the origin, for the judge to see.
    """
    if rival.prepare is not None:
        rival.prepare(scene, starts, device)
    began = time.perf_counter()
    poses = np.asarray(rival.solve(scene, starts, seed, device), dtype=np.float64)
    seconds = time.perf_counter() - began
    if poses.shape != starts.shape:
        raise ValueError(f"rival {rival.name} returned poses of shape {poses.shape}; expected {starts.shape}")
    return np.nan_to_num(poses, nan=0.0, posinf=0.0, neginf=0.0), seconds
