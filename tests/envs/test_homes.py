"""Homes as an environment: it is Gymnasium's, the base stays on the floor, and the shortest way leads to the goal."""

import gymnasium
import numpy as np
import pytest
import shapely
from gymnasium.utils.env_checker import check_env

from sceneweaver.envs import HomeEnv
from sceneweaver.home import Home
from sceneweaver.navigation import point_goal_episodes, save_episodes
from sceneweaver.scene import InputError
from tests.navigation.full import full_flat, largest
from tests.verify.home.homes import flat, house


@pytest.mark.parametrize("task", ["pointnav", "objectnav"])
def test_it_is_an_environment_of_gymnasium(task):
    env = gymnasium.make("sceneweaver/Home-v0", homes=full_flat(), task=task, count=3, seed=1, render_mode="rgb_array")
    check_env(env.unwrapped, skip_render_check=True)
    env.reset(seed=0)
    picture = env.render()
    assert isinstance(picture, np.ndarray) and picture.dtype == np.uint8 and picture.shape[2] == 3
    assert (picture == (210, 50, 40)).all(axis=2).any()


@pytest.mark.parametrize(("task", "turn"), [("pointnav", 30.0), ("objectnav", 30.0), ("pointnav", 10.0)])
def test_the_expert_reaches_the_goal_on_nearly_the_shortest_way(task, turn):
    env = HomeEnv(full_flat(), task=task, count=12, seed=3, turn=turn)
    for number in range(12):
        _, info = env.reset(options={"episode": number})
        first, total, done = info["distance_to_goal"], 0.0, False
        assert first == pytest.approx(env.episode.geodesic, abs=1e-3)
        while not done:
            _, reward, done, cut, info = env.step(env.expert_action())
            total += reward
            assert not cut
        assert info["success"] and info["spl"] > 0.8
        assert total == pytest.approx(first - info["distance_to_goal"] + 1.0, abs=1e-6)


def test_the_base_stays_on_the_floor_and_slides():
    env = HomeEnv(full_flat(), count=4, seed=0, max_steps=10_000)
    env.reset(seed=5)
    floor, met = largest(env.roadmap).buffer(1e-5), 0
    rng = np.random.default_rng(0)
    for _ in range(600):
        before = env.position.copy()
        *_, info = env.step(rng.choice([1, 1, 1, 2, 3]))
        assert floor.covers(shapely.Point(env.position))
        moved = np.linalg.norm(env.position - before)
        assert moved <= 0.25 + 1e-6
        met += info["collided"]
        assert info["collided"] or moved == 0 or moved == pytest.approx(0.25)
    assert 20 < met < 500


def test_a_scan_sees_walls_and_furniture():
    """From the middle of the empty hall: 0.8 m to either wall, and nothing within 2 m along it."""
    env = HomeEnv(Home.example("flat"), count=3, seed=0, rays=4, reach=2.0)
    observation, _ = env.reset()
    env.position, env.yaw = np.array([5.4, 1.6]), np.pi / 2
    observation = env._observe()
    np.testing.assert_allclose(observation["scan"][[1, 3]], [0.8, 0.8], atol=1e-6)
    assert observation["scan"][0] == pytest.approx(2.0)
    assert env.observation_space.contains(observation)


def test_equal_seeds_and_actions_give_equal_observations():
    def run():
        env = HomeEnv([full_flat(), Home.example("flat")], count=3, seed=2)
        rng = np.random.default_rng(1)
        found = [env.reset(seed=7)]
        found += [env.step(int(rng.integers(1, 4)))[0] for _ in range(30)]
        return repr(found)

    assert run() == run()


def test_episodes_are_read_from_files(tmp_path):
    home = full_flat()
    home.save(tmp_path / "home.json")
    made = point_goal_episodes(home, count=3, seed=4)
    save_episodes(made, tmp_path / "val.json.gz")
    env = HomeEnv(tmp_path / "home.json", tmp_path / "val.json.gz")
    assert env.episodes == (made,)
    _, info = env.reset(options={"episode": 2})
    assert info["episode"] == "2" and info["distance_to_goal"] == pytest.approx(made.episodes[2].geodesic, abs=1e-3)


def test_a_base_on_wheels_stays_on_its_storey():
    env = HomeEnv(house(), count=10, seed=0)
    assert {(e.start[2], e.goal[2]) for e in env.episodes[0].episodes} == {(0.0, 0.0), (2.7, 2.7)}


@pytest.mark.parametrize(
    ("bad", "said"),
    [
        ({"task": "dance"}, "task: 'dance'"),
        ({"task": "objectnav"}, "home 'flat' has none"),
        ({"render_mode": "human"}, "render_mode"),
        ({"step": 0.0}, "step is 0.0"),
        ({"episodes": []}, "0 sets for 1 homes"),
    ],
)
def test_bad_input_is_refused(bad, said):
    with pytest.raises(InputError, match=said):
        HomeEnv(flat(), **bad)
    with pytest.raises(InputError, match="none is given"):
        HomeEnv([])
