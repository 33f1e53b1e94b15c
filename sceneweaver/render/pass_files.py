"""Files of data passes: PNG, multi-layer EXR or NPZ, with the cameras and the meaning of the ids beside them."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from sceneweaver.io import load_json, own_folder, whole, write_atomic
from sceneweaver.io.messages import quote, suggest
from sceneweaver.runtime.package import missing_extra
from sceneweaver.scene import InputError, MissingDependencyError

from .camera import Shot, shot_from
from .passes import Frame, PassRenderer, check_passes

FORMATS = ("png", "exr", "npz")

SCHEMA = "sceneweaver.passes/1"

_LAYER = "ViewLayer"
_EXR = {
    "color": ("Combined", "RGB"),
    "depth": ("Depth", "Z"),
    "distance": ("Distance", "Z"),
    "normal_world": ("Normal", "XYZ"),
    "normal_cam": ("NormalCamera", "XYZ"),
    "position": ("Position", "XYZ"),
    "instance": ("IndexOB", "X"),
    "semantic": ("Semantic", "X"),
    "material": ("IndexMA", "X"),
}
"""Blender's names of the passes, and of ours that Blender does not have, with their channels."""

_NPZ = {"distance": "depth_meters", "instance": "semantic_instance"}
"""Hypersim's names where they differ from ours."""

_MILLIMETRE = 1000.0
_DEEPEST = 65535


def write_passes(
    renderer: PassRenderer,
    folder: Path,
    passes: Sequence[str],
    kind: str = "png",
    written: list[Path] | None = None,
) -> list[Path]:
    """Write the frames of all cameras; the paths of what was written, ``cameras.json`` and ``labels.json`` last.

    Args:
        renderer: The scene and its cameras.
        folder: Where to; it is made if its own folder exists.
        passes: Which ones, see `PASSES`.
        kind: One of `FORMATS`.
        written: Where the paths are put as files are done, for who may run out of time; None: a new list.

    Raises:
        InputError: a pass or format that is unknown, a camera's name that makes no file name, or a folder that cannot
            be written to.
        MissingDependencyError: EXR is asked for and OpenEXR is not installed.
    """
    check_request(passes, kind)
    for shot in renderer.shots:
        if not shot.name or set(shot.name) & set('/\\:*?"<>|') or shot.name.startswith(".") or len(shot.name) > 100:
            raise InputError(f"cameras: {quote(shot.name)} makes no file name; use letters, digits and dashes")
    own_folder(folder)
    write: Callable[[Frame, Path], list[Path]] = {"png": _write_png, "exr": _write_exr, "npz": _write_npz}[kind]
    written = [] if written is None else written
    for frame in renderer.frames(passes):
        written += write(frame, folder)
    tables = {
        "cameras.json": {"schema": SCHEMA, "cameras": [shot.to_dict() for shot in renderer.shots]},
        "labels.json": {
            "schema": SCHEMA,
            "nothing": 0,
            "instances": renderer.labels.instances,
            "semantics": renderer.labels.semantics,
            "materials": renderer.labels.materials,
        },
    }
    for name, content in tables.items():
        write_atomic(folder / name, json.dumps(content, indent=1) + "\n")
        written.append(folder / name)
    return written


def check_request(passes: Sequence[str], kind: str) -> None:
    """Whether these passes can be written in this format; raises as `write_passes`."""
    check_passes(passes)
    if kind not in FORMATS:
        raise InputError(f"format: '{kind}' is unknown{suggest(kind, FORMATS)}; use one of {', '.join(FORMATS)}")
    if kind == "exr":
        _openexr()


def read_shots(path: Path, width: int, height: int) -> list[Shot]:
    """The cameras of a JSON file: a list of them, or an object with one under ``cameras``; see `shot_from`.

    Raises:
        InputError: the file cannot be read, or something in it makes no camera.
    """
    try:
        data: Any = load_json(path)
    except InputError as error:
        raise InputError(f"--cameras: {error}; use auto or a JSON file") from None
    rows = data.get("cameras") if isinstance(data, dict) else data
    if not isinstance(rows, list) or not rows:
        example = '{"cameras": [{"eye": [1, 1, 1.5], "target": [3, 2, 1]}]}'
        raise InputError(f"--cameras: {path} has no list of cameras; write {example}")
    return [shot_from(row, f"camera-{k}", width, height) for k, row in enumerate(rows)]


def _write_png(frame: Frame, folder: Path) -> list[Path]:
    written = []
    for name, array in frame.arrays.items():
        if name in ("position", "color"):  # they do not fit
            continue
        path = folder / f"{frame.shot.name}_{name}.png"
        with whole(path) as temporary:
            Image.fromarray(_pixels(name, array)).save(temporary, "PNG", compress_level=4)
        written.append(path)
    return written


def _pixels(name: str, array: np.ndarray) -> np.ndarray:
    """An array as a PNG holds it: 8 bits for colours and normals, 16 for millimetres and ids."""
    if name == "rgb":
        return array
    if name.startswith("normal"):
        return np.rint((array + 1) * 127.5).astype(np.uint8)
    if name in ("depth", "distance"):
        deep = np.where(np.isfinite(array), np.rint(array * _MILLIMETRE), 0)
        return np.minimum(deep, _DEEPEST).astype(np.uint16)
    return array.astype(np.uint16)


def _write_npz(frame: Frame, folder: Path) -> list[Path]:
    path = folder / f"{frame.shot.name}.npz"
    arrays = {_NPZ.get(name, name): array for name, array in frame.arrays.items()}
    arrays |= {
        "K": frame.shot.k,
        "camera_to_world_blender": frame.shot.camera_to_world,
        "camera_to_world_opencv": frame.shot.camera_to_world_opencv,
    }
    with whole(path) as temporary:
        np.savez_compressed(temporary, **arrays)  # pyright: ignore[reportArgumentType]
    return [path]


def _write_exr(frame: Frame, folder: Path) -> list[Path]:
    openexr = _openexr()
    path = folder / f"{frame.shot.name}.exr"
    channels: dict[str, np.ndarray] = {}
    for name, array in frame.arrays.items():
        if name not in _EXR:
            continue
        layer, letters = _EXR[name]
        values = array.astype(np.float32).reshape(*array.shape[:2], -1)
        for k, letter in enumerate(letters):
            channels[f"{_LAYER}.{layer}.{letter}"] = np.ascontiguousarray(values[..., k])
    header = {"compression": openexr.ZIP_COMPRESSION, "type": openexr.scanlineimage}
    with whole(path) as temporary:
        openexr.File(header, channels).write(str(temporary))
    return [path]


def _openexr() -> Any:
    try:
        import OpenEXR  # pyright: ignore[reportMissingImports]
    except ImportError:
        raise MissingDependencyError(missing_extra("exr", "EXR files need OpenEXR")) from None
    return OpenEXR
