"""Patterns that strict eyes counted over many rooms, as measures of one room: how often, out of how many.

Most are breaches of design rules, which the critic finds; the others are measured here from geometry and metadata.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from benchmarks.patterns.room import Hits, Room
from benchmarks.patterns.sills import pierced
from benchmarks.patterns.views import hidden_keys, lights_hidden
from sceneweaver.critic import kinds
from sceneweaver.critic.design.looks import off_palette
from sceneweaver.critic.design.measure import top_of
from sceneweaver.critic.design.query import kind_set
from sceneweaver.critic.design.walls import spans_of
from sceneweaver.critic.groups import ALL_BEDS, groups_of
from sceneweaver.critic.survey import turn_to
from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge.small_things import belongs
from sceneweaver.rules.design import limit
from sceneweaver.scene import Scene
from sceneweaver.verify.solids import Body

OFF_AXIS = 0.2
"""Distance [m] from which on the pattern counts a rug as off its axis."""

ALONE = 0.9
"""Distance [m] to the nearest other piece from which on a light piece stands alone."""

BACK = 110.0
"""Angle [deg] from which on a seat has its back to a screen."""

NEAR_SCREEN = 6.0
"""Distance [m] up to which a seat goes with a screen."""

ONE_ANGLE = 1.0
"""Difference [deg] up to which chairs stand at one angle."""

WAYS = 3
"""Directions of gym machines from which on they face anywhere."""

LIGHT = kind_set(
    "=pouf =ottoman =stool =bar_stool =bench =side_table =nightstand =yoga_mat =exercise_mat =exercise_ball =locker"
    " =chair =armchair =floor_cushion =bean_bag =coffee_table"
)
"""Pieces that stand with others."""

NO_COMPANY = kinds.TALL_PLANTS | frozenset(("floor_lamp", "tripod_lamp", "wastebasket", "radiator", "rug", "round_rug"))
"""Things beside which a piece still stands alone."""


Measure = Callable[[Room], Hits]


def _room(objects: Iterable[str]) -> Hits:
    """One room, which has the pattern where there are objects."""
    names = tuple(objects)
    return Hits(int(bool(names)), 1, tuple(filter(None, names)))


def _things(found: Iterable[Body], of: Iterable[Body]) -> Hits:
    names = tuple(b.id for b in found)
    return Hits(len(names), len(list(of)), names)


NONE = Hits(0, 0)


def bare_wall(room: Room) -> Hits:
    """Rooms with a wall that is hardly covered."""
    least, short = limit("wall_covered", "share"), limit("wall_covered", "length")
    tall, close = limit("wall_covered", "tall"), limit("wall_covered", "close")
    bare = []
    for wall in room.survey.placed.walls:
        length = sum(span.end - span.start for span in spans_of(room.survey, wall, tall, close))
        if wall.length >= short and length < least * wall.length:
            bare.append(f"wall:{wall.index}")
    return _room(bare)


def small_off_palette(room: Room) -> Hits:
    """Small things that do not follow the style or the palette of the room."""
    return _things(*off_palette(room.survey))


def rug_off_axis(room: Room) -> Hits:
    """Rugs under a bed or before a sofa, off its axis."""
    groups, pairs = groups_of(room.survey), {}
    for sleeping in groups.sleepings:
        if sleeping.rug is not None and groups.overlap(sleeping.rug, sleeping.bed) > 0.0:
            pairs[sleeping.rug] = sleeping.bed
    for seating in groups.seatings:
        if seating.rug is not None and seating.anchor.item.category in kinds.SOFAS - {"sectional_sofa"}:
            pairs.setdefault(seating.rug, seating.anchor)
    return _things([r for r, base in pairs.items() if abs(base.local(r.centre)[1]) > OFF_AXIS], pairs)


def rug_too_small(room: Room) -> Hits:
    """Rugs under a table that do not carry its chairs."""
    groups = groups_of(room.survey)
    under = {r for r in groups.rugs for g in groups.tables if groups.overlap(r, g.table) > 0.5 * _floor(g.table)}
    bad = set(room.named("rug_beyond_table"))
    return _things([r for r in under if r.id in bad], under)


def _floor(body: Body) -> float:
    return body.size[0] * body.size[1]


def head_on_door_wall(room: Room) -> Hits:
    """Beds with their head on the wall of a door."""
    beds = [b for b in room.survey.of_kind(ALL_BEDS) if b.item.category in kinds.BEDS]
    bad = set(room.named("bed_off_door_wall"))
    return _things([b for b in beds if b.id in bad], beds)


def orphan(room: Room) -> Hits:
    """Rooms with a light piece that stands with nothing."""
    survey, names = room.survey, room.named("seat_in_a_group", "piece_in_a_group")
    for body in survey.of_kind(LIGHT):
        if body.item.mount != "floor":
            continue
        near = [b for b, _ in survey.near(body, ALONE) if b.item.mount == "floor" and b.item.category not in NO_COMPANY]
        single = body.item.category == "locker" and not any(b.item.category == "locker" for b in near)
        names += [body.id] if not near or single else []
    return _room(dict.fromkeys(names))


def at_door_frame(room: Room) -> Hits:
    """Rooms with furniture that touches the frame of a door."""
    most = limit("door_frame", "touching")
    close = [f for f in room.faults.get("door_frame", ()) if f.measured is not None and f.measured < most]
    return _room(name for f in close for name in f.objects)


def back_to_screen(room: Room) -> Hits:
    """Rooms with a screen that a seat turns its back to, that something hides from a seat, or that is one of two."""
    screens = [b for b in room.survey.of_kind(kinds.TVS)]
    if not screens:
        return NONE
    names = room.named("back_to_focus", "focus_unblocked", "one_screen")
    for seat in room.survey.of_kind(kinds.LOUNGE):
        near = [s for s in screens if math.dist(s.centre, seat.centre) <= NEAR_SCREEN]
        if near and all(math.degrees(turn_to(seat, s.centre)) > BACK for s in near):
            names.append(seat.id)
    return _room(dict.fromkeys(names))


def curtain_off(room: Room) -> Hits:
    """Curtains off the middle of their window."""
    curtains, bad = room.survey.of_kind(kind_set("curtain")), set(room.named("curtain_centred"))
    return _things([b for b in curtains if b.id in bad], curtains)


def sill_pierces(room: Room) -> Hits:
    """Curtains whose cloth the board of a sill goes through."""
    return _things(*pierced(room.survey))


def foreign_small(room: Room) -> Hits:
    """Rooms with small things that people do not have there."""
    small = [b for b in room.survey.bodies if b.item.mount == "surface" and b.item.intent.priority != "asked"]
    return _room([b.id for b in small if not belongs(b.item.category, room.kind)])


def blocked(room: Room) -> Hits:
    """Rooms in which something in use is blocked: a board, screen, window, oven, a zone or a door."""
    names = room.named("before_use", "before_focus", "low_below_windows", "swing_free")
    wrong = room.survey.report.violations
    names += [o for v in wrong if v.kind in ("blocked_zone", "blocked_opening") for o in v.objects]
    return _room(dict.fromkeys(names))


def _kitchen(room: Room) -> bool:
    return bool(room.survey.on_floor(("kitchen_counter", "kitchen_cabinet", "sink_cabinet")))


def stepped_worktop(room: Room) -> Hits:
    """Kitchens whose worktop has steps."""
    return _room(room.named("one_worktop_height")) if _kitchen(room) else NONE


def bare_dishwasher(room: Room) -> Hits:
    """Dishwashers that no worktop of the height of the others goes over."""
    survey = room.survey
    washers = survey.on_floor(("dishwasher",))
    counters = survey.on_floor(("kitchen_counter", "kitchen_cabinet", "sink_cabinet"))
    step = limit("one_worktop_height", "step") + 0.005

    def beside(washer: Body) -> Body | None:
        return min(counters, key=lambda b: (round(math.dist(b.centre, washer.centre), 3), b.id), default=None)

    def topped(washer: Body) -> bool:
        counter = beside(washer)
        return bool(washer.item.surfaces) and counter is not None and abs(top_of(washer) - top_of(counter)) <= step

    return _things([w for w in washers if not topped(w)], washers)


def stove_in_corner(room: Room) -> Hits:
    """Kitchens with a stove or oven in a corner or behind a counter."""
    return _room(room.named("no_stove_in_corner")) if _kitchen(room) else NONE


def unlit(room: Room) -> Hits:
    """Rooms with tables or several desks of which some have no lamp over them."""
    survey = room.survey
    desks = survey.on_floor(kinds.DESKS - {"reception_desk", "dressing_table"})
    tables = [g.table for g in groups_of(survey).tables if g.table.item.category in kinds.DINING]
    return _room(room.named("lamp_over_table")) if tables or len(desks) >= 3 else NONE


def low_pendant(room: Room) -> Hits:
    """Pendants that hang low over a way."""
    lamps, bad = room.survey.of_kind(kind_set("hanging_light")), set(room.named("pendant_clear"))
    return _things([b for b in lamps if b.id in bad], lamps)


def machines_anyhow(room: Room) -> Hits:
    """Gyms whose cardio machines face several ways or stand out of their row."""
    if room.kind not in ("gym", "home_gym"):
        return NONE
    cardio, ways = room.survey.on_floor(kind_set("cardio_machine")), []
    for body in cardio:
        if not any(abs(wrap_angle(body.yaw - other)) < math.radians(10.0) for other in ways):
            ways.append(body.yaw)
    many = [b.id for b in cardio] if len(ways) >= WAYS else []
    return _room([*room.named("machines_in_rows"), *many])


def gym_lacks(room: Room) -> Hits:
    """Gyms without a mirror, lockers or enough small things."""
    if room.kind != "gym":
        return NONE
    lacking = [] if room.survey.of_kind(kind_set("=wall_mirror =standing_mirror =gym_mirror")) else ["no mirror"]
    lacking += [] if room.survey.of_kind(("locker",)) else ["no locker"]
    few = sum(b.item.mount == "surface" for b in room.survey.bodies) < limit("enough_small_things", "bedroom")
    return _room([*lacking, *(["few small things"] if few else [])])


def one_chair_angle(room: Room) -> Hits:
    """Rooms with four chairs at tables or more, all at one angle to them."""
    angles = []
    for group in groups_of(room.survey).tables:
        turned = group.table.item.category.startswith("round")
        for seat in group.seats:
            ahead, aside = seat.local(group.table.centre)
            angles.append(
                math.atan2(aside, ahead) if turned else float(wrap_angle(seat.yaw - group.table.yaw, math.pi / 2))
            )
    if len(angles) < 4:
        return NONE
    alike = math.degrees(max(angles) - min(angles)) < ONE_ANGLE
    return _room([g.table.id for g in groups_of(room.survey).tables] if alike else [])


class Pattern(NamedTuple):
    """A pattern: what it says, what is counted, how often strict eyes saw it, and how one room is measured."""

    text: str
    unit: str
    seen: str
    measure: Measure


def _rules(*rules: str) -> Measure:
    return lambda room: _room(room.named(*rules))


PATTERNS: Mapping[str, Pattern] = MappingProxyType(
    {
        "light": Pattern("own light hidden, or lamps float without a ceiling", "rooms", "15 of 15", lights_hidden),
        "behind": Pattern("key piece from behind or with a cut wall in both views", "pieces", "10 of 15", hidden_keys),
        "bare_wall": Pattern("a wall less than 15 % covered", "rooms", "12 of 15", bare_wall),
        "palette": Pattern("small things off style and palette", "objects", "158 of 207", small_off_palette),
        "rug_axis": Pattern("rug off the axis of bed or sofa by over 0.2 m", "rugs", "21 of 31", rug_off_axis),
        "rug_size": Pattern("rug too small for table and chairs", "rugs", "8 of 9", rug_too_small),
        "bed_head": Pattern("bed head on the door wall", "beds", "6 of 6", head_on_door_wall),
        "orphan": Pattern("a seat, stool, mat or piece stands alone", "rooms", "8 of 15", orphan),
        "door_frame": Pattern("furniture within 0.1 m of a door frame", "rooms", "7 of 15", at_door_frame),
        "screen": Pattern("back to the screen, screen hidden, two screens", "rooms", "6 of 27", back_to_screen),
        "curtain_axis": Pattern("curtain off the window's axis", "curtains", "24 of 119", curtain_off),
        "sill": Pattern("sill comes through the curtain", "curtains", "9 of 10", sill_pierces),
        "foreign": Pattern("wrong-room small things", "rooms", "7 of 15", foreign_small),
        "duplicates": Pattern("duplicates of what a room has once", "rooms", "6 of 6", _rules("one_of_each")),
        "blocked": Pattern("something in use is blocked", "rooms", "9 of 27", blocked),
        "worktop": Pattern("kitchen worktop has steps", "kitchens", "6 of 6", stepped_worktop),
        "dishwasher": Pattern("dishwasher without a worktop", "dishwashers", "5 of 6", bare_dishwasher),
        "stove": Pattern("stove or oven in a corner", "kitchens", "5 of 6", stove_in_corner),
        "unlit": Pattern("only some tables or desks lit", "rooms", "6 of 6", unlit),
        "pendant": Pattern("pendant low over a way", "pendants", "17 scenes", low_pendant),
        "machines": Pattern("gym machines face anywhere", "gyms", "3 of 3", machines_anyhow),
        "gym_lacks": Pattern("gym without mirror, lockers or small things", "gyms", "3 of 3", gym_lacks),
        "cloned": Pattern("pictures, laptops or small things exactly alike", "rooms", "-", _rules("not_cloned")),
        "one_angle": Pattern("one chair angle", "rooms", "-", one_chair_angle),
    }
)
"""The patterns that one room shows, by name; those of many rooms are in `sets`."""


def measured(scene: Scene) -> dict[str, Hits]:
    """Every pattern in one room."""
    room = Room.of(scene)
    return {name: pattern.measure(room) for name, pattern in PATTERNS.items()}
