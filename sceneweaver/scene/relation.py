"""The relations of a scene."""

from __future__ import annotations

import re
from typing import Self

from pydantic import Field, field_validator, model_validator

from sceneweaver.io.messages import quote, show, suggest

from .base import FrozenModel
from .catalogue import CATALOGUE
from .fields import Flag, Id, JsonDict, Name, Target, Weight
from .messages import FieldError

_WALL = re.compile(r"wall:(0|[1-9][0-9]{0,8})", re.ASCII)


def wall_number(target: str) -> int | None:
    """k of "wall:k"; None when it is something else."""
    match = _WALL.fullmatch(target)
    return int(match[1]) if match else None


class Relation(FrozenModel):
    """A spatial relation between ``subject`` and ``target``; the catalogue says what each type means.

    ``params`` are lengths [m] and angles [degrees] of the type. An unknown type, param or target is an `InputError`.

    Examples:
        >>> import sceneweaver as sw
        >>> relation = sw.Relation(type="against_wall", subject="desk", target="wall:0")
        >>> relation.hard, relation.targets
        (True, ('wall:0',))
    """

    type: Name = Field(description="Relation type, one of the catalogue")
    subject: Id = Field(description="Id of the object that the relation places")
    target: Target = Field(
        default=None,
        description='Id of an object, two ids, "wall:k", id of a door or window, or null, as the type asks',
    )
    params: JsonDict = Field(default_factory=dict, description="Numbers of the relation type set for this relation")
    hard: Flag = Field(default=True, description="Whether the scene is invalid when the relation does not hold")
    weight: Weight = Field(default=1.0, description="Weight among soft relations")
    asked: Flag = Field(default=False, description="Whether the request says it; what it does not say gives way first")
    request: Name | None = Field(
        default=None, description="Id of the stated relation of the request that it stands for; null: of none"
    )

    @field_validator("type")
    @classmethod
    def _known(cls, value: str) -> str:
        if value not in CATALOGUE:
            raise FieldError((), f"{show(value)} is unknown{suggest(value, CATALOGUE)}")
        return value

    @model_validator(mode="after")
    def _check(self) -> Self:
        self._check_target()
        try:
            params = CATALOGUE[self.type].check_params(self.params)
        except FieldError as error:
            raise FieldError(("params", *error.loc), error.text) from None
        object.__setattr__(self, "params", params)  # with their proper types; the model is not out in the world yet
        return self

    @property
    def targets(self) -> tuple[str, ...]:
        """The target as a tuple of none, one or two names."""
        if self.target is None:
            return ()
        return (self.target,) if isinstance(self.target, str) else self.target

    def _check_target(self) -> None:
        """The target has the form that the relation type asks for, and is not the subject."""
        spec = CATALOGUE[self.type]
        kind, target = spec.target_kind, self.target
        wanted = {
            "none": "null",
            "wall": '"wall:k"',
            "object": "the id of an object",
            "objects": "a list of two object ids",
            "window": "the id of a window",
            "door": "the id of a door",
        }[kind]
        wanted += " or null" if spec.target_optional and kind != "none" else ""
        if target is None:
            if not spec.target_optional:
                raise FieldError(("target",), f"is missing; {self.type} takes {wanted}")
            return
        if kind == "none":
            raise FieldError(("target",), f"is {_show_target(target)}; {self.type} takes none, set it to null")
        if isinstance(target, str) == (kind == "objects"):
            raise FieldError(("target",), f"is {_show_target(target)}; {self.type} takes {wanted}")
        if kind == "wall" and wall_number(self.targets[0]) is None:
            raise FieldError(("target",), f"is {_show_target(target)}; {self.type} takes {wanted}, such as wall:0")
        if self.subject in self.targets:
            raise FieldError(("target",), f"is {quote(self.subject)}, the subject itself; name another object")
        if kind == "objects" and len(set(self.targets)) < 2:
            raise FieldError(("target",), f"names {quote(self.targets[0])} twice; name two objects")


def _show_target(target: str | tuple[str, str]) -> str:
    return quote(target) if isinstance(target, str) else f"[{', '.join(quote(t) for t in target)}]"
