"""Chains over valid layouts: what they lead to is valid, other than before, and nobody else's business."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver.layout.compile import CompiledScene, compile_scene
from sceneweaver.layout.sampling import Sampler, first_layouts, joined
from sceneweaver.optimizers import chains as module
from sceneweaver.optimizers import search, streams
from sceneweaver.optimizers.launches import Launches
from sceneweaver.optimizers.search import CPU, GPU
from sceneweaver.optimizers.starts import new_run
from sceneweaver.scene import Pose, Room, Scene
from sceneweaver.verify import check
from tests.optimizers.batches import batch, zoo

CHAINS, STEPS = 6, 4


def walk(scenes: list[CompiledScene], chains: int = CHAINS, steps: int = STEPS) -> list[list[np.ndarray]]:
    """The fresh layouts of each step, by scene; chains begin at the scenes' own poses."""
    first = [s.room.home[None].astype(np.float32) for s in scenes]
    sampler = Sampler(scenes, first, chains, list(range(len(scenes))), "cpu")
    found: list[list[np.ndarray]] = [[] for _ in scenes]
    for _ in range(steps):
        sampler.step()
        step = sampler.read()
        for k, layouts in enumerate(found):
            layouts.append(sampler.drawn(step, k).poses)
    return found


def posed(scene: Scene, poses: np.ndarray) -> Scene:
    moved = [(o.id, Pose.from_yaw(*map(float, p))) for o, p in zip(scene.objects, poses, strict=True) if not o.fixed]
    return scene.replace_poses(dict(moved))


@pytest.mark.parametrize("name", ["bedroom-small", "living-dining-L", "children-twin"])
def test_what_chains_lead_to_is_valid_and_new(name):
    compiled = zoo(name)
    (steps,) = walk([compiled])
    layouts = np.concatenate(steps)
    assert len(layouts) >= CHAINS * STEPS // 3
    for poses in layouts:
        assert check(posed(compiled.scene, poses), walkable=False).valid
    away = np.linalg.norm(layouts[..., :2] - compiled.room.home[:, :2], axis=-1)
    assert (away > 0.5).any(axis=1).mean() > 0.5  # the best part of them has moved something far
    assert len(np.unique(layouts.reshape(len(layouts), -1), axis=0)) == len(layouts)


def test_neither_scenes_beside_it_nor_threads_change_a_chain(monkeypatch):
    scenes = [zoo("bedroom-small"), zoo("dining-round")]
    together = walk(scenes)
    monkeypatch.setattr(module, "cpu_threads", lambda: 1)
    for scene, expected in zip(scenes, together, strict=True):
        seed = scenes.index(scene)
        sampler = Sampler([scene], [scene.room.home[None].astype(np.float32)], CHAINS, [seed], "cpu")
        for poses in expected:
            sampler.step()
            np.testing.assert_array_equal(sampler.drawn(sampler.read(), 0).poses, poses)


def test_closed_chains_stay_where_they_are():
    scenes = [zoo("bedroom-small"), zoo("dining-round")]
    sampler = Sampler(scenes, [s.room.home[None].astype(np.float32) for s in scenes], 4, [1, 2], "cpu")
    sampler.step()
    before = sampler.read()
    sampler.close(np.array([True, False]))
    sampler.step()
    after = sampler.read()
    np.testing.assert_array_equal(after.poses[:4], before.poses[:4])
    assert not after.fresh[:4].any() and after.fresh[4:].any()


def test_a_step_that_fails_leaves_a_valid_layout(monkeypatch):
    monkeypatch.setattr(module, "TEMPERATURE", 3.0)  # anything goes, and there is little time to mend it
    monkeypatch.setattr(module, "ROUNDS", 1)
    compiled = zoo("bedroom-tight")
    sampler = Sampler([compiled], [compiled.room.home[None].astype(np.float32)], 16, [3], "cpu")
    for _ in range(3):
        sampler.step()
        step = sampler.read()
        for poses in step.poses[:, : compiled.room.size]:
            assert check(posed(compiled.scene, poses), walkable=False).valid
    assert not step.fresh.all()


def test_rugs_stay_inside_of_a_room_that_is_not_convex():
    """They are thinner than what the engine takes for a contact; what is outside is so at all heights."""
    from sceneweaver.assets import make

    outline = ((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4))
    rug = make("rug", 1).object("rug", pose=Pose.from_yaw(1.5, 1.0, 0.0, 0.0))
    assert rug.size[2] < 5e-4
    scene = Scene(id="rug", room=Room(outline=outline), objects=(rug,), relations=())
    (found,) = first_layouts([compile_scene(scene)], range(64), 4, [0], "cpu")
    assert len(found.poses) == 64
    assert all(check(posed(scene, poses), walkable=False).valid for poses in found.poses)


def test_a_first_layout_is_the_same_whatever_others_are():
    scene = zoo("dining-round")
    (whole,) = first_layouts([scene], range(6), 10, [4], "cpu")
    parts = [first_layouts([scene], part, 10, [4], "cpu")[0] for part in (range(2), range(2, 6))]
    assert len(whole.poses) == 6
    np.testing.assert_array_equal(joined(*parts).poses, whole.poses)


@pytest.mark.parametrize("effort", [CPU, GPU])
def test_a_step_job_by_job_is_the_same_as_in_one_launch(effort):
    plan, results = module.mixing_plan(effort), []
    for in_one in (True, False):
        what = batch(["bedroom-small"], 8, "cpu")
        what.state.rng.assign(streams(5, np.arange(what.size)))
        state, run, block = search.extend_state(what), new_run(what), Launches("cpu")
        search.Rounds(what, state, plan, run, block, in_one)
        for clock in range(plan.rounds):
            run.clock.fill_(clock)
            block.run()
        results.append((what.state.poses.numpy(), run.total.numpy()))
    for one, other in zip(*results, strict=True):
        np.testing.assert_array_equal(one, other)


def test_the_plan_of_a_gpu_leads_to_valid_layouts(monkeypatch):
    monkeypatch.setattr(module, "CPU", GPU)
    compiled = zoo("office-20")
    (steps,) = walk([compiled], steps=2)
    layouts = np.concatenate(steps)
    assert len(layouts) >= CHAINS
    assert all(check(posed(compiled.scene, poses), walkable=False).valid for poses in layouts)
