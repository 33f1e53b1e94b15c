"""The objects of a scene: pose, shape, what holds them, what they are for."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal, Self

from pydantic import Field, model_validator

from sceneweaver.geometry.rotations import from_yaw, yaw_of
from sceneweaver.geometry.se2 import SE2
from sceneweaver.io import InputError
from sceneweaver.io.messages import show

from .base import FrozenModel
from .fields import ConvexPolygon, Flag, Id, Interval, JsonDict, Length, Name, Number, Polygon, Quat, Text, Vec3
from .intent import Intent
from .limits import MAX_PARTS
from .messages import FieldError

QUARTERS = (0.0, 90.0, 180.0, 270.0)
"""Yaws [deg] of the domain "quarter_turns"."""

MAX_YAWS = 72
"""Most angles of a domain of yaw: every 5 degrees."""

YawSet = Annotated[tuple[Number, ...], Field(min_length=1, max_length=MAX_YAWS)]


class Pose(FrozenModel):
    """World position of an object's bottom centre and its rotation as an xyzw quaternion.

    Examples:
        >>> import sceneweaver as sw
        >>> pose = sw.Pose.from_yaw(1.0, 2.0, 0.0, yaw=0.5)
        >>> pose.position, round(pose.yaw, 6)
        ((1.0, 2.0, 0.0), 0.5)
    """

    position: Vec3 = Field(default=(0.0, 0.0, 0.0), description="World position of the bottom centre [m]")
    quaternion: Quat = Field(default=(0.0, 0.0, 0.0, 1.0), description="Rotation as a unit quaternion x, y, z, w")

    @property
    def yaw(self) -> float:
        """Rotation about +z in radians, in (-pi, pi]."""
        return yaw_of(self.quaternion)

    @property
    def frame(self) -> SE2:
        """The pose as seen from above."""
        return SE2(self.position[0], self.position[1], self.yaw)

    @classmethod
    def from_yaw(cls, x: float, y: float, z: float, yaw: float) -> Pose:
        """The upright pose at (x, y, z) turned by ``yaw`` radians; InputError when one of them is not finite."""
        if not math.isfinite(yaw):
            raise InputError(f"pose: yaw is {show(float(yaw))}; numbers must be finite")
        return cls(position=(x, y, z), quaternion=from_yaw(yaw))


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
    """One object of a scene.

    Its origin is the bottom centre of its box and its front is +x at yaw 0. ``size`` is depth, width, height [m];
    polygons of parts, zones and surfaces are counter-clockwise in its own frame. Anything wrong is an `InputError`.

    Examples:
        >>> import sceneweaver as sw
        >>> desk = sw.SceneObject(id="desk", category="desk", size=(0.7, 1.4, 0.74))
        >>> desk.mount, len(desk.solids)
        ('floor', 1)
    """

    _noun: ClassVar[str] = "object"

    id: Id = Field(description="Unique among doors, windows and objects")
    category: Name = Field(description="What it is, such as office chair; any words")
    description: Text | None = Field(default=None, description="What it looks like")
    size: tuple[Length, Length, Length] = Field(description="Depth along the front, width, height [m]")
    pose: Pose = Field(
        default=Pose.model_construct(position=(0.0, 0.0, 0.0), quaternion=(0.0, 0.0, 0.0, 1.0)),
        description="Where it is",
    )
    mount: Literal["floor", "wall", "ceiling", "surface"] = Field(default="floor", description="What holds it")
    support: Support | None = Field(default=None, description="What it stands on; for mount surface, and only there")
    asset: Name | None = Field(default=None, description="Id of its mesh; null: shown as its parts")
    parts: Annotated[tuple[Part, ...], Field(fail_fast=True, max_length=MAX_PARTS)] | None = Field(
        default=None, description="Collision shape as convex prisms; null: its box"
    )
    zones: Annotated[tuple[Zone, ...], Field(fail_fast=True, max_length=MAX_PARTS)] = Field(
        default=(), description="Space to keep free around it"
    )
    surfaces: Annotated[tuple[Surface, ...], Field(fail_fast=True, max_length=MAX_PARTS)] = Field(
        default=(), description="What others may stand on"
    )
    fixed: Flag = Field(default=False, description="Whether it must stay where it is")
    yaw_domain: Literal["quarter_turns"] | YawSet | None = Field(
        default=None,
        description="Yaws that it may have in the frame of the room, or of what carries it: quarter_turns, or a list "
        "of angles [deg]; null: any",
    )
    intent: Intent = Field(default=Intent.model_construct(), description="What it is there for; changes no validity")
    attributes: JsonDict = Field(
        default_factory=dict, description="Free data on how it looks: color, material, style ..."
    )

    @model_validator(mode="after")
    def _check(self) -> Self:
        """Mount and support go together; the surfaces of an object have names of their own."""
        if self.mount == "surface" and self.support is None:
            raise FieldError(
                ("support",), 'is missing, but mount is "surface"; name the object and surface that it stands on'
            )
        if self.mount != "surface" and self.support is not None:
            raise FieldError(
                ("support",), f'is given, but mount is "{self.mount}"; set mount to "surface" or support to null'
            )
        names: set[str] = set()
        for i, surface in enumerate(self.surfaces):
            if surface.name in names:
                raise FieldError(("surfaces", i, "name"), f"{show(surface.name)} is taken; choose another")
            names.add(surface.name)
        return self

    @property
    def yaws(self) -> tuple[float, ...]:
        """The yaws [deg] of its domain, ascending, from 0 to less than 360; none where it may have any."""
        if self.yaw_domain is None:
            return ()
        given = QUARTERS if self.yaw_domain == "quarter_turns" else self.yaw_domain
        return tuple(sorted({angle % 360.0 for angle in given}))

    @property
    def solids(self) -> tuple[Part, ...]:
        """The collision parts; an object without parts is its box."""
        if self.parts:
            return self.parts
        d, w, h = self.size
        box = ((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2))
        return (Part.model_construct(polygon=box, z=(0.0, h)),)


class Dropped(FrozenModel):
    """An object that was asked for and could not be placed.

    Examples:
        >>> import sceneweaver as sw
        >>> sw.Dropped(id="piano-0", category="piano", reason="it is wider than the room").reason
        'it is wider than the room'
    """

    id: Id = Field(description="Id that it would have")
    category: Name = Field(description="What it is")
    reason: Text = Field(description="Why it could not be placed")
