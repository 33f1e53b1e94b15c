"""What the system says of the memory of this process."""

from __future__ import annotations

import resource
from pathlib import Path


def memory() -> tuple[int, int]:
    """Resident memory of this process now and at its peak [bytes]."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return peak, peak
    return pages * resource.getpagesize(), peak
