"""Maps as image files, small ones: JPEG for colours and normals, and nothing where a map says nothing."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sceneweaver.assets import Material
from sceneweaver.assets.by_identity import ByIdentity
from sceneweaver.assets.textures import Maps, maps
from sceneweaver.runtime.deadline import checkpoint

_FLAT = 0.012  # mean slope below which a normal map cannot be seen
_EVEN = 0.03  # share by which roughness has to differ to be worth a map


@dataclass(frozen=True)
class Images:
    """Files of one texture: its tint (sRGB), its normals, and roughness (green) with metal (blue); None: not needed.
    ``metal`` says whether the last tells where metal is."""

    color: bytes
    normal: bytes | None
    rough: bytes | None
    metal: bool


def images(texture: str, side: int = 1024) -> Images | None:
    """The image files of a texture as JPEG, at most ``side`` pixels wide; None for a plain one.

    Raises:
        InputError: nobody knows the texture.
    """
    checkpoint()
    found = maps(texture)
    return None if found is None else _files(ByIdentity(found), side)


@lru_cache(maxsize=128)
def _files(key: ByIdentity[Maps], side: int) -> Images:
    found = key.it
    uneven = float(found.roughness.std()) / max(float(found.roughness.mean()), 1.0)
    rough = None
    if uneven > _EVEN or found.metallic is not None:
        metal = np.full_like(found.roughness, 255) if found.metallic is None else found.metallic
        rough = jpeg(np.stack([np.full_like(metal, 255), found.roughness, metal], 2), min(side, len(metal) // 2), 80)
    return Images(
        jpeg(found.tint, side, 85),
        jpeg(found.normal, side, 88) if has_relief(found) else None,
        rough,
        found.metallic is not None,
    )


def has_relief(found: Maps) -> bool:
    """Whether the normals of maps can be seen."""
    return float(np.hypot(*(found.normal[..., k] / 127.5 - 1.0 for k in (0, 1))).mean()) > _FLAT


def file_stem(texture: str) -> str:
    """The name of a texture as part of a file's name."""
    return re.sub(r"[^A-Za-z0-9_.-]", "-", texture)


def jpeg(image: np.ndarray, side: int, quality: int) -> bytes:
    """An image uint8 [H, W, 3] as JPEG without loss of colour resolution, at most ``side`` pixels wide and high."""
    return _packed(image, side, "JPEG", quality=quality, subsampling=0)


def square(image: np.ndarray, side: int, quality: int) -> bytes:
    """An image uint8 [H, W, 3] as JPEG of exactly ``side`` pixels."""
    from PIL import Image

    picture = Image.fromarray(np.ascontiguousarray(image)).resize((side, side), Image.Resampling.BOX)
    return jpeg(np.asarray(picture), side, quality)


def png(image: np.ndarray, side: int) -> bytes:
    """An image uint8 [H, W, 3] as PNG, at most ``side`` pixels wide and high."""
    return _packed(image, side, "PNG")


def _packed(image: np.ndarray, side: int, kind: str, **options: int) -> bytes:
    from PIL import Image

    picture = Image.fromarray(np.ascontiguousarray(image))
    if max(picture.size) > side:
        picture = picture.resize((min(side, picture.width), min(side, picture.height)), Image.Resampling.BOX)
    data = io.BytesIO()
    picture.save(data, kind, **options)
    return data.getvalue()


def linear(color: Sequence[float]) -> list[float]:
    """Linear light of an sRGB colour."""
    return [round(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4, 6) for c in color]


def tinted(material: Material, base: list[float]) -> tuple[list[float], float]:
    """Linear colour and roughness with which the maps of a material are multiplied; both at most 1.

    Args:
        material: One with maps or without.
        base: Its linear base colour.
    """
    found = maps(material.texture)
    if found is None:
        return base, material.roughness
    color = [round(min(1.0, c * found.gain), 6) for c in base]
    return color, round(min(1.0, material.roughness * found.rough_gain), 6)
