"""Runs of data sets: begun, interrupted, resumed, spread over workers and machines. What comes out is the same."""

from .estimate import Estimate, estimate
from .manifest import Dataset, begin, open_dataset
from .merge import merge
from .records import read_records
from .run import Options, missing, resume
from .schedule import Listener
from .status import Status, status

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
    "resume",
    "status",
]
