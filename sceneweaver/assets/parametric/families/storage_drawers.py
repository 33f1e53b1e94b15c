"""Chests of drawers, sideboards and other closed cases."""

from __future__ import annotations

from ...drawing import Drawing
from ...drawing.components import board_top, carcass, drawers
from ...drawing.components import feet as nfeet
from ...drawing.components import pulls as npulls
from ..builder import Builder
from ..joinery import door, handle
from ..registry import draws
from .storage_parts import REACH, case, cornice, drawer_stack, feet, pulls, split, top_board

WOODS = ("oak", "walnut", "white paint", "light oak", "pine", "cherry", "sage paint", "ash grey wood")


@draws("dresser")
def dresser(d: Drawing) -> None:
    """Three or four rows of drawers, lower ones higher, under a top that stands over them."""
    wood = d.material("body", *WOODS)
    fronts = d.material("fronts", "white paint", "oak", "navy paint") if d.chance("two tone", 0.35) else wood
    style, pull, reach = npulls(d, wood)
    base = d.pick("base", ["plinth", "bracket", "tapered", "splayed"])
    foot = {"plinth": 0.06, "bracket": 0.1}.get(base, 0.14)
    case = d.bounds.inset(front=max(reach, 0.01), y=0.01)
    with d.part("body"):
        nfeet(d, case.bottom(foot), wood, base)
        room = carcass(d, case.inset(bottom=foot, top=0.022), wood)
        board_top(d, case.top(0.022), wood, 0.01)
        rows = 3 if case.height < 0.85 else 4
        columns = 1 if case.width < 1.0 else 2
        head = columns if case.width < 0.8 else columns + 1
        weights = [1.25] * (rows - 2) + [1.1, 0.8]
        drawers(d, room, weights, fronts, pull, style, [columns] * (rows - 1) + [head])


@draws("tallboy")
def tallboy(b: Builder) -> None:
    """A narrow, high chest of five to seven drawers."""
    d, w, h = b.size
    wood = b.material("body", *WOODS)
    style, pull, reach = pulls(b, wood)
    base = b.pick("base", ["plinth", "bracket", "tapered"])
    foot, over = (0.06 if base == "plinth" else 0.1), 0.01
    x, y = (-d / 2, d / 2 - max(reach, over)), (-w / 2 + over, w / 2 - over)
    with b.solid("body"):
        feet(b, x, y, foot, wood, base)
        inside = case(b, x, y, (foot, h - 0.022), wood)
        top_board(b, x, y, (h - 0.022, h), wood, over)
        rows = b.whole("rows", 5, 7)
        drawer_stack(b, *inside, [1.2, 1.2, *[1.0] * (rows - 3), 0.8], [1] * rows, wood, pull, style)


@draws("sideboard")
def sideboard(b: Builder) -> None:
    """A long low case with doors and a stack of drawers."""
    d, w, h = b.size
    wood = b.material("body", "walnut", "oak", "white paint", "light oak", "black paint", "mahogany")
    fronts = b.material("fronts", "white paint", "rattan", "teal paint") if b.chance("two tone", 0.3) else wood
    style, pull, reach = pulls(b, wood, "bar", "knob")
    base = b.pick("base", ["tapered", "splayed", "square", "plinth"])
    foot, over = (0.06 if base == "plinth" else min(0.2, 0.25 * h)), 0.006
    x, y = (-d / 2, d / 2 - max(reach, over)), (-w / 2 + over, w / 2 - over)
    with b.solid("body"):
        feet(b, x, y, foot, wood, base)
        fx, fy, fz = case(b, x, y, (foot, h - 0.024), wood)
        top_board(b, x, y, (h - 0.024, h), wood, over)
        count = 3 if w < 1.5 else 4
        parts = split(fy, count, 0.018)
        drawers = b.whole("drawer place", 0, count - 1)
        for k, ys in enumerate(parts):
            if k:
                b.box((x[1] - 0.0195, x[1]), (ys[0] - 0.018, ys[0]), fz, wood, bevel=0.001)
            if k == drawers:
                drawer_stack(b, fx, ys, fz, [1.2, 1.0, 0.9], [1, 1, 1], fronts, pull, style)
            else:
                door(
                    b,
                    f"door-{k}",
                    (x[1] - 0.018, x[1]),
                    ys,
                    fz,
                    fronts,
                    pull,
                    hung="right" if k < drawers else "left",
                    style=style,
                )


@draws("cabinet")
def cabinet(b: Builder) -> None:
    """One or two framed doors, often with drawers over them."""
    d, w, h = b.size
    wood = b.material("body", *WOODS)
    style, pull, reach = pulls(b, wood, "bar", "knob")
    base = b.pick("base", ["plinth", "bracket", "tapered", "square"])
    foot, over = (0.06 if base == "plinth" else 0.11), 0.01
    x, y = (-d / 2, d / 2 - max(reach, over)), (-w / 2 + over, w / 2 - over)
    framed = b.chance("framed", 0.6)
    with b.solid("body"):
        feet(b, x, y, foot, wood, base)
        fx, fy, fz = case(b, x, y, (foot, h - 0.022), wood)
        top_board(b, x, y, (h - 0.022, h), wood, over)
        split_at = fz[1]
        if b.chance("drawers", 0.5):
            split_at -= 0.16
            drawer_stack(b, fx, fy, (split_at, fz[1]), [1.0], [1 if w < 0.7 else 2], wood, pull, style)
        count = 1 if w < 0.5 else 2
        for k, ys in enumerate(split(fy, count)):
            door(
                b,
                f"door-{k}",
                (x[1] - 0.018, x[1]),
                ys,
                (fz[0], split_at),
                wood,
                pull,
                hung="right" if k == 0 else "left",
                style=style,
                panel=wood if framed else None,
            )


@draws("linen_cabinet")
def linen_cabinet(b: Builder) -> None:
    """A tall closed cupboard: doors over two deep drawers, with a cornice."""
    d, w, h = b.size
    wood = b.material("body", "white paint", "cream paint", "oak", "pine", "sage paint")
    style, pull, reach = pulls(b, wood, "knob", "bar")
    x, y = (-d / 2, d / 2 - max(reach, 0.02)), (-w / 2 + 0.02, w / 2 - 0.02)
    with b.solid("body"):
        feet(b, x, y, 0.09, wood, "bracket")
        fx, fy, fz = case(b, x, y, (0.09, h - 0.05), wood)
        cornice(b, x, y, (h - 0.05, h), wood, 0.02)
        middle = fz[0] + 0.42
        drawer_stack(b, fx, fy, (fz[0], middle), [1.0, 1.0], [1, 1], wood, pull, style)
        for k, ys in enumerate(split(fy, 1 if w < 0.6 else 2)):
            for j, zs in enumerate(split((middle, fz[1]), 1 if h < 1.75 else 2)):
                door(
                    b,
                    f"door-{k}-{j}",
                    (x[1] - 0.018, x[1]),
                    ys,
                    zs,
                    wood,
                    pull,
                    hung="right" if k == 0 else "left",
                    style=style,
                    panel=wood,
                )
    b.surface("top", (x[0] + 0.02, x[1]), (y[0] + 0.01, y[1] - 0.01), h)


@draws("shoe_cabinet")
def shoe_cabinet(b: Builder) -> None:
    """Shallow, with tilting flaps."""
    d, w, h = b.size
    wood = b.material("body", "white paint", "oak", "light grey paint", "walnut", "black paint")
    style, pull, reach = pulls(b, wood, "bar", "knob", "cup")
    x, y = (-d / 2, d / 2 - reach), (-w / 2, w / 2)
    with b.solid("body"):
        feet(b, x, y, 0.05, wood, "plinth")
        fx, fy, fz = case(b, x, y, (0.05, h - 0.02), wood)
        top_board(b, x, y, (h - 0.02, h), wood, 0.0)
        columns = split(fy, 1 if w < 0.75 else 2)
        rows = split(fz, 2 if h < 0.9 else 3)

        for k, ys in enumerate(columns):
            for j, zs in enumerate(rows):
                with b.hinge(f"flap-{k}-{j}", (x[1], 0.0, zs[0]), axis=(0.0, 1.0, 0.0), limits=(0.0, 0.8)):
                    b.box((x[1] - 0.018, x[1]), (ys[0] + 0.003, ys[1] - 0.003), (zs[0] + 0.003, zs[1] - 0.003), wood)
                    handle(b, x[1], (ys[0] + ys[1]) / 2, zs[1] - 0.05, pull, style, 0.12)


@draws("filing_cabinet")
def filing_cabinet(b: Builder) -> None:
    """A steel case of two to four deep drawers with label holders."""
    d, w, h = b.size
    steel = b.material("body", "grey paint", "light grey paint", "black paint", "white paint", "green paint")
    pull = b.material("pulls", "brushed steel", "chrome")
    reach = REACH["bar"]
    x, y = (-d / 2, d / 2 - reach), (-w / 2, w / 2)
    rows = max(2, min(5, round((h - 0.05) / 0.32)))
    with b.solid("body"):
        feet(b, x, y, 0.03, steel, "plinth")
        fx, fy, fz = case(b, x, y, (0.03, h), steel, 0.015)

        for k, zs in enumerate(split(fz, rows)):
            with b.slide(f"drawer-{k}", limits=(0.0, round(0.8 * d, 3))):
                b.box((x[1] - 0.018, x[1]), (fy[0] + 0.002, fy[1] - 0.002), (zs[0] + 0.003, zs[1] - 0.003), steel)
                high = zs[0] + 0.62 * (zs[1] - zs[0])
                handle(b, x[1], 0.0, high, pull, "bar", 0.14)
                with b.frame(x[1], 0.0, high + 0.05):
                    b.box((0.0, 0.003), (-0.045, 0.045), (-0.018, 0.018), pull, bevel=0.001)
                    b.box((0.003, 0.0035), (-0.038, 0.038), (-0.012, 0.012), "paper", bevel=0.0)
        if b.chance("lock", 0.7):
            b.box((x[1], x[1] + 0.004), (fy[1] - 0.01, fy[1] + 0.008), (h - 0.013, h - 0.003), pull, bevel=0.001)
    b.surface("top", (x[0] + 0.01, x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), h)
