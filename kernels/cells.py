"""Cells: who is near whom in a crowd, so that a move costs what is near it and not all that is in the room.

Each candidate has a grid over its room; a cell holds a linked list of the objects whose origin lies in it. An object
looks into the cells within its own reach and the largest reach of any other. Rooms with few objects do without.
"""

import warp as wp

from .array_access import item
from .bodies import object_count
from .plan import SearchRun
from .tables import Problems, State, TablesRef

wp.set_module_options({"enable_backward": False})

CROWD = wp.constant(40)  # objects from which on cells pay
CELLS = wp.constant(256)  # of a room at most


@wp.func
def crowded(n: wp.int32, s: State):
    """True when a candidate of n objects has cells."""
    return n > CROWD and s.cell_head.shape[1] > 1


@wp.func
def cell_at(t: TablesRef, p: wp.int32, x: wp.float32, y: wp.float32):
    """Column and row of the cell at a point; points outside belong to the border."""
    grid = item(t[0].grid, p)
    count = item(t[0].grid_count, p)
    column = wp.clamp(int(wp.floor((x - grid[0]) / grid[2])), 0, count[0] - 1)
    row = wp.clamp(int(wp.floor((y - grid[1]) / grid[2])), 0, count[1] - 1)
    return column, row


@wp.func
def enter_cell(t: TablesRef, p: wp.int32, candidate: wp.int32, obj: wp.int32, s: State):
    """Put an object into the list of the cell where it stands."""
    pose = item(s.poses, candidate, obj)
    column, row = cell_at(t, p, pose[0], pose[1])
    cell = row * item(t[0].grid_count, p)[0] + column
    s.cell_of[candidate, obj] = cell
    s.cell_next[candidate, obj] = item(s.cell_head, candidate, cell)
    s.cell_head[candidate, cell] = obj


@wp.func
def change_cell(t: TablesRef, p: wp.int32, candidate: wp.int32, obj: wp.int32, s: State):
    """Take an object that has moved out of its old cell's list and into that of its new one."""
    cell = item(s.cell_of, candidate, obj)
    at = item(s.cell_head, candidate, cell)
    if at == obj:
        s.cell_head[candidate, cell] = item(s.cell_next, candidate, obj)
    else:
        while at >= 0 and item(s.cell_next, candidate, at) != obj:
            at = item(s.cell_next, candidate, at)
        if at >= 0:
            s.cell_next[candidate, at] = item(s.cell_next, candidate, obj)
    enter_cell(t, p, candidate, obj, s)


@wp.func
def fill_cells(t: TablesRef, p: wp.int32, candidate: wp.int32, s: State):
    """Build a candidate's lists anew."""
    n = object_count(t, p)
    for obj in range(n):
        s.mark[candidate, obj] = 0
    if crowded(n, s):
        count = item(t[0].grid_count, p)
        for cell in range(count[0] * count[1]):
            s.cell_head[candidate, cell] = -1
        for obj in range(n):
            enter_cell(t, p, candidate, obj, s)


@wp.kernel
def enter_cells(
    # Problem:
    b: Problems,
    # State in:
    run: SearchRun,
    # State in and out:
    s: State,
):
    """Build the lists of every active candidate anew."""
    t = b.tables
    candidate = wp.tid()
    if run.active[candidate] == 1:
        fill_cells(t, b.problem[candidate], candidate, s)
