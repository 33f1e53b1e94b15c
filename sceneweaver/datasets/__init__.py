"""Data sets: many rooms from one specification, each with its verdict, in any order and on any machine.

What needs more of the house is loaded where it is used: `produce`, `engines`, `checking` and `report`.
"""

from .arrays import Limits, Tensors, TensorView, Vocabulary, collate, tensors
from .folder import Folder
from .requests import Request, Requests
from .samples import Sample, read_rows, read_samples, write_block
from .spec import Spec, load_spec
from .store import AssetStore
from .work import make_block

__all__ = [
    "AssetStore",
    "Folder",
    "Limits",
    "Request",
    "Requests",
    "Sample",
    "Spec",
    "TensorView",
    "Tensors",
    "Vocabulary",
    "collate",
    "load_spec",
    "make_block",
    "read_rows",
    "read_samples",
    "tensors",
    "write_block",
]
