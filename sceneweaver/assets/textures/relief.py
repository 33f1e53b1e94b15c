"""From heights and colours to the maps that renderers read."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .noise import blurred


@dataclass(frozen=True)
class Maps:
    """Seamless maps of a pattern; row 0 is the top, so a point at (u, v) metres has its pixel at column
    ``u / size[0] * W`` and row ``(1 - v / size[1]) * H``, both modulo the side.

    ``tint`` uint8 [H, W, 3] is sRGB and multiplies, in linear light and times ``gain``, the material's base colour; the
    mean of linear tint times gain is 1 in each channel. ``normal`` uint8 [H, W, 3] is in the frame of the tangent (x
    along u, y along v, z outward), 0..255 for -1..1. ``roughness`` uint8 [H, W] is the share of the material's
    roughness times ``rough_gain``, whose mean is 1 as well. ``metallic`` uint8 [H, W] is the share of the material's,
    or None: it is all metal or none.
    """

    size: tuple[float, float]
    tint: np.ndarray
    gain: float
    normal: np.ndarray
    roughness: np.ndarray
    rough_gain: float
    metallic: np.ndarray | None = None


@dataclass(frozen=True)
class Relief:
    """What a pattern draws, all [n, n]: ``tint`` linear colour [n, n, 3] or grey [n, n] in any scale; ``height`` in
    metres; ``roughness`` in any scale; ``metallic`` in 0..1; ``shade`` is how much darker it gets one ``reach`` (share
    of the side) below what is around."""

    tint: np.ndarray
    height: np.ndarray
    roughness: np.ndarray | None = None
    metallic: np.ndarray | None = None
    shade: float = 0.0
    reach: float = 0.01


def developed(relief: Relief, size: tuple[float, float]) -> Maps:
    """The maps of a relief that covers ``size`` metres."""
    n = len(relief.height)
    tint = np.repeat(relief.tint[:, :, None], 3, 2) if relief.tint.ndim == 2 else relief.tint
    if relief.shade:
        low = blurred(relief.height, relief.reach) - relief.height
        low = np.clip(low / max(2.0 * float(low.std()), 1e-12), 0.0, 1.5)
        tint = tint * (1.0 - relief.shade * low)[:, :, None]
    encoded, gain = encoded_tint(tint)
    roughness, rough_gain = encoded_roughness(np.ones((n, n)) if relief.roughness is None else relief.roughness)
    metallic = None if relief.metallic is None else _bytes(relief.metallic)
    return Maps(size, encoded, gain, normals(relief.height, size), roughness, rough_gain, metallic)


def normals(height: np.ndarray, size: tuple[float, float]) -> np.ndarray:
    """The normal map uint8 [H, W, 3] of heights [H, W] in metres."""
    rows, columns = height.shape
    along = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * (columns / (2 * size[0]))
    up = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) * (rows / (2 * size[1]))
    normal = np.stack([-along, -up, np.ones_like(height)], 2)
    return _bytes(normal / np.linalg.norm(normal, axis=2, keepdims=True) * 0.5 + 0.5)


def encoded_tint(tint: np.ndarray) -> tuple[np.ndarray, float]:
    """sRGB bytes of linear colours whose mean becomes 1 in each channel, and their gain; lights above 99.8 % of all
    are cut, as they would darken the rest."""
    tint = np.clip(tint, 0.0, None)
    gain = 1.0
    for _ in range(3):
        tint = tint / np.maximum(tint.mean(axis=(0, 1)), 1e-9)
        gain = max(1.0, float(np.quantile(tint, 0.998)))
        tint = np.minimum(tint, gain)
    return _bytes(to_srgb(tint / gain)), gain


def encoded_roughness(roughness: np.ndarray) -> tuple[np.ndarray, float]:
    """Bytes of roughness in any scale, and the gain with which its mean becomes 1."""
    rough = np.clip(roughness, 0.02, None)
    rough = rough / rough.mean()
    gain = max(1.0, float(np.quantile(rough, 0.998)))
    return _bytes(rough / gain), gain


def to_srgb(linear: np.ndarray) -> np.ndarray:
    """sRGB in 0..1 of linear light."""
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)


def to_linear(srgb: np.ndarray) -> np.ndarray:
    """Linear light of sRGB in 0..1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def _bytes(values: np.ndarray) -> np.ndarray:
    return np.round(np.clip(values, 0.0, 1.0) * 255).astype(np.uint8)
