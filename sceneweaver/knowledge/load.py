"""The kinds of rooms and the templates of groups, read once from ``rooms/*.yaml`` and ``groups/*.yaml``."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources
from types import MappingProxyType
from typing import Any

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


@cache
def room_words() -> Mapping[str, str]:
    """Every phrase that names a kind of room, lower case, to its name; longer phrases should be tried first."""
    table = {name.replace("_", " "): name for name in room_types()}
    for name, room in room_types().items():
        for word in room.words:
            table.setdefault(word.lower(), name)
    return MappingProxyType(table)
