"""The categories of furniture: data in ``categories/*.yaml``, read once."""

from __future__ import annotations

from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from sceneweaver.io import packaged
from sceneweaver.scene.base import FrozenModel

from .asset import Mount

Range = Annotated[tuple[float, float], Field(description="Least and largest usual value")]
Side = Literal["front", "back", "left", "right", "top"]


ROLES = "roles.yaml"
"""The file beside those of the categories that says what they are to a room, see `roles`."""

REACH = (0.72, 1.35)
"""Factors of the least and the largest usual extent within which words may put a thing."""


class Sizes(FrozenModel):
    """Usual sizes [m]: depth along the front, width, height.

    ``longest`` is the width of what is built to the length of its place where those at it need it: counters.
    """

    depth: Range
    width: Range
    height: Range
    longest: float | None = None

    @property
    def ranges(self) -> tuple[Range, Range, Range]:
        """The three ranges in the order of an object's ``size``."""
        return self.depth, self.width, self.height

    @property
    def reach(self) -> tuple[Range, Range, Range]:
        """The ranges with what words may ask beyond them: a low table is lower than tables are."""
        d, w, h = ((low * REACH[0], high * REACH[1]) for low, high in self.ranges)
        return d, w, h

    @property
    def built(self) -> tuple[Range, Range, Range]:
        """As `reach`, with the width up to which such a thing is built."""
        d, w, h = self.reach
        return d, (w[0], max(w[1], self.longest or 0.0)), h

    @model_validator(mode="after")
    def _check(self) -> Sizes:
        for name, (low, high) in zip(("depth", "width", "height"), self.ranges, strict=True):
            if not 0 < low <= high:
                raise ValueError(f"{name} must run from small to large, not {low} to {high}")
        return self


class Category(FrozenModel):
    """One kind of thing that a user would name.

    A category without ``size`` is a group of others ("seating"), and has no body of its own.
    """

    name: str
    parent: str | None = Field(default=None, description="The wider category that it belongs to")
    synonyms: tuple[str, ...] = Field(default=(), description="Other words for the same thing")
    like: tuple[str, ...] = Field(
        default=(), description="Other things of about its size and form: its body stands for them, under their names"
    )
    plural: str | None = Field(default=None, description="Plural where it is not regular")
    several: dict[str, int] = Field(
        default={}, description="Plural words for what one body shows several of, and how many of them: gowns on a rail"
    )
    usual: str | None = Field(
        default=None, description="Of a group: the member that is meant when nothing else is said"
    )
    size: Sizes | None = None
    source: str = Field(default="", description="Where the sizes come from")
    mount: tuple[Mount, ...] = Field(default=("floor",), description="What may hold it, the usual one first")
    bottom: Range | None = Field(default=None, description="Usual height [m] of its bottom above the floor, on a wall")
    on: tuple[str, ...] = Field(default=(), description="Categories that it usually stands on")
    holds: tuple[str, ...] = Field(default=(), description="Categories that usually stand on or in it")
    sides: tuple[Side, ...] = Field(default=(), description="Sides from which it is used")
    clearance: dict[Side, float] = Field(default={}, description="Depth [m] of the free zone that a side needs")
    mass: Range = Field(default=(1.0, 10.0), description="Mass [kg] of the smallest and the largest")
    friction: float = Field(default=0.5, description="Coefficient of sliding friction")
    body: Literal["hard", "soft", "leaf"] = Field(default="hard", description="How closely parts follow the mesh")

    @property
    def words(self) -> str:
        """The name as a user would write it."""
        return self.name.replace("_", " ")


def read_yaml(file: Traversable) -> Any:
    """YAML data of a file of the package, by the fast reader where there is one."""
    return packaged.parse(packaged.text_of(file))


@cache
def categories() -> dict[str, Category]:
    """All categories by name; a category inherits nothing, so that each entry can be read on its own."""
    found: dict[str, Category] = {}
    folder = resources.files(__package__ or "").joinpath("categories")
    for file in sorted(folder.iterdir(), key=lambda f: f.name):
        if not file.name.endswith(".yaml") or file.name == ROLES:
            continue
        for name, row in (read_yaml(file) or {}).items():
            if name in found:
                raise ValueError(f"{file.name}: {name} is there already")
            # YAML 1.1 reads the bare key "on" as true.
            row = {"on" if key is True else key: value for key, value in row.items()}
            if isinstance(row.get("mount"), str):
                row["mount"] = (row["mount"],)
            found[name] = Category(name=name, **row)
    return found
