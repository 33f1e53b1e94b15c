"""Patterns for any of some words."""

import re

import pytest

from sceneweaver.language.alternatives import first_words, names_begin, one_of

NAMES = ("red", "dark red", "off-white", "écru", "red and white")


@pytest.mark.parametrize(
    "text", ["a red bed", "in dark red", "off-white walls", "écru", "infrared", "reddish", "a whitered-off", "", "Red"]
)
def test_where_no_name_begins_no_name_is_matched(text):
    matched = re.search(rf"\b{one_of(NAMES)}(?![\w-])", text)
    assert matched is None or names_begin(text, first_words(NAMES))


def test_names_begin_with_whole_words():
    firsts = first_words(NAMES)
    assert firsts == {"red", "dark", "off", "écru"}
    assert not names_begin("infrared reddish", firsts)
    assert names_begin("it is red.", firsts)
