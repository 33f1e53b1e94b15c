"""Rules for plans as rows of data: a measure, the interval that it lies in, whom it is about, and its source.

``profiles/*.yaml`` has the rows. The solver makes terms of them, `sceneweaver.plans.check` judges by them; neither has
a number of its own.
"""

from __future__ import annotations

from functools import cache
from types import MappingProxyType
from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from sceneweaver.home import DoorKind
from sceneweaver.io import InputError, Place, load_yaml, packaged
from sceneweaver.io.messages import show, suggest
from sceneweaver.scene.base import FrozenModel
from sceneweaver.scene.fields import Flag, Name, Number, Weight
from sceneweaver.scene.messages import FieldError

from .room_types import roles, room_types

MEASURES = MappingProxyType({
    # of a room
    "area": "floor between the walls [m2]",
    "side": "shorter side of the largest rectangle along the axes that fits into the room [m]",
    "aspect": "longer by shorter side of the rectangle around the room",
    "turning": "side of the largest square along the axes that fits beside swinging leaves and stairs [m]",
    "passage": "side of the largest square that slides within the room from each of its doors to each other [m]",
    "dead_end": "how far it reaches beyond the last of its doors, less its clear width [m]",
    "fill": "share of the rectangle around the room that the room takes",
    "ceiling": "height of the storey between floor and ceiling [m]",
    "glazing": "area of the windows by area of the floor, of all rooms that open passages join to it",
    "dark": "1 where neither the room nor one that an open passage of 1.2 m joins to it has a window, else 0",
    "escape": "windows to climb out of, and doors outdoors",
    "sun": "share of the windows' area that does not face north (+y)",
    "light_sides": "walls of different directions that have windows",
    # of a pair of rooms
    "distance": "least distance along the axes from the room to the nearest of the others on its storey [m]",
    "door_between": "doors and passages that lead from the room to one of the others",
    "area_over": "by how much the room's floor is larger than that of the smallest of the others [m2]",
    "nearer_entrance": "how much nearer to the entrance's door the first door of the rooms is than that of the others, "
    "along the axes on the entrance's storey [m]",
    # of a door
    "door_width": "clear width [m]",
    "door_height": "clear height [m]",
    # of stairs
    "riser": "height of a step [m]",
    "going": "depth of a step [m]",
    "stair_width": "clear width of the flight [m]",
    "headroom": "least height over a step, to a ceiling or to stairs above [m]",
    "stair_run_lack": "by how much the footprint is too short for its goings and landings [m]",
    "stair_fault": "stairs out of their stairwells, or with neither door nor floor before the first or last step",
    # of the plan
    "largest_area": "floor of the largest of the rooms [m2]",
    "circulation_share": "floor of halls, corridors and landings by floor of all rooms indoors, without stairs",
    "wet_groups": "groups of rooms with water that share walls or stand over each other",
    "entrances": "doors from outdoors or from the stairwell into the entrance's rooms",
    "unreached": "rooms that the entrance does not reach by ways that are ways",
    "shared_toilets": "toilets that are reached without crossing a bedroom; in homes of one bedroom all toilets",
    "accessible_toilets": "toilets of 5 m2 with 1.5 x 1.5 m to turn in on the entrance's storey",
    "stairs_lack": "storeys that no stairs join to the next",
    # of the geometry
    "overlap": "pairs of rooms that reach into each other",
    "wall_lack": "pairs of rooms nearer than the inner wall is thick",
    "void": "side of the largest square in a place that rooms enclose and that is no wall [m]",
    "storey_fault": "rooms of an upper storey that reach over the one below by more than 1.5 m",
    "door_fault": "doors that do not lead where they say",
    "window_fault": "windows that do not face outdoors",
    "opening_fault": "pairs of openings of one wall that overlap",
    "leaf_fault": "pairs of leaves that meet, and leaves that do not swing freely",
})  # fmt: skip
"""What rows measure, each computed once; `sceneweaver.plans.check` says exactly how."""

DOORS = ("entrance-door", "inner-door")
"""What rows about doors select by, beside types and roles of the rooms that they join."""


class Rule(FrozenModel):
    """A row: ``measure`` of what ``of`` selects is at least ``least`` and at most ``most``.

    Soft rows (``hard`` false) do not make a plan invalid: their breach costs ``weight``, less where the excess is
    below ``per`` (None: the bound, or 1 where that is 0). ``except_of`` leaves out doors of these rooms. ``passages``
    are the kinds of doors that make two rooms one for light.
    """

    _noun = "rule"

    id: Name
    measure: Name
    of: tuple[Name, ...] = ()
    to: tuple[Name, ...] = ()
    except_of: tuple[Name, ...] = ()
    passages: tuple[DoorKind, ...] = ("open",)
    least: Number | None = None
    most: Number | None = None
    hard: Flag = True
    weight: Weight = 1.0
    per: Weight | None = None
    uses: tuple[Name, ...] = ()
    says: Name
    source: Name

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.measure not in MEASURES:
            raise FieldError(("measure",), f"is {show(self.measure)}{suggest(self.measure, MEASURES)}")
        if self.least is None and self.most is None:
            raise FieldError(("least",), "is missing, and so is most; give one of them")
        known = {*room_types(), *roles(), *DOORS}
        for field in ("of", "to", "except_of"):
            for i, word in enumerate(getattr(self, field)):
                if word.removeprefix("-") not in known:
                    raise FieldError((field, i), f"is {show(word)}{suggest(word, known, what='roles and types are')}")
        return self

    def concerns(self, use: str) -> bool:
        """Whether the row is about plans of this use."""
        return not self.uses or use in self.uses

    def cost(self, excess: float) -> float:
        """What a breach by ``excess`` costs in a soft row, 0 to ``weight``."""
        return self.weight * min(1.0, excess / self.until)

    @property
    def until(self) -> float:
        """The excess from which a soft row costs its whole weight."""
        bound = self.least if self.least is not None else self.most
        return self.per or abs(bound or 0.0) or 1.0


class Profile(FrozenModel):
    """A named set of rules; ``extends`` names one whose rows come first, a row of the same id takes its place.

    Examples:
        >>> from sceneweaver.plans import Profile
        >>> Profile.named("base").rule("habitable-side").least
        2.13
    """

    _noun = "profile"

    name: Name = "profile"
    title: Name = "rules of a plan"
    extends: Name | None = None
    rows: Annotated[tuple[Rule, ...], Field(max_length=500)] = ()

    @model_validator(mode="after")
    def _check(self) -> Self:
        ids = [row.id for row in self.rows]
        for i, name in enumerate(ids):
            if name in ids[:i]:
                raise FieldError(("rows", i, "id"), f"is {show(name)}, as of row {ids.index(name)}; rename one")
        return self

    @classmethod
    def named(cls, name: str) -> Profile:
        """A profile that ships with the library, with the rows of what it extends.

        Raises:
            InputError: there is none of this name.
        """
        return _named(name)

    @classmethod
    def load(cls, path: Place) -> Profile:
        """A profile from a YAML file, with the rows of what it extends.

        Raises:
            InputError: the file or a row of it is wrong; one line that names the field.
        """
        data = load_yaml(path)
        if not isinstance(data, dict):
            raise InputError(f"{path}: is {show(data)}; a profile has title and rows")
        return _extended(cls.model_validate({"name": str(path), **data}))

    @classmethod
    def of(cls, profile: Profile | str) -> Profile:
        """``profile`` itself, or the one of that name."""
        if isinstance(profile, Profile):
            return profile
        if not isinstance(profile, str):
            raise InputError(f"profile is of type {type(profile).__name__}; give a Profile or a name")
        return cls.named(profile)

    def rule(self, rule_id: str) -> Rule:
        """The row of this id; InputError where there is none."""
        for row in self.rows:
            if row.id == rule_id:
                return row
        raise InputError(f"rule {show(rule_id)} is not in {self.name}{suggest(rule_id, [r.id for r in self.rows])}")

    def hard(self, use: str) -> tuple[Rule, ...]:
        """The hard rows for plans of this use."""
        return tuple(row for row in self.rows if row.hard and row.concerns(use))

    def soft(self, use: str) -> tuple[Rule, ...]:
        """The soft rows for plans of this use."""
        return tuple(row for row in self.rows if not row.hard and row.concerns(use))

    def without(self, *rule_ids: str) -> Profile:
        """The profile less some rows; InputError where one of them is not there."""
        for name in rule_ids:
            self.rule(name)
        return self.model_copy(update={"rows": tuple(row for row in self.rows if row.id not in rule_ids)})


def profile_names() -> tuple[str, ...]:
    """Names of the profiles that ship with the library."""
    files = packaged.folder("sceneweaver.plans", "profiles").iterdir()
    return tuple(sorted(file.name.removesuffix(".yaml") for file in files if file.name.endswith(".yaml")))


@cache
def _named(name: str) -> Profile:
    if name not in profile_names():
        raise InputError(f"profile {show(name)} is not known{suggest(name, profile_names(), what='profiles are')}")
    data: dict[str, Any] = packaged.yaml_data("sceneweaver.plans", "profiles", f"{name}.yaml")
    return _extended(Profile.model_validate({"name": name, **data}))


def _extended(profile: Profile) -> Profile:
    if profile.extends is None:
        return profile
    rows = {row.id: row for row in Profile.named(profile.extends).rows}
    rows |= {row.id: row for row in profile.rows}
    return profile.model_copy(update={"rows": tuple(rows.values())})
