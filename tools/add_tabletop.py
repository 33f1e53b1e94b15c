"""Small things on desks, tables, counters and beds, each with its place relative to the others."""

from __future__ import annotations

import random
import zlib
from collections.abc import Mapping, Sequence
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.generate.program import decided_kinds
from sceneweaver.generate.surface_bodies import Shelf
from sceneweaver.generate.surface_candidates import surfaces_of
from sceneweaver.generate.surface_scene import Surroundings
from sceneweaver.generate.surface_slots import Asked, dressed
from sceneweaver.generate.tabletop_said import Said, is_said, lost, said_rows, with_said
from sceneweaver.knowledge.surfaces import (
    Arrangement,
    Slot,
    arrangement,
    arrangement_of,
    arrangements,
    lays,
    usual_arrangement,
)
from sceneweaver.scene import InputError, SceneObject
from sceneweaver.scene.edits import Add, AnyEdit, Relate

from .base import Context, Proposal

PLACES = ((0.4, 0.7), (0.5, -0.6), (0.75, 0.1), (0.2, -0.1), (0.6, 0.4))
"""Where things stand that only the category table knows of: depth and side."""

MOST = 40
"""Most things of one kind that one call is asked for."""


class AddTabletop:
    """Lays arrangements out on supports."""

    name = "add_tabletop"

    def propose(self, context: Context) -> Proposal:
        """Adds, and soft relations between what belongs together; poses are free of collisions already."""
        inputs = context.inputs
        around = Surroundings(context.scene, context.room_type)
        said = said_rows([row for row in _rows(inputs.get("objects") or []) if is_said(row)])
        supports = [*(inputs.get("supports") or []), *(one.support for one in said if one.support is not None)]
        chosen = around.supports(supports if said else inputs.get("supports") or [])
        asked = _asked([row for row in _rows(inputs.get("objects") or []) if not is_said(row)])
        named = inputs.get("arrangement")
        plan = arrangement(str(named), around.room) if named else None
        if not supports:
            chosen = [o for o in chosen if _bare(around, o) and _worth(around, o, plan, named is not None)]
        if not chosen:
            why = "there is no table, desk or other support that lacks things"
            lacking = [f"{a.category}: {why}" for a in asked] or ([] if supports else [why])
            return Proposal(unmet=tuple(lacking))
        shelf = Shelf(context.library, context.scene.palette, context.seed, context.brief.style)
        edits: list[AnyEdit] = []
        notes: list[str] = []
        unmet: list[str] = []
        open_asked = asked
        told = _told(said, chosen)
        decided = decided_kinds(context.brief) - {a.category for a in asked}
        plans = [_unnamed(plan or plan_of(around, support), decided) for support in chosen]
        for k, support in enumerate(chosen):
            dice = random.Random(f"{context.seed}/{support.id}/{zlib.crc32(b'tabletop')}")
            here = told[support.id]
            plan_here = with_said(plans[k], here, bool(inputs.get("only"))) if here or inputs.get("only") else plans[k]
            looks = {one.slot.id: dict(one.look) for one in here if one.look}
            share = _share(open_asked, plans[k:])
            done = dressed(around, shelf, support, plan_here, dice, context.clutter, asked=share, looks=looks)
            open_asked = [*done.unplaced, *(a for a in open_asked if not any(a is s for s in share))]
            edits += [Add(object=o) for o in done.objects]
            edits += [Relate(relation=r) for r in done.relations]
            unmet += [f"{support.id}: there is no room for {_words(name)}" for name in done.missing]
            unmet += [f"{support.id}: there is no such place for {_words(name)}" for name in lost(here, done)]
            if not done.objects and not done.missing and supports:
                unmet.append(f"{support.id}: nothing of its arrangement fits on it")
            if done.objects:
                notes.append(f"{support.id}: {_listed(done.objects)}")
        where = ", ".join(o.id for o in chosen[:3])
        unmet += [f"{_words(a.category)}: there is no room on {where}" for a in open_asked]
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def _unnamed(plan: Arrangement, named: frozenset[str]) -> Arrangement:
    """An arrangement without the kinds of things that the request names: of these there are as many as it asks for."""
    slots = [slot.model_copy(update={"what": tuple(c for c in slot.what if c not in named)}) for slot in plan.slots]
    return plan.model_copy(update={"slots": tuple(slot for slot in slots if slot.what)}) if named else plan


def _share(asked: Sequence[Asked], plans: Sequence[Arrangement]) -> list[Asked]:
    """What the first of some tables gets of the things asked for: what has its place there, an even part of what has
    one nowhere."""
    nowhere = [a for a in asked if not any(lays(plan, a.category) for plan in plans)]
    even = nowhere[: -(-len(nowhere) // len(plans))]
    return [a for a in asked if lays(plans[0], a.category) or any(a is e for e in even)]


def _told(said: Sequence[Said], chosen: Sequence[SceneObject]) -> dict[str, list[Said]]:
    """By support the rows that have a place on it; those that name none are on the first."""
    ids = {o.id for o in chosen}
    told: dict[str, list[Said]] = {o.id: [] for o in chosen}
    for one in said:
        told[one.support if one.support in ids and one.support is not None else chosen[0].id].append(one)
    return told


def _rows(given: Any) -> list[Mapping[str, Any]]:
    """The rows of ``objects``; InputError for what is none."""
    if isinstance(given, str | Mapping) or not isinstance(given, Sequence):
        raise InputError('objects: give a list such as [{"category": "mug", "count": 2}]')
    for k, row in enumerate(given):
        if not isinstance(row, Mapping) or not isinstance(row.get("category"), str) or not row["category"].strip():
            raise InputError(f'objects[{k}]: give a category, such as {{"category": "mug", "count": 2}}')
    return list(given)


def _asked(given: Sequence[Mapping[str, Any]]) -> list[Asked]:
    """The things asked for, one entry each; InputError for what cannot be read."""
    out: list[Asked] = []
    for k, row in enumerate(given):
        count = row.get("count", 1)
        if isinstance(count, bool) or not isinstance(count, int) or not 1 <= count <= MOST:
            raise InputError(f"objects[{k}].count: {count!r} is no whole number from 1 to {MOST}")
        category = resolve(row["category"], "surface").category
        if "surface" not in category_named(category, "surface").mount:
            raise InputError(f"objects[{k}].category: a {_words(category)} stands on no table; add it with add_objects")
        look = {key: str(row[key]) for key in ("color", "material", "style", "words") if row.get(key)}
        out += [Asked(category, look) for _ in range(count)]
    return out


def _bare(around: Surroundings, obj: SceneObject) -> bool:
    """Whether nothing is on the main surface but what the room's file puts there: a till, an espresso machine."""
    main = surfaces_of(obj, False, plan_of(around, obj).top)["main"].name
    carried = [o for o in around.scene.objects if o.support and (o.support.object, o.support.surface) == (obj.id, main)]
    return all(o.intent.program_item is not None for o in carried)


def _worth(around: Surroundings, obj: SceneObject, plan: Arrangement | None, named: bool) -> bool:
    """Whether a support is one to dress when none was named: its item or its category says so."""
    if named and plan is not None:
        item = around.item(obj)
        return obj.category in plan.by_category or (item is not None and item.top in (plan.name, *plan.instead))
    item = around.item(obj)
    if item is not None and item.top:
        return True
    if item is not None and item.fill and (len(obj.surfaces) == 1 or obj.category not in arrangement_of(around.room)):
        return False
    return obj.mount != "surface" and obj.category in arrangement_of(around.room)


def plan_of(around: Surroundings, obj: SceneObject) -> Arrangement:
    """The arrangement of a support: its item's, its category's, what the category holds, or the generic one."""
    item = around.item(obj)
    plan = usual_arrangement(item.top if item is not None else None, obj.category, around.room)
    if plan is not None and any(around.may_add(name) for slot in plan.slots for name in slot.what):
        return plan
    known = categories().get(obj.category)
    held = [c for c in (known.holds if known else ()) if c in categories() and categories()[c].size]
    if not held:
        return arrangements()["generic"]
    slots = tuple(
        Slot(id=f"thing-{k}", what=(*held[k::5],), at=at, chance=0.85, loose=8, reach=0.2)
        for k, at in enumerate(PLACES)
        if held[k::5]
    )
    return Arrangement(name="holds", description="What the category holds", most=0.4, slots=slots)


def _listed(objects: Sequence[SceneObject]) -> str:
    counts: dict[str, int] = {}
    for o in objects:
        counts[o.category] = counts.get(o.category, 0) + 1
    return ", ".join(f"{n} {_words(c)}" for c, n in counts.items())


def _words(category: str) -> str:
    return category.replace("_", " ")
