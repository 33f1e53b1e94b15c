"""The wheel with each extra, from the index, in an empty environment away from the repository: what it is for works.

Each environment is made by uv, as ``make install`` has put it into the clone; without an index the tests are skipped.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from .test_wheel import PROJECT, ROOT, STEM

pytestmark = pytest.mark.packaging

LOCAL = ROOT / ".uv" / "bin" / "uv"
UV = str(LOCAL) if LOCAL.exists() else shutil.which("uv")
SPEC = """\
schema: sceneweaver.dataset/1
name: few
product: layouts
count: 8
requests: {kinds: {bedroom: 1}}
rooms: {candidates: 16, layouts: 4, objects: [3, 8]}
"""
REFINE = """
import sceneweaver as sw
solution = sw.refine(sw.Scene.example("bedroom"), candidates=16, seed=3, device="cpu")
print("valid:", sw.check(solution.best).valid)
"""
DXF = """
import ezdxf, sceneweaver as sw
drawing = ezdxf.new(units=6)
walls = [((0, 0), (8, 0)), ((8, 0), (8, 4)), ((8, 4), (0, 4)), ((0, 4), (0, 0)), ((4, 0), (4, 4))]
for start, end in walls:
    drawing.modelspace().add_line(start, end, dxfattribs={"layer": "WALLS"})
drawing.saveas("plan.dxf")
(found,) = sw.read_homes("plan.dxf")
print("rooms:", len(found.home.rooms))
"""
TORCH = """
import torch, sceneweaver as sw, sceneweaver.torch as swt
problem = sw.compile(sw.Scene.example("bedroom"), device="cpu")
x = torch.tensor(problem.sample(0, 2), requires_grad=True)
swt.energy(problem, x).sum().backward()
print("gradient:", bool(x.grad.abs().sum() > 0))
"""
ENVS = """
import sceneweaver as sw
from sceneweaver.envs import RoomEnv
env = RoomEnv(sw.Scene.example("bedroom"), task="go to the bed")
observation, info = env.reset(seed=0)
env.step(env.action_space.sample())
env.close()
print("instruction:", info["instruction"])
"""
LLM = """
import anthropic, openai
from pydantic import BaseModel
from pydantic_ai.models.test import TestModel
from sceneweaver.llm import ModelClient
class Plan(BaseModel):
    steps: int
print("answer:", ModelClient(TestModel()).ask("plan", Plan, "Plan.", ["a room"]))
"""
MCP = """
import asyncio, sys
from pathlib import Path
from mcp import Client, StdioServerParameters
async def main():
    command = str(Path(sys.executable).with_name("sceneweaver"))
    async with Client(StdioServerParameters(command=command, args=["mcp"])) as client:
        print("tools:", *(tool.name for tool in (await client.list_tools()).tools))
asyncio.run(main())
"""
PRIOR = """
import numpy as np
import sceneweaver as sw
from sceneweaver.prior.network import Shape
from sceneweaver.prior.tokens import TRAINED, padded, tokens_of
from sceneweaver.prior.training import Recipe, train
words = sw.LayoutPrior.load().words
scene = sw.Scene.example("bedroom")
token = tokens_of(scene, words)
poses = np.zeros((2, TRAINED["objects"], 4), dtype=np.float32)
poses[:, : len(token.index)] = token.local(np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects]))
data = {f"token.{name}": value for name, value in padded([token], **TRAINED).arrays().items()}
data |= {"poses": poses, "counts": np.array([2])}
small = {"wide": 32, "deep": 1, "heads": 2, "slim": 32, "steps": 1, "eyes": 2}
shape = Shape(len(words.categories), len(words.kinds), len(words.relations), **small)
print("steps:", sum(n for _, _, n in train(data, shape, Recipe(rooms=1, layouts=2, low="float32"), steps=25)))
"""
RUN = ["--optimizers", "adam", "--seeds", "1", "--candidates", "8", "--evaluations", "400", "--no-isolate"]
MAKE = ["dataset", "make", "spec.yaml", "--workers", "1", "--device", "cpu"]
CARD = ["dataset", "push-card", "few", "--repo", "a/b", "--endpoint", "http://127.0.0.1:9", "--token-env", "CARD_TOKEN"]

USES: dict[str, list[tuple[str | list[str], str]]] = {
    "": [(["refine", "room.json", "-o", "out", "--device", "cpu"], "")],
    "bench": [
        (["bench", "run", "-o", "runs", "--problems", "room.json", *RUN, "--device", "cpu"], ""),
        (["bench", "plot", "runs", "-o", "plots"], ""),
    ],
    "torch": [(TORCH, "gradient: True")],
    "exr": [(["render", "room.json", "-o", "exr", "--passes", "depth", "--format", "exr", "--width", "200"], "")],
    "envs": [(ENVS, "instruction: go to the bed")],
    "datasets": [
        ([*MAKE, "-o", "few"], ""),
        (["dataset", "verify", "few"], ""),
    ],
    "hub": [(CARD, "--repo: a/b")],  # as far as the server, which is not there
    "ray": [([*MAKE, "-o", "by_ray", "--engine", "ray"], "")],
    "llm": [(LLM, "answer: steps=0")],
    "mcp": [(MCP, "design_home")],
    "prior": [(PRIOR, "steps: 25")],
    "dxf": [(DXF, "rooms: 2")],
}
"""What each extra is for: programs and arguments of the command, each with what it prints."""


def ran(*command: object, cwd: Path, limit: float = 900.0) -> subprocess.CompletedProcess[str]:
    """A command without the variables that could lead it back to this checkout."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    return subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        env={**kept, "CARD_TOKEN": "none", "NO_COLOR": "1", "COLUMNS": "120"},
        capture_output=True,
        text=True,
        timeout=limit,
        check=False,
    )


@pytest.fixture(scope="module")
def archives(tmp_path_factory) -> dict[str, Path]:
    """Wheel and source archive of this checkout, by suffix."""
    out = tmp_path_factory.mktemp("dist")
    build = (sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-t", "wheel", "-d", out)
    done = ran(*build, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    return {"wheel": out / f"{STEM}-py3-none-any.whl", "sdist": out / f"{STEM}.tar.gz"}


@pytest.fixture
def place(tmp_path) -> Iterator[Path]:
    """An empty folder for an environment, which goes again: with PyTorch it has gigabytes."""
    yield tmp_path
    shutil.rmtree(tmp_path, ignore_errors=True)


def installed(archive: Path, extra: str, place: Path) -> Path:
    """The Python of a new environment with an archive and an extra."""
    if UV is None:
        pytest.skip("uv is not installed")
    python = place / "venv" / "bin" / "python"
    done = ran(UV, "venv", "-q", "--python", sys.executable, place / "venv", cwd=place)
    assert done.returncode == 0, done.stderr
    wanted = f"{archive}[{extra}]" if extra else str(archive)
    done = ran(UV, "pip", "install", "-q", "--python", python, wanted, cwd=place, limit=1800.0)
    if any(word in done.stderr for word in ("error sending request", "dns error", "Connection refused", "offline")):
        pytest.skip("no package index here")
    assert done.returncode == 0, done.stderr
    return python


def used(python: Path, extra: str, place: Path) -> None:
    """Run what every installation can do, then what the extra is for."""
    where = ran(python, "-c", "import sceneweaver; print(sceneweaver.__file__)", cwd=place)
    assert Path(where.stdout.strip()).is_relative_to(place / "venv"), where.stdout + where.stderr
    command = python.with_name("sceneweaver")
    assert "refine" in ran(command, "--help", cwd=place).stdout
    done = ran(python, "-c", REFINE, cwd=place)
    assert done.stdout == "valid: True\n", done.stdout + done.stderr
    (place / "spec.yaml").write_text(SPEC)
    shutil.copy(ROOT / "sceneweaver" / "scene" / "examples" / "bedroom.json", place / "room.json")
    for use, expected in USES[extra]:
        command = (python, "-c", use) if isinstance(use, str) else (python.with_name("sceneweaver"), *use)
        done = ran(*command, cwd=place)
        assert done.returncode == (2 if extra == "hub" else 0), f"{use}\n{done.stdout}\n{done.stderr}"
        assert expected in done.stdout + done.stderr, f"{use}\n{done.stdout}\n{done.stderr}"


@pytest.mark.slow
@pytest.mark.parametrize("extra", USES, ids=lambda extra: extra or "none")
def test_the_wheel_with_an_extra_does_what_it_is_for(extra, archives, place):
    if extra == "hub":  # a data set to speak of is made by this environment
        (place / "spec.yaml").write_text(SPEC)
        make = ("dataset", "make", place / "spec.yaml", "-o", place / "few", "--workers", "1", "--device", "cpu")
        assert ran(sys.executable, "-m", "sceneweaver.cli", *make, cwd=ROOT).returncode == 0
    used(installed(archives["wheel"], extra, place), extra, place)


@pytest.mark.slow
def test_the_wheel_with_all_extras(archives, place):
    python = installed(archives["wheel"], ",".join(filter(None, USES)), place)
    for extra in USES:
        used(python, extra, place)


@pytest.mark.slow
def test_the_source_archive_installs(archives, place):
    used(installed(archives["sdist"], "", place), "", place)


def test_every_extra_has_a_use():
    assert set(USES) - {""} == set(PROJECT["optional-dependencies"])
