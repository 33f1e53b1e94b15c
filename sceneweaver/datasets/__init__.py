"""Data sets: many rooms from one specification, each with its judgement, whoever makes them and in whatever order.

What needs more of the house is loaded where it is used: `produce`, `engines`, `checking` and `report`.
"""

from .folder import Folder
from .requests import Request, Requests
from .samples import Sample, read_rows, read_samples, write_block
from .spec import Spec, load_spec
from .store import AssetStore
from .work import make_block

__all__ = [
    "AssetStore",
    "Folder",
    "Request",
    "Requests",
    "Sample",
    "Spec",
    "load_spec",
    "make_block",
    "read_rows",
    "read_samples",
    "write_block",
]
