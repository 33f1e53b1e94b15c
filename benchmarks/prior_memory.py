"""Does the prior repeat what it was trained on? Distances to training layouts, and of layouts from each other."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.prior_data import all_words, read_parts
from benchmarks.results import Column, Result
from sceneweaver.prior.tokens import tokens_of
from sceneweaver.scene import Scene

MISSING = 2.0
"""Distance, in units of the room, of an object whose category the other layout lacks."""

COLUMNS = (
    Column("layouts", "layouts"),
    Column("count", "count", "count"),
    Column("least", "least", "number"),
    Column("tenth", "10 %", "number"),
    Column("median", "median", "number"),
    Column("near", "nearer than 5 cm of 2 m", "share"),
)


def spread(scene: Scene, poses: np.ndarray) -> float | None:
    """How far apart the same object stands in two layouts [B, N, 4], on average [m]; None for a single layout."""
    free = [i for i, o in enumerate(scene.objects) if not o.fixed]
    if len(poses) < 2 or not free:
        return None
    xy = np.asarray(poses, dtype=np.float64)[:, free, :2]
    apart = np.linalg.norm(xy[:, None] - xy[None], axis=-1).mean(axis=-1)
    return float(apart.sum() / (len(xy) * (len(xy) - 1)))


def nearest(
    layout: np.ndarray, categories: np.ndarray, others: np.ndarray, theirs: np.ndarray, there: np.ndarray
) -> float:
    """Distance of a layout [N, 4] to the nearest of others [L, M, 4], in units of the room.

    Of each object the distance to the nearest one of its category, averaged over objects; the other way round as well,
    of both the larger. Rooms are compared in their frames, turned by quarters.
    """
    best = np.inf
    same = (categories[:, None] == theirs[:, None, :]) & there[:, None, :]  # [L, N, M]
    for quarter in range(4):
        c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter]
        turned = np.stack([c * layout[:, 0] - s * layout[:, 1], s * layout[:, 0] + c * layout[:, 1]], axis=-1)
        apart = np.linalg.norm(turned[None, :, None] - others[:, None, :, :2], axis=-1)
        apart = np.where(same, np.minimum(apart, MISSING), MISSING)
        one = apart.min(axis=2).mean(axis=1)
        two = np.where(there, apart.min(axis=1), 0.0).sum(axis=1) / np.maximum(there.sum(axis=1), 1)
        best = min(best, float(np.maximum(one, two).min()))
    return best


def memory_table(result: Result, folder: Path, rooms: Sequence[dict[str, Any]]) -> None:
    """Distances of layouts of held-out rooms to the training layouts of their kind."""
    words, data = all_words(), read_parts(folder)
    first = np.concatenate([[0], np.cumsum(data["counts"])])
    found: dict[str, list[float]] = {"sample": [], "prior": [], "drawn": []}
    for room in rooms:
        scene = Scene.loads(room["scene"])
        tokens = tokens_of(scene, words)
        chosen = np.flatnonzero(data["token.kind"] == words.kind(room["kind"]))
        if not len(chosen):
            continue
        rows = np.concatenate([np.arange(first[k], first[k + 1]) for k in chosen])
        owner = np.repeat(chosen, data["counts"][chosen])
        theirs = data["token.categories"][owner]
        there = data["token.mask"][owner][:, -theirs.shape[1] :]
        for name, distances in found.items():
            for poses in room.get(name, ())[:2]:
                mine = tokens.local(poses)
                distances.append(nearest(mine, tokens.categories, data["poses"][rows], theirs, there))
    table = result.add("memory", "Distance to the nearest training layout of the kind, in units", list(COLUMNS))
    for name, distances in found.items():
        if distances:
            values = np.array(distances)
            table.rows.append(
                {"layouts": name, "count": len(values), "least": float(values.min())}
                | {"tenth": float(np.quantile(values, 0.1)), "median": float(np.median(values))}
                | {"near": float((values < 0.025).mean())}
            )
    result.notes.append(
        "Layouts of held-out rooms that the engine found from its own starts (`sample`) and from the prior's "
        "(`prior`), and the prior's own (`drawn`): were it to repeat what it was trained on, these would be nearer."
    )
