"""Seamless maps of all textures of a picture in two long arrays, with their mips."""

from __future__ import annotations

from functools import cached_property, lru_cache
from typing import Any

import numpy as np
import warp as wp

from sceneweaver.assets import textures
from sceneweaver.assets.by_identity import ByIdentity
from sceneweaver.runtime.deadline import checkpoint

from .world_kernels import Pattern

_LEAST_LEVEL = 4  # texels a side of the smallest mip


class MapTable:
    """Collects the maps that materials name, each once."""

    def __init__(self) -> None:
        self._rows: dict[str, tuple[int, float, float]] = {}
        self._patterns: list[Any] = []
        self._mips: list[_Mips] = []
        self._count = 0

    def add(self, texture: str) -> tuple[int, float, float]:
        """The row of a texture, -1 for none, and what its maps' tint and roughness are multiplied by."""
        if texture not in self._rows:
            checkpoint()  # the first use of a map reads it and works out its mips
            maps = textures.maps(texture)
            checkpoint()
            self._rows[texture] = (-1, 1.0, 1.0) if maps is None else self._put(maps)
        return self._rows[texture]

    def _put(self, maps: textures.Maps) -> tuple[int, float, float]:
        mips = _mips(ByIdentity(maps))
        row = Pattern()
        row.scale = wp.vec2(1.0 / maps.size[0], 1.0 / maps.size[1])
        row.start, row.width, row.levels = self._count, mips.width, mips.levels
        self._mips.append(mips)
        self._count += len(mips.colors)
        self._patterns.append(row)
        return len(self._patterns) - 1, maps.gain, maps.rough_gain

    @property
    def rows(self) -> wp.array:
        """Where the maps of each row are, on the current device."""
        return wp.array(self._patterns or [Pattern()], dtype=Pattern)

    @property
    def colors(self) -> wp.array:
        """Square roots of linear tints, with roughness, 8 bits each."""
        return self._texels([mips.colors for mips in self._mips])

    @property
    def bumps(self) -> wp.array:
        """Normals, with metal, 8 bits each."""
        return self._texels([mips.bumps for mips in self._mips])

    def _texels(self, found: list[np.ndarray]) -> wp.array:
        return wp.array(np.concatenate(found or [np.zeros(1, dtype=np.uint32)]), dtype=wp.uint32)


class _Mips:
    """The maps of a texture at all their sizes, one after the other, the largest first."""

    def __init__(self, maps: textures.Maps):
        tint = _linear(maps.tint)
        rough = maps.roughness[..., None] / 255.0
        metal = np.ones_like(rough) if maps.metallic is None else maps.metallic[..., None] / 255.0
        self.width = len(tint)
        colors = _levels(np.concatenate([tint, rough], axis=2))
        self.levels = len(colors)
        self.colors = np.concatenate([_packed(np.dstack([np.sqrt(c[..., :3]), c[..., 3:]])) for c in colors])
        self._bump = np.concatenate([maps.normal / 255.0, metal], axis=2)

    @cached_property
    def bumps(self) -> np.ndarray:
        """Normals with metal, packed."""
        return np.concatenate([_packed(b) for b in _levels(self._bump)])


@lru_cache(maxsize=96)
def _mips(maps: ByIdentity[textures.Maps]) -> _Mips:
    return _Mips(maps.it)


def _levels(image: np.ndarray) -> list[np.ndarray]:
    """An image [n, n, 4] and its halves, down to the smallest mip."""
    found = [image]
    while len(found[-1]) > _LEAST_LEVEL:
        checkpoint()
        found.append(_halved(found[-1]))
    return found


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
