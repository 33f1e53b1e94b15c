"""What a scene is: the typed form of ``scene.json`` (schema ``sceneweaver.scene/1``).

Units are metres and radians, z is up, yaw is counter-clockwise about +z and the front of an object is +x at yaw 0.
An object's origin is the bottom centre of its box; ``size`` is (depth along the front, width, height).
Polygons of parts, zones and surfaces are in the object's frame, counter-clockwise.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field

SCHEMA = "sceneweaver.scene/1"

Vec2 = tuple[float, float]
Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]


class _Model(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Door(_Model):
    """A door in wall ``wall``, starting ``offset`` metres after the wall's first corner."""

    id: str
    wall: int
    offset: float
    width: float
    height: float
    swing: Literal["in-left", "in-right", "out", "slide"] = "in-left"


class Window(_Model):
    """A window in wall ``wall``; ``sill`` is the height of its lower edge."""

    id: str
    wall: int
    offset: float
    width: float
    sill: float
    height: float


class Room(_Model):
    """The room: a simple outline, counter-clockwise; wall i runs from corner i to corner i + 1."""

    type: str = "room"
    outline: tuple[Vec2, ...]
    height: float = 2.7
    doors: tuple[Door, ...] = ()
    windows: tuple[Window, ...] = ()


class Pose(_Model):
    """World position of an object's bottom centre and its rotation as an xyzw quaternion."""

    position: Vec3 = (0.0, 0.0, 0.0)
    quaternion: Quat = (0.0, 0.0, 0.0, 1.0)

    @property
    def yaw(self) -> float:
        """Rotation about +z in radians, in (-pi, pi]."""
        x, y, z, w = self.quaternion
        return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

    @classmethod
    def from_yaw(cls, x: float, y: float, z: float, yaw: float) -> Pose:
        """The upright pose at (x, y, z) turned by ``yaw`` radians."""
        return cls(position=(x, y, z), quaternion=(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))


class Support(_Model):
    """The surface that an object stands on."""

    object: str
    surface: str


class Part(_Model):
    """One convex prism of an object's collision shape: a polygon times a z interval."""

    polygon: tuple[Vec2, ...]
    z: Vec2


class Zone(_Model):
    """Space that should stay free of other objects, such as the swing of a wardrobe door."""

    name: str
    polygon: tuple[Vec2, ...]
    z: Vec2
    hard: bool = True


class Surface(_Model):
    """A horizontal support surface at height ``z`` with ``headroom`` metres of free space (None: no limit)."""

    name: str
    polygon: tuple[Vec2, ...]
    z: float
    headroom: float | None = None


class SceneObject(_Model):
    """One object of a scene."""

    id: str
    category: str
    description: str | None = None
    size: Vec3
    pose: Pose = Pose()
    mount: Literal["floor", "wall", "ceiling", "surface"] = "floor"
    support: Support | None = None
    asset: str | None = None
    parts: tuple[Part, ...] | None = None
    zones: tuple[Zone, ...] = ()
    surfaces: tuple[Surface, ...] = ()
    fixed: bool = False
    attributes: dict[str, Any] = Field(default_factory=dict)

    @property
    def solids(self) -> tuple[Part, ...]:
        """The collision parts; an object without parts is its box."""
        if self.parts:
            return self.parts
        d, w, h = self.size
        box = ((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2))
        return (Part(polygon=box, z=(0.0, h)),)


class Relation(_Model):
    """A spatial relation between ``subject`` and ``target``; the catalogue says what each type means."""

    type: str
    subject: str
    target: str | tuple[str, str] | None = None
    params: dict[str, Any] = Field(default_factory=dict)
    hard: bool = True
    weight: float = 1.0


class Dropped(_Model):
    """An object that was asked for and could not be placed."""

    id: str
    category: str
    reason: str


class Scene(_Model):
    """A whole scene. Immutable: edits return a new scene."""

    schema_: Literal["sceneweaver.scene/1"] = Field(default=SCHEMA, alias="schema")
    id: str
    prompt: str = ""
    room: Room
    objects: tuple[SceneObject, ...] = ()
    relations: tuple[Relation, ...] = ()
    provenance: dict[str, Any] = Field(default_factory=dict)
    dropped: tuple[Dropped, ...] = ()

    @classmethod
    def load(cls, path: str | Path) -> Scene:
        """Read ``scene.json``; raises InputError with one line on anything wrong."""
        raise NotImplementedError

    def save(self, path: str | Path) -> None:
        """Write ``scene.json`` under a temporary name and rename it."""
        raise NotImplementedError
