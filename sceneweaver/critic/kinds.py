"""Roles of categories by the names that the checks use, and their names in words."""

from __future__ import annotations

from functools import cache

from sceneweaver.assets import categories
from sceneweaver.assets.roles import groups_above, has_role, with_role

DESKS = with_role("desk")
DINING = with_role("dining_table")
SEATED_AT = with_role("seated_at")
HIGH_SEATS = with_role("high_seat")
COFFEE = with_role("coffee_table")
SOFAS = with_role("sofa")
LOUNGE = with_role("lounge_seat")
TVS = with_role("screen")
DESK_SCREENS = with_role("desk_screen")
BEDS = with_role("bed")
LONG_BEDS = with_role("side_bed")
WALL_BACKED = with_role("wall_backed")
TALL_PLANTS = with_role("tall_plant")
WINDOW_WEAR = with_role("window_dressing")
SEE_THROUGH = with_role("see_through")
WALL_ART = with_role("wall_art")
EYE_LEVEL = with_role("eye_level")

groups_of = groups_above


def upright_seat(category: str) -> bool:
    """Whether it is a seat to sit on at a table."""
    return has_role(category, "upright_seat")


@cache
def carries(category: str) -> bool:
    """Whether something should stand on or in it: tables, desks, counters, shelves, and no seats or beds."""
    row = categories().get(category)
    if row is None or not row.holds or has_role(category, "closed_storage"):
        return False
    return not groups_above(category) & {"seating", "bed_group", "tableware"}


def words(category: str) -> str:
    """The name as a user would write it."""
    return category.replace("_", " ")


def a(category: str) -> str:
    """The name with its article."""
    return f"{'an' if category[0] in 'aeiou' else 'a'} {words(category)}"
