"""The pool of judges, and the audit of what the engine calls valid."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.audit import audit, spread
from benchmarks.judging import Judge, opinion, place, share
from benchmarks.results import Result
from benchmarks.rooms import load, witness
from sceneweaver.layout import refine
from sceneweaver.scene import Scene


@pytest.fixture(scope="module")
def solution():
    return refine(load("bedroom-small"), candidates=4, seed=0, device="cpu")


def test_layouts_are_judged_as_the_solution_gives_them(solution):
    for k in range(len(solution.status)):
        assert place(solution.source, solution.poses[k]) == solution.scene(k)


def test_fixed_objects_stay():
    scene = load("bedroom-small")
    first = scene.objects[0].model_copy(update={"fixed": True})
    scene = scene.model_copy(update={"objects": (first, *scene.objects[1:])})
    moved = place(scene, witness(scene) + (1.0, 0.0, 0.0, 0.0))
    assert moved.objects[0] == first
    assert moved.objects[1].pose.position[0] == pytest.approx(scene.objects[1].pose.position[0] + 1)


def test_processes_say_what_one_process_says(solution):
    poses = np.concatenate([solution.poses, solution.poses + np.float32(0.2)])
    with Judge(2) as judge:
        several = judge(solution.source, poses)
    assert several == Judge(1)(solution.source, poses)
    assert [o.valid for o in several[4:]] == [False] * 4


def test_opinion_of_a_witness():
    o = opinion(load("bedroom-small"), walkable=True)
    assert o.valid and o.solid and o.reason == ""
    assert o.hard[0] == o.hard[1] > 0
    assert 0 < o.walkable <= 1


def test_share():
    assert share([]) is None
    assert share([(0, 0)]) is None
    assert share([(1, 2), (2, 2)]) == 0.75


def test_spread():
    assert list(spread(np.arange(5), None)) == [0, 1, 2, 3, 4]
    assert list(spread(np.arange(10, 20), 2)) == [10, 19]
    assert list(spread(np.arange(0), 3)) == []


def test_audit_finds_no_contradiction(solution, tmp_path):
    result = Result("x", "X", "")
    found = audit(solution, Judge(1), result, "room", tmp_path)
    assert result.failures == [] and found.exceptions == 0
    assert len(found.opinions) == len(found.judged) == int((solution.status == 0).sum())
    assert not (tmp_path / "contradictions").exists()


def test_audit_reports_what_only_the_engine_calls_valid(solution, tmp_path):
    poses = solution.poses.copy()
    poses[1, :, 0] += 0.5
    status = np.array([0, 0, 1, 1], dtype=np.int8)
    result = Result("x", "X", "")
    found = audit(replace(solution, poses=poses, status=status), Judge(1), result, "a room seed 0", tmp_path)
    assert found.exceptions == 1 and found.agreed == [0]
    assert len(result.failures) == 1 and result.failures[0].startswith("a room seed 0, candidate 1: status valid, but ")
    kept = Scene.load(tmp_path / "contradictions" / "a-room-seed-0-1.json")
    assert not opinion(kept).valid
