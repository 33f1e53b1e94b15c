"""What a request says of all of a room, or of all of a surface: everything in one colour, a room of stone, tiles up to
the ceiling, carpet from wall to wall.

"All pale grey except the vase", "an all-white kitchen", "a brick cellar", "tiled to the ceiling in green".
"""

from __future__ import annotations

import re
from functools import cache

from sceneweaver.assets.materials import finishes

from ..parsed import Parsed
from ..source import Source
from ..vocabulary import vocabulary
from .phrases import one_of
from .surface_words import (
    BEGINS,
    END,
    NO_WORD,
    Reader,
    add_finish,
    data,
    floor_row,
    hues,
    look_of,
    run_of_look,
    wall_row,
)


def _carpet(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """Carpet over all of the floor: what is wall to wall, or named without an article as stuff is."""
    groups = found.groupdict()
    text = " ".join(word for word in (groups.get("look"), groups.get("more")) if word)
    text = "charcoal" if text == "dark" else text
    look = look_of(text)
    row = floor_row(look._replace(material=None), f"{text} carpet") if text else {"material": "carpet"}
    if row is None or row["material"] != "carpet":
        return None
    return " " if add_finish(parsed, source, found, "floor", **row) else None


def _dado(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    row = wall_row(look_of(found["look"]))
    if row is None or any(one.part in ("lower", "tiled", "panels") for one in parsed.finishes):
        return None
    return " " if add_finish(parsed, source, found, "lower", high=data()["marks"]["dado"], **row) else None


def _tiled(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """Tiles from the floor up to the ceiling."""
    groups = found.groupdict()
    row = wall_row(look_of(groups.get("look") or "")._replace(material="tiles")) or {}
    row.pop("material", None)
    high = data()["heights"]["panelled"]
    return " " if add_finish(parsed, source, found, "tiled", high=high, **row) else None


def _tiled_run(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    return _tiled(found, source, parsed) if look_of(found["look"]).of == "tiles" or "til" in found["look"] else None


def _is_room(spoken: str) -> bool:
    """Whether one or two words begin with the name of a room that is no part of a thing's: a bath, no bath mat."""
    table, (first, _, rest) = vocabulary(), spoken.partition(" ")
    if not rest or "room" in table.get(spoken, {}):
        return "room" in table.get(spoken, {})
    goes_on = table.get(spoken, {}).keys() | table.get(rest, {}).keys()
    return "room" in table.get(first, {}) and not goes_on & {"noun", "plural"}


def _of_room(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """ "A brick cellar", "a chapel of rough stone": the walls are of it."""
    if not _is_room(found["room"]):
        return None
    row = wall_row(look_of(found["look"]))
    if row is None or not add_finish(parsed, source, found, "walls", **row):
        return None
    return found["room"].rjust(len(found[0])) if found.start("room") > found.start("look") else found["room"]


def _bare_walls(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """What is said of walls alone, as all of a clause: "limewashed"."""
    row = wall_row(look_of(found["look"]))
    return " " if row is not None and add_finish(parsed, source, found, "walls", **row) else None


def _everything(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """All that is there in one colour or two; what has a colour of its own is told beside it."""
    look = look_of(found["look"])
    woods = {name for name, one in finishes().items() if one.family == "wood"}
    if not look.colors or look.material or look.pattern or any(color in woods for color in look.colors):
        return None
    if found[0].startswith("all") and _is_of_things(source.text[: found.start()]):
        return None
    second = look.colors[1] if len(look.colors) > 1 else None
    if not add_finish(parsed, source, found, "everything", color=look.colors[0], second=second):
        return None
    what = (found.groupdict().get("what") or "").strip()
    if not what or source.text.count(what.split()[-1]) > 1:
        return " "
    return f". {what}".rjust(len(found[0]))


METALS = "chrome|brass|copper|gold|silver|bronze|steel"
"""Metals that are a room's where they are said to be everywhere."""


def _is_of_things(before: str) -> bool:
    """Whether a comma stands before that sets it behind things: "three chairs, all black"."""
    listed = re.search(r"([a-z]+)\s*,\s*$", before)
    if listed is None:
        return False
    kinds = vocabulary().get(listed[1], {}).keys()
    return bool(kinds & {"noun", "plural"}) and "room" not in kinds


def _metal(found: re.Match[str], source: Source, parsed: Parsed) -> str:
    """ "Chrome everywhere": a metal that the room has as a colour."""
    parsed.colors.append({"chrome": "silver", "steel": "silver"}.get(found["metal"], found["metal"]))
    parsed.referred.append(source.span(*found.span()))
    return " "


def _trodden(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """ "Shavings on the boards": what the floor is of is told by what lies on it."""
    row = floor_row(look_of(found["look"]), found["look"])
    return "on the floor" if row is not None and add_finish(parsed, source, found, "floor", **row) else None


def _all_of_room(found: re.Match[str], source: Source, parsed: Parsed) -> str | None:
    """ "An all-white kitchen"; an all-white desk is a white one."""
    if not _is_room(found["room"]):
        return f"{found['look']} {found['room']}".rjust(len(found[0]))
    return found["room"].rjust(len(found[0])) if _everything(found, source, parsed) is not None else None


@cache
def readers_of_all() -> tuple[tuple[tuple[str, ...], str, Reader], ...]:
    """Letters of which some stand in each text that a pattern fits; it; what reads it."""
    run, begins, end = run_of_look(), BEGINS, END
    clause = r"(?:(?<=^)|(?<=[.;:!?(] )|(?<=[.;:!?(]))"
    several = rf"{hues()}(?:\s*(?:,|and|&|/|or)\s*{hues()}){{0,2}}"
    is_so = r"(?:,?\s+(?:is|are|be|in|must be|should be|has to be|to be|painted|done|of|kept|every|shades?|tones?))*\s+"
    but = (
        r"(?:\s*,?\s*(?:except|save|apart from|bar|but|other than|aside from|with the exception of)(?: for| only)?"
        r"\s+(?P<what>(?:the |one |an? |my |his |her |our )?(?:[a-z-]+ ){0,2}?[a-z-]+)"
        r"(?=\s*(?:$|[.,;:!?)\n]|\b(?:which|that|and|in|on|is|at|with)\b)))?"
    )
    turns = r"(?=\s+(?:except|save|apart|bar|other|aside)\b)"
    all_ = (
        r"(?:\b(?:absolutely |almost |nearly |really )?(?:everything(?: else| in it)?|"
        r"the (?:whole|entire) (?:room|place|thing)|all of it|the lot|every surface)|"
    )
    bare = hues().removeprefix(NO_WORD)  # behind the hyphen of "all-white"
    over = r"(?:\s+(?:everywhere|all over|throughout|from floor to ceiling|from top to bottom))?"
    stuff = one_of(data()["built_of"])
    rooms = r"(?P<room>[a-z]+(?: [a-z]+)?)"
    tiled = r"(?:\bwalls?\s+(?:are\s+)?)?\b(?:fully\s+|all\s+)?"
    to_top = r"(?:right |all the way )?(?:up )?(?:from floor )?to (?:the )?ceiling"
    return (
        (
            ("all", "every", "whole", "entire", "lot"),
            rf"{all_}(?:{clause}|(?<=, ))all){is_so}(?P<look>{several}){over}(?:{end}|{turns}){but}",
            _everything,
        ),
        (("everything",), rf"(?P<look>{several})\s+everything\b{but}", _everything),
        (
            ("everywhere", "throughout", "all over"),
            rf"{begins}(?P<look>{several})\s+(?:everywhere|throughout|all over)(?:{end}|{turns}){but}",
            _everything,
        ),
        (
            ("shade",),
            rf"\bin\s+(?:every|all|different|various|many)\s+shades?\s+of\s+(?P<look>{several}){over}{end}",
            _everything,
        ),
        (("all",), rf"\ball[- ](?P<look>{bare})\s+{rooms}\b", _all_of_room),
        (
            ("carpet",),
            rf"(?:(?P<look>{run})\s+)?\b(?:wall[- ]to[- ]wall|fitted)\s+carpet(?:ing)?\b(?:\s+in\s+(?P<more>{run}))?",
            _carpet,
        ),
        (
            ("carpet",),
            rf"(?P<look>{run})\s+carpet(?:ing)?\s+(?:from\s+)?(?:wall[- ]to[- ]wall|throughout|everywhere|all over)\b",
            _carpet,
        ),
        (
            ("carpet",),
            rf"{begins}(?P<look>{run})\s+carpet(?:ing)?{end}(?:\s*[.,;]\s*(?P<more>{hues()})(?=\s*(?:$|[.,;!])))?",
            _carpet,
        ),
        (
            ("everywhere", "throughout", "all over"),
            rf"\b(?P<metal>{METALS})\s+(?:everywhere|throughout|all over)\b",
            _metal,
        ),
        (
            ("on",),
            r"\bon\s+(?:the|bare)\s+(?P<look>boards|floorboards|concrete|flagstones|lino|linoleum|cobbles|parquet)"
            rf"{end}",
            _trodden,
        ),
        (("dado",), rf"\bdado(?:\s+(?:is|in|of|painted))*\s+(?P<look>{run}){end}", _dado),
        (("dado",), rf"(?P<look>{run})\s+dado\b(?!\s+(?:rail|height|level))", _dado),
        (
            ("tile", "tiling"),
            rf"{tiled}tiled\s+(?:in\s+(?P<look>{run})\s+)?{to_top}\b(?!\s+in\s+{run})",
            _tiled,
        ),
        (
            ("tile", "tiling"),
            rf"{tiled}(?:tiled|tiles|tiling)\s+{to_top}\s+in\s+(?P<look>{run}){end}",
            _tiled,
        ),
        (("tile", "tiling"), rf"(?P<look>{run})\s+{to_top}\b", _tiled_run),
        (("",), rf"(?P<look>{stuff}(?:\s+{stuff})?)\s+{rooms}\b", _of_room),
        (
            ("of",),
            rf"\b(?P<room>[a-z]+)\s+(?:(?:made|built|all)\s+)?(?:of|in)\s+"
            rf"(?P<look>{stuff}(?:\s+(?:and\s+)?{stuff})?){end}",
            _of_room,
        ),
        (("",), rf"{begins}(?:all )?(?P<look>{one_of(data()['bare_walls'])}){end}", _bare_walls),
    )


__all__ = ["METALS", "readers_of_all"]
