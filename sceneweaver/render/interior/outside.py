"""What is seen through the windows: a lawn, a hedge, trees and a house behind them, paler the farther they are; or
snow, a city, the sea, a forest, mountains, the stars."""

from __future__ import annotations

import math
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.walls import Wall
from sceneweaver.scene import Room

from ..blocks import Builder

GROUND = -0.42
"""Height of the ground outside [m]."""

Color = tuple[float, float, float]

_BARK = (0.36, 0.33, 0.29)
_PLASTER, _ROOF, _PANE = (0.80, 0.77, 0.71), (0.50, 0.37, 0.32), (0.30, 0.33, 0.36)
_CLEAR = 75.0
"""Distance [m] at which two thirds of a colour are lost in the haze."""


@dataclass(frozen=True)
class _World:
    """What grows and stands outside: colours of ground, paving, leaves and haze, how many trees there are, whether
    there are a hedge and a house, and how high the horizon is [m]."""

    ground: Color = (0.43, 0.46, 0.33)
    paving: Color = (0.66, 0.64, 0.60)
    leaves: tuple[Color, ...] = ((0.30, 0.38, 0.20), (0.36, 0.43, 0.22), (0.27, 0.36, 0.21), (0.42, 0.45, 0.25))
    haze: Color = (0.83, 0.85, 0.84)
    roof: Color = _ROOF
    trees: int = 9
    hedge: bool = True
    house: bool = True
    towers: int = 0
    stars: bool = False
    horizon: float = 7.0
    peaks: float = 2.5

    def shade(self, color: Color, distance: float) -> Material:
        """A matt colour seen through so many metres of hazy air."""
        share = 1 - math.exp(-distance / _CLEAR)
        r, g, b = (round(c + share * (h - c), 2) for c, h in zip(color, self.haze, strict=True))
        return Material(f"outside {r} {g} {b}", (r, g, b), roughness=1.0)


_SNOW, _WHITE = ((0.88, 0.90, 0.93), (0.80, 0.84, 0.88), (0.70, 0.76, 0.78), (0.92, 0.93, 0.95)), (0.93, 0.95, 0.98)
_PINES = ((0.17, 0.26, 0.17), (0.20, 0.30, 0.19), (0.14, 0.23, 0.15), (0.24, 0.32, 0.19))

_WORLDS: Mapping[str, _World] = {
    "garden": _World(),
    "rain": _World(ground=(0.33, 0.36, 0.28), haze=(0.66, 0.69, 0.71)),
    "snow": _World(_WHITE, (0.85, 0.88, 0.92), _SNOW, (0.90, 0.92, 0.95), roof=_WHITE),
    "forest": _World(leaves=_PINES, trees=34, hedge=False, house=False, horizon=12.0),
    "mountains": _World(
        (0.90, 0.92, 0.95),
        (0.8, 0.82, 0.86),
        _PINES,
        (0.86, 0.90, 0.95),
        _WHITE,
        12,
        False,
        False,
        horizon=34.0,
        peaks=22.0,
    ),
    "sea": _World(
        (0.20, 0.42, 0.55),
        (0.82, 0.76, 0.62),
        haze=(0.72, 0.82, 0.88),
        trees=0,
        hedge=False,
        house=False,
        horizon=0.0,
        peaks=0.0,
    ),
    "city": _World((0.36, 0.36, 0.37), haze=(0.70, 0.72, 0.76), trees=0, hedge=False, house=False, towers=26),
    "space": _World(trees=0, hedge=False, house=False, stars=True),
}

_LAWN_REACH = 60.0
_HEDGE = 8.5  # distance [m] of the hedge


def outside_mesh(room: Room) -> Mesh | None:
    """The world outside of a room's windows; None for a room without any."""
    import shapely

    walls = [room.walls[k] for k in sorted({window.wall for window in room.windows})]
    if not walls:
        return None
    light = room.light
    world = _WORLDS[light.outside if light is not None else "garden"]
    builder = Builder()
    if world.stars:
        _stars(builder, room)
        return builder.mesh()
    house = shapely.Polygon(room.outline).buffer(3.0)  # nothing grows where the room itself is
    _ground(builder, room, world)
    _horizon(builder, room, world)
    for wall in walls:
        rng = np.random.default_rng(zlib.crc32(f"{room.outline} {wall.index}".encode()))
        for at in np.arange(-13.0 if world.hedge else wall.length + 13.0, wall.length + 13.0, 0.45):
            place = np.array(wall.point(at, -_HEDGE + 0.12 * float(rng.standard_normal())))
            if not shapely.contains_xy(house, *place):
                half = np.array([0.5, 0.5, 0.72 + 0.12 * float(rng.standard_normal())])
                _foliage(
                    builder, np.array([*place, GROUND + 0.6]), half, 50, 0.13, world.shade(world.leaves[0], _HEDGE), rng
                )
        if world.house:
            _house(builder, wall, world, rng)
        for depth in np.sort(rng.uniform(14.0, 70.0, world.towers)):
            _tower(builder, wall, float(depth), world, light is not None and light.daylight == "night", rng)
        for depth in np.sort(rng.uniform(12.0 if world.trees < 12 else 6.0, 28.0, world.trees)):
            place = np.array(wall.point(wall.length / 2 + float(rng.uniform(-0.8, 0.8)) * (depth + 2.0), -float(depth)))
            height = float(rng.uniform(4.5, 8.0))
            if not shapely.contains_xy(house, *place):
                _tree(builder, place, height, world, float(depth), rng)
    return builder.mesh()


def _ground(builder: Builder, room: Room, world: _World) -> None:
    """A lawn around the house, and paving close to it."""
    outline = np.asarray(room.outline, dtype=float)
    low, high = outline.min(axis=0), outline.max(axis=0)
    for reach, z, color in ((_LAWN_REACH, GROUND, world.ground), (1.6, GROUND + 0.01, world.paving)):
        (a, b), (c, d) = low - reach, high + reach
        corners = np.array([(a, b, z), (c, b, z), (c, d, z), (a, d, z)])
        builder.add(corners, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32), world.shade(color, 6.0))


def _horizon(builder: Builder, room: Room, world: _World) -> None:
    """Fields and woods around everything, far away."""
    x, y = np.mean(room.outline, axis=0)
    angle = np.arange(96) * math.tau / 96
    way = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    wave = sum(np.sin(k * angle + 1.7 * k * k) / k for k in (3, 5, 8, 13, 21))
    after = np.roll(np.arange(96), -1)
    for near, far, color in (
        (0.9 * _LAWN_REACH, 110.0, world.ground),
        (110.0, 190.0, world.leaves[3] if world.trees else world.ground),
    ):
        low, high = (np.column_stack([(x, y) + radius * way, np.full(96, GROUND - 0.02)]) for radius in (near, far))
        _band(builder, low, high, after, world.shade(color, near))
    edge = (x, y) + 190.0 * way
    low, high = (np.column_stack([edge, z]) for z in (np.full(96, GROUND - 0.1), world.horizon + world.peaks * wave))
    _band(builder, low, high, after, world.shade(world.leaves[0] if world.peaks < 10 else (0.55, 0.60, 0.68), 100.0))


def _band(builder: Builder, low: np.ndarray, high: np.ndarray, after: np.ndarray, material: Material) -> None:
    """The faces between two closed rings of points [N, 3]; ``after`` is the number of the next point of each."""
    n = len(low)
    at = np.arange(n)
    faces = np.concatenate([np.stack([at, after, after + n], axis=1), np.stack([at, after + n, at + n], axis=1)])
    builder.add(np.concatenate([low, high]), faces.astype(np.int32), material)


def _house(builder: Builder, wall: Wall, world: _World, rng: np.random.Generator) -> None:
    """A house with a pitched roof, far behind the trees."""
    depth, wide, deep, eaves, ridge = 34.0, 11.0, 8.0, 5.2, 8.4
    at = wall.length / 2 + float(rng.uniform(-14.0, 14.0))
    builder.prism(
        np.array(wall.strip(at - wide / 2, wide, -depth - deep, -depth)), (GROUND, eaves), world.shade(_PLASTER, depth)
    )
    for k in range(4):
        for low in (0.5, 3.0):
            pane = wall.strip(at - wide / 2 + 1.2 + 2.5 * k, 1.1, -depth, -depth + 0.05)
            builder.prism(np.array(pane), (low, low + 1.3), world.shade(_PANE, depth))
    across = (-depth + 0.5, -depth - deep / 2, -depth - deep - 0.5)
    points = [
        (*wall.point(at + side * (wide / 2 + 0.4), d), z)
        for side in (-1, 1)
        for d, z in zip(across, (eaves - 0.3, ridge, eaves - 0.3), strict=True)
    ]
    faces = np.array([(0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (0, 1, 2), (3, 5, 4)], dtype=np.int32)
    builder.add(np.array(points), faces, world.shade(world.roof, depth))


def _tower(builder: Builder, wall: Wall, depth: float, world: _World, lit: bool, rng: np.random.Generator) -> None:
    """A block of a city with rows of windows, lit at night."""
    wide, high = float(rng.uniform(6.0, 13.0)), float(rng.uniform(9.0, 42.0))
    at = wall.length / 2 + float(rng.uniform(-1.1, 1.1)) * (depth + 4.0)
    grey = float(rng.uniform(0.42, 0.7))
    body = world.shade((grey, grey * 0.98, grey * 0.95), depth)
    builder.prism(np.array(wall.strip(at - wide / 2, wide, -depth - 9.0, -depth)), (GROUND - 14.0, high - 14.0), body)
    glow = Material("lit pane", (1.0, 0.82, 0.5), roughness=1.0, emission=0.25)
    for k in range(int(wide / 1.9)):
        for z in np.arange(GROUND - 12.0, high - 16.0, 3.1):
            if lit and rng.random() < 0.45:
                continue
            pane = np.array(wall.strip(at - wide / 2 + 0.5 + 1.9 * k, 1.2, -depth, -depth + 0.06))
            builder.prism(pane, (float(z), float(z) + 1.6), glow if lit else world.shade(_PANE, depth))


def _stars(builder: Builder, room: Room) -> None:
    """Stars all around, and a planet before each wall with windows."""
    rng = np.random.default_rng(7)
    x, y = np.mean(room.outline, axis=0)
    star = Material("star", (1.0, 1.0, 1.0), roughness=1.0, emission=0.29)
    ways = rng.normal(size=(900, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    for way in ways:
        middle = np.array([x, y, 1.5]) + 160.0 * way
        side = np.cross(way, (0.0, 0.0, 1.0))
        side *= float(rng.uniform(0.12, 0.5)) / max(float(np.linalg.norm(side)), 1e-6)
        up = np.cross(side, way)
        corners = np.stack([middle - side, middle + up, middle + side, middle - up])
        builder.add(corners, np.array([[0, 1, 2], [0, 2, 3], [0, 2, 1], [0, 3, 2]], dtype=np.int32), star)
    planet = Material("planet", (0.22, 0.42, 0.66), roughness=1.0, emission=0.2)
    points, faces = _ball()
    for k in sorted({window.wall for window in room.windows}):
        wall = room.walls[k]
        where = np.array([*wall.point(wall.length / 2 + 20.0, -90.0), 14.0])
        builder.add(where + 26.0 * points, faces, planet)


def _tree(
    builder: Builder,
    place: np.ndarray,
    height: float,
    world: _World,
    distance: float,
    rng: np.random.Generator,
) -> None:
    """A trunk, and a crown of some clouds of leaves."""
    ring = 0.016 * height * np.stack([np.cos(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4)], axis=1)
    builder.prism(place + ring, (GROUND, 0.5 * height), world.shade(_BARK, distance))
    radius, leaf = 0.27 * height, world.shade(world.leaves[int(rng.integers(len(world.leaves)))], distance)
    for _ in range(9):
        way = rng.normal(size=3)
        way = way / np.linalg.norm(way) * radius * float(rng.uniform(0.3, 1.0))
        middle = np.array([*place, 0.58 * height]) + way * (1.0, 1.0, 1.25)
        _foliage(
            builder, middle, np.full(3, radius * float(rng.uniform(0.35, 0.6))), 110, 0.06 * radius + 0.06, leaf, rng
        )


def _foliage(
    builder: Builder,
    middle: np.ndarray,
    half: np.ndarray,
    count: int,
    size: float,
    leaf: Material,
    rng: np.random.Generator,
) -> None:
    """Leaves all ways around a body that lets no light through.

    Args:
        builder: Takes the triangles.
        middle: Of the cloud [3] in metres.
        half: Half its extents [3] in metres.
        count: Of leaves, or rather of twigs full of them.
        size: Half the length of one [m].
        leaf: Its material.
        rng: Where they are.
    """
    points, faces = _ball()
    builder.add(middle + points * half * 0.74, faces, leaf)
    ways = rng.normal(size=(count, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    at = middle + ways * half * rng.uniform(0.75, 1.08, (count, 1))
    a, b = rng.normal(size=(2, count, 3))
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b -= (a * b).sum(axis=1, keepdims=True) * a
    b /= np.linalg.norm(b, axis=1, keepdims=True)
    scale = size * rng.uniform(0.6, 1.3, (count, 1))
    corners = np.stack([at - a * scale, at + b * scale * 0.6, at + a * scale, at - b * scale * 0.6], axis=1)
    start = 4 * np.arange(count, dtype=np.int32)[:, None]
    builder.add(corners.reshape(-1, 3), np.concatenate([start + (0, 1, 2), start + (0, 2, 3)]), leaf)


@cache
def _ball() -> tuple[np.ndarray, np.ndarray]:
    """A unit ball of triangles about equally large: points [N, 3], faces [F, 3]."""
    from scipy.spatial import ConvexHull

    count = 60
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, k * np.pi * (1 + 5**0.5)
    points = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], axis=1)
    faces = ConvexHull(points).simplices.astype(np.int32)
    corners = points[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = (normal * corners[:, 0]).sum(axis=1) < 0
    faces[inward] = faces[inward][:, ::-1]
    return points, faces
