"""What drawings make of the words about a thing, and what they say they cannot show."""

from __future__ import annotations

import pytest

from sceneweaver.assets import Library, Wish, categories, drawable
from sceneweaver.assets.materials import color_name, color_named, color_words, finishes_named, material_words, shade
from sceneweaver.assets.sources import ParametricSource
from sceneweaver.scene import InputError

OURS = Library([ParametricSource()])


def test_words_set_what_is_drawn() -> None:
    look = drawable("sofa", "large charcoal velvet")
    assert (look.color, look.material, look.unmet) == ("charcoal", "velvet", ())
    usual = categories()["sofa"].size
    assert usual is not None and look.size == tuple(high for _, high in usual.ranges)
    wish = Wish(look.size, look.color, look.material, seed=5)
    made = OURS.choose("sofa", wish=wish)[0]
    assert made.attributes["color"] == "grey" and made.attributes["material"].endswith("velvet")


def test_what_cannot_be_drawn_is_said() -> None:
    look = drawable("potted_plant", "velvet haunted")
    assert set(look.unmet) == {"velvet", "haunted"} and look.material is None


@pytest.mark.parametrize(
    ("category", "words", "narrower"),
    [("wall_mirror", "round", "round_mirror"), ("bed", "king size", "king_bed"), ("desk", "plain", "desk")],
)
def test_a_word_makes_a_thing_narrower(category: str, words: str, narrower: str) -> None:
    look = drawable(category, words)
    assert look.category == narrower and look.unmet == ()


@pytest.mark.parametrize("category", ["desk", "bookcase", "coffee_table", "chair", "wardrobe"])
@pytest.mark.parametrize("material", ["marble", "walnut", "bamboo", "brass", "concrete", "wicker", "teak"])
def test_hard_things_take_any_hard_material(category: str, material: str) -> None:
    for seed in range(3):
        made = OURS.choose(category, wish=Wish(material=material, seed=seed))[0]
        assert material in made.attributes["material"].split(), made.attributes


def test_every_word_for_a_colour_or_a_material_means_one() -> None:
    for word in color_words():
        assert len(shade(word)) == 3 and color_named(color_named(word)) == color_named(word)
    for word in material_words():
        assert finishes_named(word), word
    assert color_named("dove-gray") == "light grey" and color_named("dark sage") == "sage"
    assert color_name(shade("red")) == "red"
    with pytest.raises(InputError, match="color: 'dark octarine' is unknown"):
        color_named("dark octarine")


@pytest.mark.parametrize(
    ("category", "words", "part"),
    [("wardrobe", "three-door white", ("doors", 3)), ("filing_cabinet", "four drawer", ("drawers", 4))],
)
def test_counted_parts_are_drawn(category: str, words: str, part: tuple[str, int]) -> None:
    look = drawable(category, words)
    assert look.parts == (part,) and look.unmet == ()
    made = OURS.choose(category, wish=Wish(color=look.color, parts=look.parts, seed=4))[0]
    joint = "hinge" if part[0] == "doors" else "slide"
    assert sum(link.joint == joint for link in made.links) == part[1]
    assert drawable("pouf", "nine drawer").unmet == ("nine drawer",)


@pytest.mark.parametrize(
    ("category", "shape"), [("side_table", "square"), ("coffee_table", "square"), ("rug", "square")]
)
def test_a_shape_is_drawn(category: str, shape: str) -> None:
    look = drawable(category, shape)
    assert look.shape == shape and look.unmet == ()
    made = OURS.choose(category, wish=Wish(shape=look.shape, seed=9))[0]
    assert made.attributes["shape"] == shape and made.size[0] == pytest.approx(made.size[1], rel=0.12)


def test_a_name_may_say_what_was_asked() -> None:
    assert drawable("sofa", "three seater").unmet == ()
    assert drawable("tv", "65 inch").size[1] == pytest.approx(1.439, abs=0.001)


def test_a_labelled_body_takes_looks_and_loads_by_its_id() -> None:
    made = OURS.choose("zorb tower", wish=Wish(color="teal", mount="floor", seed=3))[0]
    assert made.category == "zorb_tower" and made.mount == "floor" and made.attributes["color"] == "teal"
    again = OURS.load(made.id)
    assert again.category == made.category and again.size == made.size


@pytest.mark.parametrize(
    ("category", "words", "axis", "low", "high"),
    [
        ("side_table", "narrow", 0, 0.25, 0.36),
        ("coffee_table", "low", 2, 0.2, 0.36),
        ("sideboard", "tall", 2, 1.0, 1.3),
        ("bookcase", "floor to ceiling", 2, 2.25, 2.35),
        ("bookcase", "tall", 2, 2.05, 2.15),
        ("school_desk", "child sized", 2, 0.4, 0.6),
    ],
)
def test_words_go_beyond_the_usual_size(category: str, words: str, axis: int, low: float, high: float) -> None:
    look = drawable(category, words)
    made = OURS.choose(category, wish=Wish(look.size, beyond=True, seed=4))[0]
    assert low <= made.size[axis] <= high and OURS.load(made.id).size == made.size
    usual = categories()[category].size
    assert usual is not None
    plain = OURS.choose(category, wish=Wish(look.size, seed=4))[0]
    assert usual.ranges[axis][0] - 1e-6 <= plain.size[axis] <= usual.ranges[axis][1] + 1e-6


def test_a_small_square_rug_is_square_and_what_cannot_be_so_low_is_made() -> None:
    look = drawable("rug", "small square")
    assert look.size[0] == look.size[1]
    assert OURS.choose("computer_desk", wish=Wish((None, None, 0.55), beyond=True))[0].size[2] > 0.5


def test_words_say_what_holds_a_thing_where_that_may_be() -> None:
    assert drawable("vanity", "floating oak").mount == "wall"
    unheld = drawable("sofa", "wall mounted")
    assert unheld.mount is None and unheld.unmet == ("wall mounted",)


def test_a_material_alone_makes_no_other_thing_of_a_basket() -> None:
    assert drawable("basket", "wicker").category == "basket"


def test_what_was_asked_in_vain_before_does_not_matter(monkeypatch) -> None:
    """The same wish gives the same drawing, whatever was asked before it and of what size."""
    from sceneweaver.assets.parametric.drawings import Drawings
    from sceneweaver.assets.sources import parametric
    from sceneweaver.assets.sources.base import Wish

    wishes = [Wish(size=(None, w, None), parts=(("drawers", 5),), seed=s, count=1) for w in (1.2, 2.0) for s in (0, 1)]

    def found(order):
        parametric._can_show.cache_clear()
        monkeypatch.setattr(parametric, "_DRAWN", Drawings(2**24))
        return {wish: [card.id for card in parametric.ParametricSource().find("desk", wish)] for wish in order}

    assert found(wishes) == found(wishes[::-1])
