"""What furniture needs of a plan, before it is drawn and after: least floors and sides of rooms, walls long enough.

Sizes are the least of what the knowledge base says that a kind of room needs on the smallest floor: a bath has a
shower, a living room a sofa, a television and the distance between. A plan is asked for that much from the start. Where
a room of it still cannot be furnished, the programme asks for more of that room, and the plan is solved again.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from sceneweaver.assets.taxonomy import category_named
from sceneweaver.home import Home
from sceneweaver.knowledge import Item, RoomType
from sceneweaver.knowledge.kin import excluded_kinds
from sceneweaver.knowledge.small_floors import on_floor
from sceneweaver.language import SceneGraph, read_request
from sceneweaver.plans import Programme, RoomSpec
from sceneweaver.scene import Room

from .kinds import kind_of

WAY = 0.6
"""Floor [m] before a piece where its category says nothing."""

LEAF = 0.5
"""Floor [m2] over which the leaf of the door swings, as far as nobody would walk there anyway."""

NO_TABLE = "a kitchen without a dining table"
"""What a kitchen is to hold where another room is for meals."""

CHOICE = 1.2
"""Most by least floor of a room whose size nobody asked for."""

MORE, WIDER = 1.18, 0.15
"""Factor on the floor of a room that could not be furnished, and how much [m] wider it has to be."""

CORNER = 0.05
"""Wall [m] that stays free at either end of a stretch."""


@dataclass(frozen=True)
class Needs:
    """What the furniture of a room needs.

    Attributes:
        area: floor [m2].
        side: least clear width [m].
        walls: lengths of wall [m] that stand in one piece, the longest first.
    """

    area: float
    side: float
    walls: tuple[float, ...] = ()


def needs_of(kind: RoomType, brief: SceneGraph | None = None) -> Needs:
    """What a kind of room needs at least, and what a request for it names besides.

    Examples:
        >>> from sceneweaver.furnish.demands import needs_of
        >>> from sceneweaver.furnish.kinds import kind_of
        >>> needs = needs_of(kind_of("bedroom"))
        >>> needs.area > 5, 2.0 < needs.side < 2.8, needs.walls[0] > 1.8
        (True, True, True)
    """
    small = on_floor(kind, 0.0)
    unwanted = excluded_kinds(brief.without) if brief is not None else frozenset[str]()
    gone = {item.id for item in small.items if unwanted >= {*item.what}}
    needed = [i for i in small.items if i.need == "needed" and _stands(i) and not gone & {i.id, i.with_}]
    floor = sum(item.count.least * _footprint(item) for item in needed)
    side, walls = 0.0, list[float]()
    for item in needed:
        depth, width = _size(item)
        if item.with_ is None:
            beside = sum(2 * _size(other)[1] for other in needed if other.with_ == item.id and _flanks(other))
            apart = [depth + least + _size(small.item(name))[0] for name, least in _facing(item, small)]
            side = max([side, min(width + beside, depth + _front(item)), *apart])
            if any(p.type == "against_wall" and not p.soft for p in item.place) and item.row != "run":
                walls.append(width + beside)
    run = [_size(item)[1] for item in needed if item.row == "run"]
    walls += [max(run)] if run else []
    known = {name for item in small.items for name in item.what}
    for asked in brief.entities if brief is not None else ():
        size = category_named(asked.category).size
        if size is not None and category_named(asked.category).mount[0] == "floor" and asked.category not in known:
            (depth, _), (width, _) = size.ranges[:2]
            floor += (asked.count[0] if asked.count is not None else 1) * depth * width
    return Needs(
        round(floor / kind.fill + LEAF, 2), round(side, 2), tuple(sorted((round(w, 2) for w in walls), reverse=True))
    )


def furnishable(
    programme: Programme, requests: Mapping[str, str] | None = None, asked: Collection[str] | None = None
) -> tuple[Programme, tuple[str, ...]]:
    """The programme with least floors and sides that its rooms' furniture fits in, and what was raised.

    What a room is asked to have at most stays as it is; ``asked`` are the ids of rooms whose area was asked for, None:
    all. The most of another room gives way, so that a plan is left some choice.
    """
    rooms, said = list[RoomSpec](), list[str]()
    elsewhere = any("eating" in spec.kind.roles for spec in programme.rooms)
    for spec in programme.rooms:
        kind = kind_of(spec.type)
        if kind is None:
            rooms.append(spec)
            continue
        usual = NO_TABLE if elsewhere and kind.name == "kitchen" else None
        text = (requests or {}).get(spec.id, usual)
        needs = needs_of(kind, read_request(text) if text else None)
        least, target, most = spec.area
        if asked is not None and spec.id not in asked and needs.area > least:
            most = max(most, round(CHOICE * needs.area, 2))
        area = min(max(least, needs.area), most)
        had = spec.side if spec.side is not None else spec.kind.side
        side = min(max(had, needs.side), most**0.5)
        if area > least + 1e-6 or side > had + 1e-6:
            said.append(f"{spec.id}: at least {area:.1f} m2 and {side:.2f} m wide, for its furniture")
            rooms.append(_respecified(spec, (area, max(target, area), most), side))
        else:
            rooms.append(spec)
    return with_rooms(programme, rooms), tuple(said)


def raised(programme: Programme, names: Iterable[str]) -> tuple[Programme, tuple[str, ...]]:
    """The programme that asks for more of the rooms of these ids, and what it asks for."""
    wanted, rooms, said = {*names}, list[RoomSpec](), list[str]()
    for spec in programme.rooms:
        if spec.id not in wanted:
            rooms.append(spec)
            continue
        least, target, most = spec.area
        area = (round(least * MORE, 2), round(max(target, least) * MORE, 2), round(most * MORE, 2))
        had = spec.side if spec.side is not None else spec.kind.side
        side = round(min(had + WIDER, 0.9 * area[0] ** 0.5), 2)
        rooms.append(_respecified(spec, area, max(side, had)))
        said.append(
            f"{spec.id}: at least {area[0]:.1f} m2 and {max(side, had):.2f} m wide, as its furniture had no place"
        )
    return with_rooms(programme, rooms), tuple(said)


def with_rooms(programme: Programme, rooms: Iterable[RoomSpec]) -> Programme:
    """The programme with other rooms, checked as a new one."""
    fields = {name: getattr(programme, name) for name in type(programme).model_fields}
    return type(programme)(**{**fields, "rooms": tuple(rooms)})


def short_walls(home: Home) -> dict[str, float]:
    """By id of the rooms of a plan, how much wall [m] their needed furniture lacks; those that lack none left out.

    Each piece takes one stretch of wall between doors and corners, the longest piece first; what stands before a door
    as its leaf swings in is no stretch.
    """
    found: dict[str, float] = {}
    for room in home.rooms:
        kind = kind_of(room.type)
        if kind is None:
            continue
        lack, free = 0.0, sorted(_stretches(home.shell(room.id)), reverse=True)
        for wall in needs_of(kind).walls:
            fits = [length for length in free if length >= wall]
            if not fits:
                lack += wall - max(free, default=0.0)
                continue
            free.remove(min(fits))
            free.append(min(fits) - wall)
        if lack > 1e-6:
            found[room.id] = round(lack, 3)
    return found


def _stretches(shell: Room) -> list[float]:
    """Lengths [m] of the walls of a room between doors and leaves that swing along them."""
    found: list[float] = []
    walls = shell.walls
    for wall in walls:
        taken = [(d.offset, d.offset + d.width) for d in shell.doors if d.wall == wall.index]
        for door in shell.doors:
            if not door.swing.startswith("in"):
                continue
            length = walls[door.wall].length
            if (door.wall + 1) % len(walls) == wall.index and length - door.offset - door.width < WAY:
                taken.append((0.0, door.width))  # the leaf swings along the next wall
            if (wall.index + 1) % len(walls) == door.wall and door.offset < WAY:
                taken.append((wall.length - door.width, wall.length))
        at = CORNER
        for low, high in [*sorted(taken), (wall.length - CORNER, wall.length)]:
            found.append(max(0.0, low - at))
            at = max(at, high)
    return found


def _respecified(spec: RoomSpec, area: tuple[float, float, float], side: float) -> RoomSpec:
    fields = {name: getattr(spec, name) for name in type(spec).model_fields}
    return type(spec)(**{**fields, "area": area, "side": round(side, 2)})


def _stands(item: Item) -> bool:
    return (item.mount or category_named(item.what[0]).mount[0]) == "floor" and category_named(
        item.what[0]
    ).size is not None


def _size(item: Item) -> tuple[float, float]:
    """Least depth and width [m] of the smallest thing that serves."""
    sizes = []
    for name in item.what:
        size = category_named(name).size
        if size is not None:
            known = size.ranges[:2]
            depth, width = (
                own[0] if own is not None else usual[0] for own, usual in zip(item.size[:2], known, strict=True)
            )
            sizes.append((depth * width, depth, width))
    _, depth, width = min(sizes)
    return depth, width


def _footprint(item: Item) -> float:
    depth, width = _size(item)
    return depth * width * (0.5 if item.with_ is not None and "chair" in item.what[0] else 1.0)


def _front(item: Item) -> float:
    """Floor [m] to keep free before a piece."""
    return max(WAY, item.clear.get("front", 0.0), category_named(item.what[0]).clearance.get("front", 0.0))


def _flanks(item: Item) -> bool:
    return item.count.least > 1 and any(p.type == "leftright_to_leftright" for p in item.place)


def _facing(item: Item, kind: RoomType) -> Iterator[tuple[str, float]]:
    """The needed items that it stands before, each with the least distance [m] between them."""
    for place in item.place:
        least = float(place.params.get("min") or 0.0)
        if place.type == "distance" and not place.soft and place.to is not None and least > 0:
            other = next((i for i in kind.items if i.id == place.to), None)
            if other is not None and other.need == "needed":
                yield place.to, least
