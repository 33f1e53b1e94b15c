"""States of things: "two chairs knocked over", "the curtains closed", "one drawer pulled out", "the lamp on".

Words count only where the thing that they are said of can be in that state (``assets/states.yaml``); all others are
left to the clauses.
"""

from __future__ import annotations

import re
from functools import cache

from sceneweaver.assets.states import State, state_of, states

from ..model import Attribute
from ..parsed import Left, Parsed, Told
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import vocabulary, words
from .phrases import NUMBER, Edits, noun_at, noun_before, number_of, one_of

_BE = (
    r"(?:(?:is|are|lies?|lying|left|standing|stands?|has\sbeen|have\sbeen|was|were|all|still|slightly|just|to\sbe)\s)"
    r"{0,3}"
)
_MANY = rf"(?:(?P<many>{NUMBER})\s(?:of\s(?:them|these|those|which|the\s[a-z]+|its\s[a-z]+)\s)?)?"
_END = r"(?=\s*(?:[,.;)]|$|and\b|with\b|but\b|while\b))"


def read_states(source: Source, parsed: Parsed) -> None:
    """Adds every state of a thing, and takes its words out."""
    edits = Edits(source)
    for pattern in _patterns():
        for found in list(pattern.finditer(source.text)):
            if edits.free(*found.span()):
                _add(source, parsed, edits, found)


def _add(source: Source, parsed: Parsed, edits: Edits, found: re.Match[str]) -> None:
    text, groups = source.text, found.groupdict()
    start, end = found.span()
    part = singular(groups.get("part") or "")
    own = groups.get("noun") or ""
    if own and state_of(match_of(own).category, found["state"], part) is not None:
        start, noun, after = found.start("part"), own, False
    elif part:
        noun, after = noun_before(text, start), False
    else:
        noun, after = noun_at(text, start, end)
    spoken, noun = noun, _thing(noun)
    apart = text[:start].rstrip()[-1:] in ("", ",", ".", "(")
    if not after and apart and _meant(noun, found["state"], part) is None:
        noun = _able_before(text, start, found["state"], part) or noun
    state = _meant(noun, found["state"], part)
    if state is None and not part and not after:  # "the wardrobe open" is its doors, "open shelves" have none
        part = "door"
        state = _meant(noun, found["state"], part)
    if state is None:
        return
    if found["state"] in state.after and (after or not re.search(r"[a-z]\s+$", text[:start] + " ")):
        return
    many = groups.get("many")
    count = (number_of(many), number_of(many)) if many and not part else None
    said = " ".join(text[start:end].split())
    value = f"{groups.get('part') or part} {found['state']}".strip()
    if after and noun != spoken:  # "rumpled linen bedding": the noun goes, what else is said of it is told
        rest = text[end : text.index(spoken, end) + len(spoken)]
        between = rest[: -len(spoken.split()[-1])].strip()
        end += len(rest)
        parsed.unread += [Left(between, span=source.span(end - len(rest), end))] if between else []
    span = edits.take(start, end)
    attribute = Attribute(kind="state", value=value, words=said, count=count, span=span)
    parsed.states.append(Told(attribute, noun, after, named=True))


def _thing(noun: str) -> str:
    """The noun, or that of the thing of which it is a part."""
    return words("states")["stand_for"].get(singular(noun).split()[-1], noun) if noun else ""


def _able_before(text: str, start: int, word: str, part: str) -> str:
    """The last noun before a place in its sentence that can be in a state; "" where none can."""
    first = max(text.rfind(". ", 0, start), text.rfind("(", 0, start)) + 1
    spoken = re.findall(r"[a-z][a-z'-]*", text[first:start])
    for k in range(len(spoken) - 1, -1, -1):
        for noun in (" ".join(spoken[max(0, k - 1) : k + 1]), spoken[k]):
            if "noun" in vocabulary().get(noun, {}) and _meant(noun, word, part) is not None:
                return noun
    return ""


def _meant(noun: str, word: str, part: str) -> State | None:
    if not noun:
        return None
    match = match_of(noun)
    return None if match.how == "generic" else state_of(match.category, word, part)


@cache
def _patterns() -> tuple[re.Pattern[str], ...]:
    spoken = one_of(list({word for row in states() for word in row.words if not row.part}))
    behind = one_of(list({word for row in states() for word in row.after}))
    opened = one_of(list({word for row in states() for word in row.words if row.part}))
    part = r"(?P<part>drawers?|doors?|lids?)"
    return tuple(
        re.compile(pattern)
        for pattern in (
            rf"\b(?:(?:one|a|an|the|its|top|bottom|both|all|two|every|with|and)\s){{0,3}}(?:(?P<noun>[a-z]+)\s)?{part}\s"
            rf"{_BE}(?P<state>{opened})\b",
            rf"\b{_MANY}{_BE}(?P<state>{spoken})\b",
            rf"\b{_BE}(?P<state>{behind}){_END}",
        )
    )


__all__ = ["read_states"]
