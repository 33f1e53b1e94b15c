"""Shelves, racks and counters filled with things of a theme, tidy rows at the front edge of every board."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

from sceneweaver.assets import categories, resolve
from sceneweaver.generate.program import decided_kinds
from sceneweaver.generate.surface_bodies import Shelf
from sceneweaver.generate.surface_rows import Row
from sceneweaver.generate.surface_scene import Surroundings
from sceneweaver.generate.surface_setting import Setting
from sceneweaver.knowledge.surfaces import Crowd, Unit, arrangement_of, crowd, crowd_of, crowds
from sceneweaver.scene import InputError, SceneObject, Surface
from sceneweaver.scene.edits import Add, AnyEdit
from sceneweaver.scene.messages import show

from .base import Context, Proposal

DENSITY = {"sparse": 0.25, "normal": 0.6, "full": 0.9}
"""How full shelves are when only the request speaks of it."""


HIGH, REACHED = "boxes", 1.6
"""Theme of tops above the height [m] that people reach every day."""


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
            chosen = [o for o in chosen if o.mount != "surface" and _shelf_like(around, o, theme)]
        shelf = Shelf(context.library, context.scene.palette, context.seed, context.brief.style)
        decided = decided_kinds(context.brief)
        edits: list[AnyEdit] = []
        notes: list[str] = []
        unmet: list[str] = []
        for support in chosen:
            dice = random.Random(f"{context.seed}/{support.id}/crowd")
            plan = theme if inputs.get("categories") and theme else _unnamed(theme or _theme(around, support), decided)
            boards = [s for s in support.surfaces if (support.id, s.name) not in around.carried]
            if every and _dressed(around, support):
                boards = [s for s in boards if s.headroom is not None]
            count = 0
            for board in boards:
                added = _fill(around, shelf, support, board, plan, dice, density, decided, context.clutter)
                edits += added
                count += len(added)
            if count:
                notes.append(f"{support.id}: {count} things, {plan.name.replace('_', ' ')}")
            elif not every:
                why = f"nothing of theme {plan.name} fits its boards" if boards else "all its boards carry things"
                unmet.append(f"{support.id}: {why}")
        if every and not edits:
            unmet.append("there is no shelf with empty boards")
        return Proposal(edits=tuple(edits), notes=tuple(notes), unmet=tuple(unmet))


def _unnamed(plan: Crowd, named: frozenset[str]) -> Crowd:
    """A theme without the kinds of things that the request names: of these there are as many as it asks for."""
    units = [unit.model_copy(update={"what": tuple(c for c in unit.what if c not in named)}) for unit in plan.units]
    return plan.model_copy(update={"units": tuple(unit for unit in units if unit.what)}) if named else plan


def _fill(
    around: Surroundings,
    shelf: Shelf,
    support: SceneObject,
    board: Surface,
    plan: Crowd,
    dice: random.Random,
    density: float,
    named: frozenset[str],
    clutter: float,
) -> list[AnyEdit]:
    frame = around.frame(support, _seen_from_behind(support, board))
    if board.headroom is None and board.z >= max(s.z for s in support.surfaces) - 1e-6:
        # Boxes are too deep for a shelf on a wall.
        high = support.pose.position[2] + board.z > REACHED and support.mount == "floor"
        top = HIGH if high else plan.top
        plan = _unnamed(crowd(top, around.room), named) if top else plan
    setting = Setting(support, frame, shelf, lambda surface: around.field(support, surface, frame))
    Row(setting, board, plan, around, dice, density, clutter).fill()
    return [Add(object=obj) for obj in setting.objects]


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


def _seen_from_behind(support: SceneObject, board: Surface) -> bool:
    """Whether a board is reached from the back: the back half of a shelf with two sides."""
    xs = [p[0] for p in board.polygon]
    sides = categories()[support.category].sides if support.category in categories() else ()
    return "back" in sides and max(xs) <= 0.02 and len(support.surfaces) > 1


def _density(given: Any, context: Context) -> float:
    if given is None:
        return DENSITY[context.brief.density]
    if isinstance(given, bool) or not isinstance(given, int | float) or not 0 <= given <= 1:
        raise InputError(f"density: {show(given)} is no number from 0 to 1")
    return float(given)


def _shelf_like(around: Surroundings, obj: SceneObject, theme: Crowd | None) -> bool:
    item = around.item(obj)
    if item is not None and item.fill:
        return True
    if theme is not None and obj.category in theme.by_category:
        return True
    return obj.category in crowd_of(around.room)


def _dressed(around: Surroundings, obj: SceneObject) -> bool:
    """Whether the open top of a support is left to an arrangement."""
    item = around.item(obj)
    if item is not None and (item.top or item.fill):
        return bool(item.top)
    return obj.category in arrangement_of(around.room)


def _theme(around: Surroundings, obj: SceneObject) -> Crowd:
    """The theme of a support: its item's, its category's, what the category holds, or things for storage."""
    item = around.item(obj)
    if item is not None and item.fill:
        return crowd(item.fill, around.room)
    usual = crowd_of(around.room).get(obj.category)
    if usual is not None:
        return crowd(usual, around.room)
    known = categories().get(obj.category)
    held = [c for c in (known.holds if known else ()) if c in categories() and categories()[c].size]
    if not held:
        return crowds()["storage"]
    units = tuple(Unit(what=(c,), most=2, loose=4) for c in held)
    return Crowd(name="holds", description="What the category holds", units=units)
