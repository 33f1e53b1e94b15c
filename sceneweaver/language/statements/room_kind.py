"""What kind of room a request is about, where it does not just name it.

"A room to lift weights", "studio for recording vocals", "the bridge of a cargo ship", "... it's the waiting area of a
vet": the words that a request begins with, or a sentence that says what all of it is, are taken apart into the name of
the room, what it is for and where it is. Names and purposes of all kinds of rooms (`knowledge.purposes`) tell which is
meant. A room that is named stays what it is; where it stands ("for our office", "in a hotel") names no other room. What
is also another room ("that doubles as an office", "with a sewing corner") gets the furniture which makes that one.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cache

from sceneweaver.knowledge.learned import learned_words
from sceneweaver.knowledge.likely import likeliest_room, told_by
from sceneweaver.knowledge.load import room_types, room_words
from sceneweaver.knowledge.purposes import Found, core_of, kinds_meant, stem, stemmed_heads, stems

from ..model import Span
from ..parsed import Left, Mention, Parsed, Said, Zone
from ..source import Source
from ..spelling import mended
from ..vocabulary import Verb, category_of, family, vocabulary, words
from .phrases import one_of

ENOUGH = 3.2
"""Least score [nats] at which words tell a kind of room: one word that about 14 kinds share."""

TELLING = 0.5
"""Share of the things of a request that are of a kind of room for them to tell it."""

LONGEST = 5
"""Words of the longest name of a room."""

CLOSE = 0.8
"""Share of the best score from which on the things of a request decide between kinds."""

_WEIGHTS = {"core": 1.0, "purpose": 0.95, "whole": 0.75, "setting": 0.4}
_ARTICLE = r"(?:an? |the |our |my |your |their |his |her |its |some |one )?"
_CLAUSE_ENDS = r"(?=\s*(?:[.,:;!?\n(]|$))"
_WAYS = (("verbs", "into"), ("uses", "as"), ("be", "to_be"))
"""What tells that a room became another one, and what stands before the name of the latter."""

EARLY = 240
"""Characters of a request within which a name alone tells the kind of its room."""

_SIZED = re.compile(
    r"(?:(?<=[.;:!?\n] )|(?<=\n)|^)(?:an? |the |our |my |one )?(?P<name>[a-z][a-z' -]{2,50}?),? \(?"
    r"(?:of |about |around |approx |roughly |ca )?\d+(?:[.,]\d+)?\s?(?:(?:m|metres?|meters?|ft|feet|')\s?)?"
    r"(?:(?:x|by|\*)\s?\d|m2|sqm|sq\b|square)"
)
_FRAGMENT = re.compile(
    r"(?:(?<=[,.;:!?\n] )|(?<=\n))(?:an? |the |our |my )?(?P<name>[a-z][a-z' -]{2,50})(?=[,.;:!?\n])"
)

_WORD = re.compile(r"[^\W\d_]+(?:['-][^\W\d_]+)*")


@dataclass(frozen=True)
class _Part:
    """Characters [start, end) of a phrase about the room: its name, what it is for, what it is of, where it is."""

    kind: str
    start: int
    end: int
    text: str


def read_room_kind(source: Source, parsed: Parsed) -> None:
    """Reads the kind of the room, and what else it is; see above. Words that are accounted for leave the source."""
    if (work := _work().match(source.text)) is not None:
        _leave_out(source, parsed, *work.span("work"))
    _zones(source, parsed)
    _other_kinds(source, parsed)
    for m in list(_tail().finditer(source.text)):
        if _named(_WORD.findall(m["name"])):
            _leave_out(source, parsed, *m.span("tail"))
    if any(re.search(rf"(?<!\w){re.escape(name)}(?!\w)", source.spoken) for name in learned_words()):
        return  # the clauses know the kinds of rooms that the user has learned
    for m in _becomes().finditer(source.spoken):
        parts = _parts(source.spoken, m.end(), _end(source.spoken, m.end()))
        if m["be"] is not None and not (parts and _named(_WORD.findall(parts[0].text))):
            continue  # "the table is to be red"
        if _before(m, source.spoken) and _decided(source, parsed, parts, headline=False):
            _leave_out(source, parsed, m.start(), m.end())
            return
    for start, end, headline in _phrases_about_room(source.spoken):
        parts = _parts(source.spoken, start, end)
        if _decided(source, parsed, parts, headline):
            return


def _phrases_about_room(text: str) -> list[tuple[int, int, bool]]:
    """Where a text may say what its room is, the surest first: where a name has the measures of a floor behind it, at
    the beginning, alone between commas, and where a sentence says what all of it is."""
    first = _opener().match(text)
    start = first.end() if first is not None else 0
    end = _end(text, start)
    core = _parts(text, start, end)[:1]
    named = _named(_WORD.findall(core[0].text)) if core and core[0].kind == "core" else ""
    found = [(a, z, False) for a, z in _measured(text) if a >= end]
    found += [] if named else [(a, z, False) for a, z in _alone(text) if a >= end]
    found.append((start, end, True))
    found += [(a, z, False) for a, z in _sentences(text) if a > end]
    found += [(m.end(), _end(text, m.end()), False) for m in _statement().finditer(text)]
    return [one for one in found if one[1] > one[0]]


def _measured(text: str) -> list[tuple[int, int]]:
    """The name of a room that a sentence begins with and that the measures of a floor follow: "GP waiting room, 8 x 5
    m"; the first one."""
    found = (m.span("name") for m in _SIZED.finditer(text))
    rooms = (one for one in found if _is_name(text[slice(*one)]))
    named = ((one, _named(_WORD.findall(text[slice(*one)]))) for one in rooms)
    return [one for one, name in named if "noun" not in _kinds(name)][:1]  # "low stage, 3 x 2 m"


def _sentences(text: str) -> list[tuple[int, int]]:
    """The names of rooms that later sentences begin with, after what a request may begin with; and rooms of which such
    a sentence says what they are for."""
    found: list[tuple[int, int]] = []
    for m in re.finditer(r"[.:!?\n]\s+", text[:EARLY]):
        opened = _opener().match(text, m.end())
        start = opened.end() if opened is not None else m.end()
        parts = _parts(text, start, _end(text, start))
        if not parts or parts[0].kind != "core":
            continue
        bare = _WORD.findall(parts[0].text)[-1:] in (["room"], ["place"], ["somewhere"])
        if _is_name(parts[0].text):
            found.append((start, parts[0].end))
        elif bare and any(part.kind == "purpose" for part in parts):
            found.append((start, parts[-1].end))
    return found


def _alone(text: str) -> list[tuple[int, int]]:
    """The name of a room between commas or stops, in the first sentences, where it is the only one."""
    found = [m.span("name") for m in _FRAGMENT.finditer(text, 0, EARLY)]
    found = [one for one in found if _is_name(text[slice(*one)], loose=False)]
    return found if len(found) == 1 else []


def _is_name(text: str, loose: bool = True) -> bool:
    """Whether words are the name of a room with no more than what it is like before it."""
    spoken = _WORD.findall(text)
    named = _named(spoken)
    shell = words("built_parts")["not_built"]["ceiling_shape"]["words"]  # "low brick vault" alone is a ceiling
    if not named or not (loose or named not in (*words("room_kind")["loose"], *shell)) or len(spoken) > LONGEST:
        return False
    others = ("noun", "room", "group", "pron", "det", *_NOT_IN_NAMES)
    before = [w for w in spoken[: len(spoken) - len(named.split())] if w not in words("room_kind")["buildings"]]
    return all(_kinds(word).keys().isdisjoint(others) for word in before)


def _before(m: re.Match[str], text: str) -> bool:
    """Whether what became another room is one itself: a garage that is used as a gym, not a sofa used as a bed."""
    spoken = _WORD.findall(m["verbs"] or m["uses"] or m["be"] or "") or _WORD.findall(
        re.split(r"[.;!?]", text[: m.start()])[-1]
    )
    return not spoken or any(
        "room" in kinds or kinds.get("place") == "room" or word in words("room_kind")["heads"]
        for word in spoken
        for kinds in (_kinds(word),)
    )


def _end(text: str, start: int) -> int:
    found = _ending().search(text, start)
    return found.start() if found is not None else len(text)


def _parts(text: str, start: int, end: int) -> list[_Part]:
    """The name of a room and what is tied to it, in order."""
    cuts: list[tuple[str, int, int]] = [("core", start, start)]
    for m in _tie().finditer(text, start, end):
        kind = next(name for name in ("purpose", "whole", "setting") if m[name])
        cuts.append((kind, m.start(), m.end()))
    ends = [cut[1] for cut in cuts[1:]] + [end]
    return [_Part(kind, a, z, text[b:z]) for (kind, a, b), z in zip(cuts, ends, strict=True) if z > a]


def _decided(source: Source, parsed: Parsed, parts: list[_Part], headline: bool) -> bool:
    """Whether a phrase tells the kind of the room, which is then set."""
    if not parts:
        return False
    core = parts[0] if parts[0].kind == "core" else None
    spoken = _WORD.findall(core.text) if core is not None else []
    named = _named(spoken)
    joined = _joined_by_things(source.spoken, named)
    if joined and not _is_something_else(spoken, bare=True):
        _set(source, parsed, joined, core, parts[:1], parts, exact=False)
        return True
    if named and named not in words("room_kind")["loose"]:
        longer = _joined(named, parts[1:])
        things = any("noun" in _kinds(word) for word in spoken[: -len(named.split())])
        last = list(_WORD.finditer(source.spoken, core.start, core.end))[-1].span() if core is not None else (0, 0)
        there = core is None or source.text[slice(*last)].strip() != ""  # a snug may have been read as a look
        if headline and there and not longer and not things and not _run_on(spoken, named):
            _blank_settings(source, parsed, parts[1:])
            return True  # the clauses read it
        _set(source, parsed, longer or room_words()[named], core, parts if longer else parts[:1], parts, exact=True)
        return True
    if not named and len(parts) == 1 and any(" ".join(spoken[:n]) in room_words() for n in range(1, len(spoken))):
        return headline  # other languages have what it is like behind it
    bare = not spoken or bool(named) or not {spoken[0], spoken[-1]}.isdisjoint(words("room_kind")["heads"])
    if _is_something_else(spoken, bare):
        return False
    headless = _without_head(parts) if spoken and bare and len(spoken) + len(parts) > 2 else parts
    alone = bool(named) and headless is parts
    found = (
        None
        if alone
        else _best(source.spoken, headless, bare) or (_best(source.spoken, parts, bare) if not named else None)
    )
    if found is not None and named and all(_is_person(told) for told in found.told):
        found = None  # the workshop of my uncle
    if found is not None and named and found.kind == room_words()[named]:
        return True
    if found is None and named:
        strange = any(not _kinds(word) or "whom" in _kinds(word) for word in spoken[: -len(named.split())])
        if not _belied(source, parsed, parts, named) and headline and strange:
            _set(source, parsed, room_words()[named], core, parts[:1], parts, exact=True)
        return headline
    if found is None and headline and bare:
        _blank_settings(source, parsed, parts[1:])
        return _unknown(source, parsed, spoken, parts)
    if found is None:
        return False
    _set(source, parsed, found.kind, core, parts, parts, exact=found.named and not found.told - _told(parts[:1]))
    return True


def _is_person(told: str) -> bool:
    """Whether what told a kind of room is whose it is, as a stem."""
    return any(stem(word) == told for word in _whose())


@cache
def _whose() -> frozenset[str]:
    return frozenset(words("room_kind")["kin"])


def _without_head(parts: list[_Part]) -> list[_Part]:
    """The parts without the last word of the name: of a surgery of a dentist the dentist tells."""
    core = parts[0]
    head = list(_WORD.finditer(core.text))[-1]
    return [replace(core, text=core.text[: head.start()]), *parts[1:]]


def _belied(source: Source, parsed: Parsed, parts: list[_Part], named: str) -> bool:
    """Whether a name that is loose is none of the room's kind, as its things are of another: a hall with lathes."""
    things = set(_things(source.spoken))
    likely = likeliest_room(things) if named in words("room_kind")["vague"] else None
    if likely is None or len(things) < 2 or told_by(things, room_types()[room_words()[named]]) > 0.0:
        return False
    if told_by(things, likely) < TELLING:
        return False
    _set(source, parsed, likely.name, parts[0], parts[:1], parts, exact=False)
    return True


_NOT_IN_NAMES = ("verb", "number", "amount", "preposition", "with", "modal", "place_adverb")
"""What no word of the name of a room is, so that words with one are a clause about something else."""


def _is_something_else(spoken: list[str], bare: bool) -> bool:
    """Whether words name no room: a thing, a part of a room, a clause."""
    if not spoken:
        return False
    if len(spoken) > LONGEST or " ".join(spoken) in words("room_kind")["openers"]:
        return True
    heads = words("room_kind")["heads"]
    last = spoken[-1] if spoken[-1] in vocabulary() else mended(spoken[-1], []) or spoken[-1]
    for at in range(len(spoken)):
        known = _kinds(" ".join([*spoken[at:-1], last]))
        if last in heads and at == len(spoken) - 1 > 0:
            continue  # a booth of some kind
        if known.keys() & {"group", "region"} or ("noun" in known and "room" not in known):
            return True
    if any(word in ("the", "each", "every", "a", "an", "this", "that") for word in spoken):
        return True
    if len(spoken) > 1 and _is_verb_of_thing(spoken[-1]):
        return True  # a low table sits somewhere
    open_ = [word for word in spoken[:-1] if not word.endswith("ing")]
    return any(_kinds(word).keys() & {*_NOT_IN_NAMES} for word in open_) or (not bare and len(spoken) > 3)


def _is_verb_of_thing(word: str) -> bool:
    """Whether a word is what one thing does ("stands"), and names nothing."""
    kinds = _kinds(word)
    verb = kinds.get("verb")
    return isinstance(verb, Verb) and verb.form == "s" and not kinds.keys() & {"noun", "room", "group", "region"}


def _unknown(source: Source, parsed: Parsed, spoken: list[str], parts: list[_Part]) -> bool:
    """A room by a name that nobody knows ("a toll booth") is of no known kind, and no other is made for it."""
    strange = [word for word in spoken[:-1] if not set(_kinds(word)) - {"noun", "plural", "people_words", "matter"}]
    if not strange or not spoken or "room" in _kinds(spoken[-1]) or spoken[-1] in _plain_heads():
        return False
    parsed.room_words = " ".join(parts[0].text.split())
    parsed.note(f"'{parsed.room_words}' is no kind of room that is known")
    first = next(m for m in _WORD.finditer(source.spoken, parts[0].start, parts[0].end) if m[0] == strange[0])
    parsed.unread.append(Left(parsed.room_words, first.start(), parts[0].end))
    _put(source, first.start(), parts[0].end)
    return True


def _named(spoken: list[str]) -> str:
    """The longest name of a kind of room that ends the words; "" where there is none."""
    for at in range(len(spoken)):
        phrase = " ".join(spoken[at:]).replace("-", " ")
        if phrase in room_words():
            return phrase
    if spoken and spoken[-1] not in vocabulary():
        known = mended(spoken[-1], [])
        return known if known is not None and known in room_words() else ""
    return ""


def _run_on(spoken: list[str], named: str) -> bool:
    """Whether the name begins within a phrase that the words before it make: a tiny home office is no tiny home."""
    start = len(spoken) - len(named.split())
    return any("room" in _kinds(" ".join(spoken[a:b])) for a in range(start) for b in range(start + 1, len(spoken)))


def _joined(named: str, rest: list[_Part]) -> str:
    """The kind whose name is that of a room with what it is of or for before it: the bridge of a ship."""
    for part in rest:
        own = part.kind == "setting" and not set(words("room_kind")["homes"]).isdisjoint(_WORD.findall(part.text))
        if part.kind in ("whole", "setting"):
            for one in kinds_meant([(f"{'home' if own else part.text} {named}", 1.0)]):
                if one.named and set(stems(named)) - stemmed_heads() < one.told:
                    return one.kind if one.kind != room_words()[named] else ""
    return ""


def _joined_by_things(text: str, named: str) -> str:
    """The kind whose name is that of a room with what a request speaks of before it, oftenest: a cellar with wine."""
    if named not in words("room_kind")["joined"]:
        return ""
    spoken = [stem(word) for word in _WORD.findall(text)]
    own = room_words()[named]
    longer = {
        phrase[: -len(named) - 1]: kind
        for phrase, kind in room_words().items()
        if phrase.endswith(f" {named}") and kind != own
    }
    told = {first: spoken.count(stem(first)) for first in longer if " " not in first}
    most = max(told, key=lambda first: (told[first], -spoken.index(stem(first)) if told[first] else 0), default="")
    return longer[most] if most and told[most] else ""


def _told(parts: list[_Part]) -> set[str]:
    return {s for part in parts for s in stems(part.text)}


def _best(text: str, parts: list[_Part], bare: bool) -> Found | None:
    """The likeliest kind of room for a phrase; None where nothing tells enough."""
    rest = [p for p in parts if p.kind != "core"]
    weights = _WEIGHTS if stems(parts[0].text) or len(parts) > 2 else _WEIGHTS | {"setting": 0.8}
    found = kinds_meant([(_telling(part), weights[part.kind]) for part in parts])
    near = _told([p for p in parts if p.kind != "setting"])
    head = set(stems(parts[0].text)[-1:])
    alone = bare and len(stems(parts[0].text)) <= 1  # a room in a hotel
    room_of = {s for p in rest if alone and p.kind == "setting" for s in stems(p.text)}
    found = [
        one
        for one in found
        if one.score >= ENOUGH
        and (_among(one.told, near) or (one.named and _among(one.told, room_of)))
        and (bare or (one.named and _among(one.told, head)))
    ]
    if not found:
        return None
    likely = [one for one in found if one.score >= CLOSE * found[0].score]
    if len(likely) == 1:
        return likely[0]
    things = _things(text)
    return max(likely, key=lambda one: (one.score * (1.0 + told_by(things, room_types()[one.kind])), one.kind))


_LOOKS = ("room_scale", "styles", "moods", "density", "color", "shape", "scale")


def _telling(part: _Part) -> str:
    """The words of a part without what is said of the looks of the room; with as many words as before."""
    if part.kind != "core":
        return part.text
    shell = words("room_kind")["shell"]
    return _WORD.sub(lambda m: "the" if m[0] in shell or _kinds(m[0]).keys() & {*_LOOKS} else m[0], part.text)


def _among(told: frozenset[str], spoken: set[str]) -> bool:
    """Whether some of the words that tell a kind stand in the parts that may tell it, misspelt ones as well."""
    return any(s in told or any(s[:3] == t[:3] for t in told) for s in spoken)


def _things(text: str) -> list[str]:
    """The categories that the nouns of a text may mean."""
    spoken = _WORD.findall(text)
    pairs = [" ".join(two) for two in zip(spoken, spoken[1:], strict=False)]
    known = (vocabulary().get(phrase, {}).get("noun") for phrase in (*pairs, *spoken))
    return [name for name in known if name]


def _set(
    source: Source, parsed: Parsed, kind: str, core: _Part | None, used: list[_Part], parts: list[_Part], exact: bool
) -> None:
    """Name the kind of the room, and take what told it out of the source."""
    said = " ".join(source.spoken[used[0].start : used[-1].end].split()).strip(" ,")
    parsed.room_type, parsed.room_words = kind, said
    if not exact:
        parsed.note(f"'{said}' was taken for: {kind.replace('_', ' ')}")
    told = next((f.told for f in kinds_meant([(p.text, 1.0) for p in used]) if f.kind == kind), frozenset[str]())
    for part in used:
        if part.kind == "core":
            _blank_core(source, part, told)
        elif part.kind in ("whole", "setting"):
            _blank_told(source, part, told, whole=_is_place(part))
        else:
            _blank_told(source, part, told, whole=False)
            _whom(parsed, part)
    _blank_settings(source, parsed, [p for p in parts if p not in used])


def _blank_core(source: Source, part: _Part, told: frozenset[str]) -> None:
    """The name of the room gives way to the word "room", so that what is said of it is read of it."""
    spoken = list(_WORD.finditer(source.spoken, part.start, part.end))
    last = spoken[-1] if spoken else None
    for m in spoken:
        if m is last:
            _put(source, m.start(), m.end(), "room" if m.end() - m.start() >= 4 else "")
        elif stem(m[0]) in told or m[0] in words("room_kind")["heads"]:
            _put(source, m.start(), m.end())


def _blank_told(source: Source, part: _Part, told: frozenset[str], whole: bool) -> None:
    """What something is for goes out of the source up to the last word that told it."""
    spoken = [m for m in _WORD.finditer(source.spoken, part.start, part.end) if whole or stem(m[0]) in told]
    if spoken:
        counts = re.compile(r"\b(?:\d+|one|two|three|four|five|six|seven|eight|nine|ten|twelve|twenty|thirty)\b")
        if not counts.search(source.spoken, part.start, spoken[-1].end()):
            _put(source, part.start, spoken[-1].end())


def _whom(parsed: Parsed, part: _Part) -> None:
    parsed.for_whom += [w for w in _WORD.findall(part.text) if w in words()["whom"]]


def _is_place(part: _Part) -> bool:
    """Whether a part of a phrase names a room or a building: "of a vet", "in a hotel"."""
    spoken = _WORD.findall(part.text)
    return len(spoken) <= 4 and any(f.named for f in kinds_meant([(part.text, 1.0)])) and not _is_thing(spoken)


def _is_thing(spoken: list[str]) -> bool:
    known = vocabulary().get(spoken[-1], {}) if spoken else {}
    return "noun" in known and "room" not in known


def _blank_settings(source: Source, parsed: Parsed, rest: list[_Part]) -> None:
    """Where the room is, or whose it is, names no other room: a sick room for our school."""
    for part in rest:
        if part.kind in ("whole", "setting", "purpose") and _names_room(part):
            _put(source, part.start, part.end)
            parsed.setting = f"{parsed.setting} {part.text}".strip()


def _names_room(part: _Part) -> bool:
    spoken = _WORD.findall(part.text)
    if 0 < len(spoken) <= 4 and part.kind != "purpose" and _building().search(part.text.strip()):
        return True
    return bool(spoken) and len(spoken) <= 5 and bool(_named(spoken)) and spoken[-1] == _named(spoken).split()[-1]


def _leave_out(source: Source, parsed: Parsed, start: int, end: int) -> None:
    """Words that are accounted for and say nothing more."""
    parsed.referred.append(source.span(start, end))
    _put(source, start, end)


def _put(source: Source, start: int, end: int, instead: str = "") -> None:
    source.text = source.text[:start] + instead.ljust(end - start) + source.text[end:]


def _other_kinds(source: Source, parsed: Parsed) -> None:
    """What the room is not names no kind of it: "not a bathroom" is told as not understood."""
    for m in [*_is_not().finditer(source.text)]:
        spoken = list(_WORD.finditer(source.text, m.end(), _end(source.text, m.end())))[:LONGEST]
        count = next((k for k in range(len(spoken), 0, -1) if " ".join(w[0] for w in spoken[:k]) in room_words()), 0)
        if count:
            end = spoken[count - 1].end()
            parsed.unread.append(Left(" ".join(source.text[m.start() : end].split()), m.start(), end))
            _put(source, m.start(), end)
            source.spoken = source.spoken[: m.start()] + " " * (end - m.start()) + source.spoken[end:]


def _zones(source: Source, parsed: Parsed) -> None:
    """What the room is as well: "that is also a gym", "with a sewing corner"."""
    for m in [*_also().finditer(source.text)]:
        spoken = list(_WORD.finditer(source.text, m.end(), _end(source.text, m.end())))[:4]
        for count in range(len(spoken), 0, -1):
            phrase = " ".join(w[0] for w in spoken[:count])
            if phrase in room_words():
                _add_zone(source, parsed, room_words()[phrase], m.start(), spoken[count - 1].end())
                break
    for m in [*_part_of_room().finditer(source.text)]:
        phrase = f"{m['kind']} {m['part']}"
        short = f"{m['kind'].split()[-1]} {m['part']}"
        if any(kinds.keys() & {"group", "region", "noun", "place", "room"} for kinds in map(_kinds, (phrase, short))):
            continue
        found = [one for one in kinds_meant([(m["kind"], 1.0)]) if one.told == frozenset(stems(m["kind"]))]
        if found:
            _add_zone(source, parsed, found[0].kind, m.start("kind"), m.end())


def _kinds(phrase: str) -> dict[str, object]:
    return vocabulary().get(phrase, {})


def _add_zone(source: Source, parsed: Parsed, kind: str, start: int, end: int) -> None:
    parsed.zones.append(Zone(kind, source.text[start:end].strip(), source.span(start, end)))
    _put(source, start, end)


def furnish_zones(parsed: Parsed) -> None:
    """The furniture that makes a part of the room what it is, as far as the request does not name it itself."""
    for zone in parsed.zones:
        if zone.kind == parsed.room_type:
            continue
        made = [_core_mention(parsed, name, count, zone.span) for name, count in core_of(zone.kind)]
        for mention in made[1:]:
            seat = family(mention.category) == "seat" and family(made[0].category) in ("table", "desk", "storage")
            parsed.said.append(
                Said("at" if seat else "near", [mention], (made[0],), zone.words, span=zone.span, implied=True)
            )
        parsed.note(f"'{zone.words}' was taken for: {', '.join(m.noun for m in made)}")


def _core_mention(parsed: Parsed, name: str, count: int, span: Span) -> Mention:
    category = category_of(name)
    there = next((m for m in parsed.mentions if m.category == category or m.family == category), None)
    if there is not None:
        return there
    mention = Mention(name.replace("_", " "), category, (count, count), implied=True, span=span)
    parsed.mentions.append(mention)
    return mention


def _plain_heads() -> tuple[str, ...]:
    """Words for a room that the clauses know as such."""
    return ("room", "somewhere", "where", "something", *words("groups")["rooms"])


@cache
def _building() -> re.Pattern[str]:
    return re.compile(rf"\b{one_of(words('room_kind')['buildings'])}$")


@cache
def _opener() -> re.Pattern[str]:
    said = one_of([*words("room_kind")["openers"], *words("room_kind")["work"]])
    return re.compile(rf"\s*(?:{said}\b[\s,!.:]*{_ARTICLE})*{_ARTICLE}")


@cache
def _work() -> re.Pattern[str]:
    return re.compile(rf"\s*(?:an? |the |please )?(?P<work>{one_of(words('room_kind')['work'])})\b")


@cache
def _statement() -> re.Pattern[str]:
    said = one_of(words("room_kind")["statement"])
    return re.compile(rf"(?<![\w'])(?<!if ){said} (?:all |really |basically |just |going to be |for )*{_ARTICLE}")


@cache
def _ending() -> re.Pattern[str]:
    data = words("room_kind")
    stops = rf"(?<![\w'])(?:{one_of(data['ends'])}(?![\w'])|{one_of(data['tails'])}{_CLAUSE_ENDS})"
    return re.compile(rf"[.,;:!?\n()§\d]|{stops}")


@cache
def _tie() -> re.Pattern[str]:
    data = words("room_kind")
    groups = "|".join(rf"(?P<{name}>{one_of(data[name])})" for name in ("purpose", "whole", "setting"))
    return re.compile(rf"(?<![\w'-])(?:{groups})(?![\w'-])\s*(?:{_ARTICLE})")


@cache
def _tail() -> re.Pattern[str]:
    tails = one_of(words("room_kind")["tails"])
    return re.compile(rf"(?P<name>[a-z]+(?: [a-z]+)??) (?P<tail>{tails}(?: {tails})*){_CLAUSE_ENDS}")


@cache
def _becomes() -> re.Pattern[str]:
    data = words("room_kind")["becomes"]
    ways = "|".join(rf"{one_of(data[a])}\b(?P<{a}>[^.;:!?\n]{{0,40}}?)\b{one_of(data[b])}" for a, b in _WAYS)
    return re.compile(rf"(?<![\w'-])(?:{ways}) {_ARTICLE}")


@cache
def _also() -> re.Pattern[str]:
    return re.compile(rf"(?<![\w'])[,]?{one_of(words('room_kind')['also'])} {_ARTICLE}")


@cache
def _is_not() -> re.Pattern[str]:
    return re.compile(r"(?<![a-z'])(?:(?:(?:is|are|was) |(?:that's|it's) )?(?:not|never)|isn't|no longer) (?:an?|the) ")


@cache
def _part_of_room() -> re.Pattern[str]:
    parts = one_of(words("room_kind")["parts"])
    return re.compile(
        rf"\b(?:with|and|has|plus|a|an|the|my|our) (?:a |an |the |my |our )?(?:small |little |tiny |cosy |big )?"
        rf"(?P<kind>[a-z]+(?: [a-z]+)?) (?P<part>{parts})\b"
    )


__all__ = ["furnish_zones", "read_room_kind"]
