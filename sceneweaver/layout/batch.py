"""Problems as a batch of candidates on a device."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import warp as wp

from sceneweaver.optimizers import Batch, new_state

from .compile import LayoutProblem
from .pack import Packed, margins, pack, weights


def make_batch(problems: Sequence[LayoutProblem], which: np.ndarray, device: str, pools=None) -> Batch:
    """A batch with one candidate for every entry of ``which`` (the index of its problem)."""
    packed, first = _packed(problems, device, pools)
    return Batch(
        packed.tables,
        packed.keep,
        margins(),
        weights(),
        wp.array((first + which).astype(np.int32), dtype=wp.int32, device=device),
        new_state(len(which), packed.objects, packed.relations, device),
        packed.objects,
        packed.relations,
        packed.terms,
        device,
    )


def _packed(problems: Sequence[LayoutProblem], device: str, pools) -> tuple[Packed, int]:
    """The tables of some problems, and the number of the first there. Tables without pools are kept with each problem
    for when it comes alone: rating reads those of the search."""
    if any(pools or ()):
        return pack(problems, device, pools), 0
    if len(problems) == 1 and device in problems[0].packed:
        return problems[0].packed[device]
    packed = pack(problems, device, None)
    for number, problem in enumerate(problems):
        problem.packed.setdefault(device, (packed, number))
    return packed, 0


def first_object(problem: LayoutProblem, device: str) -> int:
    """The number of a problem's first object in the tables that are kept with it."""
    packed, number = problem.packed[device]
    return sum(other.size for other in packed.problems[:number])


def stacked(worlds: Sequence[np.ndarray], objects: int) -> np.ndarray:
    """Poses [B, N, 4] of scenes of different sizes, padded to ``objects`` of them."""
    padded = np.zeros((sum(len(w) for w in worlds), objects, 4), dtype=np.float32)
    first = 0
    for world in worlds:
        padded[first : first + len(world), : world.shape[1]] = world
        first += len(world)
    return padded
