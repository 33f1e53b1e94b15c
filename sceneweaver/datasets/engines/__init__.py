"""Runs of data sets: begun, interrupted, resumed, spread over workers and machines. What comes out is the same."""

from .manifest import Dataset, begin, open_dataset
from .mending import missing
from .merge import merge
from .run import require_free, resume
from .schedule import Listener, Options, read_records
from .status import Estimate, Status, estimate, status

__all__ = [
    "Dataset",
    "Estimate",
    "Listener",
    "Options",
    "Status",
    "begin",
    "estimate",
    "merge",
    "missing",
    "open_dataset",
    "read_records",
    "require_free",
    "resume",
    "status",
]
