"""Where the reader of clauses is, and what it has in hand."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from .chunks import Chunk, NounPhrase
from .model import Span
from .parsed import Left, Mention, Parsed
from .references import REACH, References
from .source import Source
from .vocabulary import Place

Fronted = tuple[Place, tuple[Any, ...], Chunk]
"""A word of place with its targets, said ahead of who it is about."""


@dataclass
class Frame:
    """An open list: what is named in it is there ("list"), comes with its owner, or is placed by a verb.

    ``numbered`` are the nouns of the items that have a number.
    """

    kind: str
    owner: list[Mention] = field(default_factory=list)
    type: str = ""
    words: str = ""
    items: list[Mention] = field(default_factory=list)
    finite: bool = False
    each: bool = False
    closed: bool = False
    """Whether "and" named its last item."""
    nth: int = 0
    """Which one of its owner, in order, it is about."""
    numbered: list[str] = field(default_factory=list)
    fronted: list[Fronted] = field(default_factory=list)

    @property
    def fronted_on(self) -> list[Mention]:
        """The things among the targets of its places."""
        return [t for _, targets, _ in self.fronted for t in targets if isinstance(t, Mention)]

    @property
    def is_fronting(self) -> bool:
        """Whether its places came before its items and no verb between: "on the desk a lamp"."""
        return self.kind == "fronted" and not self.finite


@dataclass
class Waiting:
    """A word of place that waits for its target; without subjects these come after it."""

    place: Place
    subjects: list[Mention] | None
    chunk: Chunk
    count: tuple[int, int] | None = None
    first: Mention | None = None
    lost: bool = False
    barred: bool = False
    """Whether it says where something must not be."""


class State:
    """Where the reader of clauses is, and what it has in hand."""

    def __init__(self, chunks: list[Chunk], source: Source, parsed: Parsed):
        self.chunks, self.source, self.out = chunks, source, parsed
        self.refs = References(parsed)
        self.at = 0
        self.names_a_room = any(self._is_noun(k) and c.value.what == "room" for k, c in enumerate(chunks))
        self.party: list[Mention] = []  # the things of the part of the room that was named last
        self.surface: Mention | None = None  # what the small things of the sentence stand on
        self.surface_words, self.started, self.begun = "", 0, 0
        self.last_subjects: list[Mention] = []
        self.begin()

    def begin(self) -> None:
        """A sentence begins: nothing is open."""
        self.subject: list[Mention] = []  # who the clause is about
        self.head: list[Mention] = []  # what a word of place is said of
        self.previous: list[Mention] = []  # the item before, or who the clause before was about
        self.first_items: list[Mention] = []  # what was named first in the clauses of the sentence
        self.frames: list[Frame] = []  # open lists, the outermost one first
        self.fronted: list[Fronted] = []  # said ahead of who it is about
        self.waiting: Waiting | None = None
        self.glue = "start"  # what binds the next phrase: start, comma, and, or, while, open, object, verb, or nothing
        self.joined = ""  # what bound the last item to the one before
        self.manner = ""  # what the verb adds to a word of place: hang, lean, center, mount
        self.negated = ""  # whether what follows must not be there: first, list, article, where
        self.negation = ""  # the word that says so
        self.unwanted: list[Mention] = []  # what must not be where the next words of place say
        self.total: tuple[int, int] | None = None  # how many things there are of the kinds that are listed next
        self.per_person = False  # whether what is named is there for every one of the people
        self.barred = False  # whether the relation in hand must not hold
        self.subset: tuple[int, int] | None = None  # of how many of the subjects the next relation is said
        self.last_target: tuple[Waiting, tuple[Any, ...]] | None = None
        self.predicate: list[Mention] = []  # what "is red" is about
        self.subject_open = True  # whether the subject goes on, as no verb came
        self.done = False  # whether the clause had its verb
        self.lost = False  # whether the subject is no object, so that nothing is said of it
        self.lit = False  # whether light came through a window
        self.nth: tuple[Mention, int] | None = None  # one of several, in order, that the clause is about
        self.denied: NounPhrase | None = None  # what was ruled out last
        self.nowhere: Fronted | None = None  # where nothing is, but for what is told next
        self.bracketed: int | None = None  # how many lists were open before the bracket
        self.every = 1  # of how many things the phrase in hand means one
        self.meant_by_it: list[Mention] = []  # what "it" meant last in the sentence
        self.fronted_it: list[Mention] = []  # what "over it" meant ahead of what is there
        self.each: Mention | None = None  # the things of each of which the clause tells
        self.inverted = self.after_be = self.relative = self.head_related = False

    def name_first(self, mentions: list[Mention]) -> None:
        """Things are named first in a clause. Of many, the first one and the last ones are kept: "them and a book" over
        and over names all before once more each time."""
        kept = [*self.first_items, *mentions]
        self.first_items = [*kept[:1], *kept[1:][-REACH:]]

    def close_frames(self) -> None:
        """A new clause goes on with the list of the sentence at most."""
        self.frames = [f for f in self.frames[:1] if f.kind == "list"]

    def chunk(self, k: int) -> Chunk | None:
        """The chunk at ``k``; None beyond the ends."""
        return self.chunks[k] if 0 <= k < len(self.chunks) else None

    def noun_next(self, offset: int = 0) -> bool:
        """Whether a noun phrase comes next, or ``offset`` chunks later."""
        return self._is_noun(self.at + offset)

    def _is_noun(self, k: int) -> bool:
        chunk = self.chunk(k)
        return chunk is not None and chunk.kind == "noun"

    def target_next(self) -> bool:
        """Whether the noun after "opposite", "beside" and the like is what they are said of, and no subject."""
        chunk, after = self.chunk(self.at), self.chunk(self.at + 1)
        if chunk is None or chunk.kind != "noun":
            return True
        if after is not None and after.kind == "verb" and after.value.form in ("s", "base") and self.out.mentions:
            return bool(chunk.value.definite or chunk.value.what in ("pronoun", "place"))
        return True

    def verb_follows(self, k: int) -> bool:
        """Whether the noun phrase before chunk k is the subject of a finite verb."""
        nouns = 0
        for index, chunk in enumerate(self.chunks[k : k + 14], start=k):
            if chunk.kind == "verb":
                if chunk.value.form in ("s", "base") and not chunk.passive:
                    return True
                nouns = 0
            elif chunk.kind in ("stop", "comma", "while"):
                return False
            elif chunk.kind == "and":
                after = self.chunk(index + 1)
                if after is None or after.kind != "noun" or nouns > 0:
                    return False
            elif chunk.kind == "with":
                nouns = -1
            elif chunk.kind == "noun":
                nouns += 1
        return False

    def placed_next(self, k: int) -> bool:
        """Whether words of place or a participle follow at once, so that something is no mere item of a list."""
        chunk = self.chunk(k)
        return chunk is not None and (
            chunk.kind == "place" or (chunk.kind == "verb" and (chunk.passive or chunk.value.form in ("ed", "ing")))
        )

    def fronts(self, k: int) -> bool:
        """Whether the words of place from chunk k on come before who they are about: "and on the wall hangs ..."."""
        seen = 0
        if self.chunks[k].passive:  # "to its left a counter"
            return self.noun_next()
        for chunk in self.chunks[k : k + 8]:
            if chunk.kind == "noun":
                seen += 1
                if seen == 2:
                    return True
            elif chunk.kind == "verb":
                return seen == 1 and chunk.value.form in ("s", "base")
            elif chunk.kind == "comma" and seen == 1:
                return self.done and self._is_noun(k + 3) and self.verb_follows(k + 4)
            elif chunk.kind not in ("place", "adjective", "word"):
                return False
            elif chunk.kind == "place" and seen == 1 and chunk is not self.chunks[k]:
                seen = 0
        return False

    def leave_unread(self, text: str, start: int, end: int) -> None:
        """Words at characters [start, end) of the source are not understood."""
        self.out.unread.append(Left(" ".join(text.split()), start, end))

    def leave_sides(self, phrase: NounPhrase) -> None:
        """The sides of a phrase are of nothing that can have them."""
        assert phrase.sides is not None
        end = phrase.end
        while self.source.text[end : end + 1] == " ":  # they were longer than their mark
            end += 1
        self.leave_unread(" x ".join(f"{side:g}" for side in phrase.sides) + " m", phrase.start, end)

    def refer(self, phrase: NounPhrase) -> None:
        """The noun of a phrase names again what was named before; what else it says is accounted for elsewhere."""
        start = phrase.end - len(phrase.text)
        if self.source.text[start : phrase.end] == phrase.text:
            self.out.referred.append(self.source.span(start, phrase.end))

    def span_of(self, piece: Chunk | NounPhrase) -> Span:
        """Where a piece stands in the request."""
        return self.source.span(piece.start, piece.end)

    def chunk_span(self) -> Span:
        """Where the chunk in hand stands."""
        return self.span_of(self.chunks[max(0, min(self.at, len(self.chunks)) - 1)])
