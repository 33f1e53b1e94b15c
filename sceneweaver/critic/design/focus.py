"""What seats look at: the screen of their group, how large it is, how high, and what stands in the way."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..groups import Seating, groups_of
from ..survey import Survey, turn_to
from .breach import breach

HOME = frozenset(("living_room", "studio_apartment", "home_theatre", "sunroom", "game_room", "hotel_room"))
"""Rooms in which a seating group is set around its screen."""

WATCHED = frozenset(("waiting_room", "reception", "hospital_room", "bar"))
"""Rooms in which a screen is there for whoever sits in the room."""

NEAR_SCREEN = 5.0
"""Distance [m] from which a screen of a waiting room is read."""

SEEN_BY = 0.4
"""Share of the seats of a waiting room that should see its screen."""

SLACK = 0.9
"""Share of the width that a screen should have from which on it passes."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Seats that do not see their screen, screens that are too small, too high, or two."""
    groups = groups_of(survey)
    if survey.room_type.name in HOME:
        for group in groups.seatings:
            if group.focus is not None:
                yield from _seats(survey, group, group.focus)
                yield from _size(group.focus, group.anchor)
                yield from _height(group.focus)
    elif survey.room_type.name in WATCHED:
        for screen in survey.of_kind(kinds.TVS):
            yield from _watched(survey, screen)
    yield from _several(survey)


def _seats(survey: Survey, group: Seating, focus: Body) -> Iterator[Finding]:
    back, side = limit("back_to_focus", "angle"), limit("seat_sees_focus", "angle")
    for seat in group.seats:
        if seat.item.category not in kinds.LOUNGE:
            continue
        angle = math.degrees(turn_to(seat, focus.centre))
        if angle > side:
            away = angle > back
            yield breach(
                "back_to_focus" if away else "seat_sees_focus",
                (seat.id, focus.id),
                f"{seat.id} is turned {angle:.0f} degrees away from {focus.id}"
                + (", with its back to what the others look at" if away else ""),
                measured=angle,
                allowed=(None, side),
                suggestion=f"put {seat.id} where it looks at {focus.id}",
            )
        elif (other := between(survey, seat, focus)) is not None:
            yield breach(
                "focus_unblocked",
                (other.id, seat.id, focus.id),
                f"{other.id} stands between {seat.id} and {focus.id}",
                suggestion=f"move {other.id} out of the line of sight",
            )


def between(survey: Survey, seat: Body, focus: Body) -> Body | None:
    """What is higher than the eyes of someone who sits, on the line from a seat to a screen."""
    import shapely

    eyes = limit("focus_unblocked", "eye")
    line = shapely.LineString([seat.centre, focus.centre])
    base = focus.item.support.object if focus.item.support else None
    for row in survey.tree.query(line, predicate="intersects"):
        other = survey.bodies[int(row)]
        if other in (seat, focus) or other.item.mount != "floor" or other.id == base:
            continue
        if other.z[1] > max(eyes, focus.z[0]) and not _holds(other, focus):
            return other
    return None


def _holds(other: Body, focus: Body) -> bool:
    """Whether a screen hangs right over a piece of furniture."""
    ahead, aside = other.local(focus.centre)
    return abs(ahead) < other.size[0] / 2 + 0.05 and abs(aside) < other.size[1] / 2


def _size(screen: Body, anchor: Body) -> Iterator[Finding]:
    if screen.item.category not in kinds.TVS:
        return
    distance = math.dist(screen.centre, anchor.centre)
    least = limit("screen_width", "share") * distance
    if screen.size[1] < SLACK * least:
        yield breach(
            "screen_width",
            (screen.id,),
            f"{screen.id} is {screen.size[1]:.2f} m wide at {distance:.1f} m from {anchor.id}",
            measured=screen.size[1],
            allowed=(round(least, 2), None),
            suggestion=f"take a screen of {least:.1f} m, or move {anchor.id} nearer",
        )


def _height(screen: Body) -> Iterator[Finding]:
    low, high = limit("screen_height", "low"), limit("screen_height", "high")
    middle = (screen.z[0] + screen.z[1]) / 2
    if screen.item.category == "tv" and not low <= middle <= high:
        yield breach(
            "screen_height",
            (screen.id,),
            f"the middle of {screen.id} is {middle:.2f} m above the floor",
            measured=middle,
            allowed=(low, high),
            suggestion=f"hang {screen.id} with its middle at 1.1 m",
        )


def _watched(survey: Survey, screen: Body) -> Iterator[Finding]:
    """A screen of a waiting room that few of the seats see."""
    seats = [b for b in survey.standing if b.item.category in kinds.LOUNGE | {"waiting_bench"} or _guest(b)]
    if not seats:
        return
    most = limit("seat_sees_focus", "angle")
    seen = [
        s
        for s in seats
        if math.dist(s.centre, screen.centre) <= NEAR_SCREEN
        and math.degrees(turn_to(s, screen.centre)) <= most
        and math.degrees(turn_to(screen, s.centre)) <= most
        and between(survey, s, screen) is None
    ]
    if len(seen) < SEEN_BY * len(seats):
        yield breach(
            "seat_sees_focus",
            (screen.id,),
            f"{len(seen)} of {len(seats)} seats see {screen.id} from less than {NEAR_SCREEN:g} m",
            measured=len(seen) / len(seats),
            allowed=(SEEN_BY, None),
            suggestion=f"hang {screen.id} before the seats",
        )
        farthest = max(seats, key=lambda s: (round(math.dist(s.centre, screen.centre), 3), s.id))
        yield from _size(screen, farthest)


def _guest(body: Body) -> bool:
    return kinds.upright_seat(body.item.category) and body.item.category != "office_chair"


def _several(survey: Survey) -> Iterator[Finding]:
    if not design_rules()["one_screen"].applies(survey.room_type.name):
        return
    screens = survey.of_kind(("tv", "tv_on_stand"))
    asked = any(e.category in ("tv", "tv_on_stand") for e in survey.brief.entities)
    if len(screens) > 1 and not asked:
        spare = [b.id for b in screens[1:]]
        yield breach(
            "one_screen",
            (b.id for b in screens),
            f"{len(screens)} televisions in one room",
            measured=float(len(screens)),
            allowed=(None, 1.0),
            suggestion=f"remove {', '.join(spare)}",
            call=("remove_objects", {"ids": spare}),
        )
