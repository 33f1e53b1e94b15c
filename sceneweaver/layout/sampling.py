"""Many valid layouts of many scenes: some are searched, and chains lead from these to as many others as are wanted."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sceneweaver.kernels import load
from sceneweaver.optimizers import OPTIMIZERS, Monitor, load_poses, streams
from sceneweaver.optimizers.chains import MODULES, Chains, Step

from .batch import make_batch, stacked
from .compile import CompiledScene, LayoutProblem
from .engine import solve
from .job import Job
from .pools import surface_pools
from .surfaces import surfaces_hold

CHAIN_SALT = 0xC4A1
SOFT = 0.1  # of their weight is what soft relations have in chains, so that no step breaks a hard one for their sake


@dataclass(frozen=True)
class Drawn:
    """What a step of the chains of one scene has led to: of its valid layouts poses [K, N, 4] of all bodies and energy
    [K] float32, and which of the scene's relations hold [K, R]."""

    poses: np.ndarray
    energy: np.ndarray
    relations: np.ndarray

    @property
    def arrays(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """All of it."""
        return self.poses, self.energy, self.relations


def first_layouts(
    scenes: Sequence[CompiledScene], candidates: range, attempts: int, seeds: Sequence[int], device: str
) -> list[Drawn]:
    """The valid ones of some layouts that are searched for each scene, all in shared launches.

    Args:
        scenes: the scenes.
        candidates: numbers of the layouts that are begun for each; one is the same whatever others are.
        attempts: how often each is begun anew until it is valid.
        seeds: of each scene.
        device: a Warp device.
    """
    jobs = []
    for scene, seed in zip(scenes, seeds, strict=True):
        world = np.broadcast_to(scene.room.home, (len(candidates), *scene.room.home.shape))
        jobs.append(Job(scene, world, "sample", seed, walk=False, first=candidates.start))
    found = solve(jobs, "search", attempts, device, Monitor(len(candidates) * len(jobs)), time.monotonic())
    return [Drawn(*(a[s.status == 0] for a in (s.bodies, s.energy, s.relations))) for s in found]


def joined(first: Drawn, second: Drawn) -> Drawn:
    """The layouts of two draws of one scene."""
    pairs = zip(first.arrays, second.arrays, strict=True)
    return Drawn(*(np.concatenate(pair) for pair in pairs))


def _eased(problem: LayoutProblem) -> LayoutProblem:
    """A problem whose soft relations weigh less."""
    lighter = [rel if rel.fault else replace(rel, weight=SOFT * rel.weight) for rel in problem.relations]
    return replace(problem, relations=lighter)


class Sampler:
    """Chains of valid layouts of some scenes, as many for each, in shared launches.

    What the chains of a scene lead to follows from the scene, its seed, its first layouts and the number of chains, not
    from the scenes beside it.
    """

    def __init__(
        self,
        scenes: Sequence[CompiledScene],
        first: Sequence[np.ndarray],
        chains: int,
        seeds: Sequence[int],
        device: str,
    ) -> None:
        """Begin chains.

        Args:
            scenes: the scenes.
            first: valid layouts [K, N, 4] of each, at least one, at which its chains begin.
            chains: of each scene.
            seeds: of each scene, below 2**32.
            device: a Warp device.
        """
        self.scenes, self.chains = scenes, chains
        load(device, *MODULES, *OPTIMIZERS["search"].modules_on(device))
        jobs = [Job(scene, poses, "given", seed) for scene, poses, seed in zip(scenes, first, seeds, strict=True)]
        which = np.repeat(np.arange(len(scenes)), chains)
        self._batch = make_batch([_eased(s.room) for s in scenes], which, device, surface_pools(jobs, device, None))
        begin = [poses[np.arange(chains) % len(poses)] for poses in first]
        load_poses(self._batch, stacked(begin, max(self._batch.objects, 1)))
        numbers = [streams(seed ^ CHAIN_SALT, np.arange(chains)) for seed in seeds]
        self._chains = Chains(self._batch, np.concatenate(numbers))

    def step(self) -> None:
        """Take every open chain one step on; on a GPU it goes on after the return."""
        self._chains.step()

    def read(self) -> Step:
        """What the last step has led to; for each scene, see `drawn`. Its arrays are good until the next call."""
        step = self._chains.read()
        for k, scene in enumerate(self.scenes):
            mine = self._rows(k)
            if scene.domains and step.fresh[mine].any():
                step.fresh[mine] &= surfaces_hold(scene, self._batch, mine.start, self.chains)
        return step

    def drawn(self, step: Step, which: int) -> Drawn:
        """What a step has led to for one of the scenes."""
        room, relations = self.scenes[which].room, len(self.scenes[which].scene.relations)
        mine = self._rows(which)
        fresh = step.fresh[mine]
        rows = step.holds[mine][fresh]
        holds = rows[:, :relations].copy()
        for rider, relation in room.riders.items():
            holds[:, relation] &= rows[:, rider]
        return Drawn(step.poses[mine][fresh][:, : room.size], step.energy[mine][fresh], holds)

    def _rows(self, which: int) -> slice:
        return slice(which * self.chains, (which + 1) * self.chains)

    def close(self, done: np.ndarray) -> None:
        """Leave the chains of some scenes [S] where they are."""
        self._chains.close(np.repeat(done, self.chains))
