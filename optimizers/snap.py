"""Exact poses for valid candidates: square, flush, centred, in line. See ``kernels.snap``."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import warp as wp

from sceneweaver.kernels.snap import keep_valid, snap

from .batch import Batch
from .run import cpu_threads, pieces
from .verdict import new_device_verdict, write_verdict

MODULES = ("snap", "verdict")


def snap_batch(batch: Batch, orders: np.ndarray) -> None:
    """Bring the objects of valid candidates to the exact values of their relations, in place.

    ``orders`` [problem, object] lists the objects of each problem, those that others are placed by first. Hard terms
    cost no more afterwards, soft relations that held still do, and a candidate that is not valid afterwards stays as
    it was.
    """
    if not batch.size or not batch.objects:
        return
    order = wp.array(orders.astype(np.int32), dtype=wp.int32, device=batch.device)

    def work(part: Batch) -> None:
        device = part.device
        before, after, poses = new_device_verdict(part), new_device_verdict(part), wp.clone(part.state.poses)
        write_verdict(part, before, wp.full(part.size, 1, dtype=wp.int32, device=device))
        active = wp.array((before.status.numpy() == 0).astype(np.int32), dtype=wp.int32, device=device)
        inputs = [part.problems, order, active]
        wp.launch(snap, part.size, inputs, [part.state], device=device, block_dim=32)
        write_verdict(part, after, active)
        shape = (part.size, part.objects)
        wp.launch(keep_valid, shape, [poses, active, after.status], [part.state], device=device)

    parts = pieces(batch)
    if len(parts) == 1 or cpu_threads() == 1:
        for part in parts:
            work(part)
        return
    with ThreadPoolExecutor(cpu_threads()) as pool:
        list(pool.map(work, parts))
