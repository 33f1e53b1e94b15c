"""Colours, materials and styles that are not wanted: "nothing pink", "no black furniture", "hates red", "not wood".

What is said of nothing else holds for all of the room, its surfaces too; before a noun ("no plastic chairs") it is said
of these things alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.materials import (
    color_name,
    color_named,
    color_words,
    finishes,
    finishes_named,
    hue,
    material_words,
    shades_of,
)
from sceneweaver.assets.taxonomy import members
from sceneweaver.scene import InputError

from ..alternatives import first_words, names_begin
from ..model import Exclusion
from ..parsed import Parsed
from ..source import Source
from ..things import match_of
from ..unwanted import is_class, kinds_unwanted, of_material
from ..vocabulary import vocabulary, words
from .phrases import noun_after, one_of

_MORE = r"(?:(?:no|any|of|nothing|without)\s+)*"
_LINK = rf"(?:\s*,?\s*(?:and|or|nor)\s+{_MORE}|\s*,\s*(?:(?:no|nothing|without)\s+)+{_MORE})"
"""Between looks of one list: a comma alone may begin something that is wanted."""


def read_unwanted_looks(source: Source, parsed: Parsed) -> None:
    """Read which looks are not wanted; the words go out of the source."""
    _motifs(source, parsed)
    taken = list[tuple[int, int]]()
    if not names_begin(source.text, _first_words()):  # the patterns take long to compile
        return
    for pattern in _patterns():
        for found in list(pattern.finditer(source.text)):
            if any(a < found.end() and found.start() < b for a, b in taken):
                continue
            end = _add(source, parsed, found)
            if end is not None:
                taken.append((found.start(), end))
                source.text = source.text[: found.start()] + " " * (end - found.start()) + source.text[end:]


def _motifs(source: Source, parsed: Parsed) -> None:
    """ "Nothing with dinosaurs": things that must not be there."""
    for found in list(_motif().finditer(source.text)):
        noun, end = noun_after(source.text, found.end())
        if names := _things(noun):
            said = source.text[found.start() : end].strip()
            parsed.unwanted.append(Exclusion(words=said, categories=names, span=source.span(found.start(), end)))
            source.text = source.text[: found.start()] + " " * (end - found.start()) + source.text[end:]


@cache
def _motif() -> re.Pattern[str]:
    return re.compile(r"\bnothing\s+(?:with|about|to do with|that has|showing)\s+(?:any\s+|a\s+)?(?=[a-z])")


def _add(source: Source, parsed: Parsed, found: re.Match[str]) -> int | None:
    """One more exclusion of what is listed; where its words end, None where they say something else."""
    looks, end = list(_looks(found["list"])), found.end()
    if not looks:
        return None
    within: tuple[str, ...] = ()
    if "open" in found.re.groupindex:  # a noun follows, or nothing does
        tail = _tail().match(source.text, found.end("list"))
        if tail is not None:
            end = tail.end()
        else:
            noun, end = noun_after(source.text, found.end("list"))
            within = _things(noun)
            if not within and not _begins_anew(noun):
                return None
            end = end if within else found.end("list")
    if found.groupdict().get("only"):
        named = frozenset(shade for look in looks for shade in look.get("colors", ()))
        looks = [{"colors": tuple(one for one in _hues() if one not in named)}]
        parsed.colors += [word for word in _split(found["list"]) if word in color_words()]
    said = " ".join(source.text[found.start() : end].split()).strip(" ,.")
    row: dict[str, Any] = {"categories": ()}
    for look in looks:
        for key, value in look.items():
            row[key] = tuple(dict.fromkeys((*row.get(key, ()), *value)))
    row["categories"] = () if within else row["categories"]
    parsed.unwanted.append(Exclusion(words=said, within=within, span=source.span(found.start(), end), **row))
    return end


def _begins_anew(spoken: str) -> bool:
    """Whether words behind a look are no noun that it is said of, but another negation or a clause about somebody."""
    kinds = vocabulary().get(spoken.split()[0] if spoken else "", {})
    return not {"noun", "adjective", "color", "material"} & kinds.keys() and bool(
        {"neg", "nothing", "det", "person"} & kinds.keys()
    )


def _split(listed: str) -> list[str]:
    """The words of a list, each look by itself, the longest known phrases first."""
    return [m[0] for m in re.finditer(_look(), listed)]


def _looks(listed: str) -> Iterator[dict[str, tuple[str, ...]]]:
    """What each look of a list rules out."""
    data = words("unwanted")["looks"]
    for word in _split(listed):
        quality = next((row for row in data["qualities"].values() if word in row["words"]), None)
        if quality is not None:
            yield {key: tuple(quality[key]) for key in ("colors", "materials", "styles") if key in quality} | (
                {"materials": _shiny()} if quality.get("shiny") else {}
            )
        elif word in color_words():
            yield {"colors": _shades(word)}
        elif material := finishes_named(word):
            rows: dict[str, dict[str, list[str]]] = words("unwanted")["materials"]
            whole = next((name for name, row in rows.items() if word in row["words"]), None)
            more = {"categories": of_material(whole)} if whole is not None else {}
            yield {"materials": _of(word, tuple(one.material.name for one in material)), **more}
        else:
            yield {"materials": (word,)}  # a colour of a material: "black leather"


def _of(word: str, named: tuple[str, ...]) -> tuple[str, ...]:
    """The names by which a material is told: the family where a word means all of it."""
    families = {finishes()[name].family for name in named}
    family = next(iter(families))
    whole = [name for name, one in finishes().items() if one.family == family and not one.asked]
    return (family,) if len(families) == 1 and set(whole) <= set(named) else named


@cache
def _shiny() -> tuple[str, ...]:
    """The finishes in which one sees oneself."""
    least = float(words("unwanted")["looks"]["shiny"])
    return tuple(
        name for name, one in finishes().items() if one.material.roughness <= least and one.family not in ("food",)
    )


def _shades(word: str) -> tuple[str, ...]:
    """The basic colours that a word rules out: a plain hue with all its shades, one shade alone."""
    try:
        basic = color_named(word)
    except InputError:
        return ()
    rows: dict[str, list[str]] = words("unwanted")["looks"]["shades"]
    if word.replace("gray", "grey") in rows:
        return tuple(rows[word.replace("gray", "grey")])
    own = hue(basic)
    return shades_of(own) if own is not None and word == own else (basic,)


@cache
def _hues() -> tuple[str, ...]:
    """All basic colours that have a hue, and the browns, which are one to the eye; not the neutral ones."""
    return tuple(dict.fromkeys(name for name in color_words() if name == _basic(name) and hue(name) is not None))


def _basic(name: str) -> str:
    try:
        return color_named(name)
    except InputError:
        return color_name((0.5, 0.5, 0.5))


def _things(noun: str) -> tuple[str, ...]:
    """The categories and groups that a noun, or its last word, stands for; none for what is no known thing."""
    rows: dict[str, list[str]] = words("unwanted")["looks"]["within"]
    for name in dict.fromkeys((noun, noun.rpartition(" ")[2])):
        if not name:
            continue
        if name in rows:
            return tuple(rows[name])
        if is_class(name):
            return kinds_unwanted(name)
        match = match_of(name)
        if match.how != "generic" and match.category in categories():
            return tuple(dict.fromkeys((match.category, *members(match.category))))
    return ()


@cache
def _known() -> tuple[str, ...]:
    """Words for colours, materials, styles and qualities that may be unwanted."""
    data = words("unwanted")["looks"]
    qualities = [word for row in data["qualities"].values() for word in row["words"]]
    known = {*color_words(), *material_words(), *qualities} - {*data["not_looks"]}
    return tuple(sorted(word for word in known if word[0].isalpha()))


@cache
def _first_words() -> frozenset[str]:
    return first_words((*_known(), *color_words()))


@cache
def _look() -> str:
    """One word or phrase for a look that may be unwanted, or a colour and a material together."""
    bare = one_of(_known())
    dyed = rf"{one_of(list(color_words()))}\s{one_of([*material_words()])}"
    return rf"\b(?:{dyed}|{bare})(?![\w-])"


@cache
def _patterns() -> tuple[re.Pattern[str], ...]:
    data = words("unwanted")["looks"]
    look = _look()
    listed = rf"(?P<list>{look}(?:{_LINK}{look})*)"
    either = one_of(data["before"])
    some = rf"(?:(?:{one_of(data['between'])})\s+)*"
    dislike = one_of(data["dislike"])
    return tuple(
        re.compile(pattern)
        for pattern in (
            # "No colours but white and blue", "nothing but black".
            rf"\b(?P<only>{one_of(data['only'])})\s+{listed}(?={_END})",
            rf"\b{dislike}\s+{some}(?P<open>){listed}",
            rf"\b{either}\s+{some}(?P<open>){listed}",
            # "Pink is out", "red is forbidden".
            rf"\b{listed}\s+(?:is|are)\s+{one_of(data['behind'])}\b",
        )
    )


_END = r"\s*(?:$|[.,;:!?)]|(?:and|but|please|though|everywhere)\b)"


@cache
def _tail() -> re.Pattern[str]:
    """What may stand behind a look that is said of no thing."""
    data = words("unwanted")["looks"]
    things, more = one_of(data["anything"]), one_of(data["after"])
    return re.compile(rf"(?:\s+{things})?(?:\s+(?:{more}))*(?={_END}|\s+{one_of(data['goes_on'])}\b)")


def colors_unwanted(exclusions: Iterable[Exclusion]) -> frozenset[str]:
    """The basic colours that the whole room is to be without."""
    return frozenset(color for one in exclusions if not one.within for color in one.colors)


__all__ = ["colors_unwanted", "read_unwanted_looks"]
