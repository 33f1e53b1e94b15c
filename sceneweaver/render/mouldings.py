"""Solids of the joiner and the plasterer: profiles along a path with mitred corners, plates on a wall, rods, discs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.body import Material
from sceneweaver.geometry.prisms import prism_mesh, ring_faces
from sceneweaver.geometry.walls import Wall

from .blocks import Builder

Points = Sequence[tuple[float, float]] | np.ndarray

_SHARPEST = 0.25
"""1 + cosine of the turn from which on a mitre would be too long: it is cut there."""


@dataclass(frozen=True)
class Plane:
    """A plane in the world with axes ``u``, ``v`` and a height ``w`` over it; unit vectors [3] across each other."""

    origin: np.ndarray
    u: np.ndarray
    v: np.ndarray
    w: np.ndarray

    @classmethod
    def floor(cls) -> Plane:
        """The floor: x, y, and z above it."""
        return cls(np.zeros(3), *np.eye(3))

    @classmethod
    def on_wall(cls, wall: Wall, outside: float | None = None) -> Plane:
        """The inner face of a wall: along it, up, and the depth into the room.

        With ``outside``, the face that lies so many metres out of the room, its height leading away from it.
        """
        along, inward = np.array([*wall.along, 0.0]), np.array([*wall.inward, 0.0])
        start, up = np.array([*wall.start, 0.0]), np.array([0.0, 0.0, 1.0])
        if outside is None:
            return cls(start, along, up, inward)
        return cls(start - outside * inward, along, up, -inward)

    def world(self, points: np.ndarray) -> np.ndarray:
        """The world's points [N, 3] of points (u, v, w)."""
        return self.origin + points @ np.stack([self.u, self.v, self.w])

    def add(self, builder: Builder, points: np.ndarray, faces: np.ndarray, material: Material) -> None:
        """Triangles in these coordinates; faces that are outward in right-handed ones stay so."""
        mirrored = float(np.cross(self.u, self.v) @ self.w) < 0
        builder.add(self.world(points), faces[:, ::-1] if mirrored else faces, material)


def moulding(
    builder: Builder, plane: Plane, path: Points, profile: Points, material: Material, closed: bool = False
) -> None:
    """A profile along a path in a plane.

    Args:
        builder: Takes the triangles.
        plane: Where path and profile are.
        path: Its points (u, v) [N, 2] in metres; corners are mitred.
        profile: A polygon (to the left of the path, above the plane) [M, 2], counter-clockwise; convex if the path
            is open.
        material: What it is of.
        closed: Whether the path ends where it begins.
    """
    points, shape = np.asarray(path, dtype=float), np.asarray(profile, dtype=float)
    ways = np.diff(points, axis=0, append=points[:1] if closed else points[-1:])
    ways = ways if closed else ways[:-1]
    ways = ways / np.linalg.norm(ways, axis=1, keepdims=True)
    left = np.stack([-ways[:, 1], ways[:, 0]], axis=1)
    before = np.concatenate([left[-1:] if closed else left[:1], left])[: len(points)]
    after = left if closed else np.concatenate([left, left[-1:]])
    share = np.maximum(1 + (before * after).sum(axis=1, keepdims=True), _SHARPEST)
    aside = (before + after) / share
    n, m = len(points), len(shape)
    rings = np.empty((n, m, 3))
    rings[:, :, :2] = points[:, None] + shape[None, :, :1] * aside[:, None]
    rings[:, :, 2] = shape[:, 1]
    faces = [ring_faces(k * m, (k + 1) % n * m, m) for k in range(n if closed else n - 1)]
    if not closed:
        fan = np.array([(0, k, k + 1) for k in range(1, m - 1)], dtype=np.int32)
        faces += [fan[:, ::-1], fan + (n - 1) * m]
    plane.add(builder, rings.reshape(-1, 3), np.concatenate(faces), material)


def plate(
    builder: Builder, plane: Plane, outline: Points, depth: tuple[float, float], material: Material, bevel: float = 0.0
) -> None:
    """A convex plate over a plane: its counter-clockwise ``outline`` (u, v) between two heights [m].

    ``bevel`` [m] is how much its upper edge is broken.
    """
    shape = np.asarray(outline, dtype=float)
    if bevel <= 0:
        plane.add(builder, *prism_mesh(shape, depth), material)
        return
    middle = shape.mean(axis=0)
    size = (shape.max(axis=0) - shape.min(axis=0)) / 2
    inner = middle + (shape - middle) * np.maximum(0.0, 1 - bevel / np.maximum(size, 1e-9))
    n = len(shape)
    rings = ((shape, depth[0]), (shape, depth[1] - bevel), (inner, depth[1]))
    points = np.concatenate([np.column_stack([ring, np.full(n, level)]) for ring, level in rings])
    fan = np.array([(0, k, k + 1) for k in range(1, n - 1)], dtype=np.int32)
    faces = np.concatenate([fan[:, ::-1], fan + 2 * n, ring_faces(0, n, n), ring_faces(n, 2 * n, n)])
    plane.add(builder, points, faces, material)


def rectangle(u: tuple[float, float], v: tuple[float, float]) -> np.ndarray:
    """The corners [4, 2] of a rectangle, counter-clockwise."""
    return np.array([(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])])


def disc(middle: tuple[float, float], radius: float, sides: int = 20) -> np.ndarray:
    """The corners [sides, 2] of a regular polygon, counter-clockwise."""
    angle = np.arange(sides) * math.tau / sides
    return np.asarray(middle) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def rod(builder: Builder, plane: Plane, ends: Sequence[Sequence[float]], radius: float, material: Material) -> None:
    """A round rod between two points (u, v, w)."""
    a, b = (np.asarray(end, dtype=float) for end in ends)
    way = (b - a) / np.linalg.norm(b - a)
    aside = np.cross(way, (0.0, 0.0, 1.0) if abs(way[2]) < 0.9 else (1.0, 0.0, 0.0))
    aside /= np.linalg.norm(aside)
    across = np.cross(way, aside)
    ring = disc((0.0, 0.0), radius, 14)
    around = ring[:, :1] * aside + ring[:, 1:] * across
    n = len(ring)
    fan = np.array([(0, k, k + 1) for k in range(1, n - 1)], dtype=np.int32)
    faces = np.concatenate([fan[:, ::-1], fan + n, ring_faces(0, n, n)])
    plane.add(builder, np.concatenate([a + around, b + around]), faces, material)
