"""Drake's non-penetration projection: the nearest layout to a given one in which nothing overlaps, by SNOPT.

Solids and walls only: relations, zones and openings play no part. The cost is the sum over floor objects of
dx^2 + dy^2 + (0.5 m/rad * dyaw)^2. What stands on an object moves with it.
"""

from __future__ import annotations

import multiprocessing
from importlib.util import find_spec
from multiprocessing.connection import Connection
from multiprocessing.context import SpawnProcess
from typing import Any

import numpy as np

from benchmarks.rivals.base import Rival, register
from benchmarks.starts import carry, movable
from sceneweaver.scene import Scene

LIMIT = 5.0  # [s] for a layout
BUILD = 120.0  # [s] for a process to start and to build a scene
GRACE = 1.0  # [s] from when the process should have given up to when it is ended
PLANE = (0, 1, 3)


def project(scene: Scene, start: np.ndarray, time_limit: float = LIMIT) -> tuple[np.ndarray, bool]:
    """The nearest non-penetrating layout to one layout, as far as SNOPT gets.

    Args:
        scene: what is to be placed; of its poses those of fixed and hanging objects are used, and how things stand on
            others.
        start: x, y, z [m] and yaw [rad] of all objects [N, 4].
        time_limit: seconds for SNOPT, after which the start comes back; the process itself gets one more.

    Returns:
        Poses [N, 4], and whether nothing sinks more than 1 mm into anything else.
    """
    floor, poses = movable(scene), np.array(start, dtype=np.float64)
    ok = True
    if len(floor):
        q, ok = _worker.nearest(scene.dumps(), poses[floor][:, PLANE].ravel(), time_limit)
        poses[np.ix_(floor, PLANE)] = q.reshape(-1, 3)
    return carry(scene, poses[None])[0], ok


def _serve(connection: Connection) -> None:
    from benchmarks.rivals.drake_solver import serve

    serve(connection)


class _Worker:
    """A process that runs Drake. Where it aborts or is late, the next call starts another one."""

    def __init__(self) -> None:
        self._process: SpawnProcess | None = None
        self._connection: Connection | None = None
        self._scene = ""

    def load(self, text: str) -> None:
        """Have a scene ready in a process."""
        if self._connection is None:
            context = multiprocessing.get_context("spawn")
            self._connection, theirs = context.Pipe()
            self._process = context.Process(target=_serve, args=(theirs,), daemon=True)
            self._process.start()
            theirs.close()
            self._scene = ""
        if text != self._scene:
            if self._ask(text, BUILD) is None:
                raise RuntimeError("drake's process ended while it built a scene")
            self._scene = text

    def nearest(self, text: str, start: np.ndarray, seconds: float) -> tuple[np.ndarray, bool]:
        """See ``drake_solver.nearest``; the start, not ok, where the process ends or is late."""
        self.load(text)
        return self._ask((start, seconds), seconds + GRACE) or (start, False)

    def _ask(self, task: Any, seconds: float) -> Any:
        """Its answer; None, and the process is gone, where it has none in time."""
        assert self._connection is not None and self._process is not None
        try:
            self._connection.send(task)
            if self._connection.poll(seconds):
                return self._connection.recv()
        except (EOFError, OSError):
            pass
        self._process.kill()
        self._process.join()
        self._connection.close()
        self._connection = self._process = None
        return None


_worker = _Worker()


def solve(scene: Scene, starts: np.ndarray, seed: int, device: str) -> np.ndarray:
    """One layout after the other; nothing is drawn by chance."""
    return np.array([project(scene, start)[0] for start in starts])


def prepare(scene: Scene, starts: np.ndarray, device: str) -> None:
    """Start the process and build the plant."""
    _worker.load(scene.dumps())


def _missing(device: str) -> str | None:
    return None if find_spec("pydrake") else "drake is not installed"


def _most(objects: int, device: str) -> int:
    return 64 if objects <= 19 else 16 if objects <= 30 else 2


register(
    Rival(
        name="drake projection",
        about="Drake's nearest non-penetrating layout (SNOPT, planar joints, one layout at a time on one core, at most "
        "5 s each); it is not asked for relations, zones or openings.",
        solve=solve,
        prepare=prepare,
        missing=_missing,
        most=_most,
    )
)
