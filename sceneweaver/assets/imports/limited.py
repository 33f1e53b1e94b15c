"""Native code that may crash or never end, in a process of its own with a time limit."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from sceneweaver.io import read_arrays

_MEMORY = 2 << 30
"""Most bytes that a reader of files may take."""

_ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "PXR_WORK_THREAD_LIMIT": "1"}
"""Threads of many cores would take that memory for their stacks."""


class LimitedError(RuntimeError):
    """The work was not done: too slow, crashed, or refused; the text says which."""


def run_limited(task: str, arrays: dict[str, np.ndarray], seconds: float) -> dict[str, np.ndarray]:
    """Run ``TASKS[task]`` on arrays in another process and return its arrays.

    Raises:
        LimitedError: after ``seconds``, or when the process failed.
    """
    with tempfile.TemporaryDirectory(prefix="sceneweaver-") as folder:
        given, made = Path(folder, "given.npz"), Path(folder, "made.npz")
        np.savez(given, **arrays)  # pyright: ignore[reportArgumentType]
        command = [sys.executable, "-m", f"{__package__}.limited", task, str(given), str(made)]
        try:
            done = subprocess.run(
                command,
                capture_output=True,
                timeout=seconds,
                stdin=subprocess.DEVNULL,
                env={**os.environ, **_ONE_THREAD},
            )
        except subprocess.TimeoutExpired:
            raise LimitedError(f"not done within {seconds:g} s") from None
        if done.returncode or not made.exists():
            lines = done.stderr.decode(errors="replace").strip().splitlines()
            raise LimitedError(lines[-1][:160] if lines else f"ended with code {done.returncode}")
        return read_arrays(made)


def _decompose(arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """CoACD: convex parts of a mesh."""
    import coacd

    coacd.set_log_level("error")
    mesh = coacd.Mesh(arrays["vertices"], arrays["faces"])
    parts = coacd.run_coacd(
        mesh,
        threshold=float(arrays["threshold"]),
        max_convex_hull=int(arrays["limit"]),
        preprocess_mode="off" if arrays["manifold"] else "auto",
        max_ch_vertex=64,
        seed=0,
    )
    points = [np.asarray(v, dtype=np.float64) for v, _ in parts]
    return {"points": np.concatenate(points), "counts": np.array([len(p) for p in points])}


def _simplify(arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Quadric edge collapse, piece by piece; what resists (loose triangles) is snapped to a grid.

    Each connected piece keeps triangles in proportion to its area, so that a finely meshed leg does not cost a coarsely
    meshed cushion its shape.
    """
    from .pieces import linked

    pieces = []
    for group in np.unique(arrays["groups"]):
        points, triangles = _welded(arrays["vertices"], arrays["faces"][arrays["groups"] == group], 1e-7)
        if not len(triangles):
            continue
        label = linked(len(points), triangles[:, :2], triangles[:, 1:])[triangles[:, 0]]
        order = np.argsort(label, kind="stable")
        for mine in np.split(order, np.flatnonzero(np.diff(label[order])) + 1):
            a, b, c = (points[triangles[mine, k]] for k in range(3))
            area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
            used, packed = np.unique(triangles[mine], return_inverse=True)
            pieces.append((points[used], packed.reshape(-1, 3), group, area))
    goals = _shares([len(t) for _, t, *_ in pieces], [area for *_, area in pieces], int(arrays["target"]))
    vertices, faces, groups = [], [], []
    start = 0
    for (points, triangles, group, _), goal in zip(pieces, goals, strict=True):
        if len(triangles) > goal:
            points, triangles = _collapsed(points, triangles, goal)
        step = 5e-3
        while len(triangles) > 1.1 * goal + 12 and step < 0.5:
            points, triangles = _welded(points, triangles, step)
            step *= 1.3
        vertices.append(points)
        faces.append(triangles + start)
        groups.append(np.full(len(triangles), group))
        start += len(points)
    return {"vertices": np.concatenate(vertices), "faces": np.concatenate(faces), "groups": np.concatenate(groups)}


def _shares(counts: list[int], areas: list[float], target: int) -> list[int]:
    """How many triangles each piece may keep: by area, and what small pieces leave over goes to the others."""
    least = 48 if 48 * len(counts) <= target // 2 else 4
    goals = [min(count, least) for count in counts]
    for _ in range(8):
        rest = target - sum(goals)
        open_ = [k for k, count in enumerate(counts) if goals[k] < count]
        total = sum(areas[k] for k in open_)
        if rest <= 0 or not open_ or total <= 0:
            break
        for k in open_:
            goals[k] = min(counts[k], goals[k] + int(rest * areas[k] / total))
    return goals


def _collapsed(points: np.ndarray, triangles: np.ndarray, goal: int) -> tuple[np.ndarray, np.ndarray]:
    import fast_simplification

    share = min(0.9999, 1.0 - goal / len(triangles))
    made = fast_simplification.simplify(
        points.astype(np.float32),  # pyright: ignore[reportArgumentType]
        triangles.astype(np.int32),
        target_reduction=share,
    )
    return np.asarray(made[0], dtype=np.float64), np.asarray(made[1], dtype=np.int64)


def _welded(points: np.ndarray, triangles: np.ndarray, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Vertices of one grid cell (``step`` of the largest extent) as one, and what is left of the triangles."""
    used, packed = np.unique(triangles, return_inverse=True)
    points, triangles = points[used], packed.reshape(-1, 3)
    cell = np.round((points - points.min(axis=0)) / (step * max(float(np.ptp(points, axis=0).max()), 1e-12)))
    _, first, joined = np.unique(cell, axis=0, return_index=True, return_inverse=True)
    triangles = joined.reshape(-1)[triangles]
    a, b, c = triangles.T
    triangles = triangles[(a != b) & (b != c) & (c != a)]
    _, once = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    return points[first], triangles[np.sort(once)].astype(np.int64)


def _read_usd(arrays: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The meshes of a USD file, in bounded memory."""
    import resource

    from .usd_mesh import read_usd

    resource.setrlimit(resource.RLIMIT_DATA, (_MEMORY, _MEMORY))
    return read_usd(Path(str(arrays["path"])))


TASKS = {"decompose": _decompose, "simplify": _simplify, "read_usd": _read_usd}


if __name__ == "__main__":
    _result = TASKS[sys.argv[1]](read_arrays(sys.argv[2]))
    _part = Path(sys.argv[3] + ".part.npz")
    np.savez(_part, **_result)  # pyright: ignore[reportArgumentType]
    _part.rename(sys.argv[3])
