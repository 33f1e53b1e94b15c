"""Tool cards: when, why and with what input to call a tool. A planner reads nothing else of it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from importlib import resources
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from sceneweaver.io import packaged, parse_yaml
from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

from .schema import check_inputs, check_schema

Role = Literal["initializer", "implementer", "modifier"]
"""The scale at which a tool works: a whole scene, the things in a part of it, or details of what is there."""


class Example(FrozenModel):
    """A sentence and the inputs that say the same."""

    instruction: str
    inputs: dict[str, Any] = {}


class ToolCard(FrozenModel):
    """What is known about a tool.

    ``inputs`` is a JSON schema; ``confidence`` in 0..1 is how far it is trusted before it was ever called. ``needs``
    says what the tool cannot do without: a language model, or a model of scenes. ``withheld`` names inputs that a
    language model may not give, such as paths and angles.
    """

    name: Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$")]
    role: Role
    description: Annotated[str, Field(min_length=1)]
    when: Annotated[str, Field(min_length=1)]
    when_not: Annotated[str, Field(min_length=1)]
    strengths: tuple[str, ...]
    weaknesses: tuple[str, ...]
    rooms: Literal["all"] | tuple[str, ...] = "all"
    inputs: dict[str, Any]
    example: Example
    needs: Literal["model", "scene_model"] | None = None
    withheld: tuple[str, ...] = ()
    confidence: Annotated[float, Field(ge=0.0, le=1.0)] = 0.5

    @model_validator(mode="after")
    def _check(self) -> ToolCard:
        check_schema(self.inputs, "inputs")
        check_inputs(self.inputs, self.example.inputs, "example.inputs")
        for name in self.withheld:
            if name not in self.inputs.get("properties", {}):
                raise ValueError(f"withheld names {name}, which is no input")
        return self

    def suits(self, room: str) -> bool:
        """Whether it works for a kind of room."""
        return self.rooms == "all" or room in self.rooms

    def check(self, inputs: Any) -> None:
        """InputError with one line when the card does not allow the inputs."""
        check_inputs(self.inputs, inputs, f"tool {self.name}: inputs")


@lru_cache(maxsize=256)
def read_card(text: str) -> ToolCard:
    """The card in a YAML text; InputError with one line on anything wrong."""
    data = parse_yaml(text, "card")
    if not isinstance(data, Mapping):
        raise InputError("card: give a YAML mapping with name, role, description and so on")
    return ToolCard.model_validate(dict(data))


@cache
def own_card(name: str) -> ToolCard:
    """The card of a tool that comes with the library; InputError when there is none."""
    file = resources.files("sceneweaver").joinpath("toolcards", f"{name}.yaml")
    if not file.is_file():
        raise InputError(f"tool {name}: there is no card toolcards/{name}.yaml")
    return read_card(packaged.text_of(file))


def checked(name: str, inputs: Mapping[str, Any]) -> Mapping[str, Any]:
    """The inputs of one of our own tools, as its card allows them; InputError when it does not."""
    own_card(name).check(inputs)
    return inputs
