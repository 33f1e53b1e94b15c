"""A whole room from the knowledge base and the request: outline, objects with bodies, relations."""

from __future__ import annotations

import random
from collections.abc import Sequence

from sceneweaver.assets.taxonomy import category_named, likeliness
from sceneweaver.brief import SceneGraph, carrier_of
from sceneweaver.knowledge.surfaces import lays, usual_arrangement
from sceneweaver.scene import InputError, Intent, Pose, Relation, Room, Scene, SceneObject, Support

from .base import Context, Proposal
from .draft import walls_of
from .prior_program import BLIND, BY_RANK, LeftOut, Program, Wanted, build, demands
from .prior_relations import of_brief, of_items, thing_of
from .prior_rows import in_rows, row_variants
from .prior_shell import floor_area, shell

FILL = {"sparse": 0.24, "normal": 0.33, "full": 0.40}
"""Share of the floor under furniture up to which more is put in."""

WALLED = 0.62
"""Share of the walls, less doors, that furniture may take."""

FULL = 0.5
"""Share of a support's surfaces from which on what was asked for stands elsewhere."""

NOWHERE = 99

WAY = 0.9
"""Way [m] between a grid and what stands at the walls."""

GROWTH, GROWTHS = 1.12, 10
"""Factor by which a floor that nobody fixed grows when what is needed does not fit, and how often."""


class InitPrior:
    """Draws the room that the knowledge base and the request describe."""

    name = "init_prior"

    def propose(self, context: Context) -> Proposal:
        """A new scene; ``inputs`` may hold ``style``, and ``roomier``, a factor on a floor that nobody fixed."""
        room, brief, seed = context.room_type, context.brief, context.seed
        area, people, given, notes = floor_area(room, brief, seed)
        if not given:
            area = min(area * float(context.inputs.get("roomier", 1.0)), 1.5 * room.area[2])
        style = brief.style or str(context.inputs.get("style") or "") or random.Random(seed ^ 0x57).choice(room.styles)
        attempt = 0
        while True:
            space, remarks = shell(room, brief, area, seed)
            program = _program(context, space, area, people, style)
            _support_small_things(program, brief)
            scene, unmet = _scene(context, space, program, style, people)
            variants = row_variants(program.wanted, space, _strip(program.wanted))
            crowded = program.footprint > FILL["full"] * area or program.wall > WALLED * walls_of(space)
            astray = not variants and in_rows(program.wanted)
            attempt += 1
            large = attempt == GROWTHS or area >= 1.5 * room.area[2]
            if given or not (crowded or astray) or large or context.hurried():
                break
            area *= GROWTH
        notes += remarks + program.notes
        unmet += _missing(brief, program)
        if given and program.left_out:
            reasons = sorted({one.reason for one in program.left_out})
            notes.append("left out, as the floor asked for is full: " + ", ".join(reasons[:8]))
        return Proposal(scene=scene, variants=tuple(variants), fresh=True, notes=tuple(notes), unmet=tuple(unmet))


def _scene(context: Context, space: Room, program: Program, style: str, people: int) -> tuple[Scene, list[str]]:
    """The scene of a program, and what of the request cannot be said in it."""
    room, brief = context.room_type, context.brief
    asked, placed, unmet = of_brief(brief, program.wanted, space)
    relations = _consistent(asked, of_items(program.wanted, space, placed))
    tall = {w.id: w.asset.size[2] for w in program.wanted}
    over = {r.subject: tall[r.target] for r in relations if r.type == "above" and r.target in tall}
    before = {r.subject for r in relations if r.type == "at_window"}
    scene = Scene(
        id=room.name,
        prompt=brief.text,
        room=space,
        objects=tuple(_object(w, space, over.get(w.id, 0.0), w.id not in before) for w in program.wanted),
        relations=tuple(relations),
        provenance={
            "tool": InitPrior.name,
            "room": room.name,
            "seed": context.seed,
            "style": style,
            "people": people,
            "finish": {"floor": room.floor, "walls": room.walls},
        },
    )
    return scene, unmet


def _program(context: Context, space: Room, area: float, people: int, style: str) -> Program:
    room, brief = context.room_type, context.brief
    wishes = demands(room, brief, area, people, len(space.windows), context.seed)
    pane = (space.windows[0].width, space.windows[0].height) if space.windows else None
    fill = FILL[brief.density]
    walls = walls_of(space)
    return build(wishes, room, brief, context.library, area, walls, WALLED * walls, fill, context.seed, style, pane)


def _support_small_things(program: Program, brief: SceneGraph) -> None:
    """Give what was asked to stand on something its support, and small things without one the likeliest."""
    by_asked: dict[str, list[Wanted]] = {}
    for one in program.wanted:
        if one.asked is not None:
            by_asked.setdefault(one.asked, []).append(one)
    things = {name: [thing_of(one) for one in several] for name, several in by_asked.items()}
    for said in brief.relations:
        if said.type not in ("on", "inside"):
            continue
        for k, one in enumerate(by_asked.get(said.subject, [])):
            carrier = carrier_of(said, things, k)
            target = next((w for w in program.wanted if carrier is not None and w.id == carrier.id), None)
            if target is not None and target is not one and target.asset.surfaces and one.support is None:
                one.support = target
    load: dict[str, float] = {}  # share of the surfaces of a support that is taken
    for one in program.wanted:
        if one.mount != "surface" or one.support is not None:
            continue
        fits = [w for w in program.wanted if w is not one and w.support is None and _surface(w, one) is not None]
        if fits:
            best = min(fits, key=lambda w: _unlikely(one, w, load.get(w.id, 0.0)))
            if not brief.only and _laid_later(program, one, best):
                program.later.append(one)
                continue
            one.support = best
            taken = one.asset.size[0] * one.asset.size[1] / max(_ground(one.support), 1e-6)
            load[one.support.id] = load.get(one.support.id, 0.0) + taken
    program.wanted = [w for w in program.wanted if w not in program.later]
    lost = [w for w in program.wanted if w.mount == "surface" and w.support is None]
    program.wanted = [w for w in program.wanted if w not in lost]
    program.left_out += [LeftOut(w.asked, f"{w.category}: nothing in the room can carry it") for w in lost]


def _laid_later(program: Program, one: Wanted, support: Wanted) -> bool:
    """Whether a thing is left to what its table is laid with, where it has a place of its own: a screen on a desk."""
    if likeliness(one.category, support.category) is None or one.asked is None:
        return False
    plan = usual_arrangement(support.item.top if support.item else None, support.category)
    return lays(plan, one.category, sum(w.asked == one.asked for w in program.wanted))


def _unlikely(one: Wanted, support: Wanted, load: float) -> tuple[bool, int, float]:
    """What speaks against a support: that it is full, that such things stand elsewhere, that others stand there."""
    rank = likeliness(one.category, support.category)
    return load > FULL, NOWHERE if rank is None else rank, load


def _ground(support: Wanted) -> float:
    """Area [m2] of a support's surfaces."""
    import shapely

    return float(sum(shapely.Polygon(surface.polygon).area for surface in support.asset.surfaces))


def _surface(support: Wanted, one: Wanted) -> str | None:
    """The surface of a support that a thing fits on, the highest of the roomiest; None when there is none."""
    import shapely

    d, w, h = one.asset.size
    best: tuple[float, str] | None = None
    for surface in support.asset.surfaces:
        if surface.headroom is not None and surface.headroom < h + 0.005:
            continue
        shape = shapely.Polygon(surface.polygon)
        x0, y0, x1, y1 = shape.bounds
        if min(x1 - x0, y1 - y0) < min(d, w) or max(x1 - x0, y1 - y0) < max(d, w):
            continue
        score = shape.area + 0.2 * surface.z
        if best is None or score > best[0]:
            best = score, surface.name
    return best[1] if best else None


def _object(one: Wanted, space: Room, over: float, clear: bool) -> SceneObject:
    """The scene object; ``over`` is the height [m] of what it hangs above, ``clear`` keeps it off windows and doors."""
    support = None
    if one.support is not None:
        surface = _surface(one.support, one) or (
            one.support.asset.surfaces[0].name if one.support.asset.surfaces else None
        )
        if surface is None:
            raise InputError(f"{one.id}: {one.support.id} has no surface that carries it")
        support = Support(object=one.support.id, surface=surface)
    heights = _hang(one, space, over) if one.mount == "wall" else None
    pose = Pose(position=(0.0, 0.0, sum(heights) / 2)) if heights is not None else Pose()
    intent = Intent(
        priority=BY_RANK[one.rank],
        request=one.asked,
        program_item=one.item.id if one.item is not None else None,
        mounting_height=heights,
        keep_clear=one.mount == "wall" and clear,
    )
    obj = one.asset.object(one.id, pose=pose, mount=None if support else one.mount, support=support)  # type: ignore[arg-type]
    return obj.model_copy(update={"intent": intent})


def _hang(one: Wanted, space: Room, over: float) -> tuple[float, float]:
    """Heights [m] between which the bottom of a thing on a wall is: the item's or the category's, under the ceiling."""
    if one.category == BLIND and space.windows:
        window = space.windows[one.number % len(space.windows)]
        top = min(window.sill + window.height + 0.04, space.height - 0.02) - one.asset.size[2]
        return round(top - 0.01, 3), round(top + 0.01, 3)
    low, high = (one.item and one.item.bottom) or category_named(one.category).bottom or (1.2, 1.5)
    if over:
        low, high = max(low, over + 0.08), max(high, over + 0.3)
    most = max(0.0, space.height - one.asset.size[2] - 0.02)
    return round(min(low, max(0.0, most - 0.1)), 3), round(min(high, most), 3)


def _consistent(asked: list[Relation], usual: list[Relation]) -> list[Relation]:
    """What was asked, then of the room's own relations those that do not say the same of the same objects again."""
    said = {(r.type, r.subject, r.target) for r in asked}
    return asked + [r for r in usual if (r.type, r.subject, r.target) not in said]


def _missing(brief: SceneGraph, program: Program) -> list[str]:
    made: dict[str, int] = {}
    for one in (*program.wanted, *program.later):
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
