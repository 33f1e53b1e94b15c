"""Patterns that show over several rooms: the same shell, paint and beds again and again."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Hashable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from benchmarks.patterns.room import Hits
from benchmarks.shell_signature import layout_signature, shell_signature
from sceneweaver.assets.taxonomy import members
from sceneweaver.scene import Room, Scene

RIGHT_END = 0.6
"""Distance [m] from the end of a wall up to which a door is at that end."""

Rooms = Mapping[str, Scene]
"""Scenes by name."""


def _again(looks: Mapping[str, Hashable]) -> Hits:
    """Those of which another looks the same."""
    count = Counter(looks.values())
    names = tuple(name for name, look in looks.items() if count[look] > 1)
    return Hits(len(names), len(looks), names)


def same_shell(rooms: Rooms) -> Hits:
    """Rooms with the shell of another of their kind."""
    return _again({name: (s.room.type, shell_signature(s.room)) for name, s in rooms.items()})


def same_layout(rooms: Rooms) -> Hits:
    """Rooms with the layout of another of their kind."""
    return _again({name: (s.room.type, layout_signature(s)) for name, s in rooms.items()})


def usual_shell(rooms: Rooms) -> Hits:
    """Rooms with the door in their first wall at its right end, as who stands inside sees it, and windows opposite."""
    names = tuple(name for name, scene in rooms.items() if _usual(scene.room))
    return Hits(len(names), len(rooms), names)


def _usual(room: Room) -> bool:
    if len(room.outline) != 4 or [d.wall for d in room.doors] != [0] or {w.wall for w in room.windows} != {2}:
        return False
    door, wall = room.doors[0], room.walls[0]
    return min(door.offset, wall.length - door.offset - door.width) < RIGHT_END


def one_paint(rooms: Rooms) -> Hits:
    """Kinds of rooms of which all rooms, two or more, have one paint on their walls."""
    paints: dict[str, list[str]] = defaultdict(list)
    for scene in rooms.values():
        finish = scene.room.finish
        paints[scene.room.type].append(finish.walls if finish else str(scene.provenance.get("finish")))
    several = {kind: found for kind, found in paints.items() if len(found) > 1}
    names = tuple(kind for kind, found in several.items() if len(set(found)) == 1)
    return Hits(len(names), len(several), names)


def same_beds(rooms: Rooms) -> Hits:
    """Rooms whose bed is of a category, material and colour that that of another room is of."""
    beds = {}
    for name, scene in rooms.items():
        found = [o for o in scene.objects if o.category in members("bed_group")]
        if found:
            bed = max(found, key=lambda o: o.size[0] * o.size[1])
            look = (bed.category, str(bed.attributes.get("material")), str(bed.attributes.get("color")))
            beds[name] = (*look, tuple(round(side, 1) for side in bed.size))
    return _again(beds)


class SetPattern(NamedTuple):
    """A pattern of many rooms: what it says, what is counted, how often strict eyes saw it, how it is measured."""

    text: str
    unit: str
    seen: str
    measure: Callable[[Rooms], Hits]


SET_PATTERNS: Mapping[str, SetPattern] = MappingProxyType(
    {
        "usual_shell": SetPattern("door at an end of wall 0, window opposite", "rooms", "15 of 15", usual_shell),
        "same_shell": SetPattern("the shell of another room of its kind", "rooms", "15 of 15", same_shell),
        "one_paint": SetPattern("one paint for a kind of room", "kinds", "15 of 15", one_paint),
        "same_layout": SetPattern("the layout of another room of its kind", "rooms", "-", same_layout),
        "same_bed": SetPattern("the bed of another room", "rooms", "19 of 32", same_beds),
    }
)
"""The patterns of many rooms by name."""
