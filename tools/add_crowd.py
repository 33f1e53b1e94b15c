"""Shelves, racks and counters filled with things of a theme, tidy rows at the front edge of every board."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.generate.program import decided_kinds
from sceneweaver.generate.surface_bodies import Shelf
from sceneweaver.generate.surface_choice import is_filled, leaves_top, theme_of, theme_on_top, theme_without
from sceneweaver.generate.surface_rows import filled
from sceneweaver.generate.surface_scene import Surroundings
from sceneweaver.io.messages import show
from sceneweaver.knowledge.surfaces import Crowd, Unit, crowd, crowds
from sceneweaver.scene import InputError
from sceneweaver.scene.edits import Add, AnyEdit

from .base import Context, Proposal

DENSITY = {"sparse": 0.25, "normal": 0.6, "full": 0.9}
"""How full shelves are when only the request speaks of it."""


class AddCrowd:
    """Fills shelves by theme."""

    name = "add_crowd"

    def propose(self, context: Context) -> Proposal:
        """Adds of things on the boards that are empty; their poses are free of collisions already."""
        inputs = context.inputs
        around = Surroundings(context.scene, context.room_type)
        chosen = around.supports(inputs.get("supports") or [])
        named = inputs.get("theme")
        theme = crowd(str(named), around.room) if named else None
        if inputs.get("categories"):
            theme = _of_kinds(inputs["categories"], theme)
        density = _density(inputs.get("density"), context)
        every = not inputs.get("supports")
        if every:
            chosen = [o for o in chosen if is_filled(around, o, theme)]
        shelf = Shelf(context.library, context.scene.palette, context.seed, context.brief.style)
        decided = decided_kinds(context.brief, context.room_type)
        edits: list[AnyEdit] = []
        notes: list[str] = []
        unmet: list[str] = []
        for support in chosen:
            dice = random.Random(f"{context.seed}/{support.id}/crowd")
            plan = theme or theme_of(around, support)
            if not inputs.get("categories"):
                plan = theme_without(plan, decided)
            boards = [s for s in support.surfaces if (support.id, s.name) not in around.carried]
            if every and leaves_top(around, support):
                boards = [s for s in boards if s.headroom is not None]
            count = 0
            for board in boards:
                top = theme_on_top(around, support, board, plan)
                here = plan if top is None else theme_without(top, decided)
                found = filled(around, shelf, support, board, here, dice, density, context.clutter)
                edits += [Add(object=obj) for obj in found]
                count += len(found)
            if count:
                notes.append(f"{support.id}: {count} things, {plan.name.replace('_', ' ')}")
            elif not every:
                why = f"nothing of theme {plan.name} fits its boards" if boards else "all its boards carry things"
                unmet.append(f"{support.id}: {why}")
        if every and not edits:
            unmet.append("there is no shelf with empty boards")
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def _of_kinds(given: Any, theme: Crowd | None) -> Crowd:
    """A theme of such things alone, each as it stands in the theme that is named, else in any that has it.

    Raises:
        InputError: for what is no list of categories of small things.
    """
    if isinstance(given, str) or not isinstance(given, Sequence) or not all(isinstance(c, str) for c in given):
        raise InputError('categories: give a list of nouns, such as ["book", "vase"]')
    units: list[Unit] = []
    for noun in given:
        category = resolve(noun, "surface").category
        if category not in categories() or "surface" not in categories()[category].mount:
            raise InputError(f"categories: {show(noun)} is nothing that stands on shelves; name small things")
        plans = [*([theme] if theme is not None else []), *crowds().values()]
        known = next((unit for plan in plans for unit in plan.units if category in unit.what), None)
        plain = Unit(what=(category,), most=4, loose=4)
        units.append(known.model_copy(update={"what": (category,), "level": None}) if known is not None else plain)
    base = theme or Crowd(name="named", description="What a call names", units=tuple(units))
    return base.model_copy(update={"units": tuple(units), "top": None})


def _density(given: Any, context: Context) -> float:
    if given is None:
        return DENSITY[context.brief.density]
    if isinstance(given, bool) or not isinstance(given, int | float) or not 0 <= given <= 1:
        raise InputError(f"density: {show(given)} is no number from 0 to 1")
    return float(given)
