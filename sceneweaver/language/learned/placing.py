"""Where things are, as the learned analysis finds it beside the relations of the rules."""

from __future__ import annotations

import re
from collections.abc import Callable

from ..model import Span
from ..parsed import Mention, Parsed, Said
from ..relating import relate
from ..state import State
from ..vocabulary import Place
from .analysis import Link
from .matched import SURE, SURER, UNSAID, Matched, below, overlap

TYPES = {
    "on": "on", "in": "inside", "under": "below", "above": "above", "beside": "next_to", "near": "near",
    "far": "far_from", "left": "left_of", "right": "right_of", "front": "in_front_of", "behind": "behind",
    "facing": "facing", "opposite": "opposite", "against": "against", "along": "along", "between": "between",
    "around": "around", "at": "at", "flank": "flanking", "center": "centered_on", "sees": "facing",
}  # fmt: skip
"""Types of relations by links."""

SPOKEN = {
    "beside": "next to", "far": "far from", "left": "to the left of", "right": "to the right of",
    "front": "in front of", "center": "in the middle of", "flank": "on each side of", "sees": "facing",
}  # fmt: skip
"""How a link is said in a plain sentence; the others by their own name."""

MUTUAL = frozenset(("beside", "near", "far", "facing", "opposite", "sees"))
"""Links that say the same of both."""

BESIDE = ("beside", "near", "left", "right", "flank")
"""Links of what is next to something."""

HOLDING = ("on", "inside", "hanging_from", "leaning_on")
"""Types of relations of a thing to what holds it."""

REACH = 16
"""Characters from two mentions to the words that tell of each one."""

PHRASE = 40
"""Characters of a phrase of place at most."""

_EACH = re.compile(
    r"\b(?:(?:on|at|to)\s+)?(?:each|every|either|both|per|own)(?:\s+(?:one|of|sides?|ends?|own))*\b", re.I
)
_TIED = re.compile(r"\b(?:at|around|to|by|for|with|each|its|own|per|every|behind|before|under|along|in|of)\b", re.I)
_SIDE = re.compile(r"\b(?:left|right)$")
_GLAZED = re.compile(r"window|light|dormer|pane|glass")


def place(both: Matched, plain: Callable[[str], Parsed]) -> None:
    """Where things are."""
    state = State([], both.source, both.parsed)
    between: dict[Mention, list[tuple[Mention, Link]]] = {}
    for link, one, other in list(both.where()):
        thing, target = both.things.get(one), both.things.get(other)
        least = SURER if _is_used(both, link.other) else SURE
        if link.sure < least or thing is None or thing not in both.parsed.mentions:
            continue
        if target is not None and target is not thing:
            if link.name == "between":
                between.setdefault(thing, []).append((target, link))
            elif not (_is_said(both, link, thing, target) or _is_listed(both, link) or _has(both, link, thing)):
                kind = Place(TYPES[link.name], words=SPOKEN.get(link.name, link.name))
                beside = _table_beside(both.parsed, thing, target) if link.name in BESIDE else None
                if beside is not None:  # "a bed with a table and a lamp at either side"
                    kind, target = Place("on", words="on"), beside
                    many = beside.count or ((2, 2) if link.name == "flank" else None)
                    thing.count = many if thing.count in (None, (1, 1)) else thing.count
                relate(state, kind, [thing], (target,), _span(both, link))
                cover(both, link)
        elif both.kind(other) in ("place", "opening"):
            both.parsed.said += _said_plainly(both, link, thing, other, plain)
    for thing, pairs in between.items():
        targets = tuple(dict.fromkeys(target for target, _ in pairs))
        known = any(said.type == "between" and thing in said.subjects for said in both.parsed.said)
        if not known and (len(targets) > 1 or targets[0].many):
            relate(state, Place("between", words="between"), [thing], targets[:2], _span(both, pairs[0][1]))


def _table_beside(parsed: Parsed, thing: Mention, target: Mention) -> Mention | None:
    """What stands beside something that a small thing is to be beside as well, and can hold it."""
    if thing.mount != "surface" or target.mount != "floor" or target.family in ("table", "storage"):
        return None
    types = {TYPES[name] for name in BESIDE}
    beside = [m for said in parsed.said if said.type in types and target in said.targets for m in said.subjects]
    return next((m for m in beside if m is not thing and m.mount == "floor" and m.family in ("table", "storage")), None)


def cover(both: Matched, link: Link) -> None:
    """Words by which a link is told of each one or each side are understood with it."""
    start, end = sorted((both.span(link.one), both.span(link.other)))
    for found in _EACH.finditer(both.text, max(0, start.start - REACH), end.end + REACH):
        apart = both.text[min(found.end(), end.end) : max(found.start(), start.start)]
        if not re.search(r"[.;!?\n]", apart):
            both.parsed.referred.append(Span(*found.span()))


def _has(both: Matched, link: Link, thing: Mention) -> bool:
    """Whether the rules have such a relation of a thing to another, of which there is one: what holds it, its sides."""
    kind = TYPES[link.name]
    alike = HOLDING if kind in HOLDING else (kind,)
    return any(said.type in alike and thing in said.subjects and not said.implied for said in both.parsed.said)


def _is_listed(both: Matched, link: Link) -> bool:
    """Whether a seat and a table are only named one after the other: which seats are at which is known of the room."""
    first, second = sorted((both.span(link.one), both.span(link.other)))
    return link.name == "at" and not _TIED.search(both.text[first.end : second.start])


def _is_said(both: Matched, link: Link, thing: Mention, target: Mention) -> bool:
    """Whether something is said of two things already, or denied."""
    for said in (*both.parsed.said, *both.parsed.barred):
        if thing in said.subjects and (target in said.targets or (target in said.subjects and len(said.subjects) > 1)):
            return True
        if link.name in MUTUAL and target in said.subjects and thing in said.targets:
            return True
    return False


def _is_placed(both: Matched, thing: Mention, place: int, part: str) -> bool:
    """Whether it is said already, or denied, that a thing is at a place that is named there, or at one like it."""
    for said in (*both.parsed.said, *both.parsed.barred):
        target = said.targets[0] if said.targets else None
        if thing not in said.subjects or said.implied:
            continue
        alike = isinstance(target, str) and target.partition(":")[0] == part.partition(":")[0]
        if alike or overlap(said.span, both.span(place)):
            return True
    return False


def _is_used(both: Matched, place: int) -> bool:
    """Whether the rules took the words of a place, or what stands for a thing there, for where something else is."""
    return any(_is_said_of(said, both.span(place)) for said in both.parsed.said if not said.implied)


def _is_said_of(said: Said, place: Span) -> bool:
    """Whether a relation is told by the words right before a noun, or by the noun."""
    return said.span is not None and overlap(Span(said.span.start, said.span.end + REACH), place)


def drop_doubted(both: Matched) -> None:
    """Relations that only follow from "with" and that the analysis takes for nothing."""
    for said in [said for said in both.parsed.said if said.implied]:
        others = [target for target in said.targets if isinstance(target, Mention)]
        if others and len(others) == len(said.targets):
            doubted = [m for m in said.subjects if below(both.related([m], others), UNSAID)]
            said.subjects = [m for m in said.subjects if m not in doubted]
            if not said.subjects:
                both.parsed.said.remove(said)


def _said_plainly(both: Matched, link: Link, thing: Mention, other: int, plain: Callable[[str], Parsed]) -> list[Said]:
    """What a plain sentence says of something and a place of the room or an opening."""
    where, end = both.words(other), both.span(other).end
    told_by = [to.other for to in both.found.links if to.name == "from" and to.one == other and to.other >= 0]
    if told_by and 0 <= both.span(told_by[0]).start - end < PHRASE:
        where = both.text[both.span(other).start : both.span(told_by[0]).end].lower()
    noun = thing.noun if thing.mount != "surface" else "chair"
    found = list[Said]()
    for spoken, words in (
        (SPOKEN.get(link.name, link.name), where),
        (SPOKEN.get(link.name, link.name), "window" if _GLAZED.search(where) else "door"),
        ("against", f"{where} wall"),
    ):
        if spoken == "against" and not _SIDE.search(where) or words == "door" and both.kind(other) != "opening":
            continue
        read = plain(f"A {noun} {spoken} the {words}.")
        found = [said for said in read.said if all(isinstance(target, str) for target in said.targets)]
        if found:
            break
    return [
        Said(said.type, [thing], said.targets, said.words, side=said.side, span=_span(both, link), params=said.params)
        for said in found[:1]
        if not said.implied and not _is_placed(both, thing, other, str(said.targets[0]))
    ]


def _span(both: Matched, link: Link) -> Span:
    """Where a link is said: from behind the thing to the end of what it is placed by, if that is one phrase."""
    one, other = both.span(link.one), both.span(link.other)
    between = both.text[one.end : other.start]
    if one.end < other.start and not re.search(r"[.;:!?\n]", between):
        start = other.start - len(between.lstrip(" ,"))
        if other.end - start <= PHRASE:
            return Span(start, other.end)
    return other
