"""Linear inequalities on how far each root has moved from its anchor: J . d >= goal on the displacements d.

The derivative of a clearance by the pose of an object that is carried along is one by the pose of its root, whose arm
the object is on.
"""

import warp as wp

from .bodies import Candidate, free_part
from .geometry import perp, plane_of
from .tables import State, TablesRef

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


@wp.struct
class InequalitySystem:
    """The inequalities of all candidates; slots of an object's rows begin at ROWS times its index."""

    rows: wp.array2d(dtype=Inequality)  # [candidate, slot]
    keys: wp.array2d(dtype=wp.int32)  # [candidate, slot]: by which a row is known again in the next step
    shift: wp.array2d(dtype=wp.vec4)  # [candidate, object]: how far each root is from its anchor


@wp.func
def mobility(v: wp.vec4):
    """W^-1 v: the least movement that a unit pull along v causes."""
    return wp.vec4(v[0], v[1], v[2], v[3] / (ARM * ARM))


@wp.func
def on_root(t: TablesRef, c: Candidate, obj: wp.int32, g: wp.vec4, s: State):
    """A gradient for an object's pose as one for the pose of its root, without what the root is not free to do."""
    root = t[0].object_root[c.first_object + obj]
    if root != obj:
        arm = perp(plane_of(s.poses[c.index, obj]) - plane_of(s.poses[c.index, root]))
        g[3] = g[3] + g[0] * arm[0] + g[1] * arm[1]
    return free_part(t, c.first_object + root, g)


@wp.func(inline=False)
def add_row(
    t: TablesRef,
    c: Candidate,
    slot: wp.int32,
    who: wp.vec3i,
    ga: wp.vec4,
    gb: wp.vec4,
    gc: wp.vec4,
    missing: wp.float32,
    key: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """Write a row into a slot: the gradients for the objects ``who`` have to gain what is missing at the present poses.

    Returns 1, or 0 when nothing that is free to move can change it.
    """
    row = Inequality()
    a = t[0].object_root[c.first_object + who[0]]
    row.body = wp.vec3i(a, -1, -1)
    row.first = on_root(t, c, who[0], ga, s)
    row.goal = missing
    if who[1] >= 0:
        b = t[0].object_root[c.first_object + who[1]]
        g = on_root(t, c, who[1], gb, s)
        if b == a:
            row.first += g
        else:
            row.body[1] = b
            row.second = g
    if who[2] >= 0:
        third = t[0].object_root[c.first_object + who[2]]
        h = on_root(t, c, who[2], gc, s)
        if third == a:
            row.first += h
        elif third == row.body[1]:
            row.second += h
        else:
            row.body[2] = third
            row.third = h
    size = wp.dot(row.first, mobility(row.first)) + wp.dot(row.second, mobility(row.second))
    size += wp.dot(row.third, mobility(row.third))
    if size < 1.0e-8:
        return int(0)
    row.inverse = 1.0 / size
    row.goal += wp.dot(row.first, system.shift[c.index, a])
    if row.body[1] >= 0:
        row.goal += wp.dot(row.second, system.shift[c.index, row.body[1]])
    if row.body[2] >= 0:
        row.goal += wp.dot(row.third, system.shift[c.index, row.body[2]])
    system.rows[c.index, slot] = row
    system.keys[c.index, slot] = key
    return int(1)


@wp.func
def add_own_row(
    t: TablesRef,
    c: Candidate,
    obj: wp.int32,
    slot: wp.int32,
    g: wp.vec4,
    missing: wp.float32,
    key: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """`add_row` of one object alone."""
    none = wp.vec4(0.0, 0.0, 0.0, 0.0)
    return add_row(t, c, slot, wp.vec3i(obj, -1, -1), g, none, none, missing, key, s, system)


@wp.func
def wanting(clearance: wp.float32, hold: wp.float32):
    """What a clearance is to gain: when it is violated, enough for a little more than the limit.

    Contacts that the verdict accepts keep what they have, so that what is in order need not move.
    """
    want = hold + SLACK - clearance
    if clearance >= hold + CONTENT:
        want = wp.min(want, 0.0)
    return want
