"""Reading the small tables that asset libraries come with."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from sceneweaver.io.messages import printable_line
from sceneweaver.scene import InputError

_LONGEST = 200


def rows_of(path: Path, data: Any) -> list[dict[str, Any]]:
    """A list of objects; InputError names the file when it is anything else."""
    if not isinstance(data, list) or not all(isinstance(row, dict) for row in data):
        raise InputError(f"{path.name}: must be a list of objects")
    return data


def number(value: Any) -> float | None:
    """A finite number, or None."""
    try:
        found = float(value)
    except (TypeError, ValueError, OverflowError):
        return None
    return found if abs(found) < float("inf") else None


def text(value: Any) -> str:
    """A word or a line of a table as one short printable line; empty where it is neither a text nor a number."""
    return printable_line(str(value), _LONGEST) if isinstance(value, str | int | float) else ""


def file_of(root: Path, *names: str) -> Path | None:
    """The file that a table names, where there is one; whether it lies below the folder is for `entries` to say."""
    place = root.joinpath(*names)
    return place if os.path.isfile(place) else None  # which holds for names that are too long, or none, as well


def axis_of(value: Any) -> str | None:
    """An axis written as "+Z", "z", "-y", or as three numbers; None where there is none."""
    if isinstance(value, str):
        text = value.strip().lower().lstrip("+")
        if text in ("x", "y", "z", "-x", "-y", "-z"):
            return text
        parts = text.strip("[]()").replace(",", " ").split()
        value = [number(p) for p in parts]
    if isinstance(value, list | tuple) and len(value) == 3 and all(number(v) is not None for v in value):
        k = max(range(3), key=lambda i: abs(float(value[i])))
        return ("-" if float(value[k]) < 0 else "") + "xyz"[k] if abs(float(value[k])) > 0.5 else None
    return None
