"""Grids as relations: tables of a restaurant in rows, desks of a classroom. The search finds where the grid stands."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.scene import Relation, Room

from .program import Wanted
from .seats import seat_sides

PULL = 0.135
"""Depth [m] that belongs to a table behind a chair that is pulled up to it; the way between rows comes to it."""

WAYS = (1.0, 0.8, 0.6)
"""Widths [m] of the ways between rows that are tried; between neighbours in a row it is half of that."""

CLUSTERS = (6, 4, 2)
"""Most pieces of a cluster, as they are tried."""

TOUCHING = {"gap": (0.0, 0.02)}
"""Gap [m] between the pieces of a cluster."""

LEAST = 3
"""Groups that make a grid."""

WIDEST = (1.5, 1.1)
"""Largest ways [m] between rows, and between neighbours."""

PLAY = 0.04
"""Length [m] by which the gaps of a grid may differ before they are made equal."""


@dataclass(frozen=True)
class Group:
    """An anchor and the box around it [m], with its seats and the free space that it needs.

    ``box`` is (x0, y0, x1, y1) in the anchor's frame.
    """

    anchor: Wanted
    box: tuple[float, float, float, float]

    @property
    def depth(self) -> float:
        """Length [m] along the anchor's front."""
        return self.box[2] - self.box[0]

    @property
    def width(self) -> float:
        """Length [m] to the anchor's left and right."""
        return self.box[3] - self.box[1]


def _stands(one: Wanted, row: str = "grid") -> bool:
    return one.item is not None and one.item.row == row and one.parent is None and one.support is None


def in_grid(program: Sequence[Wanted]) -> bool:
    """Whether enough of a program stands in rows for there to be a grid, or in clusters."""
    return sum(map(_stands, program)) >= LEAST or sum(_stands(w, "cluster") for w in program) >= 2


def grid_variants(program: Sequence[Wanted], room: Room, strip: float) -> list[tuple[Relation, ...]]:
    """The relations of grids of different shape, the roomiest first, that the floor less a strip [m] at the walls has
    space for: rows across the room and along it, of one kind of group each or of several.

    What stands in clusters is one group a cluster; other clusters are tried where the first do not fit.
    """
    groups = [group_of(w, program) for w in program if _stands(w)]
    clustered = [w for w in program if _stands(w, "cluster")]
    if len(clustered) < 2:
        return _grids(groups, room, strip)
    found: list[tuple[Relation, ...]] = []
    for most in CLUSTERS:
        clusters = _clusters(clustered, most)
        inner = tuple(relation for cluster in clusters for relation in _back_to_back(cluster))
        every = groups + [_cluster_group(cluster, program) for cluster in clusters]
        found += [(*inner, *outer) for outer in _grids(every, room, strip)]
        if len(clustered) <= 2:
            break
    return found


def _clusters(anchors: Sequence[Wanted], most: int) -> list[list[Wanted]]:
    """The anchors in clusters of at most so many, nearly equal and of an even number where that can be."""
    pairs = math.ceil(len(anchors) / 2)
    parts = math.ceil(pairs / (most // 2))
    found, at = [], 0
    for k in range(parts):
        size = 2 * ((pairs + k) // parts)
        found.append(list(anchors[at : at + size]))
        at += size
    return [cluster for cluster in found if cluster]


def _back_to_back(cluster: Sequence[Wanted]) -> list[Relation]:
    """Pairs with their backs together, pair beside pair."""
    found = []
    for k, one in enumerate(cluster):
        if k % 2:
            params = {**TOUCHING, "overlap": 0.98}
            found.append(Relation(type="back_to_back", subject=one.id, target=cluster[k - 1].id, params=params))
        elif k:
            params = {"side": "left", **TOUCHING, "offset": 0.02}
            found.append(Relation(type="next_to", subject=one.id, target=cluster[k - 2].id, params=params))
    return found


def _cluster_group(cluster: Sequence[Wanted], program: Sequence[Wanted]) -> Group:
    """The cluster as a group about its first piece."""
    x0, y0, x1, y1 = group_of(cluster[0], program).box
    d, w, _ = cluster[0].asset.size
    if len(cluster) > 1:
        x0 = -d - x1
    return Group(cluster[0], (x0, y0, x1, y1 + w * ((len(cluster) - 1) // 2)))


def _grids(groups: Sequence[Group], room: Room, strip: float) -> list[tuple[Relation, ...]]:
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    length, depth = max(xs) - min(xs), max(ys) - min(ys)
    found: list[tuple[Relation, ...]] = []
    for mixed in (False, True):
        for way in WAYS:
            for margin in (strip, 0.75 * strip, 0.5 * strip):
                for long, deep in ((length, depth), (depth, length)):
                    rows = _rows(groups, long - 2 * margin, way, mixed)
                    relations = _relations(rows, long - 2 * margin, deep - 2 * margin, way) if rows else None
                    if relations is not None and relations not in found:
                        found.append(relations)
        if found:
            break
    return found


def group_of(anchor: Wanted, program: Sequence[Wanted]) -> Group:
    """A thing with the seats at it and the floor that it needs."""
    d, w, _ = anchor.asset.size
    x0, y0, x1, y1 = -d / 2, -w / 2, d / 2, w / 2
    for zone in anchor.asset.zones:
        if zone.hard:
            x0, y0 = min(x0, *(p[0] for p in zone.polygon)), min(y0, *(p[1] for p in zone.polygon))
            x1, y1 = max(x1, *(p[0] for p in zone.polygon)), max(y1, *(p[1] for p in zone.polygon))
    for side, deep in seat_sides(anchor, program).items():
        reach = deep + PULL
        x0, x1 = min(x0, -d / 2 - reach * (side == "back")), max(x1, d / 2 + reach * (side == "front"))
        y0, y1 = min(y0, -w / 2 - reach * (side == "right")), max(y1, w / 2 + reach * (side == "left"))
    return Group(anchor, (x0, y0, x1, y1))


def _rows(groups: Sequence[Group], long: float, way: float, mixed: bool) -> list[list[Group]] | None:
    """The groups in rows of at most that length [m], of one kind unless ``mixed``; None when one is too long."""
    rows: list[list[Group]] = []
    for group in sorted(groups, key=lambda g: (-g.depth, g.anchor.id.rsplit("-", 1)[0])):
        if group.width > long:
            return None
        for row in rows:
            taken = sum(g.width for g in row) + 0.5 * way * len(row)
            if taken + group.width <= long and (mixed or row[0].anchor.category == group.anchor.category):
                row.append(group)
                break
        else:
            rows.append([group])
    for row in rows:  # level rows of the same kind, so that none has two groups more than another
        for other in rows:
            while other[0].anchor.category == row[0].anchor.category and len(row) - len(other) > 1:
                other.append(row.pop())
    return rows


def _relations(rows: Sequence[Sequence[Group]], long: float, deep: float, way: float) -> tuple[Relation, ...] | None:
    """Each group beside the one before it in its row, each row behind the one before it; None when they do not fit."""
    spare = deep - sum(max(g.depth for g in row) for row in rows)
    if spare < way * (len(rows) - 1):
        return None
    between_rows = min(spare / len(rows), WIDEST[0])
    found: list[Relation] = []
    for number, row in enumerate(rows):
        free = long - sum(g.width for g in row)
        beside = min(free / len(row), WIDEST[1])
        for a, b in zip(row, row[1:], strict=False):
            gap = beside + (a.box[3] - a.anchor.asset.size[1] / 2) - (b.box[1] + b.anchor.asset.size[1] / 2)
            found.append(_next(b, a, "left", gap))
        if number:
            a, b = rows[number - 1][0], row[0]
            ahead = max(g.box[2] - a.anchor.asset.size[0] / 2 for g in rows[number - 1])
            behind = max(-g.box[0] - b.anchor.asset.size[0] / 2 for g in row)
            found.append(_next(b, a, "front", between_rows + ahead + behind))
    return tuple(found)


def _next(subject: Group, target: Group, side: str, gap: float) -> Relation:
    params = {"side": side, "gap": [round(max(0.0, gap - PLAY), 3), round(gap + PLAY, 3)]}
    return Relation(type="next_to", subject=subject.anchor.id, target=target.anchor.id, params=params)
