"""Toilets, bidets, urinals, basins and vanities."""

from __future__ import annotations

import math

import numpy as np

from sceneweaver.assets import shapes

from ..builder import Builder
from ..registry import draws
from .kitchen_parts import Finish, cabinet, egg, fronts, loft, oval, rounded, tap, vessel, worktop

_WHITE = ("white ceramic",)


def _bowl(b: Builder, x: float, long: float, w: float, h: float, china: Finish, lid: Finish, hung: bool) -> None:
    """A toilet's bowl with seat and closed lid; its back, at depth x, is square. The seat's top is at h."""
    mid = x + long * 0.52
    front, back = x + long - mid, mid - x
    rim = h - 0.042
    if hung:
        rings = [
            (0.45, 0.75, 0.42, 0.0),
            (0.62, 0.95, 0.62, 0.05),
            (0.85, 1.0, 0.85, 0.16),
            (0.96, 1.0, 0.97, rim - 0.05),
            (0.97, 1.0, 0.98, rim),
        ]
    else:
        rings = [
            (0.50, 1.0, 0.62, 0.0),
            (0.48, 1.0, 0.58, 0.03),
            (0.46, 0.98, 0.54, 0.14),
            (0.68, 0.98, 0.74, 0.25),
            (0.92, 1.0, 0.95, rim - 0.055),
            (0.97, 1.0, 0.98, rim),
        ]
    loft(b, [egg(front * f, back * k, w / 2 * s, z, mid, 0.0, 2.2, 5.0) for f, k, s, z in rings], china)
    # Seat and lid, hinged at their back: before a cistern, so that the lid can stand up.
    sb = back - (0.055 if hung else 0.115)
    b.add(*_flat(mid, front, sb, w / 2, rim + 0.0005, rim + 0.019, lid))
    with b.hinge("lid", (mid - sb, 0.0, rim + 0.02), axis=(0.0, 1.0, 0.0), limits=(-1.5, 0.0)):
        b.add(*_flat(mid, front * 0.995, sb, w / 2 * 0.99, rim + 0.021, h, lid))
    for s in (-1, 1):
        with b.frame(mid - sb - 0.004, s * 0.075, rim + 0.009, roll=math.pi / 2):
            b.frustum(0.008, 0.008, (-0.018, 0.018), "chrome", segments=12)


def _flat(mid: float, front: float, back: float, half: float, low: float, high: float, look: Finish) -> tuple:
    e = 0.006
    rings = [
        egg(front - e, back - e, half - e, low, mid, 0.0, 2.2, 4.0),
        egg(front, back, half, low + e, mid, 0.0, 2.2, 4.0),
        egg(front, back, half, high - e, mid, 0.0, 2.2, 4.0),
        egg(front - e, back - e, half - e, high, mid, 0.0, 2.2, 4.0),
    ]
    from .kitchen_parts import _body

    shape = _body(rings)
    return shape, look, [shapes.hull(shape[0])]


@draws("toilet")
def toilet(b: Builder) -> None:
    """A bowl on its foot, seat and lid, and behind them a cistern with its own lid and a push button."""
    d, w, h = b.size
    china = b.material("bowl", *_WHITE)
    seat: Finish = (
        b.pick("seat", ["oak", "walnut"])
        if b.style in ("classic", "rustic") and b.chance("wood", 0.6)
        else ("white plastic")
    )
    deep = 0.175
    x0 = -d / 2
    sh = b.uniform("seat height", 0.42, 0.45)
    with b.solid("bowl"):
        _bowl(b, x0 + 0.10, d - 0.10, w * 0.94, sh, china, seat, False)
        b.box((x0 + 0.012, x0 + 0.18), (-w * 0.3, w * 0.3), (sh - 0.16, sh - 0.04), china, bevel=0.02)
    with b.solid("cistern"):
        top = h - 0.012
        low = [
            rounded((x0 + 0.012, x0 + deep - 0.02), (-w / 2 + 0.03, w / 2 - 0.03), 0.03, sh - 0.04),
            rounded((x0 + 0.008, x0 + deep - 0.008), (-w / 2 + 0.012, w / 2 - 0.012), 0.03, top - 0.04),
        ]
        loft(b, low, china, whole=True)
        lid = ((x0, x0 + deep), (-w / 2, w / 2))
        inset = ((x0 + 0.008, x0 + deep - 0.008), (-w / 2 + 0.008, w / 2 - 0.008))
        loft(
            b,
            [rounded(*lid, 0.035, top - 0.04), rounded(*lid, 0.035, top - 0.01), rounded(*inset, 0.03, top)],
            china,
            True,
        )
    with b.solid("button"), b.frame(x0 + deep / 2, 0.0, top):
        b.frustum(0.026, 0.024, (-0.001, 0.012), "chrome", segments=20, bevel=0.002)
        b.add(shapes.box((-0.02, 0.02), (-0.0008, 0.0008), (0.009, 0.0123)), "black steel", [])
    for name, ys in (("top-right", (-w / 2 + 0.03, -0.03)), ("top-left", (0.03, w / 2 - 0.03))):
        b.surface(name, (x0 + 0.02, x0 + deep - 0.02), ys, top)
    b.fit()


@draws("wall_toilet")
def wall_toilet(b: Builder) -> None:
    """A hung bowl with seat and lid; the cistern is in the wall."""
    d, w, h = b.size
    china = b.material("bowl", *_WHITE)
    with b.solid("bowl"):
        _bowl(b, -d / 2, d, w, h, china, "white plastic", True)
    b.fit()


@draws("bidet")
def bidet(b: Builder) -> None:
    """A low open bowl on a foot, with a mixer at its back."""
    d, w, total = b.size
    china = b.material("bowl", *_WHITE)
    h = 0.40
    mid, front, back = 0.02, d / 2 - 0.02, d / 2 + 0.02
    with b.solid("bowl"):
        foot = [(0.50, 1.0, 0.62, 0.0), (0.46, 0.98, 0.54, 0.05), (0.46, 0.98, 0.54, 0.13), (0.74, 0.98, 0.78, 0.25)]
        loft(b, [egg(front * f, back * k, w / 2 * s, z, mid, 0.0, 2.2, 5.0) for f, k, s, z in foot], china)
        outer = [(0.74, 0.98, 0.78, 0.25), (0.95, 1.0, 0.96, 0.33), (1.0, 1.0, 1.0, h - 0.02), (0.985, 0.99, 0.98, h)]
        inner = [(0.84, 0.52, 0.80, h - 0.002), (0.79, 0.47, 0.74, 0.34), (0.42, 0.2, 0.36, 0.28)]
        vessel(
            b,
            [egg(front * f, back * k, w / 2 * s, z, mid, 0.0, 2.2, 5.0) for f, k, s, z in outer],
            [egg(front * f, back * k, w / 2 * s, z, mid, 0.0, 2.2, 2.4) for f, k, s, z in inner],
            china,
        )
        with b.frame(mid + 0.02, 0.0, 0.279):
            b.frustum(0.022, 0.022, (0.0, 0.004), "chrome", segments=14)
    tap(b, -d / 2 + 0.075, 0.0, h - 0.002, b.material("tap", "chrome", "brushed steel", "brass"), total - h, 0.11)
    b.fit()


@draws("urinal")
def urinal(b: Builder) -> None:
    """A shell that is open in its upper front, with a low lip, a drain and a flush pipe."""
    d, w, h = b.size
    china = b.material("bowl", "white ceramic")
    x0 = -d / 2
    hb = h - 0.06

    def ring(reach: float, half: float, z: float):
        return egg(d * reach, 0.0001, w / 2 * half, z, x0, 0.0, 2.4, 8.0, 24)

    with b.solid("shell"):
        loft(b, [ring(0.45, 0.4, 0.0), ring(0.75, 0.72, 0.06), ring(1.0, 0.96, 0.17)], china)
        # The lip and side walls around the opening.
        n = 9
        a = np.linspace(-math.pi / 2, math.pi / 2, n)
        top = [hb * 0.86 - (hb * 0.86 - 0.235) * max(0.0, math.cos(t)) ** 0.8 for t in a]

        def wall(reach: float, half: float, t: float) -> tuple[float, float]:
            c, s = max(0.0, math.cos(t)), math.sin(t)
            return x0 + 0.03 + (d - 0.03) * reach * c ** (2 / 2.4), math.copysign(w / 2 * half * abs(s) ** (2 / 2.4), s)

        for i in range(n - 1):
            pts = []
            for t, z in ((a[i], top[i]), (a[i + 1], top[i + 1])):
                pts += [
                    (*wall(1.0, 0.96, t), 0.17),
                    (*wall(1.0, 0.98, t), z),
                    (*wall(0.86, 0.82, t), 0.165),
                    (*wall(0.88, 0.84, t), z),
                ]
            b.hull(pts, china)
        b.hull(
            [(x0, s * w / 2, z) for s in (-1, 1) for z in (0.17, hb)]
            + [(x0 + 0.05, s * w / 2, z) for s in (-1, 1) for z in (0.2, hb - 0.02)],
            china,
        )
        # A hood at the top.
        loft(
            b,
            [
                egg(0.05, 0.0001, w / 2, hb * 0.78, x0, 0.0, 3.0, 8.0, 24),
                egg(0.15, 0.0001, w / 2, hb * 0.92, x0, 0.0, 3.0, 8.0, 24),
                egg(0.14, 0.0001, w / 2 * 0.97, hb, x0, 0.0, 3.0, 8.0, 24),
            ],
            china,
        )
        with b.frame(x0 + d * 0.52, 0.0, 0.165):
            b.frustum(0.03, 0.028, (0.0, 0.012), "chrome", segments=16)
        b.bar((x0 + 0.05, 0.0, hb - 0.01), (x0 + 0.05, 0.0, h), 0.012, "chrome")
        b.bar((x0, 0.0, h - 0.025), (x0 + 0.075, 0.0, h - 0.025), 0.018, "chrome", 12)
    b.fit()


def _basin_body(
    b: Builder, x: tuple, y: tuple, low: float, h: float, china: Finish, square: bool, ledge: float
) -> None:
    """A washbasin with a ledge for the tap at its back, open above."""
    cx, cy, rx, ry = (x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    p = 6.0 if square else 2.6

    def out(share: float, z: float):
        return egg(rx * share, rx, ry * share, z, cx, cy, p, 8.0, 32)

    mx = cx + ledge / 2
    ix, iy = rx - ledge / 2 - 0.02, ry - 0.028
    outer = [
        out(0.45 if not square else 0.8, low),
        out(0.82 if not square else 0.93, low + 0.05),
        out(1.0, h - 0.05),
        out(1.0, h),
    ]
    inner = [
        oval(ix, iy, h, mx, cy, p),
        oval(ix * 0.9, iy * 0.92, h - 0.05, mx, cy, p),
        oval(ix * 0.4, iy * 0.4, h - 0.115, mx, cy, 2.4),
    ]
    vessel(b, outer, inner, china)
    with b.frame(mx, cy, h - 0.1155):
        b.frustum(0.024, 0.022, (0.0, 0.006), "chrome", segments=16)


@draws("pedestal_sink")
def pedestal_sink(b: Builder) -> None:
    """A basin on a waisted column, with a tap on its ledge."""
    d, w, total = b.size
    china = b.material("bowl", *_WHITE)
    metal = b.material("tap", "chrome", "brass", "brushed steel")
    h = 0.84
    square = b.chance("square", 0.4)
    with b.solid("basin"):
        _basin_body(b, (-d / 2, d / 2), (-w / 2, w / 2), h - 0.18, h, china, square, 0.10)
    with b.solid("column"):
        p = 4.0 if square else 2.2
        column = [(0.12, 0.0), (0.115, 0.03), (0.085, 0.12), (0.08, 0.45), (0.11, h - 0.16)]
        loft(b, [oval(r * 1.0, r, z, -0.04, 0.0, p, 24) for r, z in column], china)
    tap(b, -d / 2 + 0.055, 0.0, h, metal, total - h, 0.12, square=square)
    b.fit()


@draws("wall_basin")
def wall_basin(b: Builder) -> None:
    """A basin hung on the wall, with its tap above and the trap below."""
    d, w, total = b.size
    china = b.material("bowl", *_WHITE)
    metal = b.material("tap", "chrome", "black steel", "brass", "brushed steel")
    square = b.chance("square", 0.5)
    low, up = 0.15, 0.12
    h = total - up
    low = h - 0.165
    with b.solid("basin"):
        _basin_body(b, (-d / 2, d / 2), (-w / 2, w / 2), low, h, china, square, 0.09)
    tap(b, -d / 2 + 0.05, 0.0, h, metal, up, 0.11, square=square)
    with b.solid("trap"):
        b.frustum(0.018, 0.018, (0.05, low + 0.01), metal, segments=14)
        b.frustum(0.036, 0.036, (0.0, 0.075), metal, segments=18, bevel=0.006)
        b.bar((0.0, 0.0, 0.06), (-d / 2, 0.0, 0.06), 0.015, metal, 12)
        with b.frame(-d / 2, 0.0, 0.06, pitch=math.pi / 2):
            b.frustum(0.03, 0.028, (0.0, 0.008), metal, segments=16)
    b.fit()


@draws("vanity", "double_vanity")
def vanity(b: Builder) -> None:
    """A cabinet with one or two basins set on or into its top, and a tap for each."""
    d, w, total = b.size
    leaf = b.material(
        "fronts",
        "white paint",
        "oak",
        "walnut",
        "sage paint",
        "navy paint",
        "light grey paint",
        "light oak",
        "grey paint",
    )
    shell = leaf
    top = b.material("top", "marble", "white ceramic", "dark marble", "oak", "granite")
    pull = b.material("pulls", "chrome", "black steel", "brass")
    metal = b.material("tap", "chrome", "black steel", "brass", "brushed steel")
    looks = (shell, leaf, pull, b.pick("pull style", ["bar", "knob", "cup"]))
    count = 2 if b.category.name == "double_vanity" else 1
    on = b.chance("vessel", 0.4)
    bowl = 0.13 if on else 0.0
    h = min(0.86, total - 0.13) - bowl
    x, y = (-d / 2, d / 2 - 0.027), (-w / 2, w / 2)
    t = 0.03
    legs = b.chance("legs", 0.35)
    low = 0.2 if legs else 0.09
    shaker = b.style in ("classic", "rustic")
    half = min(0.25, w / count / 2 - 0.07)
    mids = [0.0] if count == 1 else [-w / 4, w / 4]
    rx = (d - 0.16) / 2
    cx = 0.03
    hx = (cx - rx + 0.012, cx + rx - 0.03)
    square = b.chance("square", 0.5)
    with b.solid("body"):
        if legs:
            for px in (x[0] + 0.02, x[1] - 0.06):
                for py in (y[0] + 0.03, y[1] - 0.03):
                    b.box((px, px + 0.035), (py - 0.02, py + 0.02), (0.0, low), leaf, bevel=0.003)
        else:
            b.box((x[0] + 0.02, x[1] - 0.07), (y[0] + 0.01, y[1] - 0.01), (0.0, low), shell, bevel=0)
        n = 1 if w < 0.95 else 2 if w < 1.5 else 3
        for k in range(n):
            span = (y[0] + k * w / n, y[0] + (k + 1) * w / n)
            if on:
                layout = "drawers" if n == 3 and k == 1 else b.pick("layout", ["doors", "drawers", "mixed"])
                cabinet(b, f"unit-{k}", x, span, (low, h - t), layout, looks, shaker)
                continue
            front = x[1] - 0.021
            for ys in ((span[0], span[0] + 0.018), (span[1] - 0.018, span[1])):
                outer = ys[0] < y[0] + 0.001 or ys[1] > y[1] - 0.001
                b.box((x[0], front), ys, (low, h - t - (0.0 if outer else 0.14)), shell, bevel=0)
            inner = (span[0] + 0.018, span[1] - 0.018)
            b.box((x[0], front), inner, (low, low + 0.018), shell, bevel=0)
            b.box((x[0], x[0] + 0.006), inner, (low + 0.018, h - t), shell, bevel=0)
            fronts(
                b,
                f"unit-{k}",
                front,
                span,
                (low, h - t),
                "drawers" if n == 3 and k == 1 else b.pick("layout", ["doors", "drawers"]),
                looks[1],
                looks[2],
                looks[3],
                shaker,
            )
        slab = ((-d / 2, d / 2 - 0.004), y, (h - t, h))
        if on:
            b.box(*slab, top)
        else:
            worktop(b, *slab, top, [(hx, (m - half, m + half)) for m in mids])
            with b.solid("splash"):
                b.box((-d / 2, -d / 2 + 0.014), y, (h - 0.0005, h + 0.06), top, bevel=0.002)
            for m in mids:
                china: Finish = "white ceramic"
                e = 0.008
                rim = ((hx[0] - e, hx[1] + e), (m - half - e, m + half + e))
                ins = ((hx[0] + 0.012, hx[1] - 0.012), (m - half + 0.012, m + half - 0.012))
                deep = ((hx[0] + 0.05, hx[1] - 0.05), (m - half + 0.06, m + half - 0.06))
                r = 0.03 if square else 0.09
                under = ((hx[0] + 0.002, hx[1] - 0.002), (m - half + 0.002, m + half - 0.002))
                vessel(
                    b,
                    [
                        rounded(
                            (deep[0][0] - 0.012, deep[0][1] + 0.012),
                            (deep[1][0] - 0.012, deep[1][1] + 0.012),
                            0.05,
                            h - 0.13,
                        ),
                        rounded(*under, 0.02, h - 0.04),
                        rounded(*under, 0.02, h),
                        rounded(*rim, 0.02, h),
                        rounded(*rim, 0.02, h + 0.0015),
                    ],
                    [rounded(*ins, r, h + 0.0015), rounded(*deep, 0.04, h - 0.118)],
                    china,
                    (0, 3, 4, 7, 8, 11, 12, 15, 16),
                )
                with b.frame((hx[0] + hx[1]) / 2, m, h - 0.1185):
                    b.frustum(0.024, 0.022, (0.0, 0.005), "chrome", segments=14)
    for k, m in enumerate(mids):
        if on:
            with b.solid(f"bowl {k}"):
                vr = min(half - 0.03, 0.2 if not square else 0.24)
                sx = min(vr, rx - 0.012)
                p = 5.0 if square else 2.0
                with b.frame(cx + 0.01, m, h):
                    vessel(
                        b,
                        [
                            oval(sx * 0.6, vr * 0.6, 0.0, power=p),
                            oval(sx * 0.9, vr * 0.9, 0.05, power=p),
                            oval(sx, vr, bowl, power=p),
                        ],
                        [
                            oval(sx - 0.012, vr - 0.012, bowl, power=p),
                            oval(sx * 0.86, vr * 0.86, 0.05, power=p),
                            oval(sx * 0.3, vr * 0.3, 0.014, power=2.4),
                        ],
                        b.material("bowl", "white ceramic", "white ceramic", "dark marble", "concrete"),
                    )
                    with b.frame(0.0, 0.0, 0.013):
                        b.frustum(0.022, 0.022, (0.0, 0.005), "chrome", segments=14)
        tap(b, -d / 2 + 0.05, m, h, metal, total - h, 0.15, name=f"tap {k}", square=square)
    if on:
        reach = max(half - 0.03, 0.0) + 0.01
        reach = min(reach, 0.21 if not square else 0.25)
    else:
        reach = half + 0.02
    edges = [y[0] + 0.01]
    for m in mids:
        edges += [m - reach, m + reach]
    edges.append(y[1] - 0.01)
    xs = (-d / 2 + 0.02, d / 2 - 0.014)
    names = ("top-right", "top-left") if count == 1 else ("top-right", "top-middle", "top-left")
    wide = [(name, (edges[2 * k], edges[2 * k + 1])) for k, name in enumerate(names)]
    wide = [(name, ys) for name, ys in wide if ys[1] - ys[0] > 0.08]
    if not wide and not on:  # a narrow one has its soap beside the tap
        xs = (-d / 2 + 0.016, hx[0] - 0.012)
        wide = [("top-right", (y[0] + 0.01, mids[0] - 0.05)), ("top-left", (mids[0] + 0.05, y[1] - 0.01))]
    for name, ys in wide:
        b.surface(name, xs, ys, h)
    b.fit()
