"""What is read of a request, before it has the form of a graph."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Any, Self

from sceneweaver.assets.roles import has_role

from .model import (
    Amount,
    Arrangement,
    Attribute,
    Capacity,
    Exclusion,
    FreeArea,
    Span,
    StatedFinish,
    StatedLook,
    StatedMeasure,
    StatedOpening,
    View,
)
from .vocabulary import family, mounts


@dataclass(eq=False)
class Mention:
    """Objects of one kind that the request names; two are equal only if they are the same."""

    noun: str
    category: str
    count: tuple[int, int] | None = None
    generic: bool = False
    color: str | None = None
    material: str | None = None
    style: str | None = None
    size: list[float | None] = field(default_factory=lambda: [None, None, None])
    scale: float = 1.0
    words: list[str] = field(default_factory=list)
    unnamed: list[str] = field(default_factory=list)
    attributes: list[Attribute] = field(default_factory=list)
    plural: bool = False
    implied: bool = False
    also: list[str] = field(default_factory=list)
    """Other nouns by which the request calls it: a crate that is used as a table is a table."""
    span: Span | None = None
    id: str = ""
    numbered: bool = False
    """Whether its number is told as one: "one mirror", and not "a mirror"."""
    uncounted: bool = False
    """Whether it was named by "each" alone, before its number is told."""
    per_place: str = ""
    """The part of the room, window or door, at each of which it is."""
    per: Mention | None = None
    """The things over which it was counted out, so that each of them has its own."""

    @property
    def many(self) -> bool:
        """Whether it is said of more than one."""
        return self.plural or (self.count is not None and self.count[1] > 1)

    @property
    def mount(self) -> str:
        """Where it usually goes: floor, wall, ceiling or surface."""
        return mounts(self.category)[0]

    @property
    def is_small(self) -> bool:
        """Whether it may stand on other things."""
        return "surface" in mounts(self.category)

    @property
    def is_rug(self) -> bool:
        """Whether furniture stands on it; a body of no known category is what its name says."""
        return has_role(self.category, "rug") or (self.generic and "rug" in self.category)

    @property
    def family(self) -> str:
        """Seat, table, or its group of the taxonomy."""
        return family(self.category)

    def copied(self, **changed: Any) -> Self:
        """Another mention of which the same is said, but for what is ``changed``."""
        own = {"attributes": list(self.attributes), "words": list(self.words), "size": list(self.size)}
        own |= {"unnamed": list(self.unnamed), "also": list(self.also)}
        return replace(self, **own | changed)


Target = Mention | str
"""Something that was named, or a place of the room."""


@dataclass(eq=False)
class Said:
    """A relation as it was said."""

    type: str
    subjects: list[Mention]
    targets: tuple[Target, ...]
    words: str
    count: tuple[int, int] | None = None
    each: bool = False
    side: str | None = None
    implied: bool = False
    span: Span | None = None
    params: dict[str, float] = field(default_factory=dict)
    nth: int = 0

    @property
    def by_side(self) -> bool:
        """Whether it was said by a side alone ("on the left"), without the word for a wall."""
        return not {"left", "right"}.isdisjoint(self.words.split())


@dataclass(eq=False)
class Barred(Said):
    """A relation that must not hold. Subjects that are not wanted at all are ruled out by their ``categories``."""

    categories: tuple[str, ...] = ()


def without(mentions: Iterable[Mention], others: Iterable[object]) -> list[Mention]:
    """The mentions that are none of the others."""
    gone = list(others)
    return [m for m in mentions if m not in gone]


@dataclass(frozen=True)
class Told:
    """Something said of a thing by a pattern: it is named ``after`` the words or before them, by ``noun``, with
    ``named`` in so many words."""

    what: StatedMeasure | Attribute
    noun: str
    after: bool
    named: bool = False


@dataclass(frozen=True)
class Role:
    """What the thing whose name has the character ``at`` of the source serves as, or is called, in so many words."""

    at: int
    noun: str
    words: str
    span: Span


@dataclass(frozen=True)
class Zone:
    """A part of the room, or a use of all of it, that is a kind of room by itself."""

    kind: str
    words: str
    span: Span


@dataclass
class Left:
    """Words that were not understood."""

    words: str
    start: int = 0
    end: int = 0
    span: Span | None = None
    """In the request, where it is known already."""


@dataclass
class Parsed:
    """What a request says."""

    mentions: list[Mention] = field(default_factory=list)
    said: list[Said] = field(default_factory=list)
    without: list[tuple[str, tuple[str, ...], Span | None]] = field(default_factory=list)
    others: set[str] = field(default_factory=set[str])
    """Words of what is not wanted beside what the request names: "no other seats"."""
    barred: list[Barred] = field(default_factory=list)
    unwanted: list[Exclusion] = field(default_factory=list)
    stated_openings: list[StatedOpening] = field(default_factory=list)
    free_areas: list[FreeArea] = field(default_factory=list)
    capacities: list[Capacity] = field(default_factory=list)
    arrangements: list[Arrangement] = field(default_factory=list)
    views: list[View] = field(default_factory=list)
    amounts: list[Amount] = field(default_factory=list)
    appearances: list[Told] = field(default_factory=list)
    states: list[Told] = field(default_factory=list)
    measures: list[Told] = field(default_factory=list)
    limits: list[StatedMeasure] = field(default_factory=list[StatedMeasure])
    roles: list[Role] = field(default_factory=list[Role])
    bounds: list[tuple[tuple[str, ...], int, int]] = field(default_factory=list)
    shared: list[tuple[str, int]] = field(default_factory=list[tuple[str, int]])
    """What so many people share one of: "a lamp for every three guests"."""
    room_type: str | None = None
    room_words: str = ""
    setting: str = ""
    """Where the room is, or whose: "our school" of a sick room for our school."""
    wing: tuple[float, float] | None = None
    zones: list[Zone] = field(default_factory=list["Zone"])
    other_rooms: list[str] = field(default_factory=list)
    room_scale: float = 1.0
    shape: str | None = None
    style: str | None = None
    room_looks: list[StatedLook] = field(default_factory=list)
    finishes: list[StatedFinish] = field(default_factory=list)
    colors: list[str] = field(default_factory=list)
    density: str | None = None
    people: int | None = None
    for_whom: list[str] = field(default_factory=list)
    openings: dict[str, int] = field(default_factory=dict)
    only: bool = False
    sides: list[tuple[float, ...]] = field(default_factory=list)
    unread: list[Left] = field(default_factory=list)
    stations: list[Mention] = field(default_factory=list[Mention])
    """Places that were counted, of each of which it is told what is there; they are no things."""
    referred: list[Span] = field(default_factory=list[Span])
    """Where what was named before is named again."""
    notes: list[str] = field(default_factory=list)

    def note(self, text: str) -> None:
        """Says something to the user, once."""
        if text not in self.notes:
            self.notes.append(text)

    def split(self, whole: Mention, count: int) -> tuple[Mention, Mention]:
        """So many of a mention, and the rest of it, as two mentions; what was said of it holds for both."""
        low, high = whole.count or (2, 2)
        first = whole.copied(count=(count, count))
        rest = whole.copied(count=(max(1, low - count), max(1, high - count)))
        self.replace(whole, [first, rest])
        return first, rest

    def replace(self, whole: Mention, parts: list[Mention]) -> None:
        """Parts take the place of a mention; a pair that flanks something stands on its two sides."""
        at = self.mentions.index(whole)
        self.mentions[at : at + 1] = parts
        found: list[Said] = []
        for said in self.said:
            if whole in said.subjects:
                if said.type == "flanking" and len(parts) == 2 and len(said.subjects) == 1:
                    for part, side in zip(parts, ("left_of", "right_of"), strict=True):
                        found.append(Said(side, [part], said.targets, said.words, implied=said.implied, span=said.span))
                    continue
                said.subjects = [p for m in said.subjects for p in (parts if m is whole else [m])]
            if whole in said.targets:
                if len(said.targets) == 2 or said.type == "between":
                    said.targets = (parts[0], parts[-1])
                else:
                    said.targets = tuple(parts[0] if t is whole else t for t in said.targets)
            found.append(said)
        self.said = found
