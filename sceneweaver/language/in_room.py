"""What a plain noun means in a kind of room: a wheel in a pottery, bags in a boxing gym, a bench in a courtroom.

What knowledge of a kind of room holds (its kit) decides: a noun is one of the things there that are called so. What
something stands on is the stand of that thing first of all, whatever the room.
"""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import likeliness, phrases, resolve
from sceneweaver.knowledge.kin import families
from sceneweaver.knowledge.load import room_types

from .parsed import Mention, Parsed, Said
from .things import match_of
from .vocabulary import mounts, vocabulary, words

_CARRIED = ("on", "inside", "hanging_from")
"""Relations by which one thing carries another."""

_BESIDE = 30
"""Characters before and after a noun in which it is told what it is for, or what is on it."""

_OWNER = "(?:the |a |an |my |his |her |our |its |their )?"
_FOR = re.compile(
    rf"(?P<noun>[a-z]+) (?:for|of) {_OWNER}(?P<what>[a-z]+)(?= ?(?:[,.;:!?)]|$| and\b| on\b| in\b| by\b))"
)
_ON_IT = re.compile(rf"\b(?P<what>[a-z]+) on {_OWNER}(?:[a-z]+ )?$")

_NEEDS = ("needed", "usual", "optional")
"""How much a room needs a thing, most first."""


@dataclass(frozen=True)
class _Noun:
    """A noun to resolve: its mention, its last word, and what is said to be on or in it: categories with nouns."""

    mention: Mention
    head: str
    held: Sequence[tuple[str, str]]
    text: str

    @property
    def alone(self) -> bool:
        """Whether it is of one word."""
        return " " not in self.mention.noun.partition(" of ")[0]

    @property
    def plain(self) -> bool:
        """Whether it says no more of its kind than its last word does."""
        parts = self.mention.noun.partition(" of ")[0].split()
        if any("noun" in vocabulary().get(" ".join(parts[k:]), {}) for k in range(len(parts) - 1)):
            return False
        return self.mention.generic or resolve(self.head).category == self.mention.category

    @property
    def own(self) -> bool:
        """Whether it is the very name of a kind of things, of which a room may have narrower ones."""
        usual = resolve(self.head)
        return not self.mention.generic and (usual.how == "exact" or self.head in usual.category.split("_"))


def mean_in_room(mentions: Sequence[Mention], parsed: Parsed, text: str) -> None:
    """Give plain nouns the category that the kind of room has and that is called so, where it has nothing plainer.

    A noun is plain where its last word alone would mean the same. What the request names in full stays as it is, and
    so does what the room has of its own, or what people count as one with what the room needs.

    Args:
        mentions: what the request names; their categories change.
        parsed: what else it says: the kind of room, where things are. Notes on what is known after all are taken out.
        text: the request in lower case.
    """
    held = _held(parsed.said)
    named = {mention.category for mention in mentions}
    for mention in mentions:
        head = singular(mention.noun.partition(" of ")[0]).rpartition(" ")[2]
        noun = _Noun(mention, head, held.get(mention) or _told_of(mention, head, text), text)
        meant = _for_what(noun, parsed.room_type) or _stand_of(noun) or _in_room(noun, parsed, named)
        if meant is not None and not _kin(meant, mention.category, head if noun.own else ""):
            note = match_of(mention.noun).note
            parsed.notes[:] = [other for other in parsed.notes if other != note]
            mention.category, mention.generic = meant, False


def is_called_in(parsed: Parsed, noun: str, several: bool = False) -> bool:
    """Whether the kind of room that was named has something that is called by a noun, so that it names a thing there:
    the ring of a boxing gym; of several, whether the name of the room makes a thing of it: the trains of a toy shop."""
    room, head = parsed.room_type, singular(noun).rpartition(" ")[2]
    if room is None or room not in room_types():
        return False
    called = any(name.endswith(f"_{head}") for name in _called(room, head))
    return called or (several and _compound(parsed.room_words.split()[:-1], head) is not None)


def _in_room(noun: _Noun, parsed: Parsed, named: Container[str]) -> str | None:
    """What a noun means by the kind of room; None where it keeps its usual meaning."""
    room = parsed.room_type
    if not noun.plain:
        return None
    if not noun.own and (meant := _compound(parsed.room_words.split()[:-1], noun.head)) is not None:
        return meant  # the frame of a quilting studio is a quilting frame
    if room is None or room not in room_types() or noun.mention.category in _kit(room):
        return None
    return _in_kit(room, noun, named)


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


def _in_kit(room: str, noun: _Noun, named: Container[str]) -> str | None:
    """What a noun means by a room's kit; None where it keeps its usual meaning.

    A noun with a meaning of its own gives it up for the one thing that the room needs and that ends in it; one that no
    catalogue has, or that is but another name of some kind of thing ("bag" of a handbag), for what the room has.
    """
    kit, head, generic = _kit(room), noun.head, noun.mention.generic
    found = [name for name in _called(room, head) if name not in named and _may_hold(name, noun)]
    if not (generic and noun.alone):
        found = [name for name in found if name.endswith(f"_{head}")]
    if not noun.alone or (not generic and resolve(head).category.endswith(head)):
        found = [name for name in found if kit[name] == 0]  # a bin is a trash can, but a handbag is a bag
    if not found or (len(found) > 1 and (noun.own or not noun.alone)):
        return None
    first = [name for name in found if kit[name] == kit[found[0]]]
    return min(first, key=lambda name: _distance(name, noun))


def _distance(category: str, noun: _Noun) -> int:
    """Characters between a noun and the nearest word that makes it a category: of "racks" that they are for bottles."""
    start = noun.mention.span.start if noun.mention.span is not None else 0
    known = categories()[category]
    names = [name for name in (known.words, *known.synonyms) if singular(name).endswith(noun.head)]
    telling = {word for name in names for word in name.removesuffix(noun.head).split()}
    places = [at for word in telling for at in _places(noun.text, word)]
    return min((abs(at - start) for at in places), default=len(noun.text))


def _places(text: str, word: str) -> Iterable[int]:
    at = text.find(word)
    while at >= 0:
        yield at
        at = text.find(word, at + 1)


def _held(said: Iterable[Said]) -> Mapping[Mention, list[tuple[str, str]]]:
    """What is said to stand or hang on or in each thing: categories with nouns."""
    found: dict[Mention, list[tuple[str, str]]] = {}
    for one in said:
        for target in one.targets if one.type in _CARRIED else ():
            if isinstance(target, Mention):
                found.setdefault(target, []).extend(
                    (each.category, singular(each.noun))
                    for each in one.subjects
                    if not one.implied or "surface" in mounts(each.category)
                )
    return found


def _told_of(mention: Mention, head: str, text: str) -> list[tuple[str, str]]:
    """What is on a thing, or what it is for, by the words beside it where no relation was read: a "cage on a stand"."""
    if mention.span is None:
        return []
    told = _ON_IT.search(text[max(0, mention.span.start - _BESIDE) : mention.span.start].split("\n")[-1])
    what = told["what"] if told is not None else _what_for(mention, head, text)
    match = resolve(what) if what else None
    return [(match.category, singular(what))] if match is not None and match.how not in ("generic", "spelling") else []


def _what_for(mention: Mention, head: str, text: str) -> str:
    """What a thing is said to be for or of: "a block for knives"; empty where nothing is said."""
    if mention.span is None:
        return ""
    said = _FOR.search(text[mention.span.start : mention.span.end + _BESIDE])
    return said["what"] if said is not None and singular(said["noun"]) == head else ""


def _compound(before: Iterable[str], head: str) -> str | None:
    """The category of the first known name that ends in a noun and begins with one of some words."""
    for word in before:
        meant = phrases().get(f"{word} {head}")
        if meant is not None and meant in categories() and categories()[meant].size is not None:
            return meant
    return None


def _for_what(noun: _Noun, room: str | None) -> str | None:
    """What a noun means by what is said to be in or on it: a block for knives is a knife block.

    The name of a kind of things gives it up for what the room has alone (a box for gloves is no laboratory's glove
    box), and so does what is for a thing of several meanings: a rack for sheets is not for those of metal.
    """
    what = _what_for(noun.mention, noun.head, noun.text) if noun.alone else ""
    meant = _compound((singular(what), what), noun.head) if what else None
    certain = not noun.own and singular(what) not in words("senses")
    return meant if certain or (room in room_types() and meant in _kit(room)) else None


def _stand_of(noun: _Noun) -> str | None:
    """What a noun means by what is on it: the stand of a fern is a plant stand."""
    if not (noun.mention.generic and noun.alone):
        return None
    kinds = words("nouns")["kinds"]
    for category, name in noun.held:
        above = [kind for kind, names in kinds.items() if category in names]
        spoken = (word.replace("_", " ") for word in (category, name, *above))
        if (meant := _compound(spoken, noun.head)) is not None:
            return meant
    return None


def _may_hold(category: str, noun: _Noun) -> bool:
    """Whether what is said to be on a thing may be: no bird cage is on a TV stand."""
    made_for = category.removesuffix(f"_{noun.head}")
    if not noun.held or made_for.replace("_", " ") not in phrases():
        return True
    return any(
        likeliness(one, category) is not None or not {*one.split("_"), *name.split()}.isdisjoint(made_for.split("_"))
        for one, name in noun.held
    )


def _kin(one: str, other: str, word: str) -> bool:
    """Whether people count two categories as one kind, or mean the kind of the first by a word anyway."""
    kinds, meant = families()
    return any(one in family and (other in family or name in meant.get(word, ())) for name, family in kinds.items())
