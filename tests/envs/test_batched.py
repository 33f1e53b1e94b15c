"""Batches: the same rooms as one by one, the same tasks, seeds, episodes that begin anew."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver import envs
from sceneweaver.envs.batched import Bank, BatchedRoomEnv, steady
from sceneweaver.envs.batched.goals import task_rows
from sceneweaver.envs.tasks import KINDS
from sceneweaver.envs.world import RoomState
from sceneweaver.scene import InputError
from tests.envs.rooms import kitchen, load

TURNS = (0.0, 0.5)


@pytest.fixture(scope="module")
def bank() -> Bank:
    layouts = np.stack([envs.poses_of(kitchen(turn)) for turn in TURNS])
    smaller = kitchen().model_copy(update={"id": "less", "objects": kitchen().objects[:2]})
    return Bank.of([kitchen(), smaller], [layouts, None], load=load)


@pytest.fixture(scope="module")
def env(bank) -> BatchedRoomEnv:
    return BatchedRoomEnv(bank, 3, device="cpu", threads=1, max_steps=6)


@pytest.fixture(scope="module")
def world() -> envs.World:
    return envs.World(kitchen(), envs.mobile_manipulator(), load, loose=False)


def start(env: BatchedRoomEnv, *layouts: int, seed: int = 0) -> dict[str, np.ndarray]:
    return env.reset(seed=seed, options={"layout": np.array(layouts)})[0]


def state_of(env: BatchedRoomEnv, world: envs.World, k: int, layout: np.ndarray) -> RoomState:
    """The state of a world of the batch as tasks of one environment see it."""
    data, names = env.physics.data, env.bank.names[0]
    place = {o.id: pose for o, pose in zip(world.scene.objects, layout, strict=True)}
    bodies = {name: place[world.geometry.owner[name]] for name in (*world.item_names, *world.joint_names)}
    for slot, name in enumerate(names):
        if name in bodies:
            bodies[name] = np.concatenate([data.xpos.numpy()[k, 1 + slot], data.xquat.numpy()[k, 1 + slot]])
    joints = {n: float(data.qpos.numpy()[k, names.index(n)]) for n in world.joint_names if n in names}
    seen = env.observations
    return RoomState(bodies, joints, seen["tool"].numpy()[k], seen["base"].numpy()[k])


def test_bodies_are_where_the_room_has_them(env, world):
    start(env, 0, 1, 2)
    data = world.new_data()
    for k, turn in enumerate(TURNS):
        world.place(data, envs.poses_of(kitchen(turn)), np.zeros(3))
        names = env.bank.names[0]
        begun = env.bank.layout["goals"][k, env.info()["goal"][k]]["joint"]  # what is to be closed begins open
        for slot, name in enumerate(names):
            if name and not name.startswith("room:") and slot != begun:
                assert env.physics.data.xpos.numpy()[k, 1 + slot] == pytest.approx(data.body(name).xpos, abs=1e-5)
        model = env.physics._models[k]
        glass = 1 + names.index("drinking_glass-0")
        assert model.body_mass[glass] == pytest.approx(float(world.model.body("drinking_glass-0").mass[0]), rel=1e-4)
        assert world.geometry.items["dining_table-0"].free and "dining_table-0" not in names, "what is heavy is not"


def test_tasks_are_judged_as_one_by_one(bank, world):
    poses = envs.poses_of(kitchen())
    rows = task_rows(world.geometry, world.robot, poses, KINDS)
    tasks = [row.task for row in rows if row.instruction in bank.instructions[0]]
    assert {type(task) for task in tasks} >= set(KINDS) - {envs.PutOn}
    worlds, rng = 8 * len(tasks), np.random.default_rng(0)
    env = BatchedRoomEnv(bank, worlds, device="cpu", threads=1)
    start(env, *[0] * worlds)
    env._episodes.goal.assign(np.arange(worlds, dtype=np.int32) % len(tasks))
    env._look()
    begun = [state_of(env, world, k, poses) for k in range(worlds)]
    qpos, slots = env.physics.data.qpos.numpy(), bank.slots
    glass = slots.links + 7 * (bank.names[0].index("drinking_glass-0") - slots.links)
    for k in range(worlds):
        task = tasks[k % len(tasks)]
        qpos[k, : slots.links] = rng.uniform(0, 1, slots.links) * rng.integers(0, 3)
        qpos[k, list(env._find.base)] = *rng.uniform(0, 4, 2), rng.uniform(-4, 4)
        if k // len(tasks) % 2:  # near the goal, often reached
            goal = task.goal(world.geometry, begun[k])
            qpos[k, glass : glass + 3] = goal + rng.normal(0, 0.03, 3) - [0, 0, 0.06]
            if isinstance(task, envs.NavigateTo):
                angle = rng.uniform(-np.pi, np.pi)
                qpos[k, list(env._find.base)] = *(goal[:2] - 0.9 * np.array([np.cos(angle), np.sin(angle)])), angle
            if isinstance(task, envs.Take):
                qpos[k, list(env._find.base)] = goal[0] - 0.75, goal[1], 0.0
                qpos[k, env._find.drive_position[3]] = goal[2]
    env._episodes.fresh.fill_(1)
    env.physics.refresh(env._episodes.fresh)
    env._episodes.fresh.zero_()
    env._look()
    reached = 0
    for k in range(worlds):
        task, now = tasks[k % len(tasks)], state_of(env, world, k, poses)
        assert env.terminated.numpy()[k] == task.success(world.geometry, now, begun[k]), task
        value = task.potential(world.geometry, now, begun[k])
        assert env._episodes.potential.numpy()[k] == pytest.approx(value, abs=2e-4), task
        assert env.observations["goal"].numpy()[k] == pytest.approx(task.goal(world.geometry, now), abs=1e-4), task
        reached += task.success(world.geometry, now, begun[k])
    assert 0.1 * worlds < reached < 0.9 * worlds


def test_the_same_seed_and_actions_give_the_same_episodes(env):
    def run(seed: int) -> list[np.ndarray]:
        rng = np.random.default_rng(0)
        first = env.reset(seed=seed, options={})[0]
        steps = [env.step(rng.uniform(-1, 1, env.action.shape))[0] for _ in range(8)]
        return [np.concatenate([v.reshape(3, -1) for v in one.values()], axis=1) for one in (first, *steps)]

    one, other, again = run(1), run(2), run(1)
    assert np.array_equal(one, again) and not np.array_equal(one[0], other[0])


def test_an_episode_begins_anew_in_the_step_after_its_end(env):
    begun = start(env, 0, 1, 2)
    still = np.zeros(env.action.shape)
    for k in range(6):
        _, _, terminated, truncated, info = env.step(still)
        assert not terminated.any() and truncated.all() == (k == 5)
    seen, rewards, terminated, truncated, info = env.step(np.ones(env.action.shape))
    assert not rewards.any() and not terminated.any() and not truncated.any()
    assert info["layout"].tolist() == [0, 1, 2] and info["room"].tolist() == [0, 0, 1]
    assert seen["objects"] == pytest.approx(begun["objects"], abs=1e-6)
    assert env.observation_space.contains(seen) and env.action_space.contains(still.astype(np.float32))
    assert all(words.split()[0] in ("open", "close", "go", "put", "pick") for words in info["instruction"])


def test_a_world_that_goes_astray_is_cut_off_and_begins_anew(env):
    begun = start(env, 0, 1, 2)
    env.physics._states[1].qvel[:] = 1e12
    _, rewards, terminated, truncated, _ = env.step(np.zeros(env.action.shape))
    assert truncated.tolist() == [False, True, False] and rewards[1] == 0 and not terminated.any()
    seen = env.step(np.zeros(env.action.shape))[0]
    assert seen["objects"][1] == pytest.approx(begun["objects"][1], abs=1e-6)


def test_the_robot_moves_as_its_actions_say(env):
    before = start(env, 0, 0, 2)
    action = np.zeros(env.action.shape)
    action[0, 3], action[1, 2], action[:, -1] = -1.0, 1.0, -1.0
    for _ in range(5):
        after = env.step(action)[0]
    moved = after["robot"][:, :9] - before["robot"][:, :9]
    assert moved[0, 3] < -0.03 and moved[1, 2] > 0.1 and abs(moved[2]).max() < 0.01
    assert after["gripper"].max() < 0.2


def test_a_bank_is_what_was_saved(bank, tmp_path):
    bank.save(tmp_path / "bank.npz")
    loaded = Bank.load(tmp_path / "bank.npz")
    assert (loaded.slots, loaded.names, loaded.instructions) == (bank.slots, bank.names, bank.instructions)
    assert all(np.array_equal(loaded.layout[k], v) for k, v in bank.layout.items())
    assert steady(loaded, device="cpu").layouts == bank.layouts


def test_wrong_input_is_named(bank, env):
    with pytest.raises(InputError, match="num_envs"):
        BatchedRoomEnv(bank, 0)
    with pytest.raises(InputError, match="robot: arm has no base"):
        BatchedRoomEnv(bank, 1, robot="arm")
    with pytest.raises(InputError, match="layout: 7"):
        env.reset(options={"layout": 7})
    with pytest.raises(InputError, match="actions: shape"):
        env.step(np.zeros(3))


@pytest.mark.slow
def test_mujoco_warp_steps_as_mujoco_c(bank):
    both = [BatchedRoomEnv(bank, 2, device="cpu", backend=kind, threads=1) for kind in ("c", "warp")]
    seen = [start(one, 0, 2) for one in both]
    assert all(seen[0][name] == pytest.approx(seen[1][name], abs=1e-5) for name in seen[0])
    rng = np.random.default_rng(0)
    for _ in range(10):
        action = rng.uniform(-1, 1, both[0].action.shape)
        (one, reward, *_), (other, rewards, *_) = (env.step(action) for env in both)
    assert all(one[name] == pytest.approx(other[name], abs=2e-3) for name in one)
    assert reward == pytest.approx(rewards, abs=1e-3) and not both[1].overflow().any()


def test_models_of_worlds_are_those_of_their_layouts(bank, env):
    start(env, 0, 1, 2)
    model, rooms, slots = env.physics.model, bank.layout["room"][[0, 1, 2]], bank.slots
    for name, rows in bank.room.items():
        first = {"geom": 1, "body": 1}.get(name.partition("_")[0], 0)
        begin = slots.still if name in ("geom_pos", "geom_quat") else 0  # those that stand still go by layout
        found = getattr(model, name).numpy()[:, first : first + rows.shape[1]]
        assert np.array_equal(found.reshape(3, *rows.shape[1:])[:, begin:], rows[rooms][:, begin:]), name
    for name, out in (("still_pos", model.geom_pos), ("still_quat", model.geom_quat), ("link_pos", model.body_pos)):
        rows = bank.layout[name][[0, 1, 2]]
        assert np.array_equal(out.numpy()[:, 1 : 1 + rows.shape[1]], rows), name


def test_only_worlds_that_end_begin_anew(env):
    start(env, 0, 1, 2)
    env.step(np.ones(env.action.shape))
    before = env.physics.data.qpos.numpy().copy()
    env._episodes.done.assign(np.array([0, 1, 0], dtype=np.int32))
    env._begin()
    after = env.physics.data.qpos.numpy()
    assert np.array_equal(after[[0, 2]], before[[0, 2]]) and not np.array_equal(after[1], before[1])
