"""Running the command line in this process."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import pytest

from sceneweaver.cli import main
from sceneweaver.scene import Scene


@dataclass(frozen=True)
class Outcome:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        """The one JSON object on stdout."""
        return json.loads(self.out)


@pytest.fixture
def run(capfd):
    """Run a command: ``run("check", path)``."""

    def call(*args: object) -> Outcome:
        code = main([str(a) for a in args])
        return Outcome(code, *capfd.readouterr())

    return call


@pytest.fixture
def bedroom(tmp_path):
    """A valid scene file in a folder of its own."""
    path = tmp_path / "in" / "scene.json"
    path.parent.mkdir()
    Scene.example("bedroom").save(path)
    return path
