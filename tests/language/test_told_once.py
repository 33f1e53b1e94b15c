"""How many things a request names: what is told of each, what is named a second time, what is no thing at all."""

from __future__ import annotations

import pytest

from sceneweaver.language import SceneGraph
from sceneweaver.language.read import read_by_rules


def _counts(text: str) -> dict[str, int]:
    """How many of each category there are at least."""
    found: dict[str, int] = {}
    for entity in read_by_rules(text).entities:
        found[entity.category] = found.get(entity.category, 0) + (entity.count or (1, 1))[0]
    return found


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("a sewing class with six sewing machines, one each, and a lamp each", {"sewing_machine": 6, "table_lamp": 6}),
        ("an art room with five easels, one for each pupil", {"easel": 5}),
        ("six desk lamps, one per desk, six desks", {"desk_lamp": 6, "desk": 6}),
        ("a sofa and three armchairs, a cushion on each", {"sofa": 1, "armchair": 3, "cushion": 4}),
        ("eight desks, every second one with a monitor", {"desk": 8, "monitor": 4}),
        ("three beds, one of them is a bunk bed", {"bed": 2, "bunk_bed": 1}),
        ("two tables, each with 3 chairs for guests and 1 for the host", {"dining_table": 2, "chair": 8}),
        ("three beds. Locker + chair + rug per bed", {"bed": 3, "locker": 3, "chair": 3, "rug": 3}),
        ("a jug on the shelf for every four players, eight stools", {"pitcher": 2, "wall_shelf": 1, "stool": 8}),
        ("two round and three square stools", {"stool": 5}),
        ("four tanks, each with a lamp, one 2 m terrarium on the floor", {"tank": 4, "table_lamp": 4, "terrarium": 1}),
        ("four nail tables, two chairs per table one for the client one for the maker", {"nail_table": 4, "chair": 8}),
        ("three stations with a couch, a stool and a lamp each", {"sofa": 3, "stool": 3, "table_lamp": 3}),
        ("two armchairs, one floor lamp near both", {"armchair": 2, "floor_lamp": 1}),
        ("his and hers basins, one mirror over both", {"wall_basin": 2, "wall_mirror": 1}),
        ("6 pews each side of the aisle", {"public_bench": 12}),
        ("a hall with 30 chairs in 5 rows of 6, one chair broken", {"chair": 30}),
        ("a sushi bar, 10 seats, no tables", {"chair": 10}),
        ("pews facing the altar, 6 pews in total", {"public_bench": 6, "altar": 1}),
        ("a yoga room with mats x8, plants 5 or more", {"yoga_mat": 8, "potted_plant": 5}),
        ("a chapel with 40 seats, benches in the middle", {"public_bench": 2}),
    ],
)
def test_numbers(text: str, counts: dict[str, int]) -> None:
    found = _counts(text)
    assert {name: found.get(name) for name in counts} == counts
    assert sum(found.values()) == sum(counts.values()), found


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("a baby grand by the window, the sofa faces the piano", {"grand_piano": 1, "sofa": 1}),
        ("a cast iron stove in the corner. stove is black", {"wood_stove": 1}),
        ("two wooden crates by the door, a lamp on the boxes", {"wooden_crate": 2}),
        ("a milk crate as a side table next to the sofa", {"wooden_crate": 1, "sofa": 1}),
        ("a toy chest that doubles as a bench, a cushion on the bench", {"toy_chest": 1, "cushion": 1}),
        ("a plank used as a desk with a chair", {"desk": 1, "chair": 1}),
        ("a stool, i.e. a bar stool, in the corner", {"bar_stool": 1}),
        ("either a bench or two chairs by the door", {"bench": 1}),
        ("a recliner by the window, the chair faces the door", {"recliner": 1}),
        ("a bookshelf made from crates", {"bookcase": 1}),
        ("instead of a wardrobe a clothes rail by the door", {"clothes_rack": 1}),
    ],
)
def test_a_second_name_makes_no_second_thing(text: str, counts: dict[str, int]) -> None:
    found = _counts(text)
    assert {name: found.get(name) for name in counts} == counts
    assert set(found) - set(counts) <= {"table_lamp"}


def _graph(text: str) -> SceneGraph:
    return read_by_rules(text)


def test_what_is_said_of_the_role_is_said_of_the_thing() -> None:
    graph = _graph("a milk crate as a table, a lamp on the table")
    (on,) = (r for r in graph.relations if r.type == "on")
    assert on.targets == ("wooden_crate",)
    (role,) = (a for e in graph.entities for a in e.attributes if a.kind == "other")
    assert role.value == "as table"
    assert graph.text[role.span.start : role.span.end].strip(" ,") == "as a table"  # type: ignore[union-attr]


def test_what_has_no_body_is_told_as_not_understood() -> None:
    graph = _graph("a plank used as a desk with a chair")
    assert any("plank" in unread.words for unread in graph.unread)


def test_instead_of_is_not_wanted() -> None:
    graph = _graph("a bedroom with a clothes rail instead of a wardrobe")
    assert any("wardrobe" in e.categories for e in graph.exclusions)
    two = _graph("two small tables instead of one large table")
    assert not any("dining_table" in e.categories for e in two.exclusions)


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("a window of blue glass", "drinking_glass"),
        ("a chisel rack with slots in oak", "slot_machine"),
        ("a canteen where the staff eat, lockers for the staff", "staff"),
        ("a bird bath by the door", "bathtub"),
        ("a conservatory with a bed of roses", "bed"),
    ],
)
def test_no_thing_where_it_stands(text: str, never: str) -> None:
    assert never not in _counts(text)


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a table set with plate, glass and napkin", "drinking_glass"),
        ("a cheese shop with a big wheel on the counter", "cheese_wheel"),
        ("a violin next to the music rack", "music_stand"),
    ],
)
def test_senses_by_the_words_around(text: str, category: str) -> None:
    assert category in _counts(text)


def test_bounds_before_their_numbers() -> None:
    """A bound is no exclusion, and its words make no thing."""
    graph = read_by_rules("at least ten plants and no more than one mirror, max 2 tables")
    counts = {e.category: e.count for e in graph.entities}
    assert counts == {"potted_plant": (10, 14), "wall_mirror": (1, 1), "dining_table": (1, 2)}
    assert not graph.exclusions and not graph.unread
