"""Contacts of prisms as linear inequalities.

A convex prism is clear of another one when some face of either has all vertices of the other before it. Which face
is a discrete choice, made anew from the present poses: the one with the largest clearance, so the way out that is
shortest. Given the face, the clearance of each vertex is smooth in both poses, and its derivative gives a row.
"""

import warp as wp

from .bodies import Body, Candidate
from .geometry import FAR, discs_apart, overlap_in_z, parting_face, perp, plane_of, turn, turn_back
from .inequality import ROWS, SURE, InequalitySystem, add_row, wanting
from .tables import State, TablesRef
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
    t: TablesRef,
    c: Candidate,
    a: Body,
    b: Body,
    contact: Contact,
    least: wp.float32,
    reach: wp.float32,
    count: wp.int32,
    s: State,
    system: InequalitySystem,
):
    """Rows that keep the prisms of a contact of two bodies apart.

    Each pair of prisms gets the two vertices nearest to the parting face, so that a face may rest on a face. Returns
    the number of rows so far, and by how much [m] the pairs miss the verdict's limit in all, without those that cannot
    move.
    """
    count = int(count)
    pa = plane_of(a.pose)
    pb = plane_of(b.pose)
    missed = float(0.0)
    for i in range(contact.first[0], contact.first[1]):
        for j in range(contact.second[0], contact.second[1]):
            near = overlap_in_z(a.pose[2], t[0].prism_z[i], b.pose[2], t[0].prism_z[j], least)
            if near and not discs_apart(t, i, pa, a.turn, j, pb, b.turn, reach):
                parting = parting_face(t, i, pa, a.turn, j, pb, b.turn, reach)
                if parting.face >= 0:
                    # the face's owner, the other prism, and the direction from a to b
                    owner = pa
                    turned = a.turn
                    other = j
                    at = pb
                    q = b.turn
                    if not parting.of_first:
                        owner = pb
                        turned = b.turn
                        other = i
                        at = pa
                        q = a.turn
                    plane = t[0].edge[parting.face]
                    n = turn(turned, wp.vec2(plane[0], plane[1]))
                    offset = wp.dot(n, at - owner) - plane[2]
                    nearest = nearest_vertices(t, other, turn_back(q, n), offset, no_vertices())
                    out = n
                    if not parting.of_first:
                        out = -n
                    mobile = int(0)
                    for k in range(2):
                        v = wp.where(k == 0, nearest.lowest, nearest.second)
                        d = wp.where(k == 0, nearest.low, nearest.next)
                        if v >= 0 and d < reach:
                            room = ROWS
                            if d > contact.hold:
                                room = ROWS - SPARE
                            if count >= room:
                                mobile = 1
                            else:
                                point = at + turn(q, t[0].vertex[v])
                                added = add_row(
                                    t,
                                    c,
                                    a.obj * ROWS + count,
                                    wp.vec3i(a.obj, b.obj, -1),
                                    wp.vec4(-out[0], -out[1], 0.0, -wp.dot(out, perp(point - pa))),
                                    wp.vec4(out[0], out[1], 0.0, wp.dot(out, perp(point - pb))),
                                    wp.vec4(0.0, 0.0, 0.0, 0.0),
                                    wanting(d, contact.hold),
                                    parting.face * 32768 + v,
                                    s,
                                    system,
                                )
                                count += added
                                mobile += added
                    if mobile > 0:
                        missed += wp.max(contact.hold + SURE - parting.clearance, 0.0)
    return count, missed
