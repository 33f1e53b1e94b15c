"""``is_home``: whether a request is for a home, practice or office of several rooms, or for one room."""

from __future__ import annotations

from functools import lru_cache

from sceneweaver.knowledge.load import room_words

from .lexicon import data
from .mentions import is_thing
from .mixed_use import mixed_in
from .parts import Named
from .read import read_parts
from .residents import people_told
from .tokens import Token, spoken
from .use_named import use_in

FEWEST = 2
"""Rooms from which on an office or a practice is one of several rooms."""

SINGLE = 45.0
"""Floor [m2] up to which an apartment of which no room is told is one room."""

LISTED = 3
"""The same where no home is named: rooms of at least two kinds, none of which the others belong to."""

_SURFACES = frozenset(("floor", "floors", "ground", "surface", "surfaces", "roof", "ceiling", "screen"))
"""What is flat without being lived in."""


@lru_cache(maxsize=256)
def is_home(request: str) -> bool:
    """Whether a request is for a whole home, practice, office or school, and not for one room.

    A flat or a house is a whole home by its name. An office, a practice or a school is one only where rooms of it are
    told ("an office with two meeting rooms and a kitchen"); and so are three rooms of which none is part of another.

    Raises:
        InputError: when there is nothing to read.

    Examples:
        >>> from sceneweaver.language.homes import is_home
        >>> is_home("a two-bedroom flat with a big kitchen"), is_home("a living room with a kitchen corner")
        (True, False)
    """
    said = spoken(request)
    if " ".join(request.lower().split()).strip(".!") in room_words():
        return False
    if mixed_in(said.tokens) is not None:
        return True
    named = use_in(said.tokens)
    if named is not None and _is_quality(said.tokens, named[1]):
        named = None
    whole = named is not None and said.tokens[named[1]].get("use")[1] and not _room_first(said.tokens, named[1])
    of_one_room = named is not None and _is_one_kind(said.tokens, named[1])
    if whole and not of_one_room:
        return True
    reading, _ = read_parts(request)
    rooms = [one for one in reading.named if one.of is None and not one.barred and not _beside(reading.tokens, one)]
    sure = sum((one.count or 2) * one.times for one in rooms if not _may_be_part(reading.tokens, one))
    if sure:
        sure += sum(reading.staff.values())
    if whole:
        many = (people_told(reading) or reading.household or 0) > 2 or (reading.area or (0, 0))[1] > SINGLE
        return many or sure > 0 or (reading.storeys or 1) > 1
    if named is not None:
        if _room_first(said.tokens, named[1]):
            return False
        return sure >= FEWEST or (sure >= 1 and sum(one.count or 2 for one in rooms) > LISTED)
    if any(token.done == "storeys" and reading.storeys for token in reading.tokens) and sure:
        return True
    several = sure >= LISTED and len({one.kind.name for one in rooms}) > 1
    return several and (_is_list(reading.tokens, rooms) or _is_unknown_place(reading.tokens, rooms))


def _is_quality(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether "flat" is what a floor is like and no home: "the floor 6 x 6 m, flat, no rugs", "a flat floor"."""
    if tokens[at].text != "flat":
        return False
    if at + 1 < len(tokens) and tokens[at + 1].text in _SURFACES:
        return True
    ends = at + 1 == len(tokens) or tokens[at + 1].breaks
    begun = max((k for k in range(at) if tokens[k].stops), default=-1)
    return ends and at > 0 and tokens[at - 1].breaks and any(t.text in _SURFACES for t in tokens[begun + 1 : at])


def _is_one_kind(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether a name of a home is also that of a kind of single room: a tea house, a log cabin, an apartment."""
    said = [t.text for t in tokens[max(0, at - 3) : at + 1]]
    return any(" ".join(said[k:]) in room_words() for k in range(len(said)))


def _room_first(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether a room is named before the home, which then is where it lies: "bedroom, small flat"."""
    first = next((k for k, t in enumerate(tokens[:at]) if t.has("room", "known_room") and not t.has("use")), None)
    if first is None or tokens[first - 1].number not in (None, 1) or tokens[first].plural:
        return False
    return (
        not any(t.stops or t.text == ":" for t in tokens[first:at])
        and not any(t.has("number") for t in tokens[first:at])
        and (
            first == at - 1
            and tokens[first].text not in ("bedroom", "room", "bed", "bath")
            or not _compound(tokens, first, at)
        )
    )


def _compound(tokens: tuple[Token, ...], first: int, at: int) -> bool:
    """ "A one-bedroom flat": the number of rooms is part of the name."""
    return at - first <= 3 and tokens[first].text in ("bedroom", "room", "bed", "bath", "bathroom")


def _may_be_part(tokens: tuple[Token, ...], one: Named) -> bool:
    token = tokens[one.at]
    last = token.text.split()[-1]
    if (
        one.told in ("number", "total")
        and (one.count or 0) > 1
        and last not in ("station", "stations", "desks", "booths", "booth", "areas", "corners", "places")
    ):
        return False
    return (
        last in data("words")["parts_of_rooms"]
        or token.text in data("words")["parts_of_rooms"]
        or last.rstrip("s") in data("words")["parts_of_rooms"]
    )


def _beside(tokens: tuple[Token, ...], one: Named) -> bool:
    """Whether a room is only where something leads to, or what is seen: "the door to the bathroom"."""
    before = [t.text for t in tokens[max(0, one.first - 3) : one.first]]
    if before and before[-1] in ("to", "into", "from", "towards", "toward", "of", "in", "like", "outside"):
        return True
    return one.definite and not one.told and not any(t in ("with", "and", ",") for t in before[-1:])


def _is_unknown_place(tokens: tuple[Token, ...], rooms: list[Named]) -> bool:
    """Whether the request begins with a place that nobody knows, which has rooms: "a donation centre with ..."."""
    first = min(one.first for one in rooms)
    before = [t for t in tokens[:first] if not t.has("function", "soft", "size", "number")]
    tie = tokens[first - 1] if first else None
    if (
        tie is None
        or tie.text not in ("with", ":")
        and tokens[first - 2].text != "with"
        or any(t.breaks for t in before[:-1])
    ):
        return False
    heads = [t for t in before if not t.breaks]
    return bool(heads) and not any(t.has("room", "known_room") or is_thing(t) for t in heads)


def _is_list(tokens: tuple[Token, ...], rooms: list[Named]) -> bool:
    """Whether the request begins with rooms side by side, and not with one that the others belong to."""
    if len(rooms) < 2:
        return False
    first, second = rooms[0], rooms[1]
    gap = [t.text for t in tokens[first.last + 1 : second.first]]
    return bool(gap) and len(gap) <= 2 and gap[0] in (",", "and", "&", "/", "+") or (first.count or 1) > 1
