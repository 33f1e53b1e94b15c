"""All formats by name: what a scene becomes in a folder, and which suffix stands for which format."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from sceneweaver.assets.placed import Load, loader, welded_assets
from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.scene import InputError, Scene

from .folder import fill, move, staged
from .glb import write_glb
from .mjcf import mjcf
from .mjcf_clients import CLIENTS, sleeping_twin
from .scenestate import write_scenestate
from .sdf import sdf
from .urdf_room import room_urdf
from .usd import write_usd

_OURS = re.compile(r"(room|[a-z0-9_]+-[0-9a-f]{10})(-.*)?\.(obj|mtl|urdf)")  # files of articulations


@dataclass(frozen=True)
class Format:
    """A format: the file that it makes in a folder, and who writes it: (scene, path, load, with textures)."""

    name: str
    file: str
    what: str
    write: Callable[[Scene, Path, Load, bool], object]


def _write_glb(scene: Scene, path: Path, load: Load, textures: bool) -> None:
    write_glb(scene, path, load, textures=textures)


def _write_usd(scene: Scene, path: Path, load: Load, textures: bool) -> None:
    write_usd(scene, path, load, textures=textures)


def _write_mjcf(scene: Scene, path: Path, load: Load, textures: bool, client: str | None = None) -> None:
    """``scene.xml`` with ``meshes/`` and ``textures/`` beside it, in a folder that holds other things as well; the text
    comes last, and its sleeping twin, which the file for all has."""
    model = mjcf(scene, load, textures=textures, client=client)
    meshes = path.parent / "meshes"
    files = {**model.files, path.name: model.xml.encode()}
    if client is None:
        files[f"{path.stem}-sleep.xml"] = sleeping_twin(path.name, scene.id)
    with staged(path, "path") as draft:
        fill(draft, files)
        move({draft / name: path.parent / name for name in files})
    for left in meshes.glob("*.obj") if meshes.is_dir() else ():
        if f"meshes/{left.name}" not in model.files:
            left.unlink()  # of an export that this one has replaced


def _write_files(files: dict[str, bytes], path: Path, folder: str) -> None:
    """A text and the files in a folder beside it that it names, among others; the text comes last."""
    files[path.name] = files.pop(next(name for name in files if "/" not in name))
    with staged(path, "path") as draft:
        fill(draft, files)
        move({draft / name: path.parent / name for name in sorted(files, key=lambda name: name == path.name)})
    for left in (path.parent / folder).rglob("*"):
        if _OURS.fullmatch(left.name) and left.relative_to(path.parent).as_posix() not in files:
            left.unlink()  # of an export that this one has replaced


def _write_sdf(scene: Scene, path: Path, load: Load, _: bool, bullet: bool = False) -> None:
    _write_files(sdf(scene, load, bullet=bullet), path, "sdf")


def _write_urdf(scene: Scene, path: Path, load: Load, _: bool) -> None:
    _write_files(room_urdf(scene, load), path, "urdf")


FORMATS: dict[str, Format] = {
    f.name: f
    for f in (
        Format("glb", "scene.glb", "glTF 2.0 binary", _write_glb),
        Format("usd", "scene.usdc", "USD with physics, binary", _write_usd),
        Format("usda", "scene.usda", "USD with physics, as text", _write_usd),
        Format("mjcf", "scene.xml", "MuJoCo, with meshes/", _write_mjcf),
        Format(
            "scenestate",
            "scenestate.json",
            "SceneState, with models/",
            lambda scene, path, load, _: write_scenestate(scene, path, load, models=True),
        ),
        Format("sdf", "scene.sdf", "one SDF world, with sdf/", _write_sdf),
        Format("urdf", "scene.urdf.json", "a URDF a piece, with urdf/", _write_urdf),
    )
}

VARIANTS: dict[str, dict[str, Callable[[Scene, Path, Load, bool], object]]] = {
    "mjcf": {client: partial(_write_mjcf, client=client) for client in CLIENTS},
    "sdf": {"pybullet": partial(_write_sdf, bullet=True)},
}
"""By format, who writes it for one client."""

USUAL = ("glb", "usd", "mjcf")
"""What is written when nobody says what."""


def format_named(name: str) -> Format:
    """The format of a name; ``mjcf:<client>`` and ``sdf:<client>`` are those for one reader.

    Raises:
        InputError: for a name that is no format.
    """
    base, _, client = name.partition(":")
    if name in FORMATS:
        return FORMATS[name]
    if base not in VARIANTS:
        raise InputError(f"export: '{name}' is no format; use {', '.join(FORMATS)}, all or none")
    if client not in VARIANTS[base]:
        raise InputError(f"export: '{name}' is no format; clients of {base} are {', '.join(VARIANTS[base])}")
    return replace(FORMATS[base], name=name, write=VARIANTS[base][client])


def formats_named(names: str | Iterable[str]) -> tuple[str, ...]:
    """Names of formats from a list or from text with commas; "all" and "none" are understood.

    Raises:
        InputError: for a name that is no format, or two of one file.
    """
    listed = names.split(",") if isinstance(names, str) else list(names)
    found: list[str] = []
    for name in (text.strip().lower() for text in listed):
        if name == "all":
            found += [n for n in FORMATS if n != "usda"]
        elif name not in ("none", ""):
            found.append(format_named(name).name)
    files: dict[str, str] = {}
    for name in found:
        other = files.setdefault(format_named(name).file, name)
        if other != name:
            raise InputError(f"export: '{other}' and '{name}' are one file, {format_named(name).file}; choose one")
    return tuple(files.values())


def format_of(path: Path) -> Format:
    """The format that a file's suffix stands for.

    Raises:
        InputError: where it stands for none.
    """
    suffix = path.suffix.lower()
    for found in FORMATS.values():
        if Path(found.file).suffix == suffix:
            return found
    known = ", ".join(sorted({Path(f.file).suffix for f in FORMATS.values()}))
    raise InputError(f"out: '{path.name}' stands for no format; end it with {known}, or give a folder and --to")


def export_scene(
    scene: Scene,
    folder: str | os.PathLike[str],
    formats: Sequence[str] = USUAL,
    load: Load | None = None,
    *,
    textures: bool = True,
    welded: bool = False,
) -> dict[str, Path]:
    """Write a scene in several formats into a folder, which is made where it is not there.

    Args:
        scene: The scene.
        folder: Where the files go; ``FORMATS`` says under which names.
        formats: Names of formats; ``mjcf:<client>`` is MJCF for one reader.
        load: From asset id to asset; None: the library of this user. Each asset is loaded once for all formats.
        textures: Whether materials have their maps; without, files are a fraction of the size.
        welded: Whether fruit in a bowl, books of a stack and the like are one body, which is quicker to simulate.

    Returns:
        The path of each format's file.

    Raises:
        InputError: for a format that is unknown, an asset that is missing, or a folder that cannot be written. Each
            file is there whole or as it was before.
    """
    wanted = [format_named(name) for name in formats_named(formats)]
    target = Path(folder)
    fresh = not target.exists()
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise InputError(f"folder: {target} cannot be made ({reason}); choose another place") from None
    load = loader(welded_assets(load) if welded else load)
    done: dict[str, Path] = {}
    try:
        for one in wanted:
            checkpoint()
            one.write(scene, target / one.file, load, textures)
            done[one.name] = target / one.file
    except BaseException:
        if fresh:
            shutil.rmtree(target, ignore_errors=True)
        raise
    return done


def export_file(
    scene: Scene,
    path: str | os.PathLike[str],
    load: Load | None = None,
    *,
    textures: bool = True,
    welded: bool = False,
) -> Path:
    """Write a scene to one file, in the format that its suffix stands for; meshes of MJCF go to ``meshes/`` beside it.

    Raises:
        InputError: as for ``export_scene``.
    """
    target = Path(path)
    one = format_of(target)
    if not target.parent.is_dir():
        raise InputError(f"out: {target.parent} is no folder; make it first")
    one.write(scene, target, loader(welded_assets(load) if welded else load), textures)
    return target
