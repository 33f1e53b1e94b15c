"""What became of the lengths that a request states of things, measured where they stand."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sceneweaver.assets.levels import clear_below, used_level
from sceneweaver.language import StatedMeasure
from sceneweaver.language.measured import worktop_categories
from sceneweaver.rules.faults import fault_kind
from sceneweaver.verify.measure import Measurement
from sceneweaver.verify.solids import Body

from . import kinds
from .asked_words import of_each
from .survey import Survey
from .verdict import Asked, met, not_understood, partly, text_of, unmet

LIMITS = fault_kind("wrong_asked_length").limits

_NAMES = {
    "top": "height of the top",
    "seat": "height of the seat",
    "centre": "height of the middle",
    "bottom": "height of the bottom",
    "upper": "height of the upper edge",
    "placed": "height above the floor",
    "ceiling": "gap to the ceiling",
    "lowest": "height",
    "knee": "clear height below the top",
}


def outcomes(survey: Survey) -> Iterator[Asked]:
    """Each length that the request states; heights of which several are said of things are shared out among them."""
    brief = survey.brief
    for measure in brief.measures:
        bodies = _bodies(survey, measure)
        if not bodies and measure.categories:
            yield met("attribute", measure.id, (), f"'{measure.words}': there is none, so none is beyond it")
            continue
        if not bodies:
            yield unmet(
                "attribute",
                measure.id,
                (),
                f"nothing is there of which '{measure.words}' could be so",
                fault="missing_attribute",
            )
            continue
        found = [(body, m) for body in bodies if (m := _measured(survey, measure, body)) is not None]
        if not found:
            ids = [body.id for body in bodies]
            yield not_understood("attribute", measure.id, ids, f"'{measure.words}' cannot be measured here")
            continue
        several = [m for m in brief.measures if _of_same(m, measure) and not measure.categories]
        good = [body for body, m in found if m.ok()]
        yield _outcome(measure, found, good, any_=len(several) > 1)


def _of_same(one: StatedMeasure, other: StatedMeasure) -> bool:
    return (one.entity, one.quantity, one.categories) == (other.entity, other.quantity, other.categories)


def _bodies(survey: Survey, measure: StatedMeasure) -> list[Body]:
    if measure.categories:
        kinds_ = set(measure.categories)
        carriers = survey.ids_of(measure.on) if measure.on else []
        among = [b for name in carriers for b in survey.carried.get(name, ())] if measure.on else survey.bodies
        return [b for b in among if "object" in kinds_ or {b.item.category, *kinds.groups_of(b.item.category)} & kinds_]
    if measure.entity:
        return survey.standing_for(measure.entity)
    return [body for body in survey.bodies if body.item.category in worktop_categories()]


def _outcome(
    measure: StatedMeasure, found: Sequence[tuple[Body, Measurement]], good: Sequence[Body], any_: bool
) -> Asked:
    ids = [body.id for body, _ in found]
    worst = max((m for _, m in found if not m.ok()), key=lambda m: m.excess, default=None)
    if worst is None or (any_ and good):
        body, number = next((body, m) for body, m in found if m.ok())
        if len(found) == 1 and (each := of_each(measure.words)):
            reason = f"{body.id}: {text_of(number)}, but '{each}' is said of several"
            return partly("attribute", measure.id, ids, reason, number)
        return met("attribute", measure.id, ids, f"{body.id}: {text_of(number)}, as asked", number)
    wrong = [body for body, m in found if not m.ok()]
    body = next(body for body, m in found if m is worst)
    return unmet(
        "attribute",
        measure.id,
        ids,
        f"{body.id}: {text_of(worst)}, '{measure.words}' was asked for",
        worst,
        fault="wrong_asked_length",
        wrong=[one.id for one in wrong],
        share=len(wrong) / len(found),
        suggestion=f"replace {', '.join(one.id for one in wrong)} by {kinds.words(body.item.category)} as asked",
        call=_resized(measure, wrong, worst),
    )


def _resized(measure: StatedMeasure, wrong: Sequence[Body], worst: Measurement):
    axis = {"depth": 0, "width": 1, "height": 2}.get(measure.quantity)
    if axis is None:
        return None
    size = {body.id: [round(s if k != axis else measure.wanted, 3) for k, s in enumerate(body.size)] for body in wrong}
    return "update_size", {"sizes": size}


def _measured(survey: Survey, measure: StatedMeasure, body: Body) -> Measurement | None:
    """The length of one object with the interval that counts as asked; None where it has none."""
    value = _value(survey, measure, body)
    if value is None:
        return None
    low, high = _interval(measure)
    name = _NAMES.get(measure.quantity, measure.quantity)
    return Measurement(name, value, low, high, "m")


def _interval(measure: StatedMeasure) -> tuple[float, float]:
    if measure.quantity == "ceiling":
        return -math.inf, LIMITS["ceiling"]
    share = LIMITS["vague"] if measure.vague else LIMITS["share"]
    slack = max(LIMITS["least"], share * measure.wanted) if measure.low == measure.high else LIMITS["least"]
    slack = LIMITS["kind"] if measure.categories else slack
    return (
        -math.inf if measure.low is None else measure.low - slack,
        math.inf if measure.high is None else measure.high + slack,
    )


def _value(survey: Survey, measure: StatedMeasure, body: Body) -> float | None:
    depth, width, height = body.size
    low, high = body.z
    wall = body.item.mount == "wall"
    match measure.quantity:
        case "depth":
            return depth
        case "width":
            return _across(measure, survey, body) if not wall else width
        case "height":
            return height
        case "length":
            return width if wall else max(depth, width)
        case "diameter" | "side":
            sides = (width, height) if wall else (depth, width)
            return max(sides, key=lambda side: abs(side - measure.wanted))
        case "top" | "seat":
            level = used_level(body.item.solids, body.item.surfaces)
            return low + (level if level is not None else height)
        case "centre":
            return (low + high) / 2
        case "bottom":
            return low
        case "upper":
            return high
        case "lowest" if body.item.mount in ("wall", "ceiling"):
            return low
        case "lowest":
            level = used_level(body.item.solids, body.item.surfaces)
            return low + (level if level is not None else height)
        case "knee":
            return clear_below(body.item.solids, body.size)
        case "ceiling":
            return survey.scene.room.height - high
        case "placed":
            if not wall:
                return low
            least, most = _interval(measure)
            return min(max((low + high) / 2, least), most) if low <= most and high >= least else (low + high) / 2


def _across(measure: StatedMeasure, survey: Survey, body: Body) -> float:
    """The width of a thing; where its length is said as well, its shorter side."""
    other = any(m.entity == measure.entity and m.quantity == "length" for m in survey.brief.measures)
    return min(body.size[:2]) if other else body.size[1]


__all__ = ["outcomes"]
