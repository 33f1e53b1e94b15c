"""Whether things belong in this kind of room, and whether the mix of them is believable."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from functools import cache

from sceneweaver.assets import categories
from sceneweaver.knowledge import RoomType
from sceneweaver.knowledge.complete import expected_of
from sceneweaver.knowledge.kin import fits_anywhere, may_stand_in, neighbouring, place_of
from sceneweaver.knowledge.small_things import left_about, wall_things
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding
from .survey import Survey

DOMINANT = 0.4
"""Share of the furniture up to which one kind may make up a room."""

FEWEST = 8
"""Pieces of furniture from which shares of kinds are looked at."""


def faults(survey: Survey) -> Iterator[Finding]:
    """Foreign things and one-sided mixes."""
    yield from _foreign(survey)
    yield from _dominant(survey)
    yield from _lifeless(survey)


def measures(survey: Survey) -> dict[str, float]:
    """How many kinds of things there are, and how large the share of the commonest is among the furniture."""
    count = Counter(b.item.category for b in survey.bodies)
    furniture = Counter(b.item.category for b in survey.bodies if b.item.mount != "surface")
    total = sum(furniture.values())
    return {
        "categories": float(len(count)),
        "diversity": len(count) / max(1.0, len(survey.bodies) ** 0.75),
        "largest_share": max(furniture.values(), default=0) / total if total else 0.0,
    }


@cache
def _expected(names: frozenset[str]) -> tuple[frozenset[str], frozenset[str]]:
    """Categories that a room lists with their kin, and the kinds of places that they come from."""
    own = frozenset().union(*(may_stand_in(name) for name in names)) if names else frozenset()
    return own, frozenset(p for p in map(place_of, names) if p is not None)


def expected(room_type: RoomType) -> tuple[frozenset[str], frozenset[str]]:
    """Categories that a room lists with their kin, and the kinds of places that they come from."""
    looked_for = frozenset().union(*(row.what for row in expected_of(room_type.name)))
    return _expected(frozenset(name for item in room_type.items for name in item.what) | looked_for)


def _foreign(survey: Survey) -> Iterator[Finding]:
    own, places = expected(survey.room_type)
    asked = {c for a in survey.brief.entities for c in may_stand_in(a.category)}
    elsewhere = _elsewhere(survey.room_type.name)
    for body in survey.bodies:
        category = body.item.category
        if category in own or category in asked or body.id in survey.program.item_of:
            continue
        if left_about(category, survey.room_type.name) or category in wall_things(survey.room_type.name):
            continue
        if body.item.intent.request in {a.id for a in survey.brief.entities}:
            continue
        strange = _strangeness(body, places, elsewhere)
        if strange is None:
            continue
        points, grave, why = strange
        yield finding(
            "realism",
            "foreign_object",
            (body.id,),
            f"{kinds.a(category)} is {why} {kinds.a(survey.room_type.name)}",
            f"remove {body.id}",
            points=points,
            grave=grave,
            call=("remove_objects", {"ids": [body.id]}),
        )


@cache
def _elsewhere(room: str) -> frozenset[str]:
    """Categories that other kinds of rooms list and this one does not."""
    from sceneweaver.knowledge import room_types

    return frozenset(c for name, r in room_types().items() if name != room for i in r.items for c in i.what)


def _strangeness(body: Body, places: frozenset[str], elsewhere: frozenset[str]) -> tuple[float, bool, str] | None:
    """Points, whether it is grave, and words for what the room does not list; None when it may well be there."""
    category = body.item.category
    place = place_of(category)
    if place is not None and place not in places:
        large = body.item.mount == "floor" or max(body.size) > 0.5
        if any(neighbouring(place, other) for other in places):
            return 0.6, False, "unusual in"
        return (3.0, True, "out of place in") if large else (1.0, False, "out of place in")
    row = categories().get(category)
    if row is None or fits_anywhere(category):
        return None
    if place is not None:
        return None
    if body.item.mount == "surface":
        return None
    if "gym" in places and "sport" in kinds.groups_of(category):
        return None
    if kinds.groups_of(category) & {"sport", "tool_group"}:
        return 1.2, False, "unusual in"
    if category in elsewhere or row.parent == "furniture":
        return 0.7, False, "unusual in"
    return 0.25, False, "not usual in"


def _lifeless(survey: Survey) -> Iterator[Finding]:
    """Furniture without the small things of every day."""
    bases = [b for b in survey.bodies if b.item.surfaces and kinds.carries(b.item.category)]
    if not bases or survey.brief.only:
        return
    small = sum(b.item.mount == "surface" for b in survey.bodies)
    if small >= len(bases):
        return
    ids = [b.id for b in bases if b.id not in survey.carried]
    yield finding(
        "realism",
        "lifeless",
        ids,
        f"{small} small things on {len(bases)} tables and shelves: nobody lives here",
        f"put things of every day on {', '.join(ids[:4])}",
        points=1.2 * (1 - small / len(bases)),
        call=("add_crowd", {"supports": ids}),
    )


def _dominant(survey: Survey) -> Iterator[Finding]:
    furniture = [b for b in survey.bodies if b.item.mount != "surface"]
    if len(furniture) < FEWEST:
        return
    asked = {a.id: a for a in survey.brief.entities if a.count is not None}
    count = Counter(b.item.category for b in furniture)
    for category, number in count.items():
        share = number / len(furniture)
        if share <= DOMINANT:
            continue
        mine = [b for b in furniture if b.item.category == category]
        usual = [b for b in mine if survey.program.item_of.get(b.id) in survey.room_type.made_of]
        meant = [b for b in mine if survey.program.asked_of.get(b.id) in asked]
        if 2 * max(len(usual), len(meant)) >= number:
            continue
        spare = mine[int(DOMINANT * len(furniture)) :]
        ids = [b.id for b in spare]
        yield finding(
            "realism",
            "dominant_category",
            (b.id for b in mine),
            f"{share:.0%} of the {len(furniture)} pieces of furniture are {kinds.words(category)}s",
            "remove some of them, or add other furniture",
            points=1.0 + 3.0 * (share - DOMINANT),
            call=("remove_objects", {"ids": ids}),
        )
