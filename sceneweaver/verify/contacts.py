"""Side by side: how far one face is from another face or a wall, how much they turn, and how much of them overlaps."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from sceneweaver.geometry.walls import Wall
from sceneweaver.scene.catalogue import CATALOGUE
from sceneweaver.verify.measure import TOLERANCE, Measurement, Measurements, at_least, at_most
from sceneweaver.verify.solids import Body, Face, Point

_WALL = CATALOGUE["against_wall"]


def turn(a: Point, b: Point) -> float:
    """Angle between two directions [deg], 0 to 180."""
    return math.degrees(abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))


def face_measurements(
    face: Face, other: Face, gap: tuple[float, float], degrees: float, overlap: float
) -> Measurements:
    """Measurements of ``face`` opposing ``other``: angle, distance along the other's normal, shared width.

    ``gap`` [m] may be negative (one reaches into the other); ``overlap`` is a share of the narrower face.
    """
    nx, ny = other.normal
    dx, dy = face.centre[0] - other.centre[0], face.centre[1] - other.centre[1]
    along = dy * nx - dx * ny
    shared = min(along + face.half, other.half) - max(along - face.half, -other.half)
    return (
        at_most("turned", turn(face.normal, (-nx, -ny)), degrees, "deg"),
        Measurement("gap", dx * nx + dy * ny, gap[0], gap[1], "m", TOLERANCE),
        at_least("overlap", shared, overlap * 2 * min(face.half, other.half)),
    )


def wall_measurements(face: Face, wall: Wall, most: float, degrees: float, overlap: float) -> Measurements:
    """Measurements of ``face`` against ``wall``: angle, distance 0 to ``most`` [m], the face's width along it."""
    along, gap = wall.coordinates(face.centre)
    shared = min(along + face.half, wall.length) - max(along - face.half, 0.0)
    return (
        at_most("turned", turn(face.normal, (-wall.inward[0], -wall.inward[1])), degrees, "deg"),
        Measurement("gap", gap, 0.0, most, "m", TOLERANCE),
        at_least("along the wall", shared, overlap * 2 * face.half),
    )


def wall_contacts(
    walls: Iterable[Wall],
    body: Body,
    sides: Iterable[str],
    most: float = _WALL.value(None, "gap")[1],
    degrees: float = _WALL.value(None, "degrees"),
    overlap: float = _WALL.value(None, "overlap"),
) -> Iterator[Measurements]:
    """Yield what is measured of each of ``sides`` against each of the walls; defaults are against_wall's."""
    faces = [body.face(side) for side in sides]
    for wall in walls:
        for face in faces:
            yield wall_measurements(face, wall, most, degrees, overlap)
