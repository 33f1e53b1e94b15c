"""What a plain noun means in a kind of room: a wheel in a pottery, bags in a boxing gym, a bench in a courtroom.

What knowledge of a kind of room holds (its kit) decides: a noun is one of the things there that are called so. What
something stands on is the stand of that thing first of all, whatever the room.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import likeliness, phrases, resolve
from sceneweaver.knowledge.kin import families
from sceneweaver.knowledge.load import room_types

from .parsed import Mention, Parsed, Said
from .things import match_of
from .vocabulary import vocabulary, words

_CARRIED = ("on", "inside", "hanging_from")
"""Relations by which one thing carries another."""

_NEEDS = ("needed", "usual", "optional")
"""How much a room needs a thing, most first."""


def mean_in_room(mentions: Sequence[Mention], parsed: Parsed, text: str) -> None:
    """Give plain nouns the category that the kind of room has and that is called so, where it has nothing plainer.

    A noun is plain where its last word alone would mean the same. What the request names in full stays as it is, and
    so does what the room has of its own, or what people count as one with what the room needs.

    Args:
        mentions: what the request names; their categories change.
        parsed: what else it says: the kind of room, where things are. Notes on what is known after all are taken out.
        text: the request in lower case.
    """
    room, held = parsed.room_type, _held(parsed.said)
    named = {mention.category for mention in mentions}
    known = room is not None and room in room_types()
    for mention in mentions:
        head = singular(mention.noun).rpartition(" ")[2]
        meant = _stand_of(mention, head, held.get(mention, ()))
        if meant is None and known and _is_plain(mention, head) and mention.category not in _kit(room):
            meant = _in_kit(room, mention, head, named, held.get(mention, ()), text)
        if meant is not None and not _kin(meant, mention.category, head):
            note = match_of(mention.noun).note
            parsed.notes[:] = [other for other in parsed.notes if other != note]
            mention.category, mention.generic = meant, False


def is_called_in(room: str | None, noun: str) -> bool:
    """Whether a kind of room has something that is called by a noun, so that the noun names a thing there."""
    head = singular(noun).rpartition(" ")[2]
    return room is not None and room in room_types() and any(name.endswith(f"_{head}") for name in _called(room, head))


def _is_plain(mention: Mention, head: str) -> bool:
    """Whether a noun says no more of its kind than its last word does."""
    parts = mention.noun.partition(" of ")[0].split()
    if any("noun" in vocabulary().get(" ".join(parts[k:]), {}) for k in range(len(parts) - 1)):
        return False
    return mention.generic or resolve(head).category == mention.category


@cache
def _kit(room: str) -> Mapping[str, int]:
    """The categories of a kind of room, each with how much it is needed: 0 most. The usual of several comes first."""
    found: dict[str, int] = {}
    for item in room_types()[room].items:
        for k, name in enumerate(item.what):
            rank = 2 * _NEEDS.index(item.need) + min(k, 1)
            found[name] = min(rank, found.get(name, rank))
    return found


@cache
def _called(room: str, head: str) -> tuple[str, ...]:
    """The categories of a kind of room that are called by a word, most needed first: their name ends in it, or it is
    what people call them."""
    kit, kinds = _kit(room), words("nouns")["kinds"].get(head, ())
    found = [name for name in kit if name.endswith(f"_{head}") or name in kinds]
    return tuple(sorted(found, key=lambda name: kit[name]))


def _in_kit(
    room: str, mention: Mention, head: str, named: Container[str], held: Sequence[Mention], text: str
) -> str | None:
    """What a noun means by a room's kit; None where it keeps its usual meaning.

    A noun with a meaning of its own gives it up for the one thing that the room needs and that ends in it; one that no
    catalogue has, or that is but another name of some kind of thing ("bag" of a handbag), for what the room has.
    """
    usual, kit = resolve(head), _kit(room)
    alone = mention.noun.partition(" of ")[0].count(" ") == 0
    found = [name for name in _called(room, head) if name not in named and _may_hold(name, head, held)]
    if not (mention.generic and alone):
        found = [name for name in found if name.endswith(f"_{head}")]
    if not alone or (not mention.generic and usual.category.endswith(head)):
        found = [name for name in found if kit[name] == 0]  # a bin is a trash can, but a handbag is a bag
    own = not alone or (not mention.generic and (usual.how == "exact" or head in usual.category.split("_")))
    if not found or (own and len(found) > 1):
        return None
    first = [name for name in found if kit[name] == kit[found[0]]]
    return min(first, key=lambda name: _distance(name, head, mention, text))


def _distance(category: str, head: str, mention: Mention, text: str) -> int:
    """Characters between a noun and the nearest word that makes it a category: of "racks" that they are for bottles."""
    start = mention.span.start if mention.span is not None else 0
    known = categories()[category]
    names = [name for name in (known.words, *known.synonyms) if singular(name).endswith(head)]
    telling = {word for name in names for word in name.removesuffix(head).split()}
    places = [at for word in telling for at in _places(text, word)]
    return min((abs(at - start) for at in places), default=len(text))


def _places(text: str, word: str) -> Iterable[int]:
    at = text.find(word)
    while at >= 0:
        yield at
        at = text.find(word, at + 1)


def _held(said: Iterable[Said]) -> Mapping[Mention, list[Mention]]:
    """What is said to stand or hang on or in each thing."""
    found: dict[Mention, list[Mention]] = {}
    for one in said:
        for target in one.targets if one.type in _CARRIED and not one.implied else ():
            if isinstance(target, Mention):
                found.setdefault(target, []).extend(one.subjects)
    return found


def _stand_of(mention: Mention, head: str, held: Sequence[Mention]) -> str | None:
    """What a plain noun means by what is on it: the stand of a plant is a plant stand."""
    if not mention.generic or len(mention.noun.split()) > 1:
        return None
    for one in held:
        for name in (one.category.replace("_", " "), singular(one.noun)):
            meant = phrases().get(f"{name} {head}")
            if meant is not None and meant in categories() and categories()[meant].size is not None:
                return meant
    return None


def _may_hold(category: str, head: str, held: Sequence[Mention]) -> bool:
    """Whether what is said to be on a thing may be: no bird cage is on a TV stand."""
    made_for = category.removesuffix(f"_{head}").split("_")
    return not held or any(
        likeliness(one.category, category) is not None
        or any(word in one.category.split("_") or word in singular(one.noun).split() for word in made_for)
        for one in held
    )


def _kin(one: str, other: str, word: str) -> bool:
    """Whether people count two categories as one kind, or mean the kind of the first by a word anyway."""
    kinds, meant = families()
    return any(one in family and (other in family or name in meant.get(word, ())) for name, family in kinds.items())
