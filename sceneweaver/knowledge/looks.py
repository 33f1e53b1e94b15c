"""Looks of whole rooms by the words that people have for them: styles, times, themes, moods, light, sets of colours.

Each is a row of ``looks/*.yaml``. A field that a row leaves out is not said by it; rows that a request names together
refine each other (`joined`): a style outranks a time, a theme a style, and a mood, a set of colours and words about the
light are said of any of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Literal

from pydantic import Field, field_validator

from sceneweaver.assets import categories
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.finish import Daylight, FloorMaterial, Level, Outside, WallMaterial

from .load import check_known, data_of

LookKind = Literal["era", "style", "theme", "mood", "scheme", "light"]

FILES: Mapping[str, LookKind] = {
    "eras": "era",
    "styles": "style",
    "themes": "theme",
    "moods": "mood",
    "schemes": "scheme",
    "light": "light",
}
"""The files of rows, what refines another later."""

CEILING = 9.0
"""Height [m] of panels that means: up to the ceiling."""

Years = tuple[int, int]


class WallLook(FrozenModel):
    """What walls show; "rough" stands for plaster that is worn."""

    color: str | None = None
    of: WallMaterial | Literal["rough"] = "plaster"


class AccentLook(FrozenModel):
    """A wall that is done otherwise."""

    kind: Literal["paint", "paper", "panelling"]
    color: str
    high: float | None = None


class PanelLook(FrozenModel):
    """Panels along all walls, up to a height [m]."""

    color: str
    high: float


class FloorLook(FrozenModel):
    """What the floor is of."""

    material: FloorMaterial
    tone: str | None = None


class CeilingLook(FrozenModel):
    """What the ceiling is of, and the finish of beams under it."""

    of: WallMaterial = "plaster"
    color: str = "white"
    beams: str | None = None


class LightLook(FrozenModel):
    """What is said of the light; see `scene.RoomLight`."""

    daylight: Daylight | None = None
    level: Level | None = None
    kelvin: int | None = None
    glow: str | None = None
    outside: Outside | None = None


class Look(FrozenModel):
    """One row: how a room looks that people call by one of its words."""

    name: str
    kind: LookKind
    words: tuple[str, ...] = ()
    unlike: tuple[str, ...] = Field(default=(), description="Words that mean it where they are denied")
    years: Years | None = Field(default=None, description="First and last year of a time")
    style: str | None = Field(default=None, description="Style of drawings, one of `assets.materials.STYLES`")
    walls: WallLook | None = None
    accent: AccentLook | None = None
    panels: PanelLook | None = None
    floor: FloorLook | None = None
    floors: Mapping[FloorMaterial, str] = Field(default={}, description="Tones of the floor, whatever it is of")
    ceiling: CeilingLook | None = None
    trim: str | None = Field(default=None, description="Colour or wood of skirting, frames and doors")
    woods: Annotated[tuple[str, ...], Field(max_length=2, description="Of furniture; a stone may take its place")] = ()
    paints: tuple[str, ...] = ()
    metals: tuple[str, ...] = ()
    textiles: Annotated[tuple[str, ...], Field(max_length=3)] = ()
    avoid: tuple[str, ...] = Field(default=(), description="Finishes and families of which nothing is")
    light: LightLook = LightLook()
    only: Literal["flame", "named"] | None = Field(
        default=None, description="The only lamps there are: what burns, or those that the request names"
    )
    windows: int | None = Field(default=None, description="How many there are then, where none are spoken of")
    worn: bool = False
    lacks: str = Field(default="", description="What belongs to it and is not drawn")
    things: tuple[str, ...] = Field(default=(), description="Things that carry it, what carries it most first")
    never: tuple[str, ...] = Field(default=(), description="Categories and groups that are no part of it")

    @field_validator("years")
    @classmethod
    def _in_order(cls, value: Years | None) -> Years | None:
        if value is not None and value[0] > value[1]:
            raise ValueError(f"years run from {value[0]} to {value[1]}")
        return value


@cache
def looks() -> Mapping[str, Look]:
    """All rows by name."""
    found: dict[str, Look] = {}
    for file, kind in FILES.items():
        for name, row in data_of(f"looks/{file}.yaml").items():
            if name in found:
                raise ValueError(f"looks/{file}.yaml: {name} is there already")
            found[name] = Look(name=name, kind=kind, **row)
    check_known("looks", (c for look in found.values() for c in look.things), categories())
    return MappingProxyType(found)


@cache
def unlike_words() -> Mapping[str, str]:
    """Every word that means a row where it is denied, with the name of that."""
    return MappingProxyType({word: look.name for look in looks().values() for word in look.unlike})


@cache
def look_words() -> Mapping[str, str]:
    """Every phrase that means a row, with its name; where two rows have a phrase the later file counts."""
    return MappingProxyType({word: look.name for look in looks().values() for word in look.words})


def time_of(years: Years) -> Look:
    """The time in which the middle of some years lies: of several the shortest that names no place."""
    middle = (years[0] + years[1]) / 2
    eras = [look for look in looks().values() if look.kind == "era" and look.years is not None]
    holding = [(y[1] - y[0], look) for look in eras if (y := look.years) and y[0] <= middle <= y[1]]
    if not holding:
        last = max(eras, key=lambda look: look.years or (0, 0))
        return last if middle > 2000 else eras[0]
    general = [row for row in holding if row[1].name != "wild west"] or holding
    return min(general, key=lambda row: row[0])[1]


def joined(rows: Iterable[Look]) -> Look:
    """One look of several: by the order of `FILES`, and what is named later before what is named earlier."""
    order = list(FILES.values())
    found: dict[str, Any] = {}
    light: dict[str, Any] = {}
    names, never, avoid, carriers = [], [], [], []
    for look in sorted(rows, key=lambda look: order.index(look.kind)):
        names.append(look.name)
        said = look.model_dump(
            exclude_defaults=True, exclude={"name", "kind", "words", "unlike", "light", "lacks", *_LISTS}
        )
        found |= {key: getattr(look, key) for key in said if key not in ("walls",)}
        if look.walls is not None:
            found["walls"] = _walls(found.get("walls"), look.walls)
            if look.walls.color is not None and "panels" not in said:
                found.pop("panels", None)
        light |= look.light.model_dump(exclude_none=True)
        never, avoid = [*never, *look.never], [*avoid, *look.avoid]
        carriers.append((CARRIED.index(look.kind), look.things))
    return Look(
        name=" ".join(names),
        kind="style",
        **found,
        light=LightLook(**light),
        things=_in_turn([things for _, things in sorted(carriers, key=lambda one: one[0])]),
        never=tuple(dict.fromkeys(never)),
        avoid=tuple(dict.fromkeys(a for a in avoid if a not in _used(found))),
    )


CARRIED: tuple[LookKind, ...] = ("theme", "style", "era", "mood", "light", "scheme")
"""Whose things come first where there is no place for all."""


def _in_turn(lists: Sequence[Sequence[str]]) -> tuple[str, ...]:
    """What stands in some lists, two of each in turn, each once."""
    longest = max(map(len, lists), default=0)
    found = [name for k in range(0, longest, 2) for one in lists for name in one[k : k + 2]]
    return tuple(dict.fromkeys(found))


_LISTS = ("things", "never", "avoid")


def _used(found: Mapping[str, Any]) -> frozenset[str]:
    """The finishes that a look has."""
    return frozenset(name for key in ("woods", "paints", "metals") for name in found.get(key, ()))


def _walls(before: WallLook | None, now: WallLook) -> WallLook:
    if now.color is not None or before is None:
        return now
    return before if before.of != "plaster" else now.model_copy(update={"color": before.color})
