"""Scenes that are open: short ids with numbered versions, undo and redo."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import anyio

from sceneweaver.io.messages import clean, shorten, suggest
from sceneweaver.scene import InputError, Scene

from .limits import Limits


@dataclass(frozen=True)
class Version:
    """A scene as it was after one change.

    Attributes:
        number: from 1; never given twice.
        scene: the scene, which nothing changes.
        report: the judge's report on it, as the data of metrics.json.
        change: what made it, in words.
        review: what the critic of a design said of it; None for what nobody reviewed.
    """

    number: int
    scene: Scene
    report: Mapping[str, Any]
    change: str
    review: Mapping[str, Any] | None = None


@dataclass
class Handle:
    """An open scene: the versions that are kept, and the line of them along which undo and redo go.

    ``changing`` is held while a change is computed, so that changes of one scene come one after another.
    """

    id: str
    most: int
    versions: dict[int, Version] = field(default_factory=dict)
    line: list[int] = field(default_factory=list)
    at: int = -1
    last: int = 0
    changing: anyio.Lock = field(default_factory=anyio.Lock)

    @property
    def current(self) -> Version:
        """The version that is looked at and changed."""
        return self.versions[self.line[self.at]]

    def add(self, scene: Scene, report: Mapping[str, Any], change: str, review: Any = None) -> Version:
        """A new version after the current one. What was undone before is kept for `get`, but not for redo.

        Where too many are kept, what was undone goes first, then the oldest.
        """
        self.last += 1
        version = Version(self.last, scene, report, change, review)
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

    def get(self, number: int | None) -> Version:
        """A version by its number; None means the current one."""
        if number is None:
            return self.current
        if number in self.versions:
            return self.versions[number]
        kept = f"{min(self.versions)} to {max(self.versions)}"
        why = f"is no longer kept, the last {self.most} are" if 0 < number <= self.last else "is not there"
        raise InputError(f"version: {number} of {self.id} {why}; give one of {kept}")

    def before(self, version: Version) -> Version:
        """The version that comes before one in number; the first kept one comes before itself."""
        return self.versions[max((n for n in self.versions if n < version.number), default=version.number)]

    def step(self, by: int) -> Version:
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


class Handles:
    """All scenes that are open, in the order in which they were opened."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._open: dict[str, Handle] = {}
        self._count = 0

    def __iter__(self) -> Iterator[Handle]:
        return iter(list(self._open.values()))

    def require_room(self) -> None:
        """InputError where no more scenes may be opened."""
        if len(self._open) >= self._limits.scenes:
            raise InputError(f"scenes: {len(self._open)} are open, and no more are kept; close one first")

    def open(self, scene: Scene, report: Mapping[str, Any], change: str, review: Any = None) -> Handle:
        """A new handle with a scene as its first version."""
        self.require_room()
        self._count += 1
        handle = Handle(f"s{self._count}", self._limits.versions)
        handle.add(scene, report, change, review)
        self._open[handle.id] = handle
        return handle

    def get(self, name: str) -> Handle:
        """The handle of an id; InputError where none is open under it."""
        if name in self._open:
            return self._open[name]
        known = suggest("", self._open, what="open are") if self._open else "; open or design one first"
        raise InputError(f"scene: '{shorten(clean(name), 40)}' is not open{known}")

    def close(self, name: str) -> Handle:
        """Forget a scene with all its versions."""
        handle = self.get(name)
        del self._open[name]
        return handle
