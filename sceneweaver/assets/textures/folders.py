"""Folders of maps that a user has: images named as ambientCG and Poly Haven name theirs."""

from __future__ import annotations

import os
import re
from pathlib import Path

import numpy as np

from sceneweaver.io import load_yaml, open_image
from sceneweaver.io.messages import clean
from sceneweaver.scene import InputError

from .relief import Maps, encoded_roughness, encoded_tint, to_linear

_ROLES = {
    "color": ("color", "basecolor", "base_color", "albedo", "diff", "diffuse", "col"),
    "normal": ("normalgl", "nor_gl", "normal_gl", "normal", "nor"),
    "roughness": ("roughness", "rough"),
    "metallic": ("metalness", "metallic", "metal"),
}
_SUFFIXES = (".png", ".jpg", ".jpeg")
_MAX_SIDE = 1024
_SIZE = 1.0  # metres, where nobody says


def folder_of(name: str) -> Path | None:
    """The user's folder of a texture, or None."""
    root = os.environ.get("SCENEWEAVER_TEXTURES")
    if not root or not re.fullmatch(r"[\w][\w .-]*", name):
        return None
    folder = Path(root).expanduser() / name
    return folder if folder.is_dir() else None


def read_folder(folder: Path) -> Maps:
    """The maps of a folder: a colour image, and where they are there a normal map (OpenGL), roughness and metalness.

    ``texture.yaml`` may say ``size``: the metres that an image covers, one number or one along u and one along v.

    Raises:
        InputError: no colour, an image that cannot be read, or a size that is none.
    """
    size = _size(folder)
    found = _images(folder)
    if "color" not in found:
        raise InputError(f"texture: {clean(str(folder))} has no colour image; name one *_Color, *_BaseColor or *_diff")
    color = _image(found["color"], "RGB", None)
    side = color.shape[0]
    tint, gain = encoded_tint(to_linear(color / 255.0))
    flat = np.broadcast_to(np.array([128, 128, 255], dtype=np.uint8), (side, side, 3))
    normal = _image(found["normal"], "RGB", side) if "normal" in found else np.ascontiguousarray(flat)
    rough = _image(found["roughness"], "L", side) / 255.0 if "roughness" in found else np.ones((side, side))
    metallic = _image(found["metallic"], "L", side) if "metallic" in found else None
    roughness, rough_gain = encoded_roughness(rough)
    return Maps(size, tint, gain, normal, roughness, rough_gain, metallic)


def _images(folder: Path) -> dict[str, Path]:
    """The image of each role; of several, the first word of the role's list wins (a normal map of OpenGL)."""
    found: dict[str, tuple[int, Path]] = {}
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() not in _SUFFIXES:
            continue
        stem = re.sub(r"[_-]\d+k(-(png|jpg))?$", "", path.stem.lower())
        if re.search(r"normaldx|nor_dx|normal_dx", stem):
            continue
        for role, words in _ROLES.items():
            rank = next((k for k, word in enumerate(words) if re.search(rf"(^|[_-]){word}$", stem)), None)
            if rank is not None and (role not in found or rank < found[role][0]):
                found[role] = (rank, path)
    return {role: path for role, (_, path) in found.items()}


def _image(path: Path, mode: str, side: int | None) -> np.ndarray:
    """An image as uint8 [side, side(, 3)]; without a side, the power of two at or below its own, at most 1024."""
    from PIL import Image

    try:
        with open_image(path) as image:
            if mode == "L" and image.mode in ("I", "I;16", "I;16B"):
                image = Image.fromarray((np.asarray(image, dtype=float) / 257).astype(np.uint8))
            side = side or min(_MAX_SIDE, 1 << (min(image.size).bit_length() - 1))
            return np.asarray(image.convert(mode).resize((side, side), Image.Resampling.LANCZOS))
    except InputError as error:
        raise InputError(f"texture: {error}") from None


def _size(folder: Path) -> tuple[float, float]:
    path = folder / "texture.yaml"
    if not path.exists():
        return (_SIZE, _SIZE)
    line = f"texture: {clean(str(path))}: size has to be metres, as in `size: 1.5` or `size: [2.0, 0.5]`"
    try:
        data = load_yaml(path)
        size = data["size"]
        u, v = (float(x) for x in (size if isinstance(size, list) else (size, size)))
    except InputError:
        raise
    except Exception:  # no YAML, another form, no numbers
        raise InputError(line) from None
    if not (0.001 <= u <= 100 and 0.001 <= v <= 100):
        raise InputError(line)
    return (u, v)
