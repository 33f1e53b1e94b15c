"""Files of weights of small networks: matrices in 8 bits with a scale for each column or row, and what they are for."""

from __future__ import annotations

import json
from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from .archives import read_arrays
from .errors import InputError
from .writing import write_atomic

TALL = 8
"""Times as many rows as columns from which on a matrix is a table, with a scale for each of its rows."""


def write_weights(path: Path, weights: Mapping[str, np.ndarray], header: Mapping[str, Any]) -> None:
    """Write weights, rounded, with a header of JSON data that has a ``schema``."""
    arrays = {"header": np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)}
    for name, value in weights.items():
        arrays[f"q.{name}"], arrays[f"s.{name}"] = quantised(np.asarray(value, dtype=np.float32))
    file = BytesIO()
    np.savez_compressed(file, **arrays)  # pyright: ignore[reportArgumentType]
    write_atomic(path, file.getvalue())


def read_weights(path: Path, of: str, schema: str, max_bytes: int) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """What `write_weights` wrote: weights in float32, and the header.

    Args:
        path: the file.
        of: whose weights they are, for messages.
        schema: of the header.
        max_bytes: that it may unpack to.

    Raises:
        InputError: the file is missing, damaged, larger than it may be, or of another schema.
    """
    arrays = read_arrays(path, max_bytes=max_bytes)
    try:
        header = json.loads(arrays["header"].tobytes())
        if header["schema"] != schema:
            raise ValueError(header["schema"])
        names = [name[2:] for name in arrays if name.startswith("q.")]
        weights = {name: arrays[f"q.{name}"].astype(np.float32) * arrays[f"s.{name}"] for name in names}
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: no weights of {of} ({schema}); take a file that sceneweaver wrote") from error
    if not all(np.isfinite(value).all() for value in weights.values()):
        raise InputError(f"{path}: weights are damaged; take the file that ships with sceneweaver")
    return weights, header


def quantised(value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """8-bit numbers and scales: of each column of a matrix, of each row of a tall one, of the columns of each matrix of
    a stack; of vectors 16-bit floating point as it is."""
    if value.ndim < 2:
        return value.astype(np.float16), np.ones((), dtype=np.float32)
    axis = -1 if value.shape[0] > TALL * value.shape[-1] and value.ndim == 2 else -2
    scale = np.maximum(np.abs(value).max(axis=axis, keepdims=True), 1e-12).astype(np.float32) / 127.0
    return np.clip(np.round(value / scale), -127, 127).astype(np.int8), scale
