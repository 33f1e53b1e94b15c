"""Simple requests in other languages are read, each thing where it stands in the request; English stays as it is."""

from __future__ import annotations

import pytest

from sceneweaver.language import read_request
from sceneweaver.language.source import read_source


@pytest.mark.parametrize(
    ("text", "room", "things", "relation"),
    [
        (
            "Ein kleines Schlafzimmer mit Doppelbett, zwei Nachttischen und einem Kleiderschrank an der Wand",
            "bedroom",
            {"bed": "doppelbett", "nightstand": "nachttischen", "wardrobe": "kleiderschrank"},
            ("wardrobe", "wall"),
        ),
        (
            "Una sala con un sofá grande, dos butacas y una mesa redonda sobre la alfombra",
            "living_room",
            {"armchair": "dos butacas", "rug": "alfombra"},
            None,
        ),
        (
            "Un bureau ouvert avec quatre chaises et une armoire près de la porte",
            "office",
            {"wardrobe": "armoire"},
            ("wardrobe", "door"),
        ),
        (
            "卧室里有一张双人床，窗边有一张书桌，两把椅子",
            "bedroom",
            {"desk": "书桌", "chair": "椅子"},
            ("desk", "window"),
        ),
    ],
)
def test_what_is_read(text: str, room: str, things: dict[str, str], relation: tuple[str, str] | None) -> None:
    graph = read_request(text)
    assert graph.room_type == room
    for category, words in things.items():
        entity = graph.entity(category)
        assert entity is not None and entity.span is not None, graph.entities
        assert words in text[entity.span.start : entity.span.end].lower()
    if relation is not None:
        assert any((r.subject, r.targets[0]) == relation for r in graph.relations), graph.relations
    assert any("word by word" in note for note in graph.notes)


def test_what_is_excluded_stays_out() -> None:
    assert read_request("Eine Küche mit Herd und ohne Kühlschrank").exclusions[0].words == "fridge"
    assert "rug" in read_request("Un salon avec un canapé, pas de tapis").exclusions[0].categories


def test_words_of_no_table_are_told() -> None:
    graph = read_request("Ein Wohnzimmer mit einem Sofa und einem Quaxelbrumm")
    assert [unread.words for unread in graph.unread] == ["quaxelbrumm"]


@pytest.mark.parametrize(
    "text",
    ["a chaise longue in an en suite bedroom", "a café with two tables", "the bar is on the left", "a den", "", "12"],
)
def test_english_stays_english(text: str) -> None:
    assert read_source(text).language == "en"


def test_a_compound_is_its_last_part_and_what_stands_before_it() -> None:
    graph = read_request("Ein Arbeitszimmer mit einer Schreibtischlampe und einem Bürostuhl")
    assert {entity.category for entity in graph.entities} == {"desk_lamp", "office_chair"}


def test_a_part_of_a_word_is_no_thing_and_small_things_are_things() -> None:
    graph = read_request("Ein Café mit vier runden Tischen, 70 cm Durchmesser, und einem Kühlschränkchen")
    assert {entity.category for entity in graph.entities} == {"round_dining_table", "minibar"}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Spielzimmer mit drei Liegen nebeneinander unter dem Fenster", "loungers side by side under the window"),
        ("Café: an beiden Längswänden hohe Regale mit gefalteten Handtüchern", "high shelves with folded towels"),
        ("dormitorio con dos lámparas colgadas en la pared y un espejo encima", "lamps hung on the wall and a mirror"),
        ("salle avec un billard au centre et d'un côté un passage libre d'un mètre", "free passage of 1 m"),
        ("一间书房，桌子正上方一盏吊灯，左边墙上是书架", "directly above table a pendant, on the left wall is"),
    ],
)
def test_phrases_of_place_and_capitals(text: str, said: str) -> None:
    assert said in read_source(text).spoken
