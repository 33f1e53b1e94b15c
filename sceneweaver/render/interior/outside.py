"""What is seen through the windows: a lawn, a hedge, trees; plain shapes, as they are far away in bright light."""

from __future__ import annotations

import zlib
from functools import cache

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room

from ..room_blocks import Builder

GROUND = -0.42
"""Height of the ground outside [m]."""

_LAWN = Material("lawn", (0.36, 0.44, 0.24), roughness=1.0, texture="leaf")
_HEDGE = Material("hedge", (0.22, 0.33, 0.17), roughness=1.0, texture="leaf")
_TREES = tuple(
    Material(f"tree {k}", color, roughness=1.0, texture="leaf")
    for k, color in enumerate(((0.27, 0.39, 0.19), (0.33, 0.43, 0.21), (0.21, 0.33, 0.19), (0.40, 0.45, 0.25)))
)
_TRUNK = Material("trunk", (0.30, 0.25, 0.20), roughness=0.95, texture="wood")
_PAVING = Material("paving", (0.66, 0.64, 0.60), roughness=0.9, texture="stone")

_LAWN_REACH = 45.0


def outside_mesh(room: Room) -> Mesh | None:
    """The world outside of a room's windows; None for a room without any."""
    import shapely

    walls = [room.walls[k] for k in sorted({window.wall for window in room.windows})]
    if not walls:
        return None
    builder = Builder()
    inside = shapely.Polygon(room.outline).buffer(3.0)
    _ground(builder, room)
    for wall in walls:
        rng = np.random.default_rng(zlib.crc32(f"{room.outline} {wall.index}".encode()))
        _hedge(builder, wall, inside, rng)
        for _ in range(9):
            depth = float(rng.uniform(9.0, 26.0))
            at = wall.length / 2 + float(rng.uniform(-0.9, 0.9)) * (depth + 3.0)
            x, y = wall.point(at, -depth)
            if not shapely.contains_xy(inside, x, y):
                _tree(builder, np.array([x, y]), float(rng.uniform(4.0, 8.5)), rng)
    return builder.mesh()


def _ground(builder: Builder, room: Room) -> None:
    """A lawn around the house, and paving close to it."""
    outline = np.asarray(room.outline, dtype=float)
    low, high = outline.min(axis=0), outline.max(axis=0)
    for reach, z, material in ((_LAWN_REACH, GROUND, _LAWN), (1.6, GROUND + 0.01, _PAVING)):
        (a, b), (c, d) = low - reach, high + reach
        corners = np.array([(a, b, z), (c, b, z), (c, d, z), (a, d, z)])
        builder.add(corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), material)


def _hedge(builder: Builder, wall: Wall, inside, rng: np.random.Generator) -> None:
    """A hedge along the wall some metres before it: bumps side by side."""
    import shapely

    depth, reach = 7.5, 14.0
    for at in np.arange(-reach, wall.length + reach, 0.55):
        jitter = rng.uniform(-0.12, 0.12, 3)
        x, y = wall.point(at + jitter[0], -depth + jitter[1])
        if not shapely.contains_xy(inside, x, y):
            size = np.array([0.55, 0.55, 0.85 + jitter[2]])
            _bush(builder, np.array([x, y, GROUND + 0.55]), size, _HEDGE, rng)


def _tree(builder: Builder, place: np.ndarray, height: float, rng: np.random.Generator) -> None:
    """A trunk and a crown of some bushes."""
    leaf = _TREES[int(rng.integers(len(_TREES)))]
    radius = 0.30 * height
    ring = 0.03 * height * np.stack([np.cos(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4)], axis=1)
    builder.prism(place + ring, (GROUND, 0.5 * height), _TRUNK)
    for _ in range(9):
        way = rng.normal(size=3)
        way = way / np.linalg.norm(way) * radius * rng.uniform(0.35, 0.75)
        middle = np.array([*place, 0.64 * height]) + way * (1.0, 1.0, 0.9)
        _bush(builder, middle, np.full(3, radius * rng.uniform(0.45, 0.65)), leaf, rng)


def _bush(builder: Builder, middle: np.ndarray, size: np.ndarray, leaf: Material, rng: np.random.Generator) -> None:
    """An uneven ball of leaves."""
    points, faces = _ball()
    uneven = 1.0 + 0.16 * rng.standard_normal(len(points))
    builder.add(middle + points * uneven[:, None] * size, faces, leaf)


@cache
def _ball() -> tuple[np.ndarray, np.ndarray]:
    """A unit ball of triangles about equally large: points [N, 3], faces [F, 3]."""
    from scipy.spatial import ConvexHull

    count = 80
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, k * np.pi * (1 + 5**0.5)
    points = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], axis=1)
    faces = ConvexHull(points).simplices.astype(np.int32)
    corners = points[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = (normal * corners[:, 0]).sum(axis=1) < 0
    faces[inward] = faces[inward][:, ::-1]
    return points, faces
