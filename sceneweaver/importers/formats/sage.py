"""SAGE: floor plans as JSON, with rooms, walls, doors, windows and objects in one frame of the house."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from sceneweaver.io import load_json
from sceneweaver.io.references import named_inside

from ..frames import euler_matrix, facing
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import along, rectangle
from ..values import Entry

_MOST = 1000
"""Walls of a room that are tried to be put in a ring."""

_TURN = facing("y").T  # at 0 degrees a thing faces +y, as their solver has it


def _matches(path: Path, head: bytes) -> bool:
    if path.suffix.lower() != ".json":
        return False
    room = b'"room_type"' in head and b'"dimensions"' in head
    return room and (b'"ceiling_height"' in head or b'"start_point"' in head or b'"position_on_wall"' in head)


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    plan = Entry.of(path, load_json(path))
    rooms = list(plan["rooms"].entries()) if not plan.has("room_type") else [plan]
    if not rooms:
        raise plan["rooms"].error("holds no room; give a plan with at least one")
    text = plan.word("created_from_text") or plan.word("description")
    doors: dict[str, list[str]] = {}
    for room in rooms:
        for door in room.listed("doors"):
            doors.setdefault(door["id"].text(), []).append(room["id"].text())
    folders = [path.parent, *([options.folder] if options.folder is not None else [])]
    for room in rooms:
        yield _room(room, doors, text, folders)


def _room(room: Entry, doors: dict[str, list[str]], text: str, folders: list[Path]) -> SourceRoom:
    name = room["id"].text()
    notes: list[str] = []
    left, below = room["position"].named("xy")
    floor = room["position"]["z"].number() if room["position"].has("z") else 0.0
    size = room["dimensions"]
    x, y, height = size.sides(size.named(("width", "length", "height")))
    if room.has("ceiling_height"):
        height = room["ceiling_height"].length()
    walls = {wall["id"].text(): wall for wall in room.listed("walls")}
    outline = _ring(list(walls.values()))
    if outline is None:
        outline = rectangle(x, y, left, below)
        notes.append("the walls form no ring: the outline is the room's rectangle")
    openings = []
    for kind in ("doors", "windows"):
        for item in room.listed(kind):
            opening = _opening(item, walls, doors, name, kind == "doors", notes)
            openings += [opening] if opening is not None else []
    things = [item for item in room.listed("objects")]
    names = {item["id"].text() for item in things}
    objects = tuple(_object(item, name, walls, names, floor, folders) for item in things)
    return SourceRoom(
        name, room.word("room_type"), outline, height, tuple(openings), objects, text=text, notes=tuple(notes)
    )


def _ring(walls: list[Entry]) -> tuple[tuple[float, float], ...] | None:
    """The outline [m] along the walls, whatever their order and direction; None where they form no ring."""
    ends = [tuple(tuple(w[k].named("xy")) for k in ("start_point", "end_point")) for w in walls]
    if not 3 <= len(ends) <= _MOST:
        return None
    (first, at), rest = ends[0], ends[1:]
    ring = [first]
    while rest:
        near = min(rest, key=lambda e: min(np.hypot(*np.subtract(p, at)) for p in e))
        a, b = near if np.hypot(*np.subtract(near[0], at)) <= np.hypot(*np.subtract(near[1], at)) else near[::-1]
        if np.hypot(*np.subtract(a, at)) > 0.02:
            return None
        ring.append(a)
        at = b
        rest.remove(near)
    return tuple((float(p[0]), float(p[1])) for p in ring) if np.hypot(*np.subtract(at, first)) <= 0.02 else None


def _opening(
    item: Entry, walls: dict[str, Entry], doors: dict[str, list[str]], room: str, is_door: bool, notes: list[str]
) -> SourceOpening | None:
    name = item["id"].text()
    wall = walls.get(item["wall_id"].text())
    if wall is None:
        notes.append(f"{name}: its wall {item.word('wall_id')} is not in the room; left out")
        return None
    a, b = (wall[key].named("xy") for key in ("start_point", "end_point"))
    length = float(np.hypot(*np.subtract(b, a)))
    if length < 1e-6:
        raise wall.error("its two ends are one point; give a wall of some length")
    middle = item["position_on_wall"].number(0.0, 1.0) * length
    width, height = item["width"].length(), item["height"].length()
    start, end = along(a, b, middle - width / 2, middle + width / 2)
    if not is_door:
        return SourceOpening(name, "window", start, end, item["sill_height"].length(), height)
    others = [r for r in doors[name] if r != room]
    return SourceOpening(
        name,
        "passage" if item.get("opening") is True else "door",
        start,
        end,
        0.0,
        height,
        leads_to=others[0] if others else None,
    )


def _object(
    item: Entry, room: str, walls: dict[str, Entry], names: set[str], floor: float, folders: list[Path]
) -> SourceObject:
    size = item["dimensions"]
    width, depth, height = size.sides(size.named(("width", "length", "height")))
    theirs = euler_matrix(item["rotation"].named("xyz", -1e6, 1e6)) if item.has("rotation") else np.eye(3)
    bottom = np.array(item["position"].named("xyz")) - (0.0, 0.0, floor)
    centre = bottom + theirs @ (0.0, 0.0, height / 2)
    place = item.word("place_id")
    mount: Mount | None = None
    if place == room or place == "floor":
        mount = "floor"
    elif place in walls or place == "wall":
        mount = "wall"
    elif place in names:
        mount = "surface"
    return SourceObject(
        item["id"].text(),
        item.word("type", item["id"].text()),
        (float(centre[0]), float(centre[1]), float(centre[2])),
        theirs @ _TURN,
        (depth, width, height),
        asset=item.word("source_id") or None,
        mesh=_mesh(folders, item.word("source"), item.word("source_id")),
        mesh_axes=_TURN.T,
        support=place if place in names else None,
        mount=mount,
        description=item.word("description"),
        keep=item.kept("placement_constraints", "mass", "source"),
    )


def _mesh(folders: list[Path], source: str, name: str) -> Path | None:
    """The mesh of an object: ``<source>/<source_id>.ply`` beside the plan or in the asset folder."""
    for folder in folders if source and name else ():
        place = named_inside(folder, folder / source / f"{name}.ply")
        if place is not None and place.is_file():
            return place
    return None


FORMAT = SourceFormat(
    "sage",
    "SAGE floor plans",
    _matches,
    _read,
    notes=(
        "Read: rooms with walls, doors, openings, windows (a fraction along the wall, of their middle), objects.",
        "Positions are of the bottom centre in the frame of the house; angles [degrees] about fixed x, y, z; at 0 a "
        "thing faces +y (their solver), so length is its depth and width its width. Floors are moved to z = 0.",
        "Meshes (<source>/<source_id>.ply, z up, facing +y) are used where they lie beside the plan or in the folder.",
        "Lost: which way doors open, materials; masses and placement constraints are kept with the object.",
    ),
    licence="Apache-2.0 (code); SAGE-10k has its own",
)
