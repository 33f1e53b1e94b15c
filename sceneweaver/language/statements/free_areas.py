"""Floor that is to stay free: turning circles, free floor, ways, gaps between things, space around them.

Lengths are marked first, so that a phrase is a short pattern (`free_phrases`); a thing that only such a phrase names
stays in the source, for the clauses to make it.
"""

from __future__ import annotations

import re

from sceneweaver.assets import resolve

from ..model import FreeArea
from ..parsed import Parsed
from ..source import Source, metres
from ..vocabulary import category_of, family, vocabulary
from .free_phrases import Phrase, phrases, place_words, widened
from .lengths import LENGTH, length_of

_LENGTH = re.compile(rf"(?<![\w.]){LENGTH}(?!\s{{0,2}}(?:high|tall|long|thick|diameter\s+(?:table|rug))\b)")
_OWN_SIDES = re.compile(
    r"(?<![\w.])(\d{1,3}(?:[.,]\d{1,2})?)\s?(m|cm|mm|ft|in)?\s?(?:x|×|by)\s?(\d{1,3}(?:[.,]\d{1,2})?)\s?(cm|mm|in|inch(?:es)?)\b"
)
_PRONOUNS = {"it", "them", "him", "her", "these", "those", "this", "that", "both", "each"}
_NOT_THINGS = {
    "side", "sides", "front", "back", "left", "right", "end", "ends", "corner", "floor", "room", "space", "ceiling",
    "place", "area", "middle", "centre", "center", "wall", "walls", "door", "window", "windows", "other", "comfort",
}  # fmt: skip
_LOOK_BACK = 240
"""Characters before a phrase in which what it is about is looked for."""

_SIDES_MEANT = (
    ("front", "front"), ("before", "front"), ("behind", "back"), ("back", "back"), ("foot", "front"), ("left", "left"),
    ("right", "right"),
)  # fmt: skip
_WORD = re.compile(r"[a-z][a-z'-]+")

_MEASURES = frozenset("¤§")
"""What stands for a length and for two sides in a marked text."""


def read_free_areas(source: Source, parsed: Parsed) -> None:
    """Adds every free area that a source asks for to what is parsed, and takes its words out."""
    _take_sides(source)
    marked, lengths = _marked(source.text)
    assumed: dict[int, FreeArea] = {}
    for phrase in phrases():
        if phrase.width is None and _MEASURES.isdisjoint(marked):
            continue
        at = 0
        while (found := phrase.pattern.search(marked, at)) is not None:
            at = max(found.end(), at + 1)
            area = _area(phrase, found, source, lengths)
            if area is None:
                continue
            start, end = widened(marked, found.start(), found.end())
            end = start + len(source.text[start:end].rstrip())
            area = [one.model_copy(update={"span": source.span(start, end)}) for one in area]
            if len(area) == 1 and _MEASURES.isdisjoint(found[0]):
                assumed[start] = area[0]
            parsed.free_areas += area
            filler = _filler(source.text, start, end, found)
            source.text = source.text[:start] + filler + source.text[end:]
            marked = marked[:start] + filler + marked[end:]
    for at in source.free:  # no other words of the phrase are understood
        if source.text[at : at + 1] == "§":
            said = source.spoken[at : at + 12].split(",")[0].strip()
            width, depth = source.sides[at][:2]
            own = FreeArea(kind="rectangle", size=(width, depth), words=said, span=source.span(at, at + 1))
            known = next((k for k in assumed if "." not in source.text[min(k, at) : max(k, at)]), None)
            if known is not None:  # "keep the centre clear for the dancers, 2.5 x 2.5 m"
                area = assumed.pop(known)
                parsed.free_areas.remove(area)
                own = area.model_copy(update={"kind": own.kind, "size": own.size})
            parsed.free_areas.append(own)
            source.text = source.text[:at] + " " + source.text[at + 1 :]
    parsed.free_areas.sort(key=lambda area: area.span or (0, 0))


def _take_sides(source: Source) -> None:
    """Two sides in units that no room is measured in, such as 150 x 90 cm, as the source holds those in metres."""

    def read(found: re.Match[str]) -> str:
        unit = found[4]
        scale = metres("1", unit)
        source.sides[found.start()] = tuple(round(float(found[k].replace(",", ".")) * scale, 4) for k in (1, 3))
        return "§"

    if re.search(r"\b(?:free|clear|empty|open)\b", source.text):
        source.blank(_OWN_SIDES, read)


def _marked(text: str) -> tuple[str, dict[int, tuple[float, float | None]]]:
    """The text with a ``¤`` at each length, and the lengths [m] by their place."""
    lengths: dict[int, tuple[float, float | None]] = {}

    def mark(found: re.Match[str]) -> str:
        comma = len(found[0]) - len(found[0].lstrip(", "))
        lengths[found.start() + comma] = length_of(found)
        return found[0][:comma] + "¤".ljust(len(found[0]) - comma)

    return _LENGTH.sub(mark, text), lengths


def _area(
    phrase: Phrase, found: re.Match[str], source: Source, lengths: dict[int, tuple[float, float | None]]
) -> list[FreeArea] | None:
    """What a phrase asks for; None where it names nothing that it could be about, or no measure."""
    groups = found.groupdict()
    place, sides = found[0].find("¤"), found[0].find("§")
    low, most = lengths.get(found.start() + place, (None, None)) if place >= 0 else (phrase.width, None)
    size = source.sides.get(found.start() + sides) if sides >= 0 else None
    if size is None and low is None:
        return None
    width = low if low is not None else 0.0
    if groups.get("radius"):
        width *= 2
    sized = (size[0], size[1]) if size is not None and len(size) > 1 else (width, width)
    if not all(0.1 <= side <= 20 for side in sized):
        return None
    named = [words for name in ("a", "b") if (words := groups.get(name))]
    if phrase.kind == "path" and groups.get("b") and not groups.get("a"):
        named = ["door", *named]
    if groups.get("where") == "inside" and groups.get("a") in _PRONOUNS:
        named = ["door"]
    targets = [_target(words, source, found.start()) for words in named]
    to_wall = groups.get("b") in ("wall", "walls")
    if phrase.kind in ("gap", "clearance") and len(named) - to_wall < 1:
        subject = _thing_before(source.text, found.start(), several=phrase.kind == "gap" and not to_wall)
        targets = [subject, *targets]
    if any(target is None for target in targets):
        return None
    words = " ".join(source.text[slice(*widened(source.text, found.start(), found.end()))].split())
    words = words.replace("§", f"{sized[0]:g} x {sized[1]:g} m")
    names = tuple(target for target in targets if target is not None)
    if len(names) == 2 and names[0] == names[1] == "door":
        names = ("door", "door:2")
    if phrase.kind in ("gap", "clearance") and names[0] in place_words().values():
        if names[0] not in ("door", "window") or phrase.kind == "gap":
            return None
        return [FreeArea(kind="rectangle", size=sized, targets=names, side="front", words=words)]
    area = FreeArea(kind=phrase.kind, size=sized, most=most, targets=names, side=_side(phrase, groups), words=words)  # type: ignore[arg-type]
    if groups.get("way_to"):
        way = _target(groups["way_to"], source, found.start()) or "door"
        return [area, area.model_copy(update={"kind": "path", "targets": (way, names[0])})]
    return [area]


def _side(phrase: Phrase, groups: dict[str, str | None]) -> str:
    """The side of the target that is meant."""
    if groups.get("long"):
        return "long"
    if groups.get("both"):
        return "sides"
    spoken = groups.get("side") or groups.get("where") or ""
    for word, side in _SIDES_MEANT:
        if word in spoken:
            return side
    if groups.get("where") == "around":
        return "around"
    return phrase.side


def _target(spoken: str, source: Source, start: int) -> str | None:
    """A thing or part of the room by the words for it; a pronoun stands for what was named before it."""
    plain = " ".join(spoken.split())
    last = plain.split()[-1]
    if plain in _PRONOUNS:
        return _thing_before(source.text, start, several=plain in ("them", "these", "those", "both", "each"))
    if last in place_words():
        return place_words()[last]
    if _is_person(last):
        return _seat_before(source.text, start) or plain
    return plain


def _is_person(word: str) -> bool:
    kinds = vocabulary().get(word, {}).keys()
    return "people_words" in kinds and "noun" not in kinds


def _seat_before(text: str, start: int) -> str | None:
    """The seat that was named last before a place of the text: where the people are that a phrase speaks of."""
    for found in reversed(_WORD.findall(text, max(0, start - _LOOK_BACK), start)):
        noun = vocabulary().get(found, {}).get("noun")
        if isinstance(noun, str) and family(category_of(noun)) == "seat":
            return found
    return None


def _thing_before(text: str, start: int, several: bool = False) -> str | None:
    """The thing that was named last before a place of the text, in the same sentence rather than in the one before.

    With ``several`` the last that is a plural, if there is one.
    """
    before = text[max(0, start - _LOOK_BACK) : start]
    for sentence in reversed(re.split(r"\.(?!\d)", before)):
        known = [found for found in _names(sentence)]
        plural = [name for name in known if name.endswith("s") and not name.endswith("ss")]
        if several and plural:
            return plural[-1]
        if known:
            return known[-1]
    return None


def _names(sentence: str) -> list[str]:
    """The nouns of known things in a sentence, and its first noun where none is known."""
    words = [found[0] for found in _WORD.finditer(sentence)]
    known = [
        word
        for word in words
        if word not in _NOT_THINGS and resolve(word).how in ("exact", "synonym", "plural", "like", "group")
    ]
    if known:
        return known
    first = re.match(
        r"[\s,]*(?:(?:and|the|a|an|with|one|two|three|four|five|six|\d+)\s+)*([a-z][a-z'-]{2,20})\b", sentence
    )
    return [first[1]] if first is not None and first[1] not in _NOT_THINGS and len(words) > 1 else []


def _filler(text: str, start: int, end: int, found: re.Match[str]) -> str:
    """What takes the place of a phrase: blanks, with the things in it that nothing else of the text names."""
    filler = [" "] * (end - start)
    if text[:start].rstrip()[-1:] not in ("", ".", ",", "("):
        filler[0] = ","
    rest = text[:start] + " " + text[end:]
    for name in ("a", "b", "way_to"):
        if name not in found.re.groupindex or not found[name]:
            continue
        words = found[name]
        last = words.split()[-1]
        if words in _PRONOUNS or last in place_words() or last in _NOT_THINGS or _is_person(last):
            continue
        if re.search(rf"\b{re.escape(last.rstrip('s'))}", rest):
            continue
        first = text.rfind(" ", start, found.start(name) - 1) + 1 or found.start(name)  # with its count or article
        begin = (
            first
            if re.fullmatch(r"(?:two|three|four|five|six|\d{1,2}|a|an)\s+", text[first : found.start(name)])
            else found.start(name)
        )
        begin = max(begin, start + 2)
        if any(c.isalnum() for c in filler[: begin - start - 1]):
            filler[begin - start - 1] = ","  # "nothing between the sofa and the stove": of both
        filler[begin - start : found.end(name) - start] = text[begin : found.end(name)]
    return "".join(filler)


__all__ = ["read_free_areas"]
