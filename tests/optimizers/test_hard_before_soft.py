"""Soft relations that contradict what is hard give way: the layouts are valid, and no other scene notices."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from benchmarks.rooms import load
from benchmarks.soft_mixes import bare, mixed
from sceneweaver.kernels.bookkeeping import keep_best
from sceneweaver.layout import engine
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


def test_no_candidate_is_lost_to_soft_rows(monkeypatch):
    """What is valid without the soft rows is valid with them, candidate by candidate, and is what the judge says."""
    given = mixed(load("bedroom-tight"), "ten nears of weight 10")
    options = {"candidates": 12, "seed": 2, "device": "cpu", "explain": False}
    without, together = sw.refine(bare(given), **options), sw.refine(given, **options)
    good = without.status == 0
    assert good.any() and (together.status[good] == 0).all()
    for k in np.flatnonzero(together.status == 0)[:3]:
        assert sw.check(together.scene(k)).valid
    assert together.relations.shape == (12, len(given.relations))
    monkeypatch.setattr(engine, "failed_for_softness", lambda *_: {})
    lost = sw.refine(given, **options).status != 0
    assert (lost & good).any()  # else this scene shows nothing
    same = ~lost
    np.testing.assert_array_equal(together.poses[same], sw.refine(given, **options).poses[same])


def test_the_poses_that_an_edit_begins_with_count_in_the_second_search_as_well():
    given = mixed(load("bedroom-tight"), "ten nears of weight 10")
    solution = sw.refine(given, candidates=8, init="current", device="cpu", explain=False)
    assert solution.moved is not None and np.isfinite(solution.moved[solution.status == 0]).all()
    without = sw.refine(bare(given), candidates=8, init="current", device="cpu")
    assert (solution.status[without.status == 0] == 0).all()


def test_a_scene_without_soft_rows_is_searched_once(monkeypatch):
    def never(*_):
        raise AssertionError("searched again")

    monkeypatch.setattr(engine, "with_rescued", never)
    full = scene([thing(f"box-{k}", (0.8, 0.8, 0.8)) for k in range(14)], [], room=room(3.0, 2.9))
    assert (sw.refine(full, candidates=4, steps=1, device="cpu", explain=False).status != 0).all()


def test_the_explanation_names_what_a_soft_row_fights():
    """A box that has to stand at a wall is to be near another that has to stand at the opposite one."""
    boxes = [thing("left", (0.6, 0.6, 0.6)), thing("right", (0.6, 0.6, 0.6)), thing("idle", (0.4, 0.4, 0.4))]
    hard = [sw.Relation(type="against_wall", subject=n, target=f"wall:{k}") for n, k in (("left", 3), ("right", 1))]
    near = [sw.Relation(type="near", subject="left", target="right", params={"max": 0.1}, hard=False, weight=9.0)]
    near += [sw.Relation(type="near", subject="left", target="idle", params={"max": 1.0}, hard=False)]
    told = sw.refine(scene(boxes, [*hard, *near], room=room(6.0, 3.0)), candidates=16, device="cpu").explanation
    first, fight = told.splitlines()
    assert first.startswith("Soft relations that hold in none of 16 valid layouts") and "idle" not in told
    assert fight.startswith("left near right (max 0.1 m) pulls against what is hard: 5 cm more for it would break ")
    assert "left against_wall wall:3 (in " in fight and "right against_wall wall:1 (in " in fight


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
