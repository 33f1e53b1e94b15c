"""How high things hang: lamps over tables and out of the way of people, what is before windows, what is on walls.

Of lamps, one is over each table, and the others are on a grid that covers the ceiling.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from sceneweaver.assets import Asset, Wish
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.geometry.spread import even_count
from sceneweaver.knowledge import Item
from sceneweaver.knowledge.model import Range
from sceneweaver.rules.design import limit

from .draft import groups_of

ABOVE_PANE = 0.1
"""Height [m] of a curtain beyond that of the top of its window: its rod hangs over the window."""

UPRIGHT = (1.2, 1.5)
"""Heights [m] of the bottom of what hangs on a wall and of which nothing is known."""

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
    drop = ceiling - (limit("pendant_clear", "height") if below is None else below + OVER_TABLE)
    return round(min(max(drop, known.height[0]), known.height[1]), 3)


def place_along(size: Sequence[float], at: int, count: int) -> dict[str, Any]:
    """The parameters of ``over`` for one of some lamps over a thing of some size: its middle, or even places along its
    longer side."""
    if count < 2:
        return {"offset": NEAR_PLACE}
    return {"left" if size[1] >= size[0] else "forward": round((at + 0.5) / count - 0.5, 4), "offset": NEAR_PLACE}


def is_lit_table(category: str, height: float) -> bool:
    """Whether lamps hang low over furniture of a category and a height [m]."""
    return height >= TABLE and "table_group" in groups_of(category)


def before_window(wish: Wish, category: str, pane: tuple[float, float, float], ceiling: float) -> Wish:
    """A wish for what hangs before a window, as wide and high as that needs unless its width is given.

    A blind is drawn up half the way, the rod of a curtain down to the floor is above the window.

    Args:
        wish: for the body.
        category: what hangs there.
        pane: width, height and top [m] of the window.
        ceiling: height [m] of the room.
    """
    if wish.size[1] is not None:
        return wish
    width, height, top = pane
    drop, usual = wish.size[2], category_named(category).size
    if not drop and has_role(category, "blind"):
        drop = 0.5 * height
    elif not drop and has_role(category, "curtain") and usual is not None:
        drop = round(min(max(min(top + ABOVE_PANE, ceiling - 0.05), usual.height[0]), usual.height[1]), 3)
    return replace(wish, size=(wish.size[0], width + 2 * limit("curtain_width", "beyond") + 0.04, drop))


def hung_between(asset: Asset, item: Item | None, ceiling: float, over: float = 0.0) -> Range:
    """Heights [m] between which the bottom of a thing on a wall is: its item's or its category's, under the ceiling and
    above what it hangs over, which is ``over`` high [m]."""
    own = item.hung(asset.size[2]) if item is not None else None
    low, high = own or category_named(asset.category).bottom or UPRIGHT
    if over:
        low, high = max(low, over + 0.08), max(high, over + (0.12 if own else 0.3))
    most = max(0.0, ceiling - asset.size[2] - 0.02)
    return round(min(low, max(0.0, most - 0.1)), 3), round(min(high, most), 3)
