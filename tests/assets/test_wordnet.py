"""The table of nouns: which are things, which kind of thing, and whose body may stand for them."""

from __future__ import annotations

from importlib import resources

import pytest

from sceneweaver.assets import categories, resolve
from sceneweaver.assets.taxonomy import is_no_thing
from sceneweaver.assets.wordnet import LARGE, NOTHING, kinds_above, noun_named, of_head, of_kind


@pytest.mark.parametrize(
    ("noun", "kind"),
    [
        ("goblets", "vessel"),
        ("overcoat", "garment"),
        ("zither", "instrument"),
        ("trellis", "stand"),
        ("toboggan", "vehicle"),
    ],
)
def test_a_noun_is_of_a_kind(noun: str, kind: str) -> None:
    found = noun_named(noun)
    assert found is not None and found.kind == kind


@pytest.mark.parametrize("noun", ["angle", "clay", "justice", "engineer", "design", "giraffe", "afternoon", "elbow"])
def test_what_is_no_thing_is_none(noun: str) -> None:
    found = noun_named(noun)
    assert found is not None and not found.is_thing
    assert found.kind in NOTHING


def test_a_word_that_is_no_noun_is_not_there() -> None:
    assert noun_named("eachother") is None
    assert noun_named("beautiful") is None


def test_the_head_of_a_compound_tells() -> None:
    assert (found := of_head("chimney sweep's soot brush")) is not None and found.kind == "tool"
    assert is_no_thing("fire drill")
    assert not is_no_thing("kitchen island")  # a name of the taxonomy wins


def test_a_plural_with_another_sense_is_that_of_the_thing() -> None:
    found = noun_named("hooks")
    assert found is not None and found.is_thing


def test_what_is_a_kind_of_a_category_takes_its_body() -> None:
    match = resolve("tankard")
    assert (match.category, match.body, match.how) == ("tankard", "mug", "generic")
    assert "no tankard" in match.note


def test_every_category_of_the_table_has_a_body() -> None:
    known = categories()
    from sceneweaver.assets.wordnet import _table

    for row in set(_table()[0].values()):
        assert not row.category or known[row.category].size is not None
        assert row.kind not in LARGE or not row.is_thing


def test_kinds_are_transitive() -> None:
    assert {"computer", "machine"} <= {*kinds_above("laptop")}
    assert "laptop" in of_kind("computers")
    assert "grand_piano" not in of_kind("computers")


def test_the_table_is_small_and_has_its_notice() -> None:
    folder = resources.files("sceneweaver.assets.wordnet")
    assert len(folder.joinpath("nouns.txt.gz").read_bytes()) < 400_000
    assert "Princeton University" in folder.joinpath("NOTICE").read_text(encoding="utf-8")
