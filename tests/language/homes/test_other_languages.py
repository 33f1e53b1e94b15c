"""Requests for homes in German, French, Spanish and Chinese, by the tables of words."""

from collections import Counter

import pytest

from sceneweaver.knowledge.load import read_yaml
from sceneweaver.language.homes import is_home, read_home
from sceneweaver.language.homes.lexicon import data, known


@pytest.mark.parametrize(
    ("text", "language", "use", "counts"),
    [
        (
            "Eine Wohnung mit zwei Schlafzimmern und einer großen Küche, 80 m2.",
            "de",
            "flat",
            {"bedroom": 2, "kitchen": 1},
        ),
        ("3-Zimmer-Wohnung für ein Paar mit zwei Kindern, mit Balkon", "de", "flat", {"bedroom": 2, "balcony": 1}),
        (
            "Haus mit zwei Stockwerken: unten die Küche, oben drei Schlafzimmer",
            "de",
            "house",
            {"bedroom": 3, "landing": 1},
        ),
        ("Zahnarztpraxis mit drei Behandlungsräumen und Wartezimmer", "de", "dental_practice", {"dentist": 3}),
        ("Un appartement avec deux chambres et une grande cuisine, 75 m2", "fr", "flat", {"bedroom": 2, "kitchen": 1}),
        ("Une maison à deux étages avec trois chambres et un garage", "fr", "house", {"bedroom": 3, "garage": 1}),
        (
            "Cabinet médical avec deux salles de consultation et une salle d'attente",
            "fr",
            "clinic",
            {"doctors_office": 2},
        ),
        ("Un piso de tres dormitorios con una cocina grande y dos baños", "es", "flat", {"bedroom": 3, "bathroom": 2}),
        ("Una casa de dos plantas con cuatro dormitorios y un garaje", "es", "house", {"bedroom": 4, "garage": 1}),
        ("Oficina con dos salas de reuniones, una cocina y aseos", "es", "office", {"meeting_room": 2}),
        ("一套两室一厅的公寓，厨房要大，80平方米", "zh", "flat", {"bedroom": 2, "living_room": 1, "kitchen": 1}),
        ("三间卧室、两个卫生间和一个客厅的房子", "zh", "house", {"bedroom": 3, "bathroom": 2}),
    ],
)
def test_simple_requests(text, language, use, counts):
    assert is_home(text)
    read = read_home(text)
    found = Counter(room.type for room in read.programme.rooms)
    assert (read.language, read.use) == (language, use)
    assert {name: found[name] for name in counts} == counts


def test_storeys_and_areas():
    read = read_home("Ein Haus mit zwei Stockwerken: unten Wohnzimmer und Küche, oben drei Schlafzimmer und ein Bad.")
    storey = {room.id: room.storey for room in read.programme.rooms}
    assert (storey["living_room"], storey["bedroom"], storey["bathroom"]) == (0, 1, 1)
    assert read_home("一套两室一厅的公寓，80平方米").area == 80


def test_words_mean_what_the_reader_of_homes_knows():
    """Each English word of the tables for homes is one of its own words, or made of these."""
    assert read_yaml and set(data("translations")) == {"de", "fr", "es", "zh"}
    for rows in data("translations").values():
        for english in (meaning for kind in rows.values() for meaning in kind.values()):
            phrase = str(english).replace("-", " ")
            assert known(phrase) or all(
                known(word) or word.isdigit()
                for word in phrase.replace(",", "").split()
                if word not in ("two", "three", "four", "one", "bed")
            ), english
