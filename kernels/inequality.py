"""Linear inequalities on how far each root has moved from its anchor: J . d >= goal on the displacements d.

The derivative of a clearance by the pose of an object that is carried along is one by the pose of its root, whose arm
the object is on.
"""

import warp as wp

from .geometry import perp, plane_of
from .tables import FREE_PLANE, FREE_YAW, FREE_Z, State, TablesRef

wp.set_module_options({"enable_backward": False})

ROWS = wp.constant(32)  # rows that one object may have
ARM = wp.constant(0.5)  # [m] that a radian of yaw counts as
SLACK = wp.constant(7.0e-4)  # [m] clearance beyond what the verdict insists on that a violated row is given
CONTENT = wp.constant(1.0e-4)  # [m] beyond the verdict's limit, from which on a row is left as it is
SURE = wp.constant(3.0e-5)  # [m] beyond the verdict's limit, for rounding


@wp.struct
class Inequality:
    """One inequality first . d[body 0] + second . d[body 1] + third . d[body 2] >= goal; body -1: none."""

    body: wp.vec3i
    first: wp.vec4
    second: wp.vec4
    third: wp.vec4
    goal: wp.float32
    inverse: wp.float32  # of J W^-1 J^T, where W holds the weights of the squared movement


@wp.func
def mobility(v: wp.vec4):
    """W^-1 v: the least movement that a unit pull along v causes."""
    return wp.vec4(v[0], v[1], v[2], v[3] / (ARM * ARM))


@wp.func
def on_root(t: TablesRef, o0: wp.int32, obj: wp.int32, g: wp.vec4, s: State, candidate: wp.int32):
    """A gradient for an object's pose as one for the pose of its root, without what the root is not free to do."""
    root = t[0].object_root[o0 + obj]
    if root != obj:
        arm = perp(plane_of(s.poses[candidate, obj]) - plane_of(s.poses[candidate, root]))
        g[3] = g[3] + g[0] * arm[0] + g[1] * arm[1]
    free = t[0].object_free[o0 + root]
    if (free & FREE_PLANE) == 0:
        g[0] = 0.0
        g[1] = 0.0
    if (free & FREE_Z) == 0:
        g[2] = 0.0
    if (free & FREE_YAW) == 0:
        g[3] = 0.0
    return g


@wp.func(inline=False)
def add_row(
    t: TablesRef,
    o0: wp.int32,
    candidate: wp.int32,
    slot: wp.int32,
    who: wp.vec3i,
    ga: wp.vec4,
    gb: wp.vec4,
    gc: wp.vec4,
    missing: wp.float32,
    key: wp.int32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Inequality),
    keys: wp.array2d(dtype=wp.int32),
):
    """Write a row into a slot: the gradients for the objects ``who`` have to gain what is missing at the present poses.

    Returns 1, or 0 when nothing that is free to move can change it.
    """
    row = Inequality()
    a = t[0].object_root[o0 + who[0]]
    row.body = wp.vec3i(a, -1, -1)
    row.first = on_root(t, o0, who[0], ga, s, candidate)
    row.goal = missing
    if who[1] >= 0:
        b = t[0].object_root[o0 + who[1]]
        g = on_root(t, o0, who[1], gb, s, candidate)
        if b == a:
            row.first += g
        else:
            row.body[1] = b
            row.second = g
    if who[2] >= 0:
        c = t[0].object_root[o0 + who[2]]
        h = on_root(t, o0, who[2], gc, s, candidate)
        if c == a:
            row.first += h
        elif c == row.body[1]:
            row.second += h
        else:
            row.body[2] = c
            row.third = h
    size = wp.dot(row.first, mobility(row.first)) + wp.dot(row.second, mobility(row.second))
    size += wp.dot(row.third, mobility(row.third))
    if size < 1.0e-8:
        return int(0)
    row.inverse = 1.0 / size
    row.goal += wp.dot(row.first, shift[candidate, a])
    if row.body[1] >= 0:
        row.goal += wp.dot(row.second, shift[candidate, row.body[1]])
    if row.body[2] >= 0:
        row.goal += wp.dot(row.third, shift[candidate, row.body[2]])
    rows[candidate, slot] = row
    keys[candidate, slot] = key
    return int(1)


@wp.func
def wanting(clearance: wp.float32, hold: wp.float32):
    """What a clearance is to gain: when it is violated, enough for a little more than the limit.

    Contacts that the verdict accepts keep what they have, so that what is in order need not move.
    """
    want = hold + SLACK - clearance
    if clearance >= hold + CONTENT:
        want = wp.min(want, 0.0)
    return want
