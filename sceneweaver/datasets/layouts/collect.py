"""Collect distinct valid layouts of programs: search some, and let chains go on from them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from sceneweaver.layout.compile import CompiledScene
from sceneweaver.layout.sampling import Drawn, Sampler
from sceneweaver.layout.solution import signatures
from sceneweaver.runtime.threads import cores
from sceneweaver.scene import Scene

from .tables import GROUP

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


STEPS = 16
"""Steps over which a program's layouts are spread, as far as its chains may be so few or so many."""

LEAST_CHAINS = 8
MOST_CHAINS = {"cpu": 64, "gpu": 262_144}
"""Chains of a program on a CPU; of all programs together on a GPU, which works on them side by side."""

BURN_IN = 2
"""Steps before chains that began at the same layout count as different."""

PATIENCE, LEAST_YIELD = 16, 0.02
"""Steps after which a program is left at what there is, where fewer of its steps have led to new layouts."""

Emit = Callable[[int, dict[str, np.ndarray]], None]
"""What takes the layouts of a program: its position among the programs, and their columns."""


class Collection:
    """The layouts of one program, up to so many."""

    def __init__(self, position: int, program: int, scene: CompiledScene, wanted: int, emit: Emit):
        self._position, self._program, self._emit, self.wanted = position, program, emit, wanted
        self._signatures, self._seen = Signatures(scene.scene), Seen()
        weights = np.array([0.0 if r.hard else r.weight for r in scene.scene.relations], dtype=np.float32)
        self._weights = weights / max(float(weights.sum()), 1e-9)
        self._soft = bool(weights.any())
        self._waiting: list[dict[str, np.ndarray]] = []
        self.count = self._written = 0

    @property
    def complete(self) -> bool:
        """Whether there are as many as are wanted."""
        return self.count >= self.wanted

    def take(self, drawn: Drawn) -> None:
        """Take in layouts that are valid, in order; those that there are already are left out."""
        hashes = self._signatures.distinct(drawn.poses)
        new = self._seen.add(hashes, self.wanted - self.count)
        poses = drawn.poses[new]
        soft = drawn.relations[new] @ self._weights if self._soft else np.ones(len(new))
        self._waiting.append(
            {
                "program": np.full(len(new), self._program, dtype=np.int32),
                "layout": np.arange(self.count, self.count + len(new), dtype=np.int32),
                "poses": poses,
                "energy": drawn.energy[new],
                "soft": soft.astype(np.float32),
                "signature": hashes[new],
                "near_duplicate_group": self._signatures.group(poses),
            }
        )
        self.count += len(new)
        if self.count - self._written >= GROUP:
            self.flush()

    def flush(self) -> None:
        """Hand over what is there."""
        if self.count == self._written:
            return
        rows = {name: np.concatenate([some[name] for some in self._waiting]) for name in self._waiting[0]}
        for first in range(0, len(rows["layout"]), GROUP):
            self._emit(self._position, {name: values[first : first + GROUP] for name, values in rows.items()})
        self._waiting, self._written = [], self.count


def chains_for(wanted: int, programs: int, device: str) -> int:
    """How many chains a program gets beside so many others."""
    most = MOST_CHAINS["cpu"] if device == "cpu" else MOST_CHAINS["gpu"] // programs
    return max(LEAST_CHAINS, min(math.ceil(wanted / STEPS), most))


def collect(
    scenes: Sequence[CompiledScene],
    first: Sequence[Drawn],
    seeds: Sequence[int],
    collections: Sequence[Collection],
    device: str,
    stop: Callable[[], bool] = bool,
) -> int:
    """Fill the collections of some programs, as far as that can be done; how many steps it took.

    Args:
        scenes: the programs.
        first: layouts of each that are valid, at least one.
        seeds: of each.
        collections: where their layouts go.
        device: a Warp device.
        stop: says when to leave it at what there is; for measurements.
    """
    with ThreadPoolExecutor(cores()) as pool:
        list(pool.map(Collection.take, collections, first))
        done = np.array([c.complete for c in collections], dtype=bool)
        steps = 0
        if not done.all():
            chains = chains_for(max(c.wanted for c in collections), len(scenes), device)
            sampler = Sampler(scenes, [d.poses for d in first], chains, seeds, device)
            sampler.close(done)
            sampler.step()

            def take(k: int) -> None:
                collections[k].take(sampler.drawn(step, k))

            while True:
                step = sampler.read()
                steps += 1
                going = np.flatnonzero(~done).tolist()
                if device != "cpu":
                    sampler.step()  # goes on while the last one is looked at
                if steps > BURN_IN:
                    list(pool.map(take, going))
                # Where a room is so full that chains hardly leave their layout, more steps find nothing.
                few = LEAST_YIELD * chains * steps
                for k in going:
                    done[k] = collections[k].complete or (steps >= PATIENCE and collections[k].count < few)
                if done.all() or stop():
                    break
                # What is done stays where it is from the next step on, so that no time goes into it.
                if any(done[k] for k in going):
                    sampler.close(done)
                if device == "cpu":
                    sampler.step()
        list(pool.map(Collection.flush, collections))
    return steps
