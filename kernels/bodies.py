"""Candidates and their objects, as functions take them: what would else be six arguments is a struct of two or four."""

import warp as wp

from .array_access import item, item_strided
from .geometry import plane_of, prism_at, turn
from .tables import FREE_PLANE, FREE_YAW, FREE_Z, Problems, State, TablesRef, View

wp.set_module_options({"enable_backward": False})

EAST = wp.constant(wp.vec2(1.0, 0.0))


@wp.struct
class Candidate:
    """A candidate and the range of its problem's objects in the tables."""

    index: wp.int32
    problem: wp.int32
    first_object: wp.int32  # global index of the problem's object 0
    objects: wp.int32


@wp.struct
class Body:
    """An object, or the prism of a fixture, at a pose."""

    obj: wp.int32  # local index; -1: a fixture
    index: wp.int32  # global index of the object or of the fixture
    pose: wp.vec4  # x, y, z [m], yaw [rad]
    turn: wp.vec2  # (cos, sin) of the yaw


@wp.struct
class Layout:
    """A candidate's layout as a view sees it."""

    candidate: Candidate
    state: State
    view: View


@wp.func
def layout_of(c: Candidate, s: State):
    """A candidate's layout as it stands."""
    return Layout(c, s, View())


@wp.func
def candidate_of(b: Problems, candidate: wp.int32):
    """A candidate of a batch."""
    t = b.tables
    c = Candidate()
    c.index = candidate
    c.problem = b.problem[candidate]
    c.first_object = item(t[0].object_start, c.problem)
    c.objects = item(t[0].object_start, c.problem + 1) - c.first_object
    return c


@wp.func
def object_count(t: TablesRef, p: wp.int32):
    """How many objects problem p has."""
    return item(t[0].object_start, p + 1) - item(t[0].object_start, p)


@wp.func
def root_at(b: Problems, candidate: wp.int32, obj: wp.int32):
    """Global index of a candidate's object if that is a root; -1: it is carried, or there is no such object."""
    if candidate >= b.problem.shape[0]:
        return -1
    t = b.tables
    p = b.problem[candidate]
    o = item(t[0].object_start, p) + obj
    if o >= item(t[0].object_start, p + 1):
        return -1
    return wp.where(item(t[0].object_root, o) == obj, o, -1)


@wp.func
def viewed_body(layout: Layout, i: wp.int32):
    """Object i where the view sees it."""
    view = layout.view
    candidate = layout.candidate.index
    pose = item_strided(layout.state.poses, candidate, i)
    q = item_strided(layout.state.turns, candidate, i)
    if view.stamp != 0:
        mark = item(layout.state.mark, candidate, i)
        if wp.abs(mark) == view.stamp:
            rise = float(0.0)
            if mark < 0:
                rise = view.after[2] - view.before[2]
                if view.draft == 1:
                    pose = item(layout.state.draft, candidate, i)
                    q = wp.vec2(wp.cos(pose[3]), wp.sin(pose[3]))
            at = plane_of(view.after) + turn(view.spin, plane_of(pose) - plane_of(view.before))
            pose = wp.vec4(at[0], at[1], pose[2] + rise, pose[3] + view.after[3] - view.before[3])
            q = turn(view.spin, q)
    return Body(i, layout.candidate.first_object + i, pose, q)


@wp.func
def body_of(c: Candidate, obj: wp.int32, s: State):
    """An object where it stands."""
    return Body(obj, c.first_object + obj, item_strided(s.poses, c.index, obj), item_strided(s.turns, c.index, obj))


@wp.func
def fixture_body(k: wp.int32):
    """Fixture k (global), which stands where its prism says."""
    return Body(-1, k, wp.vec4(0.0, 0.0, 0.0, 0.0), EAST)


@wp.func
def posed(x: Body, pose: wp.vec4):
    """An object at another pose."""
    return Body(x.obj, x.index, pose, wp.vec2(wp.cos(pose[3]), wp.sin(pose[3])))


@wp.func
def prism_of(t: TablesRef, prism: wp.int32, x: Body):
    """A prism (global index) of an object or of a fixture where that is."""
    return prism_at(t, prism, plane_of(x.pose), x.turn)


@wp.func
def free_part(t: TablesRef, o: wp.int32, v: wp.vec4):
    """A vector (x, y, z, yaw) without what object o (global) is not free to do."""
    free = item(t[0].object_free, o)
    if (free & FREE_PLANE) == 0:
        v[0] = 0.0
        v[1] = 0.0
    if (free & FREE_Z) == 0:
        v[2] = 0.0
    if (free & FREE_YAW) == 0:
        v[3] = 0.0
    return v
