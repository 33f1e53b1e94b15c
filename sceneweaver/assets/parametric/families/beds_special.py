"""Bunk, loft, wall, hospital and baby beds, and massage tables."""

from __future__ import annotations

import math

from ... import shapes
from ..builder import Builder, Interval
from ..registry import draws
from .beds_parts import SHEETS, bedding, ladder, slats
from .seating_parts import pillow, ring_shape, square_leg

_WOODS = ("pine", "white paint", "oak", "birch", "light grey paint", "ash grey wood")


def _span(a: float, c: float) -> Interval:
    return (min(a, c), max(a, c))


def _posts(b: Builder, x, y, high: float, size: float, wood) -> None:
    for i, cx in enumerate((x[0] + size / 2, x[1] - size / 2)):
        for cy in (y[0] + size / 2, y[1] - size / 2):
            with b.solid(f"post {i}"):
                b.box((cx - size / 2, cx + size / 2), (cy - size / 2, cy + size / 2), (0.0, high), wood, bevel=0.005)


def _end(b: Builder, xs, y, z, wood, group: str) -> None:
    """The end of a bunk between its posts: a rail above, one below, upright bars between."""
    with b.solid(group):
        b.box(xs, y, (z[1] - 0.07, z[1]), wood)
        b.box(xs, y, (z[0], z[0] + 0.06), wood)
        slats(b, xs, y, (z[0] + 0.05, z[1] - 0.06), wood, 0.13, 0.02)


@draws("bunk_bed")
def bunk_bed(b: Builder) -> None:
    """Two beds one above the other with guard rails and a ladder at the left side."""
    d, w, h = b.size
    wood = b.material("frame", *_WOODS)
    t = 0.055
    x, y = (-d / 2, d / 2), (-w / 2, w / 2 - 0.1)
    low, high = 0.3, h - 0.3
    _posts(b, x, y, h, t, wood)
    inner = (y[0] + t, y[1] - t)
    for px, name in ((x[0], "post 0"), (x[1] - t, "post 1")):
        xs = (px + 0.014, px + t - 0.014)
        _end(b, xs, inner, (low - 0.06, low + 0.36), wood, name)
        _end(b, xs, inner, (high - 0.06, h - 0.02), wood, name)
    long = (x[0] + t, x[1] - t)
    for level, name in ((low, "lower"), (high, "upper")):
        with b.solid(name):
            for ys in ((y[0] + 0.014, y[0] + t - 0.014), (y[1] - t + 0.014, y[1] - 0.014)):
                b.box(long, ys, (level - 0.07, level + 0.07), wood)
            b.box(long, (y[0] + t - 0.014, y[1] - t + 0.014), (level - 0.03, level - 0.01), wood, bevel=0.002)
    rung = (x[1] - t - 0.5, x[1] - t - 0.12)
    for ys, ends, name in (
        ((y[0] + 0.015, y[0] + t - 0.015), long, "guard back"),
        ((y[1] - t + 0.015, y[1] - 0.015), (long[0], rung[0]), "guard"),
    ):
        with b.solid(name):
            for z in (h - 0.075, h - 0.16):
                b.box(ends, ys, (z, z + 0.055), wood)
            if ends is not long:
                b.box((ends[1] - 0.05, ends[1]), ys, (high + 0.06, h - 0.02), wood)
    bed = (y[0] + t - 0.008, y[1] - t + 0.008)
    bedding(
        b, (long[0] + 0.005, long[1] - 0.005), bed, (low - 0.012, low + 0.13), "lower", 1, low + 0.02, None, thick=0.11
    )
    bedding(
        b,
        (long[0] + 0.005, long[1] - 0.005),
        bed,
        (high - 0.012, high + 0.11),
        "upper",
        1,
        high + 0.02,
        None,
        thick=0.1,
    )
    with b.solid("ladder"):
        ladder(b, rung, y[1] - 0.004, (0.0, h - 0.06), wood, 0.045, 5)
    b.fit()


@draws("loft_bed")
def loft_bed(b: Builder) -> None:
    """A bed on high posts with guard rails and a ladder; the room below stays free."""
    d, w, h = b.size
    metal = b.chance("metal", 0.35)
    wood = b.material("frame", "black steel", "white steel", "brushed steel") if metal else b.material("frame", *_WOODS)
    t = 0.04 if metal else 0.065
    x, y = (-d / 2, d / 2), (-w / 2, w / 2 - 0.11)
    bed_z = h - 0.36
    for i, cx in enumerate((x[0] + t / 2, x[1] - t / 2)):
        for j, cy in enumerate((y[0] + t / 2, y[1] - t / 2)):
            with b.solid(f"post {i} {j}"):
                b.box((cx - t / 2, cx + t / 2), (cy - t / 2, cy + t / 2), (0.0, h), wood, bevel=0.005)
    inner, long = (y[0] + t, y[1] - t), (x[0] + t, x[1] - t)
    a = 0.25 * t
    with b.solid("bed"):
        for ys in ((y[0] + a, y[0] + t - a), (y[1] - t + a, y[1] - a)):
            b.box(long, ys, (bed_z - 0.08, bed_z + 0.07), wood)
        for xs in ((x[0] + a, x[0] + t - a), (x[1] - t + a, x[1] - a)):
            b.box(xs, inner, (bed_z - 0.08, bed_z + 0.07), wood)
        b.box(long, (y[0] + t - a, y[1] - t + a), (bed_z - 0.03, bed_z - 0.01), wood, bevel=0.002)
        rung = (x[1] - t - 0.52, x[1] - t - 0.12)
        for ys, ends in (((y[0] + a, y[0] + t - a), long), ((y[1] - t + a, y[1] - a), (long[0], rung[0]))):
            for z in (h - 0.05, h - 0.13, h - 0.21):
                b.box(ends, ys, (z - 0.025, z + 0.025), wood, bevel=0.005)
            if ends is not long:
                b.box((ends[1] - 0.04, ends[1]), ys, (bed_z + 0.06, h - 0.02), wood)
        for xs in ((x[0] + a, x[0] + t - a), (x[1] - t + a, x[1] - a)):
            b.box(xs, inner, (h - 0.07, h - 0.02), wood, bevel=0.005)
            slats(b, xs, inner, (bed_z + 0.06, h - 0.06), wood, 0.14, 0.018)
        if not metal:
            b.box((x[0] + a, x[0] + t - a), inner, (0.3, 0.38), wood)
    bedding(
        b,
        (long[0] + 0.004, long[1] - 0.004),
        (y[0] + t - 0.008, y[1] - t + 0.008),
        (bed_z - 0.012, bed_z + 0.11),
        "bed",
        1,
        bed_z + 0.02,
        None,
        thick=0.1,
    )
    with b.solid("ladder"):
        ladder(b, rung, y[1] - 0.004, (0.0, h - 0.08), wood, 0.055, 6)
    b.clear((long[0], long[1]), inner, (0.05, bed_z - 0.1))
    b.fit()


@draws("crib")
def crib(b: Builder) -> None:
    """A baby's bed with bars all around, a small mattress, a blanket and a pillow roll."""
    d, w, h = b.size
    wood = b.material("frame", "white paint", "birch", "beech", "light grey paint", "oak", "sage paint")
    t = 0.035
    x, y = (-d / 2, d / 2), (-w / 2, w / 2)
    low, bed = 0.2, 0.4
    solid_ends = b.chance("solid ends", 0.4)
    for k, xs in enumerate(((x[0], x[0] + t), (x[1] - t, x[1]))):
        with b.solid(f"end {k}"):
            for ys in ((y[0], y[0] + t), (y[1] - t, y[1])):
                b.box(xs, ys, (0.0, h), wood, bevel=0.005)
            inner = (y[0] + t, y[1] - t)
            b.box(xs, inner, (h - 0.06, h - 0.008), wood, bevel=0.01)
            b.box(xs, inner, (low, low + 0.06), wood)
            if solid_ends:
                b.box((xs[0] + 0.009, xs[1] - 0.009), inner, (low + 0.05, h - 0.05), wood)
            else:
                slats(b, xs, inner, (low + 0.05, h - 0.05), wood, 0.075, 0.014, True)
    for k, ys in enumerate(((y[0], y[0] + t), (y[1] - t, y[1]))):
        with b.solid(f"side {k}"):
            inner = (x[0] + t, x[1] - t)
            mid = (ys[0] + 0.005, ys[1] - 0.005)
            b.box(inner, mid, (h - 0.06, h - 0.015), wood, bevel=0.008)
            b.box(inner, mid, (low, low + 0.06), wood)
            slats(b, inner, mid, (low + 0.05, h - 0.05), wood, 0.078, 0.014, True)
    sheet, cover = (
        b.material("sheet", *SHEETS),
        b.material("blanket", "rose fabric", "blue fabric", "green fabric", "mustard fabric", "white fabric"),
    )
    with b.solid("bed"):
        inside = (x[0] + t, x[1] - t), (y[0] + t, y[1] - t)
        b.box(*inside, (low + 0.05, low + 0.075), wood, bevel=0.002)
        b.cushion(*inside, (low + 0.074, bed), sheet, radius=0.03)
        shape = ring_shape(
            (x[0] + 0.5 * d, x[1] - t - 0.004), (y[0] + t + 0.004, y[1] - t - 0.004), (bed - 0.06, bed + 0.018), 0.035
        )
        b.add(shape, cover, [shapes.containing_hull(shape[0])])
        fold = ring_shape(
            (x[0] + 0.5 * d + 0.002, x[0] + 0.5 * d + 0.13),
            (y[0] + t + 0.003, y[1] - t - 0.003),
            (bed - 0.05, bed + 0.026),
            0.035,
        )
        b.add(fold, sheet, [shapes.containing_hull(fold[0])])
    with b.solid("pillow"):
        b.cushion(
            (x[0] + t + 0.02, x[0] + t + 0.22), (-0.17, 0.17), (bed - 0.005, bed + 0.05), cover, radius=0.03, puff=0.5
        )
    b.fit()


@draws("murphy_bed")
def murphy_bed(b: Builder) -> None:
    """A cupboard whose large front folds down to a bed; drawn folded up."""
    d, w, h = b.size
    wood = b.material("body", "white paint", "oak", "walnut", "light grey paint", "ash grey wood")
    front = b.material("front", "oak", "walnut", "white paint", "sage paint") if b.chance("two tone", 0.4) else wood
    pull = b.material("pulls", "black steel", "brass", "brushed steel")
    x, y = (-d / 2, d / 2 - 0.028), (-w / 2, w / 2)
    t = 0.03
    edge = (x[1] - 0.002, x[1] + 0.018)
    with b.solid("cupboard"):
        b.box((x[0], x[1] + 0.018), (y[0], y[0] + t), (0.0, h - 0.06), wood)
        b.box((x[0], x[1] + 0.018), (y[1] - t, y[1]), (0.0, h - 0.06), wood)
        b.box((x[0], x[1] - 0.002), (y[0] + t, y[1] - t), (0.0, h - 0.06), wood)
        b.box(edge, (y[0] + t, y[1] - t), (h - 0.18, h - 0.06), wood)
        b.box((x[0], d / 2), y, (h - 0.06, h), wood, bevel=0.012)
        b.box((x[1] - 0.003, x[1] + 0.008), (y[0] + t, y[1] - t), (0.0, 0.08), "black paint")
    z = (0.085, h - 0.185)
    inner = (y[0] + t + 0.003, y[1] - t - 0.003)
    foot = (x[1] + 0.021, 0.0, z[0])
    with b.hinge("bed", foot, axis=(0.0, 1.0, 0.0), limits=(0.0, math.pi / 2)), b.solid("cupboard"):
        b.box((x[1], x[1] + 0.014), inner, z, front)
        columns, rows = b.pick("panels", [(2, 1), (2, 2), (2, 3), (3, 1)])
        m = 0.07
        sy, sz = (inner[1] - inner[0]) / columns, (z[1] - z[0]) / rows
        framed = b.chance("framed", 0.6)
        for i in range(columns):
            for j in range(rows):
                ya, yb = inner[0] + i * sy, inner[0] + (i + 1) * sy
                za, zb = z[0] + j * sz, z[0] + (j + 1) * sz
                out = (x[1] + 0.013, x[1] + 0.021)
                if not framed:
                    b.box(out, (ya + 0.002, yb - 0.002), (za + 0.002, zb - 0.002), front, bevel=0.002)
                    continue
                b.box(out, (ya + 0.002, ya + m), (za + 0.002, zb - 0.002), front, bevel=0.002)
                b.box(out, (yb - m, yb - 0.002), (za + 0.002, zb - 0.002), front, bevel=0.002)
                b.box(out, (ya + m, yb - m), (za + 0.002, za + m), front, bevel=0.002)
                b.box(out, (ya + m, yb - m), (zb - m, zb - 0.002), front, bevel=0.002)
        for s in (-1, 1):
            at = s * 0.25 * w
            top = z[1] - 0.32
            b.box((x[1] + 0.02, d / 2), (at - 0.1, at + 0.1), (top, top + 0.018), pull, bevel=0.004)
        # Folded feet, a sign that this is a bed.
        for s in (-1, 1):
            at = s * 0.36 * w
            b.box((x[1] + 0.02, x[1] + 0.027), (at - 0.022, at + 0.022), (z[1] - 0.62, z[1] - 0.3), pull, bevel=0.003)
    b.surface("top", (x[0] + 0.02, x[1] - 0.02), (y[0] + 0.03, y[1] - 0.03), h)
    b.fit()


@draws("hospital_bed")
def hospital_bed(b: Builder) -> None:
    """A bed on castors with a raised head part, side rails, boards at both ends, and a lifting column."""
    d, w, h = b.size
    panel = b.material("boards", "white plastic", "beech", "light grey paint", "blue plastic")
    metal = b.material("frame", "white steel", "grey plastic", "light grey paint")
    sheet = b.material("sheet", "white fabric")
    cover = b.material("blanket", "blue fabric", "green fabric", "white fabric", "grey fabric")
    x = (-d / 2, d / 2)
    deck, top = 0.46, 0.6
    with b.solid("bed"):
        for cx in (x[0] + 0.24, x[1] - 0.28):
            for s in (-1, 1):
                with b.frame(cx, s * (w / 2 - 0.14), 0.062, roll=math.pi / 2):
                    b.frustum(0.062, 0.062, (-0.02, 0.02), "grey plastic", segments=18, bevel=0.006)
                b.box(
                    (cx - 0.02, cx + 0.02), (s * (w / 2 - 0.14) - 0.028, s * (w / 2 - 0.14) + 0.028), (0.1, 0.17), metal
                )
            b.box((cx - 0.035, cx + 0.035), (-w / 2 + 0.1, w / 2 - 0.1), (0.15, 0.2), metal, bevel=0.008)
        b.box((x[0] + 0.2, x[1] - 0.24), (-0.2, 0.2), (0.15, 0.21), metal, bevel=0.01)
        for cx in (-0.4, 0.4):
            b.box((cx - 0.07, cx + 0.07), (-0.09, 0.09), (0.2, deck - 0.05), "brushed steel", bevel=0.006)
        b.box((x[0] + 0.06, x[1] - 0.06), (-w / 2 + 0.06, w / 2 - 0.06), (deck - 0.06, deck), metal, bevel=0.01)
        split = x[0] + 0.8
        ys = (-w / 2 + 0.065, w / 2 - 0.065)
        b.cushion((split - 0.03, x[1] - 0.055), ys, (deck, top), sheet, radius=0.035)
        shape = ring_shape(
            (split + 0.14, x[1] - 0.052), (ys[0] - 0.004, ys[1] + 0.004), (deck + 0.02, top + 0.02), 0.045
        )
        b.add(shape, cover, [shapes.containing_hull(shape[0])])
    b.surface("top", (split + 0.36, x[1] - 0.12), (ys[0] + 0.06, ys[1] - 0.06), top + 0.02)
    with b.solid("head part"):
        fold = ring_shape(
            (split + 0.144, split + 0.33), (ys[0] - 0.006, ys[1] + 0.006), (deck + 0.04, top + 0.03), 0.045
        )
        b.add(fold, sheet, [shapes.containing_hull(fold[0])])
        tilt = 0.42
        with b.frame(split, 0, deck, pitch=tilt):
            b.box((-0.72, 0.0), (ys[0] + 0.01, ys[1] - 0.01), (-0.03, 0.0), metal, bevel=0.005)
            b.cushion((-0.74, 0.05), ys, (-0.004, top - deck), sheet, radius=0.035)
            with b.frame(-0.47, 0, top - deck - 0.004):
                pillow(b, 0.42, 0.62, 0.14, sheet)
    for name, px, high in (("head board", x[0], h), ("foot board", x[1] - 0.045, 0.86)):
        with b.solid(name):
            b.cushion((px, px + 0.045), (-w / 2 + 0.03, w / 2 - 0.03), (0.4, high), panel, radius=0.022)
            b.box((px + 0.012, px + 0.033), (-0.16, 0.16), (high - 0.002, high), panel, bevel=0.0005)
            b.box((px - 0.0, px + 0.045), (-0.24, 0.24), (high - 0.15, high - 0.1), "grey plastic", bevel=0.002)
    for s in (-1, 1):
        ya, yb = _span(s * (w / 2 - 0.055), s * (w / 2 - 0.02))
        for xs, name in (((x[0] + 0.16, x[0] + 0.86), "head rail"), ((x[0] + 1.0, x[0] + 1.6), "foot rail")):
            with b.solid(f"{name} {s}"):
                top_z = 0.88 if name == "head rail" else 0.8
                path = [
                    (xs[0], (ya + yb) / 2, deck - 0.03),
                    (xs[0] + 0.06, (ya + yb) / 2, top_z),
                    (xs[1] - 0.06, (ya + yb) / 2, top_z),
                    (xs[1], (ya + yb) / 2, deck - 0.03),
                ]
                b.tube(path, 0.0145, panel if panel.name == "white plastic" else metal, 8)
                for z in (0.6, 0.7) if name == "foot rail" else (0.6, 0.69, 0.78):
                    reach = 0.06 * (z - deck) / (top_z - deck)
                    b.bar((xs[0] + reach, (ya + yb) / 2, z), (xs[1] - reach, (ya + yb) / 2, z), 0.011, metal, 6)
                b.box(
                    (xs[0] + 0.03, xs[1] - 0.03),
                    (min(ya, s * (w / 2 - 0.075)), max(yb, s * (w / 2 - 0.075))),
                    (deck - 0.05, deck - 0.02),
                    metal,
                )
                b.box(
                    (sum(xs) / 2 - 0.1, sum(xs) / 2 + 0.1),
                    _span(s * w / 2, s * (w / 2 - 0.05)),
                    (top_z - 0.07, top_z - 0.02),
                    "grey plastic",
                    bevel=0.008,
                )
    b.fit()


@draws("massage_table")
def massage_table(b: Builder) -> None:
    """A padded top with a face cradle at its head, on folding wooden legs with braces, or on a cabinet."""
    d, w, h = b.size
    cover = b.material(
        "cover", "white leather", "black leather", "brown leather", "tan leather", "teal paint", "navy fabric"
    )
    wood = b.material("frame", "beech", "oak", "walnut", "white paint")
    x, y = (-d / 2 + 0.26, d / 2), (-w / 2, w / 2)
    pad = 0.075
    with b.solid("top"):
        for xs in ((x[0], -0.0 + 0.13 - 0.002), (0.13 + 0.002, x[1])):
            b.box(
                (xs[0] + 0.005, xs[1] - 0.002),
                (y[0] + 0.006, y[1] - 0.006),
                (h - 0.14, h - pad + 0.003),
                wood,
                bevel=0.004,
            )
            b.cushion(xs, y, (h - pad, h), cover, radius=0.03)
    with b.solid("cradle"):
        n = 16
        points = [
            (x[0] - 0.135 + 0.105 * math.cos(2 * math.pi * k / n), 0.11 * math.sin(2 * math.pi * k / n), h - 0.045)
            for k in range(n)
            if abs(k - 0) > 1 and abs(k - n) > 1
        ]
        b.tube(points, 0.042, cover, 10)
        for s in (-1, 1):
            b.bar((x[0] + 0.05, s * 0.09, h - 0.1), (x[0] - 0.14, s * 0.09, h - 0.085), 0.012, "brushed steel", 8)
        b.cushion((x[0] - 0.2, x[0] - 0.08), (-0.11, 0.11), (h - 0.1, h - 0.08), wood, radius=0.008)
    if b.chance("cabinet", 0.3):
        with b.solid("cabinet"):
            b.box((x[0] + 0.16, x[1] - 0.16), (y[0] + 0.1, y[1] - 0.1), (0.0, 0.07), "black paint")
            b.box((x[0] + 0.1, x[1] - 0.1), (y[0] + 0.06, y[1] - 0.06), (0.07, h - 0.13), wood)
            for s in (-1, 1):
                for k in range(3):
                    step = (x[1] - x[0] - 0.24) / 3
                    xs = (x[0] + 0.12 + k * step + 0.006, x[0] + 0.12 + (k + 1) * step - 0.006)
                    b.box(xs, _span(s * (y[1] - 0.061), s * (y[1] - 0.045)), (0.09, h - 0.15), wood)
                    b.box(
                        (xs[1] - 0.05, xs[1] - 0.038),
                        _span(s * (y[1] - 0.046), s * (y[1] - 0.03)),
                        (h - 0.32, h - 0.2),
                        "brushed steel",
                        bevel=0.003,
                    )
    else:
        for k, (cx, s) in enumerate(((x[0] + 0.12, 1), (x[1] - 0.12, -1))):
            with b.solid(f"legs {k}"):
                for cy in (y[0] + 0.06, y[1] - 0.06):
                    square_leg(b, (cx - s * 0.05, cy, 0.012), (cx, cy, h - 0.13), 0.035, 0.04, wood)
                    b.box((cx - s * 0.05 - 0.022, cx - s * 0.05 + 0.022), (cy - 0.022, cy + 0.022), (0, 0.02), "rubber")
                b.box((cx - s * 0.035 - 0.011, cx - s * 0.035 + 0.011), (y[0] + 0.06, y[1] - 0.06), (0.2, 0.25), wood)
                for cy in (y[0] + 0.06, y[1] - 0.06):
                    b.bar((cx - s * 0.03, cy, 0.33), (cx + s * 0.42, cy, h - 0.13), 0.012, wood, 6)
    b.surface("top", (0.13 + 0.04, x[1] - 0.045), (y[0] + 0.045, y[1] - 0.045), h)
    b.surface("top-head", (x[0] + 0.04, 0.13 - 0.04), (y[0] + 0.045, y[1] - 0.045), h)
    b.fit()
