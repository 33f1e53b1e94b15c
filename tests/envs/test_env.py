"""Rooms as environments: Gymnasium's own checker, resets that restore everything, tasks by words, errors by name."""

from __future__ import annotations

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from sceneweaver import envs
from sceneweaver.scene import InputError
from tests.envs.rooms import kitchen, load


@pytest.fixture(scope="module")
def env() -> envs.RoomEnv:
    return envs.make(kitchen(), load=load)


def same(one: dict, other: dict) -> bool:
    return all(np.array_equal(one[name], other[name]) for name in one)


@pytest.mark.filterwarnings("ignore:.*alternative render modes.*")
def test_the_checker_of_gymnasium_finds_nothing(env, recwarn):
    check_env(env)
    assert [w for w in recwarn if "render modes" not in str(w.message)] == []


def test_the_same_seed_and_actions_give_the_same_episode(env):
    def run(seed: int) -> list[dict]:
        first, _ = env.reset(seed=seed)
        rng = np.random.default_rng(0)
        steps = [env.step(rng.uniform(-1, 1, env.action_space.shape)) for _ in range(25)]
        return [first, *(step[0] for step in steps)]

    one, _, again = run(3), run(4), run(3)
    assert all(same(a, b) for a, b in zip(one, again, strict=True))
    assert not same(one[0], one[-1])


def test_layouts_of_a_room_stand_where_they_should():
    layouts = np.stack([envs.poses_of(kitchen(turn)) for turn in (0.0, 0.5, 1.0)])
    env = envs.make(kitchen(), layouts=layouts, load=load, task="go to the table")
    table = env.world.item_names.index("dining_table-0")
    for number in (2, 0, 1):
        observation, info = env.reset(seed=number, options={"layout": number})
        assert info["layout"] == number
        assert observation["objects"][table] == pytest.approx(layouts[number][3], abs=1e-5)


def test_rooms_of_other_sizes_have_the_same_observations():
    smaller = kitchen().model_copy(update={"id": "less", "objects": kitchen().objects[:2]})
    env = envs.make([kitchen(), smaller], load=load, task="go to the fridge")
    shapes = {number: env.reset(seed=0, options={"scene": number})[0] for number in (0, 1)}
    assert all(env.observation_space.contains(found) for found in shapes.values())
    assert not shapes[1]["objects"][2:].any()


def test_words_find_tasks(env):
    words = {
        "open the kitchen counter": envs.Open,
        "close kitchen_counter-0.unit-0-drawer-1": envs.Close,
        "take the glass": envs.Take,
        "Put the glass on the dining table": envs.PutOn,
        "go to the sink cabinet": envs.NavigateTo,
        "tidy": envs.Tidy,
    }
    for text, kind in words.items():
        env.reset(seed=0, options={"task": text})
        assert isinstance(env.task, kind), text


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"task": "open the glass"}, "task: 'open the glass' is not feasible in scene 'small-kitchen'"),
        ({"task": "eat the glass"}, "task: 'eat the glass' has no known verb"),
        ({"robot": "cat"}, "robot: 'cat' is not known"),
        ({"control": "mind"}, "control: 'mind' is not known"),
        ({"render_mode": "human"}, "render_mode: 'human' is not known"),
        ({"layouts": np.zeros((2, 3, 4))}, r"layouts: shape \(2, 3, 4\); give"),
        ({"layouts": [kitchen().model_copy(update={"objects": ()})]}, r"layouts\[0\]: not the objects of the scene"),
    ],
)
def test_what_is_wrong_is_named(changes, text):
    with pytest.raises(InputError, match=text):
        envs.make(kitchen(), load=load, **changes).reset(seed=0)


def test_an_episode_ends_at_its_limit_and_the_registry_knows_the_room():
    env = gymnasium.make("sceneweaver/Room-v0", scenes=kitchen(), task="take the glass", load=load, max_steps=3)
    env.reset(seed=0)
    ends = [env.step(env.action_space.sample())[2:4] for _ in range(3)]
    assert ends == [(False, False), (False, False), (False, True)]
    env.close()


def test_the_tool_follows_its_velocity():
    env = envs.make(kitchen(), task="take the glass", control="ee", load=load)
    env.reset(seed=0, options={"base": (2.0, 1.5, 0.0)})
    begin = env.state.tool[:3]
    action = np.zeros(env.action_space.shape)
    action[3:6] = 0.4, 0.0, -0.4
    for _ in range(50):
        env.step(action)
    assert env.state.tool[:3] - begin == pytest.approx([0.2, 0.0, -0.2], abs=0.03)


def test_the_fixed_arm_stands_before_what_it_is_asked_for():
    env = envs.make(kitchen(), task="take the glass", robot="arm", load=load)
    observation, _ = env.reset(seed=1)
    far = np.linalg.norm(observation["base"][:2] - observation["goal"][:2])
    assert 0.4 < far < env.robot.reach
    env.step(env.action_space.sample())
    assert env.state.base == pytest.approx(observation["base"], abs=1e-6)
