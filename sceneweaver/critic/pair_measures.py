"""What a stated relation between two objects asks for, as measurements of where they stand.

The numbers are what people mean by the words, not what the catalogue's relations of similar names demand. Lengths are
metres, angles degrees; left and right are those of who looks at the front of the target.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from sceneweaver.geometry.angles import wrap_angle
from sceneweaver.verify.measure import TOLERANCE, Measurement, Measurements, at_least, at_most
from sceneweaver.verify.solids import Body

from . import kinds
from .survey import Survey, turn_to

NEXT, NEAR, CLOSE, HANGING = 0.5, 1.5, 0.1, 0.3
"""Gap [m] up to which things are next to each other, near each other, touch as good as, and hang from each other."""

ACROSS = (1.5, 4.0)
"""Gap [m] of what is opposite."""

FAR = 2.5
"""Gap [m] from which things are far apart in any room; in a small one half its diagonal is far."""

BAND = 1.25
"""How much wider than the target the region on one of its sides is."""

FACING, ABREAST = 15.0, 10.0
"""Angles [deg] up to which something faces a thing, and is parallel to it."""

BEFORE = 45.0
"""Angle [deg] from the direction of a front up to which something is before it."""

RAY = 100.0
"""Length [m] of a ray: more than any room has."""

SEATED = 35.0
"""Angle [deg] between a seat's front and the way to what one sits at."""

OVER = 0.3
"""Gap [m] in plan up to which something is above or below a thing: a picture hangs over the back of a sofa."""

SLACK = 0.02
"""Height [m] by which something may reach below the top of what it is above."""

OFF_CENTRE, OFF_MIDDLE = 0.15, 0.25
"""How far [m] a centre may be off: of one axis beside the target, of both on it."""

FRONTS = {"in_front_of": (0, 1.0), "behind": (0, -1.0), "right_of": (1, 1.0), "left_of": (1, -1.0)}
"""Side of the target: axis of its frame (0 ahead, 1 to its own left) and sign. Its own left is a viewer's right."""

Alternatives = Sequence[Measurements]
"""Ways in which a relation may hold; one is enough."""


def gap(survey: Survey, a: Body, b: Body) -> float:
    """Least distance [m] between the solids of two objects, heights included."""
    import shapely

    kept, key = survey.gaps, (min(a.index, b.index), max(a.index, b.index))
    if key not in kept:
        parts = survey.placed.parts
        rows, columns = survey.placed.part_rows(a), survey.placed.part_rows(b)
        flat = shapely.distance(parts.polygons[rows][:, None], parts.polygons[columns][None, :])
        low, high = parts.z[rows], parts.z[columns]
        upright = np.maximum(low[:, None, 0] - high[None, :, 1], high[None, :, 0] - low[:, None, 1])
        kept[key] = float(np.hypot(flat, np.maximum(upright, 0.0)).min())
    return kept[key]


def plan_gap(survey: Survey, a: Body, b: Body) -> float:
    """Least distance [m] between two objects as seen from above."""
    return survey.placed.distance(a, b)


def spans(survey: Survey, subject: Body, target: Body) -> tuple[tuple[float, float], tuple[float, float]]:
    """Extents [m] of the subject's footprint in the target's frame: ahead of it, and to its own left."""
    x, y = (survey.outline(subject) - target.centre).T
    (c, s) = target.front
    ahead, left = c * x + s * y, c * y - s * x
    return (float(ahead.min()), float(ahead.max())), (float(left.min()), float(left.max()))


def carried_by(survey: Survey, subject: Body, target: Body) -> bool:
    """Whether the target carries the subject, directly or with something between."""
    body: Body | None = subject
    for _ in survey.bodies:
        if body is None or body.item.support is None:
            return False
        if body.item.support.object == target.id:
            return True
        body = survey.placed.by_id.get(body.item.support.object)
    return False


def beyond(survey: Survey, subject: Body, target: Body, side: str, most: float = ACROSS[1]) -> Measurements:
    """The subject on one side of the target, its middle past that side, within its width and a quarter more."""
    axis, sign = FRONTS[side]
    extents = spans(survey, subject, target)
    low, high = extents[axis]
    past = sign * (low + high) / 2 - target.size[axis] / 2
    half = BAND * target.size[1 - axis] / 2
    low, high = extents[1 - axis]
    shared = min(high, half) - max(low, -half)
    return (
        at_least(f"middle past its {_name(side)}", past, 0.0, slack=TOLERANCE),
        at_least("shared width", shared, 0.5 * min(high - low, 2 * half), slack=TOLERANCE),
        at_most("gap", plan_gap(survey, subject, target), most, slack=TOLERANCE),
    )


def _name(side: str) -> str:
    return {"in_front_of": "front", "behind": "back", "left_of": "left side", "right_of": "right side"}[side]


def sides_named(target: Body, name: str) -> tuple[str, ...]:
    """The sides of a target that "long", "short", "left" and "right" mean; all four of a square one for the first."""
    if name in ("left", "right"):
        return (f"{name}_of",)
    depth, width = target.size[:2]
    fronts, flanks = ("in_front_of", "behind"), ("left_of", "right_of")
    if math.isclose(depth, width, rel_tol=0.05):
        return (*fronts, *flanks)
    return fronts if (width > depth) == (name == "long") else flanks


# ---- distances -------------------------------------------------------------------------------------------------------


def _within(survey: Survey, s: Body, t: Body, most: float, params: dict[str, Any], least: float = 0.0) -> Measurements:
    low, high = float(params.get("min", least)), float(params.get("max", most))
    return (Measurement("gap", gap(survey, s, t), low, high, "m", TOLERANCE),)


def _apart(survey: Survey, s: Body, t: Body) -> Measurements:
    """Neither carries the other."""
    on = carried_by(survey, s, t) or carried_by(survey, t, s)
    return (at_most("one of them on the other", float(on), 0.0, ""),) if on else ()


def next_to(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Beside it, with a gap of at most half a metre."""
    return [(*_within(survey, s, t, NEXT, params), *_apart(survey, s, t))]


def near(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Within a step or two."""
    return [_within(survey, s, t, NEAR, params)]


def far_from(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """As far as the room allows, about."""
    return [_within(survey, s, t, math.inf, params, min(FAR, 0.5 * survey.diagonal))]


def against(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Touching it, or as good as."""
    return [(*_within(survey, s, t, CLOSE, params), *_apart(survey, s, t))]


def side_by_side(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Next to each other, at the left or right of one of them."""
    close = _within(survey, s, t, NEXT, params)
    return [(*close, *beyond(survey, a, b, side)[:2]) for a, b in ((s, t), (t, s)) for side in ("left_of", "right_of")]


# ---- sides -----------------------------------------------------------------------------------------------------------


def side_of(side: str) -> Callable[[Survey, Body, Body, dict[str, Any]], Alternatives]:
    """The predicate of one of the four sides."""

    def on_side(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
        return [beyond(survey, s, t, side, float(params.get("max", ACROSS[1])))]

    return on_side


def along(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Beside one of its long sides."""
    most = float(params.get("max", NEXT))
    return [beyond(survey, s, t, side, most) for side in sides_named(t, "long")]


def _end(survey: Survey, s: Body, t: Body, params: dict[str, Any], of_bed: str) -> Alternatives:
    bed = t.item.category in kinds.BEDS
    ends = (of_bed,) if bed else sides_named(t, "short")
    found = [beyond(survey, s, t, side, float(params.get("max", NEXT))) for side in ends]
    if bed and of_bed == "behind":  # what stands beside the pillows is at the head as well
        (low, high), _ = spans(survey, s, t)
        past = at_most("middle from its head", (low + high) / 2 + t.size[0] / 2, t.size[0] / 3, slack=TOLERANCE)
        found.append((past, at_most("gap", plan_gap(survey, s, t), NEXT, slack=TOLERANCE)))
    return found


def at_head(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Beyond the head of a bed or beside the pillows; at an end of anything else."""
    return _end(survey, s, t, params, "behind")


def at_foot(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Beyond the foot of a bed; at an end of anything else."""
    return _end(survey, s, t, params, "in_front_of")


def at(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Next to it, and a chair turned to it."""
    import shapely

    close = _within(survey, s, t, NEXT, params)
    if not kinds.upright_seat(s.item.category) or "chair_group" not in kinds.groups_of(s.item.category):
        return [close]
    here = shapely.points(s.centre)
    hull = shapely.convex_hull(survey.footprint(t))
    if shapely.intersects(hull, here):
        return [close]
    spot = shapely.get_coordinates(shapely.shortest_line(here, hull))[1]
    off = math.degrees(min(turn_to(s, (float(spot[0]), float(spot[1]))), turn_to(s, t.centre)))
    return [(*close, at_most("turned away by", off, SEATED, "deg"))]


# ---- one over the other ----------------------------------------------------------------------------------------------


def shared(survey: Survey, s: Body, t: Body) -> float:
    """Share of the subject's outline that lies within the target's, as seen from above."""
    import shapely

    mine, theirs = (shapely.convex_hull(survey.footprint(b)) for b in (s, t))
    area = float(shapely.area(mine))
    return float(shapely.area(shapely.intersection(mine, theirs))) / area if area > 0.0 else 0.0


def on(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Carried by it, or resting on it: a table on a rug, a painting over a chest."""
    if carried_by(survey, s, t):
        return [(at_least("carried by it", 1.0, 1.0, ""),)]
    height = at_most("height over its top", abs(s.z[0] - t.z[1]), 0.05, slack=TOLERANCE)
    return [(height, at_least("share over it", shared(survey, s, t), 0.5, ""))]


def inside(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Carried by one of its inner surfaces, by its top where it has none, or for the most part within its box."""
    low, high = max(s.z[0], t.z[0]), min(s.z[1], t.z[1])
    share = max(0.0, high - low) / max(1e-9, s.z[1] - s.z[0]) * shared(survey, s, t)
    within = (at_least("share within it", share, 0.5, ""),)
    inner = {surface.name for surface in t.item.surfaces if surface.headroom is not None}
    if not carried_by(survey, s, t):
        return [within]
    body = s
    while body.item.support is not None and body.item.support.object != t.id:
        body = survey.placed.by_id[body.item.support.object]
    held = not inner or (body.item.support is not None and body.item.support.surface in inner)
    return [(at_least("inside it", float(held), 1.0, ""),), within]


def hanging_from(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Carried by it, or touching it and no higher."""
    if carried_by(survey, s, t):
        return [(at_least("carried by it", 1.0, 1.0, ""),)]
    return [(*_within(survey, s, t, HANGING, params), at_most("top over its top", s.z[1] - t.z[1], 0.05))]


def _lateral(survey: Survey, s: Body, t: Body) -> Measurements:
    _, (low, high) = spans(survey, s, t)
    return (
        at_most("aside", abs(low + high) / 2, t.size[1] / 2, slack=TOLERANCE),
        at_most("gap in plan", plan_gap(survey, s, t), OVER, slack=TOLERANCE),
    )


def above(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Higher than its top, over it or at the wall right behind it."""
    return [(at_least("clearance", s.z[0] - t.z[1], -SLACK, slack=TOLERANCE), *_lateral(survey, s, t))]


def below(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Lower than its bottom, or under it as a rug is under a table and a box under a bed."""
    hung = (at_least("clearance", t.z[0] - s.z[1], -SLACK, slack=TOLERANCE), *_lateral(survey, t, s))
    own = (at_least("clearance", t.z[0] - s.z[1], -SLACK, slack=TOLERANCE), *_lateral(survey, s, t))
    covered = max(shared(survey, s, t), shared(survey, t, s))
    lower = at_most("middle over its middle", sum(s.z) / 2 - sum(t.z) / 2, 0.0, slack=TOLERANCE)
    stands = at_most("bottom over its bottom", s.z[0] - t.z[0], 0.3, slack=TOLERANCE)
    return [hung, own, (at_least("share under it", covered, 0.5, ""), lower, stands)]


def centered_on(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """In the middle of what it stands on or under it; beside it, in line with its middle."""
    (a0, a1), (l0, l1) = spans(survey, s, t)
    ahead, left = abs(a0 + a1) / 2, abs(l0 + l1) / 2
    most = float(params.get("max", OFF_MIDDLE))
    both = (
        at_most("off centre ahead", ahead, most, slack=TOLERANCE),
        at_most("off centre aside", left, most, slack=TOLERANCE),
    )
    if max(shared(survey, s, t), shared(survey, t, s)) > 0.5:
        return [both]
    return [both, (at_most("off centre", min(ahead, left), float(params.get("max", OFF_CENTRE)), slack=TOLERANCE),)]


# ---- directions ------------------------------------------------------------------------------------------------------


def facing(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Its front meets the target, or points at its middle within 15 degrees; of a desk who sits at it may face it.

    A screen has to look back, or nobody sees what is on it.
    """
    seen = (_faces(survey, t, s, 1.0),) if t.item.category in kinds.TVS and s.item.category in kinds.LOUNGE else ()
    return [(_faces(survey, s, t, way), *seen) for way in ways_of(s)]


def _faces(survey: Survey, s: Body, t: Body, way: float) -> Measurement:
    import shapely

    m = turned_to(s, shapely.convex_hull(survey.footprint(t)), t.centre, way)
    return m._replace(quantity=f"{s.id} turned away by")


def ways_of(body: Body) -> tuple[float, ...]:
    """The directions that a thing faces, as signs of its front: a desk does so as it stands and as it is sat at."""
    return (1.0, -1.0) if body.item.category in kinds.DESKS else (1.0,)


def turned_to(body: Body, shape: Any, middle: tuple[float, float], way: float = 1.0) -> Measurement:
    """How far a front (or with ``way`` -1 a back) is turned from a shape in plan: not at all where a ray meets it."""
    import shapely

    (x, y), (fx, fy) = body.centre, body.front
    if body.centre == middle:
        off = 90.0
    elif shapely.intersects(shapely.linestrings([(x, y), (x + RAY * way * fx, y + RAY * way * fy)]), shape):
        off = 0.0
    else:
        off = math.degrees(turn_to(body, middle))
        off = off if way > 0 else 180.0 - off
    return at_most("turned away by", off, FACING, "deg", slack=1e-6)


def opposite(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Across the room, one of them before the front of the other, or both turned to each other."""
    apart = Measurement("gap", gap(survey, s, t), *ACROSS, "m", TOLERANCE)
    ahead = [
        at_most("off the direction of a front", math.degrees(turn_to(a, b.centre)), BEFORE, "deg", slack=1e-6)
        for a, b in ((t, s), (s, t))
    ]
    return [*((apart, m) for m in ahead), (*facing(survey, s, t, params)[0], *facing(survey, t, s, params)[0])]


def _turned(s: Body, t: Body, modulo: float) -> Measurement:
    off = abs(math.degrees(float(wrap_angle(s.yaw - t.yaw, math.radians(modulo)))))
    return at_most("turned", off, ABREAST, "deg", slack=1e-6)


def parallel(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Along the same direction, either way round."""
    return [(_turned(s, t, 180.0),)]


def aligned(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Square to each other."""
    return [(_turned(s, t, 90.0),)]


def back_to_back(survey: Survey, s: Body, t: Body, params: dict[str, Any]) -> Alternatives:
    """Next to each other, each behind the other."""
    behind = (*beyond(survey, s, t, "behind")[:2], *beyond(survey, t, s, "behind")[:2])
    return [(*_within(survey, s, t, NEXT, params), *behind)]


PAIRS: dict[str, Callable[[Survey, Body, Body, dict[str, Any]], Alternatives]] = {
    "next_to": next_to,
    "near": near,
    "far_from": far_from,
    "side_by_side": side_by_side,
    "left_of": side_of("left_of"),
    "right_of": side_of("right_of"),
    "in_front_of": side_of("in_front_of"),
    "behind": side_of("behind"),
    "at": at,
    "along": along,
    "at_head": at_head,
    "at_foot": at_foot,
    "centered_on": centered_on,
    "against": against,
    "leaning_on": against,
    "on": on,
    "inside": inside,
    "hanging_from": hanging_from,
    "above": above,
    "below": below,
    "facing": facing,
    "opposite": opposite,
    "parallel": parallel,
    "aligned": aligned,
    "back_to_back": back_to_back,
}
"""The predicate of every relation that is said of one subject and one target."""
