"""``sceneweaver check``, ``render`` and ``examples``, with the real judge."""

from __future__ import annotations

import json

import pytest
from PIL import Image

from sceneweaver.scene import EXAMPLES, Scene
from sceneweaver.verify import check
from tests.cli.engine import moved
from tests.cli.test_bad_input import listing


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_are_valid_as_they_ship(name):
    scene = Scene.example(name)
    report = check(scene)
    assert report.valid and not report.violations
    assert scene.id == name and len(scene.objects) >= 12 and len(scene.relations) >= 15 and scene.prompt


def test_examples_are_listed_with_their_files(run):
    assert {"bedroom", "study", "living-room"} <= set(EXAMPLES)
    rows = run("examples", "--json").json["examples"]
    assert [r["name"] for r in rows] == list(EXAMPLES)
    for row in rows:
        assert Scene.load(row["path"]).id == row["name"]
    shown = run("examples")
    assert shown.code == 0 and all(r["path"] in shown.out for r in rows)


def test_a_valid_scene_is_0(run, bedroom):
    ended = run("check", bedroom)
    assert (ended.code, ended.err) == (0, "")
    assert ended.out.startswith("valid  bedroom") and "hard relations hold" in ended.out and "walkable" in ended.out


def test_json_is_the_report(run, bedroom):
    ended = run("check", bedroom, "--json")
    assert (ended.code, ended.err) == (0, "")
    data = ended.json
    assert data["schema"] == "sceneweaver.metrics/1" and data["valid"] is True and data["placed"] == 16


def test_the_floor_is_judged_for_a_robot_of_some_radius(run, bedroom):
    usual, wide = run("check", bedroom, "--json").json, run("check", bedroom, "--json", "--robot-radius", "0.4").json
    assert wide["walkable_share"] < usual["walkable_share"] and wide["robot_radius"] == 0.4
    assert "for a robot of radius 0.4 m" in run("check", bedroom, "--robot-radius", "0.4").out
    ended = run("check", bedroom, "--robot-radius", "0")
    assert ended.code == 2 and "robot_radius is 0.0; give metres, 0.01 to 5" in ended.err


def test_a_scene_that_is_not_valid_is_3_and_says_why(run, bedroom, tmp_path):
    moved(Scene.load(bedroom)).save(bedroom)
    before = bedroom.read_bytes()
    ended = run("check", bedroom, "--metrics", tmp_path / "m.json", "--picture", tmp_path / "p.png")
    assert ended.code == 3 and ended.err == ""
    assert ended.out.startswith("not valid") and "bed reaches" in ended.out
    data = json.loads((tmp_path / "m.json").read_text())
    assert data["valid"] is False and data["out_of_bounds"] == 1
    with Image.open(tmp_path / "p.png") as image:
        assert any(r > 190 and g < 90 and b < 90 for _, (r, g, b) in image.getcolors(2**24))
    assert bedroom.read_bytes() == before
    assert listing(tmp_path) == ["in", "in/scene.json", "m.json", "p.png"]


def test_a_long_list_of_violations_is_cut_on_a_terminal_only(run, bedroom):
    scene = Scene.load(bedroom)
    gone = {o.id: o.pose.model_copy(update={"position": (-9.0 - k, 0.0, 0.7)}) for k, o in enumerate(scene.objects)}
    scene.replace_poses(gone).save(bedroom)
    ended = run("check", bedroom)
    assert ended.code == 3 and "more" in ended.out.splitlines()[-2] and len(ended.out.splitlines()) < 30
    assert len(run("check", bedroom, "--json").json["violations"]) > 20


def test_render_writes_views_and_data_passes(run, bedroom, tmp_path):
    ended = run("render", bedroom, "-o", tmp_path / "v.png", "--view", "corner", "--width", "200")
    assert (ended.code, ended.err) == (0, "")
    with Image.open(tmp_path / "v.png") as image:
        assert image.size == (200, 150)
    (tmp_path / "cameras.json").write_text('[{"name": "mine", "eye": [1, 1, 1.5], "target": [2, 2, 1]}]')
    options = ("--passes", "depth, instance", "--cameras", tmp_path / "cameras.json", "--width", "200")
    ended = run("render", bedroom, "-o", tmp_path / "p", *options, "--json")
    names = {"mine_depth.png", "mine_distance.png", "mine_instance.png", "cameras.json", "labels.json"}
    assert ended.code == 0 and {path.rpartition("/")[2] for path in ended.json["files"]} == names
    assert {path.name for path in (tmp_path / "p").iterdir()} == names


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--passes", "dept"), "passes: 'dept' is unknown"),
        (("--passes", ""), "passes: none is named"),
        (("--passes", "depth", "--cameras", "none.json"), "--cameras: none.json: no such file"),
        (("--passes", "depth", "--format", "tiff"), "format: 'tiff' is unknown"),
        (("--view", "eye"), "view: 'eye' is unknown"),
    ],
)
def test_what_render_cannot_do_is_one_line(run, bedroom, tmp_path, options, words):
    ended = run("render", bedroom, "-o", tmp_path / "p.png", *options, "--width", "200")
    assert ended.code == 2 and words in ended.err and ended.err.count("\n") == 1


@pytest.mark.parametrize("options", [[], ["--plain"], ["--width", "400"]])
def test_render_writes_a_picture(run, bedroom, tmp_path, options):
    ended = run("render", bedroom, "-o", tmp_path / "p.png", *options)
    assert (ended.code, ended.err) == (0, "") and ended.out.strip() == str(tmp_path / "p.png")
    with Image.open(tmp_path / "p.png") as image:
        assert image.width == (400 if "--width" in options else 1600)
    assert run("render", bedroom, "-o", tmp_path / "p.png", *options, "--json").json["exit_code"] == 0
