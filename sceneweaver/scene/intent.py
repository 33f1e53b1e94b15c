"""What an object is there for, apart from what it is: read by the engine, the tools, the agent and the critic."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import AfterValidator, Field

from .base import FrozenModel
from .fields import Flag, Name, Vec2
from .messages import FieldError

Priority = Literal["optional", "usual", "needed", "asked"]
"""How much an object is wanted: nice to have, usual in such a room, needed by it, asked for in the request."""

PRIORITIES: tuple[Priority, ...] = get_args(Priority)
"""All priorities, the least first: where not everything fits, this is the order in which objects are given up."""


def _check_heights(value: tuple[float, float]) -> tuple[float, float]:
    if not value[0] <= value[1]:
        raise FieldError((), f"is [{value[0]:g}, {value[1]:g}]; the first must not be greater than the second")
    return value


class Intent(FrozenModel):
    """Why an object is in a scene and how it is meant to hang. The judge reads none of this: it changes no validity."""

    priority: Priority | None = Field(
        default=None, description="How much it is wanted, from optional to asked; null: nobody said, taken as usual"
    )
    request: Name | None = Field(
        default=None, description="Id of the thing in the request that it stands for; null: nobody asked for it"
    )
    program_item: Name | None = Field(
        default=None, description="Id of the item of its kind of room that it stands for; null: of none"
    )
    mounting_height: Annotated[Vec2, AfterValidator(_check_heights)] | None = Field(
        default=None, description="For mount wall: lowest and highest height of its bottom above the floor [m]"
    )
    keep_clear: Flag = Field(default=False, description="For mount wall: whether it keeps off doors and windows")

    @property
    def rank(self) -> int:
        """Position of the priority in `PRIORITIES`; without one that of "usual"."""
        return PRIORITIES.index(self.priority or "usual")
