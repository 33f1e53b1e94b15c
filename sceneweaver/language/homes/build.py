"""From resolved rooms to the programme of a plan: storeys, areas, what lies next to what, the entrance."""

from __future__ import annotations

from sceneweaver.plans import Adjacency, Programme, RoomSpec, room_type

from .lexicon import data
from .model import JointAsked
from .needed import add_landings
from .parts import Joint, Named, Reading
from .relations import apart_from_people
from .resolve import Room, bedroomlike

SOFT = 2.0
"""Weight of near and apart, which are no more than wished."""

_SIDES = {"garden": "back", "back": "back", "front": "front"}
"""Sides of the home by the places that rooms are told to lie at, which are measured and not planned."""

_ORDER = {"open": 0, "door": 1, "near": 2, "apart": 3}


def storeys_of(reading: Reading, rooms: list[Room]) -> tuple[int, dict[str, int | None]]:
    """How many storeys there are, and on which each room is told to be."""
    level = {"ground": 0, "first": 1, "second": 2, "third": 3}
    told = [room.storey for room in rooms if room.storey]
    told += [storey for storey in (reading.sleep_storey, reading.live_storey) if storey]
    least = 1 + max([level[s] for s in told if s in level], default=0)
    if {"first", "top"} <= {*told} and not reading.storeys:
        least = max(least, 3)  # two storeys that are not the ground floor
    upper = any(s in ("upper", "top") for s in told)
    asked = reading.storeys or (1 if reading.one_storey else None)
    if asked is None and (reading.share_ground or "ground" in told) and reading.use.plan == "house":
        upper = True
    count = max(asked or 1, least, 2 if upper and not reading.one_storey else 1)
    if (
        reading.use.plan in ("flat", "office")
        and asked is None
        and set(told) <= {"first", "second", "third", "ground"}
        and len(set(told)) <= 1
    ):
        count = 1  # where the flat is in its building
    count = min(count, 6)
    place = {**level, "top": count - 1, "upper": 1}
    return count, {room.id: min(place[room.storey], count - 1) if room.storey and count > 1 else None for room in rooms}


def place_rooms(reading: Reading, rooms: list[Room], count: int, placed: dict[str, int | None]) -> list[str]:
    """Storeys for rooms of which none is told: the bedroom of who is old or in a wheelchair and a bathroom on the
    ground floor, en-suites with their bedrooms; adds landings."""
    said: list[str] = []
    if count == 1:
        return said
    level = {"ground": 0, "upper": 1, "first": 1, "second": min(2, count - 1), "third": min(3, count - 1)}
    for storey, belongs in ((reading.sleep_storey, _sleeps), (reading.live_storey, _lives)):
        if storey is not None:
            high = level.get(storey, count - 1)
            placed |= {room.id: high for room in rooms if placed.get(room.id) is None and belongs(room)}
    if reading.accessible:
        beds = [room for room in rooms if bedroomlike(room.kind)]
        first = next((r for r in beds if r.kind.name == "senior_bedroom"), beds[0] if beds else None)
        bath = next((r for r in rooms if r.counts_as("bathroom") and r.kind.name != "ensuite"), None)
        for room in (first, bath):
            if room is not None and placed.get(room.id) is None:
                placed[room.id] = 0
                said.append(f"{room.id} on the ground floor: for who cannot climb stairs")
    for joint in reading.joints:
        if joint.kind != "apart" and isinstance(joint.b, Named):
            for a, b in pairs_of(joint):
                if placed.get(a) is None and placed.get(b) is not None:
                    placed[a] = placed[b]
                elif placed.get(b) is None and placed.get(a) is not None:
                    placed[b] = placed[a]
    living = ("living_room", "kitchen", "living_kitchen", "living_dining", "kitchen_diner", "dining_room")
    if reading.share_ground:
        placed |= {room.id: 0 for room in rooms if room.type in living and placed.get(room.id) is None}
    _bathrooms(reading, rooms, count, placed)
    said += add_landings(rooms, count, placed) if count > 1 and any(v for v in placed.values()) or count > 1 else []
    return said


def _sleeps(room: Room) -> bool:
    return bedroomlike(room.kind)


def _lives(room: Room) -> bool:
    """Whether a room is one that a flat has: to sleep, to live, to cook, to wash in."""
    return bool(room_type(room.type).roles & {"sleeping", "living", "cooking", "eating", "sanitary"})


def _bathrooms(reading: Reading, rooms: list[Room], count: int, placed: dict[str, int | None]) -> None:
    """Bathrooms that all share lie where bedrooms are: the first upstairs, one on each storey as far as they go."""
    if reading.use.plan != "house":
        return
    shared = [r for r in rooms if r.counts_as("bathroom") and not any(one.per is not None for one in r.named)]
    shared = [r for r in shared if r.kind.name != "ensuite"]
    taken = {placed[r.id] for r in shared if placed.get(r.id) is not None}
    beds = {placed.get(r.id) for r in rooms if bedroomlike(r.kind)}
    free = [s for s in (*range(1, count), 0) if s not in taken and (None in beds or s in beds)]
    for room, storey in zip([r for r in shared if placed.get(r.id) is None], free, strict=False):
        placed[room.id] = storey


def pairs_of(joint: Joint) -> list[tuple[str, str]]:
    """The pairs of rooms that a joint is about."""
    if not isinstance(joint.b, Named):
        return []
    a, b = joint.a.ids, joint.b.ids
    if not a or not b:
        return []
    if joint.a is joint.b or joint.a.root is joint.b.root and a == b:
        return [(a[i], a[k]) for i in range(len(a)) for k in range(i + 1, len(a))]
    if joint.how == "opposite" and len(a) < len(b):
        return [(x, next((y for y in b if y != x), x)) for x in a]
    if joint.kind == "apart" or joint.how:
        return [(x, y) for x in a for y in b if x != y]
    if len(a) == len(b):
        return [(x, y) for x, y in zip(a, b, strict=True) if x != y]
    if joint.a.per is not None and len(a) % len(b) == 0:
        return [(x, b[i // (len(a) // len(b))]) for i, x in enumerate(a)]
    if len(a) == 1:
        return [(a[0], y) for y in (b if joint.each or joint.kind == "near" else b[:1]) if y != a[0]]
    if len(b) == 1:
        return [(x, b[0]) for x in a if x != b[0]]
    return [(x, b[i % len(b)]) for i, x in enumerate(a) if x != b[i % len(b)]]


def joined(
    reading: Reading, rooms: list[Room], entrance: str, notes: list[str]
) -> tuple[list[Adjacency], list[JointAsked]]:
    """What was said of rooms to each other, as adjacencies of ids: what is open or a door has to be, near and apart are
    wished; by the entrance is what has a door to the room that one comes into."""
    found: dict[frozenset[str], Adjacency] = {}
    asked: list[JointAsked] = []
    for joint in sorted(reading.joints, key=lambda j: _ORDER[j.kind]):
        words = reading.text[joint.span.start : joint.span.end]
        if isinstance(joint.b, str):
            place = "front" if (joint.b, joint.kind) == ("street", "near") else _SIDES.get(joint.b, joint.b)
            pairs = [] if place in ("front", "back") else _to_place(joint, entrance, notes)
            if joint.a.ids:
                asked.append(JointAsked(tuple(joint.a.ids), (), joint.kind, words, place))
        else:
            pairs = pairs_of(joint)
            if pairs:
                ends = tuple(a for a, _ in pairs), tuple(b for _, b in pairs)
                asked.append(JointAsked(*ends, joint.kind, words, how=joint.how))
            else:
                _lost(reading, joint)
            pairs = [] if joint.how == "not through" else pairs
        for a, b in pairs:
            key = frozenset((a, b))
            if len(key) == 2 and key not in found:
                hard = joint.kind in ("door", "open") and joint.hard and _may_join(a, b, rooms)
                at_entrance = joint.b == "entrance" and joint.kind == "near"
                kind = "door" if at_entrance else joint.kind
                weight = 1.0 if hard else 2 * SOFT if at_entrance else SOFT
                found[key] = Adjacency(a=a, b=b, kind=kind, hard=hard, weight=weight)
    for one in reading.named:
        pairs = apart_from_people(one.ids, {r.id: room_type(r.type).roles for r in rooms}) if one.alone else []
        if one.alone is not None and pairs:
            words = reading.text[one.alone.start : one.alone.end]
            asked.append(JointAsked(tuple(a for a, _ in pairs), tuple(b for _, b in pairs), "apart", words))
        for a, b in pairs:
            found.setdefault(frozenset((a, b)), Adjacency(a=a, b=b, kind="apart", hard=False, weight=SOFT))
    return _with_ways(list(found.values()), rooms), asked


def _with_ways(found: list[Adjacency], rooms: list[Room]) -> list[Adjacency]:
    """Adjacencies with a door to a hall for each annex whose own doors lead into rooms that are no way: so that these
    doors can be had, and the annex be entered besides."""
    kinds = {room.id: room_type(room.type) for room in rooms}
    halls = [i for i, kind in kinds.items() if "circulation" in kind.roles and "stairs" not in kind.roles]
    hall = halls[0] if halls and not any(room.storey for room in rooms) else None
    for name, kind in kinds.items():
        own = [x for x in found if x.kind == "door" and name in (x.a, x.b)]
        others = [kinds[x.b if x.a == name else x.a] for x in own]
        if hall is None or "annex" not in kind.roles or not own or kind.transit != "none":
            continue
        if all(other.transit == "none" and "annex" not in other.roles for other in others):
            found = [x.model_copy(update={"hard": True, "weight": 1.0}) if x in own else x for x in found]
            found.append(Adjacency(a=name, b=hall, kind="door"))
    return found


def _may_join(a: str, b: str, rooms: list[Room]) -> bool:
    """Whether a door between two rooms may be the way to one of them, or one door more than they need; a room that is
    entered by the door that it asks for has no other."""
    kinds = [room_type(room.type) for room in rooms if room.id in (a, b)]
    return any(kind.transit != "none" for kind in kinds) or not any("annex" in kind.roles for kind in kinds)


def _lost(reading: Reading, joint: Joint) -> None:
    """What is said of rooms that are not there has led to nothing."""
    for token in reading.tokens:
        if joint.span.start <= token.span.start < joint.span.end:
            token.done = ""


def _to_place(joint: Joint, entrance: str, notes: list[str]) -> list[tuple[str, str]]:
    """The entrance is a room's."""
    if joint.b == "street":
        notes.append("sides of the street are not planned: what is to be far from it lies apart from the entrance")
    return [(i, entrance) for i in joint.a.ids if i != entrance]


def entrance_of(reading: Reading, rooms: list[Room], placed: dict[str, int | None]) -> str:
    """The room that one comes into first."""
    beside = [i for j in reading.joints if j.b == "entrance" and j.kind != "apart" for i in j.a.ids]
    ground = [room for room in rooms if not placed.get(room.id)]
    halls = [room for room in ground if room.type in ("entrance_hall", "vestibule")]
    if halls:
        return halls[0].id
    for room in ground:
        if room.id in beside and room.type in data("words")["comes_in"]:
            return room.id
    for kind in data("words")["comes_in"]:
        for room in ground:
            if room.type == kind:
                return room.id
    usable = [room for room in ground if room_type(room.type).transit == "all"]
    return (usable or ground or rooms)[0].id


def programme_of(
    reading: Reading,
    rooms: list[Room],
    count: int,
    placed: dict[str, int | None],
    entrance: str,
    adjacencies: list[Adjacency],
) -> Programme:
    """The programme of the plan."""
    daylight: dict[str, bool] = {}
    for room in rooms:
        for one in room.named:
            if one.daylight is not None:
                daylight[room.id] = one.daylight
    specs = [
        RoomSpec(
            id=room.id,
            type=room.type,
            area=room.area or room_type(room.type).area,
            side=next((one.side for one in room.named if one.side is not None), None),
            storey=placed.get(room.id),
            daylight=daylight.get(room.id),
        )
        for room in rooms
    ]
    return Programme(
        name=f"{reading.use.name}, {len(rooms)} rooms",
        use=reading.use.plan,
        rooms=tuple(specs),
        adjacencies=tuple(adjacencies),
        storeys=count,
        entrance=entrance,
    )
