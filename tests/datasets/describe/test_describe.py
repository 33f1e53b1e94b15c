"""The words of a scene: the same for the same seed, other words for another, English nouns."""

from __future__ import annotations

import json

import pytest

from sceneweaver.assets import categories
from sceneweaver.datasets.describe import describe
from sceneweaver.datasets.describe.naming import counted, listed, noun, nouns, with_article
from sceneweaver.scene import Scene


@pytest.fixture(scope="module")
def bedroom() -> Scene:
    return Scene.example("bedroom")


def test_words_follow_from_scene_and_seed_alone(bedroom):
    first = describe(bedroom, 3)
    assert describe(Scene.loads(bedroom.dumps()), 3) == first
    assert describe(bedroom, 4) != first


def test_captions_say_more_at_length(bedroom):
    data = json.loads(describe(bedroom, 0)["captions.json"])
    short, long = data["short"]["text"], data["paragraph"]["text"]
    assert short.count(".") == 1 and len(long) > 3 * len(short)
    assert {s["predicate"] for s in data["paragraph"]["statements"]} >= {"room_type", "floor_area", "count"}
    told = {i for row in data["by_place"] for s in row["statements"] for i in s["objects"]}
    assert told >= {o.id for o in bedroom.objects}


def test_a_question_has_all_that_its_answer_follows_from(bedroom):
    rows = [json.loads(line) for line in describe(bedroom, 0)["questions.jsonl"].splitlines()]
    assert len(rows) >= 12 and len({r["id"] for r in rows}) == len(rows)
    for row in rows:
        assert row["question"].endswith("?") and row["method"] and row["operands"], row
        if row["form"] == "choice":
            assert row["options"].count(row["answer"]) == 1, row
        if row["form"] == "number":
            assert row["tolerance"] > 0 and row["unit"], row


def test_nouns_are_english():
    assert [counted(2, c) for c in ("mouse", "cup_and_saucer", "standing_books", "tv", "metal_shelf")] == [
        "two computer mice",
        "two cups and saucers",
        "two rows of books",
        "two TVs",
        "two metal shelves",
    ]
    words = ("office chair", "hourglass", "upright piano", "urinal", "8 m² room", "18 m² room", "IV stand", "TV")
    assert [with_article(w).split()[0] for w in words] == ["an", "an", "an", "a", "an", "an", "an", "a"]
    assert listed(["a", "b", "c"]) == "a, b and c"
    named = [c for c, found in categories().items() if found.size is not None]
    assert len({noun(c) for c in named}) == len(named) == len({nouns(c) for c in named})
    assert not [
        c for c in named if noun(c) == nouns(c) or nouns(c).endswith(("ses", "sses")) and noun(c).endswith("ls")
    ]
