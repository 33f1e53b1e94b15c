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


Jacobian = wp.types.matrix(shape=(3, 4), dtype=wp.float32)
"""A gradient (x, y, z, yaw) for each of up to three bodies."""


@wp.struct
class Inequality:
    """One inequality: the sum over its bodies of jacobian[k] . d[body[k]] is at least the goal; body -1: none."""

    body: wp.vec3i
    jacobian: Jacobian
    goal: wp.float32
    inverse: wp.float32  # of J W^-1 J^T, where W holds the weights of the squared movement


@wp.struct
class InequalitySystem:
    """The inequalities of all candidates, and the step that solves them.

    Slots of an object's rows begin at ROWS times its index. Keys tell a row again in the next step, so that it begins
    with the force that it had.
    """

    reach: wp.float32  # [m] clearance below which something gets a row
    plain: wp.int32  # 1: goals are what rows lack of `SLACK`, of those as well that may stay as they are
    rows: wp.array2d(dtype=Inequality)  # [candidate, slot]
    keys: wp.array2d(dtype=wp.int32)  # [candidate, slot]
    force: wp.array2d(dtype=wp.float32)  # [candidate, slot]
    last_keys: wp.array2d(dtype=wp.int32)  # the same of the step before
    last_force: wp.array2d(dtype=wp.float32)
    count: wp.array2d(dtype=wp.int32)  # [candidate, object]: rows
    missed: wp.array2d(dtype=wp.float32)  # [candidate, object]: by how much [m] its terms miss the verdict's limits
    shift: wp.array2d(dtype=wp.vec4)  # [candidate, object]: how far each root is from its anchor
    scratch: wp.array2d(dtype=wp.vec4)  # [candidate, object]
    last_step: wp.array(dtype=wp.float32)  # [candidate]: how far [m] the last step went
    live: wp.array(dtype=wp.int32)  # [candidate]: 1 until it has settled
    cut: wp.array(dtype=wp.int32)  # [1]: from 1 on, nothing is done any more: for a CPU


@wp.struct
class RowCount:
    """Rows that an object has so far, and by how much [m] its terms miss the verdict's limits in all.

    What nothing free to move can mend does not count as missed.
    """

    count: wp.int32
    missed: wp.float32


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
    g: Jacobian,
    missing: wp.float32,
    key: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """Write a row into a slot: the gradients for the objects ``who`` have to gain what is missing at the present poses.

    Returns 1, or 0 when nothing that is free to move can change it.
    """
    jacobian = Jacobian()
    body = wp.vec3i(-1, -1, -1)
    for k in range(3):
        if who[k] >= 0:
            root = t[0].object_root[c.first_object + who[k]]
            place = int(k)
            if body[0] == root:
                place = 0
            elif body[1] == root:
                place = 1
            body[place] = root
            jacobian[place] = jacobian[place] + on_root(t, c, who[k], g[k], s)
    size = float(0.0)
    goal = missing
    for k in range(3):
        size += wp.dot(jacobian[k], mobility(jacobian[k]))
        if body[k] >= 0:
            goal += wp.dot(jacobian[k], system.shift[c.index, body[k]])
    if size < 1.0e-8:
        return int(0)
    system.rows[c.index, slot] = Inequality(body, jacobian, goal, 1.0 / size)
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
    jacobian = Jacobian()
    jacobian[0] = g
    return add_row(t, c, slot, wp.vec3i(obj, -1, -1), jacobian, missing, key, s, system)


@wp.func
def wanting(clearance: wp.float32, hold: wp.float32, system: InequalitySystem):
    """What a clearance is to gain: when it is violated, enough for a little more than the limit.

    Contacts that the verdict accepts keep what they have, so that what is in order need not move.
    """
    want = hold + SLACK - clearance
    if clearance >= hold + CONTENT and system.plain == 0:
        want = wp.min(want, 0.0)
    return want
