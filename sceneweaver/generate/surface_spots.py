"""Free spots on the surfaces of furniture."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Mapping, Sequence

from sceneweaver.geometry.polygons import union
from sceneweaver.scene import Pose, Room, SceneObject, Support, Surface

from .carry import carried, local, world

GAP = 0.01
"""Gap [m] that is left between things on a surface, and to its edge."""

LIFT = 0.005
"""Height [m] that is left under a board."""

GLASS = 0.3
"""Depth [m] before a window that stays free above its sill."""

FINEST = 22
"""Places tried along each side of a surface."""


def spot_on(
    objects: Mapping[str, SceneObject], room: Room, supports: Sequence[str], size: tuple[float, float, float], seed: int
) -> tuple[Support, Pose] | None:
    """A free place for a box of that size (depth, width, height) [m].

    Supports are tried as they come, of each its roomiest surface first. Returns what it stands on and its world pose,
    or None when it fits nowhere.
    """
    for id in supports:
        carrier = objects[id]
        for surface in sorted(carrier.surfaces, key=_room_on, reverse=True):
            pose = free_spot(objects, room, carrier, surface, size, seed)
            if pose is not None:
                return Support(object=id, surface=surface.name), pose
    return None


def fits_on(surface: Surface, size: tuple[float, float, float]) -> bool:
    """Whether an empty surface could carry a box of that size (depth, width, height) [m], as far as its bounds say."""
    if surface.headroom is not None and surface.headroom < size[2] + LIFT:
        return False
    xs, ys = [p[0] for p in surface.polygon], [p[1] for p in surface.polygon]
    room = sorted((max(xs) - min(xs), max(ys) - min(ys)))
    own = sorted(size[:2])
    return room[0] >= own[0] and room[1] >= own[1]


def free_spot(
    objects: Mapping[str, SceneObject],
    room: Room,
    carrier: SceneObject,
    surface: Surface,
    size: tuple[float, float, float],
    seed: int,
) -> Pose | None:
    """A place on one surface where a box touches nothing; facing as the carrier does, else turned by a quarter."""
    import numpy as np
    import shapely

    if not fits_on(surface, size):
        return None
    ground = shapely.Polygon(surface.polygon).buffer(-GAP / 2)
    taken = _taken(objects, room, carrier, surface, size[2])
    shapely.prepare(ground)
    rng = random.Random(f"{seed} {carrier.id} {surface.name}")
    for yaw in (0.0, math.pi / 2):
        d, w = (size[0], size[1]) if yaw == 0.0 else (size[1], size[0])
        if ground.is_empty:
            return None
        x0, y0, x1, y1 = ground.bounds
        if x1 - x0 < d or y1 - y0 < w:
            continue
        xs = np.linspace(x0 + d / 2, x1 - d / 2, FINEST)
        ys = np.linspace(y0 + w / 2, y1 - w / 2, FINEST)
        x, y = (a.ravel() for a in np.meshgrid(xs, ys, indexing="ij"))
        boxes = shapely.box(x - d / 2, y - w / 2, x + d / 2, y + w / 2)
        free = shapely.contains_properly(ground, boxes) | shapely.covers(ground, boxes)
        free &= shapely.distance(taken, boxes) >= GAP if not taken.is_empty else True
        at = np.flatnonzero(free)
        if len(at):
            # What is added singly stands toward the back, off the place of who sits at the front.
            cost = [float(x[k] - x0) / max(d, x1 - x0) + 0.8 * rng.random() for k in at]
            best = int(at[int(np.argmin(cost))])
            return world(carrier.pose, float(x[best]), float(y[best]), surface.z, yaw)
    return None


def has_place(carrier: SceneObject) -> bool:
    """Whether an object has a place in the room already; one at the very origin waits for the engine to give it one."""
    return carrier.pose.position[:2] != (0.0, 0.0) or carrier.pose.yaw != 0.0


def _room_on(surface: Surface) -> float:
    import shapely

    return shapely.Polygon(surface.polygon).area + 0.2 * surface.z


def _taken(objects: Mapping[str, SceneObject], room: Room, carrier: SceneObject, surface: Surface, height: float):
    """What is in the way above a surface up to a height [m]: other things on it, what hangs over it, windows."""
    import shapely

    shapes = []
    own = set(carried(objects, carrier.id))
    low, high = surface.z, surface.z + height
    settled = has_place(carrier)
    for o in objects.values():
        if o.id == carrier.id or (o.id not in own and (not settled or not has_place(o))):
            continue
        x, y, z, yaw = local(carrier.pose, o.pose)
        for part in o.solids:
            if z + part.z[1] > low + 1e-4 and z + part.z[0] < high:
                shapes.append(shapely.Polygon(_turned(part.polygon, x, y, yaw)))
    if settled:
        shapes += _glass(room, carrier, low, high)
    return union(s if s.is_valid else s.buffer(0) for s in shapes)


def _turned(polygon: Iterable[tuple[float, float]], x: float, y: float, yaw: float) -> list[tuple[float, float]]:
    c, s = math.cos(yaw), math.sin(yaw)
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in polygon]


def _glass(room: Room, carrier: SceneObject, low: float, high: float) -> list:
    """The space before windows, in the carrier's frame, where it reaches into the heights [m]."""
    import shapely

    found = []
    base = carrier.pose.position[2]
    for window in room.windows:
        if not (base + high > window.sill and base + low < window.sill + window.height):
            continue
        a, b = room.outline[window.wall], room.outline[(window.wall + 1) % len(room.outline)]
        length = math.dist(a, b)
        ux, uy = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        points = []
        for along, depth in ((0.0, 0.0), (window.width, 0.0), (window.width, GLASS), (0.0, GLASS)):
            t = window.offset + along
            points.append((a[0] + ux * t - uy * depth, a[1] + uy * t + ux * depth))
        flat = [local(carrier.pose, Pose(position=(px, py, 0.0)))[:2] for px, py in points]
        found.append(shapely.Polygon(flat))
    return found
