"""The code of docs/homes_navigation.md and the examples of what it names run."""

from __future__ import annotations

import doctest
import importlib
import pkgutil

import pytest

import sceneweaver.navigation
import sceneweaver.verify.home
from tests.test_repository import ROOT, code_blocks

MODULES = sorted(
    f"{package.__name__}.{found.name}"
    for package in (sceneweaver.navigation, sceneweaver.verify.home)
    for found in pkgutil.iter_modules(package.__path__)
)


def test_the_guide_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict = {"__name__": "__main__"}
    for source in code_blocks((ROOT / "docs" / "homes_navigation.md").read_text(), "python"):
        exec(compile(source, "docs/homes_navigation.md", "exec", dont_inherit=True), names)
    assert names["info"]["success"]


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_run(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    failed, _ = doctest.testmod(importlib.import_module(name))
    assert not failed
