"""The code of docs/simulators.md runs as it stands: MuJoCo's here, the others in the environments of the clients."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from sceneweaver.export import export_scene
from sceneweaver.scene import Scene
from tests.clients.environments import UnavailableError, python_of
from tests.clients.test_clients import ASSETS, scene  # noqa: F401 - a fixture
from tests.test_repository import ROOT, code_blocks

LIMIT = 420.0  # [s] for one snippet
OTHERS = {
    "from dm_control": ("dm_control", ["mjcf"]),
    "import newton": ("newton", ["mjcf:newton"]),
    "from robosuite": ("robosuite", ["mjcf:robosuite"]),
    "from pydrake": ("drake", ["sdf"]),
    "import pybullet": ("pybullet", ["urdf"]),
    "import sapien": ("sapien", ["urdf"]),
    "import bpy": ("blender", ["glb"]),
}
"""Environment and files of a snippet, by an import that it has."""

SNIPPETS = code_blocks((ROOT / "docs" / "simulators.md").read_text(encoding="utf-8"), "python")
OWN = [code for code in SNIPPETS if "import mujoco\n" in code]


def run(python: Path | str, code: str, folder: Path) -> str:
    """Run a snippet without a display; what it says to standard error."""
    environment = dict(os.environ)
    environment.pop("DISPLAY", None)
    done = subprocess.run(
        [str(python), "-I", "-c", code], cwd=folder, env=environment, capture_output=True, text=True, timeout=LIMIT
    )
    assert done.returncode == 0, done.stderr[-1500:]
    return done.stderr


@pytest.fixture(scope="module")
def folder(scene: Scene, tmp_path_factory) -> Path:  # noqa: F811 - the fixture
    path = tmp_path_factory.mktemp("snippets")
    export_scene(scene, path / "out", ["mjcf"], ASSETS.__getitem__)
    return path


@pytest.mark.parametrize("number", range(len(OWN)))
def test_what_is_said_of_mujoco_runs(number, folder) -> None:
    """And in each the room keeps the options that it was written with."""
    kept = (
        "\nopt = model.opt\nassert (opt.timestep, opt.cone, opt.impratio, opt.integrator) == (0.004, 1, 10.0, 3), opt"
    )
    kept += "\nassert opt.enableflags & mujoco.mjtEnableBit.mjENBL_SLEEP and model.narena == 2**30"
    run(sys.executable, OWN[number] + kept, folder)


def test_every_snippet_is_run_somewhere() -> None:
    others = [code for code in SNIPPETS if code not in OWN and "import genesis" not in code]
    assert len(OWN) == 3 and all(sum(word in code for word in OTHERS) == 1 for code in others)


@pytest.mark.slow
@pytest.mark.bench
@pytest.mark.parametrize("word", OTHERS)
def test_what_is_said_of_other_clients_runs(word, scene, tmp_path) -> None:  # noqa: F811 - the fixture
    environment, formats = OTHERS[word]
    try:
        python = python_of(environment)
    except UnavailableError as error:
        pytest.skip(str(error))
    export_scene(scene, tmp_path / "out", formats, ASSETS.__getitem__)
    said = run(python, next(code for code in SNIPPETS if word in code), tmp_path)
    assert said.count("margin") == 0, said[-1500:]
