"""Calls of tools that would mend what a request asks for and a scene has not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sceneweaver.assets.taxonomy import likeliness
from sceneweaver.geometry.angles import bearing
from sceneweaver.knowledge.surfaces import lays, usual_arrangement
from sceneweaver.language import Entity, Grounded, StatedRelation
from sceneweaver.scene import CATALOGUE
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Call, moved
from .places import segments
from .survey import Survey


def adding(survey: Survey, asked: Entity, missing: int) -> Call:
    """Add so many of what was asked for, where the request wants them."""
    row: dict[str, Any] = {"category": asked.category, "count": missing}
    row.update({k: v for k in ("color", "material", "style") if (v := getattr(asked, k)) is not None})
    table = None if survey.brief.only else _table_for(survey, asked.category, missing)
    if table is not None:  # a table is laid with more than was asked for
        return "add_tabletop", {"objects": [row], "supports": [table]}
    if any(size is not None for size in asked.size):
        row["size"] = list(asked.size)
    places, carriers = _places(survey, asked)
    row.update({"place": places} if places else {})
    row.update({"on": carriers} if carriers else {})
    return "add_objects", {"objects": [row]}


def _table_for(survey: Survey, category: str, count: int) -> str | None:
    """A bare table whose arrangement has a place for so many of a category, the likeliest: a desk for a screen."""
    found: list[tuple[int, str]] = []
    for body in survey.bodies:
        rank = likeliness(category, body.item.category)
        name = survey.program.item_of.get(body.id)
        item = survey.room_type.item(name) if name else None
        plan = usual_arrangement(item.top if item is not None else None, body.item.category, survey.room_type.name)
        if rank is not None and not survey.carried.get(body.id) and lays(plan, category, count):
            found.append((rank, body.id))
    return min(found)[1] if found else None


def _places(survey: Survey, asked: Entity) -> tuple[list[dict[str, Any]], list[str]]:
    """The relations that the request wants of a thing, as ``add_objects`` takes them, and what is to carry it."""
    places: list[dict[str, Any]] = []
    carriers: list[str] = []
    for said, meant in survey.meanings:
        spec = CATALOGUE.get(meant.type)
        if said.subject != asked.id or spec is None or meant.type == "around":
            continue
        names = meant.target if isinstance(meant.target, tuple) else (meant.target,)
        ids = [b.id for name in names if name is not None for b in survey.standing_for(name)]
        if spec.target_kind.startswith("object") and not ids:
            continue
        if meant.type in ("on_top", "inside"):
            carriers += ids
        elif spec.target_kind == "objects":
            places += [{"type": meant.type, "to": ids[:2]}] if len(ids) > 1 else []
        else:
            row: dict[str, Any] = {"type": meant.type, **meant.params}
            if ids:
                row["to"] = ids[0]
            elif isinstance(meant.target, str):
                row["to"] = meant.target
            places.append(row)
    return places, list(dict.fromkeys(carriers))


def relating(survey: Survey, said: StatedRelation, item: str, wrong: Sequence[Body]) -> Call:
    """State a relation that the engine can make true; where it is stated and not so, lay the things out anew."""
    ids = [b.id for b in wrong]
    if said.type == "facing":
        return _turning(survey, said, wrong)
    rows = []
    for row in survey.grounded.get(item, ()):
        if row.type in CATALOGUE and {row.subject, row.target} & set(ids):
            found, target = _target(survey, row)
            if found:
                stated = {"type": row.type, "subject": row.subject, "target": target, "hard": row.hard}
                rows.append({**stated, "params": dict(row.params)} if row.params else stated)
    if rows and not all(_stated(survey, row) for row in rows):
        return "add_relation", {"relations": rows}
    return moved(*ids)


def _turning(survey: Survey, said: StatedRelation, wrong: Sequence[Body]) -> Call:
    """Turn things to what they should face."""
    target = next((b for b in survey.standing_for(said.targets[0]) if b not in wrong), None)
    if target is not None and target.item.category in kinds.TVS:  # it has to look back
        pairs = [(a.id, b.id) for one in wrong for a, b in ((one, target), (target, one))]
        rows = [{"type": "facing", "subject": a, "target": b, "hard": True} for a, b in pairs]
        return "add_relation", {"relations": rows}
    if target is not None:
        return "update_rotation", {"ids": [b.id for b in wrong], "toward": target.id}
    parts = segments(survey, said.targets[0])
    if not parts:
        return moved(*(b.id for b in wrong))
    nearest = min(parts, key=lambda s: math.dist(s.middle, wrong[0].centre))
    return "update_rotation", {"ids": [wrong[0].id], "yaw": round(bearing(wrong[0].centre, nearest.middle), 4)}


def _target(survey: Survey, row: Grounded) -> tuple[bool, str | list[str] | None]:
    """Whether the room has what a grounded relation is to, and its id: of walls, windows and doors the nearest one."""
    kind, target = CATALOGUE[row.type].target_kind, row.target
    if kind in ("none", "object"):
        return True, target if isinstance(target, str) else None
    if kind == "objects":
        return isinstance(target, tuple), list(target) if isinstance(target, tuple) else None
    if target is None:
        return True, None
    parts = segments(survey, target if isinstance(target, str) and target.startswith("wall") else kind)
    if not parts:
        return False, None
    here = survey.placed.by_id[row.subject].centre
    return True, min(parts, key=lambda s: math.dist(s.middle, here)).id


def _stated(survey: Survey, row: dict[str, Any]) -> bool:
    target = row["target"]
    wanted = (row["type"], row["subject"], tuple(target) if isinstance(target, list) else target)
    return any(
        (r.type, r.subject, r.target) == wanted
        and (r.hard or not row["hard"])
        and dict(r.params) == row.get("params", {})
        for r in survey.scene.relations
    )
