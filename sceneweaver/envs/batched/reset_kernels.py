"""Kernels that begin episodes: a layout of the bank is copied into the model and the state of a world.

Quaternions are (w, x, y, z), as MuJoCo Warp has them in arrays of ``wp.quat``. Worlds whose ``fresh`` is 0 are left as
they are.
"""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

from typing import Any

import warp as wp

from .structs import Episodes, Layouts, RobotArrays, Simulation

wp.set_module_options({"enable_backward": False})


@wp.kernel
def begin_episodes(
    # Problem:
    seed: int,
    layouts: Layouts,
    # State in and out:
    episodes: Episodes,
):
    """Of each world that is done: the next episode, with a layout (-1 wanted: any) and one of its goals by the seed."""
    world = wp.tid()
    episodes.fresh[world] = episodes.done[world]
    if episodes.done[world] == 0:
        return
    episodes.number[world] = episodes.number[world] + 1
    rng = wp.rand_init(seed, world * 65537 + episodes.number[world])
    count = layouts.room.shape[0]
    layout = wp.min(int(wp.randf(rng) * float(count)), count - 1)
    if episodes.wanted[world] >= 0:
        layout = episodes.wanted[world]
    goals = layouts.goal_count[layout]
    episodes.goal[world] = wp.min(int(wp.randf(rng) * float(goals)), wp.max(goals - 1, 0))
    episodes.layout[world] = layout
    episodes.room[world] = layouts.room[layout]
    episodes.steps[world] = 0
    episodes.draw[world] = wp.randf(rng)


@wp.kernel
def copy_rows(
    # Problem:
    first: int,
    source: wp.array2d(dtype=Any),
    # State in:
    fresh: wp.array(dtype=int),
    row: wp.array(dtype=int),
    # State out:
    field_out: wp.array2d(dtype=Any),
):
    """A field of the bank, its rows [R, n] by room or by layout, into the model [W, m], from ``first`` on."""
    world, k = wp.tid()
    if fresh[world] != 0:
        field_out[world, first + k] = source[row[world], k]


@wp.kernel
def bound_boxes(
    # Problem:
    first: int,
    still: int,
    # State in:
    fresh: wp.array(dtype=int),
    size: wp.array2d(dtype=wp.vec3),
    pos: wp.array2d(dtype=wp.vec3),
    quat: wp.array2d(dtype=wp.quat),
    # State out:
    rbound_out: wp.array2d(dtype=float),
    aabb_out: wp.array3d(dtype=wp.vec3),
    xpos_out: wp.array2d(dtype=wp.vec3),
    xmat_out: wp.array2d(dtype=wp.mat33),
):
    """What follows from the sizes and places of boxes [W, G] of the slots, from ``first`` on: their bounds.

    Where the first ``still``, which stand still, are in the world is written as well, for MuJoCo Warp computes that
    once and never again.
    """
    world, box = wp.tid()
    if fresh[world] == 0:
        return
    at = first + box
    rbound_out[world, at] = wp.length(size[world, at])
    aabb_out[world, at, 0] = wp.vec3(0.0, 0.0, 0.0)
    aabb_out[world, at, 1] = size[world, at]
    if box < still:
        turn = quat[world, at]
        xpos_out[world, at] = pos[world, at]
        xmat_out[world, at] = wp.quat_to_matrix(wp.quat(turn[1], turn[2], turn[3], turn[0]))


@wp.kernel
def stop(
    # State in:
    fresh: wp.array(dtype=int),
    # State out:
    qvel_out: wp.array2d(dtype=float),
    warmstart_out: wp.array2d(dtype=float),
):
    """All degrees of freedom [W, nv] at rest."""
    world, dof = wp.tid()
    if fresh[world] != 0:
        qvel_out[world, dof] = 0.0
        warmstart_out[world, dof] = 0.0


@wp.kernel
def reset_positions(
    # Problem:
    robot: RobotArrays,
    layouts: Layouts,
    # State in:
    episodes: Episodes,
    # State in and out:
    sim: Simulation,
):
    """Positions ``sim.qpos``: links closed, free bodies by the layout, the robot at home on one of its places.

    A door that is to be closed begins open.
    """
    world, at = wp.tid()
    if episodes.fresh[world] == 0:
        return
    row = episodes.layout[world]
    slots = sim.qpos.shape[1] - robot.home.shape[0]  # positions of links and of free bodies come first
    links = slots - 7 * layouts.free_pose.shape[1]
    value = 0.0
    if at >= slots:
        value = robot.home[at - slots]
        places = layouts.spawns.shape[1]
        place = wp.min(int(episodes.draw[world] * float(places)), places - 1)
        for k in range(3):
            if at == robot.base[k]:
                value = layouts.spawns[row, place, k]
    elif at >= links:
        value = layouts.free_pose[row, (at - links) // 7, (at - links) % 7]
    goal = layouts.goals[row, episodes.goal[world]]
    if goal.joint == at:
        value = goal.begin
    sim.qpos[world, at] = value


@wp.kernel
def reset_controls(
    # Problem:
    robot: RobotArrays,
    # State in:
    episodes: Episodes,
    # State in and out:
    sim: Simulation,
):
    """Targets ``sim.ctrl`` of the actuators: where their joints are."""
    world, actuator = wp.tid()
    if episodes.fresh[world] != 0:
        sim.ctrl[world, actuator] = sim.qpos[world, robot.position[actuator]]
