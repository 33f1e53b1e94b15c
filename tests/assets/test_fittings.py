"""Names of what homes, bars, shops, arcades and studios are fitted out with, and the bodies that they get."""

import pytest

from sceneweaver.assets.taxonomy import resolve
from sceneweaver.language import read_request


@pytest.mark.parametrize(
    ("noun", "category"),
    [
        ("saucepan rail", "pan_rail"),
        ("knife rack", "knife_strip"),
        ("breadbox", "bread_bin"),
        ("walk-in panel", "shower_screen"),
        ("grabber machine", "claw_machine"),
        ("pull-up banner", "rollup_banner"),
        ("pass-through window", "serving_hatch"),
        ("bargain bin", "dump_bin"),
        ("tailor's dummy", "dress_form"),
        ("clocking-in machine", "time_clock"),
        ("TV tray", "tray_table"),
        ("step and repeat", "press_wall"),
    ],
)
def test_british_and_american_names_have_the_right_body(noun: str, category: str) -> None:
    match = resolve(noun)
    assert (match.category, match.generic) == (category, False)


def test_a_rack_is_what_its_load_asks_for() -> None:
    assert resolve("kimono rack").body == "clothes_rack"
    assert resolve("screwdriver rack").body == "pegboard"
    assert resolve("engine rack").body == "metal_shelf"


@pytest.mark.parametrize(
    ("text", "noun", "category"),
    [
        ("a kitchen with a rail over the hob for saucepans", "rail", "pan_rail"),
        ("a tailor's with a counter and a steamer", "counter", "shop_counter"),
        ("a tailor's shop with a steamer in the corner", "steamer", "garment_steamer"),
        ("a bakehouse with a mixer and sacks of flour", "mixer", "dough_mixer"),
        ("a podcast studio with a mixer on the table", "mixer", "mixing_console"),
    ],
)
def test_one_word_is_another_thing_in_another_room(text: str, noun: str, category: str) -> None:
    assert {e.category for e in read_request(text).entities if e.noun == noun} == {category}


def test_a_place_is_no_part_of_a_name() -> None:
    graph = read_request("a study with a clock on the wall above the desk")
    assert ("wall_clock", ("desk",)) in {(r.subject, r.targets) for r in graph.relations if r.type == "above"}
