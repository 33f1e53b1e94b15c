"""Annealing of sequence pairs in a fixed outline, for any problem of the zoo.

After Murata, Fujiyoshi, Nakatake and Kajitani, "VLSI Module Placement Based on Rectangle-Packing by the
Sequence-Pair", IEEE TCAD 1996.

Two orders of the blocks: what is before another in both lies left of it, what is before it in the second alone lies
below. Moves exchange two blocks in one order or in both, or turn one. `sequence_pair` packs, and is the same method on
blocks and nets alone.

Fairness: as for `bstar_tree`: rectangles with their hard zones, quarter turns, nets, the engine's energy of the packed
layout; compact packings only, one layout at a time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .floorplans import Floorplan, Packing
from .sequence_pair import reach


@dataclass(frozen=True)
class SequencePair(Floorplan):
    def packing(self, blocks: int, rng: np.random.Generator) -> Packing:
        return Pair([int(b) for b in rng.permutation(blocks)], [int(b) for b in rng.permutation(blocks)])


class Pair:
    """Two orders of blocks."""

    def __init__(self, first: list[int], second: list[int]) -> None:
        self.first, self.second = first, second

    def pack(self, width: list[float], height: list[float]) -> tuple[list[float], list[float]]:
        place = [0] * len(width)
        for p, block in enumerate(self.second):
            place[block] = p
        x, y = [0.0] * len(width), [0.0] * len(width)
        if width:
            reach(self.first, place, width, x)
            reach(self.first[::-1], place, height, y)
        return x, y

    def moved(self, rng: np.random.Generator) -> Pair:
        first, second = self.first[:], self.second[:]
        if len(first) > 1:
            a, b = (int(v) for v in rng.choice(len(first), 2, replace=False))
            both = rng.random() < 0.5
            for order in (first, second) if both else ((first,) if rng.random() < 0.5 else (second,)):
                i, j = order.index(a), order.index(b)
                order[i], order[j] = b, a
        return Pair(first, second)
