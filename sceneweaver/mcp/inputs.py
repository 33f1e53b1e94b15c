"""Types of the tools' arguments, with their bounds."""

from __future__ import annotations

from inspect import Parameter
from typing import Annotated, Any

from pydantic import Field, FiniteFloat

from sceneweaver.runtime.options import DesignOptions, Option, options_of
from sceneweaver.scene.limits import MOST_TURN

from .limits import LEAST_SIDE, MOST_CANDIDATES, MOST_PROMPT, MOST_SECONDS, MOST_SIDE, MOST_WAY

SceneId = Annotated[str, Field(min_length=1, max_length=40, description="Handle of an open scene, such as s1")]
HomeId = Annotated[str, Field(min_length=1, max_length=40, description="Handle of an open home, such as h1")]
OpenId = Annotated[str, Field(min_length=1, max_length=40, description="Handle of an open scene or home: s1, h1")]
RoomId = Annotated[str, Field(min_length=1, max_length=200, description="Id of a room of the home, such as kitchen")]
Profile = Annotated[str, Field(min_length=1, max_length=60, description="Rules of plans: base, accessible ...")]
ObjectId = Annotated[str, Field(min_length=1, max_length=200, description="Id of an object, such as desk-0")]
Name = Annotated[str, Field(min_length=1, max_length=400, description="Name below the server's folder")]
Prompt = Annotated[str, Field(min_length=1, max_length=MOST_PROMPT, description="The room, in plain English")]
Words = Annotated[str, Field(min_length=1, max_length=400)]
Coordinate = Annotated[FiniteFloat, Field(ge=-MOST_WAY, le=MOST_WAY)]
Point = Annotated[list[Coordinate], Field(min_length=2, max_length=3, description="x, y or x, y, z [m]")]
Degrees = Annotated[FiniteFloat, Field(ge=-MOST_TURN, le=MOST_TURN, description="Counter-clockwise [degrees]")]
Metres = Annotated[FiniteFloat, Field(gt=0, le=100, description="[m]")]
Seed = Annotated[int, Field(ge=0, lt=2**32, description="Equal seeds give equal results")]
Seconds = Annotated[FiniteFloat, Field(gt=0, le=MOST_SECONDS, description="Seconds that it may take; null: as usual")]
VersionNumber = Annotated[int, Field(ge=1, lt=2**32, description="Number of a version")]
Side = Annotated[int, Field(ge=LEAST_SIDE, le=MOST_SIDE, description="Pixels")]
Exact = Annotated[
    bool,
    Field(description="Leave everything just as edited; otherwise things make way so that the scene stays valid"),
]
Target = Annotated[
    str | list[str] | bool | None,
    Field(
        description='Id of an object, door or window; a wall ("north", "wall:2", "wall" for any); two ids for between; '
        "null where the type needs none"
    ),
]

MOST = {"candidates": MOST_CANDIDATES}
"""Bounds of this server on options of a design that have none of their own."""


def design_parameters() -> list[Parameter]:
    """The options of a design that the server takes, as parameters of a tool."""
    rows = options_of(DesignOptions).items()
    return [_parameter(name, kind, option) for name, (kind, option) in rows if option.server is not None]


def _parameter(name: str, kind: Any, option: Option) -> Parameter:
    most = MOST.get(name) if option.most is None else option.most
    bounds: dict[str, Any] = {key: value for key, value in (("ge", option.least), ("le", most)) if value is not None}
    told = Annotated[kind, Field(description=option.server, **bounds)]
    return Parameter(name, Parameter.KEYWORD_ONLY, default=option.default, annotation=told)
