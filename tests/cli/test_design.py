"""How ``design`` ends and what it prints: one exit code for each case, and every file that was written or left out."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from sceneweaver.agent.result import Result
from sceneweaver.cli.app import main
from sceneweaver.critic import CRITERIA, Review
from sceneweaver.language import SceneGraph
from sceneweaver.scene import Room, Scene
from sceneweaver.verify import check

FILES = ("report.html", "views/top.png", "scene.json", "scene.glb", "scene.sdf", "scene.urdf.json", "metrics.json")


@pytest.fixture(scope="module")
def whole() -> Result:
    scene = Scene(id="a", prompt="a", room=Room(type="study", outline=((0, 0), (3, 0), (3, 3), (0, 3))))
    report = check(scene)
    assert report.valid
    return Result(
        scene=scene,
        report=report,
        review=Review(grades=dict.fromkeys(CRITERIA, 7.0)),
        brief=SceneGraph(text="a"),
        steps=(),
        notes=(),
        unmet=(),
        seconds=1.0,
        finished="1 steps",
        files=FILES,
    )


INVALID, UNMET = {"valid": False}, {"unmet": ("a lamp",)}
LATE = {"undone": ("usd", "pictures"), "left_out": ("scene.usdc", "views/eye-door.png")}
STOPPED = {"undone": ("what would have come after SIGTERM",)}
BROKEN = {"undone": ("glb: unexpected ZeroDivisionError",), "broken": ("glb: unexpected ZeroDivisionError",)}

MATRIX = [
    ("whole", {}, 0),
    ("late", LATE, 5),
    ("stopped", STOPPED, 5),
    ("broken", BROKEN, 3),
    ("not valid", INVALID, 3),
    ("not valid and late", INVALID | LATE, 3),
    ("not valid and stopped", INVALID | STOPPED, 3),
    ("unmet", UNMET, 3),
    ("unmet and late", UNMET | LATE, 3),
    ("late and broken", {"undone": (*LATE["undone"], *BROKEN["undone"]), "broken": BROKEN["broken"]}, 3),
]


@pytest.mark.parametrize(("change", "code"), [row[1:] for row in MATRIX], ids=[row[0] for row in MATRIX])
@pytest.mark.parametrize("as_json", [False, True])
def test_the_exit_code_says_what_is_wrong_and_the_text_which_files_there_are(
    whole, tmp_path, monkeypatch, capsys, change, code, as_json
):
    change = dict(change)
    report = replace(whole.report, valid=change.pop("valid", True))
    result = replace(whole, report=report, **change)
    monkeypatch.setattr("sceneweaver.agent.design", lambda *_, **__: result)
    assert main(["design", "a study", "--out", str(tmp_path), *(["--json"] if as_json else [])]) == code
    out = capsys.readouterr().out
    files, missing = ([str(tmp_path / name) for name in names] for names in (result.files, result.left_out))
    if as_json:
        said = json.loads(out)
        assert said["exit_code"] == code and said["files"] == files and said["left_out"] == missing
    else:
        lines = [line.strip() for line in out.splitlines()]
        assert [line for line in lines if line in files] == files
        assert [line for line in lines if line.startswith("left out")] == [f"left out for time: {m}" for m in missing]
