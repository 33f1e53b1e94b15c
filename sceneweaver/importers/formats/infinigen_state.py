"""Infinigen's solver state: ``solve_state.json``, with poses of its own or of the USD export beside it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sceneweaver.io import load_packed_json

from ..frames import affine, euler_matrix
from ..model import Anchor, Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import opening_of_box
from ..values import Entry
from . import formats

_ROOM = "Semantics(room)"
_POSES = ("location", "position", "matrix_world")
_STAGES = (".usdc", ".usda", ".usd", ".usdz")
_MOST = 1000
"""Entries of a folder that are looked at for an export."""


def _matches(path: Path, head: bytes) -> bool:
    if path.suffix.lower() != ".json" or re.search(rb'"objs"\s*:', head) is None:
        return False
    return path.name == "solve_state.json" or b'"relations"' in head or b'"generator"' in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    state = dict(Entry.of(path, load_packed_json(path))["objs"].items())
    rooms = [name for name, item in state.items() if _ROOM in _tags(item)]
    things = {name: item for name, item in state.items() if name not in rooms}
    placed, told = _places(path, things, options.folder)
    lost = [*told, *(f"{name}: it has no pose; left out" for name in things if name not in placed)]
    cut = {name: _cut_from(things[name], rooms) for name in placed}
    homes = {name: _home(name, state, rooms) for name in placed}
    for room in rooms or [path.stem]:
        mine = [name for name in placed if homes[name] == room or room in cut[name] or not rooms]
        openings = [_opening(name, placed[name], cut[name], room) for name in mine if cut[name]]
        openings = [opening for opening in openings if opening is not None]
        mine = [name for name in mine if not cut[name]]
        stray = [name for name in placed if homes[name] is None and rooms and room == rooms[0]]
        notes = [f"{name}: related to no room; left out" for name in stray]
        yield SourceRoom(
            room,
            re.sub(r"_\d+(?:/\d+)?$", "", room) if rooms else "",
            _outline(state[room]) if rooms else None,
            None,
            tuple(openings),
            tuple(_object(name, things[name], placed, rooms) for name in mine),
            notes=tuple((lost if not rooms or room == rooms[0] else []) + notes),
        )


class _Place(NamedTuple):
    """Where an object is: position [m] of its anchor, rotation [3, 3], sides [m]."""

    position: tuple[float, float, float]
    rotation: np.ndarray
    size: tuple[float, float, float] | None
    anchor: Anchor


def _places(path: Path, things: dict[str, Entry], folder: Path | None) -> tuple[dict[str, _Place], list[str]]:
    """Where the objects are, and what is to be told: as the state has it, else as the USD export beside it has.

    Raises:
        InputError: neither has a pose.
    """
    placed = {name: place for name, item in things.items() if (place := _placed(item)) is not None}
    if placed:
        return placed, []
    stage = _stage(path, folder)
    if stage is None:
        raise Entry.of(path, None).error(
            "no object has a pose (Infinigen keeps them in scene.blend): put its USD export beside it, or import that"
        )
    shown = {
        _plain(thing.name): _Place(thing.position, thing.rotation, thing.size, thing.anchor)
        for room in formats()["usd"].read(stage, ReadOptions())
        for thing in room.objects
    }
    for name, item in things.items():
        place = shown.get(_plain(item.word("obj", name))) or shown.get(_plain(name))
        if place is not None:
            placed[name] = place
    if not placed:
        raise Entry.of(path, None).error(f"no object of it is in {stage.name}; give the export of the same scene")
    return placed, [f"poses and sizes are those of {stage.name}"]


def _stage(path: Path, folder: Path | None) -> Path | None:
    """The USD export of a scene: beside its state, a folder below, or in the asset folder."""
    if "usd" not in formats():
        return None
    places = [path.parent, *sorted(p for p in islice(path.parent.iterdir(), _MOST) if p.is_dir())]
    for place in places + ([folder] if folder is not None else []):
        found = sorted(p for p in islice(place.iterdir(), _MOST) if p.suffix.lower() in _STAGES)
        if found:
            return found[0]
    return None


def _plain(name: str) -> str:
    """A name as exports keep it: SofaFactory(12).spawn_asset(3) is SofaFactory_12__spawn_asset_3_ in USD."""
    return re.sub(r"[^0-9a-z]+", "_", name.lower()).strip("_")


def _tags(item: Entry) -> set[str]:
    return set(item.words("tags"))


def _relations(item: Entry) -> Iterator[tuple[str, set[str], set[str]]]:
    """Target, parts of this object and parts of the target, of each relation."""
    for entry in item.listed("relations"):
        if not entry.has("target_name"):
            continue
        relation = entry.find("relation")
        tags = [set(relation.words(key)) if relation else set[str]() for key in ("child_tags", "parent_tags")]
        yield entry["target_name"].text(), tags[0], tags[1]


def _cut_from(item: Entry, rooms: list[str]) -> list[str]:
    """The rooms whose walls an object is cut from, as doors and windows are."""
    cut = [
        r for r in item.listed("relations") if r.has("relation") and r["relation"].word("relation_type") == "CutFrom"
    ]
    return [r.word("target_name") for r in cut if r.word("target_name") in rooms]


def _opening(name: str, place: _Place, rooms: list[str], room: str) -> SourceOpening | None:
    """A door or window by the box of its model; None where that is not known."""
    position, rotation, size, _ = place
    others = [other for other in rooms if other != room]
    window = name.startswith("window")
    return opening_of_box(name, window, position, rotation, size, others[0] if others else None) if size else None


def _home(name: str, state: dict[str, Entry], rooms: list[str]) -> str | None:
    """The room that an object is related to, by way of what carries it."""
    seen: set[str] = set()
    wait = [name]
    while wait:
        here = wait.pop(0)
        if here in rooms:
            return here
        if here in seen or here not in state:
            continue
        seen.add(here)
        wait += [target for target, _, _ in _relations(state[here])]
    return None


def _pose_of(item: Entry) -> Entry | None:
    """Where the pose of an object stands: with it, or under ``obj`` or ``pose``."""
    for place in (item, *(item.find(key) for key in ("pose", "obj") if isinstance(item.value, dict))):
        if place is not None and isinstance(place.value, dict) and any(place.has(key) for key in _POSES):
            return place
    return None


def _placed(item: Entry) -> _Place | None:
    """Where an object is by the state itself, which has the middle of its bottom; None where it has no pose."""
    pose = _pose_of(item)
    if pose is None:
        return None
    if pose.has("matrix_world"):
        try:
            place, rotation, _ = affine(pose["matrix_world"].matrix(4, 4))
        except ValueError as error:
            raise pose["matrix_world"].error(f"{error}; give the matrix of the object") from None
    else:
        place = np.array((pose["location"] if pose.has("location") else pose["position"]).numbers(3))
        turn = next((pose[key] for key in ("rotation_euler", "rotation") if pose.has(key)), None)
        rotation = euler_matrix([math.degrees(v) for v in turn.numbers(3)]) if turn is not None else np.eye(3)
    sides = next((p[key] for p in (pose, item) for key in ("dimensions", "size") if p.has(key)), None)
    size = sides.sides(sides.numbers(3)) if sides is not None else None
    return _Place((float(place[0]), float(place[1]), float(place[2])), rotation, size, "bottom")


def _object(name: str, item: Entry, placed: dict[str, _Place], rooms: list[str]) -> SourceObject:
    position, rotation, size, anchor = placed[name]
    support, mount = _held(item, placed, rooms)
    return SourceObject(
        name,
        _label(name, item),
        position,
        rotation,
        size,
        anchor,
        asset=item.word("generator") or None,
        support=support,
        mount=mount,
        keep={"tags": sorted(_tags(item)), "relations": item.get("relations") or []},
    )


def _held(item: Entry, placed: dict[str, _Place], rooms: list[str]) -> tuple[str | None, Mount | None]:
    mount: Mount | None = None
    for target, child, parent in _relations(item):
        if "Subpart(bottom)" in child and target in placed:
            return target, "surface"
        if target in rooms or target not in placed:
            if "Subpart(bottom)" in child:
                mount = "floor"
            elif "Subpart(ceiling)" in parent or "Subpart(top)" in child:
                mount = mount or "ceiling"
            elif "Subpart(wall)" in parent:
                mount = mount or "wall"
    return None, mount


def _label(name: str, item: Entry) -> str:
    """The category: of its generator, such as SofaFactory(1234), or of its name, such as 780816_SofaFactory."""
    words = [item.word("generator"), name, item.word("obj")]
    word = next((w for w in words if "Factory" in w), words[0] or name)
    return re.sub(r"^\d+_|(?:Factory)?(?:_\d+)?$", "", re.split(r"[(.]", word)[0]) or name


def _outline(room: Entry) -> tuple[tuple[float, float], ...] | None:
    """The outline of a room where the file has it as points."""
    for key in ("contour", "polygon", "outline"):
        if isinstance(room.get(key), list):
            return tuple((x, y) for x, y in (corner.numbers(2) for corner in room[key].entries()))
    return None


FORMAT = SourceFormat(
    "infinigen",
    "Infinigen's solver state",
    _matches,
    _read,
    notes=(
        "Read: objs with generator, tags, relations, and the pose where the file has it (location with rotation_euler "
        "[rad] and dimensions, or matrix_world). What stands on or hangs on what comes from the relations' tags.",
        "Infinigen itself writes no poses there: those and the sizes come from its USD export beside the file (or a "
        "folder below, or in the asset folder), by the objects' names; without one the file is refused.",
        "What is cut from walls of rooms is a door or, by its name, a window; its location is the middle of its width.",
        "Assumed: origins at the middle of the bottom, the front +x. Objects go to the room they are related to.",
    ),
    licence="BSD-3-Clause",
)
