"""An analysis beside what the rules read of the same request: which mention is which."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from ..model import Span
from ..parsed import Mention, Parsed
from ..source import Source
from .analysis import Analysis, Link
from .labels import LINKS, WHERE

SURE, SURER = 0.55, 0.8
"""How sure a link is that is added; where the rules took its words for something else."""

DOUBTED, UNSAID = 0.1, 0.02
"""How sure the analysis is at most of what is taken back: what was counted out over a group, and a relation that only
follows from "with". What the rules read in so many words stays."""

CERTAIN = 0.85
"""How sure it is of a thing that the rules did not read, or of what they took for one."""

_FIRST = LINKS.index(WHERE[0])
_WHERE = slice(_FIRST, _FIRST + len(WHERE))
_EACH = LINKS.index("each")


@dataclass
class Matched:
    """What two readings have of one request.

    Attributes:
        text: the request.
        source: it as the rules read it.
        parsed: what the rules read.
        found: what the network found.
        things: the mention of the rules for each thing of the analysis, by its number.
    """

    text: str
    source: Source
    parsed: Parsed
    found: Analysis
    things: dict[int, Mention] = field(init=False, default_factory=dict[int, Mention])

    def __post_init__(self) -> None:
        # of several things on the same words it is the one that ends where the other does
        for number, named in enumerate(self.found.named):
            over = [m for m in self.parsed.mentions if overlap(m.span, named.span)]
            if named.kind == "thing" and over:
                self.things[number] = min(over, key=lambda m: abs(m.span.end - named.span.end) if m.span else 0)

    def kind(self, number: int) -> str:
        """Of a mention of the analysis."""
        return self.found.named[number].kind

    def span(self, number: int) -> Span:
        """Where a mention of the analysis stands."""
        return self.found.named[number].span

    def words(self, number: int) -> str:
        """Its words, small."""
        span = self.span(number)
        return self.text[span.start : span.end].lower()

    def where(self) -> Iterator[tuple[Link, int, int]]:
        """Links that say where a thing is, the thing, and what it is placed by, references resolved."""
        for link in self.found.links:
            if link.name in WHERE and link.other >= 0:
                one, other = self.found.meant(link.one), self.found.meant(link.other)
                if one != other and self.kind(one) == "thing":
                    yield link, one, other

    def related(self, ones: list[Mention], others: list[Mention]) -> float | None:
        """How sure the analysis is at most that one of some things is placed by one of others or belongs to each of
        them, either way about; None where it lacks one of them."""
        one, other = self._numbers(ones), self._numbers(others)
        if any(not self._numbers([mention]) for mention in (*ones, *others)):
            return None
        pairs = [pair for a in one for b in other if a != b for pair in ((a, b), (b, a))]
        shares = self.found.shares
        sure = (max(float(shares[a + 1, b + 1, _WHERE].max()), float(shares[a + 1, b + 1, _EACH])) for a, b in pairs)
        return max(sure, default=None)

    def each(self, owner: Mention, thing: Mention) -> float | None:
        """How sure it is at most that each of some owners has the thing; None where it lacks one of them."""
        pairs = [(a, b) for a in self._numbers([owner]) for b in self._numbers([thing]) if a != b]
        return max((float(self.found.shares[a + 1, b + 1, _EACH]) for a, b in pairs), default=None)

    def _numbers(self, mentions: list[Mention]) -> list[int]:
        own = [number for number, mention in self.things.items() if mention in mentions]
        again = [k for k, named in enumerate(self.found.named) if named.kind == "reference"]
        return [*own, *(k for k in again if self.found.meant(k) in own)]


def overlap(one: Span | None, other: Span | None) -> bool:
    """Whether two pieces of the text have a character in common."""
    return one is not None and other is not None and one.start < other.end and other.start < one.end


def below(sure: float | None, least: float) -> bool:
    """Whether the analysis holds something for less sure than that; not where it knows nothing of it."""
    return sure is not None and sure < least
