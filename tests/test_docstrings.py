"""Every public name says what it is, with an example, and the examples run."""

from __future__ import annotations

import doctest
import importlib
import importlib.util
import inspect
from collections.abc import Callable
from typing import get_args, get_type_hints

import pytest

from tests.sizes import often

MODULES = tuple(f"sceneweaver{floor}" for floor in ("", ".jax", ".torch", ".problems", ".bench", ".envs"))
NEEDS = {"sceneweaver.torch": ("torch",), "sceneweaver.bench": ("pyarrow", "matplotlib")}
PLAIN = {"sceneweaver.__version__"}  # a text has no docstring of its own
PUBLIC = [
    f"{module}.{name}"
    for module in MODULES
    if importlib.util.find_spec(module)
    for name in importlib.import_module(module).__all__
    if f"{module}.{name}" not in PLAIN
]


def public(name: str):
    """What a public name stands for."""
    module, _, last = name.rpartition(".")
    return getattr(importlib.import_module(module), last)


def examples(name: str) -> list[doctest.DocTest]:
    """The examples of a public name: of a class those of its methods as well."""
    found = public(name)
    if inspect.ismodule(found):
        return []
    return [test for test in doctest.DocTestFinder().find(found, name, globs={}) if test.examples]


@pytest.mark.parametrize("name", PUBLIC)
def test_every_public_name_has_a_docstring_with_an_example(name):
    found = public(name)
    text = inspect.getdoc(found) or ""
    assert text, "no docstring"
    if inspect.ismodule(found) or not (inspect.isclass(found) or callable(found)):
        return
    assert ">>> " in text and "\nExamples:\n" in text, "no example under the heading 'Examples:'"
    assert "+SKIP" not in text


LONG = ("sceneweaver.jax.", "sceneweaver.bench.plot", "sceneweaver.design_home")
QUICK = [name for name in PUBLIC if name == "sceneweaver.jax.ravel" or not name.startswith(LONG)]
"""All but those that mostly wait for the compiler of JAX or for drawings of matplotlib, and the design of a whole home,
which ``furnish/test_design_home.py`` does with a smaller one."""


@pytest.mark.parametrize("name", often(PUBLIC, QUICK))
def test_the_examples_of_a_public_name_run(name, tmp_path, monkeypatch):
    for module in NEEDS.get(name.rpartition(".")[0], ()):
        pytest.importorskip(module)
    monkeypatch.chdir(tmp_path)
    said: list[str] = []
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    for test in examples(name):
        test.globs["__name__"] = "__main__"
        runner.run(test, out=said.append)
    assert runner.failures == 0, "".join(said)


def parameters_of(function: Callable) -> tuple[set[str], set[str]]:
    """The names of its arguments, and those of the typed dictionary that ``**options`` unpack."""
    plain, packed = set(), set()
    for name, parameter in inspect.signature(function).parameters.items():
        if parameter.kind is parameter.VAR_KEYWORD and "Unpack" in str(parameter.annotation):
            packed |= set(get_type_hints(get_args(get_type_hints(function)[name])[0]))
        else:
            plain.add(name)
    return plain, packed


def test_a_docstring_that_lists_arguments_lists_them_all():
    wrong = []
    for name in PUBLIC:
        found = public(name)
        text = inspect.getdoc(found) or ""
        if not inspect.isfunction(found) or "\nArgs:\n" not in text:
            continue
        block = text.split("\nArgs:\n")[1].split("\n\n")[0]
        listed = {
            part.strip("* ")
            for line in block.splitlines()
            if line.startswith("    ") and not line.startswith("     ")
            for part in line.split(":")[0].split(",")
        }
        plain, packed = parameters_of(found)
        together = listed - plain - packed if packed else set()  # ``options`` stands for those that are not listed
        missing = plain - listed if together else (plain | packed) - listed
        if differ := missing | (listed - plain - packed - {"options"}):
            wrong.append(f"{name}: {sorted(differ)}")
    assert wrong == []
