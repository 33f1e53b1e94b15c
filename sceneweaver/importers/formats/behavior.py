"""BEHAVIOR and OmniGibson: ``<scene>_best.json``, all objects of a home, walls and floors among them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sceneweaver.io import InputError, load_packed_json

from ..frames import quaternion_matrix
from ..model import ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..omnigibson import box_offset, native_box
from ..plans import opening_of_box, room_at
from ..values import Entry

WALLS = {"walls", "ceilings", "roof", "background", "lawn", "driveway", "fence", "rail_fence"}
DOORS = {"door", "sliding_door", "garage_door", "gate"}
WINDOWS = {"window", "openable_window", "fixed_window"}


def _matches(path: Path, head: bytes) -> bool:
    if path.suffix.lower() != ".json" or b'"' not in head:
        return False
    return (
        b'"objects_info"' in head
        or b'"object_registry"' in head
        or (b'"init_info"' in head and b'"DatasetObject"' in head)
    )


@dataclass
class _Thing:
    """An object with its box in the world: middle [m], rotation, sides [m] where they are known."""

    name: str
    category: str
    model: str
    args: Entry
    rooms: list[str]
    middle: np.ndarray
    rotation: np.ndarray
    size: tuple[float, float, float] | None

    def corners(self) -> np.ndarray:
        """The eight corners of the box [8, 3] [m]."""
        assert self.size is not None
        signs = np.array(np.meshgrid((-0.5, 0.5), (-0.5, 0.5), (-0.5, 0.5))).reshape(3, -1).T
        return self.middle + (signs * self.size) @ self.rotation.T


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    scene = Entry.of(path, load_packed_json(path))
    notes: list[str] = []
    things = list(_things(scene, options.folder, notes))
    named = dict.fromkeys(room for thing in things for room in thing.rooms)
    rooms = list(named) or [re.sub(r"_best$|_task.*$", "", path.stem)]
    floors = {room: [t for t in things if t.category == "floors" and room in t.rooms and t.size] for room in rooms}
    if not named:
        floors[rooms[0]] = [t for t in things if t.category == "floors" and t.size]
    outlines = {room: _box(f) for room, f in floors.items() if f}
    homes = {thing.name: thing.rooms or _where(thing, outlines, rooms) for thing in things}
    for room in rooms:
        inside = [t for t in things if room in homes[t.name]]
        lost = [t.name for t in things if not homes[t.name]] if room == rooms[0] else []
        yield _room(room, inside, outlines.get(room), floors[room], homes, notes + _lost(lost))


def _lost(names: list[str]) -> list[str]:
    return [f"{name}: it stands in no room; left out" for name in names]


def _where(thing: _Thing, outlines: dict[str, tuple[tuple[float, float], ...]], rooms: list[str]) -> list[str]:
    """The room of a thing that names none: where it stands; the only one there is."""
    found = room_at(outlines, float(thing.middle[0]), float(thing.middle[1])) if outlines else None
    return [found] if found is not None else rooms if len(rooms) == 1 else []


def _things(scene: Entry, folder: Path | None, notes: list[str]) -> Iterator[_Thing]:
    state = scene["state"]
    registry = state["registry"]["object_registry"] if state.has("registry") else state["object_registry"]
    for name, item in scene["objects_info"]["init_info"].items():
        kind = item.word("class_name", "DatasetObject")
        if kind not in ("DatasetObject", "USDObject", "PrimitiveObject"):
            notes.append(f"{name}: a {kind}, no furniture; left out")
            continue
        if not registry.has(name):
            notes.append(f"{name}: it has no state, hence no pose; left out")
            continue
        link = registry[name]
        link = link["root_link"] if link.has("root_link") else link
        args = item["args"]
        category, model = args.word("category", "object"), args.word("model")
        try:
            rotation = quaternion_matrix(link["ori"].numbers(4))
        except ValueError as error:
            raise error if isinstance(error, InputError) else link["ori"].error(f"{error}; give x, y, z, w") from None
        size, scale = _size(args, folder, category, model)
        middle = np.array(link["pos"].numbers(3))
        offset = box_offset(folder, category, model)
        if offset is not None:
            middle = middle + rotation @ (scale * offset)
        yield _Thing(name, category, model, args, args.words("in_rooms"), middle, rotation, size)


def _size(args: Entry, folder: Path | None, category: str, model: str):
    """Sides [m] of the box in the object's frame, or None, and the scale [3] of its model."""
    native = native_box(folder, category, model)
    if args.has("bounding_box"):
        size = args["bounding_box"].sides(args["bounding_box"].numbers(3))
        scale = np.divide(size, native, out=np.ones(3), where=native > 1e-4) if native is not None else np.ones(3)
        return size, scale
    scale = np.ones(3)
    if args.has("scale"):
        given = args["scale"]
        scale = np.array(given.numbers(3)) if isinstance(given.value, list) else np.full(3, given.number())
    if native is None:
        return None, scale
    x, y, z = (float(v) for v in native * scale)
    return (x, y, z), scale


def _box(floors: list[_Thing]) -> tuple[tuple[float, float], ...]:
    """The outline of a room: the box of its floor as it lies, or the box around several."""
    if len(floors) == 1:
        corners = floors[0].corners()
        low = corners[corners[:, 2] < corners[:, 2].mean() + 1e-9][:, :2]
        middle = low.mean(axis=0)
        order = np.argsort(np.arctan2(*(low - middle).T[::-1]))
        return tuple((float(x), float(y)) for x, y in low[order])
    points = np.concatenate([f.corners()[:, :2] for f in floors])
    (x0, y0), (x1, y1) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return (x0, y0), (x1, y0), (x1, y1), (x0, y1)


def _room(
    room: str,
    things: list[_Thing],
    outline: tuple[tuple[float, float], ...] | None,
    floors: list[_Thing],
    homes: dict[str, list[str]],
    notes: list[str],
) -> SourceRoom:
    notes = list(notes)
    level = max((float(f.corners()[:, 2].max()) for f in floors), default=0.0)
    if abs(level) > 1e-3:
        notes.append(f"its floor is at z = {level:.3g} m: everything is moved by that")
    else:
        level = 0.0
    notes.append(
        "no size of its floor: the room is drawn around its objects"
        if outline is None
        else "the outline is the box of its floor, which need not be a rectangle"
    )
    tops = [float(t.corners()[:, 2].max()) - level for t in things if t.category == "walls" and t.size]
    openings, objects = [], []
    for thing in things:
        if thing.category in WALLS or thing.category == "floors":
            continue
        if thing.category in DOORS | WINDOWS:
            if thing.size is None:
                notes.append(f"{thing.name}: a {thing.category} of unknown size; left out")
            else:
                others = [r for r in homes[thing.name] if r != room]
                middle = thing.middle - (0.0, 0.0, level)
                window = thing.category in WINDOWS
                openings.append(
                    opening_of_box(
                        thing.name, window, middle, thing.rotation, thing.size, others[0] if others else None
                    )
                )
        else:
            objects.append(_object(thing, level, room))
    return SourceRoom(
        room,
        re.sub(r"_\d+$", "", room),
        outline,
        max(tops, default=0.0) or None,
        tuple(openings),
        tuple(objects),
        notes=tuple(notes),
    )


def _object(thing: _Thing, level: float, room: str) -> SourceObject:
    x, y, z = (float(v) for v in thing.middle)
    return SourceObject(
        thing.name,
        thing.category,
        (x, y, z - level),
        thing.rotation,
        thing.size,
        asset=f"{thing.category}/{thing.model}" if thing.model else None,
        fixed=thing.args.get("fixed_base") is True,
        keep={"in_rooms": thing.rooms},
    )


FORMAT = SourceFormat(
    "behavior",
    "BEHAVIOR and OmniGibson scenes",
    _matches,
    _read,
    notes=(
        "Read: objects_info.init_info (category, model, bounding_box or scale, in_rooms, fixed_base) and the poses of "
        "their root links; a room for each name in in_rooms.",
        "A box is in the object's own frame, the front +x. Poses are of base links: with the asset folder "
        "(objects/<category>/<model>/misc/metadata.json) boxes lie and measure as there; without, a base is taken as "
        "the middle of its box, and an object with a scale alone has no size.",
        "Walls, floors and ceilings are objects there: a room is the box of its floor, as high as its walls; doors and "
        "windows become openings as wide as the longer side of their box.",
        "Lost: joints, states, particles, robots.",
    ),
    licence="MIT (code); the assets have their own and are not given on",
)
