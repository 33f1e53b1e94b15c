"""`sceneweaver export`, `check --physics`, and what `design` writes for simulators."""

from __future__ import annotations

import json
import math

import pytest

from sceneweaver.assets import make
from sceneweaver.cli import main
from sceneweaver.scene import Pose, Room, Scene

USUAL = {"scene.glb", "scene.usdc", "scene.xml", "scene-sleep.xml", "meshes", "textures"}
ROOM = Room(type="study", outline=((0, 0), (4, 0), (4, 3), (0, 3)), height=2.6)


@pytest.fixture(scope="module")
def scene():
    desk, chair = make("desk", 2), make("chair", 1)
    objects = (
        desk.object("desk-0", pose=Pose.from_yaw(1.0, 1.0, 0.0, 0.4)),
        chair.object("chair-0", pose=Pose.from_yaw(2.6, 1.8, 0.0, math.pi)),
    )
    return Scene(id="study", room=ROOM, objects=objects)


@pytest.fixture
def source(scene, tmp_path):
    scene.save(tmp_path / "scene.json")
    return tmp_path / "scene.json"


def test_a_folder_gets_the_usual_formats(source, tmp_path, capsys):
    out = tmp_path / "a" / "b"
    assert main(["export", str(source), "-o", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert set(said["files"]) == {"glb", "usd", "mjcf"} and said["objects"] == 2
    assert {p.name for p in out.iterdir()} == USUAL
    small = tmp_path / "small"
    assert main(["export", str(source), "-o", str(small), "--no-textures"]) == 0
    assert {p.name for p in small.iterdir()} == USUAL - {"textures"}
    assert (small / "scene.glb").stat().st_size < (out / "scene.glb").stat().st_size


def test_all_formats_again_over_themselves(source, tmp_path):
    for _ in range(2):
        assert main(["export", str(source), "-o", str(tmp_path / "out"), "--to", "all"]) == 0
    names = {p.name for p in (tmp_path / "out").iterdir()}
    rest = {"scenestate.json", "models", "scene.sdf", "sdf", "scene.urdf.json", "urdf"}
    assert names == {*USUAL, *rest}


@pytest.mark.parametrize("name", ["room.usda", "room.usdc", "room.glb", "room.xml", "room.json", "room.sdf"])
def test_the_suffix_says_the_format(source, tmp_path, name):
    assert main(["export", str(source), "-o", str(tmp_path / name)]) == 0
    assert (tmp_path / name).stat().st_size > 500


def test_mjcf_beside_other_files_loads_and_leaves_no_old_meshes(source, scene, tmp_path):
    import mujoco

    out = tmp_path / "out"
    assert main(["export", str(source), "-o", str(out), "--to", "mjcf"]) == 0
    before = set((out / "meshes").iterdir())
    alone = scene.model_copy(update={"objects": scene.objects[:1]})
    alone.save(source)
    (out / "mine.txt").write_text("kept")
    assert main(["export", str(source), "-o", str(out), "--to", "mjcf"]) == 0
    assert set((out / "meshes").iterdir()) < before and (out / "mine.txt").exists()
    model = mujoco.MjModel.from_xml_path(str(out / "scene.xml"))
    bodies = {model.body(k).name.partition(".")[0] for k in range(model.nbody)}
    assert {o.id for o in scene.objects} & bodies == {"desk-0"}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--to", "obj"], ("'obj' is no format", "usd")),
        (["--to", ""], ("names no format",)),
        (["-o", "room.fbx"], ("room.fbx", "folder")),
        (["-o", "nowhere/room.glb"], ("nowhere", "make it first")),
        (["-o", "room.glb", "--to", "usd"], ("--to", "suffix")),
    ],
)
def test_bad_requests_are_one_line(source, tmp_path, capsys, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    out = [] if "-o" in arguments else ["-o", "out"]
    assert main(["export", str(source), *out, *arguments]) == 2
    said = capsys.readouterr().err.strip()
    assert "\n" not in said and all(word in said for word in words)
    assert [p.name for p in tmp_path.iterdir()] == ["scene.json"]


def test_a_missing_asset_leaves_nothing_behind(scene, tmp_path, capsys):
    desk = scene.objects[0].model_copy(update={"asset": "sha256-0000"})
    scene.model_copy(update={"objects": (desk,)}).save(tmp_path / "scene.json")
    assert main(["export", str(tmp_path / "scene.json"), "-o", str(tmp_path / "out"), "--to", "all"]) == 2
    assert "objects[0].asset" in capsys.readouterr().err
    assert [p.name for p in tmp_path.iterdir()] == ["scene.json"]


def test_a_piece_of_furniture_as_urdf(tmp_path, capsys):
    import mujoco

    assert main(["assets", "urdf", "wardrobe", "-o", str(tmp_path / "w"), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    model = mujoco.MjModel.from_xml_path(said["file"])
    assert model.njnt == len(said["joints"]) > 0
    assert main(["assets", "urdf", "wardrobe", "-o", str(tmp_path / "a" / "b")]) == 2
    assert "make it first" in capsys.readouterr().err


def test_check_with_physics_measures_stability(source, capsys):
    assert main(["check", str(source), "--physics", "--json"]) == 0
    steady = json.loads(capsys.readouterr().out)["stability"]
    assert steady["moved_over_0_1m"] == steady["moved_over_0_01m"] == 0 and steady["mean_shift_m"] < 2e-3


def test_what_falls_makes_a_scene_invalid_for_check_with_physics(tmp_path, capsys):
    plank = {
        "id": "plank",
        "category": "board",
        "size": [1.0, 0.1, 0.02],
        "mount": "surface",
        "pose": {"position": [2.0, 1.5, 0.4], "quaternion": [0, 0, 0, 1]},
        "support": {"object": "post", "surface": "top"},
    }
    top = [[-0.04, -0.04], [0.04, -0.04], [0.04, 0.04], [-0.04, 0.04]]
    post = {
        "id": "post",
        "category": "post",
        "size": [0.1, 0.1, 0.4],
        "mount": "floor",
        "fixed": True,
        "pose": {"position": [1.55, 1.5, 0.0], "quaternion": [0, 0, 0, 1]},
        "surfaces": [{"name": "top", "polygon": top, "z": 0.4, "headroom": None}],
    }
    scene = Scene.model_validate(
        {"schema": "sceneweaver.scene/1", "id": "s", "room": ROOM.model_dump(), "objects": [post, plank]}
    )
    scene.save(tmp_path / "scene.json")
    assert main(["check", str(tmp_path / "scene.json"), "--physics", "--json"]) == 3
    found = json.loads(capsys.readouterr().out)
    assert found["stability"]["moved_over_0_1m"] == 1.0
    assert ["plank"] in [v["objects"] for v in found["violations"] if v["kind"] == "unstable"]


def test_a_design_comes_with_files_for_simulators_and_settled(tmp_path, capsys):
    arguments = [
        "design",
        "a guest toilet",
        "-o",
        str(tmp_path),
        "--no-pictures",
        "--candidates",
        "32",
        "--steps",
        "3",
        "--settle",
        "--export",
        "usd,mjcf",
        "--json",
    ]
    assert main(arguments) in (0, 3)
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["valid"] and metrics["stability"]["moved_over_0_01m"] <= 0.1
    names = {p.name for p in tmp_path.iterdir()}
    assert {"scene.usdc", "scene.xml", "meshes"} <= names and "scene.glb" not in names
    scene = Scene.load(tmp_path / "scene.json")
    free = [o for o in scene.objects if o.mount == "surface"]
    assert not free or any(abs(o.pose.position[2] - round(o.pose.position[2], 3)) > 1e-9 for o in free)


def test_a_time_limit_counts_from_the_call_in_a_process_that_has_run_for_long(tmp_path, monkeypatch):
    monkeypatch.setattr("sceneweaver.cli.app.process_began", lambda: -1e9)
    arguments = ["design", "a guest toilet", "-o", str(tmp_path), "--no-pictures", "--candidates", "32", "--steps", "1"]
    assert main([*arguments, "--export", "none", "--settle", "--json"]) in (0, 3)
    assert json.loads((tmp_path / "metrics.json").read_text())["stability"]  # what is left out first when time is up


def test_a_link_to_a_folder_is_no_name_of_a_file(source, tmp_path, capsys):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    (tmp_path / "room.glb").symlink_to(elsewhere, target_is_directory=True)
    assert main(["export", str(source), "-o", str(tmp_path / "room.glb")]) == 2
    assert "link to a folder" in capsys.readouterr().err
    assert not list(elsewhere.iterdir())
