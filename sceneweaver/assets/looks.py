"""Words about what a thing looks like: colour, material, style, shape, size, counted parts."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib import resources
from typing import Any, Literal

from sceneweaver.scene import InputError

from .asset import Mount
from .category import REACH, Category, read_yaml
from .materials import color_named, color_words, finishes_named, material_words

Kind = Literal["color", "material", "style", "shape", "size", "mount"]

NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10}
NUMBERS |= {"single": 1, "double": 2, "dual": 2, "triple": 3, "multi": 3}

SCREEN = 16 / math.hypot(16, 9)
"""Width of a screen as a share of its diagonal."""

TALL, CEILING = 1.9, 2.3
"""Height [m] up to which words make things taller than usual, and of what reaches from floor to ceiling."""

LONGEST = 4
"""Words of the longest phrase."""


@dataclass(frozen=True)
class Words:
    """Words about a look, read: the first of each kind, extents as shares of the usual range, the words left over.

    ``extents`` has "depth", "width", "height", "long" and "short" (side in plan), 0 the least and 1 the most.
    ``inches`` is the diagonal of a screen. ``said`` has for each kind, or each counted part, the words that said it.
    """

    color: str | None = None
    material: str | None = None
    style: str | None = None
    shape: str | None = None
    mount: Mount | None = None
    extents: tuple[tuple[str, float], ...] = ()
    parts: tuple[tuple[str, int], ...] = ()
    inches: float | None = None
    said: tuple[tuple[str, str], ...] = ()
    left: tuple[str, ...] = ()


@cache
def vocabulary() -> dict[str, dict[Kind, Any]]:
    """Every phrase about a look with what it says; some say several things ("gold", "natural")."""
    data = _data()
    table: dict[str, dict[Kind, Any]] = {}

    def put(phrase: str, kind: Kind, value: Any) -> None:
        table.setdefault(phrase.replace("_", " "), {}).setdefault(kind, value)

    for word in color_words():
        put(word, "color", word)
    for word in material_words():
        put(word, "material", word)
    for name, words in data["shapes"].items():
        for word in words:
            put(word, "shape", name)
    for name, words in data["styles"].items():
        for word in words:
            put(word, "style", name)
    for name, words in data["mounts"].items():
        for word in words:
            put(word, "mount", name)
    for word, extents in data["sizes"].items():
        put(word, "size", tuple(extents.items()))
    return table


@cache
def roles_of_detail(part: str) -> tuple[str, ...]:
    """The roles by which drawings give a part its finish, the likeliest first."""
    return tuple(_data()["details"].get(part, ()))


@lru_cache(maxsize=4096)
def is_look(phrase: str) -> bool:
    """Whether all words of a phrase are about a look."""
    return not read_words(phrase).left


def read_words(phrase: str | Sequence[str]) -> Words:
    """What a phrase says about a look, the longest known words first."""
    text = phrase if isinstance(phrase, str) else " ".join(phrase)
    words = re.sub(r"[_\-]+", " ", text.lower()).replace(",", " ").split()
    found: dict[str, Any] = {}
    parts: dict[str, int] = {}
    extents: dict[str, float] = {}
    said: dict[str, str] = {}
    left: list[str] = []
    at = 0
    while at < len(words):
        used = _counted(words, at, parts, said) or _phrase(words, at, found, extents, said)
        if not used and words[at].isdigit() and words[at + 1 : at + 2] in (["inch"], ["inches"]):
            found["inches"], said["size"], used = float(words[at]), " ".join(words[at : at + 2]), 2
        if not used:
            left.append(words[at])
        at += used or 1
    left = [word for word in left if word not in ("with", "and", "in", "a", "an", "of", "the", "sized", "size", "made")]
    return Words(
        **found,
        extents=tuple(extents.items()),
        parts=tuple(parts.items()),
        said=tuple(said.items()),
        left=tuple(left),
    )


def extents_of(category: Category, words: Words) -> tuple[float | None, float | None, float | None]:
    """Depth, width and height [m] that words mean for a category; None where they say nothing."""
    size: list[float | None] = [None, None, None]
    if category.size is None:
        return None, None, None
    ranges = category.size.ranges
    long = 0 if ranges[0][1] > ranges[1][1] else 1
    axes = {"depth": 0, "width": 1, "height": 2, "long": long, "short": 1 - long}
    if words.inches is not None and category.parent == "electronics":
        low, high = ranges[1]
        size[1] = min(high, max(low, round(words.inches * 0.0254 * SCREEN, 3)))
    for name, share in words.extents:
        size[axes[name]] = _extent(ranges[axes[name]], share, axes[name] == 2)
    if words.shape in ("round", "square") and category.mount[0] != "wall" and None not in size[:2]:
        (a0, a1), (b0, b1) = category.size.reach[:2]
        side = min(size[:2]) if dict(words.extents).get("depth", 0.5) < 0.5 else max(size[:2])  # pyright: ignore
        size[:2] = [min(max(side, a0, b0), a1, b1)] * 2
    return size[0], size[1], size[2]


def _extent(usual: tuple[float, float], share: float, upright: bool) -> float:
    """An extent [m] by where in its usual range it is; from 0 to -1 and from 1 to 2 it goes to the ends of the reach.

    What is taller than usual is at most `TALL`: a tall bookcase is high enough as it is.
    """
    low, high = usual
    if share < 0.0:
        return round(low * (1.0 - (1.0 - REACH[0]) * -share), 3)
    if share > 1.0:
        beyond = high * (1.0 + (REACH[1] - 1.0) * (share - 1.0))
        return round(max(high, min(beyond, TALL if share <= 2.0 else CEILING)) if upright else beyond, 3)
    return min(high, max(low, round(low + share * (high - low), 3)))


def shows(attributes: Mapping[str, Any], words: Words) -> dict[str, bool]:
    """For each kind of look, and each counted part, that words ask for: whether an asset's attributes show it."""
    found: dict[str, bool] = {}
    if words.color:
        found["color"] = attributes.get("color") == color_named(words.color)
    if words.material:
        wanted = {_undyed(f.material.name) for f in finishes_named(words.material)}
        found["material"] = _undyed(str(attributes.get("material"))) in wanted
    if words.shape:
        found["shape"] = attributes.get("shape") == words.shape
    return found | {name: attributes.get(name) == count for name, count in words.parts}


def _undyed(finish: str) -> str:
    """What is left of a finish's name when it is dyed: "velvet" of "green velvet"."""
    return finish.rpartition(" ")[2]


def _phrase(words: list[str], at: int, found: dict[str, Any], extents: dict[str, float], said: dict[str, str]) -> int:
    """Words from one place on that are about a look; how many were used."""
    table = vocabulary()
    for length in range(min(LONGEST, len(words) - at), 0, -1):
        phrase = " ".join(words[at : at + length])
        kinds = table.get(phrase)
        if kinds is None:
            kinds = _composed(phrase, length)
        if kinds is None:
            continue
        for kind, value in kinds.items():
            if kind == "size":
                for name, share in value:
                    extents.setdefault(name, share)
                said.setdefault("size", phrase)
            elif kind not in found:
                found[kind] = value
                said[kind] = phrase
        return length
    return 1 if words[at] in _data()["idle"] else 0


@lru_cache(maxsize=4096)
def _composed(phrase: str, length: int) -> dict[Kind, Any] | None:
    """A shade of a colour ("light sage") or a worked material ("brushed brass") that the tables do not list."""
    if length == 1:
        return None
    if finishes_named(phrase):
        return {"material": phrase}
    try:
        color_named(phrase)
    except InputError:
        return None
    return {"color": phrase}


def _counted(words: list[str], at: int, parts: dict[str, int], said: dict[str, str]) -> int:
    """ "Three drawer", "2 seater": how many words were used."""
    if at + 1 >= len(words):
        return 0
    count = int(words[at]) if words[at].isdigit() and len(words[at]) < 3 else NUMBERS.get(words[at])
    name = next((name for name, units in _data()["parts"].items() if words[at + 1] in units), None)
    if count is None or name is None:
        return 0
    parts.setdefault(name, count)
    said.setdefault(name, f"{words[at]} {words[at + 1]}")
    return 2


@cache
def _data() -> dict[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("looks.yaml"))
