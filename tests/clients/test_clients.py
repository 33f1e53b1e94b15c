"""An exported room in this Python's MuJoCo, by the same script as in all clients; the others are long tests."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from sceneweaver.assets import make
from sceneweaver.export import export_scene
from sceneweaver.scene import Door, Pose, Room, Scene
from tests.clients import matrix
from tests.clients.environments import UnavailableError, python_of
from tests.clients.expected import expected, expected_of_home
from tests.export.home.homes import flat, load

ASSETS = {a.id: a for a in (make("fridge", 1), make("nightstand", 2), make("armchair", 2))}
HOME_CLIENTS = ("mujoco", "mujoco_warp", "newton", "newton_usd", "drake", "pybullet", "sapien")


@pytest.fixture(scope="module")
def scene() -> Scene:
    door = Door(id="d", wall=0, offset=0.5, width=0.9, height=2.0, swing="in-left")
    room = Room(outline=((0, 0), (4, 0), (4, 4), (0, 4)), doors=(door,))
    poses = (Pose.from_yaw(3.4, 1.0, 0.0, 2.0), Pose.from_yaw(1.0, 3.3, 0.0, -1.0), Pose.from_yaw(2.5, 2.8, 0.0, 0.3))
    objects = [
        a.object(f"{a.category}-{k}", pose=p) for k, (a, p) in enumerate(zip(ASSETS.values(), poses, strict=True))
    ]
    return Scene(id="clients", room=room, objects=tuple(objects))


@pytest.fixture(scope="module")
def wanted(scene, tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("wanted") / "expected.json"
    path.write_text(json.dumps(expected(scene, ASSETS.__getitem__)))
    return path


def check(row: dict) -> None:
    """What holds in every client."""
    assert "error" not in row, row
    assert row["bodies_missing"] == [] and row["pose_m"] < 1e-5 and row["pose_rad"] < 1e-4, row
    if row["joints"]:
        assert row["joints_missing"] == [] and row["joints_wrong"] == [], row
        assert row["joints_opened"] == row["joints_expected"], row
    if "far" in row:
        assert row["far"] == 0.0 and row["little"] <= 0.01, row


def test_the_room_in_this_mujoco(scene, wanted, tmp_path) -> None:
    export_scene(scene, tmp_path / "out", ["mjcf"], ASSETS.__getitem__)
    row = matrix.run(Path(sys.executable), "mujoco", tmp_path / "out", wanted, 0.5)
    check(row)
    assert row["joints"] == row["joints_expected"] >= 4 and row["free"] == 3


def test_what_is_wrong_is_found(scene, wanted, tmp_path) -> None:
    export_scene(scene, tmp_path / "out", ["mjcf"], ASSETS.__getitem__)
    said = json.loads(wanted.read_text())
    said["bodies"]["armchair-2"]["object"][0][0] += 1e-3
    joint = next(name for name in said["joints"] if name.startswith("fridge"))
    said["joints"][joint]["axis"] = [-v for v in said["joints"][joint]["axis"]]
    other = tmp_path / "other.json"
    other.write_text(json.dumps(said))
    row = matrix.run(Path(sys.executable), "mujoco", tmp_path / "out", other, 0.0)
    assert row["pose_m"] == pytest.approx(1e-3, rel=1e-3) and row["pose_worst"] == "armchair_2"
    assert row["joints_opened"] == row["joints_expected"] - 1
    assert "error" in matrix.run(Path(sys.executable), "mujoco", tmp_path / "gone", wanted, 0.0)


@pytest.fixture(scope="module")
def home_wanted(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("home") / "expected.json"
    path.write_text(json.dumps(expected_of_home(flat(), load)))
    return path


@pytest.mark.parametrize("name", ["mujoco", "mujoco_sleep"])
def test_a_home_in_this_mujoco(name, home_wanted, tmp_path) -> None:
    matrix.write_home(flat(), tmp_path / "out", "mjcf", load)
    row = matrix.run(Path(sys.executable), name, tmp_path / "out", home_wanted, 0.5)
    check(row)
    assert row["bodies"] == row["bodies_expected"] > 20
    assert row["joints"] == row["joints_expected"] >= 7


@pytest.mark.slow
@pytest.mark.bench
@pytest.mark.parametrize("name", HOME_CLIENTS)
def test_a_home_in_other_clients(name, home_wanted, tmp_path) -> None:
    entry = matrix.CLIENTS[name]
    try:
        python = python_of(entry.environment)
    except UnavailableError as error:
        pytest.skip(str(error))
    matrix.write_home(flat(), tmp_path / "out", entry.format, load)
    check(matrix.run(python, entry.module, tmp_path / "out", home_wanted, matrix.SECONDS))


@pytest.mark.slow
@pytest.mark.bench
@pytest.mark.parametrize("name", matrix.CLIENTS)
def test_every_client(name, scene, wanted, tmp_path) -> None:
    entry = matrix.CLIENTS[name]
    try:
        python = python_of(entry.environment)
    except UnavailableError as error:
        pytest.skip(str(error))
    export_scene(scene, tmp_path / "out", [entry.format], ASSETS.__getitem__)
    check(matrix.run(python, entry.module, tmp_path / "out", wanted, matrix.SECONDS))
