"""Soft relations that contradict what is hard give way: the layouts are valid, and no other scene notices."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.kernels.bookkeeping import keep_best
from sceneweaver.optimizers import search
from sceneweaver.optimizers.search import GPU, plan_for
from sceneweaver.optimizers.starts import new_run
from tests.layout.made import room, scene, thing
from tests.optimizers.batches import batch


def nets(weight: float, width: float = 6.0, depth: float = 5.0, objects: int = 6) -> sw.Scene:
    """Five of the boxes want to touch each other, all ten pairs of them, for which there is no place in the plane."""
    boxes = [thing(f"box-{k}", (0.8, 0.8, 0.8)) for k in range(objects)]
    wishes = [
        sw.Relation(type="near", subject=a.id, target=b.id, params={"max": 0.0}, hard=False, weight=weight)
        for a, b in combinations(boxes[:5], 2)
    ]
    return scene(boxes, wishes, room=room(width, depth))


@pytest.mark.parametrize(
    "given", [nets(1.0), nets(5.0), nets(1.0, 4.2, 3.6, 9)], ids=["one net", "a heavy one", "a tight room"]
)
def test_wishes_that_imply_overlap_leave_layouts_valid(given):
    solution = sw.refine(given, candidates=16, device="cpu")
    assert (solution.status == 0).all()
    assert sw.check(solution.best).valid
    told = solution.explanation
    assert "Soft relations that hold in none of 16 valid layouts" in told and "box-0 near box-1 (max 0 m)" in told
    gaps = [np.linalg.norm(solution.poses[:, i, :2] - solution.poses[:, j, :2], axis=1) for i, j in ((0, 1), (2, 3))]
    assert np.median(gaps) < 2.0  # they are as near as bodies may be, not anywhere


def test_short_attempts_of_a_gpu_let_them_give_way_as_well(monkeypatch):
    monkeypatch.setattr(search, "effort_for", lambda device, start, objects: GPU)
    solution = sw.refine(nets(5.0), candidates=16, device="cpu")
    assert (solution.status == 0).all()


def test_a_single_attempt_is_enough():
    solution = sw.refine(nets(1.0), candidates=16, steps=1, device="cpu")
    assert (solution.status == 0).mean() > 0.8


def test_nobody_gives_way_in_the_first_attempts_of_several():
    first, only = plan_for(search.CPU, "sample", None), plan_for(search.CPU, "sample", 1)
    assert first.eases_from == search.CPU.rounds and only.eases_from == 0
    assert plan_for(GPU, "sample", None).eases_from == 5


def test_the_best_of_invalid_layouts_is_the_one_that_breaks_least():
    """A candidate for each case: less of both, less hard alone, more hard but less in all, the same hard and less."""
    what = batch(["bedroom-small"], 4, "cpu", 0.3)
    run = new_run(what)
    run.best_hard.assign([0.2, 0.2, 0.2, 0.2])
    run.best_total.assign([0.5, 0.5, 0.5, 0.5])
    run.hard.assign([0.1, 0.1, 0.3, 0.2])
    run.total.assign([0.4, 0.9, 0.4, 0.4])
    wp.launch(keep_best, 4, [what.problems, what.state], [run], device="cpu")
    np.testing.assert_allclose(run.best_hard.numpy(), [0.1, 0.1, 0.2, 0.2])
    np.testing.assert_allclose(run.best_total.numpy(), [0.4, 0.9, 0.5, 0.4])
