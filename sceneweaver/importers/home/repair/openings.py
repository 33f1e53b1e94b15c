"""Doors and windows mended: widened, hung otherwise, moved along their walls, added where a room has none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, place_in
from sceneweaver.plans import Rule, room_type

from ...plan_types import OPENS_FROM
from ..leaves import faults_of, hang
from .reseat import changed, reseated
from .spans import CORNER, openings_of, outer_spans, shared_spans
from .wall_rows import wanted_width

DOOR, ENTRANCE, WINDOW = 0.8, 0.9, 1.2
"""Widths [m] of what is added."""

SILL, HEAD, LOW = 0.9, 2.1, 0.45
"""Sill and upper edge of a window that is added, and the lowest sill of one that must grow [m]."""

SPARE = 1.03
"""How much more glass there is than a rule asks: floors move by millimetres."""

GROWS = 0.1
"""Step [m] by which windows are widened."""


def wider_doors(home: Home, rules: Sequence[Rule]) -> Iterator[Home]:
    """Doors as wide as rules ask, about their middles where the wall allows it: all of them, then each alone."""
    asked = {door.id: wanted_width(home, door, rules) for door in home.doors}
    widths = {door.id: asked[door.id] for door in home.doors if door.width < asked[door.id]}
    outlines = [room.outline for room in home.rooms]
    for chosen in (widths, *({name: width} for name, width in widths.items())) if widths else ():
        made = reseated(home, outlines, chosen)
        if made is not None:
            yield made


def freed_leaves(home: Home) -> Home | None:
    """Doors hung so that leaves swing freely, then moved along their walls, at last made to slide."""
    home_, all_doors = home, [d.id for d in home.doors]
    hung = changed(home, doors=hang(home, all_doors))
    home_ = hung or home_
    for name, faults in faults_of(home_).items():
        if not faults or not faults_of(home_).get(name):
            continue
        door = next(d for d in home_.doors if d.id == name)
        for tried in (*_moved_along(home_, door), door.model_copy(update={"kind": "sliding", "opens_into": None})):
            doors = tuple(tried if d.id == name else d for d in home_.doors)
            made = changed(home_, doors=doors)
            if made is None:
                continue
            made = changed(made, doors=hang(made, [name])) or made
            if not faults_of(made).get(name):
                home_ = made
                break
    return home_ if home_ != home else None


def _moved_along(home: Home, door: HomeDoor) -> Iterator[HomeDoor]:
    """A door at other places of its wall, the nearest first."""
    room = home.room(door.room)
    wall = room.walls[door.wall]
    spans = [(CORNER, wall.length - CORNER)]
    if door.to is not None:
        number, _ = place_in(home, door, door.to)
        back = home.room(door.to).walls[number]
        ends = sorted((wall.coordinates(back.start)[0], wall.coordinates(back.end)[0]))
        spans = [(max(spans[0][0], ends[0] + 0.02), min(spans[0][1], ends[1] - 0.02))]
    taken = [s for s in openings_of(home, room, wall) if abs(s[0] - door.offset) > 1e-6]
    steps = []
    for low, high in spans:
        count = int((high - door.width - low) / 0.05) + 1 if high - door.width >= low else 0
        steps += [round(low + 0.05 * k, 3) for k in range(count)] + ([round(high - door.width, 3)] if count else [])
    for offset in sorted(steps, key=lambda s: abs(s - door.offset)):
        if all(offset + door.width <= a - 0.01 or offset >= b + 0.01 for a, b in taken):
            yield door.model_copy(update={"offset": offset})


def more_light(home: Home, rooms: Sequence[str], least: float) -> Home | None:
    """Windows of rooms made as large as their floor needs, or added in walls that look outdoors.

    Args:
        home: whose.
        rooms: ids of the rooms that lack light.
        least: glass by floor.
    """
    for name in rooms:
        room = home.room(name)
        wanted = least * SPARE * shapely.Polygon(room.outline).area
        home = _windows(home, room, wanted)
    return home


def _windows(home: Home, room: HomeRoom, wanted: float) -> Home:
    top = min(HEAD, home.storey_of(room.id).height - 0.2)
    mine = [w for w in home.windows if w.room == room.id]
    made = {w.id: w for w in mine}

    def glass() -> float:
        return sum(w.width * w.height for w in made.values())

    for window in mine:  # large enough to climb out of: 0.53 m2, a sill of 1.12 m
        sill = min(window.sill, SILL)
        made[window.id] = window.model_copy(
            update={
                "sill": round(sill, 3),
                "height": round(max(window.height, top - sill), 3),
                "width": max(window.width, _fitting(home, room, window, 0.6)),
                "offset": _about(home, room, window, max(window.width, _fitting(home, room, window, 0.6))),
            }
        )
    for window in list(made.values()):
        lack = wanted - glass()
        if lack > 0:
            width = _fitting(home, room, window, window.width + GROWS * -(-lack / window.height // GROWS))
            offset = _about(home, room, window, width)
            made[window.id] = window.model_copy(update={"width": width, "offset": offset})
    for wall, (low, high) in outer_spans(home, room):
        lack = wanted - glass()
        if made and lack <= 0:
            break
        sill = SILL
        width = min(high - low, max(WINDOW, -(-lack / (top - sill) // GROWS) * GROWS))
        if width < 0.51:
            continue
        name = _free_id(home, f"window_of_{room.id}", made)
        start = round((low + high - width) / 2, 3)
        made[name] = HomeWindow(
            id=name,
            room=room.id,
            wall=wall.index,
            offset=start,
            width=round(width, 3),
            sill=sill,
            height=round(top - sill, 3),
        )
    for window in list(made.values()):
        if wanted - glass() > 0 and window.sill > LOW:
            made[window.id] = window.model_copy(
                update={"sill": LOW, "height": round(window.height + window.sill - LOW, 3)}
            )
    rest = [made.pop(w.id, w) for w in home.windows]
    return changed(home, windows=(*rest, *made.values())) or home


def _fitting(home: Home, room: HomeRoom, window: HomeWindow, width: float) -> float:
    low, high = _around(home, room, window)
    return round(min(width, high - low), 3)


def _about(home: Home, room: HomeRoom, window: HomeWindow, width: float) -> float:
    low, high = _around(home, room, window)
    start = window.offset + (window.width - width) / 2
    return round(min(max(start, low), high - width), 3)


def _around(home: Home, room: HomeRoom, window: HomeWindow) -> tuple[float, float]:
    """What a window may take of its wall: itself and the free parts beside it that look outdoors."""
    bare = changed(home, windows=tuple(w for w in home.windows if w.id != window.id))
    for wall, (low, high) in outer_spans(bare or home, room):
        if wall.index == window.wall and low <= window.offset + window.width / 2 <= high:
            return min(low, window.offset), max(high, window.offset + window.width)
    return window.offset, window.offset + window.width


def new_doors(home: Home, room_id: str, reached: Sequence[str]) -> Iterator[Home]:
    """The home with a door between a room and one of those that are reached, the best first: halls, then others."""
    room = home.room(room_id)
    options: list[tuple[int, float, HomeRoom]] = []
    for other in home.rooms:
        if other.id not in reached or other.storey != room.storey or other.id == room_id:
            continue
        if any({d.room, d.to} == {room.id, other.id} for d in home.doors):
            continue
        spans = shared_spans(home, room, other)
        if spans:
            kind = room_type(other.type)
            rank = (
                0
                if "circulation" in kind.roles
                else 1
                if kind.transit == "all"
                else 2
                if kind.transit == "suite"
                else 3
            )
            options.append((rank, spans[0][1][0] - spans[0][1][1], other))
    for _, _, other in sorted(options, key=lambda o: o[:2]):
        wall, (low, high) = shared_spans(home, room, other)[0]
        width = round(min(DOOR, high - low), 3)
        if width < 0.6:
            continue
        name = _free_id(home, f"door_{room.id}_{other.id}")
        into = other.id if room.type in OPENS_FROM and other.type not in OPENS_FROM else room.id
        slides = room.outdoor or other.outdoor
        door = HomeDoor(
            id=name,
            room=room.id,
            wall=wall.index,
            offset=round(low, 3),
            width=width,
            height=2.05,
            to=other.id,
            kind="sliding" if slides else "hinged",
            opens_into=None if slides else into,
        )
        made = changed(home, doors=(*home.doors, door))
        if made is not None:
            yield changed(made, doors=hang(made, [name])) or made


def new_entrances(home: Home) -> Iterator[Home]:
    """The home with a door out of it: of a hall, else of a room that is a way."""
    lowest = home.storeys[0].id
    order = {"entrance_hall": 0, "hallway": 1, "corridor": 1, "vestibule": 0, "living_room": 3, "living_kitchen": 3}
    rooms = [r for r in home.rooms if r.storey == lowest and not r.outdoor and room_type(r.type).transit == "all"]
    for room in sorted(rooms, key=lambda r: order.get(r.type, 2)):
        for wall, (low, high) in outer_spans(home, room):
            if high - low < ENTRANCE:
                continue
            door = HomeDoor(
                id=_free_id(home, "entrance"),
                room=room.id,
                wall=wall.index,
                offset=round(low, 3),
                width=ENTRANCE,
                height=2.05,
                opens_into=room.id,
            )
            made = changed(home, doors=(*home.doors, door))
            if made is not None:
                yield changed(made, doors=hang(made, [door.id])) or made
            break


def _free_id(home: Home, stem: str, also: Sequence[str] | dict[str, HomeWindow] = ()) -> str:
    used = {o.id for o in (*home.doors, *home.windows)} | set(also)
    name, k = stem, 2
    while name in used:
        name, k = f"{stem}_{k}", k + 1
    return name
