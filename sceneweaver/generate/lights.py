"""The lighting plan: one lamp over each table, the others on a grid that covers the ceiling, and none in the way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.spread import even_count
from sceneweaver.knowledge import Item
from sceneweaver.rules.design import design_rules

OVER_TABLE = 0.7
"""Height [m] between a table and the lamp that hangs over it."""

TABLE = 0.6
"""Least height [m] of a table that a lamp may hang low over: people walk beside a coffee table."""

OVER = frozenset(("over", "above", "centered_on"))
"""Relations of a lamp to what it hangs over."""

NEAR_PLACE = 0.1
"""Distance [m] from its place that is left to a lamp over a table."""


def lamp_count(item: Item | None, outline: Sequence[tuple[float, float]], count: int) -> int:
    """How many of an item there are on the ceiling of a room: as many as make a full grid."""
    on_grid = item is not None and any(place.type == "on_grid" for place in item.place)
    return even_count(outline, count) if on_grid and count > 1 else count


def hanging_height(category: str, ceiling: float, below: float | None) -> float | None:
    """The height [m] of a lamp that hangs from a ceiling at some height: so that it ends above a table of height
    ``below``, or lets people pass; None for what does not hang down."""
    known = category_named(category).size
    if known is None or "ceiling" not in category_named(category).mount or known.height[1] < 0.5:
        return None
    clear = design_rules()["pendant_clear"].limits["height"]
    drop = ceiling - (clear if below is None else below + OVER_TABLE)
    return round(min(max(drop, known.height[0]), known.height[1]), 3)


def place_along(size: Sequence[float], at: int, count: int) -> dict[str, Any]:
    """The parameters of ``over`` for one of some lamps over a thing of some size: its middle, or even places along its
    longer side."""
    if count < 2:
        return {"offset": NEAR_PLACE}
    return {"left" if size[1] >= size[0] else "forward": round((at + 0.5) / count - 0.5, 4), "offset": NEAR_PLACE}
