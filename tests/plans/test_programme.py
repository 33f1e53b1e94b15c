"""Programmes: files, tables, graphs, the thirty that ship, and what is wrong with a bad one in one line."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from typing import Any

import pytest

from sceneweaver.io import InputError
from sceneweaver.plans import Adjacency, Programme, envelope_for, programme_names, room_types

ROOMS = [{"id": "hall", "type": "entrance_hall"}, {"id": "bed", "type": "bedroom", "area": 12}]


def test_thirty_programmes_ship():
    uses = [Programme.example(name).use for name in programme_names()]
    assert {use: uses.count(use) for use in uses} == {"flat": 14, "house": 8, "clinic": 4, "office": 4}


@pytest.mark.parametrize("name", programme_names())
def test_each_programme_can_be_met(name: str):
    """Names agree, every room is joined to the entrance, and its envelope has floor and walls for all rooms."""
    programme = Programme.example(name).with_storeys()
    assert programme.name == name
    assert programme.storeys == (2 if programme.use == "house" else 1)
    joined = {programme.entrance} | {room.id for room in programme.rooms if room.type == "stairs"}
    for _ in programme.rooms:
        joined |= {
            other
            for x in programme.adjacencies
            for here, other in ((x.a, x.b), (x.b, x.a))
            if x.kind in ("door", "open") and here in joined and programme.room(here).kind.transit != "none"
        }
    loose = {room.id for room in programme.rooms} - joined
    # What no door is asked for may hang on any hall; it stays near something.
    assert all(any(room in (x.a, x.b) for x in programme.adjacencies) for room in loose)
    for seed in range(3):
        envelope = envelope_for(programme, seed)
        w = envelope.inner[2][0] - envelope.inner[0][0]
        assert w > 0
        for storey in range(programme.storeys):
            rooms = [room for room in programme.rooms if room.storey == storey]
            least, most = (sum(room.area[k] for room in rooms) for k in (0, 2))
            assert least < 0.93 * inner_area(envelope.inner) and 0.97 * inner_area(envelope.inner) < most


def inner_area(corners: Any) -> float:
    pairs = zip(corners, (*corners[1:], corners[0]), strict=True)
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2


def test_files_come_back_the_same(tmp_path: Path):
    for name in programme_names():
        programme = Programme.example(name)
        programme.save(tmp_path / "p.yaml")
        assert Programme.load(tmp_path / "p.yaml") == programme == Programme.loads(programme.dumps())


def test_tables_of_texts():
    rows = ("id,type,area,storey,doors,near", "hall,entrance_hall,,,,", "living,living_kitchen,26,0,hall,")
    table = "\n".join((*rows, "bath,bathroom,4.5,,hall,living"))
    programme = Programme.from_table(csv.DictReader(io.StringIO(table)), name="small")
    assert programme.room("living").area == (20.8, 26.0, 33.8) and programme.room("living").storey == 0
    assert programme.room("hall").area == room_types()["entrance_hall"].area
    assert [(x.a, x.b, x.kind) for x in programme.adjacencies] == [
        ("living", "hall", "door"),
        ("bath", "hall", "door"),
        ("bath", "living", "near"),
    ]


def test_a_pair_that_both_rows_name_counts_once():
    rows = [{"id": "a", "type": "hallway", "doors": "b"}, {"id": "b", "type": "bedroom", "doors": ["a"]}]
    assert Programme.from_table(rows).adjacencies == (Adjacency(a="a", b="b"),)


def test_bubble_graphs():
    programme = Programme.from_graph(
        {"hall": "hall", "bed": ("bedroom", [10, 14]), "bath": {"type": "bathroom", "side": 1.7}},
        [("hall", "bed"), ("hall", "bath"), ("bed", "bath", "near")],
    )
    assert programme.entrance == "hall"
    assert programme.room("bed").area == (10.0, 12.0, 14.0) and programme.room("bath").side == 1.7
    assert programme.adjacencies[2].kind == "near"


def test_rooms_get_storeys_and_stairs():
    programme = Programme.from_graph(
        {
            **{"hall": "entrance_hall", "living": "living_kitchen", "landing": "landing"},
            **{"bed": "master_bedroom", "ensuite": "ensuite", "child": "childrens_room", "bath": "bathroom"},
        },
        [("hall", "living"), ("landing", "bed"), ("bed", "ensuite"), ("landing", "child"), ("landing", "bath")],
        use="house",
        storeys=2,
    ).with_storeys()
    storeys = {room.id: room.storey for room in programme.rooms}
    assert storeys == {
        **{"hall": 0, "living": 0, "stairs-0": 0},
        **{"landing": 1, "bed": 1, "ensuite": 1, "child": 1, "bath": 1, "stairs-1": 1},
    }
    assert [x for x in programme.adjacencies if x.kind == "open"] == [
        Adjacency(a="hall", b="stairs-0", kind="open"),
        Adjacency(a="landing", b="stairs-1", kind="open"),
    ]
    assert programme.with_storeys() == programme


@pytest.mark.parametrize(
    ("fields", "line"),
    [
        ({"rooms": []}, "programme: rooms has 0 entries; give at least 1"),
        (
            {"rooms": [*ROOMS, {"id": "bed", "type": "bedroom"}]},
            "rooms[2] 'bed': id is \"bed\", as of room 1; rename one",
        ),
        ({"rooms": [{"id": "a", "type": "bedrom"}]}, 'rooms[0] \'a\': type is "bedrom"; did you mean "bedroom"?'),
        (
            {"rooms": [{"id": "a", "type": "bedroom", "area": "big"}]},
            "rooms[0] 'a': area is \"big\"; give the target, or",
        ),
        (
            {"rooms": [{"id": "a", "type": "bedroom", "area": [9, 8, 12]}]},
            "rooms[0] 'a': area is [9, 8, 12]; least, target",
        ),
        ({"rooms": [{"id": "a", "type": "bedroom", "area": -3}]}, "rooms[0] 'a': area[0] is -2.4"),
        ({"rooms": [{"id": "a", "type": "bedroom", "area": float("nan")}]}, "rooms[0] 'a': area"),
        (
            {"rooms": [{"id": "a", "type": "bedroom", "area": 9, "side": 5.0}]},
            "rooms[0] 'a': side is 5 m, but area is at most",
        ),
        ({"rooms": [{"id": "a", "type": "hall", "storey": 1}]}, "rooms[0] 'a': storey is 1; storeys is 1, so 0 to 0"),
        ({"rooms": [{"id": "a", "type": "hall", "colour": "red"}]}, "rooms[0] 'a': unknown key \"colour\""),
        ({"rooms": ROOMS, "entrance": "door"}, 'entrance is "door"; rooms are: hall, bed'),
        ({"rooms": ROOMS, "storeys": 9}, "storeys is 9"),
        ({"rooms": ROOMS, "use": "castle"}, "use is"),
        ({"rooms": ROOMS, "adjacencies": [["hall", "bath"]]}, 'adjacencies[0].b is "bath"; rooms are'),
        ({"rooms": ROOMS, "adjacencies": [["hall", "hall"]]}, 'adjacencies[0]: a and b are both "hall"'),
        ({"rooms": ROOMS, "adjacencies": [["hall", "bed"], ["bed", "hall", "apart"]]}, "are door and apart; keep one"),
        ({"rooms": ROOMS, "adjacencies": [["hall", "bed", "touching"]]}, "adjacencies[0].kind is"),
        ({"rooms": [ROOMS[1]]}, '"entrance" is missing; add it'),
    ],
)
def test_what_is_wrong_is_said_in_one_line(fields: dict[str, Any], line: str):
    with pytest.raises(InputError) as said:
        Programme(**fields)
    assert line in str(said.value) and "\n" not in str(said.value)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("- a\n- b\n", "p.yaml: programme is"),
        ("rooms: {", "p.yaml: cannot be read as YAML"),
        ("rooms: &x [1]\n", "p.yaml: line 1: anchors"),
        ("rooms: [{id: a, type: hall}]\nadjacencies: [[a, b]]\n", 'p.yaml: programme: adjacencies[0].b is "b"'),
    ],
)
def test_bad_files_are_named(tmp_path: Path, text: str, line: str):
    (tmp_path / "p.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as said:
        Programme.load(tmp_path / "p.yaml")
    assert line in str(said.value) and "\n" not in str(said.value)


def test_bad_tables_and_graphs():
    with pytest.raises(InputError, match=r"rows\[0\]: is 3; give an object"):
        Programme.from_table([3])  # type: ignore[list-item]
    with pytest.raises(InputError, match=r"nodes\.a: is 3; give a type"):
        Programme.from_graph({"a": 3})
    with pytest.raises(InputError, match='programme "palace" is not known'):
        Programme.example("palace")
    with pytest.raises(InputError, match='room "attic" is not in'):
        Programme.example("flat-studio").room("attic")
