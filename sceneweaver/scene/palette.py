"""The look of a room, chosen once: style, woods, paints, metal and colours of cloth that all its things follow."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from .base import FrozenModel
from .fields import Index, Name

MOST_WOODS, MOST_COLORS = 2, 3
"""Woods and colours of cloth that a room has at most."""


class Palette(FrozenModel):
    """Style and colours of a room, by the names that the asset library has for finishes and colours.

    What a request names has a look of its own.
    """

    name: Name = Field(description="Name of the palette, such as fjord")
    style: Name = Field(description="Style of the furniture, such as modern")
    woods: Annotated[tuple[Name, ...], Field(min_length=1, max_length=MOST_WOODS)] = Field(
        description="Finishes of wood, that of the furniture first"
    )
    paints: Annotated[tuple[Name, ...], Field(min_length=1)] = Field(description="Finishes of painted furniture")
    metals: Annotated[tuple[Name, ...], Field(min_length=1)] = Field(
        description="Finishes of legs, handles and lamps, the usual one first"
    )
    textiles: Annotated[tuple[Name, ...], Field(min_length=1, max_length=MOST_COLORS)] = Field(
        description="Colours of cloth, that of large things first"
    )
    avoid: tuple[Name, ...] = Field(
        default=(),
        description="Finishes, families of them and basic colours that nothing is of: plastic long ago; "
        "'seating:black' holds for seats alone",
    )
    seed: Index = Field(default=0, description="Decides what the names leave open, for the whole room alike")

    @property
    def code(self) -> str:
        """Its colours in one word, as a part of the recipe of an asset."""
        groups = (self.woods, self.paints, self.metals, self.textiles, (str(self.seed),), self.avoid)
        return "/".join(",".join(group) for group in groups if group)
