"""Kernels that begin episodes: a layout of the bank is copied into the model and the state of a world.

Quaternions are (w, x, y, z), as MuJoCo Warp has them in arrays of ``wp.quat``. Worlds whose ``fresh`` is 0 are left as
they are.
"""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

from typing import Any

import warp as wp

from .task_kernels import Goal

wp.set_module_options({"enable_backward": False})

# Kernels have an argument for each array of the bank or the simulation that they read or write, hence more than ten.


@wp.kernel
def begin_episodes(
    # Problem:
    seed: int,
    layouts: int,
    layout_goals: wp.array(dtype=int),
    layout_room: wp.array(dtype=int),
    # State in:
    done: wp.array(dtype=int),
    wanted_layout: wp.array(dtype=int),
    # State in and out:
    episode: wp.array(dtype=int),
    # State out:
    fresh_out: wp.array(dtype=int),
    layout_out: wp.array(dtype=int),
    room_out: wp.array(dtype=int),
    chosen_out: wp.array(dtype=int),
    steps_out: wp.array(dtype=int),
    draw_out: wp.array(dtype=float),
):
    """Of each world that is done: the next episode, with a layout (-1 wanted: any) and one of its goals by the seed.

    All arrays [W], ``layout_goals`` [V] how many goals there are, ``layout_room`` [V] the rooms of the layouts;
    ``draw_out`` in 0..1 places the robot.
    """
    world = wp.tid()
    fresh_out[world] = done[world]
    if done[world] == 0:
        return
    episode[world] = episode[world] + 1
    rng = wp.rand_init(seed, world * 65537 + episode[world])
    layout = wp.min(int(wp.randf(rng) * float(layouts)), layouts - 1)
    if wanted_layout[world] >= 0:
        layout = wanted_layout[world]
    goals = layout_goals[layout]
    goal = wp.min(int(wp.randf(rng) * float(goals)), wp.max(goals - 1, 0))
    layout_out[world] = layout
    room_out[world] = layout_room[layout]
    chosen_out[world] = goal
    steps_out[world] = 0
    draw_out[world] = wp.randf(rng)


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
    links: int,
    slots: int,
    free_pose: wp.array3d(dtype=float),
    spawns: wp.array3d(dtype=float),
    base: wp.vec3i,
    home: wp.array(dtype=float),
    goals: wp.array2d(dtype=Goal),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    chosen: wp.array(dtype=int),
    draw: wp.array(dtype=float),
    # State out:
    qpos_out: wp.array2d(dtype=float),
):
    """Positions [W, nq]: links closed, free bodies by the layout, the robot at home on one of P places.

    Args:
        links: How many positions of links come first.
        slots: How many positions of slots; those of the robot come after them.
        free_pose: [V, F, 7] of free bodies.
        spawns: [V, P, 3] places of the base: x, y [m], yaw [rad].
        base: Positions of the base's x, y and yaw; less than 0: it has none.
        home: [nq - slots] of the robot.
        goals: [V, K] tasks; a door that is to be closed begins open.
        fresh, layout, chosen, draw: [W] of ``begin_episodes``.
        qpos_out: [W, nq].
    """
    world, at = wp.tid()
    if fresh[world] == 0:
        return
    row = layout[world]
    value = 0.0
    if at >= slots:
        value = home[at - slots]
        place = wp.min(int(draw[world] * float(spawns.shape[1])), spawns.shape[1] - 1)
        for k in range(3):
            if at == base[k]:
                value = spawns[row, place, k]
    elif at >= links:
        value = free_pose[row, (at - links) // 7, (at - links) % 7]
    goal = goals[row, chosen[world]]
    if goal.joint == at:
        value = goal.begin
    qpos_out[world, at] = value


@wp.kernel
def reset_controls(
    # Problem:
    position: wp.array(dtype=int),
    # State in:
    fresh: wp.array(dtype=int),
    qpos: wp.array2d(dtype=float),
    # State out:
    ctrl_out: wp.array2d(dtype=float),
):
    """Targets [W, nu] of the actuators: where their joints are; ``position`` [nu] in ``qpos``."""
    world, actuator = wp.tid()
    if fresh[world] != 0:
        ctrl_out[world, actuator] = qpos[world, position[actuator]]
