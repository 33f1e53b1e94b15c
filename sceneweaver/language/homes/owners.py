"""Whose rooms are alone: "my mother with her own bedroom and bathroom", "mum's bedroom"."""

from __future__ import annotations

from collections.abc import Sequence

from .parts import Named, Reading
from .tokens import Token

KIN = {
    "mother": ("mother", "mum", "mom", "mama", "elderly mother", "grandmother", "grandma", "granny", "gran", "nana"),
    "father": ("father", "dad", "papa", "elderly father", "grandfather", "grandpa", "grandad", "granddad"),
    "mother-in-law": ("mother in law", "mother-in-law", "mum in law", "mil"),
    "father-in-law": ("father in law", "father-in-law"),
    "parents": ("parents", "grandparents", "in laws", "parents in law", "mum and dad", "folks"),
    "partner": (
        "husband",
        "wife",
        "partner",
        "spouse",
        "fiance",
        "fiancee",
        "fianc\u00e9",
        "fianc\u00e9e",
        "boyfriend",
        "girlfriend",
    ),
}
_OWN = ("her", "his", "their", "its")

LISTED = 3
"""Tokens at most between rooms of a list that one "own" is said of."""


def read_owners(reading: Reading) -> None:
    """Says of rooms whose they are: of who is named last before "her own", of whose name stands before them."""
    tokens = reading.tokens
    for sentence in reading.sentences():
        names = sorted((n for n in reading.named if n.at in sentence and n.of is None), key=lambda n: n.at)
        for one in names:
            before = tokens[one.at - 1] if one.at > sentence.start else None
            if before is not None and before.text.endswith("'s"):
                one.owner = kin(before.text.removesuffix("'s"))
            elif tokens[one.at].text.split()[0].endswith("'s") and one.kind.counts_as:
                one.owner = kin(tokens[one.at].text.split("'s")[0])
            elif is_own(tokens[one.first : one.at]) or is_own(tokens[one.last + 1 : one.last + 4]):
                one.owner = next(
                    (whose for t in reversed(tokens[sentence.start : one.first]) if (whose := _whose(t))), ""
                )
        for one, two in zip(names, names[1:], strict=False):
            gap = tokens[one.last + 1 : two.first]
            listed = len(gap) < LISTED and all(t.breaks or t.text == "and" for t in gap)
            if one.owner and listed and not two.owner and _is_list_of(reading, one):
                two.owner = one.owner


def is_own(said: Sequence[Token]) -> bool:
    """Whether words say that a room is somebody's own: "her own", "of their own"."""
    return any(one.text in _OWN and two.text.split()[0] == "own" for one, two in zip(said, said[1:], strict=False))


def _is_list_of(reading: Reading, one: Named) -> bool:
    """Whether a list begins with "her own", so that what follows is hers as well."""
    return not reading.tokens[one.at].text.split()[0].endswith("'s") and not (
        one.at and reading.tokens[one.at - 1].text.endswith("'s")
    )


def _whose(token: Token) -> str:
    return kin(token.text) if token.has("person", "visitors") else ""


def kin(word: str) -> str:
    """One word for those who are called by several; the word itself where nobody is."""
    return next((name for name, words in KIN.items() if word in words), word)
