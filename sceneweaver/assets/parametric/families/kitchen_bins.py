"""Bins: open or swing topped, with a pedal, in a row for sorting."""

from __future__ import annotations

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import loft, oval, rounded, vessel
from .small_containers import open_box
from .small_kit import OPEN


@draws("trash_can")
def trash_can(b: Builder) -> None:
    """A tapered bucket with a bag turned over its rim, or a tall one with a swing lid."""
    d, w, h = b.size
    body = b.material(
        "body",
        "black plastic",
        "brushed steel",
        "white plastic",
        "grey plastic",
        "green plastic",
        "black steel",
        "blue plastic",
    )
    if b.request.shape == OPEN:
        open_box(b, d, w, h, body, 0.006, 0.1 * d)
        b.fit()
        return
    square = b.chance("square", 0.4)

    def ring(share: float, z: float):
        x, y = d / 2 * share, w / 2 * share
        return rounded((-x, x), (-y, y), 0.25 * min(x, y), z) if square else oval(x, y, z)

    lid = h > 0.5
    cuts = 16 if square else 32
    with b.solid("bin"):
        if lid:
            top = h - 0.17
            loft(b, [ring(0.80, 0.0), ring(0.82, 0.012), ring(0.955, top)], body, whole=True)
            loft(b, [ring(0.985, top), ring(1.0, top + 0.012), ring(1.0, top + 0.05)], "black plastic", whole=True)
            loft(b, [ring(0.98, top + 0.05), ring(0.62, h - 0.008), ring(0.55, h)], body, whole=True)
            # The flap, in a slope of the hood.
            b.hull(
                [
                    (x, y, z)
                    for x, z in (
                        (d * 0.36, top + 0.065),
                        (d * 0.30, top + 0.10),
                        (d * 0.485, top + 0.05),
                        (d * 0.335, h - 0.03),
                    )
                    for y in (-w * 0.2, w * 0.2)
                ],
                "grey plastic",
            )
        else:
            t = 0.006 / min(d, w) * 2
            vessel(
                b,
                [ring(0.76, 0.0), ring(0.97, h - 0.02), ring(1.0, h - 0.018), ring(1.0, h)],
                [ring(1.0 - 2.5 * t, h), ring(0.76 - t, 0.012)],
                body,
                cuts,
            )
            if b.chance("bag", 0.5):
                # A liner folded down outside hides the rim.
                loft(b, [ring(0.72, 0.35 * h), ring(0.79, 0.36 * h)], "white plastic", whole=True)
            else:
                loft(b, [ring(0.70, 0.02), ring(0.76, 0.12 * h)], "paper", whole=True)
    b.fit()


@draws("pedal_bin")
def pedal_bin(b: Builder) -> None:
    """A steel drum with a domed lid, a pedal in front and a dark foot."""
    d, w, h = b.size
    body = b.material(
        "body", "brushed steel", "white steel", "black steel", "copper", "red paint", "sage paint", "cream paint"
    )
    dark = "black plastic"
    out = 0.06
    x, r = -out / 2, (d - out) / 2
    square = b.chance("square", 0.3)

    def ring(share: float, z: float):
        if square:
            return rounded((x - r * share, x + r * share), (-w / 2 * share, w / 2 * share), 0.04, z)
        return oval(r * share, w / 2 * share, z, x)

    top = h - (0.055 if square else 0.09)
    with b.solid("bin"):
        loft(b, [ring(1.0, 0.0), ring(1.0, 0.045)], dark)
        loft(b, [ring(0.985, 0.045), ring(0.985, top - 0.006)], body)
        loft(b, [ring(1.0, top - 0.006), ring(1.0, top + 0.008)], dark)
        back = h - 0.012 if square else top + 0.35 * (h - top)  # as high as the lid is upright: clear of a wall
        with b.hinge("lid", (x - 0.985 * r, 0.0, back), axis=(0.0, 1.0, 0.0), limits=(-1.3, 0.0)):
            if square:
                rings = [ring(0.99, top + 0.0085), ring(0.985, h - 0.012), ring(0.94, h)]
            else:
                rings = [
                    ring(s, top + 0.0085 + z * (h - top - 0.0085))
                    for s, z in ((0.99, 0.0), (0.98, 0.25), (0.9, 0.6), (0.72, 0.86), (0.4, 1.0))
                ]
            loft(b, rings, body, whole=True)
        b.hull(
            [
                (px, y, z)
                for px, z in ((x + r - 0.03, 0.012), (x + r - 0.03, 0.03), (d / 2, 0.006), (d / 2, 0.018))
                for y in (-0.035, 0.035)
            ],
            body if body.metallic else "chrome",
        )
        b.box((x - r - 0.001, x - r + 0.02), (-0.05, 0.05), (top - 0.06, top + 0.006), dark, bevel=0)
    b.fit()


@draws("recycling_bin")
def recycling_bin(b: Builder) -> None:
    """Two to four bins side by side in a frame, each with a lid and a label of its colour."""
    d, w, h = b.size
    body = b.material("body", "grey plastic", "black plastic", "white plastic", "brushed steel")
    count = 2 if w < 0.82 else 3 if w < 1.05 else 4
    step = w / count
    lids = ["blue plastic", "yellow plastic", "green plastic", "red plastic"]
    with b.solid("bin"):
        for k in range(count):
            y = (-w / 2 + k * step + 0.004, -w / 2 + (k + 1) * step - 0.004)
            m = (y[0] + y[1]) / 2
            color = lids[(k + b.whole("first", 0, 3)) % 4]
            top = h - 0.06
            low = [(px * d / 2 * 0.9, m + s * step * 0.43, 0.0) for px in (-1, 1) for s in (-1, 1)]
            high = [(px * (d / 2 - 0.012), m + s * (step / 2 - 0.008), top) for px in (-1, 1) for s in (-1, 1)]
            b.hull(low + high, body)
            with b.hinge(f"lid-{k}", (-d / 2, m, h), axis=(0.0, 1.0, 0.0), limits=(-1.2, 0.0)):
                b.hull(
                    [(-d / 2, s, z) for s in y for z in (top + 0.001, h)]
                    + [(d / 2, s, z) for s in y for z in (top + 0.001, top + 0.022)]
                    + [(0.1 * d, s, h) for s in y],
                    color,
                )
                b.box(
                    (d / 2 - 0.001, d / 2 + 0.012), (m - 0.05, m + 0.05), (top + 0.003, top + 0.018), color, bevel=0.003
                )
            # A label on the sloping front.
            f0, f1 = 0.55, 0.78
            px = [d / 2 * 0.9 + (d / 2 - 0.012 - d / 2 * 0.9) * f for f in (f0, f1)]
            b.hull(
                [
                    (p + o, m + s * step * 0.26, f * top)
                    for p, f in zip(px, (f0, f1), strict=True)
                    for o in (-0.004, 0.0015)
                    for s in (-1, 1)
                ],
                color,
            )
            b.hull(
                [
                    (p + o, m + s * step * 0.12, f * top)
                    for p, f in zip(px, (f0 + 0.06, f1 - 0.06), strict=True)
                    for o in (-0.004, 0.003)
                    for s in (-1, 1)
                ],
                "white plastic",
            )
    b.fit()
