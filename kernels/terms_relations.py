"""Terms of relations: the best of a relation's options, and the penalty of an option's rows."""

import warp as wp

from .array_access import item, item_strided
from .bodies import Body, Candidate, viewed_pose
from .features import RelationPoses, feature, plain_feature
from .geometry import FAR
from .penalties import outside, penalty
from .tables import (
    DISTANCES,
    FORMULAS,
    RELATIONS,
    Energy,
    Margins,
    Problems,
    State,
    TablesRef,
    TermSlice,
    View,
    Weights,
)

wp.set_module_options({"enable_backward": False})

ALL_RELATIONS = wp.constant(FORMULAS | DISTANCES | RELATIONS)


@wp.func
def relation_poses(t: TablesRef, o0: wp.int32, r: wp.int32, s: State, candidate: wp.int32, view: View):
    """The objects of relation r (global) where a view sees them; o0: the problem's first object."""
    ids = item(t[0].relation_object, r)
    x = RelationPoses()
    x.a = o0 + ids[0]
    x.b = -1
    x.qb = wp.vec2(1.0, 0.0)
    pose, q = viewed_pose(s, candidate, ids[0], view)
    x.pose_a = pose
    x.qa = q
    if ids[1] >= 0:
        x.b = o0 + ids[1]
        pose_b, qb = viewed_pose(s, candidate, ids[1], view)
        x.pose_b = pose_b
        x.qb = qb
    if ids[2] >= 0:
        pose_c, _qc = viewed_pose(s, candidate, ids[2], view)
        x.pose_c = pose_c
    return x


@wp.func
def option_energy(
    t: TablesRef,
    option: wp.int32,
    role: wp.int32,
    x: RelationPoses,
    knee: wp.float32,
    limit: wp.float32,
    kinds: wp.int32,
):
    """Penalty of one option's rows, with the gradient for the object in the given role; stops above the limit."""
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for row in range(item(t[0].row_start, option), item(t[0].row_start, option + 1)):
        if e >= limit:
            break
        value = float(0.0)
        slope = wp.vec4(0.0, 0.0, 0.0, 0.0)
        if (kinds & RELATIONS) == 0:
            value, slope = plain_feature(t, row, role, x, (kinds & DISTANCES) != 0)
        else:
            value, slope = feature(t, row, role, x)
        aim = item(t[0].row_aim, row)
        off, sign = outside(value, wp.vec2(aim[0], aim[1]))
        de, dv = penalty(off * aim[3], knee)
        e += de
        g += dv * sign * aim[3] * slope
    return e, g


@wp.func
def best_option_of(
    t: TablesRef,
    first: wp.int32,
    last: wp.int32,
    role: wp.int32,
    x: RelationPoses,
    knee: wp.float32,
    kinds: wp.int32,
):
    """Of the options first:last the one with the lowest penalty, that penalty and its gradient."""
    best = int(first)
    low = float(FAR)
    low_g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for option in range(first, last):
        e, g = option_energy(t, option, role, x, knee, low, kinds)
        if e < low:
            low = e
            low_g = g
            best = option
        if low <= 0.0:
            break
    return best, low, low_g


@wp.func
def best_option(t: TablesRef, r: wp.int32, role: wp.int32, x: RelationPoses, knee: wp.float32):
    """The option of relation r (global) with the lowest penalty, that penalty and its gradient."""
    first = item(t[0].option_start, r)
    last = item(t[0].option_start, r + 1)
    best, low, g = best_option_of(t, first, last, role, x, knee, ALL_RELATIONS)
    return best, low, g


@wp.func
def nearest_option(b: Problems, candidate: wp.int32, rel: wp.int32, s: State):
    """The option of a candidate's relation with the lowest penalty at the present poses; -1: no such relation."""
    t = b.tables
    p = b.problem[candidate]
    r = item(t[0].relation_start, p) + rel
    if r >= item(t[0].relation_start, p + 1):
        return -1
    x = relation_poses(t, item(t[0].object_start, p), r, s, candidate, View())
    option, _e, _g = best_option(t, r, 0, x, b.weights.knee)
    return option


@wp.func
def relation_energy(
    t: TablesRef,
    w: Weights,
    c: Candidate,
    rel: wp.int32,
    role: wp.int32,
    s: State,
    view: View,
    kinds: wp.int32,
):
    """Penalty of relation ``rel`` (local), with the gradient for the object in the given role."""
    r = item(t[0].relation_start, c.problem) + rel
    x = relation_poses(t, c.first_object, r, s, c.index, view)
    first = item(t[0].option_start, r)
    last = item(t[0].option_start, r + 1)
    if view.best == 0:
        first = item_strided(s.options, c.index, rel)
        last = first + 1
    _best, low, low_g = best_option_of(t, first, last, role, x, w.knee, kinds)
    weight = w.relation * item(t[0].relation_weight, r)
    return weight * low, weight * low_g


@wp.func
def add_relations(
    t: TablesRef,
    m: Margins,
    w: Weights,
    c: Candidate,
    x: Body,
    s: State,
    view: View,
    part: TermSlice,
    kinds: wp.int32,
    total: Energy,
):
    """The penalties of the relations that an object takes part in; arguments as for `evaluator.evaluator`."""
    r0 = item(t[0].relation_start, c.problem)
    first_incidence = item(t[0].incidence_start, x.index) + part.first
    for k in range(first_incidence, item(t[0].incidence_start, x.index + 1), part.step):
        rel = item(t[0].incidence, k)
        r = r0 + rel
        wanted = item(t[0].relation_rigid, r) == 0
        if (kinds & ALL_RELATIONS) != ALL_RELATIONS:
            wanted = wanted and (kinds & item(t[0].relation_kind, r)) != 0
        if wanted:
            role = item(t[0].incidence_role, k)
            e, g = relation_energy(t, w, c, rel, role, s, view, kinds)
            total.value += e
            total.gradient += g
            if role == 0:
                total.share += e
                if item(t[0].relation_fault, r) == 0:
                    total.soft += e
    return total
