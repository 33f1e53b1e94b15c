"""The shine around lamps in a picture."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageFilter

from .caster import Picture


def glowing(picture: Picture, things: int) -> np.ndarray:
    """The picture [H, W, 3] with a soft warm shine around what is very bright of the first ``things`` instances."""
    rgb = picture.rgb
    bright = (picture.objects >= 0) & (picture.objects < things) & (rgb.min(axis=2) >= 250)
    if not bright.any():
        return rgb
    radius = rgb.shape[0] / 75
    reach = int(4 * radius) + 1  # nothing shines farther
    rows, columns = (np.flatnonzero(bright.any(axis=axis)) for axis in (1, 0))
    part = tuple(slice(max(0, at[0] - reach), at[-1] + reach + 1) for at in (rows, columns))
    mask = Image.fromarray(bright[part].astype(np.uint8) * 255).filter(ImageFilter.GaussianBlur(radius))
    shine = np.asarray(mask, dtype=np.float32)[..., None] / 255 * np.array([0.50, 0.40, 0.26], dtype=np.float32)
    rgb = rgb.copy()
    rgb[part] = (255.0 - (255.0 - rgb[part]) * (1.0 - shine)).astype(np.uint8)
    return rgb
