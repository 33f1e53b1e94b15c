"""What people name in stables, wards, workshops, stations and halls gets its own body, and no plain box."""

from __future__ import annotations

import pytest

from sceneweaver.assets.category import categories
from sceneweaver.language.read import read_by_rules


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("a tack room with a metal feed bin by the door", "feed_bin"),
        ("a stable with bridle hooks beside the door", "bridle_rack"),
        ("a synagogue with a low carved screen", "carved_screen"),
        ("a shul with an eternal light above the bench", "eternal_lamp"),
        ("a lab with a class II cabinet on the left wall", "biosafety_cabinet"),
        ("a ward with a syringe pump next to the bed", "infusion_pump"),
        ("a violin workshop with a glue pot on the workbench", "glue_pot"),
        ("a smithy with a post vice in the middle", "leg_vise"),
        ("a sleeper carriage with two berths", "berth"),
        ("a gate lounge with a flight information display", "departure_board"),
        ("a theatre with a lighting rig", "lighting_truss"),
        ("a locker room with a duckboard in front of the bench", "duckboard"),
        ("a clubhouse with a tactics board on the wall", "tactics_board"),
        ("a plant room with two circulation pumps", "pump"),
        ("a classroom with a laptop trolley", "laptop_cart"),
    ],
)
def test_a_thing_of_a_trade_has_a_body_of_its_own(text: str, category: str) -> None:
    found = [e for e in read_by_rules(text).entities if e.category == category]
    assert len(found) == 1 and not found[0].generic
    assert categories()[category].size is not None


def test_a_hyphen_in_a_name_hides_no_word() -> None:
    """A name is known without its hyphen, so that each of its words is accounted for."""
    graph = read_by_rules("an x-ray room with an x-ray viewer and a pull-up rig")
    assert {"light_box", "training_rig"} <= {entity.category for entity in graph.entities}
    assert not graph.unread


@pytest.mark.parametrize("text", ["a lab with a 3D printer", "a lab with two 3D printers"])
def test_3d_begins_a_name_and_is_no_number(text: str) -> None:
    (printer,) = [entity for entity in read_by_rules(text).entities if "printer" in entity.category]
    assert printer.category == "printer_3d"
    assert printer.count == ((2, 2) if "two" in text else (1, 1))
