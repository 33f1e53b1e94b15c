"""Scenes of any origin judged alike: what is missing is said, runs go on, one bad scene spoils nothing."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

import sceneweaver as sw
from sceneweaver.evaluation import METRICS, Candidate, SceneRow, candidates, compare, evaluate, judge_scene
from sceneweaver.evaluation.candidate import Reading
from sceneweaver.evaluation.files import ROWS, add_row, read_known, row_file, table_rows, write_comparison
from sceneweaver.evaluation.summary import summed
from sceneweaver.evaluation.work import Task, rows_of
from sceneweaver.io import InputError, open_parquet
from sceneweaver.runtime.deadline import NEVER, Deadline
from sceneweaver.scene import Pose, Scene

STUDY = Scene.example("study")
BEDROOM = Scene.example("bedroom")
BROKEN = BEDROOM.replace_poses({"wardrobe": BEDROOM.object("bed").pose})


def imported(
    scene: Scene, *, sizes: str = "file", boundary: str = "file", openings: bool = True, sure: float = 1.0
) -> Scene:
    """A scene as the importers leave it, with what its file is said to hold."""
    told = {name: {"size_from": sizes, "label": "x", "confidence": sure} for name in scene.ids}
    room = scene.room if openings else scene.room.model_copy(update={"doors": (), "windows": ()})
    provenance = {"imported": {"format": "layoutgpt", "boundary": boundary, "objects": told}}
    return scene.model_copy(update={"provenance": provenance, "room": room, "relations": (), "free_areas": ()})


def test_every_metric_has_a_value_or_a_reason():
    found = compare({"a": [BEDROOM, STUDY], "b": imported(STUDY)}, stability=False)
    for system in found.systems:
        assert set(system.figures) == {metric.key for metric in METRICS}
        assert all((f.value is None) == bool(f.missing) for f in system.figures.values())
    assert all(metric.definition and metric.source for metric in METRICS)


def test_what_the_judge_counts():
    figures = evaluate([BEDROOM, BROKEN], stability=False).figures
    report = sw.check(BROKEN)
    assert figures["collisions"].value == report.collisions / 2
    assert figures["clean_scenes"].value == 0.5 and figures["penetrating_scenes"].value == 0.5
    involved = {name for v in report.violations if v.kind == "collision" for name in v.objects}
    assert figures["penetrating_objects"].value == pytest.approx(len(involved) / (2 * len(BEDROOM.objects)))
    deepest = max(v.amount for v in report.violations if v.kind == "collision")
    assert figures["depth_most"].value == pytest.approx(1e3 * deepest)


@pytest.mark.parametrize(
    ("change", "gone", "stays"),
    [
        ({"sizes": "category"}, ("collisions", "out_of_bounds", "supported_objects", "sizes_usual"), ("objects",)),
        ({"boundary": "objects"}, ("out_of_bounds", "navigability", "openings_clear"), ("collisions", "sizes_usual")),
        ({"sure": 0.0}, ("category_diversity", "sizes_usual", "accessibility"), ("collisions", "objects")),
        ({"openings": False}, ("openings_clear", "openings_covered"), ("navigability", "collisions")),
    ],
)
def test_what_a_file_does_not_say_is_no_zero(change, gone, stays):
    found = evaluate(imported(STUDY, **change), stability=False)
    for key in gone:
        assert found.figures[key].value is None and "not in the files" in found.figures[key].missing
    assert all(found.figures[key].value is not None for key in stays)
    assert any("not in the files" in reason for reason in found.lacks)


def test_assumed_sizes_are_marked():
    scene = imported(STUDY, sizes="category")
    found = evaluate(scene, stability=False, reading=Reading(assume_sizes=True))
    figure = found.figures["collisions"]
    assert figure.value == 0.0 and figure.assumed and figure.text(METRICS[2]).startswith("~ ")
    assert found.figures["sizes_usual"].value is None
    assert not found.figures["objects"].assumed
    bare = evaluate(imported(STUDY, sizes="category", openings=False), stability=False)
    assert {"sizes are not in the files", "doors and windows are not in the files"} <= set(bare.lacks)
    unnamed = evaluate(imported(STUDY, sizes="category", sure=0.0), stability=False, reading=Reading(assume_sizes=True))
    assert unnamed.figures["collisions"].value is None, "what is not known has no usual size"


def test_stability():
    lifted = next(o for o in STUDY.objects if o.mount == "floor" and o.size[2] > 0.5)
    x, y, _ = lifted.pose.position
    thrown = STUDY.replace_poses({lifted.id: Pose.from_yaw(x, y, 0.5, lifted.pose.yaw)})
    stays, falls = (evaluate(one).figures["stable_objects"].value for one in (STUDY, thrown))
    assert stays == 1.0 and falls < 1.0


def test_reference(tmp_path):
    BEDROOM.save(tmp_path / "one.json")
    named = compare({"a": BEDROOM, "b": STUDY}, reference="a", stability=False)
    by_path = compare({"a": BEDROOM, "b": STUDY}, reference=str(tmp_path), stability=False)
    for found in (named, by_path):
        assert found.system("a").figures["category_kl"].value == pytest.approx(0.0, abs=1e-9)
        assert found.system("b").figures["category_kl"].value > 1.0
    with pytest.raises(InputError, match="reference"):
        compare({"a": BEDROOM}, reference="nowhere", stability=False)


def test_sources(tmp_path):
    (tmp_path / "one").mkdir()
    BEDROOM.save(tmp_path / "one" / "scene.json")
    (tmp_path / "one" / "metrics.json").write_text("{}")
    (tmp_path / "one" / "steps" / "1").mkdir(parents=True)
    BEDROOM.save(tmp_path / "one" / "steps" / "1" / "scene.json")
    STUDY.save(tmp_path / "study.json")
    assert [c.name for c in candidates(tmp_path)] == ["study", "one"]
    assert [c.name for c in candidates([tmp_path / "study.json", BEDROOM])] == ["study", BEDROOM.id]
    with pytest.raises(InputError, match="no such"):
        list(candidates(tmp_path / "nothing"))
    with pytest.raises(InputError, match="no scene"):
        list(candidates([3]))


def test_a_broken_file_is_told_and_passed_over(tmp_path):
    STUDY.save(tmp_path / "a.json")
    (tmp_path / "b.json").write_text('{"schema": "sceneweaver.scene/1", "room": 3}')
    found = evaluate(tmp_path, stability=False)
    assert found.judged == 1 and len(found.refused) == 1 and "b.json" in found.refused[0]


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"jobs": 0}, "jobs"),
        ({"limit": 0}, "limit"),
        ({"scene_limit": 0.0}, "scene_limit"),
        ({"time_limit": float("nan")}, "time_limit"),
    ],
)
def test_options_out_of_range(options, says):
    with pytest.raises(InputError, match=says):
        compare({"a": BEDROOM}, **options)


def test_no_system():
    with pytest.raises(InputError, match="systems"):
        compare({})


def test_a_scene_that_takes_too_long_is_a_row_of_its_own():
    found = evaluate([STUDY, BEDROOM], scene_limit=1e-9, stability=False)
    assert found.judged == 0 and all("not enough" in row.error for row in found.failed)
    assert found.figures["objects"].missing == "no scene was judged"


def test_time_that_is_up_cuts_off():
    found = compare({"a": [STUDY, BEDROOM]}, deadline=Deadline(0.0), stability=False)
    assert found.cut_off and not found.systems[0].rows


def test_rows_are_taken_again_where_nothing_changed():
    made: list[SceneRow] = []
    first = compare({"a": [STUDY, BEDROOM]}, stability=False, on_row=made.append)
    known = {row.key: row for row in made}
    again: list[SceneRow] = []
    second = compare({"a": [STUDY, BROKEN]}, stability=False, on_row=again.append, known=known)
    assert len(made) == 2 and [row.scene for row in again] == [BROKEN.id]
    assert second.systems[0].rows[0] == first.systems[0].rows[0]


def test_several_processes_give_the_same():
    scenes = [STUDY, BEDROOM, BROKEN]
    one, two = (compare({"a": scenes}, jobs=jobs, stability=False) for jobs in (1, 2))
    strip = [[replace(row, seconds=0.0) for row in found.systems[0].rows] for found in (one, two)]
    assert strip[0] == strip[1] and one.systems[0].figures == two.systems[0].figures


def _dies(task: Task, text: str) -> SceneRow:
    import os

    if task.candidate.name == "bad":
        os._exit(3)
    from sceneweaver.evaluation.work import _judged

    return _judged(task, text)


@pytest.mark.slow
def test_a_process_that_dies_costs_one_scene(monkeypatch):
    from sceneweaver.evaluation import work

    monkeypatch.setattr(work, "_judged", _dies)
    tasks = [Task("a", Candidate(STUDY, name), False, None, 60.0, name) for name in ("one", "bad", "two")]
    rows = {row.scene: row for row in rows_of(tasks, 2, NEVER)}
    assert set(rows) == {"one", "bad", "two"} and "died" in rows["bad"].error
    assert not rows["one"].error and not rows["two"].error


def test_the_files(tmp_path):
    found = compare({"<b>a</b>": [STUDY, BROKEN], "b": imported(STUDY, sizes="category")}, stability=False, pictures=1)
    paths = write_comparison(found, tmp_path, "comparison")
    assert [path.name for path in paths] == ["comparison.json", "comparison.parquet", "comparison.html"]
    data = json.loads(paths[0].read_text())
    assert data["schema"] == "sceneweaver.comparison/1" and data["systems"][0]["scenes"] == 2
    assert data["systems"][1]["figures"]["collisions"]["value"] is None
    with open_parquet(paths[1]) as table:
        rows = table.read().to_pylist()
    assert len(rows) == 3 and rows[1]["collisions"] >= 1.0 and rows[2]["collisions"] is None
    assert {m["figure"] for m in rows[2]["missing"]} > {"collisions"} and rows == list(table_rows(found))
    page = paths[2].read_text()
    assert "<b>a</b>" not in page and "&lt;b&gt;a" in page
    assert all(metric.title in page for metric in METRICS) and "data:image/jpeg" in page
    assert "sizes are not in the files" in page and "<script" not in page


def test_rows_of_a_run_that_was_killed(tmp_path):
    row = judge_scene("a", next(candidates(STUDY)), simulate=False, key="k")
    with row_file(tmp_path) as file:
        add_row(file, row)
    with open(tmp_path / ROWS, "ab") as file:
        file.write(b'{"system": "a", "sce')
    assert read_known(tmp_path) == {"k": row}
    with row_file(tmp_path) as file:
        add_row(file, replace(row, key="l"))
    assert set(read_known(tmp_path)) == {"k", "l"}


def test_the_table():
    found = compare({"a": STUDY, "b": imported(STUDY, sizes="category")}, stability=False)
    lines = found.table().splitlines()
    assert len(lines) == 2 + len(METRICS) and "| a (n = 1) | b (n = 1) |" in lines[0]
    assert "not in the files" in next(line for line in lines if line.startswith("| #CN"))


def test_no_rows():
    found = summed("a", [])
    assert all(f.value is None and f.missing for f in found.figures.values())
