"""``sceneweaver problems``: what it prints, writes and ends with."""

from __future__ import annotations

import hashlib
import json

import numpy as np
import pytest

from sceneweaver import problems
from sceneweaver.cli import main
from sceneweaver.problems import store
from sceneweaver.scene import Scene
from sceneweaver.verify import check


def test_list_has_all_or_some(capsys):
    assert main(["problems", "list", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert tuple(row["name"] for row in data["problems"]) == problems.names()
    assert data["families"] == problems.families()
    assert main(["problems", "list", "--infeasible"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(problems.names(feasible=False))


def test_show_prints_the_card(capsys):
    assert main(["problems", "show", "packing/n005-t60"]) == 0
    assert capsys.readouterr().out.strip() == problems.load("packing/n005-t60").card.strip()
    assert main(["problems", "show", "infeasible/area-n010", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["certificate"]["kind"] == "area"


def test_export_writes_what_others_can_read(tmp_path, capsys):
    name = "packing/n005-t60"
    assert main(["problems", "export", name, "-o", str(tmp_path / "out"), "--json"]) == 0
    files = json.loads(capsys.readouterr().out)["files"]
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == sorted(f.rpartition("/")[2] for f in files)
    assert check(Scene.load(tmp_path / "out" / "witness.json")).valid
    assert not check(Scene.load(tmp_path / "out" / "scene.json")).valid
    data = (tmp_path / "out" / "problem.json").read_bytes().rstrip(b"\n")
    assert hashlib.sha256(data).hexdigest() == problems.load(name).hash
    assert main(["problems", "export", "infeasible/area-n010", "-o", str(tmp_path / "two")]) == 0
    assert not (tmp_path / "two" / "witness.json").exists()


def test_verify_says_how_many_are_in_order(capsys):
    assert main(["problems", "verify", "rooms/n014-t50-T"]) == 0
    assert capsys.readouterr().out == "1 of 1 problems are in order\n"


def test_verify_ends_with_3_when_a_problem_was_changed(capsys, monkeypatch, tmp_path):
    case = problems.generate("packing", 5, 0.5, 1)
    store.freeze([case], tmp_path)
    path = tmp_path / "manifest.json"
    path.write_text(path.read_text().replace(case.hash, "0" * 64))
    for cached in (store.manifest, store.measured, store._family, store.load):
        cached.cache_clear()
    monkeypatch.setattr(store, "DATA", tmp_path)
    try:
        assert main(["problems", "verify", "--json"]) == 3
        assert "the manifest says 000000000000" in json.loads(capsys.readouterr().out)["wrong"][case.name]
    finally:
        for cached in (store.manifest, store.measured, store._family, store.load):
            cached.cache_clear()


def test_a_zoo_is_written_and_read_back(monkeypatch, tmp_path):
    case = problems.generate("surfaces", 14, 0.4, 3)
    store.freeze([case], tmp_path)
    first = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    store.freeze([case], tmp_path)
    assert first == {path.name: path.read_bytes() for path in tmp_path.iterdir()}, "the same zoo in other bytes"
    row = json.loads((tmp_path / "manifest.json").read_text())["problems"][case.name]
    assert row["hash"] == case.hash and row["objects"] == 14
    assert np.isfinite(case.witness).all()


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["show", "packing/n005-t61"], "did you mean packing/n005-t60"),
        (["list", "--family", "boxes"], "family: 'boxes' is none of"),
        (["verify", "nothing"], "no problem 'nothing'"),
        (["export", "packing/n005-t60", "-o", "some.json"], "give a folder"),
    ],
)
def test_bad_input_ends_with_2_and_one_line(arguments, text, capsys):
    assert main(["problems", *arguments]) == 2
    said = capsys.readouterr().err.strip()
    assert text in said and "\n" not in said
