"""What floor and walls of a room are finished with; colours and woods by the names of the asset library."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from .base import FrozenModel
from .fields import Index, Length, Name, Offset
from .messages import FieldError

FloorMaterial = Literal["wood", "tile", "carpet", "concrete", "stone"]
WallMaterial = Literal[
    "plaster", "rough plaster", "paper", "concrete", "brick", "stone", "boards", "logs", "metal", "tiles"
]
FloorPattern = Literal[
    "checkered",
    "herringbone",
    "basket weave",
    "strip parquet",
    "hexagon tiles",
    "square tiles",
    "large tiles",
    "terrazzo",
    "marble",
    "slate",
    "granite",
    "travertine",
    "limestone",
    "brick",
    "rubber",
    "shaggy",
    "earth",
    "cork",
    "pebbles",
    "smooth",
    "tartan",
    "leopard",
    "zebra",
    "floral",
    "dotted",
    "stripes",
]
WallPattern = Literal[
    "stripes", "dots", "damask", "botanical", "checkered", "wall tiles", "metro tiles", "hexagon tiles", "square tiles"
]
Outside = Literal["garden", "snow", "city", "sea", "forest", "mountains", "space", "rain"]
Daylight = Literal["day", "overcast", "dusk", "night"]
Level = Literal["bright", "normal", "dim", "dark"]


class FloorFinish(FrozenModel):
    """What a floor is of."""

    material: FloorMaterial = Field(default="wood", description="What it is laid of")
    tone: Name | None = Field(default=None, description="A finish of wood, else a colour; null: the usual one")
    pattern: FloorPattern | None = Field(default=None, description="How it is laid, or which stone; null: as usual")
    second: Name | None = Field(default=None, description="The other colour of a pattern of two")


class WallAccent(FrozenModel):
    """Walls that are done otherwise than the others: another paint, striped paper, or panels up to some height."""

    kind: Literal["paint", "paper", "panelling"] = "paint"
    color: Name = Field(description="Its colour")
    of: WallMaterial | None = Field(default=None, description="What is seen of it instead of paint: brick, stone")
    pattern: WallPattern | None = Field(default=None, description="Of paper, or of tiles; null: paper is striped")
    second: Name | None = Field(default=None, description="The other colour of stripes or checks")
    walls: Annotated[tuple[Index, ...], Field(min_length=1)] = Field(description="Numbers of the walls")
    high: Length | None = Field(default=None, description="Height of panels [m]; null: 1.15")


class CeilingFinish(FrozenModel):
    """What a ceiling is of, and the wood of beams under it."""

    material: WallMaterial = Field(default="plaster", description="What it is of")
    color: Name = Field(default="white", description="Its colour, or a finish of wood")
    beams: Name | None = Field(default=None, description="A finish of wood or metal; null: there are none")


class RoomLight(FrozenModel):
    """The light that a room is shown in: what comes in by the windows, and what its lamps are like."""

    daylight: Daylight = Field(default="day", description="What comes in by the windows")
    level: Level = Field(default="normal", description="How light the room is")
    kelvin: Annotated[int, Field(ge=1000, le=12000)] = Field(default=2900, description="Colour of its lamps [K]")
    glow: Name | None = Field(default=None, description="A colour that fills the room, as of neon; null: none")
    outside: Outside = Field(default="garden", description="What is seen through the windows")


class WallTiles(FrozenModel):
    """A band of tiles on walls."""

    color: Name = Field(description="Colour of the tiles")
    pattern: WallPattern | None = Field(default=None, description="Their shape; null: squares")
    second: Name | None = Field(default=None, description="The other colour of checks")
    low: Offset = Field(default=0.0, description="Height at which it begins [m]")
    high: Length = Field(description="Height at which it ends [m]")
    walls: tuple[Index, ...] | None = Field(default=None, description="Numbers of the walls; null: all")

    @model_validator(mode="after")
    def _check(self) -> Self:
        if self.high <= self.low:
            raise FieldError(("high",), f"is {self.high:.6g}, not above low ({self.low:.6g}); make it higher")
        return self


class RoomFinish(FrozenModel):
    """Paint, paper, panels and tiles of the walls, and the floor."""

    walls: Name = Field(default="white", description="Colour of the walls, or a finish of wood")
    walls_of: WallMaterial = Field(default="plaster", description="What the walls show")
    walls_pattern: WallPattern | None = Field(default=None, description="Of paper or tiles; null: the usual one")
    walls_second: Name | None = Field(default=None, description="The other colour of stripes or checks")
    ceiling: CeilingFinish | None = Field(default=None, description="Null: white plaster")
    trim: Name | None = Field(default=None, description="Colour or wood of skirting, frames and doors; null: white")
    doors: Name | None = Field(default=None, description="Colour or wood of the leaves of doors; null: as the trim")
    electric: bool = Field(default=True, description="Whether there are switches, sockets and radiators")
    floor: FloorFinish = FloorFinish()
    accent: WallAccent | None = None
    tiles: WallTiles | None = None

    @property
    def named_walls(self) -> tuple[tuple[str, int], ...]:
        """The walls that its parts name: part and number."""
        parts = (("accent", self.accent), ("tiles", self.tiles))
        return tuple((name, wall) for name, part in parts if part is not None for wall in part.walls or ())
