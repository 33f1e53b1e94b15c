"""``sceneweaver repair`` with the engine itself, on a small room."""

from __future__ import annotations

import json

import pytest

from sceneweaver.scene import MissingDependencyError, Pose, Scene
from tests.cli.test_bad_input import assert_one_line, listing
from tests.layout.made import CUP, relation, room, scene, table, thing

WRITTEN = ["metrics.json", "scene.json", "views", "views/top_annotated.png"]


def at(obj, x, y, z=0.0):
    return obj.model_copy(update={"pose": Pose.from_yaw(x, y, z, 0.0)})


def saved(folder, what: Scene):
    path = folder / "in" / "scene.json"
    path.parent.mkdir()
    what.save(path)
    return path


@pytest.fixture
def broken(tmp_path):
    """A box in the wall, a table that overlaps another box, and a cup in the air."""
    objects = [at(thing("a"), 0.1, 1.0), at(thing("b"), 2.7, 2.0), at(table(), 2.5, 2.3), at(CUP, 2.5, 2.4, 1.2)]
    return saved(tmp_path, scene(objects, []))


@pytest.fixture
def impossible(tmp_path):
    """A box in a wall, and one longer than the room."""
    objects = [at(thing("whale", (9, 2, 1)), 2, 2), at(thing("b"), 0.1, 0.6)]
    return saved(tmp_path, scene(objects, [relation("near", "b", "whale", max=0.1)], room=room(4, 3)))


def test_a_folder_gets_scene_metrics_and_picture(run, broken, tmp_path):
    out = tmp_path / "deep" / "out"
    ended = run("repair", broken, "-o", out, "--device", "cpu", "--seed", 7)
    assert (ended.code, ended.err) == (0, "")
    assert listing(out) == WRITTEN
    metrics = json.loads((out / "metrics.json").read_text())
    assert metrics["valid"] is True and metrics["seed"] == 7 and metrics["device"] == "cpu"
    assert metrics["seconds"]["total"] > 0 and "warp-lang" in metrics["versions"]
    assert ended.out.startswith("valid  made: 4 objects")
    for text in ("before", "after", "collisions", "unsupported", "moved", "cup", str(out)):
        assert text in ended.out
    assert run("check", out / "scene.json").code == 0


def test_a_json_file_gets_the_scene_alone(run, broken, tmp_path):
    ended = run("repair", broken, "-o", tmp_path / "new" / "fixed.json", "--device", "cpu", "--json")
    assert ended.code == 0 and listing(tmp_path / "new") == ["fixed.json"]
    data = ended.json
    assert data["valid"] is True and data["exit_code"] == 0 and data["timed_out"] is False
    assert data["files"] == {"scene": str(tmp_path / "new" / "fixed.json")}
    assert {m["id"] for m in data["moved"]} == {"a", "b", "table", "cup"}
    assert data["before"]["collisions"] and data["before"]["out_of_bounds"] and data["before"]["unsupported"]
    assert data["metrics"]["collisions"] == 0


def test_a_scene_may_be_repaired_in_place(run, broken):
    assert run("repair", broken, "-o", broken, "--device", "cpu").code == 0
    assert listing(broken.parent) == ["scene.json"]
    ended = run("repair", broken, "-o", broken)
    assert ended.code == 0 and "nothing to repair" in ended.out


def test_a_valid_scene_stays_as_it_is_and_that_is_said(run, bedroom, tmp_path):
    ended = run("repair", bedroom, "-o", tmp_path / "out")
    assert ended.code == 0 and "nothing to repair; unchanged" in ended.out
    assert (tmp_path / "out" / "scene.json").read_bytes() == bedroom.read_bytes()
    data = run("repair", bedroom, "-o", tmp_path / "out", "--json", "--no-picture").json
    assert data["moved"] == [] and data["device"] is None and set(data["files"]) == {"scene", "metrics"}


def test_not_valid_is_3_with_everything_written_and_the_unmet_listed(run, impossible, tmp_path):
    ended = run("repair", impossible, "-o", tmp_path / "out", "--candidates", 4, "--device", "cpu")
    assert ended.code == 3 and listing(tmp_path / "out") == WRITTEN
    assert ended.out.startswith("not valid  made") and "out_of_bounds" in ended.out and "whale" in ended.out
    assert len(Scene.load(tmp_path / "out" / "scene.json").objects) == 2


def test_not_valid_is_said_as_json_too(run, impossible, tmp_path):
    few = ("--candidates", 4)
    data = run("repair", impossible, "-o", tmp_path / "out", *few, "--device", "cpu", "--json").json
    assert data["valid"] is False and data["exit_code"] == 3 and data["explanation"]


def test_relations_are_left_alone_when_they_are_not_asked_for(run, tmp_path):
    what = scene([at(thing("a"), 0.1, 2.0), at(thing("b"), 4.0, 2.0)], [relation("near", "a", "b", max=0.2)])
    path = saved(tmp_path, what)
    ended = run("repair", path, "-o", tmp_path / "x.json", "--no-relations", "--device", "cpu", "--json")
    assert ended.code == 0 and [m["id"] for m in ended.json["moved"]] == ["a"]
    assert Scene.load(tmp_path / "x.json").relations == what.relations
    ended = run("repair", path, "-o", tmp_path / "y.json", "--device", "cpu", "--json")
    assert ended.code == 0 and {m["id"] for m in ended.json["moved"]} >= {"a"}
    assert run("check", tmp_path / "x.json").code == 3 and run("check", tmp_path / "y.json").code == 0


def test_options_reach_the_repair(run, broken, tmp_path, monkeypatch):
    import sceneweaver.repairs

    real, calls = sceneweaver.repairs.repair_report, []

    def recorded(what, **options):
        calls.append(options)
        return real(what, relations=options["relations"], device="cpu", candidates=2)

    monkeypatch.setattr("sceneweaver.repairs.repair_report", recorded)
    options = ["--candidates", 9, "--seed", 3, "--device", "cuda:1", "--time-limit", 900, "--no-relations"]
    assert run("repair", broken, "-o", tmp_path / "out", *options).code == 0
    assert 600 < calls[0].pop("time_limit") < 900  # the rest is for what comes after
    asked = {"relations": False, "soft": False, "drop": False, "candidates": 9, "seed": 3, "device": "cuda:1"}
    assert calls == [asked]


def test_a_device_that_is_not_there_is_4(run, broken, tmp_path, monkeypatch):
    def no_device(what, **options):
        raise MissingDependencyError('device: "cuda" is not there; use device="cpu"')

    monkeypatch.setattr("sceneweaver.repairs.repair_report", no_device)
    ended = run("repair", broken, "-o", tmp_path / "out", "--device", "cuda", "--json")
    assert ended.code == 4 and ended.json["exit_code"] == 4
    assert_one_line(ended.err, "cuda")
    assert listing(tmp_path) == ["in", "in/scene.json"]


def test_an_interrupt_leaves_nothing(run, broken, tmp_path, monkeypatch):
    def interrupted(what, **options):
        raise KeyboardInterrupt

    monkeypatch.setattr("sceneweaver.repairs.repair_report", interrupted)
    assert run("repair", broken, "-o", tmp_path / "new" / "out").code == 130
    assert listing(tmp_path) == ["in", "in/scene.json"]
