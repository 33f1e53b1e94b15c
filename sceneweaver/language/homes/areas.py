"""Floor of each room [m2]: as it is said, by the people it is for, or as usual, fitted to the area of the home."""

from __future__ import annotations

import re

from sceneweaver.language.vocabulary import NUMBERS
from sceneweaver.plans import room_type

from .lexicon import data
from .parts import Reading
from .resolve import Room

SPREAD = (0.85, 1.25)
"""Least and most floor by the target, for a room whose size is said in words or follows from people."""

EXACT = 0.05
"""Share by which a room may be off an area that is said."""

FITS = (0.7, 1.6)
"""Factors between which usual areas are fitted to the area of the home."""

_NUMBER = re.compile(r"\b(\d{1,3}|" + "|".join(word for word, n in NUMBERS.items() if 1 < n < 100) + r")\b")


def set_areas(reading: Reading, rooms: list[Room]) -> list[str]:
    """Sets (least, target, most) of each room; says where the area of the home does not fit its rooms."""
    free: list[Room] = []
    for room in rooms:
        least, usual, most = room_type(room.type).area
        told = next((one.area for one in room.named if one.area is not None), None)
        size = next((one.size for one in reversed(room.named) if one.size is not None), None)
        people = _people(room)
        if told is not None:
            low, high = told
            room.area = (round(low * (1 - EXACT), 1), round((low + high) / 2, 1), round(high * (1 + EXACT), 1))
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
        else:
            room.area = (least, usual, most)
        free.append(room)
    if reading.area is None:
        return []
    return _fitted(reading, rooms, free)


def _people(room: Room) -> int | None:
    """For how many a room is, by the words that are said of it."""
    for one in room.named:
        for words in one.wishes:
            found = _NUMBER.search(words)
            if found is not None and re.match(r"(for|of|seats|seating|where)\b", words):
                return int(found[1]) if found[1].isdigit() else NUMBERS[found[1]]
    return None


def _fitted(reading: Reading, rooms: list[Room], free: list[Room]) -> list[str]:
    """Usual areas, all multiplied alike, so that the rooms indoors have the floor that is asked for."""
    assert reading.area is not None
    asked = (reading.area[0] + reading.area[1]) / 2
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
    total = fixed + sum(room.area[1] for room in open_ if room.area)
    if abs(total - asked) > 0.06 * asked:
        return [f"{asked:g} m2 do not fit {len(indoors)} rooms of usual size: they have {total:.0f} m2 together"]
    return []
