"""``sceneweaver refine`` with a stand-in for the engine."""

from __future__ import annotations

import json
import os

import pytest
from PIL import Image

from sceneweaver.cli import output
from sceneweaver.scene import EXAMPLES, MissingDependencyError, Scene
from tests.cli import engine
from tests.cli.test_bad_input import assert_one_line, listing

WRITTEN = ["metrics.json", "scene.json", "views", "views/top_annotated.png"]


@pytest.fixture
def calls(monkeypatch):
    return engine.use(monkeypatch, engine.keeps)


@pytest.fixture
def spoilt(monkeypatch):
    return engine.use(monkeypatch, engine.spoils)


def test_a_folder_gets_scene_metrics_and_picture(run, bedroom, tmp_path, calls):
    out = tmp_path / "deep" / "out"
    ended = run("refine", bedroom, "-o", out, "--candidates", 4, "--seed", 7)
    assert (ended.code, ended.err) == (0, "")
    assert listing(out) == WRITTEN
    assert Scene.load(out / "scene.json") == Scene.load(bedroom)
    metrics = json.loads((out / "metrics.json").read_text())
    assert metrics["valid"] is True and metrics["seed"] == 7 and metrics["candidates"] == 4
    assert metrics["device"] == "cpu" and metrics["seconds"]["total"] > 0 and "warp-lang" in metrics["versions"]
    with Image.open(out / "views" / "top_annotated.png") as image:
        assert image.width == 1600
    assert ended.out.startswith("valid  bedroom") and "2 of 4 candidates" in ended.out and str(out) in ended.out
    assert sorted(p.name for p in out.parent.iterdir()) == ["out"]


def test_options_reach_the_engine(run, bedroom, tmp_path, calls):
    options = ["--candidates", 9, "--seed", 3, "--init", "current", "--device", "cuda:1", "--optimizer", "adam"]
    assert run("refine", bedroom, "-o", tmp_path / "out", *options, "--time-limit", 900).code == 0
    (call,) = calls
    del call["scene"]
    assert 600 < call.pop("time_limit") < 900  # the rest is for what comes after
    assert call == {
        "candidates": 9,
        "seed": 3,
        "init": "current",
        "device": "cuda:1",
        "optimizer": "adam",
        "progress": None,
    }


def test_an_objective_comes_from_a_file(run, bedroom, tmp_path, calls):
    terms = tmp_path / "terms.json"
    terms.write_text('[{"kind": "flow", "objects": ["bed", "wardrobe"], "weight": 2.0}]')
    assert run("refine", bedroom, "-o", tmp_path / "out", "--objective", terms).code == 0
    (term,) = calls[0]["objective"]
    assert (term.kind, term.objects, term.weight) == ("flow", ("bed", "wardrobe"), 2.0)


@pytest.mark.parametrize("text", ['{"kind": "flow"}', '[{"kind": "flow", "objects": ["bed"]}]', "[", "[7]"])
def test_a_file_that_is_no_objective_is_named(run, bedroom, tmp_path, calls, text):
    terms = tmp_path / "terms.json"
    terms.write_text(text)
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--objective", terms)
    assert_one_line(ended.err)
    assert not calls and not (tmp_path / "out").exists()


def test_no_picture(run, bedroom, tmp_path, calls):
    assert run("refine", bedroom, "-o", tmp_path / "out", "--no-picture").code == 0
    assert listing(tmp_path / "out") == ["metrics.json", "scene.json"]


def test_a_json_file_gets_the_scene_alone(run, bedroom, tmp_path, calls):
    ended = run("refine", bedroom, "-o", tmp_path / "new" / "refined.json", "--json")
    assert ended.code == 0 and listing(tmp_path / "new") == ["refined.json"]
    assert ended.json["files"] == {"scene": str(tmp_path / "new" / "refined.json")}


def test_a_scene_may_be_refined_in_place_and_other_files_stay(run, bedroom, calls):
    (bedroom.parent / "notes.txt").write_text("mine")
    assert run("refine", bedroom, "-o", bedroom.parent).code == 0
    assert listing(bedroom.parent) == sorted([*WRITTEN, "notes.txt"])
    assert run("refine", bedroom, "-o", bedroom.parent).code == 0


def test_json_is_one_object_whatever_libraries_print(run, bedroom, tmp_path, monkeypatch):
    def loud(scene, **options):
        print("Warp 1.19.0 initialized")
        os.write(1, b"printed from C\n")
        return engine.keeps(scene, **options)

    engine.use(monkeypatch, loud)
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--json", "--candidates", 4)
    assert (ended.code, ended.err) == (0, "")
    data = ended.json
    assert data["valid"] is True and data["valid_candidates"] == 2 and data["candidates"] == 4
    assert data["metrics"] == json.loads((tmp_path / "out" / "metrics.json").read_text())
    assert set(data["files"]) == {"scene", "metrics", "picture"}


def test_other_words_on_stderr_are_passed_on(run, bedroom, tmp_path, monkeypatch):
    def warns(scene, **options):
        os.write(2, b"something to know\n")
        return engine.keeps(scene, **options)

    engine.use(monkeypatch, warns)
    assert run("refine", bedroom, "-o", tmp_path / "out").err == "something to know\n"


def test_not_valid_is_3_with_everything_written_and_the_unmet_listed(run, bedroom, tmp_path, spoilt):
    ended = run("refine", bedroom, "-o", tmp_path / "out")
    assert ended.code == 3 and listing(tmp_path / "out") == WRITTEN
    assert ended.out.startswith("not valid  bedroom")
    assert "out_of_bounds" in ended.out and "bed against_wall" in ended.out
    assert "the walls are too short by 0.4 m" in ended.out and "time limit" in ended.out
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--json")
    assert ended.code == 3
    assert ended.json["valid"] is False and ended.json["exit_code"] == 3 and ended.json["timed_out"] is True
    assert ended.json["explanation"] and ended.json["metrics"]["violations"]


def test_a_device_that_is_not_there_is_4(run, bedroom, tmp_path, monkeypatch):
    def no_device(scene, **options):
        raise MissingDependencyError('device: "cuda" is not there; use device="cpu"')

    engine.use(monkeypatch, no_device)
    ended = run("refine", bedroom, "-o", tmp_path / "out", "--device", "cuda", "--json")
    assert ended.code == 4 and ended.json["exit_code"] == 4
    assert_one_line(ended.err, "cuda")
    assert listing(tmp_path) == ["in", "in/scene.json"]


def test_a_missing_package_is_4(run, bedroom, tmp_path, monkeypatch):
    def no_package(scene, **options):
        raise ModuleNotFoundError("No module named 'scipy'", name="scipy")

    engine.use(monkeypatch, no_package)
    ended = run("refine", bedroom, "-o", tmp_path / "out")
    assert ended.code == 4
    assert_one_line(ended.err, "scipy", "pip install")


def test_an_interrupt_is_130_and_leaves_nothing(run, bedroom, tmp_path, monkeypatch):
    def interrupted(scene, **options):
        raise KeyboardInterrupt

    engine.use(monkeypatch, interrupted)
    ended = run("refine", bedroom, "-o", tmp_path / "new" / "out")
    assert ended.code == 130
    assert_one_line(ended.err, "interrupted")
    assert listing(tmp_path) == ["in", "in/scene.json"]


def test_an_interrupt_while_files_are_written_keeps_the_old_ones(run, bedroom, tmp_path, monkeypatch, calls):
    out = tmp_path / "out"
    assert run("refine", bedroom, "-o", out).code == 0
    before = (out / "scene.json").read_bytes()

    def interrupted(*args, **kwargs):
        raise KeyboardInterrupt

    monkeypatch.setattr("sceneweaver.render.save_top", interrupted)
    assert run("refine", bedroom, "-o", out, "--seed", 5).code == 130
    assert listing(out) == WRITTEN and (out / "scene.json").read_bytes() == before


@pytest.mark.parametrize("debug", [False, True])
def test_a_fault_of_the_program_is_1_with_a_hint(run, bedroom, tmp_path, monkeypatch, debug):
    def faulty(scene, **options):
        raise ZeroDivisionError("first line\nsecond line")

    engine.use(monkeypatch, faulty)
    if debug:
        monkeypatch.setenv("SCENEWEAVER_DEBUG", "1")
    else:
        monkeypatch.delenv("SCENEWEAVER_DEBUG", raising=False)
    ended = run("refine", bedroom, "-o", tmp_path / "out")
    assert ended.code == 1 and "ZeroDivisionError" in ended.err
    assert ("Traceback" in ended.err) is debug
    if not debug:
        assert_one_line(ended.err, "SCENEWEAVER_DEBUG=1", "first line second line")


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_can_be_refined(run, tmp_path, calls, name):
    Scene.example(name).save(tmp_path / "in.json")
    ended = run("refine", tmp_path / "in.json", "-o", tmp_path / "out", "--candidates", 4, "--json")
    assert ended.code == 0 and ended.json["valid"] is True


def test_without_a_terminal_there_is_no_progress(capfd):
    with output.progress_bar("refining", 10) as report:
        assert report is None
    assert capfd.readouterr() == ("", "")
