"""Words of the looks of surfaces: colours, what they are of, patterns; what a run of them says of a floor or a wall."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any, NamedTuple

from sceneweaver.assets.materials import color_words, finishes
from sceneweaver.knowledge.load import data_of

from ..model import StatedFinish
from ..parsed import Parsed
from ..source import Source
from .phrases import one_of

BEGINS = r"(?:(?<=^)|(?<=[.,;:!?(] )|(?<=[.;:!?(])|(?<=\band )|(?<=\bbut )|(?<=\bwith ))"
"""Before the first word of an item of a list, or of a clause."""

END = r"(?=\s*(?:$|[.,;:!?)\n]|(?:and|with|but|to|please|throughout|everywhere|for|so)\b))"
"""Behind the last word of what is said of a surface."""

NO_WORD = r"(?<![\w-])"
"""No part of a word stands before this."""

Reader = Callable[[re.Match[str], Source, Parsed], str | None]
"""What reads a phrase: it gives what is left of it, None for all."""


class Look(NamedTuple):
    """A run of words about a surface, read."""

    colors: tuple[str, ...]
    material: str | None
    pattern: str | None
    of: str | None
    """What a pattern is usually of."""
    dark: bool = False
    """Whether it is said to be dark, without a colour."""


_DENIED = re.compile(r"\b(?:no|not|without|never|avoid|nor|isn't|aren't)\s+(?:any\s+|a\s+|an\s+|the\s+)?$")


def is_denied(before: str) -> bool:
    """Whether a text ends with a denial of what follows: "no" of "no white walls"."""
    return _DENIED.search(before[-24:]) is not None


def add_finish(parsed: Parsed, source: Source, found: re.Match[str], part: str, **said: Any) -> bool:
    """One more finish; the first that is said of a part counts."""
    if any(one.part == part for one in parsed.finishes) or is_denied(source.text[: found.start()]):
        return False
    words = " ".join(found[0].split()).strip(" ,.;:")
    span = source.span(*found.span())
    parsed.finishes.append(StatedFinish(part=part, words=words, span=span, **said))  # type: ignore[arg-type]
    return True


# ---- the words of a look ---------------------------------------------------------------------------------------------


def look_of(text: str) -> Look:
    """What a run of words says of a surface.

    Examples:
        >>> from sceneweaver.language.statements.surface_words import look_of
        >>> look_of("red and cream checkered tiles").colors
        ('red', 'cream')
    """
    colors: list[str] = []
    material, pattern, of = None, None, None
    text = text.replace("-", " ")
    for word in re.findall(token(), text):
        for where in ("walls", "floor"):
            for name, row in data()["patterns"][where].items():
                if word in row["words"] and pattern is None:
                    pattern, of = name, row["of"]
        if word in _woods() or word in _colors():
            colors.append(_woods().get(word) or _tints().get(word) or word)
            continue
        if material is None:
            material = next((name for name, words in data()["clad"].items() if word in words), None)
        if material is None and word in data()["walls"] and (row := data()["walls"][word]).get("material"):
            material = row["material"]
            colors += [row["color"]] if word.startswith("white") else []
    return Look(tuple(dict.fromkeys(colors)), material, pattern, of, bool(re.search(r"\bdark\b", text)))


@cache
def data() -> Any:
    """The words of finishes, of ``knowledge/stated_finishes.yaml``."""
    return data_of("stated_finishes.yaml")


@cache
def _woods() -> dict[str, str]:
    return {**{n: n for n, one in finishes().items() if one.family == "wood"}, **data()["woods"]}


@cache
def _tints() -> dict[str, str]:
    return dict(data()["tints"])


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
def token() -> str:
    """One known word, or phrase, of a look."""
    rows = data()
    known = {*_plain_colors(), *_woods(), *rows["walls"], *rows["beside"]}
    known |= {word for words in rows["clad"].values() for word in words}
    known |= {word for rows in rows["patterns"].values() for row in rows.values() for word in row["words"]}
    known |= {word for row in rows["floors"].values() for word in row["words"]}
    known |= {"wood", "wooden", "timber"}
    known = {word for word in known if not word.startswith("half")}
    phrases = _spaced(word for word in known if " " in word)
    shaded = f"{one_of(_SHADES)} {one_of(_basic_colors())}"
    return rf"(?<![\w-])(?:{phrases}|{shaded}|{one_of(word for word in known if ' ' not in word)})(?![\w])"


def _spaced(phrases: Iterable[str]) -> str:
    """Any of some phrases, with blanks or hyphens."""
    return one_of(phrases).replace(r"\ ", "[ -]")


@cache
def hues() -> str:
    """A colour with a shade before it or none."""
    phrases = _spaced(word for word in _plain_colors() if " " in word)
    one = one_of(_basic_colors())
    return rf"{NO_WORD}(?:{phrases}|{one_of(_SHADES)} {one}|{one})(?![\w-])"


@cache
def run_of_look() -> str:
    """A run of such words."""
    between = r"(?:\s+(?:and|&|with|on|in)\s+|\s*/\s*|-|\s+)"
    return rf"{token()}(?:{between}{token()}){{0,5}}"


def floor_row(look: Look, text: str) -> dict[str, Any] | None:
    """Material, colours and pattern of a floor in a look; None where that is nothing that floors are of."""
    rows = data()
    row = rows["patterns"]["floor"].get(look.pattern or "", {})
    words = re.findall(token(), text.replace("-", " "))
    material = row.get("of") or next(
        (name for name, one in rows["floors"].items() if any(word in one["words"] for word in words)), None
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
    two = look.pattern == "checkered" or "second" in row
    tone = colors[0] if colors else row.get("tone")
    second = colors[1] if len(colors) > 1 else "white" if colors and tone != "white" else "black" if colors else None
    found = {"material": material, "color": tone, "pattern": look.pattern if row else None}
    if two and look.pattern != "checkered":
        second = colors[1] if len(colors) > 1 else row["second"]
    return found | ({"second": second or row.get("second")} if two else {})


def wall_row(look: Look) -> dict[str, Any] | None:
    """Material, colours and pattern of walls in a look."""
    material = look.material or look.of
    if look.pattern is not None and look.pattern not in data()["patterns"]["walls"]:
        material = "brick" if look.pattern == "brick" else look.material or ("stone" if not look.colors else None)
    pattern = look.pattern if look.pattern in data()["patterns"]["walls"] else None
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


__all__ = [
    "BEGINS",
    "END",
    "NO_WORD",
    "Look",
    "Reader",
    "add_finish",
    "data",
    "floor_row",
    "hues",
    "is_denied",
    "look_of",
    "run_of_look",
    "token",
    "wall_row",
]
