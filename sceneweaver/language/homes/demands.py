"""``demands``: what a request for a home asks for, each as it is in the finished home: met, partly, not met; and what
was not understood of it."""

from __future__ import annotations

from collections.abc import Iterator

from sceneweaver.home import Home
from sceneweaver.plans import room_types

from .areas import CLEARLY
from .measured import WALL, MeasuredHome
from .model import HomeDemand, HomeRequest, JointAsked, Status
from .places import group_of, place, room_of
from .things import things

DOOR, CORRIDOR = 0.85, 1.2
"""Least clear widths [m] of doors and of ways in an accessible home."""

CLOSE, FAR = 0.05, 0.12
"""Shares by which an area may be off to be met, and partly met."""

EVEN = 0.005
"""Floor [m2] below what is written of an area."""

NEARBY = 2.0
"""Distance [m] up to which rooms are partly near each other."""


def demands(request: HomeRequest, home: Home) -> list[HomeDemand]:
    """What is asked for, as measured in a home: numbers and areas of rooms, doors, storeys, widths, light, things; then
    each phrase that was not understood, in the words of the request.

    What was assumed is no demand. The home is measured by itself: rooms are counted by their types, joined by its
    doors, and as far apart as their outlines are. Rooms are those of the same id; in a home that has none of that id,
    those of the type that suit best.

    Args:
        request: as read.
        home: planned; things in rooms are looked for where rooms are furnished.

    Examples:
        >>> import sceneweaver as sw
        >>> from sceneweaver.language.homes import demands, read_home
        >>> home = sw.Home.example("flat")
        >>> [(d.words, d.status) for d in demands(read_home("a two-bedroom flat on two floors"), home)]
        [('2 to sleep in', 'met'), ('2 storeys', 'not met')]
    """
    measured = MeasuredHome(home)
    return [
        *_counts(request, measured),
        *_areas(request, measured),
        *(_joint(joint, request, measured) for joint in request.joints),
        *_outside(request, measured),
        *_storeys(request, measured),
        *_profile(request, measured),
        *_envelope(request, measured),
        *_light(request, measured),
        *_excluded(request, measured),
        *things(request, measured),
        *(HomeDemand("words", one.words, "not understood", "nothing was made of it") for one in request.unread),
    ]


def _status(met: bool, partly: bool = False) -> Status:
    return "met" if met else "partly" if partly else "not met"


def _counts(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    asked: dict[str, int] = {}
    for type_, count in request.counts:
        asked[group_of(type_)] = asked.get(group_of(type_), 0) + count
    for group, count in asked.items():
        have = sum(group_of(room.type) == group for room in measured.home.rooms)
        name = {"sleeping": "to sleep in", "bathing": "to bathe in"}.get(group, group.replace("_", " "))
        yield HomeDemand("count", f"{count} {name}", _status(have == count, have > 0), f"{have} of {count}")


def _areas(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    yield from _limits("area", "in all", measured.total, request.least, request.most)
    if request.area is not None and request.least is None and request.most is None:
        off = abs(measured.total - request.area) / request.area
        yield HomeDemand(
            "area", f"{request.area:g} m2 in all", _status(off <= CLOSE, off <= FAR), f"{measured.total:.1f} m2"
        )
    for room in request.rooms:
        there = place(room.id, request, measured)
        if there is None or there.type not in room_types():
            if room.area is not None or room.size:
                yield HomeDemand("room_area", f"{room.id}: its area", "not met", "there is no such room")
            continue
        area = measured.area(there)
        if room.least is not None or room.most is not None:
            yield from _limits("room_area", room.id, area, room.least, room.most)
        elif room.area is not None:
            low, high = room.area
            met = low * (1 - CLOSE) <= area <= high * (1 + CLOSE)
            text = f"{room.id}: {low:g} m2" if low == high else f"{room.id}: {low:g} to {high:g} m2"
            yield HomeDemand(
                "room_area", text, _status(met, low * (1 - FAR) <= area <= high * (1 + FAR)), f"{area:.1f} m2"
            )
        elif room.size:
            usual = room_types()[there.type].area[1]
            more = area / usual if room.size == "big" else usual / area
            yield HomeDemand(
                "room_area",
                f"{room.id}: {room.size}",
                _status(more >= CLEARLY - 0.01, more >= 1.0),
                f"{area:.1f} m2, usual are {usual:g}",
            )


def _limits(kind: str, of: str, area: float, least: float | None, most: float | None) -> Iterator[HomeDemand]:
    """A floor that is not to be gone above or below, which has no play."""
    for limit, words, met in (
        (least, "at least", least is None or area >= least - EVEN),
        (most, "at most", most is None or area <= most + EVEN),
    ):
        if limit is not None:
            text = f"{words} {limit:g} m2 {of}" if of == "in all" else f"{of}: {words} {limit:g} m2"
            yield HomeDemand(kind, text, _status(met), f"{area:.2f} m2")


def _joint(joint: JointAsked, request: HomeRequest, measured: MeasuredHome) -> HomeDemand:
    if joint.place in ("front", "back"):
        return _to_side(joint, request, measured)
    if joint.how == "not through":
        return _not_through(joint, request, measured)
    if joint.place:
        return _to_entrance(joint, request, measured)
    pairs = list(zip(joint.a, joint.b, strict=True))
    found = [_best_pair(joint.how or joint.kind, a, b, request, measured) for a, b in pairs]
    met, near = sum(f[0] for f in found), sum(f[1] for f in found)
    words = f"{', '.join(dict.fromkeys(joint.a))} {joint.words} {', '.join(dict.fromkeys(joint.b))}"
    return HomeDemand(
        "joint",
        f"{joint.how or joint.kind}: {words}",
        _status(met == len(pairs), met + near > 0),
        "; ".join(f[2] for f in found),
    )


def _best_pair(kind: str, a: str, b: str, request: HomeRequest, measured: MeasuredHome) -> tuple[bool, bool, str]:
    """A pair of rooms by their ids; where the home has none of these, the pair of their types that suits best."""
    both = room_of(measured, a) is not None and room_of(measured, b) is not None
    groups = [group_of(request.programme.room(name).type) for name in (a, b)]
    ones, twos = ([a], [b]) if both else ([r.id for r in measured.home.rooms if group_of(r.type) == g] for g in groups)
    found = [_pair(kind, one, two, measured) for one in ones for two in twos if one != two]
    if not found:
        return False, False, f"no {groups[0]} and {groups[1]}".replace("_", " ")
    return (min if kind == "apart" else max)(found, key=lambda one: one[:2])


def _pair(kind: str, a: str, b: str, measured: MeasuredHome) -> tuple[bool, bool, str]:
    """Whether two rooms are to each other as is asked, whether nearly, and how they are."""
    joined, gap = measured.joined(a, b), measured.gap(a, b)
    how = (
        "open"
        if measured.open(a, b)
        else "a door"
        if joined
        else "on different storeys"
        if gap is None
        else f"{gap:.2f} m apart"
    )
    beside = gap is not None and gap <= WALL
    if kind == "open":
        return measured.open(a, b), joined, how
    if kind == "door":
        return joined, beside, how
    if kind == "opposite":
        between = measured.opposite(a, b)
        return bool(between), joined or beside or gap is not None and gap <= NEARBY, between or how
    if kind == "near":
        return joined or beside, gap is not None and gap <= NEARBY, how
    return not joined and not beside, not joined, how


def _to_side(joint: JointAsked, request: HomeRequest, measured: MeasuredHome) -> HomeDemand:
    """Rooms at the front, where the entrance is, or at the back."""
    found = dict[str, bool]()
    for name in joint.a:
        room = place(name, request, measured)
        found[name] = room is not None and measured.at_side(room, joint.place) != (joint.kind == "apart")
    sides = {True: "it is", False: "it is not"}
    detail = "; ".join(f"{name}: {sides[met]}" for name, met in found.items())
    words = f"{', '.join(joint.a)} {'not ' * (joint.kind == 'apart')}at the {joint.place} ({joint.words})"
    return HomeDemand("joint", words, _status(all(found.values()), any(found.values())), detail)


def _not_through(joint: JointAsked, request: HomeRequest, measured: MeasuredHome) -> HomeDemand:
    """Whether one gets to rooms without others on the way."""
    ends = [(place(a, request, measured), place(b, request, measured)) for a, b in zip(joint.a, joint.b, strict=True)]
    free = [a is not None and (b is None or a.id in measured.reached_without(b.id)) for a, b in ends]
    words = f"{', '.join(dict.fromkeys(joint.a))} {joint.words} {', '.join(dict.fromkeys(joint.b))}"
    return HomeDemand(
        "joint", f"not through: {words}", _status(all(free)), "another way" if all(free) else "no other way"
    )


def _to_entrance(joint: JointAsked, request: HomeRequest, measured: MeasuredHome) -> HomeDemand:
    steps = measured.steps_from_entrance()
    there = {name: place(name, request, measured) for name in joint.a}
    found = {name: steps.get(room.id) if room is not None else None for name, room in there.items()}
    words = f"{', '.join(joint.a)} {joint.words} the {joint.place}"
    detail = "; ".join(
        f"{name} {'cannot be reached' if n is None else f'behind {n} doors'}" for name, n in found.items()
    )
    far = [n is not None and n >= 2 for n in found.values()]
    near = [n is not None and n <= 1 for n in found.values()]
    good = far if joint.kind == "apart" else near
    return HomeDemand("joint", f"{joint.kind}: {words}", _status(all(good), any(good)), detail)


def _outside(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    for room in request.rooms:
        there = place(room.id, request, measured)
        if room.outside:
            doors = measured.home.doors
            has = there is not None and any(door.room == there.id and door.to is None for door in doors)
            yield HomeDemand("outside", f"{room.id}: a door outside", _status(has), "a door" if has else "none")


def _storeys(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    have = len({room.storey for room in measured.home.rooms})
    if request.storeys is not None:
        yield HomeDemand(
            "storeys",
            f"{request.storeys} storey{'s' * (request.storeys > 1)}",
            _status(have == request.storeys),
            f"{have}",
        )
    for room in request.rooms:
        there = place(room.id, request, measured)
        if room.storey is not None:
            level = measured.level(there) if there is not None else None
            yield HomeDemand(
                "storey",
                f"{room.id} on storey {room.storey}",
                _status(level == room.storey),
                f"on {level}" if there is not None else "no such room",
            )


def _profile(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    accessible = request.profile == "accessible"
    doors, corridors = (
        max(asked or 0.0, usual if accessible else 0.0)
        for asked, usual in ((request.doors, DOOR), (request.ways, CORRIDOR))
    )
    if doors:
        widths = measured.door_widths()
        wide = sum(width >= doors - 1e-6 for width in widths)
        yield HomeDemand(
            "profile",
            f"doors of {doors:g} m",
            _status(wide == len(widths), 2 * wide > len(widths)),
            f"{wide} of {len(widths)}, least {min(widths, default=0):.2f} m",
        )
    ways = [measured.narrowest(room) for room in measured.of_role("circulation") if room.type != "stairs"]
    if ways and corridors:
        yield HomeDemand(
            "profile",
            f"ways of {corridors:g} m",
            _status(min(ways) >= corridors - 0.02, max(ways) >= corridors),
            f"least {min(ways):.2f} m",
        )
    if not accessible:
        return
    baths = measured.of_role("sanitary")
    turning = [room.id for room in baths if measured.turns(room)]
    yield HomeDemand(
        "profile", "a bathroom or toilet to turn in", _status(bool(turning)), ", ".join(turning) or "none of 1.5 m"
    )
    if len(measured.home.storeys) > 1 and request.use in ("flat", "house", "care_home"):
        low = [room for room in measured.home.rooms if measured.level(room) == 0]
        beds = [room for room in measured.of_role("sleeping") if room in low]
        wet = [room for room in baths if room in low]
        yield HomeDemand(
            "profile",
            "bed and bath without stairs",
            _status(bool(beds and wet), bool(beds or wet)),
            f"{len(beds)} bedrooms and {len(wet)} bathrooms on the ground floor",
        )


def _envelope(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    asked = [side for side in (request.width, request.depth) if side is not None]
    if asked:
        sides = measured.sides()
        off = min(max(abs(one - two) for one, two in zip(asked, order, strict=False)) for order in (sides, sides[::-1]))
        yield HomeDemand(
            "envelope",
            " x ".join(f"{side:g}" for side in asked) + " m",
            _status(off <= 0.05, off <= 0.5),
            f"{sides[0]:g} x {sides[1]:g} m",
        )
    if request.l_shape:
        share = measured.fills_rectangle()
        yield HomeDemand("envelope", "L-shaped", _status(share <= 0.96), f"fills {share:.0%} of its rectangle")
    if request.window_sides is not None:
        have = len(measured.window_directions())
        yield HomeDemand(
            "envelope",
            f"windows on {request.window_sides} sides",
            _status(0 < have <= request.window_sides),
            f"on {have}",
        )


def _light(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    for room in request.rooms:
        there = place(room.id, request, measured)
        if room.daylight is not None:
            lit = measured.lit(there) if there is not None else None
            words = "with" if room.daylight else "without"
            yield HomeDemand(
                "light", f"{room.id} {words} windows", _status(lit == room.daylight), "a window" if lit else "none"
            )


def _excluded(request: HomeRequest, measured: MeasuredHome) -> Iterator[HomeDemand]:
    for type_ in request.excluded:
        kin = {"hallway": {"hallway", "corridor"}}.get(type_, {type_})
        have = sum(room.type in kin for room in measured.home.rooms)
        yield HomeDemand("excluded", f"no {type_.replace('_', ' ')}", _status(have == 0), f"{have}")
