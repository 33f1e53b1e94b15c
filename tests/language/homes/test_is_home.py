"""Whether a request is for a whole home or for one room."""

from pathlib import Path

import pytest

from sceneweaver.knowledge.load import read_yaml, room_types, room_words
from sceneweaver.language.homes import is_home
from sceneweaver.scene import InputError

REQUESTS = Path(__file__).parents[3] / "benchmarks" / "requests.yaml"


@pytest.mark.parametrize(
    "text",
    [
        "a two-bedroom flat with a big kitchen",
        "3 bed 2 bath",
        "A house",
        "my parents want a bungalow with wide doors",
        "an apartment for a family of four",
        "a dental practice with three surgeries and a waiting room",
        "an office with two meeting rooms and a kitchen",
        "school with four classrooms and toilets",
        "kitchen, living room and two bedrooms",
        "Plan of a house with a garage.",
        "a hostel with two dorms, a kitchen and showers",
        "Eine Wohnung mit zwei Schlafzimmern",
        "Une maison avec trois chambres",
        "Un piso de tres dormitorios",
        "三室两厅的房子",
    ],
)
def test_several_rooms_are_a_home(text):
    assert is_home(text)


@pytest.mark.parametrize(
    "text",
    [
        "a bedroom",
        "a studio desk",
        "a living room with a kitchen corner",
        "office for two",
        "a studio apartment for a student",
        "a small flat of one room",
        "the bathroom of our house",
        "Kitchen of a two-bedroom flat",
        "In my flat the kitchen is narrow, 2 m by 4 m",
        "a bedroom with an en-suite bathroom and a walk-in closet",
        "a home office",
        "a dentist's surgery with a chair and a lamp",
        "an open-plan office with a meeting corner and phone booths",
        "a towel that hangs flat, and three floor lamps",
        "A hall for robots. Floor 6 x 6 m, flat, no rugs.",
        "a room 4 x 5 m with a flat floor and one table",
        "a hotel room with a bathroom",
        "doll's house on a shelf in a nursery",
        "cabin of a ship with two bunks",
        "Ein Schlafzimmer mit Bett",
        "一间卧室",
    ],
)
def test_one_room_stays_one(text):
    assert not is_home(text)


def test_no_kind_of_room_is_a_home_by_its_name():
    taken = [name for name in (*room_words(), *room_types()) if is_home(name)]
    assert taken == []


def test_requests_for_rooms_stay_such():
    taken = [text for text in read_yaml(REQUESTS.read_text("utf-8")) if is_home(text)]
    assert taken == []


@pytest.mark.parametrize("text", ["", "  ", None])
def test_nothing_is_refused(text):
    with pytest.raises(InputError, match="prompt"):
        is_home(text)
