"""Reading the small tables that asset libraries come with."""

from __future__ import annotations

import csv
import gzip
import json
import zlib
from pathlib import Path
from typing import Any

from sceneweaver.scene import InputError


def read_json(path: Path) -> Any:
    """A JSON file, gzipped or not; InputError names the file when it is damaged."""
    try:
        data = path.read_bytes()
        return json.loads(gzip.decompress(data) if path.suffix == ".gz" else data)
    except (OSError, ValueError, EOFError, zlib.error) as error:
        raise InputError(f"{path.name}: not readable as JSON ({' '.join(str(error).split())[:100]})") from error


def rows_of(path: Path, data: Any) -> list[dict[str, Any]]:
    """A list of objects; InputError names the file when it is anything else."""
    if not isinstance(data, list) or not all(isinstance(row, dict) for row in data):
        raise InputError(f"{path.name}: must be a list of objects")
    return data


def read_csv(path: Path) -> list[dict[str, str]]:
    """A CSV file with a header; InputError names the file when it is damaged."""
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            return list(csv.DictReader(file))
    except (OSError, ValueError, csv.Error) as error:
        raise InputError(f"{path.name}: not readable as CSV ({' '.join(str(error).split())[:100]})") from error


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
