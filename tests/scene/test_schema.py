"""The published JSON Schema is the one that the models give, and agrees with them."""

from __future__ import annotations

import json

import jsonschema
import pytest

from sceneweaver.scene import EXAMPLES, InputError, Scene
from sceneweaver.scene import schema as scene_schema


@pytest.fixture(scope="module")
def validator():
    published = json.loads(scene_schema.FILE.read_text("utf-8"))
    jsonschema.Draft202012Validator.check_schema(published)
    return jsonschema.Draft202012Validator(published)


def test_file_is_up_to_date():
    assert scene_schema.FILE.read_text("utf-8") == scene_schema.text(), "run python -m sceneweaver.scene.schema"


def test_zoo_is_valid(validator, zoo_file):
    data = json.loads(zoo_file.read_text("utf-8"))
    validator.validate(data)
    Scene.from_json(data)


def test_what_we_write_is_valid(validator, small):
    validator.validate(small)
    validator.validate(Scene.from_json(small).to_json())
    for name in EXAMPLES:
        validator.validate(Scene.example(name).to_json())


BAD = [
    (("schema",), "sceneweaver.scene/2"),
    (("objects", 3, "positon"), [0, 0, 0]),
    (("objects", 3, "size", 1), -0.5),
    (("objects", 3, "size"), [1, 2]),
    (("objects", 3, "mount"), "flor"),
    (("objects", 3, "id"), ""),
    (("objects", 1, "parts", 0, "polygon"), [[0, 0], [1, 1]]),
    (("objects", 1, "intent", "priority"), "wanted"),
    (("objects", 1, "intent", "mounting_height"), [1]),
    (("objects", 1, "intent", "need"), "asked"),
    (("room", "outline"), []),
    (("room", "doors", 0, "wall"), -1),
    (("relations", 0, "type"), "agianst_wall"),
    (("relations", 0, "target"), "chair-0"),
    (("relations", 0, "target"), 5),
    (("relations", 2, "target"), None),
    (("relations", 2, "params"), {"mx": 1}),
    (("relations", 2, "params"), {"max": -1}),
    (("relations", 2, "params"), {"max": [0, 1]}),
    (("relations", 2, "type"), "distance"),
    (("relations", 3, "target"), "chair-0"),
    (("relations", 7, "target"), "chair-0"),
    (("relations", 0, "weight"), 0),
    (("provenance",), []),
]


@pytest.mark.parametrize(("path", "value"), BAD)
def test_schema_and_model_refuse_alike(validator, small, put, path, value):
    put(small, path, value)
    assert not validator.is_valid(small)
    with pytest.raises(InputError):
        Scene.from_json(small)


def test_every_field_and_relation_is_described():
    data = scene_schema.json_schema()
    assert [branch["properties"]["type"]["const"] for branch in data["$defs"]["Relation"]["oneOf"]] == data["$defs"][
        "Relation"
    ]["properties"]["type"]["enum"]
    for name, model in data["$defs"].items():
        assert model["description"], name
    for model in ("Door", "Window", "Pose", "Part", "SceneObject", "Relation"):
        for key, field in data["$defs"][model]["properties"].items():
            assert "description" in field or "$ref" in field, (model, key)


def test_command_writes_the_file(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(scene_schema, "FILE", tmp_path / "scene.schema.json")
    assert scene_schema.main() == 0
    assert (tmp_path / "scene.schema.json").read_text("utf-8") == scene_schema.text()
    assert "scene.schema.json" in capsys.readouterr().out
