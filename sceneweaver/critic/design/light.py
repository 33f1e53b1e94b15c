"""Lamps: over tables and desks, at beds, at what height pendants hang, how ceiling lights spread over a room."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from sceneweaver.geometry.se2 import SE2
from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..needs import seat_like, table_of
from ..space import floor_of
from ..survey import Survey
from .breach import breach
from .measure import applies, named, names

CEILING = named("pendant chandelier ceiling_light track_light ceiling_fan")

HANGING = frozenset(("pendant", "chandelier"))

STANDING = named("table_lamp floor_lamp tripod_lamp arc_lamp desk_lamp wall_sconce night_light lantern")
"""Lamps that light the place beside them."""

PUBLIC = named(
    "office meeting_room restaurant cafe canteen bar classroom library waiting_room reception gym computer_lab"
)
"""Rooms in which light from the ceiling is expected everywhere."""

SPOTS = 300
"""Points of the floor at which its light is looked at."""

EATEN_AT = frozenset(("dining_table", "round_dining_table", "oval_table", "cafe_table"))

LONG = 2.2
"""Length [m] from which one lamp does not light a table."""

DARK = 0.3
"""Share of the floor of a public room that may be farther from a lamp than the rule says."""

SIDE_LIT = 1.2
"""Width [m] from which a bed is for two."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for light."""
    lamps = [b for b in survey.of_kind(CEILING) if b.item.mount == "ceiling"]
    if applies(survey, "lamp_over_table"):
        yield from _tables(survey, lamps)
        yield from _desks(survey, lamps)
    if applies(survey, "lamp_at_bed_side"):
        yield from _beds(survey)
    yield from _heights(survey, lamps)
    if applies(survey, "ceiling_lights_spread") and lamps:
        yield from _spread(survey, lamps)


def _tables(survey: Survey, lamps: list[Body]) -> Iterator[Finding]:
    """Tables that people sit around: a lamp over the middle, on long ones several in line."""
    offset = limit("lamp_over_table", "offset")
    if survey.room_type.name == "office":
        return
    dark: list[Body] = []
    tables = survey.on_floor(kinds.DINING)
    over_some = {b.index for b in lamps if any(_above(t, b, 0.1) for t in tables)}
    for table in tables:
        if table.item.category in ("kids_table", "bar_table", "folding_table", "chess_table"):
            continue
        if not any(seat_like(b) and table_of(survey, b) is table for b, _ in survey.near(table, 0.9)):
            continue
        near = [b for b in lamps if math.dist(b.centre, table.centre) < max(table.size[:2]) / 2 + 1.2]
        over = [b for b in near if _above(table, b, 0.1)]
        over = [b for b in over if b.item.category in HANGING] or over  # others light the room
        if not over:
            dark.append(table)
            continue
        mean = np.mean([b.centre for b in over], axis=0)
        off = math.dist((float(mean[0]), float(mean[1])), table.centre)
        long = max(table.size[:2])
        few = long > LONG and len(over) == 1 and over[0].size[1] < 0.4 * long and over[0].size[0] < 0.4 * long
        aside = [b for b in near if b.index not in over_some and b.item.category in HANGING]
        if off > offset or few or aside:
            what = f"{over[0].id} hangs {off:.2f} m off the middle of {table.id}"
            if few or aside:
                what = f"{len(over)} of {len(over) + len(aside)} lamps hang over {table.id}, {long:.1f} m long"
            yield breach(
                "lamp_over_table",
                (table.id, *(b.id for b in (*over, *aside))),
                what,
                measured=off,
                allowed=(0.0, offset),
                suggestion=f"hang the lamps in line over {table.id}",
            )
    if dark:
        yield breach(
            "lamp_over_table",
            (b.id for b in dark),
            f"no lamp hangs over {names(dark)}",
            measured=float(len(dark)),
            weight=min(2.0, 0.6 + 0.2 * len(dark)),
            suggestion=f"hang a lamp over {names(dark)}",
        )


def _above(table: Body, lamp: Body, slack: float) -> bool:
    ahead, aside = table.local(lamp.centre)
    return abs(ahead) <= table.size[0] / 2 + slack and abs(aside) <= table.size[1] / 2 + slack


def _desks(survey: Survey, lamps: list[Body]) -> Iterator[Finding]:
    """Desks of a room with several: each within reach of a lamp at the ceiling."""
    reach = limit("lamp_over_table", "reach")
    desks = survey.on_floor(kinds.DESKS - {"reception_desk", "dressing_table"})
    if len(desks) < 3:
        return
    dark = [d for d in desks if min((math.dist(b.centre, d.centre) for b in lamps), default=math.inf) > reach]
    if dark:
        yield breach(
            "lamp_over_table",
            (b.id for b in dark),
            f"{len(dark)} of {len(desks)} desks have no ceiling light within {reach:g} m: {names(dark)}",
            measured=float(len(dark)),
            weight=0.5 + len(dark) / len(desks),
            suggestion="hang the ceiling lights over all desks",
        )


def _beds(survey: Survey) -> Iterator[Finding]:
    reach = limit("lamp_at_bed_side", "reach")
    for bed in survey.on_floor(kinds.BEDS):
        lamps = [b for b, _ in survey.near(bed, reach) if b.item.category in STANDING | HANGING]
        sides = {bed.local(b.centre)[1] > 0 for b in lamps if bed.local(b.centre)[0] < 0.2}
        wanted = 2 if bed.size[1] >= SIDE_LIT else 1
        if len(sides) < wanted:
            yield breach(
                "lamp_at_bed_side",
                (bed.id,),
                f"{len(sides)} of {wanted} sides of {bed.id} have a lamp within {reach:g} m",
                measured=float(len(sides)),
                allowed=(float(wanted), None),
                suggestion=f"put a lamp at each side of {bed.id}",
            )


def _heights(survey: Survey, lamps: list[Body]) -> Iterator[Finding]:
    """Pendants low over ways, and those too high or low over their table."""
    high, over_rest = limit("pendant_clear", "height"), limit("pendant_clear", "over_rest")
    low, top = limit("pendant_over_dining_table", "low"), limit("pendant_over_dining_table", "high")
    bases = [
        b
        for b in survey.standing
        if kinds.groups_of(b.item.category) & {"table_group", "bed_group", "storage"} or b.item.category in kinds.SOFAS
    ]
    wrong: list[tuple[float, Body, Body]] = []
    for lamp in lamps:
        if lamp.item.category not in HANGING:
            continue
        bottom = lamp.z[0]
        under = [b for b in bases if _above(b, lamp, 0.1)]
        tables = [b for b in under if b.item.category in EATEN_AT]
        if tables and bottom < 2.6:
            over = bottom - max(s.z for s in tables[0].item.surfaces) if tables[0].item.surfaces else bottom - 0.75
            if not low - 0.1 <= over <= top + 0.1:
                wrong.append((over, lamp, tables[0]))
        elif bottom < (high - 0.02 if not under else over_rest if _rests(under) else 0.0):
            yield breach(
                "pendant_clear",
                (lamp.id,),
                f"{lamp.id} hangs {bottom:.2f} m above {under[0].id if under else 'a floor that people walk on'}",
                measured=bottom,
                allowed=(over_rest if under else high, None),
                weight=min(1.5, 0.5 + (high - bottom) / 0.3),
                suggestion=f"hang {lamp.id} over a table, or {high:g} m high",
            )
    if wrong:
        over, lamp, table = max(wrong, key=lambda w: (round(abs(w[0] - 0.7), 3), w[1].id))
        yield breach(
            "pendant_over_dining_table",
            (*(b.id for _, b, _ in wrong), *{t.id: 0 for _, _, t in wrong}),
            f"{lamp.id} hangs {over:.2f} m over {table.id}",
            measured=over,
            allowed=(low, top),
            suggestion=f"hang {names(b for _, b, _ in wrong)} 0.7 m over the table",
        )


def _rests(under: list[Body]) -> bool:
    """Whether some things are beds or sofas, from which people get up."""
    return all(b.item.category in kinds.BEDS | kinds.LONG_BEDS | kinds.SOFAS for b in under)


def _spread(survey: Survey, lamps: list[Body]) -> Iterator[Finding]:
    """Ceiling lights near a wall or off the middle, and public rooms of which a part has none."""
    limits = design_rules()["ceiling_lights_spread"].limits
    free = [b for b in lamps if b.item.category not in HANGING]
    at_wall = [b for b in free if float(survey.wall_gaps[b.index]) < limits["wall"] and survey.area < limits["area"]]
    if at_wall:
        gap = float(survey.wall_gaps[at_wall[0].index])
        yield breach(
            "ceiling_lights_spread",
            (b.id for b in at_wall),
            f"{at_wall[0].id} hangs {gap:.2f} m from a wall",
            measured=gap,
            allowed=(limits["wall"], None),
            suggestion="hang it in the middle of the room",
        )
    elif len(lamps) == 1 and free and survey.area < limits["area"] * 1.5:
        centroid = survey.placed.floor.centroid
        off = math.dist(free[0].centre, (float(centroid.x), float(centroid.y)))
        group = kinds.BEDS | kinds.DINING | kinds.COFFEE
        if off > limits["offset"] and not any(_above(b, free[0], 0.0) for b in survey.on_floor(group)):
            yield breach(
                "ceiling_lights_spread",
                (free[0].id,),
                f"{free[0].id} hangs {off:.2f} m off the middle of the room",
                measured=off,
                allowed=(0.0, limits["offset"]),
                suggestion="hang it in the middle of the room",
            )
    if survey.room_type.name in PUBLIC and survey.area >= limits["area"]:
        floor = floor_of(survey)
        rows, columns = np.nonzero(floor.inside)
        pick = slice(None, None, max(1, len(rows) // SPOTS))
        u = floor.origin[0] + (columns[pick] + 0.5) * floor.cell
        v = floor.origin[1] + (rows[pick] + 0.5) * floor.cell
        x, y = SE2(yaw=floor.turn).world(u, v)
        centres = np.array([b.centre for b in lamps])
        away = np.hypot(x[:, None] - centres[:, 0], y[:, None] - centres[:, 1]).min(axis=1)
        reach = math.sqrt(limits["area"] / 2)
        dark = float((away > reach).mean())
        if dark > DARK:
            yield breach(
                "ceiling_lights_spread",
                (b.id for b in lamps),
                f"{dark:.0%} of the floor is more than {reach:.1f} m from any of {len(lamps)} lamps",
                measured=dark,
                allowed=(0.0, DARK),
                weight=0.5 + dark,
                suggestion="hang the ceiling lights on a grid over the whole room",
            )
