"""What a model read of a request, checked: the form that the offline reader gives its graph from as well.

Whatever is wrong is said in a sentence that names the item and the fix (``problems``), and left out of the draft, so
that the same pass tells a model what to mend and takes what is left once it is not asked again.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from sceneweaver.assets.taxonomy import narrower
from sceneweaver.io.messages import quote as shown

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

    ``things`` are by the ids that the model gave them, ``names`` the ids by name, ``places`` parts of the room by id,
    ``problems`` what is wrong with what becomes of it, ``doubts`` what may be wrong, ``marked`` where the words stand
    of which the model said what they are.
    """

    quotes: Quotes
    source: Source
    parsed: Parsed = field(default_factory=Parsed)
    things: dict[str, Mention] = field(default_factory=dict)
    names: dict[str, list[str]] = field(default_factory=dict)
    places: dict[str, str] = field(default_factory=dict)
    problems: dict[str, str] = field(default_factory=dict)
    doubts: list[str] = field(default_factory=list)
    marked: list[Span] = field(default_factory=list)

    def find(self, quote: str, near: Span | None = None, problem: str = "", then: str = NOWHERE) -> Span | None:
        """Where a quote stands, nearest to another; it is marked, or a problem where it is nowhere."""
        span = self.quotes.nearest(quote, near) if quote else None
        if span is not None:
            self.marked.append(span)
        elif quote and problem:
            self.problems[problem] = then
        return span

    def leave_unread(self, quote: str, most: int) -> None:
        """Words of the request that say nothing that could be read."""
        self.parsed.unread.append(Left(cut(quote, most), *(self.quotes.nearest(quote, None) or (0, 0))))


def add_things(reply: RequestReply, draft: Draft) -> None:
    """Puts the things of a reply, what they are like and what must not be there into a draft."""
    taken: set[Span] = set()
    for thing in reply.things[:MOST]:
        _add_thing(thing, draft, taken)
    if len(reply.things) > MOST:
        draft.problems[f"things: there are {len(reply.things)}; name at most {MOST} kinds"] = "the rest was left out"
        draft.parsed.unread += [Left(cut(thing.quote or thing.name)) for thing in reply.things[MOST : 2 * MOST]]
    for number, excluded in enumerate(reply.exclusions[:MOST]):
        _exclude(number, excluded, draft)
    for quote in reply.unread[:MOST]:
        draft.leave_unread(quote, 4 * LONGEST)


def _add_thing(thing: ThingReply, draft: Draft, taken: set[Span]) -> None:
    name = english(thing.name)
    where = f"thing {shown(cut(thing.id))}"
    if not thing.id or not (name or thing.quote):
        draft.problems[f"{where}: give it an id, a name in English and its words in the request"] = OUT
        return
    if thing.id in draft.things or thing.id in draft.places:
        draft.problems[f"{where}: the id is there already; each thing has its own"] = OUT
        return
    if (place := part_of_room(name)) is not None:  # windows and doors are so many of the room
        draft.places[thing.id] = place
        if place in OPENINGS and thing.count and 0 <= thing.count[0] <= 40:
            draft.parsed.openings.setdefault(place, thing.count[0])
        draft.find(thing.quote)
        return
    if not name:
        problem = f"{where}: name {shown(cut(thing.name))} is not English; say what it is in English"
        draft.problems[problem] = "it is kept under its own words"
    span = _span(where, thing.quote, draft, taken)
    match = match_of(name or cut(thing.quote).lower())
    noun = cut(thing.quote, 2 * LONGEST) or name
    mention = Mention(noun, match.category, generic=match.how == "generic", implied=thing.implied, span=span)
    if mention.generic:
        draft.doubts.append(
            f"{where}: no furniture is known as {shown(name)}; "
            "if a more usual English noun means the same give that, else say it again"
        )
    mention.count = counted(thing.count, where, draft.problems)
    for axis, name_of_axis in enumerate(("depth", "width", "height")):
        if (length := getattr(thing, name_of_axis)) is not None:
            mention.size[axis] = _within(length, SIZES, f"{where}: {name_of_axis}", draft.problems, " m")
    for word in thing.words[:WORDS]:
        _describe(mention, word, where, draft)
    if thing.scale is not None:
        mention.scale = _within(thing.scale, SCALES, f"{where}: scale", draft.problems) or 1.0
    if not mention.generic:
        spoken = " ".join(a.value for a in mention.attributes)
        mention.category = narrower(mention.category, spoken, name)
    draft.things[thing.id] = mention
    for known in {name, mention.category, mention.category.replace("_", " "), thing.quote.lower()}:
        draft.names.setdefault(known, []).append(thing.id)
    draft.parsed.mentions.append(mention)


def _span(where: str, quote: str, draft: Draft, taken: set[Span]) -> Span | None:
    """Where the noun of a thing stands: at the first place that is no other thing's."""
    span = draft.quotes.next(quote, taken)
    if span is None:
        problem = f"{where}: {shown(cut(quote))} is not in the request; copy its noun exactly as it stands there"
        draft.problems[problem] = NOWHERE
        return None
    taken.add(span)
    if span.end - span.start <= LONGEST:  # who quotes a sentence did not say what each of its words is
        draft.marked.append(span)
    return span


def _describe(mention: Mention, word: WordReply, where: str, draft: Draft) -> None:
    value = " ".join(re.sub(r"[_\-]+", " ", word.value.lower()[:LONGEST]).split())
    value = lexicon("nouns")["made_of"].get(value, value)
    if not value:
        return
    problem = f"{where}: {shown(cut(word.quote))} is not in the request; copy the word for {shown(value)} from it"
    kind, span = word.kind, draft.find(word.quote, mention.span, problem)
    if kind == "color" and not is_color(value):
        problem = f"{where}: color {shown(value)} is unknown; use a plain English colour"
        draft.problems[problem] = "it is kept as a plain word"
        kind = "other"
    count = counted(word.count, f"{where}, {value}", draft.problems)
    spoken = cut(word.quote, 2 * LONGEST) or value
    mention.attributes.append(Attribute(kind=kind, value=value, words=spoken, count=count, span=span))
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


def _exclude(number: int, excluded: ExclusionReply, draft: Draft) -> None:
    where = f"exclusion {number}"
    span = draft.find(excluded.quote)
    if span is None:
        draft.problems[f"{where}: {shown(cut(excluded.quote))} is not in the request; copy its words"] = NOWHERE
    names = [name for given in excluded.names[:WORDS] if (name := english(given))]
    if not names:
        draft.problems[f"{where}: say in English what must not be there"] = OUT
        draft.leave_unread(excluded.quote, LONGEST)
        return
    places = {name: place for name in names if (place := part_of_room(name)) in OPENINGS}
    draft.parsed.openings |= dict.fromkeys(map(str, places.values()), 0)
    things = [name for name in names if name not in places]
    found = tuple(dict.fromkeys(category for name in things for category in excluded_categories(name)))
    if found:
        draft.parsed.without.append((cut(excluded.quote, 2 * LONGEST) or things[0], found, span))


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
