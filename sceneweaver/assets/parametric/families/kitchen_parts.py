"""Shared by kitchens, bathrooms, laundries and hotels: lofts, basins, taps, worktops, fronts, burners."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from sceneweaver.assets import shapes
from sceneweaver.assets.body import Material
from sceneweaver.geometry.prisms import ring_faces

from ..builder import Builder, Interval
from ..joinery import carcass, door, drawer, handle

Finish = Material | str

WORKTOPS = ("oak", "walnut", "marble", "dark marble", "granite", "concrete", "beech")

COATS = ("brushed steel", "white paint", "black paint", "steel")
"""Finishes of the appliances of a kitchen, which match in a suite."""


def worktop_of(b: Builder) -> tuple[Material, float]:
    """Finish and thickness [m] of a worktop, the same for all pieces of a suite."""
    return b.material("top", *WORKTOPS), b.pick("top thickness", [0.02, 0.03, 0.04], matched=True)


def coat_of(b: Builder, *more: str) -> Material:
    """Finish of an appliance, the same for all appliances of a suite; what is in none may have one of ``more``."""
    return b.material("body", *([b.pick("coat", COATS, matched=True)] if b.in_suite else (*COATS, *more)))


def oval(rx: float, ry: float, z: float, x: float = 0.0, y: float = 0.0, power: float = 2.0, n: int = 32) -> np.ndarray:
    """A ring [n, 3]: an ellipse, or with a higher power a box with round corners."""
    return egg(rx, rx, ry, z, x, y, power, power, n)


def egg(
    front: float,
    back: float,
    ry: float,
    z: float,
    x: float = 0.0,
    y: float = 0.0,
    power: float = 2.2,
    back_power: float = 2.2,
    n: int = 32,
) -> np.ndarray:
    """A ring whose front and back halves differ: a toilet's bowl is round in front and square at its back."""
    a = np.arange(n) * (2 * np.pi / n)
    c, s = np.cos(a), np.sin(a)
    c[np.abs(c) < 1e-9] = 0.0
    p = np.where(c >= 0, power, back_power)
    u = np.sign(c) * np.abs(c) ** (2 / p)
    v = np.sign(s) * np.abs(s) ** (2 / p)
    return np.c_[x + np.where(c >= 0, front, back) * u, y + ry * v, np.full(n, z)]


def rounded(x: Interval, y: Interval, r: float, z: float, k: int = 3) -> np.ndarray:
    """A ring of a rectangle with round corners, k steps each, counter-clockwise from the front right corner."""
    points = []
    for i, (cx, cy) in enumerate(
        ((x[1] - r, y[0] + r), (x[1] - r, y[1] - r), (x[0] + r, y[1] - r), (x[0] + r, y[0] + r))
    ):
        for j in range(k + 1):
            a = -math.pi / 2 + i * math.pi / 2 + j * math.pi / (2 * k)
            points.append((cx + r * math.cos(a), cy + r * math.sin(a), z))
    return np.array(points)


def _body(rings: Sequence[np.ndarray]):
    n = len(rings[0])
    fan = np.arange(1, n - 1)
    last = (len(rings) - 1) * n
    faces = [ring_faces(i * n, (i + 1) * n, n) for i in range(len(rings) - 1)]
    faces.append(np.c_[np.zeros(n - 2, dtype=int), fan + 1, fan])
    faces.append(np.c_[np.full(n - 2, last), last + fan, last + fan + 1])
    return np.concatenate(rings), np.concatenate(faces).astype(np.int32)


def loft(b: Builder, rings: Sequence[np.ndarray], material: Finish, whole: bool = False) -> None:
    """A solid through convex rings from below upward; its hulls are one for each pair, or one for all."""
    pairs = [tuple(rings)] if whole else list(zip(rings[:-1], rings[1:], strict=True))
    hulls = [shapes.hull(np.concatenate(p)) for p in pairs if np.ptp(np.concatenate(p)[:, 2]) > 1e-6]
    b.add(_body(rings), material, hulls)


def vessel(
    b: Builder,
    outer: Sequence[np.ndarray],
    inner: Sequence[np.ndarray],
    material: Finish,
    cuts: Sequence[int] | int = 16,
    split: tuple[int, int] | None = None,
) -> None:
    """A hollow body: rings up outside, then down inside. Its parts are a floor and staves, so it stays open.

    ``split`` cuts the staves of a bellied body in two at an outer and an inner ring.
    """
    rings = [*outer, *inner]
    n = len(rings[0])
    ends = list(range(0, n + 1, max(1, n // cuts))) if isinstance(cuts, int) else list(cuts)
    hulls = [shapes.hull(np.concatenate([outer[0], inner[-1]]))]
    for a, e in zip(ends[:-1], ends[1:], strict=True):
        index = np.arange(a, e + 1) % n
        layers = (
            [rings]
            if split is None
            else [[*outer[: split[0] + 1], *inner[split[1] :]], [*outer[split[0] :], *inner[: split[1] + 1]]]
        )
        hulls += [shapes.hull(np.concatenate([ring[index] for ring in layer])) for layer in layers]
    b.add(_body(rings), material, hulls)


CORNER_CUTS = (0, 3, 4, 7, 8, 11, 12, 15, 16)
"""Where the staves of a vessel of rounded rectangles end: one for each corner and one for each side."""


def basin(b: Builder, x: Interval, y: Interval, z: float, depth: float, material: Finish, lip: float = 0.015) -> None:
    """A basin let into a worktop at height z, with a thin rim on it and a drain."""
    t, r = 0.004, 0.03
    rim = ((x[0] - lip, x[1] + lip), (y[0] - lip, y[1] + lip))
    taper = 0.025
    floor = ((x[0] + taper, x[1] - taper), (y[0] + taper, y[1] - taper))
    outer = [
        rounded(floor[0], floor[1], 0.05, z - depth),
        rounded(x, y, r, z),
        rounded(*rim, 0.02, z),
        rounded(*rim, 0.02, z + 0.0015),
    ]
    inner = [
        rounded((x[0] + t, x[1] - t), (y[0] + t, y[1] - t), r, z + 0.0015),
        rounded(
            (floor[0][0] + 0.006, floor[0][1] - 0.006),
            (floor[1][0] + 0.006, floor[1][1] - 0.006),
            0.05,
            z - depth + 0.006,
        ),
    ]
    vessel(b, outer, inner, material, CORNER_CUTS)
    with b.frame((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z - depth + 0.0055):
        b.frustum(0.035, 0.035, (0.0, 0.0025), "chrome", segments=16)
        b.frustum(0.022, 0.022, (0.002, 0.004), "black steel", segments=12)


def tap(
    b: Builder,
    x: float,
    y: float,
    z: float,
    material: Finish,
    height: float = 0.3,
    reach: float = 0.18,
    name: str = "tap",
    square: bool = False,
) -> None:
    """A mixer with a bent spout toward +x and a lever at its side."""
    with b.solid(name), b.frame(x, y, z):
        b.frustum(0.026, 0.022, (0.0, 0.05), material, segments=16, bevel=0.003)
        r = 0.011
        if square:
            b.box((-0.014, 0.014), (-0.014, 0.014), (0.045, height), material)
            b.box((-0.014, reach), (-0.016, 0.016), (height - 0.022, height), material)
            b.box((reach - 0.028, reach), (-0.016, 0.016), (height - 0.04, height - 0.02), material, bevel=0.001)
        else:
            rad = min(reach / 2, height * 0.45)
            arc = [
                (reach / 2 - reach / 2 * math.cos(t), 0.0, height - r - rad + rad * math.sin(t))
                for t in np.linspace(0, math.pi, 8)
            ]
            tail = [(reach, 0.0, height - r - rad - 0.03)]
            b.tube([(0.0, 0.0, 0.045), *arc, *tail], r, material, 10)
            b.frustum(0.014, 0.014, (0.0, 0.001), material, segments=8)
        b.bar((0.0, -0.02, 0.035), (0.0, -0.045, 0.037), 0.009, material, 8)
        b.bar((0.0, -0.042, 0.037), (0.02, -0.05, 0.095), 0.005, material, 8)


def worktop(b: Builder, x: Interval, y: Interval, z: Interval, material: Finish, holes=()) -> None:
    """A worktop with rectangular cut outs (x, y), all of one depth, in order of y."""
    if not holes:
        b.box(x, y, z, material)
        return
    hx = holes[0][0]
    b.box((x[0], hx[0]), y, z, material, bevel=0)
    b.box((hx[1], x[1]), y, z, material, bevel=0)
    at = y[0]
    for _, hy in holes:
        b.box(hx, (at, hy[0]), z, material, bevel=0)
        at = hy[1]
    b.box(hx, (at, y[1]), z, material, bevel=0)


def fronts(
    b: Builder,
    name: str,
    x: float,
    y: Interval,
    z: Interval,
    layout: str,
    leaf: Finish,
    pull: Finish,
    style: str,
    shaker: bool = False,
    glass: bool = False,
    deep: float = 0.4,
) -> None:
    """Doors and drawers of 20 mm on a carcass ``deep`` whose front is at x: "door", "doors", "drawers" or "mixed"."""
    h, travel = z[1] - z[0], 0.75 * deep
    xs = (x + 0.0005, x + 0.0205)
    panel: Finish | None = "glass" if glass else leaf if shaker else None
    if layout == "drawers":
        shares = (0.24, 0.38, 0.38) if h > 0.5 else (0.5, 0.5)
        top = z[1]
        for k, share in enumerate(shares):
            drawer(b, f"{name}-drawer-{k}", xs, y, (top - share * h, top), leaf, pull, style, travel)
            top -= share * h
        return
    high = z[1]
    if layout == "drawer":
        drawer(b, f"{name}-drawer", xs, y, z, leaf, pull, style, travel)
        return
    if layout == "mixed":
        high = z[1] - 0.16
        drawer(b, f"{name}-drawer", xs, y, (high, z[1]), leaf, pull, style, travel)
    if y[1] - y[0] > 0.62 or layout == "doors":
        m = (y[0] + y[1]) / 2
        door(b, f"{name}-right", xs, (y[0], m), (z[0], high), leaf, pull, "right", style, panel)
        door(b, f"{name}-left", xs, (m, y[1]), (z[0], high), leaf, pull, "left", style, panel)
    else:
        door(b, f"{name}-door", xs, y, (z[0], high), leaf, pull, "left", style, panel)


def cabinet(
    b: Builder,
    name: str,
    x: Interval,
    y: Interval,
    z: Interval,
    layout: str,
    looks: tuple,
    shaker: bool = False,
    glass: bool = False,
) -> None:
    """A carcass with its fronts; ``looks`` are body, fronts, pulls, style; x[1] is where its fronts end."""
    body, leaf, pull, style = looks
    carcass(b, (x[0], x[1] - 0.021), y, z, body)
    fronts(b, name, x[1] - 0.021, y, z, layout, leaf, pull, style, shaker, glass, x[1] - 0.021 - x[0])


def burners(b: Builder, x: Interval, y: Interval, z: float, gas: bool, count: int = 4) -> None:
    """Hot plates on a cooktop at height z: flat rings in glass, or gas burners under iron grates of 35 mm."""
    cols = 2 if count <= 4 else 3
    dx, dy = (x[1] - x[0]) / 2, (y[1] - y[0]) / cols
    for i in range(2):
        for j in range(cols):
            cx, cy = x[0] + (i + 0.5) * dx, y[0] + (j + 0.5) * dy
            r = min(dx, dy) * (0.40 if (i + j) % 2 else 0.31)
            if not gas:
                for k, (radius, look) in enumerate(
                    (
                        (r, "grey plastic"),
                        (r - 0.004, "black glass"),
                        (r * 0.55, "grey plastic"),
                        (r * 0.55 - 0.003, "black glass"),
                    )
                ):
                    with b.frame(cx, cy):
                        b.add(shapes.frustum(radius, radius, (z - 0.004 - 0.001 * k, z + 0.00005 * (k + 1)), 24), look)
                continue
            with b.frame(cx, cy, z):
                b.frustum(r * 0.62, r * 0.5, (-0.002, 0.012), "iron", segments=16)
                b.frustum(r * 0.36, r * 0.33, (0.011, 0.022), "black steel", segments=16)
    if gas:
        for j in range(cols):
            cy, half = y[0] + (j + 0.5) * dy, dy / 2 - 0.012
            for s in (-1, 1):
                b.box(
                    (x[0] + 0.01, x[1] - 0.01),
                    (cy + s * half - 0.005, cy + s * half + 0.005),
                    (z, z + 0.035),
                    "iron",
                    bevel=0,
                )
            for t in (0.02, 0.25, 0.5, 0.75, 0.98):
                at = x[0] + 0.01 + t * (x[1] - x[0] - 0.02)
                b.box((at - 0.005, at + 0.005), (cy - half, cy + half), (z + 0.024, z + 0.035), "iron", bevel=0)


def knob(b: Builder, x: float, y: float, z: float, material: Finish, r: float = 0.02, long: float = 0.024) -> None:
    """A turning knob on a front face at depth x."""
    with b.frame(x, y, z, pitch=math.pi / 2):
        b.frustum(r, r * 0.85, (0.0, long), material, segments=14, bevel=0.002)
    b.box((x + long - 0.001, x + long + 0.0005), (y - 0.0015, y + 0.0015), (z, z + r * 0.8), "white plastic", bevel=0)


def oven_door(b: Builder, name: str, x: Interval, y: Interval, z: Interval, look: Finish, pull: Finish) -> None:
    """A door with a window and a bar across its top; it falls open about its lower edge."""
    with b.hinge(name, (x[1], (y[0] + y[1]) / 2, z[0]), axis=(0.0, 1.0, 0.0), limits=(0.0, 1.5)):
        b.box(x, y, z, look, bevel=0.004)
        w, h = y[1] - y[0], z[1] - z[0]
        b.box(
            (x[1] - 0.003, x[1] + 0.001),
            (y[0] + 0.12 * w, y[1] - 0.12 * w),
            (z[0] + 0.16 * h, z[1] - 0.28 * h),
            "black glass",
            bevel=0,
        )
        handle(b, x[1], (y[0] + y[1]) / 2, z[1] - 0.11 * h, pull, "bar", 0.78 * w)


def feet(b: Builder, x: Interval, y: Interval, z: float, material: Finish = "black plastic", r: float = 0.018) -> None:
    """Four low round feet at the corners of a rectangle, up to height z."""
    for px in (x[0] + 0.05, x[1] - 0.05):
        for py in (y[0] + 0.05, y[1] - 0.05):
            with b.frame(px, py):
                b.frustum(r, r, (0.0, z), material, segments=12)


def castors(b: Builder, x: Interval, y: Interval, z: float = 0.08, r: float = 0.032, metal: Finish = "steel") -> None:
    """Four wheels in forks at the corners of a rectangle; they carry at height z."""
    for px in x:
        for py in y:
            with b.frame(px, py, r, yaw=0.3, pitch=0.0, roll=math.pi / 2):
                b.frustum(r, r, (-0.011, 0.011), "rubber", segments=14, bevel=0.003)
                b.frustum(r * 0.5, r * 0.5, (-0.0125, 0.0125), "grey plastic", segments=10)
            b.hull([(px + s * 0.012, py + t * 0.017, v) for s in (-1, 1) for t in (-1, 1) for v in (r * 1.2, z)], metal)
