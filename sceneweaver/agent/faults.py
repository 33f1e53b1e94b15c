"""Faults of the program in a part of a design: they cost that part, not the scene that there is."""

from __future__ import annotations

import traceback
import warnings
from pathlib import Path


def fault(part: str, error: Exception) -> str:
    """What to say of an exception that nobody foresaw in ``part`` of a design; a warning says it as well."""
    frames = traceback.extract_tb(error.__traceback__)
    place = f" ({Path(frames[-1].filename).name}:{frames[-1].lineno})" if frames else ""
    said = f"{part}: unexpected {type(error).__name__}: {str(error) or 'no message'}{place}"
    warnings.warn(said, RuntimeWarning, stacklevel=2)
    return said
