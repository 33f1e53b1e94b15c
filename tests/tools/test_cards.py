"""Tool cards: they are complete, their schemas mean what they say, errors are one clear line."""

from __future__ import annotations

import contextlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sceneweaver.scene import InputError
from sceneweaver.tools.card import ToolCard, own_card, read_card
from sceneweaver.tools.registry import OWN
from sceneweaver.tools.schema import KEYWORDS, check_inputs, check_schema
from tests.sizes import examples

CARDS = sorted(f.stem for f in (Path(__file__).parents[2] / "toolcards").glob("*.yaml"))


def test_every_tool_has_a_card_and_every_card_a_tool():
    assert set(CARDS) == set(OWN)


@pytest.mark.parametrize("name", CARDS)
def test_card_is_complete(name):
    card = own_card(name)
    assert card.name == name
    assert card.strengths and card.weaknesses
    card.check(card.example.inputs)
    assert card.role == ("initializer" if name.startswith("init_") else card.role)


@pytest.mark.parametrize("name", CARDS)
def test_schema_is_json_schema(name):
    jsonschema = pytest.importorskip("jsonschema")
    card = own_card(name)
    jsonschema.Draft202012Validator.check_schema(card.inputs)
    jsonschema.validate(card.example.inputs, card.inputs)


WRONG = [
    ("add_objects", {}, "tool add_objects: inputs.objects is missing"),
    ("add_objects", {"objects": []}, "tool add_objects: inputs.objects has 0 entries; at least 1"),
    (
        "add_objects",
        {"objects": [{"category": "desk", "count": -1}]},
        "tool add_objects: inputs.objects[0].count is -1; at least 1",
    ),
    ("add_objects", {"objects": [{"category": "desk", "cuont": 2}]}, 'did you mean "count"?'),
    ("add_objects", {"objects": [{"category": 3}]}, "inputs.objects[0].category is 3; give a text"),
    ("add_objects", {"objects": [{"category": "desk", "count": True}]}, "count is true; give a whole number"),
    ("add_objects", {"objects": [{"category": "desk", "size": [1, 2]}]}, "size has 2 entries; at least 3"),
    ("add_objects", {"objects": [{"category": "desk", "mount": "roof"}]}, 'mount is "roof"'),
    ("update_size", {"sizes": {"desk-0": [1.0, 0.0, 1.0]}}, 'inputs.sizes["desk-0"][1] is 0.0; more than 0'),
    ("add_crowd", {"density": float("nan")}, "inputs.density is NaN; numbers must be finite"),
    ("add_crowd", {"density": 1.5}, "inputs.density is 1.5; at most 1"),
    ("remove_objects", [], "tool remove_objects: inputs is a list; give an object"),
]


@pytest.mark.parametrize(("name", "inputs", "line"), WRONG)
def test_wrong_inputs(name, inputs, line):
    with pytest.raises(InputError) as caught:
        own_card(name).check(inputs)
    assert line in str(caught.value)
    assert "\n" not in str(caught.value)


def test_wrong_cards():
    good = own_card("add_crowd").model_dump(mode="json")
    for change, line in (
        ({"confidence": 2.0}, "confidence"),
        ({"role": "boss"}, "role"),
        ({"name": "Add Crowd"}, "name"),
        ({"inputs": {"type": "objekt"}}, "inputs.type"),
        ({"inputs": {"type": "object", "oneOf": []}}, "oneOf"),
        ({"inputs": {"type": "object", "required": ["a"]}}, "required"),
        ({"inputs": {"type": "object", "properties": {"n": {"minimum": 3, "maximum": 1}}}}, "minimum"),
        ({"example": {"instruction": "x", "inputs": {"density": 7}}}, "example.inputs.density"),
        ({"colour": "red"}, "colour"),
    ):
        with pytest.raises(InputError, match=line.replace(".", r"\.")):
            ToolCard.model_validate({**good, **change})
    for text in ("[1, 2]", "name: [", ""):
        with pytest.raises(InputError):
            read_card(text)


def test_bare_on_is_refused():
    with pytest.raises(InputError, match="quotes"):
        check_schema({"type": "object", "properties": {True: {"type": "string"}}})


@pytest.mark.parametrize("keyword", KEYWORDS)
@pytest.mark.parametrize("value", [None, 7.5, -1, "a", ["a", 3], [["a"]], {"a": 1}, {3: {}}, True, float("nan")])
def test_any_value_of_a_keyword_is_read_or_refused(keyword, value):
    schema = {"minimum": 1.0, "minItems": 2, keyword: value}
    for data in ({"a": 1}, [1, "a"], 3, "a", None):
        with contextlib.suppress(InputError):
            check_schema(schema)
            check_inputs(schema, data)


values = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 5) | st.floats(-5, 5) | st.sampled_from(["", "a", "near"]),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(["a", "b", "c"]), inner, max_size=3),
    max_leaves=6,
)
kinds = st.sampled_from(["object", "array", "string", "number", "integer", "boolean", "null"])
schemas = st.recursive(
    st.fixed_dictionaries({"type": kinds | st.lists(kinds, min_size=1, max_size=2)}, optional={"minimum": st.just(0)}),
    lambda inner: (
        st.fixed_dictionaries(
            {"type": st.just("object"), "properties": st.dictionaries(st.sampled_from("abc"), inner, max_size=2)},
            optional={"additionalProperties": st.booleans()},
        )
        | st.fixed_dictionaries({"type": st.just("array"), "items": inner}, optional={"minItems": st.just(1)})
    ),
    max_leaves=4,
)


@examples(50, 150)
@given(schemas, values)
def test_agrees_with_json_schema(schema, value):
    jsonschema = pytest.importorskip("jsonschema")
    check_schema(schema)
    fine = jsonschema.Draft202012Validator(schema).is_valid(value)
    try:
        check_inputs(schema, value)
    except InputError:
        assert not fine
    else:
        assert fine
