"""The bodies of what is not known: plain shapes of typical size, each class with a form of its own."""

from __future__ import annotations

from ...drawing import Drawing, draws
from ...drawing.components import legs


@draws("object")
def unknown(d: Drawing) -> None:
    """A plain block with cut edges and a band around it, so that nobody takes it for furniture."""
    box, thick = d.bounds, min(0.002, 0.1 * min(d.bounds.size[:2]))
    look = d.material("body", "cardboard, light grey paint, beige fabric")
    with d.part("all"):
        d.box(box.inset(x=thick, y=thick), look, 0.04 * min(d.size))
        d.box(box.share(z=(0.42, 0.58)), "grey plastic", bevel=0.0)
    d.surface("top", box.share((0.1, 0.9), (0.1, 0.9)))


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
