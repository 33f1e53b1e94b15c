"""English names from a model, as the taxonomy and the lexicon take them."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.materials import color_named
from sceneweaver.knowledge import match_room
from sceneweaver.scene import InputError

from ..model import PLACES
from ..things import match_of
from ..unwanted import is_class, kinds_unwanted
from ..vocabulary import vocabulary

LONGEST = 60
"""Most characters of an English name or of the words about a thing; of a quote twice as many."""


def excluded_categories(name: str) -> Iterator[str]:
    """The categories, or groups of them, that "no ..." means in English."""
    if is_class(name):
        yield from kinds_unwanted(name)
        return
    group = name.replace(" ", "_")
    if group in categories() and categories()[group].size is None:
        yield group
        return
    yield match_of(name).category


def english(name: str) -> str:
    """A name in lower case, plain letters, without an article; nothing where it is not written in Latin letters."""
    plain = "".join(c for c in unicodedata.normalize("NFKD", name[: 4 * LONGEST]) if not unicodedata.combining(c))
    if any(c.isalpha() and not c.isascii() for c in plain):
        return ""
    plain = "".join(c if c.isalnum() or c in " -'" else " " for c in plain.lower())
    spoken = plain.replace("_", " ").split()
    if spoken[:1] in (["a"], ["an"], ["the"]) and len(spoken) > 1:
        spoken = spoken[1:]
    return " ".join(spoken)[:LONGEST].strip()


@cache
def is_color(value: str) -> bool:
    """Whether an English word is a colour that can be made."""
    try:
        return bool(color_named(value))
    except InputError:
        return False


def part_of_room(name: str) -> str | None:
    """The place that a name means, when it means no thing: windows, a wall, the bedroom itself."""
    meant = vocabulary().get(name, {})
    if name in PLACES:
        return name
    if "noun" in meant:
        return None
    if (place := meant.get("place")) is not None:
        return str(place)
    room = match_room(name)
    return "room" if room is not None and room[1] == 1.0 else None


def cut(text: str, most: int = LONGEST) -> str:
    """Words of a model that are shown or kept: one line, not endless."""
    plain = " ".join(text.split())
    return plain if len(plain) <= most else plain[: most - 1] + "…"
