"""Built parts of rooms that things stand in, at and on, and what divides them."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


def _said(text: str) -> list[tuple[str, str, tuple[str, ...]]]:
    return [(said.subject, said.type, said.targets) for said in read_by_rules(text).relations]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a den with a desk in the alcove", ("desk", "against", ("wall:niche",))),
        ("a den with an alcove with a bookcase", ("bookcase", "against", ("wall:niche",))),
        ("a hall with a recess where a bench stands", ("bench", "against", ("wall:niche",))),
        ("a parlour, a sideboard centred on its chimney breast", ("sideboard", "centered_on", ("wall:breast",))),
        ("a lounge, a bookcase on either side of the chimney breast", ("bookcase", "against", ("wall:beside_breast",))),
        ("a kitchen with the stove inside the chimney breast", ("stove", "against", ("wall:breast_opening",))),
        ("a lounge with an armchair in the bay window", ("armchair", "against", ("wall:bay",))),
        ("a hall with a window seat", ("window_seat", "at", ("window",))),
        ("a chapel with a dais at the far wall", ("stage_platform", "against", ("wall:far",))),
        ("a bakehouse with a window over the sink", ("sink_cabinet", "below", ("window",))),
        ("a bedroom, a window opposite the bed", ("bed", "opposite", ("window",))),
        ("a chapel, an altar in the middle of the far wall", ("altar", "centered_on", ("wall:far",))),
        ("a loft, a half-height wall divides the bed from the sofa", ("low_wall", "between", ("bed", "sofa"))),
    ],
)
def test_places_of_built_parts(text: str, said: tuple[str, str, tuple[str, ...]]) -> None:
    assert said in _said(text), _said(text)


def test_a_part_that_is_only_named_is_asked_for() -> None:
    graph = read_by_rules("a lounge with a chimney breast, shelves in the alcoves either side of it")
    assert [(one.part, one.count) for one in graph.openings] == [("breast", 1), ("niche", 2)]
    assert read_by_rules("a lounge without an alcove").openings == ()


def test_a_low_wall_is_no_wall_of_the_room() -> None:
    graph = read_by_rules("an office with a low wall 1.1 m high")
    assert graph.height is None
    assert [(e.category, e.size[2]) for e in graph.entities] == [("low_wall", 1.1)]


def test_slopes_are_told_with_what_they_are_said_of() -> None:
    (slope,) = read_by_rules("an attic room, a chest is under the eaves").openings
    assert (slope.part, slope.words) == ("slope", "under the eaves")


@pytest.mark.parametrize(
    ("text", "part", "count"),
    [
        ("a chapel down five stone steps", "steps", 5),
        ("a barn with a trapdoor", "floor_opening", 1),
        ("a milking parlour, pit down the middle", "sunk_floor", 1),
        ("a vaulted cellar with a rack", "ceiling_shape", 1),
        ("an attic room with two skylights", "roof_window", 2),
    ],
)
def test_what_no_room_has_is_told(text: str, part: str, count: int) -> None:
    assert [(one.part, one.count) for one in read_by_rules(text).openings] == [(part, count)]
