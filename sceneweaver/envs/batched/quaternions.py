"""Quaternions (w, x, y, z), as MuJoCo has them."""

from __future__ import annotations

import numpy as np


def product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The rotation b followed by a: [..., 4]."""
    w, x, y, z = np.moveaxis(np.asarray(a, dtype=float), -1, 0)
    p, q, r, s = np.moveaxis(np.asarray(b, dtype=float), -1, 0)
    return np.stack(
        [
            w * p - x * q - y * r - z * s,
            w * q + x * p + y * s - z * r,
            w * r - x * s + y * p + z * q,
            w * s + x * r - y * q + z * p,
        ],
        axis=-1,
    )
