"""What cameras would see of a room, without light or materials: collision prisms and flat walls, cheap enough to try
hundreds of cameras."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from sceneweaver.assets.placed import parts_mesh, plain_material
from sceneweaver.geometry.rotations import matrix
from sceneweaver.geometry.shell import wall_pieces
from sceneweaver.scene import Door, Room, Scene, SceneObject

from .camera import Camera
from .tracing import Triangles
from .words import is_one_of

NOTHING, WALL, FLOOR, CEILING, WINDOW, DOOR = -1, -2, -3, -4, -5, -6
"""Ids of what is no object."""


@dataclass(frozen=True)
class Glimpse:
    """What one camera sees: ``ids`` int [H, W], numbers of objects or those above; ``distance`` [H, W] along rays [m];
    ``points`` [H, W, 3] in the world."""

    ids: np.ndarray
    distance: np.ndarray
    points: np.ndarray

    def pixels(self, count: int) -> np.ndarray:
        """How many pixels show each of ``count`` objects, [count]."""
        return np.bincount(self.ids[self.ids >= 0], minlength=count)


class Probe:
    """A room to look at from many cameras."""

    def __init__(
        self,
        scene: Scene,
        hidden: Collection[str] = (),
        cut: Collection[int] = (),
        ceiling: bool = True,
        doors: bool = True,
    ) -> None:
        """Prepare it.

        Args:
            scene: The room and its objects; these are drawn as their collision prisms.
            hidden: Ids of objects that are left out.
            cut: Walls that are left out.
            ceiling: Whether the room has one.
            doors: Whether doors are shut; else one looks through.
        """
        pieces = [object_mesh(thing) if thing.id not in hidden else _EMPTY for thing in scene.objects]
        ids = [np.full(len(faces), k) for k, (_, faces) in enumerate(pieces)]
        shell = [(piece, number) for piece, number in _shell(scene.room, cut, ceiling) if doors or number != DOOR]
        pieces += [piece for piece, _ in shell]
        ids += [np.full(len(faces), number) for (_, faces), number in shell]
        starts = np.cumsum([0, *(len(vertices) for vertices, _ in pieces)])
        faces = [own + start for (_, own), start in zip(pieces, starts, strict=False)]
        self._ids = np.concatenate(ids)
        self._triangles = Triangles(np.concatenate([v for v, _ in pieces]), np.concatenate(faces))

    def look(self, cameras: Sequence[Camera], width: int, height: int) -> list[Glimpse]:
        """What each camera sees."""
        hits = self._triangles.first_hits(cameras, width, height)
        ids = np.where(hits.face >= 0, self._ids[hits.face], NOTHING)
        return [
            Glimpse(own, distance, camera.origins(width, height) + camera.rays(width, height) * distance[..., None])
            for own, distance, camera in zip(ids, hits.distance, cameras, strict=True)
        ]


def is_key(thing: SceneObject) -> bool:
    """Whether a room is about such a thing: a bed, a table, a counter ..."""
    return thing.mount == "floor" and is_one_of(thing.category, "key")


def has_back(thing: SceneObject) -> bool:
    """Whether a thing should not be seen from behind."""
    return thing.size[2] > 0.3 and not is_one_of(thing.category, "all round")


def weight(thing: SceneObject) -> float:
    """How much it matters that a picture shows a thing: about its size in metres, more where it is key."""
    depth, width, height = thing.size
    size = min(1.6, max(0.15, (width * max(height, depth)) ** 0.5))
    if is_one_of(thing.category, "minor"):
        return 0.25 * size
    share = {"floor": 1.0, "wall": 0.7, "ceiling": 0.3, "surface": 0.3}[thing.mount]
    return size * (3.0 if is_key(thing) else share)


def box_corners(thing: SceneObject) -> np.ndarray:
    """The corners [8, 3] of a thing's box in the world [m]."""
    depth, width, height = thing.size
    signs = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0.0, 1.0)])
    return signs * (depth, width, height) @ matrix(thing.pose.quaternion).T + np.asarray(thing.pose.position)


def box_share(camera: Camera, thing: SceneObject) -> float:
    """The share of a picture that a thing's box covers, were nothing before it and the picture endless."""
    import shapely

    u, v, ahead = camera.project(box_corners(thing)).T
    if (ahead <= 0).any():
        return 1.0
    return shapely.MultiPoint(np.column_stack([u, v])).convex_hull.area / 4


_EMPTY = (np.empty((0, 3)), np.empty((0, 3), dtype=np.int32))


def object_mesh(thing: SceneObject) -> tuple[np.ndarray, np.ndarray]:
    """A thing as its collision prisms: points [V, 3] in the world [m] and faces [F, 3]."""
    mesh = parts_mesh(thing.solids, plain_material(thing))
    return mesh.vertices @ matrix(thing.pose.quaternion).T + np.asarray(thing.pose.position), mesh.faces


def _shell(room: Room, cut: Collection[int], ceiling: bool) -> list[tuple[tuple[np.ndarray, np.ndarray], int]]:
    """Walls, floor and ceiling: vertices, faces and id of each piece."""
    import manifold3d

    plan = np.asarray(room.outline, dtype=float)
    flat = np.asarray(manifold3d.triangulate([plan]), dtype=np.int32)
    found = []
    for z, number in ((0.0, FLOOR), (room.height, CEILING))[: 2 if ceiling else 1]:
        found.append(((np.column_stack([plan, np.full(len(plan), z)]), flat), number))
    for wall in room.walls:
        if wall.index in cut:
            continue
        for (a, b), (low, high), opening in wall_pieces(wall.length, room.openings_of(wall.index), room.height):
            corners = [(*wall.point(s), z) for s, z in ((a, low), (b, low), (b, high), (a, high))]
            number = WALL if opening is None else DOOR if isinstance(opening, Door) else WINDOW
            found.append(((np.array(corners), np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)), number))
    return found
