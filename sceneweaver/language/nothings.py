"""Whether a word that no catalogue has may name an object at all."""

from __future__ import annotations

from functools import cache, lru_cache

from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import is_head

from .tokens import looks_adjective
from .vocabulary import vocabulary, words

_FUNCTIONS = ("adverbs", "modal", "person", "action", "passive", "verb", "unit", "stop", "det", "preposition", "aside")
_NAMES = ("noun", "place", "room", "region", "parts", "containers")


@lru_cache(maxsize=4096)
def may_name(noun: str) -> bool:
    """Whether the last word of a noun may be the name of an object.

    The nouns that say what kind of a body a thing has may. What may not: verbs, adverbs, adjectives, people, units,
    events, ideas, and what ends as those do.
    """
    last = noun.split()[-1]
    if is_head(last):
        return True
    kinds = {**vocabulary().get(last, {}), **vocabulary().get(singular(last), {})}
    if kinds.keys() & {*_NAMES}:
        return True
    if kinds.keys() & {*_FUNCTIONS, "matter", "people_words", "whom", "abstract"}:
        return False
    return last.isalpha() and len(last) > 2 and not looks_adjective(last) and not singular(last).endswith(_endings())


@cache
def _endings() -> tuple[str, ...]:
    return tuple(words("nothings")["endings"])
