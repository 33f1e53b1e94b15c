"""The files of room types: they can be read, name what exists, and say where furniture goes."""

from __future__ import annotations

from collections import Counter
from importlib import resources

import pytest

from sceneweaver.assets import categories
from sceneweaver.knowledge import Item, Place, RoomType, match_room, room_types, surfaces
from sceneweaver.scene import CATALOGUE, InputError, Relation
from tests.for_each import for_each

ROOMS = room_types()
NAMES = sorted(ROOMS)
HOMES = (
    "attic_room",
    "balcony",
    "bathroom",
    "bedroom",
    "childrens_room",
    "dining_room",
    "game_room",
    "garage",
    "guest_toilet",
    "hallway",
    "home_gym",
    "home_theatre",
    "kitchen",
    "laundry_room",
    "living_room",
    "music_room",
    "nursery",
    "pantry",
    "studio_apartment",
    "study",
    "sunroom",
    "teen_bedroom",
    "walk_in_closet",
)
FLAT = 0.02
"""Height [m] below which a thing is a mat or rug that furniture stands through."""


def _mount(item: Item) -> str:
    """What holds the item: floor, wall, ceiling or surface."""
    return "surface" if item.on else item.mount or categories()[item.what[0]].mount[0]


def _height(item: Item) -> float:
    """Least height [m] of the item's first category."""
    size = categories()[item.what[0]].size
    assert size is not None
    return size.height[0]


def _relation(place: Place) -> Relation:
    """The relation that a line of a file becomes, between stand-ins for the objects."""
    kind = CATALOGUE[place.type].target
    target: str | None = "other"
    if kind.startswith("window"):
        target = "window-0"
    elif kind.startswith("object"):
        assert place.to, f"{place.type} needs an item"
    else:
        target = None
    return Relation(type=place.type, subject="one", target=target, params=place.params, hard=not place.soft)


def _pieces(room_type: RoomType, item: Item) -> int:
    """Objects that the item is at the room's usual size."""
    own = item.count.of(room_type.area[1], room_type.people, 0.5)
    return own * (_pieces(room_type, room_type.item(item.with_)) if item.with_ else 1)


def test_there_are_many_and_each_file_is_named_as_its_room() -> None:
    folder = resources.files("sceneweaver.knowledge").joinpath("rooms")
    files = {f.name.removesuffix(".yaml") for f in folder.iterdir() if f.name.endswith(".yaml")}
    assert files == set(NAMES)
    assert len(NAMES) >= 40
    assert set(HOMES) <= set(NAMES)


def test_lines_are_at_most_120_characters() -> None:
    folders = (resources.files("sceneweaver.knowledge").joinpath(name) for name in ("rooms", "groups"))
    long = [
        f"{f.name}:{n}"
        for folder in folders
        for f in folder.iterdir()
        for n, line in enumerate(f.read_text(encoding="utf-8").splitlines(), 1)
        if len(line) > 120
    ]
    assert not long


def test_a_word_means_one_room() -> None:
    said: dict[str, str] = {}
    for room in ROOMS.values():
        for word in {room.name.replace("_", " "), *(w.lower() for w in room.words)}:
            assert said.setdefault(word, room.name) == room.name, f"{word}: {said[word]} and {room.name}"


@pytest.mark.parametrize(
    "words, name",
    [
        ("home office", "study"),
        ("garage", "garage"),
        ("powder room", "guest_toilet"),
        ("home cinema", "home_theatre"),
        ("Baby Room", "nursery"),
        ("teenager's room", "teen_bedroom"),
        ("walk-in closet", "walk_in_closet"),
        ("dinning room", "dining_room"),
        ("kitchens", "kitchen"),
    ],
)
def test_people_find_rooms_by_their_own_words(words: str, name: str) -> None:
    found = match_room(words)
    assert found is not None
    assert found[0] == name


@for_each(NAMES)
def test_all_that_a_room_names_exists(name: str) -> None:
    room, known = ROOMS[name], categories()
    assert room.sources and all(len(source.split()) >= 2 for source in room.sources)
    for object_id in room.made_of:
        room.item(object_id)
    for item in room.items:
        for what in item.what:
            assert what in known, f"{item.id}: {what} is no category"
            assert known[what].size is not None, f"{item.id}: {what} is a group"
            mounts = known[what].mount
            assert item.mount is None or item.mount in mounts, f"{item.id}: {what} is not held by {item.mount}"
        if item.top:
            surfaces.arrangement(item.top)
        if item.fill:
            surfaces.crowd(item.fill)


@for_each(NAMES)
def test_relations_are_those_of_the_catalogue(name: str) -> None:
    room = ROOMS[name]
    for item in room.items:
        kinds = Counter((p.type, p.to) for p in item.place)
        assert max(kinds.values(), default=1) == 1, f"{item.id}: the same relation twice"
        for place in item.place:
            relation = _relation(place)
            assert relation.hard is not place.soft
            if place.to == item.id:
                assert item.count.most > 1 or item.row, f"{item.id}: {place.type} to itself, of which there is one"
            if place.type == "above":
                assert _mount(item) in ("wall", "ceiling"), f"{item.id}: what is above something has to hang"


@for_each(NAMES)
def test_numbers_are_plausible(name: str) -> None:
    room = ROOMS[name]
    least, usual, most = room.area
    assert 1.2 <= least <= usual <= most <= 600.0
    assert 1.0 <= room.aspect[0] <= room.aspect[1] <= 3.0
    assert 2.2 <= room.height <= 6.0
    for opening in (room.doors, room.windows):
        assert 0.4 <= opening.width[0] <= opening.width[1]
        assert opening.height[0] <= opening.height[1] < room.height
    assert room.windows.sill[1] + room.windows.height[1] <= room.height
    assert 2 <= sum(item.need == "needed" for item in room.items) <= 14
    for item in room.items:
        assert 0 <= item.count.least <= item.count.most <= 400
        for size in item.size:
            assert size is None or 0.0 < size[0] <= size[1]
        if item.bottom:
            assert 0.0 <= item.bottom[0] <= item.bottom[1] < room.height
            assert item.bottom[0] + _height(item) < room.height


@for_each(NAMES)
def test_what_stands_on_the_floor_is_told_where(name: str) -> None:
    room = ROOMS[name]
    floor = [i for i in room.items if _mount(i) == "floor"]
    pieces = sum(_pieces(room, i) for i in floor)
    assert pieces >= 5
    # From the tool that reads the files a seat at a table also gets a relation that squares it.
    told = sum((len(i.place) + any(p.type == "front_against" for p in i.place)) * _pieces(room, i) for i in floor)
    assert told / pieces >= 1.2
    for item in floor:
        assert item.place or _height(item) < FLAT, f"{item.id} has no relation"


LEAST = frozenset(("overlap", "min"))
"""Parameters that are stricter the larger they are; the others are stricter the smaller."""

OWN = frozenset(("gap", "max", "min"))
"""Parameters that say what is meant; the others only how exactly it has to be so."""

EXACT = ("against_wall", "side_against_wall", "aligned", "parallel", "centered_on", "front_against", "front_to_front")
EXACT += ("leftright_to_leftright", "side_by_side", "back_to_back", "around", "at_window")


@for_each(NAMES)
def test_what_has_to_hold_is_no_looser_than_the_catalogue_says(name: str) -> None:
    for item in ROOMS[name].items:
        for place in item.place:
            if place.soft or place.type not in EXACT:
                continue
            spec = CATALOGUE[place.type]
            for key, value in place.params.items():
                usual = spec.value(None, key)
                if key in OWN or not isinstance(usual, float | int):
                    continue
                looser = value < usual if key in LEAST else value > usual
                assert not looser, f"{item.id}: {place.type} {key} {value}, usually {usual}"


@for_each(NAMES)
def test_nothing_is_needed_that_cannot_fit(name: str) -> None:
    room, area = ROOMS[name], 0.0
    for item in room.items:
        size = categories()[item.what[0]].size
        if item.need != "needed" or _mount(item) != "floor" or _height(item) < FLAT or size is None:
            continue
        d, w = (own[0] if mine is None else mine[0] for own, mine in zip(size.ranges[:2], item.size[:2], strict=True))
        area += d * w * _pieces(room, item) * (0.5 if item.with_ else 1.0)
    assert area <= 0.45 * room.area[1]


def test_nightstands_stand_at_the_wall_beside_the_bed() -> None:
    hard = {(p.type, p.to) for p in ROOMS["bedroom"].item("nightstand").place if not p.soft}
    assert {("leftright_to_leftright", "bed"), ("against_wall", None)} <= hard


def test_a_name_that_is_no_arrangement_is_refused() -> None:
    with pytest.raises(InputError):
        surfaces.arrangement("no_such_arrangement")
    with pytest.raises(ValueError, match="is no item"):
        RoomType(
            name="x",
            description="x",
            sources=(),
            area=(4, 5, 6),
            doors={"width": (0.8, 0.8), "height": (2, 2)},  # type: ignore[arg-type]
            windows={"width": (1, 1), "height": (1, 1)},  # type: ignore[arg-type]
            items=({"id": "bed", "what": "bed", "place": ["near lamp"]},),  # type: ignore[arg-type]
        )
