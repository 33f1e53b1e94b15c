"""A sentence such as "add two plants and a floor lamp next to the sofa", read as inputs of add_objects."""

from __future__ import annotations

from typing import Any

from .draft import Draft

HERE = ("wall", "window", "door", "corner", "middle")
"""Targets that are part of the room."""


def rows_of(instruction: str, draft: Draft) -> tuple[list[dict[str, Any]], list[str]]:
    """Entries of ``objects`` as add_objects takes them, and what was not understood.

    What a sentence only relates to ("next to the sofa") and what is there already is not added again.
    """
    from sceneweaver.language import meanings, read_request  # pyright: ignore[reportAttributeAccessIssue]

    brief = read_request(instruction)
    targets = {name for r in brief.relations for name in r.targets}
    subjects = {r.subject for r in brief.relations}
    category = {a.id: a.category for a in brief.entities}
    there = {a.id for a in brief.entities if a.id in targets and a.id not in subjects and draft.named(a.category)}
    rows: list[dict[str, Any]] = []
    relations = meanings(brief)
    notes = [f"not understood: {word.words}" for word in brief.unread]
    for asked in brief.entities:
        if asked.id in there:
            continue
        row: dict[str, Any] = {"category": asked.category, "count": asked.count[0] if asked.count else 1}
        row["count"] = max(1, row["count"])
        row.update({k: v for k in ("color", "material", "style") if (v := getattr(asked, k)) is not None})
        if asked.size != (None, None, None):
            row["size"] = list(asked.size)
        if asked.words:
            row["words"] = " ".join(asked.words)
        places = []
        for said, meant in relations:
            if said.subject != asked.id:
                continue
            if "middle" in said.targets:
                notes.append(f"{said.words or 'in the middle'}: {asked.noun} goes where there is room")
                continue
            words = [n if n in HERE or n.startswith("wall:") else category.get(n, n) for n in _names(meant.target)]
            place: dict[str, Any] = {"type": meant.type, **({"params": dict(meant.params)} if meant.params else {})}
            if words:
                place["to"] = words if len(words) > 1 else words[0]
            places.append(place)
        if places:
            row["place"] = places
        rows.append(row)
    # What others stand on or beside comes first, so that it is there when they are placed.
    rows.sort(key=lambda row: any(p["type"] in ("on_top", "inside") for p in row.get("place", ())))
    return rows, notes


def _names(target: str | tuple[str, str] | None) -> list[str]:
    return [] if target is None else [target] if isinstance(target, str) else list(target)
