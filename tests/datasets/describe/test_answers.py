"""Answers and statements of whole rooms, against a second reading of their files."""

from __future__ import annotations

import json
from collections import Counter

import pytest

from sceneweaver.datasets.describe import describe
from sceneweaver.knowledge.library import load_scene
from sceneweaver.scene import EXAMPLES, Pose, Relation, Scene, Support
from sceneweaver.verify import check
from sceneweaver.verify.relations import judge_relation
from sceneweaver.verify.solids import Placed
from tests.datasets.describe.evaluator import Room, answer, holds

ROOMS = ("bathroom-1", "bedroom-1", "kitchen-1", "living_room-1", "waiting_room-1")


@pytest.fixture(scope="module")
def described() -> list[tuple[Scene, dict[str, bytes]]]:
    scenes = [*(Scene.example(name) for name in EXAMPLES), *map(load_scene, ROOMS)]
    return [(scene, describe(scene, seed)) for seed, scene in enumerate(scenes)]


def test_every_answer_is_right_in_a_second_reading(described):
    asked, wrong = Counter(), []
    for scene, files in described:
        room = Room(json.loads(scene.dumps()))
        for line in files["questions.jsonl"].splitlines():
            row = json.loads(line)
            asked[row["template"]] += 1
            if not answer(room, row):
                wrong.append((scene.id, row))
    assert not wrong
    assert sum(asked.values()) > 120 and len(asked) >= 18, asked


def test_the_second_reading_tells_wrong_answers(described):
    """Turned round, hardly a yes or no, a side or a number is still right."""
    fooled = []
    for scene, files in described[:3]:
        room = Room(json.loads(scene.dumps()))
        for line in files["questions.jsonl"].splitlines():
            row = json.loads(line)
            turned = {"yes": "no", "no": "yes", "left": "right", "right": "left"}
            if row["form"] in ("count", "number"):
                row["answer"] = row["answer"] * 1.5 + 1
            elif row["answer"] in turned if isinstance(row["answer"], str) else False:
                row["answer"] = turned[row["answer"]]
            else:
                continue
            if answer(room, row):
                fooled.append(row)
    assert not fooled


def test_every_statement_of_a_caption_is_true(described):
    stated, false = Counter(), []
    for scene, files in described:
        room = Room(json.loads(scene.dumps()))
        data = json.loads(files["captions.json"])
        for text in (data["short"], data["paragraph"], *data["by_place"]):
            for statement in text["statements"]:
                stated[statement["predicate"]] += 1
                if not holds(room, statement):
                    false.append((scene.id, text["text"], statement))
    assert not false
    assert len(stated) >= 15, stated


def test_instructions_reach_their_goals_and_leave_valid_rooms(described):
    steps = 0
    for scene, files in described:
        for line in files["instructions.jsonl"].splitlines():
            row = json.loads(line)
            goals = [Relation(**goal) for step in row["steps"] for goal in step["goal"]]
            wanted = scene.model_copy(update={"relations": (*scene.relations, *goals)})
            already = Placed.of(wanted)
            for step in row["steps"]:
                held = [judge_relation(already, Relation(**goal)).holds for goal in step["goal"]]
                assert not all(held), (row["instruction"], "is so already")
            report = check(_after(wanted, row), walkable=False)
            assert report.valid, (scene.id, row["instruction"], [v.detail for v in report.violations if v.hard])
            steps += len(row["steps"])
    assert steps > 15


def _after(scene: Scene, row: dict) -> Scene:
    """The scene with the witnesses of an instruction and without what they give up."""
    given_up = {given["index"] for step in row["steps"] for given in step["given_up"]}
    objects = {o.id: o for o in scene.objects}
    for step in row["steps"]:
        witness = step["witness"]
        for name, pose in witness["poses"].items():
            objects[name] = objects[name].model_copy(update={"pose": Pose(**pose)})
        if witness["support"] is not None:
            update = {"support": Support(**witness["support"])}
            objects[step["object"]] = objects[step["object"]].model_copy(update=update)
    relations = tuple(r for k, r in enumerate(scene.relations) if k not in given_up)
    return scene.model_copy(update={"objects": tuple(objects.values()), "relations": relations})
