"""The bodies of what is not known: plain shapes of typical size, each class with a form of its own."""

from __future__ import annotations

import math

from ...drawing import Drawing, draws
from ...drawing.components import legs

PLAIN = "light grey paint, beige fabric, cardboard, sage paint, grey plastic, white plastic"


@draws("object")
def unknown(d: Drawing) -> None:
    """A plain block with cut edges and a band around it, so that nobody takes it for furniture."""
    box, thick = d.bounds, min(0.002, 0.1 * min(d.bounds.size[:2]))
    look = d.material("body", "cardboard, light grey paint, beige fabric")
    with d.part("all"):
        d.box(box.inset(x=thick, y=thick), look, 0.04 * min(d.size))
        d.box(box.share(z=(0.42, 0.58)), "grey plastic", bevel=0.0)
    d.surface("top", box.share((0.1, 0.9), (0.1, 0.9)))


@draws("generic_item", "generic_device", whole=True)
def device(d: Drawing) -> None:
    """A case with a darker panel in front."""
    d.box(d.bounds.inset(front=0.006), d.material("body", PLAIN), 0.05 * min(d.size))
    d.box(d.bounds.front(0.008).share(y=(0.06, 0.94), z=(0.12, 0.88)), d.material("front", "grey plastic"), 0.002)


@draws("generic_tool", whole=True)
def tool(d: Drawing) -> None:
    """A handle and a head that is broader."""
    d.box(d.bounds.share((0.2, 0.8), (0.0, 0.65), (0.1, 0.7)), d.material("body", "black plastic, oak"), 0.004)
    d.box(d.bounds.share(y=(0.62, 1.0)), d.material("head", "brushed steel"))


@draws("generic_figure", whole=True)
def figure(d: Drawing) -> None:
    """A body and a head on a round base."""
    profile = [(1.0, 0.0), (1.0, 0.08), (0.84, 0.1), (0.8, 0.3), (0.6, 0.56), (0.32, 0.66), (0.48, 0.78), (0.44, 0.9)]
    d.turned(d.bounds, [*profile, (0.16, 1.0)], d.material("body", "white ceramic, terracotta, grey ceramic, oak"))


@draws("generic_vessel", whole=True, even="round")
def vessel(d: Drawing) -> None:
    """A round vessel with a lid."""
    profile = [(0.68, 0.0), (1.0, 0.3), (0.96, 0.62), (0.72, 0.8), (0.76, 0.86), (0.4, 0.94), (0.12, 1.0)]
    d.turned(d.even("round"), profile, d.material("body", "white ceramic, blue ceramic, grey ceramic, terracotta"))


@draws("generic_soft", whole=True)
def soft(d: Drawing) -> None:
    """A cushion."""
    d.cushion(d.bounds, d.material("body", "@fabric"), radius=0.05, puff=0.6)


@draws("generic_sheet", "generic_mat", whole=True)
def sheet(d: Drawing) -> None:
    """A flat board or a mat."""
    mat = d.category.name == "generic_mat"
    look = d.material("body", "@fabric, rubber" if mat else "paper, cardboard, oak")
    d.slab(d.bounds, look, 0.03 if mat else 0.006)


@draws("generic_machine", "generic_furniture")
def cabinet(d: Drawing) -> None:
    """A case on a plinth with a front panel."""
    box = d.bounds
    look = d.material("body", "light grey paint, white paint, grey paint, sage paint")
    with d.part("all"):
        d.box(box.inset(y=0.02, back=0.02, front=0.05).bottom(0.08), "black plastic", bevel=0.0)
        body = d.box(box.inset(bottom=0.08, front=0.01), look, 0.01)
        front = body.front(-0.01).inset(back=-0.002, y=0.08 * box.width, bottom=0.06, top=0.1 * box.height)
        d.box(front, d.material("front", "grey plastic"))
    d.surface("top", box.share((0.04, 0.94), (0.04, 0.96)))


@draws("generic_table")
def table(d: Drawing) -> None:
    """A top on four legs."""
    body = d.material("body", "@wood, white paint")
    top = d.bounds.top(0.035)
    with d.part("top"):
        d.box(top, body, bevel=0.004)
    with d.part("legs"):
        legs(d, d.bounds.inset(x=0.025, y=0.025, top=0.035), body, width=0.05)
    d.surface("top", top.share((0.02, 0.98), (0.02, 0.98)))


@draws("generic_stand")
def stand(d: Drawing) -> None:
    """A post on a foot, with a plate on it."""
    body = d.material("body", "black steel, oak, white steel, brass")
    box, side = d.bounds, 0.7 * min(d.size[:2])
    plate = box.top(0.02).place(side, side)
    with d.part("foot"):
        d.box(box.bottom(0.03), body, bevel=0.005)
    with d.part("post"):
        d.cylinder(box.inset(bottom=0.03, top=0.02).place(0.17 * side, 0.17 * side), body, segments=16)
    with d.part("plate"):
        d.box(plate, body)
    d.surface("top", plate, inset=0.03 * side)


@draws("generic_rack")
def rack(d: Drawing) -> None:
    """Four posts and three boards."""
    body = d.material("body", "black steel, white steel, oak, pine")
    legs(d, d.bounds, body, width=0.03)
    room = d.bounds.inset(x=0.03, y=0.03)
    for k, level in enumerate(room.inset(bottom=0.1).rows(3)):
        board = level.bottom(0.018).move(z=-0.018)
        with d.part(f"board{k}"):
            d.box(board, body, bevel=0.001)
        d.surface(f"board-{k}", board, None if k == 2 else level.height - 0.018, inset=0.005)


@draws("generic_panel", whole=True)
def panel(d: Drawing) -> None:
    """A board in a frame."""
    d.box(d.bounds.share(x=(0.0, 0.8)), d.material("frame", "oak, black paint, white paint"))
    d.box(d.bounds.share((0.7, 1.0), (0.04, 0.96), (0.05, 0.95)), d.material("body", "chalk pigment, paper"), 0.001)


@draws("generic_fixture", whole=True)
def fixture(d: Drawing) -> None:
    """A box on a plate."""
    body = d.material("body", "white plastic, grey plastic, light grey paint, brushed steel")
    d.box(d.bounds.share(x=(0.0, 0.1)), body)
    d.box(d.bounds.share((0.08, 1.0), (0.1, 0.9), (0.12, 0.88)), body, bevel=0.01)


@draws("generic_hanging", whole=True)
def hanging(d: Drawing) -> None:
    """A body on a cord."""
    body = d.material("body", "oak, white plastic, brass, paper")
    box, r = d.bounds, min(d.size[:2]) / 2
    d.cylinder(box.top(0.02).place(0.32 * r, 0.32 * r), "white plastic", segments=16)
    d.bar((0, 0, 0.5 * box.height), (0, 0, box.height - 0.01), 0.004, "black plastic", 8)
    turns = [k * math.pi / 8 for k in range(9)]
    ball = [(max(0.02, math.sin(a)), 0.5 * (1 - math.cos(a))) for a in turns]
    d.turned(box.bottom(0.52 * box.height), ball, body)
