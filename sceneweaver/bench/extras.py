"""What the extra ``bench`` brings."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from sceneweaver.scene import MissingDependencyError


def pyarrow() -> Any:
    """The package, with what reads and writes Parquet."""
    _found("pyarrow.parquet")
    return _found("pyarrow")


def figure() -> Any:
    """matplotlib's `Figure`, which needs no display."""
    return _found("matplotlib.figure").Figure


def _found(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError:
        package = name.partition(".")[0]
        raise MissingDependencyError(f"{package} is not installed; pip install 'sceneweaver[bench]'") from None
