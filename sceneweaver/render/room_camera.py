"""From where a room is looked at: the corner that shows most, and what stands in its way."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.angles import heading
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS
from sceneweaver.scene import Scene, SceneObject

from .camera import Camera
from .room_shell import STUB

PITCH = math.radians(37.0)
_FOV = 0.42

HIDDEN = 0.03
"""Share of the floor behind a wall from which on it is cut away."""


def corner_directions(scene: Scene) -> list[np.ndarray]:
    """Unit vectors [2] from the room to the four corners of its box, the best one first."""
    u, across = _axes_of(scene)
    found = []
    for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        way = a * u + b * across
        found.append(way / np.linalg.norm(way))
    return sorted(found, key=lambda way: (-round(_worth(scene, way), 6), round(math.atan2(way[1], way[0]), 6)))


def opposite(ways: list[np.ndarray]) -> np.ndarray:
    """The direction across the room from the best one."""
    return min(ways, key=lambda way: float(way @ ways[0]))


def cut_walls(scene: Scene, way: np.ndarray) -> set[int]:
    """Walls that hide the room from a camera in the direction ``way``: whose outer face is turned to it, and those of a
    notch behind which more of the floor lies."""
    turned = {wall.index for wall in scene.room.walls if float(np.dot(wall.outward, way)) > 0.12}
    return turned | _before_the_floor(scene, way, turned)


def _before_the_floor(scene: Scene, way: np.ndarray, cut: set[int]) -> set[int]:
    """Standing walls behind which, for a camera in a direction, more than `HIDDEN` of the floor lies."""
    import shapely

    floor = shapely.Polygon(scene.room.outline)
    strip = -way * scene.room.height / math.tan(PITCH)  # what a wall hides, seen from far away
    found = set()
    for wall in scene.room.walls:
        if wall.index in cut:
            continue
        ends = np.array([wall.point(0.0), wall.point(wall.length)])
        hidden = shapely.MultiPoint(np.concatenate([ends, ends + strip])).convex_hull
        if shapely.intersection(hidden, floor).area > HIDDEN * floor.area:
            found.add(wall.index)
    return found


def corner_camera(scene: Scene, way: np.ndarray, cut: set[int], aspect: float) -> Camera:
    """A perspective camera that holds the room: its slab, the stubs and the walls that stand."""
    forward = np.array([*(-way * math.cos(PITCH)), -math.sin(PITCH)])
    points = []
    for wall in scene.room.walls:
        high, reach = STUB if wall.index in cut else scene.room.height, WALL_THICKNESS
        for offset in (-reach, wall.length + reach):
            for z in (-FLOOR_THICKNESS, high):
                points.append((*wall.point(offset, -reach), z))
    return Camera.holding(np.asarray(points), forward, fov=_FOV, aspect=aspect, margin=1.06)


def _axes_of(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
    longest = max(scene.room.walls, key=lambda wall: round(wall.length, 6))
    # The same axes whichever wall is the longest one.
    x, y = heading(longest.yaw % (math.pi / 2))
    return np.array([x, y]), np.array([-y, x])


def _before_window(thing: SceneObject) -> bool:
    return any(word in thing.category for word in ("curtain", "blind"))


def _worth(scene: Scene, way: np.ndarray) -> float:
    """How much a camera in a direction shows: fronts of objects, windows; tall things near it hide the rest."""
    outline = np.asarray(scene.room.outline)
    middle = (outline.min(axis=0) + outline.max(axis=0)) / 2
    reach = max(float(np.abs((outline - middle) @ way).max()), 1e-6)
    cut = cut_walls(scene, way)
    floor = {o.id for o in scene.objects if o.mount == "floor"}
    worth = 0.0
    for thing in scene.objects:
        depth, width, height = thing.size
        if thing.mount == "ceiling" or height < 0.05:
            continue
        front = thing.pose.frame.axis
        near = float((np.asarray(thing.pose.position[:2]) - middle) @ way) / reach
        face = width * height
        if thing.mount == "wall":
            # Pictures and mirrors are half of what a wall shows; curtains are large, and count by their windows.
            face = 2.5 * min(face, 1.0) if not _before_window(thing) else 0.1 * face
        worth += face * float(np.dot(front, way))
        if height > 1.0 and near > 0:
            worth -= 5.0 * max(width, depth) * (height - 0.8) * near
    standing_there = {r.target for r in scene.relations if r.type == "at_window" and r.subject in floor}
    for window in scene.room.windows:
        worth += 4.0 * (window.id in standing_there and window.wall not in cut)
        worth += (0.6 if window.wall not in cut else 0.0) * window.width * window.height
    for door in scene.room.doors:
        worth += 0.2 * (door.wall not in cut)
    # A deep L shows its inside from where no wall of the notch is in the way.
    standing = sum(wall.length for wall in scene.room.walls if wall.index not in cut)
    return worth + 0.05 * standing
