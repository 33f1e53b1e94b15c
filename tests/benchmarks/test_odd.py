"""Odd requests: the grammar, and that every way to end badly is seen."""

from __future__ import annotations

import json
import subprocess

import pytest

from benchmarks.families.odd import KEPT, Run, _error, _invalid, tabulate
from benchmarks.odd_requests import KINDS, odd_requests
from benchmarks.results import Result
from sceneweaver.scene import Pose, Scene


def test_equal_seeds_give_equal_requests_that_a_command_can_be_given():
    asked = odd_requests(15, seed=3)
    assert asked == odd_requests(15, seed=3) != odd_requests(15, seed=4)
    assert len(asked) == 15 * len(KINDS) == 300
    assert {kind for kind, _ in asked} == set(KINDS)
    assert all("\0" not in text and len(text.encode()) < 120_000 for _, text in asked)
    assert len({text for _, text in asked}) > 250


@pytest.fixture
def out(tmp_path):
    """A folder as a design leaves it."""
    for name in KEPT:
        (tmp_path / name).write_text("{}")
    Scene.example("bedroom").save(tmp_path / "scene.json")
    return tmp_path


def ended(code, files=(), err="", stdout=None):
    said = json.dumps({"files": [str(f) for f in files]}) if stdout is None else stdout
    return subprocess.CompletedProcess([], code, said, err)


def test_a_run_that_ended_well(out):
    for code in (0, 3):
        assert _error(ended(code, [out / "scene.json"], "step 1: ..."), out) == ""
    assert _error(ended(2, err="sceneweaver: prompt: it is empty", stdout='{"error": "x"}'), out) == ""
    assert _invalid(out / "scene.json") == ""


@pytest.mark.parametrize(
    ("code", "err", "stdout", "says"),
    [
        (1, "sceneweaver: unexpected KeyError: 'a'", "{}", "exit 1: sceneweaver: unexpected"),
        (-9, "", "", "exit -9"),
        (0, "Traceback (most recent call last):\nx", None, "exit 0: x"),
        (0, "", "valid", "no JSON on stdout"),
        (3, "", '{"undone": ["glb: unexpected KeyError: 1"], "files": []}', "exit 3: glb: unexpected KeyError"),
        (2, "one\ntwo", '{"error": "x"}', "refused in several lines"),
    ],
)
def test_a_run_that_ended_badly(out, code, err, stdout, says):
    assert says in _error(ended(code, err=err, stdout=stdout), out)


def test_files_that_are_missing_torn_empty_or_left_behind(out):
    (out / "scene.glb").touch()
    assert "scene.glb" in _error(ended(0, [out / "scene.glb"]), out)
    (out / ".sceneweaver-00.tmp").mkdir()
    assert ".sceneweaver-00.tmp" in _error(ended(0), out)
    (out / "metrics.json").write_text("{")
    assert "exit 0" in _error(ended(0), out)
    (out / "state.json").unlink()
    assert "exit 3" in _error(ended(3), out)


def test_a_scene_that_is_not_as_claimed(out):
    scene = Scene.load(out / "scene.json")
    scene.replace_poses({scene.objects[0].id: Pose.from_yaw(-9, -9, 0, 0)}).save(out / "scene.json")
    assert "oob" in _invalid(out / "scene.json")


def test_every_fault_is_counted_and_listed():
    runs = [
        Run("units", "a", 0, 5.0),
        Run("units", "b", 0, 6.0, invalid="collisions"),
        Run("crowds", "c", 1, 7.0, error="exit 1"),
        Run("crowds", "d", 3, 32.5),
    ]
    result = Result("odd", "", "")
    tabulate(result, runs)
    rows = {row["kind"]: row for row in result.table("odd").rows}
    assert set(rows) == {"units", "crowds", "all"}
    assert [rows["all"][key] for key in ("count", "errors", "overruns", "invalid", "satisfied")] == [4, 1, 1, 1, 2]
    assert rows["crowds"]["errors"] == rows["crowds"]["overruns"] == 1 and len(result.failures) == 3
