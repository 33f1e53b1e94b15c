"""A programme whose areas leave room for the hard rows of a profile: a default gives way to a row, what was asked for
to the nearest value that a plan can have."""

from __future__ import annotations

from collections.abc import Collection

from .profile import Profile
from .programme import Programme
from .room_specs import RoomSpec
from .solve_problem import ACCESSIBLE_TOILET, Rows, accessible_toilet

ROOM = 1.25
"""Most floor by the least that a row asks for, of a room whose size is a default."""

NARROW = 1.1
"""Most by least floor under which a default leaves a plan too little choice."""

EXACT = 1.05
"""Most floor by the least that a row asks for, of a room whose size was asked for."""


def feasible(
    programme: Programme, profile: Profile | str = "base", asked: Collection[str] = ()
) -> tuple[Programme, tuple[str, ...]]:
    """The programme with areas that the hard rows of a profile allow, and a line for each area that gave way.

    Areas of rooms that are defaults grow as far as a row asks. Those of rooms in ``asked`` become the nearest that the
    row allows. A programme that contradicts no row stays as it is.

    Args:
        programme: as read or given.
        profile: rules, or the name of those that ship with the library.
        asked: ids of rooms whose area was asked for.

    Examples:
        >>> from sceneweaver.plans import Programme, feasible
        >>> programme = Programme.from_graph(
        ...     {"hall": "entrance_hall", "office": "private_office", "toilet": ("washroom", 3)},
        ...     [("hall", "office"), ("hall", "toilet")],
        ...     use="office",
        ... )
        >>> wide, told = feasible(programme, "accessible")
        >>> wide.room("toilet").area, told
        ((5.0, 5.0, 6.25), ('toilet: at least 5 m2 and not at most 3.9, as the rules of accessible ask',))
    """
    rules = Profile.of(profile)
    rows = Rows(rules, programme.use)
    toilet = accessible_toilet(programme.with_storeys(), rows)
    rooms, told = list[RoomSpec](), list[str]()
    for room in programme.rooms:
        needed = _least(room, rows)
        if toilet is not None and room.id == toilet.id:
            needed = max(needed, ACCESSIBLE_TOILET)
        fixed = room.id in asked
        least, target, most = room.area
        if most < needed:
            told.append(f"{room.id}: at least {needed:g} m2 and not at most {most:g}, as the rules of {rules.name} ask")
            least, most = needed, round(needed * (EXACT if fixed else ROOM), 2)
        elif not fixed and most < NARROW * max(least, needed):
            most = round(NARROW * max(least, needed), 2)
        area = (least, min(max(target, least), most), most)
        rooms.append(room if area == room.area else room.model_copy(update={"area": area}))
    if all(new is old for new, old in zip(rooms, programme.rooms, strict=True)):
        return programme, ()
    return programme.model_copy(update={"rooms": tuple(rooms)}), tuple(told)


def totalled(
    programme: Programme, total: float, asked: Collection[str] = (), profile: Profile | str = "base"
) -> Programme:
    """The programme whose rooms indoors have a floor together, or the nearest that their bounds allow.

    Targets move between least and most floor, all by the same share of what is left to them; those of rooms in
    ``asked`` stay.

    Args:
        programme: as furniture and rules have it.
        total: floor of all rooms indoors [m2], without stairs.
        asked: ids of rooms whose area was asked for.
        profile: of the rules that bound areas as well.

    Examples:
        >>> from sceneweaver.plans import Programme, totalled
        >>> programme = totalled(Programme.example("flat-2-bedrooms"), 70)
        >>> round(sum(room.area[1] for room in programme.rooms if "outdoor" not in room.kind.roles))
        70
    """
    rows = Rows(Profile.of(profile), programme.use)
    indoors = [r for r in programme.rooms if not {"outdoor", "stairs"} & r.kind.roles]
    free = [r for r in indoors if r.id not in asked]
    more = total - sum(r.area[1] for r in indoors)
    ends = {r.id: r.area[2] if more > 0 else min(r.area[1], max(r.area[0], _least(r, rows))) for r in free}
    left = sum(abs(ends[r.id] - r.area[1]) for r in free)
    if left < 1e-6:
        return programme
    share = min(1.0, abs(more) / left)

    def moved(room: RoomSpec) -> RoomSpec:
        least, target, most = room.area
        area = (least, round(target + share * (ends[room.id] - target), 2), most)
        return room.model_copy(update={"area": area})

    rooms = tuple(moved(room) if room.id in ends else room for room in programme.rooms)
    return programme.model_copy(update={"rooms": rooms})


def _least(room: RoomSpec, rows: Rows) -> float:
    """The least floor [m2] that hard rows leave to a room: by its area, or as wide as it has to be both ways."""
    side = max(room.side or 0.0, rows.bound("side", room)[0], rows.bound("turning", room)[0], 0.0)
    return round(max(rows.bound("area", room)[0], side**2, 0.0), 2)
