"""The memory of this process: what the system says of it, and giving back what is free."""

from __future__ import annotations

import ctypes
import resource
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any


def memory() -> tuple[int, int]:
    """Resident memory of this process now and at its peak [bytes]."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return peak, peak
    return pages * resource.getpagesize(), peak


def resident(pid: int) -> int:
    """Resident memory of a process [bytes]; 0 where the system does not say, or the process is gone."""
    try:
        return int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * resource.getpagesize()
    except OSError:
        return 0


@contextmanager
def freed_memory_given_back() -> Iterator[None]:
    """At the end, give the system back what was freed within.

    The C library of Linux keeps what was freed between two things that are still in use. Caches that let go of one
    thing for another leave many such places, and a process that makes one room after the other would grow by them.
    """
    try:
        yield
    finally:
        trim = _trim()
        if trim is not None:
            trim(0)


@cache
def _trim() -> Any:
    """The function of the C library; None where it has none."""
    if not sys.platform.startswith("linux"):
        return None
    return getattr(ctypes.CDLL(None), "malloc_trim", None)
