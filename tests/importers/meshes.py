"""Mesh files for tests of readers."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tests.importers.reading import written


def box_obj(folder: Path, name: str, low, high) -> None:
    """A mesh ``<name>/raw_model.obj``: the box between two corners."""
    points = [[(low, high)[b][k] for k, b in enumerate(bits)] for bits in np.ndindex(2, 2, 2)]
    faces = [(1, 2, 4), (1, 4, 3), (5, 7, 8), (5, 8, 6), (1, 5, 6), (1, 6, 2), (3, 4, 8), (3, 8, 7)]
    faces += [(1, 3, 7), (1, 7, 5), (2, 6, 8), (2, 8, 4)]
    text = [f"v {x} {y} {z}" for x, y, z in points] + [f"f {a} {b} {c}" for a, b, c in faces]
    written(folder, f"{name}/raw_model.obj", "\n".join(text))
