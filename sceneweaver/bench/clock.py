"""Time spent in a method: wall and processor time, with all devices waited for."""

from __future__ import annotations

import sys
import time
from typing import Any

import warp as wp


class Stopwatch:
    """Adds up the time inside ``with`` blocks [s]."""

    def __init__(self, device: str) -> None:
        self.device = device
        self.wall = self.cpu = 0.0
        self._began = (0.0, 0.0)

    def __enter__(self) -> Stopwatch:
        settle(self.device)
        self._began = (time.perf_counter(), time.process_time())
        return self

    def __exit__(self, *_: Any) -> None:
        settle(self.device)
        wall, cpu = self._began
        self.wall += time.perf_counter() - wall
        self.cpu += time.process_time() - cpu


def settle(device: str, state: Any = None) -> None:
    """Wait for what is under way on a device, for PyTorch's work as well, and for the arrays of JAX in a state."""
    wp.synchronize_device(device)
    if (torch := sys.modules.get("torch")) and device != "cpu":
        torch.cuda.synchronize(device)
    if state is not None and (jax := sys.modules.get("jax")):
        jax.block_until_ready(state)
