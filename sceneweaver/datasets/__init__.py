"""Data sets: many rooms from one specification, each with its judgement, whoever makes them and in whatever order."""

from .blocks import read_rows, write_block
from .checking import Verification, verify_dataset
from .folder import Folder
from .produce import produce
from .requests import Request, Requests
from .sample import Sample
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
    "Verification",
    "load_spec",
    "make_block",
    "produce",
    "read_rows",
    "verify_dataset",
    "write_block",
]
