"""What a model answers when it looks at a room, and what of it is refused or mended."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Collection, Sequence
from typing import Annotated, Literal

from pydantic import Field

from sceneweaver.io.messages import quote, suggest
from sceneweaver.language.by_model.leniency import Listed
from sceneweaver.llm import Reply
from sceneweaver.scene import InputError, Scene

MOST_FAULTS = 24
"""Faults of an answer that are read."""

MOST_NAMED = 12
"""Objects of one fault."""

MOST_TOLD = 4
"""Wrong names that a model is told at once."""

Criterion = Literal["realism", "functionality", "layout", "completion"]


class Graded(Reply):
    """A grade with its reason."""

    comment: str = Field(description="The reason, one or two sentences")
    grade: float = Field(ge=0, le=10, description="0 to 10")


class Seen(Reply):
    """Something that is wrong."""

    criterion: Criterion
    objects: Annotated[list[str], Listed] = Field(
        default=[], description="Exact ids of the things meant; empty for the whole room"
    )
    wrong: str = Field(description="What is wrong, one sentence")
    suggestion: str = Field(default="", description="What would mend it, one sentence")
    severity: float = Field(ge=1, le=3, description="1 a blemish, 2 a flaw, 3 the room fails at it")
    tool: str | None = Field(default=None, description="Tool that would mend it, where one fits")


class Look(Reply):
    """All that a model says about a room: what it saw, then its grades."""

    faults: Annotated[list[Seen], Listed] = []
    realism: Graded
    functionality: Graded
    layout: Graded
    completion: Graded

    def graded(self, criterion: str) -> Graded:
        """Grade and reason of a criterion."""
        return getattr(self, criterion)


class Names:
    """The ids of a scene, and what a model may have meant by something that is none.

    Case, blanks, hyphens and underscores do not matter; a category means the only object of it; numbers at the end
    belong to the id. Doors, windows, walls and the room itself are no objects: a fault of these is one of the room.
    """

    def __init__(self, scene: Scene) -> None:
        self.ids = scene.ids
        self._known = set(scene.ids)
        plain = Counter(_plain(name) for name in scene.ids)
        self._plain = {_plain(name): name for name in scene.ids if plain[_plain(name)] == 1}
        kinds = Counter(_plain(o.category) for o in scene.objects)
        self._only = {_plain(o.category): o.id for o in scene.objects if kinds[_plain(o.category)] == 1}
        walls = {f"wall{k}" for k in range(len(scene.room.outline))}
        openings = {_plain(o.id) for o in scene.room.openings}
        self._room = walls | openings | {"", "room", "wall", "walls", "floor", "ceiling", "door", "window"}

    def of(self, name: str) -> str | None:
        """The id that is meant; "" for a part of the room, None for nothing that is there."""
        if name in self._known:
            return name
        plain = _plain(name)
        return self._plain.get(plain) or self._only.get(plain) or ("" if plain in self._room else None)

    def known(self, names: Sequence[str]) -> tuple[str, ...]:
        """The objects that are meant, each once; what means none is left out."""
        return tuple(dict.fromkeys(found for name in names[:MOST_NAMED] if (found := self.of(name))))


def checker(names: Names) -> Callable[[Look], Look]:
    """What refuses an answer in which a name means nothing, with words for the model."""

    def check(look: Look) -> Look:
        wrong = [
            f"faults[{k}].objects: there is no object {quote(name)}{suggest(name, names.ids)}"
            for k, fault in enumerate(look.faults[:MOST_FAULTS])
            for name in fault.objects[:MOST_NAMED]
            if names.of(name) is None
        ]
        if wrong:
            raise InputError("; ".join(wrong[:MOST_TOLD]))
        return look

    return check


def tool_of(name: str | None, tools: Collection[str]) -> str | None:
    """The tool that is meant, None where there is no such tool."""
    plain = {_plain(tool): tool for tool in tools}
    return plain.get(_plain(name)) if name else None


def _plain(name: str) -> str:
    return re.sub(r"[\s_:\-]+", "", name.casefold())
