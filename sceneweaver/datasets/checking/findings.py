"""What a check of a data set finds: faults, counted by kind, numbers that add up, and a page about both."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from sceneweaver.io.messages import clean, printable_line
from sceneweaver.scene import Scene
from sceneweaver.verify import Report

from ..templates import render

CHECKS = {
    "file": "all files are regular ones of the data set: none is missing, a link, a pipe, a device, or foreign",
    "manifest": "dataset.json and what it names are what the data set was begun with, and agree with the index",
    "checksum": "shards, tables and assets have the SHA-256 that is listed",
    "index": "rows are complete, in order, and have reasons where nothing was delivered",
    "shard": "every delivered scene lies in its shard once, and nothing else does",
    "content": "the files of each scene have the hash and size of its row",
    "split": "no room, content or group of near-duplicates is in two splits",
    "licence": "the licence of every asset is known, and named by the scenes that have it",
    "asset": "every file that a GLB or MJCF names is in the store",
    "judge": "the judge finds every scene valid: nothing collides, leaves the room, floats or breaks a relation",
    "record": "what index and metrics.json record is what is measured",
    "gate": "every delivered scene passes the gates of the specification",
    "export": "objects stand in GLB and MJCF where scene.json has them",
    "compile": "MuJoCo compiles the sample of MJCF files",
    "stability": "nothing diverges, or moves farther than a gate allows",
}
"""The checks, with what holds where they find nothing."""

LONGEST = 400
"""Most characters of what is said of a fault."""

KEPT = 10
"""How many faults of each kind are kept, those of the first keys."""


@dataclass(frozen=True, order=True)
class Fault:
    """One thing that is not as it should be.

    Attributes:
        key: of the scene; of what concerns no scene the path of a file.
        check: which check found it.
        detail: one line.
    """

    key: str
    check: str
    detail: str


@dataclass
class Findings:
    """What some checks found. Adding others gives the same in any order, and takes no more memory.

    Attributes:
        faults: how many there are by check.
        first: of each check the first by key.
        counts: how much was checked, by name.
        shifts: of things let loose in MuJoCo: how many, over 1 cm, over 10 cm, sum [m].
        unsteady: the things that moved farthest: (shift [m], key, object).
    """

    faults: Counter[str] = field(default_factory=Counter)
    first: dict[str, list[Fault]] = field(default_factory=dict)
    counts: Counter[str] = field(default_factory=Counter)
    shifts: Counter[str] = field(default_factory=Counter)
    unsteady: list[tuple[float, str, str]] = field(default_factory=list)

    def fault(self, check: str, key: str, detail: str) -> None:
        """Note a fault."""
        self.faults[check] += 1
        key, detail = clean(str(key)), printable_line(detail, LONGEST)
        kept = self.first.setdefault(check, [])
        kept.append(Fault(key, check, detail))
        if len(kept) > 2 * KEPT:
            self.first[check] = sorted(kept)[:KEPT]

    def judged(self, key: str, scene: Scene, report: Report) -> None:
        """Note what the judge says of a scene."""
        for name, count in (
            ("objects", len(scene.objects)),
            ("collisions", report.collisions),
            ("out of bounds", report.out_of_bounds),
        ):
            self.counts[name] += count
        if not report.valid:
            worst = next(v for v in report.violations if v.hard)
            self.fault("judge", key, f"is not valid: {worst.kind}: {worst.detail}")

    def moved(self, key: str, shifts: dict[str, float]) -> None:
        """Note how far [m] the free things of a scene moved."""
        self.shifts["things"] += len(shifts)
        self.shifts["over 1 cm"] += sum(far > 0.01 for far in shifts.values())
        self.shifts["over 10 cm"] += sum(far > 0.1 for far in shifts.values())
        self.shifts["micrometres"] += round(1e6 * sum(shifts.values()))
        farthest = [(round(far, 4), key, name) for name, far in shifts.items() if far > 0.01]
        self.unsteady = sorted([*self.unsteady, *farthest], key=lambda row: (-row[0], row[1:]))[:KEPT]

    def add(self, other: Findings) -> None:
        """Take over what others found."""
        for mine, theirs in ((self.faults, other.faults), (self.counts, other.counts), (self.shifts, other.shifts)):
            mine.update(theirs)
        for check, faults in other.first.items():
            self.first[check] = sorted([*self.first.get(check, []), *faults])[:KEPT]
        self.unsteady = sorted([*self.unsteady, *other.unsteady], key=lambda row: (-row[0], row[1:]))[:KEPT]

    def stability(self) -> dict[str, Any] | None:
        """Shares of things that moved and their mean shift; None where nothing was let loose."""
        things = self.shifts["things"]
        if not self.counts["simulated"]:
            return None
        count = max(things, 1)
        return {
            "scenes": self.counts["simulated"],
            "things": things,
            "moved_over_0_01m": self.shifts["over 1 cm"] / count,
            "moved_over_0_1m": self.shifts["over 10 cm"] / count,
            "mean_shift_m": 1e-6 * self.shifts["micrometres"] / count,
            "farthest": [{"key": key, "object": name, "shift_m": far} for far, key, name in self.unsteady],
        }


def markdown(data: Mapping[str, Any]) -> str:
    """The page."""
    return render("checking/verification.md", **data, checks=CHECKS)
