"""Kinds of rooms that were learned: files of the user, read beside those that ship with the library.

A learned room is meant where a request says its name or one of its words, and nowhere else: it takes no word that is
known already, and no part in telling which room is meant by things. A file that is damaged is left out with a warning.
"""

from __future__ import annotations

import logging
import os
from collections import ChainMap
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, cast

from sceneweaver.io import read_bytes, write_atomic
from sceneweaver.io.messages import shorten, suggest
from sceneweaver.runtime.caches import data_place, kept_in
from sceneweaver.scene import InputError

from .load import room_types, room_words
from .model import RoomType
from .room_files import LARGEST, plain, read_room, slug

MOST = 500
"""Rooms that are read of a folder at most."""

log = logging.getLogger(__name__)

_only: ContextVar[Path | None | bool] = ContextVar("only", default=False)
_beside: ContextVar[tuple[RoomType, ...] | None] = ContextVar("beside", default=None)


def rooms_folder() -> Path:
    """Where learned rooms are kept: ``$SCENEWEAVER_ROOMS``, or the user's data folder, or what stands in for it."""
    given = os.environ.get("SCENEWEAVER_ROOMS")
    return Path(given).expanduser() if given else kept_in(data_place("sceneweaver/rooms"))


@contextmanager
def rooms_of(folder: Path | None) -> Iterator[None]:
    """Within it the learned rooms are those of a folder, not the user's; with None there are none."""
    token = _only.set(folder)
    try:
        with rooms_apart():
            yield
    finally:
        _only.reset(token)


@contextmanager
def rooms_apart() -> Iterator[None]:
    """Within it rooms may be made known by `know`; after it they are not."""
    token = _beside.set(_beside.get() or ())
    try:
        yield
    finally:
        _beside.reset(token)


def know(room: RoomType) -> None:
    """Within `rooms_of` or `rooms_apart`, make a room known by its name; no request is read otherwise for it."""
    others = _beside.get()
    if others is not None:
        _beside.set((*others, room))


def all_rooms() -> Mapping[str, RoomType]:
    """The kinds of rooms that ship with the library, then those that were learned; checked when they are asked for."""
    return ChainMap(cast(Any, room_types()), dict(learned_rooms()))


def learned_rooms() -> Mapping[str, RoomType]:
    """The learned rooms by name, as their files are now."""
    beside = {room.name: room for room in _beside.get() or ()}
    return MappingProxyType({**beside, **_kept()}) if beside else _kept()


def _place() -> Path | None:
    """The folder that is read now; None where there are to be no learned rooms."""
    folder = _only.get()
    return rooms_folder() if isinstance(folder, bool) else folder


def _kept() -> Mapping[str, RoomType]:
    place = _place()
    return _rooms(_state(place)) if place is not None else MappingProxyType({})


def learned_words() -> Mapping[str, str]:
    """Every phrase that names a learned room, lower case, to its name; none of them is known otherwise."""
    rooms = _kept()
    table = {plain(name): name for name in rooms}
    for name, room in rooms.items():
        for word in room.words:
            table.setdefault(plain(word), name)
    return {word: name for word, name in table.items() if word not in room_words()}


def named_in(text: str) -> list[RoomType]:
    """The learned rooms that a text names."""
    low = f" {plain(text)} "
    found = {name for word, name in learned_words().items() if f" {word} " in low}
    return [room for name, room in _kept().items() if name in found]


def keep_room(text: str, folder: Path | None = None) -> Path:
    """Keep a room for later; in the place of one of the same name.

    Args:
        text: of its file.
        folder: where; None: with the user's.

    Raises:
        InputError: when it is no room, has a name or a word that is known already, or cannot be written.
    """
    room = read_room(text)
    if taken := _taken(room):
        raise InputError(f"room: {taken}")
    if len(text.encode()) > LARGEST:
        raise InputError(f"room: {room.name} has more than {LARGEST // 1024} kB; write it shorter")
    place = folder or rooms_folder()
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{place}: cannot be made ({error.strerror}); set SCENEWEAVER_ROOMS to another") from None
    path = place / f"{room.name}.yaml"
    write_atomic(path, text)
    return path


def forget_room(words: str) -> Path:
    """Remove a learned room for good; InputError when there is none of that name."""
    name, place = slug(words), rooms_folder()
    path = place / f"{name}.yaml"
    if name not in learned_rooms() and not path.is_file():
        if name in room_types():
            raise InputError(f"room: {name} comes with sceneweaver and cannot be forgotten")
        raise InputError(f"room: '{name}' was never learned{suggest(name, learned_rooms(), what='learned')}")
    path.unlink(missing_ok=True)
    return path


def room_file(name: str) -> str:
    """The text of the file of a learned room; InputError when there is none."""
    place = _place()
    if place is None or name not in _kept():
        raise InputError(f"room: '{shorten(name)}' was never learned{suggest(name, learned_rooms(), what='learned')}")
    return read_bytes(place / f"{name}.yaml", max_bytes=LARGEST).decode()


State = tuple[tuple[str, int, int], ...]


def _state(folder: Path) -> State:
    """Path, time and length of each file of a folder, also of what is none: reading it says so."""
    try:
        named = [f for f in folder.glob("*.yaml") if not f.name.startswith(".")]
        files = [(str(f), f.stat() if f.exists() else f.lstat()) for f in named]
    except OSError:
        return ()
    return tuple(sorted((path, stat.st_mtime_ns, stat.st_size) for path, stat in files))


@lru_cache(maxsize=8)
def _rooms(state: State) -> Mapping[str, RoomType]:
    found: dict[str, RoomType] = {}
    for path, _, _ in state[:MOST]:
        try:
            room = read_room(read_bytes(path, max_bytes=LARGEST).decode())
            if room.name != Path(path).stem:
                raise InputError(f"name is {shorten(room.name)}; name the file and the room alike")
            if taken := _taken(room):
                raise InputError(taken)
        except (InputError, UnicodeDecodeError) as error:
            log.warning("learned room %s is left out: %s", path, shorten(" ".join(str(error).split()), 200))
            continue
        found[room.name] = room
    return MappingProxyType(found)


def _taken(room: RoomType) -> str:
    """Which of a room's names is known already; empty when none is."""
    for word in (room.name, *room.words):
        if plain(word) in room_words():
            return f"'{shorten(word)}' is known already, as {room_words()[plain(word)]}; give it another name"
    return ""
