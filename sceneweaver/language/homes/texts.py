"""The sentence that each room of a home is designed from, as the reader of single rooms takes it."""

from __future__ import annotations

from sceneweaver.home import Home
from sceneweaver.plans import room_types

from .model import HomeRequest, RoomAsked

_TIES = ("with", "for", "without", "where", "that", "which", "of", "in", "has", "seats", "seating", "including", "to")
"""Words that a wish may begin with, so that it needs none before it."""


def room_requests(request: HomeRequest, home: Home | None = None, *, told_only: bool = False) -> dict[str, str]:
    """By id the sentence with which each room is designed: its kind, whom it is for, what it is like, what it is to
    have and not to have, and the style of all rooms. Its size is that of its shell, so no sentence says it.

    Args:
        request: as read.
        home: the plan; its rooms that no programme has (stairs are left out) get a sentence by their type. None: the
            rooms of the programme.
        told_only: leave out the rooms of which the request says no more than their kind.

    Examples:
        >>> from sceneweaver.language.homes import read_home, room_requests
        >>> asked = read_home("a rustic flat with two bedrooms and a crib in the parents' bedroom")
        >>> room_requests(asked, told_only=True)
        {'bedroom': "A rustic parents' bedroom for two people with a crib."}
    """
    asked = {room.id: room for room in request.rooms}
    types = {room.id: room.type for room in (home.rooms if home is not None else request.programme.rooms)}
    found: dict[str, str] = {}
    for name, kind in types.items():
        room = asked.get(name) or _by_type(name, kind)
        if room is None or (kind in room_types() and room_types()[kind].furnish is None):
            continue
        own = room.whose or room.looks or room.wishes or room.unwanted
        if own or not told_only:
            found[name] = sentence(room, request.styles)
    return found


def sentence(room: RoomAsked, styles: tuple[str, ...] = ()) -> str:
    """The sentence of one room."""
    before = " ".join(dict.fromkeys((*styles[:2], *room.looks)))
    name = f"{before} {room.noun}".strip()
    text = f"{'An' if name[0] in 'aeiou' else 'A'} {name}"
    wishes = list(room.wishes)
    if room.whose and not any(wish.startswith("for ") for wish in wishes):
        text += f" for {room.whose}"
    said = [wish if wish.split()[0] in _TIES else f"with {_counted(wish)}" for wish in wishes]
    for k, wish in enumerate(said):
        text += f" {wish}" if k == 0 else f", {wish}"
    text += "."
    if room.unwanted:
        text += f" No {', no '.join(room.unwanted)}."
    return text


def _counted(wish: str) -> str:
    """A thing that is named bare gets its article: "crib" is "a crib"."""
    first, last = wish.split()[0], wish.split()[-1]
    if (
        first in ("a", "an", "the", "two", "three", "four", "five", "six", "some")
        or first[0].isdigit()
        or last.endswith("s")
    ):
        return wish
    return f"{'an' if first[0] in 'aeiou' else 'a'} {wish}"


def _by_type(name: str, kind: str) -> RoomAsked | None:
    """A room that the plan added."""
    if kind not in room_types():
        return RoomAsked(name, kind.replace("_", " "), assumed=True)
    furnish = room_types()[kind].furnish
    return None if furnish is None else RoomAsked(name, furnish.replace("_", " "), assumed=True)
