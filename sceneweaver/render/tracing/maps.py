"""Seamless maps of all textures of a picture in two long arrays, with their mips."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from sceneweaver.assets import textures

from . import world_kernels

_LEAST_LEVEL = 4  # texels a side of the smallest mip


class MapTable:
    """Collects the maps that materials name, each once."""

    def __init__(self) -> None:
        self._rows: dict[str, tuple[int, float, float]] = {}
        self._patterns: list[Any] = []
        self._colors: list[np.ndarray] = []
        self._bumps: list[np.ndarray] = []
        self._count = 0

    def add(self, texture: str) -> tuple[int, float, float]:
        """The row of a texture, -1 for none, and what its maps' tint and roughness are multiplied by."""
        if texture not in self._rows:
            maps = textures.maps(texture)
            self._rows[texture] = (-1, 1.0, 1.0) if maps is None else self._put(maps)
        return self._rows[texture]

    def _put(self, maps: textures.Maps) -> tuple[int, float, float]:
        tint = _linear(maps.tint)
        rough = maps.roughness[..., None] / 255.0
        metal = np.ones_like(rough) if maps.metallic is None else maps.metallic[..., None] / 255.0
        color = np.concatenate([tint, rough], axis=2)
        bump = np.concatenate([maps.normal / 255.0, metal], axis=2)
        row = world_kernels.Pattern()
        row.scale = wp.vec2(1.0 / maps.size[0], 1.0 / maps.size[1])
        row.start, row.width, row.levels = self._count, len(tint), 0
        while True:
            shown = np.concatenate([np.sqrt(color[..., :3]), color[..., 3:]], axis=2)
            self._colors.append(_packed(shown))
            self._bumps.append(_packed(bump))
            self._count += len(color) ** 2
            row.levels += 1
            if len(color) <= _LEAST_LEVEL:
                break
            color, bump = _halved(color), _halved(bump)
        self._patterns.append(row)
        return len(self._patterns) - 1, maps.gain, maps.rough_gain

    def arrays(self) -> tuple[wp.array, wp.array, wp.array]:
        """Rows, tints with roughness, and normals with metal, on the current device."""
        empty = [np.zeros(1, dtype=np.uint32)]
        return (
            wp.array(self._patterns or [world_kernels.Pattern()], dtype=world_kernels.Pattern),
            wp.array(np.concatenate(self._colors or empty), dtype=wp.uint32),
            wp.array(np.concatenate(self._bumps or empty), dtype=wp.uint32),
        )


def _linear(srgb: np.ndarray) -> np.ndarray:
    table = np.arange(256) / 255.0
    return np.where(table <= 0.04045, table / 12.92, ((table + 0.055) / 1.055) ** 2.4)[srgb]


def _halved(image: np.ndarray) -> np.ndarray:
    """An image [2 n, 2 n, 4] at half its size [n, n, 4]."""
    n = len(image) // 2
    return image.reshape(n, 2, n, 2, 4).mean(axis=(1, 3))


def _packed(image: np.ndarray) -> np.ndarray:
    """Values [n, n, 4] in 0..1 as uint32 [n * n], the first channel lowest."""
    texel = np.round(np.clip(image, 0.0, 1.0) * 255).astype(np.uint32)
    return (texel[..., 0] | texel[..., 1] << 8 | texel[..., 2] << 16 | texel[..., 3] << 24).reshape(-1)
