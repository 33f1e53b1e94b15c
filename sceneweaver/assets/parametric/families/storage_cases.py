"""Closed cases: wardrobes, chests of drawers, sideboards, cabinets, lockers."""

from __future__ import annotations

from ...drawing import Box, Drawing, draws
from ...drawing.components import (
    SWING,
    carcass,
    compartments,
    cornice,
    door,
    doors,
    drawer,
    drawers,
    feet,
    handle,
    lip,
    pulls,
)
from .storage_parts import BOARD, closed_case, inner_boards, rear_panels

WOODS = ("oak", "walnut", "white paint", "light oak", "pine", "cherry", "sage paint", "ash grey wood")


@draws("wardrobe")
def wardrobe(d: Drawing) -> None:
    """A case with two to four doors, a rail and a board for hats inside; a cornice in the classic style."""
    two_tone = d.chance("two tone", 0.3)
    woods = ("oak", "white paint", "walnut", "light grey paint", "pine", "cherry", "cream paint", "sage paint")
    wood = d.material("body", *(("oak", "light oak", "walnut") if two_tone else woods))
    fronts = d.material("fronts", "white paint", "sage paint", "navy paint", "cream paint") if two_tone else wood
    style, pull, reach = pulls(d, wood, "bar", "knob", "bar")
    classic = d.style in ("classic", "rustic")
    over, head = (0.025, 0.06) if classic else (0.0, 0.0)
    framed, mirror = classic or d.chance("framed", 0.25), d.chance("mirror", 0.3)
    foot, leaf = 0.08, 0.02
    case = d.bounds.inset(front=max(reach + leaf, over), y=over, top=head)
    count = 2 if d.size.width < 1.2 else 3 if d.size.width < 1.6 else 4
    with d.part("foot"):
        d.box(case.bottom(foot).inset(y=BOARD, front=0.0 if classic else 0.03).front(BOARD), wood)
        d.box(case.bottom(foot).inset(y=BOARD, back=0.05).back(BOARD), wood, bevel=0.0)
        if classic:
            d.box(case.bottom(foot).front(-0.012), wood, bevel=0.004)
    for k, side in enumerate((case.right(BOARD), case.left(BOARD))):
        with d.part(f"side-{k}"):
            d.box(side, wood, bevel=0.0015)
    room = case.inset(y=BOARD, bottom=foot)
    with d.part("back"):
        rear_panels(d, room.inset(back=0.009).back(0.004), "birch", "white plastic", max(2, count - 1))
    with d.part("foot"):
        d.box(room.bottom(BOARD), wood, bevel=0.0015)
    room = room.inset(back=0.013, bottom=BOARD)
    with d.part("top"):
        d.box(room.top(BOARD), wood, bevel=0.0015)
        hats = d.box(room.inset(front=0.02, top=0.24).top(BOARD), wood, bevel=0.0)
        x, _, z = hats.move(z=-0.06).anchor("bottom")
        d.bar((x, room.y[0], z), (x, room.y[1], z), 0.0125, "brushed steel")
        if classic:
            cornice(d, case.top(-head), wood, over)
    compartments(d, [room.to(z=(room.z[0], z - 0.02)), room.to(z=(hats.z[1], room.z[1] - BOARD))])
    d.surface("floor", room.bottom(0.0).inset(back=0.01, front=0.02), round(z - 0.0175 - room.z[0], 4))
    with d.part("doors"):
        for k, cell in enumerate(case.inset(bottom=foot + 0.003, top=0.003).front(-leaf).columns(count)):
            panel = "mirror" if mirror and k == count // 2 else fronts if framed else None
            hung = "right" if k % 2 == 0 and k + 1 < count else "left"
            door(d, f"door-{k}", cell, fronts, pull, hung, style, panel)
    d.surface("top", d.bounds.to(x=case.x, y=case.y), inset=0.02)


@draws("dresser", "tallboy")
def chest_of_drawers(d: Drawing) -> None:
    """Rows of drawers, lower ones higher, under a top that stands over them; a tallboy is narrow and has many."""
    tall = d.category.name == "tallboy"
    wood = d.material("body", *WOODS)
    two_tone = not tall and d.chance("two tone", 0.35)
    fronts = d.material("fronts", "white paint", "oak", "navy paint") if two_tone else wood
    style, pull, reach = pulls(d, wood)
    base = d.pick("base", ["plinth", "bracket", "tapered", *(() if tall else ("splayed",))])
    foot = {"plinth": 0.06, "bracket": 0.1}.get(base, 0.1 if tall else 0.14)
    case = d.bounds.inset(front=max(reach, 0.01), y=0.01)
    rows = d.integer("rows", 5, 7) if tall else 3 if case.height < 0.85 else 4
    columns = 1 if case.width < 1.0 else 2
    head = columns if case.width < 0.8 else columns + 1
    with d.part("body"):
        room = closed_case(d, case, wood, base, foot, 0.01)
        weights = [1.2, 1.2, *[1.0] * (rows - 3), 0.8] if tall else [1.25] * (rows - 2) + [1.1, 0.8]
        drawers(d, room, weights, fronts, pull, style, [columns] * (rows - 1) + [1 if tall else head])


@draws("sideboard")
def sideboard(d: Drawing) -> None:
    """A long low case with doors and a stack of drawers."""
    wood = d.material("body", "walnut", "oak", "white paint", "light oak", "black paint", "mahogany")
    fronts = d.material("fronts", "white paint", "rattan", "teal paint") if d.chance("two tone", 0.3) else wood
    style, pull, reach = pulls(d, wood, "bar", "knob")
    base = d.pick("base", ["tapered", "splayed", "square", "plinth"])
    case = d.bounds.inset(front=max(reach, 0.006), y=0.006)
    count = 3 if case.width < 1.5 else 4
    drawn = d.integer("drawer place", 0, count - 1)
    with d.part("body"):
        room = closed_case(
            d, case, wood, base, 0.06 if base == "plinth" else min(0.2, 0.25 * case.height), 0.006, 0.024
        )
        for k, cell in enumerate(room.columns(count, gap=BOARD)):
            if k:
                d.box(cell.right(-BOARD), wood, bevel=0.001)
            if k == drawn:
                drawers(d, cell, [1.2, 1.0, 0.9], fronts, pull, style)
            else:
                inner_boards(d, cell, 1, wood, f"inside-{k}")
                door(d, f"door-{k}", cell.front(BOARD), fronts, pull, "right" if k < drawn else "left", style, grip=0.7)


@draws("cabinet")
def cabinet(d: Drawing) -> None:
    """One or two framed doors, often with drawers over them."""
    wood = d.material("body", *WOODS)
    style, pull, reach = pulls(d, wood, "bar", "knob")
    base = d.pick("base", ["plinth", "bracket", "tapered", "square"])
    framed = wood if d.chance("framed", 0.6) else None
    with d.part("body"):
        case = d.bounds.inset(front=max(reach, 0.01), y=0.01)
        room = closed_case(d, case, wood, base, 0.06 if base == "plinth" else 0.11, 0.01)
        if d.chance("drawers", 0.5):
            drawers(d, room.top(0.16), 1, wood, pull, style, 1 if case.width < 0.7 else 2)
            room = room.inset(top=0.16 + BOARD)
            d.box(room.top(-BOARD), wood, bevel=0.0)
        inner_boards(d, room, 1, wood)
        doors(d, room.front(BOARD), 1 if case.width < 0.5 else 2, wood, pull, style, framed, grip=0.65)


@draws("linen_cabinet")
def linen_cabinet(d: Drawing) -> None:
    """A tall closed cupboard: doors over two deep drawers, with a cornice."""
    wood = d.material("body", "white paint", "cream paint", "oak", "pine", "sage paint")
    style, pull, reach = pulls(d, wood, "knob", "bar")
    case = d.bounds.inset(front=max(reach, 0.02), y=0.02, top=0.05)
    with d.part("body"):
        feet(d, case.bottom(0.09), wood, "bracket")
        room = carcass(d, case.inset(bottom=0.09), wood)
        cornice(d, case.top(-0.05), wood, 0.02)
        drawers(d, room.bottom(0.42), 2, wood, pull, style)
        upper = room.inset(bottom=0.42 + BOARD)
        d.box(upper.bottom(-BOARD), wood, bevel=0.0)
        inner_boards(d, upper, 3, wood)
        levels = upper.front(BOARD).rows(1 if d.size.height < 1.75 else 2)
        for j, level in enumerate(levels):
            name = f"door-{j}" if len(levels) > 1 else "door"
            doors(d, level, 1 if case.width < 0.56 else 2, wood, pull, style, wood, name)
    d.surface("top", d.bounds.to(x=case.x, y=case.y), inset=0.02)


@draws("shoe_cabinet")
def shoe_cabinet(d: Drawing) -> None:
    """A shallow case with tilting flaps, each with a tray for shoes behind it."""
    wood = d.material("body", "white paint", "oak", "light grey paint", "walnut", "black paint")
    style, pull, reach = pulls(d, wood, "bar", "knob", "cup")
    case = d.bounds.inset(front=reach)
    with d.part("body"):
        room = closed_case(d, case, wood, "plinth", 0.05, 0.0, 0.02)
        for k, column in enumerate(room.columns(1 if case.width < 0.75 else 2)):
            for j, cell in enumerate(column.rows(2 if case.height < 0.9 else 3)):
                own = cell.inset(y=0.003, z=0.003)
                hinge = own.anchor("front bottom")
                with d.hinge(f"flap-{k}-{j}", hinge, axis=(0.0, 1.0, 0.0), limits=(0.0, 0.8)):
                    face = d.box(own.front(BOARD), wood)
                    handle(d, face.top(0.1), pull, style, 0.12)
                    tray = own.inset(front=BOARD, back=0.02, y=0.015)
                    for level in (0.05, 0.45):
                        d.box(tray.share(z=(level, level)).bottom(0.004), "black plastic", bevel=0.0)


@draws("filing_cabinet")
def filing_cabinet(d: Drawing) -> None:
    """A steel case of two to five deep drawers with label holders."""
    steel = d.material("body", "grey paint", "light grey paint", "black paint", "white paint", "green paint")
    pull = d.material("pulls", "brushed steel", "chrome")
    case = d.bounds.inset(front=0.025)
    with d.part("body"):
        feet(d, case.bottom(0.03), steel, "plinth")
        room = carcass(d, case.inset(bottom=0.03), steel, 0.015)
        for k, cell in enumerate(room.rows(max(2, min(5, round((case.height - 0.05) / 0.32))))):
            drawer(d, f"drawer-{k}", cell, steel, pull, travel=0.8 * case.depth, inside=steel, label=True)
        if d.chance("lock", 0.7):
            d.box(case.front(-0.004).left(0.02).top(0.013).inset(top=0.003, right=0.004), pull, bevel=0.001)
    d.surface("top", case, inset=0.01)


@draws("locker")
def locker(d: Drawing) -> None:
    """Steel doors with slots for air, one or two over each other, with a hat board and a rail inside."""
    steel = d.material("body", "grey paint", "light grey paint", "blue paint", "navy paint")
    fronts = d.material("doors", "blue paint", "red paint", "green paint", "teal paint", "yellow paint", "grey paint")
    metal = d.material("locks", "brushed steel", "chrome")
    case = d.bounds.inset(front=0.025)
    columns, rows = max(1, round(case.width / 0.32)), d.pick("rows", [1, 1, 2])
    with d.part("body"):
        feet(d, case.bottom(0.1), steel, "square" if d.chance("legs", 0.4) else "plinth")
        room = carcass(d, case.inset(bottom=0.1), steel, 0.014)
        for k, column in enumerate(room.columns(columns, gap=0.004)):
            if k:
                d.box(column.inset(front=0.02).right(-0.004), steel, bevel=0.0)
            for j, cell in enumerate(column.rows(rows, gap=0.006)):
                hats = d.box(cell.inset(front=0.025).place(height=0.003, at="top").move(z=-0.28), steel, bevel=0.0)
                compartments(
                    d,
                    [cell.inset(front=0.02).to(z=z) for z in ((cell.z[0], hats.z[0] - 0.06), (hats.z[1], cell.z[1]))],
                    f"inside-{k}-{j}",
                )
                rail = Box.around(hats.anchor("bottom"), 0.016, cell.width, 0.016).move(z=-0.04)
                d.cylinder(rail, metal, "y", segments=8)
                _locker_door(d, f"door-{k}-{j}", cell.inset(y=0.002, z=0.002).front(BOARD), fronts, metal)


def _locker_door(d: Drawing, name: str, leaf: Box, paint, metal) -> None:
    """A steel leaf with slots for air at both ends, a lock with a grip, and a card with its number."""
    with d.hinge(name, leaf.anchor("front left bottom"), limits=(0.0, SWING)):
        d.box(leaf, paint, bevel=0.002)
        field = leaf.front(0.0).share(y=(0.2, 0.8))
        for z in (leaf.z[1] - 0.08, leaf.z[0] + 0.07):
            for slot in field.to(z=(z, z + 0.06)).rows(4, gap=0.012):
                d.print(slot, "black paint")
        d.print(field.place(width=0.06).to(z=(leaf.z[1] - 0.14, leaf.z[1] - 0.11)), "paper")
        height = 1.05 if leaf.height > 1.0 else leaf.center[2]
        plate = leaf.front(-0.002).right(0.042).inset(right=0.012).to(z=(height - 0.06, height + 0.06))
        d.box(plate, metal, bevel=0.0005)
        lip(d, plate.front(-0.022).inset(y=0.008, z=0.03), metal, (0.0, 1.0, 0.0))
