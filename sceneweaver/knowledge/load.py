"""The kinds of rooms and the templates of groups, read once from ``rooms/*.yaml`` and ``groups/*.yaml``."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any

from sceneweaver.scene import InputError
from sceneweaver.scene.messages import suggest

from .groups import GroupTemplate, expanded
from .model import RoomType


def read_yaml(text: str) -> Any:
    """YAML data whose bare key ``on`` is a word, not the truth value that YAML 1.1 makes of it."""
    import yaml

    def mend(data: Any) -> Any:
        if isinstance(data, dict):
            return {"on" if key is True else key: mend(value) for key, value in data.items()}
        return [mend(value) for value in data] if isinstance(data, list) else data

    return mend(yaml.load(text, Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader)))


@cache
def group_templates() -> Mapping[str, GroupTemplate]:
    """All templates of groups by name."""
    return MappingProxyType({data["name"]: GroupTemplate(**data) for data in _files("groups")})


@cache
def room_types() -> Mapping[str, RoomType]:
    """All kinds of rooms by name, their groups expanded into plain items."""
    templates = group_templates()
    return MappingProxyType({data["name"]: RoomType(**expanded(data, templates)) for data in _files("rooms")})


def _files(folder: str) -> list[dict[str, Any]]:
    """The data of all YAML files of a folder beside this module, by name."""
    files = sorted(resources.files(__package__ or "").joinpath(folder).iterdir(), key=lambda f: f.name)
    return [read_yaml(f.read_text(encoding="utf-8")) for f in files if f.name.endswith(".yaml")]


def room_type(name: str) -> RoomType:
    """The kind of room of that name; InputError when there is none."""
    known = room_types()
    if name not in known:
        raise InputError(f"room: '{name}' is unknown{suggest(name, known)}")
    return known[name]


@cache
def room_words() -> Mapping[str, str]:
    """Every phrase that names a kind of room, lower case, to its name; longer phrases should be tried first."""
    table = {name.replace("_", " "): name for name in room_types()}
    for name, room in room_types().items():
        for word in room.words:
            table.setdefault(word.lower(), name)
    return MappingProxyType(table)


def match_room(words: str) -> tuple[str, float] | None:
    """The kind of room that words name, and how surely (1 exact, less for a misspelt name); None when unknown."""
    asked = " ".join(words.lower().replace("_", " ").replace("-", " ").split())
    table = room_words()
    for form in (asked, asked.removesuffix("s")):
        if form in table:
            return table[form], 1.0
    alike = [form for form in difflib.get_close_matches(asked, table, n=5, cutoff=0.8) if _word_by_word(asked, form)]
    near = alike[:1]
    return (table[near[0]], difflib.SequenceMatcher(None, asked, near[0]).ratio()) if near else None


def _word_by_word(asked: str, known: str) -> bool:
    """Whether each word is a misspelling of its counterpart: a "boiler room" is no "toilet room"."""
    mine, theirs = asked.split(), known.split()
    return len(mine) != len(theirs) or all(
        difflib.SequenceMatcher(None, a, b).ratio() >= 0.75 for a, b in zip(mine, theirs, strict=True)
    )
