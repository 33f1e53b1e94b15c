"""What a kind of room is: its furniture with counts and relations, as the files in ``rooms/`` say it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

from pydantic import Field, field_validator, model_validator

from sceneweaver.scene import CATALOGUE
from sceneweaver.scene.base import FrozenModel

Need = Literal["needed", "usual", "optional"]
Side = Literal["front", "back", "left", "right", "top"]
Range = tuple[float, float]

PLACES = ("wall", "window", "door", "wall:far")
"""Targets of a relation that are no objects: any wall, window or door, and the wall that looks at the door."""


class Place(FrozenModel):
    """One relation of an item, to another item or to the room.

    In the files a line such as ``near bed`` (type, then target), ``soft facing tv``, or a mapping
    ``{type: near, to: bed, max: 1.5, soft: true}``: what is no key of this model is a parameter of the relation.
    """

    type: str
    to: str | None = Field(default=None, description="Id of another item, wall, window or door")
    soft: bool = False
    weight: float = 1.0
    params: dict[str, Any] = {}
    instead: tuple[str, ...] = Field(
        default=(), description="Categories of what is meant, as a wish, where the other item is not in the room"
    )

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if isinstance(data, str):
            words = data.split()
            soft = bool(words) and words[0] == "soft"
            words = words[soft:]
            if not 1 <= len(words) <= 2:
                raise ValueError(f'"{data}" is no "[soft] TYPE [TARGET]"')
            return {"type": words[0], "to": words[1] if len(words) == 2 else None, "soft": soft}
        if isinstance(data, dict):
            known = {k: v for k, v in data.items() if k in cls.model_fields}
            extra = {k: v for k, v in data.items() if k not in cls.model_fields}
            if isinstance(known.get("to"), list):  # of several kinds of things the first that is there
                known["instead"] = known.pop("to")
            return {**known, "params": {**known.get("params", {}), **extra}}
        return data

    @property
    def targets(self) -> tuple[str, ...]:
        """What it may be to, the first choice first; empty where it needs nothing."""
        return self.instead if self.to is None else (self.to,)

    @field_validator("type")
    @classmethod
    def _known(cls, value: str) -> str:
        if value not in CATALOGUE:
            raise ValueError(f"{value} is no relation of the catalogue")
        return value


class Count(FrozenModel):
    """How many: ``least`` to ``most``, or a rate an area or a person, kept in between.

    In the files a number, a pair ``[least, most]``, or a mapping.
    """

    least: int = 1
    most: int = 1
    per_area: float | None = Field(default=None, description="Pieces per square metre of floor")
    per_person: float | None = Field(default=None, description="Pieces for every person")

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if isinstance(data, int):
            return {"least": data, "most": data}
        if isinstance(data, list | tuple):
            return {"least": data[0], "most": data[1]}
        return data

    def of(self, area: float, people: int, draw: float) -> int:
        """The count for a floor area [m2] and a number of people; ``draw`` in 0..1 decides where nothing else does."""
        if self.per_area is not None:
            wanted = round(self.per_area * area)
        elif self.per_person is not None:
            wanted = round(self.per_person * people)
        else:
            wanted = self.least + int(draw * (self.most - self.least + 1) * 0.999999)
        return max(self.least, min(self.most, wanted))


class Item(FrozenModel):
    """One kind of object in a room, or a set of equal ones.

    With ``with_`` (in the files ``with``) the count is for each instance of that other item: two nightstands for every
    bed; relations to that item then mean this very instance.
    """

    id: str = Field(description="Name in this file; relations use it")
    what: tuple[str, ...] = Field(description="Categories that serve, the usual one first; one is chosen by seed")
    need: Need = "usual"
    count: Count = Count()
    with_: str | None = Field(default=None, alias="with")
    when: tuple[str, ...] = Field(default=(), description="Categories of what it goes with that it is for; none: all")
    same: bool = Field(default=True, description="Whether all are equal, like dining chairs")
    size: tuple[Range | None, Range | None, Range | None] = Field(
        default=(None, None, None), description="Sizes [m] here, where they differ from the category's"
    )
    beyond: tuple[Range | None, Range | None] = Field(
        default=(None, None),
        description="How far [m] it reaches beyond either side of what it goes with, along the depth and the width of "
        "that: a rug under a table; sets its size",
    )
    bottom: Range | None = Field(default=None, description="Height [m] of the bottom, for what hangs on a wall")
    middle: Range | None = Field(default=None, description="Height [m] of the middle instead, as for art and screens")
    mount: Literal["floor", "wall", "ceiling", "surface"] | None = Field(
        default=None, description="What holds it, where it differs from the category's usual"
    )
    spans: float | None = Field(
        default=None, gt=0, description="Width as a share of that of what it goes with, such as a mirror over a basin"
    )
    suite: str | None = Field(default=None, description="All items of one suite match in finishes, fronts and handles")
    color: str | None = None
    place: tuple[Place, ...] = ()
    row: Literal["grid", "cluster", "line", "run"] | None = Field(
        default=None,
        description="How several are set out: in a grid, back to back in clusters on a grid, in a line at even "
        "distances, or flush side by side along a wall together with all other items that say run, as in a kitchen",
    )
    run: float | None = Field(
        default=None, description="Place in the run or line: small numbers first; equal ones by number"
    )
    line: str | None = Field(default=None, description="Name of the line that it shares with the items that say so")
    gap: Range | None = Field(default=None, description="Distance [m] in a line to the one before it")
    clear: dict[Side, float] = Field(
        default={}, description="Depth [m] to keep free before these sides here, where it is not the category's"
    )
    on: tuple[str, ...] = Field(default=(), description="Items on whose surfaces it stands")
    top: str | None = Field(default=None, description="Arrangement on its top: a file in arrangements/")
    fill: str | None = Field(default=None, description="Theme that fills its shelves or top: a file in crowds/")
    group: str | None = Field(default=None, description="The group of a template in groups/ that it belongs to")

    @field_validator("what", mode="before")
    @classmethod
    def _one(cls, value: Any) -> Any:
        return (value,) if isinstance(value, str) else value

    def hung(self, height: float) -> Range | None:
        """Heights [m] between which the bottom hangs of what is so high; None where the category's are meant."""
        if self.middle is None:
            return self.bottom
        return self.middle[0] - 0.5 * height, self.middle[1] - 0.5 * height


def check_items(items: Sequence[Item]) -> None:
    """Raise ValueError where items of one room or group share an id, or name what is not there."""
    ids = [item.id for item in items]
    for twice in {i for i in ids if ids.count(i) > 1}:
        raise ValueError(f"two items are called {twice}")
    known: set[str] = set()
    for item in items:
        for name in (item.with_, *item.on):
            if name is not None and name not in known:
                raise ValueError(f"{item.id}: {name} is no item before it")
        for place in item.place:
            if place.to is not None and place.to not in (*PLACES, *ids):
                raise ValueError(f"{item.id}: {place.type} names {place.to}, which is no item")
        known.add(item.id)


class Opening(FrozenModel):
    """Windows or doors that a kind of room usually has."""

    count: Count = Count()
    width: Range
    height: Range
    sill: Range = (0.9, 0.9)
    swing: Literal["in-left", "in-right", "out", "slide"] = "in-left"


class RoomType(FrozenModel):
    """A kind of room: when it is meant, how large it is and what it holds."""

    name: str
    words: tuple[str, ...] = Field(default=(), description="Other names for it")
    description: str
    sources: tuple[str, ...] = Field(description="Where sizes, counts and clearances come from")
    area: tuple[float, float, float] = Field(description="Least, usual and largest floor [m2]")
    area_per_person: float | None = Field(default=None, description="Floor [m2] that each person needs")
    aspect: Range = (1.0, 1.5)
    height: float = 2.6
    people: int = 2
    doors: Opening
    windows: Opening
    styles: tuple[str, ...] = ("modern", "scandinavian")
    floor: Literal["wood", "tile", "carpet", "concrete", "stone"] = "wood"
    tiles: Range | None = Field(default=None, description="Heights [m] between which its walls are tiled")
    fill: float = Field(default=0.33, gt=0, lt=1, description="Share of the floor that furniture takes as a rule")
    for_request: bool = Field(
        default=False, description="Whether it was written for the very request, so that all of it is wanted"
    )
    made_of: tuple[str, ...] = Field(default=(), description="Items that may be most of it: chairs in a restaurant")
    palettes: str | None = Field(
        default=None, description="Group of palettes.yaml whose palettes it takes; None: the one that lists it"
    )
    never: tuple[str, ...] = Field(default=(), description="Categories, or groups of them, that do not belong in it")
    absent: frozenset[str] = Field(
        default=frozenset(), description="Categories that the look or the time of a request does not have"
    )
    things: tuple[str, ...] = Field(
        default=(), description="Groups of small_things.yaml whose small things belong in it, beside those that list it"
    )
    names: dict[Literal["de", "es", "fr", "zh"], tuple[str, ...]] = Field(
        default={}, description="What it is called in other languages, the usual name first"
    )
    items: tuple[Item, ...]

    @model_validator(mode="after")
    def _check(self) -> RoomType:
        check_items(self.items)
        return self

    def item(self, item_id: str) -> Item:
        """The item of that id; KeyError when there is none."""
        for item in self.items:
            if item.id == item_id:
                return item
        raise KeyError(item_id)
