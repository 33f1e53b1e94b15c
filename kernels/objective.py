"""Objectives that are minimised over valid layouts: the value of a term, by layout.

A term is about some members: objects of the problem, or places (doors, windows, walls). A member has a pin, a point in
its own frame that turns with it. Values are not weighted; `sceneweaver.layout.objective` says what each kind is for,
and `sceneweaver.layout.objective_values` computes the same in float64 with arithmetic of its own.
"""

import math
from typing import TYPE_CHECKING

import warp as wp

from . import features
from .array_access import item, item_strided
from .bodies import Candidate, candidate_of
from .geometry import FAR, perp, plane_of, turn
from .tables import Problems, State, Table, TablesRef, struct_of

wp.set_module_options({"enable_backward": False})

# Kinds of terms, ``Objective.kind``.
WIRE_LENGTH = 0  # [m] half the perimeter of the box around all pins
FLOW = 1  # [m] between the pins of a and b; p0 1: manhattan, else euclidean
COST = 2  # [m] from the pin of a to the point (p0, p1), p2 1: manhattan; p3 1: the pin's (x, y) . (p0, p1) instead
EXPOSED_WALL = 3  # [m] of the walls (those members that are places) with no other member nearer than p0
LIGHT = 4  # shortfall of the illuminance at the first member from the others, as a share of p0 [lx]
USER = 5  # a residual of the user's of feature ``code``, of a and b

NEAREST_SOURCE = wp.constant(0.1)  # [m] distance below which a source of light gives no more
SPHERE = wp.constant(4.0 * math.pi)

OBJECTIVE = (
    Table("kind", ("term",), wp.int32, "", "what is measured"),
    Table("code", ("term",), wp.int32, "", "feature of a user's residual"),
    Table("weight", ("term",), wp.float32, "", "what a unit of the value costs"),
    Table("params", ("term",), wp.vec4, "", "numbers of the kind"),
    Table("member_start", ("term + 1",), wp.int32, "", "range of a term's members"),
    Table("member", ("member",), wp.int32, "", "object (local), or -1 - place"),
    Table("pin", ("member",), wp.vec3, "m", "in the member's frame"),
    Table("amount", ("member",), wp.float32, "lm", "what a source of light gives"),
    Table("incidence_start", ("object + 1",), wp.int32, "", "range of an object's terms"),
    Table("incidence", ("incidence",), wp.int32, "", "terms that the object is a member of, each once"),
    Table("place", ("place",), wp.vec4, "m", "middle, and (cos, sin) of the way into the room"),
    Table("place_half", ("place",), wp.float32, "m", "half the width"),
)

# ``terms`` is how many there are.
if TYPE_CHECKING:
    from .tables import Arrays

    class Objective(Arrays):
        """As below."""
else:
    Objective = struct_of("Objective", "The objective of the candidates of one problem.", OBJECTIVE, terms=wp.int32)


@wp.struct
class Pin:
    """A member's pin in the room's frame, and which way the member faces."""

    at: wp.vec3
    turn: wp.vec2


@wp.func
def pin_of(o: Objective, c: Candidate, s: State, k: wp.int32):
    """The pin of member k where it is."""
    m = item(o.member, k)
    p = item(o.pin, k)
    x = Pin()
    if m >= 0:
        pose = item_strided(s.poses, c.index, m)
        x.turn = item_strided(s.turns, c.index, m)
        at = plane_of(pose) + turn(x.turn, wp.vec2(p[0], p[1]))
        x.at = wp.vec3(at[0], at[1], pose[2] + p[2])
    else:
        place = item(o.place, -1 - m)
        x.turn = wp.vec2(place[2], place[3])
        at = wp.vec2(place[0], place[1]) + turn(x.turn, wp.vec2(p[0], p[1]))
        x.at = wp.vec3(at[0], at[1], p[2])
    return x


@wp.func
def length_of(v: wp.vec2, manhattan: wp.float32):
    """Length of a vector."""
    if manhattan > 0.5:
        return wp.abs(v[0]) + wp.abs(v[1])
    return wp.length(v)


@wp.func
def wire_length(o: Objective, c: Candidate, s: State, first: wp.int32, last: wp.int32):
    """Half the perimeter of the box around the pins."""
    x = pin_of(o, c, s, first)
    low = plane_of_point(x.at)
    high = low
    for k in range(first + 1, last):
        p = plane_of_point(pin_of(o, c, s, k).at)
        low = wp.min(low, p)
        high = wp.max(high, p)
    return high[0] - low[0] + high[1] - low[1]


@wp.func
def plane_of_point(p: wp.vec3):
    """A point's (x, y)."""
    return wp.vec2(p[0], p[1])


@wp.func
def covered(
    t: TablesRef, o: Objective, c: Candidate, s: State, k: wp.int32, place: wp.vec4, half: wp.float32, depth: wp.float32
):
    """The stretch of a wall (offsets from its middle) that the box of member k covers; empty: first above last."""
    m = item(o.member, k)
    pose = item_strided(s.poses, c.index, m)
    q = item_strided(s.turns, c.index, m)
    size = item(t[0].object_size, c.first_object + m)
    n = wp.vec2(place[2], place[3])
    along = perp(n)
    v = plane_of(pose) - wp.vec2(place[0], place[1])
    side = perp(q)
    reach = 0.5 * (wp.abs(wp.dot(along, q)) * size[0] + wp.abs(wp.dot(along, side)) * size[1])
    deep = 0.5 * (wp.abs(wp.dot(n, q)) * size[0] + wp.abs(wp.dot(n, side)) * size[1])
    if wp.dot(n, v) - deep > depth or wp.dot(n, v) + deep < 0.0:
        return wp.vec2(1.0, 0.0)
    return wp.vec2(wp.max(wp.dot(along, v) - reach, -half), wp.min(wp.dot(along, v) + reach, half))


@wp.func
def exposed_wall(
    t: TablesRef, o: Objective, c: Candidate, s: State, first: wp.int32, last: wp.int32, depth: wp.float32
):
    """Length of the walls that nothing stands or hangs at."""
    total = float(0.0)
    for w in range(first, last):
        if item(o.member, w) < 0:
            number = -1 - item(o.member, w)
            place = item(o.place, number)
            half = item(o.place_half, number)
            at = -half
            while at < half:
                # As far as what covers this point goes, else to where the next cover begins.
                on = float(at)
                next = float(half)
                for k in range(first, last):
                    if item(o.member, k) >= 0:
                        x = covered(t, o, c, s, k, place, half, depth)
                        if x[0] <= x[1]:
                            if x[0] <= at:
                                on = wp.max(on, x[1])
                            else:
                                next = wp.min(next, x[0])
                if on > at:
                    at = on
                else:
                    total += next - at
                    at = next
    return total


@wp.func
def illuminance(o: Objective, c: Candidate, s: State, first: wp.int32, last: wp.int32):
    """Illuminance [lx] of a horizontal plane at the first member's pin, straight from the others.

    The inverse-square law with Lambert's cosine law: a lamp sends its flux out alike in all directions, a window as a
    diffuse surface that faces into the room. Nothing is in the way, and nothing is reflected.
    """
    at = pin_of(o, c, s, first).at
    total = float(0.0)
    for k in range(first + 1, last):
        source = pin_of(o, c, s, k)
        v = source.at - at
        d = wp.max(wp.length(v), NEAREST_SOURCE)
        intensity = item(o.amount, k) / SPHERE
        if item(o.member, k) < 0:
            facing = -(v[0] * source.turn[0] + v[1] * source.turn[1]) / d
            intensity = item(o.amount, k) / wp.static(math.pi) * wp.max(facing, 0.0)
        total += intensity * wp.max(v[2], 0.0) / (d * d * d)
    return total


@wp.func
def user_term(t: TablesRef, o: Objective, c: Candidate, s: State, term: wp.int32, first: wp.int32, last: wp.int32):
    """A user's residual."""
    a = item(o.member, first)
    b = a
    if last > first + 1:
        b = item(o.member, first + 1)
    return features.user_value(
        item(o.code, term),
        item_strided(s.poses, c.index, a),
        item_strided(s.poses, c.index, b),
        item(t[0].object_size, c.first_object + a),
        item(t[0].object_size, c.first_object + b),
        item(o.params, term),
    )


@wp.func(inline=False)
def term_value(t: TablesRef, o: Objective, c: Candidate, s: State, term: wp.int32):
    """The value of a term, times its weight."""
    kind = item(o.kind, term)
    first = item(o.member_start, term)
    last = item(o.member_start, term + 1)
    value = float(0.0)
    if kind == WIRE_LENGTH:
        value = wire_length(o, c, s, first, last)
    else:
        p = item(o.params, term)
        if kind == FLOW:
            v = pin_of(o, c, s, first + 1).at - pin_of(o, c, s, first).at
            value = length_of(wp.vec2(v[0], v[1]), p[0])
        elif kind == COST:
            at = pin_of(o, c, s, first).at
            if p[3] > 0.5:
                value = at[0] * p[0] + at[1] * p[1]
            else:
                value = length_of(wp.vec2(at[0] - p[0], at[1] - p[1]), p[2])
        elif kind == EXPOSED_WALL:
            value = exposed_wall(t, o, c, s, first, last, p[0])
        elif kind == LIGHT:
            value = wp.max(1.0 - illuminance(o, c, s, first, last) / p[0], 0.0)
        elif kind == USER:
            value = user_term(t, o, c, s, term, first, last)
    value = value * item(o.weight, term)
    if wp.isfinite(value):
        return value
    return float(FAR)


@wp.kernel
def measure_objective(
    # Problem:
    b: Problems,
    o: Objective,
    # State in:
    s: State,
    # State out:
    value_out: wp.array2d(dtype=wp.float32),
):
    """The weighted value of every term [candidate, term]."""
    candidate, term = wp.tid()
    value_out[candidate, term] = term_value(b.tables, o, candidate_of(b, candidate), s, term)
