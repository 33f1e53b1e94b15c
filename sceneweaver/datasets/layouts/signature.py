"""When two layouts of a program are the same, and when they are nearly the same: as numbers, for many at once."""

from __future__ import annotations

import numpy as np

from sceneweaver.layout.solution import signatures
from sceneweaver.scene import Scene

CELL = 0.5  # [m]
EIGHTH = np.pi / 4


class Signatures:
    """The signatures of one program's layouts."""

    def __init__(self, scene: Scene):
        self._scene = scene
        free = [k for k, o in enumerate(scene.objects) if not o.fixed and o.support is None]
        floor = [k for k in free if scene.objects[k].mount == "floor"]
        self._objects = floor or free

    def distinct(self, poses: np.ndarray) -> np.ndarray:
        """Hashes [K] of layouts [K, N, 4]: the 0.5 m cell and the eighth of a turn of all that stands on the floor.

        Layouts of one program with the same hash count once.
        """
        chosen = poses[:, self._objects]
        eighth = np.round(chosen[..., 3] / EIGHTH).astype(np.int64) % 8
        cells = np.floor(chosen[..., :2] / CELL).astype(np.int64)
        return hashed(np.concatenate([cells[..., 0], cells[..., 1], eighth], axis=1))

    def group(self, poses: np.ndarray) -> np.ndarray:
        """Hashes [K] of layouts: the wall and the eighth of a turn of the large pieces, see `layout.signatures`.

        Layouts of one program that share it are near-duplicates of each other.
        """
        return hashed(signatures(self._scene, poses).astype(np.int64))


def hashed(numbers: np.ndarray) -> np.ndarray:
    """A 63-bit hash [K] int64 of each row of integers [K, M]: their sum with odd weights, then the finaliser of
    SplitMix64 (Steele et al., 2014, public domain)."""
    weights = _mixed(np.arange(1, numbers.shape[1] + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15))
    mixed = _mixed((numbers.astype(np.uint64) * (weights | np.uint64(1))).sum(axis=1, dtype=np.uint64))
    return (mixed >> np.uint64(1)).astype(np.int64)


def _mixed(x: np.ndarray) -> np.ndarray:
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


class Seen:
    """The hashes of the layouts there are."""

    def __init__(self) -> None:
        self._sorted = np.empty(0, dtype=np.int64)

    def add(self, hashes: np.ndarray, most: int) -> np.ndarray:
        """Which of some layouts [K] are new, the first of each hash and so many at most: their indices, in order."""
        values, first = np.unique(hashes, return_index=True)
        at = np.searchsorted(self._sorted, values)
        known = np.zeros(len(values), dtype=bool)
        inside = at < len(self._sorted)
        known[inside] = self._sorted[at[inside]] == values[inside]
        new = np.sort(first[~known])[:most]
        taken = ~known & (first <= (new[-1] if len(new) else -1))
        self._sorted = np.insert(self._sorted, at[taken], values[taken])
        return new
