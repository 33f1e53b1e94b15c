"""Collect distinct valid layouts of programs: search some, and let chains go on from them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from sceneweaver.layout.compile import CompiledScene
from sceneweaver.layout.sampling import Drawn, Sampler
from sceneweaver.runtime.threads import cores

from .signature import Seen, Signatures
from .tables import GROUP

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
                few = LEAST_YIELD * chains * steps
                for k in going:
                    done[k] = collections[k].complete or (steps >= PATIENCE and collections[k].count < few)
                if done.all() or stop():
                    break
                if any(done[k] for k in going):
                    sampler.close(done)
                if device == "cpu":
                    sampler.step()
        list(pool.map(Collection.flush, collections))
    return steps
