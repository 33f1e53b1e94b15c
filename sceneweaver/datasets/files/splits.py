"""Which split each scene is in: whole rooms and whole groups of near-duplicates, in shares as wanted."""

from __future__ import annotations

import hashlib

import numpy as np

from ..spec import Spec


def assign_splits(spec: Spec, families: np.ndarray) -> np.ndarray:
    """The split of each scene, as its place among the names of the splits in ascending order.

    Families lie in the order of a hash; each is in the split within whose share of all scenes its middle falls. So the
    shares are as exact as whole families allow, and no family is in two splits.

    Args:
        spec: says the shares.
        families: a number for each scene; scenes of one family share a split. Shape [scene].
    """
    names, places, sizes = np.unique(families, return_inverse=True, return_counts=True)
    order = np.array(sorted(range(len(names)), key=lambda i: _hash(spec.seed, int(names[i]))), dtype=int)
    middles = np.cumsum(sizes[order]) - sizes[order] / 2
    shares = np.array([spec.splits[name] for name in sorted(spec.splits)])
    ends = np.cumsum(shares / shares.sum())[:-1] * len(families)
    split = np.empty(len(names), dtype=int)
    split[order] = np.searchsorted(ends, middles, side="right")
    return split[places]


def _hash(seed: int, family: int) -> bytes:
    return hashlib.sha256(f"{seed} {family}".encode()).digest()
