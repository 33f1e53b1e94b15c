"""What is said of all of a room or all of a surface: one colour, a stuff, carpet, tiles up to the ceiling."""

import pytest

from sceneweaver.language import read_request


def finish(text, part):
    found = read_request(text).finish_of(part)
    assert found is not None, text
    return found


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("A parlour for two. All dusty pink except the piano.", ("dusty pink", None)),
        ("a study, everything in olive and cream", ("olive", "cream")),
        ("an all-navy bathroom", ("navy", None)),
        ("a gym with four mats, lilac everywhere", ("lilac", None)),
        ("a playroom in every shade of green", ("green", None)),
    ],
)
def test_everything_in_a_colour(text, colors):
    found = finish(text, "everything")
    assert (found.color, found.second) == colors


def test_what_is_excepted_stays():
    graph = read_request("A bar, everything black apart from one stool, which is red.")
    assert graph.finish_of("everything") and not graph.exclusions
    assert [(e.category, e.color) for e in graph.entities] == [("stool", "red")]


@pytest.mark.parametrize("text", ["a den with three chairs, all black", "an office with an all-white desk"])
def test_things_in_a_colour_are_not_everything(text):
    graph = read_request(text)
    assert graph.finish_of("everything") is None and graph.entities[0].color in ("black", "white")


@pytest.mark.parametrize(
    ("text", "material"),
    [("a concrete garage", "concrete"), ("a vaulted stone cellar", "stone"), ("a chapel of bare brick", "brick")],
)
def test_a_room_is_of_something(text, material):
    assert finish(text, "walls").material == material
    assert read_request("a bathroom with a stone bath mat").finish_of("walls") is None


def test_floors_that_are_no_boards():
    assert finish("a barn with an earth floor", "floor").pattern == "earth"
    assert finish("a studio, cork floor", "floor").pattern == "cork"
    found = finish("a club, tartan carpet wall to wall", "floor")
    assert (found.material, found.pattern) == ("carpet", "tartan")
    assert read_request("a club with a tartan rug").finish_of("floor") is None


def test_tiles_up_to_the_ceiling_and_a_dado():
    assert finish("a shower room tiled to the ceiling in mint", "tiled").color == "mint"
    found = finish("a hall with a dado in plum", "lower")
    assert (found.color, found.high) == ("plum", pytest.approx(0.9))
    assert finish("a hall, walls ivory above and plum below", "walls").color == "ivory"


def test_the_colour_of_stuff_is_not_the_rooms():
    assert read_request("a hangar with brown dust at the door").colors == ()
