"""Kernels of actions, tasks and observations: what `sceneweaver.envs.control` and `sceneweaver.envs.tasks` say.

Quaternions are (w, x, y, z), as MuJoCo Warp has them in arrays of ``wp.quat``.
"""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

import warp as wp

from sceneweaver.envs.predicates import FACING, LEVEL
from sceneweaver.envs.tasks import KINDS

wp.set_module_options({"enable_backward": False})

OPEN, CLOSE, NAVIGATE, PUT_IN, PUT_ON, TAKE = (wp.constant(k) for k in range(len(KINDS)))  # as `tasks.KINDS` has them

_FACING, _ON = wp.constant(FACING), wp.constant(LEVEL)
_HUGE = wp.constant(1.0e6)  # positions beyond it are of a simulation that went astray


@wp.struct
class Goal:
    """A row of `goals.GOAL`."""

    kind: wp.int32
    subject: wp.int32
    holder: wp.int32
    joint: wp.int32
    oval: wp.int32
    share: wp.float32
    open_end: wp.float32
    begin: wp.float32
    radius: wp.float32
    centre: wp.vec3
    item_low: wp.vec3
    item_high: wp.vec3
    low: wp.vec3
    high: wp.vec3
    subject_pos: wp.vec3
    subject_quat: wp.quat
    holder_pos: wp.vec3
    holder_quat: wp.quat


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


@wp.kernel
def apply_actions(
    # Problem:
    bases: int,
    period: float,
    lead: float,
    speeds: wp.array(dtype=float),
    drive: wp.array(dtype=int),
    drive_position: wp.array(dtype=int),
    ctrl_range: wp.array(dtype=wp.vec2),
    fingers: wp.array(dtype=int),
    # State in:
    action: wp.array2d(dtype=float),
    qpos: wp.array2d(dtype=float),
    # State in and out:
    ctrl: wp.array2d(dtype=float),
):
    """Targets [W, nu] from actions [W, A], as `control.Controller` with "joint" makes them.

    Args:
        bases: How many of the driven joints are the base's: 3 or 0.
        period: Of an action [s]; ``lead`` [s] how far targets run ahead.
        speeds: [D] top speeds of the driven joints.
        drive: [D] their actuators; ``drive_position`` [D] their positions in ``qpos``.
        ctrl_range: [nu] limits of targets.
        fingers: Actuators of the gripper.
        action: [W, A] in -1..1; ``qpos`` [W, nq]; ``ctrl`` [W, nu].
    """
    world = wp.tid()
    yaw = 0.0
    if bases == 3:
        yaw = qpos[world, drive_position[2]]
    c = wp.cos(yaw)
    s = wp.sin(yaw)
    for k in range(drive.shape[0]):
        share = wp.clamp(action[world, k], -1.0, 1.0) * speeds[k]
        if bases == 3 and k < 2:
            ahead = wp.clamp(action[world, 0], -1.0, 1.0) * speeds[0]
            left = wp.clamp(action[world, 1], -1.0, 1.0) * speeds[1]
            share = wp.where(k == 0, c * ahead - s * left, s * ahead + c * left)
        at = drive[k]
        now = qpos[world, drive_position[k]]
        reach = lead * speeds[k]
        target = wp.clamp(ctrl[world, at] + share * period, now - reach, now + reach)
        ctrl[world, at] = wp.clamp(target, ctrl_range[at][0], ctrl_range[at][1])
    closed = action.shape[1] - 1
    for k in range(fingers.shape[0]):
        at = fingers[k]
        span = ctrl_range[at]
        ctrl[world, at] = span[0] + (span[1] - span[0]) * (wp.clamp(action[world, closed], -1.0, 1.0) + 1.0) / 2.0


@wp.kernel
def judge(
    # Problem:
    first: int,
    base: wp.vec3i,
    robot: int,
    tool: int,
    most_steps: int,
    released: float,
    goals: wp.array2d(dtype=Goal),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    chosen: wp.array(dtype=int),
    qpos: wp.array2d(dtype=float),
    xpos: wp.array2d(dtype=wp.vec3),
    xquat: wp.array2d(dtype=wp.quat),
    site_xpos: wp.array2d(dtype=wp.vec3),
    # State in and out:
    steps: wp.array(dtype=int),
    potential: wp.array(dtype=float),
    start_height: wp.array(dtype=float),
    start_goal: wp.array(dtype=wp.vec3),
    # State out:
    reward_out: wp.array(dtype=float),
    terminated_out: wp.array(dtype=bool),
    truncated_out: wp.array(dtype=bool),
    done_out: wp.array(dtype=int),
    subject_out: wp.array2d(dtype=float),
    goal_out: wp.array2d(dtype=float),
    base_out: wp.array2d(dtype=float),
):
    """Success, potential and reward of each world's task; all arrays [W] or [W, n].

    Args:
        first: Number of the first moving body in the model.
        base: Positions of the base's x, y and yaw in ``qpos``; less than 0: the robot stands at its ``robot`` body.
        robot, tool: Its root body and the site between its fingers.
        most_steps: After which an episode is cut off.
        released: Distance [m] of the tool from a thing's box from which it is let go.
        goals: [V, K] tasks of the layouts.
        fresh: Worlds that begin an episode get no reward, nor those that went astray, whose episode is cut off.
        layout, chosen: Rows of ``goals``.
        qpos, xpos, xquat, site_xpos: State of the simulation.
        steps: Of the episode so far.
        potential: Of the step before; ``start_height`` and ``start_goal`` of `Take`: where its thing began.
        reward_out, terminated_out, truncated_out, done_out: As Gymnasium has them.
        subject_out: [W, 7] pose of what the task is about; ``goal_out`` [W, 3] where to bring it; ``base_out`` [W, 3].
    """
    world = wp.tid()
    g = goals[layout[world], chosen[world]]
    pos = g.subject_pos
    quat = g.subject_quat
    if g.subject >= 0:
        pos = xpos[world, first + g.subject]
        quat = xquat[world, first + g.subject]
    holder_pos = g.holder_pos
    holder_quat = g.holder_quat
    if g.holder >= 0:
        holder_pos = xpos[world, first + g.holder]
        holder_quat = xquat[world, first + g.holder]
    here = wp.vec3(0.0, 0.0, 0.0)
    if base[0] >= 0:
        here = wp.vec3(qpos[world, base[0]], qpos[world, base[1]], qpos[world, base[2]])
    else:
        turn = xquat[world, robot]
        here = wp.vec3(xpos[world, robot][0], xpos[world, robot][1], 2.0 * wp.atan2(turn[3], turn[0]))
    centre = pos + turned(quat, g.centre)
    hand = wp.length(centre - site_xpos[world, tool])
    free = hand > g.radius + released
    if fresh[world] != 0:
        start_height[world] = pos[2]
        start_goal[world] = centre + wp.vec3(0.0, 0.0, g.share)
    goal = centre
    success = False
    value = 0.0
    if g.kind == OPEN or g.kind == CLOSE:
        opened = wp.clamp(qpos[world, g.joint] / g.open_end, 0.0, 1.0)
        if g.kind == OPEN:
            success = opened >= g.share
            value = -wp.max(g.share - opened, 0.0) - 0.5 * hand
        else:
            success = opened <= g.share
            value = -opened - 0.5 * hand
    elif g.kind == NAVIGATE:
        at = local(pos, quat, wp.vec3(here[0], here[1], pos[2]))
        dx = wp.max(wp.max(g.item_low[0] - at[0], at[0] - g.item_high[0]), 0.0)
        dy = wp.max(wp.max(g.item_low[1] - at[1], at[1] - g.item_high[1]), 0.0)
        way = wp.sqrt(dx * dx + dy * dy)
        aside = wp.abs(wrapped(wp.atan2(centre[1] - here[1], centre[0] - here[0]) - here[2]))
        success = way <= g.share and aside <= _FACING
        value = -wp.max(way - g.share, 0.0) - 0.5 * aside / wp.pi
    elif g.kind == PUT_IN or g.kind == PUT_ON:
        tall = g.item_high[2] - g.item_low[2]
        middle = (g.low + g.high) * 0.5
        goal = holder_pos + turned(holder_quat, wp.vec3(middle[0], middle[1], g.low[2] + tall * 0.5))
        if g.kind == PUT_IN:
            half = (g.high - g.low) * 0.5
            at = local(holder_pos, holder_quat, centre) - middle
            share = wp.vec3(at[0] / wp.max(half[0], 1e-9), at[1] / wp.max(half[1], 1e-9), at[2] / wp.max(half[2], 1e-9))
            inside = wp.abs(share[0]) <= 1.0 and wp.abs(share[1]) <= 1.0 and wp.abs(share[2]) <= 1.0
            if g.oval != 0:
                inside = inside and share[0] * share[0] + share[1] * share[1] <= 1.0
            success = inside and free
        else:
            lowest = 1.0e9
            for k in range(8):
                x = wp.where(k % 2 == 0, g.item_low[0], g.item_high[0])
                y = wp.where(k // 2 % 2 == 0, g.item_low[1], g.item_high[1])
                z = wp.where(k // 4 == 0, g.item_low[2], g.item_high[2])
                corner = pos + turned(quat, wp.vec3(x, y, z))
                lowest = wp.min(lowest, corner[2])
            at = local(holder_pos, holder_quat, wp.vec3(centre[0], centre[1], lowest))
            over = at[0] >= g.low[0] and at[0] <= g.high[0] and at[1] >= g.low[1] and at[1] <= g.high[1]
            success = over and wp.abs(at[2] - g.low[2]) <= _ON and free
        value = -wp.length(centre - goal) - 0.5 * hand
    elif g.kind == TAKE:
        success = pos[2] - start_height[world] >= g.share and not free
        goal = centre + wp.vec3(0.0, 0.0, g.share)
        value = -wp.length(centre - start_goal[world]) - 0.5 * hand
    cut = False
    astray = int(0)  # noqa: UP018 - a variable of a loop in Warp
    for k in range(qpos.shape[1]):
        if not (wp.abs(qpos[world, k]) < _HUGE):  # nor a number
            astray = int(1)  # noqa: UP018
    if astray != 0:
        cut = True
        reward_out[world] = 0.0
        success = False
        value = 0.0
    elif fresh[world] != 0:
        reward_out[world] = 0.0
        success = False
    else:
        steps[world] = steps[world] + 1
        reward_out[world] = value - potential[world] + wp.where(success, 1.0, 0.0)
        cut = steps[world] >= most_steps
    potential[world] = value
    terminated_out[world] = success
    truncated_out[world] = cut
    done_out[world] = wp.where(success or cut, 1, 0)
    for k in range(3):
        subject_out[world, k] = pos[k]
        goal_out[world, k] = goal[k]
        base_out[world, k] = here[k]
    for k in range(4):
        subject_out[world, 3 + k] = quat[k]


@wp.kernel
def observe(
    # Problem:
    links: int,
    first: int,
    tool: int,
    drive_position: wp.array(dtype=int),
    drive_dof: wp.array(dtype=int),
    fingers: wp.array(dtype=int),
    finger_position: wp.array(dtype=int),
    ctrl_range: wp.array(dtype=wp.vec2),
    goals: wp.array2d(dtype=Goal),
    layout_room: wp.array(dtype=int),
    used: wp.array2d(dtype=int),
    # State in:
    layout: wp.array(dtype=int),
    chosen: wp.array(dtype=int),
    qpos: wp.array2d(dtype=float),
    qvel: wp.array2d(dtype=float),
    xpos: wp.array2d(dtype=wp.vec3),
    xquat: wp.array2d(dtype=wp.quat),
    site_xpos: wp.array2d(dtype=wp.vec3),
    site_xmat: wp.array2d(dtype=wp.mat33),
    # State out:
    robot_out: wp.array2d(dtype=float),
    tool_out: wp.array2d(dtype=float),
    gripper_out: wp.array2d(dtype=float),
    doors_out: wp.array2d(dtype=float),
    objects_out: wp.array3d(dtype=float),
    task_out: wp.array2d(dtype=float),
):
    """Observations [W, n] of `env.BatchedRoomEnv`; what is not used is 0.

    Args:
        links: How many links there are; ``first``: number of the first moving body; ``tool``: the tool's site.
        drive_position, drive_dof: [D] of the driven joints.
        fingers, finger_position: Actuators of the gripper and the positions of their joints; ``ctrl_range`` [nu].
        goals: [V, K]; ``layout_room`` [V] the room of each layout; ``used`` [R, M] whether a slot is.
        layout, chosen: [W] rows of ``goals``.
        qpos, qvel, xpos, xquat, site_xpos, site_xmat: State of the simulation.
        robot_out: [W, 2 D]; ``tool_out`` [W, 7]; ``gripper_out`` [W, 1]; ``doors_out`` [W, L] positions of links;
            ``objects_out`` [W, F, 7]; ``task_out`` [W, kinds].
    """
    world = wp.tid()
    count = drive_position.shape[0]
    for k in range(count):
        robot_out[world, k] = qpos[world, drive_position[k]]
        robot_out[world, count + k] = qvel[world, drive_dof[k]]
    turn = wp.quat_from_matrix(site_xmat[world, tool])
    for k in range(3):
        tool_out[world, k] = site_xpos[world, tool][k]
        tool_out[world, 4 + k] = turn[k]
    tool_out[world, 3] = turn[3]
    gripper_out[world, 0] = 0.0
    if fingers.shape[0] > 0:
        span = ctrl_range[fingers[0]]
        gripper_out[world, 0] = wp.clamp((qpos[world, finger_position[0]] - span[0]) / (span[1] - span[0]), 0.0, 1.0)
    room = layout_room[layout[world]]
    for k in range(doors_out.shape[1]):
        doors_out[world, k] = qpos[world, k]
    for k in range(objects_out.shape[1]):
        if used[room, links + k] != 0:
            pos = xpos[world, first + links + k]
            quat = xquat[world, first + links + k]
            for i in range(3):
                objects_out[world, k, i] = pos[i]
            for i in range(4):
                objects_out[world, k, 3 + i] = quat[i]
        else:
            for i in range(7):
                objects_out[world, k, i] = 0.0
    kind = goals[layout[world], chosen[world]].kind
    for k in range(task_out.shape[1]):
        task_out[world, k] = wp.where(k == kind, 1.0, 0.0)
