"""What a programme asks for, against the plan: rooms, areas, storeys, light, and what lies next to what."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from ..report import PlanViolation
from ..room_specs import Adjacency
from .economy import share_wall
from .facts import PlanFacts
from .parts import RoomFacts
from .readings import number
from .rooms import clear_side
from .walls import metres


def asked(plan: PlanFacts) -> Iterator[tuple[bool, float, PlanViolation]]:
    """What of the programme is not met: (hard, weight, violation)."""
    programme = plan.programme
    if programme is None:
        return
    yield from ((True, 1.0, violation) for violation in _rooms(plan))
    for room in plan.rooms:
        if room.spec is not None:
            yield from ((True, 1.0, violation) for violation in _sizes(plan, room))
    for adjacency in programme.adjacencies:
        a, b = plan.by_id.get(adjacency.a), plan.by_id.get(adjacency.b)
        if a is None or b is None:
            continue  # told as a missing room
        line = _unmet(plan, adjacency, a, b)
        if line:
            weight = 1.0 if adjacency.hard else adjacency.weight
            yield adjacency.hard, weight, PlanViolation("programme-adjacency", (a.id, b.id), line, 1.0)


def _rooms(plan: PlanFacts) -> Iterator[PlanViolation]:
    programme = plan.programme
    assert programme is not None
    for spec in programme.rooms:
        room = plan.by_id.get(spec.id)
        if room is None:
            yield PlanViolation("programme-rooms", (spec.id,), f"{spec.id}: the plan has no such room", 1.0)
        elif plan.home.room(spec.id).type != spec.type:
            line = f"{spec.id}: it is of type {plan.home.room(spec.id).type}; the programme asks for {spec.type}"
            yield PlanViolation("programme-rooms", (spec.id,), line, 1.0)
    for room in plan.rooms:
        if room.spec is None and not room.has("stairs"):
            yield PlanViolation("programme-rooms", (room.id,), f"{room.id}: the programme has no such room", 1.0)
    storeys = len({room.storey for room in plan.rooms})
    if storeys != programme.storeys:
        line = f"the plan has rooms on {storeys} storeys; the programme asks for {programme.storeys}"
        yield PlanViolation("programme-storeys", (), line, float(abs(storeys - programme.storeys)))


def _sizes(plan: PlanFacts, room: RoomFacts) -> Iterator[PlanViolation]:
    spec = room.spec
    assert spec is not None
    least, _, most = (Fraction(repr(value)) for value in spec.area)
    for excess, word, bound in ((least - room.area, "at least", least), (room.area - most, "at most", most)):
        if excess > 0:
            line = f"{room.id}: floor is {number(room.area, 'm2')}; the programme asks for {word} {number(bound, 'm2')}"
            yield PlanViolation("programme-area", (room.id,), line, float(excess))
    if spec.side is not None:
        side, bound = metres(clear_side(room)), Fraction(repr(spec.side))
        if side < bound:
            line = f"{room.id}: clear width is {number(side, 'm')}; the programme asks for {number(bound, 'm')}"
            yield PlanViolation("programme-side", (room.id,), line, float(bound - side))
    if spec.storey is not None and spec.storey != room.storey:
        line = f"{room.id}: it is on storey {room.storey}; the programme asks for {spec.storey}"
        yield PlanViolation("programme-storeys", (room.id,), line, float(abs(spec.storey - room.storey)))


def _unmet(plan: PlanFacts, adjacency: Adjacency, a: RoomFacts, b: RoomFacts) -> str:
    """What is wrong, in one line; empty where nothing is."""
    doors = [door for door in plan.doors_of(a) if {*door.rooms} == {a.id, b.id}]
    stairs = any({stair.lower, stair.upper} == {a.id, b.id} for stair in plan.stairs)
    pair = f"{a.id} and {b.id}"
    if adjacency.kind == "door" and not doors and not stairs:
        return f"{pair}: no door joins them; the programme asks for one"
    if adjacency.kind == "open" and not any(door.part.kind == "open" for door in doors) and not stairs:
        return f"{pair}: no open passage joins them; the programme asks for one"
    together = a.storey == b.storey and (bool(doors) or share_wall(a, b))
    if adjacency.kind == "near" and not together:
        return f"{pair}: they share no wall; the programme wants them beside each other"
    if adjacency.kind == "apart" and together:
        return f"{pair}: they share a wall; the programme wants them apart"
    return ""
