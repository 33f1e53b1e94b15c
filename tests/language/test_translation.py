"""Requests in other languages are read, each thing where it stands in the request; English stays as it is."""

from __future__ import annotations

import pytest

from sceneweaver.assets import categories
from sceneweaver.language.numerals import numerals
from sceneweaver.language.read import read_by_rules
from sceneweaver.language.source import read_source
from sceneweaver.language.translation import LANGUAGES, english_of, tables
from sceneweaver.language.vocabulary import vocabulary, words


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
    graph = read_by_rules(text)
    assert graph.room_type == room
    for category, spoken in things.items():
        entity = graph.entity(category)
        assert entity is not None and entity.span is not None, graph.entities
        assert spoken in text[entity.span.start : entity.span.end].lower()
    if relation is not None:
        assert any((r.subject, r.targets[0]) == relation for r in graph.relations), graph.relations
    assert any("word by word" in note for note in graph.notes)


def test_what_is_excluded_stays_out() -> None:
    assert read_by_rules("Eine Küche mit Herd und ohne Kühlschrank").exclusions[0].words == "fridge"
    assert "rug" in read_by_rules("Un salon avec un canapé, pas de tapis").exclusions[0].categories


def test_words_of_no_table_are_told() -> None:
    graph = read_by_rules("Ein Wohnzimmer mit einem Sofa und einem Quaxelbrumm")
    assert [unread.words for unread in graph.unread] == ["quaxelbrumm"]


@pytest.mark.parametrize(
    "text",
    ["a chaise longue in an en suite bedroom", "a café with two tables", "the bar is on the left", "a den", "", "12"],
)
def test_english_stays_english(text: str) -> None:
    assert read_source(text).language == "en"


def test_a_compound_is_its_last_part_and_what_stands_before_it() -> None:
    graph = read_by_rules("Ein Arbeitszimmer mit einer Schreibtischlampe und einem Bürostuhl")
    assert {entity.category for entity in graph.entities} == {"desk_lamp", "office_chair"}


def test_a_part_of_a_word_is_no_thing_and_small_things_are_things() -> None:
    graph = read_by_rules("Ein Café mit vier runden Tischen, 70 cm Durchmesser, und einem Kühlschränkchen")
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


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Ein Zimmer mit dunkelroten Vorhaengen und zwei Stuehlen aus Eiche", "dark red curtains and two oak chairs"),
        ("Ein Zimmer mit einem Buchenholzregal und einem Tischchen", "a beech wood shelf and a small table"),
        ("Una habitacion con lamparas de pie y sillas blancas", "floor lamps and white chairs"),
        ("Une chambre avec deux commodes basses et neuves", "two low new dressers"),
        ("Une salle avec vingt-quatre chaises pliantes et des tableaux", "24 folding chairs and some pictures"),
    ],
)
def test_forms_of_words_are_told_by_rules(text: str, said: str) -> None:
    assert said in read_source(text).spoken


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Wohnzimmer mit einem Sofa, neben dem ein Sessel steht", "a sofa, next to it a armchair"),
        ("In der Ecke soll eine Stehlampe stehen, wir haben weder Katze noch Hund", "in the corner is a floor lamp,"),
        ("Die Küche einer Schule mit zwei Öfen", "kitchen of a school"),
        ("Büro mit einem Schrank, der an der linken Wand steht", "a cabinet, that is on the left wall"),
        ("Ein Raum, 4 mal 5 Meter, mit einem Tisch und ohne Teppich oder Vorhang", "4 x 5 m"),
        ("Cocina con una mesa de madera redonda en la pared del fondo", "a wooden round table on the back wall"),
        (
            "Bureau avec une armoire de classement noire contre le mur de gauche",
            "a black filing cabinet against the left",
        ),
        ("卧室里窗边的书桌和两把白色椅子", "desk by the window and two white chairs"),
        ("教室，椅子十六把，黑板在门的对面", "16 chairs, blackboard opposite door"),
        ("房间长四米宽三米，床一米八宽", "4 m long and 3 m wide, bed 1.8 m wide"),
    ],
)
def test_words_stand_in_the_order_of_english(text: str, said: str) -> None:
    assert said in read_source(text).spoken


@pytest.mark.parametrize(
    ("text", "things", "unread"),
    [
        ("Ein Zimmer mit einem Bett und einem Fang", {"bed"}, ["fang"]),
        ("Un cuarto con una cama y dos pandas", {"bed"}, ["pandas"]),
        ("Une pièce avec un lit et trois zincs", {"bed"}, ["zincs"]),
    ],
)
def test_what_has_no_translation_is_no_english_word(text: str, things: set[str], unread: list[str]) -> None:
    graph = read_by_rules(text)
    assert {entity.category for entity in graph.entities} == things
    assert [left.words.split()[-1] for left in graph.unread] == unread


def test_an_adjective_in_small_letters_is_no_compound() -> None:
    graph = read_by_rules("Ein Büro mit einem unwegsamtbaren Schreibtisch und einem Stuhl")
    assert {entity.category for entity in graph.entities} == {"desk", "chair"}


def test_nouns_of_several_meanings_are_told_by_words_around_them() -> None:
    assert "bar counter" in read_source("Un bar con una barra larga y mesas").spoken
    assert "bread loaves" in read_source("Una panadería con cestas llenas de barras").spoken
    assert read_source("Bureau avec un bureau et une chaise").spoken == "office with a desk and a chair"


def test_all_that_is_absent_is_excluded() -> None:
    graph = read_by_rules("Ein Bad mit einer Dusche, ohne Badewanne oder Teppich, weder Pflanzen noch Bilder")
    assert {exclusion.words for exclusion in graph.exclusions} == {"bathtub", "rug", "plants", "pictures"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_numbers_have_one_name_each(language: str) -> None:
    found = numerals(language)
    assert set(found.values()) == set(range(2, 201))
    assert all(tables(language).phrases[name][0] in (str(n), "two") for name, n in found.items())


@pytest.mark.parametrize("language", LANGUAGES)
def test_names_of_things_are_read_as_their_categories(language: str) -> None:
    listed = words(f"translations/{language}_things")
    names = [name for row in listed.values() for name in row.split(", ")]
    assert len(names) == len(set(names))
    assert set(listed) <= set(categories())
    wrong = [category for category in listed if vocabulary()[english_of(category)].get("noun") != category]
    assert wrong == []
