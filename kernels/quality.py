"""How good valid layouts are: soft terms of design, measured for all candidates at once.

A row of the terms asks one measure of some members (objects of the problem, or places such as doors, windows and
walls) to lie in a soft interval. What it misses, in units of a span and at most 1, times a weight is what the row takes
off; rows of one rule take off so much together at most. Members are what they occupy in plan as boxes where it is
between them, and by their true prisms where something is in the way. `quality_floor` has the measures that need a grid.
"""

import math
from typing import TYPE_CHECKING

import warp as wp

from .array_access import item, item_strided
from .geometry import FAR, Prism, box_distance, box_separation, perp, plane_of, turn, turn_back, wrap
from .tables import FIXTURE_SOLID, SOLIDS, Problems, State, Table, TablesRef, parts_of, struct_of

wp.set_module_options({"enable_backward": False})

# Measures, ``Terms.kind``. Members are a, b, c in their order; "ahead" and "aside" are the axes of a member's frame.
LATERAL = 0  # [m] how far b's middle is aside of a's
AHEAD = 1  # [m] how far b's middle is ahead of a's
GAP = 2  # [m] between the boxes of a and b; negative: they overlap
NEAREST = 3  # [m] the least gap between a and one of the others
BEARING = 4  # [rad] from a's front, turned by p0, to the middle of the other it is least off; 0 to pi
TURNED = 5  # [rad] b's yaw less a's and p0, wrapped to a period of p1; 0 to p1 / 2
MIRRORED = 6  # [m] between b and where a's mirror image at the axis of c is
BACKING = 7  # [m] a's back ahead of b
CLEAR = 8  # [m] free before a side of a (`side_of`), p0 wide (0: as it), from height p1 to p2; others do not count
OVERLAP = 9  # [m] of the width of b's side p1, p2 wider at its ends, that a stands before, where it is nearer than p0
SCREENED = 10  # [m] of the line between a and b at height p0 that solids take up; other members do not count
BARE = (
    11  # [m] of wall a in stretches longer than p2 with nothing nearer than p0, be it hung or p1 high, nor an opening
)
UNEVEN = (
    12  # pairs of the members that nearly stand in line, nearer than p0; p1 1: seats, which are compared aside only
)
ON_FLOOR = 16  # and above: those of `quality_floor`

BINS = wp.constant(32)  # of a wall
OUT_OF_LINE = wp.constant(wp.vec2(0.015, 0.12))  # [m] between equals of a row that look like a mistake
SAME_WAY = wp.constant(math.radians(3.0))  # angle up to which equals are parallel
HUNG = wp.constant(0.3)  # [m] above the floor from which on something hangs

TERMS = (
    Table("kind", ("row",), wp.int32, "", "the measure"),
    Table("member_start", ("row + 1",), wp.int32, "", "range of a row's members"),
    Table("member", ("member",), wp.int32, "", "object (local), or -1 - place"),
    Table("interval", ("row",), wp.vec4, "", "lowest and highest value that takes nothing off, span, weight"),
    Table("params", ("row",), wp.vec4, "", "numbers of the measure"),
    Table("rule_start", ("rule + 1",), wp.int32, "", "range of a rule's rows"),
    Table("rule_most", ("rule",), wp.float32, "", "what its rows take off together at most"),
    Table("place", ("place",), wp.vec4, "m", "middle, and (cos, sin) of the way into the room"),
    Table("place_half", ("place",), wp.vec2, "m", "half the depth and half the width"),
    Table("place_z", ("place",), wp.vec2, "m", "lowest and highest point"),
)

# ``first`` is the first object of the candidates' problem in the tables.
if TYPE_CHECKING:
    from .tables import Arrays

    class Terms(Arrays):
        """As below."""
else:
    Terms = struct_of("Terms", "Terms of design for the candidates of one problem, see TERMS.", TERMS, first=wp.int32)


@wp.struct
class Member:
    """What a row is about: a box in plan and its heights."""

    at: wp.vec2
    turn: wp.vec2  # (cos, sin) of the yaw
    half: wp.vec2
    z: wp.vec2


@wp.func
def member_of(b: Problems, terms: Terms, s: State, candidate: wp.int32, k: wp.int32):
    """Member k of the terms where it stands."""
    m = item(terms.member, k)
    x = Member()
    if m >= 0:
        t = b.tables
        pose = item_strided(s.poses, candidate, m)
        size = item(t[0].object_size, terms.first + m)
        x.at = plane_of(pose)
        x.turn = item_strided(s.turns, candidate, m)
        x.half = wp.vec2(0.5 * size[0], 0.5 * size[1])
        x.z = wp.vec2(pose[2], pose[2] + size[2])
    else:
        place = item(terms.place, -1 - m)
        x.at = wp.vec2(place[0], place[1])
        x.turn = wp.vec2(place[2], place[3])
        x.half = item(terms.place_half, -1 - m)
        x.z = item(terms.place_z, -1 - m)
    return x


@wp.func
def has_member(terms: Terms, first: wp.int32, last: wp.int32, obj: wp.int32):
    """Whether an object is one of a range of members."""
    for k in range(first, last):
        if item(terms.member, k) == obj:
            return True
    return False


@wp.func
def in_frame(x: Member, p: wp.vec2):
    """A point as a member sees it: ahead, aside."""
    return turn_back(x.turn, p - x.at)


@wp.func
def side_of(x: Member, side: wp.int32):
    """A member with another side for its front: 0 front, 1 left, 2 back, 3 right."""
    y = x
    if side == 1:
        y.turn = perp(x.turn)
    if side == 2:
        y.turn = -x.turn
    if side == 3:
        y.turn = -perp(x.turn)
    if side == 1 or side == 3:
        y.half = wp.vec2(x.half[1], x.half[0])
    return y


@wp.func
def yaw_between(q: wp.vec2, r: wp.vec2):
    """Angle from one direction to another, in (-pi, pi]."""
    return wp.atan2(q[0] * r[1] - q[1] * r[0], wp.dot(q, r))


@wp.func
def gap_of(a: Member, b: Member):
    """Distance of two boxes; where they overlap, minus their separating-axis depth."""
    x = Prism(0, wp.vec4(0.0, 0.0, a.half[0], a.half[1]), a.at, a.turn)
    y = Prism(0, wp.vec4(0.0, 0.0, b.half[0], b.half[1]), b.at, b.turn)
    s, _n, _x = box_separation(x, y, -FAR)
    if s > 0.0:
        s, _n, _x = box_distance(x, y)
    return s


@wp.func
def gap_to_point(a: Member, p: wp.vec2):
    """Distance of a point from a box; 0 inside."""
    v = in_frame(a, p)
    return wp.length(wp.vec2(wp.max(wp.abs(v[0]) - a.half[0], 0.0), wp.max(wp.abs(v[1]) - a.half[1], 0.0)))


@wp.func
def box_in_frame(x: Member, other: Member):
    """Bounds of another member's box as a member sees it: ahead from and to, aside from and to."""
    middle = in_frame(x, other.at)
    c = wp.abs(wp.dot(x.turn, other.turn))
    s = wp.abs(x.turn[0] * other.turn[1] - x.turn[1] * other.turn[0])
    ahead = c * other.half[0] + s * other.half[1]
    aside = s * other.half[0] + c * other.half[1]
    return wp.vec4(middle[0] - ahead, middle[0] + ahead, middle[1] - aside, middle[1] + aside)


@wp.func
def nearest_in_strip(t: TablesRef, prism: wp.int32, at: wp.vec2, q: wp.vec2, x: Member, half: wp.float32):
    """How far ahead of a member's middle a prism begins within ``half`` of its axis, and ends: FAR, -FAR if it is not
    there."""
    first = item(t[0].prism_start, prism)
    last = item(t[0].prism_start, prism + 1)
    near = float(FAR)
    far = float(-FAR)
    before = in_frame(x, at + turn(q, item(t[0].vertex, last - 1)))
    for e in range(first, last):
        v = in_frame(x, at + turn(q, item(t[0].vertex, e)))
        rise = v[1] - before[1]
        low = float(0.0)  # the part of the edge within the strip, as shares of its length
        high = float(1.0)
        if wp.abs(rise) < 1.0e-9:
            if wp.abs(v[1]) >= half:
                high = -1.0
        else:
            u = (-half - before[1]) / rise
            w = (half - before[1]) / rise
            low = wp.max(low, wp.min(u, w))
            high = wp.min(high, wp.max(u, w))
        if low < high:
            p = before[0] + low * (v[0] - before[0])
            r = before[0] + high * (v[0] - before[0])
            near = wp.min(near, wp.min(p, r))
            far = wp.max(far, wp.max(p, r))
        before = v
    return near, far


@wp.func
def free_ahead(b: Problems, terms: Terms, s: State, candidate: wp.int32, x: Member, members: wp.vec2i, p: wp.vec4):
    """Free length ahead of a member's front face: up to a wall, the outside of the room, or an object."""
    t = b.tables
    problem = b.problem[candidate]
    half = wp.where(p[0] > 0.0, 0.5 * p[0], x.half[1]) - 0.01  # what touches at a side is beside
    front = x.at + x.half[0] * x.turn
    best = float(FAR)
    for k in range(item(t[0].plane_start, problem), item(t[0].plane_start, problem + 1)):
        plane = item(t[0].plane, k)
        n = wp.vec2(plane[0], plane[1])
        speed = -wp.dot(n, x.turn)
        if speed > 1.0e-3:
            best = wp.min(best, wp.max(wp.dot(n, front) - plane[2], 0.0) / speed)
    for k in range(item(t[0].fixture_start, problem), item(t[0].fixture_start, problem + 1)):
        if item(t[0].fixture_kind, k) == FIXTURE_SOLID:
            near, far = nearest_in_strip(t, item(t[0].fixture, k), wp.vec2(0.0, 0.0), wp.vec2(1.0, 0.0), x, half)
            if far > x.half[0]:
                best = wp.min(best, wp.max(near - x.half[0], 0.0))
    for obj in range(item(t[0].object_start, problem + 1) - terms.first):
        o = terms.first + obj
        pose = item_strided(s.poses, candidate, obj)
        v = in_frame(x, plane_of(pose))
        reach = item(t[0].object_radius, o)[0]
        if v[0] + reach > x.half[0] and v[0] - reach < x.half[0] + best and wp.abs(v[1]) < half + reach:
            if not has_member(terms, members[0], members[1], obj):
                solids = parts_of(t, o, SOLIDS)
                for a in range(solids[0], solids[1]):
                    z = item(t[0].prism_z, a)
                    if pose[2] + z[0] < p[2] and pose[2] + z[1] > p[1]:
                        q = item_strided(s.turns, candidate, obj)
                        near, far = nearest_in_strip(t, a, plane_of(pose), q, x, half)
                        if far > x.half[0] + 0.01:
                            best = wp.min(best, wp.max(near - x.half[0], 0.0))
    return best


@wp.func
def length_within(t: TablesRef, prism: wp.int32, at: wp.vec2, q: wp.vec2, p: wp.vec2, r: wp.vec2):
    """Length of the line from p to r that lies in a prism's polygon."""
    u = turn_back(q, p - at)
    v = turn_back(q, r - at) - u
    low = float(0.0)
    high = float(1.0)
    for e in range(item(t[0].prism_start, prism), item(t[0].prism_start, prism + 1)):
        face = item(t[0].edge, e)
        n = wp.vec2(face[0], face[1])
        left = face[2] - wp.dot(n, u)  # inside where n . v * share <= left
        speed = wp.dot(n, v)
        if wp.abs(speed) < 1.0e-9:
            if left < 0.0:
                high = -1.0
        elif speed > 0.0:
            high = wp.min(high, left / speed)
        else:
            low = wp.max(low, left / speed)
    return wp.max(high - low, 0.0) * wp.length(v)


@wp.func
def screened_length(
    b: Problems,
    terms: Terms,
    s: State,
    candidate: wp.int32,
    members: wp.vec2i,
    p: wp.vec2,
    r: wp.vec2,
    height: wp.float32,
):
    """Length of the line from p to r at a height that solids take up, those of the members left out."""
    t = b.tables
    problem = b.problem[candidate]
    total = float(0.0)
    way = wp.max(wp.length(r - p), 1.0e-6)
    along = (r - p) / way
    for obj in range(item(t[0].object_start, problem + 1) - terms.first):
        o = terms.first + obj
        pose = item_strided(s.poses, candidate, obj)
        ends = item(t[0].object_z, o)
        if pose[2] + ends[0] < height and pose[2] + ends[1] > height:
            at = plane_of(pose)
            reach = item(t[0].object_radius, o)[0]
            u = wp.clamp(wp.dot(at - p, along), 0.0, way)
            if wp.length(p + u * along - at) < reach and not has_member(terms, members[0], members[1], obj):
                solids = parts_of(t, o, SOLIDS)
                for a in range(solids[0], solids[1]):
                    z = item(t[0].prism_z, a)
                    if pose[2] + z[0] < height and pose[2] + z[1] > height:
                        total += length_within(t, a, at, item_strided(s.turns, candidate, obj), p, r)
    return wp.min(total, way)


@wp.func
def bins_within(low: wp.float32, high: wp.float32, half: wp.float32):
    """The bins of a wall whose middle lies between two places aside of the wall's own middle, as bits."""
    scale = float(BINS) / (2.0 * half)
    first = wp.clamp(int(wp.ceil((low + half) * scale - 0.5)), 0, BINS)
    last = wp.clamp(int(wp.ceil((high + half) * scale - 0.5)), 0, BINS)
    bits = wp.uint32(0)
    for k in range(first, last):
        bits = bits | (wp.uint32(1) << wp.uint32(k))
    return bits


@wp.func
def bare_length(b: Problems, terms: Terms, s: State, candidate: wp.int32, wall: Member, members: wp.vec2i, p: wp.vec4):
    """Length of a wall in stretches longer than p2 with neither an opening nor a high or hung object nearer than p0."""
    t = b.tables
    problem = b.problem[candidate]
    covered = wp.uint32(0)
    for k in range(members[0] + 1, members[1]):
        box = box_in_frame(wall, member_of(b, terms, s, candidate, k))
        covered = covered | bins_within(box[2], box[3], wall.half[1])
    for obj in range(item(t[0].object_start, problem + 1) - terms.first):
        pose = item_strided(s.poses, candidate, obj)
        size = item(t[0].object_size, terms.first + obj)
        hung = pose[2] > HUNG and pose[2] + size[2] < wall.z[1] - 0.05
        if hung or (size[2] >= p[1] and pose[2] <= HUNG):
            other = Member()
            other.at = plane_of(pose)
            other.turn = item_strided(s.turns, candidate, obj)
            other.half = wp.vec2(0.5 * size[0], 0.5 * size[1])
            box = box_in_frame(wall, other)
            if box[0] < p[0] and box[1] > 0.0:
                covered = covered | bins_within(box[2], box[3], wall.half[1])
    step = 2.0 * wall.half[1] / float(BINS)
    total = float(0.0)
    run = float(0.0)
    for k in range(BINS):
        if ((covered >> wp.uint32(k)) & wp.uint32(1)) == wp.uint32(1):
            total += wp.where(run > p[2], run, 0.0)
            run = float(0.0)
        else:
            run += step
    return total + wp.where(run > p[2], run, 0.0)


@wp.func
def uneven_pairs(b: Problems, terms: Terms, s: State, candidate: wp.int32, members: wp.vec2i, p: wp.vec4):
    """Members whose nearest equal along a row is a little out of line with them."""
    total = float(0.0)
    axes = wp.where(p[1] > 0.0, 1, 2)
    for i in range(members[0], members[1]):
        a = member_of(b, terms, s, candidate, i)
        for axis in range(axes):
            nearest = p[0]
            off = float(0.0)
            for k in range(members[0], members[1]):
                o = member_of(b, terms, s, candidate, k)
                v = in_frame(a, o.at)
                along = wp.where(axis == 0, v[1], v[0])
                across = wp.abs(wp.where(axis == 0, v[0], v[1]))
                yaw = yaw_between(a.turn, o.turn)
                parallel = wp.abs(wrap(yaw, 0.5 * wp.pi)) < SAME_WAY and (p[1] == 0.0 or wp.cos(yaw) > 0.9)
                if parallel and along > 0.05 and along < nearest and across < 0.2:
                    nearest = along
                    off = across
            if off > OUT_OF_LINE[0] and off < OUT_OF_LINE[1]:
                total += 1.0
    return total


@wp.func
def measured(b: Problems, terms: Terms, s: State, candidate: wp.int32, row: wp.int32):
    """The measure of a row."""
    kind = item(terms.kind, row)
    p = item(terms.params, row)
    first = item(terms.member_start, row)
    last = item(terms.member_start, row + 1)
    members = wp.vec2i(first, last)
    a = member_of(b, terms, s, candidate, first)
    if kind == NEAREST:
        best = float(FAR)
        for k in range(first + 1, last):
            best = wp.min(best, gap_of(a, member_of(b, terms, s, candidate, k)))
        return best
    if kind == CLEAR:
        return free_ahead(b, terms, s, candidate, side_of(a, int(p[3])), members, p)
    if kind == BEARING:
        best = float(FAR)
        for k in range(first + 1, last):
            w = in_frame(a, member_of(b, terms, s, candidate, k).at)
            best = wp.min(best, wp.abs(wrap(wp.atan2(w[1], w[0]) - p[0], 2.0 * wp.pi)))
        return best
    if kind == BARE:
        return bare_length(b, terms, s, candidate, a, members, p)
    if kind == UNEVEN:
        return uneven_pairs(b, terms, s, candidate, members, p)
    o = member_of(b, terms, s, candidate, first + 1)
    v = in_frame(a, o.at)
    if kind == LATERAL:
        return wp.abs(v[1])
    if kind == AHEAD:
        return v[0]
    if kind == GAP:
        return gap_of(a, o)
    if kind == TURNED:
        return wp.abs(wrap(yaw_between(a.turn, o.turn) - p[0], p[1]))
    if kind == BACKING:
        return in_frame(o, a.at - a.half[0] * a.turn)[0]
    if kind == OVERLAP:
        face = side_of(o, int(p[1]))
        box = box_in_frame(face, a)
        half = face.half[1] + p[2]
        width = wp.min(box[3], half) - wp.max(box[2], -half)
        return wp.where(box[0] < p[0] and box[1] > 0.0, wp.max(width, 0.0), 0.0)
    if kind == SCREENED:
        return screened_length(b, terms, s, candidate, members, a.at, o.at, p[0])
    if kind == MIRRORED:
        axis = member_of(b, terms, s, candidate, first + 2)
        u = in_frame(axis, a.at)
        w = in_frame(axis, o.at)
        return wp.length(wp.vec2(u[0] - w[0], u[1] + w[1]))
    return 0.0


@wp.kernel
def measure(
    # Problem:
    b: Problems,
    terms: Terms,
    selected: wp.array(dtype=wp.int32),
    # State in:
    s: State,
    # State out:
    value_out: wp.array2d(dtype=wp.float32),
):
    """The measures [slot, row] of the selected candidates, those on the floor left out."""
    slot, row = wp.tid()
    if item(terms.kind, row) < ON_FLOOR:
        value_out[slot, row] = measured(b, terms, s, selected[slot], row)


@wp.func
def penalty(interval: wp.vec4, value: wp.float32):
    """What a value takes off."""
    missed = wp.max(interval[0] - value, value - interval[1]) / interval[2]
    return interval[3] * wp.clamp(missed, 0.0, 1.0)


@wp.kernel
def add_up(
    # Problem:
    terms: Terms,
    floor: wp.int32,
    # State in:
    value: wp.array2d(dtype=wp.float32),
    # State out:
    points_out: wp.array(dtype=wp.float32),
):
    """What all rows take off together [slot]. ``floor`` 0: those on the floor are not measured and count in full."""
    slot = wp.tid()
    total = float(0.0)
    for rule in range(terms.rule_most.shape[0]):
        points = float(0.0)
        for row in range(item(terms.rule_start, rule), item(terms.rule_start, rule + 1)):
            interval = item(terms.interval, row)
            if floor == 0 and item(terms.kind, row) >= ON_FLOOR:
                points += interval[3]
            else:
                points += penalty(interval, value[slot, row])
        total += wp.min(points, item(terms.rule_most, rule))
    points_out[slot] = total
