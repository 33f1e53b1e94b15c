"""Infinigen's solver state: ``solve_state.json``, objects with tags and relations, poses where it has them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import load_packed_json

from ..entries import Entry
from ..frames import affine, euler_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import opening_of_box

_ROOM = "Semantics(room)"
_POSES = ("location", "position", "matrix_world")


def _matches(path: Path, head: bytes) -> bool:
    if path.suffix.lower() != ".json" or re.search(rb'"objs"\s*:', head) is None:
        return False
    return path.name == "solve_state.json" or b'"relations"' in head or b'"generator"' in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    state = dict(Entry.of(path, load_packed_json(path))["objs"].items())
    rooms = [name for name, item in state.items() if _ROOM in _tags(item)]
    things = {name: item for name, item in state.items() if name not in rooms}
    placed = {name: item for name, item in things.items() if _pose_of(item) is not None}
    if not placed:
        raise Entry.of(path, None).error(
            "no object has a pose: Infinigen keeps them in scene.blend; export it and import the USD or GLB"
        )
    lost = [f"{name}: no pose in the file; left out" for name in things if name not in placed]
    cut = {name: _cut_from(item, rooms) for name, item in placed.items()}
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
            tuple(_object(name, placed[name], placed, rooms) for name in mine),
            notes=tuple((lost if not rooms or room == rooms[0] else []) + notes),
        )


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


def _opening(name: str, item: Entry, rooms: list[str], room: str) -> SourceOpening | None:
    """A door or window by the box of its model; None where that is not known."""
    place, rotation, size = _placed(item)
    others = [other for other in rooms if other != room]
    window = name.startswith("window")
    return opening_of_box(name, window, place, rotation, size, others[0] if others else None) if size else None


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


def _placed(item: Entry) -> tuple[np.ndarray, np.ndarray, tuple[float, float, float] | None]:
    """Position [3] [m], rotation [3, 3] and sides [m] of an object that has a pose."""
    pose = _pose_of(item)
    assert pose is not None
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
    return place, rotation, sides.sides(sides.numbers(3)) if sides is not None else None


def _object(name: str, item: Entry, placed: dict[str, Entry], rooms: list[str]) -> SourceObject:
    place, rotation, size = _placed(item)
    support, mount = _held(item, placed, rooms)
    return SourceObject(
        name,
        _label(name, item),
        (float(place[0]), float(place[1]), float(place[2])),
        rotation,
        size,
        anchor="bottom",
        asset=item.word("generator") or None,
        support=support,
        mount=mount,
        keep={"tags": sorted(_tags(item)), "relations": item.get("relations") or []},
    )


def _held(item: Entry, placed: dict[str, Entry], rooms: list[str]) -> tuple[str | None, Mount | None]:
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
        "Infinigen itself writes no poses there: import the USD or GLB of its export; a file without is refused.",
        "What is cut from walls of rooms is a door or, by its name, a window; its location is the middle of its width.",
        "Assumed: origins at the middle of the bottom, the front +x. Objects go to the room they are related to.",
    ),
    licence="BSD-3-Clause",
)
