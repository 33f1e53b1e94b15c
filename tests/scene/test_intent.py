"""What an object is there for: its order, its limits, and old files that say it in attributes."""

from __future__ import annotations

import copy
import json

import jsonschema
import pytest

from sceneweaver.knowledge.library import own_folder
from sceneweaver.scene import PRIORITIES, InputError, Intent, Scene, SceneObject
from sceneweaver.scene import schema as scene_schema
from sceneweaver.scene.migrate import migrate

OLD = {"color": "oak", "need": "asked", "asked": "desk-1", "item": "desk", "hang": [0.5, 1.2], "clear": True}


def test_priorities_have_an_order_and_none_counts_as_usual():
    ranks = [Intent(priority=priority).rank for priority in PRIORITIES]
    assert ranks == sorted(set(ranks)) and PRIORITIES[0] == "optional" and PRIORITIES[-1] == "asked"
    assert Intent().rank == Intent(priority="usual").rank


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"priority": "need"}, 'intent: priority is "need"; did you mean "needed"?'),
        ({"request": ""}, 'request is ""; give at least 1 character'),
        ({"mounting_height": [1.5, 1.2]}, "is [1.5, 1.2]; the first must not be greater than the second"),
        ({"mounting_height": [1.5]}, "mounting_height has 1 entry; give 2"),
        ({"mounting_height": [0.0, float("inf")]}, "mounting_height[1] is Infinity; numbers must be finite"),
        ({"keep_clear": 1}, "keep_clear is 1; give true or false"),
        ({"hang": [1, 2]}, 'intent: unknown key "hang"'),
    ],
)
def test_what_makes_no_sense_is_refused(given, message):
    with pytest.raises(InputError) as caught:
        Intent.model_validate(given)
    assert message in str(caught.value)


def test_an_empty_intent_is_not_written_and_a_full_one_comes_back():
    bare = SceneObject(id="a", category="desk", size=(1, 1, 1))
    full = Intent(priority="usual", request="r", program_item="i", mounting_height=(1.0, 1.0), keep_clear=True)
    objects = (bare, bare.model_copy(update={"id": "b", "intent": full}))
    scene = Scene.example().model_copy(update={"objects": objects, "relations": ()})
    first, second = scene.to_json()["objects"]
    assert "intent" not in first and second["intent"].keys() == Intent.model_fields.keys()
    assert Scene.loads(scene.dumps()).objects == scene.objects


def test_attributes_of_old_files_become_the_intent(small):
    small["objects"][3]["attributes"] = OLD
    before = copy.deepcopy(small)
    chair = Scene.from_json(small).object("chair-0")
    assert small == before
    assert chair.attributes == {"color": "oak"}
    assert chair.intent == Intent(
        priority="asked", request="desk-1", program_item="desk", mounting_height=(0.5, 1.2), keep_clear=True
    )
    again = Scene.from_json(small).to_json()
    assert migrate(again) is again and Scene.from_json(again).object("chair-0") == chair
    published = json.loads(scene_schema.FILE.read_text("utf-8"))
    jsonschema.Draft202012Validator(published).validate(before)  # a file of others stays one of this version
    jsonschema.Draft202012Validator(published).validate(again)


def test_foreign_attributes_of_these_names_stay(small):
    foreign = {"need": "high", "asked": 3, "item": "", "hang": "left", "clear": "glass"}
    small["objects"][3]["attributes"] = foreign
    small["objects"][4] |= {"intent": {"priority": "needed"}, "attributes": {"need": "asked"}}
    _, _, _, chair, other = Scene.from_json(small).objects
    assert chair.attributes == foreign and chair.intent == Intent()
    assert other.attributes == {"need": "asked"} and other.intent == Intent(priority="needed")


def test_old_files_in_an_older_version(small):
    small["schema"] = "sceneweaver.scene/0"
    small["objects"][3]["attributes"] = {"need": "usual", "n": 1}
    chair = Scene.from_json(small).object("chair-0")
    assert chair.intent.priority == "usual" and chair.attributes == {"n": 1}


def test_relations_of_old_files_know_whether_they_were_asked_for(small):
    del small["relations"][0]["asked"]
    small["provenance"]["asked"] = [["near", "chair-1"], ["in_corner", "nothing"]]
    before = copy.deepcopy(small)
    scene = Scene.from_json(small)
    assert small == before and scene.provenance == {"seed": 7}
    assert {(r.type, r.subject) for r in scene.relations if r.asked} == {("near", "chair-1")}
    written = scene.to_json()["relations"]
    assert [r.get("asked") for r in written] == [r.asked or None for r in scene.relations]
    assert Scene.loads(scene.dumps()) == scene


@pytest.mark.parametrize("asked", ["yes", {"near": 1}, [["near", "chair-1"], "more"]])
def test_a_foreign_note_of_what_was_asked_stays(small, asked):
    small["provenance"]["asked"] = asked
    assert Scene.from_json(small).provenance["asked"] == asked


@pytest.mark.parametrize("objects", [5, [5], [{"attributes": 5}], [{"attributes": {"need": "asked"}}], {}])
def test_what_is_no_scene_is_still_refused_by_the_model(small, objects):
    small["objects"] = objects
    with pytest.raises(InputError, match=r"^objects"):
        Scene.from_json(small)


def test_no_scene_of_the_library_says_it_in_attributes():
    files = [path for path in own_folder().glob("*.json") if path.stem != "index"]
    objects = [obj for path in files for obj in json.loads(path.read_text("utf-8"))["objects"]]
    assert len(objects) > 100 and any("intent" in obj for obj in objects)
    assert not [obj["id"] for obj in objects if {"need", "asked", "item", "hang", "clear"} & {*obj["attributes"]}]
