"""What a home needs when its request does not say: rooms by the people and by the use."""

from __future__ import annotations

from sceneweaver.plans import room_type

from .lexicon import data, room_kinds
from .parts import Named, Reading
from .residents import bedrooms_for, people_told
from .resolve import Room, bedroomlike, kind_named, new_id


def add_needed(reading: Reading, rooms: list[Room]) -> list[str]:
    """Adds the rooms that are needed and not named; says what was assumed, one line each."""
    said: list[str] = []
    barred = {one.kind.name for one in reading.named if one.barred}
    if reading.use.plan in ("flat", "house"):
        said += _bedrooms(reading, rooms)
    for kind, count in reading.staff.items():
        have = sum(room.counts_as(kind) for room in rooms)
        if have < count and not _named_for_staff(reading, rooms):
            _add(rooms, kind, count - have)
            said.append(f"{count} x {kind.replace('_', ' ')}: one for each who works there")
    guests = reading.visitors and reading.use.plan == "house" and not _numbered(reading)
    if guests and not any(room.kind.name == "guest_room" for room in rooms):
        _add(rooms, "guest_room", 1)
        said.append("a guest room: for those who come to stay")
    second = dict(reading.second.needs) if reading.second is not None else {}
    for name, count in [*reading.use.needs.items(), *second.items()]:
        options = name.split("|")
        if any(room.counts_as(option) or option in room.kind.counts_as for room in rooms for option in options):
            continue
        theirs = name in second and options[0] == "washroom"  # those who come to a business have a toilet there
        toilets = theirs and not any(room.type in ("washroom", "guest_toilet", "accessible_toilet") for room in rooms)
        if options[0] in barred or _instead(options[0], rooms, barred) and not toilets:
            continue
        if options[0] == "bathroom":
            continue
        _add(rooms, options[0], count)
        whose = reading.second if name in second and reading.second is not None else reading.use
        said.append(f"{_counted(options[0], count)}: a {whose.name.replace('_', ' ')} has it")
    said += _bathrooms(reading, rooms)
    said += _ways(reading, rooms, barred)
    said += _accessible(reading, rooms)
    return said


def _named_for_staff(reading: Reading, rooms: list[Room]) -> bool:
    """Whether rooms of care are told by their number already, so that staff tells no other number."""
    care = {
        "doctors_office",
        "examination_room",
        "dentist",
        "treatment_room",
        "psychotherapy_room",
        "vet_surgery",
        "private_office",
    }
    return any(room.kind.name in care for room in rooms)


def _instead(name: str, rooms: list[Room], barred: set[str]) -> bool:
    """Whether rooms stand in for one: people of a shared flat may live in a big kitchen; a single toilet, an
    accessible one."""
    return (
        any(name in room.kind.counts_as for room in rooms)
        or name == "washroom"
        and any(room.type in ("washroom", "guest_toilet", "accessible_toilet", "bathroom") for room in rooms)
    )


def _numbered(reading: Reading) -> bool:
    """Whether a number of bedrooms is told, which then are all of them."""
    return any(
        one.of is None and one.told in ("number", "total") and one.kind.name in ("bedroom", "studio_room")
        for one in reading.named
    )


def _bedrooms(reading: Reading, rooms: list[Room]) -> list[str]:
    own = [room for room in rooms if bedroomlike(room.kind) and room.kind.name != "guest_room"]
    if any(room.type in ("dormitory", "studio_apartment", "ward") for room in rooms) or reading.use.name in ("hostel",):
        return []
    said: list[str] = []
    if not _numbered(reading):
        need = dict(bedrooms_for(reading))
        spare = list(own)
        for kind in need:  # rooms that are named for those people, then any other bedroom
            for room in [room for room in spare if room.kind.name == kind][: need[kind]]:
                spare.remove(room)
                need[kind] -= 1
        for kind in need:
            for room in spare[: need[kind]]:
                spare.remove(room)
                need[kind] -= 1
            if need[kind] > 0:
                _add(rooms, kind, need[kind])
                said.append(f"{_counted(kind, need[kind])}: for those who live there")
    if not any(bedroomlike(room.kind) for room in rooms):
        _add(rooms, "bedroom", 1)
        said.append("a bedroom: nothing is said of who sleeps there")
    return said


def _bathrooms(reading: Reading, rooms: list[Room]) -> list[str]:
    """Bathrooms by how many people or bedrooms there are; an en-suite is none for the others."""
    if reading.use.needs.get("bathroom") is None and reading.use.needs.get("accessible_bathroom") is None:
        return []
    baths = [room for room in rooms if room.counts_as("bathroom")]
    shared = [
        room
        for room in baths
        if room.kind.name != "ensuite"
        and not any(
            one.per is not None or one.owner and _lives_apart(reading, one)
            for one in reading.named
            if room.id in one.ids
        )
    ]
    beds = [room for room in rooms if bedroomlike(room.kind)]
    told = any(
        not (one.owner and _lives_apart(reading, one))
        and one.kind.name in ("bathroom", "accessible_bathroom", "wet_room")
        and one.of is None
        and not one.barred
        for one in reading.named
    )
    own = sum(room.kind.name == "ensuite" for room in rooms)
    if told or own and own >= len(beds):
        return []
    if shared:
        return []
    kind = "accessible_bathroom" if reading.accessible else "bathroom"
    people = people_told(reading) or reading.household or max(2, len(beds) + 1)
    many = next((count for count, up_to in data("people")["bathrooms"] if people <= up_to), 4)
    many = max(1, many - len(baths))
    _add(rooms, kind, many)
    return [f"{_counted(kind, many)}: by how many live there"]


def _lives_apart(reading: Reading, one: Named) -> bool:
    """Whether who has a bathroom alone lives on a storey where the others do not sleep."""
    beds = [other for other in reading.named if other.of is None and bedroomlike(other.kind) and not other.barred]
    elsewhere = any(bed.storey not in (None, one.storey) and not bed.owner for bed in beds)
    return one.storey is not None and (elsewhere or reading.sleep_storey not in (None, one.storey))


def _accessible(reading: Reading, rooms: list[Room]) -> list[str]:
    """One bathroom, or one toilet where there is none, to turn a wheelchair in."""
    if not reading.accessible or any(room.kind.name.startswith("accessible") for room in rooms):
        return []
    for types, kind in (
        (("bathroom", "wet_room", "kids_bathroom"), "accessible_bathroom"),
        (("guest_toilet", "washroom"), "accessible_toilet"),
        (("ensuite",), "accessible_bathroom"),
    ):
        room = next((room for room in rooms if room.type in types), None)
        if room is not None:
            room.kind = room_kinds()[kind]
            return [f"{room.id} is one to turn a wheelchair in"]
    return []


def _ways(reading: Reading, rooms: list[Room], barred: set[str]) -> list[str]:
    """A hall to come in by, a corridor between many rooms, a landing at the top of stairs."""
    said: list[str] = []
    ways = [room for room in rooms if room.type in ("entrance_hall", "hallway", "corridor", "vestibule", "landing")]
    no_ways = bool(barred & {"hallway", "entrance_hall"})
    indoors = [room for room in rooms if room.type not in ("balcony", "terrace", "garage")]
    if reading.use.plan in ("flat", "house"):
        if not ways and not no_ways and len(indoors) > 3:
            _add(rooms, "entrance_hall", 1)
            said.append("an entrance hall: doors of many rooms need one")
    elif not ways and not no_ways and len(indoors) > 1 and not any(room_type(r.type).transit == "all" for r in rooms):
        _add(rooms, "hallway", 1)
        said.append("a corridor: no room that is named leads to the others")
    elif not ways and not no_ways and len(indoors) > 4 and not any(room.type == "open_office" for room in rooms):
        _add(rooms, "hallway", 1)
        said.append("a corridor: doors of many rooms need one")
    return said


def add_landings(rooms: list[Room], storeys: int, placed: dict[str, int | None]) -> list[str]:
    """A landing on each upper storey that has more than one room and none to come from the stairs into."""
    said: list[str] = []
    for storey in range(1, storeys):
        there = [room for room in rooms if placed.get(room.id) == storey]
        if any(
            room.type in ("landing", "hallway", "corridor", "open_office", "living_room", "living_kitchen")
            for room in there
        ):
            continue
        name = new_id(rooms, "landing")
        rooms.append(Room(name, room_kinds()["landing"], assumed=True))
        placed[name] = storey
        said.append(f"a landing: stairs come up to storey {storey}")
    return said


def _add(rooms: list[Room], kind: str, count: int) -> None:
    for _ in range(count):
        if len(rooms) >= 60:
            return
        rooms.append(Room(new_id(rooms, kind), kind_named(kind), assumed=True))


def _counted(kind: str, count: int) -> str:
    name = kind_named(kind).noun
    return f"{'an' if name[0] in 'aeiou' else 'a'} {name}" if count == 1 else f"{count} x {name}"
