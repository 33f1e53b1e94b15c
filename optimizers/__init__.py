"""Batched search and optimisers over a compiled problem."""

from .adam import run_adam as run_adam
from .base import OPTIMIZERS as OPTIMIZERS
from .base import Monitor as Monitor
from .base import Outcome as Outcome
from .batch import Batch as Batch
from .batch import Verdict as Verdict
from .batch import judge as judge
from .batch import load_poses as load_poses
from .batch import new_state as new_state
from .batch import streams as streams
from .projection import run_projection as run_projection
from .run import run as run
from .search import run_search as run_search

__all__ = [
    "OPTIMIZERS",
    "Batch",
    "Monitor",
    "Outcome",
    "Verdict",
    "judge",
    "load_poses",
    "new_state",
    "run",
    "run_adam",
    "run_projection",
    "run_search",
    "streams",
]
