"""The search taken apart into jobs, as on a GPU: the same layouts as in one launch, and its plan finds valid ones."""

from __future__ import annotations

import numpy as np
import pytest
import warp as wp

import sceneweaver as sw
from sceneweaver.kernels import bookkeeping
from sceneweaver.kernels.plan import Plan
from sceneweaver.kernels.verdict import DeviceVerdict
from sceneweaver.layout.engine import _load_worlds
from sceneweaver.layout.surfaces import surfaces_hold
from sceneweaver.optimizers import load_poses, search, streams
from sceneweaver.optimizers.base import Start
from sceneweaver.optimizers.batch import Batch
from sceneweaver.optimizers.launches import Launches
from sceneweaver.optimizers.search import CPU, GPU, GPU_ANCHORED, GPU_CROWD, Effort, effort_for, plan_for
from sceneweaver.optimizers.starts import new_run
from tests.kernels.harness import ZOO, best_options, run_energy, zoo
from tests.optimizers.batches import batch

ROUNDS = 2


def run(what: Batch, plan: Plan, in_one: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Poses, energies by object and totals after some rounds."""
    state, progress, block = search.extend_state(what), new_run(what), Launches(what.device)
    progress.active.assign(np.arange(what.size) % 5 != 4)  # some are done already
    state.released.fill_(1)
    search.Rounds(what, state, plan, progress, block, in_one)
    for k in range(ROUNDS):
        progress.clock.fill_(k)
        block.run()
    return what.state.poses.numpy(), state.rating.numpy(), progress.total.numpy()


@pytest.mark.parametrize(
    ("room", "start", "effort"),
    [
        ("bedroom-small", "random", GPU),
        ("bedroom-small", "given", GPU_ANCHORED),
        ("living-dining-L", "sample", CPU),
        ("restaurant-60", "sample", GPU_CROWD),
    ],
)
def test_job_by_job_is_the_same_as_in_one_launch(room: str, start: Start, effort: Effort) -> None:
    results = []
    for in_one in (True, False):
        what = batch([room], 12, "cpu", 0.3)
        what.state.rng.assign(streams(5, np.arange(what.size)))
        results.append(run(what, plan_for(effort, start, None), in_one))
    for one, other in zip(*results, strict=True):
        np.testing.assert_array_equal(one, other)


def test_those_that_are_done_stay_where_they_are() -> None:
    what = batch(["bedroom-small"], 10, "cpu", 0.3)
    what.state.rng.assign(streams(5, np.arange(what.size)))
    before = what.state.poses.numpy().copy()
    run(what, plan_for(GPU, "random", None), False)
    moved = np.any(what.state.poses.numpy() != before, axis=(1, 2))
    np.testing.assert_array_equal(moved, np.arange(what.size) % 5 != 4)


@pytest.mark.parametrize("effort", [CPU, GPU, GPU_ANCHORED])
def test_a_round_reports_the_energy_that_it_leaves(effort: Effort) -> None:
    what = batch(["children-twin"], 60, "cpu")  # the last survey of a round need not come at its end
    totals = run(what, plan_for(effort, "random", None), True)[2]
    best_options(what)
    energies = run_energy(what).total
    searched = np.arange(what.size) % 5 != 4
    assert np.any(totals[searched] > 0.01), "some are not solved"
    np.testing.assert_allclose(totals[searched], energies[searched], rtol=1e-4, atol=1e-5)


@pytest.mark.parametrize("room", ["bedroom-small", "bedroom-tight", "office-20", "dining-round", "studio-U"])
def test_the_plan_of_a_gpu_finds_valid_layouts(room: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(search, "effort_for", lambda device, start, objects: effort_for("cuda:0", start, objects))
    scene = sw.Scene.load(ZOO / f"{room}.json")
    solution = sw.refine(scene, candidates=16, init="random", seed=2, device="cpu", explain=False)
    assert np.all(solution.status == 0)
    assert not [v for k in range(16) for v in sw.check(solution.scene(k)).violations]


def test_the_effort_suits_device_start_and_size() -> None:
    assert effort_for("cpu", "random", 10) is CPU
    assert effort_for("cuda:1", "random", 10) is GPU
    assert effort_for("cuda:1", "sample", 100) is GPU_CROWD
    assert effort_for("cuda", "given", 100) is GPU_ANCHORED
    assert plan_for(GPU, "random", 7).steps == 7 * GPU.rounds
    plan = plan_for(CPU, "random", None)
    assert (plan.first_steps, plan.steps) == (CPU.attempts * CPU.rounds, CPU.most_attempts * CPU.rounds)
    for start, attempts in (("given", None), ("random", 7)):  # no more than that, however close
        plan = plan_for(CPU, start, attempts)
        assert plan.first_steps == plan.steps


def test_starts_that_are_the_same_for_all_go_over_once() -> None:
    problems = [zoo("bedroom-small").room, zoo("office-20").room]
    results = []
    for broadcast in (True, False):
        what = batch(["bedroom-small", "office-20"], 6, "cpu", 0.1)
        worlds = [np.broadcast_to(p.home, (6, *p.home.shape)) for p in problems]
        if broadcast:
            _load_worlds(what, worlds)
        else:
            padded = np.zeros((12, what.objects, 4), dtype=np.float32)
            for k, world in enumerate(worlds):
                padded[6 * k : 6 * k + 6, : world.shape[1]] = world
            load_poses(what, padded)
        results.append([getattr(what.state, name).numpy() for name in ("poses", "anchors", "turns")])
    for one, other in zip(*results, strict=True):
        np.testing.assert_array_equal(one, other)


def test_what_stands_on_surfaces_is_judged_in_their_frames() -> None:
    compiled = zoo("bedroom-small")
    what = batch(["bedroom-small"], 6, "cpu", 0.1)
    load_poses(what, np.repeat(compiled.room.home[None], 6, axis=0).astype(np.float32))
    assert surfaces_hold(compiled, what, 0, 6).all()
    poses = what.state.poses.numpy()
    turn = 1.0  # of the whole room, after which all is where it was on its surface
    c, s = np.cos(turn), np.sin(turn)
    poses[1] = np.stack(
        [
            c * poses[1, :, 0] - s * poses[1, :, 1],
            s * poses[1, :, 0] + c * poses[1, :, 1],
            poses[1, :, 2],
            poses[1, :, 3] + turn,
        ],
        axis=-1,
    )
    poses[4, compiled.domains[-1].surface.members[0], 0] += 0.5
    np.testing.assert_array_equal(surfaces_hold(compiled, what, 1, 5), [True, True, True, False, True])


def test_the_neighbourhood_of_a_violation_is_released_step_by_step() -> None:
    room = zoo("bedroom-small").room
    what = batch(["bedroom-small"], 3, "cpu")
    state, progress, verdict = search.extend_state(what), new_run(what), DeviceVerdict()
    plan = Plan()
    plan.rounds, plan.anchored_attempts = 2, 3
    fault = np.zeros((3, what.objects), dtype=np.int8)
    fault[:2, room.size - 1] = 1  # something that is carried
    holds = np.ones((3, what.relations), dtype=bool)
    pair = next(r for r, rel in enumerate(room.relations) if rel.fault and rel.objects[1] >= 0)
    soft = next(r for r, rel in enumerate(room.relations) if not rel.fault)
    holds[1, pair], holds[2, soft] = False, False

    def release(clock: int) -> np.ndarray:
        progress.clock.fill_(clock)
        verdict.fault, verdict.holds = (wp.array(a, device="cpu") for a in (fault, holds))
        wp.launch(bookkeeping.release, 3, [what.problems, plan, progress, verdict], [state], device="cpu")
        return state.released.numpy().copy()

    first = np.zeros((3, what.objects), dtype=np.int32)
    first[:2, room.roots[room.size - 1]] = 1
    first[1, room.roots[[o for o in room.relations[pair].objects if o >= 0]]] = 1
    np.testing.assert_array_equal(release(0), first)
    fault[:2] = 0
    fault[2, 0] = 1
    np.testing.assert_array_equal(release(1), first)  # in the middle of an attempt
    first[2, room.roots[0]] = 1
    np.testing.assert_array_equal(release(2), first)
    first[:, room.roots] = 1
    np.testing.assert_array_equal(release(4), first)  # the last attempt that starts from the given poses


def test_those_that_never_come_close_leave_with_their_best_layout() -> None:
    what = batch(["bedroom-small"], 5, "cpu", 0.3)
    progress, verdict, plan = new_run(what), DeviceVerdict(), Plan()
    plan.first_steps = 6
    progress.best.fill_(wp.vec4(1.0, 2.0, 0.0, 0.5))
    progress.best_hard.assign([0.0, 0.05, 0.3, 0.3, 0.3])
    progress.best_total.assign([0.0, 0.45, 0.4, 0.3, 0.3])
    progress.active.assign([1, 1, 1, 0, 1])
    verdict.status = wp.array(np.int8([0, 1, 2, 0, 1]), device="cpu")
    before = what.state.poses.numpy().copy()

    def retire(clock: int) -> list[int]:
        progress.left.zero_()
        progress.clock.fill_(clock)
        wp.launch(bookkeeping.retire, 5, [plan, 0.1, verdict], [progress], device="cpu")
        return progress.left.numpy().tolist()

    assert retire(5) == [3, 0]
    assert retire(6) == [1, 2]
    np.testing.assert_array_equal(progress.active.numpy(), [0, 1, 0, 0, 0])
    np.testing.assert_array_equal(what.state.poses.numpy(), before)
    inputs = [what.problems, progress, verdict]
    wp.launch(bookkeeping.take_best_found, before.shape[:2], inputs, [what.state], device="cpu")
    after, objects = what.state.poses.numpy(), zoo("bedroom-small").room.size
    np.testing.assert_array_equal(after[[0, 3]], before[[0, 3]])
    assert np.all(after[[1, 2, 4], :objects] == progress.best.numpy()[[1, 2, 4], :objects])
    np.testing.assert_allclose(what.state.turns.numpy()[1, 0], [np.cos(0.5), np.sin(0.5)], rtol=1e-6)


def test_a_single_attempt_gives_up_what_is_far_from_valid_and_changes_nothing_else(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def one_attempt(hopeful: float) -> sw.Solution:
        monkeypatch.setattr(search, "HOPEFUL", hopeful)
        return sw.refine(sw.Scene.example("bedroom"), candidates=48, seed=1, steps=1, device="cpu")

    whole, cut = one_attempt(np.inf), one_attempt(0.1)
    followed = (cut.poses == whole.poses).all(axis=(1, 2))
    assert not followed.all()
    assert (cut.status == 0).any()
    assert followed[cut.status == 0].all()
    assert (cut.energy[~followed] > 0.1).all()
