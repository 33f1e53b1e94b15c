"""A whole room from the knowledge base and the request: outline, objects with bodies, relations."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.generate.draft import walls_of
from sceneweaver.generate.finish import finished
from sceneweaver.generate.fit import POOR, fitted
from sceneweaver.generate.lights import lamp_count
from sceneweaver.generate.program import BLIND, BY_RANK, Program, Wanted, build, demands, free_zones
from sceneweaver.generate.relations import of_brief, of_items, rows_of
from sceneweaver.generate.rooms import larger_rooms, may_hold, other_rooms, same_walls, walls_hold
from sceneweaver.generate.rows import in_rows, lines_of, row_variants
from sceneweaver.generate.run import has_place
from sceneweaver.generate.shell import floor_area, shell
from sceneweaver.generate.supports import Places, laid, supported
from sceneweaver.generate.tables import lengthened
from sceneweaver.knowledge.palettes import Palette as RoomPalette
from sceneweaver.knowledge.palettes import palette_for
from sceneweaver.language import Grounded, SceneGraph
from sceneweaver.scene import CATALOGUE, Intent, Palette, Pose, Relation, Room, Scene, SceneObject
from sceneweaver.scene.palette import MOST_COLORS

from .base import Context, Proposal

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

LEAN, LEAST = 0.62, 0.75
"""Share of what a kind of room usually has under furniture below which a floor that nobody fixed shrinks to what it
holds, and the least share of the floor that is left."""

GROWTH, GROWTHS = 1.12, 10
"""Factor by which a floor that nobody fixed grows when what is needed does not fit, and how often."""


class InitPrior:
    """Draws the room that the knowledge base and the request describe."""

    name = "init_prior"

    def propose(self, context: Context) -> Proposal:
        """A new scene; ``inputs`` may hold ``style``, and ``roomier``, a factor on a floor that nobody fixed."""
        room, brief, seed = context.room_type, context.brief, context.seed
        area, people, given, notes = floor_area(room, brief, seed)
        roomier = float(context.inputs.get("roomier", 1.0))
        if not given:
            area = min(area * roomier, 1.5 * room.area[2])
        style = brief.style or str(context.inputs.get("style") or "") or random.Random(seed ^ 0x57).choice(room.styles)
        look = palette_for(room.name, style, brief.colors, seed)
        palette = kept(look, style, seed)
        attempt = drawn = 0
        free = not given and brief.people is None and brief.scale == 1.0
        while True:
            space, remarks = shell(room, brief, area, seed, drawn)
            program = _program(context, space, area, people, palette)
            needed = roomier * program.footprint / (LEAN * room.fill)
            if free and needed < area:
                area, free = max(needed, LEAST * area, 0.8 * room.area[0]), False
                continue
            rows = rows_of(brief, program.wanted)
            loose = _free_of_rows(program.wanted, rows)
            corners, cost = fitted(program, loose, space, context.library)
            suits = cost < POOR and walls_hold(space, program.wanted) and may_hold(space, program.wanted, rows)
            if drawn < SHELLS and not suits and not context.hurried():
                drawn += 1
                continue
            supported(program, brief)
            program.wanted = _not_before_windows(program.wanted, rows_of(brief, program.wanted))
            rows = rows_of(brief, program.wanted)
            if lengthened(program, rows, context.library, brief):
                rows = rows_of(brief, program.wanted)
            places = laid(program, rows, context.library, brief, palette, seed)
            loose = _free_of_rows(program.wanted, rows)
            variants = row_variants(loose, space, _strip(program.wanted), corners)
            crowded = program.footprint > FILL["full"] * room.fill * area or program.wall > WALLED * walls_of(space)
            astray = not variants and in_rows(loose)
            attempt += 1
            large = attempt == GROWTHS or area >= 1.5 * room.area[2]
            if given or not (crowded or astray) or large or context.hurried():
                break
            area, drawn = area * GROWTH, 0
        space = finished(space, room, look, seed, brief.text)
        scene, unmet = _scene(context, space, program, places, rows, palette, people)
        fixed = given or brief.shape == "round"
        rooms, larger = [], []
        if not variants and not context.hurried():
            rooms = [
                r
                for r in other_rooms(room, brief, space, area, seed, fixed, DRAWN)
                if may_hold(r, program.wanted, rows) and same_walls(r, space, scene.relations)
            ]
        if not given and not context.hurried():
            said = [*scene.relations, *(r for variant in variants for r in variant)]
            larger = [
                r
                for r in larger_rooms(room, brief, space, area, seed)
                if may_hold(r, program.wanted, rows) and same_walls(r, space, said)
            ]
        notes += remarks + program.notes
        unmet += [*places.unmet, *_missing(brief, program)]
        if given and program.left_out:
            reasons = sorted({one.reason for one in program.left_out})
            notes.append("left out, as the floor asked for is full: " + ", ".join(reasons[:8]))
        return Proposal(
            scene=scene,
            variants=tuple(variants),
            rooms=tuple(finished(r, room, look, seed, brief.text) for r in rooms[:ROOMS]),
            larger=tuple(finished(r, room, look, seed, brief.text) for r in larger),
            fresh=True,
            notes=tuple(notes),
            unmet=tuple(unmet),
        )


def kept(look: RoomPalette, style: str, seed: int) -> Palette:
    """A palette in a style as a scene keeps it."""
    return Palette(
        name=look.name,
        style=style,
        woods=look.woods,
        paints=look.paints,
        metals=look.metals,
        textiles=look.textiles[:MOST_COLORS],
        seed=seed,
    )


def _free_of_rows(wanted: Sequence[Wanted], rows: Sequence[Grounded]) -> list[Wanted]:
    """What may stand in a run, a line or a grid: what the request gives no other place."""
    placed = {(row.subject, row.type) for row in rows if row.hard and row.type in PLACING}
    return [one for one in wanted if not any(i == one.id and not has_place(one, type) for i, type in placed)]


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


def _scene(
    context: Context,
    space: Room,
    program: Program,
    places: Places,
    rows: Sequence[Grounded],
    palette: Palette,
    people: int,
) -> tuple[Scene, list[str]]:
    """The scene of a program in a room, and what of the request cannot be said in it."""
    room, brief = context.room_type, context.brief
    asked, placed, unmet = of_brief(brief, program.wanted, space, places.failed)
    for line in lines_of(_free_of_rows(program.wanted, rows)):
        for one in line[1:]:  # its place is in the line; the first of it says where the line is
            placed[one.id] = placed.get(one.id, frozenset()) | LED
    relations = _consistent(asked, [*of_items(program.wanted, space, placed), *_at_walls(program.wanted, rows)])
    tall = {w.id: w.asset.size[2] for w in program.wanted}
    over = {r.subject: tall[r.target] for r in relations if r.type == "above" and r.target in tall}
    before = {r.subject for r in relations if r.type == "at_window"}
    scene = Scene(
        id=room.name,
        prompt=brief.text,
        room=space,
        objects=tuple(_object(w, space, over.get(w.id, 0.0), w.id not in before, places) for w in program.wanted),
        relations=tuple(relations),
        palette=palette,
        provenance={
            "tool": InitPrior.name,
            "room": room.name,
            "seed": context.seed,
            "style": palette.style,
            "people": people,
        },
    )
    return scene, unmet


def _program(context: Context, space: Room, area: float, people: int, palette: Palette) -> Program:
    room, brief = context.room_type, context.brief
    wishes = [
        replace(wish, count=lamp_count(wish.item, space.outline, wish.count)) if wish.asked is None else wish
        for wish in demands(room, brief, area, people, len(space.windows), context.seed)
    ]
    first = space.windows[0] if space.windows else None
    pane = (first.width, first.height, first.sill + first.height) if first is not None else None
    fill = FILL[brief.density] * room.fill
    walls = walls_of(space)
    return build(
        wishes,
        room,
        context.library,
        area,
        walls,
        WALLED * walls,
        fill,
        context.seed,
        palette,
        pane,
        space.height,
    )


def _object(one: Wanted, space: Room, over: float, clear: bool, places: Places) -> SceneObject:
    """The scene object; ``over`` is the height [m] of what it hangs above, ``clear`` keeps it off windows and doors."""
    heights = _hang(one, space, over) if one.mount == "wall" else None
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
    top = (places.tops[one.id],) if one.id in places.tops and not obj.surfaces else obj.surfaces
    return obj.model_copy(update={"intent": intent, "surfaces": top, "zones": zones})


def _hang(one: Wanted, space: Room, over: float) -> tuple[float, float]:
    """Heights [m] between which the bottom of a thing on a wall is: the item's or the category's, under the ceiling."""
    if one.category == BLIND and space.windows:
        window = space.windows[one.number % len(space.windows)]
        top = min(window.sill + window.height + 0.04, space.height - 0.02) - one.asset.size[2]
        return round(top - 0.01, 3), round(top + 0.01, 3)
    own = one.item.hung(one.asset.size[2]) if one.item else None
    low, high = own or category_named(one.category).bottom or (1.2, 1.5)
    if over:
        low, high = max(low, over + 0.08), max(high, over + (0.12 if own else 0.3))
    most = max(0.0, space.height - one.asset.size[2] - 0.02)
    return round(min(low, max(0.0, most - 0.1)), 3), round(min(high, most), 3)


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
