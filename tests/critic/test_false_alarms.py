"""What a visitor would not call a fault: each beside what he would."""

from __future__ import annotations

import pytest

from sceneweaver.critic.design import other_faults
from sceneweaver.critic.kinds import groups_of
from sceneweaver.knowledge import room_type
from sceneweaver.scene import Relation
from tests.critic import breaches, rooms
from tests.critic.breaches import box, broken, lamp
from tests.critic.rooms import Case

CHAIR = (0.5, 0.5, 0.9)

SOFT = {"textile", "plant_group"}


def uneven_rows(survey) -> list[str]:
    return [f.fault.kind for f in other_faults(survey) if f.fault.kind == "uneven_row"]


@pytest.mark.parametrize(("depth", "ahead", "uneven"), ((0.5, 0.0, False), (0.6, 0.05, False), (0.5, 0.05, True)))
def test_cabinets_of_another_depth_are_in_line_where_their_backs_are(depth, ahead, uneven) -> None:
    row = [box(f"cabinet-{k}", (0.5, 1.0, 0.8), 0.26, 0.8 + 1.02 * k) for k in range(3)]
    last = box("cabinet-3", (depth, 1.0, 0.8), 0.26 + ahead, 0.8 + 1.02 * 3)
    assert uneven_rows(breaches.survey("office", [*row, last])) == ["uneven_row"] * uneven


@pytest.mark.parametrize(("out", "uneven"), ((0.04, False), (0.09, True)))
def test_chairs_are_not_pushed_in_to_the_centimetre(out, uneven) -> None:
    table = box("dining_table-0", (0.9, 1.6, 0.75), 3.0, 2.5, 90)
    seats = [box("dining_chair-0", CHAIR, 2.6, 1.8, 90), box("dining_chair-1", CHAIR, 3.4, 1.8 - out, 90)]
    assert uneven_rows(breaches.survey("dining_room", [table, *seats])) == ["uneven_row"] * uneven


@pytest.mark.parametrize(("absent", "named"), ((1, False), (3, True)))
def test_a_room_may_do_without_one_of_many_usual_things(absent, named) -> None:
    case = rooms.bedroom()
    have = sorted({o.category for o in case.scene.objects})
    assert len(have) > 6
    gone = ("piano", "aquarium", "easel")[:absent]
    items = [{"id": what, "what": what, "need": "usual"} for what in (*have, *gone)]
    review = Case(case.scene, rooms.kind("bedroom", items)).review()
    assert any(f.kind == "missing_usual" and "piano" in f.reason for f in review.faults) is named


@pytest.mark.parametrize(("gap", "asked", "named"), ((0.25, False, False), (2.0, False, True), (0.25, True, True)))
def test_a_wish_that_is_missed_by_little_is_no_fault(gap, asked, named) -> None:
    case = rooms.office()
    wish = Relation(type="off_walls", subject="desk-0", params={"min": gap}, hard=False, asked=asked)
    scene = case.scene.model_copy(update={"relations": (*case.scene.relations, wish)})
    judged = Case(scene, case.room_type)
    assert any(v.kind == "soft_relation" for v in judged.report().violations)
    assert any(f.kind == "soft_relation" for f in judged.review().faults) is named


def test_what_people_leave_on_the_floor_carries_nothing() -> None:
    case = rooms.living()
    basket, table = rooms.put("basket-0", 0.6, 0.6, mount="floor"), rooms.put("side_table-9", 0.6, 0.6)
    assert not [f for f in case.plus(basket).review().faults if f.kind == "empty_support" and "basket-0" in f.objects]
    assert [f for f in case.plus(table).review().faults if f.kind == "empty_support" and "side_table-9" in f.objects]


def test_lights_of_the_room_take_no_lamp_off_the_middle_of_a_table() -> None:
    table = box("dining_table-0", (0.9, 1.6, 0.75), 3.0, 2.5)
    seat, pendant = box("dining_chair-0", CHAIR, 2.3, 2.5), lamp("pendant-0", 3.0, 2.5, 1.5)
    for light in (lamp("ceiling_light-0", 3.4, 3.2), lamp("ceiling_light-0", 3.0, 1.75)):
        assert not broken("lamp_over_table", "kitchen", [table, seat, pendant, light])


@pytest.mark.parametrize(("kind", "empty"), (("bedroom", False), ("office", True)))
def test_the_floor_before_a_wardrobe_is_no_empty_floor_of_a_home(kind, empty) -> None:
    wardrobe = box("wardrobe-0", (0.6, 2.5, 2.0), 0.32, 1.3)
    desk = box("desk-0", (3.0, 1.0, 0.8), 1.5, 3.1)
    assert (
        bool(broken("no_empty_floor", kind, [wardrobe, desk], breaches.room(2.5, 3.7, door=1.5, window=None))) is empty
    )


@pytest.mark.parametrize(("kind", "missed"), (("workshop", False), ("living_room", True)))
def test_a_workshop_needs_no_cloth_and_no_plant(kind, missed) -> None:
    case = Case(rooms.office().scene, room_type(kind))
    bare = case.but(*({"id": o.id, "gone": True} for o in case.scene.objects if SOFT & groups_of(o.category)))
    said = {n for f in bare.review().faults for n in (f.kind, f.reason)}
    assert any("no_softness" in s or "plant" in s or "textile" in s or "rug" in s for s in said) is missed
