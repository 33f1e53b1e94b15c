"""Kitchen cabinets, counters, islands, sinks and carts."""

from __future__ import annotations

from itertools import pairwise

from ...drawing import Box, Drawing, draws
from ...drawing.components import Layout, basin, carcass, castors, compartments, door, drawer, fronts, tap, unit
from .kitchen_common import PLINTH, SETBACK, WORKTOPS, finishes_of, plinth, worktop, worktop_of

BLIND = 0.03
"""Width [m] by which the panel of a corner cabinet is wider than the cabinet on the other wall is deep."""


@draws("kitchen_cabinet", "kitchen_counter")
def base_units(d: Drawing) -> None:
    """Base units on a plinth under one worktop."""
    body, fittings = finishes_of(d)
    top, thick = worktop_of(d)
    case = d.bounds.inset(front=SETBACK, bottom=PLINTH, top=thick)
    with d.part("body"):
        d.box(d.bounds.top(thick), top)
        plinth(d, d.bounds.inset(front=SETBACK).bottom(PLINTH))
        for k, cell in enumerate(case.columns(max(1, round(case.width / 0.62)) if case.width > 1.0 else 1)):
            closed = "doors" if cell.width > 0.5 else "door"
            unit(d, f"unit-{k}", cell, d.pick(f"layout {k}", [closed, "drawers", "mixed"]), body, *fittings)
    d.surface("top", d.bounds, inset=0.01)


@draws("corner_cabinet")
def corner_cabinet(d: Drawing) -> None:
    """Two wings around an inner corner with a door in one; the corner of the room is at -x, +y."""
    body, (leaf, pull, style, panel) = finishes_of(d)
    top, thick = worktop_of(d)
    deep, over = 0.572, 0.048  # like base units of 0.62 m, whose fronts and worktop it goes on with
    bounds, board = d.bounds, 0.018
    wing = bounds.back(deep)
    arm = bounds.inset(back=deep).left(deep)
    with d.part("wing"):
        d.box(wing.inset(front=-over).top(thick), top, bevel=0.0)
        plinth(d, wing.bottom(PLINTH))
        case = wing.inset(bottom=PLINTH, top=thick)
        room = carcass(d, case, body)
        rooms = room.inset(front=0.03).rows(2, gap=board)
        d.box(rooms[1].bottom(-board), body, bevel=0.0)
        compartments(d, rooms)
        # Hung at the outer end, and short of the other wing's front by more than its thickness: so it clears that. A
        # filler beside it keeps its handle clear of that front.
        face = case.inset(left=deep + 0.024).front(-0.02)
        d.box(face.left(0.018), leaf, bevel=0.001)
        door(d, "front-door", case.inset(left=deep + 0.044).front(-0.02), leaf, pull, "right", style, panel, 0.8)
    with d.part("arm"):
        d.box(arm.inset(back=over, right=-over).top(thick), top, bevel=0.0)
        d.box(arm.bottom(PLINTH).inset(right=0.06, left=0.02, front=0.002, back=-0.06), "black plastic", bevel=0.0)
        case = arm.inset(bottom=PLINTH, top=thick)
        for side in (case.bottom(board), case.top(board), case.left(0.006).inset(z=board)):
            d.box(side, body, bevel=0.0)
        d.box(case.front(board).inset(z=board), body, bevel=0.001)
        d.box(case.inset(back=0.024, front=0.002, z=0.002).right(-0.02), leaf)
    (x0, x1), (y0, y1) = bounds.inset(x=0.01, y=0.01).x, bounds.inset(x=0.01, y=0.01).y
    inner = wing.x[1] + over - 0.01, arm.y[0] - over + 0.01
    ring = [(x0, y0), (inner[0], y0), inner, (x1, inner[1]), (x1, y1), (x0, y1)]
    d.surface("top", bounds, polygon=ring)


@draws("wall_cabinet", "corner_wall_cabinet")
def wall_cabinet(d: Drawing) -> None:
    """A hung cupboard with one or two doors, framed, flat or glazed, and boards behind them.

    One for a corner has a plain panel at its right, before which the cabinet on the other wall ends.
    """
    body, fittings = finishes_of(d)
    if d.chance("glass", 0.3, matched=True):
        fittings = fittings._replace(panel="glass")
    head = 0.03 if d.style in ("classic", "rustic") else 0.0
    case = d.bounds.inset(front=0.025, top=head)
    with d.part("body"):
        if d.category.name == "corner_wall_cabinet":
            blind = case.right(d.bounds.depth + BLIND)
            carcass(d, blind.inset(front=0.019), body)
            d.box(blind.front(0.018).inset(y=0.0015, z=0.0015), fittings.leaf)
            case = case.inset(right=d.bounds.depth + BLIND)
        for k, cell in enumerate(case.columns(max(1, round(case.width / 0.75)))):
            layout = "doors" if cell.width > 0.55 else "door"
            unit(d, f"unit-{k}", cell, layout, body, *fittings, boards=1 if cell.height < 0.72 else 2, grip=0.2)
        if head:
            d.box(d.bounds.inset(front=0.015).top(head), fittings.leaf, bevel=0.01)
    d.fit()


@draws("tall_cabinet")
def tall_cabinet(d: Drawing) -> None:
    """A tall cupboard with a door or a pair below and above."""
    body, fittings = finishes_of(d)
    split = d.uniform("split", 1.15, 1.45)
    case = d.bounds.inset(front=0.025, bottom=PLINTH)
    layout = "doors" if case.width > 0.62 else "door"
    with d.part("body"):
        plinth(d, d.bounds.inset(front=0.025).bottom(PLINTH))
        room = carcass(d, case.inset(front=0.019), body)
        levels = (0.45, 0.8, split, split + 0.35)
        ends = [room.z[0] - 0.009, *levels, room.z[1] + 0.009]
        spans = [room.inset(front=0.04).to(z=(a + 0.009, b - 0.009)) for a, b in pairwise(ends)]
        compartments(d, spans)
        for z in levels:
            d.box(room.inset(front=0.0 if z == split else 0.04).to(z=(z - 0.009, z + 0.009)), body, bevel=0.0)
        for name, z in (("low", (PLINTH, split)), ("high", (split, case.z[1]))):
            fronts(d, name, case.to(z=z), layout, *fittings, grip=0.8 if name == "low" else 0.2)
    d.fit()


@draws("sink_cabinet")
def sink_cabinet(d: Drawing) -> None:
    """A base unit with one or two basins let into its worktop, and a mixer behind them."""
    body, fittings = finishes_of(d)
    top, thick = worktop_of(d)
    ceramic = d.material("sink", "brushed steel", "steel", "white ceramic", "granite")
    metal = d.material("tap", "chrome", "black steel", "brass", "brushed steel")
    least = min(0.87, max(0.7, d.size.height - 0.25))  # lower only where a low one is asked for
    bounds = d.bounds.to(z=(0.0, min(0.92, max(least, d.size.height - 0.34))))
    wide, half = bounds.width, d.uniform("basin", 0.24, 0.29)
    double = wide > 1.2 and d.chance("double", 0.5)
    middle = d.pick("side", [-1, 1]) * (wide / 2 - half - 0.1) if wide > 1.05 else 0.0
    hole = bounds.top(thick).inset(back=0.13, front=0.089)
    hole = hole.to(y=(middle - half, middle + half)).inset(y=-0.04 if double else 0.0)
    with d.part("body"):
        plinth(d, bounds.inset(front=SETBACK).bottom(PLINTH))
        case = bounds.inset(front=SETBACK + 0.019, bottom=PLINTH, top=thick)
        room = case.inset(y=0.018, bottom=0.018)
        below = room.inset(back=0.006, front=0.02).to(z=(room.z[0], room.z[0] + 0.4))  # under the basin
        if wide < 1.05:
            compartments(d, [below])
        for side in (case.left(0.018), case.right(0.018), case.inset(y=0.018).bottom(0.018), room.back(0.006)):
            d.box(side, body, bevel=0.001)
        cells = [case.inset(front=-0.019)]
        if wide >= 1.05:  # the border is beside the basin
            border = min(0.0, hole.y[0] - 0.03) if middle > 0 else max(0.0, hole.y[1] + 0.03)
            d.box(room.to(y=(border - 0.009, border + 0.009)), body, bevel=0.0)
            cells = cells[0].columns([border - case.y[0], case.y[1] - border])
        other: Layout = d.pick("beside", ["drawers", "mixed"])
        for k, cell in enumerate(cells):
            under = len(cells) == 1 or cell.y[0] < middle < cell.y[1]
            fronts(d, f"unit-{k}", cell, "doors" if under else other, *fittings)
        worktop(d, bounds.top(thick), top, hole)
        depth = d.pick("deep", [0.17, 0.2])
        for bowl in hole.columns(2, gap=0.016) if double else [hole]:
            basin(d, bowl.inset(x=0.002, y=0.002).top(depth), ceramic, 0.007 if double else 0.015)
        if double:
            d.box(hole.inset(x=0.002).place(width=0.024).top(0.03).inset(top=-0.0015), ceramic, bevel=0.0)
    with d.part("tap"), d.at(bounds.x[0] + 0.065, middle, bounds.z[1]):
        tap(d, metal, 0.2, d.size.height - bounds.height, square=d.chance("square tap", 0.35))
    free = bounds.inset(back=0.01, front=0.014, y=0.01)
    sides = [("top-right", (free.y[0], hole.y[0] - 0.025)), ("top-left", (hole.y[1] + 0.025, free.y[1]))]
    wide_sides = [(name, free.to(y=y)) for name, y in sides if y[1] - y[0] > 0.11]
    behind = free.to(x=(free.x[0], hole.x[0] - 0.02))  # a narrow one has its soap beside the tap
    beside = [
        ("top-right", behind.to(y=(free.y[0], middle - 0.05))),
        ("top-left", behind.to(y=(middle + 0.05, free.y[1]))),
    ]
    for name, place in wide_sides or beside:
        d.surface(name, place)
    d.fit()


@draws("kitchen_island")
def kitchen_island(d: Drawing) -> None:
    """A block of units with a broad top that overhangs at the back for stools."""
    body, fittings = finishes_of(d)
    top, thick = d.material("top", *WORKTOPS), d.pick("top thickness", [0.03, 0.04, 0.06])
    bounds = d.bounds
    block = bounds.inset(front=SETBACK, y=0.03).front(min(0.62, bounds.depth - 0.27))
    case = block.inset(bottom=PLINTH, top=thick)
    cells = case.columns(max(2, round(case.width / 0.65)))
    with d.part("body"):
        plinth(d, block.bottom(PLINTH))
        for k, cell in enumerate(cells):
            unit(d, f"unit-{k}", cell, d.pick(f"layout {k}", ["doors", "drawers", "mixed"]), body, *fittings)
        # A dressed back: a panel with battens.
        panel = d.box(case.inset(bottom=-0.04).back(-0.016), fittings.leaf, bevel=0.001)
        for k in range(len(cells) + 1):
            at = min(max(case.y[0] + k * cells[0].width, case.y[0] + 0.03), case.y[1] - 0.03)
            d.box(panel.to(y=(at - 0.03, at + 0.03)).back(-0.008), fittings.leaf, bevel=0.001)
    with d.part("top"):
        d.box(bounds.top(thick), top, bevel=0.004)
    d.clear(Box((bounds.x[0], block.x[0] - 0.03), case.y, (0.0, case.z[1] - 0.005)))
    d.surface("top", bounds, inset=0.015)


@draws("kitchen_cart")
def kitchen_cart(d: Drawing) -> None:
    """A butcher's block on four posts and castors with a drawer, two shelves and a towel bar."""
    wood = d.material("top", "beech", "oak", "bamboo", "birch", "walnut")
    frame = d.material("frame", "white paint", "oak", "black steel", "birch", "sage paint")
    metal = d.material("metal", "steel", "black steel")
    thick, post, box = 0.036, 0.04, d.bounds.inset(front=0.025, left=0.05)
    rack = box.inset(back=0.02, front=0.02, y=0.02, top=thick)
    with d.corners(rack):
        d.box(Box((0.0, post), (0.0, post), (0.075, rack.z[1])), frame)
    apron = rack.top(0.15)
    with d.part("top"):
        d.box(box.top(thick), wood, bevel=0.004)
        d.box(apron.inset(y=post, back=0.01).back(0.018), frame, bevel=0.0)
        for side in (apron.left(0.028), apron.right(0.028)):
            d.box(side.place(width=0.018).inset(x=post), frame, bevel=0.0)
        drawer(d, "drawer", apron.inset(y=post, back=0.03), frame, metal, "knob")
        bar = (d.bounds.y[1] - 0.01, apron.z[0] + 0.07)
        ends = apron.x[0] + 0.03, apron.x[1] - 0.03
        d.bar((ends[0], *bar), (ends[1], *bar), 0.009, metal, 8)
        for x in (ends[0] + 0.02, ends[1] - 0.02):
            d.bar((x, apron.y[1] - 0.005, bar[1]), (x, *bar), 0.006, metal, 8)
    room = Box(rack.x, rack.y, (0.12, apron.z[0]))
    for k, own in enumerate(room.rows(2)):
        with d.part(f"shelf {k}"):
            shelf = d.box(own.inset(x=0.005, y=0.004).bottom(0.02), wood, bevel=0.002)
            if k == 0:
                castors(d, Box(rack.x, rack.y, (0.0, 0.0755)).inset(x=-0.01, y=-0.01))
        d.surface(f"shelf-{k}", shelf, round(own.height - 0.03, 3), inset=0.042)
    d.surface("top", box, inset=0.01)
    d.fit()
