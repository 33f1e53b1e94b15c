"""What a model read of a request, checked: the form that the offline reader gives its graph from as well.

Whatever is wrong is said in a sentence that names the item and the fix (``problems``), and left out of the draft, so
that the same pass tells a model what to mend and takes what is left once it is not asked again.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from sceneweaver.assets.taxonomy import narrower
from sceneweaver.scene.messages import quote as shown

from ..graph import MOST
from ..model import Attribute, Span
from ..parsed import Left, Mention, Parsed
from ..source import Source
from ..things import match_of
from ..vocabulary import vocabulary
from ..vocabulary import words as lexicon
from .english import LONGEST, cut, english, excluded_categories, is_color, part_of_room
from .quotes import Quotes
from .reply import ExclusionReply, RequestReply, ThingReply, WordReply

WORDS = 24
"""Most words about one thing."""

SIZES = (0.005, 20.0)
"""Least and most length [m] of a thing."""

SCALES = (0.3, 2.0)
"""Least and most factor on a usual size."""

ENDLESS = 10**6
"""A count that stands for all that are larger: what is made of it is far less."""

OUT, OPEN = "it was left out", "it was left open"
NOWHERE = "it is kept without its place in the text"
"""What becomes of what stays wrong."""

OPENINGS = ("window", "door")


@dataclass
class Draft:
    """A reply in the form of the offline reader.

    ``places`` are ids that the model gave to parts of the room, ``problems`` what is wrong with what becomes of it,
    ``doubts`` what may be wrong, ``marked`` where the words stand of which the model said what they are.
    """

    text: str
    parsed: Parsed
    source: Source
    things: dict[str, Mention] = field(default_factory=dict)
    names: dict[str, list[str]] = field(default_factory=dict)
    places: dict[str, str] = field(default_factory=dict)
    problems: dict[str, str] = field(default_factory=dict)
    doubts: list[str] = field(default_factory=list)
    marked: list[Span] = field(default_factory=list)


class Things:
    """Puts the things of a reply, what they are like and what must not be there into a draft."""

    def __init__(self, reply: RequestReply, quotes: Quotes, draft: Draft) -> None:
        self._reply, self._quotes, self._draft = reply, quotes, draft
        self._taken: set[Span] = set()

    def run(self) -> None:
        """All of them, in the order of the reply."""
        draft, reply = self._draft, self._reply
        for thing in reply.things[:MOST]:
            self._thing(thing)
        if len(reply.things) > MOST:
            draft.problems[f"things: there are {len(reply.things)}; name at most {MOST} kinds"] = (
                "the rest was left out"
            )
            for thing in reply.things[MOST : 2 * MOST]:
                draft.parsed.unread.append(Left(cut(thing.quote or thing.name)))
        for number, excluded in enumerate(reply.exclusions[:MOST]):
            self._excluded(number, excluded)
        for quote in reply.unread[:MOST]:
            span = self._quotes.nearest(quote, None)
            left = Left(cut(quote, 4 * LONGEST), *(span or (0, 0)))
            draft.parsed.unread.append(left)

    def _thing(self, thing: ThingReply) -> None:
        draft, name = self._draft, english(thing.name)
        where = f"thing {shown(cut(thing.id))}"
        if not thing.id or not (name or thing.quote):
            draft.problems[f"{where}: give it an id, a name in English and its words in the request"] = OUT
            return
        if thing.id in draft.things or thing.id in draft.places:
            draft.problems[f"{where}: the id is there already; each thing has its own"] = OUT
            return
        if (place := part_of_room(name)) is not None:
            draft.places[thing.id] = place
            self._opening(place, thing)
            return
        if not name:
            problem = f"{where}: name {shown(cut(thing.name))} is not English; say what it is in English"
            draft.problems[problem] = "it is kept under its own words"
        span = self._span(where, thing.quote)
        match = match_of(name or cut(thing.quote).lower())
        noun = cut(thing.quote, 2 * LONGEST) or name
        mention = Mention(noun, match.category, generic=match.how == "generic", implied=thing.implied, span=span)
        if mention.generic:
            draft.doubts.append(
                f"{where}: no furniture is known as {shown(name)}; "
                "if a more usual English noun means the same give that, else say it again"
            )
        mention.count = counted(thing.count, where, draft.problems)
        self._size(mention, thing, where)
        for word in thing.words[:WORDS]:
            self._word(mention, word, where)
        if thing.scale is not None:
            mention.scale = _within(thing.scale, SCALES, f"{where}: scale", draft.problems) or 1.0
        if not mention.generic:
            spoken = " ".join(a.value for a in mention.attributes)
            mention.category = narrower(mention.category, spoken, name)
        draft.things[thing.id] = mention
        for known in {name, mention.category, mention.category.replace("_", " "), thing.quote.lower()}:
            draft.names.setdefault(known, []).append(thing.id)
        draft.parsed.mentions.append(mention)

    def _opening(self, place: str, thing: ThingReply) -> None:
        """Windows and doors among the things are so many windows and doors of the room."""
        if place in OPENINGS and thing.count and 0 <= thing.count[0] <= 40:
            self._draft.parsed.openings.setdefault(place, thing.count[0])
        if (span := self._quotes.nearest(thing.quote, None)) is not None:
            self._draft.marked.append(span)

    def _span(self, where: str, quote: str) -> Span | None:
        span = self._quotes.next(quote, self._taken)
        if span is None:
            problem = f"{where}: {shown(cut(quote))} is not in the request; copy its noun exactly as it stands there"
            self._draft.problems[problem] = NOWHERE
            return None
        self._taken.add(span)
        if span.end - span.start <= LONGEST:  # who quotes a sentence did not say what each of its words is
            self._draft.marked.append(span)
        return span

    def _size(self, mention: Mention, thing: ThingReply, where: str) -> None:
        for axis, name in enumerate(("depth", "width", "height")):
            if (length := getattr(thing, name)) is not None:
                mention.size[axis] = _within(length, SIZES, f"{where}: {name}", self._draft.problems, " m")

    def _word(self, mention: Mention, word: WordReply, where: str) -> None:
        value = " ".join(re.sub(r"[_\-]+", " ", word.value.lower()[:LONGEST]).split())
        value = lexicon("nouns")["made_of"].get(value, value)
        if not value:
            return
        kind, span = word.kind, self._quotes.nearest(word.quote, mention.span) if word.quote else None
        if word.quote and span is None:
            problem = (
                f"{where}: {shown(cut(word.quote))} is not in the request; copy the word for {shown(value)} from it"
            )
            self._draft.problems[problem] = NOWHERE
        if kind == "color" and not is_color(value):
            problem = f"{where}: color {shown(value)} is unknown; use a plain English colour"
            self._draft.problems[problem] = "it is kept as a plain word"
            kind = "other"
        count = counted(word.count, f"{where}, {value}", self._draft.problems)
        spoken = cut(word.quote, 2 * LONGEST) or value
        mention.attributes.append(Attribute(kind=kind, value=value, words=spoken, count=count, span=span))
        if span is not None:
            self._draft.marked.append(span)
        if count is not None:
            return  # it is said of some of them
        meant = vocabulary().get(value, {})
        if kind == "color":
            mention.color = mention.color or value
        elif kind == "material":
            mention.material = mention.material or value
        elif kind == "style":
            mention.style = mention.style or meant.get("styles")
        elif kind == "size" and "scale" in meant:
            mention.scale = float(meant["scale"])
        else:
            mention.words.append(value)

    def _excluded(self, number: int, excluded: ExclusionReply) -> None:
        draft, where = self._draft, f"exclusion {number}"
        span = self._quotes.nearest(excluded.quote, None)
        if span is None:
            draft.problems[f"{where}: {shown(cut(excluded.quote))} is not in the request; copy its words"] = NOWHERE
        else:
            draft.marked.append(span)
        names = [name for given in excluded.names[:WORDS] if (name := english(given))]
        if not names:
            draft.problems[f"{where}: say in English what must not be there"] = OUT
            draft.parsed.unread.append(Left(cut(excluded.quote), *(span or (0, 0))))
            return
        for place in [name for name in names if part_of_room(name) in OPENINGS]:
            draft.parsed.openings[str(part_of_room(place))] = 0
            names.remove(place)
        found = tuple(dict.fromkeys(category for name in names for category in excluded_categories(name)))
        if found:
            draft.parsed.without.append((cut(excluded.quote, 2 * LONGEST) or names[0], found, span))


def counted(count: tuple[int, ...] | None, where: str, problems: dict[str, str]) -> tuple[int, int] | None:
    """Least and most; None where they make no sense. Too many are cut later, with a note."""
    if count is None:
        return None
    low, high = count
    if not 0 <= low <= high:
        problem = f"{where}: count [{low}, {high}] is none; say [least, most] with 0 <= least <= most, or null"
        problems[problem] = OPEN
        return None
    return min(low, ENDLESS), min(high, ENDLESS)


def _within(
    value: float, bounds: tuple[float, float], where: str, problems: dict[str, str], unit: str = ""
) -> float | None:
    low, high = bounds
    if low <= value <= high:
        return value
    problems[f"{where} {value:g}{unit} cannot be; it is between {low:g} and {high:g}{unit}, or null"] = OPEN
    return None
