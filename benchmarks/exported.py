"""What an exported scene does in plain MuJoCo, in a process that knows nothing else of it."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from statistics import fmean
from typing import Any

from benchmarks.designs import LIBRARY
from benchmarks.results import Column
from sceneweaver.assets import Asset
from sceneweaver.export.mjcf import write_mjcf
from sceneweaver.physics import mjcf_file
from sceneweaver.scene import Scene

SECONDS = 3.0

COLUMNS = (
    Column("room", "room"),
    Column("objects", "objects", "number"),
    Column("free", "free", "number"),
    Column("far", "> 0.1 m", "share"),
    Column("little", "> 0.01 m", "share"),
    Column("mean", "mean [mm]", "number"),
    Column("most", "most [mm]", "number"),
    Column("doors", "doors", "number"),
    Column("ajar", "ajar, most", "share"),
    Column("parts", "parts", "number"),
    Column("contacts", "contacts", "number"),
    Column("write_s", "write [s]", "number"),
    Column("run_s", "run [s]", "number"),
    Column("faster", "sleeping, x real time", "number"),
)
_WORST = ("most", "ajar")  # of which the table by rooms shows the largest, not the mean


def measure(scene: Scene, seconds: float = SECONDS, load: Callable[[str], Asset] | None = None) -> dict[str, Any]:
    """Export a scene and let it loose in another process: the columns of the table, ``moved`` [m] by id, ``problems``.

    Raises:
        RuntimeError: MuJoCo does not take the export.
    """
    script = Path(mjcf_file.__file__)
    with tempfile.TemporaryDirectory() as folder:
        began = time.perf_counter()
        path = write_mjcf(scene, Path(folder) / "scene", load or LIBRARY.load)
        written = time.perf_counter() - began
        found = _run(script, path, seconds)
        sleeping = _run(script, path.with_name("scene-sleep.xml"), seconds)
    far = list(found["moved"].values())
    problems = [] if found["finite"] else ["diverged"]
    problems += [f"{name} {count} times" for name, count in found["warnings"].items()]
    return {
        "objects": float(len(scene.objects)),
        "free": float(len(far)),
        **_shares(far),
        "mean": 1e3 * fmean(far or [0.0]),
        "most": 1e3 * max(far, default=0.0),
        **{key: float(found[key]) for key in ("doors", "ajar", "parts", "contacts", "run_s")},
        "faster": seconds / sleeping["run_s"],
        "write_s": written,
        "moved": found["moved"],
        "problems": problems,
    }


def _run(script: Path, path: Path, seconds: float) -> dict[str, Any]:
    """What the script prints of a file."""
    command = [sys.executable, "-I", str(script), str(path), str(seconds)]
    done = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=3600)
    if done.returncode:
        raise RuntimeError(f"MuJoCo does not take the export: {done.stderr.strip()[-1000:]}")
    return json.loads(done.stdout.strip().splitlines()[-1])


def _shares(far: Sequence[float]) -> dict[str, float]:
    count = max(1, len(far))
    return {"far": sum(v > 0.1 for v in far) / count, "little": sum(v > 0.01 for v in far) / count}


def joined(name: str, rows: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """One row for several scenes: shares and the mean are over all their bodies."""
    far = [v for row in rows for v in row["moved"].values()]
    keys = [c.key for c in COLUMNS[1:]]
    means = {key: (max if key in _WORST else fmean)(row[key] for row in rows) for key in keys}
    return {"room": name, **means, **_shares(far), "mean": 1e3 * fmean(far or [0.0])}
