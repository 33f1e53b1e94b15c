"""Convex parts of any mesh that together contain it: exact where pieces are convex, CoACD elsewhere.

CoACD: X. Wei et al., "Approximate Convex Decomposition for 3D Meshes with Collision-Aware Concavity and Tree
Search", ACM Transactions on Graphics 41 (2022). Its parts only come near the surface; each triangle is therefore given
to the part that it is nearest to, and that part grown around it.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
from pathlib import Path

import numpy as np

from sceneweaver.io import InputError, own_folder, read_arrays, write_atomic

from ..body import Hull
from ..shapes import containing_hull, hull
from .limited import LimitedError, run_limited
from .pieces import pieces_of

THRESHOLD = 0.05
MAX_HULLS = 32
MAX_PIECES = 48
_CONVEX = 0.97


def convex_parts(
    vertices: np.ndarray, faces: np.ndarray, *, cache: Path | None = None, seconds: float = 60.0
) -> tuple[list[Hull], list[str]]:
    """Hulls that contain a mesh, and notes on how they came about.

    Each connected piece that is convex is its own hull; the others go through CoACD, for ``seconds`` at most in all.
    Where that fails, the hull of the whole piece stands in: too large, never too small, and noted.
    """
    notes: list[str] = []
    pieces = pieces_of(vertices, faces)
    simple, rest = [], []
    for points, triangles in pieces:
        body = _hull(points)
        (simple if _is_convex(points, triangles, body) else rest).append((points, triangles, body))
    hulls = [body for *_, body in simple]
    if len(hulls) > MAX_PIECES:
        hulls = _merged(hulls, MAX_PIECES)
        notes.append(f"{len(simple)} convex pieces merged to {len(hulls)}")
    if rest:
        points = np.concatenate([p for p, *_ in rest])
        starts = np.cumsum([0] + [len(p) for p, *_ in rest])[:-1]
        triangles = np.concatenate([t + s for (_, t, _), s in zip(rest, starts, strict=True)])
        try:
            # A mesh that is no manifold is remeshed first, which lets parts stand out of it by a few millimetres.
            found = [
                np.clip(part, points.min(axis=0), points.max(axis=0))
                for part in _decomposed(points, triangles, cache, seconds)
            ]
            hulls += _grown(found, points, triangles)
        except LimitedError as error:
            bodies = _merged([body for *_, body in rest], MAX_HULLS)
            hulls += bodies
            notes.append(f"collision parts are whole hulls, too large: convex decomposition failed ({error})")
    return [Hull(v, f) for v, f in hulls], notes


def _hull(points: np.ndarray):
    """The convex hull, thickened a little where the points lie in a plane; at most 64 corners."""
    from scipy.spatial import QhullError

    try:
        body = hull(points)
    except ValueError:
        low, high = points.min(axis=0), points.max(axis=0)
        flat = np.maximum(2e-3 - (high - low), 0) / 2
        spread = np.concatenate([points + s * np.maximum(flat, 5e-4) * a for a in np.eye(3) for s in (-1, 1)])
        return hull(spread)
    if len(body[0]) <= 64:
        return body
    try:
        return containing_hull(points)
    except (QhullError, ValueError):  # too thin for that
        return body


def _volume(points: np.ndarray, triangles: np.ndarray) -> float:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def _is_convex(points: np.ndarray, triangles: np.ndarray, body) -> bool:
    whole = _volume(*body)
    thin = float(np.ptp(points, axis=0).min()) < 2e-3
    return thin or len(points) <= 4 or abs(_volume(points, triangles)) >= _CONVEX * whole


def _merged(bodies: list, limit: int) -> list:
    """Hulls merged, nearest first, until there are ``limit``."""
    bodies = list(bodies)
    if len(bodies) > 200:  # pairs would take long: by place first
        middles = np.array([v.mean(axis=0) for v, _ in bodies])
        order = np.lexsort((middles[:, 2], middles[:, 1], middles[:, 0]))
        groups = np.array_split(order, 200)
        bodies = [_hull(np.concatenate([bodies[i][0] for i in g])) for g in groups]
    low, high = np.array([v.min(axis=0) for v, _ in bodies]), np.array([v.max(axis=0) for v, _ in bodies])
    while len(bodies) > limit:
        span = (np.maximum(high[:, None], high[None]) - np.minimum(low[:, None], low[None])).prod(axis=2)
        cost = span - (high - low).prod(axis=1)[:, None] - (high - low).prod(axis=1)[None]
        cost[np.tril_indices(len(bodies))] = np.inf
        i, j = divmod(int(np.argmin(cost)), len(bodies))
        bodies[i] = _hull(np.concatenate([bodies[i][0], bodies[j][0]]))
        low[i], high[i] = bodies[i][0].min(axis=0), bodies[i][0].max(axis=0)
        del bodies[j]
        low, high = np.delete(low, j, axis=0), np.delete(high, j, axis=0)
    return bodies


def _decomposed(points: np.ndarray, triangles: np.ndarray, cache: Path | None, seconds: float) -> list[np.ndarray]:
    """CoACD's parts as point sets; from the cache when the same mesh was there before."""
    manifold = _is_manifold(triangles)
    key = hashlib.sha256(points.tobytes() + triangles.astype(np.int64).tobytes())
    key.update(f"coacd 1 {THRESHOLD} {MAX_HULLS} {manifold}".encode())
    file = None if cache is None else cache / "coacd" / f"{key.hexdigest()}.npz"
    made = _kept(file)
    if made is None:
        made = run_limited(
            "decompose",
            {
                "vertices": points,
                "faces": triangles,
                "threshold": np.array(THRESHOLD),
                "limit": np.array(MAX_HULLS),
                "manifold": np.array(manifold),
            },
            seconds,
        )
        if file is not None:
            _keep(file, made)
    return np.split(made["points"], np.cumsum(made["counts"])[:-1])


def _kept(file: Path | None) -> dict[str, np.ndarray] | None:
    """What was found before; None where nothing was, or where it is not whole."""
    if file is None or not os.path.exists(file):
        return None
    try:
        return read_arrays(file)
    except InputError:
        return None


def _keep(file: Path, made: dict[str, np.ndarray]) -> None:
    """Keep what was found for the next time; where that cannot be written, it is found again then."""
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **made)  # pyright: ignore[reportArgumentType]
    with contextlib.suppress(OSError, InputError):
        file.parents[2].mkdir(parents=True, exist_ok=True)
        own_folder(file.parents[1])
        own_folder(file.parent)
        write_atomic(file, buffer.getvalue())


def _is_manifold(triangles: np.ndarray) -> bool:
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    return bool((counts == 2).all())


def _grown(parts: list[np.ndarray], points: np.ndarray, triangles: np.ndarray) -> list:
    """The parts' hulls, each grown around the triangles that it is nearest to, so that all lie in their union."""
    hulls = [_hull(p) for p in parts]
    corners = points[triangles]
    best = np.full(len(triangles), np.inf)
    owner = np.zeros(len(triangles), dtype=int)
    for k, (v, f) in enumerate(hulls):
        normal = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-15)
        offset = np.einsum("ij,ij->i", normal, v[f[:, 0]])
        outside = (corners.reshape(-1, 3) @ normal.T - offset).max(axis=1).reshape(-1, 3).max(axis=1)
        nearer = outside < best
        best[nearer], owner[nearer] = outside[nearer], k
    grown = []
    for k, body in enumerate(hulls):
        mine = corners[(owner == k) & (best > 1e-9)].reshape(-1, 3)
        grown.append(_hull(np.concatenate([body[0], mine])) if len(mine) else body)
    return grown
