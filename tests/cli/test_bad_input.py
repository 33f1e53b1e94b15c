"""Bad input ends with exit code 2, one line on stderr that names what is wrong, and nothing written."""

from __future__ import annotations

import json
import math

import pytest

from sceneweaver.cli.output import LONGEST, complain
from tests.cli import engine


def _set(*path_and_value):
    *path, last, value = path_and_value

    def change(data):
        at = data
        for key in path:
            at = at[key]
        at[last] = value

    return change


def _circle_of_support(data):
    top = {"name": "top", "polygon": [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]], "z": 0.3, "headroom": None}
    first, second = data["objects"][0], data["objects"][1]
    for obj, other in ((first, second), (second, first)):
        obj["mount"] = "surface"
        obj["surfaces"] = [top]
        obj["support"] = {"object": other["id"], "surface": "top"}


def _clockwise(data):
    data["room"]["outline"].reverse()
    data["room"]["doors"] = data["room"]["windows"] = []


CHANGES = {
    "NaN position": (_set("objects", 0, "pose", "position", 0, math.nan), "position"),
    "infinite height": (_set("room", "height", math.inf), "height"),
    "negative size": (_set("objects", 0, "size", 1, -0.5), "size"),
    "zero size": (_set("objects", 0, "size", 2, 0), "size"),
    "self-crossing outline": (_set("room", "outline", [[0, 0], [4, 3], [4, 0], [0, 3]]), "outline"),
    "clockwise outline": (_clockwise, "clockwise"),
    "unknown id": (_set("relations", 0, "subject", "bedd"), "bedd"),
    "support cycle": (_circle_of_support, "support"),
    "unknown relation type": (_set("relations", 0, "type", "against_wal"), "against_wall"),
    "unknown key": (_set("relations", 0, "hart", True), "hard"),
    "unknown param": (_set("relations", 0, "params", {"gapp": [0, 1]}), "gap"),
    "newer schema": (_set("schema", "sceneweaver.scene/9"), "sceneweaver.scene/9"),
    "other schema": (_set("schema", "something else"), "schema"),
    "door beyond its wall": (_set("room", "doors", 0, "offset", 99.0), "door"),
}


@pytest.mark.parametrize("what", CHANGES)
@pytest.mark.parametrize("command", ["refine", "repair", "check"])
def test_a_wrong_scene(run, tmp_path, monkeypatch, command, what):
    calls = engine.use(monkeypatch, engine.keeps)
    change, named = CHANGES[what]
    data = engine.example_data()
    change(data)
    refuse(run, tmp_path, command, json.dumps(data), named)
    assert not calls


@pytest.mark.parametrize(
    ("content", "named"),
    [
        (json.dumps(engine.example_data())[:2000], "cut off"),
        ("", "empty"),
        ("{", "JSON"),
        ("[1, 2]", "scene"),
        ("null", "scene"),
        (b"\xff\xfe\x00rubbish", "UTF-8"),
        ("[" * 100_000, "nested"),
        ('{"schema": "sceneweaver.scene/1", "id": "x", "id": "y"}', "twice"),
    ],
    ids=["truncated", "empty", "brace", "list", "null", "binary", "deep", "key twice"],
)
def test_a_wrong_file(run, tmp_path, content, named):
    refuse(run, tmp_path, "check", content, named)


def refuse(run, folder, command, content, named):
    """Run a command on a file of this content and see it refused."""
    source = folder / "wrong.json"
    source.write_bytes(content if isinstance(content, bytes) else content.encode())
    before = listing(folder)
    outputs = {
        "refine": ["-o", folder / "out"],
        "repair": ["-o", folder / "out"],
        "check": ["--metrics", folder / "m.json", "--picture", folder / "p.png"],
    }
    ended = run(command, source, *outputs[command])
    assert ended.code == 2 and ended.out == ""
    assert_one_line(ended.err, "wrong.json", named)
    assert listing(folder) == before
    ended = run(command, source, "--json", *outputs[command])
    assert ended.code == 2
    assert_one_line(ended.err, named)
    assert ended.json["exit_code"] == 2 and named in ended.json["error"]
    assert listing(folder) == before


def assert_one_line(text, *named):
    assert text.endswith("\n") and text.count("\n") == 1 and text.startswith("sceneweaver: "), text
    assert "Traceback" not in text
    for name in named:
        assert name in text, text


def listing(folder):
    return sorted(str(p.relative_to(folder)) for p in folder.rglob("*"))


def test_a_file_of_100_mb_is_refused_without_reading_it(run, tmp_path):
    with open(tmp_path / "large.json", "wb") as file:
        file.truncate(100 * 2**20)
    ended = run("check", tmp_path / "large.json")
    assert ended.code == 2
    assert_one_line(ended.err, "large.json", "MB")


@pytest.mark.parametrize(
    "command", [("refine", "-o", "out"), ("repair", "-o", "out"), ("check",), ("render", "-o", "p.png")]
)
def test_a_missing_file_and_a_folder(run, tmp_path, monkeypatch, command):
    monkeypatch.chdir(tmp_path)
    for source, named in (("nowhere.json", "no such file"), (tmp_path, "folder")):
        ended = run(command[0], source, *command[1:])
        assert ended.code == 2
        assert_one_line(ended.err, named)
    assert listing(tmp_path) == []


@pytest.mark.parametrize(
    ("args", "named"),
    [
        (["refine", "IN"], "--out"),
        (["refine", "-o", "OUT"], "IN"),
        (["refine", "IN", "-o", "OUT", "--init", "ramdom"], "random"),
        (["refine", "IN", "-o", "OUT", "--optimizer", "sgd"], "search"),
        (["refine", "IN", "-o", "OUT", "--device", "tpu"], "cuda"),
        (["refine", "IN", "-o", "OUT", "--device", "cuda:-1"], "cuda"),
        (["refine", "IN", "-o", "OUT", "--candidates", "0"], "--candidates"),
        (["refine", "IN", "-o", "OUT", "--candidates", "many"], "--candidates"),
        (["refine", "IN", "-o", "OUT", "--seed", "-1"], "--seed"),
        (["refine", "IN", "-o", "OUT", "--time-limit", "0"], "--time-limit"),
        (["refine", "IN", "-o", "OUT", "--time-limit", "nan"], "--time-limit"),
        (["refine", "IN", "-o", "OUT", "--time-limit", "inf"], "--time-limit"),
        (["refine", "IN", "-o", "OUT", "--candidate", "5"], "--candidates"),
        (["repair", "IN"], "--out"),
        (["repair", "IN", "-o", "OUT", "--device", "tpu"], "cuda"),
        (["repair", "IN", "-o", "OUT", "--candidates", "0"], "--candidates"),
        (["repair", "IN", "-o", "OUT", "--time-limit", "-1"], "--time-limit"),
        (["repair", "IN", "-o", "OUT", "--no-relation"], "--no-relations"),
        (["check", "IN", "--picture", "OUT/p.gif"], ".png"),
        (["check", "IN", "--metrics", "OUT/m.json"], "folder"),
        (["check", "IN", "--meshes", "OUT"], "--meshes"),
        (["render", "IN", "-o", "OUT.jpg"], ".png"),
        (["render", "IN", "-o", "p.png", "--width", "5"], "--width"),
        (["demo", "--out", "out.json"], "folder"),
        (["demo", "--out", "OUT", "--seed", "-1"], "--seed"),
        (["design", "", "--out", "OUT"], "prompt"),
        (["design", "a bedroom"], "--out"),
        (["design", "a bedroom", "--out", "out.json"], "folder"),
        (["design", "a bedroom", "--out", "OUT", "--steps", "0"], "--steps"),
        (["design", "a bedroom", "--out", "OUT", "--planner", "oracle"], "--planner"),
        (["design", "a bedroom", "--out", "OUT", "--time-limit", "0"], "--time-limit"),
        (["refin", "IN"], "refin"),
        (["--nonsense"], "--nonsense"),
    ],
    ids=lambda v: " ".join(v) if isinstance(v, list) else None,
)
@pytest.mark.parametrize("as_json", [False, True], ids=["", "json"])
def test_wrong_options(run, bedroom, tmp_path, monkeypatch, args, named, as_json):
    calls = engine.use(monkeypatch, engine.keeps)
    monkeypatch.chdir(tmp_path)
    before = listing(tmp_path)
    args = [str(bedroom) if a == "IN" else a for a in args]
    ended = run(*args, *(["--json"] if as_json else []))
    assert ended.code == 2
    assert_one_line(ended.err, named)
    if as_json:
        assert named in ended.json["error"] and ended.json["exit_code"] == 2
    else:
        assert ended.out == ""
    assert listing(tmp_path) == before and not calls


@pytest.mark.parametrize(
    ("out", "named"),
    [
        ("file.txt", "file"),
        ("file.txt/deeper/out", "file"),
        ("folder.json", "folder"),
        ("clash", "folder"),
        ("/proc/nowhere/out", "cannot be written"),
    ],
)
@pytest.mark.parametrize("command", ["refine", "repair"])
def test_places_that_cannot_be_written_are_refused_before_the_work(
    run, bedroom, tmp_path, monkeypatch, command, out, named
):
    calls = engine.use(monkeypatch, engine.keeps)
    (tmp_path / "file.txt").write_text("mine")
    (tmp_path / "folder.json").mkdir()
    (tmp_path / "clash" / "scene.json").mkdir(parents=True)
    before = listing(tmp_path)
    ended = run(command, bedroom, "-o", tmp_path / out)
    assert ended.code == 2 and not calls
    assert_one_line(ended.err, named)
    assert listing(tmp_path) == before and (tmp_path / "file.txt").read_text() == "mine"


def test_a_folder_without_permission(run, bedroom, tmp_path, monkeypatch):
    """Root may write anywhere, so the refusal of the system is played."""
    calls = engine.use(monkeypatch, engine.keeps)

    def refused(*args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("os.mkdir", refused)
    ended = run("refine", bedroom, "-o", tmp_path / "out")
    assert ended.code == 2 and not calls
    assert_one_line(ended.err, "Permission denied")


def test_a_line_has_an_end_whatever_it_quotes(capsys) -> None:
    complain("x" * 5000)
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("sceneweaver: xxx") and len(line) == LONGEST
