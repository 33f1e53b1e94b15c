"""When a process began."""

from __future__ import annotations

import os
import time
from pathlib import Path


def process_began() -> float:
    """When this process began, by ``time.monotonic()`` [s]: a time limit counts what it took to start as well."""
    try:
        ticks = float(Path("/proc/self/stat").read_text().rpartition(")")[2].split()[19])
        return time.monotonic() - max(0.0, time.clock_gettime(time.CLOCK_BOOTTIME) - ticks / os.sysconf("SC_CLK_TCK"))
    except (OSError, ValueError, IndexError, AttributeError):  # no Linux
        return time.monotonic()
