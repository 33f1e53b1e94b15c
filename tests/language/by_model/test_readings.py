"""Where a model and the offline reader disagree, and what stays of either."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from sceneweaver.agent.request_file import RequestFile
from sceneweaver.language import SceneGraph
from sceneweaver.language.by_model.disagreements import Disagreement
from sceneweaver.language.by_model.reader import Reading, read_by_model
from sceneweaver.language.read import read_by_rules
from tests.agent.by_model.answering import Answering

TEXT = (
    "A small modern study for two people, 4 x 3 m, with a large oak desk by the window, two grey office chairs, a "
    "bookcase against the left wall and a plant on the desk. No rug."
)
READ: dict[str, Any] = {
    "language": "English",
    "room": {
        "kind": "study",
        "quote": "study",
        "scale": 0.75,
        "style": "modern",
        "people": 2,
        "for_whom": ["people"],
        "sides": [4, 3],
    },
    "things": [
        {
            "id": "desk",
            "name": "desk",
            "quote": "desk",
            "count": [1, 1],
            "words": [
                {"kind": "size", "value": "large", "quote": "large"},
                {"kind": "material", "value": "oak", "quote": "oak"},
            ],
        },
        {
            "id": "chair",
            "name": "office chair",
            "quote": "office chairs",
            "count": [2, 2],
            "words": [{"kind": "color", "value": "grey", "quote": "grey"}],
        },
        {"id": "shelf", "name": "bookcase", "quote": "bookcase", "count": [1, 1]},
        {"id": "plant", "name": "small plant", "quote": "plant", "count": [1, 1]},
    ],
    "relations": [
        {"type": "near", "subject": "desk", "targets": ["window"], "quote": "by"},
        {"type": "against", "subject": "shelf", "targets": ["wall:left"], "quote": "against"},
        {"type": "on", "subject": "plant", "targets": ["desk"], "quote": "on"},
    ],
    "exclusions": [{"quote": "rug", "names": ["rug"]}],
}


def read(text: str = TEXT, **changes: Any) -> Reading:
    """The request by a model that answers as above, but for these fields."""
    return read_by_model(Answering(READ | changes).client, text, read_by_rules(text))


def rows(reading: Reading) -> set[tuple[str, str, str]]:
    """Item, field and whose reading is used of each disagreement."""
    return {(row.item, row.field, row.used) for row in reading.disagreements}


def without(field: str, name: str) -> list[dict[str, Any]]:
    """The things or relations of the answer but one."""
    return [row for row in READ[field] if name not in (row.get("id"), row.get("subject"), row.get("type"))]


def changed(name: str, **values: Any) -> list[dict[str, Any]]:
    """The things of the answer, one of them with other values."""
    return [row | values if row["id"] == name else row for row in READ["things"]]


def facts(graph: SceneGraph) -> list[Any]:
    """What of a graph does not depend on how words were cut out of the text."""
    things = [(e.id, e.category, e.count, e.color, e.material, e.scale) for e in graph.entities]
    said = [(r.type, r.subject, r.targets) for r in graph.relations]
    room = [getattr(graph, name) for name in ("room_type", "size", "scale", "people", "style", "only", "without")]
    return [sorted(things), sorted(said), room]


def test_two_that_agree_say_nothing() -> None:
    reading = read()
    assert [str(row) for row in reading.disagreements] == []
    assert facts(reading.graph) == facts(read_by_rules(TEXT))


def test_a_thing_that_the_model_forgot_stays() -> None:
    reading = read(things=without("things", "shelf"), relations=without("relations", "shelf"))
    assert facts(reading.graph) == facts(read_by_rules(TEXT))
    assert rows(reading) == {("bookcase", "thing", "offline"), ("relation-2", "relation", "offline")}
    assert "1 bookcase offline, nothing by the model; the offline reading is used" in str(reading.disagreements[0])
    shelf = reading.graph.entity("bookcase")
    assert shelf is not None
    assert shelf.span is not None
    assert TEXT[slice(*shelf.span)] == "a bookcase"


@pytest.mark.parametrize(
    "elsewhere",
    [
        {"exclusions": [*READ["exclusions"], {"quote": "bookcase", "names": ["bookcase"]}]},
        {"exclusions": [*READ["exclusions"], {"quote": "a bookcase against the left wall", "names": ["bookcase"]}]},
        {"room": READ["room"] | {"quote": "bookcase"}},
        {"add": {"id": "x", "name": "ladder", "quote": "bookcase"}},
        {"word": {"kind": "other", "value": "bookish", "quote": "bookcase"}},
    ],
)
def test_a_thing_whose_words_the_model_took_for_something_else_goes(elsewhere: dict[str, Any]) -> None:
    things = without("things", "shelf")
    if "add" in elsewhere:
        things.append(elsewhere.pop("add"))
    if "word" in elsewhere:
        things[0] = things[0] | {"words": [*things[0]["words"], elsewhere.pop("word")]}
    reading = read(things=things, relations=without("relations", "shelf"), **elsewhere)
    assert reading.graph.entity("bookcase") is None
    item = next(row for row in reading.disagreements if "bookcase" in row.offline)
    assert item.used == "model"


def test_who_quotes_a_sentence_did_not_say_what_its_words_are() -> None:
    quote = TEXT[TEXT.index("a large oak desk") : TEXT.index(" and a plant")]
    reading = read(things=[READ["things"][0] | {"quote": quote}], relations=[])
    assert {"bookcase", "office_chair"} <= {e.category for e in reading.graph.entities}


def test_what_the_model_did_not_say_of_a_thing_stays() -> None:
    things = changed("chair", words=[], count=None)
    reading = read(things=things)
    chair = reading.graph.entity("office_chair")
    assert chair is not None
    assert (chair.color, chair.count) == ("grey", (2, 2))
    assert [(a.kind, a.value) for a in chair.attributes] == [("color", "grey")]
    assert rows(reading) == {("office_chair", "color", "offline"), ("office_chair", "count", "offline")}


def test_a_word_that_the_model_gave_to_something_else_is_not_taken_back() -> None:
    things = changed("chair", words=[])
    things[2] = things[2] | {"words": [{"kind": "color", "value": "grey", "quote": "grey"}]}
    reading = read(things=things)
    chair, shelf = reading.graph.entity("office_chair"), reading.graph.entity("bookcase")
    assert chair is not None
    assert shelf is not None
    assert (chair.color, shelf.color) == (None, "grey")
    assert ("office_chair", "color", "model") in rows(reading)


def test_where_both_say_something_the_model_is_used() -> None:
    things = changed("chair", count=[3, 3], words=[{"kind": "color", "value": "black", "quote": "grey"}])
    said = [
        *without("relations", "desk"),
        {"type": "opposite", "subject": "desk", "targets": ["window"], "quote": "by"},
    ]
    reading = read(things=things, relations=said, room=READ["room"] | {"people": 3})
    chair = reading.graph.entity("office_chair")
    assert chair is not None
    assert (chair.color, chair.count, reading.graph.people) == ("black", (3, 3), 3)
    assert {
        ("office_chair", "color", "model"),
        ("office_chair", "count", "model"),
        ("room", "people", "model"),
    } <= rows(reading)
    assert [r.type for r in reading.graph.relations if r.subject == "desk"] == ["opposite"]


def test_facts_about_the_room_that_the_model_left_out_stay() -> None:
    reading = read(room={}, exclusions=[])
    assert facts(reading.graph) == facts(read_by_rules(TEXT))
    used = {name: used for item, name, used in rows(reading) if item == "room"}
    assert set(used) >= {"room_type", "size", "scale", "people", "style"}
    assert set(used.values()) == {"offline"}
    assert ("exclusion-0", "exclusion", "offline") in rows(reading)
    assert reading.graph.room_words == "study"


def test_a_thing_that_only_the_model_reads_is_there_and_said() -> None:
    reading = read(things=[*READ["things"], {"id": "l", "name": "floor lamp", "quote": "window", "count": [1, 1]}])
    assert reading.graph.entity("floor_lamp") is not None
    assert ("floor_lamp", "thing", "model") in rows(reading)


def test_an_unwanted_thing_that_the_model_wants_is_there() -> None:
    rug = {"id": "r", "name": "rug", "quote": "rug", "count": [1, 1]}
    reading = read(things=[*READ["things"], rug], exclusions=[])
    assert reading.graph.entity("rug") is not None
    assert reading.graph.without == ()
    assert ("exclusion-0", "exclusion", "model") in rows(reading)


def test_nothing_is_held_twice_or_by_itself() -> None:
    said = [*without("relations", "plant"), {"type": "on", "subject": "desk", "targets": ["plant"]}]
    reading = read(relations=said)
    held = [(r.subject, r.targets) for r in reading.graph.relations if r.type == "on"]
    assert held == [("desk", ("small_plant",))]


def test_a_pair_that_was_told_apart_is_the_same_as_two() -> None:
    text = "A living room with two sofas facing each other and a coffee table between them."
    answer = {
        "language": "English",
        "room": {"kind": "living room", "quote": "living room"},
        "things": [
            {"id": "s", "name": "sofa", "quote": "sofas", "count": [2, 2]},
            {"id": "t", "name": "coffee table", "quote": "coffee table", "count": [1, 1]},
        ],
        "relations": [
            {"type": "facing", "subject": "s", "targets": ["s"], "quote": "facing each other"},
            {"type": "between", "subject": "t", "targets": ["s"], "quote": "between"},
        ],
    }
    reading = read_by_model(Answering(answer).client, text, read_by_rules(text))
    assert [str(row) for row in reading.disagreements] == []
    assert facts(reading.graph) == facts(read_by_rules(text))


def test_a_language_that_is_claimed_does_not_hide_what_was_read() -> None:
    reading = read(language="Klingon", things=without("things", "shelf"))
    assert reading.graph.entity("bookcase") is not None


def test_rows_are_data_and_one_line_each() -> None:
    reading = read(room={}, things=without("things", "shelf"))
    for row in reading.disagreements:
        assert "\n" not in str(row)
        assert Disagreement.model_validate(json.loads(row.model_dump_json())) == row


def test_the_file_of_a_request_names_them_and_is_as_before_without_any(tmp_path: Path) -> None:
    graph, said = read_by_rules(TEXT), ("room, people: 2 offline, 3 by the model; the model reading is used",)
    plain = RequestFile(schema="sceneweaver.request/1", graph=graph, summary={"total": 0}, outcomes=())
    plain.save(tmp_path / "plain.json")
    assert "disagreements" not in json.loads((tmp_path / "plain.json").read_text())
    other = plain.model_copy(update={"disagreements": said})
    other.save(tmp_path / "other.json")
    assert RequestFile.load(tmp_path / "other.json").disagreements == said
    assert RequestFile.load(tmp_path / "plain.json") == plain
