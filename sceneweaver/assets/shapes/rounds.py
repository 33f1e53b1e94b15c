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
    return [hull(lathe(stretch, segments)[0]) for stretch in _bulges(profile)]


def hollow_hulls(
    outer: list[tuple[float, float]], inner: list[tuple[float, float]], segments: int = 24, staves: int = 8
) -> list[Shape]:
    """Convex parts of a lathed body that is open above: solid ones up to its floor inside, staves in a ring over it.

    ``outer`` rises to the rim, ``inner`` falls from it to the floor; each is (radius, z).
    """
    floor = inner[-1][1]
    levels, radii = [z for _, z in inner[::-1]], [r for r, _ in inner[::-1]]
    ends = np.linspace(0, segments, staves + 1).round().astype(int)
    hulls = []
    for stretch in _bulges(outer):
        low, high = stretch[0][1], stretch[-1][1]
        if low < floor:
            hulls.append(hull(lathe(_between(stretch, low, min(high, floor)), segments)[0]))
        if high <= floor + 1e-6:
            continue
        low = max(low, floor)
        own = [z for z in levels if low < z < high]
        inside = [(float(np.interp(z, levels, radii)), z) for z in (low, *own, high)]
        rings = [_ring(r / np.cos(np.pi / segments), z, segments) for r, z in _between(stretch, low, high) + inside]
        for a, b in zip(ends[:-1], ends[1:], strict=True):
            index = np.arange(a, b + 1) % segments
            hulls.append(hull(np.concatenate([ring[index] for ring in rings])))
    return hulls


def _bulges(profile: list[tuple[float, float]]) -> list[list[tuple[float, float]]]:
    """A rising profile cut at its waists, so that each stretch bulges outward; flat ones are left out."""
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
    return [s for s in stretches if len(s) >= 2 and s[-1][1] - s[0][1] > 1e-6]


def _between(stretch: list[tuple[float, float]], low: float, high: float) -> list[tuple[float, float]]:
    """A stretch of a rising profile from one height to another."""
    if low <= stretch[0][1] and high >= stretch[-1][1]:
        return stretch
    radii, levels = [r for r, _ in stretch], [z for _, z in stretch]
    ends = [(float(np.interp(z, levels, radii)), z) for z in (low, high)]
    return [ends[0], *[p for p in stretch if low < p[1] < high], ends[1]]


def ball(
    radii: tuple[float, float, float], center: tuple[float, float, float] = (0, 0, 0), segments: int = 20
) -> Shape:
    """An ellipsoid with half axes ``radii``."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, segments // 2 + 1)
    profile = [(float(np.cos(a)) if abs(a) < np.pi / 2 - 1e-9 else 0.0, float(np.sin(a))) for a in angle]
    vertices, faces = lathe(profile, segments)
    vertices /= np.abs(vertices).max(axis=0)  # it fills its box exactly
    return vertices * np.asarray(radii) + np.asarray(center), faces
