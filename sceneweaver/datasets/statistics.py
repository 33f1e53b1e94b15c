"""What a data set is made of, in numbers: counts, spreads, variety. Streaming: rows are seen once and not kept."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.knowledge import room_types

SCHEMA = "sceneweaver.dataset-statistics/1"

BINS: Mapping[str, tuple[float, float, int]] = {
    "area": (0.0, 120.0, 24),
    "object_count": (0.0, 200.0, 40),
    "relation_count": (0.0, 120.0, 24),
    "grade": (0.0, 10.0, 40),
    "clutter": (0.0, 1.0, 20),
    "walkable_share": (0.0, 1.0, 20),
    "openable_share": (0.0, 1.0, 20),
    "relations_satisfied": (0.0, 1.0, 20),
}
"""Columns that are numbers: lower and upper end of their histogram, and its bins."""


class Spread:
    """Count, mean, deviation, extremes and a histogram of numbers; the outer bins hold what lies beyond them."""

    def __init__(self, low: float, high: float, bins: int):
        self.low, self.high = low, high
        self.counts = [0] * bins
        self.number, self._sum, self._squares = 0, 0.0, 0.0
        self._least, self._most = math.inf, -math.inf

    def add(self, value: float) -> None:
        """One number more."""
        place = int((value - self.low) / (self.high - self.low) * len(self.counts))
        self.counts[min(max(place, 0), len(self.counts) - 1)] += 1
        self.number += 1
        self._sum += value
        self._squares += value * value
        self._least, self._most = min(self._least, value), max(self._most, value)

    def result(self) -> dict[str, Any]:
        """As plain JSON; without numbers only their count, 0."""
        if not self.number:
            return {"count": 0}
        mean = self._sum / self.number
        deviation = math.sqrt(max(0.0, self._squares / self.number - mean * mean))
        found = {"mean": mean, "deviation": deviation, "least": self._least, "most": self._most}
        rounded = {name: round(value, 6) for name, value in found.items()}
        return {"count": self.number, **rounded, "low": self.low, "high": self.high, "histogram": self.counts}


def statistics(rows: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """The statistics of a data set, as ``meta/statistics.json`` holds them.

    Shares are of all requests, spreads and variety are over the delivered scenes. Categories and their entropy are
    counted by scenes that have them. Distinct shells are counted by kind of room, number of walls and area to 0.01 m2,
    so that there are at least as many.

    Args:
        rows: rows of the index, in order; of a data set of layouts its programs.

    Returns:
        Plain JSON without times: equal rows give equal statistics.
    """
    gathered = _Gathered()
    for row in rows:
        gathered.add(row)
    return gathered.result()


class _Gathered:
    """What is gathered of rows, one by one."""

    def __init__(self) -> None:
        names = ("status", "split", "kind", "room_type", "licence", "attempt", "reasons", "gates_failed", "unmet")
        self.tallies: dict[str, Counter[str]] = {name: Counter() for name in (*names, "categories")}
        self.sums = Counter[str]()
        self.spreads = {name: Spread(*bins) for name, bins in BINS.items()}
        self.grades: dict[str, Spread] = {}
        self.rooms, self.signatures, self.shells, self.groups = set(), set(), set(), Counter()

    def add(self, row: Mapping[str, Any]) -> None:
        """One row more."""
        tallies = self.tallies
        tallies["status"][row["status"]] += 1
        if row["status"] != "ok":
            tallies["reasons"][_short(row.get("reason"))] += 1
            tallies["gates_failed"].update(k for k, passed in (row.get("gates") or {}).items() if passed is False)
            return
        self.sums["invalid"] += row.get("valid") is False
        for name in ("bytes", "layouts", "object_count"):
            self.sums[name] += row.get(name) or 0
        for name in ("split", "kind", "room_type", "attempt"):
            if row.get(name) is not None:
                tallies[name][str(row[name])] += 1
        for name, column in (("licence", "licences"), ("categories", "categories")):
            tallies[name].update(set(row.get(column) or ()))
        tallies["unmet"].update(row.get("unmet") or ())
        for name, spread in self.spreads.items():
            if row.get(name) is not None:
                spread.add(float(row[name]))
        for name, grade in (row.get("grades") or {}).items():
            if grade is not None:
                self.grades.setdefault(name, Spread(0.0, 10.0, 40)).add(grade)
        self.rooms.add(row.get("room"))
        # What is only counted is kept by its hash: memory grows by some tens of bytes a row.
        if row.get("layout_signature"):
            self.signatures.add(hash(row["layout_signature"]))
        if row.get("area") is not None:
            self.shells.add((row.get("room_type"), row.get("wall_count"), round(row["area"], 2)))
        if row.get("near_duplicate_group") is not None:
            self.groups[row["near_duplicate_group"]] += 1

    def result(self) -> dict[str, Any]:
        """All of it as plain JSON."""
        tallies, sums = {name: _sorted(tally) for name, tally in self.tallies.items()}, self.sums
        seen = tallies.pop("categories")
        things, requests, ok = self.tallies["categories"], self.tallies["status"].total(), self.tallies["status"]["ok"]
        twins = sum(count for count in self.groups.values() if count > 1)
        return {
            "schema": SCHEMA,
            "requests": requests,
            "scenes": ok,
            "rooms": len(self.rooms),
            "served": _share(ok, requests),
            "invalid": sums["invalid"],
            "bytes": sums["bytes"],
            "objects": sums["object_count"],
            **({"layouts": sums["layouts"]} if sums["layouts"] else {}),
            **tallies,
            "unmet": dict(list(tallies["unmet"].items())[:50]),
            "spreads": {name: spread.result() for name, spread in self.spreads.items()},
            "grades": {name: spread.result() for name, spread in sorted(self.grades.items())},
            "categories": seen,
            "diversity": {
                "categories": len(things),
                "category_entropy": round(entropy(things), 4),
                "effective_categories": round(2 ** entropy(things), 2),
                "layout_signatures": len(self.signatures),
                "shells": len(self.shells),
                "near_duplicates": twins,
                "near_duplicate_share": _share(twins, self.groups.total()),
            },
            "coverage": {
                "categories": _coverage(set(things), set(categories())),
                "room_types": _coverage(set(self.tallies["room_type"]), set(room_types())),
            },
        }


def entropy(tally: Mapping[Any, int]) -> float:
    """Shannon entropy [bits] of what is counted."""
    total = sum(tally.values())
    return -sum(count / total * math.log2(count / total) for count in tally.values() if count)


def _coverage(seen: set[str], known: set[str]) -> dict[str, Any]:
    """How much of what the knowledge base knows is there."""
    used = len(seen & known)
    return {"seen": used, "known": len(known), "share": _share(used, len(known)), "unseen": sorted(known - seen)}


def _sorted(tally: Mapping[str, int]) -> dict[str, int]:
    return dict(sorted(tally.items(), key=lambda pair: (-pair[1], pair[0])))


def _share(part: float, whole: float) -> float:
    return round(part / whole, 6) if whole else 0.0


def _short(reason: Any) -> str:
    """A reason without what differs between scenes: what stands behind the first colon."""
    return str(reason or "unknown").split(":")[0].strip()
