"""The compiled problem as the kernels see it: one struct of flat tables.

A batch may hold candidates of several problems, so every table is the concatenation of the problems' tables and
``*_start`` arrays give each problem's, object's or relation's range (CSR). Indices of objects and relations stored
inside the tables are local to their problem. Lengths are metres, angles radians. Some vectors of three numbers are
stored as four, which a thread reads in one piece.
"""

import warp as wp

from .array_access import item

wp.set_module_options({"enable_backward": False})

# Bits of ``Tables.pair_flags[i, j]``.
PAIR_COLLIDE = 1  # solids of i and j must not overlap; a term of the energy
PAIR_ZONE_OF_FIRST = 2  # hard zones of i must be free of j's solids
PAIR_ZONE_OF_SECOND = 4  # hard zones of j must be free of i's solids
PAIR_RIGID = 8  # carried along together: the distance never changes, only the verdict looks at it
PAIR_POLYGON = 16  # one of them has prisms that are no boxes

# Bits of ``Tables.object_free``.
FREE_PLANE = 1  # x, y
FREE_YAW = 2
FREE_Z = 4

# Kinds of static prisms, ``Tables.fixture_kind``.
FIXTURE_SOLID = 0  # outside of the room, or a part of the furniture that carries a surface
FIXTURE_OPENING = 1  # clearance of a door or a window

# Kinds of an object's parts, see ``Tables.parts``.
SOLIDS = wp.constant(0)
ZONES = wp.constant(1)

# Features of a relation row, ``Tables.row_feature``; `features.py` has their arithmetic.
FEATURE_LINE = 0
FEATURE_YAW = 1
FEATURE_EXTENT = 2
FEATURE_WINDOW = 3
FEATURE_HEIGHT = 4
FEATURE_CONSTANT = 5
FEATURES_PLAIN = 6  # those before are short formulas
FEATURE_BEARING = 6
FEATURE_DISTANCE = 7
FEATURE_BETWEEN = 8
FEATURE_ASIDE = 9
FEATURE_SPREAD = 10
FEATURE_USER = 16  # and above: residuals registered by the user

# Kinds of an energy's terms, bits of ``Tables.object_terms``; `evaluator.TERMS` says what adds them up.
BOUNDS = wp.constant(1)  # walls, floor and ceiling
FORMULAS = wp.constant(2)  # relations of plain features
DISTANCES = wp.constant(4)  # relations with distances of boxes besides
RELATIONS = wp.constant(8)  # all other relations
BOXES = wp.constant(16)  # where boxes meet
POLYGONS = wp.constant(32)  # where other things meet
PULL = wp.constant(64)  # of the anchor


@wp.struct
class Tables:
    """Every table of a batch of problems. Built by ``sceneweaver.layout.pack``."""

    # problem [P] or [P + 1]
    object_start: wp.array(dtype=wp.int32)
    relation_start: wp.array(dtype=wp.int32)
    fixture_start: wp.array(dtype=wp.int32)
    plane_start: wp.array(dtype=wp.int32)
    pair_start: wp.array(dtype=wp.int32)
    room_height: wp.array(dtype=wp.float32)
    room_box: wp.array(dtype=wp.vec4)  # xmin, ymin, xmax, ymax of the outline
    grid: wp.array(dtype=wp.vec4)  # cells: lowest corner, edge, largest reach of an object
    grid_count: wp.array(dtype=wp.vec2i)  # columns, rows
    movable: wp.array(dtype=wp.int32)  # roots that are free to move
    # object [O] or [O + 1]
    object_size: wp.array(dtype=wp.vec3)
    object_radius: wp.array(dtype=wp.vec2)  # reach of the solids, and of solids and hard zones, from the origin
    object_z: wp.array(dtype=wp.vec2)  # lowest and highest point of the solids above the origin
    object_free: wp.array(dtype=wp.int32)
    object_clear: wp.array(dtype=wp.int32)  # 1: must keep openings clear (wall-mounted objects need not)
    object_boxes: wp.array(dtype=wp.int32)  # 1: all its prisms are boxes
    object_terms: wp.array(dtype=wp.int32)  # the kinds of terms that it may have
    group_start: wp.array(dtype=wp.int32)  # a root, all that it carries, and the groups of what is placed by it
    group: wp.array(dtype=wp.int32)
    object_parent: wp.array(dtype=wp.int32)  # the movable root that places this one by a relation; -1: none
    object_root: wp.array(dtype=wp.int32)  # the object that carries it along; its own index for a root
    member_start: wp.array(dtype=wp.int32)  # a root and all that it carries, itself first; empty for the carried
    member: wp.array(dtype=wp.int32)
    parts: wp.array(dtype=wp.vec2i)  # [2 O] prisms that each object has from and to: solids, then zones
    footprint_start: wp.array(dtype=wp.int32)
    incidence_start: wp.array(dtype=wp.int32)  # relations that the object takes part in
    incidence: wp.array(dtype=wp.int32)
    incidence_role: wp.array(dtype=wp.int32)  # 0 subject, 1 first target, 2 second target
    surface_start: wp.array(dtype=wp.int32)  # a root's support surfaces, supporters before what they carry
    pair_flags: wp.array(dtype=wp.uint8)  # n x n per problem, from pair_start
    # deck: a support surface with what stands on it, and a pool of layouts solved for it beforehand
    surface_supporter: wp.array(dtype=wp.int32)
    surface_height: wp.array(dtype=wp.float32)
    surface_member_start: wp.array(dtype=wp.int32)
    surface_member: wp.array(dtype=wp.int32)
    pool_start: wp.array(dtype=wp.int32)
    pool: wp.array(dtype=wp.vec4)  # entry by entry, poses in the supporter's frame above the surface
    pool_size: wp.int32  # entries of every deck
    # prism [M] or [M + 1]
    footprint: wp.array(dtype=wp.int32)
    prism_start: wp.array(dtype=wp.int32)  # range of vertices
    prism_z: wp.array(dtype=wp.vec2)
    prism_disc: wp.array(dtype=wp.vec4)  # bounding circle: centre, radius
    prism_box: wp.array(dtype=wp.vec4)  # centre and half edges of the bounding box, see below
    # the first half edge is negative unless the prism is this box, the second if some of its faces are no way out
    vertex: wp.array(dtype=wp.vec2)
    edge: wp.array(dtype=wp.vec4)  # outward normal n and offset c of the edge that starts here: n . x <= c
    edge_real: wp.array(dtype=wp.int32)  # 0: an edge inside the outside of the room, no way out
    # static prism, half plane (n, c): n . x >= c inside
    fixture: wp.array(dtype=wp.int32)
    fixture_kind: wp.array(dtype=wp.int32)
    plane: wp.array(dtype=wp.vec4)
    # relation [R] or [R + 1], option, row
    relation_object: wp.array(dtype=wp.vec3i)  # subject, first and second target; -1: none
    relation_weight: wp.array(dtype=wp.float32)
    relation_fault: wp.array(dtype=wp.int32)  # status when it does not hold: 0 soft, 1 mounting, 2 hard relation
    relation_rigid: wp.array(dtype=wp.int32)  # 1: between objects carried along together
    relation_kind: wp.array(dtype=wp.int32)  # FORMULAS, DISTANCES or RELATIONS
    option_start: wp.array(dtype=wp.int32)
    row_start: wp.array(dtype=wp.int32)
    row_feature: wp.array(dtype=wp.int32)
    row_frame: wp.array(dtype=wp.vec4)  # the feature's normal and point
    row_aim: wp.array(dtype=wp.vec4)  # interval that the energy pulls into, offset, metres per unit of the feature
    row_prism: wp.array(dtype=wp.int32)
    row_hold: wp.array(dtype=wp.vec2)  # interval that counts as fulfilled
    # rows of exact values of each option, from and to; their aim is the value and the one that all may share
    snap_start: wp.array(dtype=wp.int32)


TablesRef = wp.array(dtype=Tables)
"""How kernels take the tables: an array of one. The struct is 3 kB and functions take arguments by value."""


@wp.func
def parts_of(t: TablesRef, o: wp.int32, kind: wp.int32):
    """The prisms that object o (global) has of a kind: from and to."""
    return item(t[0].parts, 2 * o + kind)


@wp.struct
class State:
    """The candidates' layouts, [candidate, object] or [candidate, relation]."""

    poses: wp.array2d(dtype=wp.vec4)  # x, y, z, yaw
    turns: wp.array2d(dtype=wp.vec2)  # cos, sin of yaw
    options: wp.array2d(dtype=wp.int32)  # chosen option of each relation, an index into row_start
    anchors: wp.array2d(dtype=wp.vec4)  # where Weights.pull pulls to
    rng: wp.array(dtype=wp.uint32)  # seed of each candidate's random streams
    stream: wp.array2d(dtype=wp.uint32)  # [candidate, lane]: the search's streams; the last: the candidate's own
    released: wp.array2d(dtype=wp.int32)  # 1: a root that anchored attempts may move, see `release`
    mark: wp.array2d(dtype=wp.int32)  # the move that an object takes part in, see `View`
    draft: wp.array2d(dtype=wp.vec4)  # surfaces laid out otherwise, see `View`
    cell_head: wp.array2d(dtype=wp.int32)  # [candidate, cell]: first object of the cell; -1: none
    cell_next: wp.array2d(dtype=wp.int32)  # next object of the same cell
    cell_of: wp.array2d(dtype=wp.int32)


@wp.struct
class View:
    """A look at a candidate as if some of its objects had moved already, and as its discrete choices stand.

    Objects whose ``mark`` is the stamp turn and move with a body from one pose to another; where it is minus the
    stamp they also rise with it, and with ``draft`` = 1 they start from ``State.draft``. Stamp 0: nothing moves.
    """

    stamp: wp.int32
    draft: wp.int32
    before: wp.vec4
    after: wp.vec4
    spin: wp.vec2  # (cos, sin) of the turn
    crowd: wp.int32  # 1: what is near is found through cells where there are any; 0: there are none
    best: wp.int32  # 1: relations choose their best option; 0: they keep to ``State.options``


@wp.struct
class TermSlice:
    """Which terms of an energy a thread adds up: every ``step``-th from ``first``; no more once they exceed the limit.

    What threads with all the slices return adds up.
    """

    first: wp.int32
    step: wp.int32
    limit: wp.float32


@wp.struct
class Energy:
    """A sum of terms [m], and its gradient."""

    value: wp.float32  # all that an object takes part in
    share: wp.float32  # its share of the candidate's energy: half of each pair, the whole of a relation for its subject
    soft: wp.float32  # what of the share soft relations and the pull make up
    gradient: wp.vec4  # of the value for the object's pose (x, y, z, yaw)


@wp.struct
class Margins:
    """Clearances [m] of the energy, and those that the verdict insists on."""

    collision_aim: wp.float32
    collision_hold: wp.float32
    bounds_aim: wp.float32
    bounds_hold: wp.float32
    zone_aim: wp.float32
    zone_hold: wp.float32
    least_overlap_z: wp.float32  # z overlap below which two prisms do not meet


@wp.struct
class Weights:
    """Weights of the energy's terms."""

    collision: wp.float32
    bounds: wp.float32
    zone: wp.float32
    opening: wp.float32
    relation: wp.float32
    pull: wp.float32
    knee: wp.float32  # [m] where the penalty turns from quadratic to linear
