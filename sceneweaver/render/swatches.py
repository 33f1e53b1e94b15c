"""Flat pieces of every pattern at real size, in light that comes from the side."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache

import numpy as np
from PIL import Image

from sceneweaver.assets import textures
from sceneweaver.assets.body import Material
from sceneweaver.assets.materials import finishes, rgb
from sceneweaver.assets.textures.relief import to_linear, to_srgb
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError

from .words import tables

_LIGHT = np.array([-0.72, 0.36, 0.60]) / np.linalg.norm([0.72, 0.36, 0.60])
_HALF = (_LIGHT + np.array([0.0, 0.0, 1.0])) / np.linalg.norm(_LIGHT + np.array([0.0, 0.0, 1.0]))


def swatches(names: Iterable[str] = (), size: int = 240) -> Iterator[tuple[str, Image.Image]]:
    """A label and a square picture for each pattern.

    Raises:
        InputError: for a pattern that is unknown.
    """
    known = textures.patterns()
    for name in list(names) or known:
        if name not in known:
            raise InputError(f"pattern: '{name}' is unknown{suggest(name, known)}")
        wide = round(min(max(known[name].size), 2 * min(known[name].size)), 3)
        yield f"{name}, {wide:g} m", swatch(_look(name), wide, size)


def swatch(material: Material, wide: float, size: int = 240) -> Image.Image:
    """A square of a material that is ``wide`` metres across, seen from straight ahead.

    Raises:
        InputError: the material has no maps.
    """
    maps = textures.maps(material.texture)
    if maps is None:
        raise InputError(f"material: '{material.name}' has no pattern")
    samples = 3  # a side, of each pixel
    v, u = np.mgrid[0 : samples * size, 0 : samples * size] * (wide / (samples * size))
    height, width = maps.roughness.shape
    rows, columns = (
        np.mod(v / maps.size[1] * height, height).astype(int),
        np.mod(u / maps.size[0] * width, width).astype(int),
    )
    base = to_linear(np.array(material.color)) * to_linear(maps.tint / 255.0)[rows, columns] * maps.gain
    normal = maps.normal[rows, columns] / 127.5 - 1.0
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    rough = np.clip(maps.roughness[rows, columns] / 255.0 * maps.rough_gain * material.roughness, 0.1, 1.0)[..., None]
    sun = np.clip(normal @ _LIGHT, 0.0, None)[..., None]
    facing = np.clip(normal @ _HALF, 0.0, 1.0)[..., None]
    lobe = rough**4 / (np.pi * (facing**2 * (rough**4 - 1.0) + 1.0) ** 2)
    mirrored = 0.04 * (1.0 - material.metallic) + base * material.metallic
    around = 0.55 + 0.45 * normal[..., 1:2] - 0.25 * normal[..., 0:1]
    light = base * (1.0 - material.metallic) * (1.2 * sun + 0.28)
    light += mirrored * (np.minimum(lobe, 6.0) * sun * 0.5 + around * (0.15 + 0.85 * material.metallic))
    light = light.reshape(size, samples, size, samples, 3).mean(axis=(1, 3))
    return Image.fromarray(np.round(to_srgb(np.clip(light, 0.0, 1.0)) * 255).astype(np.uint8))


@cache
def _look(pattern: str) -> Material:
    """The first finish that has a pattern, or a colour that becomes it."""
    metals, plain = tables()["metal swatches"], tables()["swatches"]
    if pattern in metals:
        return Material(pattern, rgb(metals[pattern]), roughness=0.4, metallic=1.0, texture=pattern)
    if pattern in plain:
        return Material(pattern, rgb(plain[pattern]), roughness=0.5, texture=pattern)
    for finish in finishes().values():
        if finish.material.texture == pattern:
            return finish.material
    return Material(pattern, rgb("#eeece6"), roughness=0.6, texture=pattern)
