"""``sceneweaver evaluate`` and ``sceneweaver compare``."""

from __future__ import annotations

import json

import pytest

from sceneweaver.scene import Scene
from tests.cli.test_bad_input import assert_one_line, listing

FILES = ["comparison.html", "comparison.json", "comparison.parquet", "scenes.jsonl"]


@pytest.fixture
def scenes(tmp_path):
    """Two folders of scenes, one with a collision."""
    study = Scene.example("study")
    a, b = [o.id for o in study.objects if o.mount == "floor"][:2]
    for name, scene in (("good", study), ("bad", study.replace_poses({a: study.object(b).pose}))):
        (tmp_path / "in" / name).mkdir(parents=True)
        scene.save(tmp_path / "in" / name / "one.json")
    return tmp_path / "in"


def test_two_systems(run, scenes, tmp_path):
    out = tmp_path / "out"
    ended = run("compare", scenes / "good", f"other={scenes / 'bad'}", "-o", out, "--no-stability", "--pictures", 1)
    assert (ended.code, ended.err) == (0, "") and listing(out) == FILES
    data = json.loads((out / "comparison.json").read_text())
    assert [s["name"] for s in data["systems"]] == ["good", "other"]
    assert [s["figures"]["penetrating_scenes"]["value"] for s in data["systems"]] == [0.0, 1.0]
    for text in ("#OB", "good", "other", "n = 1", str(out)):
        assert text in ended.out


def test_a_run_goes_on(run, scenes, tmp_path):
    out = tmp_path / "out"
    options = ("-o", out, "--no-stability", "--pictures", 0, "--json")
    first = run("compare", scenes / "good", scenes / "bad", *options).json
    assert len((out / "scenes.jsonl").read_text().split()) > 0
    rows = (out / "scenes.jsonl").read_text()
    second = run("compare", scenes / "good", scenes / "bad", *options).json
    assert (out / "scenes.jsonl").read_text().strip() == rows.strip() and first == second


def test_one_system(run, scenes, tmp_path):
    out = tmp_path / "out"
    ended = run("evaluate", scenes / "bad", "-o", out, "--no-stability", "--pictures", 0, "--json")
    assert ended.code == 0 and ended.json["systems"][0]["figures"]["collisions"]["value"] >= 1
    assert listing(out) == ["evaluation.html", "evaluation.json", "evaluation.parquet", "scenes.jsonl"]


def test_several_folders_of_one_system(run, scenes, tmp_path):
    options = ("-o", tmp_path / "out", "--no-stability", "--pictures", 0, "--json")
    (system,) = run("evaluate", scenes / "good", scenes / "bad", *options).json["systems"]
    assert system["name"] == "scenes" and system["scenes"] == 2
    assert system["figures"]["penetrating_scenes"]["value"] == 0.5


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["nowhere"], "nowhere"),
        (["{good}", "good={bad}"], "two systems"),
        (["{good}", "--from", "layoutgptt"], "--from"),
        (["{good}", "--from", "other=auto"], "other"),
        (["{good}", "--assets", "mine"], "--assets"),
        (["{good}", "--prompts", "{good}/one.json"], "one.json"),
        (["{good}", "--reference", "nowhere"], "reference"),
    ],
)
def test_bad_input(run, scenes, tmp_path, words, says):
    places = {"good": scenes / "good", "bad": scenes / "bad"}
    ended = run("compare", *(word.format(**places) for word in words), "-o", tmp_path / "out", "--no-stability")
    assert ended.code == 2
    assert_one_line(ended.err, says)


def test_out_is_a_file(run, scenes, tmp_path):
    (tmp_path / "out").write_text("")
    assert_one_line(run("compare", scenes / "good", "-o", tmp_path / "out").err, "out")


def test_too_little_time(run, scenes, tmp_path):
    ended = run("compare", scenes / "good", "-o", tmp_path / "out", "--no-stability", "--time-limit", 1e-3, "--json")
    assert ended.code == 5 and ended.json["systems"][0]["cut_off"]
