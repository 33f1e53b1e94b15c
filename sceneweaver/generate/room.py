"""The first draft of a room: outline, doors and windows, objects with bodies, relations; none of them placed."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sceneweaver.assets.roles import has_role
from sceneweaver.knowledge.palettes import Palette as RoomPalette
from sceneweaver.knowledge.palettes import in_colors, palette_for, unnamed
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import CATALOGUE, Intent, Palette, Pose, Relation, Room, Scene, SceneObject
from sceneweaver.scene.palette import MOST_COLORS

from .arrange import fits, hung
from .draft import walls_of
from .finish import finished
from .fit import POOR, fitted
from .free_floor import agreeing, free_areas_of, kept_free, people_of
from .hanging import hung_between, lamp_count
from .look import look_of
from .program import BY_RANK, Limits, Program, Wanted, build, demands, free_zones
from .relations import of_brief, of_items, rows_of, stated_rows
from .rooms import larger_rooms, may_hold, other_rooms, same_walls, walls_hold
from .rows import in_rows, lines_of, row_variants
from .run import Variant, has_place
from .seats import lengthened
from .setup import Proposal, Setup
from .shell import floor_area, shell_of
from .squared import squared
from .stacks import stacked
from .stated_lengths import with_stated_lengths
from .stated_states import pulled_out, with_stated_looks, with_stated_states
from .supports import Places, laid, supported
from .under import below_windows, with_room_below, without_company
from .unwanted_looks import avoided, of_room, styles_unwanted
from .ways import ways_of

FILL = {"sparse": 0.73, "normal": 1.0, "full": 1.21}
"""Share of what a kind of room usually has under furniture up to which more is put in."""

WALLED = 0.62
"""Share of the walls, less doors, that furniture may take."""

WAY = 0.9
"""Way [m] between a grid and what stands at the walls."""

SHELLS = 4
"""Shells that are drawn before the floor grows, where the walls of one are too short for what stands at them."""

DRAWN, ROOMS = 12, 5
"""Other rooms that are drawn, and of those that may hold everything how many are laid out beside the first."""

PLACING = CATALOGUE.with_role("placing") | {
    "distance",
    "near_door",
    "near_window",
    "at_window",
    "in_corner",
    "in_middle",
}
"""Types of relations that, asked for, take a thing out of the row that it usually stands in."""

LED = CATALOGUE.with_role("placing") | {"at_window", "near_door"}
"""Types of relations that of a line only the first piece has."""

LEAN, LEAST = 0.62, 0.55
"""Share of what a kind of room usually has under furniture below which a floor that nobody fixed shrinks to what it
holds, and the least share of the floor that is left."""

LEVEL, MIDDLED = 0.2, 0.25
"""Height [m] between things that hang one over another, and how far off the middle, in widths of what they are over."""

GROWTH, GROWTHS = 1.12, 10
"""Factor by which a floor that nobody fixed grows when what is needed does not fit, and how often."""


LARGEST = 1.5
"""Times the largest floor of a kind of room up to which one that nobody fixed grows."""


@dataclass
class _Floor:
    """The floor [m2] of an attempt: whether the request fixes it, whether it may shrink to what it holds, and down to
    how much; and the factor on the share of it that is put under furniture."""

    area: float
    people: int
    given: bool
    shrinks: bool
    least: float
    fill: float = 1.0


@dataclass
class _Attempt:
    """A shell with what stands in it."""

    space: Room
    program: Program
    rows: list[Grounded]
    corners: list[Variant]
    remarks: list[str]
    places: Places = field(default_factory=Places)
    variants: list[Variant] = field(default_factory=list)


def first_draft(
    setup: Setup, *, style: str = "", roomier: float = 1.0, fill: float = 1.0, hurried: Callable[[], bool] = bool
) -> Proposal:
    """Draw the room that the knowledge base and the request describe: objects at the origin but for what stands on
    others, relations, other rooms for the same things and larger ones. A room that is given stays as it is.

    Args:
        setup: request, kind of room, library and seed; its scene is not read.
        style: where the request names none; empty: one of the room's.
        roomier: factor on a floor that nobody fixed.
        fill: factor on the share of the floor that is put under furniture.
        hurried: whether what could be drawn once more is left as it is.
    """
    room, brief, seed = setup.room_type, setup.brief, setup.seed
    area, people, given, notes = floor_area(room, brief, seed, setup.room)
    most = LARGEST * room.area[2]
    shrinks = not given and brief.scale == 1.0
    least = max(LEAST * area, 0.8 * room.area[0])
    if people_of(brief) is not None and room.area_per_person:
        least = max(least, room.area_per_person * people)
    floor = _Floor(area if given else min(area * roomier, most), people, given, shrinks, least, fill)
    styles = [one for one in room.styles if one not in styles_unwanted(brief)] or room.styles
    style = brief.style or style or random.Random(seed ^ 0x57).choice(styles)
    wanted = look_of(brief)
    style = (wanted and wanted.style) or style
    unwanted = avoided(brief)
    look = palette_for(room.name, style, brief.colors, seed, wanted, of_room(unwanted))
    woods = [said.color for said in brief.finishes if said.part == "furniture" and said.color]
    if (every := brief.finish_of("everything")) is not None:
        look = in_colors(look, [color for color in (every.color, every.second) if color])
    elif woods:
        look = look.model_copy(update={"woods": tuple(woods[:2])})
    avoid = (*(wanted.avoid if wanted is not None else ()), *unnamed(brief.colors), *unwanted)
    palette = setup.palette or kept(look, style, seed, tuple(dict.fromkeys(avoid)))

    made = _shelled(setup, floor, palette, roomier, hurried)
    smallest: tuple[float, _Attempt] | None = None
    for attempt in range(1, GROWTHS + 1):
        _furnished(setup, made, palette, hurried)
        # Where a grid or a line fits no shell of this size, or all is crowded, only more floor helps.
        crowded = made.program.footprint > FILL["full"] * room.fill * max(
            floor.area - kept_free(brief), 0.5 * floor.area
        )
        crowded = crowded or made.program.wall > WALLED * walls_of(made.space)
        astray = not made.variants and in_rows(_free_of_rows(made.program.wanted, made.rows))
        astray = astray or not fits(brief, made.program.wanted, made.space)
        if not crowded and smallest is None:
            smallest = floor.area, made
        if given or not (crowded or astray) or hurried():
            break
        if attempt == GROWTHS or floor.area >= most:
            if smallest is not None:  # what is astray in any of them does not need a hall
                floor.area, made = smallest
            break
        floor.area *= GROWTH
        made = _shelled(setup, floor, palette, roomier, hurried)

    space = finished(made.space, room, look, seed, brief)
    scene, unmet = _scene(setup, space, made, palette, people)
    rooms, larger = ([], []) if hurried() else _alternatives(setup, floor, made, space, scene)
    notes += made.remarks + made.program.notes
    if given and made.program.left_out:
        standing = {one.category for one in scene.objects}
        reasons = sorted({one.reason for one in made.program.left_out})
        notes += [_left_out(reason, standing) for reason in reasons[:8]]
    return Proposal(
        scene=scene,
        variants=tuple(tuple(agreeing(variant, scene.free_areas)) for variant in made.variants),
        rooms=tuple(finished(r, room, look, seed, brief) for r in rooms[:ROOMS]),
        larger=tuple(finished(r, room, look, seed, brief) for r in larger),
        fresh=True,
        notes=tuple(notes),
        unmet=(*unmet, *made.places.unmet, *_missing(brief, made.program)),
    )


def _left_out(reason: str, standing: Collection[str]) -> str:
    """What is said of something that the floor had no place for; ``reason`` begins with its category."""
    category, _, why = reason.partition(": ")
    name = f"another {category}" if category in standing else category
    return f"{name} was left out of the floor asked for: {why or 'it is full'}"


def _shelled(setup: Setup, floor: _Floor, palette: Palette, roomier: float, hurried: Callable[[], bool]) -> _Attempt:
    """The first shell of a floor whose walls and corners may hold what stands at them; the last one if none does."""
    room, brief, drawn = setup.room_type, setup.brief, 0
    while True:
        space, remarks = shell_of(setup, floor.area, drawn)
        program = _program(setup, space, floor, palette)
        # Nobody asked for this size: a floor that would stay empty shrinks, once, to what it holds.
        needed = roomier * program.footprint / (LEAN * room.fill) + kept_free(brief)
        if floor.shrinks and needed < floor.area:
            floor.area, floor.shrinks = max(needed, min(floor.least, floor.area)), False
            continue
        rows = rows_of(brief, program.wanted)
        corners, cost = fitted(program, _free_of_rows(program.wanted, rows), space, setup.library, brief)
        suits = cost < POOR and walls_hold(space, program.wanted) and may_hold(space, program.wanted, rows)
        if suits or drawn == SHELLS or setup.room is not None or hurried():
            return _Attempt(space, program, rows, corners, remarks)
        drawn += 1


def _furnished(setup: Setup, made: _Attempt, palette: Palette, hurried: Callable[[], bool]) -> None:
    """Decide what stands on what, how long tables are and how rows may go; changes the program of an attempt."""
    program, brief = made.program, setup.brief
    supported(program, brief)
    stacked(program.wanted, brief)
    hung(brief, program.wanted)
    program.wanted = _not_before_windows(program.wanted, rows_of(brief, program.wanted))
    below_windows(brief, program.wanted, made.space)
    stated = stated_rows(brief, program.wanted)
    with_room_below(stated, program.wanted, setup.library)
    program.wanted = without_company(program.wanted, stated)
    rows = rows_of(brief, program.wanted)
    if lengthened(program, rows, setup.library, brief):
        rows = rows_of(brief, program.wanted)  # more seats may be told of a longer table
    made.rows = rows
    # Small things are laid out now, in the frame of what carries them: the search moves both as one.
    made.places = laid(program, rows, setup.library, brief, palette, setup.seed, hurried)
    loose = _free_of_rows(program.wanted, rows)
    made.variants = row_variants(loose, made.space, _strip(program.wanted), made.corners)


def _alternatives(
    setup: Setup, floor: _Floor, made: _Attempt, space: Room, scene: Scene
) -> tuple[list[Room], list[Room]]:
    """Other rooms for the same things, and larger ones, as far as the request leaves them to us."""
    room, brief, wanted = setup.room_type, setup.brief, made.program.wanted
    others, larger = list[Room](), list[Room]()
    if setup.room is not None:
        return others, larger
    if not made.variants:
        fixed = floor.given or brief.shape == "round"
        others = other_rooms(room, brief, space, floor.area, setup.seed, fixed, DRAWN)
    if not floor.given:
        larger = larger_rooms(room, brief, space, floor.area, setup.seed)
    said = [*scene.relations, *(r for variant in made.variants for r in variant)]
    others, larger = (
        [r for r in found if may_hold(r, wanted, made.rows) and same_walls(r, space, said)]
        for found in (others, larger)
    )
    return others, larger


def kept(look: RoomPalette, style: str, seed: int, avoid: Sequence[str] = ()) -> Palette:
    """A palette in a style as a scene keeps it."""
    return Palette(
        name=look.name,
        style=style,
        woods=look.woods,
        paints=look.paints,
        metals=look.metals,
        textiles=look.textiles[:MOST_COLORS],
        avoid=tuple(avoid),
        seed=seed,
    )


def _free_of_rows(wanted: Sequence[Wanted], rows: Sequence[Grounded]) -> list[Wanted]:
    """What may stand in a run, a line or a grid: what the request gives no other place."""
    placed = {(row.subject, row.type) for row in rows if row.hard and row.type in PLACING}
    set_out = {id for row in rows if row.type == "arranged" for id in (row.subject, row.target)}
    return [
        one
        for one in wanted
        if one.id not in set_out and not any(i == one.id and not has_place(one, type) for i, type in placed)
    ]


def _not_before_windows(wanted: list[Wanted], rows: Sequence[Grounded]) -> list[Wanted]:
    """What was wanted, without what nobody asked for that hangs over a thing which was asked for at a window."""
    at_window = {row.subject for row in rows if row.type == "at_window" and row.hard}
    before = {one.item.id for one in wanted if one.item is not None and one.id in at_window}

    def hidden(one: Wanted) -> bool:
        places = one.item.place if one.item is not None and one.asked is None and one.mount == "wall" else ()
        return any(place.type == "above" and place.to in before for place in places)

    return [one for one in wanted if not hidden(one)]


def _at_walls(wanted: Sequence[Wanted], rows: Sequence[Grounded]) -> list[Relation]:
    """Pieces of a run that stand elsewhere do so at a wall, too, where the request does not keep them off it."""
    off = {row.subject for row in rows if row.type in ("in_middle", "over", "behind", "around")}
    free = {one.id for one in _free_of_rows(wanted, rows)}
    return [
        Relation(type="against_wall", subject=one.id)
        for one in wanted
        if one.item is not None and one.item.row == "run" and one.mount == "floor" and one.id not in free | off
    ]


def _scene(setup: Setup, space: Room, made: _Attempt, palette: Palette, people: int) -> tuple[Scene, list[str]]:
    """The scene of an attempt in a room, and what of the request cannot be said in it."""
    room, brief = setup.room_type, setup.brief
    program, places, rows = made.program, made.places, made.rows
    asked, placed, unmet = of_brief(brief, program.wanted, space, places.failed)
    for line in lines_of(_free_of_rows(program.wanted, rows)):
        for one in line[1:]:  # its place is in the line; the first of it says where the line is
            placed[one.id] = placed.get(one.id, frozenset()) | LED
    relations = _consistent(asked, [*of_items(program.wanted, space, placed), *_at_walls(program.wanted, rows)])
    made_of: dict[str, list[str]] = {}
    for one in program.wanted:
        made_of.setdefault(one.asked or "", []).append(one.id)
    areas = (*free_areas_of(brief, made_of, space), *(ways_of(space) if setup.room is not None else ()))
    relations = agreeing(relations, areas)
    relations = pulled_out(relations, program.wanted, brief)
    relations = _widened(relations, levels := _levels(program.wanted, relations))
    tall = {w.id: w.asset.size[2] for w in program.wanted}
    over = {r.subject: tall[r.target] for r in relations if r.type == "above" and r.target in tall}
    before = {r.subject for r in relations if r.type == "at_window"}
    lintels = _over_doors(brief, program.wanted, space)
    over, before = over | lintels, before | set(lintels)
    objects = tuple(
        _raised(_object(w, space, over.get(w.id, 0.0), w.id not in before, places), levels.get(w.id, 0), space)
        for w in program.wanted
    )
    scene = Scene(
        id=room.name,
        prompt=brief.text,
        room=space,
        objects=squared(objects, space) if setup.room is not None else objects,
        relations=tuple(relations),
        free_areas=areas,
        palette=palette,
        provenance={
            "tool": "init_prior",
            "room": room.name,
            "seed": setup.seed,
            "style": palette.style,
            "people": people,
        },
    )
    return scene, unmet


def _program(setup: Setup, space: Room, floor: _Floor, palette: Palette) -> Program:
    room, brief, area, people = setup.room_type, setup.brief, floor.area, floor.people
    wishes = [
        replace(wish, count=lamp_count(wish.item, space.outline, wish.count)) if wish.asked is None else wish
        for wish in demands(room, brief, area, people, len(space.windows), setup.seed)
    ]
    first = space.windows[0] if space.windows else None
    pane = (first.width, first.height, first.sill + first.height) if first is not None else None
    fill = floor.fill * FILL[brief.density] * room.fill
    walls = walls_of(space)
    limits = Limits(max(area - kept_free(brief), 0.5 * area), fill, walls, WALLED * walls)
    program = build(wishes, room, setup.library, limits, setup.seed, palette, pane, space.height)
    with_stated_lengths(program.wanted, brief, space.height, setup.library)
    with_stated_looks(program.wanted, brief, setup.library)
    with_stated_states(program.wanted, brief, space.windows, setup.library)
    return program


def _object(one: Wanted, space: Room, over: float, clear: bool, places: Places) -> SceneObject:
    """The scene object; ``over`` is the height [m] of what it hangs above, ``clear`` keeps it off windows and doors."""
    heights = one.hung or (_hang(one, space, over) if one.mount == "wall" else None)
    pose = Pose(position=(0.0, 0.0, sum(heights) / 2)) if heights is not None else Pose()
    intent = Intent(
        priority=BY_RANK[one.rank],
        request=one.asked,
        program_item=one.item.id if one.item is not None else None,
        mounting_height=heights,
        keep_clear=one.mount == "wall" and clear,
    )
    obj = places.objects.get(one.id) or one.asset.object(one.id, pose=pose, mount=one.mount)  # type: ignore[arg-type]
    zones = free_zones(one.item, obj)
    top = places.tops.get(one.id)
    added = top is not None and top.name not in {s.name for s in obj.surfaces}
    surfaces = (*obj.surfaces, top) if top is not None and added else obj.surfaces
    surfaces = (*surfaces, *places.hooks.get(one.id, ()))
    return obj.model_copy(update={"intent": intent, "surfaces": surfaces, "zones": zones})


def _over_doors(brief: SceneGraph, wanted: Sequence[Wanted], space: Room) -> dict[str, float]:
    """By id the height [m] of the doors over which things on walls are said to hang."""
    named = {said.subject for said in brief.relations if said.type == "above" and said.targets[:1] == ("door",)}
    top = max((door.height for door in space.doors), default=0.0)
    return {one.id: top for one in wanted if one.asked in named and one.mount == "wall" and top}


def _levels(wanted: Sequence[Wanted], relations: Sequence[Relation]) -> dict[str, int]:
    """By id the level, from 0, of things that were asked for over one thing which is too narrow for them side by side:
    shelves on the wall over a counter."""
    width = {one.id: one.asset.size[1] for one in wanted}
    hung = {one.id for one in wanted if one.mount == "wall"}
    over: dict[str, list[str]] = {}
    for r in relations:
        if r.type == "above" and r.asked and r.hard and r.subject in hung and isinstance(r.target, str):
            over.setdefault(r.target, []).append(r.subject)
    narrow = {t: ids for t, ids in over.items() if sum(width[i] for i in ids) > width.get(t, math.inf)}
    return {name: k for ids in narrow.values() if len(ids) > 1 for k, name in enumerate(ids)}


def _widened(relations: Sequence[Relation], levels: Mapping[str, int]) -> list[Relation]:
    """Relations of things that hang one over another, each over the middle of what they are over."""
    return [
        r.model_copy(update={"params": {**r.params, "lateral": max(MIDDLED, float(r.params.get("lateral") or 0.0))}})
        if r.type == "above" and r.subject in levels
        else r
        for r in relations
    ]


def _raised(obj: SceneObject, level: int, space: Room) -> SceneObject:
    """A thing on a wall so many levels above where it usually hangs, as far as the ceiling allows it."""
    heights = obj.intent.mounting_height
    if not level or heights is None:
        return obj
    up = level * (obj.size[2] + LEVEL)
    top = space.height - obj.size[2] - 0.02
    low, high = (min(height + up, top) for height in heights)
    x, y, _ = obj.pose.position
    pose = obj.pose.model_copy(update={"position": (x, y, (low + high) / 2)})
    return obj.model_copy(
        update={"pose": pose, "intent": obj.intent.model_copy(update={"mounting_height": (low, high)})}
    )


def _hang(one: Wanted, space: Room, over: float) -> tuple[float, float]:
    """Heights [m] between which the bottom of a thing on a wall is: the item's or the category's, under the ceiling."""
    if has_role(one.category, "blind") and space.windows:
        window = space.windows[one.number % len(space.windows)]
        top = min(window.sill + window.height + 0.04, space.height - 0.02) - one.asset.size[2]
        return round(top - 0.01, 3), round(top + 0.01, 3)
    return hung_between(one.asset, one.item, space.height, over)


def _consistent(asked: list[Relation], usual: list[Relation]) -> list[Relation]:
    """What was asked, then of the room's own relations those that do not say the same of the same objects again, nor
    hang something where another thing was asked for: over the same basin."""
    said = {(r.type, r.subject, r.target) for r in asked}
    over = {r.target for r in asked if r.type == "above" and r.hard}
    astray = {(r.subject, r.target) for r in usual if r.type == "above" and r.target in over}
    return asked + [
        r for r in usual if (r.type, r.subject, r.target) not in said and (r.subject, r.target) not in astray
    ]


def _missing(brief: SceneGraph, program: Program) -> list[str]:
    made: dict[str, int] = {}
    for one in program.wanted:
        if one.asked is not None:
            made[one.asked] = made.get(one.asked, 0) + 1
    out = []
    for asked in brief.entities:
        least = asked.count[0] if asked.count else 1
        if made.get(asked.id, 0) < least:
            reasons = [one.reason for one in program.left_out if one.asked == asked.id]
            out.append(f"{asked.noun}: {made.get(asked.id, 0)} of {least}" + (f" ({reasons[0]})" if reasons else ""))
    return out


def _strip(program: Sequence[Wanted]) -> float:
    """Depth [m] along the walls that other things need, a way included."""
    return max((w.asset.size[0] for w in program if w.wall > 0.0), default=0.0) + WAY
