"""Annealing of B*-trees in a fixed outline (Chang, Chang, Wu and Wu, "B*-Trees: A New Representation for Non-Slicing
Floorplans", DAC 2000; fixed outline after Adya and Markov, TVLSI 2003).

A left child lies against the right side of its parent, a right child above it at the same x; heights follow from a
contour. Moves turn a block, exchange two, or take one out and put it in elsewhere. Written from the papers.

Fairness: it sees one rectangle for a block (with its hard zones, if ``zones``), quarter turns, the box around the
room, nets and flows, and the engine's energy of the packed layout, by which relations, doors and walls enter its cost;
packings are compact, so places in the middle of a room do not exist for it. It pays for one layout at a time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .floorplans import Floorplan, Packing


@dataclass(frozen=True)
class BStarTree(Floorplan):
    def packing(self, blocks: int, rng: np.random.Generator) -> Packing:
        tree = Tree([int(b) for b in rng.permutation(blocks)])
        for slot in range(1, blocks):  # a complete binary tree
            parent = (slot - 1) // 2
            tree.up[slot] = parent
            (tree.left if slot % 2 else tree.right)[parent] = slot
        return tree


class Tree:
    """Slots with the block in each, parents and children (-1: none)."""

    def __init__(self, block: list[int]) -> None:
        self.block = block
        self.up, self.left, self.right = ([-1] * len(block) for _ in range(3))
        self.root = 0

    def copy(self) -> Tree:
        tree = Tree(self.block[:])
        tree.up, tree.left, tree.right, tree.root = self.up[:], self.left[:], self.right[:], self.root
        return tree

    def pack(self, width: list[float], height: list[float]) -> tuple[list[float], list[float]]:
        x, y = [0.0] * len(width), [0.0] * len(width)
        sky: list[tuple[float, float, float]] = [(0.0, math.inf, 0.0)]  # from, to, height
        stack = [(self.root, 0.0)] if self.block else []
        while stack:
            slot, at = stack.pop()
            block = self.block[slot]
            end, top = at + width[block], 0.0
            before, after = [], []
            for piece in sky:
                begin, stop, level = piece
                if stop <= at:
                    before.append(piece)
                elif begin >= end:
                    after.append(piece)
                else:
                    top = max(top, level)
                    if begin < at:
                        before.append((begin, at, level))
                    if stop > end:
                        after.append((end, stop, level))
            sky = [*before, (at, end, top + height[block]), *after]
            x[block], y[block] = at, top
            if self.right[slot] >= 0:
                stack.append((self.right[slot], at))
            if self.left[slot] >= 0:
                stack.append((self.left[slot], end))
        return x, y

    def moved(self, rng: np.random.Generator) -> Tree:
        tree = self.copy()
        if len(tree.block) < 2:
            return tree
        i, j = (int(v) for v in rng.choice(len(tree.block), 2, replace=False))
        if rng.random() < 0.5:
            tree.block[i], tree.block[j] = tree.block[j], tree.block[i]
        else:
            slot = tree._take_out(i, rng)
            places = [s for s in range(len(tree.block)) if s != slot]
            tree._put_in(slot, places[int(rng.integers(len(places)))], bool(rng.integers(2)))
        return tree

    def _take_out(self, slot: int, rng: np.random.Generator) -> int:
        """Take a block out: children move up until a leaf is left. The slot that holds it then."""
        while self.left[slot] >= 0 or self.right[slot] >= 0:
            children = [c for c in (self.left[slot], self.right[slot]) if c >= 0]
            child = children[int(rng.integers(len(children)))]
            self.block[slot], self.block[child] = self.block[child], self.block[slot]
            slot = child
        parent = self.up[slot]
        for side in (self.left, self.right):
            if side[parent] == slot:
                side[parent] = -1
        self.up[slot] = -1
        return slot

    def _put_in(self, slot: int, parent: int, to_left: bool) -> None:
        """Put a free slot under a parent; what hung there hangs under it on the same side."""
        side = self.left if to_left else self.right
        child = side[parent]
        side[parent], self.up[slot] = slot, parent
        side[slot] = child
        if child >= 0:
            self.up[child] = slot
