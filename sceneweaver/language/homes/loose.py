"""Things that are asked for in no room that is named, with the words that are said of them."""

from __future__ import annotations

from collections.abc import Sequence

from sceneweaver.language.model import Span
from sceneweaver.language.vocabulary import vocabulary

from .lexicon import plain
from .mentions import is_thing
from .parts import Reading
from .tokens import Token

REST, LONGEST = 10, 3
"""Tokens at most of what is said of a thing, and of the name of one."""

_EVERYONE = ("each", "everyone", "everybody")
_ALL_OF = ("we", "they", "us", "them", "you")
"""Words before "all" where that means people."""
REACH = 6
"""Words before a thing among which the people are whom it is for."""

_STYLE = ("styles", "moods")
_TIES = ("for", "of", "with", "the", "a", "an", "by", "under", "on", "in")


def read_loose(reading: Reading, sentence: range) -> None:
    """Things that are asked for in no room that is named: each with the words around it."""
    tokens = reading.tokens
    at = sentence.start
    while at < sentence.stop:
        long = _compound(tokens, at, sentence.stop)
        if not long and (tokens[at].done or not is_thing(tokens[at]) or is_style(tokens[at])):
            at += 1
            continue
        start, end = at, max(at + long, thing_end(reading, at, sentence.stop))
        while start > sentence.start and _leads(tokens[start - 1]):
            start -= 1
        if _is_said_of_room(reading, sentence, start):
            at += 1
            continue
        while end < sentence.stop and not tokens[end].breaks and not tokens[end].done and end - at < REST:
            follows = _compound(tokens, end, sentence.stop)
            with_more = tokens[end].text == "and" and any(t.text == "with" for t in tokens[at:end])
            if not (follows or _goes_on(tokens[end]) or with_more and _begins_thing(tokens, end + 1, sentence.stop)):
                break
            end += max(1, follows)
        while end - 1 > at and tokens[end - 1].text in _TIES:
            end -= 1
        words = said_words(tokens[start:end])
        span = Span(tokens[start].span.start, tokens[end - 1].span.end)
        reading.loose.append((words, span, _for_everyone(reading, sentence, start)))
        for j in range(start, end):
            reading.did(j, "request")
        at = end


def _is_said_of_room(reading: Reading, sentence: range, start: int) -> bool:
    """Whether a thing is what a room is told to be or not to be: "the hall must not be a tunnel"."""
    tokens = reading.tokens
    if start <= sentence.start or tokens[start - 1].text not in ("be", "is", "are", "become"):
        return False
    clause = max((k for k in range(sentence.start, start) if tokens[k].breaks), default=sentence.start - 1)
    return any(clause < one.at < start for one in reading.named)


def _leads(token: Token) -> bool:
    """Whether a word before a thing is said of it."""
    if token.breaks or token.done:
        return False
    return not token.kinds or token.has("own", "size", "number") or token.text in ("a", "an")


def _goes_on(token: Token) -> bool:
    """Whether what is said of a thing goes on with a word."""
    of_it = token.text in (*_TIES, "each")
    return of_it or token.has("person", "number", "each", "groups") or is_thing(token)


def _compound(tokens: Sequence[Token], at: int, stop: int) -> int:
    """Tokens of a thing whose name has several words, of which one alone may be none: "grab bars"; 0 for none."""
    for length in range(LONGEST, 1, -1):
        some = tokens[at : at + length]
        if at + length > stop or any(t.done or t.breaks for t in some):
            continue
        kinds = vocabulary().get(" ".join(plain(t.text) for t in some), {})
        if "noun" in kinds and "room" not in kinds:
            return length
    return 0


def _begins_thing(tokens: Sequence[Token], at: int, stop: int) -> bool:
    """Whether a thing follows, behind an article or a number at most."""
    at += at < stop and (tokens[at].text in ("a", "an") or tokens[at].has("number"))
    return at < stop and (_compound(tokens, at, stop) > 0 or is_thing(tokens[at]) and not tokens[at].done)


def _for_everyone(reading: Reading, sentence: range, at: int) -> bool:
    """Whether a thing is for each of the people: "each needs a desk", "they all have a desk of their own"."""
    for k in range(at - 1, max(sentence.start, at - REACH) - 1, -1):
        if reading.tokens[k].breaks:
            return False
        words = reading.tokens[k].text.split()
        if words[0] in _EVERYONE or words == ["for", "each"]:
            return True
        if words[0] == "all" and ("of" in words or k and reading.tokens[k - 1].text in _ALL_OF):
            return True
    return False


def thing_end(reading: Reading, at: int, stop: int) -> int:
    """The number of the token behind the things that one begins."""
    end = at + 1
    while end < stop and is_thing(reading.tokens[end]) and not reading.tokens[end].done:
        end += 1
    return end


def is_style(token: Token) -> bool:
    """Whether a token is a word for a style or a mood."""
    if token.kinds and not token.has("accessible"):
        return False
    kinds = vocabulary().get(token.text, {})
    return any(kind in kinds for kind in _STYLE) and not token.has("accessible")


def said_words(tokens: tuple[Token, ...] | list[Token]) -> str:
    """Words as they are said, without what ends or begins a clause for nothing."""
    said = [t.text for t in tokens]
    while said and said[0] in ("so", "and", "has", "have", "plus", "it", "that", "which", "is"):
        said.pop(0)
    while said and said[-1] in ("and", "or", "too", "please", "also"):
        said.pop()
    return " ".join(said)
