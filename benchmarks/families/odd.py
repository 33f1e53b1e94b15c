"""Odd requests, each in a process of its own: nothing ends with a fault, in time, or with a wrong claim."""

from __future__ import annotations

import importlib.util
import json
import os
import queue
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.judging import Judge
from benchmarks.odd_requests import KINDS, odd_requests
from benchmarks.parallel import core_shares
from benchmarks.results import Column, Result
from benchmarks.settings import ROOT, Settings
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import InputError, Scene

EACH, QUICK = 15, 2
"""Requests of each kind, and in all to see that everything works."""

LIMIT, TOLERANCE, PATIENCE = 30.0, 2.0, 180.0
"""The time limit [s] that each is given, by how much it may be overrun, and when it is killed."""

BRIEF_LIMIT = 6.0
"""The time limit [s] when it is only to be seen that everything works, however busy the machine is."""

CORES_EACH = 2
"""Cores for each process: the limit is for one that has some to itself."""

KEPT = ("scene.json", "metrics.json", "state.json")
"""Files that have to be there, and whole, when a scene was made."""

COLUMNS = (
    Column("kind", "kind"),
    Column("count", "requests", "count"),
    Column("satisfied", "all so", "count"),
    Column("unmet", "something unmet", "count"),
    Column("refused", "refused", "count"),
    Column("errors", "errors", "count"),
    Column("overruns", "overruns", "count"),
    Column("invalid", "invalid at exit 0", "count"),
    Column("p50", "p50 s", "number"),
    Column("p95", "p95 s", "number"),
)


@dataclass(frozen=True)
class Run:
    """How one request ended: exit code, seconds, what was wrong with it, and with a scene that claims to be valid."""

    kind: str
    text: str
    code: int
    seconds: float
    error: str = ""
    invalid: str = ""
    limit: float = LIMIT

    @property
    def overrun(self) -> bool:
        """Whether it took longer than it was given."""
        return self.seconds > self.limit + TOLERANCE


def run(settings: Settings, judge: Judge) -> Result:
    """Send all requests, several at a time, and look at how each one ended."""
    del judge
    result = Result(
        "odd",
        "Odd requests",
        f"Requests by a grammar, each in a process of its own with a limit of {LIMIT:g} s. An error is an exit code "
        "other than 0, 2 and 3, a traceback, a refusal of more than one line, or files that are missing or not whole; "
        f"an overrun is more than {LIMIT + TOLERANCE:g} s from start to end; a scene at exit 0 is judged by the "
        "independent checker of the tests.",
    )
    asked = odd_requests(1 if settings.quick else EACH, settings.seed)[: QUICK if settings.quick else None]
    with tempfile.TemporaryDirectory(prefix="sceneweaver-odd-") as folder:
        limit = BRIEF_LIMIT if settings.quick else LIMIT
        send("warm-up", "a small bedroom", 0, Path(folder, "warm"), settings.device, limit)  # compiles the kernels
        with _cores(settings.jobs) as pool:
            jobs = [
                pool.submit(send, kind, text, settings.seed + k, Path(folder, str(k)), settings.device, limit)
                for k, (kind, text) in enumerate(asked)
            ]
            runs = [job.result() for job in jobs]
    tabulate(result, runs, late=not settings.quick)
    return result


@contextmanager
def _cores(jobs: int) -> Iterator[ThreadPoolExecutor]:
    """Threads that each have a few cores to themselves, for themselves and for the processes that they start."""
    shares = core_shares(min(jobs, max(1, cores() // CORES_EACH)))
    left: queue.SimpleQueue[list[int]] = queue.SimpleQueue()
    for share in shares:
        left.put(share)
    with ThreadPoolExecutor(len(shares), initializer=lambda: os.sched_setaffinity(0, left.get())) as pool:
        yield pool


def send(kind: str, text: str, seed: int, out: Path, device: str, limit: float = LIMIT) -> Run:
    """Design one request by the command line."""
    command = [sys.executable, "-m", "sceneweaver", "design", "--json", "--time-limit", str(limit), "--seed", str(seed)]
    command += ["--device", device, "--out", str(out), "--", text]
    began = time.monotonic()
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace", timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return Run(kind, text, -1, time.monotonic() - began, f"killed after {PATIENCE:g} s", limit=limit)
    seconds = time.monotonic() - began
    error = _error(done, out)
    invalid = _invalid(out / "scene.json") if done.returncode == 0 and not error else ""
    return Run(kind, text, done.returncode, seconds, error, invalid, limit)


def _error(done: subprocess.CompletedProcess[str], out: Path) -> str:
    """What is wrong with how a process ended; empty when nothing is."""
    said = done.stderr.strip()
    last = said.splitlines()[-1] if said else ""
    if done.returncode not in (0, 2, 3) or "Traceback" in said or "unexpected" in last:
        return f"exit {done.returncode}: {last if done.returncode >= 0 else ' / '.join(said.splitlines()[:8])}"
    try:
        stated = json.loads(done.stdout)
    except ValueError:
        return f"exit {done.returncode}: no JSON on stdout"
    if done.returncode == 2:
        return "" if said.count("\n") == 0 and "error" in stated else f"refused in several lines: {said[:200]}"
    try:
        for name in KEPT:
            json.loads((out / name).read_text(encoding="utf-8"))
        Scene.load(out / "scene.json")
    except (OSError, ValueError, InputError) as error:
        return f"exit {done.returncode}: {error}"
    broken = [text for text in stated.get("undone", ()) if "unexpected" in text]
    if broken:
        return f"exit {done.returncode}: {broken[0]}"
    missing = [name for name in stated["files"] if not Path(name).stat().st_size]
    left = [path.name for path in out.rglob(".sceneweaver-*")]
    return f"empty or left behind: {missing + left}" if missing or left else ""


def _invalid(path: Path) -> str:
    """What the checker of the tests finds wrong with a scene; empty when nothing is."""
    try:
        found = _checker()(json.loads(path.read_text(encoding="utf-8")))
    except Exception as error:  # one scene that breaks the checker is no reason to lose what all others came to
        return f"the checker broke down: {type(error).__name__}: {error}"
    wrong = {key: value for key, value in found.items() if value and key in _WRONG}
    return json.dumps(wrong) if wrong else ""


_WRONG = ("collisions", "oob", "zones", "openings", "support", "hard_failed")


def _checker() -> Any:
    spec = importlib.util.spec_from_file_location("oracle_check_scene", ROOT / "tests" / "oracle" / "check_scene.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    known = module.holds

    def holds(relation: dict[str, Any], *rest: Any) -> bool:
        """Relation types that are younger than the checker are left to the tests of the judge."""
        if isinstance(relation.get("target"), list):  # it knows no relation of two targets
            return True
        try:
            return known(relation, *rest)
        except ValueError as error:
            if str(error) == relation["type"]:
                return True
            raise

    module.holds = holds
    return module.check


def tabulate(result: Result, runs: list[Run], late: bool = True) -> None:
    """A row for each kind, a sum, and a line for everything that went wrong; ``late`` says whether overruns did."""
    table = result.add("odd", "Odd requests", COLUMNS)
    for kind in (*KINDS, "all"):
        mine = [r for r in runs if kind in (r.kind, "all")]
        if not mine:
            continue
        seconds = np.array([r.seconds for r in mine])
        table.rows.append(
            {
                "kind": kind,
                "count": len(mine),
                "satisfied": sum(r.code == 0 for r in mine),
                "unmet": sum(r.code == 3 for r in mine),
                "refused": sum(r.code == 2 for r in mine),
                "errors": sum(bool(r.error) for r in mine),
                "overruns": sum(r.overrun for r in mine),
                "invalid": sum(bool(r.invalid) for r in mine),
                "p50": float(np.percentile(seconds, 50)),
                "p95": float(np.percentile(seconds, 95)),
            }
        )
    for r in runs:
        for what in (r.error, r.invalid, f"took {r.seconds:.1f} s" if r.overrun and late else ""):
            if what:
                result.failures.append(f"{r.kind}: {r.text[:100]!r}: {what}")
