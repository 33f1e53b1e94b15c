"""Which of many valid layouts is good: the design rules as terms that the engine rates all candidates by.

A term is about the objects of a scene before their poses are known, so what belongs together is read from relations and
categories. What a relation of the room demands anyway may be among the terms: then it takes nothing off.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.critic import kinds
from sceneweaver.critic.design.clearance import BELOW_WINDOWS, BOARDS, BROWSED, OPENED
from sceneweaver.critic.design.fill import largest_allowed
from sceneweaver.critic.design.visitors import BESIDE, STAFFED, VISITORS
from sceneweaver.critic.design.walls import CLOSE, PLAIN, TALL
from sceneweaver.critic.design.ways import ACROSS, BODY, GOALS, GRID, REACH, USED
from sceneweaver.critic.groups import COUNTERS
from sceneweaver.geometry.shell import heights
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.design_rules import limit
from sceneweaver.layout import QualityTerm
from sceneweaver.scene import Scene

from . import choice_groups, choice_order
from .choice_rules import Rules

MOST_GOALS, MOST_REACHED = 8, 32
"""Ways that are measured: to the largest pieces."""

ONE = 0.7
"""Share of the points of a rule that one of several costs where the critic names them together."""

LEVEL = 0.14
"""Width [m] that a way may lack more, as the terms' grid is coarser than the critic's."""


def choice_terms(scene: Scene, room_type: RoomType) -> list[QualityTerm]:
    """The terms of design quality for a scene in a kind of room, whatever its poses are.

    Args:
        scene: what is to be laid out; members of the terms are its objects, doors, windows and walls.
        room_type: the kind of room, which says what rules there are.
    """
    rules = Rules(scene, room_type.name)
    return [
        *choice_groups.terms(rules),
        *choice_order.terms(rules),
        *_doors(rules),
        *_use(rules),
        *_ways(rules),
        *_walls(rules),
        *_tables(rules),
        *_fill(rules),
    ]


def _doors(rules: Rules) -> Iterator[QualityTerm]:
    """Furniture beside door frames; beds and desks as seen from the door."""
    gap, touching = limit("door_frame", "gap"), limit("door_frame", "touching")
    for door in rules.scene.room.doors:
        for o in rules.standing:
            if o.id not in rules.movable:
                yield from rules.term("door_frame", "gap", o.id, door.id, low=gap, span=gap - touching)
        for bed in rules.of_kind(kinds.BEDS):
            yield from rules.term("bed_off_door_wall", "backing", bed.id, door.id, low=0.4, span=0.1)
            yield from rules.term("bed_off_door_wall", "bearing", bed.id, door.id, high=1.6, span=1.0, share=0.5)
        for desk in rules.of_kind(("reception_desk", "host_stand")):
            most = math.radians(limit("desk_looks_at_door", "angle"))
            yield from rules.term("desk_looks_at_door", "bearing", desk.id, door.id, high=most, span=0.5)


def _use(rules: Rules) -> Iterator[QualityTerm]:
    """Room before what is used and behind who sits and serves; nothing high before windows."""
    clear, light = limit("before_use", "clear"), rules.movable
    for depth, wanted in ((clear, OPENED), (clear / 2, BROWSED)):
        for o in rules.of_kind(wanted):
            if o.mount == "floor":
                yield from rules.term("before_use", "clear", o.id, *light, low=depth, span=depth)
    for board in rules.of_kind(BOARDS):
        seats = [o.id for o in rules.of_kind(kinds.SEATED_AT)] if board.mount == "wall" else []
        yield from rules.term("before_use", "clear", board.id, *light, *seats, low=clear, span=clear)
    for counter in rules.of_kind(COUNTERS):
        depth = limit("behind_counter", "clear")
        yield from rules.term("behind_counter", "clear", counter.id, *light, low=depth, span=0.5, side=2)
    depth = limit("staff_and_visitors_apart", "depth")
    for desk in rules.of_kind(STAFFED - {"host_stand"}):
        for o in rules.of_kind(VISITORS):
            if o.mount == "floor" and desk.mount == "floor":
                far = {"depth": depth + desk.size[0] / 2, "side": 2.0, "beside": BESIDE}
                half = min(o.size[:2]) / 2
                rule = "staff_and_visitors_apart"
                yield from rules.term(rule, "overlap", o.id, desk.id, high=half, span=0.1, share=ONE, **far)
    behind = limit("behind_seats", "clear") - 0.15
    for seat in rules.standing:
        if kinds.upright_seat(seat.category) and seat.category != "stool":
            tables = [o.id for o in rules.tied(seat, kinds.SEATED_AT)]
            if tables:
                others = [o for o in light if o != seat.id] + tables
                yield from rules.term("behind_seats", "clear", seat.id, *others, low=behind, span=0.3, side=2)
    most, depth = limit("low_below_windows", "above_sill"), limit("before_use", "window")
    for window in rules.scene.room.windows:
        for o in rules.standing:
            if o.size[2] > heights(window)[0] + most and o.category not in BELOW_WINDOWS and o.id not in light:
                yield from rules.term("low_below_windows", "overlap", o.id, window.id, high=0.15, span=0.2, depth=depth)


def _ways(rules: Rules) -> Iterator[QualityTerm]:
    """Ways from the doors to windows, to the largest pieces, and to the front of all that stands on the floor."""
    if not rules.scene.room.doors:
        return
    width = limit("way_to_window", "width") - GRID - LEVEL
    for window in rules.scene.room.windows:
        yield from rules.term("way_to_window", "way", window.id, low=width, span=0.3, reach=ACROSS)
    width = limit("way_to_group", "width") - GRID - LEVEL
    for o in [o for o in rules.standing if o.category in GOALS][:MOST_GOALS]:
        yield from rules.term("way_to_group", "way", o.id, low=width, span=0.3, share=ONE, reach=REACH)
    near = limit("reachable", "gap") - 0.1
    for o in rules.standing[:MOST_REACHED]:
        if o.category in USED:
            side = 0 if o.category in kinds.WALL_BACKED else -1
            yield from rules.term("reachable", "way", o.id, low=BODY - LEVEL, span=0.2, reach=near, side=side)


def _walls(rules: Rules) -> Iterator[QualityTerm]:
    """Walls with nothing on them."""
    room = rules.scene.room
    run = limit("wall_covered", "length") * (2.0 if rules.room in PLAIN else 1.0)
    for k, wall in enumerate(room.walls):
        if wall.length >= run:
            openings = [o.id for o in room.openings_of(k)]
            most = min(2.0 * run, (1.0 - limit("wall_covered", "share")) * wall.length)
            yield from rules.term(
                *("wall_covered", "bare", f"wall:{k}", *openings),
                high=0.8 * most,
                span=0.2 * most,
                depth=CLOSE,
                tall=TALL,
                run=run,
            )


def _tables(rules: Rules) -> Iterator[QualityTerm]:
    """Tables that people sit around, off the walls."""
    walls = [f"wall:{k}" for k in range(len(rules.scene.room.outline))]
    least = limit("table_off_walls", "gap")
    for table in rules.of_kind(kinds.DINING):
        around = [o for o in rules.standing if kinds.upright_seat(o.category) and table in rules.tied(o, kinds.DINING)]
        if table.mount == "floor" and len(around) >= (3 if "round" in table.category else 4):
            yield from rules.term("table_off_walls", "nearest", table.id, *walls, low=least, span=least)


def _fill(rules: Rules) -> Iterator[QualityTerm]:
    """Empty floor."""
    side = largest_allowed(rules.room)
    if rules.standing:
        yield from rules.term("no_empty_floor", "empty", high=side, span=0.15)
        yield from rules.term("no_empty_floor", "empty", high=side, span=side)
