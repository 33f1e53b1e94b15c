"""The verdict on layouts that were found in another way than by the search of their scene."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sceneweaver.kernels import load
from sceneweaver.optimizers import Batch
from sceneweaver.optimizers.verdict import judge

from .compile import CompiledScene
from .measure import energy_of
from .surfaces import BROKEN, surfaces_hold


class Judged(NamedTuple):
    """Status [B], relations [B, R] and energy [B] of layouts."""

    status: np.ndarray
    relations: np.ndarray
    energy: np.ndarray


def judged(compiled: CompiledScene, batch: Batch) -> Judged:
    """The engine's verdict on a batch of layouts of one scene, surfaces and the energy included."""
    load(batch.device, "verdict", "bookkeeping")
    room, relations = compiled.room, len(compiled.scene.relations)
    verdict = judge(batch)
    status = verdict.status.copy()
    status[(status == 0) & (room.faulty | ~surfaces_hold(compiled, batch, 0, batch.size))] = BROKEN
    holds = verdict.holds[:, :relations].copy()
    for rider, relation in room.riders.items():
        holds[:, relation] &= verdict.holds[:, rider]
    return Judged(status, holds, energy_of(batch)[0].numpy().copy())
