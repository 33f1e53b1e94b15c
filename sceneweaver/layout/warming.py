"""The kernels that layouts may need, to be compiled ahead."""

from __future__ import annotations

from sceneweaver.kernels import variants_of
from sceneweaver.optimizers import OPTIMIZERS
from sceneweaver.optimizers.chains import MODULES as CHAINS
from sceneweaver.optimizers.descent import MEASURED, MEASURED_ON_GPU
from sceneweaver.optimizers.snap import MODULES as SNAP
from sceneweaver.runtime.compiling import Variant

from .live import MODULES as LIVE
from .minimise import MODULES as MINIMISED
from .rate import MODULES as RATED


def kernel_modules(device: str) -> list[Variant]:
    """The modules of a refinement by any built-in optimiser, of edits, ratings, objectives and data sets."""
    names = ["bookkeeping", "verdict", "walk", "residuals", *SNAP, *RATED, *LIVE, *CHAINS, *MINIMISED]
    for optimizer in OPTIMIZERS.values():
        names += optimizer.modules_on(device)
    names += MEASURED if device == "cpu" else MEASURED_ON_GPU
    return [variant for name in dict.fromkeys(names) for variant in variants_of(name)]
