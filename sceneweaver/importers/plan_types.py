"""Types of rooms: words of files as the types that plans have."""

from __future__ import annotations

import re
from functools import lru_cache
from importlib import resources

from sceneweaver.assets.category import read_yaml

OUTDOOR = frozenset({"balcony", "terrace"})
"""Types of rooms that have no ceiling."""

OPENS_FROM = frozenset({"hallway", "corridor", "entrance_hall", "landing", "living_room", "living_dining"})
"""Types of rooms that doors open from: leaves swing into the other room."""


@lru_cache(maxsize=1)
def _words() -> dict[str, str]:
    table = read_yaml(resources.files("sceneweaver.importers").joinpath("plan_types.yaml"))
    return {word: kind for kind, words in table.items() for word in [kind, *words] if word}


def plan_type(word: str) -> str | None:
    """The type of a plan's room for a word of a file, such as "Master Bedroom 2"; None: it is no room.

    Examples:
        >>> plan_type("LivingRoom"), plan_type("WC"), plan_type("Shaft"), plan_type("Crypt 2"), plan_type("")
        ('living_room', 'guest_toilet', None, 'crypt', 'room')
    """
    name = _plain(word)
    if not name:
        return "room"
    return _words().get(name, _words().get(name.replace("_", ""), name)) or None


def known_type(word: str) -> str | None:
    """The type of a plan's room for a word that means one; None for any other word.

    Examples:
        >>> known_type("Bad"), known_type("bath-1"), known_type("shaft")
        (None, 'bathroom', None)
    """
    name = _plain(word)
    return _words().get(name, _words().get(name.replace("_", ""))) or None


def _plain(word: str) -> str:
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", word.strip())
    return re.sub(r"[^a-z]+", "_", re.sub(r"[\W_]*\d+$", "", spaced).lower()).strip("_")
