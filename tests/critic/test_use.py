"""Pairs of scenes for realism, functionality and completion."""

from __future__ import annotations

import pytest

from sceneweaver.critic.design.breach import breach
from sceneweaver.critic.grade import eased, finding, grades, squash
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Intent, Scene
from tests.critic import rooms
from tests.critic.rooms import Case, put
from tests.critic.test_layout import falls, only

# ---- functionality ---------------------------------------------------------------------------------------------------


def test_no_bed_in_a_bedroom() -> None:
    good = rooms.bedroom()
    bad = good.but({"id": "bed-0", "gone": True})
    fault = falls(good, bad, "missing_needed", set(), criterion="functionality", least=3.2)
    assert bad.review().grades["functionality"] < 6.0
    assert fault.tool == "add_objects" and fault.inputs["objects"][0]["category"] == "bed"
    assert {"type": "against_wall"} in fault.inputs["objects"][0]["place"]


def test_one_nightstand_of_two_is_less_grave_than_none() -> None:
    good = rooms.bedroom()
    two = good.review().grades["functionality"]
    one = good.but({"id": "nightstand-0", "gone": True}).review().grades["functionality"]
    none = good.but({"id": "nightstand-0", "gone": True}, {"id": "nightstand-1", "gone": True}).review()
    assert 0.8 * two < one < 0.95 * two and none.grades["functionality"] < 0.7 * two


def test_fewer_than_the_floor_would_take_is_no_lack_of_the_needed() -> None:
    items = [
        {"id": "desk", "what": "desk", "need": "needed", "count": {"per_area": 0.3, "least": 2, "most": 9}},
        {"id": "chair", "what": "office_chair", "need": "needed", "with": "desk"},
    ]
    case = rooms.office()
    few = Case(case.scene, rooms.kind("office", items)).review()
    assert 0.85 * case.review().grades["functionality"] < few.grades["functionality"]
    assert only(few, "missing_needed", "functionality")[0].reason.startswith("2 of 3 desks")


def test_kin_may_stand_in_for_what_is_needed() -> None:
    good = rooms.bedroom()
    bed = good.scene.object("bed-0")
    other = good.but({"id": "bed-0", "update": {"category": "king_bed", "size": bed.size}})
    assert not only(other.review(), "missing_needed", "functionality")


def test_items_that_intents_name_count() -> None:
    good = rooms.bedroom()
    named = good.but(
        {"id": "dresser-0", "update": {"intent": Intent(program_item="wardrobe")}}, {"id": "wardrobe-0", "gone": 1}
    )
    assert not only(named.review(), "missing_needed", "functionality")


def test_desk_without_chair() -> None:
    good = rooms.bedroom().but({"id": "dresser-0", "gone": True})
    desk = put("desk-0", 2.6, 0.32, 90, size=(0.6, 1.1, 0.74))
    fault = falls(
        good,
        good.plus(desk),
        "incomplete_group",
        {"desk-0"},
        criterion="functionality",
        least=1.0,
        also=("layout", "completion"),
    )
    row = fault.inputs["objects"][0]
    assert row["place"] == [{"type": "front_to_front", "to": "desk-0"}] and row["count"] == 1


def test_table_with_too_few_chairs() -> None:
    good = rooms.restaurant()
    bad = good.but(*({"id": f"dining_chair-{k}", "gone": True} for k in range(4)))
    fault = falls(good, bad, "missing_needed", set(), criterion="functionality", least=0.5)
    row = fault.inputs["objects"][0]
    assert row["count"] == 4 and row["place"] == [{"type": "front_against", "to": "dining_table-0"}]
    assert len(fault.inputs["objects"]) == 1


def test_chair_that_nobody_can_get_into() -> None:
    good = rooms.office()
    bad = good.plus(put("sideboard-0", 0.95, 2.2, -90, size=(0.4, 1.3, 0.8)))
    assert only(bad.review(), "cramped_seat", "functionality")


# ---- realism ---------------------------------------------------------------------------------------------------------


def test_toilet_in_a_bedroom() -> None:
    good = rooms.bedroom()
    bad = good.plus(put("toilet-0", 0.4, 0.36, 90))
    fault = falls(good, bad, "foreign_object", {"toilet-0"}, criterion="realism", least=3.5, also=("layout",))
    assert bad.review().grades["realism"] <= 5.0
    assert fault.tool == "remove_objects" and fault.inputs == {"ids": ["toilet-0"]}


def test_what_was_asked_for_is_not_foreign() -> None:
    asked = SceneGraph.model_validate(
        {"text": "", "entities": [{"id": "toilet", "noun": "toilet", "category": "toilet"}]}
    )
    good = rooms.bedroom()
    scene = good.plus(put("toilet-0", 0.4, 0.3, 90)).scene
    assert not only(Case(scene, good.room_type, asked).review(), "foreign_object", "realism")


@pytest.mark.parametrize("category", ["side_table", "floor_lamp", "suitcase", "armchair"])
def test_everyday_furniture_is_not_foreign(category: str) -> None:
    bad = rooms.bedroom().plus(put(f"{category}-9", 1.9, 3.6))
    assert not only(bad.review(), "foreign_object", "realism")


def test_one_kind_dominates_unless_the_room_is_made_of_it() -> None:
    assert not only(rooms.restaurant().review(), "dominant_category", "realism")
    plants = [put(f"snake_plant-{k}", 0.3 + 0.45 * k, 0.3, size=(0.3, 0.3, 0.8)) for k in range(3, 10)]
    good = rooms.living()
    fault = falls(
        good,
        good.plus(*plants),
        "dominant_category",
        {"snake_plant-3"},
        criterion="realism",
        least=0.8,
        also=("layout", "functionality"),
    )
    assert set(fault.inputs["ids"]) < {f"snake_plant-{k}" for k in range(10)}


# ---- completion ------------------------------------------------------------------------------------------------------


def test_nothing_on_tables_and_shelves() -> None:
    good = rooms.living()
    small = [{"id": o.id, "gone": True} for o in good.scene.objects if o.mount == "surface" and "tv" not in o.id]
    bad = good.but(*small)
    fault = falls(good, bad, "empty_support", {"coffee_table-0", "bookcase-0"}, criterion="completion", least=2.0)
    assert bad.review().measures["populated_share"] < good.review().measures["populated_share"] == 1.0
    assert bad.review().grades["completion"] <= 5.0
    assert fault.tool in ("add_tabletop", "add_crowd")
    crowd = next(f for f in bad.review().faults if f.kind == "empty_support" and "bookcase-0" in f.objects)
    assert crowd.tool == "add_crowd" and crowd.inputs == {"supports": ["bookcase-0"], "theme": "books"}


def test_sparse_shelf() -> None:
    good = rooms.office()
    bad = good.but(*({"id": f"standing_books-{k}", "gone": True} for k in (1, 2, 3)))
    falls(good, bad, "sparse_support", {"bookcase-0"}, criterion="completion", least=0.1, also=("functionality",))


def test_bare_walls_and_no_light() -> None:
    good = rooms.bedroom()
    bad = good.but({"id": "picture-0", "gone": True}, {"id": "ceiling_light-0", "gone": True})
    review = bad.review()
    assert {f.inputs["objects"][0]["category"] for f in only(review, "missing_usual", "completion")} == {
        "picture",
        "ceiling_light",
    }
    assert review.grades["completion"] <= 0.95 * good.review().grades["completion"]
    assert not only(review, "missing_usual", "functionality")


def test_half_empty_room_is_incomplete() -> None:
    good = rooms.living()
    far = good.scene.model_copy(update={"room": rooms.room(9.0, 6.0)})
    review = Case(far, good.room_type).review()
    assert review.grades["completion"] <= 5.0 and only(review, "bare", "completion")
    assert review.measures["used_share"] < 0.5


def test_sparse_requests_are_not_held_to_the_same() -> None:
    good = rooms.bedroom().but({"id": "picture-0", "gone": True}, {"id": "dresser-0", "gone": True})
    sparse = Case(good.scene, good.room_type, SceneGraph(text="", density="sparse"))
    assert sparse.review().grades["completion"] > good.review().grades["completion"]


# ---- grades ----------------------------------------------------------------------------------------------------------


def test_empty_room() -> None:
    case = rooms.bedroom()
    empty = Case(Scene(id="empty", room=case.scene.room), case.room_type)
    review = empty.review()
    assert review.total < 4.0 and review.grades["functionality"] <= 1.0
    assert {f.inputs["objects"][0]["category"] for f in only(review, "missing_needed", "functionality")} >= {"bed"}


def test_grades_fall_with_every_fault_and_never_below_zero() -> None:
    for curve in (squash, eased):
        values = [curve(0.25 * k) for k in range(200)]
        assert all(a > b > 0.0 for a, b in zip(values, values[1:], strict=False)) and values[0] == 10.0
    found = [finding("layout", f"k{k}", (), "x", points=2.0, cap=5.0 if k == 0 else None) for k in range(8)]
    series = [grades(found[:k])["layout"] for k in range(9)]
    assert series[1] < 0.75 * series[0] and all(a > b for a, b in zip(series, series[1:], strict=False))
    assert grades(found)["realism"] == grades([])["realism"], "a user's own checks lower their own grade alone"
    known = grades([finding("layout", "collision", (), "x", points=2.0)])
    assert known["realism"] < grades([])["realism"], "who sees one thing wrong marks down the rest"


def test_ten_is_rare_and_what_was_asked_for_is_graded_by_itself() -> None:
    nothing = grades([])
    assert all(6.0 < nothing[c] < 9.5 for c in ("realism", "functionality", "layout", "completion"))
    assert nothing["alignment"] == 10.0
    wrong = grades([breach("door_frame", ("bed-0",), "it is near")])
    assert all(wrong[c] < nothing[c] for c in ("realism", "functionality", "layout", "completion"))
    assert wrong["alignment"] == 10.0


def test_order_of_objects_and_turns_of_the_room_change_nothing() -> None:
    import math

    from sceneweaver.scene import Pose

    case = rooms.living()
    base = case.review()
    back = case.scene.model_copy(update={"objects": case.scene.objects[::-1]})
    assert Case(back, case.room_type).review().grades == base.grades
    for degrees in (90, 37):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        outline = tuple((c * x - s * y + 3, s * x + c * y - 1) for x, y in case.scene.room.outline)
        poses = {
            o.id: Pose.from_yaw(
                c * o.pose.position[0] - s * o.pose.position[1] + 3,
                s * o.pose.position[0] + c * o.pose.position[1] - 1,
                o.pose.position[2],
                o.pose.yaw + math.radians(degrees),
            )
            for o in case.scene.objects
        }
        turned = case.scene.replace_poses(poses)
        turned = turned.model_copy(update={"room": turned.room.model_copy(update={"outline": outline})})
        grade = Case(turned, case.room_type).review().grades
        assert grade == pytest.approx(base.grades, abs=0.15)


def test_categories_in_other_words() -> None:
    good = rooms.living()
    other = good.but(
        {"id": "sofa-0", "update": {"category": "couch"}}, {"id": "bookcase-0", "update": {"category": "bookshelf"}}
    )
    assert other.review().grades == good.review().grades
    strange = good.but({"id": "armchair-0", "update": {"category": "quux machine"}})
    assert strange.review().total > 0.9 * good.review().total


def test_reasons_use_the_right_article() -> None:
    case = rooms.office().but({"id": "bookcase-0", "gone": True}, {"id": "low_bookcase-0", "gone": True})
    fault = only(case.review(), "missing_usual", "completion")[0]
    assert fault.reason == "there is no bookcase; an office usually has 1"


@pytest.mark.parametrize("name", ["bedroom", "living_room", "office", "kitchen"])
def test_the_scenes_that_ship_with_the_library(name: str) -> None:
    from sceneweaver.knowledge import room_types
    from sceneweaver.scene import EXAMPLES

    for example in EXAMPLES:
        room = room_types().get(name) or rooms.BEDROOM
        review = Case(Scene.example(example), room).review()
        assert all(0.0 <= grade <= 10.0 for grade in review.grades.values())


def test_tilted_things_and_round_rooms_are_read() -> None:
    import math

    case = rooms.living()
    o = case.scene.object("armchair-0")
    tilted = o.pose.model_copy(update={"quaternion": (math.sin(0.3), 0.0, 0.0, math.cos(0.3))})
    outline = tuple((2.5 + 3.6 * math.cos(k * math.pi / 10), 2.1 + 3.6 * math.sin(k * math.pi / 10)) for k in range(20))
    scene = case.scene.replace_poses({o.id: tilted})
    room = scene.room.model_validate({"outline": outline, "height": 2.6})
    review = Case(scene.model_copy(update={"room": room}), case.room_type).review()
    assert review.measures["floor_m2"] > 35.0 and not only(review, "crooked")
