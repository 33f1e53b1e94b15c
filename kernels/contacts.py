"""Contacts of prisms as linear inequalities.

A convex prism is clear of another one when some face of either has all vertices of the other before it. Which face
is a discrete choice, made anew from the present poses: the one with the largest clearance, so the way out that is
shortest. Given the face, the clearance of each vertex is smooth in both poses, and its derivative gives a row.
"""

import warp as wp

from .energy import overlap_in_z
from .geometry import FAR, discs_apart, perp, plane_of, turn, turn_back, way_out
from .inequality import ROWS, SURE, Inequality, add_row, wanting
from .tables import State, TablesRef

wp.set_module_options({"enable_backward": False})

SPARE = wp.constant(8)  # rows of an object kept for what is violated


@wp.func(inline=False)
def parting_face(
    t: TablesRef, a: wp.int32, pa: wp.vec2, qa: wp.vec2, b: wp.int32, pb: wp.vec2, qb: wp.vec2, far: wp.float32
):
    """The face, of prism a or b, with the largest clearance of the other prism: (clearance, face, 1 when it is a's).

    As `geometry.separation`, which finds the same clearance: faces that are no way out only tell whether the prisms
    are apart. The face is -1 when they are further apart than ``far``.
    """
    best = float(-FAR)
    best_face = int(-1)
    best_mine = int(1)
    shut = float(-FAR)
    shut_face = int(-1)
    shut_mine = int(1)
    a0 = t[0].prism_start[a]
    a1 = t[0].prism_start[a + 1]
    b0 = t[0].prism_start[b]
    b1 = t[0].prism_start[b + 1]
    ab = pb - pa
    for k in range(a0, a1 + b1 - b0):
        mine = int(1)
        face = k
        v0 = b0
        v1 = b1
        q = qa
        other = qb
        towards = ab
        if k >= a1:
            mine = 0
            face = b0 + k - a1
            v0 = a0
            v1 = a1
            q = qb
            other = qa
            towards = -ab
        plane = t[0].edge[face]
        n = turn(q, wp.vec2(plane[0], plane[1]))
        m = turn_back(other, n)
        low = float(FAR)
        rest = int(v0)
        for v in range(v0, v1):
            d = wp.dot(m, t[0].vertex[v])
            if d < low:
                low = d
                rest = v
        clear = low + wp.dot(n, towards) - plane[2]
        if clear > far:
            return clear, int(-1), int(1)
        if clear > wp.min(best, shut):
            if way_out(t, face, v0, v1, rest):
                if clear > best:
                    best = clear
                    best_face = face
                    best_mine = mine
            else:
                if clear > 0.0:
                    return FAR, int(-1), int(1)
                if clear > shut:
                    shut = clear
                    shut_face = face
                    shut_mine = mine
    if best == -FAR:
        return shut, shut_face, shut_mine
    return best, best_face, best_mine


@wp.func(inline=False)
def add_contacts(
    t: TablesRef,
    o0: wp.int32,
    candidate: wp.int32,
    base: wp.int32,
    count: wp.int32,
    i: wp.int32,
    parts_a: wp.vec2i,
    pose_a: wp.vec4,
    qa: wp.vec2,
    j: wp.int32,
    parts_b: wp.vec2i,
    pose_b: wp.vec4,
    qb: wp.vec2,
    hold: wp.float32,
    least: wp.float32,
    reach: wp.float32,
    s: State,
    shift: wp.array2d(dtype=wp.vec4),
    rows: wp.array2d(dtype=Inequality),
    keys: wp.array2d(dtype=wp.int32),
):
    """Rows that keep two ranges of prisms, of objects i and j (-1: static), apart.

    Each pair of prisms gets the two vertices nearest to the parting face, so that a face may rest on a face. Returns
    the number of rows so far, and by how much [m] the pairs miss the verdict's limit in all, without those that cannot
    move.
    """
    pa = plane_of(pose_a)
    pb = plane_of(pose_b)
    missed = float(0.0)
    for a in range(parts_a[0], parts_a[1]):
        for b in range(parts_b[0], parts_b[1]):
            if overlap_in_z(pose_a[2], t[0].prism_z[a], pose_b[2], t[0].prism_z[b], least):
                if not discs_apart(t, a, pa, qa, b, pb, qb, reach):
                    clear, face, mine = parting_face(t, a, pa, qa, b, pb, qb, reach)
                    if face >= 0:
                        mobile = int(0)
                        # the face's owner, the other prism, and the direction from a to b
                        owner = pa
                        turned = qa
                        v0 = t[0].prism_start[b]
                        v1 = t[0].prism_start[b + 1]
                        at = pb
                        q = qb
                        if mine == 0:
                            owner = pb
                            turned = qb
                            v0 = t[0].prism_start[a]
                            v1 = t[0].prism_start[a + 1]
                            at = pa
                            q = qa
                        plane = t[0].edge[face]
                        n = turn(turned, wp.vec2(plane[0], plane[1]))
                        m = turn_back(q, n)
                        offset = wp.dot(n, at - owner) - plane[2]
                        lowest = int(-1)
                        second = int(-1)
                        low = float(FAR)
                        next = float(FAR)
                        for v in range(v0, v1):
                            d = wp.dot(m, t[0].vertex[v]) + offset
                            if d < low:
                                next = low
                                second = lowest
                                low = d
                                lowest = v
                            elif d < next:
                                next = d
                                second = v
                        out = n
                        if mine == 0:
                            out = -n
                        for k in range(2):
                            v = lowest
                            d = low
                            if k == 1:
                                v = second
                                d = next
                            if v >= 0 and d < reach:
                                room = ROWS
                                if d > hold:
                                    room = ROWS - SPARE
                                if count >= room:
                                    mobile = 1
                                else:
                                    point = at + turn(q, t[0].vertex[v])
                                    ga = wp.vec4(-out[0], -out[1], 0.0, -wp.dot(out, perp(point - pa)))
                                    gb = wp.vec4(out[0], out[1], 0.0, wp.dot(out, perp(point - pb)))
                                    one = add_row(
                                        t,
                                        o0,
                                        candidate,
                                        base + count,
                                        wp.vec3i(i, j, -1),
                                        ga,
                                        gb,
                                        wp.vec4(0.0, 0.0, 0.0, 0.0),
                                        wanting(d, hold),
                                        face * 32768 + v,
                                        s,
                                        shift,
                                        rows,
                                        keys,
                                    )
                                    count += one
                                    mobile += one
                        if mobile > 0:
                            missed += wp.max(hold + SURE - clear, 0.0)
    return count, missed
