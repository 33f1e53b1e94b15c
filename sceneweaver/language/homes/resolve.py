"""From rooms as they were named to rooms with ids: which names mean the same rooms, how many there are of each."""

from __future__ import annotations

from dataclasses import dataclass, field

from sceneweaver.plans import room_type

from .lexicon import RoomKind, data, room_kinds
from .parts import Named, Reading
from .residents import bedrooms_for


@dataclass
class Room:
    """A room with all that is said of it."""

    id: str
    kind: RoomKind
    named: list[Named] = field(default_factory=list[Named])
    assumed: bool = False
    storey: str | None = None
    area: tuple[float, float, float] | None = None

    @property
    def type(self) -> str:
        """Of the plan."""
        return self.kind.type

    def counts_as(self, kind: str) -> bool:
        """Whether it is one of a kind."""
        return kind in (self.kind.name, self.kind.type, *self.kind.counts_as)


def bedroomlike(kind: RoomKind) -> bool:
    """Whether people sleep there who live there."""
    return kind.name == "bedroom" or "bedroom" in kind.counts_as


def resolve(reading: Reading) -> list[Room]:
    """The rooms of a request with their ids; every `Named` gets the ids of the rooms that it means."""
    _same(reading)
    rooms = list[Room]()
    for one in reading.named:
        if one.of is None and one.per is None and not one.barred:
            _make(reading, rooms, one, _count_of(reading, one) * one.times)
    for _ in range(2):
        for one in reading.named:
            if one.of is None and one.per is not None and not one.ids and not one.barred:
                of = one.per.root
                many = one.per.count if one.per.of is not None and one.per.count else len(of.ids)
                if many:
                    _make(reading, rooms, one, many * (one.count or 1))
    for one in reading.named:
        if one.of is not None:
            _refer(reading, rooms, one)
    for one in reading.named:
        for room in rooms:
            if room.id in one.ids:
                room.named.append(one)
                room.storey = room.storey or one.storey
    return rooms


def _same(reading: Reading) -> None:
    """Names that mean rooms that another name tells of become references to these."""
    own = [one for one in reading.named if one.of is None and not one.barred]
    totals = [one for one in own if one.told == "total"]
    numbers = [one for one in own if one.kind.name == "bedroom" and one.told == "number"]
    explicit = [one for one in own if one.told or one.per is not None or one.area is not None and one.count is None]
    explicit = [one for one in explicit if not one.more]
    for index, one in enumerate(own):
        before = own[:index]
        if one.owner and not one.told and (whose := _of_owner(one, before)) is not None:
            _become(one, whose, None)
            continue
        if bedroomlike(one.kind) and one.told != "total":
            whole = totals[0] if totals else None
            if whole is None and numbers and not one.told and one is not numbers[0]:
                whole = numbers[0]
            if whole is not None and one is not whole and not _elsewhere(one, whole):
                _become(one, whole, one.count if one.told else None if one.all or one.count is None else 1)
                continue
        if one.per is not None:
            continue
        if one.told in ("number", "article"):
            twin = next((o for o in before if o.of is None and o.kind.name == one.kind.name), None)
            once = (
                one.told == "article"
                and one.kind.name in data("words")["one_only"]
                and twin is not None
                and (twin.count == 1 or twin.count is None)
            )
            if once and twin is not None and _other_sentence(reading, twin, one):
                _become(one, twin, None)
            continue
        plural = reading.tokens[one.at].plural and not one.definite
        target = next(
            (o for o in reversed(before) if o.of is None and _means(one, o) and not (plural and o.count == 1)), None
        )
        if target is None and not one.told:
            target = next(
                (
                    o
                    for o in own[index + 1 :]
                    if o in explicit
                    and o.of is None
                    and o.kind.name == one.kind.name
                    and o.told
                    and not _elsewhere(one, o)
                ),
                None,
            )
        if target is not None and target is not one:
            _become(one, target, None if one.all or one.count is None or target.count == 1 else 1)


def _means(one: Named, other: Named) -> bool:
    """Whether a name without a number may mean rooms that were named: "the kitchen" a dining kitchen."""
    if _elsewhere(one, other):
        return False
    if one.definite and one.count == 1 and " " in other.said and other.said.split()[-1] == one.said != "room":
        return True  # "the studio" of a pottery studio
    if one.kind.name == other.kind.name:
        alike = one.said == other.said or one.definite or bedroomlike(one.kind)
        return one.kind.noun == other.kind.noun and alike
    return one.kind.name in other.kind.counts_as and not (one.kind.name == "bathroom" and not one.definite)


def _of_owner(one: Named, before: list[Named]) -> Named | None:
    """The room of the same person that was named before: "mum's bedroom" of a mother with her own bedroom."""
    alike = [
        o for o in before if o.of is None and o.owner == one.owner and bedroomlike(o.kind) == bedroomlike(one.kind)
    ]
    return next((o for o in reversed(alike) if bedroomlike(o.kind) or o.kind.name == one.kind.name), None)


def _elsewhere(one: Named, other: Named) -> bool:
    """Whether two names are told to be on different storeys."""
    return one.storey is not None and other.storey is not None and one.storey != other.storey


def _become(one: Named, whole: Named, count: int | None) -> None:
    while whole.of is not None:
        whole = whole.of
    if whole is one:
        return
    one.of = whole
    one.count = count
    if whole.size is None and count is None:
        whole.size = one.size


def _other_sentence(reading: Reading, one: Named, two: Named) -> bool:
    return any(token.stops for token in reading.tokens[one.at : two.at])


def _count_of(reading: Reading, one: Named) -> int:
    if one.count is not None:
        return max(1, one.count)
    words = " ".join(one.wishes)
    if any(pair in words for pair in data("words")["pairs_of_people"]):
        return 2
    if bedroomlike(one.kind):
        return -1  # by the people
    return 2 if reading.tokens[one.at].plural else 1


def _make(reading: Reading, rooms: list[Room], one: Named, count: int) -> None:
    if count < 0:
        count = max(1, _bedrooms_left(reading, rooms, one))
        if one.said.split()[:1] in (["double"], ["twin"]):
            count = (count + 1) // 2
    for _ in range(min(count, 60 - len(rooms))):
        room = Room(new_id(rooms, one.kind.name), one.kind)
        rooms.append(room)
        one.ids.append(room.id)


def _bedrooms_left(reading: Reading, rooms: list[Room], one: Named) -> int:
    """How many bedrooms those who live there need beside the ones that are there, for "bedrooms" without a number."""
    told = sum(
        n.count or 1
        for n in reading.named
        if n.of is None
        and n is not one
        and bedroomlike(n.kind)
        and n.kind.name not in ("guest_room", "carers_room")
        and not n.barred
    )
    need = sum(count for _, count in bedrooms_for(reading))
    return max(need - told, 2 if told == 0 else 1) if need else 2


def new_id(rooms: list[Room], name: str) -> str:
    """A new id for a room of a kind: "bedroom", "bedroom-2"."""
    taken = {room.id for room in rooms}
    if name not in taken:
        return name
    return next(f"{name}-{k}" for k in range(2, 99) if f"{name}-{k}" not in taken)


def _refer(reading: Reading, rooms: list[Room], one: Named) -> None:
    """The rooms that a reference means: all of them, or as many as it says that no other reference has taken."""
    whole = one.root
    if not whole.ids:
        return
    if one.count is None:
        special = one.kind.name != whole.kind.name and one.kind.name not in whole.kind.counts_as
        left = _free(reading, whole, one)
        one.ids = (
            (left[1:] or left)[: max(1, len(left) - 1)]
            if special and len(left) > 1 and bedroomlike(one.kind)
            else list(whole.ids)
        )
    else:
        left = _free(reading, whole, one)
        same = next(
            (
                o
                for o in reading.named
                if o is not one
                and o.of is whole
                and o.kind.name == one.kind.name
                and o.ids
                and one.definite
                and o.count == one.count
            ),
            None,
        )
        one.ids = list(same.ids) if same is not None else (left or list(whole.ids))[: one.count]
    if one.kind.name != whole.kind.name and whole.kind.name in one.kind.counts_as:
        for room in rooms:
            if room.id in one.ids and room.kind is whole.kind:
                room.kind = one.kind


def _free(reading: Reading, whole: Named, one: Named) -> list[str]:
    taken = {
        i
        for o in reading.named
        if o is not one and o.of is not None and o.root is whole and o.count is not None
        for i in o.ids
    }
    return [i for i in whole.ids if i not in taken]


def usual_area(kind: RoomKind) -> tuple[float, float, float]:
    """Least, usual and most area [m2] of a kind."""
    return room_type(kind.type).area


def kind_named(name: str) -> RoomKind:
    """A kind by its name, the first of several that a ``|`` separates."""
    return room_kinds()[name.split("|")[0]]
