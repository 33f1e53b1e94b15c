"""``sceneweaver export``."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import typer

from sceneweaver.home import Home, is_home
from sceneweaver.io import MAX_BYTES, parse_json, read_bytes
from sceneweaver.scene import InputError, Scene

from .clock import clock
from .output import list_files, print_json
from .streams import no_chatter


def run_export(
    source: Path,
    out: Path,
    *,
    to: str | None,
    as_json: bool,
    textures: bool,
    welded: bool,
    time_limit: float | None,
    began: float,
) -> int:
    """Write a scene or a home for other tools: a folder of formats, or one file whose suffix says which.

    The time limit [s] counts from ``began``, by ``time.monotonic()``; formats that there is no time for are left out.
    """
    if out.suffix and out.is_symlink() and out.is_dir():
        raise InputError(f"--out: {out} is a link to a folder; give a file's name, or the folder itself")
    scene = _load(source)
    start = time.monotonic()
    files: dict[str, Path] = {}
    look: Any = {"textures": textures, "welded": welded}
    with no_chatter():
        from sceneweaver.assets.placed import loader
        from sceneweaver.export import FORMATS, export_file, export_home, export_scene, formats_named
        from sceneweaver.export.formats import USUAL, format_of
    with no_chatter(), clock(time_limit, began) as until:
        if out.suffix and not out.is_dir():
            if to is not None:
                raise InputError(f"--to: {out} is a file, whose suffix says the format; give a folder, or no --to")
            files[format_of(out).name] = until.needed("export", lambda: export_file(scene, out, **look))
        else:
            home = isinstance(scene, Home)
            names = formats_named(to, homes=home) if to is not None else USUAL
            if not names:
                raise InputError(f"--to: names no format; use {', '.join(FORMATS)} or all")
            load = loader()
            write: Any = export_home if home else export_scene
            for name in names:
                until.extra(name, lambda name=name: files.update(write(scene, out, [name], load, **look)))
            if not files:
                until.over("export")
    scenes = [room.scene for room in scene.rooms] if isinstance(scene, Home) else [scene]
    objects = sum(len(one.objects) for one in scenes if one is not None)
    seconds, code = time.monotonic() - start, until.code(0)
    if as_json:
        print_json(
            {
                "exit_code": code,
                "objects": objects,
                "seconds": round(seconds, 3),
                "files": {name: str(path) for name, path in files.items()},
                "left_out": list(until.left_out),
            }
        )
        return code
    typer.echo(f"{scene.id}: {objects} objects in {seconds:.1f} s")
    until.tell()
    list_files(list(files.values()))
    return code


def _load(source: Path) -> Scene | Home:
    """The scene or home of a file: which of the two it says itself."""
    try:
        home = is_home(parse_json(read_bytes(source, max_bytes=MAX_BYTES), wanted="a scene or a home"))
    except InputError:
        home = False  # reading it as a scene says what is wrong
    return Home.load(source) if home else Scene.load(source)
