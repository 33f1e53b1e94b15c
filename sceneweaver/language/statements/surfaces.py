"""Looks of surfaces of the room, in whatever order they are told: which part, of what, in which colours and pattern, up
to which height, on which of the walls.

"White tiles to 1.5 m, plaster above", "walls, floor and ceiling black", "bare brick on one wall", "a floor in red and
cream checks", "floral wallpaper", "a blue door". The words of a look are a run of known words; what else is said of a
part is left to `finishes`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from sceneweaver.assets.materials import color_words, finishes
from sceneweaver.knowledge.load import data_of

from ..model import StatedFinish
from ..parsed import Parsed
from ..source import Source
from ..vocabulary import NUMBERS
from .lengths import PLAIN, plain_length
from .phrases import one_of
from .resolve import is_thing

LOW, HIGH = 0.3, 3.2
"""Heights [m] between which a band on a wall ends."""

HALF = 1.2
"""Height [m] at which walls in two colours change where nothing is said of it."""


class Look(NamedTuple):
    """A run of words about a surface, read."""

    colors: tuple[str, ...]
    material: str | None
    pattern: str | None
    of: str | None
    """What a pattern is usually of."""
    dark: bool = False
    """Whether it is said to be dark, without a colour."""


def read_surfaces(source: Source, parsed: Parsed) -> None:
    """Read bands of walls, several parts in one look, patterns, single walls and doors; their words go out."""
    if not _compiled(_token()).search(source.text):
        return
    for needed, pattern, read in _readers():
        if any(word in source.text for word in needed):
            source.blank(
                _compiled(pattern), lambda found, read=read: None if _counted(found) else read(found, source, parsed)
            )


def _counted(found: re.Match[str]) -> bool:
    """Whether a number stands before what would be a look, so that it is things: "two boards on the front wall"."""
    look = found.groupdict().get("look")
    if not look or found.start("look") != found.start() or not look.endswith("s"):
        return False
    return any(word.isdecimal() or word in NUMBERS for word in found.string[: found.start()].split()[-1:])


_compiled = cache(re.compile)
"""Kept however many patterns there are; `re` forgets all but the last 512."""


def _add(parsed: Parsed, source: Source, found: re.Match[str], part: str, **said: Any) -> bool:
    """One more finish; the first that is said of a part counts."""
    if any(one.part == part for one in parsed.finishes):
        return False
    words = " ".join(found[0].split()).strip(" ,.;:")
    span = source.span(*found.span())
    parsed.finishes.append(StatedFinish(part=part, words=words, span=span, **said))  # type: ignore[arg-type]
    return True


# ---- the words of a look ---------------------------------------------------------------------------------------------


def look_of(text: str) -> Look:
    """What a run of words says of a surface.

    Examples:
        >>> from sceneweaver.language.statements.surfaces import look_of
        >>> look_of("red and cream checkered tiles").colors
        ('red', 'cream')
    """
    colors: list[str] = []
    material, pattern, of = None, None, None
    for word in re.findall(_token(), text):
        for where in ("walls", "floor"):
            for name, row in _data()["patterns"][where].items():
                if word in row["words"] and pattern is None:
                    pattern, of = name, row["of"]
        if word in _woods() or word in _colors():
            colors.append(_woods().get(word) or _tints().get(word) or word)
            continue
        if material is None:
            material = next((name for name, words in _data()["clad"].items() if word in words), None)
        if material is None and word in _data()["walls"] and (row := _data()["walls"][word]).get("material"):
            material = row["material"]
            colors += [row["color"]] if word.startswith("white") else []
    return Look(tuple(dict.fromkeys(colors)), material, pattern, of, bool(re.search(r"\bdark\b", text)))


@cache
def _data() -> Any:
    return data_of("stated_finishes.yaml")


@cache
def _woods() -> dict[str, str]:
    return {**{n: n for n, one in finishes().items() if one.family == "wood"}, **_data()["woods"]}


@cache
def _tints() -> dict[str, str]:
    return dict(_data()["tints"])


_SHADES = ("light", "dark", "pale", "deep", "bright", "dusty", "soft", "pastel", "muted", "warm", "baby", "powder")


@cache
def _plain_colors() -> frozenset[str]:
    return frozenset((*color_words(), *_tints()))


@cache
def _basic_colors() -> frozenset[str]:
    """Colours of one word, which a shade may stand before."""
    return frozenset(word for word in _plain_colors() if " " not in word)


@cache
def _colors() -> frozenset[str]:
    return _plain_colors() | {f"{shade} {word}" for shade in _SHADES for word in _basic_colors()}


@cache
def _token() -> str:
    """One known word, or phrase, of a look."""
    data = _data()
    known = {*_plain_colors(), *_woods(), *data["walls"], *data["beside"]}
    known |= {word for words in data["clad"].values() for word in words}
    known |= {word for rows in data["patterns"].values() for row in rows.values() for word in row["words"]}
    known |= {word for row in data["floors"].values() for word in row["words"]}
    known |= {"wood", "wooden", "timber"}
    known = {word for word in known if not word.startswith("half")}
    phrases = one_of(word for word in known if " " in word)
    shaded = f"{one_of(_SHADES)} {one_of(_basic_colors())}"
    return rf"(?<![\w-])(?:{phrases}|{shaded}|{one_of(word for word in known if ' ' not in word)})(?![\w])"


@cache
def _run() -> str:
    """A run of such words."""
    between = r"(?:\s+(?:and|&|with|on|in)\s+|\s*/\s*|-|\s+)"
    return rf"{_token()}(?:{between}{_token()}){{0,5}}"


def _floor_row(look: Look, text: str) -> dict[str, Any] | None:
    """Material, colours and pattern of a floor in a look; None where that is nothing that floors are of."""
    data = _data()
    row = data["patterns"]["floor"].get(look.pattern or "", {})
    words = re.findall(_token(), text)
    material = row.get("of") or next(
        (name for name, one in data["floors"].items() if any(word in one["words"] for word in words)), None
    )
    woods = [color for color in look.colors if color in finishes()]
    if material is None and woods:
        material = "wood"
    if material is None:
        material = look.material if look.material in ("concrete", "stone") else "tile" if look.colors else None
    if material is None:
        return None
    colors = list(look.colors)
    if material == "wood":
        colors = woods
    two = look.pattern == "checkered"
    tone = colors[0] if colors else row.get("tone")
    second = colors[1] if len(colors) > 1 else "white" if colors and tone != "white" else "black" if colors else None
    found = {"material": material, "color": tone, "pattern": look.pattern if row else None}
    return found | ({"second": second or row.get("second")} if two else {})


def _wall_row(look: Look) -> dict[str, Any] | None:
    """Material, colours and pattern of walls in a look."""
    material = look.material or look.of
    if look.pattern is not None and look.pattern not in _data()["patterns"]["walls"]:
        material = "brick" if look.pattern == "brick" else look.material or ("stone" if not look.colors else None)
    pattern = look.pattern if look.pattern in _data()["patterns"]["walls"] else None
    if material == "plaster" and pattern is not None:
        material = "paper"
    color = look.colors[0] if look.colors else _USUAL.get(material or "")
    if look.dark and not look.colors and material in ("paper", "tiles", "plaster", None):
        color = "dark green" if pattern == "botanical" else "charcoal"
    if color is None and material is None:
        return None
    if material in (None, "plaster") and color in finishes() and finishes()[color].family == "wood":
        material = "boards"
    if material == "paper" and pattern is None and len(look.colors) > 1:
        pattern = "stripes"
    second = look.colors[1] if len(look.colors) > 1 and pattern in ("stripes", "checkered") else None
    return {"material": material, "color": color, "pattern": pattern, "second": second}


_USUAL = {
    "brick": "brick red",
    "stone": "greige",
    "concrete": "grey",
    "tiles": "white",
    "metal": "light grey",
    "boards": "oak",
    "panels": None,
    "paper": "cream",
    "plaster": "off white",
}
"""Colours of what walls are of where none is named."""


# ---- bands -----------------------------------------------------------------------------------------------------------


def _banded(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """Walls that are one thing up to a height and another above."""
    groups = found.groupdict()
    above = groups.get("top") or groups.get("top2")
    low, top = look_of(groups["low"]), look_of(above) if above else None
    high = HALF
    if groups.get("name"):
        high = {**_data()["heights"], **_data()["marks"]}[groups["name"]]
    elif groups.get("metres"):
        high = plain_length(groups["metres"]) or 0.0
    row = _wall_row(low)
    if row is None or not LOW <= high <= HIGH or (top is not None and _wall_row(top) is None):
        return None
    if any(one.part in ("lower", "tiled", "panels") for one in parsed.finishes):
        return None
    material = row.pop("material")
    if material == "tiles":
        _add(parsed, source, found, "tiled", high=high, **row)
    elif material in ("panels", "boards"):
        color = row["color"] if low.colors else None
        _add(parsed, source, found, "panels", high=high, color=color)
    else:
        _add(parsed, source, found, "lower", high=high, material=material, **row)
    if top is not None and (upper := _wall_row(top)) is not None:
        _add(parsed, source, found, "walls", **upper)
    return " "


@cache
def _bands() -> tuple[str, ...]:
    run, data = _run(), _data()
    names = one_of([*data["heights"], *data["marks"]])
    high = (
        rf"(?:about |around |roughly |a height of |the height of |the |a )*(?:(?P<name>{names})(?:[- ]?(?:height|high|"
        rf"level))?|(?P<metres>{PLAIN}))"
    )
    where = r"(?:\s+(?:high|height|up|all (?:a)?round|on all (?:four )?walls|everywhere|from the floor|on the walls))*"
    before = r"(?:\bwalls?(?:\s+(?:are|is|in|all|painted|tiled|clad|with|done))*[:,]?\s+)?"
    lead = r"(?:and\s+|then\s+|with\s+|but\s+)*"
    over = r"(?:above(?:\s+(?:that|it|this))?|over\s+(?:it|that)|on top|higher up|from there(?:\s+(?:up|on))?|" + (
        r"the rest|the upper (?:half|part)|upper (?:half|part)|top half|up to the ceiling)"
    )
    behind, before_it = rf"(?P<top2>{run})(?:\s+walls?)?\s+{over}", rf"{over}\s*(?:is|in|are|,|:)?\s*(?P<top>{run})"
    tail = rf"(?:\s*[,;:]?\s*{lead}(?:{before_it}|{behind}))?"
    has = r"\s*(?:is|are|in|painted|:)?\s*(?:in )?"
    return (
        rf"{before}(?P<low>{run})(?:\s+walls?)?\s+(?:up\s+)?(?:to|until|till)\s+{high}{where}{tail}",
        rf"{before}(?P<low>{run})\s+(?:below|at the bottom|down below|underneath)\s*,?\s*{lead}(?P<top>{run})\s+"
        r"(?:above|on top|at the top|over (?:it|that))",
        rf"(?:\bwalls?(?:\s+(?:are|is|,|:))*\s*)?\b(?:the )?(?:lower|bottom) half(?: of the walls?)?{has}(?P<low>{run})"
        rf"\s*,?\s*{lead}(?:the )?(?:upper|top|other) half(?: of it)?{has}(?P<top>{run})",
        rf"\bwalls?\s+(?:are |is |, |: )?half\s+(?P<low>{run})\s*,?\s*{lead}half\s+(?P<top>{run})",
    )


# ---- parts -----------------------------------------------------------------------------------------------------------


_PART = r"(?:walls?|floors?|flooring|ceilings?)"


def _parts(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """Several parts of the room in one look."""
    look = look_of(found["look"])
    before = source.text[: found.start()]
    taken = found.start("parts") < found.start("look") and re.search(rf"(?:{_token()}|\bon the)\s*$", before)
    if taken or not look.colors and not look.material:
        return None  # "white walls, floor grey": the first part has a look of its own
    for part in re.findall(_PART, found["parts"]):
        if part.startswith("floor"):
            row = _floor_row(look, found["look"])
            name = "floor"
        else:
            row, name = _wall_row(look), "ceiling" if part.startswith("ceiling") else "walls"
        if row is not None:
            if name == "ceiling":
                row = {key: row[key] for key in ("material", "color")}
            _add(parsed, source, found, name, **row)
    return " "


def _floor(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """A floor in a pattern, or of a stone or in two colours that a pattern has."""
    text = " ".join(word for word in (found.groupdict().get("look"), found.groupdict().get("more")) if word)
    look = look_of(text)
    if look.pattern not in _data()["patterns"]["floor"]:
        return None
    row = _floor_row(look, text)
    if row is None or not _add(parsed, source, found, "floor", **row):
        return None
    return "floor".rjust(len(found[0]))


def _paper(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    look = look_of(" ".join(word for word in (found["look"], found["more"]) if word))
    if not look.colors and look.pattern is None:
        return None
    row = _wall_row(look._replace(material="paper"))
    return " " if row is not None and _add(parsed, source, found, "walls", **row) else None


def _clad(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """ "White metro tiles on the walls", "walls tiled in green hexagons", "wooden walls painted red"."""
    groups = found.groupdict()
    look = look_of(found["look"])
    if "more" in groups:  # its paint
        look = look._replace(colors=look_of(found["more"]).colors)
    row = _wall_row(look)
    told = look.material not in (None, "plaster") or look.of == "tiles" or look.pattern is not None
    if row is None or not told or ("more" in groups and not look.colors):
        return None
    if row["material"] == "panels":
        row["material"] = "boards"
    return "walls".rjust(len(found[0])) if _add(parsed, source, found, "walls", **row) else None


def _others(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """The walls beside the one that is told of."""
    row = _wall_row(look_of(found["look"]))
    accent = any(one.part == "accent" for one in parsed.finishes)
    return " " if row is not None and accent and _add(parsed, source, found, "walls", **row) else None


def _one_wall(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """One wall in another look than the others."""
    groups = found.groupdict()
    look = look_of(groups["look"])
    row = _wall_row(look)
    if row is None:
        return None
    if row["material"] == "panels":
        row["material"] = "boards"
    side = groups.get("side") or ""
    where = {"back": "far", "end": "short", "opposite": "far", "front": "near"}.get(side, side) or "any"
    if not _add(parsed, source, found, "accent", where=where, **row):
        return None
    return " "


def _door(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """The door of the room in a colour, or of a wood."""
    look = look_of(found["look"])
    of_thing = re.search(r"(?:([a-z]+)\s+with|\b(?:its|their))\s*$", source.text[: found.start()])
    if not look.colors or (of_thing is not None and (not of_thing[1] or is_thing(of_thing[1]))):
        return None
    if not _add(parsed, source, found, "doors", color=look.colors[0]):
        return None
    return "door".rjust(len(found[0]))


_Reader = Callable[[re.Match[str], Source, Parsed], str | None]


@cache
def _readers() -> tuple[tuple[tuple[str, ...], str, _Reader], ...]:
    """Letters of which some stand in each text that a pattern fits (few patterns are compiled); it; what reads it."""
    run = _run()
    parts = rf"(?P<parts>{_PART}(?:\s*(?:,\s*and\s|,|and|&|\+)\s*(?:the\s+)?{_PART})+)"
    link = (
        r"(?:\s*:|\s+(?:is|are|all|both|in|of|painted|should be|must be|made of|with|have|has|laid|covered|clad))*\s+"
    )
    end = r"(?=\s*(?:$|[.,;:!?)\n]|(?:and|with|but|to|please|throughout|everywhere|for|so)\b))"
    floor = r"(?:floor(?:ing|s)?)"
    print_ = one_of([word for row in _data()["patterns"]["walls"].values() for word in row["words"]])
    walls, floors, doors = ("wall",), ("floor",), ("door",)
    return (
        *((("",), pattern, _banded) for pattern in _bands()),
        (walls, rf"(?P<look>{run})\s+walls?\s+painted\s+(?:in\s+)?(?P<more>{run}){end}", _clad),
        (walls, rf"(?P<look>{run})\s+(?:all over |on |over |covering )(?:the |all |all the )?(?:four )?walls\b", _clad),
        (("wall", "floor", "ceiling"), rf"(?P<look>{run})\s+{parts}\b(?!(?:\s+(?:is|are|in|of))*\s+{run})", _parts),
        (("wall", "floor", "ceiling"), rf"\b{parts}{link}(?P<look>{run}){end}", _parts),
        (floors, rf"(?P<look>{run})\s+{floor}\b(?:\s+(?:in|of|with)\s+(?P<more>{run}){end})?", _floor),
        (floors, rf"\b{floor}{link}(?P<look>{run}){end}", _floor),
        (floors, rf"(?P<look>{run})\s+(?:all over |over |on |across )(?:the |its )?{floor}\b", _floor),
        (
            ("paper",),
            rf"(?P<look>(?:{run}\s+)?)(?:wall ?paper(?:s|ed walls)?|papered walls)\b"
            rf"(?:\s+(?:with|of|in)\s+(?:big |small |large |little )?(?P<more>(?:{run}\s+)?{print_}|{run}){end})?",
            _paper,
        ),
        (walls, rf"(?P<look>{run})\s+(?:accent|feature)\s+wall\b", _one_wall),
        (walls, rf"\b(?:accent|feature)\s+wall\s+(?:in|of|is|painted|with)\s+(?:in )?(?P<look>{run})", _one_wall),
        (walls, rf"(?P<look>{run})\s+on\s+(?:one|a single|just one|only one)(?: of the)?\s+walls?\b", _one_wall),
        (walls, rf"(?P<look>{run})\s+on\s+the\s+(?P<side>{_SIDES})\s+wall\b", _one_wall),
        (
            walls,
            rf"\b(?:(?:the|a|one)\s+)?(?P<side>{_SIDES})\s+wall{link}(?:(?:painted|clad|covered)\s+)?(?:in\s+)?"
            rf"(?P<look>{run}){end}",
            _one_wall,
        ),
        (walls, rf"\b(?:one|a single)\s+wall{link}(?P<look>{run}){end}", _one_wall),
        (
            ("other", "remaining", "rest"),
            rf"\b(?:all\s+)?(?:the\s+)?(?:others?|other walls|other three(?: walls)?|remaining walls|rest)"
            rf"(?:\s+(?:of the walls|are|is|in|painted|stay|all))*\s+(?P<look>{run}){end}",
            _others,
        ),
        (
            walls,
            rf"\b(?:a|one)\s+(?P<look>{run})\s+wall\b"
            r"(?=\s*(?:$|[.,;:!?)]|(?:behind|opposite|at|across|near|by|and|with|on|to|in|for|next|beside)\b))",
            _one_wall,
        ),
        (walls, rf"\bthe\s+(?P<look>{run})\s+(?P<side>{_SIDES})\s+wall\b", _one_wall),
        (walls, rf"\bwalls?{link}(?P<look>{run}){end}", _clad),
        (
            doors,
            rf"\b(?:a|the|one)\s+(?P<look>{run})\s+(?:front\s+|entrance\s+|room\s+)?door\b"
            r"(?!\s*(?:mat|knob|handle|stop))",
            _door,
        ),
        (doors, rf"\bdoor{link}(?P<look>{run}){end}", _door),
    )


_SIDES = r"(?:left|right|far|back|end|opposite|front|long|short)"


__all__ = ["Look", "look_of", "read_surfaces"]
