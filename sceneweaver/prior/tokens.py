"""A scene as tokens: the room, its walls, openings and objects as rows of numbers, and the relations among them.

Lengths are in the frame of the room: origin in the middle of its bounding box, +x along its longest wall, and one unit
the longer half side of that box. What stands on something else is no token: it goes along with what carries it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from sceneweaver.geometry.polygons import signed_area
from sceneweaver.geometry.se2 import SE2
from sceneweaver.io import InputError
from sceneweaver.scene import Scene, SceneObject

from .vocabulary import UNKNOWN, Words

MOST_WALLS, MOST_OPENINGS, MOST_OBJECTS = 64, 64, 256
"""Tokens of a scene at most: the network knows no limit, its memory does."""

TRAINED = {"walls": 16, "openings": 12, "objects": 48}
"""What scenes that the prior is trained on may have."""

ROOM_WIDTH, WALL_WIDTH, OPENING_WIDTH, OBJECT_WIDTH = 5, 8, 9, 16
"""Numbers that a token of each sort has."""

MOUNTS = ("floor", "wall", "ceiling", "surface")


@dataclass(frozen=True)
class Tokens:
    """One scene for the network, with W walls, O openings and N objects; T = 1 + W + O + N tokens in that order.

    Attributes:
        room: [5] float32: logarithm of the unit [m], height, area, share of it that floor-standing boxes cover, and the
            logarithm of how many objects there are.
        kind: number of the kind of room.
        walls: [W, 8] float32: x, y of both ends, inward normal, length, logarithm of the length [m].
        openings: [O, 9] float32: x, y of the middle, inward normal, width, lower edge, height, door or window.
        objects: [N, 16] float32: depth, width, height in units, their logarithms in metres, mount (4), whether it is
            given, height of the underside, how far hard zones reach ahead, back, left and right.
        categories: [N] int32.
        given: [N, 4] float32, x, y, cosine and sine of the yaw where an object is fixed; zeros elsewhere.
        unary: [N, R] float32, types of the relations that it is subject of.
        edges: [T, T] int32: 0 none, 2 + 2 r: the row's token is subject of a relation of type r to the column's, one
            more the other way round; 1: both are the same.
        index: [N] int, places of the objects in the scene.
        frame: the frame of the room in the scene.
        unit: its length [m].
    """

    room: np.ndarray
    kind: int
    walls: np.ndarray
    openings: np.ndarray
    objects: np.ndarray
    categories: np.ndarray
    given: np.ndarray
    unary: np.ndarray
    edges: np.ndarray
    index: np.ndarray
    frame: SE2
    unit: float

    def local(self, poses: np.ndarray) -> np.ndarray:
        """x, y, cosine and sine [..., N, 4] in the room's frame of world poses [..., scene's objects, 4] (with z)."""
        mine = np.asarray(poses, dtype=np.float64)[..., self.index, :]
        xy = self.frame.to_local(mine[..., :2]) / self.unit
        yaw = mine[..., 3] - self.frame.yaw
        return np.concatenate([xy, np.cos(yaw)[..., None], np.sin(yaw)[..., None]], axis=-1).astype(np.float32)

    def world(self, local: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """World x, y [..., N, 2] [m] and yaw [..., N] [rad] of what `local` gives."""
        found = np.asarray(local, dtype=np.float64)
        yaw = np.arctan2(found[..., 3], found[..., 2]) + self.frame.yaw
        return self.frame.to_world(found[..., :2] * self.unit), (yaw + np.pi) % (2 * np.pi) - np.pi


def tokens_of(scene: Scene, words: Words) -> Tokens:
    """The tokens of a scene.

    Raises:
        InputError: the scene has more walls, openings or objects than a network is asked to look at.
    """
    room = scene.room
    outline = np.array(room.outline, dtype=np.float64)
    standing = [i for i, o in enumerate(scene.objects) if o.support is None]
    openings = [*room.doors, *room.windows]
    _check(scene, len(outline), len(openings), len(standing))
    frame, unit = _frame(scene, outline)
    corners = frame.to_local(outline) / unit
    ends = np.roll(corners, -1, axis=0)
    length = np.linalg.norm(ends - corners, axis=1, keepdims=True)
    along = (ends - corners) / length
    inward = np.stack([-along[:, 1], along[:, 0]], axis=1)
    walls = np.concatenate([corners, ends, inward, length, np.log(length * unit)], axis=1)
    rows = []
    for opening in openings:
        k = opening.wall
        middle = corners[k] + along[k] * (opening.offset + 0.5 * opening.width) / unit
        sill = getattr(opening, "sill", None)
        sort = (1.0, 0.0) if sill is None else (0.0, 1.0)
        rows.append((*middle, *inward[k], opening.width / unit, (sill or 0.0) / unit, opening.height / unit, *sort))
    objects = [scene.objects[i] for i in standing]
    area = abs(float(signed_area(room.outline)))
    covered = sum(o.size[0] * o.size[1] for o in objects if o.mount == "floor") / area
    whole = (math.log(unit), room.height / unit, area / unit**2, covered, math.log1p(len(objects)))
    unary, edges = _relations(scene, standing, len(outline), words)
    return Tokens(
        room=np.array(whole, dtype=np.float32),
        kind=words.kind(room.type),
        walls=walls.astype(np.float32),
        openings=np.array(rows, dtype=np.float32).reshape(-1, OPENING_WIDTH),
        objects=np.array([_object(o, unit) for o in objects], dtype=np.float32).reshape(-1, OBJECT_WIDTH),
        categories=np.array([words.category(o.category) for o in objects], dtype=np.int32),
        given=np.array([_given(o, frame, unit) for o in objects], dtype=np.float32).reshape(-1, 4),
        unary=unary,
        edges=edges,
        index=np.array(standing, dtype=np.int64),
        frame=frame,
        unit=unit,
    )


def fits(scene: Scene) -> bool:
    """Whether a scene is small enough to train on."""
    room = scene.room
    have = {
        "walls": len(room.outline),
        "openings": len(room.doors) + len(room.windows),
        "objects": sum(o.support is None for o in scene.objects),
    }
    return have["objects"] > 0 and all(have[name] <= most for name, most in TRAINED.items())


def _check(scene: Scene, walls: int, openings: int, objects: int) -> None:
    for name, count, most in (
        ("walls", walls, MOST_WALLS),
        ("doors and windows", openings, MOST_OPENINGS),
        ("objects that stand on nothing else", objects, MOST_OBJECTS),
    ):
        if count > most:
            raise InputError(f'prior: scene {scene.id} has {count} {name}, more than {most}; use init="sample"')


def _frame(scene: Scene, outline: np.ndarray) -> tuple[SE2, float]:
    """The frame of a room and its unit [m]."""
    wall = max(scene.room.walls, key=lambda w: (round(w.length, 6), -w.index))
    turned = SE2(0.0, 0.0, wall.yaw)
    local = turned.to_local(outline)
    low, high = local.min(axis=0), local.max(axis=0)
    x, y = turned.world(*(0.5 * (low + high)))
    return SE2(float(x), float(y), wall.yaw), 0.5 * float((high - low).max())


def _object(obj: SceneObject, unit: float) -> tuple[float, ...]:
    """The numbers of an object."""
    reach = [0.0, 0.0, 0.0, 0.0]
    for zone in obj.zones:
        if zone.hard:
            xs, ys = zip(*zone.polygon, strict=True)
            beyond = (max(xs) - obj.size[0] / 2, -min(xs) - obj.size[0] / 2)
            beyond += (max(ys) - obj.size[1] / 2, -min(ys) - obj.size[1] / 2)
            reach = [max(a, b) for a, b in zip(reach, beyond, strict=True)]
    sizes = tuple(s / unit for s in obj.size) + tuple(math.log(max(s, 1e-3)) for s in obj.size)
    mount = tuple(float(obj.mount == name) for name in MOUNTS)
    under = obj.pose.position[2] / unit if obj.mount != "floor" else 0.0
    return (*sizes, *mount, float(obj.fixed), under, *(r / unit for r in reach))


def _given(obj: SceneObject, frame: SE2, unit: float) -> tuple[float, float, float, float]:
    """Where an object is that must stay there."""
    if not obj.fixed:
        return 0.0, 0.0, 0.0, 0.0
    x, y = frame.local(obj.pose.position[0], obj.pose.position[1])
    yaw = obj.pose.yaw - frame.yaw
    return x / unit, y / unit, math.cos(yaw), math.sin(yaw)


def _relations(scene: Scene, standing: Sequence[int], walls: int, words: Words) -> tuple[np.ndarray, np.ndarray]:
    """Types [N, R] of the relations that each object is subject of, and edges [T, T] between tokens."""
    room = scene.room
    names = {f"wall:{k}": 1 + k for k in range(walls)}
    names |= {o.id: 1 + walls + k for k, o in enumerate([*room.doors, *room.windows])}
    first = 1 + walls + len(room.doors) + len(room.windows)
    names |= {scene.objects[i].id: first + k for k, i in enumerate(standing)}
    count = first + len(standing)
    unary = np.zeros((len(standing), len(words.relations)), dtype=np.float32)
    edges = np.zeros((count, count), dtype=np.int32)
    np.fill_diagonal(edges, 1)
    # Where two relations are between the same two, the hard one counts, and of several of these the first.
    for relation in sorted(scene.relations, key=lambda r: not r.hard):
        number, row = words.relation(relation.type), names.get(relation.subject)
        if number is None or row is None or row < first:
            continue
        unary[row - first, number] = 1.0
        for target in relation.targets:
            column = names.get(target)
            if column is not None and edges[row, column] == 0:
                edges[row, column] = 2 + 2 * number
                edges[column, row] = 3 + 2 * number
    return unary, edges


@dataclass(frozen=True)
class Padded:
    """Tokens of several scenes S side by side with room for W walls, O openings and N objects, and which are there.

    Arrays are those of `Tokens`, with the scene as the leading axis; ``mask`` is [S, T] bool.
    """

    room: np.ndarray
    kind: np.ndarray
    walls: np.ndarray
    openings: np.ndarray
    objects: np.ndarray
    categories: np.ndarray
    given: np.ndarray
    unary: np.ndarray
    edges: np.ndarray
    mask: np.ndarray

    def arrays(self) -> dict[str, np.ndarray]:
        """The arrays by name."""
        return {f.name: getattr(self, f.name) for f in fields(self)}


def padded(scenes: Sequence[Tokens], walls: int, openings: int, objects: int) -> Padded:
    """Tokens side by side; the scenes have to fit."""
    total, relations = 1 + walls + openings + objects, scenes[0].unary.shape[1]
    count = len(scenes)
    out = Padded(
        room=np.stack([t.room for t in scenes]),
        kind=np.array([t.kind for t in scenes], dtype=np.int32),
        walls=np.zeros((count, walls, WALL_WIDTH), dtype=np.float32),
        openings=np.zeros((count, openings, OPENING_WIDTH), dtype=np.float32),
        objects=np.zeros((count, objects, OBJECT_WIDTH), dtype=np.float32),
        categories=np.full((count, objects), UNKNOWN, dtype=np.int32),
        given=np.zeros((count, objects, 4), dtype=np.float32),
        unary=np.zeros((count, objects, relations), dtype=np.float32),
        edges=np.zeros((count, total, total), dtype=np.int32),
        mask=np.zeros((count, total), dtype=bool),
    )
    for k, t in enumerate(scenes):
        w, o, n = len(t.walls), len(t.openings), len(t.objects)
        place = np.concatenate([[0], 1 + np.arange(w), 1 + walls + np.arange(o), 1 + walls + openings + np.arange(n)])
        out.walls[k, :w], out.openings[k, :o], out.objects[k, :n] = t.walls, t.openings, t.objects
        out.categories[k, :n], out.given[k, :n], out.unary[k, :n] = t.categories, t.given, t.unary
        out.edges[k][np.ix_(place, place)] = t.edges
        out.mask[k, place] = True
    return out
