"""Doors that lead outside from rooms other than the entrance, added to a plan that is solved."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from sceneweaver.home import Home, HomeDoor
from sceneweaver.plans import Envelope, Profile, Programme, check_plan

WIDTH, JAMB = 0.95, 0.15
"""Clear width of such a door, and wall [m] beside it."""

BEYOND = 0.6
"""How far [m] behind an outer wall's face no room may be."""


def with_outside_doors(
    home: Home, names: Collection[str], programme: Programme, profile: Profile | str, envelope: Envelope
) -> Home:
    """The home with a door outside in each room of these ids that has none, where one can be.

    A door is put where the outer wall of the room is free of windows and doors, and the exact checker still calls the
    plan valid; rooms in which there is no such place stay as they are.
    """
    for name in names:
        ids = {room.id for room in home.rooms}
        if name not in ids or has_outside_door(home, name):
            continue
        for door in _candidates(home, name):
            changed = home.with_changes(doors=(*home.doors, door))
            if check_plan(changed, programme, profile, envelope=envelope).valid:
                home = changed
                break
    return home


def has_outside_door(home: Home, name: str) -> bool:
    """Whether a door leads from a room out of the home."""
    return any(door.room == name and door.to is None for door in home.doors)


def _candidates(home: Home, name: str) -> Iterator[HomeDoor]:
    """Doors at the ends and in the middle of each stretch of outer wall, into the room and out of it."""
    import shapely

    shell, room = home.shell(name), home.room(name)
    others = [shapely.Polygon(r.outline) for r in home.rooms if r.storey == room.storey and r.id != name]
    taken = {door.id for door in home.doors} | {window.id for window in home.windows}
    own = next(f"outside-{k}" for k in range(1, 99) if f"outside-{k}" not in taken)
    for wall in shell.walls:
        spans = [(o.offset, o.offset + o.width) for o in (*shell.doors, *shell.windows) if o.wall == wall.index]
        at = 0.0
        for low, high in [*sorted(spans), (wall.length, wall.length)]:
            first, last = at + JAMB, low - JAMB - WIDTH
            at = max(at, high)
            for offset in dict.fromkeys((first, last, (first + last) / 2)) if last >= first else ():
                start = round(round(offset * 1000) / 1000, 3)
                a, out = wall.start, (wall.along[1], -wall.along[0])
                ends = [(a[0] + wall.along[0] * s, a[1] + wall.along[1] * s) for s in (start, start + WIDTH)]
                beyond = shapely.Polygon([*ends, *((x + out[0] * BEYOND, y + out[1] * BEYOND) for x, y in ends[::-1])])
                if any(beyond.intersection(other).area > 1e-6 for other in others):
                    continue
                for into in (name, None):
                    for hinge in ("left", "right"):
                        yield HomeDoor(
                            id=own, room=name, wall=wall.index, offset=start, width=WIDTH, opens_into=into, hinge=hinge
                        )
