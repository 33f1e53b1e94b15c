"""Which kind of room is meant where a request names none: from its things, and from words of rooms beside them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.taxonomy import members

from .kin import families
from .load import check_known, data_of, room_types, room_words
from .model import RoomType

CHANCE = {"needed": 0.9, "usual": 0.6, "optional": 0.25}
"""Chance that a request for a room names a thing of it, by how much the room needs it."""

SIGN, STRANGE = 0.8, 0.03
"""The same for a sign of a room, and for what is no thing of it."""

PRIOR = 0.3
"""Prior of a kind of room that the data does not list."""

NAMED, BESIDE = 40.0, 6.0
"""How much likelier a kind of room is whose name stands in the text, on its own and before another noun."""


@cache
def _data() -> Mapping[str, Any]:
    """The file: ``prior`` of rooms, ``signs`` of rooms, and the families that are ``decisive``."""
    file, data = "likely_rooms.yaml", data_of("likely_rooms.yaml")
    check_known(file, (*data["prior"], *data["signs"]), room_types(), "kind of room")
    check_known(file, (name for names in data["signs"].values() for name in names), categories())
    check_known(file, data["decisive"], families()[0], "family of kin.yaml")
    return data


@cache
def _chances(room: str) -> Mapping[str, float]:
    """The chance of each category that belongs to a kind of room."""
    found: dict[str, float] = dict.fromkeys(_data()["signs"].get(room, ()), SIGN)
    for item in room_types()[room].items:
        for name in item.what:
            for category in (name, *members(name)):
                found[category] = max(found.get(category, 0.0), CHANCE[item.need])
    return found


def likeliest_room(named: Iterable[str], text: str = "") -> RoomType | None:
    """The kind of room that a request means by the things that it names.

    A naive Bayes classifier: prior times the chance of each category named, each counted once; what is part of no kind
    of room tells nothing. A room's name in the text ("a breakfast dining room", "kitchen table") makes it likelier.

    Args:
        named: categories that the request asks for.
        text: its words.

    Returns:
        The likeliest kind of room; None when nothing tells one from another.
    """
    known = room_types()
    told = sorted(c for c in set(named) if any(c in _chances(room) for room in known))
    words = _words_of_rooms(text)
    if not told and not words:
        return None

    def score(room: str) -> float:
        chances = _chances(room)
        found = sum(math.log(chances.get(c, STRANGE)) for c in told)
        return found + math.log(_data()["prior"].get(room, PRIOR)) + math.log(words.get(room, 1.0))

    return known[max(_possible(told), key=score)]


def told_by(named: Iterable[str], room: RoomType) -> float:
    """The share of things that belong to a kind of room, 0 where there are none."""
    kinds = set(named)
    return sum(kind in _chances(room.name) for kind in kinds) / max(1, len(kinds))


def _possible(told: Iterable[str]) -> list[str]:
    """The kinds of rooms that may hold what decides: beds are in rooms to sleep in, whatever else is there."""
    found = sorted(room_types())
    for family in (families()[0][name] for name in _data()["decisive"]):
        if family.intersection(told):
            found = [room for room in found if family.intersection(_chances(room))] or found
    return found


def _words_of_rooms(text: str) -> Mapping[str, float]:
    """By kind of room how much likelier its name in the text makes it; a name within a longer one does not count."""
    low, found = text.lower(), dict[str, float]()
    taken: list[tuple[int, int]] = []
    for phrase in sorted((words for words in room_words() if words in low), key=len, reverse=True):
        for match in re.finditer(rf"\b{re.escape(phrase)}\b(?P<noun>\s+[a-z-]+)?", low):
            start, end = match.start(), match.start() + len(phrase)
            if any(start < b and a < end for a, b in taken):
                continue
            taken.append((start, end))
            beside = match["noun"] is not None and _is_thing(match["noun"])
            room = room_words()[phrase]
            found[room] = max(found.get(room, 1.0), BESIDE if beside else NAMED)
    return found


def _is_thing(noun: str) -> bool:
    """Whether a noun is one of furniture: a "kitchen table" may stand elsewhere."""
    from sceneweaver.assets import resolve

    return resolve(noun.strip()).how != "generic"
