"""The file of the network's weights, with the pieces that it knows and the labels that it tells apart."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError
from sceneweaver.io.weights import read_weights, write_weights

from .evidence import TYPES, WORDS
from .labels import KINDS, LINKS, MARKS
from .pieces import Vocabulary

SCHEMA = "sceneweaver.reader/1"
MOST = 64 * 2**20
"""Bytes that a file of weights may unpack to."""

_LABELS = {"kinds": [*KINDS], "links": [*LINKS], "marks": [*MARKS], "types": [*TYPES], "words": [*WORDS]}


@dataclass(frozen=True)
class Model:
    """A network: weights by name in float32, how many layers its encoder has, its pieces, and what is said of it."""

    weights: Mapping[str, np.ndarray]
    layers: int
    vocabulary: Vocabulary
    about: Mapping[str, Any]


def save_model(
    path: Path, weights: Mapping[str, np.ndarray], layers: int, pieces: Iterable[str], about: Mapping[str, Any]
) -> None:
    """Write a network, its matrices as 8-bit numbers."""
    header = {"schema": SCHEMA, "layers": layers, "pieces": [*pieces], "labels": _LABELS, "about": dict(about)}
    write_weights(path, weights, header)


def load_model(path: Path) -> Model:
    """What `save_model` wrote.

    Raises:
        InputError: the file is missing, damaged, or of other labels than this version has.
    """
    weights, header = read_weights(path, "a reader", SCHEMA, MOST)
    try:
        if header["labels"] != _LABELS:
            raise ValueError("labels")
        return Model(weights, int(header["layers"]), Vocabulary(header["pieces"]), dict(header["about"]))
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{path}: no weights of a reader of this version; take the file that ships with it") from error
