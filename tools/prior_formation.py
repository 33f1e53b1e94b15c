"""Regular formations: tables of a restaurant in rows, desks of a classroom, machines along a wall."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass

from sceneweaver.scene import Pose, Room, Scene

from .prior_lines import lines_of, set_out
from .prior_program import Wanted

PULL = 0.12
"""Depth [m] behind a chair that belongs to its table; the way between rows comes to it."""

WAYS = (1.0, 0.8, 0.6)
"""Widths [m] of the ways between rows that are tried; between neighbours in a row it is half of that."""

Local = dict[str, tuple[float, float, float]]


@dataclass(frozen=True)
class Group:
    """An anchor with what belongs to it: poses (x, y, yaw) in the anchor's frame, and the box around all [m].

    ``box`` is (x0, y0, x1, y1) with the room that its seats need.
    """

    anchor: Wanted
    poses: Local
    box: tuple[float, float, float, float]


def formations(program: Sequence[Wanted], scene: Scene, seed: int, most: int = 6) -> list[dict[str, Pose]]:
    """Up to ``most`` ways to set out what stands in grids, lines and runs; empty when nothing does, or nothing fits."""
    groups, lines = _groups_of(program, scene), lines_of(program)
    if not groups and not lines:
        return []
    drafts: list[dict[str, Pose]] = []
    grids = _grids(groups, program, scene, seed, most) if groups else [{}]
    if not grids:
        return []
    sizes = {w.id: w.asset.size for w in program}
    curtained = any(r.type == "at_window" and scene.object(r.subject).mount == "wall" for r in scene.relations)
    for k in range(most if lines else 1):
        for n, grid in enumerate(grids):
            if len(drafts) == most:
                return drafts
            if not lines:
                drafts.append(grid)
                continue
            taken = [_footprint(pose, sizes[id]) for id, pose in grid.items()]
            poses = set_out(lines, scene.room, taken, seed + 31 * k + n, curtained)
            if poses is not None and {**grid, **poses} not in drafts:
                drafts.append({**grid, **poses})
    return drafts or [grid for grid in grids if grid]


def in_rows(program: Sequence[Wanted]) -> bool:
    """Whether something of a program stands in grids, lines or runs."""
    return len(_anchors(program)) >= 3 or bool(lines_of(program))


def _anchors(program: Sequence[Wanted]) -> list[Wanted]:
    return [w for w in program if w.item and w.item.row == "grid" and w.parent is None and w.support is None]


def _grids(
    groups: Sequence[Group], program: Sequence[Wanted], scene: Scene, seed: int, most: int
) -> list[dict[str, Pose]]:
    rng = random.Random(seed ^ 0xF0F0)
    strip = _strip(program)
    margins = (strip, 0.75 * strip, 0.5 * strip)
    tries = [(turn, margin, way) for way in WAYS for margin in margins for turn in (0, 1, 2, 3)]
    head, tail = tries[:8], tries[8:]
    rng.shuffle(head)
    found: list[dict[str, Pose]] = []
    for mixed in (False, True):
        for turn, margin, way in (*head, *tail):
            if len(found) == most:
                return found
            draft = _grid(groups, scene.room, turn, margin, way, mixed)
            if draft is not None:
                found.append(draft)
        if found:
            break
    return found


def _footprint(pose: Pose, size: tuple[float, float, float]):
    import shapely

    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    (x, y, _), (d, w, _) = pose.position, size
    corners = ((-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2))
    return shapely.Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in corners]).buffer(0.3)


def _groups_of(program: Sequence[Wanted], scene: Scene) -> list[Group]:
    """The groups whose anchor's item stands in a grid, where there are three or more."""
    anchors = _anchors(program)
    if len(anchors) < 3:
        return []
    return [_group(a, [w for w in program if w.parent is a and w.mount == "floor"], scene) for a in anchors]


def _group(anchor: Wanted, members: Sequence[Wanted], scene: Scene) -> Group:
    d, w, _ = anchor.asset.size
    poses: Local = {anchor.id: (0.0, 0.0, 0.0)}
    sides = _seats(anchor, members)
    low, high = [-d / 2, -w / 2], [d / 2, w / 2]
    for zone in anchor.asset.zones:
        if zone.hard:
            for x, y in zone.polygon:
                low, high = [min(low[0], x), min(low[1], y)], [max(high[0], x), max(high[1], y)]
    for one, (x, y, yaw) in sides.items():
        poses[one] = (x, y, yaw)
        reach = scene.object(one).size[0] / 2 + PULL
        back = (x - reach * math.cos(yaw), y - reach * math.sin(yaw))
        for k in (0, 1):
            low[k], high[k] = min(low[k], back[k]), max(high[k], back[k])
    return Group(anchor, poses, (low[0], low[1], high[0], high[1]))


def _seats(anchor: Wanted, members: Sequence[Wanted]) -> Local:
    """Chairs at their table: at its front where they belong to the front, else on the long sides, then on the short."""
    d, w, _ = anchor.asset.size
    front = [m for m in members if _only_front(m)]
    free = [m for m in members if m not in front]
    poses: Local = {}
    _line(poses, front, (d / 2, 0.0), (0.0, 1.0), w, math.pi, anchor)
    if not free:
        return poses
    if abs(d - w) < 0.12 * max(d, w) and "round" in anchor.category:
        for k, one in enumerate(free):
            turn = 2 * math.pi * k / len(free)
            reach = d / 2 + _out(one, anchor)
            poses[one.id] = (reach * math.cos(turn), reach * math.sin(turn), turn + math.pi)
        return poses
    if len(free) == 1:
        _line(poses, free, (d / 2, 0.0), (0.0, 1.0), w, math.pi, anchor)
        return poses
    along = w >= d
    length = w if along else d
    width = max(one.asset.size[1] for one in free) + 0.08
    ends = 0
    while len(free) - 2 * ends > 2 * max(1, int(length / width)) and ends < 2:
        ends += 1
    per_side = len(free) - ends
    first, second = free[: (per_side + 1) // 2], free[(per_side + 1) // 2 : per_side]
    heads = free[per_side:]
    axis = (0.0, 1.0) if along else (1.0, 0.0)
    if along:
        _line(poses, first, (d / 2, 0.0), axis, w, math.pi, anchor)
        _line(poses, second, (-d / 2, 0.0), axis, w, 0.0, anchor)
        _line(poses, heads[:1], (0.0, w / 2), (1.0, 0.0), d, -math.pi / 2, anchor)
        _line(poses, heads[1:], (0.0, -w / 2), (1.0, 0.0), d, math.pi / 2, anchor)
    else:
        _line(poses, first, (0.0, w / 2), axis, d, -math.pi / 2, anchor)
        _line(poses, second, (0.0, -w / 2), axis, d, math.pi / 2, anchor)
        _line(poses, heads[:1], (d / 2, 0.0), (0.0, 1.0), w, math.pi, anchor)
        _line(poses, heads[1:], (-d / 2, 0.0), (0.0, 1.0), w, 0.0, anchor)
    return poses


def _only_front(member: Wanted) -> bool:
    places = member.item.place if member.item else ()
    return any(p.type == "front_to_front" and p.to == (member.item and member.item.with_) for p in places)


def _out(one: Wanted, anchor: Wanted) -> float:
    """How far the middle of a seat lies beyond the edge of its table: just clear of it, to be pushed in later."""
    return one.asset.size[0] / 2 + 0.015


def _line(
    poses: Local,
    seats: Sequence[Wanted],
    edge: tuple[float, float],
    axis: tuple[float, float],
    length: float,
    yaw: float,
    anchor: Wanted,
) -> None:
    """Seats evenly along one edge, facing it."""
    for k, one in enumerate(seats):
        at = ((k + 0.5) / len(seats) - 0.5) * length
        out = _out(one, anchor)
        x = edge[0] + axis[0] * at - out * math.cos(yaw)
        y = edge[1] + axis[1] * at - out * math.sin(yaw)
        poses[one.id] = (x, y, yaw)


def _strip(program: Sequence[Wanted]) -> float:
    """Depth [m] along the walls that other things need, a way included."""
    deep = [w.asset.size[0] for w in program if w.wall > 0.0]
    return (max(deep) if deep else 0.0) + 0.9


def _grid(
    groups: Sequence[Group], room: Room, turn: int, margin: float, way: float, mixed: bool
) -> dict[str, Pose] | None:
    """Rows of groups, of one kind unless ``mixed``, spread over the room less ``margin`` [m] along its walls.

    None when they do not fit.
    """
    xs, ys = [p[0] for p in room.outline], [p[1] for p in room.outline]
    x0, x1, y0, y1 = min(xs) + margin, max(xs) - margin, min(ys) + margin, max(ys) - margin
    # In the frame of the formation rows run along y; a quarter turn swaps the room's sides.
    long, deep = (y1 - y0, x1 - x0) if turn % 2 == 0 else (x1 - x0, y1 - y0)
    if long <= 0 or deep <= 0:
        return None
    rows: list[list[Group]] = []
    for group in sorted(groups, key=lambda g: (-(g.box[2] - g.box[0]), g.anchor.id.rsplit("-", 1)[0])):
        wide = group.box[3] - group.box[1]
        for row in rows:
            taken = sum(g.box[3] - g.box[1] for g in row) + 0.5 * way * len(row)
            if taken + wide <= long and (mixed or row[0].anchor.category == group.anchor.category):
                row.append(group)
                break
        else:
            if wide > long:
                return None
            rows.append([group])
    _even(rows)
    depths = [max(g.box[2] - g.box[0] for g in row) for row in rows]
    spare = deep - sum(depths)
    if spare < way * (len(rows) - 1):
        return None
    gap = min(spare / max(1, len(rows)), 1.5)
    start = (deep - sum(depths) - gap * (len(rows) - 1)) / 2
    poses: dict[str, Pose] = {}
    cx, cy, yaw = (x0 + x1) / 2, (y0 + y1) / 2, turn * math.pi / 2
    for row, depth in zip(rows, depths, strict=True):
        wides = [g.box[3] - g.box[1] for g in row]
        free = long - sum(wides)
        between = min(free / max(1, len(row)), 1.1)
        at = (long - sum(wides) - between * (len(row) - 1)) / 2
        for group, wide in zip(row, wides, strict=True):
            middle_x = (group.box[0] + group.box[2]) / 2
            middle_y = (group.box[1] + group.box[3]) / 2
            u = start + depth / 2 - middle_x - deep / 2
            v = at + wide / 2 - middle_y - long / 2
            for id, (x, y, turned) in group.poses.items():
                a, b = u + x, v + y
                poses[id] = Pose.from_yaw(
                    cx + a * math.cos(yaw) - b * math.sin(yaw),
                    cy + a * math.sin(yaw) + b * math.cos(yaw),
                    0.0,
                    _wrapped(yaw + turned),
                )
            at += wide + between
        start += depth + gap
    return poses


def _even(rows: list[list[Group]]) -> None:
    """Level rows of the same kind, so that none has two groups more than another."""
    for row in rows:
        for other in rows:
            while other[0].anchor.category == row[0].anchor.category and len(row) - len(other) > 1:
                other.append(row.pop())


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
