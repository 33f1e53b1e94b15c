"""How far a data set is, and what it will cost, from a sample of it that is made and thrown away."""

from __future__ import annotations

import math
import tempfile
import time
from collections import Counter
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.runtime.processes import cores

from ..folder import Folder
from ..reading import rows_of
from ..work import Produce
from .local import LocalEngine
from .manifest import Dataset, create, devices, load_source
from .run import whole
from .schedule import Job, Listener, Options, read_records

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
        """Seconds until all blocks are made at the present rate; None when no run is at work."""
        made = sum(self.rows.values())
        if not self.running or not self.rate or not self.made:
            return None
        return made / self.made * (self.blocks - self.made) / self.rate

    def to_dict(self) -> dict[str, Any]:
        """All of it as JSON."""
        data = asdict(self) | {"scenes_a_second": self.rate, "seconds_left": self.seconds_left}
        names = ("blocks", "made", "whole", "rows", "scenes_a_second", "seconds_left", "reasons")
        return {name: data[name] for name in names}


def status(dataset: Dataset) -> Status:
    """Read how far a data set is; runs may be at work on it."""
    folder, blocks = dataset.folder, dataset.requests.blocks
    complete = folder.complete.exists() or whole(dataset)
    made = blocks if complete else sum(folder.block(number).exists() for number in range(blocks))
    rows, reasons = Counter({"ok": 0, "rejected": 0, "failed": 0}), Counter()
    for row in rows_of(folder, ["status", "reason"]):
        rows[str(row.get("status"))] += 1
        if row.get("status") != "ok":
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


@dataclass(frozen=True)
class Estimate:
    """What a data set will cost.

    Attributes:
        count: scenes that it has.
        sample: scenes that were made to find out.
        workers: processes that this holds for.
        scene_seconds: worker seconds a scene, without what a worker needs to begin.
        start_seconds: seconds until the first worker began.
        scene_bytes: of files that belong to one scene.
        asset_bytes: of files that scenes share, when all are made.
        shares: scenes that were ok, rejected and failed.
    """

    count: int
    sample: int
    workers: int
    scene_seconds: float
    start_seconds: float
    scene_bytes: float
    asset_bytes: float
    shares: dict[str, int]

    @property
    def rate(self) -> float:
        """Scenes a second of all workers."""
        return self.workers / self.scene_seconds if self.scene_seconds else math.inf

    @property
    def seconds(self) -> float:
        """That the whole data set will take."""
        return self.start_seconds + self.count / self.rate

    @property
    def bytes(self) -> float:
        """On the disk when all is made; packing needs some hundred MB more for a while."""
        return self.count * self.scene_bytes + self.asset_bytes

    def to_dict(self) -> dict[str, Any]:
        """All of it as JSON."""
        return {
            "count": self.count,
            "sample": self.sample,
            "workers": self.workers,
            "scenes_a_second": self.rate,
            "seconds": self.seconds,
            "start_seconds": self.start_seconds,
            "bytes": self.bytes,
            "bytes_a_scene": self.scene_bytes,
            "asset_bytes": self.asset_bytes,
            "sample_status": self.shares,
        }


def estimate(
    source: Path,
    sample: int = 20,
    workers: int | None = None,
    device: str = "auto",
    listener: Listener | None = None,
    produce: Produce | None = None,
) -> Estimate:
    """Make the first scenes of a data set in a temporary folder, and reckon what all of them cost.

    Args:
        source: a specification in YAML.
        sample: scenes to make at least, as far as there are so many.
        workers: processes; None: one for each core.
        device: where rooms are laid out.
        listener: hears of blocks and troubles.
        produce: what makes scenes, if not `produce`.
    """
    spec, inputs = load_source(source)
    workers, count = workers or cores(), spec.count
    rooms = min(-(-sample // spec.rooms.layouts), -(-count // spec.rooms.layouts))
    block = max(1, min(spec.block, rooms // (2 * workers)))  # two for each worker; what is made does not depend on it
    few = spec.model_copy(update={"count": min(count, rooms * spec.rooms.layouts), "block": block})
    with tempfile.TemporaryDirectory(prefix="sceneweaver-plan-") as place:
        dataset = create(Folder(Path(place) / "set"), few, device, inputs)
        growth: list[tuple[int, int]] = []
        records: list[dict[str, Any]] = []

        def block_done(record: dict[str, Any]) -> None:
            records.append(record)
            growth.append((sum(r["ok"] + r["rejected"] + r["failed"] for r in records), _bytes(dataset.folder.assets)))
            if listener is not None:
                listener.block(record)

        notice = listener.notice if listener is not None else lambda text: None
        names = devices(device, spec)
        options = Options(workers, patient=False)
        engine = LocalEngine(Job(dataset, Listener(block_done, notice), options, produce), names)
        engine.run(range(dataset.requests.blocks))
    made = growth[-1][0]
    return Estimate(
        count=count,
        sample=made,
        workers=workers,
        scene_seconds=sum(record["end"] - record["start"] for record in records) / made,
        start_seconds=min(record["start"] for record in records) - engine.began,
        scene_bytes=sum(record["bytes"] for record in records) / made,
        asset_bytes=grown(growth, count),
        shares={status: sum(record[status] for record in records) for status in ("ok", "rejected", "failed")},
    )


def grown(growth: list[tuple[int, int]], count: int) -> float:
    """How large a store of assets will be, by the power law that fits its growth; never more than in proportion.

    Args:
        growth: after so many scenes, so many bytes.
        count: scenes in the end.
    """
    scenes, size = (np.array(values, dtype=float) for values in zip(*growth, strict=True))
    last = size[-1]
    if not last:
        return 0.0
    slope = np.polyfit(np.log(scenes), np.log(np.maximum(size, 1.0)), 1)[0] if len(set(scenes)) > 1 else 1.0
    return float(last * (count / scenes[-1]) ** min(max(slope, 0.0), 1.0))


def _bytes(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
