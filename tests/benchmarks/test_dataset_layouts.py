"""The benchmark of layouts counts and judges what lies in files."""

from __future__ import annotations

import json
import shutil

import numpy as np
import pytest

from benchmarks import dataset_layouts
from benchmarks.layout_rows import Written, different_rows, examine
from sceneweaver.datasets.layouts.tables import Writers, schema
from sceneweaver.scene import Scene
from tests.test_repository import ROOT

ZOO = ROOT / "tests" / "zoo"
ROOM = Scene.load(ZOO / "children-twin.json")


def poses_of(scene: Scene) -> np.ndarray:
    return np.array([(*o.pose.position, o.pose.yaw) for o in scene.objects], dtype=np.float32)


def test_rows_are_counted_and_judged(tmp_path):
    floor = next(k for k, o in enumerate(ROOM.objects) if o.mount == "floor" and not o.fixed)
    poses = np.repeat(poses_of(ROOM)[None], 3, axis=0)  # a layout, the same again, and one with a thing outside
    poses[2, floor, 0] += 30.0
    columns = {
        "layout": np.arange(3, dtype=np.int32),
        "poses": poses,
        "energy": np.zeros(3, dtype=np.float32),
        "soft": np.ones(3, dtype=np.float32),
        "signature": np.array([7, 7, 8]),
        "near_duplicate_group": np.array([1, 1, 2]),
    }
    with Writers(tmp_path, schema(20)) as writers:
        for program in (1, 5):  # of one file
            writers.add(program, columns | {"program": np.full(3, program, dtype=np.int32)})
    found = examine(Written(5, ROOM.dumps(), writers.path(5), 3, 3))
    assert (found.rows, found.signatures, found.distinct, found.groups, found.judged) == (3, 2, 2, 2, 3)
    assert len(found.wrong) == 1 and ROOM.objects[floor].id in found.wrong[0]
    assert examine(Written(9, ROOM.dumps(), writers.path(9), 0, 3)).rows == 0


def test_different_rows_are_those_of_numpy():
    rows = np.random.default_rng(0).integers(-1, 2, (200, 4))
    assert different_rows(rows) == len(np.unique(rows, axis=0)) < len(rows)


def test_programs_are_saved_and_taken_from_files_once(tmp_path, capsys):
    given, saved, figures = tmp_path / "given", tmp_path / "saved", tmp_path / "figures.json"
    given.mkdir()
    for name in ("a.json", "b.json"):
        shutil.copy(ZOO / "children-twin.json", given / name)
    shutil.copy(ZOO / "studio-U.json", given / "c.json")
    words = ["--scenes", given, "--save", saved, "--json", figures, "--seconds", "0", "--candidates", "4"]
    assert dataset_layouts.main([str(word) for word in [*words, "--device", "cpu"]]) == 0
    found = json.loads(figures.read_text())
    assert (found["programs"], found["drawn"], found["objects"]) == (2, False, [15, 19.5, 24])
    assert [Scene.load(path).ids for path in sorted(saved.iterdir())] == [
        ROOM.ids,
        Scene.load(ZOO / "studio-U.json").ids,
    ]
    assert "1 like others" in capsys.readouterr().out


@pytest.mark.parametrize("number", [0, 1])
def test_the_specification_takes_kinds_or_scenes(number):
    spec = dataset_layouts.spec_of(3, 4, 0, [None, ["a.json"]][number])
    assert (spec.requests.scenes, bool(spec.requests.kinds)) == ([None, ("a.json",)][number], not number)
