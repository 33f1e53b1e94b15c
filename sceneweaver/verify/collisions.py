"""Pairs of objects that collide.

Two objects collide when they penetrate deeper than 1 mm, as the least translation over
pairs of their convex parts, and share more than the smaller of 1e-6 m3 and 1 % of the smaller body. For boxes and
prisms one pair of parts must do both. Where a mesh is known, the depth still comes from the parts (which contain the
mesh), or from the convex hull of a mesh without parts, and the shared volume from the meshes themselves. Two concave
meshes whose hulls overlap only touch when moving one by 1 mm parts them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from sceneweaver.runtime.deadline import checkpoint
from sceneweaver.verify import convex
from sceneweaver.verify.measure import at_most, length
from sceneweaver.verify.meshes import MeshBody, MeshSet, part_points
from sceneweaver.verify.overlap import overlaps
from sceneweaver.verify.report import Violation
from sceneweaver.verify.solids import DEPTH, Array, Body, Placed

SHARED_VOLUME = 1e-6
"""Volume in cubic metres that two bodies may share."""

SHARED_FRACTION = 0.01
"""Fraction of the smaller body that may be shared, where that is less than `SHARED_VOLUME`."""


@dataclass(eq=False)
class Shape:
    """An object whose collisions need more than upright prisms: it is tilted, or a mesh of it is known."""

    body: Body
    mesh: MeshBody | None

    @cached_property
    def pieces(self) -> list[Array]:
        """Vertices of the convex pieces in the world [k, 3]."""
        return [self.body.to_world(p) for p in part_points(self.body.item, self.mesh)]

    @cached_property
    def piece_solids(self) -> list[Any]:
        """The convex pieces as manifolds."""
        return [convex.solid(p) for p in self.pieces]

    @cached_property
    def solid(self) -> Any:
        """The body as one manifold: its closed mesh, else its parts or the hull of its mesh."""
        if self.mesh is not None and self.mesh.solid is not None:
            return self.mesh.solid.transform(np.column_stack([self.body.rotation, self.body.position]))
        return convex.union(self.piece_solids)

    @property
    def volume(self) -> float:
        """Volume of the body [m3]."""
        return self.body.volume if self.mesh is None else float(self.solid.volume())


def volume_limit(a: Any, b: Any) -> Any:
    """Volume [m3] that bodies of volumes ``a`` and ``b`` may share; numbers or arrays."""
    return np.minimum(SHARED_VOLUME, SHARED_FRACTION * np.minimum(a, b))


def find(placed: Placed, meshes: MeshSet, warnings: list[str]) -> list[Violation]:
    """Every colliding pair once, ordered by the objects' places in the scene; what is to say of meshes is appended."""
    shapes = _shapes(placed, meshes)
    plain = np.ones(len(placed.bodies), dtype=bool)
    for index, shape in shapes.items():
        plain[index] = False
        warnings.extend(_notes(shape, meshes))
    found = _prisms(placed, plain, warnings)
    for a, b in _special_pairs(placed, shapes):
        checkpoint()
        depth = _penetration(*(shapes.get(k) or Shape(placed.bodies[k], None) for k in (a, b)))
        if depth > 0.0:
            found[a, b] = depth
    return [_violation(placed.bodies[a].id, placed.bodies[b].id, depth) for (a, b), depth in sorted(found.items())]


def _violation(a: str, b: str, depth: float) -> Violation:
    measured = at_most("depth", depth, 0.0, slack=DEPTH)
    return Violation.of("collision", (a, b), f"{a} sinks {length(depth)} into {b}", measured)


def _shapes(placed: Placed, meshes: MeshSet) -> dict[int, Shape]:
    shapes = {}
    for body in placed.bodies:
        mesh = meshes.get(body.item.asset)
        if mesh is not None or body.tilted:
            shapes[body.index] = Shape(body, mesh)
    return shapes


def _notes(shape: Shape, meshes: MeshSet) -> Iterator[str]:
    """What the report should say about the mesh of ``shape``."""
    if shape.mesh is None:
        return
    item = shape.body.item
    if shape.mesh.solid is None:
        by = "parts" if item.parts else "convex hull"
        yield f"{item.id}: mesh {shape.mesh.asset!r} is not watertight; judged by its {by}"
    if note := meshes.stick_out(item, shape.mesh):
        yield note


def _prisms(placed: Placed, plain: Any, warnings: list[str]) -> dict[tuple[int, int], float]:
    """Collisions among the upright objects without meshes."""
    parts = placed.parts if plain.all() else placed.parts.pick(plain[placed.parts.owner])
    pairs = overlaps(parts, parts)
    if pairs.cut:
        warnings.append(f"over {len(pairs)} pairs of parts overlap; no more of them were counted")
    a, b = parts.owner[pairs.i], parts.owner[pairs.j]
    volumes = np.array([body.volume for body in placed.bodies])
    depth = np.minimum(pairs.depth, pairs.rise)
    found: dict[tuple[int, int], float] = {}
    for k in np.flatnonzero(pairs.area * pairs.rise > volume_limit(volumes[a], volumes[b])):
        key = (int(a[k]), int(b[k]))
        found[key] = max(found.get(key, 0.0), float(depth[k]))
    return found


def _special_pairs(placed: Placed, shapes: dict[int, Shape]) -> list[tuple[int, int]]:
    """Pairs with at least one shape whose bounding boxes in space overlap."""
    if not shapes:
        return []
    low, high = np.empty((len(placed.bodies), 3)), np.empty((len(placed.bodies), 3))
    for body in placed.bodies:
        shape = shapes.get(body.index)
        if shape is None:
            box = placed.parts.boxes[placed.part_rows(body)]
            low[body.index] = (*box[:, :2].min(axis=0), body.z[0])
            high[body.index] = (*box[:, 2:].max(axis=0), body.z[1])
        else:
            points = np.concatenate(shape.pieces)
            low[body.index], high[body.index] = points.min(axis=0), points.max(axis=0)
    pairs = set()
    for k in shapes:
        meet = np.flatnonzero((low < high[k] - DEPTH).all(axis=1) & (high > low[k] + DEPTH).all(axis=1))
        pairs |= {(min(k, int(m)), max(k, int(m))) for m in meet if m != k}
    return sorted(pairs)


def _penetration(a: Shape, b: Shape) -> float:
    """Depth [m] of a pair that collides, 0.0 for one that does not."""
    if a.mesh is None and b.mesh is None:
        return _piecewise(a, b)
    depth = max((convex.depth(p, q) for p in a.pieces for q in b.pieces), default=0.0)
    if depth <= DEPTH:
        return 0.0
    limit = volume_limit(a.volume, b.volume)
    if convex.shared_volume(a.solid, b.solid) <= limit:
        return 0.0
    if all(s.mesh is None or s.body.item.parts for s in (a, b)):
        return depth
    if convex.separable(a.solid, b.solid, DEPTH, limit):
        return 0.0
    return min(depth, max(convex.thickness(a.solid ^ b.solid), DEPTH))


def _piecewise(a: Shape, b: Shape) -> float:
    """Depth [m] of the deepest pair of convex parts that collides, as for upright prisms."""
    limit = volume_limit(a.volume, b.volume)
    deepest = 0.0
    for i, p in enumerate(a.pieces):
        for j, q in enumerate(b.pieces):
            depth = convex.depth(p, q)
            if depth > max(DEPTH, deepest) and convex.shared_volume(a.piece_solids[i], b.piece_solids[j]) > limit:
                deepest = depth
    return deepest
