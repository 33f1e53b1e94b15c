"""Round things: frusta, lathed profiles, balls."""

from __future__ import annotations

from functools import cache

import numpy as np

from sceneweaver.geometry.prisms import ring_faces

from .convex import Shape, hull


@cache
def _circle(segments: int) -> tuple[np.ndarray, np.ndarray]:
    # Half a step off the axes, so that flats, not vertices, lie on them: a round top then fits its box exactly.
    angle = (np.arange(segments) + 0.5) * (2 * np.pi / segments)
    return np.cos(angle), np.sin(angle)


def _ring(radius: float, z: float, segments: int) -> np.ndarray:
    ring = np.empty((segments, 3))
    ring[:, 0], ring[:, 1] = (radius * part for part in _circle(segments))
    ring[:, 2] = z
    return ring


def frustum(low: float, high: float, z: tuple[float, float], segments: int = 24, bevel: float = 0.0) -> Shape:
    """A cylinder or cone about z with radius ``low`` at its foot and ``high`` at its head; convex.

    The radii are those of the flats, so that a cylinder of radius r is 2 r wide.
    """
    if bevel > 0:
        b = min(bevel, 0.45 * (z[1] - z[0]), 0.45 * min(low, high)) if min(low, high) > 0 else 0.0
        if b > 0:
            return lathe([(low - b, z[0]), (low, z[0] + b), (high, z[1] - b), (high - b, z[1])], segments)
    return lathe([(low, z[0]), (high, z[1])], segments)


def lathe(profile: list[tuple[float, float]], segments: int = 24) -> Shape:
    """A profile of (radius, z) turned about z; from the axis or a flat foot upward, closed at both ends.

    A profile that runs up outside and down again inside (a bowl, a cup) makes a hollow body with a wall.
    """
    scale = 1.0 / np.cos(np.pi / segments)
    points = [(r * scale, z) for r, z in profile]
    rings = [np.array([[0.0, 0.0, z]]) if r < 1e-9 else _ring(r, z, segments) for r, z in points]
    return np.concatenate(rings), _lathe_faces(tuple(len(ring) for ring in rings), segments).copy()


@cache
def _lathe_faces(sizes: tuple[int, ...], segments: int) -> np.ndarray:
    """The faces of a lathed body by the number of vertices of each ring; not to change."""
    starts = [(sum(sizes[:k]), size) for k, size in enumerate(sizes)]  # first vertex and number of vertices
    faces = []
    for (a, n), (b, m) in zip(starts[:-1], starts[1:], strict=True):
        i = np.arange(segments)
        j = (i + 1) % segments
        if n > 1 and m > 1:
            faces.append(ring_faces(a, b, segments))
        elif m > 1:
            faces.append(np.c_[np.full(segments, a), b + j, b + i])
        elif n > 1:
            faces.append(np.c_[a + i, a + j, np.full(segments, b)])
    fan = np.arange(1, segments - 1)
    if starts[0][1] > 1:
        a = starts[0][0]
        faces.append(np.c_[np.full(segments - 2, a), a + fan + 1, a + fan])
    if starts[-1][1] > 1:
        b = starts[-1][0]
        faces.append(np.c_[np.full(segments - 2, b), b + fan, b + fan + 1])
    return np.concatenate(faces).astype(np.int32)


def lathe_hulls(profile: list[tuple[float, float]], segments: int = 12) -> list[Shape]:
    """Convex parts of a solid lathed body: one frustum for each stretch of the profile that bulges outward.

    The profile must rise from foot to head; fewer ``segments`` than the mesh has still contain it.
    """
    stretches: list[list[tuple[float, float]]] = []
    for point in profile:
        if stretches and len(stretches[-1]) >= 2:
            (r0, z0), (r1, z1) = stretches[-1][-2:]
            turn = (r1 - r0) * (point[1] - z1) - (z1 - z0) * (point[0] - r1)
            if turn < -1e-9:  # the profile turns outward again: a waist
                stretches.append([stretches[-1][-1]])
        elif not stretches:
            stretches.append([])
        stretches[-1].append(point)
    hulls = []
    for stretch in stretches:
        low, high = stretch[0][1], stretch[-1][1]
        if len(stretch) >= 2 and high - low > 1e-6:
            hulls.append(hull(lathe(stretch, segments)[0]))
    return hulls


def ball(
    radii: tuple[float, float, float], center: tuple[float, float, float] = (0, 0, 0), segments: int = 20
) -> Shape:
    """An ellipsoid with half axes ``radii``."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, segments // 2 + 1)
    profile = [(float(np.cos(a)) if abs(a) < np.pi / 2 - 1e-9 else 0.0, float(np.sin(a))) for a in angle]
    vertices, faces = lathe(profile, segments)
    vertices /= np.abs(vertices).max(axis=0)  # it fills its box exactly
    return vertices * np.asarray(radii) + np.asarray(center), faces
