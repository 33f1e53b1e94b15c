"""Each word of a request has a status: something that was read speaks for it, or it is told as not understood."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from benchmarks.families.requests import requests
from benchmarks.room_requests import SETS, room_requests
from sceneweaver.assets.plurals import singular
from sceneweaver.language import SceneGraph
from sceneweaver.language.coverage import function_words
from sceneweaver.language.read import read_request
from sceneweaver.language.vocabulary import vocabulary, words

SHARED = Path(__file__).parents[3] / "shared" / "requests" / "dev.jsonl"
"""Requests of people that lie beside the project where there are any; they are read and never copied."""

WORD = re.compile(r"[^\W\d_]+(?:['’-][^\W\d_]+)*")
OWN = (
    "A hall for a deaf boy who limps, with a bench he can rest on, because stairs tire him.",
    "The lounge should feel like a tent in the desert; two sofas, a stove, and no rug but a mat.",
    "Study for my uncle. He hums, he paces, he must not be stared at. A desk, a lamp, nothing with wheels.",
    "Bedroom. I loathe carpets, curtains are banned, a mirror-free corner for the cot would be a dream.",
    "A kitchen that smells of bread, where nobody quarrels, in order to calm the twins; table, four chairs, fridge.",
    "Workshop with a saloon door, a hatch for the cat, a bench so the van may reverse up to it.",
    "A den with a sofa. The dog may not sit on the sofa. The sofa must never be wet.",
)


def without_status(graph: SceneGraph) -> Iterator[str]:
    """The content words of a request in English that no item, fact of the room or phrase not understood has."""
    items = (
        *(entity for entity in graph.entities if not entity.implied),
        *(attribute for entity in graph.entities for attribute in entity.attributes),
        *(graph.relations + graph.exclusions + graph.openings + graph.free_areas + graph.capacities),
        *(graph.arrangements + graph.views + graph.amounts + graph.measures + graph.looks + graph.finishes),
        *graph.unread,
    )
    spans = [item.span for item in items if item.span is not None]
    spans += [span for one in graph.arrangements for span in one.more]
    facts = [graph.room_words, graph.style or "", graph.shape or "", *graph.colors, *graph.for_whom]
    facts += [name.replace("_", " ") for name in (*graph.other_rooms, graph.room_type or "")]
    facts += [" ".join((entity.noun, *entity.words, entity.category.replace("_", " "))) for entity in graph.entities]
    facts += [f"{one.words} {' '.join(one.categories)}" for one in graph.exclusions]
    facts += [f"{one.words} {' '.join(one.targets)}" for one in graph.relations]
    facts += [one.words for one in graph.looks + graph.unread + graph.openings]
    facts += [a.words for entity in graph.entities for a in entity.attributes] + list(graph.notes)
    facts += words("refusals")["refused"] if graph.exclusions else []
    people = {"people_words", "whom"} if graph.people or graph.capacities or graph.for_whom else set[str]()
    told = {
        form
        for text in facts
        for word in WORD.findall(text.lower().replace(":", " "))
        for form in (word, singular(word))
    }
    for match in WORD.finditer(graph.text):
        word = match[0].lower().replace("’", "'")
        if any(span.start <= match.start() < span.end for span in spans):
            continue
        parts = {word, singular(word), *word.split("-")}
        kinds = vocabulary().get(word, {}).keys()
        grammar = kinds & {"number", "neg", "unit", "verb", "modal", "adverbs", "region", "amount", "collective"}
        grammar |= kinds & people
        if not (parts & (told | function_words()) or set(word.split("-")) <= function_words() or grammar):
            yield word


@pytest.mark.parametrize("text", OWN)
def test_each_word_of_own_texts_has_a_status(text: str) -> None:
    assert list(without_status(read_request(text))) == []


@pytest.mark.parametrize("name", SETS)
def test_each_word_of_the_benchmarks_has_a_status(name: str) -> None:
    assert {one.id: lost for one in room_requests(name) if (lost := list(without_status(read_request(one.text))))} == {}


def test_each_word_of_short_requests_has_a_status() -> None:
    assert [lost for text in requests() if (lost := list(without_status(read_request(text))))] == []


@pytest.mark.skipif(not SHARED.exists(), reason="no requests of people beside the project")
def test_each_word_of_requests_of_people_has_a_status() -> None:
    rows = [json.loads(line) for line in SHARED.read_text(encoding="utf-8").splitlines()]
    english = [row for row in rows if row["language"] == "en"]
    lost = {row["id"]: words for row in english if (words := list(without_status(read_request(row["request"]))))}
    assert english and lost == {}
