"""Kernels that begin episodes: a layout of the bank is copied into the model and the state of a world.

Quaternions are (w, x, y, z), as MuJoCo Warp has them in arrays of ``wp.quat``. Worlds whose ``fresh`` is 0 are left as
they are.
"""
# pyright: reportInvalidTypeForm=false
# The types of a kernel's arguments are calls.

from __future__ import annotations

import warp as wp

from .task_kernels import Goal

wp.set_module_options({"enable_backward": False})


@wp.kernel
def begin_episodes(
    # Problem:
    seed: int,
    layouts: int,
    layout_goals: wp.array(dtype=int),
    # State in:
    done: wp.array(dtype=int),
    wanted_layout: wp.array(dtype=int),
    # State in and out:
    episode: wp.array(dtype=int),
    # State out:
    fresh_out: wp.array(dtype=int),
    layout_out: wp.array(dtype=int),
    chosen_out: wp.array(dtype=int),
    steps_out: wp.array(dtype=int),
    draw_out: wp.array(dtype=float),
):
    """Of each world that is done: the next episode, with a layout (-1 wanted: any) and one of its goals by the seed.

    All arrays [W], ``layout_goals`` [V] how many goals there are; ``draw_out`` in 0..1 places the robot.
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
    chosen_out[world] = goal
    steps_out[world] = 0
    draw_out[world] = wp.randf(rng)


@wp.kernel
def reset_boxes(
    # Problem:
    first: int,
    still: int,
    layout_room: wp.array(dtype=int),
    still_pos: wp.array2d(dtype=wp.vec3),
    still_quat: wp.array2d(dtype=wp.quat),
    room_size: wp.array2d(dtype=wp.vec3),
    room_friction: wp.array2d(dtype=wp.vec3),
    room_pos: wp.array2d(dtype=wp.vec3),
    room_quat: wp.array2d(dtype=wp.quat),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    # State out:
    size_out: wp.array2d(dtype=wp.vec3),
    friction_out: wp.array2d(dtype=wp.vec3),
    pos_out: wp.array2d(dtype=wp.vec3),
    quat_out: wp.array2d(dtype=wp.quat),
    rbound_out: wp.array2d(dtype=float),
    aabb_out: wp.array3d(dtype=wp.vec3),
    xpos_out: wp.array2d(dtype=wp.vec3),
    xmat_out: wp.array2d(dtype=wp.mat33),
):
    """Boxes [W, G] of the slots, from ``first`` on: those that stand still from the layout, the others from the room.

    Where the former are in the world is written as well, for MuJoCo Warp computes that once and never again.
    """
    world, box = wp.tid()
    if fresh[world] == 0:
        return
    row = layout[world]
    room = layout_room[row]
    at = first + box
    size = room_size[room, box]
    size_out[world, at] = size
    friction_out[world, at] = room_friction[room, box]
    rbound_out[world, at] = wp.length(size)
    aabb_out[world, at, 0] = wp.vec3(0.0, 0.0, 0.0)
    aabb_out[world, at, 1] = size
    if box < still:
        pos = still_pos[row, box]
        quat = still_quat[row, box]
        pos_out[world, at] = pos
        quat_out[world, at] = quat
        xpos_out[world, at] = pos
        xmat_out[world, at] = wp.quat_to_matrix(wp.quat(quat[1], quat[2], quat[3], quat[0]))
    else:
        pos_out[world, at] = room_pos[room, box]
        quat_out[world, at] = room_quat[room, box]


@wp.kernel
def reset_bodies(
    # Problem:
    first: int,
    links: int,
    layout_room: wp.array(dtype=int),
    link_pos: wp.array2d(dtype=wp.vec3),
    link_quat: wp.array2d(dtype=wp.quat),
    room_mass: wp.array2d(dtype=float),
    room_gravcomp: wp.array2d(dtype=float),
    room_subtreemass: wp.array2d(dtype=float),
    room_inertia: wp.array2d(dtype=wp.vec3),
    room_ipos: wp.array2d(dtype=wp.vec3),
    room_iquat: wp.array2d(dtype=wp.quat),
    room_invweight: wp.array2d(dtype=wp.vec2),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    # State out:
    mass_out: wp.array2d(dtype=float),
    gravcomp_out: wp.array2d(dtype=float),
    subtreemass_out: wp.array2d(dtype=float),
    inertia_out: wp.array2d(dtype=wp.vec3),
    ipos_out: wp.array2d(dtype=wp.vec3),
    iquat_out: wp.array2d(dtype=wp.quat),
    invweight_out: wp.array2d(dtype=wp.vec2),
    pos_out: wp.array2d(dtype=wp.vec3),
    quat_out: wp.array2d(dtype=wp.quat),
):
    """Moving bodies [W, M] of the slots, from ``first`` on; only links have a place in the model."""
    world, body = wp.tid()
    if fresh[world] == 0:
        return
    row = layout[world]
    room = layout_room[row]
    at = first + body
    mass_out[world, at] = room_mass[room, body]
    gravcomp_out[world, at] = room_gravcomp[room, body]
    subtreemass_out[world, at] = room_subtreemass[room, body]
    inertia_out[world, at] = room_inertia[room, body]
    ipos_out[world, at] = room_ipos[room, body]
    iquat_out[world, at] = room_iquat[room, body]
    invweight_out[world, at] = room_invweight[room, body]
    if body < links:
        pos_out[world, at] = link_pos[row, body]
        quat_out[world, at] = link_quat[row, body]


@wp.kernel
def reset_links(
    # Problem:
    first: int,
    layout_room: wp.array(dtype=int),
    room_pos: wp.array2d(dtype=wp.vec3),
    room_axis: wp.array2d(dtype=wp.vec3),
    room_range: wp.array2d(dtype=wp.vec2),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    # State out:
    pos_out: wp.array2d(dtype=wp.vec3),
    axis_out: wp.array2d(dtype=wp.vec3),
    range_out: wp.array2d(dtype=wp.vec2),
):
    """Joints [W, L] of links, from ``first`` on."""
    world, link = wp.tid()
    if fresh[world] == 0:
        return
    room = layout_room[layout[world]]
    pos_out[world, first + link] = room_pos[room, link]
    axis_out[world, first + link] = room_axis[room, link]
    range_out[world, first + link] = room_range[room, link]


@wp.kernel
def reset_velocities(
    # Problem:
    slots: int,
    layout_room: wp.array(dtype=int),
    room_frictionloss: wp.array2d(dtype=float),
    room_damping: wp.array2d(dtype=float),
    room_armature: wp.array2d(dtype=float),
    room_invweight: wp.array2d(dtype=float),
    # State in:
    fresh: wp.array(dtype=int),
    layout: wp.array(dtype=int),
    # State out:
    frictionloss_out: wp.array2d(dtype=float),
    damping_out: wp.array2d(dtype=float),
    armature_out: wp.array2d(dtype=float),
    invweight_out: wp.array2d(dtype=float),
    qvel_out: wp.array2d(dtype=float),
    warmstart_out: wp.array2d(dtype=float),
):
    """Degrees of freedom [W, nv]: the first ``slots`` as the room has them, all at rest."""
    world, dof = wp.tid()
    if fresh[world] == 0:
        return
    qvel_out[world, dof] = 0.0
    warmstart_out[world, dof] = 0.0
    if dof < slots:
        room = layout_room[layout[world]]
        frictionloss_out[world, dof] = room_frictionloss[room, dof]
        damping_out[world, dof] = room_damping[room, dof]
        armature_out[world, dof] = room_armature[room, dof]
        invweight_out[world, dof] = room_invweight[room, dof]


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
