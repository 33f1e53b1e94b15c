"""States of things: "two chairs knocked over", "the curtains closed", "one drawer pulled out", "the lamp on".

Words count only where the thing that they are said of can be in that state (``assets/states.yaml``); all others are
left to the clauses.
"""

from __future__ import annotations

import re
from functools import cache

from sceneweaver.assets.roles import groups_above, has_role
from sceneweaver.assets.states import State, state_of, states

from ..model import Attribute
from ..parsed import Left, Parsed, Told
from ..source import Source
from ..things import match_of, singular
from ..told_states import LAID_FOR, PULLED_OUT
from ..vocabulary import vocabulary, words
from .lengths import PLAIN, plain_length
from .phrases import NUMBER, Edits, noun_after, noun_at, noun_before, noun_behind, number_of, one_of
from .resolve import is_thing, thing_before

_BE = (
    r"(?:(?:is|are|lies?|lying|left|standing|stands?|has\sbeen|have\sbeen|was|were|all|still|slightly|just|to\sbe)\s)"
    r"{0,3}"
)
_MANY = rf"(?:(?P<many>{NUMBER})\s(?:of\s(?:them|these|those|which)\s)?)?"
FAR = 0.3
"""How far [m] from its table a chair is that is pulled out."""

_PULLED = re.compile(
    r"(?P<said>\b(?:not\s(?:fully\s|quite\s|all\s)?pushed\sin|pulled\s(?:out|back|away)|pushed\sback)"
    rf"(?:\s(?:by\s|about\s|some\s){{0,2}}(?P<length>{PLAIN}))?)(?P<from>\sfrom(?=\s(?:the|its|their|a|his|her)\s))?"
)
_SET = re.compile(
    rf"\b(?P<said>{_BE}(?:set|laid)(?:\sup|\sout)?)\s"
    rf"(?:for\s(?P<many>{NUMBER})\b(?:\s(?:people|guests|diners|persons|covers))?(?!\s(?:o'?clock|cm|m|metres))|for\s(?:a\s)?(?:formal\s|festive\s|big\s|family\s)?"
    r"(?:dinner|lunch|breakfast|supper|tea|meal|feast|party|christmas|brunch)\b(?:\sparty|\sdinner|\slunch)?)"
)
_OVER_FLOOR = re.compile(r"\s(?:all\s)?(?:over|on|across|around|about)\sthe\s(?:whole\s)?(?:floor|ground)\b")
LIT = "lit"
"""What a fireplace is with a fire in it."""

_FIRE = re.compile(
    r"\b(?:with\s)?(?:a|the)\s(?:[a-z]+\s)?fire\s(?:is\s|was\s)?(?:(?:burns|burning|lit|crackles|crackling|glows|glowing|"
    r"roars|roaring|blazes|blazing|going)\s)?(?:brightly\s|softly\s|low\s)?(?:in|inside)\s"
    r"(?:(?P<it>it|them)\b|(?:the|a|an|our|my|its)\s)"
)
OVER_BACK = "over the back"
"""What a garment does that lies on a chair; see ``states.yaml``."""

_OVER_BACK = re.compile(
    r"\b(?:(?:is|are|was|lies|has\sbeen|draped|slung|thrown|hung|hangs|hanging|flung|tossed|left|laid|lying|resting|"
    r"carelessly|casually|neatly)\s){0,3}(?:(?:over|across|on|from)\sthe\sback(?:rest)?\sof(?=\s[a-z]+\s)|"
    r"(?P<own>over\s(?:its|the|their)\sback(?:rest)?\b(?!\sof))|"
    r"over(?=\s[a-z]+\s(?:[a-z]+\s){0,2}(?:chair|armchair|stool|sofa|bench)s?\b))"
)
_SHARE = re.compile(
    rf"\b(?P<many>{NUMBER})\sof\s(?P<rest>(?:the|our|my|these|those)\s(?:{NUMBER}\s)?[a-z]+\s?[a-z]*\s)$"
)
_NOT_OVER = r"(?!(?<=\sover)\s(?:the|an?|one|its?|both|each|every|my|our|his|her|their)\b)"
"""What is thrown "over the chair" is no chair thrown over."""

_END = r"(?=\s*(?:[,.;)]|$|and\b|with\b|but\b|while\b))"


def read_states(source: Source, parsed: Parsed) -> None:
    """Adds every state of a thing, and takes its words out."""
    edits = Edits(source)
    _pulled_out(source, parsed, edits)
    _over_backs(source, parsed, edits)
    _set_tables(source, parsed, edits)
    _fires(source, parsed, edits)
    _untold(source, parsed, edits)
    _parts_of(source, parsed, edits)
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
    if after and "noun" in vocabulary().get(f"{found['state']} {noun}", {}):
        return  # "broken glass", "crumpled paper" are things of their own
    spoken, noun = noun, _thing(noun)
    apart = text[:start].rstrip()[-1:] in ("", ",", ".", "(")
    if not after and apart and _meant(noun, found["state"], part) is None:
        noun = _able_before(text, start, found["state"], part) or noun
    state = _meant(noun, found["state"], part)
    # "The wardrobe open" is its doors, "open shelves" have none.
    for opened in ("drawer",) if singular(spoken).endswith("drawer") else ("door", "lid"):
        if state is None and not groups.get("part") and not after:
            part = opened
            state = _meant(noun, found["state"], part) if opened != "lid" or _has_lid(noun) else None
    if state is None or (state.becomes and _OVER_FLOOR.match(text, end)):
        return  # what lies scattered over the floor is told as an amount, of all that is listed
    if found["state"] in state.after and (after or not re.search(r"[a-z]\s+$", text[:start] + " ")):
        return
    many = groups.get("many")
    share = _SHARE.search(text[:start]) if not many and not after and not part else None
    if share is not None:  # "one of the two beds is unmade": the number is of this alone
        many = share["many"]
        edits.take(share.start("many"), share.start("rest"))
    count = (number_of(many), number_of(many)) if many and not part else None
    said = " ".join(text[start:end].split())
    value = f"{groups.get('part') or part} {found['state']}".strip()
    behind = re.compile(r"\s+".join(map(re.escape, spoken.split()))).search(text, end)
    if after and noun != spoken and behind is not None:
        # "rumpled linen bedding": the noun goes, what else is said of it is told
        between = " ".join(text[end : behind.end() - len(spoken.split()[-1])].split())
        parsed.unread += [Left(between, span=source.span(end, behind.end()))] if between else []
        end = behind.end()
    span = edits.take(start, end)
    attribute = Attribute(kind="state", value=value, words=said, count=count, span=span)
    parsed.states.append(Told(attribute, noun, after, named=True))


def _untold(source: Source, parsed: Parsed, edits: Edits) -> None:
    """What is said of a thing and nothing shows: "a cup full of tea", "without arms", "turned away from the table"."""
    for pattern in _unseen():
        for found in list(pattern.finditer(source.text)):
            noun = found.groupdict().get("noun") or thing_before(source.text, found.start())
            if not noun:
                continue
            start = found.start("said")
            said = " ".join(found["said"].split())
            span = edits.take(start, found.end())
            what = Attribute(kind="state", value=said, words=said, span=span)
            parsed.states.append(Told(what, noun, after=False, named=True))


def _pulled_out(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "A chair pulled out by 40 cm from the desk": it is at the desk, and as far off."""
    for found in list(_PULLED.finditer(source.text)):
        noun = noun_behind(source.text, found.start("said"))
        noun = noun if is_thing(noun) else thing_before(source.text, found.start("said"))
        if not noun or "chair_group" not in groups_above(match_of(noun).category) and "stool" not in noun:
            continue
        far = plain_length(found["length"]) if found["length"] else FAR
        start, end = found.span("said")
        said = " ".join(found["said"].split())
        span = edits.take(start, end + (5 if found["from"] else 0), "at" if found["from"] else "")
        what = Attribute(kind="state", value=f"{PULLED_OUT} {far:g}", words=said, span=span)
        parsed.states.append(Told(what, noun, after=False, named=True))


def _over_backs(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "A coat slung over the back of the chair": it is on the chair, and hangs over its back."""
    for found in list(_OVER_BACK.finditer(source.text)):
        noun = noun_before(source.text, found.start())
        if not noun or _meant(noun, OVER_BACK, "") is None:
            continue
        span = edits.take(*found.span(), "on it" if found["own"] else "on")
        what = Attribute(kind="state", value=OVER_BACK, words=OVER_BACK, span=span)
        parsed.states.append(Told(what, noun, after=False, named=True))


def _fires(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "A fire burns in the stove", "a stove with a fire in it": it is lit."""
    for found in list(_FIRE.finditer(source.text)):
        it = found["it"] is not None
        noun = noun_before(source.text, found.start()) if it else noun_after(source.text, found.end())[0]
        if not noun or _meant(noun, LIT, "") is None:
            continue
        span = edits.take(*found.span(), "" if it else "the")
        what = Attribute(kind="state", value=LIT, words=" ".join(found[0].split()), span=span)
        parsed.states.append(Told(what, noun, after=not it, named=True))


def _set_tables(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "The table is laid for six": it is a table for six, with a place laid for each."""
    for found in list(_SET.finditer(source.text)):
        noun = noun_before(source.text, found.start())
        if not noun or not has_role(match_of(_thing(noun)).category, "dining_table"):
            continue
        end = found.end("said") if found["many"] else found.end()
        span = edits.take(found.start(), end)
        many = number_of(found["many"]) if found["many"] else 0
        what = Attribute(kind="state", value=f"{LAID_FOR} {many}", words=" ".join(found[0].split()), span=span)
        parsed.states.append(Told(what, noun, after=False, named=True))


def _parts_of(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "One drawer of the dresser is pulled out": the dresser is there, with one drawer out."""
    for found in list(_part_of_owner().finditer(source.text)):
        noun, part = found["owner"].partition(" ")[2], singular(found["part"])
        if _meant(noun, found["state"], part) is None:
            continue
        edits.take(*found.span("of"))
        span = edits.take(*found.span("be"))
        value = f"{found['part']} {found['state']}"
        what = Attribute(kind="state", value=value, words=" ".join(found[0].split()), span=span)
        parsed.states.append(Told(what, noun, after=False, named=True))


@cache
def _part_of_owner() -> re.Pattern[str]:
    opened = one_of(list({word for row in states() for word in row.words if row.part}))
    return re.compile(
        r"\b(?P<of>(?:(?:one|a|an|the|its|top|bottom|lowest|middle|both|all|two|every|upper|lower)\s){0,2}"
        rf"(?P<part>drawers?|doors?|lids?)\sof\s)(?P<owner>(?:the|a|an|my|our|his|her|their)\s(?:[a-z]+\s){{0,2}}?"
        rf"[a-z]+)(?P<be>\s{_BE}(?P<state>{opened}))\b"
    )


@cache
def _unseen() -> tuple[re.Pattern[str], ...]:
    vessels, parts = one_of(words("states")["vessels"]), one_of(words("states")["lacking"])
    return (
        re.compile(rf"(?P<noun>\b{vessels})\s(?P<said>(?:half\s)?(?:full\sof|filled\swith)\s(?:hot\s|cold\s)?[a-z]+)"),
        re.compile(rf"(?P<said>\b(?:without|with\sno)\s(?:any\s)?{parts}\b)"),
        re.compile(
            r"(?P<said>\b(?:turned|facing|turning)\s(?:away|around|round|aside)"
            r"(?:\sfrom\s(?:the|each|it)\s?[a-z]*)?)"
        ),
    )


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
    for name in filter(None, dict.fromkeys((noun, singular(noun)))):  # "glasses" may be spectacles, a glass is not
        match = match_of(name)
        state = None if match.how == "generic" else state_of(match.category, word, part)
        if state is not None:
            return state
    return None


def _has_lid(noun: str) -> bool:
    """Whether something that is open has its lid open: a box has, a book has none."""
    return bool(noun) and bool(
        groups_above(match_of(noun).category) & {"container", "storage", "cookware", "appliance", "sanitary"}
    )


@cache
def _patterns() -> tuple[re.Pattern[str], ...]:
    spoken = one_of(list({word for row in states() for word in row.words if not row.part}))
    behind = one_of(list({word for row in states() for word in row.after}))
    opened = one_of(list({word for row in states() for word in row.words if row.part}))
    alone = one_of(["ajar", "open", "opened", "half open", "wide open", "slightly open"])
    part = r"(?P<part>drawers?|doors?|lids?)"
    return tuple(
        re.compile(pattern)
        for pattern in (
            r"\b(?:(?:one|a|an|the|its|top|bottom|both|all|two|every|with|and)\s){0,3}"
            rf"(?:(?P<noun>[a-z]+)\s)?{part}\s{_BE}(?P<state>{opened})\b",
            rf"\b{_MANY}{_BE}(?P<state>{spoken})\b{_NOT_OVER}",
            rf"\b{_BE}(?P<state>{alone}){_END}",
            rf"\b{_BE}(?P<state>{behind}){_END}",
        )
    )


__all__ = ["read_states"]
