"""Records of blocks: when each was made, by whom, and how much memory that took. They are no part of the data set."""

from __future__ import annotations

import json
import os
import resource
import socket
from contextlib import suppress
from pathlib import Path
from typing import Any

from ..folder import Folder


class Records:
    """The file that a run adds its records to."""

    def __init__(self, folder: Folder):
        self._path = folder.records / f"{socket.gethostname()}-{os.getpid()}.jsonl"

    def add(self, record: dict[str, Any]) -> None:
        """Write one record; without room on the disk it is lost, as nothing depends on it."""
        with suppress(OSError):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with open(self._path, "a", encoding="utf-8") as file:
                file.write(json.dumps(record) + "\n")


def read_records(folder: Folder) -> list[dict[str, Any]]:
    """The records of all runs of a data set, in order of their end.

    Each has ``block``, ``start`` and ``end`` [s since 1970], ``worker``, ``host``, ``pid``, ``rss`` and ``peak_rss``
    [bytes], ``bytes`` (of the block), ``rooms``, and how many scenes were ``ok``, ``rejected`` and ``failed``.
    """
    found = []
    for path in sorted(folder.records.glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
            with suppress(ValueError):  # the last line of a run that was killed may be torn
                found.append(json.loads(line))
    return sorted(found, key=lambda record: record["end"])


def memory() -> tuple[int, int]:
    """Resident memory of this process now and at its peak [bytes]."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return peak, peak
    return pages * resource.getpagesize(), peak
