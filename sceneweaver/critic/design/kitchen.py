"""Kitchens: one height and finish for a run, the work triangle, no stove in a corner, cabinets along the wall."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from itertools import combinations

from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from ..grade import Finding
from ..survey import Survey
from .breach import breach
from .measure import along, applies, inside, middle, named, names, overlap, strip, top_of

FRONTS = named("kitchen_counter kitchen_cabinet sink_cabinet corner_cabinet")
"""Units with fronts and a worktop."""

UNDER = FRONTS | {"dishwasher", "stove"}
"""What a worktop goes over, or is level with."""

HOBS = frozenset(("stove", "hob"))

FRIDGES = frozenset(("fridge", "side_by_side_fridge"))

SINKS = frozenset(("sink_cabinet",))


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for kitchens."""
    if not applies(survey, "one_worktop_height", "work_triangle"):
        return
    units = survey.on_floor(UNDER)
    if len(units) < 3:
        return
    yield from _heights(units)
    yield from _finishes(survey, units)
    yield from _triangle(survey)
    yield from _corner(survey)
    yield from _above(survey, units)
    yield from _sink(survey)
    yield from _bin(survey)


def _heights(units: list[Body]) -> Iterator[Finding]:
    step = limit("one_worktop_height", "step")
    tops = {b.id: top_of(b) for b in units}
    counters = [tops[b.id] for b in units if b.item.category in FRONTS] or list(tops.values())
    usual = Counter(round(t, 2) for t in counters).most_common(1)[0][0]
    off = [b for b in units if abs(tops[b.id] - usual) > step + 0.005]
    if off:
        worst = max(off, key=lambda b: (round(abs(tops[b.id] - usual), 4), b.id))
        rise = abs(tops[worst.id] - usual)
        yield breach(
            "one_worktop_height",
            (b.id for b in off),
            f"{worst.id} is {tops[worst.id]:.2f} m high where the worktop is {usual:.2f} m",
            measured=rise,
            allowed=(0.0, step),
            weight=min(2.0, 0.4 + 8.0 * rise + 0.2 * len(off)),
            suggestion="give all units of the run one worktop height",
        )


def _finishes(survey: Survey, units: list[Body]) -> Iterator[Finding]:
    if not applies(survey, "one_worktop_finish"):
        return
    fronts: dict[str, list[Body]] = {}
    for body in units:
        look = body.item.attributes.get("material") or body.item.attributes.get("color")
        if body.item.category in FRONTS and look:
            fronts.setdefault(str(look), []).append(body)
    if len(fronts) > limit("one_worktop_finish", "finishes"):
        most = max(fronts, key=lambda k: (len(fronts[k]), k))
        other = [b for k, bodies in fronts.items() if k != most for b in bodies]
        yield breach(
            "one_worktop_finish",
            (b.id for b in other),
            f"the run has {len(fronts)} finishes of fronts: {', '.join(sorted(fronts))}",
            measured=float(len(fronts)),
            allowed=(1.0, limit("one_worktop_finish", "finishes")),
            weight=0.4 + 0.3 * len(fronts),
            suggestion=f"give all units of the run one finish, such as {most}",
        )


def _triangle(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "work_triangle"):
        return
    corners = []
    for wanted in (SINKS, HOBS, FRIDGES):
        found = survey.of_kind(wanted)
        if not found:
            return
        corners.append(found[0])
    long = sum(math.dist(a.centre, b.centre) for a, b in combinations(corners, 2))
    low, high = limit("work_triangle", "low"), limit("work_triangle", "high")
    if not low <= long <= high:
        yield breach(
            "work_triangle",
            (b.id for b in corners),
            f"the ways between {names(corners)} add up to {long:.1f} m",
            measured=long,
            allowed=(low, high),
            suggestion="set sink, hob and fridge in a triangle",
        )


def _corner(survey: Survey) -> Iterator[Finding]:
    """A stove before which another unit reaches, or beside a wall that its user runs into."""
    if not applies(survey, "no_stove_in_corner"):
        return
    gap = limit("no_stove_in_corner", "gap")
    for stove in survey.on_floor(HOBS | {"oven_tower", "dishwasher"}):
        before = [
            b
            for b, s in inside(survey, strip(stove, "front", 0.6, 0.9), (stove,))
            if b.item.category in UNDER and s > 0.02
        ]
        side = min(survey.clear_ahead(stove, s) for s in ("left", "right"))
        if before or (side < gap and stove.item.category in HOBS):
            what = f"behind {before[0].id}" if before else f"{side:.2f} m from the wall beside it"
            yield breach(
                "no_stove_in_corner",
                (stove.id, *(b.id for b in before)),
                f"{stove.id} stands in a corner, {what}",
                measured=side,
                allowed=(gap, None),
                suggestion=f"move {stove.id} out of the corner",
            )


HUNG = frozenset(("wall_cabinet", "corner_wall_cabinet", "wall_shelf", "spice_rack"))
"""Categories of what goes on over a run."""


def _above(survey: Survey, units: list[Body]) -> Iterator[Finding]:
    """Share of the wall over the run, but for hood and window, that has cabinets or shelves."""
    if not applies(survey, "wall_cabinets_continuous"):
        return
    least = limit("wall_cabinets_continuous", "share")
    hung = [b for b in survey.bodies if b.item.mount == "wall" and b.item.category in HUNG]
    free = covered = 0.0
    for wall in survey.placed.walls:

        def spans(bodies: list[Body], wall=wall) -> list[tuple[float, float]]:
            rows = [along(wall, b) for b in bodies]
            return [u for u, v in rows if v[0] < 0.25 and u[1] - u[0] > 0.05 and v[1] < 0.8]

        run = spans(units)
        if not run:
            continue
        gone = [
            (w.item.offset, w.item.offset + w.item.width) for w in survey.placed.windows if w.wall.index == wall.index
        ]
        gone += spans(survey.of_kind(("range_hood",)))
        free += _length(run) - _shared(run, gone)
        covered += _shared(run, spans(hung))
    share = covered / free if free > 0.5 else 1.0
    if share < least:
        yield breach(
            "wall_cabinets_continuous",
            [b.id for b in hung],
            f"{share:.0%} of the {free:.1f} m of wall over the run has cabinets",
            measured=share,
            allowed=(least, None),
            weight=min(1.5, 0.5 + least - share),
            suggestion="go on with wall cabinets over the run",
        )


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


def _sink(survey: Survey) -> Iterator[Finding]:
    """A sink away from the window of its kitchen where the window is over a run."""
    if not applies(survey, "sink_at_window"):
        return
    offset = design_rules()["sink_at_window"].limits["offset"]
    for sink in survey.on_floor(SINKS):
        back = survey.back_wall(sink)
        over = [w for w in survey.placed.windows if w.z[0] > top_of(sink) - 0.05 and _has_run(survey, w)]
        if not over or back is None:
            continue
        away = min(math.dist(sink.centre, middle(w, sink.size[0] / 2)) for w in over)
        if away > offset:
            yield breach(
                "sink_at_window",
                (sink.id, over[0].item.id),
                f"{sink.id} is {away:.1f} m from {over[0].item.id}",
                measured=away,
                allowed=(None, offset),
                suggestion=f"put {sink.id} below {over[0].item.id}",
            )


def _has_run(survey: Survey, window) -> bool:
    u = (window.item.offset, window.item.offset + window.item.width)
    rows = [along(window, b) for b in survey.on_floor(UNDER)]
    return sum(max(0.0, overlap(u, a)) for a, v in rows if v[0] < 0.25) > 0.5 * window.item.width


def _bin(survey: Survey) -> Iterator[Finding]:
    if not applies(survey, "bin_at_sink"):
        return
    most = limit("bin_at_sink", "distance")
    bins = survey.on_floor(("pedal_bin", "trash_can", "recycling_bin", "wastebasket"))
    work = survey.of_kind(SINKS, HOBS)
    for body in bins if work else ():
        gap = min(survey.placed.distance(body, b) for b in work)
        if gap > most:
            yield breach(
                "bin_at_sink",
                (body.id,),
                f"{body.id} stands {gap:.1f} m from sink and stove",
                measured=gap,
                allowed=(None, most),
                suggestion=f"put {body.id} near the sink",
            )
