"""What English nouns are: things of which kind, or no things at all; a table derived from WordNet, see ``NOTICE``.

``python -m benchmarks nouns`` writes the table.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Literal

from sceneweaver.io import packaged

from ..plurals import singular

Near = Literal["same", "kind", "wide", "like", ""]

LARGE = frozenset(("vehicle", "structure"))
"""Kinds of what can be touched and stands in no room, or is the room itself."""

NOTHING = frozenset(("substance", "person", "animal", "body", "place", "part", "event", "abstract"))
"""Kinds of what is no object of its own."""

SURE = 4
"""Tenths of its use from which a noun is a thing."""

_GZIP = 31  # zlib's code for "with the header of gzip"


@dataclass(frozen=True)
class Noun:
    """What a noun names.

    ``sure`` is in how many tenths of its use it is a thing that can stand in a room. ``category`` is the one whose body
    may stand for it, because it is another name of it (``near`` is "same"), a kind of it ("kind"), what it is a kind of
    ("wide"), or of the same kind and use ("like"); empty where none is near.
    """

    kind: str
    sure: int
    category: str = ""
    near: Near = ""

    @property
    def is_thing(self) -> bool:
        """Whether it is a thing that can stand in a room, as it is mostly used."""
        return self.sure >= SURE and self.kind not in NOTHING and self.kind not in LARGE

    @property
    def is_large(self) -> bool:
        """Whether it is a vehicle or a structure: nothing to put in a room."""
        return self.sure < SURE and self.kind in LARGE


@lru_cache(maxsize=4096)
def noun_named(words: str) -> Noun | None:
    """What a noun of one or two words is, singular or plural; None where it is not known as a noun.

    Examples:
        >>> from sceneweaver.assets.wordnet import noun_named
        >>> noun_named("tankards").kind, noun_named("justice").is_thing
        ('vessel', False)
    """
    table, asked = _table()[0], words.lower().replace("-", " ")
    forms = (table.get(form.replace(" ", "_")) for form in (asked, singular(asked)))
    found = [row for row in forms if row is not None]  # "hooks" are more often hooks than what "hooks" alone means
    return max(found, key=lambda row: row.sure, default=None)


@lru_cache(maxsize=4096)
def of_head(noun: str) -> Noun | None:
    """What a noun of any number of words is: by its last two words, else by its last."""
    words = noun.lower().replace("-", " ").split()
    for k in (2, 1):
        found = noun_named(" ".join(words[-k:])) if len(words) >= k else None
        if found is not None:
            return found
    return None


def kinds_above(category: str) -> tuple[str, ...]:
    """The words for a category and for all that it is a kind of, the nearest first; none for one that is not known.

    Examples:
        >>> from sceneweaver.assets.wordnet import kinds_above
        >>> "computer" in kinds_above("laptop")
        True
    """
    return _table()[1].get(category, ())


@cache
def of_kind(word: str) -> frozenset[str]:
    """The categories that a noun is a word for, or for what they are a kind of."""
    asked = singular(word.lower().replace("-", " ")).replace(" ", "_")
    return frozenset(name for name, words in _table()[1].items() if asked in words)


@cache
def _table() -> tuple[dict[str, Noun], dict[str, tuple[str, ...]]]:
    """Nouns with what they are, and for each category the words above it."""
    file = packaged.folder(__package__ or "").joinpath("nouns.txt.gz")
    nouns, above = zlib.decompress(packaged.bytes_of(file), _GZIP).decode().split("\n\n")
    table: dict[str, Noun] = {}
    for line in nouns.splitlines():
        kind, sure, category, near, words = line.split(" ", 4)
        row = Noun(kind, int(sure), category.strip("-"), near.strip("-"))  # type: ignore[arg-type]
        table.update(dict.fromkeys(words.split(" "), row))
    rows = (line.split(" ") for line in above.splitlines())
    return table, {name: tuple(words) for name, *words in rows}
