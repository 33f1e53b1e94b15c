"""Where a thing goes when nobody says: as the kind of room has it, else as such things usually stand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.usual_places import UsualPlace, usual_places_of
from sceneweaver.scene import CATALOGUE, SceneObject

from .draft import Draft, groups_of
from .program import matches

SEATS = ("chair_group", "stool", "bar_stool")
"""Groups and categories of what is pulled up to a table."""

LOUNGE = ("rocking_chair", "high_chair")
"""Chairs that are not pulled up to a table as a rule."""

FRONTED = (
    "desk",
    "computer_desk",
    "standing_desk",
    "secretary_desk",
    "corner_desk",
    "dressing_table",
    "teacher_desk",
    "school_desk",
    "workbench",
    "drafting_table",
    "lab_bench",
    "sewing_machine_table",
    "reception_desk",
)
"""Tables with one side to sit at."""

TABLES = (
    "dining_table",
    "round_dining_table",
    "oval_table",
    "conference_table",
    "cafe_table",
    "kids_table",
    "folding_table",
    "patio_table",
    "chess_table",
    "poker_table",
)

HIGH = ("kitchen_island", "bar_table", "bar_counter")
"""What bar stools stand at."""

SEAT_WIDTH = 0.62
"""Length [m] of table edge that one seat takes."""

Row = dict[str, Any]


def item_for(room_type: RoomType, category: str, draft: Draft, name: str | None = None) -> Item | None:
    """The item of a room that a category stands for: the named one, else one that is not there yet, else any."""
    if name is not None:
        return next((item for item in room_type.items if item.id == name), None)
    fits = [item for item in room_type.items if matches(category, item)]
    there = {o.intent.program_item for o in draft.objects.values()}
    return next((item for item in fits if item.id not in there), fits[0] if fits else None)


def rows_for(draft: Draft, item: Item | None, subject: SceneObject) -> list[Row]:
    """Relations for an object of which nothing was said; those whose target is not there are left out."""
    if subject.mount == "surface":
        return []
    rows = [_of_place(p) for p in item.place] if item is not None else []
    rows = [row for row in rows if _there(draft, row, subject)]
    if rows:
        return rows
    seat = _at_table(draft, subject)
    if seat is not None:
        return [seat]
    rows = [_of_usual(u) for u in usual_places_of(groups_of(subject.category))]
    if subject.mount != "wall" and any(row["type"] == "above" for row in rows):
        return []
    return [row for row in rows if _there(draft, row, subject)]


def _of_place(place: Any) -> Row:
    return {
        "type": place.type,
        "to": place.to,
        "soft": place.soft,
        "weight": place.weight,
        "params": dict(place.params),
    }


def _of_usual(usual: UsualPlace) -> Row:
    row = _of_place(usual.place)
    return {**row, "to": usual.among} if usual.among else row


def _there(draft: Draft, row: Mapping[str, Any], subject: SceneObject) -> bool:
    """Whether what a relation needs is in the room; a wall relation is nothing for what hangs from the ceiling."""
    to = row["to"]
    if row["type"] in CATALOGUE.with_role("edge") - {"at_window"} and subject.mount != "floor":
        return False
    if row["type"] == "at_window" or to == "window":
        return bool(draft.room.windows)
    if row["type"] == "away_from_door" or to == "door":
        return bool(draft.room.doors)
    words = [to] if isinstance(to, str) else list(to or ())
    if not words or str(to).partition(":")[0] == "wall":
        return True
    return any(id != subject.id for word in words for id in draft.named(word))


def _at_table(draft: Draft, subject: SceneObject) -> Row | None:
    """For a chair: the relation to a desk or table that has a side free."""
    groups = groups_of(subject.category)
    if subject.mount != "floor" or not groups & set(SEATS) or subject.category in LOUNGE:
        return None
    kinds = HIGH if subject.category == "bar_stool" else (*FRONTED, *TABLES)
    best: tuple[float, str] | None = None
    for o in draft.objects.values():
        if o.category not in kinds or o.mount != "floor":
            continue
        free = _seats(o) - _taken(draft, o.id)
        if free > 0 and (best is None or free > best[0]):
            best = free, o.id
    if best is None:
        return None
    relation = "front_to_front" if draft.objects[best[1]].category in FRONTED else "front_against"
    return {"type": relation, "to": best[1], "soft": False, "weight": 1.0, "params": {}}


def _seats(table: SceneObject) -> int:
    """How many can sit at a table."""
    d, w, _ = table.size
    if table.category in FRONTED:
        return 1
    if table.category in HIGH:
        return max(1, int(w / SEAT_WIDTH))
    return 2 * max(1, int(w / SEAT_WIDTH)) + (2 if d > 0.7 else 0)


def _taken(draft: Draft, table: str) -> int:
    tied = {r.subject for r in draft.relations if table in r.targets}
    return sum("seating" in groups_of(draft.objects[s].category) for s in tied if s in draft.objects)
