"""What a problem is about, for people and for optimisers: objects, their domains, relations, items of the energy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sceneweaver.kernels import tables as k

from .compile import LayoutProblem

COORDINATES = (k.FREE_PLANE, k.FREE_PLANE, k.FREE_Z, k.FREE_YAW)
RELATION, ALONE, PAIR = "relation", "alone", "pair"


@dataclass(frozen=True)
class ObjectInfo:
    """One object of a problem.

    Attributes:
        id: its id in the scene.
        size: depth along its front, width, height [m].
        free: which of x, y, z, yaw an optimiser may change; none of a fixed or carried object,
            and no yaw of a set.
        lower, upper: box [4] of its poses: the place's bounding box, heights, a whole turn. Equal where it is not free.
        yaws: the yaws [rad] that it may have where these are a set: then an optimiser may not change its yaw by a
            little, and the box holds all of them; none where it may have any.
        root: index of the object at the bottom of the stack that it is in; its own, if it is not carried.
    """

    id: str
    size: tuple[float, float, float]
    free: tuple[bool, bool, bool, bool]
    lower: tuple[float, float, float, float]
    upper: tuple[float, float, float, float]
    root: int
    yaws: tuple[float, ...] = ()


@dataclass(frozen=True)
class RelationInfo:
    """One relation of a problem: ``index`` in the scene's list (None: added by the engine, as mountings are).

    ``objects`` are the subject and the targets, ``weight`` its weight in the energy, ``term`` the name of the
    user's term that it is of (None: of none).
    """

    index: int | None
    objects: tuple[int, ...]
    hard: bool
    weight: float
    term: str | None = None


@dataclass(frozen=True)
class ItemInfo:
    """One item of the energy: its ``kind`` ("relation", "alone" or "pair"), its objects, its relation if it has one."""

    kind: str
    objects: tuple[int, ...]
    relation: int | None = None


@dataclass(frozen=True)
class Metadata:
    """What stands where in the arrays of one scene's problem.

    Attributes:
        objects: in the order of poses.
        relations: the scene's relations first, then what the engine adds.
        items: in the order of residuals and violations: relations, every object alone, pairs that may meet.
        box: bounding box of the place in plan, xmin, ymin, xmax, ymax [m].
        height: of the ceiling, or head room over a surface [m]; may be infinite.
    """

    objects: tuple[ObjectInfo, ...]
    relations: tuple[RelationInfo, ...]
    items: tuple[ItemInfo, ...]
    box: tuple[float, float, float, float]
    height: float


def items_of(layout: LayoutProblem) -> tuple[ItemInfo, ...]:
    """The items of a layout's energy. Pairs that are carried along together, or never meet, are none."""
    related = [
        ItemInfo(RELATION, tuple(o for o in relation.objects if o >= 0), r)
        for r, relation in enumerate(layout.relations)
    ]
    alone = [ItemInfo(ALONE, (i,)) for i in range(layout.size)]
    meets = ((layout.flags & ~np.uint8(k.PAIR_RIGID)) != 0) & ((layout.flags & k.PAIR_RIGID) == 0)
    pairs = [ItemInfo(PAIR, (int(i), int(j))) for i, j in np.argwhere(np.triu(meets, 1))]
    return (*related, *alone, *pairs)


def freedom_of(layout: LayoutProblem) -> np.ndarray:
    """Which coordinates [object, 4] of a layout's poses may change."""
    root = layout.roots == np.arange(layout.size)
    return ((layout.free[:, None] & np.array(COORDINATES)) != 0) & root[:, None]


def bounds_of(layout: LayoutProblem) -> tuple[np.ndarray, np.ndarray]:
    """The box [object, 4] of a layout's poses, lower and upper; the given pose where a coordinate is not free."""
    x0, y0, x1, y1 = layout.region.box
    top = np.maximum(layout.region.height - layout.sizes[:, 2], 0.0)
    lower = np.tile([x0, y0, 0.0, -np.pi], (layout.size, 1))
    upper = np.tile([x1, y1, 0.0, np.pi], (layout.size, 1))
    upper[:, 2] = top
    free = freedom_of(layout)
    lower, upper = np.where(free, lower, layout.home), np.where(free, upper, layout.home)
    for i, yaws in enumerate(layout.yaws):
        if yaws and layout.free[i]:
            lower[i, 3], upper[i, 3] = min(yaws), max(yaws)
    return lower, upper


def metadata_of(layout: LayoutProblem) -> Metadata:
    """What stands where in the arrays of a layout's problem."""
    free, (lower, upper) = freedom_of(layout), bounds_of(layout)
    objects = tuple(
        ObjectInfo(name, *map(tuple, row), root, yaws)  # pyright: ignore[reportCallIssue]
        for name, *row, root, yaws in zip(
            layout.ids,
            *(a.tolist() for a in (layout.sizes, free, lower, upper, layout.roots)),
            layout.yaws,
            strict=True,
        )
    )
    named = [*layout.relation_ids, *([None] * (len(layout.relations) - len(layout.relation_ids)))]
    relations = tuple(
        RelationInfo(index, tuple(o for o in r.objects if o >= 0), r.fault != 0, float(r.weight), r.term)
        for index, r in zip(named, layout.relations, strict=True)
    )
    return Metadata(objects, relations, items_of(layout), layout.region.box, float(layout.region.height))
