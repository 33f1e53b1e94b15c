"""Desks: tables with room for knees at the front (+x) and a back that goes to the wall."""

from __future__ import annotations

from ...body import Material
from ..builder import Builder, Interval
from ..joinery import drawer
from ..registry import draws
from .tables_parts import corner_legs, end_frame, planks, rounded, tabletop

BOARDS = ("oak", "light oak", "walnut", "white paint", "birch", "ash grey wood", "wenge")
METALS = ("black steel", "white steel", "brushed steel", "iron")


def drawer_stack(
    b: Builder,
    x: Interval,
    y: Interval,
    z: Interval,
    body: Material,
    front: Material,
    pull: Material,
    count: int,
    style: str,
    name: str = "drawer",
    tall_last: bool = False,
) -> None:
    """A closed pedestal of drawers with fronts at x[1]; its body is one block in one prism."""
    face = x[1] - 0.018
    with b.solid(f"{name} stack"):
        b.box((x[0], face - 0.0005), y, z, body, bevel=0.002)
    shares = [1.0] * count
    if tall_last and count > 2:
        shares[-1] = 1.8
    at, total = z[1], sum(shares)
    for k, share in enumerate(shares):
        low = at - (z[1] - z[0]) * share / total
        with b.solid(f"{name} stack"):
            drawer(b, f"{name}-{k}", (x[0] + 0.02, x[1]), y, (low, at), front, pull, style)
        at = low


@draws("desk")
def desk(b: Builder) -> None:
    """A top on steel or wooden legs, panel ends with a modesty board, or with one or two stacks of drawers."""
    d, w, h = b.size
    kind = b.pick("kind", ["legs", "loop", "drawers", "panel", "thin drawers", "a"])
    twin = kind == "drawers" and w > 1.5
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", *BOARDS)
    thick = b.uniform("thickness", 0.022, 0.03)
    low = h - thick
    pull = b.material("pulls", "black steel", "brass", "brushed steel")
    style = b.pick("pull style", ["bar", "knob", "cup"])
    inner: Interval = (y[0] + 0.06, y[1] - 0.06)
    with b.solid("top"):
        if kind == "a" and b.chance("boards", 0.6):
            planks(b, x, y, (low, h), top, wide=0.16)
        else:
            tabletop(b, rounded(x, y, b.pick("corner", [0.008, 0.03, 0.05]), 3), (low, h), top)
    if kind == "legs":
        wooden = b.chance("wooden", 0.5)
        legs = b.material("legs", "oak", "beech", "walnut", "birch") if wooden else b.material("legs", *METALS)
        corner_legs(
            b,
            (x[0] + 0.03, x[1] - 0.03),
            (y[0] + 0.03, y[1] - 0.03),
            low,
            legs,
            b.pick("leg style", ["tapered", "splayed"] if wooden else ["square", "hairpin"]),
            0.05,
        )
        with b.solid("top"):
            b.box((x[0] + 0.08, x[0] + 0.1), (y[0] + 0.08, y[1] - 0.08), (low - 0.07, low), legs)
            for s in (-1, 1):
                b.box(
                    (x[0] + 0.08, x[1] - 0.08),
                    (s * (w / 2 - 0.09) - 0.01, s * (w / 2 - 0.09) + 0.01),
                    (low - 0.05, low),
                    legs,
                )
    elif kind in ("loop", "a"):
        legs = b.material("legs", *(METALS if kind == "loop" else ("oak", "pine", "walnut", "black paint")))
        at = w / 2 - (0.05 if kind == "loop" else 0.16)
        for s in (-1, 1):
            end_frame(b, s * at, (x[0] + 0.03, x[1] - 0.03), low, legs, kind, 0.045)
        with b.solid("rail"):
            b.box((x[0] + 0.1, x[0] + 0.13), (-at, at), (low - 0.08, low - 0.01), legs)
        inner = (-at + 0.03, at - 0.03)
    elif kind == "panel":
        side = b.material("sides", "white paint", "black paint") if b.chance("two tone", 0.3) else top
        for s in (-1, 1):
            ys = (y[1] - 0.04, y[1] - 0.015) if s > 0 else (y[0] + 0.015, y[0] + 0.04)
            with b.solid(f"side {s}"):
                b.box((x[0] + 0.015, x[1] - 0.03), ys, (0.0, low), side, bevel=0.002)
        with b.solid("modesty"):
            b.box((x[0] + 0.06, x[0] + 0.078), (y[0] + 0.04, y[1] - 0.04), (0.3, low), side, bevel=0.0015)
    elif kind == "drawers":
        front = (
            b.material("fronts", "white paint", "sage paint", "navy paint", "light grey paint")
            if b.chance("two tone", 0.35)
            else top
        )
        wide = b.uniform("stack", 0.36, 0.42)
        count = b.whole("count", 3, 4)
        sides = (-1, 1) if twin else (b.pick("side", [-1, 1]),)
        for s in (-1, 1):
            if s in sides:
                ys = (y[1] - 0.02 - wide, y[1] - 0.02) if s > 0 else (y[0] + 0.02, y[0] + 0.02 + wide)
                with b.solid(f"stack{s} stack"):
                    b.box(
                        (x[0] + 0.05, x[1] - 0.07),
                        (ys[0] + 0.02, ys[1] - 0.02),
                        (0.0, 0.05),
                        "black plastic",
                        bevel=0.0,
                    )
                drawer_stack(
                    b,
                    (x[0] + 0.02, x[1] - 0.025),
                    ys,
                    (0.05, low - 0.001),
                    top,
                    front,
                    pull,
                    count,
                    style,
                    name=f"stack{s}",
                    tall_last=True,
                )
                inner = (inner[0], ys[0]) if s > 0 else (ys[1], inner[1])
            else:
                with b.solid(f"side {s}"):
                    b.box(
                        (x[0] + 0.02, x[1] - 0.03),
                        (s * (w / 2 - 0.035) - 0.0125, s * (w / 2 - 0.035) + 0.0125),
                        (0.0, low),
                        top,
                        bevel=0.002,
                    )
        with b.solid("modesty"):
            b.box((x[0] + 0.04, x[0] + 0.056), (inner[0] - 0.005, inner[1] + 0.005), (0.25, low), top, bevel=0.0)
    else:
        legs = b.material("legs", "black steel", "brass", "oak", "walnut", "beech") if b.chance("other", 0.5) else top
        tall, count = min(0.085, low - 0.625), 3 if w > 1.5 else 2
        shell, face = (x[0] + 0.03, x[1] - 0.03), x[1] - 0.01
        with b.solid("top"):
            b.box(shell, (y[0] + 0.02, y[1] - 0.02), (low - tall, low), top, bevel=0.002)
            step = (w - 0.06) / count
            for k in range(count):
                at = y[0] + 0.03 + k * step
                drawer(
                    b,
                    f"drawer-{k}",
                    (shell[0], face),
                    (at, at + step),
                    (low - tall + 0.006, low - 0.004),
                    top,
                    pull,
                    style if style != "bar" else "knob",
                )
        corner_legs(
            b,
            (x[0] + 0.05, x[1] - 0.06),
            (y[0] + 0.05, y[1] - 0.05),
            low - tall,
            legs,
            b.pick("leg style", ["tapered", "splayed", "round"]),
            0.045,
        )
        inner = (y[0] + 0.18, y[1] - 0.18)
    b.clear((-0.1 if kind != "a" else -0.05, x[1]), (inner[0] + 0.1, inner[1] - 0.1), (0.0, 0.62))


@draws("corner_desk")
def corner_desk(b: Builder) -> None:
    """An L: a wing along the back, one along a side, panel ends, a stack of drawers at the end of the side wing."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", *BOARDS)
    low = h - 0.025
    deep, wing = b.uniform("depth", 0.6, 0.68), b.uniform("wing", 0.5, 0.58)
    s = b.pick("side", [-1, 1])
    inner = s * (w / 2 - wing)
    side: Interval = (inner, y[1]) if s > 0 else (y[0], inner)
    edge = x[0] + deep
    steel = b.chance("steel", 0.45)
    legs = b.material("legs", *METALS) if steel else top
    with b.solid("main top"):
        b.box((x[0], edge), y, (low, h), top)
    with b.solid("wing top"):
        b.box((edge, x[1]), side, (low, h), top)
    m = 0.01
    bend = s * inner + m
    ring = [
        (x[0] + m, y[0] + m),
        (edge - m, y[0] + m),
        (edge - m, bend),
        (x[1] - m, bend),
        (x[1] - m, y[1] - m),
        (x[0] + m, y[1] - m),
    ]
    if s < 0:
        ring = [(px, -py) for px, py in ring[::-1]]
    b.surface("top", (0, 0), (0, 0), h, polygon=ring)
    far = -s * (w / 2 - 0.04)
    if steel:
        end_frame(b, far, (x[0] + 0.03, edge - 0.03), low, legs, "loop", 0.045)
        with b.solid("corner leg"):
            at = s * (w / 2 - 0.06)
            b.box((x[0] + 0.03, x[0] + 0.075), (at - 0.0225, at + 0.0225), (0, low), legs)
        with b.solid("rail"):
            b.box((x[0] + 0.04, x[0] + 0.06), (-w / 2 + 0.06, w / 2 - 0.08), (low - 0.08, low - 0.005), legs)
    else:
        with b.solid("side"):
            b.box((x[0] + 0.02, edge - 0.03), (far - 0.0125, far + 0.0125), (0, low), legs, bevel=0.002)
        with b.solid("back"):
            b.box((x[0] + 0.03, x[0] + 0.048), (-w / 2 + 0.06, w / 2 - 0.03), (0.2, low), legs, bevel=0.0)
        with b.solid("wing back"):
            at = s * (w / 2 - 0.03)
            b.box((x[0] + 0.05, x[1] - 0.45), (at - 0.009, at + 0.009), (0.0, low), legs, bevel=0.0)
    pull = b.material("pulls", "black steel", "brass", "brushed steel")
    front = b.material("fronts", "white paint", "light grey paint") if b.chance("two tone", 0.3) else top
    # The stack opens toward the sitter, across the wing.
    wide = x[1] - 0.02 - 0.42
    with b.frame(wide + 0.21, s * (w / 2 - 0.02), 0, yaw=-s * 1.5707963267948966):
        drawer_stack(
            b,
            (0.0, wing - 0.05),
            (-0.21, 0.21),
            (0.03, low - 0.001),
            top,
            front,
            pull,
            3,
            b.pick("pull style", ["bar", "knob"]),
            tall_last=True,
        )
    with b.solid("drawer stack"):
        b.box((wide + 0.01, x[1] - 0.03), (side[0] + 0.08, side[1] - 0.08), (0, 0.03), "black plastic", bevel=0.0)
    b.clear((x[0] + 0.1, edge), (-w / 2 + 0.1, inner) if s > 0 else (inner, w / 2 - 0.1), (0, 0.62))
    b.clear((edge, x[1]), (-w / 2, inner - 0.02) if s > 0 else (inner + 0.02, w / 2), (0, h))


@draws("standing_desk")
def standing_desk(b: Builder) -> None:
    """A top on two telescopic columns with long feet, a cross rail, a control panel and a tray for cables."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", "oak", "white paint", "walnut", "black paint", "bamboo", "light oak")
    metal = b.material("frame", "black steel", "white steel", "grey paint")
    low = h - 0.026
    with b.solid("top"):
        tabletop(b, rounded(x, y, b.pick("corner", [0.02, 0.06]), 4), (low, h), top)
        for s in (-1, 1):
            b.box(
                (x[0] + 0.08, x[1] - 0.08),
                (s * (w / 2 - 0.25) - 0.03, s * (w / 2 - 0.25) + 0.03),
                (low - 0.03, low),
                metal,
            )
        b.box((-0.06, -0.02), (-w / 2 + 0.28, w / 2 - 0.28), (low - 0.045, low - 0.003), metal)
        b.box((x[1] - 0.05, x[1] - 0.005), (y[1] - 0.24, y[1] - 0.13), (low - 0.018, low), "black plastic", bevel=0.003)
        for k in range(4):
            at = y[1] - 0.225 + k * 0.025
            b.box(
                (x[1] - 0.006, x[1] - 0.003), (at - 0.007, at + 0.007), (low - 0.014, low - 0.006), "grey plastic", 0.0
            )
    cut = b.uniform("cut", 0.5, 0.56)
    for s in (-1, 1):
        at = s * (w / 2 - 0.25)
        with b.solid(f"foot {s}"):
            side = (
                (x[0] + 0.06, 0.012),
                (x[1] - 0.06, 0.012),
                (-0.06, 0.055),
                (0.03, 0.055),
                (x[0] + 0.06, 0.03),
                (x[1] - 0.06, 0.03),
            )
            b.hull([(px, at + py, pz) for px, pz in side for py in (-0.035, 0.035)], metal)
            for px in (x[0] + 0.09, x[1] - 0.09):
                with b.frame(px, at):
                    b.frustum(0.02, 0.02, (0, 0.012), "rubber", segments=12)
        with b.solid(f"column {s}"):
            b.box((-0.08, 0.02), (at - 0.035, at + 0.035), (0.05, cut), metal, bevel=0.004)
            b.box((-0.073, 0.013), (at - 0.029, at + 0.029), (cut, low - 0.03), metal, bevel=0.004)
    with b.solid("tray"):
        b.box((x[0] + 0.06, x[0] + 0.2), (-0.3 * w, 0.3 * w), (low - 0.09, low - 0.084), metal, bevel=0.001)
        for px in (x[0] + 0.06, x[0] + 0.195):
            high = low - 0.05 if px > x[0] + 0.1 else low
            b.box((px, px + 0.005), (-0.3 * w, 0.3 * w), (low - 0.084, high), metal, bevel=0.0)
    b.clear((0.06, x[1]), (-w / 2 + 0.35, w / 2 - 0.35), (0.0, 0.62))


@draws("school_desk")
def school_desk(b: Builder) -> None:
    """A single or double top on a frame of steel tube, with a tray for books and a hook for the bag."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    top = b.material("top", "beech", "birch", "light oak", "light grey paint", "plywood")
    metal = b.material("frame", "grey paint", "blue paint", "black steel", "red paint", "green paint", "chrome")
    low, r = h - 0.022, 0.0175
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.04, 4), (low, h), top)
        b.box((x[0] + 0.03, x[0] + 0.045), (y[0] + 0.12, y[1] - 0.12), (h - 0.002, h + 0.001), metal, bevel=0.0)
    kind = b.pick("legs", ["c", "four"])
    for s in (-1, 1):
        at = s * (w / 2 - 0.06)
        with b.solid(f"end {s}"):
            if kind == "c":
                b.bar((x[0] + 0.08, at, r), (x[1] - 0.05, at, r), r, metal, segments=12)
                b.bar((x[0] + 0.16, at, r), (x[0] + 0.14, at, low - 0.01), r, metal, segments=12)
                b.bar((x[0] + 0.05, at, low - r - 0.002), (x[1] - 0.06, at, low - r - 0.002), r, metal, segments=12)
            else:
                for px in (x[0] + 0.06, x[1] - 0.06):
                    b.bar((px, at, 0.0), (px, at, low), r, metal, segments=12)
                b.bar((x[0] + 0.06, at, low - 0.03), (x[1] - 0.06, at, low - 0.03), r * 0.8, metal, segments=10)
                b.bar((x[0] + 0.06, at, 0.1), (x[1] - 0.06, at, 0.1), r * 0.8, metal, segments=10)
    with b.solid("tray"):
        tray = (x[0] + 0.05, x[1] - 0.1)
        floor = low - 0.08
        b.box(tray, (y[0] + 0.09, y[1] - 0.09), (floor, floor + 0.008), metal, bevel=0.001)
        b.box((tray[0], tray[0] + 0.008), (y[0] + 0.09, y[1] - 0.09), (floor + 0.008, low), metal, bevel=0.0)
        for ys in ((y[0] + 0.09, y[0] + 0.098), (y[1] - 0.098, y[1] - 0.09)):
            b.box((tray[0] + 0.008, tray[1]), ys, (floor + 0.008, low), metal, bevel=0.0)
    with b.solid("rail"):
        b.bar((x[0] + 0.14, -w / 2 + 0.06, 0.36), (x[0] + 0.14, w / 2 - 0.06, 0.36), r * 0.8, metal, segments=10)
    b.bar((0.02, y[1] - 0.06, low - 0.1), (0.02, y[1] - 0.03, low - 0.115), 0.004, metal, segments=6)
    b.clear((x[0] + 0.2, x[1]), (y[0] + 0.1, y[1] - 0.1), (0.0, min(0.62, h - 0.11)))
    b.fit()


@draws("teacher_desk")
def teacher_desk(b: Builder) -> None:
    """A heavy desk with two stacks of drawers, a drawer between them, panelled back and a leather inlay."""
    d, w, h = b.size
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    wood = b.material("body", "mahogany", "walnut", "cherry", "oak", "wenge")
    pull = b.material("pulls", "brass", "bronze", "black steel")
    style = b.pick("pull style", ["knob", "cup", "bar"])
    low = h - 0.032
    with b.solid("top"):
        tabletop(b, rounded(x, y, 0.015, 3), (low, h), wood)
        if b.chance("inlay", 0.6):
            leather = b.material("inlay", "brown leather", "black leather", "green paint")
            b.box((x[0] + 0.1, x[1] - 0.06), (y[0] + 0.14, y[1] - 0.14), (h - 0.004, h + 0.001), leather, bevel=0.0)
        b.box((x[0] + 0.015, x[1] - 0.015), (y[0] + 0.015, y[1] - 0.015), (low - 0.012, low), wood, bevel=0.005)
    wide = min(0.44, 0.28 * w)
    zone = (0.07, low - 0.012)
    for s, name in ((-1, "right"), (1, "left")):
        ys = (y[1] - 0.03 - wide, y[1] - 0.03) if s > 0 else (y[0] + 0.03, y[0] + 0.03 + wide)
        drawer_stack(b, (x[0] + 0.035, x[1] - 0.035), ys, zone, wood, wood, pull, 3, style, name=name, tall_last=True)
        with b.solid(f"{name} stack"):
            b.box((x[0] + 0.025, x[1] - 0.05), (ys[0] - 0.008, ys[1] + 0.008), (0.0, 0.07), wood, bevel=0.01)
            b.box((x[0] + 0.027, x[0] + 0.035), (ys[0] + 0.05, ys[1] - 0.05), (0.13, zone[1] - 0.06), wood, bevel=0.003)
            outer = ys[1] if s > 0 else ys[0]
            b.box(
                (x[0] + 0.1, x[1] - 0.12),
                (outer, outer + 0.008) if s > 0 else (outer - 0.008, outer),
                (0.13, zone[1] - 0.06),
                wood,
                bevel=0.003,
            )
    inner = (y[0] + 0.03 + wide, y[1] - 0.03 - wide)
    with b.solid("middle"):
        b.box((x[0] + 0.1, x[1] - 0.06), inner, (zone[1] - 0.065, zone[1]), wood, bevel=0.001)
        drawer(b, "middle", (x[0] + 0.12, x[1] - 0.04), inner, (zone[1] - 0.065, zone[1]), wood, pull, style)
    with b.solid("modesty"):
        b.box((x[0] + 0.05, x[0] + 0.07), inner, (0.08, zone[1]), wood, bevel=0.0)
        b.box((x[0] + 0.042, x[0] + 0.05), (inner[0] + 0.06, inner[1] - 0.06), (0.14, zone[1] - 0.06), wood)
    b.clear((x[0] + 0.1, x[1]), (inner[0] + 0.01, inner[1] - 0.01), (0.0, 0.62))
    b.fit()
