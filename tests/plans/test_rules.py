"""Each hard rule can be broken, by one change of a house that keeps them all; and the line says what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from sceneweaver.plans import Profile, check_plan
from tests.plans.houses import Data, both, home_with, outline, part, resized, with_part, without

Change = Callable[[Data], object]


def retyped(**types: str) -> Change:
    """The change of types of rooms."""
    return both(*(with_part("rooms", name, type=kind) for name, kind in types.items()))


def added(key: str, **item: Any) -> Change:
    """The change that adds a part."""
    return lambda data: data[key].append(item)


def swings_into(data: Data) -> None:
    """Two doors of the hall's southern corner open into it."""
    part(data, "doors", "front").update(offset=0.0, hinge="left")
    part(data, "doors", "to-kitchen").update(offset=0.05, opens_into="hall", hinge="right")


def with_a_third_storey(data: Data) -> None:
    """A room over the landing that no stairs lead to."""
    data["storeys"].append({"id": "roof", "elevation": 5.8, "height": 2.4})
    data["rooms"].append({"id": "attic", "type": "storage_room", "storey": "roof", "outline": outline((3, 0.3, 5, 4))})


def narrow_hall(x: float) -> Change:
    """The hall with a pier from its eastern wall to ``x``."""
    corners = [[3, 0.3], [5, 0.3], [5, 2.8], [x, 2.8], [x, 3.5], [5, 3.5], [5, 4.2], [3, 4.2]]
    return both(with_part("rooms", "hall", outline=corners), with_part("doors", "to-stairs", wall=6))


def living_around_a_hole(data: Data) -> None:
    """The living room leaves out a place at its western wall that rooms enclose."""
    corners = [[5.1, 0.3], [8.7, 0.3], [8.7, 7.1], [5.1, 7.1], [5.1, 5.0], [6.3, 5.0], [6.3, 4.0], [5.1, 4.0]]
    part(data, "rooms", "living")["outline"] = corners
    part(data, "doors", "to-living").update(wall=7, offset=1.4)


def low(*heights: float) -> Change:
    """Lower storeys, windows with them."""

    def change(data: Data) -> None:
        for storey, height in zip(data["storeys"], heights, strict=True):
            storey["height"] = height
        for window in data["windows"]:
            window["height"] = 1.0

    return change


def narrow_bath(x: float, **door: float) -> Change:
    """A bath that begins at ``x``, with the door to the closet moved into its northern wall."""
    return both(resized("bath", x, 3.1, 2.9, 5.3), with_part("doors", "to-closet", **door))


SMALL_ROOMS = both(
    *(resized(name, 5.1, 0.3, 8.7, 3.3) for name in ("living", "bedroom")),
    *(with_part("doors", name, offset=0.5) for name in ("to-living", "to-bedroom")),
    *(with_part("windows", name, width=1.8) for name in ("w-living", "w-bedroom")),
)

FAR_LAUNDRIES = both(
    retyped(living="living_kitchen"),
    *(
        added("rooms", id=f"far-{x}", type="laundry_room", storey="ground", outline=outline((x, 0.3, x + 2, 3)))
        for x in (12, 16)
    ),
)

BROKEN: dict[str, tuple[Change, str]] = {
    "disjoint": (resized("kitchen", 0.3, 0.3, 2.9, 3.2), "kitchen and shower: they share 0.2600 m2 of floor"),
    "wall-thickness": (resized("living", 5.06, 0.3, 8.7, 7.1), "is 0.060 m thick; at least 0.100 m"),
    "no-voids": (living_around_a_hole, "width is 1.000 m; at most 0.900 m"),
    "storey": (resized("bedroom", 5.1, 0.3, 11.5, 7.1), "bedroom: 6.80 m2 of it reach more than 1.5 m"),
    "doors-lead": (
        with_part("doors", "front", room="store", offset=0.9, width=0.8, opens_into="store"),
        "door front of store: it leads out, but shower lies within 0.90 m",
    ),
    "windows-outside": (
        with_part("windows", "w-bath", wall=1, offset=1.4),
        "window w-bath of bath: stairwell lies within 1.30 m",
    ),
    "openings-apart": (
        added("windows", id="again", room="bath", wall=3, offset=0.6, width=0.6),
        "w-bath and again of bath: they share 0.600 m of a wall",
    ),
    "leaves-free": (swings_into, "doors front and to-kitchen: their leaves meet in hall"),
    "entrance": (without("doors", "front"), "there is no door from outside"),
    "reached": (without("doors", "to-kitchen"), "kitchen: no doors lead from the entrance to it"),
    "shared-toilet": (retyped(shower="wet_room", bath="wet_room"), "there is no toilet; add a bathroom"),
    "habitable-area": (resized("child", 0.3, 0.3, 2.9, 2.7), "child: floor is 6.24 m2; at least 6.50 m2"),
    "one-large-room": (SMALL_ROOMS, "floor is 10.80 m2; at least 11.10 m2"),
    "habitable-side": (resized("child", 0.3, 0.9, 2.9, 3.0), "child: clear width is 2.100 m; at least 2.130 m"),
    "kitchen-side": (resized("kitchen", 0.3, 1.65, 2.9, 3.0), "kitchen: clear width is 1.350 m; at least 1.400 m"),
    "bath-side": (narrow_bath(2.2, offset=1.95, width=0.6), "bath: clear width is 0.700 m; at least 0.760 m"),
    "shower-side": (
        both(retyped(bath="wet_room"), narrow_bath(2.2, offset=1.95, width=0.6)),
        "bath: clear width is 0.700 m; at least 0.760 m",
    ),
    "toilet-side": (
        both(retyped(bath="guest_toilet"), narrow_bath(2.25, offset=1.95, width=0.6)),
        "bath: clear width is 0.650 m; at least 0.700 m",
    ),
    "hall-width": (narrow_hall(3.8), "hall: clear way between its doors is 0.800 m; at least 0.910 m"),
    "ceiling": (low(2.1, 2.1), "living: ceiling height is 2.100 m; at least 2.130 m"),
    "ceiling-wet": (low(2.02, 2.02), "shower: ceiling height is 2.020 m; at least 2.030 m"),
    "aspect": (
        both(resized("living", 5.1, 0.3, 7.5, 7.1), with_part("windows", "w-living-south", offset=0.5)),
        "living: length by width is 2.833; at most 2.5",
    ),
    "daylight": (without("windows", "w-child"), "child: it has no window"),
    "glazing": (with_part("windows", "w-child", width=0.4), "child: windows by floor is 7.4 %; at least 8.0 %"),
    "escape": (with_part("windows", "w-child", sill=1.13), "child: no window of 0.53 m2"),
    "entrance-door": (with_part("doors", "front", width=0.8), "entrance front of hall: clear width is 0.800 m"),
    "door-width": (with_part("doors", "to-store", width=0.55), "door to-store of store: clear width is 0.550 m"),
    "door-height": (with_part("doors", "to-store", height=1.9), "door to-store of store: height is 1.900 m"),
    "stairs-there": (with_a_third_storey, "no stairs lead from storey upper to the next"),
    "stairs-place": (
        with_part("doors", "from-stairs", width=0.55),
        "before the last step there is neither a door of stairwell nor its floor",
    ),
    "riser": (with_part("stairs", "s", risers=14), "riser is 0.207 m; at most 0.196 m"),
    "going": (with_part("stairs", "s", going=0.25), "going is 0.250 m; at least 0.254 m"),
    "stair-width": (with_part("stairs", "s", width=0.9), "width is 0.900 m; at least 0.910 m"),
    "stair-run": (with_part("stairs", "s", going=0.28), "what its footprint lacks is 0.110 m; at most 0.000 m"),
    "headroom": (low(2.6, 2.0), "headroom is 2.000 m; at least 2.030 m"),
    "wet-groups": (FAR_LAUNDRIES, "groups is 4; at most 2"),
    "corridors": (retyped(store="corridor", closet="corridor", child="corridor"), "share of the floor is 31.8 %"),
}

ACCESSIBLE: dict[str, tuple[Change, str]] = {
    "accessible-door": (lambda data: None, "clear width is 0.800 m; at least 0.850 m"),
    "accessible-corridor": (narrow_hall(4.1), "hall: clear way between its doors is 1.100 m; at least 1.200 m"),
    "turning": (narrow_bath(1.3, offset=1.2), "bath: square to turn in is 1.300 m; at least 1.500 m"),
    "accessible-bath": (resized("shower", 1.0, 3.1, 2.9, 5.3), "no toilet on the entrance's storey has 5 m2"),
}


def test_the_house_keeps_all_rules():
    report = check_plan(home_with())
    assert report.valid and not report.violations
    assert report.areas["kitchen"] == pytest.approx(2.6 * 2.7)
    assert report.measures["circulation_share"] == pytest.approx(15.6 / 98.88)


@pytest.mark.parametrize("rule", BROKEN)
def test_each_rule_can_be_broken(rule: str):
    change, line = BROKEN[rule]
    report = check_plan(home_with(change))
    found = [violation for violation in report.violations if violation.rule == rule]
    assert found and not report.valid
    assert any(line in violation.detail for violation in found), [violation.detail for violation in found]
    assert all(violation.amount > 0 and "\n" not in violation.detail for violation in found)


@pytest.mark.parametrize("rule", ACCESSIBLE)
def test_each_rule_for_wheelchairs_can_be_broken(rule: str):
    change, line = ACCESSIBLE[rule]
    found = [v for v in check_plan(home_with(change), profile="accessible").violations if v.rule == rule]
    assert any(line in violation.detail for violation in found), [violation.detail for violation in found]


def test_every_hard_rule_has_its_case():
    assert set(BROKEN) == {row.id for row in Profile.named("base").rows if row.hard}
    added_rows = {row.id for row in Profile.named("accessible").rows} - {row.id for row in Profile.named("base").rows}
    assert set(ACCESSIBLE) == added_rows


SOFT: dict[str, tuple[Change, str]] = {
    "corridors-short": (lambda data: None, "share of the floor is 15.8 %; at most 14.0 %"),
    "kitchen-dining": (lambda data: None, "kitchen to living: distance is 2.200 m; at most 0.400 m"),
    "kitchen-wide": (resized("kitchen", 0.3, 1.3, 2.9, 3.0), "kitchen: clear width is 1.700 m; at least 1.800 m"),
    "bath-wide": (narrow_bath(1.5, offset=1.4), "bath: clear width is 1.400 m; at least 1.500 m"),
    "toilet-wide": (
        both(retyped(bath="guest_toilet"), narrow_bath(2.2, offset=1.95, width=0.6)),
        "bath: clear width is 0.700 m; at least 0.760 m",
    ),
    "kitchen-light": (without("windows", "w-kitchen"), "kitchen: windows by floor is 0.0 %; at least 8.0 %"),
    "kitchen-entrance": (
        both(
            retyped(hall="corridor"),
            added("rooms", id="far", type="vestibule", storey="ground", outline=outline((12, 0.3, 14, 3))),
        ),
        "kitchen to far: distance is 9.100 m; at most 2.000 m",
    ),
    "no-dead-ends": (resized("landing", 3.0, -3.0, 5.0, 4.2), "landing: way beyond the last door is 1.800 m"),
    "bedrooms-apart": (retyped(landing="living_room"), "bedroom: it opens to landing"),
    "bath-bedrooms": (retyped(bath="closet"), "bedroom to shower: distance is 5.200 m; at most 1.500 m"),
    "toilet-not-at-kitchen": (retyped(hall="kitchen_diner"), "shower: it opens to hall"),
    "living-light": (with_part("windows", "w-living", width=0.6), "living: windows by floor is"),
    "living-sun": (
        both(without("windows", "w-living"), with_part("windows", "w-living-south", wall=2)),
        "living: glass that does not face north is 0.0 %; at least 50.0 %",
    ),
    "two-sides": (without("windows", "w-living-south"), "living: sides with windows is 1; at least 2"),
    "aspect-good": (lambda data: None, "living: length by width is 1.889; at most 1.6"),
    "kitchen-shape": (resized("kitchen", -3.5, 0.3, 2.9, 1.9), "kitchen: length by width is 4; at most 1.8"),
    "bath-shape": (resized("bath", -1.5, 3.1, 2.9, 5.3), "bath: length by width is 2; at most 1.7"),
    "toilet-shape": (
        both(retyped(bath="guest_toilet"), resized("bath", -2.82, 3.1, 2.9, 5.3)),
        "bath: length by width is 2.6; at most 2.2",
    ),
    "service-shape": (resized("store", 0.3, 5.4, 2.9, 6.4), "store: length by width is 2.6; at most 2"),
    "hall-shape": (resized("landing", 3.0, -3.0, 5.0, 4.2), "landing: length by width is 3.6; at most 3.2"),
    "hall-plain": (
        both(
            with_part("rooms", "landing", outline=[[3, 0.3], [3.4, 0.3], [3.4, 1.8], [5, 1.8], [5, 4.2], [3, 4.2]]),
            with_part("doors", "from-stairs", wall=4),
        ),
        "landing: share of the rectangle around it is 69.2 %; at least 70.0 %",
    ),
    "hall-modest": (lambda data: None, "hall: floor beyond that of child is 0.78 m2; at most 0.00 m2"),
    "room-whole": (
        both(
            with_part(
                "rooms", "bedroom", outline=[[5.1, 0.3], [8.7, 0.3], [8.7, 4.5], [7.6, 4.5], [7.6, 7.1], [5.1, 7.1]]
            ),
            with_part("doors", "to-bedroom", wall=5),
        ),
        "bedroom: share of the rectangle around it is 88.3 %; at least 90.0 %",
    ),
    "living-largest": (
        resized("living", 5.1, 0.3, 8.6, 7.1),
        "bedroom: floor beyond that of living is 0.68 m2; at most 0.00 m2",
    ),
    "master-largest": (
        retyped(bedroom="bedroom", child="master_bedroom"),
        "bedroom: floor beyond that of child is 17.46 m2; at most 0.00 m2",
    ),
    "kitchen-door": (lambda data: None, "kitchen: it opens to none of eating, living"),
    "living-first": (
        retyped(kitchen="guest_room"),
        "kitchen: its lead over living on the way in is 1.000 m; at most 0.000 m",
    ),
    "wet-together": (retyped(living="living_kitchen"), "groups is 2; at most 1"),
}


@pytest.mark.parametrize("rule", SOFT)
def test_each_soft_rule_costs(rule: str):
    change, line = SOFT[rule]
    report = check_plan(home_with(change))
    found = [violation.detail for violation in report.soft if violation.rule == rule]
    assert any(line in detail for detail in found), found
    assert report.cost > 0 and rule not in {violation.rule for violation in report.violations}


def test_every_soft_rule_has_its_case():
    assert set(SOFT) == {row.id for row in Profile.named("base").rows if not row.hard}
