"""Terms of relations: the best of a relation's options, and the penalty of an option's rows."""

import warp as wp

from .array_access import item, item_strided
from .bodies import Body, Layout, candidate_of, fixture_body, layout_of, viewed_body
from .features import Relation, feature, plain_feature
from .geometry import FAR
from .penalties import outside, penalty
from .tables import DISTANCES, FORMULAS, RELATIONS, Energy, Problems, State, TablesRef, TermSlice

wp.set_module_options({"enable_backward": False})

ALL_RELATIONS = wp.constant(FORMULAS | DISTANCES | RELATIONS)


@wp.func
def relation_of(t: TablesRef, layout: Layout, r: wp.int32):
    """The objects of relation r (global) where the view sees them."""
    ids = item(t[0].relation_object, r)
    x = Relation(viewed_body(layout, ids[0]), fixture_body(-1), fixture_body(-1))
    if ids[1] >= 0:
        x.b = viewed_body(layout, ids[1])
    if ids[2] >= 0:
        x.c = viewed_body(layout, ids[2])
    return x


@wp.func
def option_energy(b: Problems, option: wp.int32, role: wp.int32, x: Relation, limit: wp.float32, kinds: wp.int32):
    """Penalty of one option's rows, with the gradient for the object in the given role; stops above the limit."""
    t = b.tables
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
        de, dv = penalty(off * aim[3], b.weights.knee)
        e += de
        g += dv * sign * aim[3] * slope
    return e, g


@wp.func
def best_option_of(b: Problems, first: wp.int32, last: wp.int32, role: wp.int32, x: Relation, kinds: wp.int32):
    """Of the options first:last the one with the lowest penalty, that penalty and its gradient."""
    best = int(first)
    low = float(FAR)
    low_g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    for option in range(first, last):
        e, g = option_energy(b, option, role, x, low, kinds)
        if e < low:
            low = e
            low_g = g
            best = option
        if low <= 0.0:
            break
    return best, low, low_g


@wp.func
def best_option(b: Problems, r: wp.int32, x: Relation):
    """The option of relation r (global) with the lowest penalty, and that penalty."""
    first = item(b.tables[0].option_start, r)
    best, low, _g = best_option_of(b, first, item(b.tables[0].option_start, r + 1), 0, x, ALL_RELATIONS)
    return best, low


@wp.func
def nearest_option(b: Problems, candidate: wp.int32, rel: wp.int32, s: State):
    """The option of a candidate's relation with the lowest penalty at the present poses; -1: no such relation."""
    t = b.tables
    c = candidate_of(b, candidate)
    r = item(t[0].relation_start, c.problem) + rel
    if r >= item(t[0].relation_start, c.problem + 1):
        return -1
    option, _e = best_option(b, r, relation_of(t, layout_of(c, s), r))
    return option


@wp.func
def relation_energy(b: Problems, layout: Layout, rel: wp.int32, role: wp.int32, kinds: wp.int32):
    """Penalty of relation ``rel`` (local), with the gradient for the object in the given role."""
    t = b.tables
    c = layout.candidate
    r = item(t[0].relation_start, c.problem) + rel
    x = relation_of(t, layout, r)
    first = item(t[0].option_start, r)
    last = item(t[0].option_start, r + 1)
    if layout.view.best == 0:
        first = item_strided(layout.state.options, c.index, rel)
        last = first + 1
    _best, low, low_g = best_option_of(b, first, last, role, x, kinds)
    weight = b.weights.relation * item(t[0].relation_weight, r)
    return weight * low, weight * low_g


@wp.func
def add_relations(b: Problems, layout: Layout, x: Body, part: TermSlice, kinds: wp.int32, total: Energy):
    """The penalties of the relations that an object takes part in; arguments as for `evaluator.evaluator`."""
    t = b.tables
    r0 = item(t[0].relation_start, layout.candidate.problem)
    first_incidence = item(t[0].incidence_start, x.index) + part.first
    for k in range(first_incidence, item(t[0].incidence_start, x.index + 1), part.step):
        rel = item(t[0].incidence, k)
        r = r0 + rel
        wanted = item(t[0].relation_rigid, r) == 0
        if (kinds & ALL_RELATIONS) != ALL_RELATIONS:
            wanted = wanted and (kinds & item(t[0].relation_kind, r)) != 0
        if wanted:
            role = item(t[0].incidence_role, k)
            e, g = relation_energy(b, layout, rel, role, kinds)
            if role == 0:
                total.share += e
                if item(t[0].relation_fault, r) == 0:
                    total.soft += e
            if b.weights.soft != 1.0:
                if item(t[0].relation_fault, r) == 0:
                    e *= b.weights.soft
                    g *= b.weights.soft
            total.value += e
            total.gradient += g
    return total
