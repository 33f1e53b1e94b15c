"""What an analysis adds to the rules, given by hand; and what the network of the package finds."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.language import read_request
from sceneweaver.language.graph import build
from sceneweaver.language.learned.analysis import Analysis, Link, Named, analyse, shipped
from sceneweaver.language.learned.completing import complete
from sceneweaver.language.learned.labels import LINKS
from sceneweaver.language.model import Span
from sceneweaver.language.read import parsed_by_rules, read_by_rules


def analysis(text: str, named: list[tuple[str, str]], links: list[tuple[str, int, int, float]]) -> Analysis:
    """An analysis that is sure of what it is given: words with kinds, links with shares."""
    found, at = [], 0
    for words, kind in named:
        start = text.index(words, at)
        at = start + len(words)
        found.append(Named(Span(start, at), kind, 0.99))
    shares = np.zeros((len(found) + 1, len(found) + 1, len(LINKS)), np.float32)
    shares[..., 0] = 1.0
    for name, one, other, sure in links:
        shares[one + 1, other + 1] = 0.0
        shares[one + 1, other + 1, [0, LINKS.index(name)]] = 1.0 - sure, sure
    return Analysis(tuple(found), tuple(Link(*link) for link in links if link[3] > 0.5), shares)


def completed(text: str, named: list[tuple[str, str]], links: list[tuple[str, int, int, float]]):
    source, parsed = parsed_by_rules(text)
    complete(parsed, source, text, analysis(text, named, links), lambda sentence: parsed_by_rules(sentence)[1])
    return build(text, source, parsed)


def said(graph) -> set[str]:
    return {f"{r.subject} {r.type} {' '.join(r.targets)}" for r in graph.relations}


BARE = "a den: sofa, lamp, rug, window"
NAMED = [("sofa", "thing"), ("lamp", "thing"), ("rug", "thing"), ("window", "opening")]


def test_a_link_becomes_a_relation():
    assert not read_by_rules(BARE).relations
    graph = completed(
        BARE, NAMED, [("left", 1, 0, 0.9), ("under", 0, 3, 0.9), ("between", 2, 0, 0.9), ("on", 1, 2, 0.2)]
    )
    assert {"sofa below window"} < said(graph) and any(" left_of sofa" in one for one in said(graph))
    assert not any(" on rug" in one for one in said(graph))
    relation = next(r for r in graph.relations if r.type == "left_of")
    assert relation.span is not None and "sofa" in BARE[relation.span.start : relation.span.end]


def test_what_the_rules_said_stays_and_is_not_said_twice():
    text = "a den with a lamp next to a sofa"
    graph = completed(text, [("lamp", "thing"), ("sofa", "thing")], [("near", 0, 1, 0.9)])
    assert said(graph) == said(read_by_rules(text)) != set()


def test_a_seat_and_a_table_of_one_list_are_not_tied():
    named = [("table", "thing"), ("chairs", "thing")]
    assert not completed("a den with a table and ten chairs", named, [("at", 1, 0, 0.9)]).relations


def test_what_only_follows_from_with_is_dropped_where_the_analysis_takes_it_for_nothing():
    text = "eight desks, each with a chair and a sink"
    named = [("desks", "thing"), ("chair", "thing"), ("sink", "thing")]
    assert any("sink" in one for one in said(read_by_rules(text)))
    assert not any("sink" in one for one in said(completed(text, named, [("each", 0, 1, 0.9)])))
    spoken = "a den with a lamp next to a sofa"  # what is said in so many words stays
    assert said(completed(spoken, [("lamp", "thing"), ("sofa", "thing")], [])) == said(read_by_rules(spoken))


def test_each_of_so_many_people_has_one():
    text = "a room where three girls study: desk, chair"
    named = [("girls", "person"), ("desk", "thing"), ("chair", "thing")]
    graph = completed(text, named, [("each", 0, 1, 0.9), ("each", 1, 2, 0.9)])
    assert [graph.entity(name).count for name in ("desk", "chair")] == [(3, 3), (3, 3)]


def test_what_is_counted_out_over_the_wrong_group_is_counted_back():
    text = "eight desks, each with a chair and a sink"
    assert read_by_rules(text).entities[-1].count == (8, 8)
    named = [("desks", "thing"), ("chair", "thing"), ("sink", "thing")]
    graph = completed(text, named, [("each", 0, 1, 0.9), ("at", 1, 0, 0.9)])
    assert [e.count for e in graph.entities] == [(8, 8), (8, 8), (1, 1)]


def test_what_must_not_be_there_is_ruled_out():
    text = "a shop with shelves. The generator must stay outdoors"
    graph = completed(text, [("shelves", "thing"), ("generator", "unwanted")], [])
    assert "generator" in {e.words for e in graph.exclusions} and "generator" not in {e.noun for e in graph.entities}


@pytest.mark.parametrize(
    ("link", "kind", "targets", "side"),
    [
        ([("to", 1, 2)], "path", ("door", "sofa"), "any"),
        ([("from", 1, 3), ("to", 1, 2)], "path", ("door", "sofa"), "any"),
        ([("around", 1, 2)], "clearance", ("sofa",), "around"),
        ([("front", 1, 2)], "clearance", ("sofa",), "front"),
        ([], "path", (), "any"),
    ],
)
def test_floor_is_kept_free(link, kind, targets, side):
    text = "a den: 0.8 m to walk a way about, sofa, door"
    named = [("0.8 m", "measure"), ("way", "free"), ("sofa", "thing"), ("door", "opening")]
    graph = completed(text, named, [("of", 0, 1, 0.9), *((*one, 0.9) for one in link)])
    (area,) = [area for area in graph.free_areas if area.kind == kind]
    assert area.targets == targets and area.side == side and area.size == (0.8, 0.8)


def test_a_room_gets_the_sides_that_are_told_one_by_one():
    text = "a shed 3.2 m broad, 7 long, with shelves"
    named = [("shed", "room"), ("3.2 m", "measure"), ("7", "measure"), ("shelves", "thing")]
    assert read_by_rules(text).size is None
    assert completed(text, named, [("of", 1, 0, 0.9), ("of", 2, -1, 0.9)]).size == (7.0, 3.2)
    assert completed(text, named, [("of", 1, 3, 0.9), ("of", 2, 3, 0.9)]).size is None


def test_the_network_of_the_package_reads_what_rules_do_not():
    assert shipped().about["links"] > 0.55
    graph = read_request(
        "Three pupils, every pupil with own easel and stool. Leave a free 80 cm passage from the door to the sink."
    )
    assert [graph.entity(name).count for name in ("easel", "stool")] == [(3, 3), (3, 3)]
    (way,) = graph.free_areas
    assert (way.kind, way.size, way.targets) == ("path", (0.8, 0.8), ("door", "sink_cabinet"))


def test_equal_texts_are_analysed_equally():
    text = "a study with a desk by the window and two chairs facing it"
    one, other = (analyse(text, parsed_by_rules(text)[1]) for _ in range(2))
    assert one.named == other.named and one.links == other.links


def test_odd_texts_are_analysed():
    for text in ("bed", "!!!", "a" * 3000, "bed " * 900, "床和桌子", "a\n\n\tbed"):
        read_request(text)
