"""Windows of plans: each room takes what its floor asks for, on the outer walls that it has."""

import warp as wp

from .array_access import item
from .plan_geometry import facade_overlap, has, next_cell
from .plan_measures import window_need
from .plan_tables import GLAZED, LIT, MAX_WINDOWS, PUBLIC, WET, WINDOWS, PlanProblemRef

wp.set_module_options({"enable_backward": False})

MODULE = wp.constant(50)  # [mm] widths of windows are multiples of it where there is room


@wp.func
def free_facade(
    p: PlanProblemRef, cell: wp.vec4i, level: wp.int32, facade: wp.int32, doors: wp.array2d(dtype=wp.int32), n: wp.int32
):
    """Where a window may be in a cell's part of an outer wall: from and to [mm], clear of the entrance's door."""
    s = wp.vec2i(0, 0)
    if (item(p[0].facade_flags, facade) & WINDOWS) != 0:
        s = facade_overlap(item(p[0].facade, facade), cell)
        s = wp.vec2i(s[0] + p[0].pier, s[1] - p[0].pier)
        if n > 0 and level == 0:
            side = item(p[0].facade, facade)[0]
            axis = side % 2
            if doors[0, 1] < 0 and doors[0, 2] == side and doors[0, 3 + axis] == item(p[0].facade, facade)[1]:
                low = doors[0, 4 - axis] - p[0].pier
                high = doors[0, 4 - axis] + doors[0, 5] + p[0].pier
                if low < s[1] and high > s[0]:
                    if low - s[0] >= s[1] - high:
                        s = wp.vec2i(s[0], low)
                    else:
                        s = wp.vec2i(high, s[1])
    if s[1] - s[0] < p[0].least_window:
        return wp.vec2i(0, 0)
    return s


@wp.func
def add_windows(
    p: PlanProblemRef,
    room: wp.int32,
    facade: wp.int32,
    s: wp.vec2i,
    wanted: wp.int32,
    n: wp.int32,
    windows: wp.array2d(dtype=wp.int32),
):
    """Windows of a width in all, evenly on a part of a wall; how many windows there are then."""
    length = s[1] - s[0]
    width = wp.min(wp.max(wanted, p[0].least_window), length)
    rounded = (width + MODULE - 1) / MODULE * MODULE
    if rounded <= length:
        width = rounded
    parts = (width + p[0].most_window - 1) / p[0].most_window
    each = (width + parts - 1) / parts
    while parts > 1 and parts * each + (parts - 1) * p[0].pier > length:
        parts -= 1
        each = (width + parts - 1) / parts
    gap = (length - parts * each) / (parts + 1)
    if parts > 1:
        gap = wp.max(gap, 0)
    at = s[0] + gap
    side = item(p[0].facade, facade)[0]
    face = item(p[0].facade, facade)[1]
    axis = side % 2
    for _k in range(parts):
        if n < MAX_WINDOWS:
            windows[n, 0] = room
            windows[n, 1] = side
            windows[n, 2] = wp.where(axis == 0, face, at)
            windows[n, 3] = wp.where(axis == 0, at, face)
            windows[n, 4] = each
            n += 1
            at += each + wp.max(gap, p[0].pier)
    return n


@wp.func
def place_windows(
    p: PlanProblemRef,
    frame: wp.int32,
    count: wp.int32,
    cells: wp.array(dtype=wp.vec4i),
    storey: wp.array(dtype=wp.int32),
    area: wp.array(dtype=wp.int32),
    doors: wp.array2d(dtype=wp.int32),
    n_doors: wp.int32,
    windows: wp.array2d(dtype=wp.int32),
):
    """Place windows; how many, and the width [mm] that rooms lack."""
    n = int(0)
    lack = int(0)
    for r in range(p[0].rooms):
        need = int(0)
        if has(p, r, GLAZED):
            need = window_need(p, area[r])
        if has(p, r, LIT):
            need = wp.max(need, p[0].least_window)
        wish = need + need / 4
        if has(p, r, PUBLIC) and need > 0:
            wish = need + need * 6 / 10
        if need == 0 and has(p, r, WET):
            wish = wp.max(p[0].least_window, window_need(p, area[r]))
        if wish > 0:
            total = int(0)
            longest = int(0)
            best_cell = int(-1)
            best_facade = int(-1)
            i = next_cell(p, frame, count, storey, r, -1)
            while i < count:
                for f in range(p[0].facade.shape[0]):
                    s = free_facade(p, cells[i], storey[i], f, doors, n_doors)
                    total += s[1] - s[0]
                    if s[1] - s[0] > longest:
                        longest = s[1] - s[0]
                        best_cell = i
                        best_facade = f
                i = next_cell(p, frame, count, storey, r, i)
            begin = n
            if longest > 0:
                wish = wp.min(wish, total)
                if longest >= wish and not has(p, r, PUBLIC):
                    s = free_facade(p, cells[best_cell], storey[best_cell], best_facade, doors, n_doors)
                    n = add_windows(p, r, best_facade, s, wish, n, windows)
                else:
                    i = next_cell(p, frame, count, storey, r, -1)
                    while i < count:
                        for f in range(p[0].facade.shape[0]):
                            s = free_facade(p, cells[i], storey[i], f, doors, n_doors)
                            if s[1] > s[0]:
                                part = float(wish) * float(s[1] - s[0]) / float(total)
                                n = add_windows(p, r, f, s, int(wp.ceil(part)), n, windows)
                        i = next_cell(p, frame, count, storey, r, i)
            got = int(0)
            for k in range(begin, n):
                got += windows[k, 4]
            lack += wp.max(need - got, 0)
    return n, lack
