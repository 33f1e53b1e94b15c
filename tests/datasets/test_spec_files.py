"""Specifications that ship with the library, and their schema."""

import re
from pathlib import Path

import jsonschema
import pytest
import yaml

from sceneweaver.datasets import Requests, load_spec
from sceneweaver.datasets.spec import EXAMPLES, Gates, Rooms, Spec, Views, spec_file, spec_schema
from sceneweaver.datasets.spec import Requests as SpecRequests
from sceneweaver.datasets.tables import schema_of
from sceneweaver.knowledge import room_types
from sceneweaver.scene import InputError
from tests.test_repository import ROOT, code_blocks


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_load_by_name_and_ask_for_rooms_that_are_known(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    spec = load_spec(spec_file(Path(name)))
    assert spec.name == name
    assert set(spec.requests.kinds or ()) <= set(room_types())
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


def test_the_guide_names_every_field_and_column():
    text = (ROOT / "docs" / "datasets.md").read_text()
    named = set(re.findall(r"`\.?(?:\w+\.)?(\w+)`", text))
    fields = {field.alias or name for name, field in Spec.model_fields.items()}
    for part in (SpecRequests, Rooms, Views, Gates):
        fields |= set(part.model_fields)
    assert fields - named == {"rooms"}  # which is named by its fields
    assert set(schema_of("index").names) - named == set()


def test_the_guide_says_the_defaults():
    text = (ROOT / "docs" / "datasets.md").read_text()
    rows = dict(re.findall(r"^\| `([\w.]+)` \| .* \| (\d[\d.]*) \|$", text, re.MULTILINE))
    defaults = {**{f"rooms.{k}": v for k, v in Rooms().model_dump().items()}, **Spec.model_fields}
    assert {"variants", "rooms.candidates", "time_limit", "block", "shard"} <= set(rows)
    for name, value in rows.items():
        default = defaults[name]
        assert float(value) == (default if isinstance(default, int) else default.default), name
