"""SceneWeaver: ``layout_<i>.json``, the state of a step, and the ``Placement`` of its language-model tools."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import numpy as np

from sceneweaver.io import load_json

from ..frames import euler_matrix
from ..model import Mount, ReadOptions, SourceFormat, SourceObject, SourceOpening, SourceRoom
from ..plans import opening_of_box, rectangle
from ..values import Entry

WALL = 0.14
"""Half the thickness [m] of its executor's walls: there the floor lies and the walls end, within ``roomsize``."""

_MOUNTS: dict[str, Mount] = {"onfloor": "floor", "on_floor": "floor", "against_wall": "wall"}
_ON = {"ontop", "on_top", "on", "inside"}


def _matches(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return _last(path) is not None
    if path.suffix.lower() != ".json":
        return False
    if re.search(rb'"(?:roomsize|Roomsize|room_size)"\s*:', head) is not None:
        return b'"objects"' in head or b'"Placement' in head
    named = re.fullmatch(r"layout_\d+\.json", path.name) is not None
    return (named or b'"structure"' in head) and b'"objects"' in head and b'"location"' in head


def _steps(folder: Path) -> list[tuple[int, Path]]:
    """The layouts of a folder by the number of their step."""
    named = ((re.fullmatch(r"layout_(\d{1,9})\.json", p.name), p) for p in folder.iterdir())
    return sorted((int(match[1]), p) for match, p in named if match)


def _last(folder: Path) -> Path | None:
    """The last step of a run, as its record_scene has them; None where the folder is none."""
    steps = _steps(folder)
    if not steps or folder.name != "record_scene":
        return None
    return steps[-1][1]


def _read(path: Path, options: ReadOptions) -> Iterator[SourceRoom]:
    if not path.is_dir():
        yield from _layout(path, [])
        return
    last = _last(path) or path / "layout_0.json"
    earlier = len(_steps(path)) - 1
    yield from _layout(last, [f"{last.name} is read; {earlier} earlier steps are passed over"] if earlier else [])


def _layout(path: Path, notes: list[str]) -> Iterator[SourceRoom]:
    data = Entry.of(path, load_json(path))
    things = dict(_things(data))
    size = next((data[k] for k in ("roomsize", "Roomsize", "room_size") if data.has(k)), None)
    level = _level(things)
    inset = WALL if abs(level - WALL) < 0.03 else 0.0
    if level:
        notes.append(f"what stands on the floor is at z = {level:.3g} m: everything is moved down by it")
    outline = height = None
    if size is None:
        notes.append("no roomsize: the room is drawn around its objects")
    else:
        sides = [v.number(0.0) for v in size.entries()] if isinstance(size.value, list) else size.named(("x", "y"))
        if len(sides) not in (2, 3):
            raise size.error("must be [x, y] or [x, y, height]")
        x, y, height = (*sides, None) if len(sides) == 2 else sides
        size.sides((x - 2 * inset, y - 2 * inset, 1.0))
        outline = rectangle(x - 2 * inset, y - 2 * inset, inset, inset)
        if inset:
            notes.append(f"the walls are {2 * inset:g} m thick and lie within roomsize")
    openings = []
    for name, item in data["structure"].items() if data.has("structure") else ():
        openings.append(_opening(name, item, level))
    if openings:
        notes.append("doors and windows: a location is taken as the middle of the opening's width")
    objects = tuple(_object(name, item, set(things), level) for name, item in things.items())
    yield SourceRoom(
        path.stem,
        next((data.word(k) for k in ("Roomtype", "Room type", "roomtype", "room_type") if data.has(k)), ""),
        outline,
        height,
        tuple(openings),
        objects,
        text=next((data.word(k) for k in ("user_demand", "User demand") if data.has(k)), ""),
        notes=tuple(notes),
    )


def _things(data: Entry) -> Iterator[tuple[str, Entry]]:
    """Objects by name: those of a layout, or those of a placement, two levels deep by category and number."""
    if data.has("objects"):
        objects = data["objects"]
        if isinstance(objects.value, list):
            yield from ((item["name"].text(), item) for item in objects.entries())
        else:
            yield from objects.items()
        return
    places = [key for key in data.mapping() if key.startswith("Placement")]
    if not places:
        raise data.error("'objects' is missing; a layout has them by name")
    for key in places:
        for category, numbered in data[key].items():
            for number, item in numbered.items():
                yield f"{number}_{category}", item


def _level(things: dict[str, Entry]) -> float:
    """Height [m] of what the file says to stand on the floor, where it is that of no other system's zero."""
    lows = []
    for item in things.values():
        if any(relation in ("onfloor", "on_floor") for _, relation in _relations(item)):
            place = _place(item)
            lows += [place[2]] if len(place) > 2 else []
    level = median(lows) if lows else 0.0
    return level if 0.03 < level < 0.5 else 0.0


def _place(item: Entry) -> list[float]:
    place = item["location"] if item.has("location") else item["position"]
    return place.numbers(len(place.value) if isinstance(place.value, list) and len(place.value) == 2 else 3)


def _relations(item: Entry) -> Iterator[tuple[str, str]]:
    """Pairs of a parent's name and a relation: ``[[name, relation], ..]``, ``[category, number, relation]``."""
    parent = item.get("parent")
    if not isinstance(parent, list) or not parent:
        return
    if all(isinstance(p, str) for p in parent):
        if len(parent) == 3:
            yield f"{parent[1]}_{parent[0]}", parent[2]
        elif len(parent) == 2:
            yield parent[0], parent[1]
        return
    for pair in parent:
        if isinstance(pair, list) and len(pair) == 2 and all(isinstance(p, str) for p in pair):
            yield pair[0], pair[1]


def _object(name: str, item: Entry, names: set[str], level: float) -> SourceObject:
    depth, width, height = item["size"].sides(item["size"].numbers(3))
    place = _place(item)
    x, y, z = (*place, level) if len(place) == 2 else place
    turn = item.find("rotation")
    if turn is None:
        rotation = np.eye(3)
    elif isinstance(turn.value, list):
        rotation = euler_matrix([math.degrees(v) for v in turn.numbers(3)])
    else:  # their language-model tools write degrees about z
        rotation = euler_matrix((0.0, 0.0, turn.number()))
    relations = list(_relations(item))
    support = next((parent for parent, relation in relations if relation in _ON and parent in names), None)
    mount: Mount | None = None if support is None else "surface"
    told = [_MOUNTS[relation] for _, relation in relations if relation in _MOUNTS]
    if mount is None and told:
        mount = "floor" if "floor" in told else "wall"
    z -= level
    if mount == "wall" and z < 0.02:
        mount = "floor"  # against a wall, and on the floor
    return SourceObject(
        name,
        _label(name),
        (x, y, z),
        rotation,
        (depth, width, height),
        anchor="bottom",
        support=support,
        mount=mount,
        keep=item.kept("parent"),
    )


def _label(name: str) -> str:
    """The category in a name such as ``BedFactory(1234).bbox_placeholder(5678)`` or ``8263_bed``."""
    word = re.sub(r"\(.*?\)", " ", name).split(".")[0]
    return re.sub(r"Factory\b", "", re.sub(r"^\d+_|_\d+$", "", word.strip())).strip() or name


def _opening(name: str, item: Entry, level: float) -> SourceOpening:
    """A door ("entrance..") or window by the box of its model."""
    x, y, z = item["location"].numbers(3)
    size = item["size"].sides(item["size"].numbers(3))
    turn = euler_matrix([math.degrees(v) for v in item["rotation"].numbers(3)])
    return opening_of_box(name, name.startswith("window"), (x, y, z - level), turn, size)


FORMAT = SourceFormat(
    "sceneweaver",
    "SceneWeaver layouts",
    _matches,
    _read,
    notes=(
        "Read: roomsize, objects (location or position, rotation, size, parent with the relation), structure.",
        "A position is of the bottom centre; angles [rad] about fixed x, y, z; the front is +x, so size is depth, "
        "width, height. A room has one corner at the origin. Where the floor lies at 0.14 m, as the executor has it, "
        "everything is moved down by it and the walls are inset by it.",
        "Assumed: a door or window is as wide as the longer side of its box, around its location.",
        "A folder record_scene is one scene, that of its last step.",
        "Relations to parents are kept with the object; what lies on or in a parent is carried by it.",
    ),
    licence="BSD-3-Clause (code); the scenes are the user's",
)
