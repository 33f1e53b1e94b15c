"""Designs on cores that are busy with other work: ``python -m benchmarks.busy_designs '{"designs": 30}'``.

Each design runs with all formats and the usual time limit on two cores, on which as many other processes compute all
the time. What counts is whether every file of a valid design is there, or the program says with exit code 5 which are
not, and whether there are pictures.

A task is a JSON object {"designs": N, "first": K, "cores": [[0, 1], ...], "time_limit": S, "out": DIR}, each with a
default. A line a design goes to stderr, and the counts as one line of JSON to stdout.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import Queue
from typing import Any

import yaml

from sceneweaver.export.formats import format_named, formats_named

REQUESTS = Path(__file__).with_name("requests.yaml")
BUSY = "while True: sum(i * i for i in range(100_000))"
PICTURES = ("top", "top_annotated", "corner")
ALWAYS = ("scene.json", "metrics.json", "report.html")
GRACE = 60.0  # [s] beyond the limit after which a design counts as hanging


def measure(task: dict[str, Any]) -> dict[str, Any]:
    """Run the designs, each pair of cores one at a time."""
    requests = yaml.safe_load(REQUESTS.read_text(encoding="utf-8"))
    first, count = int(task.get("first", 0)), int(task.get("designs", 30))
    pairs = task.get("cores") or [[0, 1]]
    free: Queue[list[int]] = Queue()
    others = []
    for pair in pairs:
        free.put(pair)
        others += [_started([sys.executable, "-c", BUSY], [core]) for core in pair]
    home = Path(task.get("out") or tempfile.mkdtemp(prefix="busy-"))

    def one(k: int) -> dict[str, Any]:
        cores = free.get()
        try:
            return _design(
                str(requests[k % len(requests)]), k, home / f"{k:03d}", float(task.get("time_limit", 120)), cores
            )
        finally:
            free.put(cores)

    try:
        with ThreadPoolExecutor(len(pairs)) as pool:
            rows = list(pool.map(one, range(first, first + count)))
    finally:
        for other in others:
            other.kill()
    return {
        "designs": len(rows),
        "exit_codes": dict(Counter(row["exit"] for row in rows)),
        "told": sum(row["told"] for row in rows),
        "with_pictures": sum(not row["without"] for row in rows),
        "longest": max(row["seconds"] for row in rows),
    }


def _started(command: list[str], cores: list[int], **more: Any) -> subprocess.Popen[str]:
    return subprocess.Popen(command, text=True, preexec_fn=lambda: os.sched_setaffinity(0, cores), **more)


def _design(request: str, seed: int, out: Path, limit: float, cores: list[int]) -> dict[str, Any]:
    """One design: ``told`` is whether all files are there, or exit code and list say which are not."""
    began = time.monotonic()
    command = [sys.executable, "-m", "sceneweaver.cli", "design", request, "--out", str(out), "--seed", str(seed)]
    command += ["--export", "all", "--time-limit", f"{limit:g}", "--device", "cpu", "--json"]
    process = _started(command, cores, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    try:
        said, errors = process.communicate(timeout=limit + GRACE)
    except subprocess.TimeoutExpired:
        process.kill()
        said, errors = "", "hangs"
    seconds = round(time.monotonic() - began, 1)
    try:
        data = json.loads(said)
    except ValueError:
        data = {}
    wanted = [
        *ALWAYS,
        *(format_named(name).file for name in formats_named("all")),
        *(f"views/{name}.png" for name in PICTURES),
    ]
    missing = [name for name in wanted if not (out / name).is_file()]
    left_out = {os.path.relpath(name, out) for name in data.get("left_out", ())}
    code = process.returncode
    told = code in (0, 3, 5) and set(missing) <= left_out and (code != 0 or not missing)
    row = {
        "exit": code,
        "seconds": seconds,
        "told": told,
        "missing": missing,
        "without": [name for name in missing if name.startswith("views/")],
    }
    line = f"{seed:3d} {code} {seconds:6.1f} s {'' if told else 'NOT TOLD '}{', '.join(missing) or 'all files'}"
    sys.stderr.write(f"{line} | {request}{' | ' + errors.strip()[-300:] if code not in (0, 3, 5) else ''}\n")
    sys.stderr.flush()
    return row


if __name__ == "__main__":
    sys.stdout.write(json.dumps(measure(json.loads(sys.argv[1]) if len(sys.argv) > 1 else {})) + "\n")
