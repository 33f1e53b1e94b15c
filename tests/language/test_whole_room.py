"""What is said of all of a room or all of a surface: one colour, a stuff, carpet, tiles up to the ceiling."""

import pytest

from sceneweaver.language.read import read_by_rules


def finish(text, part):
    found = read_by_rules(text).finish_of(part)
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
    graph = read_by_rules("A bar, everything black apart from one stool, which is red.")
    assert graph.finish_of("everything") and not graph.exclusions
    assert [(e.category, e.color) for e in graph.entities] == [("stool", "red")]


@pytest.mark.parametrize("text", ["a den with three chairs, all black", "an office with an all-white desk"])
def test_things_in_a_colour_are_not_everything(text):
    graph = read_by_rules(text)
    assert graph.finish_of("everything") is None and graph.entities[0].color in ("black", "white")


@pytest.mark.parametrize(
    ("text", "material"),
    [("a concrete garage", "concrete"), ("a vaulted stone cellar", "stone"), ("a chapel of bare brick", "brick")],
)
def test_a_room_is_of_something(text, material):
    assert finish(text, "walls").material == material
    assert read_by_rules("a bathroom with a stone bath mat").finish_of("walls") is None


def test_floors_that_are_no_boards():
    assert finish("a barn with an earth floor", "floor").pattern == "earth"
    assert finish("a studio, cork floor", "floor").pattern == "cork"
    found = finish("a club, tartan carpet wall to wall", "floor")
    assert (found.material, found.pattern) == ("carpet", "tartan")
    assert read_by_rules("a club with a tartan rug").finish_of("floor") is None


def test_tiles_up_to_the_ceiling_and_a_dado():
    assert finish("a shower room tiled to the ceiling in mint", "tiled").color == "mint"
    found = finish("a hall with a dado in plum", "lower")
    assert (found.color, found.high) == ("plum", pytest.approx(0.9))
    assert finish("a hall, walls ivory above and plum below", "walls").color == "ivory"


def test_the_colour_of_stuff_is_not_the_rooms():
    assert read_by_rules("a hangar with brown dust at the door").colors == ()


def test_stuff_and_metals_that_are_said_of_the_room():
    assert finish("a workshop with sawdust on the boards", "floor").material == "wood"
    assert read_by_rules("a bar with three stools, brass everywhere").colors == ("brass",)
    assert finish("a den, walls half panelled in teak", "panels").color == "teak"


def test_what_is_denied_is_no_finish():
    graph = read_by_rules("a den, no white walls")
    assert graph.finish_of("walls") is None and [left.words for left in graph.unread] == ["white"]


def test_what_a_thing_holds_is_not_its_colour():
    graph = read_by_rules("a stable with a crate of sand")
    assert graph.entities[0].color is None and [left.words for left in graph.unread] == ["sand"]


@pytest.mark.parametrize(
    ("text", "color", "material"),
    [
        ("a den with a rug with yellow stripes", "yellow", "striped"),
        ("a den with an armchair in a floral pattern", None, "floral"),
        ("a den with a pale pink sofa", "pale pink", None),
        ("a den with a blue tartan sofa", "blue", "tartan"),
    ],
)
def test_prints_and_shades_of_things(text, color, material):
    one = read_by_rules(text).entities[0]
    assert (one.color, one.material) == (color, material)


def test_things_in_the_order_of_their_colours():
    (books,) = read_by_rules("a library with twenty books sorted by colour").entities
    assert books.attributes[-1].value.startswith("each of red, orange, yellow")
