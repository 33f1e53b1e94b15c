"""Bins: open or swing topped, with a pedal, in a row for sorting."""

from __future__ import annotations

from ... import shapes
from ...drawing import Box, Drawing, draws
from ...drawing.components import CORNERS, lip, open_box, oval, vessel


@draws("trash_can")
def trash_can(d: Drawing) -> None:
    """A tapered bucket with a bag turned over its rim, or a tall one with a swing lid."""
    names = ("black plastic", "brushed steel", "white plastic", "grey plastic", "green plastic", "black steel")
    body = d.material("body", *names, "blue plastic")
    bounds = d.bounds
    if d.request.shape == "open":
        open_box(d, bounds, body, 0.006, 0.1 * bounds.depth)
        d.fit()
        return
    square = d.chance("square", 0.4)

    def ring(share: float, z: float):
        own = bounds.inset(x=(1 - share) / 2 * bounds.depth, y=(1 - share) / 2 * bounds.width)
        return shapes.rectangle(own.x, own.y, z, 0.25 * min(own.size[:2]) / 2) if square else oval(own, z)

    h = bounds.height
    with d.part("bin"):
        if h > 0.5:
            rim = h - 0.17
            d.loft([ring(0.80, 0.0), ring(0.82, 0.012), ring(0.955, rim)], body, convex=True)
            d.loft([ring(0.985, rim), ring(1.0, rim + 0.012), ring(1.0, rim + 0.05)], "black plastic", convex=True)
            d.loft([ring(0.98, rim + 0.05), ring(0.62, h - 0.008), ring(0.55, h)], body, convex=True)
            # The flap, in a slope of the hood.
            slope = ((0.36, rim + 0.065), (0.30, rim + 0.10), (0.485, rim + 0.05), (0.335, h - 0.03))
            width = 0.2 * bounds.width
            flap = [(share * bounds.depth, y, z) for share, z in slope for y in (-width, width)]
            d.hull(flap, "grey plastic")
        else:
            wall = 0.012 / min(bounds.size[:2])
            outer = [ring(0.76, 0.0), ring(0.97, h - 0.02), ring(1.0, h - 0.018), ring(1.0, h)]
            vessel(d, outer, [ring(1.0 - 2.5 * wall, h), ring(0.76 - wall, 0.012)], body, 16 if square else 32)
            if d.chance("bag", 0.5):  # a liner folded down outside hides the rim
                d.loft([ring(0.72, 0.35 * h), ring(0.79, 0.36 * h)], "white plastic", convex=True)
            else:
                d.loft([ring(0.70, 0.02), ring(0.76, 0.12 * h)], "paper", convex=True)
    d.fit()


@draws("pedal_bin")
def pedal_bin(d: Drawing) -> None:
    """A steel drum with a domed lid, a pedal in front and a dark foot."""
    names = ("brushed steel", "white steel", "black steel", "copper", "red paint", "sage paint", "cream paint")
    body, dark = d.material("body", *names), "black plastic"
    drum = d.bounds.inset(front=0.06)
    square = d.chance("square", 0.3)
    h, rim = drum.height, drum.height - (0.055 if square else 0.09)

    def ring(share: float, z: float):
        own = drum.inset(x=(1 - share) / 2 * drum.depth, y=(1 - share) / 2 * drum.width)
        return shapes.rectangle(own.x, own.y, z, 0.04) if square else oval(own, z)

    with d.part("bin"):
        d.loft([ring(1.0, 0.0), ring(1.0, 0.045)], dark)
        sides = [ring(0.985, 0.045), ring(0.985, rim - 0.006), ring(1.0, rim - 0.006), ring(1.0, rim + 0.008)]
        less = 0.985 - 0.016 / drum.width
        vessel(d, sides, [ring(less, rim + 0.008), ring(less, 0.055)], body, CORNERS if square else 16)
        # As high as the lid: nothing of it goes behind the bin, where a wall is.
        hinge = (drum.x[0] + 0.0075 * drum.depth, 0.0, h)
        with d.hinge("lid", hinge, axis=(0.0, 1.0, 0.0), limits=(-1.3, 0.0), role="lid"):
            dome = ((0.99, 0.0), (0.98, 0.25), (0.9, 0.6), (0.72, 0.86), (0.4, 1.0))
            flat = ((0.99, 0.0), (0.985, 0.74), (0.94, 1.0))
            low = rim + 0.0085
            d.loft([ring(s, low + z * (h - low)) for s, z in (flat if square else dome)], body, convex=True)
            lip(d, drum.front(-0.025).inset(back=-0.004).place(width=0.05).to(z=(low + 0.001, low + 0.013)), dark)
        pedal = Box((drum.x[1] - 0.03, d.bounds.x[1]), (-0.035, 0.035), (0.006, 0.03))
        ends = ((pedal.x[0], 0.012), (pedal.x[0], 0.03), (pedal.x[1], 0.006), (pedal.x[1], 0.018))
        d.hull([(x, y, z) for x, z in ends for y in pedal.y], body if body.metallic else "chrome")
        d.box(drum.back(0.02).place(width=0.1).to(z=(rim - 0.06, rim + 0.006)), dark, bevel=0.0)
    d.fit()


@draws("recycling_bin")
def recycling_bin(d: Drawing) -> None:
    """Two to four bins side by side in a frame, each with a lid and a label of its colour."""
    body = d.material("body", "grey plastic", "black plastic", "white plastic", "brushed steel")
    bounds = d.bounds
    count = 2 if bounds.width < 0.82 else 3 if bounds.width < 1.05 else 4
    colors = ["blue plastic", "yellow plastic", "green plastic", "red plastic"]
    first, rim = d.integer("first", 0, 3), bounds.height - 0.06
    with d.part("bin"):
        for k, cell in enumerate(bounds.columns(count, gap=0.008)):
            color = colors[(k + first) % 4]
            foot, head = cell.inset(x=0.05 * cell.depth, y=0.07 * cell.width), cell.inset(x=0.012, y=0.004)

            def at(share: float, y: float, out: float, cell=cell, foot=foot, head=head) -> tuple[float, float, float]:
                """A point on the sloping front: at a share of its height, y from its middle, and so far out of it."""
                x = foot.x[1] + share * (head.x[1] - foot.x[1])
                return x + out, cell.center[1] + y, share * rim

            plans = [cell.to(x=b.x, y=b.y) for b in (foot, head)]
            outer = [shapes.rectangle(b.x, b.y, z, 0.001, 1) for b, z in zip(plans, (0.0, rim), strict=True)]
            walls = [(plan.inset(x=0.008, y=0.008), z) for plan, z in zip(plans[::-1], (rim, 0.012), strict=True)]
            inner = [shapes.rectangle(b.x, b.y, z, 0.001, 1) for b, z in walls]
            vessel(d, outer, inner, body, range(0, len(outer[0]) + 1, 2))
            hinge = (cell.x[0], cell.center[1], bounds.z[1])
            with d.hinge(f"lid-{k}", hinge, axis=(0.0, 1.0, 0.0), limits=(-1.2, 0.0), role="lid"):
                low, high = rim + 0.001, bounds.z[1]
                profile = ((cell.x[0], low), (cell.x[0], high), (0.1 * cell.depth, high), (cell.x[1], low + 0.021))
                d.hull([(x, y, z) for x, z in (*profile, (cell.x[1], low)) for y in cell.y], color)
                lip(d, cell.front(-0.022).place(width=0.1).to(z=(low + 0.002, low + 0.017)), color)
            labels = ((0.26, 0.55, 0.78, 0.0015, color), (0.12, 0.61, 0.72, 0.003, "white plastic"))
            for width, low, high, out, look in labels:
                sides = (-width * cell.width, width * cell.width)
                d.hull([at(s, y, o) for s in (low, high) for y in sides for o in (-0.004, out)], look)
    d.fit()
