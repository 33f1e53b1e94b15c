"""Whether a room is finished: things on tables and in shelves, walls, light, cloth and plants, no bare floor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.small_things import left_about
from sceneweaver.verify.solids import Body

from . import kinds
from .grade import Finding, finding
from .needs import placing
from .space import floor_of
from .survey import Survey

BARE = 0.5
"""Share of the floor that furniture should use."""

REACHED = 1.75
"""Height [m] above which a surface may stay empty."""


def faults(survey: Survey) -> Iterator[Finding]:
    """What is missing for the room to feel done."""
    yield from _supports(survey)
    yield from _floor(survey)
    yield from _numbers(survey)
    yield from _touches(survey)


def measures(survey: Survey) -> dict[str, float]:
    """Share of supports that carry something, and numbers of things against what such rooms have."""
    bases = supports(survey)
    return {
        "supports": float(len(bases)),
        "populated_share": populated(survey),
        "expected_objects": expected(survey),
        "small_objects": float(sum(b.item.mount == "surface" for b in survey.bodies)),
    }


# ---- tables and shelves ----------------------------------------------------------------------------------------------


def supports(survey: Survey) -> list[Body]:
    """Furniture that should carry something."""
    return [
        b
        for b in survey.bodies
        if b.item.surfaces
        and kinds.carries(b.item.category)
        and b.item.mount != "surface"
        and not left_about(b.item.category, survey.room_type.name)
        and any(_low(b, s.z) for s in b.item.surfaces)
    ]


def _low(body: Body, z: float) -> bool:
    return body.position[2] + z < REACHED


def filled(survey: Survey, body: Body) -> float:
    """Share of a body's surfaces, up to `REACHED`, on which something stands."""
    names = {s.name for s in body.item.surfaces if _low(body, s.z)}
    used = {b.item.support.surface for b in survey.carried.get(body.id, ()) if b.item.support is not None}
    if not names or (used and "table_group" in kinds.groups_of(body.item.category)):
        return 1.0
    return len(names & used) / len(names)


def populated(survey: Survey) -> float:
    """Mean over the supports of how far they are filled; half of a shelf's boards are enough."""
    bases = supports(survey)
    return sum(min(1.0, 2.0 * filled(survey, b)) for b in bases) / len(bases) if bases else 1.0


def _supports(survey: Survey) -> Iterator[Finding]:
    bases = supports(survey)
    if not bases or survey.brief.only:
        return
    level = {b.id: filled(survey, b) for b in bases}
    empty = [b for b in bases if level[b.id] == 0.0]
    poor = [b for b in bases if 0.0 < level[b.id] < 0.5]
    share = populated(survey)
    grave = share < 0.5 and len(bases) >= 2
    groups: dict[tuple[str, str | None], list[Body]] = {}
    for body in empty:
        groups.setdefault(_call(survey, body), []).append(body)
    for (tool, name), bodies in groups.items():
        ids = [b.id for b in bodies]
        inputs: dict[str, Any] = {"supports": ids}
        if name is not None:
            inputs["arrangement" if tool == "add_tabletop" else "theme"] = name
        yield finding(
            "completion",
            "empty_support",
            ids,
            f"nothing stands on {', '.join(ids[:4])}{' and others' if len(ids) > 4 else ''}: "
            f"{share:.0%} of the tables and shelves are in use",
            f"put things on {', '.join(ids[:4])}",
            points=0.4 + 3.0 * len(ids) / len(bases),
            grave=grave,
            call=(tool, inputs),
        )
    if poor:
        ids = [b.id for b in poor]
        yield finding(
            "completion",
            "sparse_support",
            ids,
            f"{level[ids[0]]:.0%} of the boards of {ids[0]} carry something",
            f"fill {', '.join(ids[:4])}",
            points=0.2 + 1.2 * len(ids) / len(bases),
            call=("add_crowd", {"supports": ids}),
        )


def _call(survey: Survey, body: Body) -> tuple[str, str | None]:
    """The tool that fills a support, and the arrangement or theme that the room's item names."""
    name = survey.program.item_of.get(body.id)
    item = survey.room_type.item(name) if name else None
    if item is not None and item.top is not None:
        return "add_tabletop", item.top
    if item is not None and item.fill is not None:
        return "add_crowd", item.fill
    return ("add_crowd" if len(body.item.surfaces) > 1 else "add_tabletop"), None


# ---- floor and numbers -----------------------------------------------------------------------------------------------


def _floor(survey: Survey) -> Iterator[Finding]:
    floor = floor_of(survey)
    used = floor.share(floor.used)
    bare = 0.35 if survey.brief.density == "sparse" or survey.brief.only else BARE
    if used < bare:
        yield finding(
            "completion",
            "bare",
            (),
            f"{1 - used:.0%} of the floor is more than 0.6 m from any furniture",
            "add furniture to the empty part of the room",
            points=1.0 + 6.0 * (bare - used),
            grave=True,
            call=("add_objects", {"objects": _more(survey)}),
        )
    elif used < bare + 0.15:
        yield finding(
            "completion",
            "bare",
            (),
            f"{1 - used:.0%} of the floor is more than 0.6 m from any furniture",
            "add furniture to the empty part of the room",
            points=6.0 * (bare + 0.15 - used),
            call=("add_objects", {"objects": _more(survey)}),
        )


def _more(survey: Survey) -> list[dict[str, Any]]:
    """Furniture of the room type that is not on the floor yet, optional things last; a plant when all of it is."""
    have = set(survey.program.item_of.values())
    rank = {"needed": 0, "usual": 1, "optional": 2}
    absent = [i for i in survey.room_type.items if i.id not in have and i.with_ is None and not i.on and _stands(i)]
    absent.sort(key=lambda i: rank[i.need])
    if not absent:
        return [{"category": "potted_plant", "count": 1, "place": [{"type": "in_corner"}]}]
    return [{"category": i.what[0], "count": 1, "place": placing(survey, i)} for i in absent[:2]]


def _stands(item: Item) -> bool:
    from sceneweaver.assets import categories

    row = categories().get(item.what[0])
    return (item.mount or (row.mount[0] if row else "floor")) == "floor"


def expected(survey: Survey) -> float:
    """How many objects such a room has: its items, and two small things on every support."""
    items = 0.0
    for item in survey.room_type.items:
        count = item.count.of(survey.area, survey.program.people, 0.3)
        if item.with_ is not None:
            count *= sum(name == item.with_ for name in survey.program.item_of.values())
        items += count * {"needed": 1.0, "usual": 0.9, "optional": 0.2}[item.need]
    share = {"sparse": 0.55, "normal": 1.0, "full": 1.2}[survey.brief.density]
    return share * (items + 2.0 * len(supports(survey)))


def _numbers(survey: Survey) -> Iterator[Finding]:
    if survey.brief.only:
        return
    want, have = expected(survey), len(survey.bodies)
    if want and have < 0.8 * want:
        yield finding(
            "completion",
            "few_objects",
            (),
            f"{have} objects; such a room has about {want:.0f}",
            "add furniture and small things",
            points=3.5 * (0.8 - have / want) + 0.2,
            call=("add_objects", {"objects": _more(survey)}),
        )


# ---- the last touches ------------------------------------------------------------------------------------------------


def _touches(survey: Survey) -> Iterator[Finding]:
    """Walls, light, cloth and plants, where the missing items of the room do not say it already."""
    if survey.brief.only or survey.brief.density == "sparse":
        return
    said = {c for n in survey.program.needs if n.missing for c in n.item.what}
    bodies = survey.bodies
    lit = any("lighting" in kinds.groups_of(b.item.category) for b in bodies)
    hung = any(
        b.item.mount == "wall"
        and b.item.category not in kinds.WINDOW_WEAR
        and not kinds.groups_of(b.item.category) & {"lighting", "appliance"}
        for b in bodies
    )
    soft = any(kinds.groups_of(b.item.category) & {"textile", "plant_group"} for b in bodies)
    rows = (
        (lit, "lighting", "no_light", "there is no lamp", "ceiling_light", 0.8),
        (hung, "", "bare_walls", "nothing hangs on the walls", "picture", 0.7),
        (soft, "textile plant_group", "no_softness", "there is neither a plant nor a textile", "potted_plant", 0.5),
    )
    for there, groups, kind, reason, category, points in rows:
        wanted = set(groups.split())
        if there or any(kinds.groups_of(c) & wanted or (not wanted and c in kinds.WALL_ART) for c in said):
            continue
        listed = _listed(survey.room_type, wanted)
        if listed is None and kind == "no_softness":
            continue  # nobody misses it in a workshop
        name = listed or category
        yield finding(
            "completion",
            kind,
            (),
            reason,
            f"add {kinds.a(name)}",
            points=points if listed else points / 2,
            call=("add_objects", {"objects": [{"category": name, "count": 1}]}),
        )


def _listed(room_type: RoomType, groups: set[str]) -> str | None:
    """The first category of some groups that a room lists; of none, of what hangs on walls."""
    for item in room_type.items:
        for name in item.what:
            if kinds.groups_of(name) & groups or (not groups and name in kinds.EYE_LEVEL):
                return name
    return None
