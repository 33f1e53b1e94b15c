"""A batch of candidates on one device: the state that optimisers move."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import warp as wp

from sceneweaver.kernels.bookkeeping import set_turns
from sceneweaver.kernels.tables import STATE, Margins, Problems, State, Tables, Weights
from sceneweaver.kernels.warp_primitives import WARP_SIZE


@dataclass(frozen=True)
class Batch:
    """Candidates of one or several problems.

    ``tables`` is an array of one ``Tables``, ``keep`` what keeps its arrays alive. ``problem`` [B] int32 says which
    problem a candidate belongs to; ``state`` holds poses [B, N, 4] and the rest; N and R are the largest counts of
    objects and relations of any problem, ``terms`` the kinds of terms (bits of ``Tables.object_terms``) that any has.
    """

    tables: wp.array
    keep: Tables
    margins: Margins
    weights: Weights
    problem: wp.array
    state: State
    objects: int
    relations: int
    terms: int
    device: str

    @property
    def size(self) -> int:
        """Number of candidates B."""
        return self.problem.shape[0]

    @cached_property  # every launch takes it
    def problems(self) -> Problems:
        """What kernels take first."""
        problems = Problems()
        problems.tables, problems.problem = self.tables, self.problem
        problems.margins, problems.weights = self.margins, self.weights
        return problems

    def part(self, first: int, last: int) -> Batch:
        """Candidates first to last as a batch that shares this one's memory."""
        state = State()
        for table in STATE:
            setattr(state, table.name, getattr(self.state, table.name)[first:last])
        return replace(self, problem=self.problem[first:last], state=state)

    def scratch(self) -> State:
        """A second state of the same shape."""
        return new_state(self.size, self.objects, self.relations, self.device)


Progress = Callable[[int, int, int, float], None]


def threads_per_candidate(device: str) -> int:
    """Threads that work on one candidate where a kernel deals its loops out over lanes."""
    return 1 if device == "cpu" else WARP_SIZE


def new_state(candidates: int, objects: int, relations: int, device: str) -> State:
    """A state of zeros."""
    counts = {"candidate": candidates, "object": max(objects, 1), "relation": max(relations, 1)}
    counts |= {"lane": threads_per_candidate(device) + 1, "1": 1}
    state = State()
    for table in STATE:
        shape = tuple(counts[dimension] for dimension in table.shape)
        setattr(state, table.name, wp.zeros(shape, dtype=table.dtype, device=device))
    return state


def load_poses(batch: Batch, poses: np.ndarray) -> None:
    """Set poses [B, N, 4]; also where the pull goes."""
    padded = poses
    if poses.shape[1] != max(batch.objects, 1) or poses.dtype != np.float32:
        padded = np.zeros((batch.size, max(batch.objects, 1), 4), dtype=np.float32)
        padded[:, : poses.shape[1]] = poses
    batch.state.poses.assign(padded)
    batch.state.anchors.assign(padded)
    wp.launch(set_turns, batch.state.poses.shape, [batch.state.poses], [batch.state.turns], device=batch.device)
