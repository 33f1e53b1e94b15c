"""Floor of each room [m2]: as it is said, by the people it is for, or as usual, fitted to the area of the home."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping

from sceneweaver.language.vocabulary import NUMBERS
from sceneweaver.plans import Programme, RoomSpec, room_type

from .lexicon import data
from .parts import Reading
from .resolve import Room

SPREAD = (0.85, 1.25)
"""Least and most floor by the target, for a room whose size is said in words or follows from people."""

CLEARLY = 1.1
"""Factor on its usual floor from which on a room is big, and under whose inverse it is small."""

EXACT = 0.05
"""Share by which a room may be off an area that is said."""

OUTER, WALLS, CORNER = 0.3, 0.93, 0.86
"""Thickness of outer walls [m]; shares of the floor within them that inner walls and the corner of an L leave."""

ALIKE = 0.06
"""Share by which rooms of one size may be off it."""

FITS = (0.65, 2.0)
"""Factors between which usual areas are fitted to the area of the home."""

_NUMBER = re.compile(r"\b(\d{1,3}|" + "|".join(word for word, n in NUMBERS.items() if 1 < n < 100) + r")\b")


def set_areas(reading: Reading, rooms: list[Room]) -> list[str]:
    """Sets (least, target, most) of each room; says where the area of the home does not fit its rooms."""
    free: list[Room] = []
    for room in rooms:
        least, usual, most = room_type(room.type).area
        told = next((one.area for one in room.named if one.area is not None), None)
        size = _size(room)
        people = _people(room)
        if told is not None:
            low, high = told
            room.area = (round(low * (1 - EXACT), 1), round((low + high) / 2, 1), round(high * (1 + EXACT), 1))
            room.area = _limited(room, room.area)
            continue
        if people is not None and room.kind.name in data("words")["per_person"]:
            base, each = data("words")["per_person"][room.kind.name]
            usual = max(usual * 0.7, base + each * people)
        workers = reading.workers
        if room.type == "open_office" and people is None and workers and workers > 1:
            many = sum(r.type == "open_office" for r in rooms)
            base, each = data("words")["per_person"]["open_office"]
            usual = base + each * workers / many
        usual = round(usual * (size or 1.0) * reading.scale, 1)
        if usual != room_type(room.type).area[1]:
            room.area = (round(usual * SPREAD[0], 1), usual, round(max(usual * SPREAD[1], usual + 1), 1))
            room.area = _as_said(room, size, room.area)
        else:
            room.area = (least, usual, most)
        free.append(room)
    if reading.area is not None:
        return _fitted(sum(reading.area) / 2, rooms, free)
    if reading.width is not None and reading.depth is not None:
        _fitted(_within(reading), rooms, free)
    return []


def _limited(room: Room, area: tuple[float, float, float]) -> tuple[float, float, float]:
    """An area within the limits that are said of a room, which have no play."""
    least = next((one.least for one in room.named if one.least is not None), area[0])
    most = next((one.most for one in room.named if one.most is not None), area[2])
    return least, min(max(area[1], least), most), most


def _within(reading: Reading) -> float:
    """Floor [m2] of the rooms of a home whose sides are said: what walls and a missing corner leave."""
    assert reading.width is not None and reading.depth is not None
    inner = (reading.width - 2 * OUTER) * (reading.depth - 2 * OUTER)
    return inner * WALLS * (CORNER if reading.l_shape else 1.0) * (reading.storeys or 1)


def balanced(programme: Programme, told: Collection[str], area: float | None = None) -> Programme:
    """A programme of several storeys whose rooms fill each of them: all storeys have the outline of the largest.

    Args:
        programme: as it was asked for.
        told: ids of rooms whose area was said, which keep it.
        area: of all rooms [m2], where it was said.
    """
    if programme.storeys == 1:
        return programme
    placed = _spread(programme)
    floors = _floors(programme, placed)
    goal = max(floors) if area is None else min(area, sum(floors)) / programme.storeys
    usual = {room.id: room.storey for room in programme.with_storeys().rooms}
    moved = {name: storey for name, storey in placed.items() if storey != usual[name]}
    fixed = _floors(programme, placed, told)
    rooms: list[RoomSpec] = []
    for room in programme.rooms:
        storey = placed[room.id]
        free = max(floors[storey] - fixed[storey], 1.0)
        factor = min(max((goal - fixed[storey]) / free, FITS[0]), FITS[1])
        update: dict[str, object] = {"storey": moved.get(room.id, room.storey)}
        if room.id not in told and abs(factor - 1) > EXACT and "outdoor" not in room.kind.roles:
            update["area"] = _stretched(room, factor)
        rooms.append(room.model_copy(update=update))
    return programme.model_copy(update={"rooms": tuple(rooms)})


def alike(programme: Programme, groups: Iterable[Collection[str]]) -> Programme:
    """The programme in which rooms of a group are of one size: none is larger than another by more than 2 `ALIKE`."""
    rooms = {room.id: room for room in programme.rooms}
    for group in groups:
        there = [rooms[name] for name in group if name in rooms]
        target = round(sum(room.area[1] for room in there) / max(1, len(there)), 1)
        area = (round(target * (1 - ALIKE), 2), target, round(target * (1 + ALIKE), 2))
        if len(there) > 1:
            rooms |= {room.id: room.model_copy(update={"area": area}) for room in there}
    return programme.model_copy(update={"rooms": tuple(rooms.values())})


def _stretched(room: RoomSpec, factor: float) -> tuple[float, float, float]:
    """The area of a room whose target is multiplied, up to the most of its type; its ends give way."""
    least, target, most = room.area
    new = round(min(target * factor, max(room.kind.area[2], target)), 1)
    return min(least, round(new * SPREAD[0], 1)), new, round(max(most, new * SPREAD[1]), 1)


def _floors(programme: Programme, placed: Mapping[str, int], only: Collection[str] | None = None) -> list[float]:
    """Floor of the rooms indoors of each storey [m2], of some of them where ids are given."""
    rooms = [r for r in programme.rooms if "outdoor" not in r.kind.roles and (only is None or r.id in only)]
    return [sum(r.area[1] for r in rooms if placed[r.id] == s) for s in range(programme.storeys)]


def _spread(programme: Programme) -> dict[str, int]:
    """The storey of each room: as usual, but with bedrooms of which no storey is told moved, with their bathrooms, to
    where there is least, as long as that makes storeys more alike."""
    placed = {room.id: room.storey or 0 for room in programme.with_storeys().rooms}
    doors = [(x.a, x.b) for x in programme.adjacencies if x.kind in ("door", "open")]
    movable = [r for r in programme.rooms if r.storey is None and "sleeping" in r.kind.roles]
    for room in reversed(movable):
        with_it = [room.id, *(b if a == room.id else a for a, b in doors if room.id in (a, b))]
        suite = [r for r in programme.rooms if r.id in with_it]
        floors = _floors(programme, placed)
        high, low = floors.index(max(floors)), floors.index(min(floors))
        fits = placed[room.id] == high and all(r.storey is None for r in suite)
        if fits and floors[high] - floors[low] > 1.2 * sum(r.area[1] for r in suite):
            placed |= dict.fromkeys((r.id for r in suite), low)
    return placed


def _people(room: Room) -> int | None:
    """For how many a room is, by the words that are said of it."""
    for one in room.named:
        for words in one.wishes:
            found = _NUMBER.search(words)
            if found is not None and re.match(r"(for|of|seats|seating|where)\b", words):
                return int(found[1]) if found[1].isdigit() else NUMBERS[found[1]]
    return None


def _size(room: Room) -> float | None:
    """The factor of the word for its size that is said last."""
    return next((one.size for one in reversed(room.named) if one.size is not None), None)


def _as_said(room: Room, size: float | None, area: tuple[float, float, float]) -> tuple[float, float, float]:
    """A big room is above its usual floor, a small one below, also where the home has much or little of it."""
    usual = room_type(room.type).area[1]
    least, target, most = area
    if size is not None and size > 1.0:
        least = round(usual * CLEARLY, 1)
        most = max(most, round(least * SPREAD[1], 1))
    elif size is not None and size < 1.0:
        most = round(usual / CLEARLY, 1)
        least = min(least, round(most * SPREAD[0], 1))
    return least, min(max(target, least), most), most


def _fitted(asked: float, rooms: list[Room], free: list[Room]) -> list[str]:
    """Usual areas, all multiplied alike, so that the rooms indoors have the floor [m2] that is asked for."""
    indoors = [room for room in rooms if "outdoor" not in room_type(room.type).roles]
    fixed = sum(room.area[1] for room in indoors if room not in free and room.area)
    open_ = [room for room in free if room in indoors]
    usual = sum(room.area[1] for room in open_ if room.area)
    if not usual:
        return []
    factor = min(max((asked - fixed) / usual, FITS[0]), FITS[1])
    for room in open_:
        if room.area is None:
            continue
        least, target, most = room.area
        new = round(target * factor, 1)
        room.area = (
            round(min(least, new * SPREAD[0]) if factor < 1 else min(new * SPREAD[0], new), 1),
            new,
            round(max(new * SPREAD[1], new + 1), 1),
        )
        room.area = _as_said(room, _size(room), room.area)
    total = fixed + sum(room.area[1] for room in open_ if room.area)
    if abs(total - asked) > 0.06 * asked:
        return [f"{asked:g} m2 do not fit {len(indoors)} rooms of usual size: they have {total:.0f} m2 together"]
    return []
