"""What each of several things has for its own stands at it: seats at desks, wheels, mirrors, boards."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import pytest

from sceneweaver.assets import Library
from sceneweaver.assets.taxonomy import category_named
from sceneweaver.generate.lamps import lamps_beside
from sceneweaver.generate.room import first_draft
from sceneweaver.generate.setup import Setup
from sceneweaver.knowledge import room_type
from sceneweaver.language import Entity, SceneGraph, StatedRelation
from sceneweaver.language.model import Arrangement, FreeArea, View
from sceneweaver.scene import Relation, Room, Scene

EMPTY = Scene(id="empty", room=Room(outline=((0, 0), (4, 0), (4, 3), (0, 3))))


def told(**counts: int) -> tuple[Entity, ...]:
    """Things by their categories, with how many there are."""
    return tuple(
        Entity(id=name, noun=name.replace("_", " "), category=name, count=(n, n)) for name, n in counts.items()
    )


def said(kind: Any, subject: str, target: str, number: int = 0, **more: Any) -> StatedRelation:
    return StatedRelation(id=f"relation-{number}", type=kind, subject=subject, targets=(target,), **more)


def graph(entities: Sequence[Entity], relations: Sequence[StatedRelation] = (), **more: Any) -> SceneGraph:
    return SceneGraph(text="", entities=tuple(entities), relations=tuple(relations), **more)


def draft(brief: SceneGraph, kind: str, library: Library) -> Scene:
    setup = Setup(brief=brief, room_type=room_type(kind), scene=EMPTY, library=library, seed=2)
    scene = first_draft(setup).scene
    assert scene is not None
    return scene


def hard(scene: Scene, kind: str, subject: str) -> list[Relation]:
    return [r for r in scene.relations if r.hard and r.type == kind and r.subject.rpartition("-")[0] == subject]


def test_who_works_at_a_desk_sits_at_its_front_and_visitors_at_its_back(library: Library) -> None:
    things = told(desk=1, office_chair=1, dining_chair=2)
    relations = (
        said("behind", "office_chair", "desk", 0),
        said("in_front_of", "dining_chair", "desk", 1),
        said("facing", "desk", "door", 2),
    )
    scene = draft(graph(things, relations), "study", library)
    (own,) = hard(scene, "seated_at", "office_chair")
    visitors = hard(scene, "seated_at", "dining_chair")
    assert own.params["side"] == "front"
    assert [(r.params["side"], r.params["k"], r.params["n"]) for r in visitors] == [("back", 0, 2), ("back", 1, 2)]
    assert hard(scene, "facing_door", "office_chair") and not hard(scene, "against_wall", "desk")


def test_visitors_before_the_chair_of_who_works_at_a_desk_are_across_it(library: Library) -> None:
    things = told(desk=1, office_chair=1, dining_chair=2)
    relations = (said("behind", "office_chair", "desk", 0), said("in_front_of", "dining_chair", "office_chair", 1))
    at = hard(draft(graph(things, relations), "study", library), "seated_at", "dining_chair")
    assert {(r.target, r.params["side"]) for r in at} == {("desk-0", "back")}


def test_one_chair_before_a_desk_is_its_owners(library: Library) -> None:
    scene = draft(graph(told(desk=1, office_chair=1), (said("in_front_of", "office_chair", "desk"),)), "study", library)
    assert [r.params["side"] for r in hard(scene, "seated_at", "office_chair")] == ["front"]


@pytest.mark.parametrize(("kind", "implied"), [("near", True), ("in_front_of", False)])
def test_each_wheel_has_a_stool_of_its_own_right_before_it_in_any_room(
    kind: str, implied: bool, library: Library
) -> None:
    relation = said(kind, "stool", "pottery_wheel", each=True, implied=implied)
    scene = draft(graph(told(pottery_wheel=3, stool=3), (relation,)), "living_room", library)
    at = hard(scene, "front_to_front", "stool")
    assert len({r.target for r in at}) == len({r.subject for r in at}) == 3
    assert all(r.params["gap"][1] <= 0.3 for r in at)
    square = [r for r in scene.relations if r.type == "aligned" and r.subject.startswith("pottery_wheel")]
    assert len(square) == 2 and not any(r.hard for r in square)


def test_before_each_chair_of_a_row_hang_a_mirror_and_below_it_a_shelf(library: Library) -> None:
    things = told(barber_chair=3, wall_mirror=3, wall_shelf=3)
    relations = (
        said("above", "wall_mirror", "barber_chair", 0, each=True, implied=True),
        said("in_front_of", "wall_shelf", "barber_chair", 1, each=True),
    )
    row = Arrangement(id="arrangement-0", entity="barber_chair", pattern="row", rows=1)
    free = FreeArea(id="free_area-0", kind="clearance", size=(0.9, 0.9), targets=("barber_chair",), side="around")
    scene = draft(graph(things, relations, arrangements=(row,), free_areas=(free,)), "barbershop", library)
    width = scene.object("barber_chair-0").size[1]
    steps = [abs(float(r.params["left"])) for r in hard(scene, "arranged", "barber_chair")]
    assert all(step >= width + 0.9 for step in steps)
    for name in ("wall_mirror", "wall_shelf"):
        at = hard(scene, "arranged", name)
        assert sorted(str(r.target) for r in at) == [f"barber_chair-{k}" for k in range(3)]
        assert all(float(r.params["ahead"]) > 0 and r.params["left"] == 0.0 for r in at)
    mirror, shelf = scene.object("wall_mirror-0"), scene.object("wall_shelf-0")
    assert shelf.pose.position[2] + shelf.size[2] < mirror.pose.position[2]
    planes = {
        round(float(r.params["ahead"]) + scene.object(r.subject).size[0] / 2, 3)
        for name in ("wall_mirror", "wall_shelf")
        for r in hard(scene, "arranged", name)
    }
    assert len(planes) == 1  # on one wall
    assert not [o.id for o in scene.objects if o.category == "barber_station"]


def test_what_stands_beside_each_of_a_row_has_a_side_of_its_own_and_room_there(library: Library) -> None:
    things = told(donor_chair=3, iv_stand=3, stool=3)
    relations = (
        said("near", "iv_stand", "donor_chair", 0, each=True, implied=True),
        said("next_to", "stool", "donor_chair", 1, each=True),
    )
    row = Arrangement(id="arrangement-0", entity="donor_chair", pattern="row", rows=1)
    scene = draft(graph(things, relations, arrangements=(row,)), "dialysis_room", library)
    left = {float(r.params["left"]) for r in hard(scene, "arranged", "iv_stand")}
    right = {float(r.params["left"]) for r in hard(scene, "arranged", "stool")}
    assert len(left) == len(right) == 1 and min(left) > 0 > max(right)
    step = min(abs(float(r.params["left"])) for r in hard(scene, "arranged", "donor_chair"))
    wide = max(left) - min(right) + (scene.object("iv_stand-0").size[1] + scene.object("stool-0").size[1]) / 2
    assert step >= wide


@pytest.mark.parametrize("by", ["rows", "tables", "seats", "everybody"])
def test_all_at_tables_in_rows_sit_on_the_side_away_from_the_board(by: str, library: Library) -> None:
    relations = [said("at", "chair", "dining_table", 0, each=True)]
    relations += [said("facing", "dining_table", "whiteboard", 1)] if by == "tables" else []
    relations += [said("facing", "chair", "whiteboard", 1)] if by == "seats" else []
    views = (View(id="view-0", target="whiteboard", kind="face"),) if by == "everybody" else ()
    facing = "whiteboard" if by == "rows" else ""
    rows = Arrangement(id="arrangement-0", entity="dining_table", pattern="rows", aisle=1.2, facing=facing)
    things = told(dining_table=4, chair=8, whiteboard=1)
    scene = draft(graph(things, relations, arrangements=(rows,), views=views), "seminar_room", library)
    at = hard(scene, "seated_at", "chair")
    assert len(at) == 8 and {(r.params["side"], r.params["n"]) for r in at} == {("back", 2)}
    assert [r for r in scene.relations if r.hard and r.type == "facing" and r.subject == "dining_table-0"]


def test_school_desks_in_rows_have_the_board_at_their_backs(library: Library) -> None:
    rows = Arrangement(id="arrangement-0", entity="school_desk", pattern="rows", rows=2, facing="whiteboard")
    relations = (said("at", "school_chair", "school_desk", each=True, implied=True),)
    things = told(school_desk=6, school_chair=6, whiteboard=1)
    scene = draft(graph(things, relations, arrangements=(rows,)), "classroom", library)
    assert {r.params["side"] for r in hard(scene, "seated_at", "school_chair")} == {"front"}
    (across,) = hard(scene, "across_from", "whiteboard")
    assert (across.target, across.params["side"]) == ("school_desk-0", "back")


def test_a_lamp_on_a_bed_is_on_the_nightstand_that_goes_with_it() -> None:
    relations = (
        said("next_to", "nightstand", "single_bed", 0, each=True),
        said("on", "table_lamp", "single_bed", 1, each=True),
    )
    things = told(single_bed=2, nightstand=2, table_lamp=2)
    assert lamps_beside(graph(things, relations)).relations[1].targets == ("nightstand",)
    alone = lamps_beside(graph(told(bed=1, table_lamp=1), (said("on", "table_lamp", "bed"),))).relations[0]
    assert (alone.type, alone.targets) == ("near", ("bed",))
    book = graph(told(bed=1, book=1), (said("on", "book", "bed"),))
    assert lamps_beside(book) == book
    assert category_named("table_lamp").mount[0] == "surface"


def test_beds_at_two_walls_have_each_a_nightstand_of_its_own_by_the_pillow(library: Library) -> None:
    walls = Arrangement(id="arrangement-0", entity="single_bed", pattern="walls", around="wall")
    relations = (said("next_to", "nightstand", "single_bed", each=True, implied=True),)
    scene = draft(graph(told(single_bed=2, nightstand=2), relations, arrangements=(walls,)), "hostel_dorm", library)
    at = hard(scene, "arranged", "nightstand")
    assert sorted(str(r.target) for r in at) == ["single_bed-0", "single_bed-1"]
    assert all(float(r.params["ahead"]) < -0.5 for r in at)
