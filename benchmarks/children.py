"""Measuring in a process of its own: ``python -m benchmarks.children TASK`` prints one line of JSON.

A task is a JSON object {"scenes": [room or number of objects ...], "candidates": B, "device": D, "seed": S}; for each
scene in turn the time of a first call and of a second one is taken. Nothing is imported before the clock runs.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from typing import Any

LIMIT_S = 3600


def run(
    task: dict[str, Any], environment: dict[str, str] | None = None, module: str = "benchmarks.children"
) -> dict[str, Any]:
    """Run a task of a module in a new process: what it printed, and ``process`` [s], its life as seen from here.

    Raises:
        RuntimeError: it failed; the message is the end of what it said.
    """
    from benchmarks.settings import ROOT

    command = [sys.executable, "-m", module, json.dumps(task)]
    began = time.perf_counter()
    done = subprocess.run(
        command, cwd=ROOT, env={**os.environ, **(environment or {})}, capture_output=True, text=True, timeout=LIMIT_S
    )
    if done.returncode:
        raise RuntimeError(f"a measuring process failed with {done.returncode}: {done.stderr.strip()[-2000:]}")
    found = json.loads(done.stdout.strip().splitlines()[-1])
    return {**found, "process": time.perf_counter() - began}


def peak_mib() -> float | None:
    """Most memory that this process ever held [MiB].

    ``resource.getrusage`` says more than that on Linux: a child's peak begins with what its parent held when it was
    started. ``VmHWM`` does not.
    """
    try:
        with open("/proc/self/status", encoding="utf-8") as file:
            return next(int(line.split()[1]) for line in file if line.startswith("VmHWM")) / 1024
    except (OSError, StopIteration):
        pass
    try:
        import resource
    except ImportError:
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1024 * 1024 if sys.platform == "darwin" else 1024)


def device_mib(device: str) -> float | None:
    """High-water mark of the GPU's memory pool [MiB]; None without one."""
    import warp as wp

    if not device.startswith("cuda") or not wp.is_mempool_enabled(device):
        return None
    return wp.get_mempool_used_mem_high(device) / 2**20


def _task(task: dict[str, Any]) -> dict[str, Any]:
    began = time.perf_counter()
    from sceneweaver.layout import refine

    imported = time.perf_counter() - began
    from benchmarks.floors import floor
    from benchmarks.rooms import load

    calls = []
    device = ""
    for name in task["scenes"]:
        scene = floor(name) if isinstance(name, int) else load(name)
        seconds = []
        for _ in range(task.get("repeat", 2)):
            start = time.perf_counter()
            solution = refine(scene, candidates=task["candidates"], seed=task["seed"], device=task["device"])
            seconds.append(time.perf_counter() - start)
        device = solution.device
        calls.append({"scene": name, "seconds": seconds, "valid": int((solution.status == 0).sum())})
    return {"imported": imported, "calls": calls, "peak_mib": peak_mib(), "device_mib": device_mib(device)}


if __name__ == "__main__":
    sys.stdout.write("\n" + json.dumps(_task(json.loads(sys.argv[1]))) + "\n")
