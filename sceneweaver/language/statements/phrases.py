"""What patterns over a request share: numbers, lengths, the noun before or after a place in the text, edits."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache

from ..alternatives import one_of
from ..model import Span
from ..source import Source
from ..vocabulary import NUMBERS, vocabulary, words

_SCORES = {"a couple of": 2, "a pair of": 2, "half a dozen": 6, "a dozen": 12, "two dozen": 24, "dozen": 12}

_VALUES = {**NUMBERS, **_SCORES}

_WORD = re.compile(r"[a-z][a-z'/-]*")

_DETERMINERS = frozenset(
    ("the", "a", "an", "every", "each", "all", "both", "my", "our", "his", "her", "its", "their", "this", "these")
)

_BEFORE = frozenset(("with", "a", "an", "the", "each", "every", "his", "her", "our", "my", "their", "some"))
"""Words behind which a noun phrase begins."""

REACH = 600
"""Characters before a place that are looked at for what is said there; no sentence is longer, an endless text is."""

MOST_WORDS = 4
"""Words that a noun with what stands before it has at most."""


def number_of(word: str) -> int:
    """The value of what `NUMBER` matches."""
    return int(word) if word.isdigit() else _VALUES[word]


def listed(name: str) -> tuple[str, ...]:
    """Words of the lexicon of people and patterns."""
    return tuple(words("people")[name])


NUMBER = rf"(?:\d{{1,3}}|{one_of(_VALUES)})(?!\w|\.\d)"
"""A whole number in digits or words, with nothing that would make another number or word of it."""


@cache
def _closed() -> frozenset[str]:
    return frozenset((*listed("closed"), *listed("prepositions"), *NUMBERS))


_NEXT = re.compile(
    r"\s*(?!(?:back|side|end|head|face)s? (?:to|by) |side-by-side|open(?:ing|ed)? (?:to|towards?)\b)([a-z][a-z'-]*)"
)
"""The next word of a noun, which what says how things are to each other is none of: "seats back to back"."""


def noun_after(text: str, at: int) -> tuple[str, int]:
    """The words of a noun that begin at a place, and where they end; "" where there are none."""
    found: list[str] = []
    end = at
    while len(found) < MOST_WORDS:
        m = _NEXT.match(text, end)
        if m is None or m[1] in _closed():
            break
        found.append(m[1])
        end = m.end()
    return " ".join(found), end


@cache
def _heights() -> re.Pattern[str]:
    """Phrases that say how high something is by naming the floor or the ceiling."""
    return re.compile(rf"\b(?:{'|'.join(sorted(words('measures')['ceiling'], key=len, reverse=True))})\b")


_FOR_SO_MANY = re.compile(
    rf" for (?:about |up to |at least )?{NUMBER}(?: (?:people|persons|guests|kids|children|of us))?,?\s*$"
)
"""For how many a thing is, between it and what is said of it: "a jury box for twelve in two rows"."""


def noun_before(text: str, at: int) -> str:
    """The noun of the sentence that something at a place is said of: the last one before it that no preposition ties
    to another ("four benches from wood" are benches). How high it is, "from floor to ceiling", names nothing."""
    text = _heights().sub(lambda m: " " * len(m[0]), text[max(0, at - REACH) : at])
    text = _FOR_SO_MANY.sub(lambda m: " " * len(m[0]), text)
    start = max(text.rfind("."), text.rfind("(")) + 1
    chunks: list[tuple[str, list[str]]] = [("", [])]
    for m in re.finditer(r"[a-z][a-z'/-]*|\d+|[,)]", text[start:]):
        tied = not chunks[-1][1] and chunks[-1][0] in listed("prepositions")
        if tied and m[0] in _DETERMINERS:
            continue  # "on every surface": the preposition ties the noun behind the article
        if m[0] in _closed() or not _WORD.fullmatch(m[0]):
            chunks.append((m[0], []))
        else:
            chunks[-1][1].append(m[0])
    near = chunks[-1][1] and chunks[-1][0] in ("with", "w/")  # "a room with crates stacked three high"
    said = [(before, found) for before, found in chunks if found]
    free = [found for before, found in said if before not in listed("prepositions")]
    free += [chunks[-1][1]] if near else []
    chosen = (free or [found for _, found in said] or [[]])[-1]
    return " ".join(chosen[-MOST_WORDS:])


def noun_at(text: str, start: int, end: int) -> tuple[str, bool]:
    """The noun that something between two places is said of, and whether it comes after."""
    before = re.search(r"([a-z0-9']+|[,.(])[\s-]*$", text[max(0, start - REACH) : start])
    said = before[1] if before is not None else "."
    follows = re.match(r"[\s,-]*([a-z]+)", text[end:])
    plain = follows is not None and follows[1] not in listed("closed") and follows[1] not in listed("prepositions")
    plain = plain and not (follows and vocabulary().get(follows[1], {}).keys() & {"while", "stop", "neg", "pron"})
    behind = said in _BEFORE or said in NUMBERS or said.isdigit() or (said in ",.(" and text[end : end + 1] != ",")
    behind = behind or not vocabulary().get(said, {"noun": 1}).keys() & {"noun", "plural", "verb", "parts", "stop"}
    if plain and behind:
        noun, _ = noun_after(text, end + len(re.match(r"[\s,-]*", text[end:])[0]))  # type: ignore[index]
        if noun:
            return noun, True
    return noun_behind(text, start), False


def noun_behind(text: str, start: int) -> str:
    """As `noun_before`; where a place is at the beginning of a bracket the noun before that."""
    near = max(0, start - 41)
    bracket = re.search(r"\([^()]{0,40}$", text[near:start])
    return noun_before(text, start) or (noun_before(text, near + bracket.start()) if bracket is not None else "")


def table_before(text: str, at: int) -> str:
    """The last thing in the sentence before a place at which people sit or work; "" where none is named."""
    start = max(text.rfind(".", 0, at), text.rfind("(", 0, at)) + 1
    tables = words("people")["at"]
    names = one_of([*tables["work"], *(noun for noun in tables["sit"] if "table" in noun)])
    found = re.findall(rf"\b{names}\b", text[start:at])
    return found[-1] if found else ""


@dataclass
class Edits:
    """What a reader takes out of the source or puts into it, in place: the length of the text stays the same."""

    source: Source
    _taken: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])

    def free(self, start: int, end: int) -> bool:
        """Whether nothing of these characters was taken yet."""
        return all(end <= a or start >= b for a, b in self._taken)

    def take(self, start: int, end: int, instead: str = "") -> Span:
        """Blanks characters [start, end), or puts shorter words in their place; where they stand in the request."""
        text = self.source.text
        self.source.text = text[:start] + instead[: end - start].ljust(end - start) + text[end:]
        self._taken.append((start, end))
        return self.source.span(start, end)
