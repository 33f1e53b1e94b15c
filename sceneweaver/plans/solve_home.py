"""From a candidate's cells, doors and windows to a `Home`."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely.geometry import Polygon, box
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from sceneweaver.home import Home, HomeDoor, HomeRoom, HomeWindow, Stair, Storey, WallThickness
from sceneweaver.kernels import plan_tables as tables

from .solve_problem import PANE, SILL, CompiledPlan
from .solve_stairs import SLAB

DOOR_HEIGHT = 2.0
PASSAGE_HEIGHT = 2.1
KINDS = {tables.HINGED: "hinged", tables.SLIDES: "sliding", tables.PASSAGE: "open", tables.DOUBLE: "double"}
UP = ((-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0))
"""Ways out through walls on the sides west, south, east and north."""

Point = tuple[float, float]


def outlines_of(plan: CompiledPlan, cells: np.ndarray, storey: np.ndarray, owner: np.ndarray) -> list[list[Point]]:
    """The clear floor of each room [m], counter-clockwise: its cells, and the ways between them.

    Args:
        plan: the problem.
        cells: [cells, 4] int, x0, y0, x1, y1 [mm].
        storey: [cells] int; -1: not there.
        owner: [cells] int, the room of each cell.
    """
    inner, movable = plan.numbers["inner"], plan.numbers["cells"]
    outlines: list[list[Point]] = []
    sides = plan.arrays["room_side"]
    for room in range(len(plan.programme.rooms)):
        mine = [k for k in range(len(cells)) if storey[k] >= 0 and owner[k] == room]
        shapes = [box(int(cells[k][0]), int(cells[k][1]), int(cells[k][2]), int(cells[k][3])) for k in mine]
        for k in mine:
            if len(plan.programme.rooms) <= k < movable:
                way = _way(cells[k], cells[room], inner)
                if way is not None and max(way[2] - way[0], way[3] - way[1]) >= sides[room]:
                    shapes.append(box(*way))
        whole = unary_union(shapes)
        assert isinstance(whole, Polygon), f"the cells of {plan.programme.rooms[room].id} are apart"
        outlines.append(_corners(whole))
    return outlines


def _way(a: np.ndarray, b: np.ndarray, inner: int) -> tuple[int, int, int, int] | None:
    """The part of the wall between two cells that is not there."""
    for axis in (0, 1):
        low, high = (a, b) if a[axis] < b[axis] else (b, a)
        if high[axis] - low[axis + 2] == inner:
            start, end = max(a[1 - axis], b[1 - axis]), min(a[3 - axis], b[3 - axis])
            if start < end:
                span = (int(low[axis + 2]), int(high[axis])), (int(start), int(end))
                (x0, x1), (y0, y1) = span if axis == 0 else span[::-1]
                return x0, y0, x1, y1
    return None


def _corners(shape: Polygon) -> list[Point]:
    points = np.array(orient(shape).exterior.coords[:-1])
    before, after = np.roll(points, 1, axis=0), np.roll(points, -1, axis=0)
    cross = (points - before)[:, 0] * (after - points)[:, 1] - (points - before)[:, 1] * (after - points)[:, 0]
    return [(round(x) / 1000, round(y) / 1000) for x, y in points[cross != 0]]


def home_of(
    plan: CompiledPlan,
    frame: int,
    cells: np.ndarray,
    storey: np.ndarray,
    owner: np.ndarray,
    doors: np.ndarray,
    windows: np.ndarray,
) -> Home:
    """The home of one candidate; rooms are empty.

    Args:
        plan: the problem.
        frame: number of the candidate's frame.
        cells, storey, owner: as for `outlines_of`.
        doors: [doors, 9] int, `kernels.plan_tables.DOOR_RECORD`.
        windows: [windows, 5] int, `kernels.plan_tables.WINDOW_RECORD`.
    """
    rooms = plan.programme.rooms
    outlines = outlines_of(plan, cells, storey, owner)
    rise = plan.envelope.height + SLAB / 1000
    return Home(
        id=plan.programme.name,
        storeys=tuple(
            Storey(id=f"storey-{k}", elevation=round(k * rise, 3), height=plan.envelope.height)
            for k in range(plan.programme.storeys)
        ),
        walls=WallThickness(inner=plan.envelope.inner_wall, outer=plan.envelope.outer_wall),
        rooms=tuple(
            HomeRoom(id=room.id, type=room.type, storey=f"storey-{room.storey or 0}", outline=tuple(outline))
            for room, outline in zip(rooms, outlines, strict=True)
        ),
        doors=tuple(_door(k, row, plan, outlines) for k, row in enumerate(doors)),
        windows=tuple(_window(k, row, plan, outlines) for k, row in enumerate(windows)),
        stairs=_stairs(plan, frame),
    )


def _door(number: int, row: np.ndarray, plan: CompiledPlan, outlines: Sequence[list[Point]]) -> HomeDoor:
    room, to, side, x, y, width, kind, into, hinge = map(int, row)
    wall, offset = place_on(outlines[room], side, (x / 1000, y / 1000), width / 1000)
    rooms = plan.programme.rooms
    return HomeDoor(
        id="entrance" if to < 0 else f"door-{number}",
        room=rooms[room].id,
        wall=wall,
        offset=offset,
        width=width / 1000,
        height=PASSAGE_HEIGHT if kind == tables.PASSAGE else DOOR_HEIGHT,
        to=None if to < 0 else rooms[to].id,
        kind=KINDS[kind],  # pyright: ignore[reportArgumentType]
        opens_into=None if into < 0 else rooms[into].id,
        hinge="right" if hinge else "left",
    )


def _window(number: int, row: np.ndarray, plan: CompiledPlan, outlines: Sequence[list[Point]]) -> HomeWindow:
    room, side, x, y, width = map(int, row)
    wall, offset = place_on(outlines[room], side, (x / 1000, y / 1000), width / 1000)
    return HomeWindow(
        id=f"window-{number + 1}",
        room=plan.programme.rooms[room].id,
        wall=wall,
        offset=offset,
        width=width / 1000,
        sill=SILL / 1000,
        height=PANE / 1000,
    )


def place_on(outline: list[Point], side: int, corner: Point, width: float) -> tuple[int, float]:
    """Number of a wall, and the offset [m] along it of an opening.

    Args:
        outline: counter-clockwise, right angles.
        side: which way out: 0 west, 1 south, 2 east, 3 north.
        corner: the opening's end with the lower coordinates.
        width: of the opening [m].
    """
    axis, along = side % 2, 1 - side % 2
    for wall, (a, b) in enumerate(zip(outline, outline[1:] + outline[:1], strict=True)):
        way = b[along] - a[along]
        # a counter-clockwise wall in the south runs east, one in the east north, and so on
        if a[axis] != b[axis] or a[axis] != corner[axis] or (way > 0) != (side in (1, 2)):
            continue
        low, high = min(a[along], b[along]), max(a[along], b[along])
        if low - 1e-9 <= corner[along] and corner[along] + width <= high + 1e-9:
            offset = corner[along] - a[along] if way > 0 else a[along] - corner[along] - width
            return wall, round(offset, 3)
    raise AssertionError(f"no wall on side {side} holds an opening at {corner}")


def _stairs(plan: CompiledPlan, frame: int) -> tuple[Stair, ...]:
    if plan.stairwell is None:
        return ()
    chosen, well = plan.frames[frame], plan.stairwell
    x0, y0, x1, y1 = (v / 1000 for v in chosen.fixed[1].rect)
    by_storey = {room.storey: room.id for room in plan.programme.rooms if "stairs" in room.kind.roles}
    return tuple(
        Stair(
            id=f"stairs-{k}-to-{k + 1}",
            lower=by_storey[k],
            upper=by_storey[k + 1],
            outline=((x0, y0), (x1, y0), (x1, y1), (x0, y1)),
            up=(float(chosen.up[0]), float(chosen.up[1])),
            shape="u",
            width=well.flight / 1000,
            risers=well.risers,
            going=well.going / 1000,
        )
        for k in range(plan.programme.storeys - 1)
    )
