"""Runs of data sets: begun, interrupted, resumed, spread over workers and machines. What comes out is the same."""

from .local import Listener
from .manifest import Dataset, begin, open_dataset
from .records import read_records
from .run import Options, missing, resume

__all__ = ["Dataset", "Listener", "Options", "begin", "missing", "open_dataset", "read_records", "resume"]
