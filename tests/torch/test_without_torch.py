"""`sceneweaver.torch` where there is no PyTorch."""

from __future__ import annotations

import sys

import pytest

import sceneweaver as sw
import sceneweaver.torch as swt
from tests.layout.research import problem_of


@pytest.mark.parametrize("call", [swt.energy, swt.residuals, swt.feasible, swt.free], ids=lambda f: f.__name__)
def test_it_says_what_is_missing(monkeypatch, call):
    problem = problem_of("bedroom-small")
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(sw.MissingDependencyError, match="PyTorch is not installed; pip install torch"):
        call(problem, *([] if call is swt.free else [problem.home]))
