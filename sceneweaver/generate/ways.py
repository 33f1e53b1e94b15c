"""The ways through a room that is given: from door to door, and from the doors to what stands in it."""

from __future__ import annotations

import math

from sceneweaver.scene import Door, FreeArea, Room

WAYS = "ways"
"""Id of the free area that says how wide all ways are; those of straight ways between doors begin with it."""

BASE = 0.55
"""Width of all ways [m]: a round base of 0.25 m gets along."""

STRAIGHT = 0.6
"""Width of the straight ways between doors [m]."""

THROUGH = 3
"""Doors from which on a room is one to walk through: its straight ways between doors are kept free."""


def ways_of(room: Room) -> tuple[FreeArea, ...]:
    """The free floor of a shell that is given: none where nobody can come in.

    Every room keeps ways from its doors to what stands in it. One that is walked through keeps straight ways between
    doors besides, as many as join them all, the shortest first; ways around a corner of the room are not straight.
    """
    if not room.doors:
        return ()
    found = [FreeArea(id=WAYS, kind="path", size=(BASE, BASE))]
    if len(room.doors) >= THROUGH:
        for first, second in _joining(room):
            pair = (first.id, second.id)
            found.append(FreeArea(id=f"{WAYS} {' '.join(pair)}", kind="path", size=(STRAIGHT, STRAIGHT), targets=pair))
    return tuple(found)


def _joining(room: Room) -> list[tuple[Door, Door]]:
    """Pairs of doors with a straight way between them that join as many doors as can be, the shortest first."""
    import shapely

    floor = shapely.Polygon(room.outline).buffer(1e-3)
    middles = {d.id: room.walls[d.wall].point(d.offset + d.width / 2) for d in room.doors}
    pairs = sorted(
        (round(math.dist(middles[a.id], middles[b.id]), 6), i, j)
        for i, a in enumerate(room.doors)
        for j, b in enumerate(room.doors[:i])
        if floor.covers(shapely.LineString([middles[a.id], middles[b.id]]))
    )
    group, found = list(range(len(room.doors))), list[tuple[Door, Door]]()
    for _, i, j in pairs:
        if group[i] != group[j]:
            old, new = group[i], group[j]
            group = [new if g == old else g for g in group]
            found.append((room.doors[j], room.doors[i]))
    return found
