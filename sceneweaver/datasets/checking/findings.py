"""What a check of a data set finds: faults, counted by kind, and numbers that add up."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

Check = Literal[
    "checksum",
    "index",
    "shard",
    "content",
    "split",
    "licence",
    "asset",
    "judge",
    "record",
    "gate",
    "export",
    "compile",
    "stability",
]
CHECKS: tuple[str, ...] = get_args(Check)

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
    check: Check
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

    def fault(self, check: Check, key: str, detail: str) -> None:
        """Note a fault."""
        self.faults[check] += 1
        kept = self.first.setdefault(check, [])
        kept.append(Fault(key, check, detail))
        if len(kept) > 2 * KEPT:
            self.first[check] = sorted(kept)[:KEPT]

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
