"""What storage furniture shares: closed cases with shadow gaps, feet, grids of drawers and doors, boards."""

from __future__ import annotations

from collections.abc import Sequence

from ...body import Material
from ..builder import Builder, Interval
from ..joinery import LegStyle, drawer, legs

REACH = {"bar": 0.025, "knob": 0.025, "cup": 0.022, "none": 0.0}
SHADOW = "black paint"


def pulls(b: Builder, body: Material, *styles: str) -> tuple[str, Material, float]:
    """A style of handle, a metal that shows on the body, and how far it stands out."""
    style = b.pick("pull style", styles or ("bar", "knob", "cup"))
    metals = (
        ("brass", "brushed steel", "steel") if max(body.color) < 0.25 else ("black steel", "brass", "brushed steel")
    )
    return style, b.material("pulls", *metals), REACH[style]


def feet(b: Builder, x: Interval, y: Interval, high: float, wood: Material, style: str) -> None:
    """What a case stands on: "plinth", "bracket", or a style of legs, from the floor to ``high``."""
    if style == "plinth":
        b.box((x[0] + 0.01, x[1] - 0.04), (y[0] + 0.02, y[1] - 0.02), (0.0, high), SHADOW, bevel=0.0)
    elif style == "bracket":
        t, long = 0.02, 0.12
        for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
            b.box((x[0], x[1] - t), ys, (0.0, high), wood)
        b.box((x[1] - t, x[1]), y, (high * 0.55, high), wood)
        for ys in ((y[0], y[0] + long), (y[1] - long, y[1])):
            b.box((x[1] - t, x[1]), ys, (0.0, high * 0.55), wood, bevel=0.002)
    else:
        inset = 0.03
        kind: LegStyle = style  # type: ignore[assignment]
        legs(b, (x[0] + inset, x[1] - inset), (y[0] + inset, y[1] - inset), (0.0, high), wood, kind, 0.045)


def case(
    b: Builder, x: Interval, y: Interval, z: Interval, wood: Material, board: float = 0.018
) -> tuple[Interval, Interval, Interval]:
    """A closed box with a front rim; returns the rectangle for fronts that lie flush in it: (x, y, z)."""
    inner, rise = (y[0] + board, y[1] - board), (z[0] + board, z[1] - board)
    for ys in ((y[0], inner[0]), (inner[1], y[1])):
        b.box(x, ys, z, wood, bevel=0.0015)
    for zs in ((z[0], rise[0]), (rise[1], z[1])):
        b.box(x, inner, zs, wood, bevel=0.0015)
    b.box((x[0], x[1] - 0.022), inner, rise, wood, bevel=0.0)
    b.box((x[1] - 0.022, x[1] - 0.0195), inner, rise, SHADOW, bevel=0.0)
    return (x[0] + 0.02, x[1]), inner, rise


def top_board(b: Builder, x: Interval, y: Interval, z: Interval, wood: Material, over: float = 0.012) -> None:
    """A top that stands over its case in front and at the sides, and is a surface."""
    wide = (y[0] - over, y[1] + over)
    b.box((x[0], x[1] + over), wide, z, wood, bevel=0.004)
    b.surface("top", (x[0] + 0.01, x[1] + over - 0.01), (wide[0] + 0.01, wide[1] - 0.01), z[1])


def cornice(b: Builder, x: Interval, y: Interval, z: Interval, wood: Material, over: float = 0.03) -> None:
    """A stepped moulding on top of a case."""
    for k in range(3):
        out = over * (k + 1) / 3
        low = z[0] + k * (z[1] - z[0]) / 3
        b.box((x[0], x[1] + out), (y[0] - out, y[1] + out), (low, low + (z[1] - z[0]) / 3), wood, bevel=0.002)


def drawer_stack(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    rows: Sequence[float],
    columns: Sequence[int],
    front: Material,
    pull: Material,
    style: str,
    name: str = "drawer",
) -> None:
    """Rows of drawers from the foot up with these shares of the height, each in so many columns."""
    total, low, number = sum(rows), z[0], 0
    for share, count in zip(rows, columns, strict=True):
        high = low + share / total * (z[1] - z[0])
        step = (y[1] - y[0]) / count
        for k in range(count):
            drawer(b, f"{name}-{number}", x, (y[0] + k * step, y[0] + (k + 1) * step), (low, high), front, pull, style)
            number += 1
        low = high


def split(span: Interval, count: int, gap: float = 0.0) -> list[Interval]:
    """An interval cut into equal parts with gaps between them."""
    step = (span[1] - span[0] + gap) / count
    return [(span[0] + k * step, span[0] + (k + 1) * step - gap) for k in range(count)]
