"""Reading the small tables that asset libraries come with."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

from sceneweaver.io import MAX_UNPACKED, read_bytes, read_unpacked, reason
from sceneweaver.scene import InputError

MAX_CONTAINERS = 10_000_000
"""Lists and objects of a JSON file, or cells of a table, at most: in memory they take far more than in the file."""


def read_json(path: Path) -> Any:
    """A JSON file, gzipped or not; InputError names the file when it is damaged or holds over `MAX_UNPACKED` bytes."""
    return parsed(path, read_unpacked(path))


def parsed(path: Path, text: bytes) -> Any:
    """JSON text of a file; InputError names the file when it is damaged."""
    try:
        if text.count(b"{") + text.count(b"[") > MAX_CONTAINERS:
            raise ValueError(f"over {MAX_CONTAINERS} lists and objects; split it")
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path.name}: not readable as JSON ({reason(error)})") from error


def rows_of(path: Path, data: Any) -> list[dict[str, Any]]:
    """A list of objects; InputError names the file when it is anything else."""
    if not isinstance(data, list) or not all(isinstance(row, dict) for row in data):
        raise InputError(f"{path.name}: must be a list of objects")
    return data


def read_csv(path: Path) -> list[dict[str, str]]:
    """A CSV file with a header; InputError names the file when it is damaged."""
    try:
        text = read_bytes(path, max_bytes=MAX_UNPACKED).decode("utf-8-sig")
        if text.count(",") + text.count("\n") > MAX_CONTAINERS:
            raise ValueError(f"over {MAX_CONTAINERS} cells; split it")
        return list(csv.DictReader(io.StringIO(text, newline="")))
    except InputError:
        raise
    except (ValueError, csv.Error) as error:
        raise InputError(f"{path.name}: not readable as CSV ({reason(error)})") from error


def number(value: Any) -> float | None:
    """A finite number, or None."""
    try:
        found = float(value)
    except (TypeError, ValueError):
        return None
    return found if abs(found) < float("inf") else None


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
