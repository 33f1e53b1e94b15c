"""Clauses that say why or what for, and comparisons: they name nothing that is to be there.

"So that nobody trips over the cables" and "because the lamp was too bright" become one token of the kind ``aside``,
which is told as not understood as a whole. A clause in which something is placed or needed ("so that the desk faces
the window", "because we need a crib") is read as any other.
"""

from __future__ import annotations

from functools import cache

from .tokens import Token
from .vocabulary import Verb, frame, words

_MOST_OPEN = 6
"""Words between "so" and its modal verb at most: "so the boy in the wheelchair can"."""

_OPENS = 4
"""Tokens that what opens a clause consists of at most."""

_PEOPLE = ("person", "people_words", "whom")


def without_subclauses(tokens: list[Token]) -> list[Token]:
    """The tokens with each clause of reason or purpose in which nothing is placed or needed as one.

    Examples:
        >>> from sceneweaver.language import read_request
        >>> graph = read_request("a hall with a bench, so that nobody trips over a suitcase")
        >>> [e.category for e in graph.entities], graph.unread[0].words
        (['bench'], 'so that nobody trips over a suitcase')
    """
    found: list[Token] = []
    at = 0
    while at < len(tokens):
        first = _opened(tokens, at)
        end = _end(tokens, first) if first > at else at
        felt = first > at and tokens[first - 1].text in ("when", "if", "that")
        if end > first and (felt or not _places(tokens[first:end])):
            joined = " ".join(token.text for token in tokens[at:end])
            found.append(Token(joined, tokens[at].start, tokens[end - 1].end, {"aside": "verb"}))
            at = end
            continue
        found.append(tokens[at])
        at += 1
    return found


def _opened(tokens: list[Token], at: int) -> int:
    """Where what a clause says begins, behind the words that open it at a token; ``at`` itself where none does."""
    for length in range(min(_OPENS, len(tokens) - at), 0, -1):
        if " ".join(token.text for token in tokens[at : at + length]) in _openers():
            return at + length
    if tokens[at].text != "so":
        return at
    for k in range(at + 1, min(at + 1 + _MOST_OPEN, len(tokens))):
        if tokens[k].has("break"):
            break
        if tokens[k].text in words("parts_of_speech")["able"]:
            return at + 1 if k > at + 1 else at
    return at


@cache
def _openers() -> frozenset[str]:
    return frozenset(words("parts_of_speech")["purposes"])


def _end(tokens: list[Token], k: int) -> int:
    """Where a clause ends: at a comma or a stop, or with "and a chair", which goes on with the list."""
    first = k
    while k < len(tokens) and not tokens[k].has("break"):
        after = tokens[k + 1] if k + 1 < len(tokens) else None
        listed = after is not None and (after.text in ("a", "an") or after.has("number", "amount", "neg", "with"))
        if k > first and tokens[k].has("and") and listed:
            break
        if k > first and (tokens[k].has("neg", "while") and tokens[k].text in ("but", "and no", "but no", "with no")):
            break
        named = k > first and (tokens[k - 1].has("noun", "people_words", "whom") or not tokens[k - 1].kinds)
        if named and tokens[k].text in ("a", "an"):
            break  # "in order to see stars a telescope"
        k += 1
    return k


def _places(clause: list[Token]) -> bool:
    """Whether something is placed or needed in a clause; where people sit and stand places nothing."""
    placing = words("parts_of_speech")["placing"]
    people = False
    for token in clause:
        if token.text in placing:
            return True
        verb = token.get("verb")
        related = isinstance(verb, Verb) and (verb.lemma in words("relations")["verbs"]["posture"] or bool(frame(verb)))
        if related and verb.lemma != "be" and not people and not token.has("noun"):
            return True
        people = people or (token.has(*_PEOPLE) and not token.has("noun"))
    return False


__all__ = ["without_subclauses"]
