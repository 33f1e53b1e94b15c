"""``sceneweaver import``: files of other systems into scene files."""

from __future__ import annotations

import json

import pytest

from sceneweaver.scene import Scene

PROMPT = "Room Type: bedroom\nRoom Size: max length 256px, max width 200px"
BED = {"length": 120, "width": 90, "height": 40, "left": 90, "top": 60, "depth": 20, "orientation": 90}


def layout(name: str) -> dict:
    return {"query_id": name, "prompt": PROMPT, "object_list": [["double_bed", BED]]}


@pytest.fixture
def two(tmp_path):
    path = tmp_path / "in" / "two.json"
    path.parent.mkdir()
    path.write_text(json.dumps([layout("a"), layout("b")]))
    return path


def test_a_folder_has_a_file_a_scene_and_an_index(run, two, tmp_path):
    ended = run("import", two, "-o", tmp_path / "out", "--json")
    assert ended.code == 0
    index = json.loads((tmp_path / "out" / "import.json").read_text())
    assert [row["room"] for row in index["scenes"]] == ["a", "b"] and ended.json["scenes"] == index["scenes"]
    for row in index["scenes"]:
        scene = Scene.load(row["file"])
        assert scene.objects[0].category == "bed" and scene.provenance["imported"]["format"] == "layoutgpt"
        assert row["sizes_from"] == {"file": 1} and row["confidence"] > 0.9


def test_one_room_goes_into_a_file_wherever_it_is(run, two, tmp_path):
    ended = run("import", two, "-o", tmp_path / "new" / "b.json", "--room", "b")
    assert ended.code == 0 and "layoutgpt, 1 objects" in ended.out
    assert Scene.load(tmp_path / "new" / "b.json").objects[0].id.startswith("double_bed")


@pytest.mark.parametrize(
    "arguments, named",
    [
        (["--room", "c"], "--room"),
        (["--from", "layoutgtp"], "layoutgpt"),
        (["--assets", "mine"], "assets"),
        (["--sizes", "gone.json"], "gone.json"),
        ([], "several scenes"),
    ],
)
def test_what_is_wrong_is_one_line_and_nothing_is_written(run, two, tmp_path, arguments, named):
    ended = run("import", two, "-o", tmp_path / "out.json", *arguments)
    assert ended.code == 2 and ended.err.count("\n") == 1 and named in ended.err
    assert not (tmp_path / "out.json").exists()


def test_what_is_broken_in_a_folder_is_told_and_the_rest_goes_on(run, two, tmp_path):
    (two.parent / "broken.json").write_text(two.read_text()[:-40])
    ended = run("import", two.parent, "--from", "layoutgpt", "-o", tmp_path / "out", "--assets", "boxes")
    assert ended.code == 3 and "broken.json" in ended.err and "2 scenes imported, 1 files or rooms refused" in ended.out


def test_sizes_of_a_table_are_taken_where_a_file_has_none(run, tmp_path):
    file = tmp_path / "scene.json"
    matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1.5, 1.2, 0, 1]
    state = {
        "format": "sceneState",
        "scene": {
            "up": [0, 0, 1],
            "front": [0, 1, 0],
            "unit": 1,
            "object": [{"id": "0", "modelId": "x.chest", "index": 0, "transform": {"data": matrix}}],
            "arch": {
                "elements": [
                    {"id": "f", "type": "Floor", "roomId": "r", "points": [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]}
                ]
            },
        },
    }
    file.write_text(json.dumps(state))
    table = tmp_path / "sizes.csv"
    table.write_text("name,depth,width,height\nx.chest,0.5,1.1,0.9\n")
    ended = run("import", file, "-o", tmp_path / "out" / "r.json", "--sizes", table, "--json")
    assert ended.code == 0 and ended.json["scenes"][0]["sizes_from"] == {"table": 1}
    assert Scene.load(tmp_path / "out" / "r.json").objects[0].size == (0.5, 1.1, 0.9)
