"""From requests to scenes."""

from __future__ import annotations

import json
from dataclasses import replace
from importlib import import_module

import pytest

from sceneweaver import check
from sceneweaver.assets import Library
from sceneweaver.datasets import AssetStore, Requests, Sample, Spec
from sceneweaver.datasets.produce import produce
from sceneweaver.datasets.produce.drafts import drafted
from sceneweaver.datasets.produce.layouts import alike, chosen, laid_out
from sceneweaver.scene import Pose, Scene

SHELF = "a store room with one shelf"


def spec(*prompts: str, **fields) -> Spec:
    return Spec.model_validate(
        {
            "schema": "sceneweaver.dataset/1",
            "name": "test",
            "count": len(prompts),
            "requests": {"prompts": prompts},
            "exports": (),
            **fields,
        }
    )


def made(wanted: Spec, rooms, tmp_path) -> list[Sample]:
    requests = Requests(wanted)
    return list(produce(wanted, [requests[room] for room in rooms], AssetStore(tmp_path), "cpu"))


def content(sample: Sample):
    return sample.key, sample.status, sample.row, sample.files


def test_scenes_do_not_depend_on_their_neighbours_order_or_history(tmp_path):
    wanted = spec(SHELF, SHELF, rooms={"candidates": 12})
    forwards = [content(s) for s in made(wanted, [0, 1], tmp_path)]
    assert [content(s) for s in made(wanted, [1, 0], tmp_path)] == forwards[::-1]
    assert [content(s) for s in made(wanted, [1], tmp_path)] == forwards[1:]


@pytest.mark.slow
def test_furnished_rooms_do_not_depend_on_their_neighbours_order_or_history(tmp_path):
    wanted = spec(
        "a bedroom", "a kitchen", "a bathroom", "an office", rooms={"candidates": 12}, exports=("glb", "mjcf")
    )
    forwards = [content(s) for s in made(wanted, [0, 1, 2, 3], tmp_path)]
    assert [content(s) for s in made(wanted, [3, 1, 2, 0], tmp_path)] == [forwards[k] for k in (3, 1, 2, 0)]
    for room in (2, 1):
        assert [content(s) for s in made(wanted, [room], tmp_path)] == [forwards[room]]


def test_a_sample_holds_a_valid_scene_and_its_measures(tmp_path):
    (sample,) = made(spec(SHELF), [0], tmp_path)
    scene = Scene.loads(sample.files["scene.json"])
    report = check(scene)
    assert sample.status == "ok" and report.valid
    assert sample.row["collisions"] == 0 and sample.row["out_of_bounds"] == 0
    assert sample.row["object_count"] == len(scene.objects)
    assert json.loads(sample.files["metrics.json"])["valid"] is True


def test_what_says_nothing_is_a_failed_row_and_its_neighbours_are_made(tmp_path):
    bad, good = made(spec("", SHELF), [0, 1], tmp_path)
    assert (bad.status, good.status) == ("failed", "ok")
    assert "\n" not in bad.row["reason"] and bad.files == {}


def test_a_scene_that_takes_too_long_is_a_failed_row(tmp_path):
    (sample,) = made(spec(SHELF, time_limit=1e-3), [0], tmp_path)
    assert sample.status == "failed"
    assert sample.row["reason"] == "time limit"


def test_a_gate_that_nothing_passes_leaves_a_rejected_row(tmp_path):
    (sample,) = made(spec(SHELF, gates={"grade": 10.0}, rooms={"attempts": 1}), [0], tmp_path)
    assert sample.status == "rejected" and sample.files == {}
    assert sample.row["gates"] == {"valid": True, "grade": False}
    assert sample.row["reason"] == "gate: grade"


def test_a_full_disk_is_no_fault_of_a_scene(tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(import_module("sceneweaver.datasets.produce.scenes"), "files_of", full)
    with pytest.raises(OSError, match="No space"):
        made(spec(SHELF), [0], tmp_path)


def test_layouts_of_a_room_differ_in_more_than_small_things():
    wanted = spec("a store room with a desk and a wardrobe", count=3, rooms={"layouts": 3, "candidates": 16})
    request = Requests(wanted)[0]
    draft = drafted(wanted, request, request.attempt(0), Library(), "cpu")
    kept = [outcome.scene for outcome in chosen(draft, laid_out([draft], "cpu")[0], 3)]
    assert len(kept) == 3
    assert alike(kept[0], kept[0])
    assert not any(alike(kept[a], kept[b]) for a, b in ((0, 1), (0, 2), (1, 2)))
    desk = kept[0].object("desk-0").pose
    beside = Pose.from_yaw(desk.position[0] + 0.1, desk.position[1], 0.0, desk.yaw)
    assert alike(kept[0], kept[0].replace_poses({"desk-0": beside}))


def test_a_room_that_holds_nothing_and_that_there_is_no_other_of_has_no_layouts():
    wanted = spec("a bathroom of 2 by 2 m with a bathtub, a shower, a toilet and a sink", rooms={"candidates": 1})
    draft = drafted(wanted, Requests(wanted)[0], 3, Library(), "cpu")
    alone = replace(draft, proposal=replace(draft.proposal, rooms=(), larger=()))
    assert laid_out([alone], "cpu") == [[]]
