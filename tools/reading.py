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
    from sceneweaver.brief import read_brief  # pyright: ignore[reportAttributeAccessIssue]

    brief = read_brief(instruction)
    targets = {t for r in brief.relations for t in _names(r.target)}
    subjects = {r.subject for r in brief.relations}
    category = {a.id: a.category for a in brief.objects}
    there = {a.id for a in brief.objects if a.id in targets and a.id not in subjects and draft.named(a.category)}
    rows: list[dict[str, Any]] = []
    notes = [f"not understood: {word}" for word in brief.unread]
    for asked in brief.objects:
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
        for r in brief.relations:
            if r.subject != asked.id:
                continue
            names = _names(r.target)
            if "middle" in names:
                notes.append(f"{r.words or 'in the middle'}: {asked.noun} goes where there is room")
                continue
            words = [n if n in HERE or n.startswith("wall:") else category.get(n, n) for n in names]
            place: dict[str, Any] = {"type": r.type, **({"params": dict(r.params)} if r.params else {})}
            if words and words != ["corner"]:
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
