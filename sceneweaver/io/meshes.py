"""Mesh files that somebody else made, read by trimesh: GLB, glTF, OBJ, STL, PLY and OFF."""

from __future__ import annotations

import contextlib
import logging
import os
from collections.abc import Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.runtime.package import missing_module

from .errors import InputError, MissingDependencyError
from .json_text import parse_json
from .messages import clean
from .reading import Place, open_regular, read_bytes, reason
from .references import named_inside

if TYPE_CHECKING:
    import trimesh

MAX_BYTES = 2**30
"""Largest mesh file [bytes], and the most that all files which it names, or its arrays, may have together."""

MAX_NODES = 50_000
"""Nodes of a glTF scene."""

MAX_DEPTH = 256
"""glTF nodes within each other: trimesh walks the whole chain for each of them."""

_QUIET = logging.NullHandler()  # what trimesh logs of a damaged file is an error of ours

_COMPONENTS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_SHAPES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}


def read_meshes(path: Place) -> trimesh.Scene:
    """A GLB, glTF, OBJ, STL, PLY or OFF file; files that it names are read from its own folder only.

    Raises:
        InputError: for a file that is missing, no regular file, too large, damaged, or names such a file.
        MissingDependencyError: for a file that needs a package which is not installed.
    """
    import trimesh

    logging.getLogger("trimesh").addHandler(_QUIET)
    place = Path(path)
    name, suffix = clean(place.name), place.suffix.lower()
    with _damage_named(name), open_regular(place, MAX_BYTES) as file:
        if suffix in (".glb", ".gltf"):
            _check_gltf(name, file.read())
            file.seek(0)
        scene = trimesh.load_scene(file, file_type=suffix[1:], resolver=_resolver(place), process=False)
        for body in scene.geometry.values():
            faces: Any = getattr(body, "faces", ())
            if len(faces) and not 0 <= faces.min() <= faces.max() < len(body.vertices):
                raise InputError(f"{name}: a triangle names a vertex that is not there")
    return scene


def read_mesh(path: Place) -> trimesh.Trimesh:
    """All that `read_meshes` finds, as one mesh; errors are the same."""
    scene = read_meshes(path)
    with _damage_named(clean(Path(path).name)):
        return scene.to_mesh()


@contextlib.contextmanager
def _damage_named(name: str) -> Generator[None, None, None]:
    """What libraries raise for damaged files, which is whatever they like, as one line."""
    try:
        yield
    except (InputError, MissingDependencyError):
        raise
    except ModuleNotFoundError as error:
        what = f"{name}: reading it needs the package '{error.name}'"
        raise MissingDependencyError(missing_module(error.name or "", what)) from error
    except Exception as error:
        raise InputError(f"{name}: the file is damaged or cut off ({reason(error)})") from error


def _resolver(path: Path) -> Any:
    """What trimesh asks for the files that a mesh file names: regular ones in its folder, of bounded size together."""
    from trimesh.resolvers import FilePathResolver

    class Resolver(FilePathResolver):
        left = MAX_BYTES

        def get(self, name: str) -> bytes:
            for candidate in (name.strip(), name.strip().lstrip("/"), os.path.basename(name)):
                place = named_inside(path.parent, path.parent / candidate)
                if place is not None and place.exists():
                    content = read_bytes(place, max_bytes=self.left)
                    self.left -= len(content)
                    return content
            raise FileNotFoundError(name)

    return Resolver(str(path))


def _check_gltf(name: str, content: bytes) -> None:
    """What a reader would find out late, or with an odd error: a GLB cut off, and more than memory or time allow.

    An accessor without a buffer is as many zeros as it says, and one buffer may serve any number of accessors.
    """
    if name.lower().endswith(".glb"):
        if len(content) < 20 or content[:4] != b"glTF":
            raise InputError(f"{name}: this is no GLB file")
        length = int.from_bytes(content[8:12], "little")
        if len(content) < length:
            raise InputError(f"{name}: the file is cut off: {len(content)} of {length} bytes")
        content = content[20 : 20 + int.from_bytes(content[12:16], "little")]
    try:
        document = parse_json(content)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
    rows = document.get("accessors", [])
    size = sum(int(r["count"]) * _COMPONENTS.get(r["componentType"], 4) * _SHAPES.get(r["type"], 1) for r in rows)
    if size > MAX_BYTES:
        raise InputError(f"{name}: its arrays have {size >> 20} MiB; at most {MAX_BYTES >> 20} MiB are read")
    _require_tree(name, [list(node.get("children", ())) for node in document.get("nodes", [])])


def _require_tree(name: str, children: list[list[int]]) -> None:
    """That nodes are few, each has one parent at most, and none is deep."""
    if len(children) > MAX_NODES:
        raise InputError(f"{name}: {len(children)} nodes; at most {MAX_NODES} are read")
    parents = [0] * len(children)
    for child in (child for mine in children for child in mine):
        parents[child] += 1
    if max(parents, default=0) > 1:
        raise InputError(f"{name}: a node has two parents; glTF allows one")
    level, seen = [k for k, count in enumerate(parents) if not count], 0
    for _ in range(MAX_DEPTH):
        seen += len(level)
        level = [child for k in level for child in children[k]]
        if not level:
            break
    if level:
        raise InputError(f"{name}: nodes within each other more than {MAX_DEPTH} deep; flatten it")
    if seen < len(children):
        raise InputError(f"{name}: nodes that are their own parents")
