"""A floor-plan problem and its candidates as the kernels see them: flat tables in whole millimetres.

A plan is a forest of slicing trees (Otten 1982; Wong and Liu 1986). A *bay* is a rectangle of clear floor on one
storey; its tree is written in prefix order: a number below `CUT_X` is a cell, `CUT_X` splits what follows into left and
right, `CUT_Y` into lower and upper. The trees of all bays of a candidate's *frame* follow each other in its code. A
frame is one way to part the envelope into bays and fixed cells (stairwells). A room has one cell of its own, cell r of
room r, and may have further ones, which a plan may or may not use: so halls and living rooms become L-shaped.
``sceneweaver.plans.solve_problem`` fills the tables.
"""

from typing import TYPE_CHECKING

import warp as wp

from .tables import Table, struct_of

wp.set_module_options({"enable_backward": False})

MAX_CELLS = 32  # of a plan with its fixed ones; also the largest number of rooms, whose sets are bits of an integer
MAX_CODE = 64  # numbers of a code
MAX_DOORS = 40
FRONTS = 80  # both sides of all doors
MAX_WINDOWS = 48
MAX_ROWS = 40  # adjacencies

CUT_X = wp.constant(100)
CUT_Y = wp.constant(101)

HARD_WEIGHT = wp.constant(10.0)  # of a violation of 1, against soft rows

# Bits of ``PlanProblem.room_flags``.
THROUGH = wp.constant(1)  # anybody may walk through it
SUITE = wp.constant(2)  # its own annexes may lie behind it
ANNEX = wp.constant(4)  # may lie behind a room that asks for a door to it
GLAZED = wp.constant(8)  # its windows need a share of its floor
LIT = wp.constant(16)  # has a window at least
WET = wp.constant(32)
CIRCULATION = wp.constant(64)
LARGE = wp.constant(128)  # one of these has the area of ``large_room``
STAIRS = wp.constant(256)
SUNNY = wp.constant(512)  # its windows had better see the sun
TURNING = wp.constant(1024)  # a square of ``turning`` is free of leaves
PUBLIC = wp.constant(2048)
QUIET = wp.constant(4096)  # had better be far from the entrance, and off the living room
SLIDING = wp.constant(8192)  # its door may slide along the wall
LIVING = wp.constant(16384)  # larger than bedrooms, and entered before them
DAY = wp.constant(32768)  # toilets do not open to it
TOILET = wp.constant(65536)
MASTER = wp.constant(262144)  # no smaller than other bedrooms
TWO_SIDED = wp.constant(131072)  # had better have windows on two sides

# Kinds of ``PlanProblem.adjacency``.
DOOR = wp.constant(0)
OPEN = wp.constant(1)
NEAR = wp.constant(2)
APART = wp.constant(3)

# Sides of a rectangle, and of the outer walls: which way is out.
WEST = wp.constant(0)
SOUTH = wp.constant(1)
EAST = wp.constant(2)
NORTH = wp.constant(3)

# Bits of ``PlanProblem.facade_flags``.
WINDOWS = wp.constant(1)
ENTRANCE = wp.constant(2)

# Kinds of doors, `DOOR_RECORD`.
HINGED = wp.constant(0)
SLIDES = wp.constant(1)
PASSAGE = wp.constant(2)
DOUBLE = wp.constant(3)

RULES = (
    "area",
    "side",
    "aspect",
    "glazing",
    "adjacency",
    "reached",
    "entrance",
    "wet-groups",
    "corridors",
    "large-room",
    "shape",
    "doors",
    "windows",
    "turning",
)
"""Rules that are counted, in the order of ``PlanState.violation``."""
AREA, SIDE, ASPECT, GLAZING, ADJACENCY, REACHED, ENTRY = range(7)
GROUPS, SHARE, LARGEST, SHAPE, DOORS, PANES, TURN = range(7, 14)
RULE_COUNT = 14

DOOR_RECORD = ("room", "to", "side", "x", "y", "width", "kind", "into", "hinge")
"""Integers of a door: rooms (to: -1 outdoors), the side of ``room`` that it is in, the lowest corner of its line on
that room's face [mm], its width [mm], its kind, the room that leaves swing into (-1: none), hinge (0 left, 1 right)."""
WINDOW_RECORD = ("room", "side", "x", "y", "width")

ROOM, CELL, ADJACENT, BAY, FIXED = ("room",), ("cell",), ("adjacency",), ("bay",), ("fixed",)
FRAME_1, FRAME, FACADE, WISH = ("frame + 1",), ("frame",), ("facade",), ("wish",)

PROBLEM = (
    Table("room_area", ROOM, wp.vec3i, "mm2", "least, wanted and most floor"),
    Table("room_side", ROOM, wp.int32, "mm", "least clear width"),
    Table("room_aspect", ROOM, wp.int32, "1/1000", "largest ratio of sides by hard rules"),
    Table("room_form", ROOM, wp.vec4, "1", "by soft rows: largest ratio of sides, its weight; least fill, its weight"),
    Table("room_flags", ROOM, wp.int32, "", "bits THROUGH and following"),
    Table("room_storeys", ROOM, wp.int32, "", "bits: storeys that it may lie on"),
    Table("room_rank", ROOM, wp.int32, "", "which rooms lead on first: lower ones do"),
    Table("room_door", ROOM, wp.int32, "mm", "width of its door"),
    Table("cell_room", CELL, wp.int32, "", "the room of each cell"),
    Table("cell_side", CELL, wp.int32, "mm", "least clear width of a cell"),
    Table("adjacency", ADJACENT, wp.vec4i, "mm", "two rooms, a kind, and the width of its door or passage"),
    Table("adjacency_weight", ADJACENT, wp.float32, "", "weight of soft ones; -1: hard"),
    Table("wish_room", WISH, wp.int32, "", "soft rows: a room"),
    Table("wish_mask", WISH, wp.int32, "", "that lies near one of these rooms"),
    Table("wish_reach", WISH, wp.vec2, "mm, 1", "as far as this; weight for each metre more"),
    Table("bay_start", FRAME_1, wp.int32, "", "range of a frame's bays"),
    Table("bay", BAY, wp.vec4i, "mm", "clear floor: x0, y0, x1, y1"),
    Table("bay_storey", BAY, wp.int32, "", "its storey"),
    Table("fixed_start", FRAME_1, wp.int32, "", "range of a frame's fixed cells"),
    Table("fixed", FIXED, wp.vec4i, "mm", "clear floor of a fixed cell"),
    Table("fixed_room", FIXED, wp.vec3i, "", "its room, storey, and whether doors may be in its walls"),
    Table("frame_family", FRAME, wp.vec2i, "", "frames with bays of the same storeys: from, to"),
    Table(
        "frame_share",
        FRAME,
        wp.float32,
        "1",
        "where each frame's part of the unit interval ends: how often it is drawn",
    ),
    Table("facade", FACADE, wp.vec4i, "mm", "outer walls: side, place of the inner face, from, to along it"),
    Table("facade_flags", FACADE, wp.int32, "", "bits WINDOWS, ENTRANCE"),
)

if TYPE_CHECKING:
    from .tables import Arrays

    class PlanProblem(Arrays):
        """As below."""

    class PlanState(Arrays):
        """As below."""
else:
    PlanProblem = struct_of(
        "PlanProblem",
        "A programme, an envelope and a profile of rules.",
        PROBLEM,
        rooms=wp.int32,
        cells=wp.int32,  # that trees may hold
        frames=wp.int32,
        storeys=wp.int32,
        entrance=wp.int32,  # room
        inner=wp.int32,  # [mm] thickness of inner walls
        jamb=wp.int32,  # [mm] wall beside a door
        pier=wp.int32,  # [mm] wall beside a window
        entrance_door=wp.int32,  # [mm]
        glazing=wp.int32,  # [1/1000] share of the floor
        pane=wp.int32,  # [mm] height of windows
        least_window=wp.int32,  # [mm]
        most_window=wp.int32,  # [mm]
        through=wp.int32,  # rooms (bits) that have the flag THROUGH, and so on
        suites=wp.int32,
        annexes=wp.int32,
        stairs=wp.int32,
        wet_rooms=wp.int32,
        wet_groups=wp.int32,  # at most, by hard rules
        wet_wall=wp.int32,  # [mm] of wall that rooms with water share
        corridors=wp.vec2i,  # [1/1000] share of the floor: by hard rules, by soft ones
        large_room=wp.int32,  # [mm2]; 0: no such rule
        turning=wp.int32,  # [mm]
        weights=wp.types.vector(length=12, dtype=wp.float32),  # of soft rows, `SOFT`
    )

PlanProblemRef = wp.array(dtype=PlanProblem)
"""How kernels take a problem: an array of one. The struct is 3 kB and functions take arguments by value."""

SOFT = (
    "area",
    "corridors",
    "wet",
    "dead_ends",
    "sun",
    "bedroom_doors",
    "toilet_doors",
    "halls",
    "bedrooms",
    "master",
    "two_sides",
    "living_first",
)
"""Soft rows by weight."""
SOFT_AREA, SOFT_CORRIDORS, SOFT_WET, SOFT_ENDS, SOFT_SUN, SOFT_BEDROOM_DOORS = range(6)
SOFT_TOILET_DOORS, SOFT_HALLS, SOFT_BEDROOMS, SOFT_MASTER, SOFT_SIDES, SOFT_FIRST = range(6, 12)

STATE = (
    Table("rng", ("candidate",), wp.uint32, "", "random stream"),
    Table("frame", ("candidate",), wp.int32, "", "frame"),
    Table("code", ("candidate", "code"), wp.int32, "", "trees of the bays in prefix order"),
    Table("length", ("candidate",), wp.int32, "", "numbers of the code"),
    Table("weight", ("candidate", "cell"), wp.float32, "m2", "what floor is shared out by"),
    Table("cut", ("candidate", "code"), wp.int32, "mm", "where each cut's wall begins, on the axis that it parts"),
    Table("blame", ("candidate",), wp.int32, "", "bits: rooms that violate something"),
    Table("energy", ("candidate",), wp.float32, "1", "of the plan as it stands: hard violations, then soft"),
    Table("cells", ("candidate", "cell"), wp.vec4i, "mm", "clear floor of each cell: x0, y0, x1, y1; empty: not there"),
    Table("storey", ("candidate", "cell"), wp.int32, "", "storey of each cell; -1: it is not there"),
    Table("owner", ("candidate", "cell"), wp.int32, "", "room of each cell; -1: none"),
    Table("doors", ("candidate", "door", "9"), wp.int32, "mm", "`DOOR_RECORD`"),
    Table("windows", ("candidate", "window", "5"), wp.int32, "mm", "`WINDOW_RECORD`"),
    Table("count", ("candidate",), wp.vec2i, "", "doors and windows"),
    Table("violation", ("candidate", "rule"), wp.float32, "m, m2 or 1", "by how much each of `RULES` is broken"),
    Table("status", ("candidate",), wp.int32, "", "1: valid; 0: not yet"),
    Table("rounds", ("candidate",), wp.int32, "", "attempts so far"),
)

if not TYPE_CHECKING:
    PlanState = struct_of("PlanState", "Plans of all candidates.", STATE)
