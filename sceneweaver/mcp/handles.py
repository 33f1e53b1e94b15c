"""Scenes and homes that are open: short ids with numbered versions, undo and redo."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, TypeVar

import anyio

from sceneweaver.io.messages import clean, shorten, suggest
from sceneweaver.scene import InputError

from .limits import Limits


class Named(Protocol):
    """What a scene and a home have in common here."""

    @property
    def id(self) -> str:
        """Its name."""
        ...


Content = TypeVar("Content", bound=Named)

_ID = re.compile(r"[a-z]\d+")


@dataclass(frozen=True)
class Version(Generic[Content]):
    """A scene or a home as it was after one change.

    Attributes:
        number: from 1; never given twice.
        content: the scene or the home, which nothing changes.
        report: the judge's report on it, as the data of metrics.json.
        change: what made it, in words.
        review: what the critic of a design said of it; None for what nobody reviewed.
    """

    number: int
    content: Content
    report: Mapping[str, Any]
    change: str
    review: Mapping[str, Any] | None = None


@dataclass
class Handle(Generic[Content]):
    """An open scene or home: the versions that are kept, and the line of them along which undo and redo go.

    ``changing`` is held while a change is computed, so that changes of one scene come one after another. ``basis`` is
    what it is judged by beside the rules that hold for all: for a home its programme and profile.
    """

    id: str
    most: int
    basis: Any = None
    versions: dict[int, Version[Content]] = field(default_factory=dict)
    line: list[int] = field(default_factory=list)
    at: int = -1
    last: int = 0
    changing: anyio.Lock = field(default_factory=anyio.Lock)

    @property
    def current(self) -> Version[Content]:
        """The version that is looked at and changed."""
        return self.versions[self.line[self.at]]

    def add(self, content: Content, report: Mapping[str, Any], change: str, review: Any = None) -> Version[Content]:
        """A new version after the current one. What was undone before is kept for `get`, but not for redo.

        Where too many are kept, what was undone goes first, then the oldest.
        """
        self.last += 1
        version = Version(self.last, content, report, change, review)
        self.versions[version.number] = version
        self.line[self.at + 1 :] = [version.number]
        self.at = len(self.line) - 1
        while len(self.versions) > self.most:
            undone = self.versions.keys() - set(self.line)
            oldest = min(undone or self.versions)
            del self.versions[oldest]
            if oldest in self.line:
                self.line.remove(oldest)
                self.at -= 1
        return version

    def get(self, number: int | None) -> Version[Content]:
        """A version by its number; None means the current one."""
        if number is None:
            return self.current
        if number in self.versions:
            return self.versions[number]
        kept = f"{min(self.versions)} to {max(self.versions)}"
        why = f"is no longer kept, the last {self.most} are" if 0 < number <= self.last else "is not there"
        raise InputError(f"version: {number} of {self.id} {why}; give one of {kept}")

    def go(self, number: int) -> None:
        """Make a version that is kept the current one; where it was left behind by changes, it comes back after it."""
        version = self.get(number)
        if version.number not in self.line:
            self.line[self.at + 1 :] = [version.number]
        self.at = self.line.index(version.number)

    def before(self, version: Version[Content]) -> Version[Content]:
        """The version that comes before one in number; the first kept one comes before itself."""
        return self.versions[max((n for n in self.versions if n < version.number), default=version.number)]

    def step(self, by: int) -> Version[Content]:
        """Go back (-1) or forward (+1) along the line; the version that is current then."""
        at = self.at + by
        if not 0 <= at < len(self.line):
            if by > 0:
                raise InputError(f"redo: nothing of {self.id} was undone")
            cut = min(self.versions) > 1
            why = f"older versions than {min(self.versions)} are no longer kept" if cut else "there is nothing to undo"
            raise InputError(f"undo: {self.id} is at version {self.current.number}; {why}")
        self.at = at
        return self.current


class Handles(Generic[Content]):
    """All scenes, or all homes, that are open, in the order in which they were opened.

    Args:
        limits: how many, with how many versions.
        noun: what they are; ids begin with its first letter.
        others: what is said of an id of the other kind.
    """

    def __init__(self, limits: Limits, noun: str = "scene", others: str = "") -> None:
        self._limits = limits
        self._noun, self._others = noun, others
        self._open: dict[str, Handle[Content]] = {}
        self._count = 0

    def __iter__(self) -> Iterator[Handle[Content]]:
        return iter(list(self._open.values()))

    def __contains__(self, name: str) -> bool:
        return name in self._open

    def require_room(self) -> None:
        """InputError where no more may be opened."""
        if len(self._open) >= self._limits.scenes:
            raise InputError(f"{self._noun}s: {len(self._open)} are open, and no more are kept; close one first")

    def open(
        self, content: Content, report: Mapping[str, Any], change: str, review: Any = None, basis: Any = None
    ) -> Handle[Content]:
        """A new handle with a scene or a home as its first version."""
        self.require_room()
        self._count += 1
        handle = Handle[Content](f"{self._noun[0]}{self._count}", self._limits.versions, basis)
        handle.add(content, report, change, review)
        self._open[handle.id] = handle
        return handle

    def get(self, name: str) -> Handle[Content]:
        """The handle of an id; InputError where none is open under it."""
        if name in self._open:
            return self._open[name]
        known = suggest("", self._open, what="open are") if self._open else "; open or design one first"
        known = self._others if self._others and _ID.fullmatch(name) and name[0] != self._noun[0] else known
        raise InputError(f"{self._noun}: '{shorten(clean(name), 40)}' is not open{known}")

    def close(self, name: str) -> Handle[Content]:
        """Forget a scene or home with all its versions."""
        handle = self.get(name)
        del self._open[name]
        return handle
