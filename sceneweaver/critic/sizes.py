"""Whether sizes are those of such things: against the usual ranges, against equals, against what carries them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from sceneweaver.assets import categories
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding
from .survey import Survey

NAMES = ("depth", "width", "height")

ROOM = (1.3, 1.3, 1.5)
"""Factors beyond the usual depth, width and height that still pass; beds without a headboard are low."""

WRONG = 1.8
"""Factor from which a size hinders belief and use."""

DEEP = 0.3
"""Depth [m] up to which what hangs before a window may be of any: folds and rods differ."""

THIN = 0.03
"""Sizes [m] below which nobody sees a difference: the thickness of rugs and mats."""

UNEQUAL = 1.35
"""Factor between the largest and the smallest extent of things that should be equal."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Sizes out of range, unequal siblings, small things larger than what carries them."""
    for body in survey.bodies:
        yield from _range(survey, body)
    yield from _equals(survey)
    yield from _carried(survey)


def _range(survey: Survey, body: Body) -> Iterator[Finding]:
    row = categories().get(body.item.category)
    if row is None or row.size is None:
        return
    item = survey.program.item_of.get(body.id)
    own = survey.room_type.item(item).size if item else (None, None, None)
    asked = next((a for a in survey.brief.entities if a.id == survey.program.asked_of.get(body.id)), None)
    worst, words, target, odd = 1.0, "", list(body.size), False
    for k in range(3):
        low, high = row.size.ranges[k]
        given = own[k]
        if given is not None:
            low, high = min(low, given[0]), max(high, given[1])
        if asked is not None:
            wish = asked.size[k]
            low, high = (min(low, wish), max(high, wish)) if wish is not None else (low, high)
            low, high = low * min(1.0, asked.scale), high * max(1.0, asked.scale)
            if any(a.kind in ("size", "other") for a in asked.attributes):
                low, high = min(low, row.size.reach[k][0]), max(high, row.size.reach[k][1])
        size = body.size[k]
        if max(size, high) <= THIN or (k == 0 and body.item.category in kinds.WINDOW_WEAR and size < DEEP):
            continue
        factor = max(size / high, low / max(size, 1e-6))
        odd = odd or factor > ROOM[k]
        if factor > worst and factor > ROOM[k]:
            worst, words = factor, f"{size:.2f} m {NAMES[k]}, usual are {low:.2f} to {high:.2f} m"
        target[k] = min(max(size, low), high)
    if odd:
        yield finding(
            "layout",
            "wrong_size",
            (body.id,),
            f"{body.id} ({kinds.words(body.item.category)}) has {words}",
            f"give {body.id} the size {' x '.join(f'{t:.2f}' for t in target)} m",
            points=1.0 if worst < WRONG else min(3.0, 1.0 + worst),
            grave=worst >= WRONG,
            call=("update_size", {"sizes": {body.id: [round(t, 3) for t in target]}}),
        )


def _equals(survey: Survey) -> Iterator[Finding]:
    """Instances of an item that should be equal, around or beside the same thing; pictures differ."""
    sets: dict[tuple[str, str], list[Body]] = defaultdict(list)
    for body in survey.bodies:
        item = survey.program.item_of.get(body.id)
        hung_later = body.item.intent.program_item is None
        if body.item.mount == "wall" and (hung_later or body.item.category in kinds.EYE_LEVEL):
            continue
        if item is not None and survey.room_type.item(item).same and body.item.mount != "surface":
            sets[item, body.item.category].append(body)
    for bodies in sets.values():
        if len(bodies) < 2:
            continue
        middle = sorted(bodies, key=lambda b: (round(b.size[0] * b.size[1] * b.size[2], 4), b.id))[len(bodies) // 2]
        odd = [b for b in bodies if _factor(b, middle) > UNEQUAL]
        if odd:
            yield finding(
                "layout",
                "unequal_siblings",
                (b.id for b in odd),
                f"{odd[0].id} differs from {middle.id} by a factor of {_factor(odd[0], middle):.1f}",
                f"give them the size of {middle.id}",
                call=("update_size", {"sizes": {b.id: list(middle.size) for b in odd}}),
            )


def _factor(a: Body, b: Body) -> float:
    return max(max(x / y, y / x) for x, y in zip(a.size, b.size, strict=True) if max(x, y) > THIN)


def _carried(survey: Survey) -> Iterator[Finding]:
    """Something unknown on a table may have any size, but is not as large as the table."""
    for body in survey.bodies:
        if body.item.support is None or body.item.category in categories():
            continue
        base = survey.placed.by_id.get(body.item.support.object)
        if base is None or max(body.size[:2]) <= 0.9 * max(base.size[:2]) and body.size[2] < 1.2:
            continue
        factor = 0.4 * max(base.size[:2]) / max(body.size)
        yield finding(
            "layout",
            "wrong_size",
            (body.id, base.id),
            f"{body.id} measures {max(body.size):.2f} m and stands on {base.id} of {max(base.size[:2]):.2f} m",
            f"make {body.id} smaller",
            points=1.5,
            call=("update_size", {"sizes": {body.id: [round(s * factor, 3) for s in body.size]}}),
        )
