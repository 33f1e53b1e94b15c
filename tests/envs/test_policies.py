"""A robot opens, takes and puts by contact alone."""

from __future__ import annotations

import numpy as np
import pytest

from sceneweaver import envs
from sceneweaver.envs.joining import PREFIX
from sceneweaver.envs.kinematics import ToolPose, configuration
from sceneweaver.envs.planning import link_pose
from sceneweaver.envs.policies import Failed, solve
from tests.envs.rooms import kitchen, load


@pytest.fixture(scope="module")
def env() -> envs.RoomEnv:
    return envs.make(kitchen(), load=load)


def test_configurations_bring_the_tool_where_it_should_be(env):
    env.reset(seed=0, options={"task": "take the glass", "base": (2.5, 1.5, 0.0)})
    world, data = env.world, env.data
    rng, found = np.random.default_rng(0), 0
    for _ in range(60):
        approach = rng.normal(size=3)
        approach /= np.linalg.norm(approach)
        closing = np.cross(approach, rng.normal(size=3))
        closing /= np.linalg.norm(closing)
        tool = ToolPose(rng.uniform((1, 1, 0.4), (3, 3, 1.2)), approach, closing)
        joints = configuration(tool, rng.uniform(-3, 3), rng.uniform(0, 0.5))
        if joints is None:
            continue
        found += 1
        data.qpos[world.indices.drive_position] = joints
        world.forward(data)
        turned = data.site(PREFIX + "tool").xmat.reshape(3, 3)
        assert world.tool(data)[:3] == pytest.approx(tool.position, abs=1e-6)
        assert turned[:, 2] == pytest.approx(approach, abs=1e-6)
        assert abs(turned[:, 1] @ closing) == pytest.approx(1.0, abs=1e-6)
    assert found > 10


def test_doors_turn_and_slide_as_in_the_simulation(env):
    env.reset(seed=0, options={"task": "take the glass"})
    world, data = env.world, env.data
    for name, door in world.geometry.articulations.items():
        data.joint(name).qpos[0] = 0.7 * door.open_end
        world.forward(data)
        pose = link_pose(door, world.pose(data, door.object), 0.7 * door.open_end)
        assert world.pose(data, name) == pytest.approx(pose, abs=1e-6)


@pytest.mark.slow
def test_a_glass_is_taken(env):
    env.reset(seed=1, options={"task": "take the glass"})
    before = env.state.bodies["drinking_glass-0"][2]
    assert solve(env)
    assert env.state.bodies["drinking_glass-0"][2] > before + 0.1


def test_what_no_policy_knows_is_said(env):
    env.reset(seed=1, options={"task": "tidy"})
    with pytest.raises(Failed, match="no policy for Tidy"):
        solve(env)


@pytest.mark.slow
@pytest.mark.parametrize("task", ["open the fridge", "put the glass in the sink"])
@pytest.mark.parametrize("seed", [0, 1])
def test_doors_open_and_things_are_put(env, task, seed):
    env.reset(seed=seed, options={"task": task})
    assert solve(env)
