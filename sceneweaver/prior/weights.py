"""The file of the prior's weights: what they are for and in what shape."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.weights import read_weights, write_weights

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
    write_weights(path, weights, header)


def load_weights(path: Path) -> tuple[dict[str, np.ndarray], Shape, Words, dict[str, Any]]:
    """What `save_weights` wrote: weights in float32, their shape, names, and what is said of them.

    Raises:
        InputError: the file is missing, damaged, or something else.
    """
    weights, header = read_weights(path, "a prior", SCHEMA, MOST)
    try:
        shape, words = Shape(**header["shape"]), Words.from_json(header["words"])
        wanted = layout_of(shape)
        wrong = [name for name, size in wanted.items() if weights[name].shape != size]
        about = dict(header["about"])
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: no weights of a prior ({SCHEMA}); take a file that sceneweaver wrote") from error
    if wrong:
        raise InputError(f"{path}: weights are damaged; take the file that ships with sceneweaver")
    return {name: weights[name] for name in wanted}, shape, words, about
