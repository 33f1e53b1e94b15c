"""``sceneweaver export``."""

from __future__ import annotations

import time
from pathlib import Path

import typer

from sceneweaver.scene import InputError, Scene

from .output import list_files, no_chatter, print_json


def run_export(source: Path, out: Path, *, to: str | None, as_json: bool, textures: bool, welded: bool) -> int:
    """Write a scene for other tools: a folder of formats, or one file whose suffix says which."""
    scene = Scene.load(source)
    began = time.monotonic()
    with no_chatter():
        from sceneweaver.export import FORMATS, export_file, export_scene, formats_named
        from sceneweaver.export.formats import USUAL, format_of

        if out.suffix and not out.is_dir():
            if to is not None:
                raise InputError(f"--to: {out} is a file, whose suffix says the format; give a folder, or no --to")
            files = {format_of(out).name: export_file(scene, out, textures=textures, welded=welded)}
        else:
            names = formats_named(to) if to is not None else USUAL
            if not names:
                raise InputError(f"--to: names no format; use {', '.join(FORMATS)} or all")
            files = export_scene(scene, out, names, textures=textures, welded=welded)
    seconds = time.monotonic() - began
    if as_json:
        print_json(
            {
                "exit_code": 0,
                "objects": len(scene.objects),
                "seconds": round(seconds, 3),
                "files": {name: str(path) for name, path in files.items()},
            }
        )
        return 0
    typer.echo(f"{scene.id}: {len(scene.objects)} objects in {seconds:.1f} s")
    list_files(list(files.values()))
    return 0
