"""Kernels of actions, tasks and observations: what `sceneweaver.envs.control` and `sceneweaver.envs.tasks` say."""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

import warp as wp

from sceneweaver.envs.predicates import FACING, LEVEL
from sceneweaver.envs.tasks import KINDS, RELEASED

from .structs import Episodes, Goal, Layouts, Observations, RobotArrays, Simulation

wp.set_module_options({"enable_backward": False})

FIRST_BODY = wp.constant(1)
"""Number of the first moving body in the model: 0 is the world."""

OPEN, CLOSE, NAVIGATE, PUT_IN, PUT_ON, TAKE = (wp.constant(k) for k in range(len(KINDS)))  # as `tasks.KINDS` has them

_FACING, _ON, _RELEASED = wp.constant(FACING), wp.constant(LEVEL), wp.constant(RELEASED)
_HUGE = wp.constant(1.0e6)  # positions beyond it are of a simulation that went astray


@wp.func
def turned(
    # Problem:
    quat: wp.quat,
    vector: wp.vec3,
):
    """A vector turned by a quaternion (w, x, y, z)."""
    axis = wp.vec3(quat[1], quat[2], quat[3])
    return vector + 2.0 * wp.cross(axis, wp.cross(axis, vector) + quat[0] * vector)


@wp.func
def local(
    # Problem:
    pos: wp.vec3,
    quat: wp.quat,
    point: wp.vec3,
):
    """A point of the world in a frame."""
    return turned(wp.quat(quat[0], -quat[1], -quat[2], -quat[3]), point - pos)


@wp.func
def wrapped(
    # Problem:
    angle: float,
):
    """An angle in -pi..pi."""
    return angle - 2.0 * wp.pi * wp.floor((angle + wp.pi) / (2.0 * wp.pi))


@wp.func
def way_to(
    # Problem:
    goal: Goal,
    pos: wp.vec3,
    quat: wp.quat,
    base: wp.vec3,
):
    """Distance [m] in the plane from a base (x, y, yaw) to the box of what a goal is about, as `distance_to_box`."""
    at = local(pos, quat, wp.vec3(base[0], base[1], pos[2]))
    dx = wp.max(wp.max(goal.item_low[0] - at[0], at[0] - goal.item_high[0]), 0.0)
    dy = wp.max(wp.max(goal.item_low[1] - at[1], at[1] - goal.item_high[1]), 0.0)
    return wp.sqrt(dx * dx + dy * dy)


@wp.func
def is_inside(
    # Problem:
    goal: Goal,
    point: wp.vec3,
):
    """Whether a point of the holder's frame is in the interior of a goal, as `predicates.is_inside`."""
    half = (goal.high - goal.low) * 0.5
    at = point - (goal.low + goal.high) * 0.5
    share = wp.vec3(at[0] / wp.max(half[0], 1e-9), at[1] / wp.max(half[1], 1e-9), at[2] / wp.max(half[2], 1e-9))
    inside = wp.abs(share[0]) <= 1.0 and wp.abs(share[1]) <= 1.0 and wp.abs(share[2]) <= 1.0
    return inside and (goal.oval == 0 or share[0] * share[0] + share[1] * share[1] <= 1.0)


@wp.func
def is_on(
    # Problem:
    goal: Goal,
    point: wp.vec3,
):
    """Whether a point of the holder's frame is on the surface of a goal, as `predicates.is_on`."""
    x, y = point[0], point[1]
    over = x >= goal.low[0] and x <= goal.high[0] and y >= goal.low[1] and y <= goal.high[1]
    return over and wp.abs(point[2] - goal.low[2]) <= _ON


@wp.func
def lowest(
    # Problem:
    goal: Goal,
    pos: wp.vec3,
    quat: wp.quat,
):
    """Height [m] of the lowest corner of the box of what a goal is about."""
    low = float(1.0e9)  # noqa: UP018 - a variable of a loop in Warp
    for k in range(8):
        x = wp.where(k % 2 == 0, goal.item_low[0], goal.item_high[0])
        y = wp.where(k // 2 % 2 == 0, goal.item_low[1], goal.item_high[1])
        z = wp.where(k // 4 == 0, goal.item_low[2], goal.item_high[2])
        corner = pos + turned(quat, wp.vec3(x, y, z))
        low = wp.min(low, corner[2])
    return low


@wp.func
def pose_of(
    # Problem:
    sim: Simulation,
    world: int,
    slot: int,
    pos: wp.vec3,
    quat: wp.quat,
):
    """Where the body in a slot is; without one (-1) the place that is given."""
    if slot >= 0:
        return sim.xpos[world, FIRST_BODY + slot], sim.xquat[world, FIRST_BODY + slot]
    return pos, quat


@wp.func
def progress(
    # Problem:
    goal: Goal,
    robot: RobotArrays,
    sim: Simulation,
    episodes: Episodes,
    world: int,
    pos: wp.vec3,
    quat: wp.quat,
    base: wp.vec3,
):
    """Whether a task is done, its potential, and the point to go or to bring things to.

    ``pos`` and ``quat`` are those of what it is about, ``base`` is x, y, yaw of the robot.
    """
    centre = pos + turned(quat, goal.centre)
    hand = wp.length(centre - sim.site_xpos[world, robot.tool])
    free = hand > goal.radius + _RELEASED
    target = centre
    success = False
    value = 0.0
    if goal.kind == OPEN or goal.kind == CLOSE:
        opened = wp.clamp(sim.qpos[world, goal.joint] / goal.open_end, 0.0, 1.0)
        if goal.kind == OPEN:
            success = opened >= goal.share
            value = -wp.max(goal.share - opened, 0.0) - 0.5 * hand
        else:
            success = opened <= goal.share
            value = -opened - 0.5 * hand
    elif goal.kind == NAVIGATE:
        way = way_to(goal, pos, quat, base)
        aside = wp.abs(wrapped(wp.atan2(centre[1] - base[1], centre[0] - base[0]) - base[2]))
        success = way <= goal.share and aside <= _FACING
        value = -wp.max(way - goal.share, 0.0) - 0.5 * aside / wp.pi
    elif goal.kind == PUT_IN or goal.kind == PUT_ON:
        holder_pos, holder_quat = pose_of(sim, world, goal.holder, goal.holder_pos, goal.holder_quat)
        tall = goal.item_high[2] - goal.item_low[2]
        target = holder_pos + turned(holder_quat, goal.spot + wp.vec3(0.0, 0.0, tall * 0.5))
        if goal.kind == PUT_IN:
            success = is_inside(goal, local(holder_pos, holder_quat, centre)) and free
        else:
            bottom = wp.vec3(centre[0], centre[1], lowest(goal, pos, quat))
            success = is_on(goal, local(holder_pos, holder_quat, bottom)) and free
        value = -wp.length(centre - target) - 0.5 * hand
    elif goal.kind == TAKE:
        success = pos[2] - episodes.start_height[world] >= goal.share and not free
        target = centre + wp.vec3(0.0, 0.0, goal.share)
        value = -wp.length(centre - episodes.start_goal[world]) - 0.5 * hand
    return success, value, target


@wp.func
def went_astray(
    # Problem:
    sim: Simulation,
    world: int,
):
    """Whether a simulation has positions that are too large, or no numbers."""
    astray = int(0)  # noqa: UP018 - a variable of a loop in Warp
    for k in range(sim.qpos.shape[1]):
        if not (wp.abs(sim.qpos[world, k]) < _HUGE):
            astray = int(1)  # noqa: UP018
    return astray != 0


@wp.kernel
def apply_actions(
    # Problem:
    period: float,
    lead: float,
    robot: RobotArrays,
    # State in:
    action: wp.array2d(dtype=float),
    # State in and out:
    sim: Simulation,
):
    """Targets ``sim.ctrl`` from actions [W, A] in -1..1, as `control.Controller` with "joint" makes them.

    Args:
        period: Of an action [s]; ``lead`` [s] how far targets run ahead.
        robot: Where it is in the model.
        action: [W, A]: the base, the arm, the gripper.
        sim: The simulation.
    """
    world = wp.tid()
    yaw = sim.qpos[world, robot.base[2]]
    c = wp.cos(yaw)
    s = wp.sin(yaw)
    for k in range(robot.drive.shape[0]):
        share = wp.clamp(action[world, k], -1.0, 1.0) * robot.speeds[k]
        if k < 2:  # x and y of the base: actions are ahead and to the left
            ahead = wp.clamp(action[world, 0], -1.0, 1.0) * robot.speeds[0]
            left = wp.clamp(action[world, 1], -1.0, 1.0) * robot.speeds[1]
            share = wp.where(k == 0, c * ahead - s * left, s * ahead + c * left)
        at = robot.drive[k]
        now = sim.qpos[world, robot.drive_position[k]]
        reach = lead * robot.speeds[k]
        target = wp.clamp(sim.ctrl[world, at] + share * period, now - reach, now + reach)
        sim.ctrl[world, at] = wp.clamp(target, robot.ctrl_range[at][0], robot.ctrl_range[at][1])
    closed = action.shape[1] - 1
    for k in range(robot.fingers.shape[0]):
        at = robot.fingers[k]
        span = robot.ctrl_range[at]
        sim.ctrl[world, at] = span[0] + (span[1] - span[0]) * (wp.clamp(action[world, closed], -1.0, 1.0) + 1.0) / 2.0


@wp.kernel
def judge(
    # Problem:
    most_steps: int,
    robot: RobotArrays,
    layouts: Layouts,
    # State in:
    sim: Simulation,
    # State in and out:
    episodes: Episodes,
    # State out:
    reward_out: wp.array(dtype=float),
    terminated_out: wp.array(dtype=bool),
    truncated_out: wp.array(dtype=bool),
    seen_out: Observations,
):
    """Success, potential and reward of each world's task, and what is seen of it.

    Args:
        most_steps: After which an episode is cut off.
        robot: Where it is in the model.
        layouts: With their goals.
        sim: The simulation.
        episodes: Those that begin get no reward, nor those that went astray, which are cut off.
        reward_out, terminated_out, truncated_out: [W] as Gymnasium has them.
        seen_out: ``subject``, ``goal`` and ``base``.
    """
    world = wp.tid()
    g = layouts.goals[episodes.layout[world], episodes.goal[world]]
    pos, quat = pose_of(sim, world, g.subject, g.subject_pos, g.subject_quat)
    base = wp.vec3(sim.qpos[world, robot.base[0]], sim.qpos[world, robot.base[1]], sim.qpos[world, robot.base[2]])
    fresh = episodes.fresh[world] != 0
    if fresh:
        episodes.start_height[world] = pos[2]
        episodes.start_goal[world] = pos + turned(quat, g.centre) + wp.vec3(0.0, 0.0, g.share)
    success, value, target = progress(g, robot, sim, episodes, world, pos, quat, base)
    reward = 0.0
    cut = False
    if went_astray(sim, world):
        cut = True
        success = False
        value = 0.0
    elif fresh:
        success = False
    else:
        episodes.steps[world] = episodes.steps[world] + 1
        reward = value - episodes.potential[world] + wp.where(success, 1.0, 0.0)
        cut = episodes.steps[world] >= most_steps
    episodes.potential[world] = value
    episodes.done[world] = wp.where(success or cut, 1, 0)
    reward_out[world] = reward
    terminated_out[world] = success
    truncated_out[world] = cut
    for k in range(3):
        seen_out.subject[world, k] = pos[k]
        seen_out.goal[world, k] = target[k]
        seen_out.base[world, k] = base[k]
    for k in range(4):
        seen_out.subject[world, 3 + k] = quat[k]


@wp.kernel
def observe(
    # Problem:
    robot: RobotArrays,
    layouts: Layouts,
    # State in:
    episodes: Episodes,
    sim: Simulation,
    # State out:
    seen_out: Observations,
):
    """Observations of robot, doors, objects and the kind of task."""
    world = wp.tid()
    count = robot.drive_position.shape[0]
    for k in range(count):
        seen_out.robot[world, k] = sim.qpos[world, robot.drive_position[k]]
        seen_out.robot[world, count + k] = sim.qvel[world, robot.drive_dof[k]]
    turn = wp.quat_from_matrix(sim.site_xmat[world, robot.tool])
    for k in range(3):
        seen_out.tool[world, k] = sim.site_xpos[world, robot.tool][k]
        seen_out.tool[world, 4 + k] = turn[k]
    seen_out.tool[world, 3] = turn[3]
    seen_out.gripper[world, 0] = 0.0
    if robot.fingers.shape[0] > 0:
        span = robot.ctrl_range[robot.fingers[0]]
        wide = (sim.qpos[world, robot.finger_position[0]] - span[0]) / (span[1] - span[0])
        seen_out.gripper[world, 0] = wp.clamp(wide, 0.0, 1.0)
    layout = episodes.layout[world]
    room = layouts.room[layout]
    links = seen_out.doors.shape[1]
    for k in range(links):
        seen_out.doors[world, k] = sim.qpos[world, k]
    for k in range(seen_out.objects.shape[1]):
        for i in range(7):
            seen_out.objects[world, k, i] = 0.0
        if layouts.used[room, links + k] != 0:
            pos = sim.xpos[world, FIRST_BODY + links + k]
            quat = sim.xquat[world, FIRST_BODY + links + k]
            for i in range(3):
                seen_out.objects[world, k, i] = pos[i]
            for i in range(4):
                seen_out.objects[world, k, 3 + i] = quat[i]
    kind = layouts.goals[layout, episodes.goal[world]].kind
    for k in range(seen_out.task.shape[1]):
        seen_out.task[world, k] = wp.where(k == kind, 1.0, 0.0)
