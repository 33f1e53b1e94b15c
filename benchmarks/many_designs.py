"""Memory over many designs in one process: ``python -m benchmarks.many_designs '{"designs": 200}'``.

A task is a JSON object {"designs": N, "device": D, "seed": S}, each with a default. What the process holds is said on
stderr after every `EVERY` designs, and at the end one line of JSON: ``mib`` by number of designs, and ``ratio``, how
much is held at the end by comparison with after `WARM` designs (null where there were fewer).
"""

from __future__ import annotations

import gc
import json
import os
import sys
from typing import Any

EVERY = 10
WARM = 40
"""Designs after which caches are full."""

REQUESTS = (
    "a bedroom with a desk by the window",
    "a small study with two bookcases",
    "a living room with a sofa and a tv",
    "a kitchen for a family",
    "a bathroom with a shower",
)


def held_mib() -> float:
    """What this process holds in memory now [MiB]; 0 where the system does not say."""
    gc.collect()
    try:
        with open("/proc/self/statm", encoding="utf-8") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
    except OSError:
        return 0.0


def measure(task: dict[str, Any]) -> dict[str, Any]:
    """Short designs, one after the other, without pictures and files."""
    from sceneweaver.agent import design

    count, seed, every = int(task.get("designs", 200)), int(task.get("seed", 0)), int(task.get("every", EVERY))
    held: dict[int, float] = {}
    for k in range(1, count + 1):
        request = REQUESTS[k % len(REQUESTS)]
        options: dict[str, Any] = {"steps": 1, "candidates": 8, "generations": 0, "time_limit": None}
        design(request, seed=seed + k, device=task.get("device", "cpu"), **options)
        if k % every == 0 or k == count:
            held[k] = round(held_mib(), 1)
            sys.stderr.write(f"{k} designs: {held[k]:.0f} MiB\n")
            sys.stderr.flush()
    ratio = round(held[count] / held[WARM], 4) if held.get(WARM) else None
    return {"mib": held, "warm": WARM, "ratio": ratio}


if __name__ == "__main__":
    sys.stdout.write("\n" + json.dumps(measure(json.loads(sys.argv[1]) if len(sys.argv) > 1 else {})) + "\n")
