"""Measures of sizes: against the usual ranges, and against equals."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import Any, NamedTuple

from sceneweaver.assets import categories
from sceneweaver.assets.roles import has_role
from sceneweaver.verify.solids import Body

from ..design.query import listed
from ..design.registry import measure
from ..survey import Survey

AXES = ("depth", "width", "height")


class OddSize(NamedTuple):
    """An extent [m] that is out of its usual range by a factor, and the size [m] that is in all ranges."""

    axis: str
    size: float
    low: float
    high: float
    factor: float
    target: list[float]


@measure
def odd_size(survey: Survey, o: Body, factors: Sequence[float], thin: float, folds: float) -> list[OddSize]:
    """The extent that is farthest out of its range, where one is by more than its factor.

    What is thinner than ``thin`` [m], or less deep than ``folds`` [m], may be of any size.
    """
    row = categories().get(o.item.category)
    if row is None or row.size is None:
        return []
    worst, target = OddSize("", 0.0, 0.0, 0.0, 1.0, []), list(o.size)
    for k, (size, (low, high)) in enumerate(zip(o.size, _usual_ranges(survey, o), strict=True)):
        if max(size, high) <= thin or (k == 0 and size < folds):
            continue
        factor = max(size / high, low / max(size, 1e-6))
        if factor > max(worst.factor, factors[k]):
            worst = OddSize(AXES[k], size, low, high, factor, target)
        target[k] = round(min(max(size, low), high), 3)
    return [worst] if worst.axis else []


def _usual_ranges(survey: Survey, o: Body) -> list[tuple[float, float]]:
    """From where to where each extent [m] is usual: by its category, the room's item for it, and the request."""
    usual = categories()[o.item.category].size
    assert usual is not None
    item = survey.program.item_of.get(o.id)
    own = survey.room_type.item(item).size if item else (None, None, None)
    asked = survey.brief.entity(survey.program.asked_of.get(o.id, ""))
    found = []
    for k, (low, high) in enumerate(usual.ranges):
        given = own[k]
        if given is not None:
            low, high = min(low, given[0]), max(high, given[1])
        if asked is not None:
            wish = asked.size[k]
            low, high = (min(low, wish), max(high, wish)) if wish is not None else (low, high)
            low, high = low * min(1.0, asked.scale), high * max(1.0, asked.scale)
            if any(a.kind in ("size", "other") for a in asked.attributes):
                low, high = min(low, usual.built[k][0]), max(high, usual.built[k][1])
        found.append((low, high))
    return found


@measure
def resized(_: Survey, bodies: Any, size: Sequence[float]) -> dict[str, list[float]]:
    """By id one size [m] for all of some bodies, as ``update_size`` takes it."""
    return {b.id: list(size) for b in listed(bodies)}


@measure
def scaled(_: Survey, o: Body, factor: float) -> list[float]:
    """A factor times the size [m] of a body."""
    return [round(s * factor, 3) for s in o.size]


@measure
def same_in_program(survey: Survey) -> list[tuple[Body, ...]]:
    """Instances of an item of the room that should be equal, by category; pictures and what was hung later differ."""
    sets: dict[tuple[str, str], list[Body]] = defaultdict(list)
    for body in survey.bodies:
        item = survey.program.item_of.get(body.id)
        hung_later = body.item.intent.program_item is None
        if body.item.mount == "wall" and (hung_later or has_role(body.item.category, "eye_level")):
            continue
        if item is not None and survey.room_type.item(item).same and body.item.mount != "surface":
            sets[item, body.item.category].append(body)
    return [tuple(bodies) for bodies in sets.values()]


@measure
def median_sized(_: Survey, bodies: Sequence[Body]) -> Body:
    """The body whose box is in the middle of some by volume."""
    by_volume = sorted(bodies, key=lambda b: (round(b.size[0] * b.size[1] * b.size[2], 4), b.id))
    return by_volume[len(bodies) // 2]


@measure
def size_factor(_: Survey, a: Body, b: Body, thin: float) -> float:
    """The largest quotient of two extents of boxes along an axis, but for those that both are thinner than ``thin``."""
    return max((max(x / y, y / x) for x, y in zip(a.size, b.size, strict=True) if max(x, y) > thin), default=1.0)
