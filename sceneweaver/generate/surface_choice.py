"""Which furniture of a room is laid, and with what: the arrangement on its top, the theme of its boards."""

from __future__ import annotations

from sceneweaver.assets import categories
from sceneweaver.assets.roles import groups_above
from sceneweaver.knowledge.surfaces import (
    Arrangement,
    Crowd,
    Slot,
    Unit,
    arrangement,
    arrangement_of,
    arrangements,
    crowd,
    crowd_of,
    crowds,
    usual_arrangement,
)
from sceneweaver.scene import CATALOGUE, SceneObject, Surface

from .surface_candidates import surfaces_of
from .surface_scene import Surroundings

PLACES = ((0.4, 0.7), (0.5, -0.6), (0.75, 0.1), (0.2, -0.1), (0.6, 0.4))
"""Where things stand that only the category table knows of: depth and side."""

SEATED = CATALOGUE.with_role("seat", "formation")
"""Types of relations whose subject, a seat, is one that people sit on."""

HIGH, REACHED = "boxes", 1.6
"""Theme of tops above the height [m] that people reach every day."""


def plan_of(around: Surroundings, obj: SceneObject) -> Arrangement:
    """The arrangement of a support: its item's, its category's, what the category holds, or the generic one."""
    item = around.item(obj)
    plan = usual_arrangement(item.top if item is not None else None, obj.category, around.room)
    if plan is not None and any(around.may_add(name) for slot in plan.slots for name in slot.what):
        return plan
    held = _held_by(obj)
    if not held:
        return arrangements()["generic"]
    slots = tuple(
        Slot(id=f"thing-{k}", what=(*held[k::5],), at=at, chance=0.85, loose=8, reach=0.2)
        for k, at in enumerate(PLACES)
        if held[k::5]
    )
    return Arrangement(name="holds", description="What the category holds", most=0.4, slots=slots)


def theme_of(around: Surroundings, obj: SceneObject) -> Crowd:
    """The theme of a support: its item's, its category's, what the category holds, or things for storage."""
    item = around.item(obj)
    if item is not None and item.fill:
        return crowd(item.fill, around.room)
    usual = crowd_of(around.room).get(obj.category)
    if usual is not None:
        return crowd(usual, around.room)
    units = tuple(Unit(what=(c,), most=2, loose=4) for c in _held_by(obj))
    if not units:
        return crowds()["storage"]
    return Crowd(name="holds", description="What the category holds", units=units)


def _held_by(obj: SceneObject) -> list[str]:
    """What can be drawn of the things that a category of furniture holds."""
    known = categories().get(obj.category)
    return [c for c in (known.holds if known else ()) if c in categories() and categories()[c].size]


def theme_on_top(around: Surroundings, obj: SceneObject, board: Surface, theme: Crowd) -> Crowd | None:
    """The theme of a board where it is another one than that of the boards below: on the open top of a support."""
    if board.headroom is not None or board.z < max(s.z for s in obj.surfaces) - 1e-6:
        return None
    # Boxes are too deep for a shelf on a wall.
    high = obj.pose.position[2] + board.z > REACHED and obj.mount == "floor"
    top = HIGH if high else theme.top
    return crowd(top, around.room) if top else None


def arrangement_without(plan: Arrangement, named: frozenset[str]) -> Arrangement:
    """An arrangement without kinds of things that the request names: of these there are as many as it asks for."""
    slots = [slot.model_copy(update={"what": tuple(c for c in slot.what if c not in named)}) for slot in plan.slots]
    return plan.model_copy(update={"slots": tuple(slot for slot in slots if slot.what)}) if named else plan


def theme_without(plan: Crowd, named: frozenset[str]) -> Crowd:
    """A theme without kinds of things that the request names."""
    units = [unit.model_copy(update={"what": tuple(c for c in unit.what if c not in named)}) for unit in plan.units]
    return plan.model_copy(update={"units": tuple(unit for unit in units if unit.what)}) if named else plan


def is_bare(around: Surroundings, obj: SceneObject) -> bool:
    """Whether nothing is on the main surface but what the room's file puts there: a till, an espresso machine."""
    main = surfaces_of(obj, False, plan_of(around, obj).top)["main"].name
    carried = [o for o in around.scene.objects if o.support and (o.support.object, o.support.surface) == (obj.id, main)]
    return all(o.intent.program_item is not None for o in carried)


def is_dressed(around: Surroundings, obj: SceneObject, plan: Arrangement | None = None) -> bool:
    """Whether a support is one for an arrangement, or for that one, as its item or its category says."""
    item = around.item(obj)
    if plan is not None:
        return obj.category in plan.by_category or (item is not None and item.top in (plan.name, *plan.instead))
    if item is not None and item.top:
        return True
    name = arrangement_of(around.room).get(obj.category)
    usual = name is not None and (arrangement(name).sat_on or not is_sat_on(around, obj))
    if item is not None and item.fill and (len(obj.surfaces) == 1 or not usual):
        return False
    return obj.mount != "surface" and usual


def is_sat_on(around: Surroundings, obj: SceneObject) -> bool:
    """Whether people sit on a seat, so that it carries nothing that nobody asked for: it was itself asked for, or has
    its place at a table or in a row. The stool beside a bed or a bath is a small table."""
    if "seating" not in groups_above(obj.category):
        return False
    placed = any(r.subject == obj.id and r.type in SEATED for r in around.scene.relations)
    return placed or obj.intent.priority == "asked"


def leaves_top(around: Surroundings, obj: SceneObject) -> bool:
    """Whether the open top of shelves is left to an arrangement."""
    item = around.item(obj)
    if item is not None and (item.top or item.fill):
        return bool(item.top)
    return obj.category in arrangement_of(around.room)


def is_filled(around: Surroundings, obj: SceneObject, theme: Crowd | None) -> bool:
    """Whether a support is one to fill with a theme, or with any."""
    item = around.item(obj)
    if obj.mount == "surface":
        return False
    own = (item is not None and bool(item.fill)) or obj.category in crowd_of(around.room)
    return own or (theme is not None and obj.category in theme.by_category)


def seen_from_behind(support: SceneObject, board: Surface) -> bool:
    """Whether a board is reached from the back: the back half of a shelf with two sides."""
    xs = [p[0] for p in board.polygon]
    sides = categories()[support.category].sides if support.category in categories() else ()
    return "back" in sides and max(xs) <= 0.02 and len(support.surfaces) > 1
