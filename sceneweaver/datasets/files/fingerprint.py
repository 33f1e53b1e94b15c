"""Where the large furniture of a room stands, in a frame of the room's own: what tells layouts apart.

The frame has its origin in the centroid of the outline and its x axis along a wall. A rectangle has one such frame up
to turns by 90 degrees and mirrors, other outlines one for each direction of a wall. A layout seen in another of these
frames is the same layout.

Two scenes are near-duplicates when, in frames of their rooms, the extents of the rooms differ by at most 20 cm and the
large furniture can be paired such that the two of each pair are of one category, at most 10 cm and 15 degrees apart,
and differ in depth and width by at most 10 cm.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely

from sceneweaver.scene import Scene

if TYPE_CHECKING:
    from scipy.cluster.hierarchy import DisjointSet

FOOTPRINT, HEIGHT = 0.3, 0.1
"""Least footprint [m2] and height [m] of large furniture: neither seats at tables nor rugs."""

FEW = 4
"""Where less than so many things are as large, all that stands on the floor counts, but what is flat."""

POSITION, ANGLE = 0.05, math.radians(15.0)
"""Grid of signatures for lengths [m] and angles [rad]."""

BIAS = 0.0123
"""Shift of the grid [m], so that lengths that people give lie on no border of it."""

MIRROR = np.diag([1.0, -1.0])


def fingerprint(scene: Scene) -> dict[str, Any]:
    """What packing needs of a scene to find near-duplicates: its signature and its large furniture as plain data."""
    return Layout.of(scene).columns


@dataclass(frozen=True)
class Layout:
    """The large furniture of a room.

    Attributes:
        outline: corners of the floor [m], shape [corner, 2].
        categories: of the furniture, in ascending order.
        boxes: x, y [m], yaw [rad], depth, width [m] of each, shape [thing, 5].
    """

    outline: np.ndarray
    categories: tuple[str, ...]
    boxes: np.ndarray

    @classmethod
    def of(cls, scene: Scene) -> Layout:
        """The layout of a scene."""
        standing = [o for o in scene.objects if o.mount == "floor" and o.size[2] >= HEIGHT]
        large = [o for o in standing if o.size[0] * o.size[1] >= FOOTPRINT]
        chosen = sorted(large if len(large) >= FEW else standing, key=lambda o: o.category)
        boxes = [(*o.pose.position[:2], o.pose.yaw, *o.size[:2]) for o in chosen]
        outline = np.array(scene.room.outline, dtype=float)
        return cls(outline, tuple(o.category for o in chosen), np.array(boxes, dtype=float).reshape(-1, 5))

    @classmethod
    def from_row(cls, furniture: dict[str, Any]) -> Layout:
        """The layout from the plain data of `fingerprint`."""
        boxes = np.array(furniture["boxes"], dtype=float).reshape(-1, 5)
        return cls(np.array(furniture["outline"], dtype=float), tuple(furniture["categories"]), boxes)

    @property
    def columns(self) -> dict[str, Any]:
        """Its signature, and itself as the plain data of `from_row`."""
        furniture = {
            "outline": _rounded(self.outline),
            "categories": list(self.categories),
            "boxes": _rounded(self.boxes),
        }
        return {"layout_signature": self.signature, "furniture": furniture}

    def views(self) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """The layout in each of its frames: extents of the room [m], shape [2], and boxes, shape [thing, 5]."""
        centroid = shapely.Polygon(self.outline).centroid
        outline = self.outline - (centroid.x, centroid.y)
        places = self.boxes[:, :2] - (centroid.x, centroid.y)
        for direction in self._directions:
            for quarter in range(4):
                angle = -direction - quarter * math.pi / 2
                c, s = math.cos(angle), math.sin(angle)
                turn = np.array([[c, -s], [s, c]])
                for mirrored in (False, True):
                    matrix = MIRROR @ turn if mirrored else turn
                    yaw = self.boxes[:, 2] + angle
                    boxes = np.column_stack([places @ matrix.T, -yaw if mirrored else yaw, self.boxes[:, 3:]])
                    yield np.ptp(outline @ matrix.T, axis=0), boxes

    @property
    def signature(self) -> str:
        """A hash that all views agree on: equal for equal furniture, to 5 cm and 15 degrees, in equal extents."""
        texts = []
        for extents, boxes in self.views():
            lengths = np.floor((np.round(boxes[:, [0, 1, 3, 4]], 6) + BIAS) / POSITION).astype(int)
            turns = np.floor(np.round(boxes[:, 2] / ANGLE, 6) + 0.5).astype(int) % round(2 * math.pi / ANGLE)
            things = sorted(
                f"{category} {' '.join(map(str, numbers))} {turn}"
                for category, numbers, turn in zip(self.categories, lengths.tolist(), turns.tolist(), strict=True)
            )
            room = np.floor((np.round(extents, 6) + BIAS) / POSITION).astype(int).tolist()
            texts.append("\n".join([str(room), *things]))
        return hashlib.sha256(min(texts).encode()).hexdigest()[:16]

    @cached_property
    def embedding(self) -> np.ndarray:
        """Numbers [m] that no view changes, shape [3 things]; of two near-duplicates none differs by over 10 cm.

        The distances from the centroid of the room, the depths and the widths, each sorted within a category: sorting
        two lists whose entries differ by so much at most gives lists that do, too.
        """
        centroid = shapely.Polygon(self.outline).centroid
        distance = np.hypot(*(self.boxes[:, :2] - (centroid.x, centroid.y)).T)
        names = np.array(self.categories)
        columns = [
            np.sort(values[names == name])
            for values in (distance, self.boxes[:, 3], self.boxes[:, 4])
            for name in dict.fromkeys(self.categories)
        ]
        return np.concatenate([np.zeros(0), *columns]).astype(np.float32)

    @cached_property
    def _directions(self) -> list[float]:
        """Directions of the walls [rad], without those that differ by a multiple of 90 degrees."""
        steps = np.roll(self.outline, -1, axis=0) - self.outline
        angles = np.arctan2(steps[:, 1], steps[:, 0]) % (math.pi / 2)
        rounded = np.round(angles, 3) % round(math.pi / 2, 3)
        return list(dict(zip(rounded.tolist(), angles.tolist(), strict=True)).values())


def _rounded(values: np.ndarray) -> list[list[float]]:
    return np.round(values, 4).tolist()


APART, TURNED = 0.10, math.radians(15.0)
"""How far two things of a pair may be apart [m] and turned against each other [rad]."""

EXTENTS = 2 * APART
"""How much the extents of two rooms may differ [m]: as if each of two opposite walls stood elsewhere."""

CHUNK = 1024
"""Layouts whose neighbours are looked for at once."""


def near_duplicates(a: Layout, b: Layout) -> bool:
    """Whether the large furniture of two rooms stands alike."""
    from scipy.optimize import linear_sum_assignment

    if a.categories != b.categories:
        return False
    extents, boxes = next(a.views())
    names = np.array(a.categories)
    other_kind = names[:, None] != names[None, :]
    for other_extents, other in b.views():
        if np.abs(extents - other_extents).max() > EXTENTS:
            continue
        apart = np.hypot(*np.moveaxis(boxes[:, None, :2] - other[None, :, :2], -1, 0))
        turned = np.abs((boxes[:, None, 2] - other[None, :, 2] + math.pi) % (2 * math.pi) - math.pi)
        larger = np.abs(boxes[:, None, 3:] - other[None, :, 3:]).max(axis=-1)
        unlike = other_kind | (apart > APART) | (turned > TURNED) | (larger > APART)
        if unlike.all(axis=1).any():
            continue
        rows, columns = linear_sum_assignment(unlike)
        if not unlike[rows, columns].any():
            return True
    return False


def join_near_duplicates(sets: DisjointSet, layouts: Sequence[tuple[int, str, Layout]]) -> None:
    """Join the scenes that are near-duplicates, and those that hang together by others that are.

    Args:
        sets: over all scenes.
        layouts: number, signature and layout of each scene that may be one.
    """
    first: dict[str, int] = {}
    kinds: dict[tuple[str, ...], list[tuple[int, Layout]]] = {}
    for number, signature, layout in layouts:
        if signature in first:  # in the same cells of 5 cm and 15 degrees
            sets.merge(first[signature], number)
        else:
            first[signature] = number
            kinds.setdefault(layout.categories, []).append((number, layout))
    for same in kinds.values():
        _join_neighbours(sets, same)


def smallest(sets: DisjointSet) -> np.ndarray:
    """The smallest number of the set of each of the numbers 0 to N - 1, shape [N]."""
    names = np.empty(len(sets), dtype=np.int64)
    for members in sets.subsets():
        names[list(members)] = min(members)
    return names


def _join_neighbours(sets: DisjointSet, layouts: Sequence[tuple[int, Layout]]) -> None:
    """Join near-duplicates among layouts with the same categories; only near embeddings are compared."""
    from scipy.spatial import KDTree

    if len(layouts) < 2:
        return
    points = np.array([layout.embedding for _, layout in layouts], dtype=float).reshape(len(layouts), -1)
    if not points.shape[1]:  # empty rooms
        points = np.zeros((len(layouts), 1))
    tree = KDTree(points)
    for start in range(0, len(layouts), CHUNK):
        near = tree.query_ball_point(points[start : start + CHUNK], APART + 1e-3, p=math.inf)
        for i, candidates in enumerate(near, start):
            for j in sorted(candidates):
                a, b = layouts[i], layouts[j]
                if i < j and not sets.connected(a[0], b[0]) and near_duplicates(a[1], b[1]):
                    sets.merge(a[0], b[0])
