"""What a request says of walls, floor, ceiling and woods of its room: materials, colours, panels, beams.

What is said of a part of the room goes out of the source, the part itself stays: a desk may stand at "the black walls".
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cache
from typing import Any

from sceneweaver.assets.materials import color_named, finishes
from sceneweaver.knowledge.load import data_of
from sceneweaver.scene import InputError

from ..model import StatedFinish
from ..parsed import Parsed
from ..source import Source
from .lengths import PLAIN, plain_length
from .phrases import one_of
from .surface_words import is_denied

LONGEST = 3
"""Words of a colour or a material at most."""

_APART = frozenset(("on", "the", "a", "of", "in", "to", "at", "over", "across", "under", "from", "with", "onto", "all"))
"""Words behind which the look of a part begins that stands after them."""

_PART = r"(?P<part>walls?|floor(?:ing|boards?|s)?|ceilings?|plaster|wallpaper)"
_BEFORE = re.compile(rf"(?P<words>(?:[a-z-]+ ){{0,3}}[a-z-]+) {_PART}\b")
_LINK = (
    r"(?:(?:the colou?r of|are|is|be|in|of|all|should|must|have|has|painted|clad|a|an|the|covered|covering|with|made|"
    r"both|to) )*"
)
_AFTER = re.compile(
    rf"\b{_PART}:? {_LINK}(?P<words>(?:[a-z-]+ ){{0,3}}?[a-z-]+)"
    r"(?=\s*(?:[,.;!?\n]|$)| and | with | up | above | below )"
)


def read_finishes(source: Source, parsed: Parsed) -> None:
    """Read what the room is finished in."""
    _heights(source, parsed)
    _panels(source, parsed)
    _beams(source, parsed)
    for pattern in (_BEFORE, _AFTER):
        source.blank(pattern, lambda m: _said(m, source, parsed))
    _alone(source, parsed)
    for wood, match in _woods_of_room(source.text):
        _add(parsed, source, match, "furniture", color=wood)


def _add(parsed: Parsed, source: Source, match: re.Match[str] | tuple[int, int], part: str, **said: Any) -> bool:
    """One more finish, of a phrase or of characters of the source; the first that is said of a part counts."""
    if part != "furniture" and any(one.part == part for one in parsed.finishes):
        return False
    start, end = match if isinstance(match, tuple) else match.span()
    if is_denied(source.text[:start]):
        return False
    span, words = source.span(start, end), source.text[start:end].strip(" ,.")
    parsed.finishes.append(StatedFinish(part=part, words=words, span=span, **said))  # type: ignore[arg-type]
    return True


# ---- a part and what it is of ----------------------------------------------------------------------------------------


def _said(match: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """A part with words before or after it; what is left of the phrase in the source, None for all of it."""
    part, spoken = match["part"], match["words"]
    words = [
        word for word in re.sub(r"[-,]", " ", spoken).split() if word not in ("painted", "and", "coloured", "colored")
    ]
    before = match.start("words") < match.start("part")
    if before:  # "wood shavings on the floor" are no floor of wood
        words = words[max((k + 1 for k, word in enumerate(words) if word in _APART), default=0) :]
    if not words:
        return None
    if part.startswith("floor"):
        row, used = _floor(words, before)
        if row is not None and row["material"] == "tile" and part.startswith("floorboard"):
            row["material"] = "wood"  # painted boards
        kind = "floor"
    elif part.startswith("ceiling"):
        row, used = _surface(words, before)
        kind = "ceiling"
    elif part in ("plaster", "wallpaper"):
        row, used = _surface(words, before) if before else (None, 0)
        row = row and row | {"material": "plaster" if part == "plaster" else "paper"}
        kind = "walls"
    elif before and words[-1] in ("accent", "feature"):
        row, used = _surface(words[:-1], True)
        used, kind = used + 1, "accent"
    elif part == "walls" or not before or words[-1] in _data()["walls"]:
        row, used = _surface(words, before)
        kind = "walls"
    else:
        return None
    if not row:
        return None
    if kind == "walls" and row.pop("panelled", False):
        _add(parsed, source, match, "panels", color=row.get("color"), high=_data()["heights"]["panelled"])
    parts = [m.span() for m in re.finditer(r"[a-z]+", match["words"])]
    at = match.start("words")
    if before:
        start, end = at + parts[-min(used, len(parts))][0], match.end()
    else:
        start, end = match.start(), at + parts[min(used, len(parts)) - 1][1]
    if not _add(parsed, source, (start, end), kind, **row):
        return None
    keeps = part if before and part.startswith(("wall", "floor", "ceiling")) and part != "wallpaper" else ""
    said = match[0]
    a, b = start - match.start(), end - match.start()
    return said[:a] + keeps.rjust(b - a) + said[b:]


def _floor(words: Sequence[str], before: bool) -> tuple[dict[str, Any] | None, int]:
    """A floor of some words, and how many of them say it; None where that is nothing of which floors are."""
    spoken = " ".join(words)
    wood = next(iter(_woods(spoken)), None)
    known: Any = _data()["floors"]
    for material, row in known.items():
        found = next((word for word in row["words"] if re.search(rf"\b{re.escape(word)}\b", spoken)), None)
        if found is not None:
            tone = wood if material == "wood" and wood in _of_family("wood") else None
            bare = [word for word in words if word not in found.split()]
            color, more = _color(bare, True)
            tone = tone or (color if material != "wood" else None) or row["tone"]
            used = len(words) if before else max(k + 1 for k, word in enumerate(words) if word in found.split())
            return {"material": row.get("drawn", material), "color": tone}, min(
                used, 1 + more + len(found.split())
            ) if before else used
    if wood is not None and wood in _of_family("wood"):
        return {"material": "wood", "color": wood}, 2 if len(words) > 1 and " ".join(words[-2:]) in _wood_names() else 1
    color, used = _color(words, before)
    return ({"material": "tile", "color": color}, used) if color is not None else (None, 0)


def _surface(words: Sequence[str], before: bool) -> tuple[dict[str, Any] | None, int]:
    """What walls or a ceiling are of, and how many of the words say it."""
    if not words:
        return None, 0
    color, used = _color(words, before)
    if color is not None:
        rest = words[: len(words) - used] if before else words[used:]
        material, more = _material(rest, before)
        return {"color": color, **({"material": material["material"]} if material.get("material") else {})}, used + more
    material, used = _material(words, before)
    if used:
        rest = words[: len(words) - used] if before else words[used:]
        own, more = _color(rest, before)
        wood = next(iter(_woods(" ".join(words))), None) if material.get("material") in ("boards", "logs") else None
        return {**material, "color": wood or own or material.get("color")}, min(len(words), used + more)
    named = " ".join(words[-2:] if before else words[:2])
    for name in (named, named.split()[-1 if before else 0]):
        if name in _wood_names():
            return {"material": "boards", "color": _wood_names()[name]}, len(name.split())
    return None, 0


def _color(words: Sequence[str], last: bool) -> tuple[str | None, int]:
    """The colour that the last words name, or the first, the longest that is one; how many words those are."""
    for count in range(min(LONGEST, len(words)), 0, -1):
        name = " ".join(words[-count:] if last else words[:count])
        if name in _data()["tints"]:
            return _data()["tints"][name], count
        try:
            color_named(name)
        except InputError:
            continue
        if name not in ("wood", "wooden"):
            return name, count
    return None, 0


def _material(words: Sequence[str], last: bool) -> tuple[dict[str, Any], int]:
    known: dict[str, dict[str, Any]] = _data()["walls"]
    for count in range(min(LONGEST, len(words)), 0, -1):
        if (row := known.get(" ".join(words[-count:] if last else words[:count]))) is not None:
            return dict(row), count
    return {}, 0


# ---- panels, beams, bands --------------------------------------------------------------------------------------------


def _heights(source: Source, parsed: Parsed) -> None:
    """ "Blue to waist height, white over it": two colours of one wall."""
    heights: dict[str, float] = _data()["heights"]

    def take(match: re.Match[str]) -> str | None:
        low, _ = _color(match["low"].split(), True)
        if low is None:
            return None
        metres = heights[match["name"]] if match["name"] else plain_length(match["metres"])
        if metres is None or not 0.4 <= metres <= 3.0:
            return None
        _add(parsed, source, match, "lower", color=low, high=metres)
        top, _ = _color(match["top"].split(), True) if match["top"] else (None, 0)
        if top is not None:
            _add(parsed, source, match, "walls", color=top)
        return " "

    source.blank(_up_to(), take)


@cache
def _up_to() -> re.Pattern[str]:
    color = r"(?P<{}>(?:[a-z]+ )??[a-z]+)"
    high = rf"(?:(?P<name>{one_of(_data()['heights'])})(?:[- ](?:height|high|level))?|(?P<metres>{PLAIN}))"
    return re.compile(
        rf"{color.format('low')} (?:(?:walls?|paint|tiles?|tiled) )?(?:up to|to|below|until) (?:about |around )?{high}"
        rf"(?: (?:high|height|up))?(?:[, ]+(?:and )?{color.format('top')} (?:above|over it|over that|on top))?"
    )


def _panels(source: Source, parsed: Parsed) -> None:
    for kind in ("half", "whole"):

        def take(match: re.Match[str], kind: str = kind) -> str:
            name = match["wood"] or match["in"]
            color = _wood_names()[name] if name else None
            _add(
                parsed,
                source,
                match,
                "panels",
                color=color,
                high=_data()["heights"]["half" if kind == "half" else "panelled"],
            )
            return "wall" if match[0].endswith(("walls", "wall")) else " "

        source.blank(_panelled(kind), take)


@cache
def _panelled(kind: str) -> re.Pattern[str]:
    woods = one_of(_wood_names())
    after = rf"(?:\s+in\s+(?P<in>{woods})\b)?"
    return re.compile(rf"(?:\b(?:with|in) )?\b(?:(?P<wood>{woods})[ -])?{one_of(_data()['panelled'][kind])}\b{after}")


def _beams(source: Source, parsed: Parsed) -> None:
    def take(match: re.Match[str]) -> str:
        color = _wood_names().get(match["wood"] or "", "steel" if "steel" in match[0] else "dark oak")
        _add(parsed, source, match, "beams", color="black steel" if color == "steel" else color)
        return "ceiling" if "ceiling" in match[0] and not match[0].endswith("ceiling") else " "

    source.blank(_beamed(), take)


@cache
def _beamed() -> re.Pattern[str]:
    return re.compile(
        r"(?<!from )(?<!from the )"  # what hangs from them is overhead
        r"\b(?:low |heavy |exposed |open |visible |rustic |old |thick )*"
        rf"(?:(?P<wood>{one_of(_wood_names())})[ -])?{one_of(_data()['beams'])}\b"
    )


def _alone(source: Source, parsed: Parsed) -> None:
    """Floors that one word names, and materials of which all is."""
    for word in _data()["alone"]:
        for match in re.finditer(rf"(?P<before>[a-z]+ )?\b{word}\b", source.text):
            words = [*(match["before"] or "").split(), word.removesuffix("s")]
            row, used = _floor(words, True)
            if row is not None and not any(one.part == "floor" for one in parsed.finishes):
                _add(parsed, source, match, "floor", **row)
                a, b = match.span() if used > 1 or not match["before"] else match.span()
                source.text = source.text[:a] + " " * (b - a) + source.text[b:]
    for match in _built().finditer(source.spoken):
        row = {name: _data()["walls"][match["of"]].get(name) for name in ("material", "color")}
        if source.text[slice(*match.span("of"))].strip() and _add(parsed, source, match.span("of"), "walls", **row):
            a, b = match.span("of")
            source.text = source.text[:a] + " " * (b - a) + source.text[b:]
    for word in _data()["all"]:
        every = re.compile(
            rf"(?:(?<=^)|(?<=[,.;:] )|(?<=\band ))(?:bare |exposed )?{word}"
            r"(?: (?:everywhere|all over|throughout|all around))?"
            rf"(?=\s*(?:[,.;!]|$)| and )"
        )
        rows = _data()["all"][word]
        for match in every.finditer(source.text):
            for part, row in rows.items():
                _add(parsed, source, match, part, **row)


@cache
def _built() -> re.Pattern[str]:
    walls, built = one_of(_data()["walls"]), one_of(_data()["built"])
    return re.compile(rf"\b(?P<of>{walls})(?:[ -]built)? (?=(?:vaulted |old )?{built}\b)")


# ---- woods -----------------------------------------------------------------------------------------------------------


def _woods(text: str) -> Iterable[str]:
    """Finishes of wood that a text names, the longest name first, each once."""
    found: list[str] = []
    names = _wood_names()
    for name in sorted(names, key=len, reverse=True):
        if re.search(rf"\b{re.escape(name)}\b", text):
            text = re.sub(rf"\b{re.escape(name)}\b", " ", text)
            if names[name] not in found:
                found.append(names[name])
    return found


def _woods_of_room(text: str) -> Iterable[tuple[str, re.Match[str]]]:
    """Woods that are said of no thing, as "in oak" or "oak furniture" is, with their place."""
    for match in _wood_alone().finditer(text):
        yield _wood_names()[match["wood"]], match


@cache
def _wood_alone() -> re.Pattern[str]:
    rest = r"(?:\s+(?:everywhere|all|furniture|tones|details|all over|throughout))*"
    ends = r"(?=\s*(?:[,.;:!?\n]|$)|\s+(?:and|with|in)\s)"
    start = r"(?:(?<=^)|(?<=[,.;:!?] )|(?<=[,.;:!?])|(?<=\band )|(?<=\bwith )|(?<=\bin )|(?<=\bof )|(?<=\ball ))"
    return re.compile(rf"{start}\s*(?:all |everything |everything in )?(?P<wood>{one_of(_wood_names())}){rest}{ends}")


@cache
def _wood_names() -> dict[str, str]:
    """What people call woods, with the finish that each is."""
    return {**{name: name for name in _of_family("wood")}, **_data()["woods"]}


@cache
def _of_family(family: str) -> frozenset[str]:
    return frozenset(name for name, finish in finishes().items() if finish.family == family)


def _data() -> Any:
    return data_of("stated_finishes.yaml")
