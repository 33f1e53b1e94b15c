"""The kinds of rooms and the templates of groups, read once from ``rooms/*.yaml`` and ``groups/*.yaml``."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Any

from sceneweaver.io import packaged

from .groups import GroupTemplate, expanded
from .model import RoomType


def read_yaml(text: str) -> Any:
    """YAML data of our own whose bare key ``on`` is a word, not the truth value that YAML 1.1 makes of it."""
    return with_on(packaged.parse(text))


def with_on(data: Any) -> Any:
    """The data with the key ``on`` where YAML 1.1 made a truth value of it."""
    if isinstance(data, dict):
        return {"on" if key is True else key: with_on(value) for key, value in data.items()}
    return [with_on(value) for value in data] if isinstance(data, list) else data


@cache
def data_of(name: str) -> Any:
    """What a YAML file beside this module says."""
    return read_yaml(packaged.text(__package__ or "", name))


def files_of(folder: str) -> dict[str, dict[str, Any]]:
    """The data of all YAML files of a folder beside this module, in the order of their names without the ending."""
    files = sorted(packaged.folder(__package__ or "", folder).iterdir(), key=lambda f: f.name)
    yaml_files = [file.name for file in files if file.name.endswith(".yaml")]
    return {name.removesuffix(".yaml"): data_of(f"{folder}/{name}") for name in yaml_files}


def check_known(file: str, names: Iterable[str], known: Container[str], kind: str = "category") -> None:
    """ValueError where a file names something that is not known."""
    if unknown := sorted(name for name in set(names) if name not in known):
        raise ValueError(f"{file}: {', '.join(unknown)} is no {kind}")


@cache
def group_templates() -> Mapping[str, GroupTemplate]:
    """All templates of groups by name."""
    return MappingProxyType({data["name"]: GroupTemplate(**data) for data in files_of("groups").values()})


@cache
def room_types() -> _Rooms:
    """All kinds of rooms by name, their groups expanded into plain items."""
    return _Rooms({data["name"]: data for data in files_of("rooms").values()})


class _Rooms(Mapping[str, RoomType]):
    """Kinds of rooms by name, each checked when it is asked for: a design needs one of hundreds."""

    def __init__(self, files: Mapping[str, Mapping[str, Any]]):
        self._files = files
        self._made: dict[str, RoomType] = {}

    def __getitem__(self, name: str) -> RoomType:
        if name not in self._made:
            self._made[name] = RoomType(**expanded(self._files[name], group_templates()))
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def words_of(self, name: str) -> Sequence[str]:
        """Other names of a kind of room, without checking the rest of its file."""
        return self._files[name].get("words", ())


@cache
def plain_room() -> RoomType:
    """A room with light and nothing else; its other items stand for what a request names, with what these need."""
    return RoomType(**data_of("plain_room.yaml"))


@cache
def room_words() -> Mapping[str, str]:
    """Every phrase that names a kind of room, lower case, to its name; longer phrases should be tried first."""
    table = {name.replace("_", " "): name for name in room_types()}
    for name in room_types():
        for word in room_types().words_of(name):
            table.setdefault(word.lower(), name)
    return MappingProxyType(table)
