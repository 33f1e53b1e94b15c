"""Problems as a batch of candidates on a device."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import warp as wp

from sceneweaver.optimizers import Batch, new_state

from .compile import LayoutProblem
from .pack import Packed, margins, pack, weights


def make_batch(
    problems: Sequence[LayoutProblem], which: np.ndarray, device: str, pools=None, *, shared: bool = False
) -> Batch:
    """A batch with one candidate for every entry of ``which`` (the index of its problem).

    Args:
        problems: the problems.
        which: problem of each candidate [B].
        device: where the batch lives.
        pools: starts for things on surfaces, by problem.
        shared: of one problem, whether tables do that it has with others, where its number and that of its first
            object are not 0 (see `first_object`): enough for rating, and packed already by the search.
    """
    packed, first = _packed(problems, device, pools, shared)
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


def _packed(problems: Sequence[LayoutProblem], device: str, pools, shared: bool) -> tuple[Packed, int]:
    """The tables of some problems, and the number of the first there; those without pools are kept with the problems,
    for when one comes alone."""
    if any(pools or ()):
        return pack(problems, device, pools), 0
    if len(problems) == 1 and device in problems[0].packed:
        kept = problems[0].packed[device]
        if shared or len(kept[0].problems) == 1:
            return kept
    packed = pack(problems, device, None)
    for number, problem in enumerate(problems):
        problem.packed[device] = packed, number
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
