"""Tasks on states that are made for them: done and just not done, potentials that grow, what a room offers to whom."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sceneweaver import envs
from sceneweaver.envs.grasping import grasps_of
from sceneweaver.envs.predicates import to_world
from sceneweaver.envs.world import RoomState
from tests.envs.rooms import kitchen, load

GLASS, TABLE, FRIDGE = "drinking_glass-0", "dining_table-0", "fridge-0"
AWAY = np.array([0.0, 0.0, 3.0, 1.0, 0, 0, 0])  # of the tool


@pytest.fixture(scope="module")
def geometry() -> envs.SceneGeometry:
    return envs.SceneGeometry(kitchen(), load)


@pytest.fixture(scope="module")
def begun(geometry) -> RoomState:
    """The room as it is, everything closed, the hand far from everything."""
    place = dict(zip(kitchen().ids, envs.poses_of(kitchen()), strict=True))
    bodies = {name: place[owner] for name, owner in geometry.owner.items()}
    return RoomState(bodies, dict.fromkeys(geometry.articulations, 0.0), AWAY, np.array([2.0, 1.0, 0.0]))


def with_glass(geometry: envs.SceneGeometry, state: RoomState, middle, tool=AWAY[:3]) -> RoomState:
    """The state with the glass upright, the middle of its box somewhere, and the tool elsewhere."""
    pose = np.array([*(np.asarray(middle) - geometry.items[GLASS].centre), 1.0, 0, 0, 0])
    return replace(state, bodies={**state.bodies, GLASS: pose}, tool=np.array([*tool, 1.0, 0, 0, 0]))


def tasks(geometry: envs.SceneGeometry, begun: RoomState, robot: envs.Robot) -> list[envs.Task]:
    return envs.tasks_of(geometry, robot, dict(begun.bodies))


def of_kind(geometry, begun, kind):
    return next(t for t in tasks(geometry, begun, envs.mobile_manipulator()) if type(t) is kind)


@pytest.mark.parametrize("kind", [envs.PutIn, envs.PutOn])
def test_a_thing_is_put_when_it_is_there_and_the_hand_is_away(geometry, begun, kind):
    task = of_kind(geometry, begun, kind)
    goal = task.goal(geometry, begun)
    done = with_glass(geometry, begun, goal)
    assert task.subject == GLASS and not task.success(geometry, begun, begun)
    assert task.success(geometry, done, begun)
    assert not task.success(geometry, with_glass(geometry, begun, goal, tool=goal), begun), "still in the hand"
    for off in ((0, 0, 0.4), (3.0, 0, 0)):
        assert not task.success(geometry, with_glass(geometry, begun, goal + off), begun)
    near = with_glass(geometry, begun, goal + [0.1, 0, 0.1], tool=goal)
    assert task.potential(geometry, near, begun) > task.potential(geometry, begun, begun)


def test_on_a_surface_means_on_its_level(geometry, begun):
    task = of_kind(geometry, begun, envs.PutOn)
    goal = task.goal(geometry, begun)
    for rise, done in ((0.019, True), (0.021, False), (-0.021, False)):
        assert task.success(geometry, with_glass(geometry, begun, goal + [0, 0, rise]), begun) == done
    lying = replace(begun, bodies={**begun.bodies, GLASS: np.array([*goal, np.sqrt(0.5), np.sqrt(0.5), 0, 0])})
    bottom = lying.bodies[GLASS][2] - geometry.items[GLASS].size[1] / 2
    down = replace(lying, bodies={**lying.bodies, GLASS: lying.bodies[GLASS] - [0, 0, bottom - goal[2], 0, 0, 0, 0]})
    low = goal[2] - geometry.items[GLASS].size[2] / 2
    flat = replace(down, bodies={**down.bodies, GLASS: down.bodies[GLASS] + [0, 0, low - goal[2], 0, 0, 0, 0]})
    assert task.success(geometry, flat, begun), "what lies there is there as well"


def test_a_thing_is_taken_when_it_is_up_and_in_the_hand(geometry, begun):
    task, centre = envs.Take(GLASS), to_world(begun.bodies[GLASS], geometry.items[GLASS].centre)
    for rise, tool, done in ((0.11, 0.11, True), (0.09, 0.09, False), (0.11, 1.5, False)):
        now = with_glass(geometry, begun, centre + [0, 0, rise], tool=centre + [0, 0, tool])
        assert task.success(geometry, now, begun) == done
    assert task.goal(geometry, begun) == pytest.approx(centre + [0, 0, 0.1])


@pytest.mark.parametrize(("share", "opened", "closed"), [(0.0, False, True), (0.5, False, False), (0.95, True, False)])
def test_doors_are_open_or_closed_by_their_share(geometry, begun, share, opened, closed):
    for name, door in geometry.articulations.items():
        now = replace(begun, joints={**begun.joints, name: share * door.open_end})
        assert envs.Open(name).success(geometry, now, begun) == opened
        assert envs.Close(name).success(geometry, now, begun) == closed
        assert envs.Close(name).start_joints(geometry) == {name: pytest.approx(0.7 * door.open_end)}
        gain = envs.Open(name).potential(geometry, now, begun) - envs.Open(name).potential(geometry, begun, begun)
        assert gain == pytest.approx(min(share, 0.9)), "the hand has not moved"


def test_a_base_goes_near_and_looks(geometry, begun):
    task = envs.NavigateTo(TABLE)
    item, pose = geometry.items[TABLE], begun.bodies[TABLE]
    edge = to_world(pose, np.array([item.low[0], item.centre[1], 0.0]))
    for gap, yaw, done in ((0.6, 0.0, True), (0.8, 0.0, False), (0.6, np.pi, False)):
        assert task.success(geometry, replace(begun, base=np.array([edge[0] - gap, edge[1], yaw])), begun) == done


def test_a_room_is_tidy_when_all_is_home(geometry, begun):
    home = envs.Tidy((envs.PutOn(GLASS, "kitchen_counter-0", kitchen().objects[-1].support.surface),))
    assert home.success(geometry, begun, begun) and home.scattered == (GLASS,)
    floor = with_glass(geometry, begun, (2.0, 2.0, 0.1))
    assert not home.success(geometry, floor, begun)
    assert home.potential(geometry, floor, begun) < home.potential(geometry, begun, begun) == 0.0


def test_a_room_offers_what_a_robot_can_do(geometry, begun):
    def kinds(robot: envs.Robot) -> set[type]:
        return {type(task) for task in tasks(geometry, begun, robot)}

    mobile = envs.mobile_manipulator()
    everything = {envs.Open, envs.Close, envs.PutIn, envs.PutOn, envs.Take, envs.NavigateTo, envs.Tidy}
    assert kinds(mobile) == everything
    assert kinds(envs.fixed_arm()) == everything - {envs.NavigateTo, envs.Tidy}, "it does not drive"
    assert kinds(replace(mobile, payload=0.0)) == {envs.Open, envs.Close, envs.NavigateTo}, "it lifts nothing"
    assert kinds(replace(mobile, heights=(5.0, 6.0))) == {envs.NavigateTo}, "it reaches nothing"


def test_only_what_a_hand_closes_around_has_grasps(geometry):
    assert grasps_of(geometry, TABLE) == []
    found = grasps_of(geometry, GLASS)
    assert found and all(g.width < 0.08 and g.body == GLASS for g in found)
    assert all(abs(g.approach @ g.closing) < 1e-9 for g in found)
