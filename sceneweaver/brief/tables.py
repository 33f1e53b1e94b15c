"""What English words mean to a request: phrases of ``words.yaml`` and ``groups.yaml``, nouns, colours, rooms."""

from __future__ import annotations

from functools import cache
from importlib import resources
from typing import Any

from sceneweaver.assets import categories
from sceneweaver.assets.materials import color_words, palette
from sceneweaver.assets.taxonomy import phrases
from sceneweaver.knowledge.load import read_yaml, room_words

LONGEST = 6
"""Words of the longest phrase."""

NUMBERS = {
    "zero": 0,
    "one": 1,
    "two": 2,
    "three": 3,
    "four": 4,
    "five": 5,
    "six": 6,
    "seven": 7,
    "eight": 8,
    "nine": 9,
    "ten": 10,
    "eleven": 11,
    "twelve": 12,
    "thirteen": 13,
    "fourteen": 14,
    "fifteen": 15,
    "sixteen": 16,
    "seventeen": 17,
    "eighteen": 18,
    "nineteen": 19,
    "twenty": 20,
    "thirty": 30,
    "forty": 40,
    "fifty": 50,
    "sixty": 60,
    "hundred": 100,
}

AMOUNTS: dict[str, tuple[int, int]] = {
    "a dozen": (12, 12),
    "dozen": (12, 12),
    "two dozen": (24, 24),
    "half a dozen": (6, 6),
    "half dozen": (6, 6),
    "a couple of": (2, 2),
    "couple of": (2, 2),
    "a pair of": (2, 2),
    "pair of": (2, 2),
    "several": (3, 5),
    "a few": (2, 4),
    "few": (2, 4),
    "some": (2, 4),
    "many": (5, 9),
    "lots of": (5, 9),
    "a lot of": (5, 9),
    "plenty of": (5, 9),
    "multiple": (2, 5),
    "various": (3, 5),
    "numerous": (5, 9),
    "a number of": (3, 6),
    "single": (1, 1),
    "twin": (2, 2),
    "double": (2, 2),
}

BOUNDS = {
    "at least": "least",
    "no less than": "least",
    "no fewer than": "least",
    "minimum": "least",
    "a minimum of": "least",
    "more than": "above",
    "over": "above",
    "up to": "most",
    "at most": "most",
    "no more than": "most",
    "maximum": "most",
    "a maximum of": "most",
    "not more than": "most",
    "less than": "below",
    "fewer than": "below",
}

MATERIALS = (
    "oak",
    "walnut",
    "pine",
    "birch",
    "beech",
    "ash",
    "teak",
    "mahogany",
    "wood",
    "wooden",
    "bamboo",
    "leather",
    "velvet",
    "linen",
    "fabric",
    "cotton",
    "wool",
    "glass",
    "metal",
    "steel",
    "iron",
    "brass",
    "copper",
    "chrome",
    "marble",
    "stone",
    "granite",
    "concrete",
    "plastic",
    "rattan",
    "wicker",
    "ceramic",
    "porcelain",
    "upholstered",
    "jute",
    "cork",
)


@cache
def words() -> dict[str, Any]:
    """The file ``words.yaml``."""
    return read_yaml(resources.files(__package__ or "").joinpath("words.yaml").read_text(encoding="utf-8"))


@cache
def groups() -> dict[str, Any]:
    """The file ``groups.yaml``."""
    return read_yaml(resources.files(__package__ or "").joinpath("groups.yaml").read_text(encoding="utf-8"))


@cache
def vocabulary() -> dict[str, dict[str, Any]]:
    """Every phrase that is known: phrase -> kind -> value."""
    table: dict[str, dict[str, Any]] = {}

    def put(phrase: Any, kind: str, value: Any) -> None:
        table.setdefault(str(phrase).lower().replace("-", " "), {}).setdefault(kind, value)

    data = words()
    for section in ("relations", "places", "scale", "room_scale", "shape", "density", "styles", "dims"):
        kind = {"relations": "relation", "places": "place", "dims": "dim"}.get(section, section)
        for value, listed in data[section].items():
            for phrase in listed:
                put(phrase, kind, value)
    plain = (
        "det",
        "with",
        "and",
        "each",
        "both",
        "pron",
        "verb",
        "neg",
        "nothing",
        "only",
        "only_all",
        "moods",
        "whom",
        "people_words",
        "pieces_of",
        "stop",
    )
    for section in plain:
        for phrase in data[section]:
            put(phrase, section, phrase)
    for name, row in groups()["groups"].items():
        for phrase in row["words"]:
            put(phrase, "group", name)
    for phrase, value in NUMBERS.items():
        put(phrase, "number", value)
    for phrase, value in AMOUNTS.items():
        put(phrase, "amount", value)
    for phrase, value in BOUNDS.items():
        put(phrase, "bound", value)
    for phrase in MATERIALS:
        put(phrase, "material", {"wooden": "wood"}.get(phrase, phrase))
    for phrase, finish in palette().items():
        if not finish.asked:
            put(phrase, "finish", phrase)
    for phrase in color_words():
        put(phrase, "color", phrase)
    for phrase, name in room_words().items():
        put(phrase, "room", name)
    for phrase, name in phrases().items():
        put(phrase, "noun", name)
        put(_plural(phrase), "noun", name)
    return table


def _plural(phrase: str) -> str:
    if phrase.endswith(("s", "x", "ch", "sh")):
        return phrase + "es"
    if phrase.endswith("y") and phrase[-2:-1] not in "aeiou":
        return phrase[:-1] + "ies"
    if phrase.endswith("shelf"):
        return phrase[:-1] + "ves"
    return phrase + "s"


def category_of(name: str) -> str:
    """A category with a body: for a group its usual member."""
    from sceneweaver.assets import resolve

    found = categories().get(name)
    return name if found is not None and found.size is not None else resolve(name.replace("_", " ")).category
