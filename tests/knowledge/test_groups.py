"""Templates of groups: what a room's file makes of them, and what is wrong in one."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.knowledge import RoomType, room_types
from sceneweaver.knowledge.groups import GroupTemplate, expanded
from sceneweaver.knowledge.load import group_templates
from sceneweaver.scene import InputError

SEATING = GroupTemplate(
    name="seating",
    description="Seats around a table.",
    sources=("made up",),
    items=(
        {"id": "sofa", "what": ["sofa", "loveseat"], "need": "needed", "place": ["against_wall", "soft facing tv"]},
        {"id": "tv", "what": "tv_stand", "place": ["against_wall"]},
        {"id": "table", "what": "coffee_table", "with": "sofa", "place": ["front_to_front sofa"]},
        {"id": "bowl", "what": "bowl", "on": ["table"]},
    ),
)
PLAIN: dict[str, Any] = {
    "name": "lounge",
    "description": "x",
    "sources": ["x"],
    "area": [8, 12, 20],
    "doors": {"width": [0.8, 0.9], "height": [2.0, 2.0]},
    "windows": {"width": [1.0, 1.2], "height": [1.2, 1.2]},
}
LAMP = {"id": "lamp", "what": "floor_lamp", "with": "sofa", "place": ["near tv"]}


def _room(*groups: dict[str, Any], items: tuple[dict[str, Any], ...] = ()) -> RoomType:
    return RoomType(**expanded({**PLAIN, "groups": groups, "items": items}, {"seating": SEATING}))


def _lines(room: RoomType, item_id: str) -> list[tuple[str, str | None, bool]]:
    return [(p.type, p.to, p.soft) for p in room.item(item_id).place]


def test_a_group_becomes_plain_items_before_those_of_the_room() -> None:
    room = _room(
        {"use": "seating"}, items=({"id": "lamp", "what": "floor_lamp", "with": "sofa", "place": ["near tv"]},)
    )
    assert [i.id for i in room.items] == ["sofa", "tv", "table", "bowl", "lamp"]
    assert [i.group for i in room.items] == ["seating"] * 4 + [None]
    assert room.item("sofa").what == ("sofa", "loveseat") and room.item("sofa").need == "needed"
    assert _lines(room, "sofa") == [("against_wall", None, False), ("facing", "tv", True)]


def test_what_a_room_says_otherwise_holds() -> None:
    change = {"what": "sectional_sofa", "count": 2, "need": "optional", "size": [None, [2.0, 2.2], None]}
    more = {"also": ["facing tv", "away_from_door"]}
    room = _room({"use": "seating", "items": {"sofa": {**change, **more}, "table": {"place": ["near sofa"]}}})
    sofa = room.item("sofa")
    assert (sofa.what, sofa.count.most, sofa.need) == (("sectional_sofa",), 2, "optional")
    assert sofa.size[1] == (2.0, 2.2)
    assert _lines(room, "sofa") == [
        ("against_wall", None, False),
        ("facing", "tv", False),  # said anew, no longer soft
        ("away_from_door", None, False),
    ]
    assert _lines(room, "table") == [("near", "sofa", False)]


def test_what_is_dropped_takes_the_relations_to_it_along() -> None:
    room = _room({"use": "seating", "drop": ["tv"]})
    assert [i.id for i in room.items] == ["sofa", "table", "bowl"]
    assert _lines(room, "sofa") == [("against_wall", None, False)]


def test_a_second_use_has_ids_of_its_own() -> None:
    room = _room({"use": "seating"}, {"use": "seating", "as": "guest", "drop": ["tv"]})
    assert [i.id for i in room.items][4:] == ["guest_sofa", "guest_table", "guest_bowl"]
    assert room.item("guest_table").with_ == "guest_sofa" and room.item("guest_bowl").on == ("guest_table",)
    assert _lines(room, "guest_table") == [("front_to_front", "guest_sofa", False)]
    assert {i.group for i in room.items} == {"seating", "guest_seating"}


@pytest.mark.parametrize(
    "group, said",
    [
        ({"use": "seeting"}, 'group "seeting" is unknown; did you mean "seating"'),
        ({"use": "seating", "drop": ["sofaa"]}, 'there is no item "sofaa"; did you mean "sofa"'),
        ({"use": "seating", "items": {"chair": {}}}, 'there is no item "chair"'),
        ({"use": "seating", "drop": ["sofa"]}, "table goes with sofa, which is dropped"),
        ({"use": "seating", "drop": ["table"]}, "bowl goes with table, which is dropped"),
        ({"use": "seating", "items": {"sofa": {"counts": 2}}}, "counts"),
        ({"use": "seating", "items": {"sofa": {"also": ["nearby tv"]}}}, "nearby is no relation"),
        ({"use": "seating", "items": {"sofa": {"also": ["near lamp"]}}}, "near names lamp, which is no item"),
        ({"uses": "seating"}, "uses"),
    ],
)
def test_what_is_wrong_is_said(group: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said):
        _room(group)


def test_an_id_that_comes_twice_is_refused() -> None:
    with pytest.raises(InputError, match="two items are called sofa"):
        _room({"use": "seating"}, {"use": "seating", "drop": ["tv", "table", "bowl"]})


def test_a_template_names_only_itself_and_the_room() -> None:
    with pytest.raises(InputError, match="bed, which is no item"):
        GroupTemplate(
            name="x", description="x", sources=("x",), items=({"id": "a", "what": "desk", "place": ["near bed"]},)
        )


def test_every_template_is_named_as_its_file_has_sources_and_is_used() -> None:
    templates = group_templates()
    used = {item.group or "" for room in room_types().values() for item in room.items}
    for name, template in templates.items():
        assert template.sources and template.description
        assert any(group == name or group.endswith(f"_{name}") for group in used), f"no room uses {name}"
