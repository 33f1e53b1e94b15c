"""``sceneweaver render``."""

from __future__ import annotations

from pathlib import Path

from sceneweaver.io import whole
from sceneweaver.scene import InputError, Scene

from .output import list_files, no_chatter, print_json

PLAN = "plan"
"""The view that is a drawing and no picture."""


def run_render(
    source: Path, out: Path, view: str, size: tuple[int, int], *, plain: bool, device: str, as_json: bool
) -> int:
    """Draw a scene file: as a plan, or a picture of its room."""
    require_png(out, "--out")
    scene = Scene.load(source)
    from sceneweaver.render import draw_room, save_top

    if view == PLAN:
        save_top(scene, out, width=size[0], annotated=not plain)
    else:
        picture = draw_room(scene, None, view, *size, device=_one_device(device))
        with whole(out) as path:
            picture.save(path, "PNG")
    if as_json:
        print_json({"files": {"picture": str(out)}, "exit_code": 0})
    else:
        list_files([out])
    return 0


def run_passes(
    source: Path,
    out: Path,
    passes: str,
    cameras: str,
    kind: str,
    size: tuple[int, int],
    *,
    device: str,
    as_json: bool,
) -> int:
    """Write data passes of a scene file into a folder."""
    scene = Scene.load(source)
    from sceneweaver.render.pass_files import check_request, read_shots, write_passes
    from sceneweaver.render.passes import PassRenderer, auto_shots

    names = [name.strip() for name in passes.split(",") if name.strip()]
    check_request(names, kind)
    shots = auto_shots(scene, *size) if cameras == "auto" else read_shots(Path(cameras), *size)
    written = write_passes(PassRenderer(scene, shots, device=_one_device(device)), out, names, kind)
    if as_json:
        print_json({"files": [str(path) for path in written], "exit_code": 0})
    else:
        list_files(written)
    return 0


def _one_device(device: str) -> str:
    """Pictures are drawn on one device."""
    with no_chatter():  # Warp greets when it starts
        from sceneweaver.layout.devices import pick_devices

        return pick_devices(device)[0]


def require_png(path: Path, option: str) -> None:
    """InputError unless a picture can be written under this name."""
    if path.suffix.lower() != ".png":
        raise InputError(f"{option}: {path} is no name for a PNG picture; end it in .png")
