"""The compiled problem and the candidates as the kernels see them: flat tables, each declared once.

A batch may hold candidates of several problems, so every table is the concatenation of the problems' tables, and
``*_start`` arrays give each problem's, object's or relation's range (CSR). Indices of objects and relations stored
inside the tables are local to their problem. Some vectors of three numbers are stored as four, which a thread reads in
one piece. ``sceneweaver.layout.pack`` fills the tables, ``sceneweaver.optimizers.batch`` makes the state.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

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
FREE_TURNS = 8  # yaw, among the values of a set; never together with FREE_YAW

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


class Table(NamedTuple):
    """An array of a struct: its name, what each dimension counts, the type of an element, its unit, and its meaning."""

    name: str
    shape: tuple[str, ...]
    dtype: Any
    unit: str
    meaning: str


if TYPE_CHECKING:

    class Arrays:
        """What a type checker takes a struct of tables for."""

        def __getattr__(self, name: str) -> Any: ...
        def __setattr__(self, name: str, value: Any) -> None: ...


def struct_of(name: str, doc: str, tables: tuple[Table, ...], **more: Any) -> Any:
    """A Warp struct with an array for every table, and other fields with their types."""
    fields = {table.name: wp.array(dtype=table.dtype, ndim=len(table.shape)) for table in tables} | more
    return wp.struct(type(name, (), {"__annotations__": fields, "__doc__": doc, "__module__": __name__}))


PROBLEM, OBJECT, RELATION = ("problem",), ("object",), ("relation",)
SURFACE, PRISM, EDGE, FIXTURE, ROW = ("surface",), ("prism",), ("edge",), ("fixture",), ("row",)
PROBLEM_1, OBJECT_1, RELATION_1 = ("problem + 1",), ("object + 1",), ("relation + 1",)

TABLES = (
    Table("object_start", PROBLEM_1, wp.int32, "", "range of a problem's objects"),
    Table("relation_start", PROBLEM_1, wp.int32, "", "range of a problem's relations"),
    Table("fixture_start", PROBLEM_1, wp.int32, "", "range of a problem's static prisms"),
    Table("plane_start", PROBLEM_1, wp.int32, "", "range of a problem's half planes"),
    Table("pair_start", PROBLEM, wp.int32, "", "where a problem's n x n pair flags begin"),
    Table("room_height", PROBLEM, wp.float32, "m", "height of the ceiling"),
    Table("room_box", PROBLEM, wp.vec4, "m", "xmin, ymin, xmax, ymax of the outline"),
    Table("grid", PROBLEM, wp.vec4, "m", "cells: lowest corner, edge, largest reach of an object"),
    Table("grid_count", PROBLEM, wp.vec2i, "", "cells: columns, rows"),
    Table("movable", PROBLEM, wp.int32, "", "how many roots are free to move"),
    Table("object_size", OBJECT, wp.vec3, "m", "depth along the front, width, height"),
    Table("object_radius", OBJECT, wp.vec2, "m", "reach of the solids, and of solids and hard zones, from the origin"),
    Table("object_z", OBJECT, wp.vec2, "m", "lowest and highest point of the solids above the origin"),
    Table("object_free", OBJECT, wp.int32, "", "bits FREE_PLANE, FREE_YAW, FREE_Z, FREE_TURNS"),
    Table("yaw_start", OBJECT_1, wp.int32, "", "range of the yaws that an object may take; empty: any"),
    Table("yaw", ("yaw",), wp.float32, "rad", "yaws that an object may take, in the problem's frame"),
    Table("object_clear", OBJECT, wp.int32, "", "1: must keep openings clear"),
    Table("object_boxes", OBJECT, wp.int32, "", "1: all its prisms are boxes"),
    Table("object_terms", OBJECT, wp.int32, "", "bits: the kinds of terms that it may have"),
    Table("object_parent", OBJECT, wp.int32, "", "the movable root that places this one by a relation; -1: none"),
    Table("object_root", OBJECT, wp.int32, "", "the object that carries it along; its own index for a root"),
    Table("group_start", OBJECT_1, wp.int32, "", "range of an object's group"),
    Table("group", ("group",), wp.int32, "", "a root, all that it carries, and the groups of what is placed by it"),
    Table("member_start", OBJECT_1, wp.int32, "", "range of an object's members; empty for the carried"),
    Table("member", ("member",), wp.int32, "", "a root and all that it carries, itself first"),
    Table("parts", ("2 object",), wp.vec2i, "", "prisms that an object has from and to: solids, then zones"),
    Table("footprint_start", OBJECT_1, wp.int32, "", "range of an object's footprint"),
    Table("footprint", ("footprint",), wp.int32, "", "prisms that the footprint is made of"),
    Table("incidence_start", OBJECT_1, wp.int32, "", "range of an object's incidences"),
    Table("incidence", ("incidence",), wp.int32, "", "relations that the object takes part in"),
    Table("incidence_role", ("incidence",), wp.int32, "", "0 subject, 1 first target, 2 second target"),
    Table("surface_start", OBJECT_1, wp.int32, "", "range of a root's support surfaces that carry something"),
    Table("pair_flags", ("pair",), wp.uint8, "", "bits PAIR_*"),
    Table("surface_supporter", SURFACE, wp.int32, "", "the object it belongs to; supporters before what they carry"),
    Table("surface_height", SURFACE, wp.float32, "m", "height above the supporter's origin"),
    Table("surface_member_start", ("surface + 1",), wp.int32, "", "range of what stands on it"),
    Table("surface_member", ("surface member",), wp.int32, "", "what stands on it"),
    Table("pool_start", ("surface + 1",), wp.int32, "", "range of its pool"),
    Table(
        "pool",
        ("pool",),
        wp.vec4,
        "m, rad",
        "layouts solved beforehand: poses in the supporter's frame",
    ),
    Table("prism_start", ("prism + 1",), wp.int32, "", "range of a prism's vertices"),
    Table("prism_z", PRISM, wp.vec2, "m", "lowest and highest point"),
    Table("prism_disc", PRISM, wp.vec4, "m", "bounding circle: centre, radius"),
    # the first half edge is negative unless the prism is this box, the second if some of its faces are no way out
    Table("prism_box", PRISM, wp.vec4, "m", "bounding box: centre, half edges, with signs"),
    Table("vertex", EDGE, wp.vec2, "m", "vertices, counter-clockwise"),
    Table("edge", EDGE, wp.vec4, "m", "outward normal n and offset c of the edge that starts here: n . x <= c"),
    Table("edge_real", EDGE, wp.int32, "", "0: an edge inside the outside of the room, no way out"),
    Table("fixture", FIXTURE, wp.int32, "", "prism of a static prism"),
    Table("fixture_kind", FIXTURE, wp.int32, "", "FIXTURE_SOLID or FIXTURE_OPENING"),
    Table("plane", ("plane",), wp.vec4, "m", "half plane (n, c): n . x >= c inside"),
    Table("relation_object", RELATION, wp.vec3i, "", "subject, first and second target; -1: none"),
    Table("relation_weight", RELATION, wp.float32, "", "weight in the energy"),
    Table("relation_fault", RELATION, wp.int32, "", "status if it does not hold: 0 soft, 1 mounting, 2 hard relation"),
    Table("relation_rigid", RELATION, wp.int32, "", "1: between objects carried along together"),
    Table("relation_kind", RELATION, wp.int32, "", "FORMULAS, DISTANCES or RELATIONS"),
    Table("option_start", RELATION_1, wp.int32, "", "range of a relation's options"),
    Table("row_start", ("option + 1",), wp.int32, "", "range of an option's rows"),
    Table("row_feature", ROW, wp.int32, "", "FEATURE_*"),
    Table("row_frame", ROW, wp.vec4, "m", "the feature's normal and point"),
    Table("row_aim", ROW, wp.vec4, "", "interval that the energy pulls into, offset, metres per unit of the feature"),
    Table("row_prism", ROW, wp.int32, "", "static prism that a distance is measured to; -1: none"),
    Table("row_hold", ROW, wp.vec2, "", "interval that counts as fulfilled"),
    # rows of exact values stand behind all others; their aim is the value and the one that all may share
    Table("snap_start", ("option + 1",), wp.int32, "", "range of an option's rows of exact values"),
)
# ``pool_size`` is the number of layouts in every surface's pool.
if TYPE_CHECKING:

    class Tables(Arrays):
        """As below."""
else:
    Tables = struct_of("Tables", "Every table of a batch of problems, see TABLES.", TABLES, pool_size=wp.int32)


TablesRef = wp.array(dtype=Tables)
"""How kernels take the tables: an array of one. The struct is 3 kB and functions take arguments by value."""


@wp.func
def parts_of(t: TablesRef, o: wp.int32, kind: wp.int32):
    """The prisms that object o (global) has of a kind: from and to."""
    return item(t[0].parts, 2 * o + kind)


OF_OBJECT = ("candidate", "object")

STATE = (
    Table("poses", OF_OBJECT, wp.vec4, "m, rad", "x, y, z, yaw"),
    Table("turns", OF_OBJECT, wp.vec2, "", "(cos, sin) of the yaw"),
    Table("options", ("candidate", "relation"), wp.int32, "", "chosen option of each relation, index into row_start"),
    Table("anchors", OF_OBJECT, wp.vec4, "m, rad", "where Weights.pull pulls to"),
    Table("rng", ("candidate",), wp.uint32, "", "seed of the candidate's random streams"),
    Table("stream", ("candidate", "lane"), wp.uint32, "", "the search's streams; the last: the candidate's own"),
    # Those that only a search fills; before, the second dimension is 1.
    Table("released", ("candidate", "1"), wp.int32, "", "1: a root that anchored attempts may move, see `release`"),
    Table("rating", ("candidate", "1"), wp.float32, "m", "what was last found to be at fault with an object"),
    Table("mark", OF_OBJECT, wp.int32, "", "the move that an object takes part in, see `View`"),
    Table("draft", OF_OBJECT, wp.vec4, "m, rad", "surfaces laid out otherwise, see `View`"),
    Table("cell_head", ("candidate", "1"), wp.int32, "", "first object of each cell; -1: none"),
    Table("cell_next", ("candidate", "1"), wp.int32, "", "next object of the same cell"),
    Table("cell_of", ("candidate", "1"), wp.int32, "", "the cell of each object"),
)
if TYPE_CHECKING:

    class State(Arrays):
        """As below."""
else:
    State = struct_of("State", "The candidates' layouts, see STATE.", STATE)


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

    value: wp.float32  # all that an object takes part in; of soft relations as much as ``Weights.soft`` says
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
    soft: wp.float32  # of soft relations, in the value and its gradient alone
    knee: wp.float32  # [m] where the penalty turns from quadratic to linear


@wp.struct
class Problems:
    """What every kernel takes first: the problems of a batch, and whose layout each candidate is."""

    tables: TablesRef
    margins: Margins
    weights: Weights
    problem: wp.array(dtype=wp.int32)  # [candidate]
