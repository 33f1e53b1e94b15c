"""Furniture that can be added by words, with its usual sizes, and the kinds of rooms that are known."""

from __future__ import annotations

from typing import Any

from sceneweaver.assets import resolve
from sceneweaver.assets.category import Category, categories
from sceneweaver.assets.taxonomy import members
from sceneweaver.knowledge import match_room, room_types

SEVERAL = (",", ";")


def listing(words: str | None) -> dict[str, Any]:
    """Rows of furniture and the names of rooms.

    Args:
        words: things ("desk, small lamp"), a group of them ("seating") or a kind of room ("study"); None: everything.

    Returns:
        ``furniture`` (rows), ``rooms`` (names) and ``notes`` (what was not known by that name).
    """
    rooms = sorted(room_types())
    known = categories()
    if words is None:
        rows = [_row(c) for name, c in sorted(known.items()) if c.size is not None and not name.startswith("generic")]
        return {"furniture": rows, "rooms": rooms, "notes": []}
    rows, notes = [], []
    for each in words.replace(SEVERAL[1], SEVERAL[0]).split(SEVERAL[0]):
        if not (asked := " ".join(each.split())):
            continue
        found, note = _named(asked)
        rows += [row for row in found if row not in rows]
        notes += [note] if note else []
    return {"furniture": rows, "rooms": rooms, "notes": notes}


def _named(words: str) -> tuple[list[dict[str, Any]], str]:
    """Rows of what words name, and what is to be said about it."""
    known = categories()
    name = words.lower().replace(" ", "_")
    if name in known and known[name].size is None:
        return [_row(known[member]) for member in members(name)], ""
    room = match_room(words)
    if room is not None and room[1] == 1.0 and name not in known:
        found = {resolve(name).body for item in room_types()[room[0]].items for name in item.what}
        rows = [_row(known[each]) for each in sorted(found) if each in known and known[each].size is not None]
        return rows, f"{words}: a kind of room; this is its furniture"
    match = resolve(words)
    body = known.get(match.body)
    if body is None or body.size is None:
        return [], match.note or f"{words}: nothing of this name"
    return [_row(body) | {"category": match.category}], match.note


def _row(category: Category) -> dict[str, Any]:
    assert category.size is not None
    return {
        "category": category.name,
        "words": category.words,
        "synonyms": list(category.synonyms),
        "mount": list(category.mount),
        "stands_on": list(category.on),
        "size": [[float(low), float(high)] for low, high in category.size.ranges],
    }
