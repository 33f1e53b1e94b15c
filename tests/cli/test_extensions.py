"""What other packages add to the command line."""

from __future__ import annotations

from importlib.metadata import EntryPoint

import pytest

from sceneweaver.cli import main
from sceneweaver.cli.extensions import GROUP

CALLED: list[str] = []


def define() -> None:
    CALLED.append("define")


def broken() -> None:
    raise ValueError("no such colour")


@pytest.mark.parametrize("name", ["define", "broken"])
def test_each_is_called_before_a_command_and_a_broken_one_costs_a_line(monkeypatch, capfd, name):
    CALLED.clear()
    points = [EntryPoint("green", f"{__name__}:{name}", GROUP)]
    monkeypatch.setattr("sceneweaver.cli.extensions.entry_points", lambda group: points if group == GROUP else [])
    assert main(["--version"]) == 0
    said = capfd.readouterr()
    assert said.out.startswith("sceneweaver ")
    if name == "define":
        assert CALLED == ["define"] and not said.err
    else:
        assert said.err == "sceneweaver: extension 'green' is left out: no such colour\n"
