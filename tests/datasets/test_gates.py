"""Gates: what a scene has to be, when it is made and when it is verified."""

from __future__ import annotations

import pytest

from sceneweaver.datasets import Spec
from sceneweaver.datasets.checking.tables import gates_failed
from sceneweaver.datasets.gates import Gates, gate_names, gates, passed
from sceneweaver.datasets.tables import schema_of
from tests.datasets.small import small_spec


@pytest.mark.parametrize("name", ["openable", "walkable"])
def test_a_share_below_its_gate_is_not_delivered_and_found_when_it_is(name):
    asked = Gates.model_validate({name: 0.6})
    spec: Spec = small_spec(1).model_copy(update={"gates": asked})
    for share, through in ((0.59, False), (0.6, True), (None, True)):
        measured = {"valid": True, f"{name}_share": share}
        assert passed(asked, measured.get) == {"valid": True, name: through}
        assert bool([*gates_failed(measured, spec)]) is not through


def test_a_gate_of_valid_scenes_is_not_measured_in_others():
    asked = Gates.model_validate({"still": 0.1, "unmet": 1})
    assert passed(asked, {"valid": False, "unmet": ["a lamp", "a rug"]}.__getitem__) == {"valid": False, "unmet": False}
    assert passed(asked, {"valid": True, "unmet": ["a lamp"], "shift": 0.2}.get) == {
        "valid": True,
        "unmet": True,
        "still": False,
    }


def test_the_index_has_a_column_for_each_gate():
    assert set(gate_names()) == {"valid", *Gates.model_fields}


def test_each_gate_is_measured_in_the_index_or_in_physics():
    columns = {*schema_of("index").names, *(field.name for field in schema_of("index").field("grades").type)}
    assert {gate.measure for gate in gates()} - columns == {"shift"}
    assert [field.name for field in schema_of("index").field("gates").type] == [*gate_names()]
