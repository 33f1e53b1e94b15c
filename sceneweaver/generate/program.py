"""From a kind of room and a request to a list of objects: what, how many, beside which, and how badly needed."""

from __future__ import annotations

import random
import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from sceneweaver.assets import Asset, Library, Look, Wish, categories, drawable
from sceneweaver.assets.roles import groups_above, has_role, with_role
from sceneweaver.assets.taxonomy import category_named, narrower
from sceneweaver.assets.zones import cleared, hung_at
from sceneweaver.knowledge import Item, Place, RoomType
from sceneweaver.knowledge.kin import excluded_kinds, serves
from sceneweaver.knowledge.usual_places import usual_places_of
from sceneweaver.language import Entity, SceneGraph, Thing
from sceneweaver.language.standing import stood_at
from sceneweaver.language.told_states import words_of_whole
from sceneweaver.scene import PRIORITIES, InputError, Palette, SceneObject, Zone

from .draft import CRAMMED, groups_of
from .hanging import OVER, before_window, hanging_height, is_lit_table
from .kitchen_runs import galley_spared
from .meant import (
    decided_kinds,
    desks_spared,
    is_plural,
    loose,
    matches,
    may_mean,
    meant_by,
    places_spared,
    roles_of,
    sat_elsewhere,
    stations_spared,
)
from .quantity import SOME, is_detailed, is_plain, is_plain_item, least_of, small_kind

PLENTY = 5
"""How many of a thing that stands on the floor are so many that some of them are small ones, on furniture."""

SMALL, SPARE = 0.3, 0.05
"""What takes at most this floor [m2] may take this share of the floor beyond what furniture fills."""

CRAMPED = 0.75
"""Share of the usual floor of a kind of room below which nothing is added for which something asked for serves."""

RUN = 0.6
"""Share of the floor under the units of a run that counts as taken: no ways lead around and between them."""

HUNG = 0.75
"""Height of furniture hung on a wall, as a share of the least usual: its top is where it usually is."""

BY_RANK = PRIORITIES[::-1]
"""Priorities by rank, what is most wanted first."""

SEATS = frozenset(("chair_group", "stool"))
"""Groups and categories of seats without a place of their own."""

RANK = {priority: rank for rank, priority in enumerate(BY_RANK)}


@dataclass
class Wanted:
    """One object to be.

    ``parent`` is the instance that it goes with, ``support`` the one that it stands on (``inside``: on a board in it;
    ``on_top``: above all of it; ``hangs``: from it; ``share``: where, as depth and side), ``held`` what holds it where
    the request has it otherwise than usual, ``hung`` between which heights [m] its bottom is then, ``wish`` what its
    body was chosen by, ``drawn_as`` the category of its body where that is another one.
    """

    item: Item | None
    category: str
    asset: Asset
    rank: int
    number: int
    parent: Wanted | None = None
    support: Wanted | None = None
    asked: str | None = None
    id: str = ""
    inside: bool = False
    hangs: bool = False
    on_top: bool = False
    share: tuple[float, float] | None = None
    held: str | None = None
    hung: tuple[float, float] | None = None
    drawn_as: str | None = None
    wish: Wish | None = None

    @property
    def mount(self) -> str:
        """What holds it."""
        if self.support is not None:
            return "surface"
        if self.held is not None:
            return self.held
        return (self.item and self.item.mount) or self.asset.mount

    @property
    def thing(self) -> Thing:
        """It as the relations of a request know it."""
        return Thing(self.id, self.category, self.asset.size, self.mount, self.support.id if self.support else None)

    @property
    def footprint(self) -> float:
        """Floor [m2] under it; less of it for a unit of a run, half for a seat, as it goes partly under its table, and
        nothing for a rug."""
        d, w, h = self.asset.size
        if self.mount != "floor" or h < 0.02:
            return 0.0
        seat = self.parent is not None and "seating" in groups_of(self.category)
        run = self.item is not None and self.item.row == "run"
        return d * w * (0.5 if seat else RUN if run else 1.0)

    @property
    def mounted_from_behind(self) -> bool:
        """Whether it stands in a line at a wall with its front to it, as it is entered from its back: a treadmill."""
        free = {zone.name for zone in self.asset.zones if zone.hard}
        return self.item is not None and self.item.row == "line" and "back" in free and "front" not in free

    @property
    def usual(self) -> tuple[Place, ...]:
        """Where it usually goes: of what was asked for and is no item of the room; chairs go to what they are for."""
        groups = groups_of(self.category)
        if self.item is not None or self.support is not None or SEATS & groups:
            return ()
        return usual_places_of(groups)

    @property
    def wall(self) -> float:
        """Wall [m] that it takes."""
        places = self.item.place if self.item else self.usual
        if self.mount == "floor" and any(p.type == "against_wall" and not p.soft for p in places):
            return self.asset.size[1]
        return 0.0


@dataclass(frozen=True)
class Demand:
    """One kind of object with its count, before bodies are chosen; ``mixed`` ones are of all its categories in turn."""

    item: Item | None
    categories: tuple[str, ...]
    count: int
    rank: int
    asked: Entity | None = None
    least: int = 0
    mixed: bool = False


@dataclass(frozen=True)
class LeftOut:
    """Something that is not in the program: the id of what in the request it stands for, if anything, and why."""

    asked: str | None
    reason: str


@dataclass
class Program:
    """All objects to be, in order of need, parents before what goes with them; ``left_out`` says what did not fit."""

    wanted: list[Wanted] = field(default_factory=list)
    left_out: list[LeftOut] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def footprint(self) -> float:
        """Floor [m2] that all take together."""
        return sum(w.footprint for w in self.wanted)

    @property
    def wall(self) -> float:
        """Wall [m] that all take together."""
        return sum(w.wall for w in self.wanted)


def demands(room_type: RoomType, brief: SceneGraph, area: float, people: int, windows: int, seed: int) -> list[Demand]:
    """What the room should hold: what was asked, then the room's items by need, without what must not be there.

    Of a kind that was named there is what was named: it takes the place of the room's own, of which none is added.
    What was written for this very request is there besides, where it stands for nothing that the request names.
    """
    rng = random.Random(seed)
    banned = excluded_kinds(brief.without) if room_type.for_request else decided_kinds(brief, room_type)
    asked = {a.id: a for a in brief.entities}
    roles = roles_of(room_type, brief)
    shares = _shares(room_type, brief, area, people, roles)
    holders = {i.with_ for i in room_type.items if any(i.id in items for items in roles.values())}
    sat_at = _sat_at_items(brief, roles)
    spared = desks_spared(room_type, brief, roles) | stations_spared(room_type, brief, roles)
    spared |= places_spared(room_type, brief, roles, area, people) | galley_spared(room_type, brief, roles)
    skipped, spare = set[str](), set[str]()
    cramped = not room_type.for_request and (brief.scale < 1.0 or area < CRAMPED * room_type.area[1])
    stated = cramped and (brief.area is not None or brief.size is not None) and len(asked) >= SOME
    found: list[Demand] = []
    for item in room_type.items:
        draw, pick, keep = rng.random(), rng.random(), rng.random()
        meant = [a for a in asked.values() if item.id in roles[a.id]]
        own: Item | None = item
        if meant and sat_elsewhere(item, room_type, brief):
            spare.add(item.with_ or "")
            own = None
        if meant:
            for one in meant:
                share = shares.get(one.id)
                if share is None:
                    del asked[one.id]
                    found.append(_asked_demand(one, own, area, people, draw, brief))
                elif item.id in share:
                    many = share.pop(item.id)
                    if many:
                        found.append(Demand(own, (one.category,), many, 0, one, many))
                    if not share:
                        del asked[one.id]
            continue
        names = tuple(c for c in item.what if c not in banned)
        if names and cramped and any(serves(a.category, names) for a in brief.entities):
            continue  # in a small bathroom a shower that is asked for takes the place of the tub
        if stated and item.need != "needed" and names and _takes_floor(item):
            continue  # a small room that is told in detail has no floor for more
        if item.with_ in sat_at and "seating" in groups_of(item.what[0]):
            continue  # the request says what is sat on there
        if item.id in spared or _seated_already(item, room_type, brief):
            continue
        if not names and item.with_:
            skipped.add(item.with_)
        if _hangs_at_windows(item) and _something_at_windows(room_type, brief):
            short = tuple(c for c in names if not has_role(c, "curtain"))
            names = short or tuple(sorted(with_role("blind") - banned))
        if not names or (brief.only and item.need != "needed") or (brief.only and brief.entities):
            continue
        if item.id not in holders and not room_type.for_request and not _usual_enough(item, brief, keep):
            continue
        count = windows if _hangs_at_windows(item) else item.count.of(area, people, draw)
        start = int(pick * len(names)) if item.need != "needed" or len(names) > 1 else 0
        names = names[start:] + names[:start]
        if count > 0:
            found.append(Demand(item, names, count, RANK[item.need], least=min(count, item.count.least)))
    # A table whose seats were named for another place is not set out without any, a desk of ours not at all.
    found = [d for d in found if d.asked or d.item is None or d.item.id not in skipped or d.item.need == "needed"]
    found = [d for d in found if d.asked or d.item is None or d.item.id not in spare]
    found += [_asked_demand(one, None, area, people, rng.random(), brief) for one in asked.values()]
    return [_at_all_windows(demand, windows) for demand in found]


def _takes_floor(item: Item) -> bool:
    """Whether an item stands on the floor and is no light."""
    held = item.mount or category_named(item.what[0]).mount[0]
    return held == "floor" and "lighting" not in groups_above(item.what[0])


def _at_all_windows(demand: Demand, windows: int) -> Demand:
    """ "The curtains" are those of all windows."""
    asked = demand.asked
    if asked is None or asked.count is not None or not has_role(asked.category, "curtain", "blind"):
        return demand
    return replace(demand, count=max(1, windows), least=max(1, windows))


def _usual_enough(item: Item, brief: SceneGraph, keep: float) -> bool:
    """Whether something that nobody asked for is added; the more a request says, the less."""
    if is_plain(brief):
        return is_plain_item(item)
    if item.need == "needed":
        return True
    said = len(brief.entities)
    return said < SOME and keep >= 0.3 if item.need == "optional" else not is_detailed(brief)


def _shares(
    room_type: RoomType, brief: SceneGraph, area: float, people: int, roles: Mapping[str, Sequence[str]]
) -> dict[str, dict[str, int]]:
    """Where several items of the room stand for something asked for, how its number is spread over them.

    Each takes what it usually has, in the order of the room's file, and the last takes the rest: of eight bar stools
    four stand at the counter and four at the tables.
    """
    found: dict[str, dict[str, int]] = {}
    for one in brief.entities:
        items = [item for item in room_type.items if item.id in roles[one.id] and matches(one.category, item)]
        if one.count is None or len(items) < 2:
            continue
        left = _asked_demand(one, items[0], area, people, 0.5, brief).count
        share = found[one.id] = {}
        for item in items:
            hosts = room_type.item(item.with_).count.of(area, people, 0.5) if item.with_ else 1
            usual = item.count.of(area, people, 0.5) * max(1, hosts)
            share[item.id] = left if item is items[-1] else min(left, usual)
            left -= share[item.id]
    return found


def _sat_at_items(brief: SceneGraph, roles: Mapping[str, Sequence[str]]) -> frozenset[str]:
    """The items of the room at whose things the request has seats of its own, or people stand."""
    seats = {e.id for e in brief.entities if "seating" in groups_of(e.category)}
    placed = {r.subject for r in brief.relations if r.targets and not r.implied}
    tables = [e for e in brief.entities if has_role(e.category, "seated_at")]
    loose_seats = [e for e in brief.entities if has_role(e.category, "upright_seat") and e.id not in placed]
    beside = {t for r in brief.relations if r.subject in seats for t in r.targets} & {e.id for e in tables}
    alone = {tables[0].id} if len(tables) == 1 and loose_seats else set[str]()
    at = (
        beside
        | alone
        | {
            name
            for r in brief.relations
            if r.subject in seats and r.type in ("around", "along", "at")
            for name in r.targets
        }
    )
    return frozenset(item for name in at | stood_at(brief) for item in roles.get(name, ()))


ENOUGH_SEATS, ENOUGH_FOR_SOFA = 3, 4
"""Seats that a request names from which on a room gets none of its own besides, or no sofa."""


def _seated_already(item: Item, room_type: RoomType, brief: SceneGraph) -> bool:
    """Whether seats that nobody asked for would double those that the request names: benches in a waiting room."""
    if "seating" not in groups_of(item.what[0]):
        return False
    host = room_type.item(item.with_) if item.with_ else None
    if host is not None and any(has_role(name, "seated_at") for name in host.what):
        return False
    tables = {e.id for e in brief.entities if has_role(e.category, "seated_at")}
    at_tables = {r.subject for r in brief.relations if tables & set(r.targets)}
    seats = [e for e in brief.entities if "seating" in groups_of(e.category) and e.id not in at_tables]
    named = sum(e.count[0] if e.count else 2 if is_plural(e) else 1 for e in seats)
    return named >= (ENOUGH_FOR_SOFA if has_role(item.what[0], "sofa") else ENOUGH_SEATS)


def _hangs_at_windows(item: Item) -> bool:
    return (
        any(p.type == "at_window" and not p.soft for p in item.place)
        and item.mount != "floor"
        and all(categories()[c].mount[0] == "wall" for c in item.what if c in categories())
    )


def _something_at_windows(room_type: RoomType, brief: SceneGraph) -> bool:
    """Whether furniture should stand under a window, where a curtain down to the floor would be in its way."""
    asked = {a.id for a in brief.entities}
    return any("window" in said.targets and said.subject in asked for said in brief.relations) or any(
        p.type == "at_window" and not _hangs_at_windows(item) and item.need != "optional"
        for item in room_type.items
        for p in item.place
    )


def _asked_demand(asked: Entity, item: Item | None, area: float, people: int, draw: float, brief: SceneGraph) -> Demand:
    if asked.count is not None:
        low, high = asked.count
        usual = item.count.of(area, people, draw) if item else low
        count = max(low, min(high, usual))
    else:
        count = item.count.of(area, people, draw) if item and is_plural(asked) else 1
    count = max(count, least_of(asked, brief))
    names = (asked.category,)
    if item is not None and asked.category not in item.what and loose(asked, brief) and meant_by(asked, item, brief):
        words = " ".join(a.words for a in asked.attributes)
        meant = [name for name in item.what if may_mean(asked, name, brief)] or [asked.category]
        names = tuple(narrower(name, words) for name in meant)
    if asked.category == "stool" and _is_at_counter(asked, brief):
        names = ("bar_stool",)
    small = small_kind(asked.category)
    if count >= PLENTY and small is not None and least_of(asked, brief):  # many plants are not all tubs on the floor
        return Demand(item, (asked.category, small), count, 0, asked, count, mixed=True)
    return Demand(item, names, count, 0, asked, count)


def _is_at_counter(seat: Entity, brief: SceneGraph) -> bool:
    """Whether seats are told to be at something that is sat at on bar stools."""
    high = {e.id for e in brief.entities if has_role(e.category, "counter")}
    return any(r.subject == seat.id and high & set(r.targets) for r in brief.relations)


@dataclass(frozen=True)
class Limits:
    """How much a room holds: its floor [m2] and the share of it that may be taken, its walls [m], and how much of them.

    What is asked for or needed ends where not even `CRAMMED` would do.
    """

    area: float
    fill: float
    walls: float
    taken: float

    def fits(self, program: Program, one: Wanted, must: bool) -> bool:
        """Whether there is floor and wall for one more thing, which is needed with ``must``."""
        fill, wall = (CRAMMED[0], self.walls * CRAMMED[1]) if must else (self.fill, self.taken)
        if one.footprint <= SMALL:  # a bin or a plant still goes into a room that is full of furniture
            fill, wall = fill + SPARE, wall * (1 + 2 * SPARE)
        floor_fits = one.footprint == 0 or program.footprint + one.footprint <= fill * self.area
        return floor_fits and (one.wall == 0 or program.wall + one.wall <= wall)


def build(
    wishes: Iterable[Demand],
    room_type: RoomType,
    library: Library,
    limits: Limits,
    seed: int,
    palette: Palette,
    pane: tuple[float, float, float] | None = None,
    ceiling: float = 2.6,
) -> Program:
    """Choose bodies for all demands, as long as the floor and the walls have room for them.

    Args:
        wishes: what the room should hold.
        room_type: the kind of room, whose file says what comes first.
        library: where bodies come from.
        limits: how much the room holds.
        seed: decides bodies.
        palette: that of the room.
        pane: width, height and top [m] of the windows, for what hangs before them.
        ceiling: height [m] of the room, for lamps that hang down.
    """
    program, by_item = Program(), dict[str, list[Wanted]]()
    for number, demand in enumerate(sorted(wishes, key=_order(room_type))):
        item, own = demand.item, seed + 101 * number
        parents = _parents(demand, by_item)
        demand = _high_seats(demand, parents)
        # A count that the request gives is that of all together, one of the room's file is for each parent; one thing
        # that is named is not there for each of what the room has by itself.
        ours = item is not None and all(parent is not None and parent.asked is None for parent in parents)
        total = demand.asked is not None and (demand.asked.count is not None or (ours and not is_plural(demand.asked)))
        pieces = demand.count if total else demand.count * len(parents)
        if not pieces:
            continue
        wish, held = _wish(demand, palette, own)
        wish = _sized(demand, wish, held, parents[0], by_item, own, pane, ceiling)
        asked = demand.asked.id if demand.asked else None
        try:
            assets = _bodies(demand, pieces, wish, library)
        except InputError as error:
            program.left_out.append(LeftOut(asked, str(error)))
            continue
        supports = [w for name in (item.on if item else ()) for w in by_item.get(name, ())]
        least = demand.least * (1 if total else len(parents))
        for k, asset in enumerate(assets):
            parent = parents[k % len(parents)] if total else parents[k // demand.count]
            support = supports[k % len(supports)] if supports else None
            own_item = None if demand.mixed and asset.category != demand.categories[0] else item
            one = Wanted(own_item, asset.category, asset, demand.rank, k, parent, support, asked, held=held, wish=wish)
            if not limits.fits(program, one, must=demand.rank <= 1 and k < least):
                program.left_out.append(LeftOut(asked, f"{one.category}: the floor or the walls are full"))
                break
            program.wanted.append(one)
            if own_item is not None:
                by_item.setdefault(own_item.id, []).append(one)
    _name(program.wanted)
    return program


def _parents(demand: Demand, by_item: Mapping[str, Sequence[Wanted]]) -> Sequence[Wanted | None]:
    """What each of a demand goes with: [None] for what stands for itself, nothing where that parent is not there."""
    item = demand.item
    if item is None or item.with_ is None:
        return [None]
    found = [w for w in by_item.get(item.with_, ()) if not item.when or w.category in item.when]
    return found or ([None] if demand.asked is not None else [])


def _high_seats(demand: Demand, parents: Sequence[Wanted | None]) -> Demand:
    """Seats of the room's own at tables that take bar stools, as a high table that is asked for in a bakery."""
    seats = demand.asked is None and "seating" in groups_of(demand.categories[0])
    high = seats and parents and all(p is not None and has_role(p.category, "counter") for p in parents)
    return replace(demand, categories=("bar_stool",)) if high else demand


def _sized(
    demand: Demand,
    wish: Wish,
    held: str | None,
    parent: Wanted | None,
    by_item: Mapping[str, Sequence[Wanted]],
    seed: int,
    pane: tuple[float, float, float] | None,
    ceiling: float,
) -> Wish:
    """A wish with the sizes that follow from the room: from its windows, its ceiling, and what a thing goes with."""
    item = demand.item
    if item is not None and _hangs_at_windows(item) and pane is not None:
        wish = before_window(wish, demand.categories[0], pane, ceiling)
    if demand.categories and wish.size[2] is None and held is None:
        drop = hanging_height(demand.categories[0], ceiling, _hung_over(item, by_item))
        wish = replace(wish, size=(*wish.size[:2], drop)) if drop is not None else wish
    if item is not None and parent is not None:
        wish = replace(wish, size=_around(item, parent.asset.size, wish, seed))
    return wish


def _hung_over(item: Item | None, by_item: Mapping[str, Sequence[Wanted]]) -> float | None:
    """The height [m] of the furniture that lamps of an item hang over; None where that is no table."""
    for place in item.place if item is not None else ():
        under = by_item.get(place.to or "", ()) if place.type in OVER else ()
        if under and is_lit_table(under[0].category, under[0].asset.size[2]):
            return under[0].asset.size[2]
    return None


def free_zones(item: Item | None, obj: SceneObject) -> tuple[Zone, ...]:
    """The zones of an object with what its item keeps free before it here."""
    if item is None or not item.clear:
        return obj.zones
    low = (item.bottom[0] if item.bottom else hung_at(category_named(obj.category))) if obj.mount == "wall" else 0.0
    return cleared(obj.zones, item.clear, obj.size, low)


def _around(
    item: Item, parent: Sequence[float], wish: Wish, seed: int
) -> tuple[float | None, float | None, float | None]:
    """The size [m] of a wish, where it is not given as far as the item reaches beyond what it goes with."""
    rng = random.Random(seed ^ 0xBE)
    depth, width = (
        own if own is not None or more is None else round(side + 2 * rng.uniform(*more), 3)
        for own, side, more in zip(wish.size, parent, item.beyond, strict=False)
    )
    return depth, width, wish.size[2]


def _order(room_type: RoomType):
    """By need, an item never before what it goes with or stands on; then as the room's file has them."""
    at = {item.id: k for k, item in enumerate(room_type.items)}

    def rank(item: Item, own: int) -> int:
        above = [room_type.item(name) for name in ((item.with_,) if item.with_ else ()) + item.on if name in at]
        return max([own, *(rank(a, RANK[a.need]) for a in above)])

    def key(demand: Demand) -> tuple[int, int]:
        if demand.item is None:
            return 1, 1000
        return max(1, rank(demand.item, demand.rank)), at.get(demand.item.id, 1000)

    return key


def suite_of(item: Item | None, seed: int) -> int | None:
    """The number of the suite that an item of a room belongs to, if any; ``seed`` is the room's."""
    return None if item is None or item.suite is None else zlib.crc32(f"{seed}/{item.suite}".encode())


def _wish(demand: Demand, palette: Palette, seed: int) -> tuple[Wish, str | None]:
    """What a body is chosen by, and what holds it where the words say so."""
    item, asked = demand.item, demand.asked
    size: list[float | None] = [None, None, None]
    rng = random.Random(seed)
    look = drawable(demand.categories[0], words_of_whole(asked.attributes)) if asked else Look("")
    if item is not None:
        size = [None if r is None else round(rng.uniform(*r), 3) for r in item.size]
    if asked is not None:
        if any(said is not None for said in look.size):
            size = list(look.size)
        if hung_furniture(demand.categories[0], look.mount) and size[2] is None:
            usual = category_named(demand.categories[0]).size
            assert usual is not None
            size[2] = round(usual.height[0] * HUNG, 3)
        if look.shape in ("round", "square") and look.size[:2] == (None, None):
            size[:2] = [None, None]  # the drawing makes both alike
        size = [a if a is not None else s for a, s in zip(asked.size, size, strict=True)]
        if asked.scale != 1.0 and size == [None, None, None]:
            ranges = category_named(asked.category).size
            if ranges is not None:
                at = min(1.0, max(0.0, 0.5 + 1.5 * (asked.scale - 1.0)))
                # Rounded within the range: the pile of a rug is half a millimetre high.
                size = [min(max(round(lo + at * (hi - lo), 3), lo), hi) for lo, hi in ranges.ranges]
        if "ceiling" in category_named(asked.category).mount:
            size[2] = asked.size[2]  # a huge lamp is wide; how far it hangs down follows from what is below
    wish = Wish(
        size=(size[0], size[1], size[2]),
        color=(asked and asked.color) or look.color or (item and item.color) or None,
        material=look.material or (asked.material if asked else None),
        shape=look.shape,
        parts=look.parts,
        beyond=any(extent is not None for extent in (*look.size, *(asked.size if asked else ())))
        or look.mount is not None,
        style=(asked and asked.style) or palette.style,
        palette=palette.code,
        words=" ".join(asked.words) if asked else "",
        seed=seed,
        count=1,
        suite=suite_of(item, palette.seed),
    )
    return wish, look.mount


def hung_furniture(category: str, mount: str | None) -> bool:
    """Whether a thing that usually stands on the floor is hung on the wall."""
    return mount == "wall" and category_named(category).mount[0] == "floor"


def _bodies(demand: Demand, pieces: int, wish: Wish, library: Library) -> list[Asset]:
    name = demand.categories[0]
    same = demand.item.same if demand.item else True
    if same and not demand.mixed:
        return library.choose(name, pieces, wish)
    out = []
    for k in range(pieces):
        category = demand.categories[k % len(demand.categories)]
        out += library.choose(category, 1, replace(wish, seed=wish.seed + 7 * k))
    return out


def _name(wanted: list[Wanted]) -> None:
    counts: dict[str, int] = {}
    for one in wanted:
        k = counts.get(one.category, 0)
        one.id, counts[one.category] = f"{one.category}-{k}", k + 1
