"""Whether weights of soft relations are found again from rooms that were arranged for them."""

from __future__ import annotations

import time
from statistics import fmean
from typing import Any

from benchmarks.judging import Judge
from benchmarks.planted_weights import KINDS, arranged, cosine, forgotten, planted, wished
from benchmarks.results import Column, Result
from benchmarks.settings import Settings
from sceneweaver import Scene, learn_weights

FIRST = 1000
"""Seeds of the sets count from here; those below were there to develop with."""

SETS, QUICK_SETS = 10, 2
ROOMS, QUICK_ROOMS = 30, 16
WANTED = 0.95

COLUMNS = (
    Column("set", "set"),
    Column("rooms", "rooms", "count"),
    Column("cosine", "cosine", "number"),
    Column("worst", "worst weight", "number"),
    Column("equal", "cosine of equal weights", "number"),
    Column("left", "forces left", "share"),
    Column("arranging", "seconds to arrange", "number"),
    Column("learning", "seconds to learn", "number"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Plant weights, arrange rooms for them, and learn the weights from the poses."""
    del judge
    result = Result(
        "weights",
        "Weights from arranged rooms",
        f"In each set weights of {len(KINDS)} kinds of soft relations that contradict each other are drawn over a "
        "factor of six. Rooms with 18 of these, different ones each, are brought to rest for them by the search and "
        "L-BFGS, and the weights are learned from the poses alone. Worst: how many times too large or small the worst "
        f"weight is. A mean cosine below {WANTED} is a failure.",
    )
    table = result.add("sets", "Planted weights", COLUMNS)
    rooms = settings.size(ROOMS, QUICK_ROOMS)
    first = FIRST + settings.seed
    for seed in range(first, first + (QUICK_SETS if settings.quick else SETS)):
        table.rows.append(_one(seed, rooms, settings.device))
    mean = fmean(row["cosine"] for row in table.rows)
    result.notes.append(f"Mean cosine {mean:.3f}, least {min(row['cosine'] for row in table.rows):.3f}.")
    if mean < WANTED:
        result.failures.append(f"a mean cosine of {mean:.3f} is below {WANTED}")
    return result


def _one(seed: int, count: int, device: str) -> dict[str, Any]:
    weights = planted(seed)
    began = time.process_time()
    rooms: list[Scene] = [arranged(wished(100 * seed + k, weights), device=device) for k in range(count)]
    ready = time.process_time()
    learned = learn_weights([forgotten(room) for room in rooms], device=device)
    total = sum(weights.values()) / len(weights)
    ratios = [max(learned.weights.get(kind, 0.0), 1e-6) / (weights[kind] / total) for kind in weights]
    return {
        "set": str(seed),
        "rooms": count,
        "cosine": cosine(learned.weights, weights),
        "worst": max(max(ratio, 1 / ratio) for ratio in ratios),
        "equal": cosine(dict.fromkeys(weights, 1.0), weights),
        "left": learned.left,
        "arranging": ready - began,
        "learning": time.process_time() - ready,
    }
