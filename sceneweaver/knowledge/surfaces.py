"""What stands on tables and fills shelves, read once from ``arrangements/*.yaml`` and ``crowds/*.yaml``.

Everything is said as the user of the piece sees it: back is the far edge, right is at the user's right hand.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType
from typing import Any, Literal, TypeVar

from pydantic import Field, field_validator, model_validator

from sceneweaver.assets import categories
from sceneweaver.io.messages import suggest
from sceneweaver.scene import CATALOGUE, InputError
from sceneweaver.scene.base import FrozenModel

from .load import files_of
from .model import Need, Range

Side = Literal["front", "back", "left", "right", "beside"]
Level = Literal["main", "left", "right", "upper", "lower"]

BESIDE = 3
"""Most things of a kind that stand side by side on a table."""


class _Kinds(FrozenModel):
    """A choice among categories, with the sizes [m] that suit here."""

    what: tuple[str, ...] = Field(description="Categories that serve, the best first")
    size: tuple[Range | None, Range | None, Range | None] = (None, None, None)
    turn: float = Field(default=0.0, description="Yaw [degrees] from facing the user")
    loose: float = Field(
        default=0.0, description="Most the yaw strays [degrees] in a room as usual; 0 where a person would align it"
    )

    @field_validator("what", "only", mode="before", check_fields=False)
    @classmethod
    def _one(cls, value: Any) -> Any:
        return (value,) if isinstance(value, str) else value

    @field_validator("what")
    @classmethod
    def _known(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        for name in value:
            if name not in categories() or categories()[name].size is None:
                raise ValueError(f"{name} is no category with a body")
        return value


class Slot(_Kinds):
    """One thing of an arrangement, and where it stands.

    ``at`` is (depth, side): 0 at the back edge to 1 at the front edge, -1 at the user's left end to 1 at the right,
    the thing itself staying inside. With ``by`` it stands at that side of another slot's thing, ``gap`` metres off,
    with ``on`` upon it. ``each: seat`` repeats it before every chair, facing it. A slot with a ``count`` is as many,
    side by side, with ids of their own: jar, jar-2, jar-3.
    """

    id: str
    need: Need = "usual"
    chance: float = Field(default=1.0, ge=0, le=1, description="How often it is there")
    at: tuple[float, float] | None = None
    by: str | None = None
    side: Side = "beside"
    gap: float = 0.04
    on: str | None = None
    each: Literal["seat"] | None = None
    only: tuple[str, ...] = Field(default=(), description="Only when the thing of ``by`` is one of these")
    like: str | None = Field(default=None, description="Slot whose thing it equals, if that is there")
    count: int = Field(default=1, ge=1, le=6, description="How many stand side by side")
    alike: bool = Field(default=True, description="Whether those of a count are equal")
    paired: bool = Field(default=False, description="Whether it is the same on all such furniture of a room")
    vary: bool = Field(default=False, description="With ``each``: whether kind and chance are drawn anew for each seat")
    clutter: float = Field(default=0.0, ge=0, le=1, description="Clutter from which on it is there")
    surface: Level = "main"
    fixed: bool = Field(default=False, description="Whether left and right keep when the arrangement is mirrored")
    drift: float = Field(default=0.015, description="How far the place strays [m]")
    reach: float = Field(default=0.16, description="How far it may move to where there is room [m]")
    relate: str | None = Field(default=None, description="Relation to the thing of ``by`` (or ``on``) that this means")
    unless: tuple[str, ...] = Field(
        default=(), description="Categories that make it needless when one is within 1.5 m already"
    )
    least: tuple[float, float] = Field(default=(0.0, 0.0), description="Depth and width [m] of a support worth it")

    @model_validator(mode="after")
    def _check(self) -> Slot:
        if sum(v is not None for v in (self.at, self.by, self.on, self.each)) != 1 and not (self.each and self.by):
            raise ValueError(f"{self.id}: give one of at, by, on, each")
        if self.relate is not None and self.relate not in CATALOGUE:
            raise ValueError(f"{self.id}: {self.relate} is no relation of the catalogue")
        return self


class _Plan(FrozenModel):
    """What furniture of some categories carries, in some kinds of rooms."""

    name: str
    description: str
    by_category: tuple[str, ...] = Field(default=(), description="Categories of furniture that it suits")
    rooms: tuple[str, ...] = Field(default=(), description="Kinds of rooms that it is for; none: all others")
    instead: tuple[str, ...] = Field(default=(), description="Others whose place it takes in its rooms")


class Arrangement(_Plan):
    """Things that belong together on one piece of furniture."""

    user: Literal["front", "back"] = Field(default="front", description="Side of the furniture its user is at")
    top: bool = Field(default=False, description="Whether it goes on the highest surface, not the one to work at")
    most: float = Field(default=0.5, description="Largest share of the surface to cover, for what is not needed")
    sat_on: bool = Field(default=False, description="Whether one still sits where it lies, as with cushions")
    slots: tuple[Slot, ...]

    @field_validator("slots")
    @classmethod
    def _counted(cls, value: tuple[Slot, ...]) -> tuple[Slot, ...]:
        return tuple(one for slot in value for one in _each_of(slot))

    @model_validator(mode="after")
    def _order(self) -> Arrangement:
        known: set[str] = set()
        for slot in self.slots:
            for name in (slot.by, slot.on, slot.like):
                if name is not None and name not in known:
                    raise ValueError(f"{slot.id}: {name} is no slot before it")
            if slot.id in known:
                raise ValueError(f"two slots are called {slot.id}")
            known.add(slot.id)
        return self


def _each_of(slot: Slot) -> list[Slot]:
    """A slot with a count as slots of one thing each, every further one beside the one before it."""
    found = [slot.model_copy(update={"count": 1})]
    for k in range(2, slot.count + 1):
        beside = {"id": f"{slot.id}-{k}", "at": None, "by": found[-1].id, "side": "beside", "on": None, "count": 1}
        found.append(slot.model_copy(update={**beside, "like": slot.id if slot.alike else None, "relate": None}))
    return found


class Unit(_Kinds):
    """Something that a shelf is filled with, ``repeat`` alike side by side."""

    weight: float = 1.0
    repeat: tuple[int, int] = (1, 1)
    gap: float = Field(default=0.012, description="Between those that are alike [m]")
    most: int = Field(default=8, description="Most groups of it on one surface")
    level: Literal["low", "middle", "high"] | None = Field(
        default=None, description="Where it usually is: below 0.6 m, between, above 1.6 m"
    )
    end: bool = Field(default=False, description="Whether it closes a row, like a bookend")
    fill: bool = Field(default=False, description="Whether its width is chosen to fill what is left")
    same: bool = Field(default=True, description="Whether those of one group are equal")


class Crowd(_Plan):
    """What fills shelves, racks and counters of one kind."""

    mode: Literal["pack", "spread"] = Field(
        default="spread", description="Groups close together from one end, or evenly spread"
    )
    count: tuple[int, int] = Field(default=(2, 8), description="Least and most objects on a surface")
    share: Range = Field(default=(0.35, 0.9), description="Share of the width that is filled, at density 0 and 1")
    setback: float = Field(default=0.02, description="From the front edge [m]")
    top: str | None = Field(default=None, description="Another theme for the open top of a piece with shelves")
    units: tuple[Unit, ...]


Read = TypeVar("Read", Arrangement, Crowd)


def _read(folder: str, kind: type[Read]) -> Mapping[str, Read]:
    found: dict[str, Read] = {}
    for name, data in files_of(folder).items():
        try:
            found[name] = kind(name=name, **data)
        except (InputError, TypeError) as error:
            raise InputError(f"{folder}/{name}.yaml: {error}") from None
    return MappingProxyType(found)


@cache
def arrangements() -> Mapping[str, Arrangement]:
    """All arrangements by name."""
    return _read("arrangements", Arrangement)


@cache
def crowds() -> Mapping[str, Crowd]:
    """All themes by name."""
    return _read("crowds", Crowd)


def arrangement(name: str, room: str | None = None) -> Arrangement:
    """The arrangement of that name, or what takes its place in a kind of room; InputError when there is none."""
    return _named("arrangement", arrangements(), name, room)


def crowd(name: str, room: str | None = None) -> Crowd:
    """The theme of that name, or what takes its place in a kind of room; InputError when there is none."""
    return _named("theme", crowds(), name, room)


def _named(kind: str, plans: Mapping[str, Read], name: str, room: str | None) -> Read:
    if name not in plans:
        raise InputError(f"{kind}: '{name}' is unknown{suggest(name, plans)}")
    return next((one for one in plans.values() if room in one.rooms and name in one.instead), plans[name])


@cache
def arrangement_of(room: str | None = None) -> Mapping[str, str]:
    """The usual arrangement, in a kind of room, of each category of furniture that has one."""
    return _usual(arrangements(), room)


@cache
def crowd_of(room: str | None = None) -> Mapping[str, str]:
    """The usual theme, in a kind of room, of each category of furniture that has one."""
    return _usual(crowds(), room)


def _usual(plans: Mapping[str, Read], room: str | None) -> Mapping[str, str]:
    """By category the plan for any room, or where there is one that for this kind."""
    anywhere = {c: name for name, one in plans.items() if not one.rooms for c in one.by_category}
    here = {c: name for name, one in plans.items() if room in one.rooms for c in one.by_category}
    return MappingProxyType(anywhere | here)


def usual_arrangement(top: str | None, category: str, room: str | None = None) -> Arrangement | None:
    """What a piece of furniture is laid with: as its item of the room says (``top``), else as its category there."""
    name = top or arrangement_of(room).get(category)
    return arrangement(name, room) if name else None


def lays(plan: Arrangement | None, category: str, count: int = 1) -> bool:
    """Whether an arrangement has a place of its own for so many of a category, not one before every chair."""
    if plan is None or count > BESIDE:
        return False
    return any(category in slot.what and slot.each is None for slot in plan.slots)
