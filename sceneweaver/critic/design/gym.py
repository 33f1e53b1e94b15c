"""Gyms: machines in rows that look at something, room behind them, racks that can be loaded, mats in one place."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from .. import kinds
from ..grade import Finding
from ..survey import QUARTER, Survey
from .breach import breach
from .measure import applies, clear_depth, inside, middle, movable, named, names, outlook, strip

CARDIO = named("treadmill spin_bike exercise_bike elliptical rowing_machine stair_climber")

MACHINES = CARDIO | named("squat_rack smith_machine cable_machine leg_press weight_bench")

RACKS = frozenset(("squat_rack", "smith_machine"))

MATS = frozenset(("yoga_mat", "exercise_mat", "gym_mat"))

LOOSE = named("medicine_ball exercise_ball foam_roller kettlebell dumbbell")

STORES = named("dumbbell_rack weight_plate_rack kettlebell_rack metal_shelf storage_cart toy_shelf cube_shelf")

MIRRORS = frozenset(("wall_mirror", "standing_mirror", "gym_mirror"))

ASKEW = 15.0
"""Angle [deg] to the walls from which a roller lies as it was left."""

FAR = 9.0
"""Distance [m] up to which a window or screen is looked at."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for gyms."""
    if not applies(survey, "machines_in_rows"):
        return
    cardio = survey.on_floor(CARDIO)
    yield from _rows(cardio)
    yield from _view(survey, cardio)
    yield from _behind(survey)
    yield from _mats(survey)
    yield from _loose(survey)


def _rows(cardio: list[Body]) -> Iterator[Finding]:
    """Machines of a kind that face several ways, or of which one stands away from the row."""
    limits = design_rules()["machines_in_rows"].limits
    sets: dict[str, list[Body]] = defaultdict(list)
    for body in cardio:
        sets[body.item.category].append(body)
    for category, bodies in sets.items():
        if len(bodies) < 2:
            continue
        ways: list[list[Body]] = []
        for body in bodies:
            for way in ways:
                if abs(wrap_angle(body.yaw - way[0].yaw)) < math.radians(limits["angle"]):
                    way.append(body)
                    break
            else:
                ways.append([body])
        row = max((_row(way, limits) for way in ways), key=len)
        out = [b for b in bodies if b not in row]
        if out:
            words = kinds.words(category)
            yield breach(
                "machines_in_rows",
                (b.id for b in out),
                f"{len(row)} of {len(bodies)} {words}s stand in one row"
                + (f", they face {len(ways)} ways" if len(ways) > 1 else ""),
                measured=float(len(out)),
                weight=0.5 + len(out) / len(bodies),
                suggestion=f"set {names(out)} in the row of the other {words}s, facing the same way",
            )


def _row(bodies: list[Body], limits: dict[str, float]) -> list[Body]:
    """The most of some machines that face one way which stand side by side without a wide gap."""
    best: list[Body] = []
    for first in bodies:
        spots = sorted((first.local(b.centre)[1], b.index, b) for b in bodies if _abreast(first, b, limits["offset"]))
        row: list[Body] = []
        for aside, _, body in spots:
            if row and aside - first.local(row[-1].centre)[1] > body.size[1] + limits["gap"]:
                best, row = max(best, row, key=len), []
            row.append(body)
        best = max(best, row, key=len)
    return best


def _abreast(a: Body, b: Body, offset: float) -> bool:
    return abs(a.local(b.centre)[0]) <= offset


def _view(survey: Survey, cardio: list[Body]) -> Iterator[Finding]:
    """Cardio machines that look at a blank wall; a screen that hardly any of them looks at."""
    if not cardio:
        return
    angle = limit("cardio_view", "angle")
    sights = [(w.item.id, middle(w)) for w in survey.placed.windows]
    screens = survey.of_kind(("tv",), MIRRORS)
    sights += [(b.id, b.centre) for b in screens if b.item.category == "tv" or b.size[1] > 1.5]
    blind = [b for b in cardio if not any(_sees(b, spot, angle) for _, spot in sights)]
    if blind:
        yield breach(
            "cardio_view",
            (b.id for b in blind),
            f"{len(blind)} of {len(cardio)} cardio machines look at no window, screen or mirror: {names(blind)}",
            measured=float(len(blind)),
            weight=0.5 + len(blind) / len(cardio),
            suggestion=f"turn {names(blind)} to a window or a screen",
        )
    for tv in survey.of_kind(("tv",)):
        seen = sum(_sees(b, tv.centre, angle) for b in cardio)
        if seen < min(3, len(cardio)):
            yield breach(
                "cardio_view",
                (tv.id,),
                f"{seen} of {len(cardio)} cardio machines look at {tv.id}",
                measured=float(seen),
                allowed=(3.0, None),
                suggestion=f"hang {tv.id} before the cardio machines",
            )


def _sees(body: Body, spot: tuple[float, float], angle: float) -> bool:
    return outlook(body, spot) <= angle and math.dist(body.centre, spot) <= FAR


def _behind(survey: Survey) -> Iterator[Finding]:
    clear = limit("cardio_clear_behind", "clear")
    tight = []
    for body in survey.on_floor(("treadmill",)):
        free, other = clear_depth(survey, body, "back", clear, movable)
        if free < clear - 0.1:
            tight.append((free, body, other))
    if tight:
        free, body, other = min(tight, key=lambda t: (round(t[0], 3), t[1].id))
        yield breach(
            "cardio_clear_behind",
            (b.id for _, b, _ in tight),
            f"{free:.2f} m behind {body.id} to {'the wall' if other is None else other.id}",
            measured=free,
            allowed=(clear, None),
            weight=min(1.5, 0.4 + 0.3 * len(tight)),
            suggestion=f"leave {clear:g} m behind {names(b for _, b, _ in tight)}",
        )


def _mats(survey: Survey) -> Iterator[Finding]:
    """Mats that lie apart, turned, or in the way of a machine."""
    mats = survey.on_floor(MATS)
    limits = design_rules()["mats_together"].limits
    if not mats:
        return
    machines = {b.index for b in survey.on_floor(MACHINES)}
    wrong: dict[Body, str] = {}
    for mat in mats:
        under = [b for b, _ in inside(survey, survey.boxes[mat.index], (mat,), low=0.1) if b.index in machines]
        use = [
            b for b in survey.on_floor(("cable_machine",)) if strip(b, "front", 0.5).intersects(survey.boxes[mat.index])
        ]
        near = [b for b, g in survey.near(mat, limits["gap"]) if b in mats]
        turned = abs(float(survey.wall_angles[mat.index])) > math.radians(limits["angle"])
        askew = [b for b in near if abs(wrap_angle(b.yaw - mat.yaw, 2 * QUARTER)) > math.radians(limits["angle"])]
        if under or use:
            wrong[mat] = f"lies in the way of {(under or use)[0].id}"
        elif turned:
            wrong[mat] = f"is turned {math.degrees(float(survey.wall_angles[mat.index])):.0f} degrees against the walls"
        elif len(mats) > 1 and not near:
            wrong[mat] = "lies alone"
        elif askew:
            wrong[mat] = f"lies across {askew[0].id}"
    if wrong:
        first = min(wrong, key=lambda b: b.index)
        yield breach(
            "mats_together",
            (b.id for b in wrong),
            f"{first.id} {wrong[first]}" + (f"; so do {len(wrong) - 1} more" if len(wrong) > 1 else ""),
            measured=float(len(wrong)),
            weight=0.6 + 0.3 * len(wrong),
            suggestion="lay the mats side by side, away from machines",
        )


def _loose(survey: Survey) -> Iterator[Finding]:
    """Balls and rollers that lie about singly."""
    loose = survey.on_floor(LOOSE)
    if not loose or not applies(survey, "gym_things_stored"):
        return
    reach = limit("gym_things_stored", "reach")
    homes = survey.on_floor(STORES, MATS)
    about = [
        b
        for b in loose
        if (
            not any(o in homes for o, _ in survey.near(b, reach))
            and sum(o in loose for o, _ in survey.near(b, 0.3)) < 2
        )
        or (b.item.category == "foam_roller" and float(survey.wall_angles[b.index]) > math.radians(ASKEW))
    ]
    if len(about) >= 2:
        yield breach(
            "gym_things_stored",
            (b.id for b in about),
            f"{names(about)} lie about singly",
            measured=float(len(about)),
            allowed=(0.0, 1.0),
            weight=min(2.0, 0.4 + 0.2 * len(about)),
            suggestion="keep balls and rollers together at a rack or beside the mats",
        )
