"""Annotated requests: they are as they should be, nobody's text is in both sets, and readers are measured by them."""

from __future__ import annotations

import pytest

from benchmarks.annotated_requests import annotated, annotated_requests
from benchmarks.reading import counted, shares
from sceneweaver.language.learned.labels import KINDS
from sceneweaver.language.read import read_by_rules

LINE = "A {lamp|1T} on {each|4A} {desk|2T}, no {rug|3N} || on(1,2) each(2,1) of(4,2) n1=2 n2=2"


def test_a_line_is_a_text_with_mentions_and_links():
    one = annotated(LINE, "me")
    assert one.text == "A lamp on each desk, no rug" and one.writer == "me"
    assert one.mentions[2] == (15, 19, "thing") and one.text[24:27] == "rug" and one.mentions[3][2] == "unwanted"
    assert one.links == (("on", 1, 2), ("each", 2, 1), ("of", 4, 2)) and one.counts == {1: 2, 2: 2}


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("A {lamp|1T} and a {desk|1T}", "twice"),
        ("A {lamp|1T", "broken"),
        ("A {lamp|1X}", "broken"),
        ("A {lamp|1T} || on(1,2)", "not there"),
        ("A {lamp|1T} || over(1,0)", "no link"),
        ("A {lamp|1T} || on(0,1)", "not there"),
        ("A {lamp|1T} || n2=3", "no link"),
    ],
)
def test_a_broken_line_says_so(line, says):
    with pytest.raises(ValueError, match=says):
        annotated(line)


def test_who_is_held_out_wrote_nothing_that_is_trained_on():
    trained, held_out = list(annotated_requests()), list(annotated_requests(held_out=True))
    assert len(trained) > 4000 and len(held_out) > 150
    assert {one.text for one in trained}.isdisjoint(one.text for one in held_out)
    assert {one.writer for one in held_out} == {"held_out"}
    assert {kind for one in held_out for _, _, kind in one.mentions.values()} == set(KINDS)


def test_a_reading_is_counted_by_its_marks():
    one = annotated("{Two desks|1T}, a {lamp|2T} on a {shelf|3T}, no {rug|4N} || on(2,3) n1=2")
    found = counted(one, read_by_rules(one.text))
    assert set(shares(found).values()) == {100.0, 0.0} and shares(found)["free floor"] == 0.0
    other = annotated("{Two desks|1T}, a {lamp|2T} on a {shelf|3T}, no {rug|4N} || on(1,3) n1=3")
    wrong = shares(counted(other, read_by_rules(other.text)))
    assert wrong["relations"] == 0.0 == wrong["right relations"] and wrong["counts"] < 100.0
