"""What a token is at its place: a verb, or a part of a noun phrase."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from sceneweaver.assets.taxonomy import is_head

from .chunks import CLOSED, QUALITIES, Chunk, Kind
from .tokens import Token
from .vocabulary import Verb, frame, words

_BASES = ("stand", "rest", "face", "display", "frame", "support", "house", "line", "open")
"""Verbs in the plural that look like nouns."""


_MODALS = ("can", "could", "should", "shall", "will", "would", "must", "may", "might")


LONGEST_NAME = 4
"""Words before a noun's last that are looked at."""


class Scan:
    """Tokens and where the reader of them is."""

    def __init__(self, tokens: list[Token]):
        self.tokens = [_as_noun(token) if _is_counted(tokens, k) else token for k, token in enumerate(tokens)]
        self.at = 0
        self.out: list[Chunk] = []
        self.named: set[str] = set()  # what the noun phrases so far are: things, rooms ...
        self.noun_before = False  # whether the last chunk was a noun phrase
        self.depth = 0  # of the noun phrase that is being read: of how many others it is
        self.several = list(_several(self.tokens))  # by token: whether a plural stands before it in its clause

    def peek(self, offset: int) -> Token | None:
        """The token so many further on; None beyond the ends."""
        return self.token(self.at + offset)

    def token(self, k: int) -> Token | None:
        """The token at ``k``; None beyond the ends."""
        return self.tokens[k] if 0 <= k < len(self.tokens) else None

    def add(self, kind: Kind, count: int = 1, value: Any = None, **more: Any) -> Chunk:
        """Makes a chunk of the next ``count`` tokens."""
        first, last = self.tokens[self.at], self.tokens[min(self.at + count, len(self.tokens)) - 1]
        text = " ".join(t.text for t in self.tokens[self.at : self.at + count])
        chunk = Chunk(kind, text, first.start, last.end, value, **more)
        self.out.append(chunk)
        self.at += count
        if kind == "noun":
            self.named.add(value.what)
        if kind != "word":
            self.noun_before = kind == "noun"
        return chunk


def participle_next(scan: Scan, token: Token, after: Token | None) -> bool:
    """Whether a participle stands without a noun before it, as after a comma or "is"."""
    last = scan.out[-1].kind if scan.out else "stop"
    if token.get("verb").form not in ("ed", "ing") or last not in (
        "verb",
        "comma",
        "and",
        "word",
        "while",
        "place",
    ):
        return False
    if after is None or after.has(*CLOSED):
        return True
    return token.get("verb").form == "ing" and after.has("number", "amount") and last != "place"


def _is_counted(tokens: list[Token], k: int) -> bool:
    """Whether what is a verb of one thing, or the plural of a noun, stands where no verb does: behind a number of
    several ("two stands") or "with"."""
    verb, before = tokens[k].get("verb"), tokens[k - 1] if k > 0 else None
    if before is None or not isinstance(verb, Verb) or verb.form != "s" or not is_head(tokens[k].text):
        return False
    number = before.get("number")
    return before.text == "with" or (number is not None and number > 1)


def _as_noun(token: Token) -> Token:
    kinds = {kind: value for kind, value in token.kinds.items() if kind not in ("verb", "stop")}
    return replace(token, kinds={**kinds, "plural": True})


def _several(tokens: list[Token]) -> Iterator[bool]:
    """For each token whether there is a plural between it and the break before it."""
    plural = False
    for token in tokens:
        yield plural
        plural = not token.has("break") and (plural or token.has("plural"))


def _of_several(scan: Scan, k: int) -> bool:
    """Whether several things, or where they are, stand just before: "shelves at the wall hold folded towels"."""
    before = scan.token(k - 1)
    return before is not None and before.has("plural", "place") and scan.several[k]


def is_name_of_one(scan: Scan, k: int) -> bool:
    """Whether a verb's plain form ends the name of one thing: "a burette stand", for what one thing does ends in s.

    Right before it stand "a" and what belongs to one noun, and no other noun is bound to that.
    """
    verb = scan.tokens[k].get("verb")
    if not isinstance(verb, Verb) or verb.form != "base" or not is_head(scan.tokens[k].text):
        return False
    for at in range(k - 1, max(-1, k - 1 - LONGEST_NAME), -1):
        token, before = scan.tokens[at], scan.token(at - 1)
        if token.text in ("a", "an", "another"):
            return at < k - 1 and (before is None or not before.has("and", "break"))
        if token.has("plural", *CLOSED) or not (token.has("noun", *QUALITIES) or not token.kinds):
            return False
    return False


def has_article(token: Token) -> bool:
    """Whether a name has its own article, so that nothing stands before it that is said of it: "the room"."""
    return token.text.startswith("the ")


def is_verb(scan: Scan, k: int, seen_noun: bool) -> bool:
    """Whether a token that can be a verb is one: after a noun, and not followed by the noun that it would name."""
    token = scan.tokens[k]
    verb = token.get("verb")
    if not isinstance(verb, Verb):
        return False
    after = scan.tokens[k + 1] if k + 1 < len(scan.tokens) else None
    closed = (
        after is None
        or after.has(*CLOSED)
        or after.has("number", "amount", "adverbs", "partial")
        or has_article(after)
        or (after.has("stop") and not after.has("noun", *QUALITIES))
    )
    other = token.has("noun", "abstract", "collective", "region", "parts", *QUALITIES)
    if verb.form == "s":
        return not other or (seen_noun and (closed or not token.has("noun")))
    if verb.form == "base" and k > 0 and scan.tokens[k - 1].text in _MODALS:  # "everybody must have"
        return True
    if is_name_of_one(scan, k):
        return False
    if verb.form == "base":
        several = k > 0 and scan.tokens[k - 1].has("plural") and after is not None and after.has("det", "preposition")
        return seen_noun and (
            (closed and (not other or several or token.text in _BASES)) or (not other and _of_several(scan, k))
        )
    if verb.form == "ed":
        if (
            token.text in ("set", "built", "fit")
            and after is not None
            and (after.has("verb") or after.has("break", "and", "with"))
        ):
            return False
        if token.has("noun") and not closed:
            return False
        return seen_noun
    if token.has("abstract") or (token.has("noun") and not (closed and seen_noun)):  # "a painting"
        return False
    if not seen_noun:
        return False
    return closed or frame(verb) is not None or gives_off(scan, k)


def gives_off(scan: Scan, k: int) -> bool:
    """Whether a participle and what follows it say what a thing gives off: a lamp "casting soft light"."""
    rows = words("bearing_words")
    if scan.tokens[k].text not in rows["giving_off"].split():
        return False
    for token in scan.tokens[k + 1 : k + 4]:
        if token.text in rows["given_off"].split():
            return True
        if not token.has(*QUALITIES):
            return False
    return False
