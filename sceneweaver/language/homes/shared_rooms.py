"""Rooms by those who use them: one open room for all, one for each, one more for us."""

from __future__ import annotations

from collections.abc import Sequence

from .lexicon import plain
from .parts import Named, Reading
from .tokens import Token

PLACES_TO_WORK = ("desk", "hot desk", "workplace", "workstation")
"""Names of places to work: many of them are in one room."""

SPACES = ("room", "space", "area", "hall", "office")
"""What an open room for many is called."""

_IN_ONE = ("a", "in one", "single", "the", "same")


def is_open(tokens: Sequence[Token], at: int, single: str) -> bool:
    """ "One open room", "eight people in one large space": where all who are named work together."""
    if single not in SPACES:
        return False
    start = at
    while start and (tokens[start - 1].has("size", "soft", "own", "number") or tokens[start - 1].text in _IN_ONE):
        start -= 1
    said = {word for t in tokens[start:at] for word in t.text.split()}
    if said & {"open", "open-plan"}:
        return True
    if not said & {"one", "single", "same"}:
        return False
    inside = "in" in said or start > 0 and tokens[start - 1].text == "in"
    before = tokens[max(0, start - 6) : start]
    return inside and any(t.has("person", "staff") or plain(_single(t)) in PLACES_TO_WORK for t in before)


def for_each(reading: Reading, at: int) -> bool:
    """ "A room for each of them": a bedroom for everybody who has none yet."""
    tokens = reading.tokens
    if reading.use.plan not in ("flat", "house") or tokens[at].text not in ("room", "bedroom") or at + 2 >= len(tokens):
        return False
    if any(t.number is not None and t.number > 1 for t in tokens[max(0, at - 2) : at]) or tokens[at].plural:
        return False
    one, two = tokens[at + 1], tokens[at + 2]
    if one.text == "each" and two.text == "for":
        return True  # "a bedroom each for me and my brother"
    return one.text == "for each" or one.text == "for" and two.text.split()[0] == "each"


def one_more_for(reading: Reading, last: Named, at: int) -> bool:
    """ "A bedroom for each of the boys and one for us": whose bedroom is one more."""
    tokens = reading.tokens
    if last.told != "each" or at + 2 >= len(tokens) or tokens[at + 1].text != "for" or tokens[at + 2].has("each"):
        return False
    return tokens[at - 1].text in ("and", ",", "plus") and tokens[at + 2].has("we", "me", "person")


def in_its_own(tokens: Sequence[Token], at: int) -> bool:
    """ "The kiln in its own locked room": no room more than the one that is named so."""
    return any(tokens[k].text == "its" and tokens[k - 1].text == "in" for k in range(max(1, at - 4), at))


def _single(token: Token) -> str:
    from sceneweaver.assets.plurals import singular

    return singular(token.text) if token.plural else token.text
