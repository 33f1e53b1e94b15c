"""``sceneweaver render``."""

from __future__ import annotations

from pathlib import Path

from sceneweaver.io import whole
from sceneweaver.scene import InputError, Scene

from .clock import clock
from .output import list_files, print_json
from .streams import no_chatter

PLAN = "plan"
"""The view that is a drawing and no picture."""


def run_render(
    source: Path,
    out: Path,
    view: str,
    size: tuple[int, int],
    *,
    plain: bool,
    device: str,
    as_json: bool,
    time_limit: float | None,
    began: float,
) -> int:
    """Draw a scene file: as a plan, or a picture of its room."""
    require_png(out, "--out")
    scene = Scene.load(source)
    from sceneweaver.render import draw_room, save_top

    with clock(time_limit, began) as until:
        if view == PLAN:
            until.needed("render", lambda: save_top(scene, out, width=size[0], annotated=not plain))
        else:
            where = _one_device(device)
            picture = until.needed("render", lambda: draw_room(scene, None, view, *size, device=where))
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
    time_limit: float | None,
    began: float,
) -> int:
    """Write data passes of a scene file into a folder; of those that there is time for."""
    scene = Scene.load(source)
    from sceneweaver.render.pass_files import check_request, read_shots, write_passes
    from sceneweaver.render.passes import PassRenderer, auto_shots

    names = [name.strip() for name in passes.split(",") if name.strip()]
    check_request(names, kind)
    where, written = _one_device(device), list[Path]()
    with clock(time_limit, began) as until:

        def draw() -> None:
            shots = auto_shots(scene, *size) if cameras == "auto" else read_shots(Path(cameras), *size)
            write_passes(PassRenderer(scene, shots, device=where), out, names, kind, written)

        if not until.extra("the other passes", draw) and not written:
            until.over("render")
    code = until.code(0)
    if as_json:
        print_json({"files": [str(path) for path in written], "left_out": list(until.left_out), "exit_code": code})
    else:
        until.tell()
        list_files(written)
    return code


def _one_device(device: str) -> str:
    """Pictures are drawn on one device."""
    with no_chatter():  # Warp greets when it starts
        from sceneweaver.layout.devices import pick_devices

        return pick_devices(device)[0]


def require_png(path: Path, option: str) -> None:
    """InputError unless a picture can be written under this name."""
    if path.suffix.lower() != ".png":
        raise InputError(f"{option}: {path} is no name for a PNG picture; end it in .png")
