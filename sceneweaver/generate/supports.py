"""What stands on what: the support of each small thing of a room, and its place there as the request says it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sceneweaver.assets import Asset, Library, categories
from sceneweaver.assets.carrying import body_within, carrier, vessel_body
from sceneweaver.assets.category import REACH
from sceneweaver.assets.roles import has_role
from sceneweaver.assets.taxonomy import category_named, likeliness
from sceneweaver.knowledge.model import Range
from sceneweaver.knowledge.surfaces import usual_arrangement
from sceneweaver.language import Grounded, SceneGraph, StatedRelation, carrier_of
from sceneweaver.scene import InputError, Palette, SceneObject, Surface

from .cavities import INSIDE, hollow, upright
from .draft import groups_of
from .hooks import hang_on
from .program import LeftOut, Program, Wanted
from .quantity import lies_on_floor, spread_of
from .surface_bodies import Shelf
from .surface_scene import Frame
from .surface_setting import Standing
from .surface_spots import fits_on
from .surface_stated import EXACT, Rider, StatedLayer, holds

_TOP = re.compile(r"\b(?:top|atop)\b")

FULL = 0.5
"""Share of a support's surfaces from which on what was asked for stands elsewhere."""

NOWHERE = 99
"""Rank of a support on which such things never stand."""

TALLEST = 1.2
"""Height [m] from which on a small thing that nothing carries does not stand on the floor instead."""

GROWN = (0.5, 1.0, 2.0)
"""Shares of the way to the largest of its kind by which a support grows when what is to stand on it has no room; from 1
to 2 it goes on to the largest that words may ask for."""

OPEN = "open"
"""The shape of a box or bin that things are put into, without its lid."""

SHRUNK = (0.0, -1.0)
"""Where in the range of its kind what has no room is drawn anew: the least usual, then the least that there is."""

MANY_LOST = 10
"""Things without room from which on a support goes to its largest at once, and they to their smallest."""

OVERHANG = 0.01
"""How far [m] a flat thing may lie over the edge of another like it."""

PILED = 0.4
"""Height, in lengths of its shorter side, up to which a thing has others of its kind on it that have no room beside it.
"""

EYES = 1.45
"""Height [m] of a surface from which on it is the last to be taken for what is said to be on nothing."""

FREE = 0.3
"""Share of a top that must be free of what rises from it, for a thing to stand there."""

SHALLOW = 0.5
"""Depth [m] of what usually stands up to which it may hang flat on a wall."""

BESIDE = ("next_to", "near", "left_of", "right_of", "in_front_of", "behind", "against", "leaning_on", "below", "at")
"""Stated relations to a thing or a part of the room that put such a thing on the floor."""


SHARES = {
    "centered_on": (0.5, 0.0),
    "left_of": (0.5, -0.85),
    "right_of": (0.5, 0.85),
    "in_front_of": (0.95, 0.0),
    "behind": (0.05, 0.0),
}
"""Where on its support a thing is that is said to be in its middle or at one of its sides: depth, side."""


def supported(program: Program, brief: SceneGraph) -> None:
    """Give each thing that was asked to stand on something its support, and small things without one the likeliest.

    What is related to a small thing stands on the same; what nothing carries stands on the floor where it may, and is
    left out else.
    """
    by_asked: dict[str, list[Wanted]] = {}
    for one in program.wanted:
        if one.asked is not None:
            by_asked.setdefault(one.asked, []).append(one)
    _stated_supports(program, brief, by_asked)
    _held(brief, by_asked)
    spread = {one.id: spread_of(one.asked, brief) for one in program.wanted if one.asked is not None}
    _likely_supports(program.wanted, _pairs(brief, by_asked), spread)
    for said in brief.relations:
        if said.type in SHARES:
            for one in by_asked.get(said.subject, []):
                if one.support is not None and one.support.asked in said.targets:
                    one.share = SHARES[said.type]
    lost = [w for w in program.wanted if w.mount == "surface" and w.support is None]
    program.wanted = [w for w in program.wanted if w not in lost]
    program.left_out += [LeftOut(w.asked, f"{w.category}: nothing in the room can carry it") for w in lost]


def _stated_supports(program: Program, brief: SceneGraph, by_asked: dict[str, list[Wanted]]) -> None:
    """Supports as the request says them: on, in, or in the middle of something."""
    things = {name: [one.thing for one in several] for name, several in by_asked.items()}
    by_id = {one.id: one for one in program.wanted}
    done = set[str]()
    for said in brief.relations:
        if said.type not in ("on", "inside", "centered_on", "hanging_from"):
            continue
        for k, one in enumerate(by_asked.get(said.subject, [])):
            holder = carrier_of(said, things, k)
            target = by_id.get(holder.id) if holder is not None else None
            # The first that is said counts, before what is usual, and nothing stands on what stands on it.
            if target is None or target is one or one.id in done or _carried(target, one):
                continue
            if said.type == "hanging_from":
                if one.asset.mount != "ceiling" and not target.thing.is_flat:
                    one.support, one.hangs, one.inside = target, True, False
                    done.add(one.id)
                continue
            # What has the floor may be said to be in the middle of a rug or a room.
            if said.type == "centered_on" and one.mount != "surface":
                continue
            if not target.thing.is_flat and _may_carry(target, one):
                one.support, one.inside = target, said.type == "inside"
                one.on_top = said.type == "on" and _TOP.search(said.words) is not None
                done.add(one.id)
            elif "floor" in category_named(one.category).mount or one.mount == "surface":
                one.held = "floor"
                done.add(one.id)


def _likely_supports(
    wanted: Sequence[Wanted], pairs: Sequence[tuple[Wanted, Wanted]], spread: Mapping[str, str | None]
) -> None:
    """The likeliest supports for small things of which nothing is said, those that are related on the same.

    What is spread over all surfaces goes onto each in turn, what is all over the room partly onto the floor.
    """
    _share_supports(pairs)
    strewn = Counter[tuple[str | None, str]]()
    load: dict[str, float] = {}  # share of the surfaces of a support that is taken
    for one in wanted:
        if one.mount != "surface" or one.support is not None:
            continue
        fits = [
            w
            for w in wanted
            if w is not one and w.support is None and any(fits_on(s, one.asset.size) for s in w.asset.surfaces)
        ]
        holds_others = any(w.support is one for w in wanted)
        all_over = spread.get(one.id)
        if one.asked is not None and has_role(one.category, "set_down") and holds_others:
            one.held = "floor"  # a bin that holds toys
        elif lies_on_floor(one.number, all_over) and one.asset.size[2] < TALLEST:
            one.held = "floor"
        elif fits and all_over in ("surfaces", "everywhere"):
            tops = [w for w in fits if not {"seating", "chair_group"} & groups_of(w.category)] or fits
            one.support = min(tops, key=lambda w: (strewn[one.asked, w.id], _unlikely(one, w, load.get(w.id, 0.0))))
            strewn[one.asked, one.support.id] += 1
        elif fits:
            one.support = min(fits, key=lambda w: _unlikely(one, w, load.get(w.id, 0.0)))
            taken = one.asset.size[0] * one.asset.size[1] / max(_ground(one.support), 1e-6)
            load[one.support.id] = load.get(one.support.id, 0.0) + taken
            _share_supports(pairs)
        elif one.asked is not None and one.asset.size[2] < TALLEST:
            one.held = "floor"


def _held(brief: SceneGraph, by_asked: dict[str, list[Wanted]]) -> None:
    """What hangs or stands otherwise than usual: on the wall or from the ceiling as the request says; toys, balls and
    boxes beside furniture on the floor."""
    for said in [*brief.relations, *_turned(brief.relations)]:
        for one in by_asked.get(said.subject, []):
            if one.support is not None:
                continue
            may = category_named(one.category).mount
            place = said.targets[0].partition(":")[0] if said.targets else ""
            if "wall" in may and (place == "wall" or said.type == "above") and one.asset.mount != "ceiling":
                one.held = "wall" if one.mount != "floor" or said.type in ("on", "hanging_from", "above") else one.held
            elif place == "wall" and said.type in ("on", "hanging_from") and one.category not in categories():
                one.held = "wall"  # of what is not known it is known that it hangs
            elif place == "wall" and said.type == "hanging_from" and one.asset.size[0] <= SHALLOW:
                one.held = "wall"  # a spade, a guitar; a bicycle stands out too far
            elif "ceiling" in may and place == "ceiling":
                one.held = "ceiling"
            elif one.mount == "surface" and (place == "floor" or said.type == "around" and _on_floor(said, by_asked)):
                one.held = "floor"
            elif one.mount == "surface" and said.type in BESIDE:
                floor = not any(by_asked.get(name) for name in said.targets) or _on_floor(said, by_asked)
                if floor and (has_role(one.category, "set_down") or "floor" in may):
                    one.held = "floor"


def _turned(relations: Sequence[StatedRelation]) -> list[StatedRelation]:
    """What is told to be next to something, said of that: a basket beside which a palm stands."""
    return [
        said.model_copy(update={"subject": target, "targets": (said.subject,)})
        for said in relations
        for target in said.targets
        if said.type in ("next_to", "near", "side_by_side")
    ]


def _on_floor(said: StatedRelation, by_asked: dict[str, list[Wanted]]) -> bool:
    """Whether all that a relation is told to stands on the floor, and none of it is a table."""
    targets = [w for name in said.targets for w in by_asked.get(name, [])]
    standing = all(w.mount == "floor" and w.support is None for w in targets)
    return bool(targets) and standing and not any(w.thing.is_table for w in targets if said.type == "around")


def _pairs(brief: SceneGraph, by_asked: dict[str, list[Wanted]]) -> list[tuple[Wanted, Wanted]]:
    """Small things that the request relates to each other."""
    found = []
    for said in brief.relations:
        if said.type in ("on", "inside", "far_from", "opposite"):
            continue
        for name in said.targets:
            targets = by_asked.get(name, [])
            for k, one in enumerate(by_asked.get(said.subject, [])):
                other = targets[k % len(targets)] if targets else one
                if other is not one and one.mount == other.mount == "surface":
                    found.append((one, other))
    return found


def _share_supports(pairs: Sequence[tuple[Wanted, Wanted]]) -> None:
    """What is related to a small thing stands on what carries that, as long as there is more to find."""
    for _ in pairs:
        open_ = [(a, b) for a, b in pairs if (a.support is None) != (b.support is None)]
        if not open_:
            return
        for a, b in open_:
            if a.support is None and b.support is not None and b.support is not a:
                a.support = b.support
            elif b.support is None and a.support is not None and a.support is not b:
                b.support = a.support


def _carried(target: Wanted, one: Wanted) -> bool:
    """Whether one thing carries another already, directly or not."""
    at: Wanted | None = target
    while at is not None:
        if at is one:
            return True
        at = at.support
    return False


def _may_carry(target: Wanted, one: Wanted) -> bool:
    """Whether a thing may stand on another: what needs the floor does where it fits."""
    if "surface" in category_named(one.category).mount:
        return True
    if "chair_group" in groups_of(one.category) and "chair_group" in groups_of(target.category):
        return False  # "one on the other side" puts no chair on a chair
    (short, long), (depth, width) = (sorted(w.asset.size[:2]) for w in (one, target))
    known = category_named(target.category).size
    if has_role(target.category, "walked_on") and known is not None:  # a stage grows to hold what stands on it
        (least, most) = sorted(end for _, end in known.reach[:2])
        return "floor" in category_named(one.category).mount and short <= least and long <= most
    small = long <= width and short <= REACH[1] * depth and one.asset.size[2] < 1.0
    at_table = one.thing.is_seat and target.thing.is_table
    return small and one.asset.mount == "floor" and target.mount != "ceiling" and not at_table


def _unlikely(one: Wanted, support: Wanted, load: float) -> tuple[bool, bool, int, float]:
    """What speaks against a support: that it is full, that it is sat on or out of reach, that such things stand
    elsewhere, that others stand there."""
    rank = likeliness(one.category, support.category)
    apart = rank is None and support.thing.is_seat or min(s.z for s in support.asset.surfaces) > EYES
    return load > FULL, apart, NOWHERE if rank is None else rank, load


def _ground(support: Wanted) -> float:
    """Area [m2] of a support's surfaces."""
    import shapely

    return float(sum(shapely.Polygon(surface.polygon).area for surface in support.asset.surfaces))


@dataclass
class Places:
    """Where small things stand: their objects by id, the tops and hooks that others got, what things are called in the
    request, rows that do not hold, and what has no room where it was asked for."""

    objects: dict[str, SceneObject] = field(default_factory=dict)
    tops: dict[str, Surface] = field(default_factory=dict)
    hooks: dict[str, tuple[Surface, ...]] = field(default_factory=dict)
    nouns: dict[str, str] = field(default_factory=dict)
    failed: list[Grounded] = field(default_factory=list)
    unmet: list[str] = field(default_factory=list)


def laid(
    program: Program,
    rows: Sequence[Grounded],
    library: Library,
    brief: SceneGraph,
    palette: Palette,
    seed: int,
    hurried: Callable[[], bool] = bool,
) -> Places:
    """Lay out all that stands on something, supports before what they carry.

    A support that is too small for it is exchanged for a larger one of its kind, and what still finds no room for the
    smallest of its kind, unless their size was asked for or time is short (``hurried``). What has no room then goes
    out of the program.
    """
    shelf = Shelf(library, palette, seed)
    places = Places(nouns={entity.id: entity.noun for entity in brief.entities})
    sized = {entity.id for entity in brief.entities if any(entity.size)}
    for support in sorted(program.wanted, key=_depth, reverse=True):
        riders = [w for w in program.wanted if w.support is support and not w.hangs]
        if support.support is not None and riders:  # a tray is as large as its cups need it before it is put down
            _fitted(support, riders, rows, shelf, Places(), library, sized, hurried)
    done: set[str] = set()
    while True:
        ready = [w for w in program.wanted if w.id not in done and (w.support is None or w.support.id in done)]
        if not ready:
            break
        for support in ready:
            done.add(support.id)
            riders = [w for w in program.wanted if w.support is support]
            if not riders:
                continue
            usual = {w.id: w.asset for w in riders}
            hung = [w for w in riders if w.hangs]
            if hung:
                dropped = hang_on(support, hung, library, places, support.asked in sized)
                _put_aside(program, dropped, support, places)
                riders = [w for w in riders if not w.hangs]
                if not riders:
                    continue
            found, lost = _fitted(support, riders, rows, shelf, places, library, sized, hurried)
            lost = _not_stacked(lost, [w for w in riders if w not in lost])
            for one in lost:
                one.asset = usual[one.id]
            _stand(support, found, places)
            places.failed += _astray(found, rows)
            _put_aside(program, lost, support, places)
    return places


def _depth(one: Wanted) -> int:
    return 0 if one.support is None else 1 + _depth(one.support)


def _fitted(
    support: Wanted,
    riders: Sequence[Wanted],
    rows: Sequence[Grounded],
    shelf: Shelf,
    places: Places,
    library: Library,
    sized: set[str],
    hurried: Callable[[], bool],
) -> tuple[list[Standing], list[Wanted]]:
    """Where things stand on a support, and those without room; for these it grows, and they shrink, while there is
    time."""
    if any(one.inside for one in riders) and support.id not in places.objects:
        _open(support, library)
    for one in riders:
        if one.inside and carrier(support.category).ways == ("inside",):
            _put_within(one, library)
    found, lost = _on_one(support, riders, rows, shelf, places)
    on_end = [one for one in lost if one.inside and one.asset.size[2] < max(one.asset.size[:2])]
    if on_end:  # brushes stand in a jar
        lying = {one.id: one.asset for one in on_end}
        for one in on_end:
            one.asset = upright(one.asset, one.drawn_as or one.category, one.wish, library)
        again, missing = _on_one(support, riders, rows, shelf, places)
        if len(missing) < len(lost):
            found, lost = again, missing
        else:
            for one in on_end:
                one.asset = lying[one.id]
    grows = support.id not in places.objects and support.asked not in sized
    for step in (*GROWN, *SHRUNK, GROWN[-1]) if len(lost) < MANY_LOST else (GROWN[-1], SHRUNK[-1]):
        astray = _astray(found, rows)
        if (not lost and not astray) or hurried():
            break
        if step in SHRUNK:
            for category in dict.fromkeys(w.category for w in lost if w.asked not in sized):
                for one in lost:
                    if one.category == category and one.asked not in sized:
                        one.asset = _smaller(one, step, library) or one.asset
                found, lost = _on_one(support, riders, rows, shelf, places)
            continue
        larger = _larger(support, step, library) if grows else None
        if larger is not None:
            before, support.asset = support.asset, larger
            again, missing = _on_one(support, riders, rows, shelf, places)
            if (len(missing), len(_astray(again, rows))) < (len(lost), len(astray)):
                found, lost = again, missing
            else:
                support.asset = before
    return found, lost


def _open(support: Wanted, library: Library) -> None:
    """Give a box, bin or vessel that things are put into room for them: without a lid, or with its cavity kept free."""
    has_inside = any(s.headroom is not None or s.name == INSIDE for s in support.asset.surfaces)
    if has_inside or support.wish is None or support.wish.shape is not None:
        return
    open_ = hollow(support.asset)
    if open_ is not support.asset:
        support.asset, support.drawn_as = open_, support.category
        return
    support.drawn_as = vessel_body(support.category)
    if support.drawn_as is not None:
        made = _drawn_anew(support, support.asset.size, True, library)
        if made is not None and any(s.name == INSIDE for s in made.surfaces):
            support.asset = made
            return
        support.drawn_as = None
    wish, support.wish = support.wish, replace(support.wish, shape=OPEN)
    opened = _drawn_anew(support, support.asset.size, True, library)
    if opened is not None and any(s.name == INSIDE for s in opened.surfaces):
        support.asset = opened
    else:
        support.wish = wish


def _put_within(one: Wanted, library: Library) -> None:
    """Give a thing the body that it has within another: flowers are without their vase."""
    body = body_within(one.category)
    if body is None or one.wish is None or one.drawn_as is not None:
        return
    try:
        made = library.choose(body, 1, replace(one.wish, size=(None, None, None), shape=None))[0]
    except InputError:
        return
    one.asset, one.drawn_as = replace(made, category=one.asset.category), body


def _not_stacked(lost: Sequence[Wanted], placed: Sequence[Wanted]) -> list[Wanted]:
    """Put flat things without room on others of their kind, towels on towels, and return the rest."""
    left = []
    for one in lost:
        piles = [w for w in placed if w.category == one.category and _is_flat(w.asset)]
        if piles and _is_flat(one.asset):
            below = piles[sum(w.support in piles for w in lost) % len(piles)]
            one.support, one.inside, one.share = below, False, None
        else:
            left.append(one)
    return left


def _is_flat(asset: Asset) -> bool:
    return asset.size[2] <= PILED * min(asset.size[:2])


def _on_one(
    support: Wanted, riders: Sequence[Wanted], rows: Sequence[Grounded], shelf: Shelf, places: Places
) -> tuple[list[Standing], list[Wanted]]:
    obj = places.objects.get(support.id) or support.asset.object(support.id, mount="floor")
    top = None if obj.surfaces and not _bare_top(obj, riders) else _top(obj)
    if top is not None:
        if all(one.category == support.category for one in riders):
            top = _over_edge(top)
        places.tops[support.id] = top
        obj = obj.model_copy(update={"surfaces": (*obj.surfaces, top)})
    plan = usual_arrangement(support.item.top if support.item else None, support.category)
    if not obj.surfaces:
        return [], list(riders)
    layer = StatedLayer(obj, plan, shelf)
    found, lost = layer.run([Rider(w.id, w.asset, w.inside, w.share, w.on_top) for w in riders], rows)
    names = {rider.id for rider in lost}
    return found, [w for w in riders if w.id in names]


def _bare_top(obj: SceneObject, riders: Sequence[Wanted]) -> bool:
    """Whether something goes on top of a thing with doors, whose surfaces are all behind them: a kettle on a fridge."""
    outside = any(one.on_top or (not one.inside and has_role(obj.category, "opened")) for one in riders)
    return outside and all(s.headroom is not None for s in obj.surfaces)


def _over_edge(top: Surface) -> Surface:
    """The top of a pile of alike things, of which none lies exactly on the other."""
    import shapely

    grown = shapely.Polygon(top.polygon).buffer(OVERHANG, join_style="mitre")
    ring = tuple((float(x), float(y)) for x, y in shapely.get_coordinates(grown)[:-1])
    return top.model_copy(update={"polygon": ring})


def _stand(support: Wanted, found: Sequence[Standing], places: Places) -> None:
    """Make objects of what was laid on a support, in its frame where it is now."""
    held = places.objects.get(support.id)
    pose = held.pose if held is not None else None
    x, y, z = pose.position if pose is not None else (0.0, 0.0, 0.0)
    frame = Frame(x, y, pose.yaw if pose is not None else 0.0, z)
    places.objects |= {one.id: one.made(support.id, frame) for one in found}


def _astray(found: Sequence[Standing], rows: Sequence[Grounded]) -> list[Grounded]:
    """The relations between things on one support that do not hold where these stand."""
    spots = {one.id: one for one in found}
    astray = []
    for row in rows:
        ids = {row.subject, *((row.target,) if isinstance(row.target, str) else row.target or ())}
        if ids <= set(spots) and len(ids) > 1:
            same = len({spots[i].surface.name for i in ids}) == 1
            if not same or row.type not in EXACT or not holds(row, spots):
                astray.append(row)
    return astray


def _put_aside(program: Program, lost: Sequence[Wanted], support: Wanted, places: Places) -> None:
    """What has no room: if it was asked for it stands on the floor beside its support, else it goes with all on it."""
    gone = [one for one in lost if one.asked is None or one.asset.size[2] >= TALLEST]
    for one in lost:
        if one not in gone:
            one.support, one.held, one.hangs = None, "floor", False
            places.unmet.append(f"{one.id}: there is no room for it on {support.id}; it stands beside it")
    while more := [w for w in program.wanted if w.support in gone and w not in gone]:
        gone += more
    program.wanted = [w for w in program.wanted if w not in gone]
    program.left_out += [LeftOut(w.asked, f"{w.category}: there is no room for it on {support.id}") for w in gone]


def _larger(support: Wanted, share: float, library: Library) -> Asset | None:
    """A body of the same kind that has more room; None where there is none."""
    known = category_named(support.category).size
    if known is None or support.wish is None:
        return None
    size = [
        max(have, _at_share(usual, most, share)) if share > 1.0 else max(have, have + share * (usual[1] - have))
        for have, usual, most in zip(support.asset.size, known.ranges[:2], known.reach, strict=False)
    ]
    return _drawn_anew(support, (*size, support.wish.size[2]), share > 1.0, library)


def _smaller(one: Wanted, share: float, library: Library) -> Asset | None:
    """A small body of the same kind; None where there is none."""
    known = category_named(one.drawn_as or one.category).size
    if known is None:
        return None
    size = [_at_share(usual, reach, share) for usual, reach in zip(known.ranges, known.reach, strict=True)]
    return _drawn_anew(one, size, share < 0.0, library)


def _at_share(usual: Range, reach: Range, share: float) -> float:
    """An extent [m] by where in its usual range it is; beyond 0 and 1 it goes on to the ends of the reach."""
    if share < 0.0:
        return usual[0] - share * (reach[0] - usual[0])
    if share > 1.0:
        return usual[1] + (share - 1.0) * (reach[1] - usual[1])
    return usual[0] + share * (usual[1] - usual[0])


def _drawn_anew(one: Wanted, size: Sequence[float | None], beyond: bool, library: Library) -> Asset | None:
    """A body of another size [m], ``beyond`` what is usual; None where none can be drawn."""
    if one.wish is None:
        return None
    depth, width, height = (None if side is None else round(side, 3) for side in size)
    wish = replace(one.wish, size=(depth, width, height), beyond=beyond or one.wish.beyond)
    try:
        made = library.choose(one.drawn_as or one.category, 1, wish)[0]
    except InputError:
        return None
    return made if one.drawn_as is None else hollow(replace(made, category=one.asset.category))


def _top(obj: SceneObject) -> Surface | None:
    """The flat top of what has no surface of its own: of its highest wide part, with what rises from it."""
    import shapely

    best: tuple[float, Surface] | None = None
    for part in obj.solids:
        ground = shapely.Polygon(part.polygon)
        above = [shapely.Polygon(p.polygon) for p in obj.solids if p.z[1] > part.z[1] + 0.005]
        free = ground.difference(shapely.union_all(above)) if above else ground
        if free.area < FREE * ground.area:
            continue
        whole = free.geom_type == "Polygon" and not shapely.get_num_interior_rings(free)
        score = free.area + 0.02 * part.z[1]
        if best is None or score > best[0]:
            ring = tuple((float(x), float(y)) for x, y in shapely.get_coordinates(free if whole else ground)[:-1])
            best = score, Surface(name="top", polygon=ring, z=part.z[1])
    return best[1] if best else None
