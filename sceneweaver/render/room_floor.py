"""Floors as they are laid: planks in rows, tiles and slabs with joints, carpet and concrete in one piece."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_vertices, ring_faces
from sceneweaver.geometry.shell import FLOOR_THICKNESS
from sceneweaver.geometry.walls import Wall, walls_of

from .room_blocks import Builder

_JOINT_DEPTH = 0.004
_SIDE = Material("slab side", (0.70, 0.68, 0.65), roughness=0.9)
_WOOD = (
    (0.745, 0.575, 0.405),
    (0.715, 0.545, 0.380),
    (0.765, 0.600, 0.432),
    (0.690, 0.525, 0.365),
    (0.735, 0.560, 0.388),
    (0.755, 0.590, 0.420),
)
_TILE = ((0.795, 0.775, 0.745), (0.775, 0.757, 0.728), (0.810, 0.790, 0.760))
_STONE = ((0.70, 0.685, 0.655), (0.675, 0.66, 0.63), (0.725, 0.71, 0.68), (0.69, 0.672, 0.64))

_TONES = {"wood": _WOOD, "tile": _TILE, "stone": _STONE}
_JOINTS = {"wood": (0.40, 0.29, 0.19), "tile": (0.60, 0.58, 0.55), "stone": (0.46, 0.44, 0.41)}
_GAPS = {"wood": 0.0024, "tile": 0.004, "stone": 0.004}


def floor_mesh(kind: str, plan: np.ndarray, under: np.ndarray, seed: int = 0, pixel: float = 0.0) -> Mesh:
    """The floor with its top at z = 0.

    Args:
        kind: One of ``room_finish.FLOORS``.
        plan: What is covered [N, 2], a simple polygon [m].
        under: The outer outline of slab and walls [M, 2].
        seed: Which tones the planks or tiles get.
        pixel: Size of a pixel on the floor [m]: joints thinner than that are drawn wider and paler, as they would
            look from afar, so that they do not break up into dashes.
    """
    builder = Builder()
    gap, joint = _GAPS.get(kind, 0.0), _SIDE
    if gap:
        wide = max(gap, min(1.1 * pixel, 0.02))
        tone = (1 - gap / wide) * np.asarray(_TONES[kind][0]) + gap / wide * np.asarray(_JOINTS[kind])
        gap, joint = wide, Material("joint", (float(tone[0]), float(tone[1]), float(tone[2])), roughness=0.9)
    _sheet(builder, under, -_JOINT_DEPTH, -FLOOR_THICKNESS, joint, _SIDE)
    rng = np.random.default_rng(seed)
    if kind == "wood":
        tones = [Material(f"plank {k}", c, roughness=0.48, texture="wood") for k, c in enumerate(_WOOD)]
        _laid(builder, plan, _planks(plan, rng, gap), tones, rng)
    elif kind == "tile":
        tones = [Material(f"tile {k}", c, roughness=0.32) for k, c in enumerate(_TILE)]
        _laid(builder, plan, _grid(plan, 0.45, 0.45, gap), tones, rng)
    elif kind == "stone":
        tones = [Material(f"slab {k}", c, roughness=0.4, texture="stone") for k, c in enumerate(_STONE)]
        _laid(builder, plan, _grid(plan, 0.9, 0.6, gap, shift=0.5), tones, rng)
    else:
        look = {
            "carpet": Material("carpet", (0.565, 0.575, 0.59), roughness=0.98, texture="fabric"),
            "concrete": Material("concrete", (0.69, 0.685, 0.67), roughness=0.6, texture="stone"),
        }[kind]
        _flat(builder, [plan], look)
    mesh = builder.mesh()
    assert mesh is not None
    return mesh


def _sheet(builder: Builder, plan: np.ndarray, top: float, bottom: float, lid: Material, side: Material) -> None:
    triangles = _triangulated([plan])
    n = len(plan)
    vertices = prism_vertices(plan, (bottom, top))
    builder.add(vertices, np.concatenate([triangles[:, ::-1], ring_faces(0, n, n)]), side)
    builder.add(vertices, triangles + n, lid)


def _flat(builder: Builder, rings: Sequence[np.ndarray], material: Material) -> None:
    points = np.concatenate(rings)
    builder.add(np.column_stack([points, np.zeros(len(points))]), _triangulated(rings), material)


def _laid(
    builder: Builder,
    plan: np.ndarray,
    cells: Iterator[np.ndarray],
    tones: Sequence[Material],
    rng: np.random.Generator,
) -> None:
    """Cells [4, 2] cut to the plan, each in one of the tones."""
    import shapely

    whole = shapely.Polygon(plan)
    shapely.prepare(whole)
    for cell in cells:
        piece = shapely.Polygon(cell)
        tone = tones[int(rng.integers(len(tones)))]
        if shapely.contains_properly(whole, piece):
            builder.add(np.column_stack([cell, np.zeros(len(cell))]), np.array([[0, 1, 2], [0, 2, 3]]), tone)
        elif shapely.intersects(whole, piece):
            for part in shapely.get_parts(shapely.intersection(whole, piece)):
                if part.geom_type == "Polygon" and part.area > 1e-6:
                    ring = np.asarray(shapely.orient_polygons(part).exterior.coords)[:-1]
                    _flat(builder, [ring], tone)


def _planks(plan: np.ndarray, rng: np.random.Generator, gap: float) -> Iterator[np.ndarray]:
    """Planks along the longest edge of the plan, their ends shifted from row to row."""
    longest, low, high = _frame(plan)
    width = 0.17
    for k in range(int(np.ceil((high[1] - low[1]) / width))):
        y = low[1] + k * width
        x = low[0] - float(rng.uniform(0.0, 1.6))
        while x < high[0]:
            length = float(rng.uniform(1.3, 2.2))
            yield np.array(longest.strip(x, length - gap, y, y + width - gap))
            x += length


def _grid(plan: np.ndarray, length: float, width: float, gap: float, shift: float = 0.0) -> Iterator[np.ndarray]:
    longest, low, high = _frame(plan)
    for row in range(int(np.ceil((high[1] - low[1]) / width))):
        y = low[1] + row * width
        x = low[0] - (shift * length if row % 2 else 0.0)
        while x < high[0]:
            yield np.array(longest.strip(x, length - gap, y, y + width - gap))
            x += length


def _frame(plan: np.ndarray) -> tuple[Wall, tuple[float, float], tuple[float, float]]:
    """The longest edge of a plan, and the plan's bounds in that edge's coordinates."""
    longest = max(walls_of(plan), key=lambda wall: round(wall.length, 6))
    u, v = longest.coordinates(plan.T)
    return longest, (float(u.min()), float(v.min())), (float(u.max()), float(v.max()))


def _triangulated(rings: Sequence[np.ndarray]) -> np.ndarray:
    """Triangles [F, 3] of a simple polygon, counter-clockwise."""
    import manifold3d

    return np.asarray(manifold3d.triangulate([np.asarray(ring, dtype=np.float64) for ring in rings]), dtype=np.int32)
