"""Requests for whole homes with what a careful reader takes from each, as data; and what a reading has of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sceneweaver.io import load_yaml
from sceneweaver.language.homes import HomeRequest, room_requests
from sceneweaver.plans import RoomSpec, room_type

FOLDER = Path(__file__).parent / "data" / "home_requests"
SETS = ("people", "tuned", "held_out", "relations", "relations_held_out", "accounts", "accounts_held_out")

AREA = 0.06
"""Share by which an area may be off."""

_KINDS = {
    "bedroom": {
        "bedroom",
        "master_bedroom",
        "childrens_room",
        "teen_bedroom",
        "nursery",
        "guest_room",
        "studio_apartment",
        "granny_flat",
    },
    "bathroom": {"bathroom", "ensuite", "accessible_bathroom", "kids_bathroom", "wet_room"},
    "toilet": {"guest_toilet", "washroom", "accessible_toilet"},
    "living_room": {"living_room", "living_kitchen", "living_dining", "family_room", "break_room"},
    "kitchen": {"kitchen", "kitchen_diner", "kitchenette", "living_kitchen", "break_room"},
    "dining_room": {"dining_room", "living_dining"},
    "study": {"study"},
    "laundry": {"laundry_room", "utility_room"},
    "hallway": {"hallway", "entrance_hall", "corridor"},
    "balcony": {"balcony", "terrace"},
    "library": {"home_library", "library"},
    "gym": {"home_gym", "physiotherapy_room"},
    "treatment_room": {"treatment_room", "dentist", "psychotherapy_room", "vet_surgery"},
    "consulting_room": {"doctors_office", "examination_room", "psychotherapy_room", "vet_surgery"},
    "examination_room": {"examination_room", "vet_surgery"},
    "triage_room": {"examination_room"},
    "staff_room": {"break_room"},
    "sterilisation_room": {"sterilisation"},
    "hospital_ward": {"ward"},
    "office": {"private_office", "office", "study"},
    "seminar_room": {"meeting_room", "classroom"},
    "computer_lab": {"classroom"},
    "study_hall": {"classroom"},
    "sewing_room": {"study"},
    "podcast_studio": {"recording_studio"},
    "walk_in_closet": {"walk_in_closet", "dressing_room"},
    "bar": {"cafe"},
    "shop": {"shop", "bakery", "hair_salon"},
}
"""Types of a plan that a word of the data means; others mean themselves."""

_NOUNS = {
    "examination_room": ("exam",),
    "triage_room": ("triage",),
    "seminar_room": ("seminar",),
    "computer_lab": ("computer",),
    "study_hall": ("study",),
    "sewing_room": ("sewing", "hobby"),
    "kitchen": ("kitchen",),
    "staff_room": ("staff", "break", "teachers", "lunch", "social", "common", "lounge"),
    "consulting_room": ("consult", "doctor", "therap", "counsel"),
    "living_room": ("living", "lounge", "common", "sitting", "day room", "great room", "diner", "den"),
    "classroom": ("class", "group", "teaching", "kindergarten"),
}
"""What the noun of a room has, where its type alone does not tell what it is."""

_VAGUE = {"break_room", "examination_room", "meeting_room", "classroom", "study"}
"""Types that do not tell it."""


@dataclass(frozen=True)
class Asked:
    """A request with what is to be read of it."""

    id: str
    kind: str
    text: str
    expect: dict[str, Any]


def home_requests(name: str) -> list[Asked]:
    """The requests of a set, one of `SETS`."""
    return [Asked(**row) for row in load_yaml(FOLDER / f"{name}.yaml")]


def is_kind(word: str, room: RoomSpec, read: HomeRequest) -> bool:
    """Whether a room is what a word of the data means: by its type, and where that is vague by its noun."""
    if room.type not in _KINDS.get(word, {word}):
        return False
    noun = next((one.said for one in read.rooms if one.id == room.id), "")
    return room.type not in _VAGUE or word not in _NOUNS or any(part in noun for part in _NOUNS[word])


def verdicts(asked: Asked, read: HomeRequest) -> Iterator[tuple[str, bool]]:
    """Each thing that is to be read of a request, in words, and whether it was."""
    for key, value in asked.expect.items():
        yield from _VERDICTS[key](value, read)


def _rooms(value: dict[str, Any], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    for word, count in value.items():
        have = sum(is_kind(word, room, read) for room in read.programme.rooms)
        least = int(str(count).rstrip("+"))
        met = have >= least if str(count).endswith("+") else have == least
        yield f"{count} {word} (has {have})", met


def _areas(value: dict[str, Any], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    sizes = {room.id: room.size for room in read.rooms}
    for word, said in value.items():
        rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
        if isinstance(said, str):
            factor = {"big": 1.1, "small": 0.9}[said]
            met = any(
                sizes.get(room.id) == said
                or (room.area[1] / room_type(room.type).area[1] - 1) * (factor - 1) > 0.01
                and said == "big"
                for room in rooms
            )
        else:
            low, high = said
            met = bool(rooms) and all(
                low <= room.area[1] <= high for room in rooms if read.room(room.id).span or len(rooms) == 1
            )
        yield f"{word} of {said} ({[room.area[1] for room in rooms]})", met


def _pairs(kinds: tuple[str, ...]) -> Any:
    def check(value: list[list[str]], read: HomeRequest) -> Iterator[tuple[str, bool]]:
        rooms = {room.id: room for room in read.programme.rooms}
        for one, two in value:
            met = any(
                adjacency.kind in kinds
                and (
                    is_kind(one, rooms[adjacency.a], read)
                    and is_kind(two, rooms[adjacency.b], read)
                    or is_kind(two, rooms[adjacency.a], read)
                    and is_kind(one, rooms[adjacency.b], read)
                )
                for adjacency in read.programme.adjacencies
            )
            same = "open" in kinds and any(is_kind(one, t, read) and is_kind(two, t, read) for t in rooms.values())
            yield f"{one} {kinds[0]} {two}", met or same

    return check


def _storey(lowest: bool) -> Any:
    def check(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
        for word in value:
            rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
            met = any(room.storey is not None and (room.storey == 0) == lowest for room in rooms)
            yield f"{word} {'on the ground floor' if lowest else 'upstairs'} ({[room.storey for room in rooms]})", met

    return check


def _said(value: dict[str, str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    texts = room_requests(read)
    rooms = {room.id: room for room in read.programme.rooms}
    for word, said in value.items():
        yield (
            f"'{said}' in the request of {word}",
            any(said in text.lower() for i, text in texts.items() if i in rooms and is_kind(word, rooms[i], read)),
        )


def _entrance(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    rooms = {room.id: room for room in read.programme.rooms}
    first = read.programme.entrance
    for word in value:
        near = {
            a.b if a.a == first else a.a
            for a in read.programme.adjacencies
            if first in (a.a, a.b) and a.kind != "apart"
        }
        yield (
            f"{word} by the entrance",
            is_kind(word, rooms[first], read) or any(is_kind(word, rooms[i], read) for i in near),
        )


def _light(value: list[str], read: HomeRequest, lit: bool) -> Iterator[tuple[str, bool]]:
    for word in value:
        rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
        yield (
            f"{word} {'with' if lit else 'without'} windows",
            bool(rooms) and all(room.daylight is lit for room in rooms),
        )


def _limits(name: str) -> Any:
    """Whether the floor of rooms is limited by a number in its requests and in the programme."""

    def check(value: dict[str, float], read: HomeRequest) -> Iterator[tuple[str, bool]]:
        for word, number in value.items():
            rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
            told = [getattr(read.room(room.id), name) for room in rooms]
            kept = all(room.area[2] <= number if name == "most" else room.area[0] >= number for room in rooms)
            yield f"{word} of {name} {number} m2 ({told})", bool(rooms) and kept and all(one == number for one in told)

    return check


def _account(read: HomeRequest) -> list[str]:
    """What is said not to be understood, in small letters."""
    return [one.words.lower() for one in read.unread]


def _told(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    """Whether what no plan can be made to have is told, in the words of the request and in one piece."""
    for words in value:
        yield f"'{words}' is told not to be understood", any(words.lower() in one for one in _account(read))


def _chat(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    """Whether what is no demand is told to be none: no word of it that has a meaning is in what was not understood."""
    for words in value:
        own = {word.strip("()!.,").lower() for word in words.split()} - {"i", "to", "in", "by", "so", "much", "you"}
        yield f"'{words}' is no demand", not any(own & {*one.replace(",", " ").split()} for one in _account(read))


def _outside(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    for word in value:
        rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
        yield f"{word} with a door outside", any(read.room(room.id).outside for room in rooms)


def _side(name: str) -> Any:
    def check(value: list[str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
        rooms = {room.id: room for room in read.programme.rooms}
        there = [i for joint in read.joints if joint.place == name and joint.kind != "apart" for i in joint.a]
        for word in value:
            yield f"{word} at the {name}", any(is_kind(word, rooms[i], read) for i in there)

    return check


def _how(name: str) -> Any:
    def check(value: list[list[str]], read: HomeRequest) -> Iterator[tuple[str, bool]]:
        rooms = {room.id: room for room in read.programme.rooms}
        pairs = [pair for joint in read.joints if joint.how == name for pair in zip(joint.a, joint.b, strict=True)]
        for one, two in value:
            ends = [(rooms[a], rooms[b]) for a, b in pairs]
            either = [*ends, *((b, a) for a, b in ends)] if name == "opposite" else ends
            met = any(is_kind(one, a, read) and is_kind(two, b, read) for a, b in either)
            yield f"{one} {name} {two}", met

    return check


def _unwanted(value: dict[str, str], read: HomeRequest) -> Iterator[tuple[str, bool]]:
    for word, said in value.items():
        rooms = [room for room in read.programme.rooms if is_kind(word, room, read)]
        yield f"no {said} in {word}", any(said in one for room in rooms for one in read.room(room.id).unwanted)


def _one(name: str, met: bool) -> Iterator[tuple[str, bool]]:
    yield name, met


_VERDICTS: dict[str, Any] = {
    "use": lambda v, r: _one(
        f"use {v} (is {r.use})", {r.use, r.programme.use} & set(v if isinstance(v, list) else [v]) != set()
    ),
    "storeys": lambda v, r: _one(
        f"{v} storeys (has {r.programme.storeys})",
        r.programme.storeys >= int(v.rstrip("+")) if isinstance(v, str) else r.programme.storeys == v,
    ),
    "rooms": _rooms,
    "area": lambda v, r: _one(f"{v} m2 (is {r.area})", r.area is not None and abs(r.area - v) <= AREA * v),
    "most": lambda v, r: _one(f"at most {v} m2 (is {r.most})", r.most == v),
    "least": lambda v, r: _one(f"at least {v} m2 (is {r.least})", r.least == v),
    "room_most": _limits("most"),
    "room_least": _limits("least"),
    "people": lambda v, r: _one(f"{v} people (are {r.people})", r.people == v),
    "told": _told,
    "chat": _chat,
    "outside": _outside,
    "front": _side("front"),
    "back": _side("back"),
    "opposite": _how("opposite"),
    "not_through": _how("not through"),
    "unwanted": _unwanted,
    "areas": _areas,
    "join": _pairs(("door", "open")),
    "open": _pairs(("open",)),
    "near": _pairs(("near", "door", "open")),
    "apart": _pairs(("apart",)),
    "ground": _storey(True),
    "upper": _storey(False),
    "accessible": lambda v, r: _one("accessible", r.profile == "accessible"),
    "doors": lambda v, r: _one(f"doors of {v} m (is {r.doors})", r.doors == v),
    "halls": lambda v, r: _one(f"halls of {v} m (is {r.ways})", r.ways == v),
    "width": lambda v, r: _one(f"{v} m wide (is {r.width})", r.width == v),
    "depth": lambda v, r: _one(f"{v} m deep (is {r.depth})", r.depth == v),
    "shape": lambda v, r: _one(f"shape {v}", r.l_shape),
    "windows": lambda v, r: _one(f"windows on {v} sides (is {r.window_sides})", r.window_sides == v),
    "style": lambda v, r: _one(f"style {v}", all(v in text for text in room_requests(r).values())),
    "none": lambda v, r: iter([(f"no {w}", not any(is_kind(w, room, r) for room in r.programme.rooms)) for w in v]),
    "said": _said,
    "entrance": _entrance,
    "light": lambda v, r: _light(v, r, True),
    "dark": lambda v, r: _light(v, r, False),
}
