"""Batched search and optimisers over a compiled problem."""

from .adam import run_adam as run_adam
from .base import OPTIMIZERS as OPTIMIZERS
from .base import Monitor as Monitor
from .base import Optimizer as Optimizer
from .base import OptimizerResult as OptimizerResult
from .batch import Batch as Batch
from .batch import Verdict as Verdict
from .batch import judge as judge
from .batch import load_poses as load_poses
from .batch import new_state as new_state
from .batch import streams as streams
from .langevin import run_langevin as run_langevin
from .lbfgs import run_lbfgs as run_lbfgs
from .projection import run_projection as run_projection
from .run import run as run
from .search import run_search as run_search
from .tempering import run_tempering as run_tempering

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
    "run",
    "run_adam",
    "run_langevin",
    "run_lbfgs",
    "run_projection",
    "run_search",
    "run_tempering",
    "streams",
]
