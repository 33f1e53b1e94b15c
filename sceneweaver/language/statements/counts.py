"""What numbers of people and arrangements say of how many things there are: two groups of four are eight armchairs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..model import Activity, Arrangement, Capacity, Entity, StatedRelation
from ..things import singular
from ..vocabulary import family, words
from .resolve import entity_named

SHARED = 2
"""People beside each other at each table of a U."""

VAGUE, FEW = (2, 6), 4
"""Count of a bare plural, and how many of it stand along two walls."""


@dataclass(frozen=True)
class Peopled:
    """Entities and relations with the counts that follow from people and arrangements, and the people of the room."""

    entities: tuple[Entity, ...]
    relations: list[StatedRelation]
    capacities: tuple[Capacity, ...]
    people: int | None


def bounded_counts(
    entities: Sequence[Entity], bounds: Sequence[tuple[tuple[str, ...], int, int]]
) -> tuple[Entity, ...]:
    """Entities with the least and most that stand behind their nouns; several nouns share a number."""
    by_id = {entity.id: entity for entity in entities}
    for nouns, least, most in bounds:
        names = [name for name in dict.fromkeys(entity_named(noun, entities) for noun in nouns) if name in by_id]
        for k, name in enumerate(names):
            share = (least + k) // len(names), max(1, (most + k) // len(names))
            by_id[name] = by_id[name].model_copy(update={"count": share})
    return tuple(by_id.values())


def shared_counts(
    entities: Sequence[Entity], shared: Sequence[tuple[str, int]], people: int | None
) -> list[tuple[tuple[str, ...], int, int]]:
    """How many there are of what so many people share one of; who sits there counts where no number was told."""
    exact = [e.count[0] for e in entities if e.count and e.count[0] == e.count[1] and family(e.category) == "seat"]
    many = people or sum(exact)
    return [((noun,), -(-many // by), -(-many // by)) for noun, by in shared if many]


def peopled(
    entities: Sequence[Entity],
    relations: Sequence[StatedRelation],
    capacities: Sequence[Capacity],
    arrangements: Sequence[Arrangement],
    people: int | None,
    room_type: str | None,
) -> Peopled:
    """Make one statement of the people of a request, and bring counts in line with it."""
    by_id = {entity.id: entity for entity in entities}
    if people is None:
        people = sum(_total(c, by_id) for c in capacities) or None
    known = [_known(c, people, by_id) for c in capacities]
    rooms = words("people")["in_rooms"]
    does: Activity = next((name for name in rooms if room_type in rooms[name]), "use")
    known = [
        c.model_copy(update={"activity": does}) if c.activity == "use" and not c.target and not c.own else c
        for c in known
    ]
    if people is not None and not any(c.people == people and not c.own for c in known):
        known.append(Capacity(id=f"capacity-{len(known)}", people=people, activity=does, words=f"{people} people"))
    for one in known:
        for name, count in one.own:
            if name in by_id and one.people:
                by_id[name] = _counted(by_id[name], one.people * count)
    found = list(relations)
    for one in arrangements:
        if one.entity in by_id:
            known_as = by_id[one.entity]
            several = known_as.count != (1, 1) or singular(known_as.noun) != known_as.noun
            by_id[one.entity] = _hung(_counted(known_as, _things(one)) if several else known_as, one)
        # What all look at is said of the arrangement; none of a row looks straight at it but the middle one.
        found = [
            r
            for r in found
            if not (r.type == "facing" and r.subject in (one.entity, *one.others) and one.facing in r.targets)
        ]
        if one.pattern == "cluster" and one.around in by_id and one.groups and one.entity in by_id:
            by_id[one.around] = _counted(by_id[one.around], one.groups)
            # What a group is around stands on the floor, whatever its words were tied to.
            found = [_grouped(r, one) for r in found if not (r.subject == one.around and _holds_off(r, one))]
            if not any(r.subject == one.entity and r.targets == (one.around,) for r in found):
                said = StatedRelation(type="around", subject=one.entity, targets=(one.around,), span=one.span)
                found.append(_grouped(said, one))
    for one in arrangements:
        entity, host = by_id.get(one.entity), by_id.get(one.around)
        if one.pattern == "walls" and entity is not None and entity.count == VAGUE:
            by_id[one.entity] = entity.model_copy(update={"count": (FEW, FEW)})  # two at each
        if one.pattern == "u" and entity is not None and entity.count == VAGUE:
            told = sum(c.people for c in known if not c.own and not c.each and c.target in ("", one.entity))
            table = family(entity.category) == "table"
            count = -(-told // SHARED) if told and table else told or VAGUE[1]
            by_id[one.entity] = entity.model_copy(update={"count": (max(3, count), max(3, count))})
        if one.pattern in ("outside", "inside") and entity is not None and host is not None and entity.count == VAGUE:
            by_id[one.entity] = entity.model_copy(update={"count": host.count})  # a seat at each table
    for one in arrangements:
        host = by_id.get(one.around)
        if one.pattern == "between" and one.entity in by_id and host is not None and host.count is not None:
            gaps = host.count[0] - _rows_of(one.around, arrangements)
            by_id[one.entity] = by_id[one.entity].model_copy(update={"count": (max(1, gaps), max(1, gaps))})
    for said in relations:
        _with_seats(said, by_id)
    return Peopled(tuple(by_id[e.id] for e in entities), found, tuple(known), people)


def _rows_of(name: str, arrangements: Sequence[Arrangement]) -> int:
    """In how many rows things stand, between whose neighbours there is something."""
    one = next((a for a in arrangements if a.entity == name), None)
    if one is None or one.pattern == "row":
        return 1
    if one.facing == "each other" and one.columns == 1:
        return 1  # across from each other
    return one.rows or (2 if one.pattern in ("walls", "sides", "rows") else 1)


def told_apart(
    relations: Sequence[StatedRelation], arrangements: Sequence[Arrangement]
) -> tuple[list[StatedRelation], tuple[Arrangement, ...]]:
    """Relations and arrangements where what is between "two sofas" is between both, if these were told apart."""
    partner = {
        r.subject: r.targets[0]
        for r in reversed(relations)
        if r.type in ("facing", "side_by_side") and len(r.targets) == 1 and r.subject.startswith(_stem(r.targets[0]))
    }
    partner |= {b: a for a, b in partner.items() if b not in partner}
    found = []
    for said in relations:
        if said.type == "between" and len(said.targets) == 1 and said.targets[0] in partner:
            said = said.model_copy(update={"targets": (said.targets[0], partner[said.targets[0]])})
        found.append(said)
    kept = []
    for one in arrangements:
        if one.pattern == "between" and one.around in partner:
            ends = (one.around, partner[one.around])
            row = StatedRelation(id=one.id, type="between", subject=one.entity, targets=ends, words=one.words)
            found.append(row.model_copy(update={"span": one.span}))
        else:
            kept.append(one)
    return found, tuple(kept)


def _stem(name: str) -> str:
    """The id of an entity without its number."""
    return name.rpartition("-")[0] if name.rpartition("-")[2].isdigit() else name


def _with_seats(said: StatedRelation, entities: dict[str, Entity]) -> None:
    """Of "six wheels with stools" each has one: seats without a number are as many as what they go with."""
    seat, host = entities.get(said.subject), entities.get(said.targets[0]) if len(said.targets) == 1 else None
    if seat is None or host is None or host.count is None or host.count[0] != host.count[1]:
        return
    if said.implied and host.count[0] > 2 and seat.count in (None, (2, 6)) and family(seat.category) == "seat":
        entities[seat.id] = seat.model_copy(update={"count": host.count})


def _total(one: Capacity, entities: dict[str, Entity]) -> int:
    """The people of a statement; those at each of its targets together."""
    target = entities.get(one.target)
    return one.people * (target.count[0] if one.each and target is not None and target.count else 1)


def _known(one: Capacity, people: int | None, entities: Mapping[str, Entity]) -> Capacity:
    """A statement of all people with their number, and of what is each one's own as far as there is such a thing."""
    own = tuple((name, count) for name, count in one.own if name in entities)
    return one.model_copy(update={"people": one.people or people or 0, "own": own})


def _things(one: Arrangement) -> int | None:
    """How many things an arrangement has."""
    if one.sides:
        return sum(one.sides)
    across = one.groups if one.pattern in ("cluster", "stack") else one.rows
    each = one.rows if one.pattern == "stack" else one.columns
    return across * each if across and each else None


def _counted(entity: Entity, count: int | None) -> Entity:
    """An entity with a number that follows; what the request says of its number itself stays."""
    if count is None or (entity.count is not None and entity.count[0] >= count):
        return entity
    return entity.model_copy(update={"count": (count, count)})


def _hung(entity: Entity, one: Arrangement) -> Entity:
    """What is set out one above the other hangs on a wall."""
    category = words("people")["hung"].get(entity.category) if one.upright else None
    return entity.model_copy(update={"category": category}) if category else entity


def _grouped(said: StatedRelation, one: Arrangement) -> StatedRelation:
    """What ties an arrangement's things to what each group is around says so of each group."""
    if said.subject != one.entity or said.targets != (one.around,) or one.columns is None:
        return said
    return said.model_copy(update={"type": "around", "count": (one.columns, one.columns), "each": True})


def _holds_off(said: StatedRelation, one: Arrangement) -> bool:
    """Whether a relation would have what a group is around elsewhere than amid its things, or says it the other way."""
    return said.type in ("on", "inside", "hanging_from") or said.targets == (one.entity,)


__all__ = ["Peopled", "bounded_counts", "peopled", "shared_counts", "told_apart"]
