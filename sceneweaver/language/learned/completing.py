"""What the learned analysis adds to what the rules read: what is there, where, what each has, what stays free."""

from __future__ import annotations

import re
from collections.abc import Callable

from sceneweaver.assets.plurals import singular

from ..exclusions import names_of
from ..model import Span
from ..parsed import Left, Mention, Parsed, Said
from ..relating import relate
from ..source import Source
from ..state import State
from ..vocabulary import NUMBERS, Place, vocabulary
from .analysis import Analysis, Link
from .free_floor import keep_free
from .labels import WHERE
from .matched import Matched, overlap
from .room import tell_of_room

SURE, SURER = 0.55, 0.8
"""How sure a link is that is added; where the rules took its words for something else."""

DOUBTED, LOOSE = 0.02, 0.1
"""How sure the analysis is at most of a relation of the rules that is dropped; of one that only follows from "with", or
of what was counted out over a group."""

CERTAIN = 0.85
"""How sure it is of a thing that the rules did not read, or of what they took for one."""

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

REACH = 16
"""Characters from two mentions to the words that tell of each one."""

PHRASE = 40
"""Characters of a phrase of place at most."""

_EACH = re.compile(
    r"\b(?:(?:on|at|to)\s+)?(?:each|every|either|both|per|own)(?:\s+(?:one|of|sides?|ends?|own))*\b", re.I
)
_SIDE = re.compile(r"\b(?:left|right)$")
_GLAZED = re.compile(r"window|light|dormer|pane|glass")
_BEFORE = re.compile(r"(?<![\w.,])(\d{1,3}|[a-z-]+)\s+$")


def complete(parsed: Parsed, source: Source, text: str, found: Analysis, plain: Callable[[str], Parsed]) -> None:
    """Adds what an analysis found and the rules did not read; takes out what they took for something else.

    Args:
        parsed: what the rules read; it is changed.
        source: of the request.
        text: the request.
        found: what the network found in it.
        plain: reads a plain sentence by the rules.
    """
    both = Matched(text, source, parsed, found)
    _rule_out(both)
    _leave_out(both)
    _add_things(both, plain)
    _count_back(both)
    _drop_doubted(both)
    _place(both, plain)
    _count_out(both)
    keep_free(both, SURE)
    tell_of_room(both, SURE)


def _rule_out(both: Matched) -> None:
    """What must not be there, where no rule read it so and nothing of its name is wanted."""
    parsed = both.parsed
    for number, named in enumerate(both.found.named):
        words = both.words(number).split()
        placed = any(link.one == number and link.name in WHERE for link in both.found.links)
        if named.kind != "unwanted" or named.sure < CERTAIN or placed:  # "no shelves above the crib"
            continue
        over = [m for m in parsed.mentions if overlap(m.span, named.span)]
        alike = [m for m in parsed.mentions if m not in over and _head(m.noun) == _head(words[-1])]
        denied = any(_head(m.noun) == _head(words[-1]) for one in parsed.barred for m in one.subjects)
        names = names_of(" ".join(words))
        if names and not (alike or denied or any(m.numbered for m in over) or _is_read(both, named.span)):
            _take_out(both, over)
            parsed.without.append((" ".join(words), names, named.span))


def _head(noun: str) -> str:
    """The last word of a noun, of one thing."""
    return singular(noun.split()[-1])


def _is_read(both: Matched, span: Span) -> bool:
    """Whether a statement of the rules has words, that things are made of neither way."""
    parsed = both.parsed
    statements = (
        *(parsed.unwanted, parsed.barred, parsed.stated_openings, parsed.finishes, parsed.capacities),
        *(parsed.arrangements, parsed.views, parsed.amounts, parsed.limits, parsed.roles, parsed.free_areas),
    )
    spans = (*(one.span for of in statements for one in of), *parsed.referred, *(one[2] for one in parsed.without))
    return any(overlap(one, span) for one in spans)


def _leave_out(both: Matched) -> None:
    """What the rules took for a thing and the analysis for something else, or for nothing."""
    for mention in list(both.parsed.mentions):
        if mention.span is None or mention.implied:
            continue
        over = [named for named in both.found.named if overlap(named.span, mention.span)]
        other = over and all(n.kind not in ("thing", "reference", "unwanted") and n.sure > CERTAIN for n in over)
        if other and mention.generic:
            _take_out(both, [mention])
            both.parsed.unread.append(Left(mention.noun, span=mention.span))


def _take_out(both: Matched, mentions: list[Mention]) -> None:
    parsed = both.parsed
    parsed.mentions = [m for m in parsed.mentions if m not in mentions]
    parsed.said = [s for s in parsed.said if not any(m in mentions for m in (*s.subjects, *s.targets))]
    for other in parsed.mentions:
        other.per = None if other.per in mentions else other.per


def _add_things(both: Matched, plain: Callable[[str], Parsed]) -> None:
    """Things that no rule read, as a plain sentence names them."""
    parsed = both.parsed
    for number, named in enumerate(both.found.named):
        if named.kind != "thing" or number in both.things:
            continue
        if (again := _named_again(both, number)) is not None:
            both.things[number] = again
            continue
        if named.sure < CERTAIN or _is_read(both, named.span) or _is_part(both.words(number)):
            continue
        start = _phrase_start(both, number)
        phrase = both.text[start : named.span.end]
        read = plain(f"There is {phrase if start < named.span.start else 'a ' + phrase}.")
        if len(read.mentions) == 1 and not read.mentions[0].generic:
            added = read.mentions[0].copied(span=named.span)
            added.attributes = [a.model_copy(update={"span": None}) for a in added.attributes]
            parsed.mentions.append(added)
            parsed.unread = [left for left in parsed.unread if not _is_of(left, both, named.span)]
            both.things[number] = added


def _named_again(both: Matched, number: int) -> Mention | None:
    """What a noun means that the rules made nothing of, as it is named elsewhere: "his side of the bed"."""
    if any(_is_of(left, both, both.span(number)) for left in both.parsed.unread):
        return None
    head = _head(both.words(number))
    return next((mention for mention in both.parsed.mentions if _head(mention.noun) == head), None)


def _is_part(words: str) -> bool:
    """Whether a noun names a part of something and no thing by itself: drawers."""
    kinds = {*vocabulary().get(words, {}), *vocabulary().get(_head(words), {})}
    return "part" in kinds and "noun" not in kinds


def _phrase_start(both: Matched, number: int) -> int:
    """Where the phrase of a noun begins: with its number and with the qualities right before it."""
    start = both.span(number).start
    qualities = [link.one for link in both.found.links if link.name == "of" and link.other == number]
    for one in sorted(qualities, key=lambda k: -both.span(k).start):
        if both.kind(one) == "quality" and not both.text[both.span(one).end : start].strip(" ,-"):
            start = both.span(one).start
    counted = _BEFORE.search(both.text.lower(), max(0, start - 20), start)
    return counted.start() if counted and (counted[1].isdecimal() or counted[1] in NUMBERS) else start


def _is_of(left: Left, both: Matched, span: Span) -> bool:
    return overlap(left.span or (both.source.span(left.start, left.end) if left.end > left.start else None), span)


def _place(both: Matched, plain: Callable[[str], Parsed]) -> None:
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
            elif not _is_said(both.parsed, link.name, thing, target):
                place = Place(TYPES[link.name], words=SPOKEN.get(link.name, link.name))
                beside = _table_beside(both.parsed, thing, target) if link.name in BESIDE else None
                if beside is not None:  # "nightstand and lamp each side"
                    place, target = Place("on", words="on"), beside
                    many = beside.count or ((2, 2) if link.name == "flank" else None)
                    thing.count = many if thing.count in (None, (1, 1)) else thing.count
                relate(state, place, [thing], (target,), _span(both, link))
                _cover(both, link)
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


def _cover(both: Matched, link: Link) -> None:
    """Words by which a link is told of each one or each side are understood with it."""
    start, end = sorted((both.span(link.one), both.span(link.other)))
    for found in _EACH.finditer(both.text, max(0, start.start - REACH), end.end + REACH):
        apart = both.text[min(found.end(), end.end) : max(found.start(), start.start)]
        if not re.search(r"[.;!?\n]", apart):
            both.parsed.referred.append(Span(*found.span()))


def _is_said(parsed: Parsed, name: str, thing: Mention, target: Mention) -> bool:
    """Whether something is said of two things already, or denied."""
    for said in (*parsed.said, *parsed.barred):
        if thing in said.subjects and (target in said.targets or (target in said.subjects and len(said.subjects) > 1)):
            return True
        if name in MUTUAL and target in said.subjects and thing in said.targets:
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
    return any(overlap(said.span, both.span(place)) for said in both.parsed.said if not said.implied)


def _drop_doubted(both: Matched) -> None:
    """What the rules said of where things are and the analysis takes for nothing."""
    for said in list(both.parsed.said):
        others = [target for target in said.targets if isinstance(target, Mention)]
        least = LOOSE if said.implied else DOUBTED
        if len(others) == len(said.targets):
            doubted = [m for m in said.subjects if _below(both.related([m], others), least)]
        elif not others and said.span is not None:
            doubted = [m for m in said.subjects if _below(both.placed(m, said.span), least)]
        else:
            continue
        said.subjects = [m for m in said.subjects if m not in doubted]
        if not said.subjects:
            both.parsed.said.remove(said)


def _below(sure: float | None, least: float) -> bool:
    return sure is not None and sure < least


def _count_back(both: Matched) -> None:
    """What the rules counted out over a group where the analysis finds nothing of each of them."""
    for mention in both.parsed.mentions:
        group = mention.per
        if group is None or mention.count is None or mention.span is None:
            continue
        if _number_in(both, mention.span.start, mention.span.end) > 1:  # "four mats, one for each of four chairs"
            continue
        if not _below(both.each(group, mention), LOOSE):
            continue
        low, high = group.count or (1, 1)
        mention.per = None
        if low == high > 1 and mention.count[0] % low == 0 and mention.count[1] % low == 0:
            mention.count = (mention.count[0] // low, mention.count[1] // low)


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


def _count_out(both: Matched) -> None:
    """So many of a thing for every one of its owners, where its own number was not told."""
    for link in both.found.links:
        owner, number = both.found.meant(link.one), both.found.meant(link.other) if link.other >= 0 else -1
        thing = both.things.get(number)
        if link.name != "each" or link.sure < SURE or thing is None or thing.per is not None:
            continue
        group = both.things.get(owner)
        if group is None and both.kind(owner) == "person":
            many = number_of_people(both, owner)
        else:
            low, high = (group.count if group is not None else None) or (1, 1)
            many = low if low == high else 1
        if many > 1 and thing.count in (None, (1, 1)) and not thing.plural:
            thing.count, thing.per = (many, many), group
            _cover(both, link)


def number_of_people(both: Matched, number: int) -> int:
    """How many a mention of people is told to be; of a mention that is said again, the first that tells."""
    words = both.words(number).split()[-1].rstrip("s")
    people = [k for k, named in enumerate(both.found.named) if named.kind == "person"]
    alike = [k for k in people if both.words(k).split()[-1][:4] == words[:4]]
    numbers = (_number_in(both, both.span(one).start, both.span(one).start) for one in (number, *alike))
    return next((many for many in numbers if many > 1), 1)


def _number_in(both: Matched, start: int, end: int) -> int:
    """The number that is told in some words or shortly before them; 1 where none is."""
    spoken = re.split(r"[.,;:!?()\n]", both.text[max(0, start - 30) : start].lower())[-1]
    words = [
        *re.findall(r"\d{1,3}|[a-z'-]+", spoken)[-3:],
        *re.findall(r"\d{1,3}|[a-z'-]+", both.text[start:end].lower()),
    ]
    numbers = (int(word) if word.isdecimal() else NUMBERS.get(word, 1) for word in reversed(words))
    return next((many for many in numbers if many > 1), 1)
