"""How a run went: scenes a second and memory of its workers, from the records of its blocks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from . import charts

BINS = 80
"""Points of the line of throughput."""


def throughput(records: Sequence[Mapping[str, Any]]) -> charts.Line:
    """Delivered scenes a second over minutes since the first block began; a block counts evenly over its time."""
    start = min(record["start"] for record in records)
    end = max(record["end"] for record in records)
    edges = np.linspace(0.0, max(end - start, 1e-3), min(BINS, 2 * len(records)) + 1)
    rate = np.zeros(len(edges) - 1)
    for record in records:
        first, last = record["start"] - start, max(record["end"] - start, record["start"] - start + 1e-3)
        inside = np.clip(np.minimum(edges[1:], last) - np.maximum(edges[:-1], first), 0.0, None)
        rate += record["ok"] * inside / (last - first)
    rate /= np.diff(edges)
    middle = (edges[1:] + edges[:-1]) / 2
    return "scenes a second", [(at / 60, value) for at, value in zip(middle.tolist(), rate.tolist(), strict=True)]


def memory(records: Iterable[Mapping[str, Any]]) -> list[charts.Line]:
    """Resident memory [MB] of each worker process over the scenes that it has made."""
    workers: dict[tuple[Any, ...], list[tuple[float, float]]] = {}
    for record in sorted(records, key=lambda record: record["end"]):
        if record.get("rss"):
            line = workers.setdefault((record.get("host"), record.get("worker"), record.get("pid")), [])
            made = sum(record.get(status, 0) for status in ("ok", "rejected", "failed"))
            line.append(((line[-1][0] if line else 0) + made, record["rss"] / 1e6))
    return [(f"worker {worker} on {host}", line) for (host, worker, _), line in workers.items() if len(line) > 1]


def throughput_svg(records: Sequence[Mapping[str, Any]]) -> str:
    """The line of throughput as an SVG; empty without records."""
    return charts.lines([throughput(records)], x="minutes", y="scenes a second") if records else ""


def memory_svg(records: Iterable[Mapping[str, Any]]) -> str:
    """The lines of memory as an SVG; empty without records."""
    return charts.lines(memory(records), x="scenes made by a worker", y="MB")
