"""Contacts of prisms as linear inequalities.

A convex prism is clear of another one when some face of either has all vertices of the other before it. Which face
is a discrete choice, made anew from the present poses: the one with the largest clearance, so the way out that is
shortest. Given the face, the clearance of each vertex is smooth in both poses, and its derivative gives a row.
"""

import warp as wp

from .bodies import Body, Candidate, prism_of
from .geometry import FAR, discs_apart, overlap_in_z, parting_face, perp, turn, turn_back
from .inequality import ROWS, SURE, InequalitySystem, Jacobian, RowCount, add_row, wanting
from .tables import Problems, State, TablesRef
from .terms_contacts import Contact

wp.set_module_options({"enable_backward": False})

SPARE = wp.constant(8)  # rows of an object kept for what is violated


@wp.struct
class NearestVertices:
    """The two vertices that lie furthest against a direction, and how far along it they lie [m]; -1: none."""

    lowest: wp.int32
    second: wp.int32
    low: wp.float32
    next: wp.float32


@wp.func
def no_vertices():
    """Nothing looked at yet."""
    return NearestVertices(-1, -1, FAR, FAR)


@wp.func
def nearest_vertices(t: TablesRef, prism: wp.int32, m: wp.vec2, offset: wp.float32, x: NearestVertices):
    """The two nearest vertices among those so far and a prism's, along m (in its frame) from an offset."""
    for v in range(t[0].prism_start[prism], t[0].prism_start[prism + 1]):
        d = wp.dot(m, t[0].vertex[v]) + offset
        if d < x.low:
            x.next = x.low
            x.second = x.lowest
            x.low = d
            x.lowest = v
        elif d < x.next:
            x.next = d
            x.second = v
    return x


@wp.func(inline=False)
def add_contact_rows(
    b: Problems, c: Candidate, x: Body, other: Body, contact: Contact, n: RowCount, s: State, system: InequalitySystem
):
    """Rows that keep the prisms of a contact of two bodies apart, added to those so far.

    Each pair of prisms gets the two vertices nearest to the parting face, so that a face may rest on a face.
    """
    t = b.tables
    reach = system.reach
    for i in range(contact.first[0], contact.first[1]):
        for j in range(contact.second[0], contact.second[1]):
            first = prism_of(t, i, x)
            second = prism_of(t, j, other)
            zi = t[0].prism_z[i]
            near = overlap_in_z(x.pose[2], zi, other.pose[2], t[0].prism_z[j], b.margins.least_overlap_z)
            if near and not discs_apart(t, first, second, reach):
                parting = parting_face(t, first, second, reach)
                if parting.face >= 0:
                    owner = first  # of the face
                    facing = second
                    if not parting.of_first:
                        owner = second
                        facing = first
                    plane = t[0].edge[parting.face]
                    normal = turn(owner.turn, wp.vec2(plane[0], plane[1]))
                    offset = wp.dot(normal, facing.at - owner.at) - plane[2]
                    way = turn_back(facing.turn, normal)
                    nearest = nearest_vertices(t, facing.index, way, offset, no_vertices())
                    out = normal  # from the first to the second
                    if not parting.of_first:
                        out = -normal
                    mobile = int(0)
                    for k in range(2):
                        v = wp.where(k == 0, nearest.lowest, nearest.second)
                        d = wp.where(k == 0, nearest.low, nearest.next)
                        if v >= 0 and d < reach:
                            room = ROWS
                            if d > contact.hold:
                                room = ROWS - SPARE
                            if n.count >= room:
                                mobile = 1
                            else:
                                point = facing.at + turn(facing.turn, t[0].vertex[v])
                                g = Jacobian()
                                g[0] = wp.vec4(-out[0], -out[1], 0.0, -wp.dot(out, perp(point - first.at)))
                                g[1] = wp.vec4(out[0], out[1], 0.0, wp.dot(out, perp(point - second.at)))
                                who = wp.vec3i(x.obj, other.obj, -1)
                                want = wanting(d, contact.hold, system)
                                key = parting.face * 32768 + v
                                added = add_row(t, c, x.obj * ROWS + n.count, who, g, want, key, s, system)
                                n.count += added
                                mobile += added
                    if mobile > 0:
                        n.missed += wp.max(contact.hold + SURE - parting.clearance, 0.0)
    return n
