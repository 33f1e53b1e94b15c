"""``sceneweaver design`` that begins with a scene of somebody else."""

from __future__ import annotations

import json

from sceneweaver.scene import Scene
from tests.agent.test_starting import SMALL, store

QUICK = ("--device", "cpu", "--candidates", 8, "--seed", 1, "--steps", 1, "--no-pictures", "--export", "none")


def test_going_on_from_a_file_tells_what_was_changed(run, tmp_path):
    file, out = tmp_path / "theirs.json", tmp_path / "out"
    store().save(file)
    done = run("design", "--start", file, "--out", out, *QUICK)  # the request is that of the file
    assert done.code in (0, 3) and "  start   " in done.out and "of 2 objects stand where they stood" in done.out
    assert Scene.load(out / "scene.json").prompt == SMALL
    told = run("design", "--start", file, "--out", tmp_path / "other", *QUICK, "--json")
    data = json.loads(told.out)
    assert data["start"]["objects"] == 2 and data["metrics"]["start"] == data["start"]


def test_a_folder_and_a_model_by_name(run, tmp_path, monkeypatch):
    (tmp_path / "theirs").mkdir()
    store().save(tmp_path / "theirs" / "one.json")
    (tmp_path / "their_model.py").write_text(
        "class Bad:\n    def generate(self, request):\n        raise ValueError('no')\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    given = {"scenes": tmp_path / "theirs", "scene-model": "their_model:Bad"}
    for name, value in given.items():
        data = json.loads(run("design", SMALL, f"--{name}", value, "--out", tmp_path / name, *QUICK, "--json").out)
        used = data["steps"][0]["call"]["tool"]
        assert used == ("init_library" if name == "scenes" else "init_prior") and data["valid"]
    assert any("it failed: ValueError: no" in note for note in data["notes"])


def test_what_is_wrong_is_one_line(run, tmp_path):
    (tmp_path / "cut.json").write_text('{"schema": "sceneweaver.scene/1", "room"')
    for more, line in (
        (("--start", tmp_path / "nothing.json"), "is not there"),
        (("--start", tmp_path / "cut.json"), "cut.json"),
        (("--init", "model"), "needs scene_model"),
        (("--init", "prior", "--scenes", tmp_path), "does not go with"),
        (("--start", tmp_path / "cut.json", "--from", "nowhere"), "nowhere"),
    ):
        done = run("design", SMALL, *more, "--out", tmp_path / "out", *QUICK)
        assert done.code == 2 and line in done.err and len(done.err.strip().splitlines()) == 1, done.err
    assert not (tmp_path / "out").exists()
