"""Surfaces of the room: bands, several parts at once, patterns, single walls, doors."""

import pytest

from sceneweaver.language.read import read_by_rules


def finish(text, part):
    found = read_by_rules(text).finish_of(part)
    assert found is not None, text
    return found


@pytest.mark.parametrize(
    ("text", "part", "color", "high", "above"),
    [
        ("a dairy, walls in navy to hip height and cream above", "lower", "navy", 0.95, "cream"),
        ("a fishmonger's, blue metro tiles up to 1.6 m, white paint over it", "tiled", "blue", 1.6, "white"),
        ("a den with oak panelling to 1.2 m, green wallpaper above that", "panels", "oak", 1.2, "green"),
        ("a gym: walls half grey, half yellow", "lower", "grey", 1.2, "yellow"),
    ],
)
def test_bands(text, part, color, high, above):
    found = finish(text, part)
    assert (found.color, found.high) == (color, pytest.approx(high))
    assert finish(text, "walls").color == above


@pytest.mark.parametrize(
    ("text", "pattern", "colors"),
    [
        ("a canteen with a red and cream checkerboard floor", "checkered", ("red", "cream")),
        ("a hall, tiled floor in grey and white diamonds", "checkered", ("grey", "white")),
        ("an attic with a herringbone floor", "herringbone", (None, None)),
        ("a bank, terrazzo floor", "terrazzo", ("light grey", None)),
        ("a hut with slate tiles on the floor", "slate", ("slate", None)),
    ],
)
def test_floors_in_a_pattern(text, pattern, colors):
    found = finish(text, "floor")
    assert (found.pattern, (found.color, found.second)) == (pattern, colors)


def test_what_lies_on_the_floor_is_no_floor():
    assert read_by_rules("a shed with wood shavings on the floor").finish_of("floor") is None


def test_several_parts_in_one_look_and_each_in_its_own():
    for part in ("walls", "ceiling", "floor"):
        assert finish("a studio, walls, ceiling and floor grey", part).color == "grey"
    text = "an office with cream walls, ceiling blue"
    assert (finish(text, "walls").color, finish(text, "ceiling").color) == ("cream", "blue")


def test_one_wall_and_the_others():
    text = "a bar, exposed brick on one wall, the others painted olive"
    assert (finish(text, "accent").material, finish(text, "walls").color) == ("brick", "olive")
    assert finish("a den, the left wall is teal", "accent").where == "left"


def test_paper_and_doors():
    found = finish("a nursery with floral wallpaper", "walls")
    assert (found.material, found.pattern) == ("paper", "botanical")
    found = finish("a hall with yellow and white striped wallpaper", "walls")
    assert (found.pattern, found.color, found.second) == ("stripes", "yellow", "white")
    assert finish("a lodge with a red door", "doors").color == "red"


def test_floors_of_earth():
    found = finish("a barn with a packed earth floor", "floor")
    assert (found.material, found.color) == ("concrete", "brown")


def test_a_cellar_of_brick_has_walls_of_it():
    found = finish("a vaulted brick cellar with a rack", "walls")
    assert (found.material, found.color) == ("brick", "brick red")
