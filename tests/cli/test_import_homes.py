"""``sceneweaver import --home``: plans of other systems into files of homes."""

from __future__ import annotations

import json

import pytest

from sceneweaver.home import Home

PLAN = (
    '<svg xmlns="http://www.w3.org/2000/svg"{}><rect id="bedroom" width="400" height="300"/>'
    '<rect id="hall" x="410" width="200" height="300"/><line id="door" x1="405" y1="100" x2="405" y2="190"/></svg>'
)


@pytest.fixture
def plan(tmp_path):
    path = tmp_path / "plans" / "flat.svg"
    path.parent.mkdir()
    path.write_text(PLAN.format(""))
    return path


def test_one_home_into_a_file(run, plan, tmp_path):
    ended = run("import", plan, "--home", "--scale", "0.01", "-o", tmp_path / "home.json")
    assert ended.code == 0 and "svg, 2 rooms, 1 doors, 0 windows" in ended.out
    assert [room.type for room in Home.load(tmp_path / "home.json").rooms] == ["bedroom", "hallway"]


def test_repair_tells_what_moved_and_what_is_left(run, plan, tmp_path):
    ended = run("import", plan, "--home", "--repair", "--scale", "0.01", "-o", tmp_path / "home.json", "--json")
    (row,) = ended.json["homes"]
    assert ended.code == 0 and len(row["left"]) < len(row["before"])
    assert any(line.startswith("window window_of_bedroom_0: added") for line in row["moved"])
    assert Home.load(tmp_path / "home.json").entrances


def test_a_folder_tells_what_was_refused(run, plan, tmp_path):
    (plan.parent / "good.svg").write_text(PLAN.format(' data-scale="0.01"'))
    ended = run("import", plan.parent, "--home", "-o", tmp_path / "out")
    assert ended.code == 3 and "nothing says how large a unit is" in ended.err
    index = json.loads((tmp_path / "out" / "import.json").read_text())
    assert len(index["homes"]) == 1 and len(index["refused"]) == 1


def test_a_file_without_a_scale_is_one_line(run, plan, tmp_path):
    ended = run("import", plan, "--home", "-o", tmp_path / "home.json")
    assert ended.code == 2 and not (tmp_path / "home.json").exists()
    assert len(ended.err.strip().splitlines()) == 1 and "--scale" in ended.err
