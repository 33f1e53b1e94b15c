"""Maps by name: baked once, kept in memory and in the user's cache folder; folders of the user come first."""

from __future__ import annotations

import contextlib
import hashlib
import os
from functools import cache, lru_cache
from importlib import resources
from pathlib import Path

import numpy as np

from sceneweaver.io import packaged, read_arrays, temporary_folder
from sceneweaver.io.messages import suggest
from sceneweaver.runtime.caches import cache_place, places, writable
from sceneweaver.scene import InputError

from .catalogue import OLD_NAMES, found, patterns
from .folders import folder_of, read_folder
from .registry import Pattern
from .relief import Maps, developed


def maps(texture: str) -> Maps | None:
    """The maps of a texture; None for "plain".

    A folder of this name under ``$SCENEWEAVER_TEXTURES`` comes before the pattern of the library.

    Raises:
        InputError: nobody knows the texture, or its folder cannot be read.
    """
    if texture == "plain":
        return None
    name = OLD_NAMES.get(texture, texture)
    folder = folder_of(name)
    if folder is not None:
        return _of_folder(folder)
    entry = found(name)
    if entry is None:
        raise InputError(f"texture: '{texture}' is unknown{suggest(texture, patterns())}; see docs/materials.md")
    return _of_pattern(entry)


@lru_cache(maxsize=64)
def _of_folder(folder: Path) -> Maps:
    return read_folder(folder)


@cache
def _of_pattern(entry: Pattern) -> Maps:
    name = f"{entry.name}-{entry.pixels}-{_version()}.npz"
    kept = next((found for folder in places(cache_folder()) if (found := _read(folder / name)) is not None), None)
    if kept is None:
        kept = developed(entry.draw(entry.pixels), entry.size)
        _write(name, kept)
    for image in (kept.tint, kept.normal, kept.roughness, kept.metallic):
        if image is not None:
            image.setflags(write=False)
    return kept


def cache_folder() -> Path:
    """Where baked maps are kept, as long as that can be written."""
    return cache_place("sceneweaver/textures")


@cache
def _version() -> str:
    """Changes with every change of the code that draws."""
    digest = hashlib.sha256()
    package = resources.files(__package__ or "")
    for folder in (package, package.joinpath("patterns")):
        for file in sorted(folder.iterdir(), key=lambda f: f.name):
            if file.name.endswith(".py"):
                digest.update(packaged.bytes_of(file))
    return digest.hexdigest()[:12]


def _read(path: Path) -> Maps | None:
    """Maps of a file; None when it is not there or is not whole."""
    try:
        data = read_arrays(path)
        size = (float(data["size"][0]), float(data["size"][1]))
        images = [data[name] for name in ("tint", "normal", "roughness")]
        gains = float(data["gain"]), float(data["rough_gain"])
        return Maps(size, images[0], gains[0], images[1], images[2], gains[1], data.get("metallic"))
    except Exception:  # a file that another process left half-written, or that is broken, is made again
        return None


def _write(name: str, made: Maps) -> None:
    """Keep maps for the next time; where no folder can be written, they are baked again then."""
    arrays = {"size": np.array(made.size), "gain": np.array(made.gain), "rough_gain": np.array(made.rough_gain)}
    arrays |= {"tint": made.tint, "normal": made.normal, "roughness": made.roughness}
    if made.metallic is not None:
        arrays["metallic"] = made.metallic
    with contextlib.suppress(OSError, InputError):
        path = writable(cache_folder()) / name
        with temporary_folder(path.parent) as draft:
            np.savez_compressed(draft / path.name, allow_pickle=False, **arrays)
            os.replace(draft / path.name, path)
        for old in path.parent.glob(f"{path.stem.rpartition('-')[0]}-*.npz"):
            if old != path:
                old.unlink()
