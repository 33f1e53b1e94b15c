"""Floors as they are laid: planks in rows, tiles and slabs with joints, carpet and concrete in one piece."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from sceneweaver.assets.body import Material, Mesh
from sceneweaver.geometry.prisms import prism_vertices, ring_faces
from sceneweaver.geometry.shell import FLOOR_THICKNESS
from sceneweaver.geometry.walls import Wall, walls_of

from .room_blocks import Builder

_JOINT_DEPTH = 0.004
_SIDE = Material("slab side", (0.70, 0.68, 0.65), roughness=0.9)
_SHADES = {
    "wood": (1.01, 0.97, 1.045, 0.93, 0.99, 1.03),
    "tile": (1.0, 0.978, 1.018),
    "stone": (1.0, 0.965, 1.03, 0.985),
}
"""How much lighter or darker single planks, tiles and slabs are."""
_JOINTS = {"wood": 0.52, "tile": 0.77, "stone": 0.65}
"""Joints, as shares of the tone."""
_SURFACES = {"wood": "oak", "tile": "glaze", "stone": "limestone"}
"""The pattern of single planks, tiles and slabs."""
_GAPS = {"wood": 0.0024, "tile": 0.004, "stone": 0.004}


def floor_mesh(
    kind: str, look: Material, plan: np.ndarray, under: np.ndarray, seed: int = 0, pixel: float = 0.0
) -> Mesh:
    """The floor with its top at z = 0.

    Args:
        kind: One of ``room_looks.FLOORS``.
        look: Its material; planks, tiles and slabs are a little lighter or darker, each.
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
        share = 1 - (1 - _JOINTS[kind]) * gap / wide
        gap, joint = wide, replace(_times(look, share), name="joint", roughness=0.9, texture="plain")
    _sheet(builder, under, -_JOINT_DEPTH, -FLOOR_THICKNESS, joint, _SIDE)
    rng = np.random.default_rng(seed)
    if kind in _SHADES:
        one = replace(look, texture=_SURFACES[kind])
        tones = [replace(_times(one, share), name=f"{look.name} {k}") for k, share in enumerate(_SHADES[kind])]
        cells = {
            "wood": lambda: _planks(plan, rng, gap),
            "tile": lambda: _grid(plan, 0.45, 0.45, gap),
            "stone": lambda: _grid(plan, 0.9, 0.6, gap, shift=0.5),
        }[kind]()
        _laid(builder, plan, cells, tones, rng)
    else:
        _flat(builder, [plan], look)
    mesh = builder.mesh()
    assert mesh is not None
    return mesh


def _times(look: Material, share: float) -> Material:
    """The material lighter (above 1) or darker."""
    r, g, b = (min(0.97, c * share) for c in look.color)
    return replace(look, color=(r, g, b))


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
