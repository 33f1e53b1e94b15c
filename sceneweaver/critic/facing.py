"""Whether things face what they are for: chairs their table, seats the screen, screens the seat, beds the room."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator
from typing import Any

import numpy as np

from sceneweaver.geometry.angles import bearing, wrap_angle
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding, moved, related
from .needs import table_of
from .survey import Survey, turn_to

SEAT, SCREEN, LOUNGE = 35.0, 45.0, 65.0
"""Angles [deg] up to which a chair faces its table, a screen its viewer, a sofa what it looks at."""

GRAVE = 60.0
"""Angle [deg] from which a chair at a table is of no use."""

VIEW = 7.0
"""Distance [m] up to which a screen is watched."""

AHEAD = 0.9
"""Distance [m] before a front within which what it meets is what it faces."""

EYES = 1.15
"""Height [m] of the eyes of someone who sits."""

HEAD_GAP = 0.15
"""Gap [m] between the head of a bed and its wall that still passes; a headboard may stand off a little."""

BEYOND = 0.6
"""Share of a free space outside of the room from which on nobody can stand in it."""

BESIDE = 70.0
"""Angle [degrees] up to which a screen or keyboard that is square to its desk serves a chair that stands aside."""

NOSE = 0.4
"""Distance [m] to a wall from which the front of a thing is usable."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Things that face the wrong way."""
    yield from _chairs(survey)
    yield from _lounge(survey)
    yield from _desk_screens(survey)
    yield from _televisions(survey)
    yield from _beds(survey)
    yield from _fronts(survey)
    yield from _walled_in(survey)


def angle_to(survey: Survey, body: Body, target: Body) -> float:
    """Angle [deg] by which the front of a body misses a target; 0 where the way straight ahead soon meets it."""
    import shapely

    where = target.centre
    shape, spot = survey.boxes[target.index], shapely.Point(body.centre)
    (x, y), (fx, fy) = body.centre, body.front
    ahead = body.size[0] / 2 + AHEAD
    if shapely.LineString([(x, y), (x + ahead * fx, y + ahead * fy)]).intersects(survey.footprint(target)):
        return 0.0
    if not shape.contains(spot):
        near = shape.exterior.interpolate(shape.exterior.project(spot))
        where = (near.x, near.y)
    # A seat between the legs of its table, or at its corner, looks at the table when it looks at its middle.
    return math.degrees(min(turn_to(body, where), turn_to(body, target.centre)))


def _wrong(ids: list[str], reason: str, fix: str, grave: bool, points: float = 1.5, **inputs) -> Finding:
    return finding(
        "layout",
        "wrong_orientation",
        ids,
        reason,
        fix,
        points=points,
        grave=grave,
        call=("update_rotation", {"ids": ids[:1], **inputs}),
    )


def _chairs(survey: Survey) -> Iterator[Finding]:
    turned: dict[str, list[tuple[str, float]]] = defaultdict(list)
    for seat in survey.bodies:
        if seat.item.mount != "floor" or not kinds.upright_seat(seat.item.category):
            continue
        table = table_of(survey, seat)
        if table is None:
            clear = survey.clear_ahead(seat)
            if clear < NOSE and seat.item.category != "stool":
                yield _wrong(
                    [seat.id],
                    f"{seat.id} faces a wall at {clear:.2f} m",
                    f"turn {seat.id} around",
                    False,
                    1.0,
                    yaw=_opposite(seat),
                )
            continue
        angle = 0.0 if _holds(survey, seat, table) else angle_to(survey, seat, table)
        if angle > SEAT and not _round_stool(seat):
            turned[table.id].append((seat.id, angle))
        elif _behind(seat, table) and not _visits(survey, seat, table):
            yield finding(
                "layout",
                "wrong_side",
                (seat.id, table.id),
                f"{seat.id} is not at the front of {table.id}",
                f"put {seat.id} in front of {table.id}",
                points=1.5,
                grave=True,
                call=related("front_to_front", seat.id, table.id),
            )
    for table_id, found in turned.items():
        worst = max(angle for _, angle in found)
        ids = [object_id for object_id, _ in found]
        reason = f"{ids[0]} is turned {worst:.0f} degrees away from {table_id}"
        if len(ids) > 1:
            reason = f"{len(ids)} seats at {table_id} are turned up to {worst:.0f} degrees away from it"
        yield finding(
            "layout",
            "wrong_orientation",
            (*ids, table_id),
            reason,
            f"turn {', '.join(ids)} toward {table_id}",
            points=min(4.0, 1.2 * len(ids)),
            grave=worst > GRAVE,
            call=("update_rotation", {"ids": ids, "toward": table_id}),
        )


def _holds(survey: Survey, seat: Body, table: Body) -> bool:
    """Whether a relation that puts a seat's front against its table holds."""
    ties = {kind for kind, other in survey.ties.get(seat.id, ()) if other == table.id}
    if not ties & CATALOGUE.with_role("seat"):
        return False
    broken = survey.violated.get("relation", set()) | survey.violated.get("soft_relation", set())
    return frozenset((seat.id, table.id)) not in broken


def _round_stool(seat: Body) -> bool:
    return seat.item.category in ("stool", "bar_stool") and abs(seat.size[0] - seat.size[1]) < 0.05


def _behind(seat: Body, table: Body) -> bool:
    """Whether a seat is at a side from which its desk is not used."""
    from sceneweaver.assets import categories

    row = categories().get(table.item.category)
    if row is None or row.sides != ("front",) or table.item.category not in kinds.DESKS - {"corner_desk"}:
        return False
    ahead, aside = table.local(seat.centre)
    return ahead < 0.0 or abs(aside) > table.size[1] / 2 + 0.3


def _visits(survey: Survey, seat: Body, table: Body) -> bool:
    """Whether someone else has a seat at the front of a desk: a patient's or visitor's seat is at another side."""
    others = [b for b, _ in survey.near(table, 0.6) if b is not seat and kinds.upright_seat(b.item.category)]
    return any(table_of(survey, other) is table and not _behind(other, table) for other in others)


def _opposite(body: Body) -> float:
    return round(wrap_angle(body.yaw + math.pi), 4)


def _lounge(survey: Survey) -> Iterator[Finding]:
    centroid = survey.placed.floor.centroid
    middle = (float(centroid.x), float(centroid.y))
    tvs = survey.of_kind(kinds.TVS)
    for seat in survey.on_floor(kinds.LOUNGE - {"bean_bag"}):
        clear = survey.clear_ahead(seat)
        if clear < 0.8:
            yield _wrong(
                [seat.id],
                f"{seat.id} faces a wall at {clear:.2f} m",
                f"turn {seat.id} into the room",
                True,
                2.0,
                yaw=_opposite(seat),
            )
            continue
        near = survey.near(seat, 3.0)
        tables = [b for b, gap in near if b.item.category in kinds.COFFEE and gap < 1.2]
        others = [b for b, _ in near if b.item.category in kinds.LOUNGE | {"fireplace"}]
        desks = [b for b, gap in near if b.item.category in kinds.SEATED_AT and gap < 0.9]
        close = [b for b in tvs if math.dist(b.centre, seat.centre) < VIEW]
        sofa = seat.item.category in kinds.SOFAS
        if sofa and close:
            angles = [angle_to(survey, seat, b) for b in close]
            if (angle := min(angles)) > LOUNGE:
                tv = min(zip(angles, close, strict=True), key=lambda pair: (pair[0], pair[1].id))[1]
                back = _another_faces(survey, seat, close)
                yield _wrong(
                    [seat.id, tv.id],
                    f"{seat.id} is turned {angle:.0f} degrees away from {tv.id}",
                    f"turn {seat.id} toward {tv.id}",
                    not back,
                    0.7 if back else 2.0,
                    toward=tv.id,
                )
                continue
        inward = math.degrees(turn_to(seat, middle))
        if inward <= LOUNGE:
            continue
        targets = [*close, *tables, *others, *desks]
        angles = [angle_to(survey, seat, b) for b in targets]
        if min([*angles, inward]) <= LOUNGE:
            continue
        to = targets[0] if targets else None
        words = f"toward {to.id}" if to else "into the room"
        inputs = {"toward": to.id} if to else {"yaw": _toward(seat, middle)}
        yield _wrong(
            [seat.id, *([to.id] if to else [])],
            f"{seat.id} is turned {min([*angles, inward]):.0f} degrees away from all it could look at",
            f"turn {seat.id} {words}",
            False,
            1.2,
            **inputs,
        )


def _another_faces(survey: Survey, seat: Body, tvs: list[Body]) -> bool:
    """Whether some other sofa looks at a television, so that this one may complete the group."""
    others = [b for b in survey.of_kind(kinds.SOFAS) if b is not seat]
    return any(angle_to(survey, o, tv) <= LOUNGE for o in others for tv in tvs)


def _toward(body: Body, point: tuple[float, float]) -> float:
    return round(bearing(body.position, point), 4)


def _desk_screens(survey: Survey) -> Iterator[Finding]:
    for screen in survey.of_kind(kinds.DESK_SCREENS):
        if screen.item.support is None:
            continue
        base = survey.placed.by_id.get(screen.item.support.object)
        if base is None or base.item.category not in kinds.SEATED_AT:
            continue
        seats = [b for b, _ in survey.near(base, 0.9) if kinds.upright_seat(b.item.category)]
        seats = [b for b in seats if table_of(survey, b) is base]
        viewer = min(seats, key=lambda b: (round(math.dist(b.centre, screen.centre), 4), b.id), default=None)
        if viewer is not None:
            angle = math.degrees(turn_to(screen, viewer.centre))
            if angle > SCREEN and not (angle < BESIDE and _square_to(screen, base)):
                yield _wrong(
                    [screen.id, viewer.id],
                    f"{screen.id} is turned {angle:.0f} degrees away from {viewer.id}",
                    f"turn {screen.id} toward {viewer.id}",
                    angle > 90,
                    1.2,
                    toward=viewer.id,
                )
        elif base.item.category in kinds.DESKS - {"corner_desk"}:
            angle = abs(math.degrees(wrap_angle(screen.yaw - base.yaw)))
            if angle > GRAVE:
                yield _wrong(
                    [screen.id, base.id],
                    f"{screen.id} is turned {angle:.0f} degrees from {base.id}'s front",
                    f"turn {screen.id} to the front of {base.id}",
                    False,
                    1.0,
                    yaw=round(base.yaw, 4),
                )


def _square_to(thing: Body, base: Body) -> bool:
    """Whether a thing lies parallel to a side of what carries it, as a keyboard does however the chair stands."""
    return abs(math.degrees(wrap_angle(thing.yaw - base.yaw, math.pi / 2))) < 10.0


def _televisions(survey: Survey) -> Iterator[Finding]:
    seats = survey.of_kind(kinds.LOUNGE, kinds.BEDS, kinds.LONG_BEDS) or [
        b for b in survey.bodies if kinds.upright_seat(b.item.category)
    ]
    for tv in survey.of_kind(kinds.TVS):
        base = survey.placed.by_id.get(tv.item.support.object) if tv.item.support else None
        if base is not None:
            angle = abs(math.degrees(wrap_angle(tv.yaw - base.yaw)))
            if angle > SCREEN:
                yield _wrong(
                    [tv.id, base.id],
                    f"{tv.id} is turned {angle:.0f} degrees from the front of {base.id}",
                    f"turn {tv.id} to the front of {base.id}",
                    True,
                    1.5,
                    yaw=round(base.yaw, 4),
                )
                continue
        clear = survey.clear_ahead(tv)
        if clear < 1.0:
            yield _wrong(
                [tv.id],
                f"{tv.id} faces a wall at {clear:.2f} m",
                f"turn {tv.id} into the room",
                True,
                yaw=_opposite(tv),
            )
            continue
        near = [s for s in seats if math.dist(s.centre, tv.centre) < VIEW]
        if not near:
            continue
        seen = [s for s in near if math.degrees(turn_to(tv, s.centre)) <= GRAVE]
        if not seen:
            seat = min(near, key=lambda s: (round(math.dist(s.centre, tv.centre), 4), s.id))
            angle = math.degrees(turn_to(tv, seat.centre))
            yield _wrong(
                [tv.id, seat.id],
                f"{tv.id} is turned {angle:.0f} degrees away from {seat.id}",
                f"turn {tv.id} toward {seat.id}",
                False,
                1.2,
                toward=seat.id,
            )
            continue
        seen = [s for s in seen if angle_to(survey, s, tv) <= LOUNGE] or seen
        seen = [s for s in seen if s.item.category in kinds.SOFAS] or seen
        hidden = [(s, h) for s in seen if (h := _hides(survey, s, tv)) is not None]
        if len(hidden) == len(seen):
            seat, other = hidden[0]
            yield finding(
                "layout",
                "hidden_screen",
                (tv.id, seat.id, other.id),
                f"{other.id} stands between {seat.id} and {tv.id}",
                f"move {other.id} out of the way",
                call=moved(other.id),
            )


def _hides(survey: Survey, seat: Body, tv: Body) -> Body | None:
    """What stands higher than the line of sight between a seat and a screen."""
    import shapely

    line = shapely.LineString([seat.centre, tv.centre])
    level = max(EYES, tv.z[0])
    for row in survey.tree.query(line, predicate="intersects"):
        other = survey.bodies[int(row)]
        if other in (seat, tv) or other.item.mount in ("surface", "ceiling") or other.z[0] > EYES:
            continue
        if other.z[1] > level and (tv.item.support is None or tv.item.support.object != other.id):
            return other
    return None


def _beds(survey: Survey) -> Iterator[Finding]:
    for bed in survey.on_floor(kinds.BEDS):
        back = survey.back_wall(bed)
        gap = back[1] if back else math.inf
        if back is not None and gap <= HEAD_GAP and math.degrees(back[2]) < 12:
            continue
        behind = [b for b, d in survey.near(bed, HEAD_GAP) if bed.local(b.centre)[0] < -bed.size[0] / 2 and d < 0.1]
        if any(b.size[1] > 0.6 * bed.size[1] for b in behind):
            continue  # a room divider or shelf behind the head
        reason = f"the head of {bed.id} is {gap:.2f} m from the wall" if back else f"no wall behind {bed.id}"
        yield finding(
            "layout",
            "headless_bed",
            (bed.id,),
            reason,
            f"put the head of {bed.id} against a wall",
            points=2.0,
            grave=gap > 0.5,
            call=related("against_wall", bed.id),
        )
    for stand in survey.of_kind(("nightstand",)):
        bed = next((b for b, gap in survey.near(stand, 0.5) if b.item.category in kinds.BEDS), None)
        if bed is not None and bed.local(stand.centre)[0] > 0.0:
            yield finding(
                "layout",
                "wrong_side",
                (stand.id, bed.id),
                f"{stand.id} stands {bed.local(stand.centre)[0] + bed.size[0] / 2:.2f} m from the head of {bed.id}",
                f"put {stand.id} at the head of {bed.id}",
                points=1.0,
                call=related("against_wall", stand.id),
            )
    for bed in survey.of_kind(kinds.LONG_BEDS):
        gap = float(survey.wall_gaps[bed.index])
        if gap > 0.2:
            yield finding(
                "layout",
                "headless_bed",
                (bed.id,),
                f"{bed.id} is {gap:.2f} m from the nearest wall",
                f"put {bed.id} against a wall",
                points=1.2,
                call=related("against_wall", bed.id),
            )


def _fronts(survey: Survey) -> Iterator[Finding]:
    """Storage and appliances whose front is at a wall."""
    for body in survey.on_floor(kinds.WALL_BACKED, kinds.DESKS - {"reception_desk", "corner_desk"}):
        clear = survey.clear_ahead(body)
        if clear < NOSE:
            yield _wrong(
                [body.id],
                f"the front of {body.id} is {clear:.2f} m from a wall",
                f"turn {body.id} around",
                True,
                2.0,
                yaw=_opposite(body),
            )


def _walled_in(survey: Survey) -> Iterator[Finding]:
    """Things whose free side, where someone stands to use them, lies beyond a wall: a shower that opens to the wall."""
    seen = {b.index for b in survey.of_kind(kinds.WALL_BACKED, kinds.DESKS)}  # as `_fronts` has them
    zones = survey.placed.zones
    beyonds = _outside(survey, zones.polygons)
    for k, owner in enumerate(zones.owner):
        body = survey.bodies[int(owner)]
        if body.item.mount != "floor" or body.index in seen:
            continue
        beyond = float(beyonds[k])
        if beyond <= BEYOND:
            continue
        seen.add(body.index)
        reason = f"{beyond:.0%} of the free space at the {zones.names[k]} of {body.id} lies beyond a wall"
        own = [j for j in range(len(zones)) if zones.owner[j] == owner]
        here = _beyond(survey, own, body, 0.0)
        quarters = (2,) if abs(body.size[0] - body.size[1]) > 0.05 else (1, 2, 3)  # so that it stays where it is
        turns = {q: _beyond(survey, own, body, q * math.pi / 2) for q in quarters}
        best = min(turns, key=lambda q: (round(turns[q], 3), q))
        if turns[best] < here - 0.3:
            yaw = round(wrap_angle(body.yaw + best * math.pi / 2), 4)
            yield _wrong([body.id], reason, f"turn {body.id} around", True, 2.0, yaw=yaw)
        else:
            yield finding(
                "layout",
                "walled_in",
                (body.id,),
                reason,
                f"move {body.id} away from the wall",
                call=moved(body.id),
            )


def _beyond(survey: Survey, zones: list[int], body: Body, turn: float) -> float:
    """Share of a body's zones outside of the room if it turned on the spot; the sum over the zones."""
    from shapely.affinity import rotate

    shapes = [rotate(survey.placed.zones.polygons[k], turn, origin=body.centre, use_radians=True) for k in zones]
    return sum(_outside(survey, shapes).tolist())


def _outside(survey: Survey, shapes: Any) -> Any:
    """Share of each of some polygons outside of the room [n]."""
    import shapely

    return 1.0 - shapely.area(shapely.intersection(shapes, survey.placed.floor)) / np.maximum(
        shapely.area(shapes), 1e-9
    )
