"""Counters of shops and banks: the front looks at the customers, the staff stand behind."""

from __future__ import annotations

from collections.abc import Callable

from ...drawing import Box, Drawing, Look, draws
from ...drawing.components import walls

TOP = 0.03
"""Thickness of a counter's top [m]."""


def _body(d: Drawing, box: Box, body: Look, foot: Look = "black plastic") -> None:
    """A front with raised panels, two sides, and shelves that are open to the staff."""
    d.box(box.bottom(0.09).inset(x=0.04, y=0.03), foot, 0.0)
    case = box.inset(bottom=0.08, front=0.012)
    d.box(case.front(0.03), body, 0.002)
    for side in (case.left(0.025), case.right(0.025)):
        d.box(side.inset(front=0.03), body, 0.001)
    inner = case.inset(front=0.03, y=0.025)
    for level in (inner.bottom(0.02), inner.share(z=(0.5, 0.5)).bottom(-0.018)):
        d.box(level, body, 0.0)
    for panel in case.front(-0.01).inset(y=0.05, z=0.05).columns(max(2, round(box.width / 0.5)), gap=0.05):
        d.box(panel, body, 0.004)


@draws("shop_counter")
def shop_counter(d: Drawing) -> None:
    """A panelled counter with a top that stands over it."""
    body = d.material("body", "oak, white paint, walnut, sage paint, navy paint, light grey paint, black paint")
    with d.part("body"):
        _body(d, d.bounds.inset(top=TOP, front=0.02, back=0.02, y=0.02), body)
    with d.part("top"):
        top = d.box(d.bounds.top(TOP), d.material("top", "oak, marble, walnut, white paint, beech"), 0.003)
    d.surface("top", top, inset=0.02)


@draws("teller_counter")
def teller_counter(d: Drawing) -> None:
    """A counter with a pane of glass from side to side, a gap to pass papers through, and a ledge before it."""
    body = d.material("body", "walnut, oak, grey paint, white paint, light oak")
    metal, box, top = d.material("posts", "brushed steel, brass, black steel"), d.bounds, 1.05
    with d.part("body"):
        _body(d, box.to(z=(0.0, top - TOP)).inset(front=0.1, back=0.02, y=0.02), body)
    with d.part("top"):
        board = d.box(box.to(z=(top - TOP, top)), d.material("top", "oak, marble, walnut, black paint"), 0.003)
    pane = box.to(x=(box.x[1] - 0.29, box.x[1] - 0.26), z=(top, box.z[1]))
    with d.part("screen"):
        for post in (pane.left(0.04), pane.right(0.04)):
            d.box(post, metal, 0.001)
        d.box(pane.top(0.04).inset(y=0.04), metal, 0.001)
        for glass in pane.inset(bottom=0.12, top=0.04, y=0.04).columns(max(1, round(box.width / 0.9)), gap=0.03):
            d.box(glass.place(depth=0.01), "glass", 0.0)
    d.surface("desk", board.inset(front=0.31), inset=0.02)
    d.surface("ledge", board.to(x=(box.x[1] - 0.25, box.x[1])), inset=0.015)


def _chilled(d: Drawing, body: Look, food: Callable[[Drawing, Box, int], None], pans: int) -> None:
    """A cold well under a glass front that leans back, with food in pans, and a top to hand things over."""
    steel, box = "brushed steel", d.bounds.inset(front=0.01)
    base, room = box.to(z=(0.09, 0.78)), box.to(z=(0.78, box.z[1] - TOP))
    with d.part("base"):
        d.box(box.bottom(0.09).inset(x=0.05, y=0.03), "black plastic", 0.0)
        d.box(base.inset(top=0.02), body, 0.003)
        d.box(base.front(-0.008).inset(back=-0.001, y=0.03).top(0.12), steel, 0.002)
        for panel in base.front(-0.008).inset(back=-0.001, y=0.03, top=0.16, bottom=0.04).columns(3, gap=0.03):
            d.box(panel, body, 0.004)
        d.box(base.top(0.02), steel, 0.0)
    lean = 0.3 * box.depth
    cut = 1 - lean / box.depth
    with d.part("glass"):
        d.silhouette(room.inset(y=0.002), [(0.98, 0.0), (1.0, 0.0), (cut, 1.0), (cut - 0.02, 1.0)], "glass")
        with d.mirror("y"):
            d.silhouette(room.left(0.006), [(0.3, 0.0), (0.98, 0.0), (cut - 0.02, 1.0), (0.3, 1.0)], "glass")
        tray = room.to(x=(box.x[0] + 0.25 * box.depth, box.x[1] - 0.07)).inset(y=0.03).bottom(0.04)
        for k, cell in enumerate(tray.columns(max(pans, round(box.width / 0.36)), gap=0.012)):
            walls(d, cell, steel, 0.004, 0.0)
            food(d, cell.inset(all=0.006), k)
    with d.part("top"):
        top = d.box(box.top(TOP).inset(front=lean - 0.01), steel, 0.003)
    d.surface("top", top, inset=0.02)


def _meat(d: Drawing, cell: Box, k: int) -> None:
    look = ("ham", "red paint", "rose fabric", "blush pigment")[k % 4]
    if k % 3 == 2:  # sausages side by side
        for row in cell.move(z=0.004).split("x", 4):
            d.cylinder(row.inset(all=0.004), look, "y", segments=10)
    else:
        for piece in cell.move(z=0.006).split("x", 2):
            d.cushion(piece.inset(all=0.006), look, 0.01, 0.3)


def _fish(d: Drawing, cell: Box, k: int) -> None:
    d.cushion(cell.inset(top=0.012), "white petal", 0.008, 0.2)
    look = ("silver leaf", "steel", "blush pigment")[k % 3]
    for own in cell.split("y", 2):
        middle = own.center
        d.ball(Box.around((middle[0], middle[1], cell.z[1]), 0.75 * cell.depth, 0.32 * own.width, 0.035), look, 10)


def _cheese(d: Drawing, cell: Box, k: int) -> None:
    look = ("cheese", "soft cheese", "ochre pigment")[k % 3]
    if k % 2:
        d.cylinder(cell.place(0.8 * cell.width, 0.8 * cell.width).move(z=0.01), look, segments=18)
    else:
        for piece in cell.move(z=0.012).split("x", 2):
            d.box(piece.inset(all=0.012), look, 0.004)


def _ice(d: Drawing, cell: Box, k: int) -> None:
    looks = ("pink icing", "chocolate", "icing", "pistachio leaf", "yellow petal", "grape", "cream ceramic")
    look = looks[k % len(looks)] if looks[k % len(looks)] != "pistachio leaf" else "pale leaf"
    for own in cell.split("x", 2):
        d.cushion(own.inset(x=0.004, top=-0.012), look, 0.012, 0.5)


@draws("meat_counter")
def meat_counter(d: Drawing) -> None:
    """A butcher's chilled counter with cuts and sausages."""
    _chilled(d, d.material("body", "white paint, red paint, brushed steel, black paint"), _meat, 4)


@draws("fish_counter")
def fish_counter(d: Drawing) -> None:
    """A fishmonger's counter, fish on crushed ice."""
    _chilled(d, d.material("body", "white paint, blue paint, brushed steel, teal paint"), _fish, 4)


@draws("cheese_counter")
def cheese_counter(d: Drawing) -> None:
    """A counter for cheese and delicatessen."""
    _chilled(d, d.material("body", "oak, white paint, sage paint, walnut"), _cheese, 4)


@draws("ice_cream_counter")
def ice_cream_counter(d: Drawing) -> None:
    """Tubs of ice cream under glass."""
    _chilled(d, d.material("body", "white paint, rose fabric, teal paint, light oak"), _ice, 5)


@draws("glass_counter")
def glass_counter(d: Drawing) -> None:
    """A showcase of glass over a closed base; trays with small precious things on velvet; a top of glass."""
    body = d.material("base", "walnut, black paint, white paint, oak, mahogany")
    cloth = d.material("lining", "navy fabric, black fabric, cream wool, green velvet")
    metal, box = d.material("frame", "brass, black steel, brushed steel"), d.bounds
    foot = 0.45 * box.height
    with d.part("base"):
        d.box(box.bottom(0.07).inset(x=0.03, y=0.03), "black plastic", 0.0)
        d.box(box.to(z=(0.07, foot)).inset(x=0.005, y=0.005), body, 0.003)
    room = box.to(z=(foot, box.z[1] - 0.014))
    with d.part("case"):
        d.box(room.bottom(0.012), cloth, 0.0)
        for pane in (room.front(0.008), room.left(0.008).inset(front=0.008), room.right(0.008).inset(front=0.008)):
            d.box(pane.inset(bottom=0.012), "glass", 0.0)
        with d.corners(room.inset(bottom=0.012), inset=0.008):
            d.box(Box((0.0, 0.012), (0.0, 0.012), (0.0, room.height - 0.012)), metal, 0.0)
        inner = room.inset(x=0.03, y=0.03, bottom=0.012)
        board = inner.inset(y=-0.02).to(z=(inner.center[2], inner.center[2] + 0.008)).inset(front=0.1)
        d.box(board, "glass", 0.0)
        for z, row in ((inner.z[0], inner), (board.z[1], board.inset(x=0.02, y=0.03))):
            for k, cell in enumerate(row.to(z=(z, z + 0.025)).columns(max(2, round(box.width / 0.3)), gap=0.05)):
                tray = d.box(cell, cloth, 0.002)
                with d.grid(tray.inset(x=0.02, y=0.02).top(0.0), x=2, y=3):
                    if k % 2:
                        d.cylinder(Box.sized(0.03, 0.03, 0.012, (0.0, 0.0, -0.002)), ("gold", "silver")[k % 4 // 2])
                    else:
                        d.box(Box.sized(0.02, 0.035, 0.014, (0.0, 0.0, -0.002)), "gold", 0.004)
    with d.part("top"):
        top = d.box(box.top(0.014), "glass", 0.0)
    d.surface("top", top, inset=0.02)


@draws("checkout_lane")
def checkout_lane(d: Drawing) -> None:
    """A supermarket's checkout: a belt, a scanner, a place to pack, and a till on the cashier's side."""
    body = d.material("body", "light grey paint, red paint, green paint, blue paint, white paint")
    box, steel = d.bounds.to(z=(0.0, 0.9)), "brushed steel"
    lane = box.to(x=(box.x[0] + 0.3 * box.depth, box.x[1]))
    with d.part("body"):
        d.box(lane.bottom(0.1).inset(x=0.04, y=0.04), "black plastic", 0.0)
        d.box(lane.inset(bottom=0.1, top=0.04), body, 0.003)
        d.box(lane.front(0.012).inset(front=0.0, y=0.02).share(z=(0.35, 0.45)), "black plastic", 0.0)
    with d.part("top"):
        top = d.box(lane.top(0.04), steel, 0.002)
        belt = top.share(y=(0.42, 0.98)).inset(x=0.06)
        d.print(belt.top(0.0), "rubber")
        d.print(top.share(x=(0.3, 0.7), y=(0.3, 0.38)).top(0.0), "black glass")
    with d.part("desk"):
        desk = box.to(x=(box.x[0], lane.x[0])).share(y=(0.08, 0.36))
        d.box(desk.to(z=(0.0, 0.78)), body, 0.003)
        till = desk.to(z=(0.78, 0.9)).inset(all=0.03, bottom=-0.03)
        d.box(till, "black plastic", 0.004)
    with d.part("pole"):
        x, y, _ = lane.anchor("back")
        d.bar((x + 0.04, y + 0.02, 0.88), (x + 0.04, y + 0.02, d.bounds.z[1] - 0.2), 0.015, steel)
        d.box(Box.around((x + 0.04, y + 0.02, d.bounds.z[1] - 0.1), 0.06, 0.2, 0.2), "lamp glow", 0.01)
    d.surface("belt", top.share(y=(0.5, 0.96)), inset=0.05)
    d.surface("packing", top.share(y=(0.03, 0.26)), inset=0.03)
    d.fit()
