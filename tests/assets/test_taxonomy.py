"""The taxonomy: words, sizes and references agree, and any noun resolves to something that says how sure it is."""

from __future__ import annotations

from collections import defaultdict

import pytest

from sceneweaver.assets.category import categories
from sceneweaver.assets.parametric import makers
from sceneweaver.assets.plurals import singular
from sceneweaver.assets.taxonomy import GENERIC, category_named, likeliness, members, narrower, phrases, resolve


def test_there_are_enough_categories() -> None:
    known = categories()
    bodies = {name for name, category in known.items() if category.size is not None}
    assert bodies == set(makers())
    assert len(bodies) >= 150
    assert sum(known[name].mount[0] == "surface" for name in bodies) >= 60


def test_every_word_means_one_thing() -> None:
    owners = defaultdict(list)
    for name, category in categories().items():
        for word in (category.words, *category.synonyms, *category.like):
            owners[word.lower()].append(name)
    assert {word: names for word, names in owners.items() if len(names) > 1} == {}


def test_references_name_categories() -> None:
    known = categories()
    for name, category in known.items():
        assert category.parent is None or category.parent in known, name
        for other in (*category.on, *category.holds):
            assert other in known, f"{name}: {other}"
        assert category.usual is None or category.usual in known, name


def test_entries_are_complete() -> None:
    incomplete = set()
    for name, category in categories().items():
        if category.size is None:
            continue
        low, high = category.mass
        holds = {
            "source": bool(category.source),
            "parent": bool(category.parent) or name == GENERIC,
            "mass": 0 < low <= high <= 2000,
            "friction": 0.05 <= category.friction <= 1.5,
            "sides": set(category.clearance) <= set(category.sides),
            "clearance": all(0 < depth <= 2 for depth in category.clearance.values()),
            "bottom": "wall" not in category.mount or category.bottom is not None,
        }
        incomplete |= {(name, what) for what, kept in holds.items() if not kept}
    assert incomplete == set()


@pytest.mark.parametrize(
    ("noun", "category", "how"),
    [
        ("desk", "desk", "exact"),
        ("Office_Chair", "office_chair", "exact"),
        ("swivel chair", "office_chair", "synonym"),
        ("bookshelves", "bookcase", "synonym"),
        ("wardrobes", "wardrobe", "plural"),
        ("armoire", "wardrobe", "synonym"),
        ("bokcase", "bookcase", "spelling"),
        ("sofaa", "sofa", "spelling"),
        ("velvet throne chair", "chair", "head"),
        ("gaming throne chair", "gaming_chair", "head"),
        ("large round oak mirror", "round_mirror", "exact"),
        ("a pair of brass candlesticks", "candlestick", "exact"),
        ("zebra", "zebra", "generic"),
        ("flux capacitors", "flux_capacitor", "generic"),
        ("large brass sextants", "sextant", "like"),
        ("", GENERIC, "generic"),
    ],
)
def test_nouns_resolve(noun: str, category: str, how: str) -> None:
    match = resolve(noun)
    assert (match.category, match.how) == (category, how)
    assert bool(match.note) == (how in ("spelling", "like", "head", "group", "generic"))


def test_a_group_means_its_usual_member() -> None:
    match = resolve("seat")
    assert match.how == "group" and match.category in members("seating")


def test_every_word_of_the_taxonomy_resolves_to_its_owner() -> None:
    for name, category in categories().items():
        if category.size is None:
            continue
        for word in (category.words, *category.synonyms):
            assert resolve(word).category == name, word
        for word in category.like:
            assert resolve(word).body == name, word


def test_what_one_body_shows_several_of_is_a_word_for_it() -> None:
    for name, category in categories().items():
        words = {word for phrase in (category.words, *category.synonyms) for word in phrase.split()}
        assert all({word, singular(word)} & words for word in category.several), name
        assert all(n > 1 for n in category.several.values()), name


def test_where_things_stand() -> None:
    """The likelier, the lower; what is said of a kind goes for its compounds."""
    assert likeliness("monitor", "desk") == likeliness("monitor", "standing_desk") == 0
    assert 0 < (likeliness("monitor", "bookcase") or 0) < (likeliness("monitor", "sideboard") or 0)
    assert likeliness("monitor", "bathtub") is None and likeliness("zorb", "bathtub") is None
    assert (likeliness("book", "bed") or 0) >= len(categories()["book"].on), "only as the bed says that it holds some"


@pytest.mark.parametrize(
    ("noun", "mount", "body"),
    [
        ("zorb pressing machine", None, "generic_machine"),
        ("zorb plaque", "wall", "generic_panel"),
        ("zorb", None, "generic_item"),
        ("zorb", "floor", "generic_furniture"),
        ("zorb", "ceiling", "generic_hanging"),
        ("brass zorb totems", None, "generic_figure"),
    ],
)
def test_the_last_word_and_what_holds_it_decide_a_labelled_body(noun: str, mount, body: str) -> None:
    match = resolve(noun, mount)
    assert match.generic and match.body == body and match.note
    assert match.category == "_".join(noun.removeprefix("brass ").removesuffix("s").split())
    known = category_named(match.category, mount)
    assert known.name == match.category and known.size == categories()[body].size
    assert mount is None or mount in known.mount


def test_another_body_stands_for_a_thing_under_its_own_name() -> None:
    match = resolve("brass sextants")
    assert (match.category, match.body, match.modifiers) == ("sextant", "compass", ("brass",))
    known = category_named("sextant")
    assert known.name == "sextant" and known.size == categories()["compass"].size
    assert phrases()["sextant"] == "sextant" and likeliness("sextant", "desk") == 0
    assert resolve("bunk bed with a zorb").category == "bunk_bed" and resolve("couch").category == "sofa"


@pytest.mark.parametrize(
    ("category", "words", "noun", "narrow"),
    [
        ("bed", "king size velvet", "bed", "king_bed"),
        ("wall_mirror", "large round", "mirror", "round_mirror"),
        ("sofa", "grey l-shaped", "couch", "sectional_sofa"),
        ("chair", "high", "chair", "chair"),
        ("table_lamp", "crystal", "table lamp", "table_lamp"),
        ("zorb", "round", "zorb", "zorb"),
    ],
)
def test_words_make_a_thing_narrower(category: str, words: str, noun: str, narrow: str) -> None:
    assert narrower(category, words, noun) == narrow


def test_words_before_a_name_stay_with_it() -> None:
    assert resolve("three-legged red lacquered wooden stool").modifiers == ("red", "lacquered")
    assert resolve("jar of pickled zorbs").category == "jar"


@pytest.mark.parametrize("noun", ["budgies", "magpies", "genies", "zombies"])
def test_plurals_of_nouns_in_ie_keep_it(noun: str) -> None:
    assert singular(noun) == noun.removesuffix("s")
    assert resolve(noun).how != "spelling"


def test_a_bin_for_something_is_for_no_waste() -> None:
    assert resolve("potato bin").category == "wooden_crate"
    assert resolve("waste bin").category == "trash_can"


def test_a_real_word_is_no_slip() -> None:
    for word in ("dressed", "cartoon", "shelled", "lamb"):
        assert resolve(word).how != "spelling", word
    assert resolve("wardrobbe").category == "wardrobe" and resolve("dinning table").category == "dining_table"
