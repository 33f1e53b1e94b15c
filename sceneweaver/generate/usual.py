"""Where a thing goes when nobody says: as the kind of room has it, else as such things usually stand."""

from __future__ import annotations

from sceneweaver.assets.roles import has_role, with_role
from sceneweaver.knowledge import Item, Place, RoomType
from sceneweaver.knowledge.usual_places import usual_places_of
from sceneweaver.scene import CATALOGUE, SceneObject

from .draft import Draft, groups_of
from .meant import matches

SEAT_WIDTH = 0.62
"""Length [m] of table edge that one seat takes."""


def item_for(room_type: RoomType, category: str, draft: Draft, name: str | None = None) -> Item | None:
    """The item of a room that a category stands for: the named one, else one that is not there yet, else any."""
    if name is not None:
        return next((item for item in room_type.items if item.id == name), None)
    fits = [item for item in room_type.items if matches(category, item)]
    there = {o.intent.program_item for o in draft.objects.values()}
    return next((item for item in fits if item.id not in there), fits[0] if fits else None)


def places_for(draft: Draft, item: Item | None, subject: SceneObject) -> list[Place]:
    """Relations for an object of which nothing was said; those whose target is not there are left out."""
    if subject.mount == "surface":
        return []
    places = [place for place in (item.place if item is not None else ()) if _there(draft, place, subject)]
    if places:
        return places
    seat = _at_table(draft, subject)
    if seat is not None:
        return [seat]
    usual = usual_places_of(groups_of(subject.category))
    if subject.mount != "wall" and any(place.type == "above" for place in usual):
        return []
    return [place for place in usual if _there(draft, place, subject)]


def _there(draft: Draft, place: Place, subject: SceneObject) -> bool:
    """Whether what a relation needs is in the room; a wall relation is nothing for what hangs from the ceiling."""
    if place.type in CATALOGUE.with_role("edge") - {"at_window"} and subject.mount != "floor":
        return False
    if place.type == "at_window" or place.to == "window":
        return bool(draft.room.windows)
    if place.type == "away_from_door" or place.to == "door":
        return bool(draft.room.doors)
    if not place.targets or str(place.to).partition(":")[0] == "wall":
        return True
    return any(id != subject.id for word in place.targets for id in draft.named(word))


def _at_table(draft: Draft, subject: SceneObject) -> Place | None:
    """For a chair: the relation to a desk or table that has a side free."""
    if subject.mount != "floor" or not has_role(subject.category, "table_seat"):
        return None
    # A bar stool is too high for a table, and a chair too low for a counter.
    high = subject.category == "bar_stool"
    kinds = with_role("counter") if high else with_role("from_front", "dining_table") - with_role("counter")
    tables = [o for o in draft.objects.values() if o.category in kinds and o.mount == "floor"]
    free = {o.id: _seats(o) - _taken(draft, o.id) for o in tables}
    best = max(tables, key=lambda o: free[o.id], default=None)
    if best is None or free[best.id] <= 0:
        return None
    return Place(type="front_to_front" if has_role(best.category, "from_front") else "front_against", to=best.id)


def _seats(table: SceneObject) -> int:
    """How many can sit at a table."""
    d, w, _ = table.size
    if has_role(table.category, "from_front"):
        return 1
    if has_role(table.category, "counter"):
        return max(1, int(w / SEAT_WIDTH))
    return 2 * max(1, int(w / SEAT_WIDTH)) + (2 if d > 0.7 else 0)


def _taken(draft: Draft, table: str) -> int:
    tied = {r.subject for r in draft.relations if table in r.targets}
    return sum("seating" in groups_of(draft.objects[s].category) for s in tied if s in draft.objects)
