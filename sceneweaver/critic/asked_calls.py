"""Calls of tools that would mend what a request asks for and a scene has not."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Any

from sceneweaver.assets.taxonomy import likeliness
from sceneweaver.brief import Entity, Meaning, StatedRelation
from sceneweaver.knowledge.surfaces import lays, usual_arrangement
from sceneweaver.scene import CATALOGUE, InputError, Relation
from sceneweaver.verify.solids import Body

from .pair_measures import plan_gap
from .place_measures import walls_named
from .survey import Survey

Call = tuple[str | None, dict[str, Any] | None]
"""A tool and its inputs; None where none can help."""


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
        plan = usual_arrangement(item.top if item is not None else None, body.item.category)
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


def relating(survey: Survey, said: StatedRelation, wrong: Sequence[Body]) -> Call:
    """State a relation that the engine can make true; where it is stated and not so, lay the things out anew."""
    meant = next((meant for other, meant in survey.meanings if other is said), None)
    rows = []
    for body in wrong:
        first = None if meant is None else next(_relations(survey, said, meant, body), None)
        if first is not None:
            target = list(first.target) if isinstance(first.target, tuple) else first.target
            row = {"type": first.type, "subject": body.id, "target": target, "hard": True}
            rows.append({**row, "params": dict(first.params)} if first.params else row)
    if rows and not all(_stated(survey, row) for row in rows):
        return "add_relation", {"relations": rows}
    return "update_layout", {"ids": [b.id for b in wrong]}


def _stated(survey: Survey, row: dict[str, Any]) -> bool:
    target = row["target"]
    wanted = (row["type"], row["subject"], tuple(target) if isinstance(target, list) else target)
    return any(
        (r.type, r.subject, r.target) == wanted and r.hard and dict(r.params) == row.get("params", {})
        for r in survey.scene.relations
    )


def _relations(survey: Survey, said: StatedRelation, meant: Meaning, body: Body) -> Iterator[Relation]:
    """The relations of the catalogue of which one should hold for a subject, those to what is nearest first."""
    spec = CATALOGUE.get(meant.type)
    if spec is None:
        return
    count, params, kind = len(survey.standing_for(said.subject)), dict(meant.params), spec.target_kind
    if meant.type == "around" and "n" not in params:
        params["n"] = count
    targets: list[str | tuple[str, str] | None] = []
    if kind in ("none", "door"):
        targets = [None]
    elif kind == "wall":
        name = meant.target.partition(":")[2] if isinstance(meant.target, str) else ""
        targets = [f"wall:{k}" for k in walls_named(name, survey.scene.room)] if name else [None]
    elif kind == "window":
        targets = [w.id for w in survey.scene.room.windows]
    elif kind == "objects":
        pair = meant.target if isinstance(meant.target, tuple) else (str(meant.target), str(meant.target))
        first, second = (survey.standing_for(name) for name in pair)
        pairs = ((a.id, b.id) for a in first for b in second if len({a.id, b.id, body.id}) == 3)
        targets = [*itertools.islice(pairs, 64)]
    else:
        others = [b for b in survey.standing_for(str(meant.target)) if b is not body]
        targets = [b.id for b in sorted(others, key=lambda b: plan_gap(survey, body, b))]
    for target in targets:
        try:
            if meant.type == "around" and count < 2:
                yield Relation(type="front_against", subject=body.id, target=target)
            else:
                yield Relation(type=meant.type, subject=body.id, target=target, params=params)
        except InputError:
            continue
