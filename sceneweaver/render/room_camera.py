"""From where a room is looked at: the corner that shows most, and what stands in its way."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.geometry.angles import heading
from sceneweaver.geometry.shell import FLOOR_THICKNESS, WALL_THICKNESS
from sceneweaver.scene import Scene

from .camera import Camera
from .instances import hidden_with
from .room_probe import Probe, box_share, has_back, is_key, weight
from .room_shell import STUB

PITCH = math.radians(37.0)
_FOV = 0.42

_LOOK = (96, 72)  # pixels of the look that tells how much a camera shows
_BEHIND = 0.1  # what a thing is worth from behind
_TALL = 1.3  # height [m] of a thing whose back hides what is behind it

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


def _worth(scene: Scene, way: np.ndarray) -> float:
    """How much a camera in a direction shows: objects by what is seen of them and from which side, and windows."""
    cut = cut_walls(scene, way)
    camera = corner_camera(scene, way, cut, _LOOK[0] / _LOOK[1])
    gone = hidden_with(scene, cut)
    glimpse = Probe(scene, gone, cut, ceiling=False).look([camera], *_LOOK)[0]
    pixels = glimpse.pixels(len(scene.objects))
    worth, total = 0.0, 0.0
    for thing, seen in zip(scene.objects, pixels, strict=True):
        if thing.mount in ("ceiling", "surface") or thing.size[2] < 0.05:
            continue
        matters = weight(thing)
        total += matters
        # Of what is about as large as its box, 0.6 of it is seen where nothing is in the way.
        shown = min(1.0, float(seen) / max(1.0, 0.6 * _LOOK[0] * _LOOK[1] * box_share(camera, thing)))
        facing = float(np.dot(thing.pose.frame.axis, way)) if has_back(thing) else 1.0
        side = _BEHIND + (1 - _BEHIND) * min(1.0, max(0.0, (facing + 0.8) / 0.9))
        worth += matters * shown * side
        if is_key(thing):  # one that is hidden or seen from behind is worse than two seen half
            worth -= matters * (1 - shown * side) ** 2
        elif thing.size[2] > _TALL:
            worth -= 2.0 * matters * (1 - side) ** 2
    worth /= max(total, 1e-9)
    floor = {o.id for o in scene.objects if o.mount == "floor"}
    standing_there = {r.target for r in scene.relations if r.type == "at_window" and r.subject in floor}
    for window in scene.room.windows:
        if window.wall not in cut:
            worth += 0.25 * (window.id in standing_there) + 0.02 * window.width * window.height
    worth += 0.01 * sum(door.wall not in cut for door in scene.room.doors)
    # A deep L shows its inside from where no wall of the notch is in the way.
    standing = sum(wall.length for wall in scene.room.walls if wall.index not in cut)
    return worth + 0.002 * standing
