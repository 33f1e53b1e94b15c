"""Batched search and optimisers over a compiled problem."""

from .base import OPTIMIZERS as OPTIMIZERS
from .base import Monitor as Monitor
from .base import Optimizer as Optimizer
from .base import OptimizerResult as OptimizerResult
from .base import register as register
from .batch import Batch as Batch
from .batch import load_poses as load_poses
from .batch import new_state as new_state
from .batch import streams as streams
from .lbfgs import run_lbfgs as run_lbfgs
from .projection import run_projection as run_projection
from .run import run as run
from .search import run_search as run_search
from .tempering import run_tempering as run_tempering
from .update_rules import Descent as Descent
from .verdict import Verdict as Verdict
from .verdict import judge as judge

__all__ = [
    "OPTIMIZERS",
    "Batch",
    "Descent",
    "Monitor",
    "Optimizer",
    "OptimizerResult",
    "Verdict",
    "judge",
    "load_poses",
    "new_state",
    "register",
    "run",
    "run_lbfgs",
    "run_projection",
    "run_search",
    "run_tempering",
    "streams",
]
