"""The formats that are read: one module each, with a `SourceFormat` called ``FORMAT``."""

from __future__ import annotations

import importlib
import pkgutil
from functools import lru_cache

from ..model import SourceFormat


@lru_cache(maxsize=1)
def formats() -> dict[str, SourceFormat]:
    """Every format by its name."""
    found: dict[str, SourceFormat] = {}
    for module in sorted(m.name for m in pkgutil.iter_modules(__path__)):
        entry = getattr(importlib.import_module(f"{__name__}.{module}"), "FORMAT", None)
        if isinstance(entry, SourceFormat):
            found[entry.name] = entry
    return found
