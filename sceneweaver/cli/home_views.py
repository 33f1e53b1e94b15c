"""What the commands make of a home.json: pictures, a page, and which command a file is for."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sceneweaver.home import Home, is_home
from sceneweaver.io import InputError, parse_json, read_bytes, whole, write_atomic

from .clock import clock
from .output import list_files, print_json
from .streams import no_chatter

if TYPE_CHECKING:
    from sceneweaver.report.home import HomePage

PLAN = "plan"
"""The view that is a drawing and no picture."""


def holds_home(path: Path) -> bool:
    """Whether a file says that it is a home; what cannot be read is none."""
    if path.suffix.lower() != ".json" or not path.is_file():
        return False
    with contextlib.suppress(InputError):
        return is_home(parse_json(read_bytes(path)))
    return False


def render_home_file(
    source: Path,
    out: Path,
    view: str,
    size: tuple[int, int],
    *,
    device: str,
    as_json: bool,
    time_limit: float | None,
    began: float,
) -> int:
    """Draw a home: into an SVG or PNG file a plan or one of its pictures, into a folder all of them.

    ``view`` is one of `sceneweaver.render.home.home_views`, where that of the lowest storey needs no name: "plan",
    "overview"; for a folder "all", or one.
    """
    home = Home.load(source)
    from sceneweaver.render.home import draw_plan, home_pictures, home_view, plan_picture

    name, kind = view if view == "all" else home_view(home, view), out.suffix.lower()
    if view == "all" and kind in (".svg", ".png"):
        raise InputError(f"--out: {out} holds one picture; for all of them give a folder")
    if kind == ".svg" and not name.startswith(PLAN):
        raise InputError(f"--view: '{view}' is no drawing; write a plan as SVG, and pictures as PNG")
    storey = name.removeprefix(f"{PLAN}_") if name.startswith(PLAN) else None
    written: list[Path] = []

    def save(picture: Any, target: Path) -> None:
        with whole(target) as path:
            picture.save(path, "PNG", dpi=picture.info.get("dpi", (96, 96)))
        written.append(target)

    def draw() -> None:
        for drawn, picture in home_pictures(home, None, None if view == "all" else [name], *size, device=where):
            save(picture, out if kind == ".png" else out / f"{drawn}.png")

    with clock(time_limit, began) as until:
        if kind == ".svg":
            until.needed("render", lambda: write_atomic(out, draw_plan(home, storey)))
            written.append(out)
        elif kind == ".png" and storey is not None:
            until.needed("render", lambda: save(plan_picture(home, storey, width=size[0]), out))
        else:
            with no_chatter():  # Warp greets when it starts
                from sceneweaver.layout.devices import pick_devices

                where = pick_devices(device)[0]
            if kind == ".png":
                until.needed("render", draw)
            else:
                out.mkdir(parents=True, exist_ok=True)
                if not until.extra("the other pictures", draw) and not written:
                    until.over("render")
    code = until.code(0)
    if as_json:
        print_json({"files": [str(p) for p in written], "left_out": list(until.left_out), "exit_code": code})
    else:
        until.tell()
        list_files(written)
    return code


def home_page(home: Home, folder: Path | None = None) -> HomePage:
    """The page of a home, with the pictures and the verdict that lie in its folder, if any."""
    from sceneweaver.render.home import report_parts
    from sceneweaver.report.home import HomePage

    parts = report_parts(home)
    metrics = _metrics(home, folder)
    return HomePage(home, metrics, pictures=_pictures(folder, parts["captions"]), **parts)


def _pictures(folder: Path | None, names: Any) -> dict[str, Any]:
    """The pictures of a home that its folder has under ``views``."""
    from sceneweaver.io import open_image

    found = {}
    for name in names if folder is not None else ():
        path = folder / "views" / f"{name}.png" if folder is not None else Path()
        if path.is_file():
            with contextlib.suppress(InputError), open_image(path) as picture:
                found[name] = picture.copy()
    return found


def _metrics(home: Home, folder: Path | None) -> dict[str, Any]:
    """The metrics.json of a home's folder; without one, its rooms are judged."""
    from sceneweaver.verify import check

    path = folder / "metrics.json" if folder is not None else None
    if path is not None and path.is_file():
        with contextlib.suppress(InputError):
            data = parse_json(read_bytes(path))
            if isinstance(data, dict):
                return data
    rooms = {room.id: check(room.scene).to_dict() for room in home.rooms if room.scene is not None}
    return {"valid": all(report["valid"] for report in rooms.values()), "rooms": rooms} if rooms else {}
