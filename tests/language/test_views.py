"""What people see from their seats, how far apart the middles of neighbours are, and tables told by their people."""

from __future__ import annotations

import pytest

from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "view"),
    [
        ("a lounge with six armchairs and a grand piano, everyone can see the piano", ("grand_piano", "see")),
        ("a study with a desk, nobody should sit with their back to the door", ("door", "not_back_to")),
        ("a den with four chairs, no one with his back to the window", ("window", "not_back_to")),
        ("a meeting room with a whiteboard, all guests facing the whiteboard", ("whiteboard", "face")),
    ],
)
def test_views_are_read(text: str, view: tuple[str, str]):
    graph = read_by_rules(text)
    assert [(one.target, one.kind) for one in graph.views] == [view]
    assert not [left.words for left in graph.unread]


def test_middles_of_neighbours_are_no_things():
    graph = read_by_rules("a gym with four spin bikes in a row whose centres are at least 1.3 m apart")
    (row,) = graph.arrangements
    assert (row.pitch, row.at_least, row.spacing) == (1.3, True, None)
    assert [e.category for e in graph.entities] == ["spin_bike"]


def test_tables_are_told_apart_by_their_people():
    graph = read_by_rules("a tavern with five tables for two and one for six in the middle")
    counts = {e.id: e.count for e in graph.entities}
    assert [(c.people, counts[c.target], c.each) for c in graph.capacities if c.target] == [
        (2, (5, 5), True),
        (6, (1, 1), False),
    ]


def test_people_in_all_tell_how_many_tables_there_are():
    graph = read_by_rules("a mess room that seats 20, tables of four")
    assert next(e for e in graph.entities if e.category == "dining_table").count == (5, 5)


def test_an_audience_is_in_rows():
    graph = read_by_rules("a union hall, 18 chairs facing a lectern")
    (rows,) = graph.arrangements
    assert (rows.pattern, rows.facing) == ("rows", "lectern")
    assert not read_by_rules("a lounge with two armchairs facing a fireplace").arrangements
