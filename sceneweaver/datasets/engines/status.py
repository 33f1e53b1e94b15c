"""How far a data set is."""

from __future__ import annotations

import time
from collections import Counter
from dataclasses import dataclass
from typing import Any

from ..reading import rows_of
from .manifest import Dataset
from .records import read_records
from .run import whole

RECENT = 600.0
"""Seconds over which the rate of a run is measured."""

MOST_REASONS = 20


@dataclass(frozen=True)
class Status:
    """How far a data set is.

    Attributes:
        blocks: how many it has.
        made: how many of them are there.
        whole: whether it is packed.
        rows: scenes, or programs of layouts, by status.
        rate: scenes a second, all runs on it together, of the last ten minutes of work.
        running: whether a block was made within the last ten minutes.
        reasons: why scenes were not delivered, the most frequent first.
    """

    blocks: int
    made: int
    whole: bool
    rows: dict[str, int]
    rate: float
    running: bool
    reasons: dict[str, int]

    @property
    def seconds_left(self) -> float | None:
        """Seconds until all blocks are made at the present rate; None when nobody is at work."""
        made = sum(self.rows.values())
        if not self.running or not self.rate or not self.made:
            return None
        return made / self.made * (self.blocks - self.made) / self.rate

    def to_dict(self) -> dict[str, Any]:
        """All of it as JSON."""
        return {
            "blocks": self.blocks,
            "made": self.made,
            "whole": self.whole,
            "rows": self.rows,
            "scenes_a_second": self.rate,
            "seconds_left": self.seconds_left,
            "reasons": self.reasons,
        }


def status(dataset: Dataset) -> Status:
    """Read how far a data set is; runs may be at work on it."""
    folder, blocks = dataset.folder, dataset.requests.blocks
    complete = folder.complete.exists() or whole(dataset)
    made = blocks if complete else sum(folder.block(number).exists() for number in range(blocks))
    rows, reasons = Counter({"ok": 0, "rejected": 0, "failed": 0}), Counter()
    for row in rows_of(folder, ["status", "reason"]):
        rows[row["status"]] += 1
        if row["status"] != "ok":
            reasons[row.get("reason") or "no reason given"] += 1
    records = read_records(folder)
    if dataset.spec.product == "layouts":  # whose rows are programs
        rows = Counter({name: sum({r["block"]: r[name] for r in records}.values()) for name in rows})
    last = records[-1]["end"] if records else 0.0
    return Status(
        blocks=blocks,
        made=made,
        whole=whole(dataset),
        rows=dict(rows),
        rate=_rate([record for record in records if record["end"] > last - RECENT]),
        running=not complete and last > time.time() - RECENT,
        reasons=dict(reasons.most_common(MOST_REASONS)),
    )


def _rate(records: list[dict[str, Any]]) -> float:
    """Scenes a second of some records."""
    if not records:
        return 0.0
    scenes = sum(record["ok"] + record["rejected"] + record["failed"] for record in records)
    seconds = max(record["end"] for record in records) - min(record["start"] for record in records)
    return scenes / seconds if seconds > 0 else 0.0
