"""Free areas of a scene: they come back from its file, older files have none, edits keep them in order."""

from __future__ import annotations

import json

import pytest

from sceneweaver.scene import FreeArea, InputError, Pose, Relation, Scene

AREAS = (
    FreeArea(id="turning", kind="circle", size=(1.5, 1.5), pose=Pose.from_yaw(1.0, 2.0, 0.0, 0.3), request="free-0"),
    FreeArea(id="beside", kind="clearance", size=(0.8, 0.8), targets=("bed",), side="long"),
    FreeArea(id="aisle", kind="path", size=(0.9, 0.9), most=1.2, targets=("door",), others=("bed", "wardrobe")),
)


def bedroom() -> Scene:
    return Scene.example("bedroom").model_copy(update={"free_areas": AREAS})


def test_free_areas_come_back_from_the_file():
    made = bedroom()
    again = Scene.loads(made.dumps())
    assert again == made
    assert again.dumps() == made.dumps()


def test_a_scene_without_them_is_written_as_it_always_was():
    made = Scene.example("bedroom")
    assert made.free_areas == ()
    assert "free_areas" not in json.loads(made.dumps())


def test_ids_are_unique():
    data = json.loads(bedroom().dumps())
    data["free_areas"][1]["id"] = "turning"
    with pytest.raises(InputError, match=r"free_areas\[1\]\.id is taken by free_areas\[0\]"):
        Scene.from_json(data)


@pytest.mark.parametrize(("field", "value"), [("size", [0.0, 1.0]), ("kind", "blob"), ("side", "north")])
def test_wrong_fields_are_named(field, value):
    data = json.loads(bedroom().dumps())
    data["free_areas"][0][field] = value
    with pytest.raises(InputError, match=rf"free_areas\[0\]\.{field}|{field}"):
        Scene.from_json(data)


def test_things_may_come_and_go():
    made = bedroom().rename("bed", "cot")
    assert made.free_areas[1].targets == ("cot",)
    assert made.free_areas[2].others == ("cot", "wardrobe")
    assert made.remove("wardrobe").free_areas == made.free_areas


def test_sides_by_the_longer_ones():
    long, around = AREAS[1], AREAS[1].model_copy(update={"side": "around"})
    assert long.sides_of(2.0, 1.6) == ("left", "right")
    assert long.sides_of(0.9, 2.0) == ("front", "back")
    assert len(around.sides_of(1.0, 1.0)) == 4


def test_pairs_of_a_gap_leave_out_what_stands_in_one_row():
    gap = FreeArea(id="g", kind="gap", size=(1.0, 1.0), targets=("a", "b", "c", "gone"))
    row = [Relation(type="next_to", subject="b", target="a", params={"gap": (0.0, 0.05)})]
    assert gap.pairs("abc", []) == [("a", "b"), ("a", "c"), ("b", "c")]
    assert gap.pairs("abc", row) == [("a", "c"), ("b", "c")]
    assert gap.model_copy(update={"others": ("c",)}).pairs("abc", row) == [("a", "c"), ("b", "c")]
