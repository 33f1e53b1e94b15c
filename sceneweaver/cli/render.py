"""``sceneweaver render``."""

from __future__ import annotations

from pathlib import Path

from sceneweaver.scene import InputError, Scene

from .output import list_files, print_json


def run_render(source: Path, out: Path, *, plain: bool, width: int, as_json: bool) -> int:
    """Draw a scene file from above."""
    require_png(out, "--out")
    scene = Scene.load(source)
    from sceneweaver.render import save_top

    save_top(scene, out, width=width, annotated=not plain)
    if as_json:
        print_json({"files": {"picture": str(out)}, "exit_code": 0})
    else:
        list_files([out])
    return 0


def require_png(path: Path, option: str) -> None:
    """InputError unless a picture can be written under this name."""
    if path.suffix.lower() != ".png":
        raise InputError(f"{option}: {path} is no name for a PNG picture; end it in .png")
