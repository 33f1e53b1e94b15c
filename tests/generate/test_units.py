"""Groups as rigid units: where each member stands to the others."""

from __future__ import annotations

import math

import pytest

from sceneweaver.assets import Library
from sceneweaver.generate.patterns import Pitch, Spot, double_rows, end_to_end, right_angle, seen_from, within
from sceneweaver.layout.engine import refine
from sceneweaver.scene import Relation, Scene
from tests.generate.drafts import drawn


def places(scene: Scene) -> dict[str, Relation]:
    return {r.subject: r for r in scene.relations if r.type == "arranged" and r.hard}


def test_a_spot_seen_from_another_and_back():
    base, spot = Spot(1.0, -0.5, 90.0), Spot(0.3, 2.0, -45.0)
    back = within(base, seen_from(base, spot))
    assert (back.ahead, back.left) == pytest.approx((spot.ahead, spot.left)) and back.turn == pytest.approx(spot.turn)


def test_rows_at_right_angles_meet_at_a_corner():
    first, second = right_angle([(0.9, 2.0)], [(0.8, 1.6)], 0.1, 0.4, open_=True)
    assert first == Spot(0.0, 0.0) and second.turn == -90.0
    assert second.left - 0.4 - 1.0 == pytest.approx(0.4)  # its front to the end of the first
    assert second.ahead - 0.8 == pytest.approx(-0.45)  # begins level with the backs


def test_double_rows_have_their_backs_together_by_twos():
    spots = double_rows(4, 2, 8, Pitch(0.4, 1.0, 0.0, 1.2))
    aheads = sorted({round(s.ahead, 3) for s in spots}, reverse=True)
    assert [round(a - b, 2) for a, b in zip(aheads, aheads[1:], strict=False)] == [0.41, 1.59, 0.41]


def test_ends_touch_along_the_longer_side():
    assert [s.ahead for s in end_to_end([(2.0, 1.0), (2.0, 1.0)], 0.1)] == pytest.approx([0.0, -2.1])
    assert [s.left for s in end_to_end([(0.8, 1.6), (0.8, 1.6)], 0.0)] == pytest.approx([0.0, 1.6])


def test_what_is_between_two_that_face_each_other_is_in_their_middle(library: Library):
    scene = drawn("a sitting room with two sofas facing each other and a coffee table between them", library)
    told = places(scene)
    (table,) = [o.id for o in scene.objects if o.category == "coffee_table"]
    (other,) = [r for r in told.values() if abs(r.params["turn"]) == 180.0]
    assert told[table].target == other.target
    size = {o.id: o.size for o in scene.objects}
    before = told[table].params["ahead"] - (size[other.target][0] + size[table][0]) / 2
    behind = other.params["ahead"] - told[table].params["ahead"] - (size[other.subject][0] + size[table][0]) / 2
    assert before == pytest.approx(behind, abs=0.01) and 0.3 < before < 0.6


def test_what_is_between_beds_brings_them_side_by_side_at_their_heads(library: Library):
    scene = drawn("a guest room with two single beds and a nightstand between them", library)
    told = places(scene)
    beds = [o for o in scene.objects if o.category == "single_bed"]
    (stand,) = [o for o in scene.objects if o.category == "nightstand" and o.id in told]
    (second,) = [told[b.id] for b in beds if b.id in told]
    assert second.params["ahead"] == pytest.approx(0.0, abs=0.1) and second.params["turn"] == 0.0
    lead = next(b for b in beds if b.id == second.target)
    back = told[stand.id].params["ahead"] - stand.size[0] / 2
    assert back == pytest.approx(-lead.size[0] / 2, abs=0.01)
    assert 0 < told[stand.id].params["left"] < second.params["left"]


def test_things_told_to_be_at_two_walls_are_left_to_the_search(library: Library):
    text = "a study with two desks facing each other, one desk against the left wall and one against the right wall"
    told = places(drawn(text, library))
    assert not [r for r in told.values() if "desk" in r.subject and "desk" in str(r.target)]


def test_beds_stand_at_both_long_walls_with_something_between(library: Library):
    scene = drawn("a hostel room with four bunk beds along both long walls and a chest between each two", library)
    walls = {r.target for r in scene.relations if r.type == "side_against_wall" and r.subject.startswith("bunk")}
    assert len(walls) == 2
    chests = [o for o in scene.objects if o.intent.request == "chest"]
    assert len(chests) == 2 and all(c.id in places(scene) for c in chests)


def test_a_composed_group_can_be_placed(library: Library):
    scene = drawn("a lobby with two sofas at right angles and a coffee table between them", library)
    told = places(scene)
    ids = {name for r in told.values() for name in (r.subject, r.target)}
    objects = tuple(o for o in scene.objects if o.id in ids)
    assert len(objects) == 3
    alone = scene.model_copy(update={"objects": objects, "relations": tuple(told.values())})
    solution = refine(alone, candidates=16, seed=0, device="cpu").best
    assert solution is not None
    (turn,) = [r.params["turn"] for r in told.values() if r.subject.startswith("sofa")]
    assert math.isclose(abs(turn), 90.0)
