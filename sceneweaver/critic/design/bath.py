"""Bathrooms: mirror, tap, towel, paper and mat where they are used; shower and bath flush with their corner."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sceneweaver.knowledge.design_rules import design_rules, limit
from sceneweaver.verify.solids import Body

from ..grade import Finding
from ..survey import Survey
from .breach import breach
from .measure import applies, inside, named, names, strip

BASINS = named("vanity double_vanity pedestal_sink wall_basin")

BATHS = frozenset(("bathtub", "freestanding_bathtub"))

SHOWERS = frozenset(("shower", "corner_shower"))

MIRRORS = named("wall_mirror round_mirror medicine_cabinet")

TOWELS = named("towel_rail towel_radiator towel_ring folded_towel towel_stack towel_roll coat_hooks")

TAPS = frozenset(("bath_tap", "faucet", "tap"))

BOWL = 0.25
"""Length [m] of a toilet's bowl ahead of its middle: who sits there reaches from there."""

HANGING = 0.25
"""Length [m] that a towel hangs below its rail."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Breaches of the rules for bathrooms."""
    if not applies(survey, "mirror_over_basin"):
        return
    yield from _mirrors(survey)
    yield from _taps(survey)
    yield from _towels(survey)
    yield from _paper(survey)
    if applies(survey, "mat_at_exit"):
        yield from _mats(survey)
        yield from _flush(survey)
    if applies(survey, "stool_at_shower"):
        yield from _stools(survey)


def basins(body: Body) -> list[float]:
    """Places [m] along the width of a unit of the basins in it."""
    quarter = body.size[1] / 4
    return [-quarter, quarter] if body.item.category == "double_vanity" else [0.0]


def _mirrors(survey: Survey) -> Iterator[Finding]:
    offset = limit("mirror_over_basin", "offset")
    for unit in survey.of_kind(BASINS):
        mirrors = [b for b, _ in survey.near(unit, 0.4) if b.item.category in MIRRORS and b.item.mount == "wall"]
        for place in basins(unit):
            off = min(
                (max(0.0, abs(unit.local(m.centre)[1] - place) - _slack(m)) for m in mirrors),
                default=math.inf,
            )
            if off > offset:
                away = f"is {off:.2f} m off it" if math.isfinite(off) else "hangs there"
                yield breach(
                    "mirror_over_basin",
                    (unit.id, *(m.id for m in mirrors)),
                    f"no mirror hangs over a basin of {unit.id}: {'the nearest ' if mirrors else 'none '}{away}",
                    measured=off,
                    allowed=(0.0, offset),
                    suggestion=f"hang a mirror over each basin of {unit.id}",
                )
                break


def _slack(mirror: Body) -> float:
    """How far [m] a wide mirror reaches beyond what a face needs."""
    return max(0.0, mirror.size[1] / 2 - 0.3)


def _taps(survey: Survey) -> Iterator[Finding]:
    """A bath that is one plain body, with no tap on it, beside it or over it."""
    reach = limit("tap_at_basin", "reach")
    for bath in survey.on_floor(BATHS):
        rim = max(p.z[1] for p in bath.item.solids)
        narrow = [
            p for p in bath.item.solids if p.z[1] > rim - 1e-6 and _area(p.polygon) < 0.3 * bath.size[0] * bath.size[1]
        ]
        beside = [b for b, _ in survey.near(bath, reach) if b.item.category in TAPS]
        if not narrow and not beside:
            yield breach(
                "tap_at_basin",
                (bath.id,),
                f"{bath.id} has no tap",
                measured=0.0,
                allowed=(1.0, None),
                suggestion=f"take a bath with a tap for {bath.id}",
            )


def _area(polygon: tuple[tuple[float, float], ...]) -> float:
    xs, ys = [p[0] for p in polygon], [p[1] for p in polygon]
    return (max(xs) - min(xs)) * (max(ys) - min(ys))


def _towels(survey: Survey) -> Iterator[Finding]:
    reach = limit("towel_in_reach", "reach")
    towels = [b for b in survey.of_kind(TOWELS) if b.z[0] < 1.7]
    lacking = []
    for body in survey.of_kind(SHOWERS, BASINS, BATHS):
        gap = min((survey.placed.distance(body, t) for t in towels), default=math.inf)
        if gap > reach + 0.05 and body.item.category not in BATHS:
            lacking.append((gap, body))
    if lacking:
        gap, body = max(lacking, key=lambda r: (round(min(r[0], 99.0), 3), r[1].id))
        far = f"the nearest is {gap:.1f} m from {body.id}" if math.isfinite(gap) else "there is none"
        yield breach(
            "towel_in_reach",
            (b.id for _, b in lacking),
            f"no towel within {reach:g} m of {names(b for _, b in lacking)}: {far}",
            measured=gap,
            allowed=(None, reach),
            weight=0.5 + 0.5 * len(lacking),
            suggestion=f"hang a towel within {reach:g} m of {names(b for _, b in lacking)}",
        )
    for rail in survey.of_kind(("towel_rail", "towel_radiator")):
        if rail.item.mount != "wall":
            continue
        area = strip(rail, "front", 0.15, 0.9)
        below = [
            b
            for b, s in inside(survey, area, (rail,))
            if s > 0.15 and b.z[1] > rail.z[0] - HANGING and b.item.category not in BATHS
        ]
        if below:
            yield breach(
                "before_use",
                (rail.id, *(b.id for b in below)),
                f"{names(below)} stands under {rail.id}: towels hang on it",
                suggestion=f"move {names(below)} away from {rail.id}",
            )


def _paper(survey: Survey) -> Iterator[Finding]:
    limits = design_rules()["paper_in_reach"].limits
    for toilet in survey.of_kind(("toilet", "wall_toilet")):
        papers = survey.of_kind(("toilet_paper_holder", "toilet_paper_stand"))
        if not papers:
            continue
        spots = [toilet.local(p.centre) for p in papers]
        ahead, aside = min(spots, key=lambda s: abs(s[1]) + abs(s[0] - BOWL))
        beyond = ahead - toilet.size[0] / 2
        if abs(aside) > limits["axis"] or not limits["low"] - 0.4 <= beyond <= limits["high"]:
            yield breach(
                "paper_in_reach",
                (papers[0].id, toilet.id),
                f"{papers[0].id} is {abs(aside):.2f} m beside {toilet.id} and {beyond:+.2f} m ahead of its bowl",
                measured=abs(aside),
                allowed=(0.0, limits["axis"]),
                weight=1.0 if abs(aside) > limits["axis"] else 0.4,
                suggestion=f"hang it beside {toilet.id}, 0.2 to 0.3 m ahead of the bowl",
            )


def _mats(survey: Survey) -> Iterator[Finding]:
    """Mats that lie at no way out of bath, shower or basin, and ways out without a mat."""
    limits = design_rules()["mat_at_exit"].limits
    mats = survey.on_floor(("bath_mat",))
    exits = survey.on_floor(SHOWERS, BATHS)
    served: set[int] = set()
    lost = []
    for mat in mats:
        at = [b for b in exits if _at_exit(survey, b, mat, limits)]
        served |= {b.index for b in at}
        if not at and not any(_at_exit(survey, b, mat, limits) for b in survey.on_floor(BASINS)):
            lost.append(mat)
    bare = [b for b in exits if b.index not in served]
    if lost or (bare and not mats):
        what = f"{names(lost)} lies at no way out of bath or shower" if lost else f"no mat lies before {names(bare)}"
        yield breach(
            "mat_at_exit",
            (*(b.id for b in lost), *(b.id for b in bare)),
            what,
            measured=float(len(lost) or len(bare)),
            weight=0.6 + 0.4 * max(len(lost), 1),
            suggestion=f"lay a mat before {names(bare or exits)}",
        )


def _at_exit(survey: Survey, body: Body, mat: Body, limits: dict[str, float]) -> bool:
    """Whether a mat lies at an open side of something, and before the middle of that side."""
    reach = "basin" if body.item.category in BASINS else "corner" if body.item.category == "corner_shower" else "gap"
    if survey.placed.distance(body, mat) > limits[reach]:
        return False
    ahead, aside = body.local(mat.centre)
    d, w = body.size[0] / 2, body.size[1] / 2
    slack = limits["offset"] - 0.2
    before = ahead > d - 0.1 and abs(aside) <= w + slack
    if body.item.category == "corner_shower":
        return before or (aside < 0.1 - w and abs(ahead) <= d + slack)  # its corner is at the back on the left
    return before or (body.item.category == "freestanding_bathtub" and ahead < 0.1 - d and abs(aside) <= w + slack)


def _flush(survey: Survey) -> Iterator[Finding]:
    """Showers and baths that stand a slot off a wall that they are against."""
    limits = design_rules()["flush_with_walls"].limits
    for body in survey.on_floor(SHOWERS, ("bathtub",)):
        gaps = {s: survey.clear_ahead(body, s) for s in ("back", "left", "right")}
        slots = {s: g for s, g in gaps.items() if limits["low"] + 0.01 < g < limits["high"]}
        if slots:
            side = max(slots, key=lambda s: (round(slots[s], 3), s))
            yield breach(
                "flush_with_walls",
                (body.id,),
                f"{slots[side]:.2f} m between the {side} of {body.id} and the wall",
                measured=slots[side],
                allowed=(0.0, limits["low"]),
                suggestion=f"push {body.id} into its corner",
            )


def _stools(survey: Survey) -> Iterator[Finding]:
    most = limit("stool_at_shower", "gap")
    wet = survey.on_floor(SHOWERS)
    for stool in survey.on_floor(("shower_stool",)):
        gap = min((survey.placed.distance(stool, b) for b in wet), default=math.inf)
        if gap > most:
            far = f"{gap:.2f} m from the shower" if math.isfinite(gap) else "in a room without a shower"
            yield breach(
                "stool_at_shower",
                (stool.id,),
                f"{stool.id} stands {far}",
                measured=gap,
                allowed=(None, most),
                suggestion=f"put {stool.id} in or beside the shower",
            )
