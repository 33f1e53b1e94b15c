"""Whether what stands on support surfaces is in order there."""

from __future__ import annotations

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import set_turns, to_surface_frames
from sceneweaver.optimizers import Batch, Monitor, judge
from sceneweaver.optimizers.run import judge_in_time

from .batch import make_batch
from .compile import CompiledScene

BROKEN = 1  # the verdict's status of bodies that are in each other's way


def surfaces_hold(
    compiled: CompiledScene, batch: Batch, first: int, count: int, monitor: Monitor | None = None
) -> np.ndarray:
    """Which of so many candidates of a batch, from the first on, have everything on its surface in order [count].

    Those that the ``monitor`` leaves no time to look at do not count as in order.
    """
    if not compiled.domains:
        return np.ones(count, dtype=bool)
    surfaces, device = [d.surface for d in compiled.domains], batch.device
    onto = make_batch([d.problem for d in compiled.domains], np.repeat(np.arange(len(surfaces)), count), device)
    start = np.cumsum([0, *(len(s.members) for s in surfaces)])
    lists = ([s.supporter for s in surfaces], start, [m for s in surfaces for m in s.members])
    tables = [wp.array(np.asarray(values, dtype=np.int32), device=device) for values in lists]
    state = onto.state
    wp.launch(
        to_surface_frames,
        state.poses.shape,
        [first, count, *tables, batch.state.poses],
        [state.poses],
        device=device,
    )
    wp.launch(set_turns, state.poses.shape, [state.poses], [state.turns], device=device)
    verdict = judge(onto) if monitor is None else judge_in_time(onto, monitor)
    return np.all(verdict.status.reshape(len(surfaces), count) != BROKEN, axis=0)
