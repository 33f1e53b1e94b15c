"""Specifications that ship with the library, and their schema."""

from pathlib import Path

import jsonschema
import pytest
import yaml

from sceneweaver.datasets import Requests, load_spec
from sceneweaver.datasets.spec import EXAMPLES, spec_file, spec_schema
from sceneweaver.knowledge import room_types
from sceneweaver.scene import InputError
from tests.test_repository import ROOT, code_blocks


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_load_by_name_and_ask_for_rooms_that_are_known(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    spec = load_spec(spec_file(Path(name)))
    assert spec.name == name
    assert set(spec.requests.kinds) <= set(room_types())
    assert Requests(spec)[0].prompt


def test_a_file_of_that_name_comes_first(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("ten_kinds").write_text("schema: sceneweaver.dataset/1\nname: mine\ncount: 1\nrequests: {prompts: [a gym]}\n")
    assert load_spec(spec_file(Path("ten_kinds"))).name == "mine"


def test_a_wrong_name_is_mended():
    with pytest.raises(InputError, match='no such file, and no example; did you mean "ten_kinds"'):
        spec_file(Path("ten_kind"))


def test_the_schema_takes_what_the_reader_takes():
    schema = spec_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    texts = [path.read_text() for path in EXAMPLES.values()]
    texts += code_blocks((ROOT / "docs" / "datasets.md").read_text(), "yaml")
    for text in texts:
        jsonschema.validate(yaml.safe_load(text), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**yaml.safe_load(texts[0]), "colour": "red"}, schema)
