"""Files of weights: each matrix in 8 bits with a scale for each of its columns."""

from __future__ import annotations

import json
from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, read_arrays, write_atomic

from .network import Shape, layout_of
from .vocabulary import Words

SCHEMA = "sceneweaver.prior/1"
MOST = 64 * 2**20
"""Bytes that a file of weights may unpack to."""


def save_weights(
    path: Path, weights: Mapping[str, np.ndarray], shape: Shape, words: Words, about: Mapping[str, Any]
) -> None:
    """Write weights as 8-bit numbers, with the names they are for and what is said of them (JSON data)."""
    header = {"schema": SCHEMA, "shape": shape.to_json(), "words": words.to_json(), "about": dict(about)}
    arrays = {"header": np.frombuffer(json.dumps(header).encode(), dtype=np.uint8)}
    for name, value in weights.items():
        number, scale = quantised(np.asarray(value, dtype=np.float32))
        arrays[f"q.{name}"], arrays[f"s.{name}"] = number, scale
    file = BytesIO()
    np.savez_compressed(file, **arrays)  # pyright: ignore[reportArgumentType]
    write_atomic(path, file.getvalue())


def load_weights(path: Path) -> tuple[dict[str, np.ndarray], Shape, Words, dict[str, Any]]:
    """What `save_weights` wrote: weights in float32, their shape, names, and what is said of them.

    Raises:
        InputError: the file is missing, damaged, or something else.
    """
    arrays = read_arrays(path, max_bytes=MOST)
    try:
        header = json.loads(arrays["header"].tobytes())
        if header["schema"] != SCHEMA:
            raise ValueError(header["schema"])
        shape, words = Shape(**header["shape"]), Words.from_json(header["words"])
        wanted = layout_of(shape)
        weights = {name: arrays[f"q.{name}"].astype(np.float32) * arrays[f"s.{name}"] for name in wanted}
        wrong = [name for name, size in wanted.items() if weights[name].shape != size]
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: no weights of a prior ({SCHEMA}); take a file that sceneweaver wrote") from error
    if wrong or not all(np.isfinite(value).all() for value in weights.values()):
        raise InputError(f"{path}: weights are damaged; take the file that ships with sceneweaver")
    return weights, shape, words, dict(header["about"])


def quantised(value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """8-bit numbers and scales: of each column of a matrix, and of vectors 16-bit floating point as it is."""
    if value.ndim < 2:
        return value.astype(np.float16), np.ones((), dtype=np.float32)
    scale = np.maximum(np.abs(value).max(axis=0), 1e-12).astype(np.float32) / 127.0
    return np.clip(np.round(value / scale), -127, 127).astype(np.int8), scale
