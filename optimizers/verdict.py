"""The engine's verdict on a batch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import warp as wp

from sceneweaver.kernels.verdict import DeviceVerdict, judge_candidates, judge_objects, judge_relations

from .batch import Batch
from .launches import Launches


@dataclass
class Verdict:
    """Status [B] int8, fault of every object [B, N] int8, relations fulfilled [B, R] bool."""

    status: np.ndarray
    fault: np.ndarray
    holds: np.ndarray


def new_device_verdict(batch: Batch) -> DeviceVerdict:
    """Room for a verdict on a batch."""
    verdict = DeviceVerdict()
    verdict.status = wp.zeros(batch.size, dtype=wp.int8, device=batch.device)
    verdict.fault = wp.zeros((batch.size, max(batch.objects, 1)), dtype=wp.int8, device=batch.device)
    verdict.holds = wp.zeros((batch.size, max(batch.relations, 1)), dtype=wp.bool, device=batch.device)
    return verdict


def add_verdict(block: Launches, batch: Batch, verdict: DeviceVerdict, active: wp.array) -> None:
    """Append the verdict on the active candidates; what the verdict holds on the others stays."""
    inputs = [batch.problems, active, batch.state]
    block.add(judge_objects, (batch.size, batch.objects), inputs, [verdict])
    block.add(judge_relations, (batch.size, batch.relations), inputs, [verdict])
    block.add(judge_candidates, batch.size, [batch.problems, active], [verdict])


def write_verdict(batch: Batch, verdict: DeviceVerdict, active: wp.array) -> None:
    """Write the verdict on the active candidates; what the verdict holds on the others stays."""
    block = Launches(batch.device)
    add_verdict(block, batch, verdict, active)
    block.run()


def judge(batch: Batch) -> Verdict:
    """Verdict on every candidate."""
    verdict = new_device_verdict(batch)
    write_verdict(batch, verdict, wp.full(batch.size, 1, dtype=wp.int32, device=batch.device))
    return Verdict(verdict.status.numpy(), verdict.fault.numpy(), verdict.holds.numpy())
