"""Open shelves and glazed cabinets: every board can carry things."""

from __future__ import annotations

import numpy as np

from ...drawing import Drawing, draws
from ...drawing.components import carcass, compartments, cornice, doors, feet, pulls, walls
from ...drawing.components.supports import SHADOW
from .storage_parts import boards, open_case

WOODS = ("oak", "walnut", "white paint", "black paint", "light oak", "pine")


@draws("bookcase")
def bookcase(d: Drawing) -> None:
    """Sides, back and three to four openings; modern on a set-back plinth, classic with plinth and cornice."""
    wood = d.material("body", *WOODS, "cherry", "sage paint")
    rear = d.material("back", "white paint", "navy paint", "sage paint") if d.chance("painted back", 0.15) else wood
    classic = d.style in ("classic", "rustic") and d.chance("cornice", 0.8)
    over, head = (0.025, 0.055) if classic else (0.0, 0.0)
    board = d.pick("board", [0.018, 0.022, 0.03])
    plinth = d.uniform("plinth", 0.06, 0.1) if classic else d.uniform("plinth", 0.04, 0.07)
    case = d.bounds.inset(front=over, y=over, top=head)
    room = open_case(d, case, wood, board, rear)
    with d.part("foot"):
        low = room.bottom(plinth)
        d.box(low.front(0.02) if classic else low.inset(front=0.03).front(0.02), wood, bevel=0.0)
        if classic:
            d.box(case.bottom(plinth).inset(y=-0.012).front(-0.012), wood, bevel=0.004)
        d.box(room.inset(bottom=plinth).bottom(board), wood, bevel=0.0015)
    for k, side in enumerate((case.right(board), case.left(board)) if classic else ()):
        with d.part(f"side-{k}"):  # a bead down the front edge
            d.box(side.front(-0.005).place(width=0.01).inset(bottom=plinth + board), wood, bevel=0.002)
    with d.part("top"):
        d.box(room.top(board), wood, bevel=0.0015)
        if classic:
            cornice(d, case.top(-head), wood, over)
    count = 3 if d.size.height < 1.6 else 4  # openings; with sides, back, foot and top at most eight prisms
    # The lowest opening is the highest: for folders and large books.
    graded = [1.12 - 0.24 * k / (count - 1) for k in range(count)] if d.chance("graded", 0.5) else count
    boards(d, room.inset(front=0.004, bottom=plinth + board, top=board).rows(graded, gap=board), wood, board)
    if d.size.height < 1.6:
        d.surface("top", d.bounds.to(x=case.x, y=case.y), inset=0.01)


@draws("low_bookcase")
def low_bookcase(d: Drawing) -> None:
    """Two or three boards high, with a top to put things on."""
    wood, board, thick = d.material("body", *WOODS), 0.02, 0.024
    base = d.pick("base", ["plinth", "tapered", "square"])
    foot = 0.05 if base == "plinth" else 0.12
    case = d.bounds.inset(front=0.008, y=0.008, top=thick)
    room = open_case(d, case.inset(bottom=foot), wood, board)
    with d.part("foot"):
        feet(d, case.bottom(foot), wood, base)
        d.box(room.bottom(board), wood, bevel=0.0015)
    with d.part("top"):
        d.box(d.bounds.top(thick), wood, bevel=0.004)
    boards(d, room.inset(front=0.004, bottom=board).rows(2 if d.size.height < 0.95 else 3, gap=board), wood, board)
    d.surface("top", d.bounds, inset=0.01)


@draws("display_cabinet")
def display_cabinet(d: Drawing) -> None:
    """A cabinet with glass doors and sides over a closed foot; glass boards within."""
    wood = d.material("body", "oak", "walnut", "white paint", "mahogany", "black paint", "cherry")
    style, pull, reach = pulls(d, wood, "bar", "knob")
    classic = d.style in ("classic", "rustic")
    over, rim, leaf = 0.02 if classic else 0.0, 0.035, 0.0195
    case = d.bounds.inset(front=max(reach, over), y=over, top=0.06)
    foot = 0.28 * d.size.height if d.chance("cupboard", 0.5) else 0.12
    glazed = case.inset(bottom=foot, front=leaf)
    with d.part("foot"):
        feet(d, case.bottom(0.08), wood, "bracket" if classic else "plinth")
        block = case.inset(bottom=0.08, front=leaf).to(z=(0.08, foot))
        rail = block.front(-leaf)
        if foot <= 0.2:
            d.box(block, wood)
        else:
            compartments(d, [carcass(d, block, wood)], "low")
            doors(d, rail.inset(top=0.02), 2, wood, pull, style, wood, "low", grip=0.75)
            rail = rail.top(0.02)
        d.box(rail, wood, bevel=0.001)
    for k, side in enumerate((glazed.right(0.025), glazed.left(0.025))):
        with d.part(f"side-{k}"):
            for post in (side.front(rim), side.back(rim)):
                d.box(post, wood, bevel=0.001)
            between = side.inset(x=rim)
            for level in (between.bottom(0.03), between.top(0.03)):
                d.box(level, wood, bevel=0.001)
            d.box(between.inset(z=0.03).place(width=0.006), "glass", bevel=0.0)
    room = glazed.inset(y=0.025, back=0.008)
    with d.part("back"):
        d.box(room.back(-0.008), wood, bevel=0.0)
    with d.part("top"):
        if classic:
            cornice(d, case.top(-0.06), wood, over)
        else:
            d.box(case.top(-0.06), wood)
    rooms = room.inset(front=0.01).rows(2 if d.size.height < 1.4 else 3, gap=0.008)
    boards(d, rooms, d.material("boards", "glass"), 0.008)
    with d.part("doors"):
        panes = case.inset(bottom=foot).front(leaf).inset(z=0.002)
        doors(d, panes, 1 if case.width < 0.55 else 2, wood, pull, style, "glass")
    if d.size.height < 1.4:
        d.surface("top", d.bounds.to(x=case.x, y=case.y), inset=0.01)


@draws("metal_shelf")
def metal_shelf(d: Drawing) -> None:
    """Posts of angle steel, four or five trays or boards, a cross brace at the back."""
    steel = d.material("frame", "brushed steel", "black steel", "white steel", "blue paint", "grey paint")
    tray = d.material("boards", "plywood", "brushed steel", "pine") if d.chance("wood", 0.5) else steel
    thin, wide, lip, bounds = 0.003, 0.035, 0.03, d.bounds
    for k, side in enumerate((bounds.right(wide), bounds.left(wide))):
        outer = "right" if k == 0 else "left"
        with d.part(f"side-{k}"):
            for post, end in ((side.back(wide), "back"), (side.front(wide), "front")):
                d.box(getattr(post, end)(thin), steel, bevel=0.0)
                d.box(getattr(post, outer)(thin), steel, bevel=0.0)
                d.box(post.bottom(0.006), "black plastic", bevel=0.0)
    with d.part("brace"), d.mirror("y"):
        x, y = bounds.x[0] + 0.006, bounds.y[1] - 0.02
        d.bar((x, -y, 0.15), (x, y, bounds.z[1] - 0.15), 0.003, steel, segments=6)
    inner = bounds.inset(back=0.012, front=thin, y=thin)
    count = 4 if bounds.height < 1.75 else 5
    levels = np.linspace(0.12, bounds.z[1] - 0.012, count).tolist()
    for k, z in enumerate(levels):
        with d.part(f"tray-{k}"):
            board = d.box(inner.to(z=(z - 0.012, z)), tray, bevel=0.001)
            for rail in (board.front(0.015), board.back(0.015)):
                d.box(rail.bottom(-lip), steel, bevel=0.001)
        room = round(levels[k + 1] - lip - 0.015 - z, 4) if k + 1 < count else None
        d.surface(f"shelf-{k}" if room else "top", board, room, inset=0.037)


@draws("cube_shelf")
def cube_shelf(d: Drawing) -> None:
    """A thick frame around square openings; in the lowest, a row of boxes."""
    wood = d.material("body", "white paint", "oak", "black paint", "light oak", "walnut")
    rim, board, bounds = 0.036, 0.018, d.bounds
    columns = max(2, min(3, round(bounds.width / 0.37)))
    rows = max(2, min(6 - columns, round(bounds.height / 0.37)))
    inner = bounds.inset(y=rim)
    levels = inner.inset(z=rim).rows(rows, gap=board)
    bins = d.chance("bins", 0.45)
    cloth = d.material("bins", "grey fabric", "beige fabric", "rattan", "navy fabric", "mustard fabric") if bins else ""
    for k, side in enumerate((bounds.right(rim), bounds.left(rim))):
        with d.part(f"upright-{k * columns}"):
            d.box(side, wood, bevel=0.002)
    for k, cell in enumerate(levels[0].columns(columns, gap=board)[1:], start=1):
        with d.part(f"upright-{k}"):
            for level in levels:
                d.box(cell.right(-board).to(z=level.z).inset(front=0.004), wood, bevel=0.001)
    spans = [inner.bottom(rim), *(level.bottom(-board) for level in levels[1:]), inner.top(rim)]
    for j, span in enumerate(spans):
        with d.part(f"board-{j}"):
            d.box(span, wood, bevel=0.001)
            if j == 0 and bins:
                for cell in levels[0].columns(columns, gap=board):
                    face = d.box(cell.inset(y=0.006, back=0.02, front=0.01, top=0.03), cloth, bevel=0.006)
                    strap = face.top(0.07).bottom(0.02).place(width=0.08).front(-0.006)
                    d.box(strap, "brown leather", bevel=0.002)
        if j < rows and (j or not bins):
            for k, cell in enumerate(levels[j].columns(columns, gap=board)):
                floor = cell.inset(front=0.004).bottom(0.0)
                d.surface(f"shelf-{j * columns + k}", floor, round(cell.height - 0.003, 4), inset=0.005)
    d.surface("top", bounds, inset=0.01)


@draws("ladder_shelf")
def ladder_shelf(d: Drawing) -> None:
    """Leaning rails in front of upright posts, boards that grow shallower upward."""
    frame = d.material("frame", "black steel", "oak", "white paint", "walnut", "bamboo")
    wood = d.material("boards", "oak", "walnut", "pine", "light oak")
    thick, bounds = 0.022, d.bounds

    def front(z: float) -> float:
        """The depth at which the rails are at a height."""
        return bounds.x[1] - 0.58 * bounds.depth * z / bounds.height

    for k, side in enumerate((bounds.right(thick), bounds.left(thick))):
        with d.part(f"side-{k}"):
            d.box(side.back(thick), frame, bevel=0.002)
            d.hull([(front(z) - out, y, z) for z in side.z for out in (0.0, 0.035) for y in side.y], frame)
    count = 4 if bounds.height < 1.65 else 5
    rooms = bounds.inset(y=thick, bottom=0.18).to(z=(0.18, bounds.z[1] + 0.03)).rows(count, gap=0.02)
    rooms = [room.to(x=(bounds.x[0] + 0.002, front(room.z[0]) - 0.006)) for room in rooms]
    boards(d, rooms, wood, 0.02, first=0, ends=False)


@draws("corner_shelf")
def corner_shelf(d: Drawing) -> None:
    """Quarter-round boards between two narrow sides that meet in the corner of a room."""
    wood = d.material("body", *WOODS)
    thick, board, bounds = 0.016, 0.02, d.bounds
    with d.part("back"):
        d.box(bounds.inset(right=0.03).back(thick), wood, bevel=0.0015)
    with d.part("side"):
        d.box(bounds.inset(back=thick, front=0.03).left(thick), wood, bevel=0.0015)
    room = bounds.inset(back=thick, left=thick)
    x, y, _ = room.anchor("back left")

    def quarter(share: float, inset: float, count: int) -> np.ndarray:
        """A quarter of an ellipse about the corner, as corners of a polygon."""
        turn = np.linspace(0.03 if inset else 0.0, np.pi / 2 - (0.03 if inset else 0.0), count)[::-1]
        ends = np.c_[x + share * room.depth * np.cos(turn), y - share * room.width * np.sin(turn)]
        return np.concatenate([ends, [(x + inset, y - inset)]])

    count = 4 if bounds.height < 1.5 else 5
    levels = np.linspace(0.08, bounds.z[1] - 0.2, count).tolist()
    for k, z in enumerate(levels):
        with d.part(f"shelf-{k}"):
            d.extrude(quarter(1.0, 0.0, 13), (z - board, z), wood)
        headroom = None if k + 1 == count else round(levels[k + 1] - board - z - 0.003, 4)
        d.surface(f"shelf-{k}", room.to(z=(0.0, z)), headroom, polygon=quarter(0.95, 0.005, 9))


@draws("library_shelf")
def library_shelf(d: Drawing) -> None:
    """A free-standing case with boards on both sides of a middle panel."""
    wood = d.material("body", "oak", "beech", "light grey paint", "walnut", "white paint")
    ends = d.material("ends", "oak", "beech", "walnut") if d.chance("ends", 0.4) else wood
    board, bounds = 0.02, d.bounds
    for k, side in enumerate((bounds.right(0.03), bounds.left(0.03))):
        with d.part(f"end-{k}"):
            d.box(side, ends, bevel=0.004)
    inner = bounds.inset(y=0.03)
    with d.part("foot"):
        d.box(inner.inset(x=0.03).bottom(0.08), SHADOW, bevel=0.0)
        d.box(inner.inset(x=0.005, bottom=0.08).bottom(board), wood, bevel=0.0015)
    with d.part("roof"):
        d.box(inner.inset(x=0.002).top(0.03), wood, bevel=0.002)
    room = inner.inset(bottom=0.08 + board, top=0.03)
    with d.part("panel"):
        d.box(room.place(depth=0.018), wood, bevel=0.0)
    inner = room.inset(x=0.008)
    halves = {"front": inner.front(inner.depth / 2 - 0.009), "back": inner.back(inner.depth / 2 - 0.009)}
    for k, level in enumerate(room.rows(4 if bounds.height > 1.5 else 3, gap=board)):
        for name, half in halves.items():
            plate = half.to(z=level.z).bottom(-board)
            if k:
                with d.part(f"shelf-{k}"):
                    d.box(plate, wood, bevel=0.0015)
            d.surface(f"{name}-{k}", plate, round(level.height - 0.003, 4), inset=0.005)


@draws("pantry_shelf")
def pantry_shelf(d: Drawing) -> None:
    """Slatted sides, four boards, two crates at the foot."""
    wood = d.material("body", "pine", "oak", "white paint", "birch")
    crate = d.material("crates", "wicker", "pine", "plywood")
    post, board, bounds = 0.04, 0.02, d.bounds
    for k, side in enumerate((bounds.right(0.022), bounds.left(0.022))):
        with d.part(f"side-{k}"):
            for own in (side.back(post), side.front(post)):
                d.box(own, wood, bevel=0.003)
            rung = side.inset(x=post, y=0.004).bottom(0.03)
            for z in np.linspace(0.25, bounds.z[1] - 0.06, 7).tolist():
                d.box(rung.move(z=z), wood, bevel=0.002)
    inner = bounds.inset(x=0.006, y=0.022)
    with d.part("shelf-0"):
        floor = d.box(inner.to(z=(0.08, 0.1)), wood, bevel=0.002)
        for cell in floor.inset(back=0.02, front=0.01, y=0.01).top(-0.24).columns(2, gap=0.02):
            d.box(cell.bottom(0.01), crate, bevel=0.0)
            walls(d, cell, crate, 0.012)
            d.print(cell.top(0.07).bottom(0.03).place(width=0.09).front(0.0), SHADOW)
    levels = np.linspace(0.5, bounds.z[1], 4).tolist()
    step = levels[1] - levels[0]
    boards(d, [inner.to(z=(z, z + step - board)) for z in levels], wood, board, first=0, ends=False)
