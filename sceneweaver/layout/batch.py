"""Problems as a batch of candidates on a device."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import warp as wp

from sceneweaver.optimizers import Batch, new_state

from .compile import LayoutProblem
from .pack import margins, pack, weights


def make_batch(problems: Sequence[LayoutProblem], which: np.ndarray, device: str, pools=None) -> Batch:
    """A batch with one candidate for every entry of ``which`` (the index of its problem)."""
    packed = pack(problems, device, pools)
    return Batch(
        packed.tables,
        packed.keep,
        margins(),
        weights(),
        wp.array(which.astype(np.int32), dtype=wp.int32, device=device),
        new_state(len(which), packed.objects, packed.relations, device),
        packed.objects,
        packed.relations,
        packed.terms,
        device,
    )
