"""Room under things: what a request puts under something on the floor fits there, or is told that it does not.

The thing above is drawn so that there is room below it (a bench on legs, a counter with an open bay), and what goes
under it as low as it may be.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from sceneweaver.assets import Asset, Library
from sceneweaver.assets.roles import has_role
from sceneweaver.geometry.polygons import signed_area
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import CATALOGUE, InputError, Room

from .program import Wanted

CLOSED = 0.6
"""Share of the floor under a thing that its body covers from which on nothing else is under it."""

FREE = 0.02
"""Height [m] that is left free above what stands under something."""

DRAWINGS = 8
"""Bodies that are tried for what is to have room below it."""

SLIDE = 0.15
"""How far [m] the bottom of a thing below a window may be lower than right under its sill."""

STEP, CLEAR, OFFSET = 0.04, 0.012, 0.05
"""Of the places under something: their distance [m], the gap to bodies, and how far a thing may be off its own."""

TURNS = {"front": 0, "left": 90, "right": -90, "back": 180}
"""The turn [deg] of a thing that looks out at a side of another."""

WALLED = 1.0
"""What it counts [m] that a thing looks to a side that may be at a wall."""

MOSTLY = 0.75
"""Least share of a thing that is under another."""

PLACED = CATALOGUE.with_role("placing", "turning", "edge", "wall", "seat") | {
    "distance",
    "near_window",
    "near_door",
    "over",
}
"""Types of relations that what stands under another thing has no more."""

LOW_BOARD = 0.25
"""Height [m] up to which what stands on a board of a thing is under it for people."""

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
        changed |= _opened(lower, upper, library) or _lowered(lower, upper, library) or _shelved(lower, upper)
    return changed


def set_under(rows: Sequence[Grounded], wanted: Sequence[Wanted]) -> list[Grounded]:
    """Rows with a place in the frame of the thing above for what goes under it, where there is one: the search moves
    both as one. What is said beside that of where it stands follows from the thing above."""
    standing = {one.id: one for one in wanted if one.mount == "floor" and one.support is None}
    bound = {row.subject for row in rows if row.type == "arranged"}
    taken: dict[str, list[Any]] = {}
    placed: dict[tuple[str, str], Grounded] = {}
    for row in rows:
        lower, upper = standing.get(row.subject), standing.get(str(row.target))
        if row.type != "over" or not row.hard or lower is None or upper is None or lower.id in bound:
            continue
        if lower is upper or lower.thing.is_flat or upper.thing.is_flat:
            continue
        found = _spot(lower.asset, upper.asset, taken.setdefault(upper.id, []))
        if found is not None:
            bound.add(lower.id)
            placed[row.subject, upper.id] = replace(row, type="arranged", params=found)
    inner = {subject for subject, _ in placed}
    kept = [row for row in rows if row.subject not in inner or row.type not in PLACED]
    return [*kept, *placed.values()]


def without_company(wanted: Sequence[Wanted], stated: Sequence[Grounded]) -> list[Wanted]:
    """What was wanted, without what nobody asked for that goes with a thing under another and has no room there.

    That is a shelf over the desk, a bin beside it; its seats stay.
    """
    bodies = {one.id: one for one in wanted if one.mount == "floor" and one.support is None}
    lower = {
        row.subject
        for row in stated
        if row.type == "over" and row.hard and row.subject in bodies and str(row.target) in bodies
        if not bodies[str(row.target)].thing.is_flat
    }

    def in_the_way(one: Wanted) -> bool:
        goes_along = one.parent is not None and one.parent.id in lower and one.support is None
        return goes_along and one.asked is None and not one.thing.is_seat

    return [one for one in wanted if not in_the_way(one)]


def _spot(lower: Asset, upper: Asset, taken: list[Any]) -> dict[str, float] | None:
    """Where a thing stands under another, in the frame of that, clear of its body and of what is ``taken``.

    What is used from its front looks out at a side by which the other is entered, with its back to the side across.
    """
    import shapely

    body = upper.object("body", mount="floor")
    depth, width, height = lower.size
    solids = [shapely.Polygon(part.polygon) for part in body.solids if part.z[0] < height + CLEAR]
    blocked = shapely.union_all([*solids, *taken]).buffer(CLEAR) if solids or taken else shapely.Polygon()
    outline = shapely.union_all([shapely.Polygon(part.polygon) for part in body.solids]).convex_hull
    half = body.size[0] / 2, body.size[1] / 2
    used = any(zone.name == "front" for zone in lower.zones) or has_role(lower.category, "pulled_up_to")
    best: tuple[float, dict[str, float], Any] | None = None
    ahead, left = (np.concatenate(a) for a in zip(*((x * np.ones_like(y), y) for x, y in _places(half)), strict=True))
    open_sides = {zone.name for zone in upper.zones if zone.hard} & set(TURNS) or {"front", "left", "right"}
    for side, turn in TURNS.items():
        deep, wide = (depth / 2, width / 2) if turn in (0, 180) else (width / 2, depth / 2)
        boxes = shapely.box(ahead - deep, left - wide, ahead + deep, left + wide)
        share = shapely.area(shapely.intersection(boxes, outline)) / (depth * width)
        front = half[0] if turn in (0, 180) else half[1]
        middle = ahead * math.cos(math.radians(turn)) + left * math.sin(math.radians(turn))
        off = np.abs(front + middle - depth / 2) if used else np.hypot(ahead, left)
        off = off + (side not in open_sides) * WALLED + 0.001 * abs(turn)
        score = np.where((share < MOSTLY) | shapely.intersects(boxes, blocked), np.inf, off + 2 * (1 - share))
        k = int(np.argmin(score))
        if score[k] < (best[0] - 1e-9 if best is not None else np.inf):
            best = float(score[k]), {"ahead": float(ahead[k]), "left": float(left[k]), "turn": float(turn)}, boxes[k]
    if best is None:
        return None
    taken.append(best[2])
    return {**best[1], "offset": OFFSET, "degrees": 2.0}


def _places(half: tuple[float, float]) -> list[tuple[float, Any]]:
    """Coordinates [m] of places under a thing, row by row, its middle among them."""
    rows, columns = (np.round(np.arange(-int(h / STEP), int(h / STEP) + 1) * STEP, 3) for h in half)
    return [(float(row), columns) for row in rows]


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
    return _spot(lower, upper, []) is not None


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


def _shelved(lower: Wanted, upper: Wanted) -> bool:
    """Whether a thing has room on a board close to the floor under another: crates under a workbench."""
    deep, wide = sorted(lower.asset.size[:2])
    for surface in upper.asset.surfaces:
        xs, ys = zip(*surface.polygon, strict=True)
        sides = sorted((max(xs) - min(xs), max(ys) - min(ys)))
        low = surface.headroom is not None and surface.z <= LOW_BOARD and surface.headroom > lower.asset.size[2] + FREE
        if low and sides[0] >= deep and sides[1] >= wide:
            lower.support, lower.inside = upper, True
            return True
    return False


__all__ = ["below_windows", "is_closed", "set_under", "with_room_below", "without_company"]
