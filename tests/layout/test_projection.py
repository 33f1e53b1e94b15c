"""Projection: the nearest feasible layout, and nothing moves without need."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sceneweaver as sw
from sceneweaver.optimizers import Monitor, judge, run, streams
from sceneweaver.scene import Pose
from tests.kernels.harness import batch_of, noisy
from tests.kernels.harness import zoo as compiled
from tests.layout.made import CUP, relation, room, scene, table, thing, zoo

MARGIN = 4e-4  # [m] clearance that a pair is given, and what rounding leaves of it
SMALL = ("bedroom-small", "bedroom", "children-twin", "living-dining-L", "studio-U", "office-20")


def project(what, init="current", **options):
    return sw.refine(what, **({"device": "cpu", "candidates": 4, "optimizer": "projection", "init": init} | options))


def box(key, x, y, size=(0.5, 0.6, 0.8), yaw=0.0, **more):
    return thing(key, size, pose=Pose.from_yaw(x, y, 0.0, yaw), **more)


def movement(problem, before, after) -> np.ndarray:
    """Squared movement [B] of layouts."""
    d = (after - before)[:, problem.roots == np.arange(problem.size)]
    turn = np.remainder(d[..., 3] + math.pi, 2 * math.pi) - math.pi
    return np.sum(d[..., :3] ** 2, axis=(1, 2)) + 0.25 * np.sum(turn**2, axis=1)


def disturbed(name: str, count: int, scale: float = 0.15, seed: int = 0) -> np.ndarray:
    problem, rng = compiled(name).room, np.random.default_rng(seed)
    return np.array([noisy(problem, rng, scale, rigid=True) for _ in range(count)])


def projected(name: str, before: np.ndarray, seed: int = 0, budget: int | None = None):
    problem = compiled(name).room
    batch = batch_of([problem], [0] * len(before), before, "cpu")
    batch.state.rng.assign(streams(seed, np.arange(len(before))))
    run(batch, "projection", "given", budget, Monitor(len(before)))
    return batch.state.poses.numpy().copy(), judge(batch).status


@pytest.mark.parametrize("name", [*SMALL, "restaurant-dense"])
def test_a_feasible_layout_keeps_every_bit(name):
    before = np.repeat(compiled(name).room.home[None].astype(np.float32), 3, axis=0)
    after, status = projected(name, before)
    assert (status == 0).all() and after.tobytes() == before.tobytes()
    solution = project(zoo(name), init=before.astype(np.float64))
    assert (solution.status == 0).all() and solution.poses.tobytes() == before.tobytes()


def test_two_boxes_part_along_the_shorter_way_by_half_the_overlap_each():
    solution = project(scene([box("a", 2.0, 2.0), box("b", 2.4, 2.0)], []))
    a, b = solution.poses[0].astype(float)
    assert solution.status[0] == 0
    assert b[0] - a[0] == pytest.approx(0.5, abs=MARGIN) and a[0] + b[0] == pytest.approx(4.4, abs=1e-4)
    assert a[1:] == pytest.approx([2.0, 0.0, 0.0], abs=1e-4) and b[1:] == pytest.approx([2.0, 0.0, 0.0], abs=1e-4)


def test_a_corner_in_the_way_is_left_by_turning_as_well():
    """Two boxes that overlap by 0.1 m near their corners: shifting alone costs 2 * 0.05^2."""
    what = scene([box("a", 2.0, 2.0), box("b", 2.4, 2.3)], [])
    solution = project(what)
    d = solution.poses[0].astype(float) - [[2.0, 2.0, 0.0, 0.0], [2.4, 2.3, 0.0, 0.0]]
    assert solution.status[0] == 0 and abs(d[0, 3]) > 0.01
    assert np.sum(d[:, :2] ** 2) + 0.25 * np.sum(d[:, 3] ** 2) < 2 * 0.05**2


def test_a_fixed_object_leaves_the_whole_way_to_the_other():
    pose = Pose.from_yaw(2.0123456789, 2.0, 0.0, 0.0)
    what = scene([thing("a", pose=pose, fixed=True), box("b", 2.4, 2.0)], [])
    best = project(what).best
    assert best.object("a").pose == pose
    assert best.object("b").pose.position[0] == pytest.approx(2.5123, abs=MARGIN)


def test_three_in_a_row_share_the_movement():
    what = scene([box(k, x, 2.0) for k, x in (("a", 2.0), ("b", 2.4), ("c", 2.8))], [])
    x = project(what).poses[0, :, 0]
    assert x == pytest.approx([1.9, 2.4, 2.9], abs=MARGIN)


def test_a_wall_pushes_straight_and_others_stay():
    what = scene([box("a", 0.15, 2.0), box("b", 3.0, 3.0, yaw=0.3)], [])
    solution = project(what)
    assert solution.poses[0, 0].tolist() == pytest.approx([0.25, 2.0, 0.0, 0.0], abs=MARGIN)
    assert solution.poses[0, 1].tobytes() == np.float32([3.0, 3.0, 0.0, 0.3]).tobytes()


def test_a_turned_box_may_turn_back_to_the_wall():
    solution = project(scene([box("a", 0.24, 2.0, (0.5, 1.2, 0.8), yaw=0.2)], []))
    x, _, _, yaw = solution.poses[0, 0].astype(float)
    assert solution.status[0] == 0
    assert 0.0 < yaw < 0.2 and 0.24 < x < 0.25 * math.cos(0.2) + 0.6 * math.sin(0.2)


@pytest.mark.parametrize("name", [*SMALL, "living", "lockers-wall-full", "gym-30"])
def test_disturbed_rooms_become_valid_near_where_they_were(name):
    """The witness is feasible, so that the nearest feasible layout is no further away than the noise was large."""
    problem, before = compiled(name).room, disturbed(name, 24)
    after, status = projected(name, before)
    assert np.mean(status == 0) >= 0.95
    ratio = (movement(problem, before, after) / movement(problem, problem.home[None], before))[status == 0]
    assert np.mean(ratio <= 1.0) >= 0.9 and np.median(ratio) < 0.8


def test_what_it_calls_valid_the_judge_calls_valid():
    for name in ("bedroom", "living-dining-L", "office-20"):
        solution = project(zoo(name), init=disturbed(name, 12))
        assert np.mean(solution.status == 0) > 0.9
        for i in np.flatnonzero(solution.status == 0):
            report = sw.check(solution.scene(int(i)), walkable=False)
            assert report.valid, report.violations


def test_same_seed_same_bits_whoever_else_is_in_the_batch(monkeypatch):
    before = disturbed("studio-U", 40)
    whole, _ = projected("studio-U", before)
    assert projected("studio-U", before)[0].tobytes() == whole.tobytes()
    assert projected("studio-U", before[:7])[0].tobytes() == whole[:7].tobytes()
    assert projected("studio-U", before, seed=1)[0].tobytes() != whole.tobytes()
    monkeypatch.setattr("sceneweaver.optimizers.projection.MEMORY", 2**20)
    assert projected("studio-U", before)[0].tobytes() == whole.tobytes()


def test_many_scenes_in_shared_launches_equal_each_alone():
    crowd = scene([box("a", 2.0, 2.0), box("b", 2.2, 2.3)], [])
    scenes = [zoo("bedroom-small"), crowd, zoo("bedroom")]
    options = {"candidates": 3, "seed": 2, "init": "current", "optimizer": "projection", "device": "cpu"}
    for one, solution in zip(scenes, sw.refine_many(scenes, **options), strict=True):
        assert solution.poses.tobytes() == sw.refine(one, **options).poses.tobytes()


def test_hard_relations_hold_afterwards_and_soft_ones_do_not_count():
    objects = [box("bed", 1.4, 2.2, (2.0, 1.5, 0.5), yaw=0.2), box("b", 4.0, 3.0, yaw=0.1)]
    solution = project(scene(objects, [relation("against_wall", "bed")]))
    assert solution.status[0] == 0 and sw.check(solution.best).valid
    soft = relation("against_wall", "bed").model_copy(update={"hard": False})
    assert (
        project(scene(objects, [soft])).poses[0].tobytes()
        == np.float32([[*o.pose.position, o.pose.yaw] for o in objects]).tobytes()
    )


def test_what_hangs_over_an_edge_goes_back_just_far_enough():
    base, cup = table().model_copy(update={"pose": Pose.from_yaw(2.5, 2.0, 0.0, 0.0)}), CUP
    cup = cup.model_copy(update={"pose": Pose.from_yaw(2.5 + 0.4, 2.1, 0.75, 0.0)})  # the top reaches to 0.4
    best = project(scene([base, cup], [])).best
    assert sw.check(best).valid
    assert best.object("cup").pose.position == pytest.approx((2.5 + 0.35, 2.1, 0.75), abs=MARGIN)
    assert best.object("table").pose.position == pytest.approx((2.5, 2.0, 0.0), abs=1e-6)


def test_from_any_start_the_search_helps_out():
    solution = project(zoo("bedroom-small"), init="random", candidates=8)
    assert np.mean(solution.status == 0) >= 0.85


def test_what_cannot_fit_is_not_valid_and_does_not_take_forever():
    solution = project(scene([thing("whale", (9, 2, 1)), box("b", 2.0, 2.0)], [], room=room(4, 3)), explain=False)
    assert (solution.status == 1).all() and np.isfinite(solution.poses).all()


def test_a_time_limit_cuts_off():
    before = disturbed("restaurant-dense", 256, 0.3)
    solution = project(zoo("restaurant-dense"), init=before, time_limit=0.5, explain=False)
    assert solution.timed_out and np.isfinite(solution.poses).all()
