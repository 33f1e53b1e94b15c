"""I-Design: ``scene_graph.json``, a list of things with centres, sizes and clockwise angles in a rectangle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from sceneweaver.io import load_json

from ..frames import yaw_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..plans import rectangle
from ..values import Entry

FACING = {"north_wall": 0.0, "east_wall": 90.0, "south_wall": 180.0, "west_wall": 270.0}
PRIORS = {*FACING, "ceiling", "middle of the room"}
"""Entries that stand for the room itself."""


def _matches(path: Path, head: bytes) -> bool:
    return path.suffix.lower() == ".json" and b'"new_object_id"' in head


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    data = Entry.of(path, load_json(path))
    items = list((data["objects_in_room"] if isinstance(data.value, dict) else data).entries())
    things = {item["new_object_id"].text(): item for item in items}
    notes: list[str] = []
    outline, height = _shell(things)
    if outline is None:
        notes.append("no entry of the ceiling, floor or walls: the room is drawn around its objects")
    objects = []
    for name, item in things.items():
        if name in PRIORS:
            continue
        if not item.has("position"):
            notes.append(f"{name}: never placed by I-Design (it has no position); left out")
            continue
        objects.append(_object(name, item, things, notes))
    yield SourceRoom(path.stem, outline=outline, height=height, objects=tuple(objects), notes=tuple(notes))


def _shell(things: dict[str, Entry]) -> tuple[tuple[tuple[float, float], ...] | None, float | None]:
    """Outline and height [m] of the room: its least corner is the origin."""
    ceiling = things.get("ceiling")
    height = ceiling["position"]["z"].length() if ceiling is not None and ceiling.has("position") else None
    for name in ("ceiling", "middle of the room"):
        if name in things and things[name].has("size_in_meters"):
            size = things[name]["size_in_meters"]
            x, y, _ = size.sides([*size.named(("length", "width"), 0.0), 1.0])
            return rectangle(x, y), height
    east, north = things.get("east_wall"), things.get("north_wall")
    if east is not None and north is not None and east.has("position") and north.has("position"):
        x, y, _ = east.sides((east["position"]["x"].length(), north["position"]["y"].length(), 1.0))
        return rectangle(x, y), east["size_in_meters"]["height"].length()
    return None, height


def _object(name: str, item: Entry, things: dict[str, Entry], notes: list[str]) -> SourceObject:
    sizes = item["size_in_meters"]
    width, depth, height = sizes.sides(sizes.named(("length", "width", "height")))
    if item.has("rotation"):
        clockwise = item["rotation"]["z_angle"].number()
    else:
        clockwise = FACING.get(item.word("facing"), 0.0)
        notes.append(f"{name}: no rotation in the file; taken to face {clockwise:g} degrees clockwise of north")
    support, mount = _held(item, things)
    x, y, z = item["position"].named("xyz")
    return SourceObject(
        name,
        name,
        (x, y, z),
        yaw_matrix(math.pi / 2 - math.radians(clockwise)),  # north is +y, and angles run clockwise from it
        (depth, width, height),
        support=support,
        mount=mount,
        description=" ".join(w for w in (item.word("style"), item.word("material")) if w),
        keep=item.kept("facing", "placement", "cluster"),
    )


def _held(item: Entry, things: dict[str, Entry]) -> tuple[str | None, Mount | None]:
    """What carries a thing, and how it is mounted, as the graph says."""
    placement = item.find("placement")
    if placement is not None:
        for other in placement.listed("objects_in_room"):
            if other.word("preposition") == "on" and other.word("object_id") in things:
                return other.word("object_id"), "surface"
        if item.get("is_on_the_floor") is not True:
            for part in placement.listed("room_layout_elements"):
                where = part.word("layout_element_id")
                if where == "ceiling":
                    return None, "ceiling"
                if where in FACING and part.word("preposition") == "on":
                    return None, "wall"
    return None, "floor" if item.get("is_on_the_floor") is True else None


FORMAT = SourceFormat(
    "idesign",
    "I-Design scene graphs",
    _matches,
    _read,
    notes=(
        "Read: centres, sizes, angles, what lies on what, what hangs on walls; the room from the ceiling's entry.",
        "Angles run clockwise from north (+y); length is the width across the front, width the depth.",
        "Things that were never placed are left out; rooms are rectangles without doors or windows.",
    ),
    licence="MIT (code); the scenes are the user's",
)
