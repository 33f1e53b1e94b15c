"""Lengths of things: "80 cm deep", "top at 90 cm", "hung with their centres at 1.5 m", "knee high".

Each is one length with what it is of: an extent, the height of a part, or where a thing is. Which thing is meant is
told by where the noun stands: behind the words ("a 40 cm high plinth"), or before them.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from ..model import StatedMeasure
from ..parsed import Parsed, Told
from ..source import Source
from ..things import singular
from ..vocabulary import vocabulary, words
from .lengths import BOUNDED, bounded_length
from .phrases import Edits, noun_at, noun_behind, one_of
from .resolve import is_thing, thing_before

REACH = (0.02, 12.0)
"""Lengths [m] that a thing in a room may have."""

BARE = 20
"""Least number without a unit that is one of centimetres: "60 wide"."""

WORKTOPS = "worktops"
"""What stands for the worktops of the room, whatever they are on."""

_SPACES = r"[\s-]{0,3}"


def measures(source: Source, parsed: Parsed) -> None:
    """Adds every length of a thing, and takes its words out."""
    edits = Edits(source)
    _sides(source, parsed, edits)
    for pattern, read in _patterns():
        for found in list(pattern.finditer(source.text)):
            if edits.free(*found.span()) and (said := read(found, source.text)) is not None:
                _add(source, parsed, edits, found, said)


def _sides(source: Source, parsed: Parsed, edits: Edits) -> None:
    """ "A table 3.2 x 0.7 m": two sides behind the noun of a thing, and perhaps its height."""
    for found in list(re.finditer(r"(?P<noun>\b[a-z]+)\s{1,2}(?P<measure>§)", source.text)):
        sides = source.sides.get(found.start("measure"))
        if sides is None or not is_thing(found["noun"]) or singular(found["noun"]) in words("measures")["not_of"]:
            continue
        span = edits.take(found.start("measure"), found.end())
        for quantity, length in zip(
            ("length", "width", "height"), (*sorted(sides[:2])[::-1], *sides[2:]), strict=False
        ):
            said = " x ".join(f"{side:g}" for side in sides) + " m"
            given = {"quantity": quantity, "low": length, "high": length}
            what = StatedMeasure.model_validate({**given, "words": said, "span": span})
            parsed.measures.append(Told(what, found["noun"], after=False, named=True))


def _add(source: Source, parsed: Parsed, edits: Edits, found: re.Match[str], said: dict[str, Any]) -> None:
    """What was said, of the thing that it is said of; nothing where no thing is named."""
    text = source.text
    start, end = found.span()
    ends = [length for length in (said["low"], said["high"]) if length is not None]
    if said["quantity"] != "ceiling" and not all(REACH[0] <= length <= REACH[1] for length in ends):
        return
    after, named = False, found.groupdict().get("bare") == "of"
    if "noun" in found.re.groupindex:
        start, noun = found.start("measure"), found["noun"]
    elif named:
        noun = (re.findall(r"[a-z]+", text[max(0, start - 30) : start]) or [""])[-1]
    else:
        behind = re.match(r"\s+(?:of|on)\s(?:the\s|a\s)?([a-z]+)", text[end:])
        if "part" in found.groupdict() or said["quantity"] == "knee":
            noun = behind[1] if behind is not None and is_thing(behind[1]) else noun_behind(text, start)
        else:
            noun, after = noun_at(text, start, end)
        if not after and singular(noun or "-").split()[-1] in words("measures")["not_of"]:
            near = (re.findall(r"[a-z]+", text[max(0, start - 40) : start]) or [""])[-1]
            noun = noun if near == noun.split()[-1] else thing_before(text, start) or noun
        if not after:
            start = _with_leading(text, start)
    last = singular(noun).split()[-1] if noun else ""
    if said.pop("of_room", False) and (not last or "room" in vocabulary().get(last, {})):
        noun = last = WORKTOPS
    if not last or last in words("measures")["not_of"]:
        return
    if last in words("measures")["screens"] and re.search(r"inch|\"", found[0]):
        return  # the diagonal of a screen
    words_ = " ".join(text[start:end].split()).strip(" ,")
    span = edits.take(start, end, " ," if text[start : start + 1] == "," and not after else "")
    parsed.measures.append(Told(StatedMeasure(**said, words=words_, span=span), noun, after, named))


def _with_leading(text: str, start: int) -> int:
    """Where the words begin that only bind a length to the thing before it."""
    found = _leading().search(text[:start])
    return found.start() if found is not None else start


@cache
def _leading() -> re.Pattern[str]:
    return re.compile(rf"(?:(?:,\s{{0,3}})?(?:\b{one_of(words('measures')['leading'])}\b\s{{0,3}}){{1,6}}|,\s{{0,3}})$")


# ---- the patterns ----------------------------------------------------------------------------------------------------


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], Any], ...]:
    """What is looked for, the most telling first, each with what makes keywords of a `StatedMeasure` of it."""
    data = words("measures")
    axes = _group("axis", data["axes"])
    names, parts = _group("name", data["names"]), _group("part", data["parts"])
    above = rf"(?:{_SPACES}{one_of(data['above'])}\b)"
    levels = "|".join(data["levels"])
    never = r"(?:,?\s{1,2}(?:(?:and|but)\s)?(?:not|no|never)\s(?P<never>lower|less|higher|more)\b)?"
    level = rf"(?P<level>{levels})(?:[\s-]?(?:level|height|high))\b{never}"
    compared = one_of([word for ends in data["compared"].values() for several in ends.values() for word in several])
    than = rf"(?:\b(?P<negated>{one_of(data['negated'])})\s{{1,2}})?\b(?P<compared>{compared})\s{{1,2}}"
    whose = r"(?:(?:my|the|your|his|her|our|a)\s)?"
    between = (
        r"(?:\s{0,3}(?:is|are|be|at|of|about|hung|height|to|should|must|its|their|in|a|:|,|all|on|stands?|sits?)\b)"
        r"{0,4}\s{0,3}"
    )
    away = rf"(?!\s{{0,3}}-?\s{{0,3}}{one_of(data['distances'])}\b)"
    told = (
        (rf"\b{parts}\b{between}{BOUNDED}(?:\s?(?:high|tall))?{above}?{away}", _part),
        (rf"\b{parts}\b{between}{level}", _part),
        (rf"{than}(?:{BOUNDED}|{whose}(?P<level>{levels})(?:[\s-]?(?:level|height|high))?\b)(?!{_SPACES}{axes})",
         _compared),
        (rf"{BOUNDED}{_SPACES}(?:of\s)?{names}\b", _name),
        (rf"\b{names}{between}{BOUNDED}", _name),
        (rf"{BOUNDED}{_SPACES}{axes}(?!\w|{above}|\s+(?:aisle|gap|passage|path|space))", _axis),
        (rf"(?:\bat\s{{1,2}}(?:a\s+height\s+of\s+)?)?{BOUNDED}(?:\s?(?:high|up))?{above}", _placed),
        (rf"\b{one_of(data['ceiling'])}\b", _ceiling),
        (rf"(?:\b(?:at|to|about|of|up to)\s{{1,2}}){{0,2}}{level}", _placed),
        (rf"\b(?P<number>\d{{2,3}})\s{{1,2}}{axes}\b", _bare),
        (rf"(?P<noun>\b[a-z]+)\s{{1,2}}(?P<measure>(?:hung\s|mounted\s|fixed\s|is\s|are\s|hang\s|hangs\s)?at\s{{1,2}}"
         rf"(?:a\s+height\s+of\s+)?{BOUNDED})(?:\s?high)?{away}", _at),
        (rf"\b(?P<bare>of|is|are|measures|measuring)\s{{1,2}}{BOUNDED}{away}(?!\s{{0,2}}[x×])", _whole),
    )  # fmt: skip
    return tuple((re.compile(pattern), read) for pattern, read in told)


def _group(name: str, listed_: dict[str, list[str]]) -> str:
    return f"(?P<{name}>{one_of([word for found in listed_.values() for word in found])})"


def _meaning(section: str, word: str) -> str:
    return next(name for name, listed_ in words("measures")[section].items() if word in listed_)


def _length(found: re.Match[str]) -> dict[str, Any]:
    level = found.groupdict().get("level")
    if level is not None:
        low, high = words("measures")["levels"][level]
        never = found.groupdict().get("never")
        return {
            "low": None if never in ("higher", "more") else low,
            "high": None if never in ("lower", "less") else high,
        }
    low, high, vague = bounded_length(found)
    return {"low": low, "high": high, "vague": vague}


def _part(found: re.Match[str], text: str) -> dict[str, Any]:
    of_room = found["part"] in words("measures")["worktops"]
    return {"quantity": _meaning("parts", found["part"]), **_length(found), "of_room": of_room}


def _name(found: re.Match[str], text: str) -> dict[str, Any]:
    quantity, said = _meaning("names", found["name"]), _length(found)
    if quantity == "knee" and said["low"] is not None:
        said["high"] = None  # room for knees may always be more
    return {"quantity": quantity, **said}


def _compared(found: re.Match[str], text: str) -> dict[str, Any]:
    """What is, or is not, more or less than a length."""
    rows = words("measures")["compared"]
    quantity, ends = next(
        (name, ends) for name, ends in rows.items() if any(found["compared"] in e for e in ends.values())
    )
    said = _length(found)
    ends_at = [length for length in (said["low"], said["high"]) if length is not None]
    at_most = (found["compared"] in ends["more"]) == bool(found["negated"])
    bounds = {"low": None, "high": max(ends_at)} if at_most else {"low": min(ends_at), "high": None}
    return {"quantity": quantity, **bounds}


def _axis(found: re.Match[str], text: str) -> dict[str, Any]:
    return {"quantity": _meaning("axes", found["axis"]), **_length(found)}


def _placed(found: re.Match[str], text: str) -> dict[str, Any]:
    return {"quantity": "placed", **_length(found)}


def _ceiling(found: re.Match[str], text: str) -> dict[str, Any]:
    return {"quantity": "ceiling", "low": 0.0, "high": 0.0}


def _bare(found: re.Match[str], text: str) -> dict[str, Any] | None:
    length = int(found["number"])
    if length < BARE:
        return None
    return {"quantity": _meaning("axes", found["axis"]), "low": length / 100, "high": length / 100}


def _at(found: re.Match[str], text: str) -> dict[str, Any] | None:
    if "noun" not in vocabulary().get(found["noun"], {}):
        return None
    return {"quantity": "placed", **_length(found)}


def _whole(found: re.Match[str], text: str) -> dict[str, Any]:
    return {"quantity": "length", **_length(found)}
