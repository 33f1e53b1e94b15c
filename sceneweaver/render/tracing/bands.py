"""Kernels over many threads: at once on a GPU, in bands over Python threads on the CPU, where a kernel has one."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.runtime.threads import cores, map_threads

_BANDS = 8  # to a thread: between them a time limit is looked at


def launch(kernel: Any, count: int, before: list, after: list, out: list, deadline: float | None = None) -> None:
    """Run a kernel over ``count`` threads; the number of the first stands between its arguments.

    Raises:
        TimeoutError: ``deadline``, a time of ``time.monotonic``, has passed.
    """
    _check(deadline)
    if count == 0:
        return
    device = wp.get_device()
    threads = cores()
    if not device.is_cpu or count < 4096:
        wp.launch(kernel, count, [*before, 0, *after], out, device=device)
        return
    wp.launch(kernel, 1, [*before, 0, *after], out, device=device)  # compiles before there are threads
    cuts = np.linspace(0, count, _BANDS * threads + 1).astype(int)

    def work(k: int) -> None:
        _check(deadline)
        size = int(cuts[k + 1] - cuts[k])
        wp.launch(kernel, size, [*before, int(cuts[k]), *after], out, device=device)

    map_threads(work, range(_BANDS * threads), threads)


def _check(deadline: float | None) -> None:
    if deadline is not None and time.monotonic() > deadline:
        raise TimeoutError("picture: its time limit has passed")
