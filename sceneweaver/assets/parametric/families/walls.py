"""Pictures, mirrors, clocks and screens on the wall or before it."""

from __future__ import annotations

import math

import numpy as np

from ... import shapes
from ..builder import Builder
from ..registry import draws
from .walls_art import art, framed, panel

_FRAMES = ("oak", "walnut", "black paint", "white paint", "brass", "light oak", "cherry")


def _rng(b: Builder) -> np.random.Generator:
    return np.random.default_rng(b.whole("art", 0, 2**31 - 1))


@draws("picture")
def picture(b: Builder) -> None:
    """A framed painting: landscape, sea, blocks, circles, arches, leaves or waves."""
    d, w, h = b.size
    with b.solid("picture"):
        framed(
            b,
            (-w / 2, w / 2),
            (0.0, h),
            (-d / 2, d / 2),
            b.material("frame", *_FRAMES),
            b.uniform("bar", 0.018, 0.035),
            b.uniform("mat", 0.03, 0.07) if b.chance("has mat", 0.5) else 0.0,
            _rng(b),
        )


@draws("poster")
def poster(b: Builder) -> None:
    """A print on paper between two wooden bars, hung from a cord; or a bare sheet."""
    d, w, h = b.size
    with b.solid("poster"):
        wood = b.material("bars", "light oak", "walnut", "black paint", "oak")
        x = -d / 2
        for z in ((0.0, 0.022), (h - 0.022, h)):
            b.box((x, d / 2), (-w / 2, w / 2), z, wood)
        y = (-w / 2 + 0.006, w / 2 - 0.006)
        whole = shapes.box((x, x + 0.006), y, (0.01, h - 0.01))
        b.add(shapes.box((x, x + 0.002), y, (0.01, h - 0.01)), "paper", hulls=[whole])
        edge = 0.05
        art(b, (y[0] + edge, y[1] - edge), (h * 0.2, h - 0.022 - edge), x + 0.003, _rng(b))
        for k, share in ((0, 0.6), (1, 0.35)):
            wide = w * share / 2
            z = h * (0.13 - 0.05 * k)
            panel(
                b,
                [(-wide, z - 0.012), (wide, z - 0.012), (wide, z + 0.012 - 0.006 * k), (-wide, z + 0.012 - 0.006 * k)],
                (x, x + 0.0035),
                "ink pigment",
            )


@draws("photo_frames")
def photo_frames(b: Builder) -> None:
    """Five to seven small frames hung together."""
    d, w, h = b.size
    rng = _rng(b)
    one = b.material("frame", *_FRAMES)
    two = b.material("second frame", *_FRAMES) if b.chance("two woods", 0.5) else one
    gap = 0.035
    plan = b.pick(
        "plan",
        [
            [
                (0, 0, 0.4, 0.45),
                (0, 0.45, 0.4, 1),
                (0.4, 0, 0.72, 0.62),
                (0.4, 0.62, 0.72, 1),
                (0.72, 0.12, 1, 0.5),
                (0.72, 0.5, 1, 0.9),
            ],
            [(0, 0.1, 0.3, 0.5), (0, 0.5, 0.3, 0.95), (0.3, 0, 0.7, 1), (0.7, 0.05, 1, 0.5), (0.7, 0.5, 1, 0.9)],
            [
                (0, 0, 0.34, 0.5),
                (0.34, 0, 0.67, 0.5),
                (0.67, 0, 1, 0.5),
                (0, 0.5, 0.34, 1),
                (0.34, 0.5, 0.67, 1),
                (0.67, 0.5, 1, 1),
            ],
        ],
    )
    with b.solid("frames"):
        for k, (u0, v0, u1, v1) in enumerate(plan):
            y = (-w / 2 + u0 * w + (gap / 2 if u0 else 0), -w / 2 + u1 * w - (gap / 2 if u1 < 1 else 0))
            z = (v0 * h + (gap / 2 if v0 else 0), v1 * h - (gap / 2 if v1 < 1 else 0))
            framed(
                b, y, z, (-d / 2, d / 2), one if k % 2 == 0 else two, 0.014, 0.1 * min(y[1] - y[0], z[1] - z[0]), rng
            )


@draws("wall_mirror")
def wall_mirror(b: Builder) -> None:
    """A mirror in a rectangular frame, or one with an arched head."""
    d, w, h = b.size
    wood = b.material("frame", "black steel", "brass", "oak", "walnut", "white paint")
    bar = b.uniform("bar", 0.02, 0.05)
    with b.solid("mirror"):
        if b.chance("arch", 0.4):
            _arch(b, w, h, d, wood, bar)
            return
        x = (-d / 2, d / 2)
        b.box(x, (-w / 2, w / 2), (0.0, bar), wood)
        b.box(x, (-w / 2, w / 2), (h - bar, h), wood)
        b.box(x, (-w / 2, -w / 2 + bar), (bar, h - bar), wood)
        b.box(x, (w / 2 - bar, w / 2), (bar, h - bar), wood)
        b.box((x[0], x[1] - 0.006), (-w / 2 + bar, w / 2 - bar), (bar, h - bar), "mirror", bevel=0.0)


@draws("gym_mirror")
def gym_mirror(b: Builder) -> None:
    """Panels of mirror side by side, without a frame, held by rails at the foot and the head."""
    d, w, h = b.size
    count = max(2, round(w / 1.0))
    with b.solid("mirror"):
        for k in range(count):
            y = -w / 2 + k * w / count
            b.box((-d / 2, d / 2 - 0.004), (y + 0.003, y + w / count - 0.003), (0.012, h - 0.012), "mirror", bevel=0.0)
        for z in (0.0, h - 0.02):
            b.box((-d / 2, d / 2), (-w / 2, w / 2), (z, z + 0.02), "brushed steel", bevel=0.0)


def _arch(b: Builder, w: float, h: float, d: float, wood, bar: float) -> None:
    bar = min(bar, 0.025)
    for cut, x1, look in ((0.0, d / 2 - 0.003, wood), (bar, d / 2, "mirror")):
        r = w / 2 - cut
        a = np.linspace(0, np.pi, 17)
        ring = np.concatenate([[(-r, cut), (r, cut)], np.c_[r * np.cos(a), h - w / 2 + r * np.sin(a)]])
        vertices, faces = shapes.extrusion(ring, (-d / 2, x1))
        b.add((vertices[:, [2, 0, 1]], faces), look)


@draws("round_mirror")
def round_mirror(b: Builder) -> None:
    """A round mirror in a thin ring, or with rays like a sun."""
    d, w, _ = b.size
    r = w / 2
    metal = b.material("frame", "brass", "black steel", "oak", "walnut", "rattan")
    with b.solid("mirror"), b.frame(-d / 2, 0.0, r, pitch=math.pi / 2):
        if b.chance("sun", 0.3):
            inner = r * 0.56
            for k in range(32):
                a = k * math.pi / 16
                out = r if k % 2 == 0 else r * 0.84
                b.bar(
                    (inner * math.cos(a), inner * math.sin(a), d * 0.4),
                    (out * math.cos(a), out * math.sin(a), d * 0.4),
                    0.004,
                    metal,
                    6,
                )
            b.frustum(inner, inner, (0.0, d * 0.9), metal, 36, bevel=0.003)
            b.frustum(inner * 0.9, inner * 0.9, (d * 0.5, d), "mirror", 36)
        else:
            b.frustum(r, r, (0.0, d - 0.002), metal, 40, bevel=0.003)
            b.frustum(r - 0.018, r - 0.018, (d * 0.5, d), "mirror", 40)


@draws("standing_mirror")
def standing_mirror(b: Builder) -> None:
    """A tall mirror that leans back in a frame, with a prop behind."""
    d, w, h = b.size
    wood = b.material("frame", "oak", "walnut", "black steel", "white paint", "brass")
    bar, thick = b.uniform("bar", 0.03, 0.05), 0.028
    lean = math.asin(min(0.22, (d * 0.42) / h))
    tall = (h - thick * math.sin(lean)) / math.cos(lean)
    with b.frame(d / 2 - thick * math.cos(lean), 0.0, 0.0, pitch=-lean), b.solid("frame"):
        b.box((0.0, thick), (-w / 2, w / 2), (0.0, bar), wood)
        b.box((0.0, thick), (-w / 2, w / 2), (tall - bar, tall), wood)
        b.box((0.0, thick), (-w / 2, -w / 2 + bar), (bar, tall - bar), wood)
        b.box((0.0, thick), (w / 2 - bar, w / 2), (bar, tall - bar), wood)
        b.box((0.004, thick - 0.006), (-w / 2 + bar, w / 2 - bar), (bar, tall - bar), "mirror", bevel=0.0)
        b.box((0.0, 0.006), (-w / 2 + bar * 0.5, w / 2 - bar * 0.5), (bar * 0.5, tall - bar * 0.5), wood, bevel=0.0)
    top = h * 0.62
    with b.solid("prop"):
        foot, head = -d / 2 + 0.012, d / 2 - thick - math.tan(lean) * top
        for sy in (-1, 1):
            b.hull(
                [
                    (x + u, sy * w * 0.3 + v, z)
                    for x, z in ((foot, 0.0), (head, top))
                    for u in (-0.012, 0.012)
                    for v in (-0.012, 0.012)
                ],
                wood,
            )
        x = foot + (head - foot) * 0.3
        b.box((x - 0.008, x + 0.008), (-w * 0.3, w * 0.3), (top * 0.3 - 0.012, top * 0.3 + 0.012), wood)


def clock_face(b: Builder, r: float, z: float, dial, hands, numbers: bool = True) -> None:
    """A dial about the local z axis at height z, its top at z + 4 mm: marks and hands; local -x is up."""
    b.frustum(r, r, (z - 0.004, z), dial, 36)
    for k in range(12):
        a = k * math.pi / 6
        long = 0.12 * r if k % 3 else 0.2 * r
        wide = max(0.0012, (0.012 if k % 3 else 0.024) * r)
        with b.frame(0, 0, 0, yaw=a):
            if numbers:
                b.box((r * 0.92 - long, r * 0.92), (-wide, wide), (z, z + 0.001), hands, bevel=0.0)
    for turn, long, wide, lift in ((0.86, 0.5, 0.035, 0.002), (-1.05, 0.78, 0.022, 0.003)):
        with b.frame(yaw=math.pi - turn):
            b.hull(
                [(-0.1 * r, y, zz) for y in (-wide * r, wide * r) for zz in (z, z + lift)]
                + [(long * r, y * 0.5, zz) for y in (-wide * r, wide * r) for zz in (z, z + lift)],
                hands,
            )
    b.frustum(0.05 * r, 0.05 * r, (z, z + 0.004), hands, 12)


@draws("wall_clock")
def wall_clock(b: Builder) -> None:
    """A round clock with marks and hands."""
    d, w, _ = b.size
    r = w / 2
    rim = b.material("rim", "black steel", "oak", "walnut", "brass", "white plastic", "red plastic", "copper")
    dial = b.material("dial", "white paint", "cream paint", "black paint", "navy paint")
    hands = "white paint" if dial.name in ("black paint", "navy paint") else "black steel"
    with b.solid("clock"), b.frame(-d / 2, 0.0, r, pitch=math.pi / 2):
        b.lathe(
            [(r * 0.94, 0.0), (r, 0.006), (r, d - 0.006), (r * 0.975, d), (r * 0.95, d), (r * 0.93, d - 0.01)],
            rim,
            40,
            hollow=True,
        )
        clock_face(b, r * 0.93, d - 0.004, dial, hands)


@draws("grandfather_clock")
def grandfather_clock(b: Builder) -> None:
    """A tall case: plinth, waist with a pendulum behind glass, hood with dial and pediment."""
    d, w, h = b.size
    wood = b.material("case", "cherry", "mahogany", "walnut", "oak")
    brass = "brass"
    base, hood = h * 0.24, h * 0.3
    x0 = -d / 2
    with b.solid("case"):
        b.box((x0, d / 2), (-w / 2, w / 2), (0.0, 0.07), wood, bevel=0.006)
        b.box((x0, d / 2 - 0.015), (-w / 2 + 0.02, w / 2 - 0.02), (0.07, base), wood)
        b.box((x0, d / 2), (-w / 2 + 0.005, w / 2 - 0.005), (base, base + 0.025), wood, bevel=0.008)
        wy, wx = w / 2 - 0.055, d / 2 - 0.045
        z0, z1 = base + 0.025, h - hood
        b.box((x0, wx - 0.012), (-wy, wy), (z0, z1), wood)
        b.box((wx - 0.012, wx), (-wy, -wy + 0.05), (z0, z1), wood, bevel=0.001)
        b.box((wx - 0.012, wx), (wy - 0.05, wy), (z0, z1), wood, bevel=0.001)
        b.box((wx - 0.012, wx), (-wy + 0.05, wy - 0.05), (z0, z0 + 0.06), wood, bevel=0.001)
        b.box((wx - 0.012, wx), (-wy + 0.05, wy - 0.05), (z1 - 0.05, z1), wood, bevel=0.001)
        b.box((wx - 0.011, wx - 0.009), (-wy + 0.05, wy - 0.05), (z0 + 0.06, z1 - 0.05), "black glass", bevel=0.0)
        b.box((wx - 0.009, wx - 0.006), (-0.006, 0.006), (z0 + 0.2, z1 - 0.05), brass, bevel=0.0)
        with b.frame(wx - 0.009, 0.0, z0 + 0.2, pitch=math.pi / 2):
            b.frustum(0.05, 0.05, (0.0, 0.006), brass, 24)
        b.box((x0, d / 2), (-w / 2 + 0.005, w / 2 - 0.005), (z1, z1 + 0.025), wood, bevel=0.008)
        top = h - 0.09
        hx = d / 2 - 0.02
        b.box((x0, hx), (-w / 2 + 0.03, w / 2 - 0.03), (z1 + 0.025, top), wood)
        for sy in (-1, 1):
            with b.frame(hx - 0.004, sy * (w / 2 - 0.04)):
                b.frustum(0.016, 0.014, (z1 + 0.025, top), wood, 12)
        r = min(w / 2 - 0.075, (top - z1) * 0.42)
        with b.frame(hx, 0.0, (z1 + 0.025 + top) / 2, pitch=math.pi / 2):
            b.frustum(r + 0.014, r + 0.014, (-0.01, 0.006), brass, 32)
            clock_face(b, r, 0.01, "cream paint", "black steel")
        b.box((x0, d / 2), (-w / 2, w / 2), (top, top + 0.03), wood, bevel=0.008)
        for sy in (-1, 1):
            b.hull(
                [
                    (x, sy * y, z)
                    for x in (x0 + 0.02, hx)
                    for y, z in ((0.03, top + 0.03), (w / 2 - 0.02, top + 0.03), (0.03, h - 0.012), (0.06, h - 0.02))
                ],
                wood,
            )
        with b.frame(0.0, 0.0):
            b.lathe([(0.02, top + 0.03), (0.024, h - 0.04), (0.012, h - 0.03), (0.016, h - 0.018), (0.0, h)], brass, 12)


def _screen(b: Builder, x: tuple[float, float], w: float, z: tuple[float, float], bezel) -> None:
    """A flat set: body, dark screen with a thin rim, and a chin."""
    middle = (z[0] + z[1]) / 2
    b.box((x[0] + 0.018, x[1] - 0.002), (-w / 2, w / 2), z, bezel, bevel=0.003)
    b.box((x[1] - 0.004, x[1]), (-w / 2 + 0.007, w / 2 - 0.007), (z[0] + 0.02, z[1] - 0.007), "screen", bevel=0.0)
    b.box((x[1] - 0.004, x[1] - 0.001), (-0.03, 0.03), (z[0] + 0.006, z[0] + 0.011), "grey plastic", bevel=0.0)
    b.box(
        (x[0], x[0] + 0.02),
        (-w * 0.3, w * 0.3),
        (middle - 0.3 * (z[1] - z[0]), middle + 0.15 * (z[1] - z[0])),
        "black plastic",
        bevel=0.006,
    )


@draws("tv")
def tv(b: Builder) -> None:
    """A flat television on the wall."""
    d, w, _ = b.size
    h = w * 0.5625 + 0.013
    with b.solid("tv"):
        _screen(b, (-d / 2, d / 2), w, (0.0, h), b.material("bezel", "black plastic", "black steel", "brushed steel"))


@draws("tv_on_stand")
def tv_on_stand(b: Builder) -> None:
    """A flat television on two feet or on a plate."""
    d, w, _ = b.size
    h = w * 0.5625 + 0.013
    bezel = b.material("bezel", "black plastic", "black steel", "brushed steel")
    lift = 0.07
    with b.solid("screen"):
        _screen(b, (-0.03, 0.03), w, (lift, lift + h), bezel)
    with b.solid("foot"):
        if b.chance("plate", 0.4):
            b.box((-d / 2, d / 2), (-w * 0.2, w * 0.2), (0.0, 0.012), bezel, bevel=0.004)
            b.box((-0.028, 0.0), (-0.06, 0.06), (0.01, lift + 0.1), bezel)
        else:
            for sy in (-1, 1):
                for end in (-1, 1):
                    y = sy * w * 0.36
                    b.hull(
                        [
                            (end * d / 2, y - 0.009, 0.0),
                            (end * d / 2, y + 0.009, 0.0),
                            (end * (d / 2 - 0.03), y - 0.009, 0.0),
                            (end * (d / 2 - 0.03), y + 0.009, 0.0),
                        ]
                        + [(u, y + v, lift + 0.01) for u in (-0.01, 0.022) for v in (-0.009, 0.009)],
                        bezel,
                    )
