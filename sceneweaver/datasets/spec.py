"""The specification of a data set: a YAML file that says all that its content depends on."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from sceneweaver.export import FORMATS
from sceneweaver.io import load_yaml
from sceneweaver.io.messages import suggest
from sceneweaver.scene import InputError
from sceneweaver.scene.base import FrozenModel

from .gates import Gates

if TYPE_CHECKING:
    Export = str
else:
    Export = Literal[tuple(sorted(name for name, one in FORMATS.items() if one.shared))]
"""A format that data sets have, see `sceneweaver.export`."""

EXAMPLES = {path.stem: path for path in sorted((Path(__file__).parent / "examples").glob("*.yaml"))}
"""Specifications that ship with the library, by name."""

Weights = Annotated[dict[str, Annotated[float, Field(gt=0)]], Field(min_length=1)]
"""What is drawn, with how much it weighs."""

Share = Annotated[float, Field(ge=0, le=1)]

HOMES_BLOCK = 1
"""Homes of a block where a specification does not say it: one takes half a minute and shares nothing with the next."""


class _Brief(FrozenModel):
    """A model that says nothing of some fields where they are not given, as before there were any."""

    _later: ClassVar[tuple[str, ...]] = ()

    @model_serializer(mode="wrap")
    def _without_later(self, usual: SerializerFunctionWrapHandler) -> dict[str, Any]:
        data = usual(self)
        return {name: value for name, value in data.items() if value is not None or name not in self._later}


class Requests(_Brief):
    """What is asked for: kinds of rooms by weight, prompts, a CSV file with a column ``prompt``, for layouts scene
    files, or for homes programmes by weight; one of the five.

    The other fields are said in each request of a kind of room: its area, style and number of people.
    """

    _later = ("programmes",)

    kinds: Weights | None = None
    prompts: tuple[str, ...] | None = None
    prompts_file: str | None = None
    scenes: tuple[str, ...] | None = Field(default=None, description="Scene files whose layouts are wanted")
    programmes: Weights | None = Field(default=None, description="Programmes of homes that ship with the library")
    area: dict[str, tuple[float, float]] = Field(default={}, description="Least and greatest floor area [m2] by kind")
    sizes: Weights = Field(default={"": 1.0}, description='Words of size: "", small, large, ...')
    styles: Weights = Field(default={"": 1.0}, description='Words of style: "", industrial, scandinavian, ...')
    people: Weights = Field(default={"": 1.0}, description='How many use the room, as in "for two people"; "": unsaid')
    clutter: tuple[Share, Share] = Field(default=(0.2, 0.6), description="Least and greatest, from 0 to 1")

    @model_validator(mode="after")
    def _one_source(self) -> Requests:
        sources = (self.kinds, self.prompts, self.prompts_file, self.scenes, self.programmes)
        if sum(given is not None for given in sources) != 1:
            raise ValueError("give one of kinds, prompts, prompts_file, scenes and programmes")
        return self


class Rooms(FrozenModel):
    """How each room is laid out."""

    candidates: int = Field(default=24, ge=1, le=65536, description="Layouts that are refined for each room")
    layouts: int = Field(default=1, ge=1, le=10**6, description="Layouts of a room that are kept, a scene each")
    objects: tuple[int, int] = Field(
        default=(1, 64), description="Least and most pieces of furniture of a room whose layouts are the product"
    )
    attempts: int = Field(default=3, ge=1, le=20, description="Draws of a room before a request counts as not served")


class Views(FrozenModel):
    """Pictures of each scene."""

    cameras: tuple[Literal["eye-door", "eye-corner", "corner", "top"], ...] = ()
    passes: tuple[str, ...] = Field(default=(), description="rgb, depth, normals, ids, ...: as `sceneweaver render`")
    width: int = Field(default=640, ge=16, le=8192, description="[pixels]")
    height: int = Field(default=480, ge=16, le=8192, description="[pixels]")


class Homes(FrozenModel):
    """How homes are planned, furnished and described, where they are the product."""

    profile: str = Field(default="base", description="Rules that plans keep")
    plans: int = Field(default=256, ge=1, le=65536, description="Plans that are searched for each home")
    furnished: bool = Field(default=True, description="Whether rooms are furnished; plans alone are quick")
    radius: float = Field(default=0.25, ge=0.01, le=5, description="Of the base that ways and maps are for [m]")
    resolution: float = Field(default=0.05, ge=0.005, le=1, description="Side of a cell of maps [m]")
    point_goals: int = Field(default=20, ge=0, le=10**5, description="Episodes to points of each home")
    object_goals: int = Field(default=20, ge=0, le=10**5, description="Episodes to things of each furnished home")


class Spec(_Brief):
    """All that the content of a data set depends on. Equal specifications give equal data sets, whoever makes them."""

    _noun: ClassVar[str] = "spec"
    _later = ("homes",)

    schema_: Literal["sceneweaver.dataset/1"] = Field(alias="schema")
    name: str = Field(pattern=r"^[a-z0-9][a-z0-9_-]{0,63}$")
    product: Literal["scenes", "layouts", "homes"] = "scenes"
    count: int = Field(ge=1, le=10**9, description="Scenes, layouts, or homes")
    seed: int = Field(default=0, ge=0, le=2**32 - 1)
    requests: Requests
    rooms: Rooms = Rooms()
    homes: Homes | None = Field(default=None, description="Of homes, where they are the product; null: the usual")
    exports: tuple[Export, ...] = ("glb", "mjcf")
    views: Views = Views()
    captions: bool = True
    counterfactuals: int = Field(default=0, ge=0, le=16, description="Changed twins of each scene")
    gates: Gates = Gates()
    splits: Weights = Field(default={"train": 0.9, "validation": 0.05, "test": 0.05})
    variants: int = Field(default=8, ge=1, le=10**6, description="Drawings of a kind of thing that scenes choose from")
    time_limit: float = Field(default=120.0, gt=0, description="Seconds for a scene, after which it has failed")
    block: int = Field(
        default=16,
        ge=1,
        le=4096,
        description=f"Rooms that are made together, kept or lost together; of homes {HOMES_BLOCK} unless it is said",
    )
    shard: int = Field(default=200, ge=1, le=4096, description="Size of a shard of data [MB]")

    @model_validator(mode="before")
    @classmethod
    def _homes_apart(cls, data: Any) -> Any:
        if isinstance(data, Mapping) and data.get("product") == "homes" and "block" not in data:
            return {**data, "block": HOMES_BLOCK}
        return data

    @model_validator(mode="after")
    def _of_homes(self) -> Spec:
        asked = self.requests
        if self.product != "homes":
            if asked.programmes is not None or self.homes is not None:
                raise ValueError("programmes and homes are for product: homes")
            return self
        if asked.kinds is not None or asked.scenes is not None:
            raise ValueError("requests of homes are programmes, prompts or a prompts_file")
        if self.rooms.layouts != 1 or self.counterfactuals or self.views.cameras or self.views.passes:
            raise ValueError("homes have no layouts, counterfactuals or views; leave these out")
        return self

    @property
    def of_homes(self) -> Homes:
        """How homes are made."""
        return self.homes or Homes()

    @property
    def table(self) -> str:
        """The name in ``columns.yaml`` of the columns of its index."""
        return "homes" if self.product == "homes" else "index"

    @property
    def hash(self) -> str:
        """SHA-256 of all fields, in hex."""
        text = json.dumps(self.model_dump(mode="json"), sort_keys=True, ensure_ascii=False)
        return hashlib.sha256(text.encode()).hexdigest()


def spec_file(source: Path) -> Path:
    """The file of a specification: of that path, or else of the example of that name.

    Raises:
        InputError: there is neither.
    """
    if source.exists() or source.suffix:
        return source
    if str(source) not in EXAMPLES:
        raise InputError(f"{source}: no such file, and no example{suggest(str(source), EXAMPLES, what='examples')}")
    return EXAMPLES[str(source)]


def spec_schema() -> dict[str, Any]:
    """The JSON schema of specifications, for editors and other programs."""
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **Spec.model_json_schema(by_alias=True)}


def load_spec(path: str | Path) -> Spec:
    """Read a specification.

    Raises:
        InputError: one line that names the file, the field and the fix.
    """
    data = load_yaml(path)
    try:
        return Spec.model_validate(data)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
