"""Figures as SceneEval defines them, worked out in another way than `sceneweaver.evaluation` does.

Points, rays and pictures where the library has exact areas: what SceneEval (github.com/3dlg-hcvc/SceneEval, `metrics/`)
says of collision, out of bounds, support, navigability, accessibility and opening clearance, with its numbers
(`configs/metrics.yaml`), written anew for bodies of convex parts. What SceneEval asks a vision model for is taken from
the scene: what holds an object, and from which sides it is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.scene import Scene, SceneObject

Array = NDArray[np.float64]

APART = 0.005
"""How far [m] the second of two objects in collision is moved before it is tried again."""

IN_BOUNDS = 0.99
"""Share of the points of an object that must be over the floor."""

NEAR = 0.01
"""Distance [m] of a hit from where its ray began that is a contact, after the object was lifted by `LIFT`."""

LIFT = 0.005
RESOLUTION = 256
OVERHEAD = 2.0
STRIP, OFFSET = 0.2, 0.05
BEFORE_WINDOW = 0.5

_DOWN = np.array([0.0, 0.0, -1.0])


@dataclass(eq=False)
class Thing:
    """An object: its convex parts as hulls of vertices [n, 3] with triangles [m, 3], in the world."""

    item: SceneObject
    rotation: Array
    position: Array
    parts: list[tuple[Array, NDArray[np.int64]]]

    @property
    def centre(self) -> Array:
        """Middle of its box [m]."""
        return self.position + self.rotation @ np.array([0.0, 0.0, self.item.size[2] / 2])

    @property
    def triangles(self) -> Array:
        """All triangles [m, 3, 3]."""
        return np.concatenate([points[faces] for points, faces in self.parts])

    def corners(self, scale: float = 1.0) -> Array:
        """The corners of its box from above [4, 2]."""
        d, w, _ = self.item.size
        local = np.array([(-d, -w, 0), (d, -w, 0), (d, w, 0), (-d, w, 0)]) / 2 * scale
        return (local @ self.rotation.T + self.centre)[:, :2]


def things_of(scene: Scene) -> list[Thing]:
    """The objects of a scene."""
    return [_thing(item) for item in scene.objects]


def _thing(item: SceneObject) -> Thing:
    x, y, z, w = np.asarray(item.pose.quaternion) / np.linalg.norm(item.pose.quaternion)
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    position = np.asarray(item.pose.position)
    parts = []
    for part in item.solids:
        n = len(part.polygon)
        points = np.array([(*p, z) for z in part.z for p in part.polygon]) @ rotation.T + position
        caps = [(0, k + 1, k) for k in range(1, n - 1)] + [(n, n + k, n + k + 1) for k in range(1, n - 1)]
        sides = [f for k in range(n) for f in ((k, (k + 1) % n, n + k), ((k + 1) % n, n + (k + 1) % n, n + k))]
        parts.append((points, np.array(caps + sides)))
    return Thing(item, rotation, position, parts)


def hits(origins: Array, direction: Array, triangles: Array) -> Array:
    """Distance along a common direction from each origin [n, 3] to the nearest triangle; inf without one."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    e1, e2 = b - a, c - a
    p = np.cross(direction, e2)
    det = np.einsum("md,md->m", e1, p)
    good = np.abs(det) > 1e-12
    if not good.any():
        return np.full(len(origins), np.inf)
    a, e1, e2, p, det = a[good], e1[good], e2[good], p[good], det[good]
    s = origins[:, None, :] - a[None]
    u = np.einsum("nmd,md->nm", s, p) / det
    q = np.cross(s, e1[None])
    v = np.einsum("d,nmd->nm", direction, q) / det
    t = np.einsum("nmd,md->nm", q, e2) / det
    inside = (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (t >= -1e-9)
    return np.where(inside, t, np.inf).min(axis=1)


def sampled(triangles: Array, count: int, random: np.random.Generator) -> Array:
    """Points on a surface [count, 3]."""
    area = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    chosen = triangles[random.choice(len(triangles), count, p=area / area.sum())]
    u, v = random.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return chosen[:, 0] + u * (chosen[:, 1] - chosen[:, 0]) + v * (chosen[:, 2] - chosen[:, 0])


def collisions(things: Sequence[Thing]) -> set[frozenset[str]]:
    """Pairs that still overlap after the second was moved apart by 5 mm, from the middle of what they share."""
    import manifold3d

    solids = [[manifold3d.Manifold.hull_points(points) for points, _ in thing.parts] for thing in things]
    found = set()
    for i, first in enumerate(things):
        for j in range(i + 1, len(things)):
            shared = _shared(solids[i], solids[j])
            if shared is None:
                continue
            way = np.mean(np.concatenate([p for p, _ in things[j].parts]), axis=0) - shared
            way = way / max(float(np.linalg.norm(way)), 1e-12) * APART
            moved = [solid.translate(way.tolist()) for solid in solids[j]]
            if _shared(solids[i], moved) is not None:
                found.add(frozenset((first.item.id, things[j].item.id)))
    return found


def _shared(ones: Sequence[Any], others: Sequence[Any]) -> Array | None:
    """The middle of what two bodies share; None where that is nothing."""
    points = []
    for one in ones:
        for other in others:
            a, b = one.bounding_box(), other.bounding_box()
            if all(a[k] < b[k + 3] and b[k] < a[k + 3] for k in range(3)):
                both = one ^ other
                if both.volume() > 1e-12:  # noqa: PLR2004 - rounding
                    points.append(np.asarray(both.to_mesh().vert_properties)[:, :3])
    return np.concatenate(points).mean(axis=0) if points else None


def out_of_bounds(scene: Scene, things: Sequence[Thing], seed: int = 0, *, deep: bool = True) -> dict[str, float]:
    """Of each object the share of points on its surface that are over the floor: from those below it SceneEval's rays,
    which go down, do not hit it. ``deep=False`` leaves that out, and is about the plan alone."""
    import shapely

    random = np.random.default_rng(seed)
    floor = shapely.buffer(shapely.Polygon(scene.room.outline), 1e-3)  # what touches a wall is in: rays at edges miss
    shapely.prepare(floor)
    found = {}
    for thing in things:
        points = sampled(thing.triangles, 2000, random)
        over = shapely.contains_xy(floor, points[:, 0], points[:, 1])
        found[thing.item.id] = float((over & (points[:, 2] >= -1e-3) if deep else over).mean())
    return found


def supported(scene: Scene, things: Sequence[Thing], seed: int = 0) -> dict[str, bool]:
    """Of each object whether something holds it, by rays from what is lowest of it (or behind it, or on top)."""
    random = np.random.default_rng(seed)
    shell = _shell(scene)
    return {
        thing.item.id: _held(thing, [t.triangles for t in things if t is not thing] + shell, random) for thing in things
    }


def _shell(scene: Scene) -> list[Array]:
    """Triangles of floor, ceiling and walls, each by itself."""
    import shapely

    outline, height = np.asarray(scene.room.outline, dtype=float), scene.room.height
    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(shapely.Polygon(outline)))
    triangles = np.array([shapely.get_coordinates(piece)[:3] for piece in pieces])

    def flat(z: float) -> Array:
        return np.concatenate([triangles, np.full((*triangles.shape[:2], 1), z)], axis=2)

    walls = []
    for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        a, b, c, d = (*p, 0.0), (*q, 0.0), (*q, height), (*p, height)
        walls.append(np.array([[a, b, c], [a, c, d]]))
    return [flat(0.0), flat(height), *walls]


def _held(thing: Thing, targets: Sequence[Array], random: np.random.Generator) -> bool:
    mount = thing.item.mount
    way = {"ceiling": -_DOWN, "wall": -thing.rotation[:, 0]}.get(mount, _DOWN)
    triangles = thing.triangles - LIFT * way
    along = triangles @ way
    far = along.max()
    close = along >= far - NEAR
    origins = [triangles[close]]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    faces = close.all(axis=1) & (np.abs(normals @ way) > 0.9 * sizes) & (sizes > 1e-12)
    if faces.any():
        origins.append(sampled(triangles[faces], 400, random))
    starts = np.concatenate(origins)
    contacts = []
    for target in targets:
        distance = hits(starts, way, target)
        touching = distance < NEAR
        contacts.append(starts[touching] + way * distance[touching, None])
    points = np.concatenate(contacts)
    if mount in ("wall", "ceiling"):
        return len(points) > 0
    return _over(points[:, :2], _middle(thing))


def _middle(thing: Thing) -> Array:
    """The centre of mass of its parts [2]."""
    import manifold3d

    total, moment = 0.0, np.zeros(2)
    for points, _ in thing.parts:
        volume = manifold3d.Manifold.hull_points(points).volume()
        total, moment = total + volume, moment + volume * points[:, :2].mean(axis=0)
    return moment / total


def _over(points: Array, middle: Array) -> bool:
    """Whether a point lies in the hull of others: in no direction all of them are on one side of it."""
    if len(points) < 4:  # noqa: PLR2004 - as SceneEval asks for
        return False
    angles = np.linspace(0.0, 2 * np.pi, 721)
    ways = np.stack([np.cos(angles), np.sin(angles)])
    return bool(((points - middle) @ ways).max(axis=0).min() >= -2e-3)


class Plan(NamedTuple):
    """A picture of the floor: which cells are room [n, n], and the world coordinates of their middles."""

    room: NDArray[np.bool_]
    x: Array
    y: Array
    cell: float

    def inside(self, corners: Array) -> NDArray[np.bool_]:
        """The cells whose middles lie in a polygon."""
        from matplotlib.path import Path as Polygon

        points = np.stack([self.x.ravel(), self.y.ravel()], axis=1)
        return Polygon(corners).contains_points(points).reshape(self.x.shape)


def plan_of(scene: Scene) -> Plan:
    """The picture of a room's floor."""
    outline = np.asarray(scene.room.outline, dtype=float)
    middle = (outline.min(axis=0) + outline.max(axis=0)) / 2
    scale = float(np.abs(outline - middle).max()) + 0.2
    cell = 2 * scale / RESOLUTION
    steps = (np.arange(RESOLUTION) + 0.5) * cell - scale
    x, y = np.meshgrid(middle[0] + steps, middle[1] + steps)
    plan = Plan(np.ones(x.shape, dtype=bool), x, y, cell)
    return plan._replace(room=plan.inside(outline))


def navigability(scene: Scene, things: Sequence[Thing], base: float) -> float:
    """Largest connected area over all area that is free for a square base [m], pixel by pixel; what is walked on or
    begins above 1.8 m is not in its way, and parts are, where SceneEval takes boxes."""
    from scipy.ndimage import binary_dilation, binary_erosion, label

    plan = plan_of(scene)
    width = max(1, int(base / plan.cell))
    base_of = np.ones((width, width), dtype=bool)
    free = binary_erosion(plan.room, base_of)
    for thing in things:
        for points, _ in thing.parts:
            low, high = points[:, 2].min(), points[:, 2].max()
            if low < 1.8 and high > 0.02:  # noqa: PLR2004
                free &= ~binary_dilation(plan.inside(points[: len(points) // 2, :2]), base_of)
    regions, count = label(free, structure=np.ones((3, 3)))
    if not count:
        return 0.0
    sizes = np.bincount(np.asarray(regions).ravel())[1:]
    return float(sizes.max() / sizes.sum())


def accessibility(scene: Scene, things: Sequence[Thing]) -> dict[str, float]:
    """Of each thing on the floor that is used from a side, the share of pixels before it that are free floor."""
    plan = plan_of(scene)
    free = plan.room.copy()
    for thing in things:
        if thing.centre[2] <= OVERHEAD and thing.position[2] + thing.item.size[2] > 0.02:  # noqa: PLR2004
            free &= ~plan.inside(thing.corners())
    found = {}
    for thing in things:
        sides = category_named(thing.item.category).sides
        shares = []
        for name, turn in (("front", 0), ("left", 1), ("back", 2), ("right", 3)):
            if name not in sides or thing.item.mount != "floor":
                continue
            depth, width = (thing.item.size[0], thing.item.size[1])[:: 1 if turn % 2 == 0 else -1]
            near = depth / 2 + OFFSET
            local = np.array(
                [(near, -width / 2), (near + STRIP, -width / 2), (near + STRIP, width / 2), (near, width / 2)]
            )
            quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
            local = local @ np.linalg.matrix_power(quarter, turn).T
            world = local @ thing.rotation[:2, :2].T + thing.centre[:2]
            strip = plan.inside(world)
            whole = width * STRIP / plan.cell**2
            shares.append(float((strip & free).sum() / whole))
        if shares:
            found[thing.item.id] = min(1.0, max(shares))
    return found


def openings_covered(
    scene: Scene, things: Sequence[Thing], leave_out: frozenset[str] = frozenset()
) -> dict[str, float]:
    """Of each door and window the share of its area before which something is, on a grid of points in that space;
    categories in ``leave_out`` do not count."""
    from matplotlib.path import Path as Polygon

    outline = np.asarray(scene.room.outline, dtype=float)
    found = {}
    for opening, sill in (*((d, 0.0) for d in scene.room.doors), *((w, w.sill) for w in scene.room.windows)):
        start, end = outline[opening.wall], outline[(opening.wall + 1) % len(outline)]
        along = (end - start) / np.linalg.norm(end - start)
        inward = np.array([-along[1], along[0]])
        depth = opening.width if sill == 0.0 and opening in scene.room.doors else BEFORE_WINDOW
        u = opening.offset + (np.arange(80) + 0.5) / 80 * opening.width
        v = 0.002 + (np.arange(60) + 0.5) / 60 * (depth - 0.004)
        w = sill + (np.arange(60) + 0.5) / 60 * opening.height
        flat = (start + u[:, None, None] * along + v[None, :, None] * inward).reshape(-1, 2)
        covered = np.zeros((len(u), len(w)), dtype=bool)
        for thing in things:
            for points, _ in thing.parts:
                low, high = points[:, 2].min(), points[:, 2].max()
                if thing.item.category in leave_out or high <= 0.02:  # noqa: PLR2004
                    continue
                in_plan = Polygon(points[: len(points) // 2, :2]).contains_points(flat).reshape(len(u), len(v))
                covered |= in_plan.any(axis=1)[:, None] & ((w >= low) & (w <= high))[None]
        found[opening.id] = float(covered.mean())
    return found
