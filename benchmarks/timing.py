"""Timing a call of the engine."""

from __future__ import annotations

import time
from typing import Any

from benchmarks.settings import Settings
from sceneweaver.layout import Solution, refine
from sceneweaver.scene import Scene


def timed(scene: Scene, settings: Settings, **options: Any) -> tuple[Solution, float]:
    """Call ``refine``: the solution and the wall time from call to return [s].

    Solutions come back as NumPy arrays, so that nothing is left running on the device.
    """
    began = time.perf_counter()
    solution = refine(scene, device=settings.device, **options)
    return solution, time.perf_counter() - began


def warm(scene: Scene, settings: Settings, init: Any = "sample", **options: Any) -> None:
    """Compile and load what a call needs, outside of what is timed."""
    refine(scene, candidates=2, seed=settings.seed, init=init, device=settings.device, **options)
