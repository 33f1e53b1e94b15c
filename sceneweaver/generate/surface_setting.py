"""One support while things are set on it: the free space of its surfaces, and what stands where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets import Asset
from sceneweaver.geometry.polygons import counter_clockwise
from sceneweaver.geometry.se2 import SE2
from sceneweaver.scene import Pose, SceneObject, Support, Surface

from .surface_bodies import Shelf
from .surface_field import GAP, Array, Field, Piece
from .surface_scene import Frame

FLAT = 0.02
"""Height [m] up to which a thing without a surface, such as a mouse pad, carries others on its top."""


@dataclass
class Standing:
    """Something that was set down: its body and where, in the support's frame [m, rad].

    ``base`` is what it stands on, if not on the support itself; ``slot`` and ``seat`` say what it was meant for, and
    ``top`` is the surface that it gets as others stand on it.
    """

    id: str
    asset: Asset
    surface: Surface
    at: Array
    yaw: float
    base: Standing | None = None
    slot: str = ""
    seat: str | None = None
    top: Surface | None = None

    @property
    def z(self) -> float:
        """Height [m] of its bottom above that of the support."""
        return self.surface.z + (self.base.surface.z if self.base is not None else 0.0)

    def made(self, support: str, frame: Frame) -> SceneObject:
        """The scene object, where ``frame`` is that of the support."""
        held = Support(object=self.base.id if self.base is not None else support, surface=self.surface.name)
        x, y = frame.world(float(self.at[0]), float(self.at[1]))
        pose = Pose.from_yaw(x, y, frame.z + self.z, frame.yaw + self.yaw)
        obj = self.asset.object(self.id, pose=pose, support=held)
        if self.top is None or any(s.name == self.top.name for s in obj.surfaces):
            return obj
        return obj.model_copy(update={"surfaces": (*obj.surfaces, self.top)})

    def carrying(self) -> Surface | None:
        """The surface on which it carries others: its own, or the top of a flat thing."""
        if self.asset.surfaces:
            return max(self.asset.surfaces, key=lambda s: s.z)
        if self.asset.size[2] > FLAT or len(self.asset.parts) != 1:
            return None
        return Surface(name="top", polygon=self.asset.parts[0].polygon, z=self.asset.parts[0].z[1])


class Setting:
    """What stands on one support. ``ground`` gives the free space of a surface before anything is set on it."""

    def __init__(self, support: SceneObject, frame: Frame, shelf: Shelf, ground: Callable[[Surface], Field]):
        self.support, self.frame, self.shelf = support, frame, shelf
        self.standing: list[Standing] = []
        self._ground = ground
        self._fields: dict[tuple[str, str], Field] = {}

    @property
    def objects(self) -> list[SceneObject]:
        """All that was set down, in that order."""
        return [one.made(self.support.id, self.frame) for one in self.standing]

    def field(self, surface: Surface, base: Standing | None = None) -> Field:
        """The free space of a surface of the support, or of a thing that stands on it."""
        key = (base.id if base is not None else "", surface.name)
        if key not in self._fields:
            self._fields[key] = self._ground(surface) if base is None else self._upon(surface, base)
        return self._fields[key]

    def _upon(self, surface: Surface, base: Standing) -> Field:
        ring = SE2(float(base.at[0]), float(base.at[1]), base.yaw).to_world(counter_clockwise(surface.polygon))
        return Field(ring, self.field(base.surface).headroom - surface.z, edge=GAP / 2)

    def piece(self, asset: Asset, yaw: float = 0.0) -> Piece:
        """A body as the free space knows it."""
        return Piece(self.shelf.shape(asset), yaw)

    def put(self, one: Standing) -> Standing:
        """Set a thing down where it was found free."""
        if one.base is not None:
            one.base.top = one.surface
        self.standing.append(one)
        self.field(one.surface, one.base).put(self.piece(one.asset, one.yaw), one.at)
        return one

    def cover(self, surface: Surface) -> float:
        """Area [m2] of the boxes of what stands on a surface of the support."""
        return sum(
            one.asset.size[0] * one.asset.size[1]
            for one in self.standing
            if one.base is None and one.surface.name == surface.name
        )

    def span(self, surface: Surface) -> tuple[Array, Array]:
        """Least and largest x, y [m] of a surface in ``frame``, which may look out of the support's back."""
        ring = np.asarray(surface.polygon, dtype=float)
        ring = -ring if abs(self.frame.yaw - self.support.pose.yaw) > 1.0 else ring
        return ring.min(axis=0), ring.max(axis=0)
