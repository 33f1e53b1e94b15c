"""What of a request led to nothing: phrases that were not understood, and what is said that is no demand.

Each clause with words of meaning that became nothing is quoted, in the customer's words and order, as far as is needed
to make sense of it. Greetings, ages, names, reasons and what people say of themselves without a wish are remarks; in
doubt words are a demand that was not understood.
"""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.language.model import Span, Unread

from .lexicon import data
from .parts import Reading
from .remarks import is_of_person, is_remark, mark_persons
from .tokens import Token

SMALL = ("function", "soft", "own", "each", "no", "them", "equal", "of_them", "animal", "we", "me")
"""Kinds of words that say nothing by themselves."""

APART = 3
"""Small words at most between two words of one phrase."""

WHOLE = 12
"""Tokens at most of a clause that is quoted from its beginning."""

_ENDS = (
    "and",
    "or",
    "but",
    "so",
    "with",
    "the",
    "a",
    "an",
    "is",
    "are",
    "be",
    "of",
    "to",
    "for",
    "our",
    "my",
    "please",
    "too",
)
"""Words that a phrase does not end with."""

_LEFT_OUT = ("and", "or", "but", "so", "with", "also", "then", "please", "plus", "that", "which", "where", ",", "too")
"""Words that a phrase neither begins nor ends with."""

_LEADS = (
    "in",
    "on",
    "at",
    "to",
    "from",
    "into",
    "onto",
    "of",
    "for",
    "by",
    "with",
    "under",
    "over",
    "through",
    "than",
    "is",
)
"""Words that lead to what something is said of."""

_TIES = (
    *_LEADS,
    "are",
    "be",
    "between",
    "inside",
    "along",
    "around",
    "behind",
    "without",
    "like",
    "as",
    "up",
    "out",
    "off",
    "must",
    "should",
    "can",
    "may",
    "not",
    "no",
    "the",
    "a",
    "an",
    "our",
    "my",
    "your",
    "their",
    "his",
    "her",
    "its",
    "and",
)
"""Words after which a phrase goes on, whatever became of what follows."""


def read_rest(reading: Reading) -> tuple[list[Unread], list[Unread]]:
    """The phrases that were not understood, and the remarks, each in the order of the request."""
    mark_persons(reading)
    unread, remarks = list[Unread](), list[Unread]()
    for clause in clauses(reading):
        found = _phrases(reading, clause)
        whole = bool(found) and is_remark(reading, clause)
        if whole:
            remarks.append(_quoted(reading, clause.start, clause.stop))
        for one in found if not whole else ():
            kept = remarks if is_of_person(reading, clause, range(*one)) else unread
            kept.append(_quoted(reading, *_trimmed(reading, *one)))
    return unread, remarks


def clauses(reading: Reading) -> Iterator[range]:
    """Parts of sentences between signs, and before words that begin another one."""
    tokens = reading.tokens
    for sentence in reading.sentences():
        start = sentence.start
        for at in (*sentence, sentence.stop):
            ends = at == sentence.stop or tokens[at].breaks
            begins = not ends and at > start and _begins_clause(tokens, at)
            if (ends or begins) and at > start:
                yield range(start, at)
            if ends or begins:
                start = at + 1 if ends else at


def _begins_clause(tokens: tuple[Token, ...], at: int) -> bool:
    """Whether a word begins another clause: "so" only before who or what it is said of."""
    if tokens[at].text not in data("remarks")["begin_clause"]:
        return False
    after = tokens[at + 1] if at + 1 < len(tokens) else None
    subject = after is not None and (
        after.text in (*data("remarks")["persons"], "that", "the", "it", "my", "our", "there", "no")
        or after.has("person")
    )
    return tokens[at].text != "so" or subject


def is_open(token: Token) -> bool:
    """Whether a token has a meaning of its own and led to nothing."""
    if token.done or token.breaks or token.text in ("a", "an", "one") or token.text in data("remarks")["small"]:
        return False
    return not token.has(*SMALL) and token.get("joint") != "together" and any(letter.isalnum() for letter in token.text)


def _phrases(reading: Reading, clause: range) -> list[tuple[int, int]]:
    """First and last token behind of each phrase of a clause that led to nothing."""
    tokens = reading.tokens
    groups = list[list[int]]()
    for at in clause:
        if not (is_open(tokens[at]) or tokens[at].span in reading.unmeasured):
            continue
        between = tokens[groups[-1][1] + 1 : at] if groups else ()
        small = all(not t.done or t.text in _TIES for t in between)
        if groups and small and len(between) <= APART:
            groups[-1][1] = at
        else:
            groups.append([at, at])
    found = list[tuple[int, int]]()
    for first, last in groups:
        first, stop = _begin(reading, clause, first), _end(reading, clause, last)
        if found and first <= found[-1][1]:
            found[-1] = found[-1][0], max(stop, found[-1][1])
        else:
            found.append((first, stop))
    return found


def _begin(reading: Reading, clause: range, first: int) -> int:
    """Where a phrase begins: at the subject of what is said of it, or at the small words before a thing."""
    tokens, at = reading.tokens, first
    said_of = any(tokens[k].text in data("remarks")["said_of"] for k in range(max(clause.start, first - 6), first))
    if said_of and first - clause.start < WHOLE:
        return clause.start
    tied = first > clause.start and (tokens[first].has("joint", "side") or tokens[first - 1].text in _LEADS)
    if tied:  # with the thing or room that it is said of
        while at > clause.start and first - at < WHOLE and tokens[at - 1].text in (*_LEADS, "the", "a", "an"):
            at -= 1
        room = next((one for one in reading.named if one.first < at <= one.last + 1), None)
        at = max(clause.start, room.first) if room is not None else at
        while room is None and at > clause.start and tokens[at - 1].done and first - at < WHOLE // 2:
            at -= 1
    while at > clause.start and not tokens[at - 1].done:
        before = tokens[at - 1]
        if not (before.has("no", "own", "size", "number", "soft") or before.text in ("a", "an", "the", "our", "my")):
            break
        at -= 1
    return at


def _end(reading: Reading, clause: range, last: int) -> int:
    """Behind which token a phrase ends: with what a word of place or time leads to."""
    tokens, at = reading.tokens, last + 1
    if at < clause.stop and tokens[at].done and tokens[at].has("room", "use", "known_room", "person", "staff"):
        return at + 1  # "quiet bedroom", "charity office"
    while at < clause.stop and at - last < WHOLE:
        goes_on = tokens[at].text in _TIES or tokens[at].has("joint", "no", "own")
        tied = tokens[at - 1].text in _TIES or tokens[at - 1].has("joint", "no", "own")
        if not (goes_on or tied or at - 1 > last and tokens[at - 1].glued):
            break
        if tokens[at].text in ("and", "with") and tokens[at - 1].text not in _TIES and not _between(tokens, last, at):
            break  # something else follows
        at += 1
    return at


def _between(tokens: tuple[Token, ...], last: int, at: int) -> bool:
    return any(t.text in ("between", "from") for t in tokens[last:at])


def _trimmed(reading: Reading, first: int, stop: int) -> tuple[int, int]:
    """A phrase without words that it neither begins nor ends with."""
    tokens = reading.tokens
    begins = (
        *_LEFT_OUT,
        "i",
        "we",
        "need",
        "want",
        "there",
        "is",
        "has",
        "have",
        "would",
        "like",
        "it",
        "a",
        "an",
        "the",
    )
    while first < stop - 1 and tokens[first].text in begins and not is_open(tokens[first]):
        first += 1
    while stop - 1 > first and tokens[stop - 1].text in _ENDS and not is_open(tokens[stop - 1]):
        stop -= 1
    return first, stop


def _quoted(reading: Reading, first: int, stop: int) -> Unread:
    spans = [token.span for token in reading.tokens[first:stop]]
    span = Span(min(s.start for s in spans), max(s.end for s in spans))
    return Unread(words=" ".join(reading.text[span.start : span.end].split()), span=span)
