"""LayoutGPT: rooms as a language model wrote them, in pixels or metres, one list of boxes a request.

A JSON list of ``{query_id, iter, prompt, object_list: [[category, {length, width, height, left, top, depth,
orientation}]]}`` (``run_layoutgpt_3d.py``, ``parse_llm_output.py``). All lengths are full sizes in the object's own
frame: ``length`` from side to side, ``width`` from back to front. ``left``, ``top`` and ``depth`` are the centre of the
box along x, z and y of a right-handed y up frame whose floor begins at (0, 0); ``orientation`` is degrees about y, and
the front looks along +z at 0. (x, y, z) becomes (x, -z, y), so the room lies below our x axis.

The floor is the rectangle of the prompt ("Room Size: max length 270px, max width 252px"). A pixel is a share of a room
whose true size stands only in the data set: with a folder of ATISS rooms (``<query_id>/boxes.npz``) it comes from
there. Without it a pixel is as long as makes the file's furniture of usual size, one length for the file. No ceiling is
given: it is where the highest lamp hangs from it. There are neither doors nor windows.
"""

from __future__ import annotations

import math
import re
import statistics
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sceneweaver.io import InputError, load_json, named_inside, read_arrays
from sceneweaver.io.messages import path_name, quote, show

from ..categories import category_of
from ..frames import Y_UP, points, yaw_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..sizes import usual_size

FIELDS = ("length", "width", "height", "left", "top", "depth", "orientation")
PIXEL = 0.013
"""Length [m] of a pixel where neither the data set nor a known piece of furniture tells."""

SURE = 0.6
"""Least confidence of a category whose usual size counts."""

LARGE = 20.0
"""Lengths above it are pixels, where the prompt does not say."""

HANGING = frozenset(("pendant_lamp", "ceiling_lamp", "chandelier"))
CEILING = (2.2, 4.0)
"""Heights [m] between which the top of the highest lamp is taken for the ceiling."""

CLOSE = 0.1
"""Height [m] of a bottom that is taken to stand on the floor."""

ROOM_SIZE = re.compile(r"max length\s*([\d.]+)\s*(px|m|)\b[^\d]*max width\s*([\d.]+)\s*(px|m|)\b")
ROOM_TYPE = re.compile(r"Room Type:\s*([^\n]+)")


def matches(path: Path, head: bytes) -> bool:
    """Whether a file begins like a list of answers."""
    return head.lstrip()[:1] in (b"[", b"{") and b'"object_list"' in head and b'"prompt"' in head


def read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    """The rooms of a file, in its order; equal names get the number of the iteration or of the entry.

    Raises:
        InputError: an entry is not as described above; the line names it.
    """
    data = load_json(path, wanted="a list of rooms as LayoutGPT writes them")
    entries = [data] if isinstance(data, Mapping) else data
    if not isinstance(entries, list) or not entries:
        raise InputError(f"{path_name(path)}: no list of rooms, or an empty one; give LayoutGPT's output")
    rooms = [_Room(path, k, entry) for k, entry in enumerate(entries)]
    pixel = _pixel(rooms)
    seen: Counter[str] = Counter()
    for room in rooms:
        seen[room.name] += 1
        name = room.name if seen[room.name] == 1 else f"{room.name}-{seen[room.name]}"
        if options.room is None or options.room == name:
            yield room.made(name, pixel, options.folder)


class _Room:
    """One checked entry of a file."""

    def __init__(self, path: Path, number: int, entry: Any) -> None:
        self.where = f"{path_name(path)}: [{number}]"
        if not isinstance(entry, Mapping):
            raise InputError(f"{self.where}: {show(entry)} is no object; give query_id, prompt and object_list")
        for key in ("object_list", "prompt"):
            if key not in entry:
                raise InputError(f"{self.where}: no {key}; give it as LayoutGPT writes it")
        self.prompt, self.name = entry["prompt"], entry.get("query_id", f"{number}")
        if not isinstance(self.prompt, str) or not isinstance(self.name, str):
            raise InputError(f"{self.where}: query_id and prompt must be texts")
        if not isinstance(entry["object_list"], list):
            raise InputError(f"{self.where}: object_list: {show(entry['object_list'])} is no list")
        self.boxes = [self._box(k, pair) for k, pair in enumerate(entry["object_list"])]
        found = ROOM_SIZE.search(self.prompt)
        self.floor = None if found is None else (float(found[1]), float(found[3]))
        if self.floor is not None and not min(self.floor) > 0:
            raise InputError(f"{self.where}: prompt: the room is {found and found[0]}; lengths must be above 0")
        largest = max([*(self.floor or ()), *(box[key] for _, box in self.boxes for key in ("left", "top"))], default=0)
        self.metric = found[2] == "m" if found is not None and found[2] else largest <= LARGE

    def _box(self, number: int, pair: Any) -> tuple[str, dict[str, float]]:
        where = f"{self.where}: object_list[{number}]"
        if not isinstance(pair, Sequence) or len(pair) != 2 or not isinstance(pair[0], str):
            raise InputError(f"{where}: {show(pair)} is no pair of a category and its numbers")
        label, numbers = pair
        if not isinstance(numbers, Mapping):
            raise InputError(f"{where} ({quote(label)}): {show(numbers)} is no object with {', '.join(FIELDS)}")
        box = {}
        for key in FIELDS:
            value = numbers.get(key)
            if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
                said = "is missing" if key not in numbers else f"is {show(value)}"
                raise InputError(f"{where} ({quote(label)}): {key} {said}; give a finite number")
            box[key] = float(value)
        return label, box

    def made(self, name: str, pixel: float, folder: Path | None) -> SourceRoom:
        """The room with lengths in metres."""
        notes = ["LayoutGPT names no doors and windows: there are none"]
        unit = 1.0 if self.metric else self._unit(pixel, folder, notes)
        objects, flat = [], []
        for label, box in self.boxes:
            if min(box[key] for key in ("length", "width", "height")) <= 0:
                flat.append(label)
                continue
            objects.append(_object(label, box, unit, len(objects)))
        if flat:
            notes.append(f"{len(flat)} without a size above 0 left out: {', '.join(flat)}")
        outline = None
        if self.floor is None:
            notes.append("the prompt names no room size: the room is drawn around its objects")
        else:
            x, y = (unit * value for value in self.floor)
            outline = ((0.0, -y), (x, -y), (x, 0.0), (0.0, 0.0))
        kind = ROOM_TYPE.search(self.prompt)
        height = self._height(unit)
        notes.append("no ceiling is named: " + (f"{height:.2f} m, by the lamps" if height else "the usual height"))
        return SourceRoom(
            name=name,
            type=kind[1].strip() if kind else "",
            outline=outline,
            height=height,
            objects=tuple(objects),
            text=self.prompt,
            notes=tuple(notes),
        )

    def _unit(self, pixel: float, folder: Path | None, notes: list[str]) -> float:
        """Metres of a pixel: by the data set's floor where the user has it."""
        known = None if folder is None or self.floor is None else _shorter_side(folder, self.name)
        if known is not None and self.floor is not None:
            notes.append(f"a pixel is {known / min(self.floor):.5f} m by boxes.npz")
            return known / min(self.floor)
        notes.append(f"a pixel is taken for {pixel:.5f} m, which makes the furniture of the file of usual size")
        return pixel

    def _height(self, unit: float) -> float | None:
        """Where the highest lamp hangs from, and no lower than anything is tall [m]; None: no lamp says."""
        tops = {label: unit * (box["depth"] + box["height"] / 2) for label, box in self.boxes if label in HANGING}
        highest = max(tops.values(), default=0.0)
        if not CEILING[0] <= highest <= CEILING[1]:
            return None
        return unit * max(max(box["depth"] + box["height"] / 2, box["height"]) for _, box in self.boxes)


def _object(label: str, box: Mapping[str, float], unit: float, number: int) -> SourceObject:
    x, y, z = points(Y_UP, unit * np.array([[box["left"], box["depth"], box["top"]]]))[0]
    stands = unit * (box["depth"] - box["height"] / 2) <= CLOSE
    return SourceObject(
        name=f"{label}-{number}",
        label=label.replace("_", " "),
        position=(float(x), float(y), float(z)),
        rotation=yaw_matrix(math.radians(box["orientation"]) - math.pi / 2),
        size=(unit * box["width"], unit * box["length"], unit * box["height"]),
        mount="ceiling" if label in HANGING else "floor" if stands else None,
    )


def _pixel(rooms: Sequence[_Room]) -> float:
    """Metres of a pixel by which the furniture of a file has its usual size: the median over widths and depths."""
    ratios = []
    for room in rooms:
        for label, box in room.boxes:
            named = category_of(label.replace("_", " "))
            if room.metric or named.confidence < SURE or min(box["width"], box["length"]) <= 0:
                continue
            depth, width, _ = usual_size(named.body)
            ratios += [depth / box["width"], width / box["length"]]
    return statistics.median(ratios) if ratios else PIXEL


def _shorter_side(folder: Path, name: str) -> float | None:
    """The shorter side [m] of the floor of a room of ATISS's data set; None where the folder has no such room."""
    file = named_inside(folder, folder / name / "boxes.npz")
    if Path(name).name != name or name in ("", ".", "..") or file is None or not file.is_file():
        return None
    try:
        vertices = np.asarray(read_arrays(file)["floor_plan_vertices"], dtype=float)
    except (KeyError, ValueError, OSError) as error:
        raise InputError(
            f"{name}/boxes.npz: no floor_plan_vertices that can be read ({type(error).__name__})"
        ) from None
    if vertices.ndim != 2 or vertices.shape[1] != 3 or not np.isfinite(vertices).all() or not len(vertices):
        raise InputError(f"{name}/boxes.npz: floor_plan_vertices must be finite numbers [n, 3]")
    side = float(np.ptp(vertices[:, [0, 2]], axis=0).min())
    if not side > 0:
        raise InputError(f"{name}/boxes.npz: floor_plan_vertices: the floor has no area")
    return side


FORMAT = SourceFormat(
    name="layoutgpt",
    title="LayoutGPT",
    matches=matches,
    read=read,
    notes=(
        "left, top, depth: centre of the box; length, width: full sizes in the object's own frame",
        "a pixel's length comes from ATISS's boxes.npz where the folder has it, else from the usual sizes of furniture",
        "no doors, windows or ceiling in the file",
    ),
    licence="MIT",
)
