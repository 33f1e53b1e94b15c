"""Whether a word that no catalogue has may name an object at all."""

from __future__ import annotations

from functools import lru_cache

from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import CERTAIN, is_head, is_no_thing, resolve
from sceneweaver.assets.wordnet import noun_named, of_head

from .vocabulary import vocabulary

_FUNCTIONS = ("adverbs", "modal", "person", "action", "passive", "verb", "unit", "stop", "det", "preposition", "aside")
SHORTEST = 4
"""Letters of each of two words that are written as one."""

_NAMES = ("noun", "containers")


@lru_cache(maxsize=4096)
def may_name(noun: str) -> bool:
    """Whether a noun may be the name of an object, by its last word, or its last two.

    The nouns that say what kind of a body a thing has may, and those that a dictionary has as things. What may not:
    verbs, adverbs, adjectives, people, units, events, ideas, and what no dictionary has.
    """
    last = noun.split()[-1]
    if is_no_thing(noun):
        return False
    if is_head(last):
        return True
    kinds = {**vocabulary().get(last, {}), **vocabulary().get(singular(last), {})}
    if kinds.keys() & {*_NAMES}:
        return True
    if kinds.keys() & {*_FUNCTIONS, "matter", "people_words", "whom", "abstract"}:
        return False
    meant = of_head(noun)
    return meant.is_thing if meant is not None else _joined(singular(last))


def is_large(noun: str) -> bool:
    """Whether a noun is a vehicle or a structure: nothing to put in a room."""
    meant = of_head(noun)
    return meant is not None and meant.is_large


@lru_cache(maxsize=4096)
def is_certain(noun: str) -> bool:
    """Whether a noun that no catalogue has is a thing beyond doubt, so that "the samovar" may be a new one."""
    meant = of_head(noun)
    return meant is not None and meant.is_thing and meant.sure >= CERTAIN and may_name(noun)


def is_word(word: str) -> bool:
    """Whether a dictionary has a word as a noun, it is two of them written as one, or a slip of one that is known."""
    if noun_named(word) is not None or is_head(word) or _joined(singular(word)):
        return True
    return resolve(word).how == "spelling"


def _joined(word: str) -> bool:
    """Whether a word that no dictionary has is two in one, the last of which is a thing: "phonestand"."""
    for k in range(SHORTEST, len(word) - SHORTEST + 1):
        head, first = word[k:], noun_named(word[:k])
        meant = noun_named(head)
        if first is not None and (is_head(head) or (meant is not None and meant.is_thing and meant.sure >= CERTAIN)):
            return True
    return False


@lru_cache(maxsize=4096)
def is_animal(noun: str) -> bool:
    """Whether a noun is an animal: nothing to put in a room, unless it is made of something."""
    meant = of_head(noun)
    return meant is not None and meant.kind == "animal" and not meant.is_thing
