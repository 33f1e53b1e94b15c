"""Batched search and optimisers over a compiled problem."""

from sceneweaver.kernels.streams import streams as streams

from . import lbfgs as lbfgs  # each enters itself
from . import projection as projection
from . import search as search
from . import tempering as tempering
from . import update_rules as update_rules
from .base import OPTIMIZERS as OPTIMIZERS
from .base import Monitor as Monitor
from .base import Optimizer as Optimizer
from .base import OptimizerResult as OptimizerResult
from .base import register as register
from .batch import Batch as Batch
from .batch import load_poses as load_poses
from .batch import new_state as new_state
from .run import run as run
from .verdict import Verdict as Verdict
from .verdict import judge as judge

__all__ = [
    "OPTIMIZERS",
    "Batch",
    "Monitor",
    "Optimizer",
    "OptimizerResult",
    "Verdict",
    "judge",
    "load_poses",
    "new_state",
    "register",
    "run",
    "streams",
]
