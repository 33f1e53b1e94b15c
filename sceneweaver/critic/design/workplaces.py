"""Offices and meeting rooms: storage in one block, desks in clusters, screens that all see, what is where."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

from sceneweaver.knowledge.design_rules import limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..survey import Survey
from .breach import breach
from .measure import applies, door_distance, middle, named, names, outlook

BLOCKS = named("locker filing_cabinet cabinet tall_cabinet metal_shelf library_shelf")
"""Storage of which several stand in one block."""

SCREENS = frozenset(("projector_screen", "tv"))

STANDS = named("flip_chart mobile_whiteboard")
"""What is turned to those who look at it."""

BINS = frozenset(("wastebasket", "trash_can"))

AT_WALL = 0.3
"""Distance [m] from the wall behind it up to which storage stands along it."""

LONG = 1.25
"""Length over depth from which a table has ends."""

CLUSTER = 4
"""Desks from which clusters are expected."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for workplaces and meetings."""
    yield from _blocks(survey)
    if applies(survey, "desk_clusters"):
        yield from _desks(survey)
    if survey.room_type.name in ("meeting_room", "classroom", "lecture_hall"):
        yield from _meeting(survey)
        yield from _stranded(survey)
    yield from _stands(survey)
    if applies(survey, "by_the_door"):
        yield from _by_the_door(survey)
    if applies(survey, "bin_at_desk"):
        yield from _bins(survey)


def _blocks(survey: Survey) -> Iterator[Finding]:
    """Equal storage that stands apart along a wall, or each on a wall of its own."""
    gap = limit("row_contiguous", "gap")
    sets: dict[tuple[Any, ...], list[Body]] = defaultdict(list)
    for body in survey.on_floor(BLOCKS):
        back = survey.back_wall(body)
        if body.size[2] > 0.7 and back is not None and back[1] < AT_WALL:  # others stand in aisles
            sets[body.item.category, *(round(s, 2) for s in body.size)].append(body)
    for (category, *_), bodies in sets.items():
        if len(bodies) < (2 if category == "locker" else 3):
            continue
        alone, least = [], math.inf
        for body in bodies:
            near = [g for b, g in survey.near(body, 3.0) if b in bodies]
            if not near or near[0] > gap:
                alone.append(body)
                least = min(least, *near, 3.0)
        if len(alone) >= 2:
            yield breach(
                "row_contiguous",
                (b.id for b in alone),
                f"{names(alone)} stand at least {least:.2f} m apart",
                measured=least,
                allowed=(None, gap),
                suggestion=f"put the {kinds.words(category)}s side by side",
            )


def _desks(survey: Survey) -> Iterator[Finding]:
    desks = survey.on_floor(kinds.DESKS - {"reception_desk", "dressing_table"})
    if len(desks) < CLUSTER:
        return
    joined = limit("desk_clusters", "gap")
    alone = [d for d in desks if not any(o in desks for o, _ in survey.near(d, joined))]
    if 2 * len(alone) > len(desks):
        yield breach(
            "desk_clusters",
            (d.id for d in alone),
            f"{len(alone)} of {len(desks)} desks stand alone, none within {joined:g} m",
            measured=float(len(alone)),
            allowed=(0.0, len(desks) / 2),
            suggestion="set the desks in clusters of two or four",
        )


# ---- meetings --------------------------------------------------------------------------------------------------------


def _meeting(survey: Survey) -> Iterator[Finding]:
    screens = [b for b in survey.of_kind(SCREENS)]
    tables = survey.on_floor(kinds.DINING)
    if not screens or not tables:
        return
    table = max(tables, key=lambda b: (round(b.size[0] * b.size[1], 4), b.id))
    seats = [b for b, _ in survey.near(table, 0.9) if seat_like(b) and table_of(survey, b) is table]
    for screen in screens:
        ahead, aside = table.local(screen.centre)
        long_ahead = table.size[0] > LONG * table.size[1]
        if max(table.size[:2]) > LONG * min(table.size[:2]) and applies(survey, "table_end_to_screen"):
            along_, across = (ahead, aside) if long_ahead else (aside, ahead)
            angle = math.degrees(math.atan2(abs(across), abs(along_)))
            if angle > limit("table_end_to_screen", "angle") + 15.0:
                yield breach(
                    "table_end_to_screen",
                    (table.id, screen.id),
                    f"{screen.id} is {angle:.0f} degrees off the long axis of {table.id}",
                    measured=angle,
                    allowed=(0.0, limit("table_end_to_screen", "angle")),
                    suggestion=f"turn the short end of {table.id} to {screen.id}",
                )
        backs = [s for s in seats if outlook(s, screen.centre) > limit("back_to_focus", "angle")]
        if backs:
            yield breach(
                "back_to_focus",
                (screen.id, *(s.id for s in backs)),
                f"{len(backs)} of {len(seats)} seats have their backs to {screen.id}",
                measured=float(len(backs)),
                weight=min(2.0, 0.25 + 0.5 * len(backs)),
                suggestion=f"leave the end of the table before {screen.id} free",
            )


def _stranded(survey: Survey) -> Iterator[Finding]:
    """Filing cabinets that stand by themselves along a wall."""
    gap = limit("piece_in_a_group", "gap")
    for body in survey.on_floor(("filing_cabinet",)):
        near = [b for b, _ in survey.near(body, gap) if kinds.groups_of(b.item.category) & {"storage", "table_group"}]
        if not near:
            yield breach(
                "piece_in_a_group",
                (body.id,),
                f"{body.id} stands alone, nothing within {gap:g} m",
                allowed=(None, gap),
                suggestion=f"put {body.id} beside the other storage",
            )


def _stands(survey: Survey) -> Iterator[Finding]:
    """Flip charts and menu boards turned away from people, and boards that no seat sees."""
    if not applies(survey, "board_seen"):
        return
    angle = limit("board_seen", "angle")
    tables = survey.on_floor(kinds.DINING, kinds.DESKS)
    for stand in survey.on_floor(STANDS, ("menu_board",)):
        clear = survey.clear_ahead(stand)
        turned = 0.0
        if stand.item.category in STANDS and tables:
            table = max(tables, key=lambda b: (round(b.size[0] * b.size[1], 4), b.id))
            turned = outlook(stand, table.centre)
        if clear < 1.0 or turned > angle:
            what = f"faces a wall at {clear:.2f} m" if clear < 1.0 else f"is turned {turned:.0f} degrees from the seats"
            yield breach(
                "board_seen",
                (stand.id,),
                f"{stand.id} {what}",
                measured=turned or clear,
                allowed=(0.0, angle) if turned else (1.0, None),
                suggestion=f"turn {stand.id} to the people that it is for",
                call=("update_rotation", {"ids": [stand.id], "toward": table.id}) if turned else None,
            )


# ---- what is where ---------------------------------------------------------------------------------------------------


def _by_the_door(survey: Survey) -> Iterator[Finding]:
    most = limit("by_the_door", "distance")
    for body in survey.on_floor(("coat_rack", "hall_stand", "umbrella_stand")):
        away = door_distance(survey, body)
        if most < away < math.inf:
            yield breach(
                "by_the_door",
                (body.id,),
                f"{body.id} stands {away:.1f} m from the door",
                measured=away,
                allowed=(None, most),
                suggestion=f"put {body.id} near the door",
                call=("add_relation", {"relations": [_near_door(survey, body, most)]}),
            )


def _near_door(survey: Survey, body: Body, most: float) -> dict[str, Any]:
    doors = survey.placed.doors
    door = min(doors, key=lambda d: (round(math.dist(body.centre, middle(d)), 3), d.item.id)).item.id
    return {"type": "near_door", "subject": body.id, "target": door, "params": {"max": most - 0.5}, "hard": False}


def _bins(survey: Survey) -> Iterator[Finding]:
    """Bins of an office that stand at no desk."""
    most = limit("bin_at_desk", "gap")
    desks = survey.on_floor(kinds.DESKS)
    if not desks:
        return
    for body in survey.on_floor(BINS):
        seats = [d for d, gap in survey.near(body, most) if d in desks and d.local(body.centre)[0] > -d.size[0] / 2]
        if not seats:
            gap = min(survey.placed.distance(body, d) for d in desks)
            yield breach(
                "bin_at_desk",
                (body.id,),
                f"{body.id} stands at no desk: {gap:.1f} m to the nearest one, or behind it",
                measured=gap,
                allowed=(None, most),
                suggestion=f"put {body.id} beside a desk",
            )
