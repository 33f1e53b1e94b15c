"""Requests with SceneEval's annotations, and what a scene meets of them."""

from __future__ import annotations

import pytest

from sceneweaver.evaluation import Requests
from sceneweaver.evaluation.lines import fits, judged
from sceneweaver.io import InputError
from sceneweaver.scene import Scene
from sceneweaver.verify import check

HEAD = "ID,Description,ObjCount,ObjAttr,OORel,OARel\n"


def of(**columns: str):
    row = {"ID": "12", "Description": "A room.", "ObjCount": "", **columns}
    return Requests.of([row]).by_id["12"]


def verdicts(scene: Scene, **columns: str) -> list[bool | None]:
    return [met.holds for met in judged(scene, check(scene, walkable=False), of(**columns))]


@pytest.fixture(scope="module")
def bedroom() -> Scene:
    return Scene.example("bedroom")


def test_a_file_is_read(tmp_path):
    path = tmp_path / "requests.csv"
    path.write_text(HEAD + '007,"A red bed.","eq,1,bed; ge,2,chair","eq,1,bed,red",,"eq,1,against,bed,wall"\n')
    found = Requests.load(path)
    asked = found.find(prompt="", name="se_007/scene")
    assert asked is not None and asked is found.find(prompt="a  RED bed.", name="x") and asked.id == "7"
    assert [line.metric for line in asked.lines] == ["CNT", "CNT", "ATR", "OAR"]
    assert asked.categories == ("bed", "chair")
    assert found.find(prompt="", name="scene_8") is None and found.find(prompt="", name="x") is None


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "no rows"),
        ("ID,ObjCount\n1,\n", "Description"),
        (HEAD + '1,x,"some,1,bed",,,\n', "begin with"),
        (HEAD + '1,x,"eq,one,bed",,,\n', "number"),
        (HEAD + '1,x,"eq,1",,,\n', "at least 3"),
        (HEAD + '1,x,"eq,1,bed","eq,1,bed",,\n', "ObjAttr"),
    ],
)
def test_a_wrong_file_is_one_line(tmp_path, text, says):
    path = tmp_path / "requests.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=says) as error:
        Requests.load(path)
    assert "\n" not in str(error.value)


def test_quantifiers():
    line = of(ObjCount="le,2,bed").lines[0]
    assert [line.enough(n) for n in (0, 2, 3)] == [True, True, False]
    assert [of(ObjCount="gt,2,bed").lines[0].enough(n) for n in (2, 3)] == [False, True]


def test_words_and_categories():
    assert fits("nightstand", "bedside_table") and fits("armchair", "chair")
    assert not fits("chair", "table") and not fits("bed", "nightstand")


def test_counts(bedroom):
    assert verdicts(bedroom, ObjCount="eq,2,nightstand; eq,1,nightstand; eq,1,bed; eq,1,piano") == [
        True,
        False,
        True,
        False,
    ]


def test_relations_between_objects(bedroom):
    held = verdicts(
        bedroom,
        ObjCount="eq,1,bed; eq,2,nightstand; eq,1,wardrobe",
        OORel="eq,2,next_to,0,bed,nightstand; eq,1,on,0,bed,wardrobe; eq,1,frobnicated,0,bed,wardrobe; "
        "eq,1,near,0,bed,piano",
    )
    assert held[3:] == [True, False, None, False]


def test_a_relation_fails_when_the_thing_is_moved(bedroom):
    wardrobe = bedroom.object("wardrobe").pose
    names = [o.id for o in bedroom.objects if o.category == "nightstand"]
    moved = bedroom.replace_poses({names[0]: wardrobe})
    said = {"ObjCount": "eq,1,bed; eq,2,nightstand", "OORel": "eq,2,next_to,0,bed,nightstand"}
    assert verdicts(bedroom, **said)[-1] is True and verdicts(moved, **said)[-1] is False


def test_relations_to_the_room(bedroom):
    held = verdicts(
        bedroom,
        ObjCount="eq,1,wardrobe; eq,1,bed",
        OARel="eq,1,against,wardrobe,wall; eq,1,hang,bed,ceiling; eq,1,on,bed,bedroom; eq,1,on,bed,kitchen",
    )
    assert held[2:] == [True, False, True, False]


def test_attributes(bedroom):
    colour = bedroom.object("bed").attributes.get("color")
    held = verdicts(bedroom, ObjCount="eq,1,bed", ObjAttr="eq,1,bed,purple; eq,1,piano,black; eq,1,bed,qwertyish")
    assert held[1:] == [False, False, None] or colour is None
