"""Gates: what a scene has to be, when it is made and when it is verified."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from sceneweaver.datasets import Spec
from sceneweaver.datasets.checking.tables import gates_failed
from sceneweaver.datasets.columns import GATES
from sceneweaver.datasets.produce.finish import _passed
from sceneweaver.datasets.spec import Gates
from tests.datasets.small import small_spec


def outcome(**measured):
    report = SimpleNamespace(valid=True, openable_share=None, walkable_share=None)
    return SimpleNamespace(report=SimpleNamespace(**{**vars(report), **measured}), review=SimpleNamespace(total=7.0))


@pytest.mark.parametrize("name", ["openable", "walkable"])
def test_a_share_below_its_gate_is_not_delivered_and_found_when_it_is(name):
    gates = Gates.model_validate({name: 0.6})
    spec: Spec = small_spec(1).model_copy(update={"gates": gates})
    for share, through in ((0.59, False), (0.6, True), (None, True)):
        measured = {f"{name}_share": share}
        assert _passed(outcome(**measured), (), gates) == {"valid": True, name: through}
        assert bool([*gates_failed(measured, spec)]) is not through


def test_the_index_has_a_column_for_each_gate():
    assert set(GATES) == {"valid", *Gates.model_fields}
