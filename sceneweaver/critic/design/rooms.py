"""Measures of bathrooms, kitchens and gyms."""

from __future__ import annotations

import math
from collections import Counter, defaultdict
from collections.abc import Sequence

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.verify.solids import Body, Opening

from ..survey import QUARTER, Survey
from .free import wall_ahead
from .measure import along, end_of, inside, middle, overlap, strip, top_of
from .plan import bearing
from .query import listed
from .registry import measure, spot

# ---- bath ------------------------------------------------------------------------------------------------------------


@measure
def mirror_off(_: Survey, unit: Body, mirrors: Sequence[Body], enough: float) -> float:
    """How far [m] mirrors are off the first basin of a unit that they are farther off than ``enough``."""
    quarter, off = unit.size[1] / 4, 0.0
    for place in (-quarter, quarter) if unit.item.category == "double_vanity" else (0.0,):
        spots = ((abs(unit.local(m.centre)[1] - place), max(0.0, m.size[1] / 2 - 0.3)) for m in mirrors)
        off = min((max(0.0, away - spare) for away, spare in spots), default=math.inf)
        if off > enough:
            break
    return off


@measure
def has_spout(_: Survey, bath: Body) -> bool:
    """Whether a narrow part of a bath reaches up to its highest point, as a tap does."""
    rim = max(p.z[1] for p in bath.item.solids)
    return any(
        p.z[1] > rim - 1e-6 and _box_area(p.polygon) < 0.3 * bath.size[0] * bath.size[1] for p in bath.item.solids
    )


def _box_area(polygon: tuple[tuple[float, float], ...]) -> float:
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    return (max(xs) - min(xs)) * (max(ys) - min(ys))


@measure
def serves(survey: Survey, mats: Sequence[Body] | Body, bodies: Sequence[Body] | Body, slack: float, gap: float,
           corner: float) -> bool:  # fmt: skip
    """Whether any mat lies at an open side of any of some showers, baths or basins, and before its middle."""
    return any(_at_exit(survey, b, m, slack - 0.2, gap, corner) for m in listed(mats) for b in listed(bodies))


def _at_exit(survey: Survey, body: Body, mat: Body, slack: float, gap: float, corner: float) -> bool:
    if survey.placed.distance(body, mat) > (corner if body.item.category == "corner_shower" else gap):
        return False
    ahead, aside = body.local(mat.centre)
    d, w = body.size[0] / 2, body.size[1] / 2
    before = ahead > d - 0.1 and abs(aside) <= w + slack
    if body.item.category == "corner_shower":
        return before or (aside < 0.1 - w and abs(ahead) <= d + slack)  # its corner is at the back on the left
    return before or (body.item.category == "freestanding_bathtub" and ahead < 0.1 - d and abs(aside) <= w + slack)


@measure
def slot(survey: Survey, o: Body, low: float, high: float) -> float:
    """The widest gap [m] between two bounds from the back or an end of a body to a wall; 0 without one."""
    gaps = (wall_ahead(survey, o, side) for side in ("back", "left", "right"))
    return max((g for g in gaps if low < g < high), default=0.0)


# ---- kitchen ---------------------------------------------------------------------------------------------------------


@measure
def worktop(_: Survey, unit: Body) -> float:
    """Height [m] of the top of a unit."""
    return top_of(unit)


@measure
def usual_worktop(_: Survey, units: Sequence[Body]) -> float:
    """The height [m] that most of some units have."""
    return Counter(round(top_of(b), 2) for b in units).most_common(1)[0][0]


def _finishes(units: Sequence[Body]) -> dict[str, list[Body]]:
    found: dict[str, list[Body]] = defaultdict(list)
    for body in units:
        look = body.item.attributes.get("material") or body.item.attributes.get("color")
        if look:
            found[str(look)].append(body)
    return found


@measure
def finishes(_: Survey, units: Sequence[Body]) -> int:
    """How many finishes some units have."""
    return len(_finishes(units))


@measure
def other_finishes(_: Survey, units: Sequence[Body]) -> list[Body]:
    """The units that do not have the finish of most."""
    found = _finishes(units)
    most = max(found, key=lambda k: (len(found[k]), k), default="")
    return [b for k, bodies in found.items() if k != most for b in bodies]


@measure
def run_below(survey: Survey, window: Opening, units: Sequence[Body]) -> bool:
    """Whether units stand below most of a window."""
    rows = [along(window, b) for b in units]
    u = (window.item.offset, end_of(window))
    return sum(max(0.0, overlap(u, a)) for a, v in rows if v[0] < 0.25) > 0.5 * window.item.width


@measure
def has_back_wall(survey: Survey, o: Body) -> bool:
    """Whether a wall is behind a body."""
    return survey.back_wall(o) is not None


@measure
def least_before(_: Survey, o: Body, windows: Sequence[Opening]) -> float:
    """Distance [m] from a body to where it would stand before the nearest of some windows."""
    return min(math.dist(o.centre, middle(w, o.size[0] / 2)) for w in windows)


@measure
def hung_share(survey: Survey, units: Sequence[Body], hung: Sequence[Body], hoods: Sequence[Body]) -> float:
    """Share of the wall over a run of units, but for hoods and windows, that has something of ``hung`` on it."""
    free = covered = 0.0
    for wall in survey.placed.walls:

        def spans(bodies: Sequence[Body], wall=wall) -> list[tuple[float, float]]:
            rows = [along(wall, b) for b in bodies]
            return [u for u, v in rows if v[0] < 0.25 and u[1] - u[0] > 0.05 and v[1] < 0.8]

        if run := spans(units):
            gone = [(w.item.offset, end_of(w)) for w in survey.placed.windows if w.wall.index == wall.index]
            free += _length(run) - _shared(run, gone + spans(hoods))
            covered += _shared(run, spans(hung))
    return covered / free if free > 0.5 else 1.0


def _length(spans: list[tuple[float, float]]) -> float:
    """Length [m] of the union of some intervals."""
    total, end = 0.0, -math.inf
    for low, high in sorted(spans):
        total += max(0.0, high - max(low, end))
        end = max(end, high)
    return total


def _shared(a: list[tuple[float, float]], b: list[tuple[float, float]]) -> float:
    """Length [m] of what two sets of intervals share."""
    parts = [(max(x[0], y[0]), min(x[1], y[1])) for x in a for y in b]
    return _length([p for p in parts if p[1] > p[0]])


# ---- gym -------------------------------------------------------------------------------------------------------------


@measure
def looks_at(survey: Survey, o: Body, sights: Sequence[Body | Opening] | Body, angle: float, far: float) -> bool:
    """Whether any of some sights is within an angle [deg] of the front of a body and a distance [m]."""
    return any(bearing(survey, o, s) <= angle and math.dist(o.centre, spot(s)) <= far for s in listed(sights))


@measure
def meets(survey: Survey, mat: Body, machines: Sequence[Body], low: float, cables: Sequence[Body], use: float) -> bool:
    """Whether a mat lies under a machine, above a height [m], or in the room before one with cables, of a depth [m]."""
    box, rows = survey.boxes[mat.index], {b.index for b in machines}
    under = any(b.index in rows for b, _ in inside(survey, box, (mat,), low=low))
    return under or any(strip(b, "front", use).intersects(box) for b in cables)


@measure
def lies_across(survey: Survey, mat: Body, mats: Sequence[Body], gap: float, angle: float) -> bool:
    """Whether a mat is turned, by more than an angle [deg], against another within a gap [m]."""
    near = [b for b, _ in survey.near(mat, gap) if b in mats]
    return any(abs(wrap_angle(b.yaw - mat.yaw, 2 * QUARTER)) > math.radians(angle) for b in near)
