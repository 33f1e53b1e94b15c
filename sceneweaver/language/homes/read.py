"""``read_home``: a request for a whole home as the programme of its plan and the requests of its rooms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sceneweaver.language.vocabulary import category_of, vocabulary
from sceneweaver.plans import room_type
from sceneweaver.plans import room_types as plan_types

from .areas import alike, balanced, set_areas
from .build import entrance_of, joined, place_rooms, programme_of, storeys_of
from .each import read_each
from .floors import read_floors
from .households import read_people
from .joined import read_joints
from .lexicon import Use, uses
from .mentions import read_mentions
from .mixed_use import join_business, mixed_in, place_business, regions
from .model import HomeRequest, RoomAsked, Understood
from .needed import add_needed
from .outside import read_outside
from .owners import read_owners
from .parts import Joint, Named, Reading
from .relations import read_relations
from .residents import people_told, settle
from .resolve import Room, bedroomlike, resolve
from .site import read_site
from .tokens import Spoken, Token, spoken
from .unread import read_rest
from .use_named import use_by_rooms, use_in
from .widths import read_widths
from .wishes import read_wishes

_OF_CHILDREN = ("nursery", "childrens_room", "teen_bedroom", "playroom")


def read_home(request: str) -> HomeRequest:
    """What a request for a home says; what it does not say is assumed and told, what is not understood is listed.

    Raises:
        InputError: when there is nothing to read.

    Examples:
        >>> from sceneweaver.language.homes import read_home
        >>> asked = read_home("a two-bedroom flat with a big kitchen, 70 m2")
        >>> sorted({room.type for room in asked.programme.rooms}), asked.area
        (['bathroom', 'bedroom', 'entrance_hall', 'kitchen', 'living_room'], 70.0)
    """
    reading, said = read_parts(request)
    rooms = resolve(reading)
    assumed = add_needed(reading, rooms)
    assumed += place_business(reading, rooms)
    count, placed = storeys_of(reading, rooms)
    assumed += place_rooms(reading, rooms, count, placed)
    for token in reading.tokens:
        if token.has("vague") and not token.done:
            reading.say_vague(token)
    notes = list(dict.fromkeys(reading.notes))
    notes += set_areas(reading, rooms)
    entrance = entrance_of(reading, rooms, placed)
    _open_kitchen(reading, rooms)
    _own_baths(reading, rooms)
    adjacencies, joints = joined(reading, rooms, entrance, notes)
    programme = programme_of(reading, rooms, count, placed, entrance, adjacencies)
    own = _asked(reading, rooms, placed)
    told = {room.id for room in own if room.area is not None or room.size}
    programme = balanced(programme, told, sum(reading.area) / 2 if reading.area else None)
    programme = alike(programme, [one.ids for one in reading.named if one.equal])
    unread, remarks = read_rest(reading)
    return HomeRequest(
        text=request,
        language=said.language,
        use=reading.use.name,
        programme=programme,
        profile="accessible" if reading.accessible else "base",
        rooms=tuple(own),
        joints=tuple(joints),
        counts=tuple(_counts(reading, rooms).items()),
        people=people_told(reading) or reading.household or reading.workers,
        styles=tuple(dict.fromkeys(reading.styles)),
        area=round(sum(reading.area) / 2, 1) if reading.area else None,
        least=reading.least,
        most=reading.most,
        width=reading.width,
        depth=reading.depth,
        doors=reading.doors,
        ways=reading.ways,
        l_shape=reading.l_shape,
        window_sides=reading.window_sides,
        storeys=reading.storeys or (1 if reading.one_storey else None),
        excluded=tuple(dict.fromkeys(one.kind.type for one in reading.named if one.barred)),
        understood=tuple(_understood(reading)),
        assumed=tuple(assumed),
        unread=tuple(unread),
        remarks=tuple(remarks),
        notes=tuple(dict.fromkeys(notes)),
    )


def read_parts(request: str, use: Use | None = None) -> tuple[Reading, Spoken]:
    """All that a request says, before rooms get ids."""
    said = spoken(request)
    found = use_in(said.tokens)
    if found is None:
        first = Reading(request, said.tokens, uses()["house"], None)
        read_mentions(first)
        kinds = [one.kind.name for one in first.named]
        said = spoken(request)
        found = (use_by_rooms(kinds, 2 if any(t.has("storey") for t in said.tokens) else 1), None)
    elif said.tokens[found[1] or 0].text == "place" and _is_storeyed(said.tokens):
        found = (uses()["house"], found[1])
    mixed = mixed_in(said.tokens)
    if mixed is not None and use is None:
        found = mixed[:2]
    reading = Reading(request, said.tokens, use or found[0], found[1])
    if mixed is not None and use is None:
        reading.second, reading.business = mixed[2], regions(said.tokens)
    if found[1] is not None:
        reading.did(found[1], "use")
        token = said.tokens[found[1]]
        reading.rows.append((token.span, "use", found[0].name.replace("_", " ")))
    for token in said.tokens:
        if token.has("use") and token.get("use")[1] and not token.has("room"):
            reading.did(token, "use")  # where it stands, or what it is called again
    read_mentions(reading)
    join_business(reading)
    read_owners(reading)
    read_outside(reading)
    read_relations(reading)
    read_joints(reading)
    read_floors(reading)
    read_widths(reading)
    read_site(reading)
    read_people(reading)
    read_each(reading)
    settle(reading)
    read_wishes(reading)
    return reading, said


def _is_storeyed(tokens: Sequence[Token]) -> bool:
    """Whether several storeys are told: "a two-storey place"."""
    return any(b.has("storey_words") and (a.number or 0) > 1 for a, b in zip(tokens, tokens[1:], strict=False))


def _counts(reading: Reading, rooms: list[Room]) -> dict[str, int]:
    """How many rooms there are of the types that are named; bedrooms of all who are told to live there."""
    named = {room.type for room in rooms if not room.assumed}
    sleeping = any(bedroomlike(room.kind) and room.type in named for room in rooms) or bool(reading.people)
    found: dict[str, int] = {}
    for room in rooms:
        bathing = room.counts_as("bathroom") and any(r.counts_as("bathroom") and r.type in named for r in rooms)
        if room.type in named or bathing or bedroomlike(room.kind) and sleeping:
            found[room.type] = found.get(room.type, 0) + 1
    return found


def _open_kitchen(reading: Reading, rooms: list[Room]) -> None:
    """An open kitchen is open to the room where people live, where nothing else is said of it."""
    living = next((room for room in rooms if room.type in ("living_room", "living_dining", "dining_room")), None)
    for one in reading.named:
        if not one.open or living is None or not one.ids or one.kind.type not in ("kitchen", "kitchen_diner"):
            continue
        if any(one in (joint.a, joint.b) and joint.kind == "open" for joint in reading.joints):
            continue
        there = next((n for n in reading.named if living.id in n.ids), None)
        if there is None:
            there = Named(living.kind, -1, -1, -1, one.span, 1, ids=[living.id])
        reading.joints.append(Joint(one, there, "open", one.span))


def _own_baths(reading: Reading, rooms: list[Room]) -> None:
    """En-suites that no bedroom is told of belong to those that are there."""
    beds = [room for room in rooms if bedroomlike(room.kind)]
    for one in reading.named:
        if one.kind.name != "ensuite" or not one.ids or any(one in (joint.a, joint.b) for joint in reading.joints):
            continue
        ids = [room.id for room in beds[: len(one.ids)]]
        if ids:
            there = Named(beds[0].kind, -1, -1, -1, one.span, len(ids), ids=ids)
            reading.joints.append(Joint(one, there, "door", one.span, each=True))


def _asked(reading: Reading, rooms: list[Room], placed: Mapping[str, int | None]) -> list[RoomAsked]:
    """What each room's own request is to say; things in no room that is named go where such things are."""
    own: dict[str, RoomAsked] = {}
    for room in rooms:
        named = room.named
        size = next((one.size for one in reversed(named) if one.size is not None), None)
        own[room.id] = RoomAsked(
            id=room.id,
            noun=room.kind.noun
            if room.kind.name.startswith("accessible")
            else next((one.noun for one in reversed(named) if one.noun), room.kind.noun),
            said=next((one.said for one in named if one.said), room.kind.noun),
            whose=_whose(reading, room),
            looks=tuple(dict.fromkeys(word for one in named for word in one.looks)),
            wishes=tuple(dict.fromkeys(words for one in named for words in one.wishes)),
            size="" if size is None or size == 1 else "big" if size > 1 else "small",
            equal=any(one.equal for one in named),
            outside=any(one.outside for one in named),
            area=next((one.area for one in named if one.area is not None), None),
            least=next((one.least for one in named if one.least is not None), None),
            most=next((one.most for one in named if one.most is not None), None),
            storey=placed.get(room.id) if room.storey else None,
            daylight=next((one.daylight for one in named if one.daylight is not None), None),
            assumed=not named,
            span=named[0].span if named else None,
        )
    table: list[Room] = []
    for words, span, everyone in reading.loose:
        there = _places(words, rooms)
        seats = bool({"chair", "chairs", "stools", "seats"} & {*words.split()})
        there = table if seats and table and not everyone else there
        table = there[:1] if "table" in words.split() else table  # chairs that are told after it stand there
        chosen = [room for room in there if room.type == there[0].type] if everyone else there[:1]
        for room in chosen:
            own[room.id] = replace(own[room.id], wishes=(*own[room.id].wishes, words))
            reading.rows.append((span, "request", f"{words}: in the request of {room.id}"))
    for words, span in reading.unwanted:
        there = _places(words, rooms)
        for room in there or rooms:
            own[room.id] = replace(own[room.id], unwanted=(*own[room.id].unwanted, words))
        reading.rows.append(
            (span, "not wanted", f"{words}: in the request of {', '.join(r.id for r in there) or 'all rooms'}")
        )
    return list(own.values())


def _whose(reading: Reading, room: Room) -> str:
    """For whom a bedroom is by its kind and the people."""
    if room.kind.whose:
        return room.kind.whose
    if room.kind.name == "master_bedroom":
        return "two people"
    if room.kind.name == "childrens_room":
        if any(p.role == "twins" for p in reading.people) or reading.share:
            return "two children"
        return "a child"
    return ""


_BEHIND_HEAD = ("with", "for", "of", "by", "in", "on", "under", "at", "to")
"""Words that end the head of a thing's name."""


def _places(words: str, rooms: list[Room]) -> list[Room]:
    """The rooms in which a thing usually is, else the one where people live."""
    from sceneweaver.knowledge.likely import likeliest_room, told_by
    from sceneweaver.knowledge.load import room_types

    spoken_words = words.split()
    triples = [" ".join(spoken_words[k : k + 3]) for k in range(len(spoken_words) - 2)]
    whole = [k for k, words in enumerate(triples) if "noun" in vocabulary().get(words, {})]  # "walk in shower"
    within = {j for k in whole for j in range(k, k + 3)}
    ends = [k for k, word in enumerate(spoken_words) if word in _BEHIND_HEAD and k and k not in within]
    spoken_words = spoken_words[: ends[0]] if ends else spoken_words  # "a shower with a seat" goes where showers do
    pairs = [" ".join(two) for two in zip(spoken_words, spoken_words[1:], strict=False)]
    nouns = [w for w in (*(triples[k] for k in whole), *pairs, *spoken_words) if "noun" in vocabulary().get(w, {})]
    categories = {category_of(str(vocabulary()[w]["noun"])) for w in nouns}
    found: list[tuple[float, int, Room]] = []
    for index, room in enumerate(rooms):
        kind = room_type(room.type).furnish
        if kind is not None and kind in room_types() and (share := told_by(categories, room_types()[kind])) > 0:
            found.append((-share, index, room))
    if found:
        return [room for _, _, room in sorted(found, key=lambda one: one[:2])]
    likely = likeliest_room(categories) if categories else None
    if likely is not None and likely.name in plan_types():
        roles = plan_types()[likely.name].roles - {"daylight", "habitable"}
        alike = [
            (
                len(roles & room_type(room.type).roles),
                room.kind.name in _OF_CHILDREN and likely.name in _OF_CHILDREN,
                -k,
            )
            for k, room in enumerate(rooms)
        ]
        best = max(alike, default=(0, False, 0))
        if best[0] >= 2:
            return [rooms[-best[2]]]
    return [
        room
        for room in rooms
        if room.type in ("living_room", "living_kitchen", "living_dining", "open_office", "waiting_room")
    ]


def _understood(reading: Reading) -> list[Understood]:
    rows = [(span, kind, row) for span, kind, row in reading.rows]
    for one in reading.named:
        if not one.barred and one.ids:
            rows.append((one.span, "rooms", ", ".join(one.ids)))
    for joint in reading.joints:
        ends = [joint.a, joint.b]
        ids = [", ".join(end.ids) if isinstance(end, Named) else end for end in ends]
        rows.append((joint.span, "joint", f"{ids[0]} {joint.kind} {ids[1]}"))
    for person in reading.people:
        rows.append((person.span, "people", f"{person.count} {person.role}"))
    for one in reading.named:
        for words in one.wishes:
            rows.append((one.span, "request", f"{words}: in the request of {', '.join(one.root.ids)}"))
    rows.sort(key=lambda one: (one[0].start, one[0].end))
    return [Understood(reading.text[s.start : s.end], kind, row, s) for s, kind, row in rows]
