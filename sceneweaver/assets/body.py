"""What an asset is made of, in plain arrays: materials, the visual mesh, convex hulls, and links that move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

Joint = Literal["hinge", "slide", "free"]

Role = Literal["door", "drawer", "lid", "control", "item"]
"""What a link is for. Controls are knobs, buttons and taps; an item is what can be taken off or out."""


@dataclass(frozen=True)
class Material:
    """A surface finish: sRGB base colour in 0..1, and the usual PBR numbers.

    ``texture`` names a pattern of ``assets.textures`` or a folder of the user's ("plain": none); ``emission`` is the
    share of the base colour that shines by itself; ``opacity`` below 1 is see-through.
    """

    name: str
    color: tuple[float, float, float]
    roughness: float = 0.6
    metallic: float = 0.0
    opacity: float = 1.0
    emission: float = 0.0
    texture: str = "plain"

    def called(self, *names: str) -> bool:
        """Whether its name is one of some."""
        return self.name in names

    @property
    def kind(self) -> str:
        """What it is in whatever colour, the last word of its name: "fabric" of "blue fabric"."""
        return self.name.rpartition(" ")[2]

    @property
    def printed(self) -> bool:
        """Whether its texture has a print in colours of its own."""
        return "#" in self.texture

    def darker(self, than: float) -> bool:
        """Whether the largest channel of its colour is below a value in 0..1."""
        return max(self.color) < than

    def near(self, color: tuple[float, float, float], within: float) -> bool:
        """Whether no channel of its colour is further than that from another colour."""
        return max(abs(a - c) for a, c in zip(color, self.color, strict=True)) <= within


@dataclass(frozen=True)
class Mesh:
    """Triangles with a material each.

    ``vertices`` float64 [V, 3] in metres; ``faces`` int32 [F, 3], counter-clockwise seen from outside;
    ``face_material`` int32 [F] into ``materials``; ``face_link`` int32 [F]: the link that carries the face, 0 is the
    body that stands still. Bodies overlap freely: the mesh is a set of closed pieces, not one surface.
    ``uv`` float32 [F, 3, 2] are texture coordinates of the corners of each face in metres, u along the grain; None:
    nobody has laid them out.
    """

    vertices: np.ndarray
    faces: np.ndarray
    face_material: np.ndarray
    face_link: np.ndarray
    materials: tuple[Material, ...]
    uv: np.ndarray | None = None

    @property
    def bounds(self) -> np.ndarray:
        """Lower and upper corner of the box, [2, 3]."""
        return np.stack([self.vertices.min(axis=0), self.vertices.max(axis=0)])


@dataclass(frozen=True)
class Hull:
    """A convex, watertight collision part: ``vertices`` float64 [V, 3], ``faces`` int32 [F, 3], outward.

    One of a ``handle`` stays a part of its own wherever parts are merged, so that a hand can close around it.
    """

    vertices: np.ndarray
    faces: np.ndarray
    link: int = 0
    handle: bool = False


@dataclass(frozen=True)
class Link:
    """Something that moves: a door, a lid or a knob (hinge), a drawer or a button (slide), or a thing that only lies
    there and can be taken (free); at 0 it is closed.

    ``axis`` is a unit vector and ``anchor`` a point on the hinge's axis, both in the object's frame; ``limits`` are
    in radians or metres. Those of a free one mean nothing. ``category`` is what a free thing is, "apple" say.
    """

    name: str
    joint: Joint
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    anchor: tuple[float, float, float] = (0.0, 0.0, 0.0)
    limits: tuple[float, float] = (0.0, 0.0)
    role: Role = "door"
    category: str = ""


@dataclass(frozen=True)
class Grasp:
    """Where a parallel gripper takes hold, in the object's frame, everything closed.

    ``link`` is the number of the body that it belongs to, ``position`` [m] the middle of what is held; the hand comes
    along the unit vector ``approach`` and its fingers close along ``closing``, which is square to it. ``width`` is how
    thick the thing is between the fingers and ``length`` how long along the third axis [m].
    """

    name: str
    link: int
    position: tuple[float, float, float]
    approach: tuple[float, float, float]
    closing: tuple[float, float, float]
    width: float
    length: float


@dataclass(frozen=True)
class Interior:
    """Room inside that holds things: a box from ``low`` to ``high`` [m] in the object's frame, everything closed.

    ``link`` is the number of the body that carries it (a drawer, say). ``entry`` is a unit vector out through its
    opening: up for a drawer or a mug, to the front for a cupboard. ``oval`` says that only the ellipse in the box's
    plan is free.
    """

    name: str
    link: int
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    entry: tuple[float, float, float] = (0.0, 0.0, 1.0)
    oval: bool = False
