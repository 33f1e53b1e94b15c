"""What an asset is made of, in plain arrays: materials, the visual mesh, convex hulls, and links that move."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np


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
    """A convex, watertight collision part: ``vertices`` float64 [V, 3], ``faces`` int32 [F, 3], outward."""

    vertices: np.ndarray
    faces: np.ndarray
    link: int = 0


@dataclass(frozen=True)
class Link:
    """Something that moves: a door (hinge) or a drawer (slide); at 0 it is closed.

    ``axis`` is a unit vector and ``anchor`` a point on the hinge's axis, both in the object's frame; ``limits`` are
    in radians or metres.
    """

    name: str
    joint: Literal["hinge", "slide"]
    axis: tuple[float, float, float]
    anchor: tuple[float, float, float]
    limits: tuple[float, float]
