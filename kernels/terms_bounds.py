"""Terms of an object alone: that it stays inside the room, and the pull towards its anchor."""

import warp as wp

from .array_access import item, item_strided
from .bodies import Body, Layout
from .features import TURN
from .geometry import lowest_vertex, perp, plane_of, turn, turn_back, wrap
from .penalties import outside, penalty
from .tables import FREE_Z, Energy, Problems, TermSlice

wp.set_module_options({"enable_backward": False})


@wp.func
def add_bounds(b: Problems, layout: Layout, x: Body, part: TermSlice, kinds: wp.int32, total: Energy):
    """The penalty of an object against walls, floor and ceiling; arguments as for `evaluator.evaluator`."""
    t = b.tables
    m = b.margins
    w = b.weights
    problem = layout.candidate.problem
    at = plane_of(x.pose)
    e = float(0.0)
    g = wp.vec4(0.0, 0.0, 0.0, 0.0)
    reach = item(t[0].object_radius, x.index)[0]
    for k in range(item(t[0].plane_start, problem) + part.first, item(t[0].plane_start, problem + 1), part.step):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        depth = wp.dot(n, at) - plane[2]
        if depth - reach < m.bounds_aim:
            low = lowest_vertex(t, x.index, turn_back(x.turn, n))
            de, dv = penalty(m.bounds_aim - depth - low[2], w.knee)
            e += w.bounds * de
            g -= w.bounds * dv * wp.vec4(n[0], n[1], 0.0, wp.dot(n, perp(turn(x.turn, wp.vec2(low[0], low[1])))))
    if part.first == 0 and item(t[0].object_free, x.index) & FREE_Z:
        z = item(t[0].object_z, x.index)
        height = item(t[0].room_height, problem)
        off, slope = outside(x.pose[2], wp.vec2(m.bounds_aim - z[0], height - z[1] - m.bounds_aim))
        dz, dzv = penalty(off, w.knee)
        e += w.bounds * dz
        g += wp.vec4(0.0, 0.0, w.bounds * dzv * slope, 0.0)
    total.value += e
    total.share += e
    total.gradient += g
    return total


@wp.func
def add_pull(b: Problems, layout: Layout, x: Body, part: TermSlice, kinds: wp.int32, total: Energy):
    """The pull of an object's anchor, quadratic in its distance (radians count as metres); a soft term."""
    w = b.weights
    if w.pull > 0.0 and part.first == 0:
        d = x.pose - item_strided(layout.state.anchors, layout.candidate.index, x.obj)
        d[3] = wrap(d[3], TURN)
        e = 0.5 * w.pull * wp.dot(d, d)
        total.value += e
        total.share += e
        total.soft += e
        total.gradient += w.pull * d
    return total
