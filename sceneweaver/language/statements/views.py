"""What people see from their seats: "everyone can see the board", "nobody sits with their back to the door"."""

from __future__ import annotations

import re
from functools import cache
from typing import Literal

from sceneweaver.assets.roles import has_role

from ..model import FreeArea, View
from ..nothings import may_name
from ..parsed import Parsed
from ..source import Source
from ..things import match_of, singular
from ..vocabulary import family, vocabulary, words
from .phrases import NUMBER, Edits, listed, noun_after, noun_before, one_of, table_before

ViewKind = Literal["see", "face", "not_back_to", "back_to"]

_SEE = r"(?:see|look at|watch|have a (?:good |clear |free )?view (?:of|to)|follow|view)"
_CAN = r"(?: (?:can|could|must|should|has to|have to|needs to|need to|will|is able to|are able to))?(?: be able to)?"
_THE = r"(?:the |an? |his |her |their |our |my )?"
_BACKS = rf"(?:his|her|their|its|the|a|any|my|your|our|w/)? ?backs?(?: turned)? (?:to|towards?|on|against) {_THE}"


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], ViewKind], ...]:
    people = one_of(listed("people"))
    all_ = (
        rf"(?:every ?(?:one|body)|all(?: of (?:us|them))?(?: {people}|{_N_PEOPLE})?|each(?: of them)?|every {people}"
        rf"|(?:all )?(?:the )?{people}|every (?:seat|chair|place)|all (?:the )?(?:seats|chairs|places)|they all|we all)"
    )
    nobody = (
        rf"(?:nobody|no ?one|none(?: of (?:us|them))?|no (?:{people}|seat|chair|place|desk)|not? any(?:one|body)"
        rf"|never (?:any(?:one|body)|a seat))"
    )
    rows: tuple[tuple[str, ViewKind], ...] = (
        (
            rf"{nobody}{_CAN}(?: (?:sit|sits|sitting|be|has|have|having|is|facing|with))*(?: with)? {_BACKS}",
            "not_back_to",
        ),
        (
            rf"(?:not|never|without(?: anyone)?|i (?:do not|don't|dont) want(?: to sit)?)(?: (?:sit|sitting|having))?"
            rf"(?: with)? {_BACKS}",
            "not_back_to",
        ),
        (rf"{all_}{_CAN} (?:be )?(?:face|facing|faces|look(?:s|ing)? (?:at|to|towards?)|turned to) {_THE}", "face"),
        (rf"{all_}{_CAN} (?:with |w/ ?|has |have |sits? with |sitting with ){_BACKS}", "back_to"),
        (rf"(?:so (?:that )?|where |and |, )?{all_}{_CAN} {_SEE} {_THE}", "see"),
        (
            rf"(?:with )?(?:a )?(?:good|clear|free|unobstructed|full) (?:view|sight) (?:of|to|on) {_THE}",
            "see",
        ),
    )
    lead = r",? ?(?:\b(?:and|but|so that|so|where|because|as) )?"
    return tuple((re.compile(rf"{lead}\b{pattern}"), kind) for pattern, kind in rows)


_N_PEOPLE = rf" {NUMBER}(?: [a-z]+)?"


def views(source: Source, parsed: Parsed) -> None:
    """Reads what is seen from seats, and what nobody has at their back; see `View`."""
    edits = Edits(source)
    for m in _OUT.finditer(source.text):
        edits.take(m.start(), m.end(), "facing the window")
    for m in _staff().finditer(source.text):
        _behind(m, edits, parsed)
    for pattern, kind in _patterns():
        for m in pattern.finditer(source.text):
            if edits.free(m.start(), m.end()):
                _read(m, kind, edits, parsed)


def _read(m: re.Match[str], kind: ViewKind, edits: Edits, parsed: Parsed) -> None:
    text = edits.source.text
    noun, end = noun_after(text, m.end())
    target, known = _target(noun)
    if not target:
        if each := re.compile(r"(?:and )?(?:each other|one another)\b").match(text, m.end()):
            target, end, known = "each other", each.end(), False
        else:
            return
    both = re.compile(r",? and (?:each other|one another)\b").match(text, end)
    if both is not None:
        parsed.views.append(View(target="each other", kind=kind, words=both[0], span=edits.source.span(*both.span())))
        edits.take(both.start(), both.end())
    before = noun_before(text, m.start())
    entity = before if before and _seats(before) and not _OF_ALL.search(m[0]) else ""
    # A thing that only these words name stays, so that there is one; a place or a person is no thing.
    named = known and re.search(rf"\b{re.escape(noun.split()[-1])}\b", text[: m.start()] + " " + text[end:]) is None
    span = edits.source.span(m.start(), end)
    words_ = text[m.start() : end].strip(" ,")
    instead = f", a {noun}" if named and len(noun) + 4 <= end - m.start() else ""
    edits.take(m.start(), end, instead)
    parsed.views.append(View(entity=entity, target=target, kind=kind, words=words_, span=span))


@cache
def _staff() -> re.Pattern[str]:
    who = one_of([*words("asides")["roles"], *listed("people")])
    return re.compile(
        rf",? ?\b(?:and |with )?(?:the |an? |one )?{who}(?: (?:standing|sitting|working|is|stands|works|sits))*"
        r" behind (?:it|them|the (?P<what>[a-z]+(?: [a-z]+)?))(?=\s*(?:$|[.,;()]|and\b|with\b))"
    )


def _behind(m: re.Match[str], edits: Edits, parsed: Parsed) -> None:
    """ "The cook behind it": who works behind a counter has a way there."""
    noun = m["what"] or table_before(edits.source.text, m.start())
    staffed = noun.endswith(("counter", "bar")) or (noun and has_role(match_of(singular(noun)).category, "staffed"))
    if staffed:
        words_ = m[0].strip(" ,")
        span = edits.take(m.start(), m.end())
        area = FreeArea(kind="clearance", size=(STAFF, STAFF), targets=(noun,), side="back", words=words_, span=span)
        parsed.free_areas.append(area)


STAFF = 0.8
"""Way [m] for who works behind a counter."""


def _target(noun: str) -> tuple[str, bool]:
    """What a noun means that is looked at, and whether it is a thing: the place of a person is where they are."""
    last = singular(noun.split()[-1]) if noun else ""
    if not last:
        return "", False
    at: dict[str, str] = words("people")["place_of"]
    if last in at:
        return at[last], False
    kinds = vocabulary().get(last, {})
    if last in _PLACES:
        return _PLACES[last], False
    if "noun" not in kinds and ("room" in kinds or (match_of(singular(noun)).how == "generic" and not may_name(last))):
        return "", False
    return noun, True


_OUT = re.compile(
    r"\b(?:looking|facing|look|turned) (?:out )?(?:on|onto|over|at|to|into|of|towards?) (?:the |a )?"
    r"(?:street|garden|sea|yard|courtyard|outside|park|valley|mountains|lake|square|road|river|city|skyline)\b"
)
"""What is outside is seen through the window."""

_OF_ALL = re.compile(r"\b(?:every ?(?:one|body)|all|nobody|no ?one|none|anyone)\b")
"""Words that a view is said with of all seats, whatever was named last."""

_PLACES = {"door": "door", "entrance": "door", "window": "window", "room": "middle", "middle": "middle",
           "centre": "middle", "center": "middle", "wall": "wall"}  # fmt: skip


def _seats(noun: str) -> bool:
    return family(match_of(singular(noun)).category) == "seat"


__all__ = ["views"]
