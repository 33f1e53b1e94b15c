"""A robot in a room: where it is in the model, how actions move it, where it can drive, layouts and their errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sceneweaver import envs
from sceneweaver.envs.batched.bank import Slots
from sceneweaver.envs.batched.template import template_of
from sceneweaver.envs.control import LEAD, Controller
from sceneweaver.envs.joining import PREFIX, indices_of
from sceneweaver.scene import InputError, Scene
from tests.envs.rooms import kitchen, load


@pytest.fixture(scope="module")
def world() -> envs.World:
    return envs.World(kitchen(), envs.mobile_manipulator(), load)


def start(world: envs.World, base=(2.0, 1.5, 0.0)):
    data = world.new_data()
    world.place(data, envs.poses_of(world.scene), np.array(base))
    return data


def test_a_robot_is_found_by_its_names(world):
    model, at = world.model, world.indices
    driven = [*world.robot.base, *world.robot.arm]
    assert [model.joint(PREFIX + name).qposadr[0] for name in driven] == at.drive_position.tolist()
    assert [model.actuator(int(k)).name for k in at.drive] == [PREFIX + name for name in driven]
    assert [model.actuator(int(k)).name for k in at.fingers] == [PREFIX + name for name in world.robot.gripper]
    assert at.base.tolist() == at.drive_position[:3].tolist() and at.speeds[0] == world.robot.speeds["base_x"]
    assert model.body(at.body).name == PREFIX + "base" and model.site(at.tool).name == PREFIX + "tool"


def test_a_robot_of_a_file_is_the_same_in_one_room_and_in_a_batch(world, tmp_path):
    own = world.robot
    path = tmp_path / "mine.xml"
    path.write_text(own.xml, encoding="utf-8")
    more = {"base": own.base, "home": own.home, "speeds": own.speeds}
    robot = envs.Robot.from_mjcf(path, tool=own.tool, arm=own.arm, gripper=own.gripper, **more)
    assert envs.World(kitchen(), robot, load).model.nu == world.model.nu
    slots = Slots(3, (1,), (1,), (2,))
    drawn, read = (template_of(slots, one) for one in (own, robot))
    assert (drawn.nq, drawn.nbody, drawn.ngeom) == (read.nq, read.nbody, read.ngeom)
    assert indices_of(read, robot).drive_position.tolist() == indices_of(drawn, own).drive_position.tolist()
    assert drawn.body(indices_of(drawn, own).body - 1).name == "free:0", "after the slots"


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"tool": "tail"}, "robot: tool 'tail' is not in its MJCF"),
        ({"arm": ("lift", "tail")}, "robot: base or arm 'tail' is not in its MJCF"),
        ({"gripper": ("tail",)}, "robot: gripper 'tail' is not in its MJCF"),
        (
            {"arm": ("lift", "finger_left"), "gripper": ("finger_right",), "xml": None},
            "robot: joint 'finger_left' has no actuator",
        ),
        ({"xml": "<mujoco"}, "robot: mobile does not fit into the room's model"),
    ],
)
def test_what_is_wrong_with_a_robot_is_named(world, changes, text):
    without = world.robot.xml.replace(
        '<position name="finger_left" joint="finger_left"', '<position name="x" joint="lift"'
    )
    changes = {key: without if value is None else value for key, value in changes.items()}
    empty = Scene(id="empty", room=kitchen().room)
    with pytest.raises(InputError, match=text):
        envs.World(empty, replace(world.robot, **changes))


def test_actions_move_targets_by_speed_and_no_farther_than_the_lead(world):
    controller = Controller(world, "joint", 0.04)
    data = start(world, (2.0, 1.5, np.pi / 2))
    at, action = world.indices, np.zeros(controller.size)
    action[0], action[3], action[-1] = 1.0, -5.0, -1.0  # ahead, down at top speed, hand closed
    before = data.ctrl[at.drive].copy()
    controller.apply(data, action)
    moved = data.ctrl[at.drive] - before
    assert moved[:4] == pytest.approx([0, 0.04 * at.speeds[0], 0, -0.04 * at.speeds[3]], abs=1e-12), "its ahead is +y"
    assert data.ctrl[at.fingers].tolist() == [0.0, 0.0]
    for _ in range(50):  # the joints stand still: targets wait for them
        controller.apply(data, action)
    assert data.ctrl[at.drive][3] == pytest.approx(before[3] - LEAD * at.speeds[3])


def test_placing_leaves_nothing_of_what_went_before(world):
    data = start(world)
    begun = data.qpos.copy()
    data.qpos += 0.3
    data.qvel[:] = 1.0
    world.place(data, envs.poses_of(world.scene), np.array([2.0, 1.5, 0.0]))
    assert np.array_equal(data.qpos, begun) and not data.qvel.any() and data.time == 0.0
    assert world.gripper_opening(data) == pytest.approx(1.0) and world.base(data) == pytest.approx([2.0, 1.5, 0.0])


def test_ways_go_around_furniture(world):
    floor = envs.FloorMap(world, start(world))
    table = np.array([2.9, 3.0])
    row, column = np.unravel_index(np.linalg.norm(floor.points - table, axis=-1).argmin(), floor.free.shape)
    assert not floor.free[row, column] and floor.free[floor.cell(table)]
    way = floor.path(np.array([1.6, 3.2]), np.array([2.9, 1.2]))
    assert way[0].tolist() == [1.6, 3.2] and way[-1].tolist() == [2.9, 1.2]
    assert all(floor.free[floor.cell(point)] for point in way[1:-1])
    assert np.linalg.norm(np.diff(way, axis=0), axis=1).max() < 0.2
    floor.free[:] = False
    with pytest.raises(LookupError, match="no free floor"):
        floor.cell(table)


def test_layouts_are_poses_however_they_are_given():
    scene, count = kitchen(), len(kitchen().objects)
    yaws = np.zeros((2, count, 4))
    yaws[1, 0] = 1.0, 2.0, 0.5, np.pi / 2
    found = envs.layouts_of(scene, yaws)
    assert found[1, 0] == pytest.approx([1, 2, 0.5, np.sqrt(0.5), 0, 0, np.sqrt(0.5)])
    longer = np.concatenate([found[..., :3], 3 * found[..., 3:]], axis=-1)
    assert envs.layouts_of(scene, longer) == pytest.approx(found), "quaternions of any length"
    assert np.array_equal(envs.layouts_of(scene), envs.layouts_of(scene, [scene]))
    yaws[0, 0, 0] = np.nan
    with pytest.raises(InputError, match="layouts: numbers must be finite"):
        envs.layouts_of(scene, yaws)
