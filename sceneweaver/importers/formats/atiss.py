"""ATISS: 3D-FRONT rooms as its preprocessing writes them, ``<room>/boxes.npz`` with ``dataset_stats.txt`` above.

`sceneweaver.importers.box_sets` says how boxes are meant. The floor plan's vertices are those of the house and are NOT
moved, whereas translations are relative to ``floor_plan_centroid``, the centre of the floor plan's box.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sceneweaver.io import InputError
from sceneweaver.io.messages import path_name

from ..box_files import Statistics, is_archive, load_arrays, members
from ..box_sets import boxes_of, things
from ..floor_plans import FILE, FloorPlan
from ..model import ReadOptions, SourceFormat, SourceRoom
from ..values import word


def matches(path: Path, head: bytes) -> bool:
    """A boxes.npz, or a folder of folders with one each."""
    if path.is_dir():
        return next(_files(path), None) is not None
    return is_archive(path, head) and {"floor_plan_vertices", "translations", "class_labels"} <= members(path)


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """Its room; of a folder, room after room by name."""
    statistics = Statistics.near(path, options)
    some = False
    for file in _files(path) if path.is_dir() else [path]:
        some = True
        yield _room(file, statistics)
    if not some:
        raise InputError(f"{path_name(path)}: no folder in it has a {FILE}; give the folder of the rooms")


def _files(folder: Path) -> Iterator[Path]:
    yield from sorted(file for file in folder.glob(f"*/{FILE}") if file.is_file())


def _room(file: Path, statistics: Statistics) -> SourceRoom:
    name = path_name(file)
    data = load_arrays(file)
    boxes = boxes_of(data, statistics, name)
    plan = FloorPlan.of(data, name)
    room = file.parent.name
    return SourceRoom(
        name=room,
        type=_text(data.get("scene_type")) or _type_in(room),
        outline=plan.outline,
        objects=things(boxes, plan.centre, _texts(data.get("jids"))),
        notes=(*boxes.notes, *plan.notes),
    )


def _text(value: Any) -> str:
    """A text that an array of no axes holds."""
    return word(value.item()) if getattr(value, "shape", None) == () else word(value)


def _texts(value: Any) -> list[str]:
    return [word(v) for v in value.tolist()] if getattr(value, "ndim", 0) == 1 else []


def _type_in(room: str) -> str:
    """ "masterbedroom" of a folder such as ``<house>_MasterBedroom-1234``."""
    return room.rpartition("_")[2].partition("-")[0].lower() if "_" in room and "-" in room else ""


FORMAT = SourceFormat(
    name="atiss",
    title="ATISS (boxes.npz)",
    matches=matches,
    read=read,
    notes=(
        "Read: boxes.npz of ATISS' preprocessing, and of what follows it (DiffuScene, InstructScene, MiDiffusion), one "
        "or a folder of many, room after room; names of the classes from dataset_stats.txt beside or above it, or in "
        "--asset-folder.",
        "Meaning: y up; sizes are half extents; angles turn about y with the front along +z; translations are relative "
        "to floor_plan_centroid, and the floor plan's vertices are not moved: rooms lie where they are in their house.",
        "Assumed: the outline is the union of the floor plan's triangles; lamps of the classes pendant_lamp and "
        "ceiling_lamp hang from the ceiling.",
        "Lost: doors, windows and the height of the room (the file has none), room_layout (a picture of the outline), "
        "descriptions (pickles are not read).",
    ),
    licence="3D-FRONT's terms of use",
    priority=1,
)
