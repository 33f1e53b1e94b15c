"""Bodies of several objects: a root with all that it carries, or with everything that it places as well."""

from functools import cache

import warp as wp

from .array_access import item, item_strided
from .bodies import Layout, free_part
from .evaluator import EVERY_KIND, object_evaluator
from .features import TURN
from .geometry import lowest_vertex, perp, plane_of, turn, turn_back, wrap
from .tables import Energy, Problems, State, TablesRef, TermSlice

wp.set_module_options({"enable_backward": False})

FORMATION = wp.constant(6)  # objects beside its own members that make a root's group a formation


@wp.func
def set_pose(s: State, candidate: wp.int32, obj: wp.int32, pose: wp.vec4):
    """Write a pose with its (cos, sin), yaw wrapped."""
    yaw = wrap(pose[3], TURN)
    s.poses[candidate, obj] = wp.vec4(pose[0], pose[1], pose[2], yaw)
    s.turns[candidate, obj] = wp.vec2(wp.cos(yaw), wp.sin(yaw))


@wp.func
def members_end(t: TablesRef, o: wp.int32):
    """Where in the group of object o (global) its members end: itself and all that it carries, which come first."""
    return item(t[0].group_start, o) + item(t[0].member_start, o + 1) - item(t[0].member_start, o)


@wp.func
def move_with_members(t: TablesRef, o0: wp.int32, s: State, candidate: wp.int32, root: wp.int32, pose: wp.vec4):
    """Move a root to a pose with all that it carries."""
    old = item_strided(s.poses, candidate, root)
    spin = pose[3] - old[3]
    q = wp.vec2(wp.cos(spin), wp.sin(spin))
    for k in range(item(t[0].member_start, o0 + root), item(t[0].member_start, o0 + root + 1)):
        i = item(t[0].member, k)
        if i != root:
            child = item_strided(s.poses, candidate, i)
            at = plane_of(pose) + turn(q, plane_of(child) - plane_of(old))
            set_pose(s, candidate, i, wp.vec4(at[0], at[1], child[2] + pose[2] - old[2], child[3] + spin))
    set_pose(s, candidate, root, pose)


@wp.func
def is_formation(t: TablesRef, o: wp.int32):
    """True when so many objects are placed by object o (global), and by one another, that they move as a whole only."""
    return item(t[0].group_start, o + 1) - members_end(t, o) >= FORMATION


@wp.func
def way_inside(
    t: TablesRef, p: wp.int32, candidate: wp.int32, root: wp.int32, after: wp.vec4, aim: wp.float32, s: State
):
    """How far a root's whole group has to go to be inside of the room's half planes, if the root is at a pose."""
    o0 = item(t[0].object_start, p)
    before = item_strided(s.poses, candidate, root)
    spin = wp.vec2(wp.cos(after[3] - before[3]), wp.sin(after[3] - before[3]))
    way = wp.vec2(0.0, 0.0)
    for k in range(item(t[0].plane_start, p), item(t[0].plane_start, p + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        missing = float(0.0)
        for g in range(item(t[0].group_start, o0 + root), item(t[0].group_start, o0 + root + 1)):
            i = item(t[0].group, g)
            if item(t[0].object_root, o0 + i) == i:
                at = plane_of(after) + turn(spin, plane_of(item_strided(s.poses, candidate, i)) - plane_of(before))
                depth = wp.dot(n, at + way) - plane[2]
                if depth - item(t[0].object_radius, o0 + i)[0] < aim - missing:
                    low = lowest_vertex(t, o0 + i, turn_back(turn(spin, item_strided(s.turns, candidate, i)), n))
                    missing = wp.max(missing, aim - depth - low[2])
        way = way + missing * n
    return way


@wp.func
def move_inside(t: TablesRef, p: wp.int32, candidate: wp.int32, root: wp.int32, aim: wp.float32, s: State):
    """Move a root with its whole group into the room's half planes."""
    o0 = item(t[0].object_start, p)
    way = way_inside(t, p, candidate, root, item_strided(s.poses, candidate, root), aim, s)
    for g in range(item(t[0].group_start, o0 + root), item(t[0].group_start, o0 + root + 1)):
        i = item(t[0].group, g)
        pose = item_strided(s.poses, candidate, i)
        set_pose(s, candidate, i, wp.vec4(pose[0] + way[0], pose[1] + way[1], pose[2], pose[3]))


@wp.func
def redraw_surfaces(
    t: TablesRef,
    p: wp.int32,
    root: wp.int32,
    candidate: wp.int32,
    key: wp.int32,
    # Out:
    poses: wp.array2d(dtype=wp.vec4),
):
    """Lay out the surfaces of a root anew from their pools; the key says which entries."""
    o = item(t[0].object_start, p) + root
    rng = wp.rand_init(key)
    for d in range(item(t[0].surface_start, o), item(t[0].surface_start, o + 1)):
        base = poses[candidate, item(t[0].surface_supporter, d)]
        q = wp.vec2(wp.cos(base[3]), wp.sin(base[3]))
        first = item(t[0].surface_member_start, d)
        count = item(t[0].surface_member_start, d + 1) - first
        entry = wp.min(int(wp.randf(rng) * float(t[0].pool_size)), t[0].pool_size - 1)
        for j in range(count):
            local = item(t[0].pool, item(t[0].pool_start, d) + entry * count + j)
            at = plane_of(base) + turn(q, plane_of(local))
            yaw = wrap(base[3] + local[3], TURN)
            i = item(t[0].surface_member, first + j)
            poses[candidate, i] = wp.vec4(at[0], at[1], base[2] + item(t[0].surface_height, d), yaw)


@cache
def group_evaluator(kinds: int) -> wp.Function:
    """A function that adds up some kinds of terms of the objects group[first:last], as one rigid body about the first.

    Pairs among what the view moves are left out, and so is the rest once the energy exceeds the limit.
    """
    object_energy = object_evaluator(kinds)

    @wp.func(name=f"group_energy_{kinds}")
    def energy(b: Problems, layout: Layout, first: wp.int32, last: wp.int32, part: TermSlice):
        t = b.tables
        c = layout.candidate
        root = item(t[0].group, first)
        at = plane_of(item_strided(layout.state.poses, c.index, root))
        total = Energy()
        for k in range(first, last):
            if total.value > part.limit:
                break
            i = item(t[0].group, k)
            rest = TermSlice(part.first, part.step, part.limit - total.value)
            e = object_energy(b, layout, i, rest)
            total.value += e.value
            total.share += e.share
            total.soft += e.soft
            arm = perp(plane_of(item_strided(layout.state.poses, c.index, i)) - at)
            g = e.gradient
            total.gradient += wp.vec4(g[0], g[1], g[2], g[3] + g[0] * arm[0] + g[1] * arm[1])
        total.gradient = free_part(t, c.first_object + root, total.gradient)
        return total

    return energy


group_energy = group_evaluator(EVERY_KIND)
