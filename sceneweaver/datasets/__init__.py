"""Data sets: many rooms from one specification, each with its judgement, whoever makes them and in whatever order.

`produce` is loaded from `sceneweaver.datasets.produce` where scenes are made, as it needs the whole house.
"""

from .blocks import read_rows, read_samples, write_block
from .checking import Verification, verify_dataset
from .folder import Folder
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
    "read_rows",
    "read_samples",
    "verify_dataset",
    "write_block",
]
