"""Looks of surfaces of the room, in whatever order they are told: which part, of what, in which colours and pattern, up
to which height, on which of the walls.

"White tiles to 1.5 m, plaster above", "walls, floor and ceiling black", "bare brick on one wall", "a floor in red and
cream checks", "floral wallpaper", "a blue door". The words of a look are a run of known words; what else is said of a
part is left to `finishes`.
"""

from __future__ import annotations

import re
from functools import cache

from sceneweaver.assets.materials import finishes

from ..parsed import Parsed
from ..source import Source
from ..vocabulary import NUMBERS
from .lengths import PLAIN, plain_length
from .phrases import one_of
from .resolve import is_thing
from .surface_words import (
    BEGINS,
    END,
    Reader,
    add_finish,
    data,
    floor_row,
    look_of,
    run_of_look,
    token,
    wall_row,
)
from .whole_room import METALS, readers_of_all

LOW, HIGH = 0.3, 3.2
"""Heights [m] between which a band on a wall ends."""

HALF = 1.2
"""Height [m] at which walls in two colours change where nothing is said of it."""


def read_surfaces(source: Source, parsed: Parsed) -> None:
    """Read bands of walls, several parts in one look, patterns, single walls and doors; their words go out."""
    if not _compiled(rf"{token()}|\b(?:{METALS})\b").search(source.text):
        return
    for needed, pattern, read in (*readers_of_all(), *_readers()):
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


# ---- bands -----------------------------------------------------------------------------------------------------------


def _banded(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """Walls that are one thing up to a height and another above."""
    groups = found.groupdict()
    above = groups.get("top") or groups.get("top2")
    low, top = look_of(" ".join(filter(None, (groups["low"], groups.get("more"))))), look_of(above) if above else None
    high = HALF
    if groups.get("name"):
        high = {**data()["heights"], **data()["marks"]}[groups["name"]]
    elif groups.get("metres"):
        high = plain_length(groups["metres"]) or 0.0
    row = wall_row(low)
    if row is None or not LOW <= high <= HIGH or (top is not None and wall_row(top) is None):
        return None
    if any(one.part in ("lower", "tiled", "panels") for one in parsed.finishes):
        return None
    material = row.pop("material")
    if material == "tiles":
        add_finish(parsed, source, found, "tiled", high=high, **row)
    elif material in ("panels", "boards"):
        color = row["color"] if low.colors else None
        add_finish(parsed, source, found, "panels", high=high, color=color)
    else:
        add_finish(parsed, source, found, "lower", high=high, material=material, **row)
    if top is not None and (upper := wall_row(top)) is not None:
        add_finish(parsed, source, found, "walls", **upper)
    return " "


@cache
def _bands() -> tuple[str, ...]:
    run = run_of_look()
    names = one_of([*data()["heights"], *data()["marks"]])
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
        rf"{before}(?P<low>{run})(?:\s+walls?)?\s+(?:up\s+)?(?:to|until|till)\s+{high}{where}(?:\s+in\s+(?P<more>{run}))?"
        rf"{tail}",
        rf"{before}(?P<low>{run})\s+(?:below|at the bottom|down below|underneath)\s*,?\s*{lead}(?P<top>{run})\s+"
        r"(?:above|on top|at the top|over (?:it|that))",
        rf"\bwalls?\s+(?:(?:are|in|painted)\s+)*(?P<top>{run})\s+(?:above|on top|at the top|higher up)\s*,?\s*{lead}"
        rf"(?P<low>{run})\s+(?:below|underneath|at the bottom|under (?:it|that)|down below|lower down)\b",
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
    taken = found.start("parts") < found.start("look") and re.search(rf"(?:{token()}|\bon the)\s*$", before)
    if taken or not look.colors and not look.material:
        return None  # "white walls, floor grey": the first part has a look of its own
    for part in re.findall(_PART, found["parts"]):
        if part.startswith("floor"):
            row = floor_row(look, found["look"])
            name = "floor"
        else:
            row, name = wall_row(look), "ceiling" if part.startswith("ceiling") else "walls"
        if row is not None:
            if name == "ceiling":
                row = {key: row[key] for key in ("material", "color")}
            add_finish(parsed, source, found, name, **row)
    return " "


def _floor(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """A floor in a pattern, or of a stone or in two colours that a pattern has."""
    text = " ".join(word for word in (found.groupdict().get("look"), found.groupdict().get("more")) if word)
    look = look_of(text)
    if look.pattern is None and len(look.colors) == 2 and "tile" in found[0]:
        look = look._replace(pattern="checkered")  # black and white tiles are laid in turn
    if look.pattern not in data()["patterns"]["floor"]:
        return None
    row = floor_row(look, text)
    if row is None or not add_finish(parsed, source, found, "floor", **row):
        return None
    return "floor".rjust(len(found[0]))


def _paper(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    look = look_of(" ".join(word for word in (found["look"], found["more"]) if word))
    if not look.colors and look.pattern is None:
        return None
    row = wall_row(look._replace(material="paper"))
    return " " if row is not None and add_finish(parsed, source, found, "walls", **row) else None


def _clad(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """ "White metro tiles on the walls", "walls tiled in green hexagons", "wooden walls painted red"."""
    groups = found.groupdict()
    look = look_of(found["look"])
    if "more" in groups:  # its paint
        look = look._replace(colors=look_of(found["more"]).colors)
    row = wall_row(look)
    wooden = any(color in finishes() and finishes()[color].family == "wood" for color in look.colors)
    told = look.material not in (None, "plaster") or look.of == "tiles" or look.pattern is not None or wooden
    if row is None or not told or ("more" in groups and not look.colors):
        return None
    if row["material"] == "panels":
        row["material"] = "boards"
    return "walls".rjust(len(found[0])) if add_finish(parsed, source, found, "walls", **row) else None


def _others(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """The walls beside the one that is told of."""
    row = wall_row(look_of(found["look"]))
    accent = any(one.part == "accent" for one in parsed.finishes)
    return " " if row is not None and accent and add_finish(parsed, source, found, "walls", **row) else None


def _one_wall(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """One wall in another look than the others."""
    groups = found.groupdict()
    look = look_of(groups["look"])
    row = wall_row(look)
    if row is None:
        return None
    if row["material"] == "panels":
        row["material"] = "boards"
    side = groups.get("side") or ""
    where = {"back": "far", "end": "short", "opposite": "far", "front": "near"}.get(side, side) or "any"
    if not add_finish(parsed, source, found, "accent", where=where, **row):
        return None
    return " "


def _door(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """The door of the room in a colour, or of a wood."""
    look = look_of(found["look"])
    of_thing = re.search(r"(?:([a-z]+)\s+with|\b(?:its|their))\s*$", source.text[: found.start()])
    if not look.colors or (of_thing is not None and (not of_thing[1] or is_thing(of_thing[1]))):
        return None
    if not add_finish(parsed, source, found, "doors", color=look.colors[0]):
        return None
    return "door".rjust(len(found[0]))


@cache
def _readers() -> tuple[tuple[tuple[str, ...], str, Reader], ...]:
    """Letters of which some stand in each text that a pattern fits (few patterns are compiled); it; what reads it."""
    run = run_of_look()
    parts = rf"(?P<parts>{_PART}(?:\s*(?:,\s*and\s|,|and|&|\+)\s*(?:the\s+)?{_PART})+)"
    link = (
        r"(?:\s*:|\s+(?:is|are|all|both|in|of|painted|should be|must be|made of|with|have|has|laid|covered|clad|"
        r"(?:in )?the colou?r of|a))*\s+"
    )
    end = END
    floor = r"(?:floor(?:ing|s)?(?:\s+tiles?)?)"
    on_floors = r"(?:mats?|cushions?|lamps?|pillows?|runners?|rugs?|vases?|lights?|poufs?)\b"
    print_ = one_of([word for row in data()["patterns"]["walls"].values() for word in row["words"]])
    walls, floors, doors = ("wall",), ("floor",), ("door",)
    checks = one_of([w for w in data()["patterns"]["floor"]["checkered"]["words"] if w.startswith("ch")])
    return (
        (
            ("wall", "floor", "ceiling"),
            rf"(?P<look>{run})\s+(?:on|for|over)\s+(?:the\s+|all\s+|both\s+)*{parts}\b",
            _parts,
        ),
        (("tile",), rf"{BEGINS}(?P<look>(?:{run}\s+)?{checks}\s+(?:floor\s+)?tiles?){END}", _floor),
        *((("",), pattern, _banded) for pattern in _bands()),
        (walls, rf"(?P<look>{run})\s+walls?\s+painted\s+(?:in\s+)?(?P<more>{run}){end}", _clad),
        (walls, rf"(?P<look>{run})\s+(?:all over |on |over |covering )(?:the |all |all the )?(?:four )?walls\b", _clad),
        (("wall", "floor", "ceiling"), rf"(?P<look>{run})\s+{parts}\b(?!(?:\s+(?:is|are|in|of))*\s+{run})", _parts),
        (("wall", "floor", "ceiling"), rf"\b{parts}{link}(?P<look>{run}){end}", _parts),
        (
            floors,
            rf"(?P<look>{run})\s+{floor}\b(?!\s+{on_floors})(?:\s+(?:in|of|with)\s+(?P<more>{run}){end})?",
            _floor,
        ),
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
        (doors, rf"\bdoors?{link}(?P<look>{run}){end}", _door),
    )


_SIDES = r"(?:left|right|far|back|end|opposite|front|long|short)"


__all__ = ["read_surfaces"]
