"""AI2-THOR houses as JSON: ProcTHOR (both schemas), Holodeck, MolmoSpaces; a house a file, or one a line."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from sceneweaver.io import load_json_lines, load_packed_json, open_unpacked

from .. import frames
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceRoom
from ..plans import room_at
from ..sizes import Size
from ..thor_assets import known_asset
from ..thor_walls import openings_of, wall_heights
from ..values import Entry

BUFFER = 0.10
"""What Holodeck adds to both sides of a thing on the floor [m] before it writes its corners."""

TALL = 2.5
"""Greatest height [m] of a thing on the floor: what is higher up hangs."""

_TURN = frames.facing("y").T  # at 0 a thing faces Unity's +z, which is our +y
_KINDS: tuple[tuple[str, Mount], ...] = (
    ("floor_objects", "floor"),
    ("wall_objects", "wall"),
    ("ceiling_objects", "ceiling"),
    ("small_objects", "surface"),
)
_COUNTED = re.compile(r"\d+|small")
"""What ids begin with that tell no type."""

_LINES = (".jsonl", ".jsonl.gz", ".ndjson")
_LOOKED = 2**22
"""Bytes that are unpacked to recognise a file."""


def _matches(path: Path, head: bytes) -> bool:
    name = path.name.lower()
    if not name.endswith((".json", ".json.gz", *_LINES)):
        return False
    if name.endswith(".gz"):
        with open_unpacked(path, 2**62) as file:
            head = file.read(len(head) or 65536)
    if b'"floorPolygon"' in head or (b'"assetId"' in head and (b'"holePolygon"' in head or b'"wall0"' in head)):
        return True
    if b'"proceduralParameters"' not in head and b'"assetId"' not in head:
        return False
    with open_unpacked(path, 2**62) as file:
        return b'"floorPolygon"' in file.read(_LOOKED)


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    if not path.name.lower().endswith(_LINES):
        yield from _house(Entry.of(path, load_packed_json(path)), "", options.folder)
        return
    some = False
    for number, data in enumerate(load_json_lines(path, max_bytes=2**40), 1):
        some = True
        yield from _house(Entry.of(path, data, f"house {number}"), f"house {number} ", options.folder)
    if not some:
        raise Entry.of(path, None).error("the file is empty; give a house a line")


@dataclass
class _Home:
    """A house while it is read."""

    outlines: dict[str, tuple[tuple[float, float], ...]]
    things: dict[str, list[SourceObject]] = field(default_factory=dict)
    notes: dict[str, list[str]] = field(default_factory=dict)
    listed: dict[str, Mount] = field(default_factory=dict)
    ids: set[str] = field(default_factory=set)
    sizes: Path | None = None


def _house(house: Entry, prefix: str, folder: Path | None) -> Iterator[SourceRoom]:
    rooms = {room["id"].text(): room for room in house["rooms"].entries()}
    if not rooms:
        raise house["rooms"].error("holds no room; give a house with at least one")
    home = _Home({name: _outline(room) for name, room in rooms.items()}, sizes=folder)
    home.notes = {name: [] for name in rooms}
    home.things = {name: [] for name in rooms}
    for key, mount in _KINDS:
        home.listed |= {item.word("id"): mount for item in house.listed(key) if item.word("id")}
    listed = list(house["objects"].entries()) if house.has("objects") else []
    if not listed:  # a Holodeck file that was cut short before the lists were joined
        listed = [item for key, _ in _KINDS for item in house.listed(key)]
    home.ids = {item.word("id") for item in listed}
    for item in listed:
        _thing(item, home, None, None)
    heights = wall_heights(house)
    openings = openings_of(house, home.outlines, home.notes)
    for name, room in rooms.items():
        yield SourceRoom(
            prefix + name,
            room.word("roomType"),
            home.outlines[name],
            heights.get(name, heights.get("")),
            tuple(openings[name]),
            tuple(home.things[name]),
            text=house.word("query"),
            notes=tuple(home.notes[name]),
            house=prefix.strip(),
        )


def _outline(room: Entry) -> tuple[tuple[float, float], ...]:
    if room.has("floorPolygon"):
        points = [corner.named("xz") for corner in room["floorPolygon"].entries()]
        where = room["floorPolygon"]
    else:
        where = room["vertices"]
        points = [corner.numbers(2) for corner in where.entries()]
    if len(points) < 3:
        raise where.error("a floor needs at least 3 corners")
    return tuple((x, z) for x, z in points)


def _thing(item: Entry, home: _Home, parent: str | None, parent_room: str | None) -> None:
    """An object and what it carries, into the room it belongs to."""
    name = item["id"].text()
    position = frames.UNITY @ item["position"].named("xyz")
    room = _room(item, home, parent_room, position)
    if room is None:
        home.notes[next(iter(home.outlines))].append(f"{name}: stands in no room; left out")
        return
    mount = home.listed.get(name) or ("surface" if parent is not None else None)
    asset = item.word("assetId")
    turn = item["rotation"].named("xyz", -1e6, 1e6) if item.has("rotation") else [0.0, 0.0, 0.0]
    # Unity turns about z, then x, then y, all about the room's axes
    theirs = frames.euler_matrix((turn[2], turn[0], turn[1]), "zxy")
    size = _size(item, mount, position[2]) if item.has("vertices") else None
    known = known_asset(home.sizes, asset)
    home.things[room].append(
        SourceObject(
            name,
            _label(item, name, asset, "" if known is None else known.kind),
            (float(position[0]), float(position[1]), float(position[2])),
            frames.rotation(frames.UNITY, theirs) @ _TURN,
            size if known is None else _scaled(known.size, item),
            asset=asset or None,
            support=parent or _receptacle(name, home),
            mount=mount,
            keep=item.kept("kinematic", "openness", "isOn"),
        )
    )
    for child in item.listed("children"):
        _thing(child, home, name, room)


def _room(item: Entry, home: _Home, parent: str | None, position: np.ndarray) -> str | None:
    """The room of an object: as it says, as its carrier's, as its id counts ("Fridge|2|1"), or where it stands."""
    if item.word("roomId") in home.outlines:
        return item.word("roomId")
    if parent is not None:
        return parent
    counted = re.fullmatch(r"[A-Za-z]+\|(\d+)\|.*", item.word("id"))
    if counted and f"room|{counted[1]}" in home.outlines:
        return f"room|{counted[1]}"
    return room_at(home.outlines, float(position[0]), float(position[1]))


def _receptacle(name: str, home: _Home) -> str | None:
    """What carries a small thing of Holodeck: ``mug-0|desk-0 (office)``."""
    carrier = name.split("|", 1)[1] if "|" in name else ""
    return carrier if carrier in home.ids else None


def _scaled(size: Size, item: Entry) -> Size:
    """The box of an asset, as large as the house has it."""
    if not item.has("scale"):
        return size
    x, y, z = item["scale"].named("xyz", 0.0)
    depth, width, height = size
    return item["scale"].sides((depth * z, width * x, height * y))


def _label(item: Entry, name: str, asset: str, kind: str) -> str:
    """Holodeck's own name of a thing, or the type that a ProcTHOR id begins with.

    Early houses of ProcTHOR begin ids with the number of the room, or with "small": there the asset tells.
    """
    own = item.word("object_name") or re.split(r"\||\s\(", name)[0]
    if asset and not item.word("object_name") and _COUNTED.fullmatch(own):
        return kind or asset.removeprefix("RoboTHOR_")
    return re.sub(r"-\d+$", "", own) or name


def _size(item: Entry, mount: Mount | None, middle: float) -> Size | None:
    """The size of a thing of Holodeck, by its corners [cm] in (x, z); None where its height is not known.

    The corners of what stands on the floor have a buffer. Its height is twice that of its middle.
    """
    if mount in ("wall", "ceiling") or not 0 < 2 * middle <= TALL:
        return None
    corners = np.array([corner.numbers(2, -1e6, 1e6) for corner in item["vertices"].entries()]) / 100
    if len(corners) < 3:
        raise item["vertices"].error("a thing needs at least 3 corners")
    angle = math.radians(item["rotation"]["y"].number(-1e6, 1e6) if item.has("rotation") else 0.0)
    front = np.array((math.sin(angle), math.cos(angle)))  # in (x, z): 0 faces +z, 90 faces +x
    depth = float(np.ptp(corners @ front)) - BUFFER
    width = float(np.ptp(corners @ np.array((front[1], -front[0])))) - BUFFER
    if min(depth, width) <= 0:
        raise item["vertices"].error(
            f"smaller than the buffer of {100 * BUFFER:g} cm that Holodeck adds; they are in cm"
        )
    return depth, width, 2 * float(middle)


FORMAT = SourceFormat(
    "ai2thor",
    "AI2-THOR houses (ProcTHOR, Holodeck, MolmoSpaces)",
    _matches,
    _read,
    notes=(
        "Read: rooms, walls, doors, windows, open walls, objects with all that they carry; .json, .json.gz, and "
        ".jsonl or .jsonl.gz with a house a line, one at a time.",
        "Unity is left-handed with y up: x, z become x, y; at 0 a thing faces +z and angles run clockwise.",
        "Houses have no boxes: they come from ProcTHOR's asset-database.json or objathor's annotations in the asset "
        "folder, or, for Holodeck's things on the floor, from their corners less the 10 cm that it adds.",
        "A door of Holodeck lies at its doorSegment; its holePolygon counts from where two rooms meet.",
        "A door turns to the left of the direction of its wall, as ProcTHOR keeps it free; hinges are not in the file.",
        "Lost: materials, lights, agents' poses.",
    ),
    licence="Apache-2.0 (ProcTHOR, Holodeck); assets have their own",
)
