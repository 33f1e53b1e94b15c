"""Mesh files and arrays of unknown origin, read without waiting for pipes and without growing past a limit."""

# pxr has no stubs:
# pyright: reportAttributeAccessIssue=false

from __future__ import annotations

import contextlib
import json
import os
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from sceneweaver.io import open_regular, read_bytes, reason
from sceneweaver.scene import InputError, MissingDependencyError

if TYPE_CHECKING:
    import trimesh

MAX_BYTES = 1 << 30
"""Largest mesh file [bytes], and the most that all files which it names, or its arrays, may have together."""

_COMPONENTS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_SHAPES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


def read_meshes(path: str | os.PathLike[str]) -> trimesh.Scene:
    """A GLB, glTF, OBJ, STL, PLY or OFF file by trimesh; files that it names are read from its own folder only.

    Raises:
        InputError: for a file that is missing, no regular file, too large, damaged, or names such a file.
        MissingDependencyError: for a file that needs a package which is not installed.
    """
    import trimesh

    place = Path(path)
    suffix = place.suffix.lower()
    try:
        with open_regular(place, MAX_BYTES) as file:
            if suffix in (".glb", ".gltf"):
                _check_gltf(place.name, file.read())
                file.seek(0)
            return trimesh.load_scene(file, file_type=suffix[1:], resolver=_resolver(place), process=False)
    except (InputError, MissingDependencyError):
        raise
    except ModuleNotFoundError as error:
        raise MissingDependencyError(
            f"{place.name}: reading it needs the package '{error.name}'; install it with: pip install {error.name}"
        ) from error
    except Exception as error:  # libraries raise whatever they like for damaged files
        raise InputError(f"{place.name}: the file is damaged or cut off ({reason(error)})") from error


def read_arrays(path: str | os.PathLike[str]) -> dict[str, np.ndarray]:
    """The arrays of an ``.npz`` file, which may unpack to `MAX_BYTES` at most.

    Raises:
        InputError: as `read_meshes`.
    """
    name = os.path.basename(path)
    try:
        with open_regular(path, MAX_BYTES) as file:
            with zipfile.ZipFile(file) as packed:
                if sum(entry.file_size for entry in packed.infolist()) > MAX_BYTES:
                    raise InputError(f"{name}: it unpacks to more than {MAX_BYTES >> 20} MiB")
            file.seek(0)
            with np.load(file) as found:
                return {key: found[key] for key in found.files}
    except InputError:
        raise
    except Exception as error:
        raise InputError(f"{name}: the file is damaged or cut off ({reason(error)})") from error


def require_regular_layers(path: Path) -> None:
    """InputError when a USD file, or one that it refers to by references, payloads or sublayers, is a pipe or device.

    A layer that is missing is left to USD, which goes on without it.
    """
    from pxr import Sdf

    todo, seen = [str(path)], set()
    while todo:
        place = todo.pop()
        if place in seen or not os.path.exists(place):
            continue
        seen.add(place)
        open_regular(place, MAX_BYTES).close()
        layer = Sdf.Layer.FindOrOpen(place)
        if layer is not None:
            todo += [layer.ComputeAbsolutePath(asset) for asset in layer.GetCompositionAssetDependencies()]


def _resolver(path: Path) -> Any:
    """What trimesh asks for the files that a mesh file names: regular ones in its folder, of bounded size together."""
    from trimesh.resolvers import FilePathResolver

    class Resolver(FilePathResolver):
        left = MAX_BYTES

        def get(self, name: str) -> bytes:
            for candidate in (name.strip(), name.strip().lstrip("/"), os.path.basename(name)):
                place = None
                with contextlib.suppress(ValueError):  # it leads out of the folder
                    place = self.absolute(candidate)
                if place is not None and place.exists():
                    content = read_bytes(place, max_bytes=self.left)
                    self.left -= len(content)
                    return content
            raise FileNotFoundError(name)

    return Resolver(str(path))


def _check_gltf(name: str, content: bytes) -> None:
    """What a reader would find out late, or with an odd error: a GLB cut off, and arrays larger than any file.

    An accessor without a buffer is as many zeros as it says, and one buffer may serve any number of accessors.
    """
    if name.lower().endswith(".glb"):
        if len(content) < 20 or content[:4] != b"glTF":
            raise InputError(f"{name}: this is no GLB file")
        length = int.from_bytes(content[8:12], "little")
        if len(content) < length:
            raise InputError(f"{name}: the file is cut off: {len(content)} of {length} bytes")
        content = content[20 : 20 + int.from_bytes(content[12:16], "little")]
    rows = json.loads(content).get("accessors", [])
    size = sum(int(r["count"]) * _COMPONENTS.get(r["componentType"], 4) * _SHAPES.get(r["type"], 1) for r in rows)
    if size > MAX_BYTES:
        raise InputError(f"{name}: its arrays have {size >> 20} MiB; at most {MAX_BYTES >> 20} MiB are read")
