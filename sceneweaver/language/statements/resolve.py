"""Names in statements as ids of the graph: a noun of the request is the entity that was named by it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any, TypeVar

from sceneweaver.assets.taxonomy import members
from sceneweaver.scene.base import FrozenModel

from ..model import PLACES, Entity, Span
from ..things import match_of, singular
from ..vocabulary import vocabulary

S = TypeVar("S", bound=FrozenModel)

_DETERMINERS = re.compile(r"^(?:the|a|an|this|that|each|every|its|their|my|our)\s+")


def entity_named(words: str, entities: Sequence[Entity], near: Span | None = None) -> str | None:
    """The id of the entity that words mean, or one of `PLACES`; None where the request names no such thing.

    The same noun counts first, then the last word of it, then the category (a "table" is the dining table). Of several
    with the same noun it is the one named nearest to where a statement stands in the request, else the first.
    """
    spoken = _DETERMINERS.sub("", words.strip().lower())
    if spoken.partition(":")[0] in PLACES:
        return spoken
    if any(entity.id == spoken for entity in entities) and (near is None or not spoken.isalpha()):
        return spoken
    noun = singular(spoken)
    for alike in (
        lambda e: singular(e.noun) == noun or singular(e.noun.replace("-", " ")) == singular(spoken.replace("-", " ")),
        lambda e: singular(e.noun).split()[-1] == noun.split()[-1],
        lambda e: noun != spoken and noun in e.noun.split(),  # the islands of island benches
    ):
        found = [entity for entity in entities if entity.noun and alike(entity)]
        if found:
            return min(found, key=lambda e: _apart(e, near)).id
    if noun.split()[-1] in PLACES:  # "the garden window"
        return noun.split()[-1]
    match = match_of(noun)
    names = {match.category, *members(match.category)} if match.how != "generic" else set[str]()
    return next((entity.id for entity in entities if entity.category in names), None)


def _apart(entity: Entity, near: Span | None) -> int:
    """The characters between the words of an entity and a place in the request."""
    if near is None or entity.span is None:
        return 0
    return max(0, near.start - entity.span.end, entity.span.start - near.end)


def is_thing(noun: str) -> bool:
    """Whether a noun names a thing, and no part of the room."""
    last = singular(noun).split()[-1] if noun else ""
    kinds = vocabulary().get(last, {}).keys()
    return bool(last) and not kinds & {"room", "place", "abstract", "region"} and match_of(noun).how != "generic"


def thing_before(text: str, start: int) -> str:
    """The last thing that a sentence names before a place in the text; "" where a part of the room is named later."""
    for word in reversed(re.findall(r"[a-z][a-z'-]*", text[text.rfind(".", 0, start) + 1 : start])):
        kinds = vocabulary().get(word, {}).keys()
        if "noun" in kinds and is_thing(word):
            return word
        if "place" in kinds and "noun" not in kinds:
            return ""
    return ""


def resolved(statements: Sequence[S], entities: Sequence[Entity], prefix: str) -> tuple[S, ...]:
    """Statements with ids of their own and of what they are about; what names nothing keeps its words."""
    found: list[S] = []
    for k, statement in enumerate(statements):
        changed: dict[str, Any] = {"id": f"{prefix}-{k}"}
        for name in ("entity", "target", "facing", "around"):
            words = getattr(statement, name, "")
            if words:
                near = getattr(statement, "span", None) if name in ("entity", "target") else None
                changed[name] = entity_named(words, entities, near) or words
        for name in ("targets", "others"):
            if several := getattr(statement, name, ()):
                changed[name] = tuple(entity_named(words, entities) or words for words in several)
        if own := getattr(statement, "own", ()):
            changed["own"] = tuple((entity_named(words, entities) or words, count) for words, count in own)
        found.append(statement.model_copy(update=changed))
    return tuple(found)


__all__ = ["entity_named", "is_thing", "resolved", "thing_before"]
