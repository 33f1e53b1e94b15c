"""Grids as relations: tables of a restaurant in rows, desks of a classroom. The search finds where the grid stands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.scene import Relation, Room

from .prior_program import Wanted
from .prior_seats import seat_sides

PULL = 0.135
"""Depth [m] that belongs to a table behind a chair that is pulled up to it; the way between rows comes to it."""

WAYS = (1.0, 0.8, 0.6)
"""Widths [m] of the ways between rows that are tried; between neighbours in a row it is half of that."""

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


def _stands(one: Wanted) -> bool:
    return one.item is not None and one.item.row == "grid" and one.parent is None and one.support is None


def in_grid(program: Sequence[Wanted]) -> bool:
    """Whether enough of a program stands in rows for there to be a grid."""
    return sum(map(_stands, program)) >= LEAST


def grid_variants(program: Sequence[Wanted], room: Room, strip: float) -> list[tuple[Relation, ...]]:
    """The relations of grids of different shape, the roomiest first, that the floor less a strip [m] at the walls has
    space for: rows across the room and along it, of one kind of group each or of several."""
    groups = [_group(w, program) for w in program if _stands(w)]
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    length, depth = max(xs) - min(xs), max(ys) - min(ys)
    found: list[tuple[Relation, ...]] = []
    for mixed in (False, True):
        for way in WAYS:
            for margin in (strip, 0.75 * strip, 0.5 * strip):
                for long, deep in ((length, depth), (depth, length)):
                    rows = _rows(groups, long - 2 * margin, way, mixed)
                    relations = _relations(rows, long - 2 * margin, deep - 2 * margin, way) if rows else None
                    if relations and relations not in found:
                        found.append(relations)
        if found:
            break
    return found


def _group(anchor: Wanted, program: Sequence[Wanted]) -> Group:
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
