"""Chairs, stools, sofas."""

from __future__ import annotations

import math

from ..builder import Builder
from ..registry import draws


@draws("office_chair")
def office_chair(b: Builder) -> None:
    """Star base on castors, gas lift, upholstered seat, curved back rest, arms in some."""
    d, w, h = b.size
    cover = b.material("cover", "@fabric", "black leather", "brown leather")
    frame = b.material("frame", "black plastic", "grey plastic", "white plastic")
    metal = b.material("base", "chrome", "black plastic", "aluminium")
    # A star of five is 1.902 radii wide; its castors stand 2 cm out to the side.
    reach = (w - 0.04) / 1.902 + 0.03
    seat = b.uniform("seat height", 0.42, 0.50)
    with b.solid("base"):
        for k in range(5):
            angle = math.pi + (k + 0.5) * 2 * math.pi / 5
            c, s = math.cos(angle), math.sin(angle)
            tip = reach - 0.03
            b.bar((0.03 * c, 0.03 * s, 0.105), (tip * c, tip * s, 0.075), 0.017, metal)
            with b.frame(tip * c, tip * s, 0.03, yaw=angle + math.pi / 2, pitch=math.pi / 2):
                b.frustum(0.03, 0.03, (-0.02, 0.02), "black plastic", segments=16, bevel=0.004)
        b.frustum(0.045, 0.035, (0.06, 0.13), metal, segments=16)
        b.frustum(0.025, 0.022, (0.13, seat - 0.07), "black plastic", segments=16)
        b.box((-0.1, 0.1), (-0.08, 0.08), (seat - 0.09, seat - 0.06), "black plastic")
    sd, sw = b.uniform("seat depth", 0.46, 0.50), min(b.uniform("seat width", 0.46, 0.52), w - 0.04)
    x0 = -sd / 2 + 0.03
    with b.solid("seat"):
        b.cushion((x0, x0 + sd), (-sw / 2, sw / 2), (seat - 0.06, seat + 0.02), cover, radius=0.03)
        b.hull([(x0 + x, y, z) for x in (0.02, sd - 0.05) for y in (-sw / 2 + 0.03, sw / 2 - 0.03)
                for z in (seat - 0.07, seat - 0.05)], frame)  # fmt: skip
    with b.solid("back"):
        bw = sw * b.uniform("back width", 0.82, 0.98)
        lean = 0.12
        height = h - seat - 0.1
        b.bar((x0 + 0.06, 0, seat - 0.07), (x0 - 0.05, 0, seat - 0.03), 0.02, frame)
        with b.frame(x0 - 0.05, 0.0, seat - 0.03, pitch=-lean):
            b.box((-0.014, 0.012), (-0.03, 0.03), (-0.005, 0.3), frame)
            top = (height + 0.12) / math.cos(lean) - 0.01
            thick = 0.05
            # Three upright strips, bent around the sitter.
            for side in (-1, 0, 1):
                with b.frame(0.035 + 0.012 * abs(side), side * bw / 3, 0.0, yaw=-side * 0.16):
                    b.cushion((-thick / 2, thick / 2), (-bw / 6 - 0.004, bw / 6 + 0.004), (0.13, top), cover,
                              radius=0.02)  # fmt: skip
    if b.chance("arms", 0.65):
        for side in (-1, 1):
            y = side * (sw / 2 + 0.005)
            with b.solid(f"arm {side}"):
                b.box((-0.04, 0.02), (y - 0.02, y + 0.02), (seat - 0.06, seat + 0.2), frame, bevel=0.006)
                b.cushion((-0.12, 0.13), (y - 0.035, y + 0.035), (seat + 0.19, seat + 0.225), "black plastic",
                          radius=0.012)  # fmt: skip
