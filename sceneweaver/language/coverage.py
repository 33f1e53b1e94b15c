"""Which words of a request nothing in its graph accounts for.

Every content word is part of something that was read (a thing, what it is like, where it is, what the room is) or is
told to the user as not understood. Words of grammar and of politeness need no account; they are data
(``lexicon/function_words.yaml``).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cache
from itertools import pairwise

from .model import SceneGraph, Span, Unread
from .translation import content_words, unknown_words
from .vocabulary import NUMBERS, vocabulary, words

WORD = re.compile(r"\b[^\W\d_]\d\b|[^\W\d_]+(?:['’&-][^\W\d_]+)*|\d+(?:[.,]\d+)?", re.UNICODE)
_NUMERAL = re.compile(r"\d+(?:\.\d+)?")
UNITS = (1.0, 0.01, 0.001, 0.3048, 0.0254, 0.092903)
"""What the units are in metres and square metres that numbers are given in."""

_PART = re.compile(r"[\s-]+")
"""What stands between the words of a compound, which a name has without hyphens: an "x-ray viewer"."""
_STOP = re.compile(r"[.;:!?\n]")
_JOIN = re.compile(r"[\s'’\"-]*")
BREAK = re.compile(r"[.,;:!?()\n]")


def silent_words(
    graph: SceneGraph,
    language: str = "en",
    referred: Iterable[Span] = (),
    slips: Mapping[str, str] | None = None,
    told: Mapping[Span, float] | None = None,
) -> tuple[Unread, ...]:
    """The words of the text that no item of the graph accounts for, neighbours together, in order.

    Time grows with the length of the text.

    Args:
        graph: what was read of it.
        language: that it was read in.
        referred: where what was named before is named again.
        slips: words with a slip of the pen, and what was meant.
        told: numbers of several words, by where these stand.
    """
    numbers = (span for span, value in (told or {}).items() if _is_measure(graph, f"{value:g}"))
    covered = marked(graph, (*spans_read(graph), *referred, *numbers, *_refusing(graph)))
    if language != "en":
        covered = marked(graph, (*spans_read(graph), *(entity.span for entity in graph.entities)))
        return _silent_foreign(graph, language, covered)
    known, named = _known_elsewhere(graph), marked(graph, (entity.span for entity in graph.entities))
    found: list[list[int]] = []
    for match in WORD.finditer(graph.text):
        word = match[0].lower().replace("’", "'")
        if any(covered[match.start() : match.end()]):
            continue
        meant = (slips or {}).get(word, word)
        if _tells(graph, match, meant, known):
            pass  # "nothing between the two": with nothing that was read of it, it is lost
        elif meant in known or all(part in function_words() or part in known for part in _PART.split(meant)):
            continue
        if any(named[match.start() : match.end()]) and (word[0].isdecimal() or _counts(word)):
            continue
        if (word[0].isdecimal() or word in NUMBERS) and _is_measure(graph, word):
            continue
        if meant in postures() and _says_where(graph.text, covered, match.end()):
            continue
        if found and _JOIN.fullmatch(graph.text, found[-1][1], match.start()):
            found[-1][1] = match.end()
        else:
            found.append([match.start(), match.end()])
    return tuple(Unread(words=graph.text[a:b].lower(), span=Span(a, b)) for a, b in found)


def _refusing(graph: SceneGraph) -> Iterable[Span]:
    """Where the words of refusing stand in the sentences that rule something out: "hate", "anywhere", "are out"."""
    ends = [-1, *(match.start() for match in _STOP.finditer(graph.text)), len(graph.text)]
    ruled = [one.span for one in graph.exclusions if one.span is not None]
    for start, end in pairwise(ends):
        here = [span for span in ruled if start < span.start < end]
        for match in _refusals().finditer(graph.text, start + 1, end) if here else ():
            if any(_is_beside(graph.text, match, span) for span in here):
                yield Span(*match.span())


def _is_beside(text: str, match: re.Match[str], span: Span) -> bool:
    """Whether words are right before or right behind what was ruled out, but for words of grammar."""
    a, b = (match.end(), span.start) if match.end() <= span.start else (span.end, match.start())
    between = text[a:b] if a < b else ""
    return not BREAK.search(between) and all(
        word[0].lower() in function_words() or _refusals().fullmatch(word[0]) for word in WORD.finditer(between)
    )


@cache
def _refusals() -> re.Pattern[str]:
    data = words("refusals")
    phrases = {phrase for phrase, kinds in vocabulary().items() if "neg" in kinds}
    phrases |= {*data["refused"], *data["keep"], *data["stressed"], *data["strictly"], *data["stressing"]} - {"a"}
    listed = "|".join(re.escape(phrase).replace(r"\ ", r"[\s-]+") for phrase in sorted(phrases, key=len, reverse=True))
    return re.compile(rf"(?<![\w'-])(?:{listed})(?![\w'])", re.IGNORECASE)


def _silent_foreign(graph: SceneGraph, language: str, covered: Sequence[int]) -> tuple[Unread, ...]:
    """Words of another language that no table has, and nouns and adjectives that no item of the graph accounts for."""
    text = graph.text.lower()
    if len(text) != len(graph.text):  # letters that are two in small
        return ()
    idle = function_words() | _known_elsewhere(graph)
    idle |= {word for entity in graph.entities for word in entity.category.split("_")}
    lost = unknown_words(text, language)
    lost += [(a, b) for english, a, b in content_words(text, language) if not _is_idle(english, idle)]
    told = sorted((a, b) for a, b in lost if not any(covered[a:b]))
    return tuple(Unread(words=text[a:b], span=Span(a, b)) for a, b in told)


def _is_idle(english: str, idle: Collection[str]) -> bool:
    """Whether the English of a word needs no account: a kind of room, which the graph has, or words of grammar."""
    return "room" in vocabulary().get(english, {}) or all(
        word in idle or word.removesuffix("s") in idle for word in english.split()
    )


def _says_where(text: str, covered: Sequence[int], start: int) -> bool:
    """Whether the words from a character on are, but for those of grammar, words that were read: "sits right on it"."""
    for match in WORD.finditer(text, start):
        if any(covered[match.start() : match.end()]):
            return _STOP.search(text, start, match.start()) is None
        if match[0].lower() not in function_words():
            return False
    return False


def _tells(graph: SceneGraph, match: re.Match[str], word: str, known: frozenset[str]) -> bool:
    """Whether a word of grammar says where something is, or that nothing is there, with nothing read of it."""
    rows = words("bearing_words")
    if word not in rows["telling"].split():
        return False
    bare = word in rows["nothing_there"].split()
    if word in known and not bare:
        return False
    follows = graph.text[match.end() :].lower().split()[:1]
    if follows and follows[0].strip(".,;:!?") in rows["telling_not_before"].split():
        return False
    return not bare or not (graph.only or graph.density != "normal" or _said_of(graph, word))


def _said_of(graph: SceneGraph, word: str) -> bool:
    """Whether something that was read has the word, wherever that stands."""
    said = [one.words for one in (*graph.relations, *graph.exclusions, *graph.looks, *graph.free_areas)]
    said += [a.words for entity in graph.entities for a in entity.attributes]
    return any(word in text.lower().split() for text in said)


def _counts(word: str) -> bool:
    """Whether a word before a noun says how many there are, or bounds it, which the number of the things tells."""
    told = [vocabulary().get(part, {}).keys() for part in word.split("-")]  # "twenty-two" is of two numbers
    counts = [not kinds.isdisjoint(("number", "amount", "collective", "bound")) for kinds in told]
    return word in words("quantities")["counting"] or all(counts)


@cache
def function_words() -> frozenset[str]:
    """Words that say nothing of what is in a room: articles, pronouns, auxiliaries, politeness."""
    return frozenset(word for group in words("function_words").values() for word in group.split())


@cache
def postures() -> frozenset[str]:
    """Words for how a thing is somewhere: it sits, hangs, is placed."""
    participles = words("relations")["verbs"]["participles"].values()
    return frozenset(
        (*words("bearing_words")["postures"].split(), *(word for several in participles for word in several))
    )


@cache
def idle_words() -> frozenset[str]:
    """Those of `function_words` that say nothing of a thing either: no places and no measures."""
    groups = words("function_words")
    return function_words().difference(*(groups[name].split() for name in ("nouns_of_place", "units", "room_quality")))


def marked(graph: SceneGraph, spans: Iterable[Span | None]) -> bytearray:
    """One for each character of the text that is in some of the spans, else zero."""
    found = bytearray(len(graph.text) + 1)
    for span in spans:
        if span is not None:
            found[span.start : span.end] = b"\x01" * (min(span.end, len(graph.text)) - span.start)
    return found


def spans_read(graph: SceneGraph, unread: bool = True) -> Iterable[Span]:
    """Where everything that was read stands, but for the noun phrases of things; what is ``unread`` as well."""
    rows = (
        graph.relations,
        graph.exclusions,
        graph.openings,
        graph.free_areas,
        graph.capacities,
        graph.views,
        graph.amounts,
        graph.looks,
        graph.finishes,
    )
    for row in (
        item
        for several in (*rows, graph.arrangements, graph.measures, graph.unread if unread else ())
        for item in several
    ):
        if row.span is not None:
            yield row.span
    for one in graph.arrangements:
        yield from one.more
    for entity in graph.entities:
        yield from (attribute.span for attribute in entity.attributes if attribute.span is not None)


def _known_elsewhere(graph: SceneGraph) -> frozenset[str]:
    """Words of facts about the room, which have no place of their own."""
    said = [graph.room_words, graph.style or "", graph.shape or "", *graph.colors, *graph.for_whom]
    said += [name.replace("_", " ") for name in graph.other_rooms]
    said += [said.words for said in (*graph.relations, *graph.exclusions)]
    said += [target.replace(":", " ") for one in (*graph.relations, *graph.free_areas) for target in one.targets]
    said += ["center centre"] if any("middle" in one.targets for one in (*graph.relations, *graph.free_areas)) else []
    said += [f"{target}s" for one in graph.relations for target in one.targets if target == "corner"]
    said += [word for entity in graph.entities for word in (entity.noun, *entity.words)]
    said += [a.words for entity in graph.entities for a in entity.attributes]
    if graph.wing is not None:
        said += [*words("openings")["wings"], "l l-shaped shaped shape form main"]
    spoken = frozenset(word for text in said for word in WORD.findall(text.lower()))
    if graph.scale != 1.0 or graph.density != "normal" or graph.only:
        spoken |= frozenset(" ".join(words("function_words").get("room_quality", "").split()).split())
    return spoken


def _is_measure(graph: SceneGraph, word: str) -> bool:
    """Whether a number is one of the room's sides, its area, its height or a measure that was read; one in words only
    where it is the room's, as small numbers are many things."""
    value = float(NUMBERS[word] if word in NUMBERS else word.replace(",", "."))
    have = [*(graph.size or ()), graph.area or 0.0, graph.height or 0.0, float(graph.people or 0)]
    have += [*(graph.wing or ())]
    if word in NUMBERS:
        return _is_one_of(value, have)
    have += [side for area in graph.free_areas for side in area.size]
    have += [float(number) for left in graph.unread for number in _NUMERAL.findall(left.words)]
    have += [float(graph.doors or 0), float(graph.windows or 0)]
    have += [float(n) for entity in graph.entities for n in entity.count or ()]
    have += [float(s) for entity in graph.entities for s in entity.size if s is not None]
    have += [float(value) for relation in graph.relations for value in relation.params.values() if value is not None]
    have += [value for one in graph.arrangements for value in (one.spacing, one.pitch, one.height, one.aisle) if value]
    return _is_one_of(value, have)


def _is_one_of(value: float, have: Sequence[float]) -> bool:
    """Whether a number is one of some, in any of the units."""
    return any(abs(value * unit - other) <= 0.006 * max(1.0, other) for unit in UNITS for other in have if other)


__all__ = ["function_words", "idle_words", "marked", "silent_words", "spans_read"]
