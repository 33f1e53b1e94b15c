"""Whether the critic sees what a request asked for, and whether its tool calls can be acted on."""

from __future__ import annotations

from typing import Any

import pytest

from sceneweaver.assets import categories
from sceneweaver.critic import Fault, Review
from sceneweaver.language import SceneGraph
from sceneweaver.scene import CATALOGUE, Intent
from tests.critic import rooms
from tests.critic.rooms import Case, put
from tests.critic.test_layout import only


def brief(**data: Any) -> SceneGraph:
    return SceneGraph.model_validate({"text": "", **data})


def entity(category: str, **more: Any) -> dict[str, Any]:
    return {"id": category, "noun": category.replace("_", " "), "category": category, **more}


def review(case: Case, **data: Any) -> Review:
    return Case(case.scene, case.room_type, brief(**data)).review()


def beyond(found: Review) -> list[Fault]:
    """Lengths that are not as asked."""
    return [fault for fault in found.faults if fault.kind == "wrong_asked_length"]


def test_what_was_asked_is_there() -> None:
    found = review(
        rooms.living(), room_type="living_room", entities=[entity("sofa"), entity("coffee_table", count=(1, 1))]
    )
    assert found.grades["alignment"] == 10.0 and not [f for f in found.faults if f.criterion == "alignment"]


def test_what_nobody_understood_is_not_taken_for_met() -> None:
    unread = [{"words": "ein ruhiges schlafzimmer"}, {"words": "mit bett"}]
    found = review(rooms.living(), unread=unread)
    assert found.grades["alignment"] == 1.0 and only(found, "not_understood", "alignment")[0].tool is None
    known = review(rooms.living(), unread=unread, entities=[entity("sofa")])
    assert known.alignment.share == pytest.approx(1 / 3) and known.grades["alignment"] <= 8.0


def test_missing_and_too_many() -> None:
    case = rooms.office()
    few = review(case, entities=[entity("desk", count=(3, 3)), entity("upright_piano")])
    faults = {f.inputs["objects"][0]["category"]: f for f in only(few, "missing_asked", "alignment")}
    assert faults["desk"].inputs["objects"][0]["count"] == 1 and "upright_piano" in faults
    assert few.grades["alignment"] <= 5.0
    one = review(case, entities=[entity("desk", count=(1, 1))])
    fault = only(one, "too_many", "alignment")[0]
    assert fault.tool == "remove_objects" and fault.inputs["ids"] in (["desk-0"], ["desk-1"])
    assert few.grades["alignment"] < one.grades["alignment"] <= 8.0


def test_another_that_takes_the_same_role_is_one_too_many() -> None:
    case = rooms.living().plus(put("loveseat-0", 1.2, 3.6, -90, size=(0.9, 1.5, 0.8)))
    fault = only(review(case, entities=[entity("sofa", count=(1, 1))]), "too_many", "alignment")[0]
    assert fault.inputs["ids"] == ["loveseat-0"]
    both = [entity("sofa", count=(1, 1)), entity("loveseat", count=(1, 1))]
    assert not only(review(case, entities=both), "too_many", "alignment")
    assert not only(review(case, entities=[entity("sofa")]), "too_many", "alignment"), "no number was given"


def test_what_a_table_is_laid_with_is_asked_of_the_table() -> None:
    case = rooms.office()
    bare = Case(
        case.scene.model_copy(
            update={"objects": tuple(o for o in case.scene.objects if o.support is None), "relations": ()}
        ),
        case.room_type,
    )
    fault = only(review(bare, entities=[entity("monitor", count=(2, 2))]), "missing_asked", "alignment")[0]
    assert fault.tool == "add_tabletop" and fault.inputs["objects"] == [{"category": "monitor", "count": 2}]
    (desk,) = fault.inputs["supports"]
    assert bare.scene.object(desk).category == "desk"
    many = only(review(bare, entities=[entity("monitor", count=(9, 9))]), "missing_asked", "alignment")[0]
    assert many.tool == "add_objects", "too many for one"


def test_attributes_and_sizes() -> None:
    case = rooms.living()
    color = case.scene.object("sofa-0").attributes["color"]
    other = "red" if color != "red" else "blue"
    assert not only(review(case, entities=[entity("sofa", color=color)]), "wrong_color", "alignment")
    assert only(review(case, entities=[entity("sofa", color=other)]), "wrong_color", "alignment")[0].objects == (
        "sofa-0",
    )
    assert not only(review(case, entities=[entity("sofa", size=(None, 2.0, None))]), "wrong_asked_size", "alignment")
    wide = only(review(case, entities=[entity("sofa", size=(None, 2.6, None))]), "wrong_asked_size", "alignment")[0]
    assert wide.inputs["sizes"]["sofa-0"][1] == 2.6
    small = case.but({"id": "coffee_table-0", "update": {"size": (0.5, 0.85, 0.42)}})
    assert only(review(small, entities=[entity("coffee_table", scale=1.3)]), "wrong_asked_size", "alignment")
    assert not only(review(small, entities=[entity("coffee_table", scale=0.8)]), "wrong_asked_size", "alignment")


@pytest.mark.parametrize(
    ("relation", "holds"),
    [
        ({"type": "against", "subject": "sofa", "targets": ("wall",)}, True),
        ({"type": "against", "subject": "sofa", "targets": ("wall:east",)}, True),
        ({"type": "against", "subject": "sofa", "targets": ("wall:right",)}, True),
        ({"type": "against", "subject": "sofa", "targets": ("wall:west",)}, False),
        ({"type": "against", "subject": "sofa", "targets": ("wall:far",)}, False),
        ({"type": "facing", "subject": "sofa", "targets": ("tv_on_stand",)}, True),
        ({"type": "facing", "subject": "armchair", "targets": ("sofa",)}, False),
        ({"type": "on", "subject": "tv_on_stand", "targets": ("tv_stand",)}, True),
        ({"type": "on", "subject": "vase", "targets": ("tv_stand",)}, False),
        ({"type": "at", "subject": "coffee_table", "targets": ("middle",)}, True),
        ({"type": "at", "subject": "bookcase", "targets": ("middle",)}, False),
        ({"type": "at", "subject": "snake_plant", "targets": ("corner",)}, True),
        ({"type": "near", "subject": "armchair", "targets": ("window",)}, False),
        ({"type": "between", "subject": "coffee_table", "targets": ("sofa", "tv_stand")}, True),
        ({"type": "between", "subject": "snake_plant", "targets": ("sofa", "tv_stand")}, False),
    ],
)
def test_asked_relations(relation: dict[str, Any], holds: bool) -> None:
    names = {relation["subject"], *(t for t in relation["targets"] if t in categories())}
    names |= {"coffee_table"} if "vase" in names else set()
    found = review(rooms.living(), entities=[entity(n) for n in sorted(names)], relations=[relation])
    faults = only(found, "asked_relation", "alignment")
    assert (not faults) is holds, faults
    if faults:
        assert found.grades["alignment"] < 9.0 and relation["subject"] in faults[0].objects[0]


def test_what_came_along_may_stand_elsewhere() -> None:
    """A plant on the tv stand and one on the table: who asked for one to three on the stand has one there."""
    case = rooms.living()
    table, stand = case.scene.object("coffee_table-0"), case.scene.object("tv_stand-0")
    said = {"type": "on", "subject": "succulent", "targets": ("tv_stand",)}
    objects = [entity("tv_stand"), entity("succulent", count=(1, 3))]
    elsewhere = rooms.on(table, "succulent-8")
    both = case.plus(rooms.on(stand, "succulent-9"), elsewhere)
    assert not only(review(both, entities=objects, relations=[said]), "asked_relation", "alignment")
    meant = elsewhere.model_copy(update={"intent": Intent(request="succulent")})
    wrong = case.plus(rooms.on(stand, "succulent-9"), meant)
    (fault,) = only(review(wrong, entities=objects, relations=[said]), "asked_relation", "alignment")
    assert "succulent-8" in fault.reason and "succulent-9" not in fault.reason
    alone = case.plus(elsewhere)
    assert only(review(alone, entities=objects, relations=[said]), "asked_relation", "alignment")


def test_what_is_asked_to_face_something_need_not_face_the_usual() -> None:
    case = rooms.living().but({"id": "sofa-0", "yaw": 0})
    said = {"type": "facing", "subject": "sofa", "targets": ("wall:right",)}
    assert only(case.review(), "wrong_orientation")
    assert not only(review(case, entities=[entity("sofa")], relations=[said]), "wrong_orientation")


def test_around() -> None:
    case = rooms.restaurant(1, 1)
    said = {"type": "around", "subject": "dining_chair", "targets": ("dining_table",)}
    objects = [entity("dining_chair", count=(4, 4)), entity("dining_table")]
    good = review(case, entities=objects, relations=[said])
    assert not only(good, "asked_relation", "alignment")
    moved = case.but({"id": "dining_chair-0", "x": 3.4, "y": 4.0})
    assert only(review(moved, entities=objects, relations=[said]), "asked_relation", "alignment")


@pytest.mark.parametrize(
    ("given", "want", "fits"),
    [
        ({"color": "light grey"}, {"color": "gray"}, True),
        ({"color": "navy"}, {"color": "dark blue"}, True),
        ({"color": "red"}, {"color": "blue"}, False),
        ({"color": "weird"}, {"color": "weird"}, True),
        ({"material": "walnut"}, {"material": "wooden"}, True),
        ({"material": "walnut"}, {"material": "oak"}, False),
        ({"material": "brown leather"}, {"material": "leather"}, True),
        ({"material": "black plastic"}, {"material": "metal"}, False),
        ({"style": "modern"}, {"style": "modern"}, True),
        ({}, {"color": "blue"}, True),
    ],
)
def test_words_for_looks(given: dict[str, str], want: dict[str, str], fits: bool) -> None:
    case = rooms.living().but({"id": "sofa-0", "update": {"attributes": given}})
    found = review(case, entities=[entity("sofa", **want)])
    assert any(f.kind.startswith("wrong_") for f in found.faults if f.criterion == "alignment") is not fits


def test_without_and_only() -> None:
    case = rooms.bedroom()
    banned = review(case, exclusions=[{"words": "plants and rugs", "categories": ["rug", "plant_group"]}])
    fault = only(banned, "unwanted", "alignment")[0]
    assert set(fault.objects) == {"rug-0", "snake_plant-0"} and banned.grades["alignment"] <= 5.0
    just = review(case, entities=[entity("bed"), entity("wardrobe")], only=True)
    extra = only(just, "not_only", "alignment")[0]
    assert "dresser-0" in extra.inputs["ids"] and "bed-0" not in extra.inputs["ids"]
    assert not only(just, "missing_usual", "completion") and not only(just, "empty_support", "completion")


def outcome_of(found: Review) -> str:
    assert found.alignment is not None
    return next(o.status for o in found.alignment.items if o.item.startswith("exclusion"))


@pytest.mark.parametrize(
    ("relation", "place", "status"), [("against", "wall", "unmet"), ("at", "middle", "met"), ("at", "corner", "met")]
)
def test_what_must_not_be_in_one_place_is_measured_there(relation: str, place: str, status: str) -> None:
    barred = {"words": "not there", "categories": ["bed"], "relation": relation, "targets": [place]}
    wanted = review(rooms.bedroom(), entities=[entity("bed")], exclusions=[{**barred, "subject": "bed"}])
    assert outcome_of(wanted) == status
    assert outcome_of(review(rooms.bedroom(), exclusions=[barred])) == status


def test_what_may_not_stand_somewhere_is_moved_and_what_is_banned_there_goes() -> None:
    barred = {"words": "not at the wall", "categories": ["bed"], "relation": "against", "targets": ["wall"]}
    wanted = review(rooms.bedroom(), entities=[entity("bed")], exclusions=[{**barred, "subject": "bed"}])
    assert not only(wanted, "unwanted", "alignment")
    assert only(wanted, "asked_relation", "alignment")
    (fault,) = only(review(rooms.bedroom(), exclusions=[barred]), "unwanted", "alignment")
    assert (fault.tool, fault.inputs["ids"]) == ("remove_objects", ["bed-0"])


@pytest.mark.parametrize(
    ("data", "kind"),
    [
        ({"area": 14.4}, None),
        ({"area": 25.0}, "wrong_area"),
        ({"size": (5.0, 5.0)}, "wrong_area"),
        ({"scale": 1.4, "area": None}, None),
        ({"shape": "rectangle"}, None),
        ({"shape": "L"}, "wrong_shape"),
        ({"height": 2.6}, None),
        ({"height": 3.2}, "wrong_height"),
        ({"windows": 1}, None),
        ({"doors": 1}, None),
        ({"windows": 3}, "wrong_windows"),
        ({"room_type": "kitchen"}, "wrong_room"),
        ({"colors": ("magenta",)}, "wrong_colors"),
    ],
)
def test_the_room(data: dict[str, Any], kind: str | None) -> None:
    found = review(rooms.bedroom(), **data)
    mine = [f.kind for f in found.faults if f.criterion == "alignment"]
    assert mine == ([kind] if kind else [])


@pytest.mark.parametrize("name", ["rectangle", "L", "T", "U", "round"])
def test_shapes(name: str) -> None:
    import math

    outlines = {
        "rectangle": [(0, 0), (6, 0), (6, 5), (0, 5)],
        "L": [(0, 0), (6, 0), (6, 3), (3, 3), (3, 6), (0, 6)],
        "T": [(2, 0), (4, 0), (4, 3), (6, 3), (6, 5), (0, 5), (0, 3), (2, 3)],
        "U": [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)],
        "round": [(3 + 3 * math.cos(k * math.pi / 8), 3 + 3 * math.sin(k * math.pi / 8)) for k in range(16)],
    }
    case = rooms.bedroom()
    room = case.scene.room.model_validate({"outline": outlines[name], "type": "bedroom", "height": 2.6})
    scene = case.scene.model_copy(update={"room": room})
    for shape in outlines:
        found = review(Case(scene, case.room_type), shape=shape)
        assert bool(only(found, "wrong_shape", "alignment")) is (shape != name), shape


def test_style() -> None:
    case = rooms.living()
    parts = [o.id for o in case.scene.objects if o.mount == "floor"]
    same = case.but(*({"id": object_id, "update": {"attributes": {"style": "modern"}}} for object_id in parts))
    assert not only(review(same, style="modern"), "wrong_style", "alignment")
    assert only(review(same, style="rustic"), "wrong_style", "alignment")


# ---- tool calls ------------------------------------------------------------------------------------------------------

BROKEN = [
    rooms.living().but(
        {"id": "sofa-0", "yaw": 30}, {"id": "bookcase-0", "y": 3.2}, {"id": "coffee_table-0", "gone": 1}
    ),
    rooms.office().but(
        {"id": "office_chair-1", "yaw": -90}, {"id": "monitor-0", "yaw": 80}, {"id": "desk-0", "x": 1.3}
    ),
    rooms.bedroom().but({"id": "bed-0", "x": 1.8}, {"id": "wardrobe-0", "yaw": 0}, {"id": "nightstand-0", "gone": 1}),
    rooms.restaurant().but(*({"id": f"dining_chair-{k}", "yaw": 40 + k} for k in range(9))),
    rooms.bedroom().plus(put("toilet-0", 3.0, 0.9, 20)),
]


def acts(case: Case, fault: Fault) -> None:
    """The inputs of a call are those of its tool and name what is there."""
    ids, calls = set(case.scene.ids), fault.inputs
    openings = {o.id for o in (*case.scene.room.doors, *case.scene.room.windows)}
    match fault.tool:
        case None:
            assert not calls
        case "add_objects":
            assert set(calls) == {"objects"} and calls["objects"]
            for row in calls["objects"]:
                assert row["category"] in categories() and row["count"] >= 1
                for place in row.get("place", ()):
                    assert place["type"] in CATALOGUE and place.get("to", "wall") in {*ids, *openings, "wall", "window"}
        case "add_tabletop" | "add_crowd":
            assert set(calls) <= {"supports", "arrangement", "theme"} and calls["supports"]
            assert set(calls["supports"]) <= ids
        case "add_wall_objects":
            assert set(calls) == {"walls"}
            assert all(0 <= wall < len(case.scene.room.walls) for wall in calls["walls"])
        case "remove_objects" | "update_layout":
            assert set(calls) == {"ids"} and set(calls["ids"]) <= ids
        case "update_rotation":
            assert set(calls["ids"]) <= ids and len({"toward", "yaw", "square"} & set(calls)) == 1
            assert calls.get("toward", next(iter(ids))) in ids
        case "update_size":
            assert set(calls["sizes"]) <= ids and all(len(s) == 3 and min(s) > 0 for s in calls["sizes"].values())
        case "add_relation":
            for row in calls["relations"]:
                assert row["type"] in CATALOGUE and row["subject"] in ids
                assert row["target"] is None or row["target"] in {*ids, *openings}
        case other:
            raise AssertionError(other)


@pytest.mark.parametrize("case", BROKEN)
def test_calls_can_be_acted_on(case: Case) -> None:
    found = case.review()
    assert found.faults and min(found.grades.values()) < 8.0
    for fault in found.faults:
        assert fault.reason and any(ch.isdigit() for ch in fault.reason) or fault.kind in ("foreign_object",)
        assert fault.points >= 0 and fault.criterion in found.grades
        acts(case, fault)


@pytest.mark.parametrize("case", BROKEN)
def test_doing_what_a_fault_says_helps(case: Case) -> None:
    """Turning, resizing and removing can be done at once; each such call must not lower the total."""
    import math

    before = case.review()
    for fault in before.faults:
        change: list[dict[str, Any]] = []
        if fault.tool == "update_rotation":
            for object_id in fault.inputs["ids"]:
                o = case.scene.object(object_id)
                yaw = fault.inputs.get("yaw")
                if fault.inputs.get("square"):
                    turns = [math.remainder(wall.yaw - o.pose.yaw, math.pi / 2) for wall in case.scene.room.walls]
                    yaw = o.pose.yaw + min(turns, key=abs)
                elif yaw is None:
                    to = case.scene.object(fault.inputs["toward"])
                    dx, dy = (b - a for a, b in zip(o.pose.position[:2], to.pose.position[:2], strict=True))
                    yaw = math.atan2(dy, dx)
                change.append({"id": object_id, "yaw": math.degrees(yaw)})
        elif fault.tool == "remove_objects":
            change = [{"id": object_id, "gone": True} for object_id in fault.inputs["ids"]]
        if change and fault.kind in ("crooked", "askew", "foreign_object", "wrong_orientation"):
            after = case.but(*change).review()
            same = [f for f in after.faults if f.kind == fault.kind and set(f.objects) == set(fault.objects)]
            assert not same, (fault, same)


def test_a_review_is_plain_data() -> None:
    found = BROKEN[0].review()
    assert Review.model_validate_json(found.model_dump_json()) == found
    assert all(isinstance(v, float) for v in found.measures.values())
    assert found == BROKEN[0].review()


def test_a_limit_on_a_kind_is_on_all_that_is_of_it() -> None:
    """A limit on things that nobody named: of two bookcases the higher one is beyond it."""
    limit = {"id": "measure-0", "quantity": "upper", "high": 1.2, "categories": ["bookcase", "low_bookcase"]}
    fault = only(review(rooms.office(), measures=[limit]), "wrong_asked_length", "alignment")[0]
    assert fault.objects == ("bookcase-0",)
    assert not beyond(review(rooms.office(), measures=[{**limit, "high": 1.8}]))
    none = review(rooms.office(), measures=[{**limit, "categories": ["wardrobe"]}])
    assert not beyond(none)


def test_room_for_knees_is_measured_below_the_top() -> None:
    knees = {"id": "measure-0", "entity": "desk", "quantity": "knee", "low": 0.6}
    data = {"entities": [entity("desk", count=(2, 2))]}
    assert not beyond(review(rooms.office(), measures=[knees], **data))
    assert beyond(review(rooms.office(), measures=[{**knees, "low": 0.8}], **data))
