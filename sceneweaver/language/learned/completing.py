"""What the learned analysis adds to what the rules read: what is there, where, what each has, what stays free."""

from __future__ import annotations

import re
from collections.abc import Callable

from sceneweaver.assets.plurals import singular

from ..exclusions import names_of
from ..model import Span
from ..parsed import Left, Mention, Parsed
from ..source import Source
from ..vocabulary import NUMBERS, vocabulary
from .analysis import Analysis
from .free_floor import keep_free
from .labels import WHERE
from .matched import CERTAIN, DOUBTED, SURE, Matched, below, overlap
from .placing import cover, drop_doubted, place
from .room import tell_of_room

_OWN = re.compile(r"\b(?:each|every|own|per|its|their)\b", re.I)
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
    drop_doubted(both)
    place(both, plain)
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
    """Whether a statement of the rules took some words, so that they name no thing more."""
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
    """What a noun means that the rules made nothing of, as it is named elsewhere: "up to the far edge of the tub"."""
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


def _count_back(both: Matched) -> None:
    """What the rules counted out over a group where the analysis finds nothing of each of them."""
    for mention in both.parsed.mentions:
        group = mention.per
        if group is None or mention.count is None or mention.span is None:
            continue
        told = _OWN.search(both.text, max(0, mention.span.start - 12), mention.span.end)  # "its own mirror"
        if told or _number_in(both, mention.span.start, mention.span.end) > 1:  # "four mats, one for each chair"
            continue
        if not below(both.each(group, mention), DOUBTED):
            continue
        low, high = group.count or (1, 1)
        mention.per = None
        if low == high > 1 and mention.count[0] % low == 0 and mention.count[1] % low == 0:
            mention.count = (mention.count[0] // low, mention.count[1] // low)


def _count_out(both: Matched) -> None:
    """So many of a thing for every one of its owners, where its own number was not told."""
    for link in both.found.links:
        owner, number = both.found.meant(link.one), both.found.meant(link.other) if link.other >= 0 else -1
        thing = both.things.get(number)
        if link.name != "each" or link.sure < SURE or thing is None or thing.per is not None:
            continue
        group = both.things.get(owner)
        if group is None and both.kind(owner) == "person":
            many = _number_of_people(both, owner)
        else:
            low, high = (group.count if group is not None else None) or (1, 1)
            many = low if low == high else 1
        if many > 1 and thing.count in (None, (1, 1)) and not thing.plural:
            thing.count, thing.per = (many, many), group
            cover(both, link)


def _number_of_people(both: Matched, number: int) -> int:
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
