"""Disjoint sets of numbers."""

from __future__ import annotations

import numpy as np


class UnionFind:
    """The numbers 0 to ``count - 1`` in sets that are joined one by one; a set is named by its smallest number."""

    def __init__(self, count: int):
        self._parent = np.arange(count)

    def find(self, number: int) -> int:
        """The smallest number of the set of a number."""
        parent = self._parent
        while parent[number] != number:
            parent[number] = parent[parent[number]]
            number = parent[number]
        return int(number)

    def join(self, a: int, b: int) -> None:
        """Make one set of two."""
        a, b = self.find(a), self.find(b)
        self._parent[max(a, b)] = min(a, b)

    def joined(self, a: int, b: int) -> bool:
        """Whether two numbers are in one set."""
        return self.find(a) == self.find(b)

    def names(self) -> np.ndarray:
        """The set of each number, shape [count]."""
        while not np.array_equal(up := self._parent[self._parent], self._parent):
            self._parent = up
        return self._parent.copy()
