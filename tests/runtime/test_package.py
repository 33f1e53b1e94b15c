"""The distribution's name, and what is said where an extra or a package is missing."""

import ast
import re
import tomllib
from importlib.metadata import PackageNotFoundError
from pathlib import Path

import pytest

import sceneweaver as sw
from sceneweaver.runtime import package

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def bounds(requirement: str) -> tuple[str, frozenset[str]]:
    """Name, and extras and bounds in any order."""
    name = re.split(r"[\s\[<>=!~;]", requirement)[0]
    return name, frozenset(re.split(r"[,\[\]]", requirement[len(name) :]))


def test_the_distribution_is_that_of_the_project():
    assert package.DISTRIBUTION == PROJECT["name"] != "sceneweaver"  # which is the package of another author on PyPI
    assert package.package_version() == PROJECT["version"] == sw.__version__


@pytest.mark.parametrize("extra", PROJECT["optional-dependencies"])
def test_a_missing_extra_is_named_with_its_packages(extra):
    line = package.missing_extra(extra, "something needs it")
    assert line.startswith(f"something needs it (extra '{extra}'); install it with: pip install '")
    assert "\n" not in line
    named = {bounds(text) for text in re.findall(r"'([^']*[<>=][^']*)'", line)}
    assert named == {bounds(text) for text in PROJECT["optional-dependencies"][extra]}


@pytest.mark.parametrize(
    "module, wanted",
    [("yaml", "pyyaml"), ("PIL.Image", "pillow"), ("pxr", "usd-core"), ("charset_normalizer", "charset-normalizer")],
)
def test_a_missing_module_is_named_by_what_brings_it(module, wanted):
    line = package.missing_module(module, "it is missing")
    assert re.fullmatch(
        rf"it is missing; install it with: pip install '{wanted}>=[\d.]+' \(in a clone: make install\)", line
    )


def test_a_module_that_is_not_ours_is_named_as_it_is():
    assert "pip install their_tables (" in package.missing_module("their_tables.core", "an optimiser needs it")


def test_in_a_tree_that_nobody_installed(monkeypatch):
    def nothing(name):
        raise PackageNotFoundError(name)

    monkeypatch.setattr(package, "requires", nothing)
    monkeypatch.setattr(package, "version", nothing)
    assert package.package_version() == package.UNKNOWN
    assert package.missing_extra("llm", "models need it") == (
        "models need it (extra 'llm'); install it with: make install, in a clone"
    )


def test_every_extra_that_code_names_is_one_of_the_project():
    named = set()
    for source in (file.read_text() for file in (ROOT / "sceneweaver").rglob("*.py")):
        for node in ast.walk(ast.parse(source)) if "missing_extra(" in source else ():
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "missing_extra":
                named.add(ast.literal_eval(node.args[0]))
    assert {"llm", "mcp", "envs"} <= named <= set(PROJECT["optional-dependencies"])
