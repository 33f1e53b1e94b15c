"""What stands on what: the support of each small thing of a room, and its place there as the request says it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from sceneweaver.assets import Asset, Library
from sceneweaver.assets.taxonomy import category_named, likeliness
from sceneweaver.brief import Grounded, SceneGraph, carrier_of
from sceneweaver.brief.pairs import groups_of
from sceneweaver.knowledge.surfaces import usual_arrangement
from sceneweaver.scene import InputError, Palette, SceneObject, Support, Surface

from .prior_program import LeftOut, Program, Wanted
from .prior_relations import thing_of
from .surface_assets import Shelf, placed
from .surface_clusters import EXACT, Rider, holds
from .surface_scene import Frame
from .surface_stated import Laid, StatedLayer

FULL = 0.5
"""Share of a support's surfaces from which on what was asked for stands elsewhere."""

NOWHERE = 99
"""Rank of a support on which such things never stand."""

TALLEST = 1.2
"""Height [m] from which on a small thing that nothing carries does not stand on the floor instead."""

GROWN = (0.5, 1.0)
"""Shares of the way to the largest of its kind by which a support grows when what is to stand on it has no room."""

ON_FLOOR = frozenset(("toy_group", "sport", "container"))
"""Groups of small things that may as well stand on the floor."""

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
    things = {name: [thing_of(one) for one in several] for name, several in by_asked.items()}
    by_id = {one.id: one for one in program.wanted}
    for said in brief.relations:
        for k, one in enumerate(by_asked.get(said.subject, [])):
            carrier = carrier_of(said, things, k) if said.type in ("on", "inside", "centered_on") else None
            target = by_id.get(carrier.id) if carrier is not None else None
            if target is None or target is one or one.support is not None or _carried(target, one):
                continue
            if said.type == "centered_on" and one.mount != "surface":
                continue
            if not thing_of(target).is_flat and _may_carry(target, one):
                one.support, one.inside = target, said.type == "inside"
            elif "floor" in category_named(one.category).mount or one.mount == "surface":
                one.held = "floor"
    _held(brief, by_asked)
    pairs = _pairs(brief, by_asked)
    _share_supports(pairs)
    load: dict[str, float] = {}  # share of the surfaces of a support that is taken
    for one in program.wanted:
        if one.mount != "surface" or one.support is not None:
            continue
        fits = [w for w in program.wanted if w is not one and w.support is None and _fits_on(w.asset, one.asset)]
        if fits:
            one.support = min(fits, key=lambda w: _unlikely(one, w, load.get(w.id, 0.0)))
            taken = one.asset.size[0] * one.asset.size[1] / max(_ground(one.support), 1e-6)
            load[one.support.id] = load.get(one.support.id, 0.0) + taken
            _share_supports(pairs)
        elif one.asked is not None and one.asset.size[2] < TALLEST:
            one.held = "floor"
    for said in brief.relations:
        if said.type in SHARES:
            for one in by_asked.get(said.subject, []):
                if one.support is not None and one.support.asked in said.targets:
                    one.share = SHARES[said.type]
    lost = [w for w in program.wanted if w.mount == "surface" and w.support is None]
    program.wanted = [w for w in program.wanted if w not in lost]
    program.left_out += [LeftOut(w.asked, f"{w.category}: nothing in the room can carry it") for w in lost]


def _held(brief: SceneGraph, by_asked: dict[str, list[Wanted]]) -> None:
    """What hangs or stands otherwise than usual: on the wall or from the ceiling as the request says; toys, balls and
    boxes beside furniture on the floor."""
    for said in brief.relations:
        for one in by_asked.get(said.subject, []):
            if one.support is not None:
                continue
            may = category_named(one.category).mount
            place = said.targets[0].partition(":")[0] if said.targets else ""
            if "wall" in may and (place == "wall" or said.type == "above") and one.asset.mount != "ceiling":
                one.held = "wall" if one.mount != "floor" or said.type in ("on", "hanging_from", "above") else one.held
            elif "ceiling" in may and place == "ceiling":
                one.held = "ceiling"
            elif one.mount == "surface" and said.type in BESIDE:
                targets = [w for name in said.targets for w in by_asked.get(name, [])]
                floor = not targets or all(w.mount == "floor" and w.support is None for w in targets)
                if floor and (groups_of(one.category) & ON_FLOOR or "floor" in may):
                    one.held = "floor"


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
    small = max(one.asset.size[:2]) <= max(target.asset.size[:2]) and one.asset.size[2] < 1.0
    return small and one.asset.mount == "floor" and target.mount != "ceiling"


def _unlikely(one: Wanted, support: Wanted, load: float) -> tuple[bool, int, float]:
    """What speaks against a support: that it is full, that such things stand elsewhere, that others stand there."""
    rank = likeliness(one.category, support.category)
    return load > FULL, NOWHERE if rank is None else rank, load


def _ground(support: Wanted) -> float:
    """Area [m2] of a support's surfaces."""
    import shapely

    return float(sum(shapely.Polygon(surface.polygon).area for surface in support.asset.surfaces))


def _fits_on(support: Asset, thing: Asset) -> bool:
    """Whether a thing fits on some surface of another, by its box."""
    import shapely

    d, w, h = thing.size
    for surface in support.surfaces:
        if surface.headroom is not None and surface.headroom < h + 0.005:
            continue
        x0, y0, x1, y1 = shapely.Polygon(surface.polygon).bounds
        if min(x1 - x0, y1 - y0) >= min(d, w) and max(x1 - x0, y1 - y0) >= max(d, w):
            return True
    return False


@dataclass
class Places:
    """Where small things stand: their objects by id, the tops that others got, rows that do not hold, and what has no
    room where it was asked for."""

    objects: dict[str, SceneObject] = field(default_factory=dict)
    tops: dict[str, Surface] = field(default_factory=dict)
    failed: list[Grounded] = field(default_factory=list)
    unmet: list[str] = field(default_factory=list)


def laid(
    program: Program, rows: Sequence[Grounded], library: Library, brief: SceneGraph, palette: Palette, seed: int
) -> Places:
    """Lay out all that stands on something, supports before what they carry.

    A support that is too small for it is exchanged for a larger one of its kind, and what still finds no room for the
    smallest of its kind, unless their size was asked for. What has no room then goes out of the program.
    """
    shelf = Shelf(library, palette, seed)
    places = Places()
    sized = {entity.id for entity in brief.entities if any(entity.size)}
    for support in sorted(program.wanted, key=_depth, reverse=True):
        riders = [w for w in program.wanted if w.support is support]
        if support.support is not None and riders:  # a tray is as large as its cups need it before it is put down
            _fitted(support, riders, rows, shelf, Places(), library, sized)
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
            found, lost = _fitted(support, riders, rows, shelf, places, library, sized)
            _stand(support, found, places)
            _check(found, rows, places)
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
) -> tuple[list[Laid], list[Wanted]]:
    """Where things stand on a support, and those without room; for these it grows, and they shrink."""
    found, lost = _on_one(support, riders, rows, shelf, places)
    for share in GROWN if support.id not in places.objects and support.asked not in sized else ():
        larger = _larger(support, share, library) if lost else None
        if larger is not None:
            before, support.asset = support.asset, larger
            again, missing = _on_one(support, riders, rows, shelf, places)
            if len(missing) < len(lost):
                found, lost = again, missing
            else:
                support.asset = before
    for one in [w for w in lost if w.asked not in sized]:
        one.asset = _smallest(one, library) or one.asset
        found, lost = _on_one(support, riders, rows, shelf, places)
    return found, lost


def _on_one(
    support: Wanted, riders: Sequence[Wanted], rows: Sequence[Grounded], shelf: Shelf, places: Places
) -> tuple[list[Laid], list[Wanted]]:
    obj = places.objects.get(support.id) or support.asset.object(support.id, mount="floor")
    top = None if obj.surfaces else _top(obj)
    if top is not None:
        places.tops[support.id] = top
        obj = obj.model_copy(update={"surfaces": (top,)})
    plan = usual_arrangement(support.item.top if support.item else None, support.category)
    if not obj.surfaces:
        return [], list(riders)
    layer = StatedLayer(obj, plan, shelf)
    found, lost = layer.run([Rider(w.id, w.asset, w.inside, w.share) for w in riders], rows)
    names = {rider.id for rider in lost}
    return found, [w for w in riders if w.id in names]


def _stand(support: Wanted, found: Sequence[Laid], places: Places) -> None:
    """Make objects of what was laid on a support, in its frame where it is now."""
    held = places.objects.get(support.id)
    pose = held.pose if held is not None else None
    x, y, z = pose.position if pose is not None else (0.0, 0.0, 0.0)
    frame = Frame(x, y, pose.yaw if pose is not None else 0.0, z)
    for one in found:
        at = (float(one.at[0]), float(one.at[1]), one.surface.z)
        on = Support(object=support.id, surface=one.surface.name)
        places.objects[one.rider.id] = placed(one.rider.asset, one.rider.id, frame, at, one.yaw, on)


def _check(found: Sequence[Laid], rows: Sequence[Grounded], places: Places) -> None:
    spots = {one.rider.id: one for one in found}
    for row in rows:
        ids = {row.subject, *((row.target,) if isinstance(row.target, str) else row.target or ())}
        if ids <= set(spots) and len(ids) > 1:
            same = len({spots[i].surface.name for i in ids}) == 1
            if not same or row.type not in EXACT or not holds(row, spots):
                places.failed.append(row)


def _put_aside(program: Program, lost: Sequence[Wanted], support: Wanted, places: Places) -> None:
    """What has no room: if it was asked for it stands on the floor beside its support, else it goes with all on it."""
    gone = [one for one in lost if one.asked is None or one.asset.size[2] >= TALLEST]
    for one in lost:
        if one not in gone:
            one.support, one.held = None, "floor"
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
    d, w, _ = support.asset.size
    size = tuple(
        round(max(have, have + share * (most - have)), 3)
        for have, (_, most) in zip((d, w), known.ranges[:2], strict=True)
    )
    try:
        return library.choose(support.category, 1, replace(support.wish, size=(*size, support.wish.size[2])))[0]
    except InputError:
        return None


def _smallest(one: Wanted, library: Library) -> Asset | None:
    """The smallest body of the same kind; None where there is none."""
    known = category_named(one.category).size
    if known is None or one.wish is None:
        return None
    (depth, _), (width, _), (height, _) = known.ranges
    try:
        return library.choose(one.category, 1, replace(one.wish, size=(depth, width, height)))[0]
    except InputError:
        return None


def _top(obj: SceneObject) -> Surface | None:
    """The flat top of what has no surface of its own: of its highest wide part."""
    import shapely

    best: tuple[float, Surface] | None = None
    for part in obj.solids:
        ground = shapely.Polygon(part.polygon)
        above = [shapely.Polygon(p.polygon) for p in obj.solids if p.z[1] > part.z[1] + 0.005]
        free = ground.difference(shapely.union_all(above)) if above else ground
        if free.geom_type != "Polygon" or free.is_empty or shapely.get_num_interior_rings(free):
            continue
        score = free.area + 0.02 * part.z[1]
        if best is None or score > best[0]:
            ring = tuple((float(x), float(y)) for x, y in shapely.get_coordinates(free)[:-1])
            best = score, Surface(name="top", polygon=ring, z=part.z[1])
    return best[1] if best else None
