"""Lines along walls: machines of a gym at even distances, the run of a kitchen flush side by side."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from sceneweaver.scene import Pose, Room

from .prior_program import Wanted

FLUSH = 0.004
"""Gap [m] to the wall, and between the pieces of a run."""

LOOSE = (0.12, 0.6)
"""Least and largest gap [m] between the pieces of a line."""

CURTAIN = 0.2
"""Length [m] of wall that a curtain takes on each side of its window."""

STEP = 0.1
"""Distance [m] between the places along a wall that are tried."""

Poses = dict[str, Pose]


@dataclass(frozen=True)
class Line:
    """Pieces that stand along one wall in this order."""

    pieces: tuple[Wanted, ...]
    flush: bool


def lines_of(program: Sequence[Wanted]) -> list[Line]:
    """The run, if items make one, then a line for each item that stands in one."""
    run = [w for w in program if w.item and w.item.row == "run" and w.mount == "floor"]
    run.sort(key=lambda w: (w.item.run if w.item and w.item.run is not None else 0.5, w.number))
    found = [Line(tuple(run), True)] if run else []
    by_item: dict[str, list[Wanted]] = {}
    for one in program:
        if one.item and one.item.row == "line" and one.mount == "floor" and one.parent is None:
            by_item.setdefault(one.item.id, []).append(one)
    return found + [Line(tuple(pieces), False) for pieces in by_item.values() if len(pieces) >= 2]


def set_out(
    lines: Sequence[Line], room: Room, taken: Iterable[Any], seed: int, curtained: bool = False
) -> Poses | None:
    """Poses of all lines, each at the first of the walls, in an order drawn by seed, that has room for it.

    Nothing stands before windows that are ``curtained``, and nothing taller than the sill before others. What is too
    long for one wall goes over the corner, or stands in two parts. ``taken`` are polygons that must stay free. None
    when something finds no wall.
    """
    import shapely

    rng = random.Random(seed)
    count = len(room.outline)
    blocked = [*taken, *_door_zones(room)]
    if curtained:
        blocked += [_before(room, w.wall, w.offset - CURTAIN, w.width + 2 * CURTAIN, 0.25) for w in room.windows]
    poses: Poses = {}
    ways: list[Any] = []  # free space that the pieces of earlier lines need
    queue = list(lines)
    while queue:
        line = queue.pop(0)
        order = list(range(count))
        rng.shuffle(order)
        order.sort(key=lambda i: _doors_at(room, i))
        found = None
        for wall in order:
            found = _along(line, room, wall, blocked, ways) or _around_corner(line, room, wall, blocked, ways)
            if found is not None:
                break
        if found is None and len(line.pieces) >= 4:
            half = len(line.pieces) // 2
            queue[:0] = [Line(line.pieces[:half], line.flush), Line(line.pieces[half:], line.flush)]
            continue
        if found is None:
            return None
        for one, pose in found:
            poses[one.id] = pose
            blocked.append(shapely.Polygon(_rectangle(one, pose, 0.0 if line.flush else 0.5 * LOOSE[0])))
            ways += _ways(one, pose)
    return poses


def _doors_at(room: Room, wall: int) -> int:
    return sum(d.wall == wall for d in room.doors)


def _frame(room: Room, wall: int) -> tuple[Any, Any, Any, float]:
    a, b = room.outline[wall], room.outline[(wall + 1) % len(room.outline)]
    length = math.dist(a, b)
    t = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
    return a, t, (-t[1], t[0]), length


def _door_zones(room: Room) -> list[Any]:
    return [_before(room, d.wall, d.offset, d.width, d.width if d.swing.startswith("in") else 0.6) for d in room.doors]


def _before(room: Room, wall: int, offset: float, width: float, deep: float) -> Any:
    """The rectangle before a stretch of a wall."""
    import shapely

    p, t, n, _ = _frame(room, wall)
    a = (p[0] + offset * t[0], p[1] + offset * t[1])
    b = (a[0] + width * t[0], a[1] + width * t[1])
    return shapely.Polygon([a, b, (b[0] + deep * n[0], b[1] + deep * n[1]), (a[0] + deep * n[0], a[1] + deep * n[1])])


def _along(
    line: Line,
    room: Room,
    wall: int,
    blocked: Sequence[Any],
    ways: Sequence[Any],
    start: float = 0.0,
    only: float | None = None,
) -> list[tuple[Wanted, Pose]] | None:
    """The whole line at one wall; ``start`` [m] is taken at its beginning, ``only`` fixes where it begins."""
    *_, length = _frame(room, wall)
    widths = [one.asset.size[1] for one in line.pieces]
    spare = length - start - sum(widths) - 2 * FLUSH
    gaps = max(0, len(widths) - 1)
    if spare < gaps * (FLUSH if line.flush else LOOSE[0]):
        return None
    gap = FLUSH if line.flush else min(LOOSE[1], max(LOOSE[0], spare / (gaps + 2)))
    total = sum(widths) + gap * gaps
    play = max(0.0, length - start - total - 2 * FLUSH)
    if only is not None:
        offsets = [only]
    else:
        offsets = [start + FLUSH + STEP * k for k in range(int(play / STEP) + 1)] + [start + FLUSH + play]
        middle = start + FLUSH + play / 2
        # A run begins in a corner, a line stands in the middle of its wall.
        offsets.sort(key=lambda v: min(v - start, start + play - v) if line.flush else abs(v - middle))
    for offset in offsets:
        placed = _placed(line.pieces, gap, room, wall, offset, blocked, ways)
        if placed is not None:
            return placed
    return None


def _placed(
    pieces: Sequence[Wanted],
    gap: float,
    room: Room,
    wall: int,
    offset: float,
    blocked: Sequence[Any],
    ways: Sequence[Any],
) -> list[tuple[Wanted, Pose]] | None:
    import shapely

    p, t, n, length = _frame(room, wall)
    yaw = math.atan2(n[1], n[0])
    out, at = [], offset
    floor = shapely.Polygon(room.outline).buffer(1e-3)
    for one in pieces:
        d, w, h = one.asset.size
        if at + w > length + 1e-6:
            return None
        for window in room.windows:
            if (
                window.wall == wall
                and h > window.sill - 0.01
                and at < window.offset + window.width
                and (at + w > window.offset)
            ):
                return None
        across = d / 2 + FLUSH
        x = p[0] + (at + w / 2) * t[0] + across * n[0]
        y = p[1] + (at + w / 2) * t[1] + across * n[1]
        pose = Pose.from_yaw(x, y, 0.0, yaw + (math.pi if one.mounted_from_behind else 0.0))
        body = shapely.Polygon(_rectangle(one, pose, -1e-4))
        if not floor.contains(body) or any(body.intersects(other) for other in (*blocked, *ways)):
            return None
        if any(way.intersects(other) for way in _ways(one, pose) for other in blocked):
            return None
        out.append((one, pose))
        at += w + gap
    return out


def _around_corner(
    line: Line, room: Room, wall: int, blocked: Sequence[Any], ways: Sequence[Any]
) -> list[tuple[Wanted, Pose]] | None:
    """A run over two walls: its first pieces end in the corner, the others begin behind them on the next wall."""
    import shapely

    if not line.flush or len(line.pieces) < 3:
        return None
    *_, length = _frame(room, wall)
    after = (wall + 1) % len(room.outline)
    for cut in range(len(line.pieces) - 1, 0, -1):
        first, second = line.pieces[:cut], line.pieces[cut:]
        total = sum(o.asset.size[1] for o in first) + FLUSH * (cut - 1)
        if total > length - 2 * FLUSH:
            continue
        head = _placed(first, FLUSH, room, wall, length - FLUSH - total, blocked, ways)
        if head is None:
            continue
        deep = max(o.asset.size[0] for o in first) + 3 * FLUSH
        others = [*blocked, *(shapely.Polygon(_rectangle(one, pose, 0.0)) for one, pose in head)]
        tail = _along(Line(tuple(second), True), room, after, others, ways, start=deep, only=deep)
        if tail is not None:
            return head + tail
    return None


def _ways(one: Wanted, pose: Pose) -> list[Any]:
    """The free space that a piece needs, a little less than all of it."""
    import shapely
    from shapely import affinity

    found = []
    for zone in one.asset.zones:
        if zone.hard:
            shape = affinity.rotate(shapely.Polygon(zone.polygon).buffer(-0.01), pose.yaw, (0, 0), use_radians=True)
            found.append(affinity.translate(shape, pose.position[0], pose.position[1]))
    return found


def _rectangle(one: Wanted, pose: Pose, margin: float) -> list[tuple[float, float]]:
    """The footprint, with the free space that its front needs."""
    d, w, _ = one.asset.size
    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    (x, y, _), m = pose.position, margin
    corners = ((-d / 2 - m, -w / 2 - m), (d / 2 + m, -w / 2 - m), (d / 2 + m, w / 2 + m), (-d / 2 - m, w / 2 + m))
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in corners]
