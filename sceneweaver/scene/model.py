"""What a scene is: the typed form of ``scene.json`` (schema ``sceneweaver.scene/1``).

Units are metres and radians, z is up, yaw is counter-clockwise about +z and the front of an object is +x at yaw 0.
An object's origin is the bottom centre of its box; ``size`` is (depth along the front, width, height).
Polygons of parts, zones and surfaces are in the object's frame, counter-clockwise.

Making a model checks it and raises InputError with one line; models are frozen, edits return new ones. The
dictionaries in them (``params``, ``attributes``, ``provenance``) are to be read only, too.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import Field, field_validator, model_validator

from . import validate
from .base import FrozenModel
from .catalogue import CATALOGUE
from .errors import InputError
from .fields import (
    ConvexPolygon,
    Flag,
    Id,
    Index,
    Interval,
    JsonDict,
    Length,
    Name,
    Number,
    Offset,
    Outline,
    Polygon,
    Quat,
    Target,
    Text,
    Vec2,
    Vec3,
    Weight,
)
from .intent import Intent
from .messages import Problem, quote, show, suggest

SCHEMA = "sceneweaver.scene/1"


class Door(FrozenModel):
    """A door in wall ``wall``, starting ``offset`` metres after the wall's first corner."""

    id: Id = Field(description="Unique among doors, windows and objects")
    wall: Index = Field(description="Number of the wall, from 0; wall i runs from corner i to corner i + 1")
    offset: Offset = Field(description="Distance from the wall's first corner to the opening [m]")
    width: Length = Field(description="Width along the wall [m]")
    height: Length = Field(description="Height from the floor [m]")
    swing: Literal["in-left", "in-right", "out", "slide"] = Field(
        default="in-left", description="How it opens; in-left and in-right need a square of its width free inside"
    )


class Window(FrozenModel):
    """A window in wall ``wall``; ``sill`` is the height of its lower edge."""

    id: Id = Field(description="Unique among doors, windows and objects")
    wall: Index = Field(description="Number of the wall, from 0; wall i runs from corner i to corner i + 1")
    offset: Offset = Field(description="Distance from the wall's first corner to the opening [m]")
    width: Length = Field(description="Width along the wall [m]")
    sill: Offset = Field(description="Height of the lower edge above the floor [m]")
    height: Length = Field(description="Height of the window itself [m]")


class Room(FrozenModel):
    """The room: a simple outline, counter-clockwise; wall i runs from corner i to corner i + 1."""

    type: Name = Field(default="room", description="Kind of room, such as bedroom")
    outline: Outline = Field(description="Corners [x, y] of the floor in counter-clockwise order [m]")
    height: Length = Field(default=2.7, description="Height of the ceiling above the floor [m]")
    doors: Annotated[tuple[Door, ...], Field(fail_fast=True)] = ()
    windows: Annotated[tuple[Window, ...], Field(fail_fast=True)] = ()

    @model_validator(mode="after")
    def _check(self) -> Self:
        validate.check_openings(self)
        return self


class Pose(FrozenModel):
    """World position of an object's bottom centre and its rotation as an xyzw quaternion."""

    position: Vec3 = Field(default=(0.0, 0.0, 0.0), description="World position of the bottom centre [m]")
    quaternion: Quat = Field(default=(0.0, 0.0, 0.0, 1.0), description="Rotation as a unit quaternion x, y, z, w")

    @property
    def yaw(self) -> float:
        """Rotation about +z in radians, in (-pi, pi]."""
        x, y, z, w = self.quaternion
        return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

    @classmethod
    def from_yaw(cls, x: float, y: float, z: float, yaw: float) -> Pose:
        """The upright pose at (x, y, z) turned by ``yaw`` radians; InputError when one of them is not finite."""
        if not math.isfinite(yaw):
            raise InputError(f"pose: yaw is {show(float(yaw))}; numbers must be finite")
        return cls(position=(x, y, z), quaternion=(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))


class Support(FrozenModel):
    """The surface that an object stands on."""

    object: Id = Field(description="Id of the object that carries this one")
    surface: Name = Field(description="Name of one of its surfaces")


class Part(FrozenModel):
    """One convex prism of an object's collision shape: a polygon times a z interval."""

    polygon: ConvexPolygon = Field(description="Corners [x, y] of a convex polygon in the object's frame [m]")
    z: Interval = Field(description="Lower and upper end in the object's frame [m]")


class Zone(FrozenModel):
    """Space that should stay free of other objects, such as the swing of a wardrobe door."""

    name: Name
    polygon: Polygon = Field(description="Corners [x, y] of a simple polygon in the object's frame [m]")
    z: Interval = Field(description="Lower and upper end in the object's frame [m]")
    hard: Flag = Field(default=True, description="Whether an object in the zone makes the scene invalid")


class Surface(FrozenModel):
    """A horizontal support surface at height ``z`` with ``headroom`` metres of free space (None: no limit)."""

    name: Name = Field(description="Unique within the object")
    polygon: Polygon = Field(description="Corners [x, y] of a simple polygon in the object's frame [m]")
    z: Number = Field(description="Height in the object's frame [m]")
    headroom: Length | None = Field(default=None, description="Free height above the surface [m]; null: no limit")


class SceneObject(FrozenModel):
    """One object of a scene."""

    _noun: ClassVar[str] = "object"

    id: Id = Field(description="Unique among doors, windows and objects")
    category: Name = Field(description="What it is, such as office chair; any words")
    description: Text | None = Field(default=None, description="What it looks like")
    size: tuple[Length, Length, Length] = Field(description="Depth along the front, width, height [m]")
    pose: Pose = Pose.model_construct(position=(0.0, 0.0, 0.0), quaternion=(0.0, 0.0, 0.0, 1.0))
    mount: Literal["floor", "wall", "ceiling", "surface"] = Field(default="floor", description="What holds it")
    support: Support | None = Field(default=None, description="What it stands on; for mount surface, and only there")
    asset: Name | None = Field(default=None, description="Id of its mesh; null: shown as its parts")
    parts: Annotated[tuple[Part, ...], Field(fail_fast=True)] | None = Field(
        default=None, description="Collision shape as convex prisms; null: its box"
    )
    zones: Annotated[tuple[Zone, ...], Field(fail_fast=True)] = Field(
        default=(), description="Space to keep free around it"
    )
    surfaces: Annotated[tuple[Surface, ...], Field(fail_fast=True)] = Field(
        default=(), description="What others may stand on"
    )
    fixed: Flag = Field(default=False, description="Whether it must stay where it is")
    intent: Intent = Field(default=Intent.model_construct(), description="What it is there for; changes no validity")
    attributes: JsonDict = Field(
        default_factory=dict, description="Free data on how it looks: color, material, style ..."
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        validate.check_object(self)
        return self

    @property
    def solids(self) -> tuple[Part, ...]:
        """The collision parts; an object without parts is its box."""
        if self.parts:
            return self.parts
        d, w, h = self.size
        box = ((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2))
        return (Part.model_construct(polygon=box, z=(0.0, h)),)


class Relation(FrozenModel):
    """A spatial relation between ``subject`` and ``target``; the catalogue says what each type means."""

    type: Name = Field(description="Relation type, one of the catalogue")
    subject: Id = Field(description="Id of the object that the relation places")
    target: Target = Field(
        default=None,
        description='Id of an object, two ids, "wall:k", id of a door or window, or null, as the type asks',
    )
    params: JsonDict = Field(default_factory=dict, description="Numbers of the relation type set for this relation")
    hard: Flag = Field(default=True, description="Whether the scene is invalid when the relation does not hold")
    weight: Weight = Field(default=1.0, description="Weight among soft relations")

    @field_validator("type")
    @classmethod
    def _known(cls, value: str) -> str:
        if value not in CATALOGUE:
            raise Problem((), f"{show(value)} is unknown{suggest(value, CATALOGUE)}")
        return value

    @model_validator(mode="after")
    def _check(self) -> Self:
        validate.check_relation(self)
        try:
            params = CATALOGUE[self.type].check_params(self.params)
        except Problem as problem:
            raise Problem(("params", *problem.loc), problem.text) from None
        object.__setattr__(self, "params", params)  # with their proper types; the model is not out in the world yet
        return self

    @property
    def targets(self) -> tuple[str, ...]:
        """The target as a tuple of none, one or two names."""
        if self.target is None:
            return ()
        return (self.target,) if isinstance(self.target, str) else self.target


class Dropped(FrozenModel):
    """An object that was asked for and could not be placed."""

    id: Id
    category: Name
    reason: Text = Field(description="Why it could not be placed")


class Scene(FrozenModel):
    """A whole scene. Immutable: edits return a new scene."""

    schema_: Literal["sceneweaver.scene/1"] = Field(default=SCHEMA, alias="schema")
    id: Name = Field(description="Name of the scene")
    prompt: Text = Field(default="", description="The request that it answers")
    room: Room
    objects: Annotated[tuple[SceneObject, ...], Field(fail_fast=True)] = ()
    relations: Annotated[tuple[Relation, ...], Field(fail_fast=True)] = ()
    provenance: JsonDict = Field(default_factory=dict, description="Free data: where the scene comes from")
    dropped: Annotated[tuple[Dropped, ...], Field(fail_fast=True)] = Field(
        default=(), description="What was asked for and could not be placed; anything here makes the scene invalid"
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        validate.check_references(self)
        return self

    @classmethod
    def _prefix(cls, data: Any) -> str:
        return ""

    @property
    def ids(self) -> tuple[str, ...]:
        """The ids of the objects, in order."""
        return tuple(self._lookup())

    def index(self, id: str) -> int:
        """The position of an object in ``objects``; InputError when there is none of that id."""
        lookup = self._lookup()
        if id not in lookup:
            raise InputError(f"{quote(id)} is no object of scene {quote(self.id)}{suggest(id, lookup, mark=chr(39))}")
        return lookup[id]

    def object(self, id: str) -> SceneObject:
        """The object of that id; InputError when there is none."""
        return self.objects[self.index(id)]

    def replace_poses(self, poses: Mapping[str, Pose]) -> Scene:
        """The scene with some objects elsewhere; quick, as nothing but the ids is checked again.

        Raises:
            InputError: for an id that is no object of the scene.
        """
        objects = list(self.objects)
        for id, pose in poses.items():
            at = self.index(id)
            objects[at] = objects[at].model_copy(update={"pose": pose})
        return self.model_copy(update={"objects": tuple(objects)})

    def to_json(self) -> dict[str, Any]:
        """The scene as plain JSON data, as ``scene.json`` holds it."""
        from . import io

        return io.to_json(self)

    def dumps(self) -> str:
        """The scene as the text of ``scene.json``; floats keep full precision."""
        from . import io

        return io.dumps(self)

    def save(self, path: str | Path) -> None:
        """Write ``scene.json`` under a temporary name and rename it; InputError when that cannot be done."""
        from . import io

        io.save(self, path)

    @classmethod
    def load(cls, path: str | Path) -> Scene:
        """Read ``scene.json``; raises InputError with one line on anything wrong."""
        from . import io

        return io.load(path)

    @classmethod
    def loads(cls, text: str | bytes) -> Scene:
        """The scene in the text of a ``scene.json``; raises InputError with one line on anything wrong."""
        from . import io

        return io.loads(text)

    @classmethod
    def from_json(cls, data: Any) -> Scene:
        """The scene in plain JSON data of this or an older schema version; InputError on anything wrong."""
        from . import io

        return io.from_json(data)

    @classmethod
    def example(cls, name: str = "bedroom") -> Scene:
        """One of the scenes that ship with the library, see ``EXAMPLES``; InputError for another name."""
        from . import io

        return io.example(name)

    def _lookup(self) -> dict[str, int]:
        """Position by id, kept with the ``objects`` that it was made from, as copies of a model share what it keeps."""
        kept = self.__dict__.get("_kept_lookup")
        if kept is None or kept[0] is not self.objects:
            kept = (self.objects, {o.id: i for i, o in enumerate(self.objects)})
            object.__setattr__(self, "_kept_lookup", kept)
        return kept[1]


__all__ = [
    "SCHEMA",
    "Door",
    "Dropped",
    "Part",
    "Pose",
    "Quat",
    "Relation",
    "Room",
    "Scene",
    "SceneObject",
    "Support",
    "Surface",
    "Vec2",
    "Vec3",
    "Window",
    "Zone",
]
