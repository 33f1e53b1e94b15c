"""What is refused with the word for it behind, or within: "rugs are out", "keep plants out", "a TV-free lounge".

The word goes before the noun, where that of "no rugs" is; verbs of refusing ("I hate rugs") are words of negation
(``lexicon/refusals.yaml``) and need no rule.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sceneweaver.assets.plurals import singular

from .tokens import Token
from .vocabulary import vocabulary, words

_MOST = 8
"""Tokens of the names of what is refused at most."""

_IN_LISTS = ("noun", "material", "color", "adjective", "scale", "shape", "det", "matter", "abstract", "group", "parts")


def with_refusals(tokens: list[Token]) -> list[Token]:
    """The tokens, with a word of negation before what a word behind it refuses.

    Examples:
        >>> from sceneweaver.language import read_request
        >>> read_request("a bedroom with a bed. Rugs are out.").without[-1]
        'round_rug'
    """
    found: list[Token] = []
    at = 0
    while at < len(tokens):
        taken = next((n for rule in _RULES if (n := rule(tokens, at, found))), 0)
        if not taken:
            found.append(tokens[at])
            taken = 1
        at += taken
    return found


def _no(start: int) -> Token:
    return Token("no", start, start, {"neg": "no"})


def _stop(end: int) -> Token:
    return Token(".", end, end, {"break": "."})


def _ends(tokens: list[Token], k: int) -> bool:
    """Whether a sentence, or a part of it, is over before a token, or says no more of what was refused."""
    return k >= len(tokens) or tokens[k].has("break", "and", "while") or tokens[k].text in words("refusals")["stressed"]


def _names(tokens: list[Token], at: int) -> int:
    """The end of the names that begin at a token: "all rugs and curtains"; ``at`` itself for none."""
    k = at
    while k < min(at + _MOST, len(tokens)) and not tokens[k].has("neg", "with", "modal"):
        listed = tokens[k].has("and") and k > at and k + 1 < len(tokens) and tokens[k + 1].has("noun")
        if (
            not (listed or tokens[k].has(*_IN_LISTS))
            or tokens[k].has("preposition", "verb")
            and not tokens[k].has("noun")
        ):
            break
        k += 1
    return k if any(token.has("noun", "matter", "abstract", "group") for token in tokens[at:k]) else at


def _is_out(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Rugs and curtains are out": what a sentence begins with."""
    if found and not found[-1].has("break", "while"):
        return 0
    end = _names(tokens, at)
    if end == at or end >= len(tokens) or tokens[end].text not in words("refusals")["be"]:
        return 0
    k = end + 1
    while k < len(tokens) and tokens[k].text in words("refusals")["strictly"]:
        k += 1
    for length in (3, 2, 1):
        spoken = " ".join(token.text for token in tokens[k : k + length])
        if spoken in words("refusals")["refused"] and _ends(tokens, k + length):
            last = tokens[k + length - 1].end
            named = [token for token in tokens[at:end] if token.text not in ("the", "all", "any")]
            found += [_no(tokens[at].start), *named, _stop(last)]
            return k + length - at
    return 0


def _keep_out(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "Keep plants out", "leave the rugs out"."""
    if tokens[at].text not in words("refusals")["keep"]:
        return 0
    end = _names(tokens, at + 1)
    if (
        end == at + 1
        or end >= len(tokens)
        or tokens[end].text not in ("out", "away", "off")
        or not _ends(tokens, end + 1)
    ):
        return 0
    named = [token for token in tokens[at + 1 : end] if token.text not in ("the", "all", "any")]
    found += [_no(tokens[at].start), *named, _stop(tokens[end].end)]
    return end + 1 - at


def _free(tokens: list[Token], at: int, found: list[Token]) -> int:
    """ "A TV-free lounge", "mirror free": the room is without it, or the thing behind is."""
    token = tokens[at]
    noun, _, last = token.text.rpartition(" ")
    end = at + 1
    if last != "free" and at + 1 < len(tokens) and tokens[at + 1].text == "free" and not token.has("number"):
        noun, end = token.text, at + 2
    elif last != "free":
        return 0
    kinds = vocabulary().get(noun, {})
    if not noun or "noun" not in kinds or singular(noun) in words("refusals")["not_free"]:
        return 0
    after = tokens[end] if end < len(tokens) else None
    if end == at + 2 and after is not None and not after.has("break", "room", "and"):
        return 0  # "leave the wall free of shelves"
    start, stop = token.start, tokens[end - 1].end
    no = [_no(start), replace(token, text=noun, end=stop, kinds=dict(kinds))]
    if after is not None and after.has("room", "place", "noun"):
        rest = tokens[end]
        found += [rest, Token(",", rest.start, rest.start, {"break": ","}), *no]
        if not _ends(tokens, end + 1):
            found.append(_stop(stop))
        return end + 1 - at
    found += no
    return end - at


_RULES: tuple[Callable[[list[Token], int, list[Token]], int], ...] = (_is_out, _keep_out, _free)
"""Each takes what has been found so far, adds to it, and says how many tokens it took; 0 leaves them to the next."""

__all__ = ["with_refusals"]
