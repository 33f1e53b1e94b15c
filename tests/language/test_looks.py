"""Looks of whole rooms: styles, times, themes, moods, light; what is said of one thing alone is none."""

from __future__ import annotations

import pytest

from sceneweaver.assets.materials import color_named, finishes, paint
from sceneweaver.knowledge.looks import joined, look_words, looks, time_of
from sceneweaver.knowledge.since import form_of, is_too_young, out_of_time, stand_in
from sceneweaver.language.read import read_by_rules


def names(text: str) -> list[str]:
    return [said.name for said in read_by_rules(text).looks]


@pytest.mark.parametrize(
    ("text", "year"),
    [
        ("a parlour in 1887 with a piano", 1887),
        ("an office like in the fifties", 1959),
        ("a bar, late 60s, two stools", 1969),
        ("a study, early nineteenth century", 1839),
        ("a hall of the 1700s", 1799),
        ("a viking longhouse with a fire", 1499),
        ("a living room in the eighteen sixties", 1869),
        ("a waiting room, nothing newer than 1955", 1955),
    ],
)
def test_years(text: str, year: int) -> None:
    assert read_by_rules(text).year == year


@pytest.mark.parametrize(
    "text", ["a library with 1500 books", "a shelf of 1800 mm", "a room for a lady in her eighties", "1200 chairs"]
)
def test_numbers_that_are_no_years(text: str) -> None:
    assert read_by_rules(text).year is None


def test_words_of_the_room_and_of_one_thing() -> None:
    assert names("a bedroom in art deco style") == ["art deco"]
    assert names("a bedroom, japandi, with a low bed") == ["japandi"]
    assert names("a kitchen with a rustic table and a retro fridge") == []
    assert names("a lounge with vintage furniture") == ["classic"]
    assert names("a playroom, jungle themed") == ["jungle"]


def test_what_is_not_wanted_is_no_look() -> None:
    assert names("a clinic that is not gloomy") == ["not gloomy"]
    assert names("an office, nothing modern") == []


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("a ward kitchen that must not look like a hospital", "not clinical"),
        ("a cellar bar, nothing creepy about it", "not scary"),
        ("a lobby, it shouldn't feel too corporate", "not corporate"),
        ("a dining room without any posh look", "not flashy"),
    ],
)
def test_what_a_room_is_not_to_be_like_is_its_look(text: str, name: str) -> None:
    assert name in names(text)


def test_a_place_that_is_not_there_is_no_look() -> None:
    assert names("a bedroom, no office") == [] and names("a bedroom without a hospital bed") == []


def test_no_lamps_but_the_one_that_is_named() -> None:
    assert names("a bedroom with one dim lamp on the desk") == ["one lamp"]
    assert names("a bedroom with one lamp on the desk") == []
    graph = read_by_rules("a wine cellar, no daylight at all")
    assert graph.windows == 0 and not graph.unread


def test_contrast_is_a_look() -> None:
    assert names("a toilet with strong contrast between floor and walls") == ["contrast"]


def test_two_colours_of_a_thing_are_not_the_rooms() -> None:
    assert names("a den with a black and white photo") == []
    assert names("a den, black and white") == ["monochrome"]


def test_light_is_read_and_goes_out_of_the_things() -> None:
    graph = read_by_rules("a chapel lit by candles, two benches")
    assert [said.name for said in graph.looks] == ["candle"] and "candle" not in {e.category for e in graph.entities}
    glow = read_by_rules("a bar bathed in red light").looks[0]
    assert glow.color == "neon red"


def test_rows_name_what_is_known() -> None:
    for look in looks().values():
        for name in (*look.woods, *look.metals):
            assert name in finishes(), (look.name, name)
        assert all(paint(name) for name in look.paints)
        colors = [*look.textiles, look.walls and look.walls.color, look.panels and look.panels.color, look.trim]
        for name in colors:
            assert name is None or name in finishes() or color_named(name), (look.name, name)
    words = [word for look in looks().values() for word in look.words]
    assert len(words) == len(look_words()), sorted({word for word in words if words.count(word) > 1})


@pytest.mark.parametrize("year", [1130, 1550, 1650, 1790, *range(1890, 2021, 10), 2200])
def test_every_year_has_a_time(year: int) -> None:
    time = time_of((year, year))
    assert time.years is not None and time.years[0] <= year <= time.years[1]


def test_later_words_refine_earlier_ones() -> None:
    one = joined([looks()["pastel"], looks()["victorian"], looks()["dim"]])
    assert one.woods == looks()["pastel"].woods and one.trim == looks()["victorian"].trim
    assert one.light.level == "dim" and one.years == looks()["victorian"].years


def test_things_have_their_time() -> None:
    assert is_too_young("laptop", 1970) and not is_too_young("desk", 1970)
    assert {"laptop", "tv", "phone"} <= out_of_time(1962) and "rotary_phone" not in out_of_time(1962)
    assert form_of("tv", out_of_time(1962)) == "tube_television" and form_of("tv", out_of_time(1890)) is None
    assert stand_in(("laptop",), out_of_time(1935))[0] == "typewriter"
    assert "typewriter" not in stand_in(("laptop",), out_of_time(1780))


def test_the_side_of_the_sun_is_that_of_a_window():
    (found,) = read_by_rules("a library, late sun from the left").openings
    assert (found.part, found.wall) == ("window", "left")
