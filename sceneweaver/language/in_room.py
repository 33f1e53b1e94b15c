"""What a plain noun means in a kind of room: a wheel in a pottery, a bin in a record shop, a bench in a courtroom."""

from __future__ import annotations

from collections.abc import Container
from functools import cache

from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import resolve
from sceneweaver.knowledge.kin import families
from sceneweaver.knowledge.load import room_types

from .parsed import Mention


def mean_in_room(mentions: list[Mention], room: str | None) -> None:
    """Give plain nouns the category that the kind of room needs and that is called so, where it has nothing plainer.

    A noun is plain where its last word alone would mean the same. What the request names in full stays as it is, and
    so does what the room has of its own, or what people count as one with what the room needs.
    """
    if room is None or room not in room_types():
        return
    named = {mention.category for mention in mentions}
    for mention in mentions:
        head = singular(mention.noun).rpartition(" ")[2]
        if mention.category not in _belongs(room) and (mention.generic or resolve(head).category == mention.category):
            meant = _needed(room, head, named)
            if meant is not None and not _kin(meant, mention.category, head):
                mention.category, mention.generic = meant, False


@cache
def _belongs(room: str) -> frozenset[str]:
    """The categories of a kind of room."""
    return frozenset(name for item in room_types()[room].items for name in item.what)


def _needed(room: str, head: str, named: Container[str]) -> str | None:
    """The one usual category of what a room needs whose name ends in a word and that is not named otherwise."""
    usual = {item.what[0] for item in room_types()[room].items if item.need == "needed"}
    found = [name for name in usual if name.endswith(f"_{head}") and name not in named]
    return found[0] if len(found) == 1 else None


def _kin(one: str, other: str, word: str) -> bool:
    """Whether people count two categories as one kind, or mean the kind of the first by a word anyway."""
    kinds, meant = families()
    return any(one in family and (other in family or name in meant.get(word, ())) for name, family in kinds.items())
