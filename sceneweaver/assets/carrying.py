"""How things carry others: on top, on boards, in a cavity, from hooks and rails. The data is ``carrying.yaml``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any

from .category import categories, read_yaml
from .plurals import singular
from .roles import groups_above

HOOK = "hook"
"""How the names of surfaces begin on which nothing stands: their height is that of the bottom of what hangs there."""


@dataclass(frozen=True)
class Carrier:
    """How things of a class carry others.

    ``ways`` are of "hang", "inside", "level" and "top", the usual one first; things hang ``at`` its underside or before
    some of its ``sides``, garments side by side ``along`` it; all that is told of a ``pure`` one hangs from it.
    """

    ways: tuple[str, ...] = ("top",)
    at: tuple[str, ...] = ("before", "under")
    along: bool = False
    sides: tuple[str, ...] = ("front", "back", "left", "right")
    pure: bool = False
    of: frozenset[str] = frozenset()
    words: tuple[str, ...] = ()

    def carries(self, way: str) -> bool:
        """Whether it may carry in a way."""
        return way in self.ways


@dataclass(frozen=True)
class Hung:
    """Things that hang where they may, and the category of the body that they have then; empty: their own."""

    of: frozenset[str]
    body: str = ""
    nouns: tuple[str, ...] = ()


def carrier(category: str, noun: str = "") -> Carrier:
    """How a thing carries others, by its category, its group or the head of what it is called.

    Examples:
        >>> from sceneweaver.assets.carrying import carrier
        >>> carrier("coat_hooks").ways, carrier("dining_table").ways
        (('hang',), ('top',))
    """
    kinds = groups_above(category) | {category}
    for row in _carriers():
        if kinds & row.of:
            return row
    if category in categories() and not category.startswith("generic"):
        return Carrier()
    return next((row for row in _carriers() if _called(noun or category.replace("_", " "), row.words)), Carrier())


def hung(category: str, noun: str = "") -> Hung | None:
    """How a thing hangs that hangs wherever it may; None for what usually stands."""
    kinds = groups_above(category) | {category}
    for row in _hanging():
        if kinds & row.of and (not row.nouns or _called(noun or category.replace("_", " "), row.nouns)):
            return row
    return None


def hangs_from(category: str, noun: str, kind: Carrier) -> bool:
    """Whether what is told to be "on" a carrier hangs from it."""
    if not kind.carries("hang"):
        return False
    return kind.pure or (kind.ways[0] == "hang" and hung(category, noun) is not None)


def bare_body(category: str) -> str | None:
    """The category that takes the place of a carrier whose drawing always has something hanging from it."""
    return _file()["bare"].get(category)


def kind_for(noun: str, contents: str) -> str | None:
    """The category of a rack, stand or holder that only its contents tell; None where they tell none."""
    row = _file()["kinds"]
    if not _plain(noun, tuple(row["words"])):
        return None
    return next((kind for kind, names in row["of"].items() if contents in names), None)


def vessel_body(category: str) -> str | None:
    """The category whose body stands for a vessel that things are put into, where its own has no cavity."""
    return _file()["vessels"].get(category)


def body_within(category: str) -> str | None:
    """The category of the body that a thing has within something, where that is not its own."""
    return _file()["within"].get(category)


def on_wall(category: str) -> str:
    """The category that a thing is where it hangs on a wall: what stands is drawn across the room, not along it."""
    return _file()["on_wall"].get(category, category)


def is_hook(surface: str) -> bool:
    """Whether what is on a surface of this name hangs."""
    return surface.startswith(HOOK)


def hung_words() -> frozenset[str]:
    """Words that say that something hangs."""
    return frozenset(_file()["hung_words"])


def draped_words() -> frozenset[str]:
    """Words that say that something lies over another which has nothing to hang it from."""
    return frozenset(_file()["draped_words"])


def _called(noun: str, words: tuple[str, ...]) -> bool:
    """Whether one of some words is the head of a noun."""
    said = f" {noun.lower()}"
    return any(form.endswith(f" {word}") for form in (said, f" {singular(noun.lower())}") for word in words)


def _plain(noun: str, words: tuple[str, ...]) -> bool:
    """Whether a noun is one of some words and no more."""
    return noun.lower() in words or singular(noun.lower()) in words


@cache
def _file() -> Mapping[str, Any]:
    return read_yaml(resources.files(__package__ or "").joinpath("carrying.yaml"))


@cache
def _carriers() -> tuple[Carrier, ...]:
    return tuple(
        Carrier(of=_known(row["of"]), **{key: _frozen(value) for key, value in row.items() if key != "of"})
        for row in _file()["carriers"].values()
    )


@cache
def _hanging() -> tuple[Hung, ...]:
    return tuple(
        Hung(_known(row["of"]), row.get("body", ""), tuple(row.get("nouns", ()))) for row in _file()["hanging"]
    )


def _frozen(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _known(names: list[str]) -> frozenset[str]:
    for name in names:
        if name not in categories():
            raise ValueError(f"carrying.yaml names {name}, which is no category or group")
    return frozenset(names)


__all__ = [
    "HOOK",
    "Carrier",
    "Hung",
    "bare_body",
    "body_within",
    "carrier",
    "draped_words",
    "hangs_from",
    "hung",
    "hung_words",
    "is_hook",
    "kind_for",
    "on_wall",
    "vessel_body",
]
