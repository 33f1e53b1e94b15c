"""All formats by name: what a scene becomes in a folder, and which suffix stands for which format.

A format is one row of ``FORMATS`` and a module that writes it, which is loaded when it is first used.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.runtime.deadline import checkpoint

if TYPE_CHECKING:
    from sceneweaver.assets.placed import Load
    from sceneweaver.home import Home
    from sceneweaver.scene import InputError, Scene


@dataclass(frozen=True)
class Format:
    """A format.

    Attributes:
        name: What it is called, with ``:<client>`` where it is for one reader.
        file: The file that it makes in a folder.
        what: In a few words.
        writer: Who writes it, as ``module:function`` of this package: called with scene, path, a function from asset id
            to asset, ``textures``, and ``client`` where there are some.
        clients: Readers that it can be written for.
        seconds: About how long it takes to write a room, and each of its objects, where a design takes 3.5 s to start.
        shared: As ``writer``, for data sets: called with scene, load and ``shared``, where meshes and images go, it
            returns the bytes of the file; empty: data sets do not have it.
        home: As ``writer``, called with a home; empty: homes are not written in it.
        home_shared: As ``shared``, called with a home; empty: data sets of homes do not have it.
    """

    name: str
    file: str
    what: str
    writer: str
    seconds: tuple[float, float]
    clients: tuple[str, ...] = ()
    shared: str = ""
    home: str = ""
    home_shared: str = ""

    def write(self, scene: Scene | Home, path: Path, load: Load, textures: bool) -> None:
        """Write a scene to a path, whole or not at all; the format of `for_homes` writes a home."""
        client = {"client": self.name.partition(":")[2] or None} if self.clients else {}
        _function(self.writer)(scene, path, load, textures=textures, **client)

    def for_homes(self) -> Format:
        """The same format for homes, whose file is ``home`` where that of a scene is ``scene``.

        Raises:
            InputError: where it has none.
        """
        if not self.home:
            known = ", ".join(name for name, one in FORMATS.items() if one.home)
            raise _wrong(f"export: '{self.name}' is for single rooms; homes are written as {known}")
        file = "home" + self.file.removeprefix("scene")
        return replace(self, file=file, writer=self.home, shared=self.home_shared)

    def shared_bytes(self, scene: Scene | Home, load: Load, shared: Any) -> bytes:
        """The file of a scene whose meshes and images are ``SharedFiles``; of a home in the format of `for_homes`."""
        return _function(self.shared)(scene, load, shared=shared)


def _function(place: str) -> Callable[..., Any]:
    module, _, name = place.partition(":")
    return getattr(import_module(f".{module}", __package__), name)


FORMATS: dict[str, Format] = {
    f.name: f
    for f in (
        Format(
            "glb",
            "scene.glb",
            "glTF 2.0 binary",
            "glb:write_glb",
            (0.3, 0.005),
            shared="glb:glb_bytes",
            home="home.glb:write_home_glb",
            home_shared="home.glb:home_glb_bytes",
        ),
        Format(
            "usd",
            "scene.usdc",
            "USD with physics, binary",
            "usd:write_usd",
            (0.4, 0.026),
            shared="usd:usd_bytes",
            home="home.usd:write_home_usd",
            home_shared="home.usd:home_usd_bytes",
        ),
        Format(
            "usda",
            "scene.usda",
            "USD with physics, as text",
            "usd:write_usd",
            (0.4, 0.026),
            home="home.usd:write_home_usd",
        ),
        Format(
            "mjcf",
            "scene.xml",
            "MuJoCo, with meshes/",
            "mjcf:write_file",
            (0.4, 0.004),
            ("mujoco", "robosuite", "genesis", "drake", "dm_control", "newton"),
            "mjcf:mjcf_bytes",
            "home.mjcf:write_file",
            "home.mjcf:home_mjcf_bytes",
        ),
        Format("scenestate", "scenestate.json", "SceneState, with models/", "scenestate:write_file", (0.1, 0.004)),
        Format(
            "sdf",
            "scene.sdf",
            "one SDF world, with sdf/",
            "sdf:write_file",
            (0.1, 0.005),
            ("pybullet",),
            home="home.robots:write_sdf",
        ),
        Format(
            "urdf",
            "scene.urdf.json",
            "a URDF a piece, with urdf/",
            "urdf:write_file",
            (0.2, 0.003),
            home="home.robots:write_urdf",
        ),
    )
}

USUAL = ("glb", "usd", "mjcf")
"""What is written when nobody says what."""


def format_named(name: str) -> Format:
    """The format of a name; ``mjcf:<client>`` and ``sdf:<client>`` are those for one reader.

    Raises:
        InputError: for a name that is no format.
    """
    base, _, client = name.partition(":")
    found = FORMATS.get(base)
    if found is None or (":" in name and not found.clients):
        raise _wrong(f"export: '{name}' is no format; use {', '.join(FORMATS)}, all or none")
    if ":" in name and client not in found.clients:
        raise _wrong(f"export: '{name}' is no format; clients of {base} are {', '.join(found.clients)}")
    return replace(found, name=name)


def formats_named(names: str | Iterable[str], *, homes: bool = False) -> tuple[str, ...]:
    """Names of formats from a list or from text with commas; "all", of ``homes`` those they have, and "none" are
    understood.

    Raises:
        InputError: for a name that is no format, or two of one file.
    """
    listed = names.split(",") if isinstance(names, str) else list(names)
    found: list[str] = []
    for name in (text.strip().lower() for text in listed):
        if name == "all":
            found += [n for n, one in FORMATS.items() if n != "usda" and (one.home or not homes)]
        elif name not in ("none", ""):
            found.append(format_named(name).name)
    files: dict[str, str] = {}
    for name in found:
        other = files.setdefault(format_named(name).file, name)
        if other != name:
            raise _wrong(f"export: '{other}' and '{name}' are one file, {format_named(name).file}; choose one")
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
    raise _wrong(f"out: '{path.name}' stands for no format; end it with {known}, or give a folder and --to")


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
    return _export(scene, Path(folder), wanted, _assets(load, welded), textures)


def export_home(
    home: Home,
    folder: str | os.PathLike[str],
    formats: str | Sequence[str] = USUAL,
    load: Load | None = None,
    *,
    textures: bool = True,
    welded: bool = False,
) -> dict[str, Path]:
    """Write a whole home as one scene of other tools into a folder, which is made where it is not there.

    Rooms are groups or prefixes of names, ``<room>:<object>``; walls, floors, stairs, windows and the leaves of doors,
    which open, are there once.

    Args:
        home: The home; rooms without a scene are empty.
        folder: Where the files go: ``home.glb``, ``home.usdc``, ``home.xml`` with its sleeping twin, ``home.sdf``,
            ``home.urdf.json``.
        formats: As for `export_scene`, a list or text with commas: glb, usd, usda, mjcf, sdf, urdf, or "all".
        load, textures, welded: As for `export_scene`.

    Returns:
        The path of each format's file.

    Raises:
        InputError: as `export_scene`, and for a format that homes are not written in.

    Examples:
        >>> import sceneweaver as sw
        >>> files = sw.export_home(sw.Home.example("flat"), "flat", ["mjcf"])
        >>> files["mjcf"].as_posix()
        'flat/home.xml'
    """
    wanted = [format_named(name).for_homes() for name in formats_named(formats, homes=True)]
    return _export(home, Path(folder), wanted, _assets(load, welded), textures)


def _export(scene: Scene | Home, target: Path, wanted: Sequence[Format], load: Load, textures: bool) -> dict[str, Path]:
    fresh = not target.exists()
    done: dict[str, Path] = {}
    try:  # time may be up anywhere from here on
        checkpoint()
        try:
            target.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            reason = error.strerror or type(error).__name__
            raise _wrong(f"folder: {target} cannot be made ({reason}); choose another place") from None
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
    scene: Scene | Home,
    path: str | os.PathLike[str],
    load: Load | None = None,
    *,
    textures: bool = True,
    welded: bool = False,
) -> Path:
    """Write a scene or a home to one file, in the format that its suffix stands for; meshes of MJCF go to ``meshes/``
    beside it.

    Raises:
        InputError: as for ``export_scene``.
    """
    target = Path(path)
    one = format_of(target)
    if not target.parent.is_dir():
        raise _wrong(f"out: {target.parent} is no folder; make it first")
    from sceneweaver.home import Home

    if isinstance(scene, Home):
        one = one.for_homes()
    one.write(scene, target, _assets(load, welded), textures)
    return target


def _wrong(text: str) -> InputError:
    """The error of a wrong input, loaded when needed: the command line lists formats before anything else is there."""
    from sceneweaver.scene import InputError

    return InputError(text)


def _assets(load: Load | None, welded: bool) -> Load:
    """Loads each asset once, with what could be taken off it welded to it or not."""
    from sceneweaver.assets.placed import loader, welded_assets

    return loader(welded_assets(load) if welded else load)
