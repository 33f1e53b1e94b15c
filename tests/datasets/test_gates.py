"""Gates: what a scene has to be, when it is made and when it is verified."""

from __future__ import annotations

import pytest

from sceneweaver.datasets import Spec
from sceneweaver.datasets.checking.tables import gates_failed
from sceneweaver.datasets.gates import Gates, gate_names, passed
from tests.datasets.small import small_spec


@pytest.mark.parametrize("name", ["openable", "walkable"])
def test_a_share_below_its_gate_is_not_delivered_and_found_when_it_is(name):
    gates = Gates.model_validate({name: 0.6})
    spec: Spec = small_spec(1).model_copy(update={"gates": gates})
    for share, through in ((0.59, False), (0.6, True), (None, True)):
        measured = {"valid": True, f"{name}_share": share}
        assert passed(gates, measured.get) == {"valid": True, name: through}
        assert bool([*gates_failed(measured, spec)]) is not through


def test_a_gate_of_valid_scenes_is_not_measured_in_others():
    gates = Gates.model_validate({"still": 0.1, "unmet": 1})
    assert passed(gates, {"valid": False, "unmet": ["a lamp", "a rug"]}.__getitem__) == {"valid": False, "unmet": False}
    assert passed(gates, {"valid": True, "unmet": ["a lamp"], "shift": 0.2}.get) == {
        "valid": True,
        "unmet": True,
        "still": False,
    }


def test_the_index_has_a_column_for_each_gate():
    assert set(gate_names()) == {"valid", *Gates.model_fields}
