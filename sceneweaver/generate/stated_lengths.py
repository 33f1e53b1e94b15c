"""Heights that a request states, in a program of things: of tops and seats, up to the ceiling, and on the wall.

Extents are part of the wish for a body from the start; these follow from the body that was drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.assets import Asset, Library
from sceneweaver.assets.levels import clear_below, used_level
from sceneweaver.assets.roles import groups_above as groups_of
from sceneweaver.language import SceneGraph, StatedMeasure
from sceneweaver.language.measured import worktop_categories

from .program import Wanted

TRIES = 4
"""Bodies that are drawn to bring a top to a height."""

CLOSE = 0.004
"""Difference [m] to it that is left."""

PLAY = 0.005
"""Half of the interval [m] that a height on the wall leaves."""

UNDER_CEILING = 0.02
"""Gap [m] of what reaches up to the ceiling."""


def with_stated_lengths(wanted: Sequence[Wanted], brief: SceneGraph, ceiling: float, library: Library) -> None:
    """Gives things bodies and places on the wall as the lengths of a request have them.

    Args:
        wanted: the things; bodies and heights of those that a length is said of change.
        brief: the request.
        ceiling: height of the room [m].
        library: where bodies are from.
    """
    for measure in brief.measures:
        if measure.categories:
            _limit([one for one in wanted if _is_of(one, measure)], measure, ceiling, library)
            continue
        if measure.entity:
            things = [one for one in wanted if one.asked == measure.entity]
        else:
            things = [one for one in wanted if one.category in worktop_categories()]
        levels = [m for m in brief.measures if m.entity == measure.entity and m.quantity == measure.quantity]
        for k, one in enumerate(things):
            _apply(one, levels[k % len(levels)], ceiling, library)


def _is_of(one: Wanted, measure: StatedMeasure) -> bool:
    """Whether a limit on all things of some kinds, or on all that stand on something, is on a thing."""
    if measure.on and (one.support is None or one.support.asked != measure.on):
        return False
    return not {"object", one.category, *groups_of(one.category)}.isdisjoint(measure.categories)


def _limit(things: Sequence[Wanted], measure: StatedMeasure, ceiling: float, library: Library) -> None:
    """Lower bodies for what stands higher than a limit, or higher ones, and lower places on the wall."""
    for one in things:
        height = one.asset.size[2]
        if measure.quantity == "upper" and one.mount == "wall" and measure.high is not None and height < measure.high:
            one.hung = hung_as(measure, height, ceiling)
        elif measure.quantity in ("upper", "height") and measure.high is not None and height > measure.high:
            _as_high(one, measure.high, library)
        elif measure.quantity == "lowest" and one.mount == "floor":
            _brought(one, measure, library)


def _apply(one: Wanted, measure: StatedMeasure, ceiling: float, library: Library) -> None:
    match measure.quantity:
        case "ceiling":
            _as_high(one, ceiling - UNDER_CEILING, library)
        case "top" | "seat" | "knee":
            _brought(one, measure, library)
        case "centre" | "bottom" | "upper" | "placed" if one.mount == "wall":
            one.hung = hung_as(measure, one.asset.size[2], ceiling)
        case _:
            pass


def hung_as(measure: StatedMeasure, height: float, ceiling: float) -> tuple[float, float]:
    """Heights [m] between which the bottom of a thing on the wall of some height is, for a stated one."""
    share = {"centre": 0.5, "upper": 1.0, "bottom": 0.0}.get(measure.quantity, 0.5)
    wanted = measure.wanted - share * height
    bottom = min(max(wanted, 0.02), max(0.02, ceiling - height - UNDER_CEILING))
    return round(max(0.0, bottom - PLAY), 4), round(bottom + PLAY, 4)


def _brought(one: Wanted, measure: StatedMeasure, library: Library) -> None:
    """Another body, so that its top, its seat or what is clear below it is as high as is asked."""
    for _ in range(TRIES):
        parts, size = one.asset.parts, one.asset.size
        level = clear_below(parts, size) if measure.quantity == "knee" else used_level(parts, one.asset.surfaces)
        low, high = measure.low or 0.0, measure.high if measure.high is not None else float("inf")
        if level is None or low - CLOSE <= level <= high + CLOSE:
            return
        wanted = measure.wanted if low == high else min(max(level, low), high)
        if not _as_high(one, one.asset.size[2] + wanted - level, library):
            return


def _as_high(one: Wanted, height: float, library: Library) -> bool:
    """Another body of that height [m]; whether it came nearer to it."""
    if one.wish is None:
        return False
    depth, width, _ = one.asset.size
    wish = replace(one.wish, size=(round(depth, 4), round(width, 4), round(height, 4)), beyond=True)
    found: Asset = library.choose(one.category, 1, wish)[0]
    nearer = abs(found.size[2] - height) < abs(one.asset.size[2] - height) - 1e-4
    if nearer:
        one.asset, one.wish = found, wish
    return nearer


__all__ = ["hung_as", "with_stated_lengths"]
