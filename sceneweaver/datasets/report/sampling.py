"""Which scenes of a data set its report shows, chosen while their rows go by."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

PICTURES, PAIRS = 400, 8
"""Plans on the wall, and pairs of near-duplicates, at most."""

_SHOWN = ("key", "prompt", "room_type", "grade", "object_count", "area", "split")


class Sampler:
    """Of each kind of room equally many scenes, spread over the set; and the first near-duplicates.

    Args:
        pictures: scenes on the wall, at most.

    Attributes:
        pairs: keys of near-duplicates, two and two.
    """

    def __init__(self, pictures: int = PICTURES) -> None:
        self._most = pictures
        self.pairs: list[tuple[str, str]] = []
        self._kept: dict[str, list[dict[str, Any]]] = {}
        self._seen: Counter[str] = Counter()
        self._groups: dict[int, str] = {}
        self._rng = np.random.default_rng(0)

    def watch(self, rows: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
        """The rows as they come."""
        for row in rows:
            if row["status"] == "ok":
                self._choose(row)
                self._group(row)
            yield row

    def wall(self) -> dict[str, dict[str, Any]]:
        """The rows for the wall by key; one kind of room after the other takes its turn."""
        order = np.random.default_rng(0).permutation
        left = {kind: [rows[k] for k in order(len(rows))] for kind, rows in sorted(self._kept.items())}
        chosen: dict[str, dict[str, Any]] = {}
        while left and len(chosen) < self._most:
            for kind in list(left):
                row = left[kind].pop(0)
                chosen[row["key"]] = row
                if not left[kind]:
                    del left[kind]
        return dict(list(chosen.items())[: self._most])

    def _choose(self, row: dict[str, Any]) -> None:
        """Reservoir sampling within a kind of room."""
        kind = row.get("room_type") or ""
        kept = self._kept.setdefault(kind, [])
        self._seen[kind] += 1
        place = len(kept) if len(kept) < self._most else int(self._rng.integers(self._seen[kind]))
        if place < self._most:
            kept[place : place + 1] = [{name: row.get(name) for name in _SHOWN}]

    def _group(self, row: dict[str, Any]) -> None:
        group, key = row.get("near_duplicate_group"), row["key"]
        if group is None or len(self.pairs) == PAIRS:
            return
        first = self._groups.setdefault(group, key)
        if first != key and all(first != pair[0] for pair in self.pairs):
            self.pairs.append((first, key))
