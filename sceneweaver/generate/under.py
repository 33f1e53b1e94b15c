"""Room under things: what a request puts under something on the floor fits there, or is told that it does not.

The thing above is drawn so that there is room below it (a bench on legs, a counter with an open bay), and what goes
under it as low as it may be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.assets import Asset, Library
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import InputError, Room

from .program import Wanted

CLOSED = 0.6
"""Share of the floor under a thing that its body covers from which on nothing else is under it."""

FREE = 0.02
"""Height [m] that is left free above what stands under something."""

DRAWINGS = 8
"""Bodies that are tried for what is to have room below it."""

SLIDE = 0.15
"""How far [m] the bottom of a thing below a window may be lower than right under its sill."""

LOW = 0.05
"""Least height [m] over the floor of a part that spans what is under it."""


def is_closed(lower: Wanted | None, upper: Wanted | None) -> bool:
    """Whether a thing that is to be under another finds no room there, as that is closed down to the floor."""
    if lower is None or upper is None or lower.thing.is_flat or upper.thing.is_flat:
        return False
    return _covered(upper.asset, lower.asset.size[2]) > CLOSED


def with_room_below(rows: Sequence[Grounded], wanted: Sequence[Wanted], library: Library) -> bool:
    """Draw what was asked to have things under it with room for them, and these low enough; whether one was drawn anew.

    Args:
        rows: the grounded relations.
        wanted: the objects to be; those that do not fit get other bodies.
        library: where bodies come from.
    """
    standing = {one.id: one for one in wanted if one.mount == "floor" and one.support is None}
    changed = False
    for row in rows:
        lower, upper = standing.get(row.subject), standing.get(str(row.target))
        if row.type != "over" or not row.hard or lower is None or upper is None or lower is upper:
            continue
        if lower.thing.is_flat or upper.thing.is_flat or _fits(lower.asset, upper.asset):
            continue
        changed |= _opened(lower, upper, library) or _lowered(lower, upper, library)
    return changed


def below_windows(brief: SceneGraph, wanted: Sequence[Wanted], room: Room) -> None:
    """Gives what hangs on a wall and is to be below a window its height: under the sill."""
    named = {said.subject for said in brief.relations if said.type == "below" and said.targets[:1] == ("window",)}
    sill = min((window.sill for window in room.windows), default=0.0)
    for one in wanted:
        most = sill - one.asset.size[2] - FREE
        if one.asked in named and one.mount == "wall" and most >= LOW:
            one.hung = (round(max(LOW, most - SLIDE), 3), round(most, 3))


def _covered(asset: Asset, height: float) -> float:
    """Share of a thing's outline that its body covers up to a height [m] over the floor."""
    body = asset.object("body", mount="floor")
    depth, width, _ = body.size
    return sum(abs(signed_area(part.polygon)) for part in body.solids if part.z[0] < height) / (depth * width)


def _fits(lower: Asset, upper: Asset) -> bool:
    return _covered(upper, lower.size[2] + FREE) <= CLOSED


def _opened(lower: Wanted, upper: Wanted, library: Library) -> bool:
    """Whether a body of the same kind has room below it for another thing; it is taken then."""
    if upper.wish is None:
        return False
    taller = [None, upper.asset.size[2], max(upper.asset.size[2], lower.asset.size[2] + 0.12)]
    for number in range(DRAWINGS):
        height = taller[min(number // 3, 2)]
        size = (upper.wish.size[0], upper.wish.size[1], upper.wish.size[2] if number < 3 else height)
        wish = replace(upper.wish, seed=upper.wish.seed + 13 * number, size=size)
        try:
            asset = library.choose(upper.category, 1, wish)[0]
        except InputError:
            continue
        if _fits(lower.asset, asset):
            upper.asset, upper.wish = asset, wish
            return True
    return False


def _lowered(lower: Wanted, upper: Wanted, library: Library) -> bool:
    """Whether a body of the same kind is low enough to go under a thing; it is taken then."""
    if lower.wish is None:
        return False
    body = upper.asset.object("body", mount="floor")
    tops = sorted(part.z[0] for part in body.solids if part.z[0] >= LOW)
    for room in reversed(tops):
        if _covered(upper.asset, room) > CLOSED:
            continue
        wish = replace(lower.wish, size=(*lower.wish.size[:2], round(room - FREE, 3)), beyond=True)
        try:
            asset = library.choose(lower.category, 1, wish)[0]
        except InputError:
            continue
        if _fits(asset, upper.asset):
            lower.asset, lower.wish = asset, wish
            return True
    return False


__all__ = ["below_windows", "is_closed", "with_room_below"]
