"""Shelves and cabinets of shops and stores: gondolas, bread shelves, drawers for small parts, glass fridges."""

from __future__ import annotations

import math

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import bar_pull, carcass, compartments, drawers, feet, pulls
from .storage_parts import boards, open_case

RAIL = "red plastic, blue plastic, white plastic, green plastic, grey plastic"


@draws("gondola_shelf")
def gondola_shelf(d: Drawing) -> None:
    """A free shelf with boards on both sides of a back panel, and rails for prices."""
    look, rail = d.material("frame", "white paint, light grey paint, black paint, oak"), d.material("rails", RAIL)
    box, board = d.bounds, 0.025
    with d.part("base"):
        base = d.box(box.bottom(0.14).inset(x=0.01), look, 0.002)
        d.print(base.front(0.0).inset(z=0.05, y=0.01), rail)
    with d.part("spine"):
        d.box(box.inset(bottom=0.14).place(depth=0.04), look, 0.002)
    middle = box.center[0]
    for name, side in (("front", (middle + 0.02, box.x[1])), ("back", (box.x[0], middle - 0.02))):
        for k, room in enumerate(box.inset(bottom=0.14, y=0.005).to(x=side).rows(4, gap=board)):
            plate = room.bottom(-board) if k else base.to(x=side).top(0.02)
            if k:
                with d.part(f"{name}-{k}"):
                    d.box(plate, look, 0.001)
                    if name == "front":
                        d.print(plate.front(0.0).inset(y=0.003, z=0.004), rail)
            d.surface(f"{name}-{k}", plate, None if k == 3 else round(room.height - 0.003, 4), inset=0.02)


@draws("store_shelf")
def store_shelf(d: Drawing) -> None:
    """Boards before a back panel on a deep base, open above, as along the walls of a shop."""
    look, rail = d.material("frame", "white paint, oak, light grey paint, black paint"), d.material("rails", RAIL)
    box, board = d.bounds, 0.025
    with d.part("back"):
        d.box(box.back(0.03), look, 0.001)
    inner = box.inset(back=0.03)
    with d.part("base"):
        base = d.box(inner.bottom(0.14), look, 0.002)
        d.print(base.front(0.0).inset(z=0.05, y=0.01), rail)
    rooms = inner.inset(bottom=0.14).rows(5 if box.height > 1.9 else 4, gap=board)
    boards(d, [rooms[0], *(room.inset(front=0.06) for room in rooms[1:])], look, board, ends=False)
    for k, room in enumerate(rooms):
        if k:
            with d.part(f"shelf-{k}"):
                d.print(room.inset(front=0.06).bottom(-board).front(0.0).inset(y=0.003, z=0.004), rail)


@draws("bread_shelf")
def bread_shelf(d: Drawing) -> None:
    """A baker's wooden shelf for the wall behind the counter, with a board of names over it."""
    wood, board = d.material("body", "oak, pine, walnut, beech, ash grey wood"), 0.025
    case = d.bounds.inset(top=0.18)
    room = open_case(d, case, wood, 0.03)
    with d.part("foot"):
        d.box(room.bottom(0.3).inset(top=board), wood, 0.002)
        d.box(room.bottom(0.3).top(board), wood, 0.001)
    with d.part("sign"):
        sign = d.box(d.bounds.top(0.18).back(0.03), wood, 0.004)
        d.print(sign.front(0.0).inset(z=0.03, y=0.06), "ink pigment")
    boards(d, room.inset(bottom=0.3).rows(4, gap=board), wood, board, ends=False)


@draws("display_fridge")
def display_fridge(d: Drawing) -> None:
    """A tall fridge with a glass door, a lit sign, and bottles and cans on wire shelves."""
    body = d.material("body", "white paint, black paint, red paint, blue paint, brushed steel")
    box, wall = d.bounds.inset(front=0.045), 0.035
    with d.part("body"):
        low, sign = box.bottom(0.16), box.top(0.2)
        d.box(low, "black plastic", 0.002)
        d.box(sign, body, 0.004)
        d.print(sign.front(0.0).inset(y=0.05, z=0.04), "lamp glow")
        case = box.inset(bottom=0.16, top=0.2)
        for side in (case.left(wall), case.right(wall), case.inset(y=wall).back(wall)):
            d.box(side, body, 0.0)
        room = case.inset(y=wall, back=wall)
        d.box(room.bottom(0.01), "white plastic", 0.0)
        looks = ("green glass", "red plastic", "orange plastic", "amber glass", "clear plastic", "blue plastic")
        rooms = room.inset(bottom=0.01, front=0.03).rows(5, gap=0.012)
        first = d.integer("first", 0, 5)
        for k, own in enumerate(rooms):
            if k:
                d.box(own.bottom(-0.012), "white steel", 0.0)
            for j, cell in enumerate(own.inset(y=0.01).columns(max(4, round(own.width / 0.09)), gap=0.012)):
                tall = min(0.21, 0.8 * own.height)
                for x in (0.3, 0.72):
                    at = cell.place(0.066, 0.066, at="bottom").move(x=(x - 0.5) * own.depth)
                    d.cylinder(at.to(z=(own.z[0], own.z[0] + tall)), looks[(k + j // 2 + first) % 6], segments=8)
        compartments(d, rooms)
    leaf = case.front(-0.02).inset(back=-0.002, y=0.003, z=0.003)
    with d.hinge("door-0", leaf.anchor("front left bottom"), limits=(0.0, math.radians(95.0))):
        for bar in (leaf.left(0.03), leaf.right(0.03)):
            d.box(bar, "black plastic", 0.0)
        for bar in (leaf.inset(y=0.03).top(0.03), leaf.inset(y=0.03).bottom(0.03)):
            d.box(bar, "black plastic", 0.0)
        d.box(leaf.inset(y=0.03, z=0.03).place(depth=0.006), "glass", 0.0)
        x, y, _ = leaf.anchor("front")
        y = leaf.y[0] + 0.02
        bar_pull(d, (leaf.x[1], y, 0.95), (leaf.x[1], y, 1.25), "black plastic", 0.008, 0.02)


def _drawer_case(d: Drawing, wood: Look, rows: int, columns: int, foot: float, pull: str, label: bool = False) -> None:
    """A case full of drawers on a plinth, with a top for things."""
    style, metal, reach = pulls(d, d.material("body", wood) if isinstance(wood, str) else wood, pull)
    box = d.bounds.inset(front=reach)
    with d.part("case"):
        feet(d, box.bottom(foot), wood, "plinth")
        room = carcass(d, box.inset(bottom=foot), wood)
        if columns > 1:
            for k, cell in enumerate(room.columns(columns, gap=0.016)):
                if k:
                    d.box(cell.right(-0.016), wood, 0.0)
                drawers(d, cell, rows, wood, metal, style, name=f"drawer-{k}")
        else:
            drawers(d, room, rows, wood, metal, style)
    d.surface("top", box, inset=0.015)


@draws("apothecary_cabinet")
def apothecary_cabinet(d: Drawing) -> None:
    """An apothecary's or ironmonger's cabinet: rows of small drawers."""
    wood = d.material("body", "oak, walnut, pine, mahogany, light grey paint, sage paint")
    _drawer_case(d, wood, 5, 3, 0.08, "knob")


@draws("plan_chest")
def plan_chest(d: Drawing) -> None:
    """Wide flat drawers for drawings and maps."""
    wood = d.material("body", "oak, grey paint, light grey paint, pine, white paint")
    _drawer_case(d, wood, 7, 1, 0.1, "cup")


@draws("type_cabinet")
def type_cabinet(d: Drawing) -> None:
    """A compositor's cabinet: shallow cases of type in a stand, with a top to set on."""
    wood = d.material("body", "oak, walnut, beech, black paint")
    _drawer_case(d, wood, 12, 1, 0.12, "cup")


def _work_table(d: Drawing, top_look: Look, frame: Look, thick: float, leg: float, shelf: float | None) -> None:
    """Four posts under a thick top, with rails and, where there is one, a shelf below."""
    box = d.bounds
    with d.part("top"):
        top = d.box(box.top(thick), top_look, 0.003)
    under = box.inset(top=thick, x=0.04, y=0.05)
    for name, ends in (("right", under.right(leg)), ("left", under.left(leg))):
        with d.part(name):
            for post in (ends.front(leg), ends.back(leg)):
                d.box(post, frame, 0.002)
            d.box(ends.inset(x=leg).top(0.08), frame, 0.001)
    between = under.inset(y=leg)
    if shelf is not None:
        with d.part("shelf"):
            board = d.box(under.inset(y=leg).to(z=(shelf - 0.025, shelf)), frame if thick < 0.05 else top_look, 0.001)
        d.surface("shelf", board.inset(x=0.02), round(box.height - thick - 0.09 - shelf, 3), inset=0.01)
    with d.part("rails"):
        for rail in (between.back(0.03), between.front(0.03)):
            d.box(rail.top(0.08), frame, 0.001)
    d.surface("top", top, inset=0.015)


@draws("bakers_table")
def bakers_table(d: Drawing) -> None:
    """A table to work dough on, with a thick wooden or a marble top and a shelf below."""
    look = d.material("top", "beech, oak, marble, granite")
    _work_table(d, look, d.material("frame", "brushed steel, oak, white paint"), 0.05, 0.06, 0.25)


@draws("cutting_table")
def cutting_table(d: Drawing) -> None:
    """A large high table to cut cloth on, with a shelf for rolls below."""
    look = d.material("top", "beech, light oak, white paint, birch")
    _work_table(d, look, d.material("frame", "oak, white paint, grey paint, pine"), 0.035, 0.07, 0.3)


@draws("sorting_table")
def sorting_table(d: Drawing) -> None:
    """A plain steel or wooden table to sort, pack and wrap on, with a shelf below."""
    look = d.material("top", "birch, grey paint, brushed steel, pine")
    _work_table(d, look, d.material("frame", "grey paint, black steel, brushed steel"), 0.03, 0.05, 0.28)


@draws("welding_table")
def welding_table(d: Drawing) -> None:
    """A thick plate of steel with a grid of holes on posts of steel."""
    box = d.bounds
    _work_table(d, "iron", d.material("frame", "black steel, blue paint, grey paint"), 0.05, 0.09, None)
    with d.part("top"), d.grid(box.top(0.0).inset(x=0.08, y=0.08), x=5, y=8):
        d.print(Box.sized(0.018, 0.018, 0.0), "black plastic", oval=True)


@draws("butcher_block")
def butcher_block(d: Drawing) -> None:
    """A block of end grain on four stout legs."""
    wood, box = d.material("block", "beech, maple, oak"), d.bounds
    with d.part("block"):
        block = d.box(box.top(0.32), wood, 0.008)
        for band in (0.25, 0.75):
            d.print(block.front(0.0).inset(y=0.01).share(z=(band - 0.03, band + 0.03)), "steel")
        with d.corners(box.bottom(box.height - 0.32), inset=0.03):
            d.box(Box((0.0, 0.1), (0.0, 0.1), (0.0, box.height - 0.32)), wood, 0.004)
    d.surface("top", block, inset=0.02)
