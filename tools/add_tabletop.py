"""Small things on desks, tables, counters and beds, each with its place relative to the others."""

from __future__ import annotations

import random
import zlib
from collections.abc import Mapping, Sequence
from typing import Any

from sceneweaver.assets import resolve
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.generate.program import decided_kinds
from sceneweaver.generate.surface_bodies import Shelf
from sceneweaver.generate.surface_choice import arrangement_without, is_bare, is_dressed, plan_of
from sceneweaver.generate.surface_scene import Surroundings
from sceneweaver.generate.surface_slots import Asked, dressed
from sceneweaver.generate.tabletop_said import Said, is_said, lost, said_rows, with_said
from sceneweaver.knowledge.surfaces import Arrangement, arrangement, lays
from sceneweaver.scene import InputError, SceneObject
from sceneweaver.scene.edits import Add, AnyEdit, Relate

from .base import Context, Proposal
from .card import own_card

MOST: int = own_card("add_tabletop").inputs["properties"]["objects"]["items"]["properties"]["count"]["maximum"]
"""Most things of one kind that one call is asked for, as the card says."""


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
            chosen = [o for o in chosen if is_bare(around, o) and is_dressed(around, o, plan)]
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
        decided = decided_kinds(context.brief, context.room_type) - {a.category for a in asked}
        plans = [arrangement_without(plan or plan_of(around, support), decided) for support in chosen]
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


def _listed(objects: Sequence[SceneObject]) -> str:
    counts: dict[str, int] = {}
    for o in objects:
        counts[o.category] = counts.get(o.category, 0) + 1
    return ", ".join(f"{n} {_words(c)}" for c, n in counts.items())


def _words(category: str) -> str:
    return category.replace("_", " ")
