"""Which part of speech a word is, by where it stands, for words that are nouns elsewhere.

After a modal verb, after a subject and after a relative pronoun stands a verb, whatever a dictionary has it for: "rain
can drum", "he fences", "a rug that anchors the table". Before a noun for a person stands what that one is like: "a
blind man". Such words name no thing; what a verb is about is read by `asides`.
"""

from __future__ import annotations

from dataclasses import replace

from .tokens import Token
from .vocabulary import Verb, words

_NAMING = ("noun", "plural", "containers", "matter", "abstract", "group", "parts", "collective", "room", "region")
"""Kinds of a token that may name something."""

_NO_VERB = (
    "det",
    "number",
    "amount",
    "pron",
    "person",
    "people_words",
    "whom",
    "break",
    "and",
    "with",
    "modal",
    "while",
)
# What is known as a verb keeps what it says of things.
_VERBS = ("action", "trade", "verb", "passive", "verb_stop", "stop")
"""Kinds that say already which verb a token is."""

_NO_PERSON = ("noun", "person", "room", "abstract", "verb", "action", "trade")
_TOLD = ("modal", "action", "trade", "det", "number", "amount")
"""What stands behind a word for a person that does something, or is a verb itself: "a table hosts five chairs"."""

_NAMED_AGAIN = ("noun", "people_words", "whom")
_MOST_ADVERBS = 4
"""Adverbs between a subject or a modal verb and its verb at most."""


def with_parts_of_speech(tokens: list[Token]) -> list[Token]:
    """The tokens, of which those that stand where a verb or an adjective does are no nouns.

    Examples:
        >>> from sceneweaver.language import read_request
        >>> [e.category for e in read_request("a bedroom for a blind man with a bed. Rain can drum outside.").entities]
        ['bed']
    """
    found: list[Token] = []
    for k in range(len(tokens)):
        found.append(_as_verb(tokens[k]) if _goes_on(tokens, k, found) else _at_place(tokens, k))
    return found


def _goes_on(tokens: list[Token], k: int, found: list[Token]) -> bool:
    """Whether a bare noun in the singular goes on from what may be done: "nobody may box or drum"."""
    if k < 3 or not tokens[k - 1].has("and") or "action" not in found[k - 2].kinds or tokens[k].has(*_NO_VERB, *_VERBS):
        return False
    bare = tokens[k].has("noun") and not tokens[k].has("plural") and _ends(tokens, k + 1)
    return bare and tokens[k - 3].text in words("parts_of_speech")["modals"]


def _ends(tokens: list[Token], k: int) -> bool:
    """Whether no noun goes on at a token."""
    return k >= len(tokens) or tokens[k].has("break", "preposition", "and", "place_adverb", "adverbs")


def _as_verb(token: Token) -> Token:
    return replace(token, kinds={"action": "base"})


def _at_place(tokens: list[Token], k: int) -> Token:
    token = tokens[k]
    if token.kinds and not token.has(*_NAMING):
        return token
    if _says_what_person(tokens, k):
        return Token(token.text, token.start, token.end, {"adjective": token.text})
    form = _form(tokens, k)
    if form is None:
        return token
    if token.has(*_VERBS):
        return replace(token, kinds={kind: value for kind, value in token.kinds.items() if kind not in _NAMING})
    kinds = {"verb": Verb("act", form)} if _is_relative(tokens, k) else {"action": form}
    return replace(token, kinds=kinds)


def _form(tokens: list[Token], k: int) -> str | None:
    """The form of the verb that a token is at its place; None where it is none."""
    token = tokens[k]
    if token.text in words("parts_of_speech")["reminding"]:
        return None
    if token.has(*_NO_VERB) or not token.text.replace("-", "").isalpha() or (token.kinds and not token.has(*_NAMING)):
        return None
    before = k - 1
    while before > 0 and k - before <= _MOST_ADVERBS and _is_adverb(tokens[before]):
        before -= 1
    if before < 0:
        return None
    first, data = tokens[before], words("parts_of_speech")
    ends_in_s = token.text.endswith("s") and not token.text.endswith("ss")
    if first.text in data["modals"] and not _is_noun(tokens, before):
        return None if ends_in_s else "base"
    if first.text in data["subjects"] and not (before and _governs(tokens[before - 1])):
        return None if ends_in_s else "base"
    if first.text in data["third"] and not (before and _governs(tokens[before - 1])):
        return "s" if ends_in_s else None
    if _is_relative(tokens, k):
        return "s" if ends_in_s or tokens[k - 2].has("plural") else None
    return "s" if ends_in_s and _has_role_for_subject(tokens, k) else None


def _has_role_for_subject(tokens: list[Token], k: int) -> bool:
    """Whether one person stands right before a word in s with something that it is about: "the clerk files papers"."""
    if k < 2 or k + 1 >= len(tokens) or tokens[k].has("number"):
        return False
    article, person, about = tokens[k - 2], tokens[k - 1], tokens[k + 1]
    one = person.has("people_words", "whom") and not person.has("noun", "plural") and article.has("det")
    return one and about.has("noun", "det", "matter") and not about.has("verb", "preposition", "number")


def _is_relative(tokens: list[Token], k: int) -> bool:
    """Whether a token goes on from "that", "which" or "who" behind a noun, with something that it is about or none."""
    if k < 2 or tokens[k - 1].text not in words("parts_of_speech")["relatives"]:
        return False
    named = tokens[k - 2].has(*_NAMED_AGAIN) and not tokens[k - 2].has("break", "preposition")
    after = tokens[k + 1] if k + 1 < len(tokens) else None
    closed = after is None or after.text == "to" or after.has("det", "number", "amount", "break", "and")
    return named and (closed or (after is not None and not after.has("verb", "modal")))


def _is_adverb(token: Token) -> bool:
    return token.text in words("parts_of_speech")["adverbs"] or (token.has("adverbs") and not token.has("noun"))


def _governs(token: Token) -> bool:
    """Whether a pronoun after a token is what that is about, and no subject: "for you", "with them"."""
    return token.has("preposition", "with") or token.text in words("parts_of_speech")["governing"]


def _is_noun(tokens: list[Token], k: int) -> bool:
    """Whether a modal verb is the noun here: "a can"."""
    before = tokens[k - 1] if k else None
    if before is None or before.text in words("parts_of_speech")["relatives"]:
        return False  # "a stove that can burn logs"
    return tokens[k].has("noun") and before.has("det", "number", "color", "material", "adjective")


def _says_what_person(tokens: list[Token], k: int) -> bool:
    """Whether a noun in the singular stands right before one for a person whom nothing is told to do: "a blind man",
    "a piano teacher"; no "chair grandma can get out of"."""
    token, person = tokens[k], tokens[k + 1] if k + 1 < len(tokens) else None
    if person is None or not person.has("people_words", "whom") or person.has(*_NO_PERSON):
        return False
    if token.has("plural", "people_words", "whom", "number", "det", "room", "preposition", "verb", "action", "with"):
        return False
    after = tokens[k + 2] if k + 2 < len(tokens) else None
    acts = after is not None and (after.has(*_TOLD) or after.text in words("parts_of_speech")["be"])
    before = tokens[k - 1] if k else None
    return not acts and before is not None and before.has("det", "number", "adjective", "people_words", "and", "scale")


__all__ = ["with_parts_of_speech"]
