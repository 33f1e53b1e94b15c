"""Seats around a table as a waiter sets them: as many on one side as on the other, at even distances."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sceneweaver.scene import Scene, SceneObject

from .frames import local, world

Poses = dict[str, tuple[float, float, float, float]]

LONG = 1.3
"""Tables whose length is at least so many times their width have long sides and ends."""

ROUND = 0.35
"""Share of its length by which the seats of a long side keep away from the table's two corners, all in all."""


def spread(scene: Scene) -> Poses:
    """Poses for the seats of each table with four or more of one kind: see the module's text."""
    known = {o.id: o for o in scene.objects}
    groups: dict[tuple[str, str], dict[str, SceneObject]] = {}
    for r in scene.relations:
        if r.type == "front_against" and isinstance(r.target, str) and r.target in known and "gap" not in r.params:
            seat = known[r.subject]
            if seat.mount == "floor" and not seat.fixed:
                groups.setdefault((r.target, seat.category), {})[seat.id] = seat
    found: Poses = {}
    for (table, _), seats in groups.items():
        if len(seats) >= 4:
            found |= _around(known[table], list(seats.values()))
    return found


def _around(table: SceneObject, seats: Sequence[SceneObject]) -> Poses:
    """The seats on the two long sides shared out evenly and spaced; one seat at an end in its middle."""
    depth, width = table.size[0], table.size[1]
    if max(depth, width) < LONG * min(depth, width):
        return {}
    lengthwise = width >= depth  # whether the table is long along its own left and right
    length = max(depth, width)
    sides: dict[tuple[bool, int], list[tuple[float, float, SceneObject]]] = {}
    for seat in seats:
        u, v = local(seat, table)
        along, across = (v, u) if lengthwise else (u, v)
        turn = seat.pose.yaw - table.pose.yaw
        fu, fv = math.cos(turn), math.sin(turn)
        ahead, aside = (fu, fv) if lengthwise else (fv, fu)  # across the table, and along it
        if max(abs(ahead), abs(aside)) < 0.95:
            return {}  # somebody turned away on purpose
        at_end = abs(aside) > abs(ahead)
        side = int(math.copysign(1, along if at_end else across))
        sides.setdefault((at_end, side), []).append((along, across, seat))
    near, far = sides.get((False, -1), []), sides.get((False, 1), [])
    if not near and not far:
        return {}
    ends = [sides.get((True, side), []) for side in (-1, 1)]
    reach = sorted(abs(across) for _, across, _ in (*near, *far))[(len(near) + len(far)) // 2]
    for end in ends:  # one at an end; a second one there sits down with the others
        while len(end) > 1:
            along, across, seat = end.pop()
            (near if len(near) <= len(far) else far).append((along, across, seat))
    while abs(len(near) - len(far)) > 1:
        more, less = (near, far) if len(near) > len(far) else (far, near)
        less.append(more.pop())
    found: Poses = {}
    widest = max(seat.size[1] for seat in seats)
    for side, row in ((-1, near), (1, far)):
        step = length * (1 - ROUND) / max(1, len(row))
        if step < widest + 0.02:
            step = length / max(1, len(row))
        if step < widest + 0.02:
            return {}
        # A seat looks across the table: along its front where it is long to its left and right.
        yaw = table.pose.yaw + (0.0 if side < 0 else math.pi) + (0.0 if lengthwise else math.pi / 2)
        for k, (_, _, seat) in enumerate(sorted(row, key=lambda one: one[0])):
            found[seat.id] = _at(table, seat, (k - (len(row) - 1) / 2) * step, side * reach, lengthwise, yaw)
    for end in ends:
        for along, _, seat in end:
            quarter = round((seat.pose.yaw - table.pose.yaw) / (math.pi / 2))
            found[seat.id] = _at(table, seat, along, 0.0, lengthwise, table.pose.yaw + quarter * math.pi / 2)
    return found


def _at(
    table: SceneObject, seat: SceneObject, along: float, across: float, lengthwise: bool, yaw: float
) -> tuple[float, float, float, float]:
    u, v = (across, along) if lengthwise else (along, across)
    return world(table, u, v, seat.pose.position[2], yaw)
