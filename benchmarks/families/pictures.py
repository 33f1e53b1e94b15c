"""Pictures at eye level: seconds and memory."""

from __future__ import annotations

from typing import Any

from benchmarks import children
from benchmarks.judging import Judge
from benchmarks.results import Column, Result
from benchmarks.settings import Settings

ROOMS = ("bedroom_1002", "living_room_1001", "kitchen_1001")
VIEWS = ("eye-door", "eye-corner", "eye-corner2")
SIZE = (1280, 960)
QUALITIES = ("draft", "normal")
QUICK_SIZE = (64, 48)

COLUMNS = (
    Column("room", "room"),
    Column("quality", "quality"),
    Column("view", "view"),
    Column("seconds", "s a view", "number"),
    Column("prepared", "s to prepare", "number"),
    Column("objects", "objects", "count"),
    Column("triangles", "triangles", "count"),
    Column("peak", "peak RSS [MiB]", "mib"),
    Column("device", "device pool, peak [MiB]", "mib"),
)


def run(settings: Settings, judge: Judge) -> Result:
    """Each room and quality in a process of its own, so that the peak is that of its pictures."""
    width, height = QUICK_SIZE if settings.quick else SIZE
    about = (
        f"Views at eye level by the path tracer, {width} x {height} pixels, with warm kernels. What is prepared once "
        "for all views of a room, trees of triangles, maps and the light of its surfaces, stands beside; choosing "
        "cameras and reading assets is not in. Peaks are those of the whole process. Each view is drawn twice and must "
        "come out equal."
    )
    result = Result("pictures", "Pictures", about)
    table = result.add("pictures", "By room and view", COLUMNS, keys=3)
    rooms = ROOMS[:1] if settings.quick else ROOMS
    for room in rooms:
        for quality in QUALITIES[:1] if settings.quick else QUALITIES:
            task: dict[str, Any] = {"room": room, "quality": quality, "views": VIEWS[:1] if settings.quick else VIEWS}
            found = children.run(
                {**task, "width": width, "height": height, "device": settings.device}, module="benchmarks.pictures"
            )
            for view in found["views"]:
                table.rows.append(_row(room, quality, found, view))
                if not view["same"]:
                    result.failures.append(f"{room} {view['view']}: drawn twice, two pictures")
                if not 20 < view["mean"] < 245:
                    result.failures.append(f"{room} {view['view']}: a mean of {view['mean']:.0f} of 255 shows nothing")
    return result


def _row(room: str, quality: str, found: dict[str, Any], view: dict[str, Any]) -> dict[str, Any]:
    kept = {key: found[key] for key in ("prepared", "objects", "triangles")}
    names = {"room": room, "quality": quality, "view": view["view"], "seconds": view["seconds"]}
    return names | kept | {"peak": found["peak_mib"], "device": found["device_mib"]}
