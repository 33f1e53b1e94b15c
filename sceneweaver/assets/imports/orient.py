"""Triangles that face outward: files often hold pieces that are inside out."""

from __future__ import annotations

import numpy as np

from .pieces import linked, welded


def outward(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """The faces, with those of each connected piece turned round whose signed volume is negative."""
    points, triangles = welded(vertices, faces)
    label = linked(len(points), triangles[:, :2], triangles[:, 1:])[triangles[:, 0]]
    count = int(label.max(initial=-1)) + 1
    sizes = np.maximum(np.bincount(label, minlength=count), 1)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    middle = np.stack([np.bincount(label, ((a + b + c) / 3)[:, k], count) for k in range(3)], axis=1) / sizes[:, None]
    a, b, c = a - middle[label], b - middle[label], c - middle[label]
    volume = np.bincount(label, np.einsum("ij,ij->i", a, np.cross(b, c)) / 6, count)
    inside_out = volume[label] < 0
    return np.where(inside_out[:, None], faces[:, ::-1], faces)
